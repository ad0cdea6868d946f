"""Quarter turns at the press of a button, and the matrices that belong to them."""

from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from courseware.figures.declaration import Place

BEFORE = sp.Matrix(3, 3, sp.symbols("before:3:3", real=True))
AXIS = sp.Matrix(sp.symbols("turn_axis:3", real=True))
OWN, PART, PRESSES = sp.symbols("own_axes turn_part presses", real=True)


@dataclass(frozen=True)
class QuarterTurns:
    """Quarter turns of a body, as many as the reader presses: about its own axes or the room's.

    A press is a letter, upper case for an own axis (X, Y, Z), lower case for one of the room, with
    a minus before it if the turn is negative. The presses are the state: "Zx-Y". Of the last turn
    a part is made, which grows from 0 to 1 after its press.
    """

    name: str = "turns"
    start: str = ""
    label: str = "turns"

    before: ClassVar[sp.Matrix] = BEFORE  # the rotation before the last turn
    axis: ClassVar[sp.Matrix] = AXIS  # of the last turn: a unit vector, (0, 0, 0) if there is none
    own: ClassVar[sp.Symbol] = OWN  # 1 if the last turn is about an own axis, else 0
    part: ClassVar[sp.Symbol] = PART
    count: ClassVar[sp.Symbol] = PRESSES
    symbols: ClassVar[tuple[sp.Symbol, ...]] = (*BEFORE, *AXIS, OWN, PART, PRESSES)

    @property
    def key(self) -> str:
        """Its name in addresses, links and values."""
        return self.name

    @staticmethod
    def last_rotation(part: Any = 1) -> sp.Matrix:
        """The matrix of the last turn; the identity before the first."""
        x, y, z = AXIS
        c, s = sp.cos(part * sp.pi / 2), sp.sin(part * sp.pi / 2)
        # about a coordinate axis, or about none
        return sp.Matrix(
            [
                [c + (1 - c) * (x**2 + (1 - x**2 - y**2 - z**2)), -s * z, s * y],
                [s * z, c + (1 - c) * (y**2 + (1 - x**2 - y**2 - z**2)), -s * x],
                [-s * y, s * x, c + (1 - c) * (z**2 + (1 - x**2 - y**2 - z**2))],
            ]
        )

    @staticmethod
    def compose(last: sp.Matrix) -> sp.Matrix:
        """The rotation after the last turn: own axes on the right, the room's on the left."""
        return OWN * (BEFORE * last) + (1 - OWN) * (last * BEFORE)


@dataclass(frozen=True)
class Bracket:
    """A matrix (3, 3) written into the picture, its middle at `at`, its columns in three looks."""

    matrix: sp.Matrix
    at: Place
    label: str = ""
    columns: tuple[str, ...] = ("x_axis", "y_axis", "z_axis")
    digits: int = 0
    kind: str = "text"
