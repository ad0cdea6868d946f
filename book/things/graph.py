"""A small graph inside a flat picture: the place of a point is an expression of its two numbers.

For example::

    graph = Graph((0.1, 0.3, 0.0, 0.15), x=(1, 100), y=(1e-6, 1), titles=("n", "error"))
    graph.place((n, error))   # a pair for shapes and handles
    graph.shapes()            # frame, numbers and titles of the axes
    graph.x_at(POINTER)       # the number on the x axis at a place of the picture
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import log10

import sympy as sp

from courseware.figures import Area, Label, Line
from courseware.figures.computed_parts import Expr, Place

Range = tuple[float, float]
Words = Mapping[Expr, str]
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Graph:
    """A graph in a box of the picture, (x_low, x_high, y_low, y_high) in metres.

    x, y: the ranges that it shows, by powers of ten; titles: of the two axes.
    """

    box: tuple[float, float, float, float]
    x: Range
    y: Range
    titles: tuple[str, str]

    def place(self, pair: Place) -> Place:
        """Return the place in the picture of a point of the graph."""
        left, right, low, high = self.box
        across, up = _share(pair[0], self.x), _share(pair[1], self.y)
        return left + (right - left) * across, low + (high - low) * up

    def x_at(self, place: Place) -> Expr:
        """Return the number on the x axis at a place of the picture."""
        left, right, low, high = *self.box[:2], *map(_power, self.x)
        return sp.Integer(10) ** (low + (high - low) * (place[0] - left) / (right - left))

    def shapes(self) -> tuple[Area | Line | Label, ...]:
        """Return the frame, the numbers and the titles of the axes."""
        left, right, low, high = self.box
        corners = ((left, low), (right, low), (right, high), (left, high))
        beside = (right - left) / 16
        numbers = {(self.place((x, 1))[0], low - 1.2 * beside): x for x in _ticks(self.x)}
        across = [self.place((x, self.y[0]))[0] for x in _ticks(self.x)]
        up = [self.place((self.x[0], y))[1] for y in _ticks(self.y)]
        for y in _ticks(self.y)[1:]:  # the lowest would meet the first below the axis
            numbers[left - 1.8 * beside, self.place((1, y))[1]] = y
        return (
            Area("grid", corners),
            *(Line("grid", ((x, low), (x, high))) for x in across),
            *(Line("grid", ((left, y), (right, y))) for y in up),
            Line("text", ((left, high), (left, low), (right, low))),
            *(Label("text", place, _power_text(x)) for place, x in numbers.items()),
            # the words of its curves, which give way to the numbers
            Label("path", ((left + right) / 2, low - 3.6 * beside), self.titles[0]),
            Label("path", (left, high + 1.3 * beside), self.titles[1]),
        )


@dataclass(frozen=True)
class LinearGraph:
    """A graph in a box of the picture, with even scales; x, y: the ranges that it shows."""

    box: tuple[float, float, float, float]
    x: tuple[Expr, Expr]
    y: tuple[Expr, Expr]

    def place(self, pair: Place) -> Place:
        """Return the place in the picture of a point of the graph."""
        left, right, low, high = self.box
        across = (pair[0] - self.x[0]) / (self.x[1] - self.x[0])
        up = (pair[1] - self.y[0]) / (self.y[1] - self.y[0])
        return left + (right - left) * across, low + (high - low) * up

    def shapes(self, across: str, up: str, xs: Words, ys: Words) -> tuple[Line | Label, ...]:
        """Return lines and titles; xs, ys: numbers of the axes with their words."""
        left, right, low, high = self.box
        beside = (right - left) / 18
        return (
            *(Line("grid", (self.place((self.x[0], y)), self.place((self.x[1], y)))) for y in ys),
            Line("text", ((left, high), (left, low), (right, low))),
            *(Label("text", (self.place((x, 0))[0], low - beside), w) for x, w in xs.items()),
            *(Label("text", (left - beside, self.place((0, y))[1]), w) for y, w in ys.items()),
            Label("path", ((left + right) / 2, low - beside), across),  # give way to the numbers
            Label("path", ((left + right) / 2, high + beside), up),
        )


def _share(number: Expr, ends: Range) -> Expr:
    low, high = map(_power, ends)
    return (_power(number) - low) / (high - low)


def _power(number: Expr) -> Expr:
    return sp.log(number) / sp.log(10)


def _ticks(ends: Range) -> Sequence[float]:
    """Return every power of ten on an axis, or some where there are many."""
    low, high = (round(log10(end)) for end in ends)
    each = 1 if high - low < 4 else 1 + (high - low) // 3
    return [10.0**power for power in range(low, high + 1, each)]


def _power_text(number: float) -> str:
    return "10" + str(round(log10(number))).translate(RAISED)
