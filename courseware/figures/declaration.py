"""The words a live figure is declared with.

Controls give symbols their numbers; shapes, readouts and handles are SymPy expressions of these
symbols. Numbers in a declaration are SI (radians); the reader sees degrees, and
`Slider.degrees(…)` is declared in them.

A `kind` is a name of the course's looks (`looks` of `open_course`), or a quantity: then its
look comes from the chapter's `LOOKS`, its label is the quantity's letter unless said otherwise, and
on the page it belongs to that quantity. A slider and a readout follow from their quantity likewise:
it brings its look, letter, unit and, where its meaning starts with one and a colon ("heading: …"),
its name. A pose (x, y, θ) may stand for a place. Looks are per kind of thing, never per figure.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self

import sympy as sp

from courseware.equations.equation import Equation, Where
from courseware.equations.quantities import NamedSymbol
from courseware.equations.text import format_symbol
from courseware.errors import CourseError, describe
from courseware.units import refuse_other_than_si

Expr = Any
Kind = Any  # a name, or a quantity
Place = Sequence[Expr]  # x, y; of a pose (x, y, θ) the first two

POINTER = sp.symbols("pointer_x pointer_y", real=True)


def assign(*equations: Equation) -> Where:
    """Named steps that compute the left sides of equations, in order, for `Figure.where`."""
    sides = [(sp.Matrix([e.left]), sp.Matrix([e.right])) for e in equations]
    return [pair for left, right in sides for pair in zip(left, right, strict=True)]


def distance(one: Place, other: Place) -> Expr:
    """The distance of two places on the ground."""
    return sp.sqrt((one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2)


def ramp(done: Expr, k: int) -> Expr:
    """How much of part k is done, from 0 to 1, of parts that come one after the other."""
    return sp.Max(0, sp.Min(1, done - k))


def default_label(symbol: NamedSymbol) -> str:
    """A quantity's name, if it has one, and its letter: "heading θ"."""
    return f"{symbol.short_name} {format_symbol(symbol)}".strip()


class NamedSteps(list[tuple[sp.Symbol, Any]]):
    """Named steps of a computation, in order, for `Figure.where`."""

    def add(self, name: str, value: Any) -> Any:
        """A number by a name, or a matrix by the names of its entries; what it is, is noted."""
        if not isinstance(value, sp.MatrixBase):
            self.append((sp.Symbol(name, real=True), value))
            return self[-1][0]
        entries = sp.symbols(f"{name}:{value.rows}:{value.cols}", real=True)
        self += zip(entries, value, strict=True)
        return sp.Matrix(*value.shape, entries)


# Controls: what the reader moves.


