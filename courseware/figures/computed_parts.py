"""Declare the computed parts of a live figure: readouts, goals, recurrences, named steps.

Controls give symbols their numbers; shapes, readouts and handles are SymPy expressions of these
symbols. Numbers in a declaration are SI (radians); the reader sees degrees, and
`Slider.degrees(…)` is declared in them.

A `kind` is a name of the course's looks (`looks` of `open_course`), or a quantity: then its
look comes from the chapter's `LOOKS`, its label is the quantity's letter unless said otherwise, and
on the page it belongs to that quantity. A slider and a readout follow from their quantity likewise:
it brings its look, letter, unit and, where its meaning starts with one and a colon ("heading: …"),
its name. A pose (x, y, θ) may be given as a place. Looks are per kind of thing, never per figure.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from courseware.equations.equation import Equation, Where
from courseware.equations.quantities import NamedSymbol
from courseware.equations.text import format_symbol
from courseware.units import refuse_unknown

Expr = Any
Kind = Any  # a name, or a quantity
Place = Sequence[Expr]  # x, y; of a pose (x, y, θ) the first two


def assign(*equations: Equation) -> Where:
    """Return named steps that compute the left sides of equations, in order."""
    sides = [(sp.Matrix([e.left]), sp.Matrix([e.right])) for e in equations]
    return [pair for left, right in sides for pair in zip(left, right, strict=True)]


def distance(one: Place, other: Place) -> Expr:
    """Return the distance of two places on the ground."""
    return sp.sqrt((one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2)


def ramp(done: Expr, k: int) -> Expr:
    """Return the progress of part k, from 0 to 1, where parts run one after another."""
    return sp.Max(0, sp.Min(1, done - k))


def default_label(symbol: NamedSymbol) -> str:
    """Return a quantity's name, if it has one, and its letter: "heading θ"."""
    return f"{symbol.short_name} {format_symbol(symbol)}".strip()


class NamedSteps(list[tuple[sp.Symbol, Any]]):
    """Named steps of a computation, in order, for `Figure.where`."""

    def add(self, name: str, value: Any) -> Any:
        """Add a number or a matrix; return the symbol, or the matrix of symbols, that names it."""
        if not isinstance(value, sp.MatrixBase):
            self.append((sp.Symbol(name, real=True), value))
            return self[-1][0]
        entries = sp.symbols(f"{name}:{value.rows}:{value.cols}", real=True)
        self += zip(entries, value, strict=True)
        return sp.Matrix(*value.shape, entries)


@dataclass(frozen=True)
class Recurrence:
    """A loop with state, which a figure knows by the `Trail` that draws it.

    Ten steps of a robot that brakes from v_0 with 0.5 m/s²::

        v, x, v_end, x_end = symbols("v x v_end x_end")
        loop = Recurrence((v, x), (v_0, 0), (v - 0.5 * dt, x + v * dt), 10, 10, (v_end, x_end))
        Trail("travelled", (x, 0), loop)

    Args:
        state: a symbol for each number of the state.
        start: the state at first, of the controls' symbols.
        step: the next state, of the state and the controls' symbols, not of steps in `where`.
        count: how often, a whole number, of the controls' symbols.
        most: the largest count.
        ends: a symbol for each number of the last state, for all other expressions.
    """

    state: tuple[sp.Symbol, ...]
    start: tuple[Expr, ...]
    step: tuple[Expr, ...]
    count: Expr
    most: int
    ends: tuple[sp.Symbol, ...]


@dataclass(frozen=True)
class Goal:
    """A task for the reader, for `Figure.goal`: done once a hand rests where the condition holds.

    Args:
        condition: of SymPy, in all that the figure knows, with room for a slider's step and a
            finger: `And(distance(here, MARK) < 0.02, Abs(theta) < pi / 36)`.
        words: the task and that room, in the reader's units: "Park on the mark: within 2 cm and
            5°."
    """

    condition: Any
    words: str


@dataclass(frozen=True)
class Readout:
    """A number to read beside the picture.

    Args:
        name: for the figure's `sentence` and tests; a quantity as the name gives its letter and
            unit, and itself as the value.
        unit: in which it is shown, of a value in SI: "cm" shows 0.18 as 18 cm.
        digits: after the point, by default 1 of an angle and 3 of all else; -2 means two digits
            and a power of ten.
        words: the text to show instead of "inf", "-inf" or "nan".
        symbol: the quantity or the kind whose look it has.
    """

    name: Any
    label: str = ""
    value: Expr = None
    unit: str = ""
    digits: int | None = None
    words: Mapping[str, str] = field(default_factory=dict)
    symbol: Kind = None

    def __post_init__(self) -> None:
        if isinstance(symbol := self.name, NamedSymbol):
            value = symbol if self.value is None else self.value
            self._set(name=str(symbol), symbol=symbol, unit=symbol.unit, value=value)
            self._set(label=self.label or default_label(symbol))
        if self.digits is None:
            self._set(digits=1 if self.unit == "rad" else 3)
        refuse_unknown(self.unit, f"the readout {self.name}")

    def _set(self, **fields: Any) -> None:
        for name, value in fields.items():
            object.__setattr__(self, name, value)
