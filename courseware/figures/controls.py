"""The controls of a figure: what the reader moves, and which symbols get their numbers from it."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Self

import sympy as sp

from courseware.equations.quantities import NamedSymbol
from courseware.figures.computed_parts import Expr, Place, default_label

POINTER = sp.symbols("pointer_x pointer_y", real=True)


@dataclass(frozen=True)
class Slider:
    """A slider for one symbol. low, high, start, step in SI; its label and unit are the quantity's.

    A step of type int: the symbol is always a whole number. shown: the condition under which it
    is beside the picture; a handle moves it all the same.
    """

    symbol: sp.Symbol
    low: float
    high: float
    start: float
    step: float
    label: str = ""
    kind: str = ""
    shown: Expr = True

    def __post_init__(self) -> None:
        if not self.label and isinstance(self.symbol, NamedSymbol):
            object.__setattr__(self, "label", default_label(self.symbol))

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
        """Make the slider of an angle, declared in degrees."""
        low, high, start, step = map(math.radians, (low, high, start, step))
        return cls(symbol, low, high, start, step, **more)

    @property
    def key(self) -> str:
        """Its name in values and sentences."""
        return str(self.symbol)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols that it sets: one; other controls set several."""
        return (self.symbol,)


@dataclass(frozen=True)
class Clock(Slider):
    """A slider that also plays: it runs from low to high, `rate` of its SI unit in a second.

    loops: it plays by itself while the picture is in sight, twice, for readers who like motion;
    a hand on it stops it, a press plays it again and again.
    """

    start: float = 0.0
    step: float = 0.05
    rate: float = 1.0
    loops: bool = False


@dataclass(frozen=True)
class Choice:
    """One of several named cases: each option gives every symbol its number.

    key: its name in values and sentences. start: the option at first; by default the first.
    shown: as of a slider.
    """

    key: str
    label: str
    symbols: tuple[sp.Symbol, ...]
    options: Mapping[str, tuple[float, ...]]
    start: str = ""
    shown: Expr = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "start", self.start or next(iter(self.options), ""))

    @classmethod
    def one_hot(
        cls, key: str, symbols: Iterable[Any], names: Iterable[str], label: str = "", **more: Any
    ) -> Self:
        """Make a choice in which each name gives its own symbol 1 and all others 0."""
        symbols = tuple(symbols)
        options = {
            each: tuple(int(symbol == chosen) for symbol in symbols)
            for each, chosen in zip(names, symbols, strict=True)
        }
        return cls(key, label or key, symbols, options, **more)


@dataclass(frozen=True)
class QuarterTurns:
    """Quarter turns of a body at the press of a button: about its own axes or the room's.

    A press is a letter, upper case for an own axis (X, Y, Z), lower case for one of the room, with
    a minus before it if the turn is negative. The presses are the state: "Zx-Y". Of the last turn
    a part is made, which grows from 0 to 1 after its press.
    """

    key: ClassVar[str] = "turns"
    start: ClassVar[str] = ""
    label: ClassVar[str] = "turns"
    before: ClassVar[sp.Matrix] = sp.Matrix(3, 3, sp.symbols("before:3:3", real=True))
    # the zero vector before the first turn
    axis: ClassVar[sp.Matrix] = sp.Matrix(sp.symbols("turn_axis:3", real=True))
    own: ClassVar[sp.Symbol] = sp.Symbol("own_axes", real=True)  # 1 or 0, of the last turn
    part: ClassVar[sp.Symbol] = sp.Symbol("turn_part", real=True)
    count: ClassVar[sp.Symbol] = sp.Symbol("presses", real=True)
    symbols: ClassVar[tuple[sp.Symbol, ...]] = (*before, *axis, own, part, count)


Control = Slider | Choice | QuarterTurns


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


@dataclass(frozen=True)
class Button:
    """A button that moves sliders to expressions of all that the figure knows, in a second.

    `Button("let the arm do it", {theta1: bearing, theta2: shoulder})`
    """

    label: str
    sets: Mapping[sp.Symbol, Expr]
