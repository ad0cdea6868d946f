"""The numbers that a typed answer consists of."""

import math
from dataclasses import dataclass, field

from courseware.units import UNITS, refuse_other_than_si

RELATIVE = 1e-3  # of a large answer: as much as numbers make that are rounded on the way


@dataclass(frozen=True)
class Unknown:
    """One number of an answer.

    How far off an answer may be follows from its unit, and is a thousandth of a large one; the
    words on decimals follow from that.

    Args:
        label: its letter or name.
        unit: SI; an answer that is typed with another unit of this size is converted.
        circle: whether it is an angle, compared up to whole turns.
        tolerance: how far off an answer may be instead, in the unit.
    """

    label: str
    unit: str = ""
    circle: bool = False
    tolerance: float = 0.0
    relative: float = field(init=False)  # the same as a part of the answer

    def __post_init__(self) -> None:
        refuse_other_than_si(self.unit, f"the answer {self.label}")
        relative = 0.0 if self.tolerance or self.circle else RELATIVE
        object.__setattr__(self, "relative", relative)
        object.__setattr__(self, "tolerance", self.tolerance or UNITS[self.unit].tolerance)

    def allowed(self, value: float, factor: float = 1.0) -> float:
        """Return how far off an answer may be from a value in a unit of this size."""
        return max(self.tolerance * abs(factor), self.relative * abs(value))

    @property
    def decimals(self) -> int:
        """The number of decimals that is always enough: half of the last is within tolerance."""
        return 0 if self.tolerance < 1e-6 else math.ceil(-math.log10(2 * self.tolerance))


def angle(label: str) -> Unknown:
    """Ask for an angle in rad, right up to whole turns."""
    return Unknown(label, "rad", circle=True)


def integer(label: str, unit: str = "") -> Unknown:
    """Ask for an integer."""
    return Unknown(label, unit, tolerance=1e-9)


def matrix(name: str, rows: int, columns: int) -> tuple[Unknown, ...]:
    """Ask for the entries of a matrix, row by row."""
    return tuple(Unknown(f"{name}[{i}, {j}]") for i in range(rows) for j in range(columns))
