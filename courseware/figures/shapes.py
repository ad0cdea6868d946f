"""The shapes of a scene, in metres.

In a label `{name}` is a number of the figure. Shapes are painted as declared; those with a `depth`
(larger is nearer) change places among themselves: the nearest comes last.
"""

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import sympy as sp

from courseware.figures.computed_parts import Expr, Kind, Place, Recurrence


@dataclass(frozen=True)
class Point:
    """A marker, its form given by the kind.

    A labelled one that leaves a flat picture with a grid is shown at its edge with its distance
    from the origin in metres.
    """

    kind: Kind
    at: Place
    label: str | None = None
    depth: Expr = None


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
class Curve:
    """The points `at` for a parameter from `low` to `high`; a depth may depend on it, too.

    A circle: `Curve("path", (r * cos(s), r * sin(s)), s, 0, 2 * pi)`.
    """

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
    dots: bool = True


@dataclass(frozen=True)
class Track:
    """Where a place has been since the last reset: the reader's own way. A jump is not drawn.

    Tracks of one name are the same on the whole page.
    """

    kind: Kind
    at: Place
    name: str = ""


@dataclass(frozen=True)
class Cloud:
    """Dots `at` a place for each row of a table, in one path: samples that were drawn with a seed.

    symbols: of the numbers of a row, which `at` depends on beside the figure's own.
    """

    kind: Kind
    at: Place
    symbols: tuple[sp.Symbol, ...]
    rows: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class AngleArc:
    """An angle around a point: its arc, and the sector in it."""

    kind: Kind
    at: Place
    start: Expr
    end: Expr
    radius: float
    label: str | None = None


@dataclass(frozen=True)
class Bracket:
    """A matrix written into the picture, its middle at `at`; looks of its columns, or by row."""

    matrix: sp.Matrix
    at: Place
    label: str = ""
    columns: tuple[str, ...] = ("x_axis", "y_axis", "z_axis")
    digits: int = 0
    by_row: bool = False
    kind: ClassVar[str] = "text"


def when(condition: Any, *shapes: Any) -> tuple[Any, ...]:
    """Return shapes and sprites that are there only while a condition holds."""
    return tuple(_hide_unless(condition, shape) for shape in shapes)


def _hide_unless(condition: Any, shape: Any) -> Any:
    name = next(name for name in ("at", "tail", "start", "points") if hasattr(shape, name))
    first, *others = getattr(shape, name)
    if name == "points":
        return replace(shape, points=(_nan_unless(condition, first), *others))
    return replace(shape, **{name: (*_nan_unless(condition, (first,)), *others)})


def _nan_unless(condition: Any, place: Place) -> Place:
    return tuple(sp.Piecewise((number, condition), (sp.nan, True)) for number in place)