@dataclass(frozen=True)
class Slider:
    """A symbol under the hand. low, high, start, step in SI; unit and face from the quantity.

    A step of type int: the symbol is always a whole number.
    """

    symbol: sp.Symbol
    low: float
    high: float
    start: float
    step: float
    label: str = ""
    kind: str = ""
    rate: float = 0.0

    def __post_init__(self) -> None:
        if not self.label and isinstance(self.symbol, NamedSymbol):
            object.__setattr__(self, "label", default_label(self.symbol))

    @property
    def key(self) -> str:
        """Its name in addresses, links and values."""
        return str(self.symbol)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The one symbol that it sets, as other controls set several."""
        return (self.symbol,)

    @classmethod
    def degrees(
        cls,
        symbol: sp.Symbol,
        low: float = -180,
        high: float = 180,
        start: float = 0,
        step: float = 1,
        **more: Any,
    ) -> Self:
        """The slider of an angle, declared in degrees."""
        low, high, start, step = map(math.radians, (low, high, start, step))
        return cls(symbol, low, high, start, step, **more)


@dataclass(frozen=True)
class Clock(Slider):
    """A slider that also plays: it runs from low to high, `rate` of its SI unit in a second.

    loops: it plays by itself while the picture is in sight, again and again, for readers who like
    motion; a hand on it stops it.
    """

    start: float = 0.0
    step: float = 0.05
    rate: float = 1.0
    loops: bool = False


@dataclass(frozen=True)
class Choice:
    """One of several named cases: each option gives every symbol its number.

    start: the option chosen at first; the first one, unless said otherwise.
    """

    name: str
    label: str
    symbols: tuple[sp.Symbol, ...]
    options: Mapping[str, tuple[float, ...]]
    start: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "start", self.start or next(iter(self.options), ""))

    @property
    def key(self) -> str:
        """Its name in addresses, links and values."""
        return self.name

    @classmethod
    def one_hot(
        cls,
        name: str,
        symbols: Iterable[sp.Symbol],
        names: Iterable[str],
        label: str = "",
        **more: Any,
    ) -> Self:
        """Each name gives its own symbol 1 and all others 0."""
        symbols = tuple(symbols)
        options = {
            each: tuple(int(symbol == chosen) for symbol in symbols)
            for each, chosen in zip(names, symbols, strict=True)
        }
        return cls(name, label or name, symbols, options, **more)


@dataclass(frozen=True)
class Handle:
    """A point to drag: where it is, and which slider gets which expression of `POINTER`.

    The expression may use all that the figure knows. A place that is two sliders needs none: it
    goes where the pointer is.
    """

    label: str
    at: Place
    sets: Mapping[sp.Symbol, Expr] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "sets", self.sets or dict(zip(self.at, POINTER, strict=False)))


# What is computed step by step.


@dataclass(frozen=True)
class Recurrence:
    """A loop with state, which a figure knows by the `Trail` that draws it.

    Ten steps of a robot that brakes from v_0 with 0.5 m/s²::

        v, x, v_end, x_end = symbols("v x v_end x_end")
        loop = Recurrence((v, x), (v_0, 0), (v - 0.5 * dt, x + v * dt), 10, 10, (v_end, x_end))
        Trail("travelled", (x, 0), loop)

    Args:
        state: a symbol for each number of the state.
        start: the state at first, of what the controls set.
        step: the next state, of the state and what the controls set, not of steps in `where`.
        count: how often, a whole number, of what the controls set.
        most: the largest count.
        ends: a symbol for each number of the last state, for all other expressions.
    """

    state: tuple[sp.Symbol, ...]
    start: tuple[Expr, ...]
    step: tuple[Expr, ...]
    count: Expr
    most: int
    ends: tuple[sp.Symbol, ...]

    def __post_init__(self) -> None:
        for part in ("start", "step", "ends"):
            if len(getattr(self, part)) != len(self.state):
                raise CourseError(
                    f"a recurrence has the state {describe(self.state)} and as `{part}` "
                    f"{describe(getattr(self, part))}: there must be as many"
                )


@dataclass(frozen=True)
class Goal:
    """What the reader shall reach, for `Figure.goal`: marked once a hand rests where it holds.

    Args:
        condition: of SymPy, in all that the figure knows, with room for a slider's step and a
            finger: `And(distance(here, MARK) < 0.02, Abs(theta) < pi / 36)`.
        words: the task and that room, in the reader's units: "Park on the mark: within 2 cm and
            5°."
    """

    condition: Any
    words: str


# The scene: what is drawn. In a label `{name}` is a number of the figure. Shapes are painted as
# declared; those with a `depth` (larger is nearer) change places among themselves: the nearest
# comes last.


@dataclass(frozen=True)
class Point:
    """A marker, its form given by the kind.

    A labelled one that leaves a flat picture is shown at its edge with its distance from the
    origin in metres, unless `edge` is False.
    """

    kind: Kind
    at: Place
    label: str | None = None
    depth: Expr = None
    edge: bool = True


@dataclass(frozen=True)
class Line:
    """Straight pieces through several points."""

    kind: Kind
    points: tuple[Place, ...]
    depth: Expr = None


@dataclass(frozen=True)
class Arrow:
    """From `tail` to `head`."""

    kind: Kind
    tail: Place
    head: Place
    label: str | None = None
    depth: Expr = None


@dataclass(frozen=True)
class Wheel:
    """A wheel from above, rolling along `angle`; length and width in metres.

    roll: how far it has rolled, which its treads show.
    """

    kind: Kind
    at: Place
    angle: Expr
    length: float
    width: float
    roll: Expr = 0


@dataclass(frozen=True)
class Disc:
    """A wheel from the side: a round thing whose spokes show how far it has turned."""

    kind: Kind
    at: Place
    angle: Expr
    radius: float
    spokes: int = 5


@dataclass(frozen=True)
class Area:
    """A filled piece of the ground, by its corners."""

    kind: Kind
    points: tuple[Place, ...]


@dataclass(frozen=True)
class Length:
    """A length with its ends marked; aside: how far to the left of start → end it is drawn, m."""

    kind: Kind
    start: Place
    end: Place
    label: str | None = None
    aside: float = 0.0


@dataclass(frozen=True)
class Label:
    """Words or a number at a place."""

    kind: Kind
    at: Place
    label: str | None = None


@dataclass(frozen=True)
class Body:
    """A round robot from above, with a nose that shows its heading."""

    at: Place
    angle: Expr
    radius: float
    kind: Kind = "body"


@dataclass(frozen=True)
class Curve:
    """The points `at` for a parameter from `low` to `high`; a depth may depend on it, too."""

    kind: Kind
    at: Place
    parameter: sp.Symbol
    low: Expr
    high: Expr
    samples: int = 96
    depth: Expr = None


@dataclass(frozen=True)
class Trail:
    """The points `at` of every state of a recurrence: a line through them, dots on the first 60."""

    kind: Kind
    at: Place
    recurrence: Recurrence
    line: bool = True
    dots: bool = True


@dataclass(frozen=True)
class AngleArc:
    """An angle around a point: its arc, and the sector in it."""

    kind: Kind
    at: Place
    start: Expr
    end: Expr
    radius: float
    label: str | None = None


# Numbers beside the picture.


@dataclass(frozen=True)
class Readout:
    """A number to read. name: for `sentence`, tests; words: instead of "inf", "-inf", "nan".

    A quantity as the name gives its letter and unit, and itself as the value. digits: after the
    point, 1 of an angle and 3 of all else unless said; -2 means two digits and a power of ten.
    """

    name: Any
    label: str = ""
    value: Expr = None
    unit: str = ""
    digits: int | None = None
    words: Mapping[str, str] = field(default_factory=dict)
    symbol: NamedSymbol | None = None

    def __post_init__(self) -> None:
        known: dict[str, Any] = {}
        if isinstance(symbol := self.name, NamedSymbol):
            value = symbol if self.value is None else self.value
            known = {"name": str(symbol), "symbol": symbol, "unit": symbol.unit, "value": value}
            known["label"] = self.label or default_label(symbol)
        if self.digits is None:
            known["digits"] = 1 if known.get("unit", self.unit) == "rad" else 3
        for key, each in known.items():
            object.__setattr__(self, key, each)
        refuse_other_than_si(self.unit, f"the readout {self.name}")
