"""A small graph inside a flat picture: where it shows two numbers is an expression of them.

For example::

    graph = Graph((0.1, 0.3, 0.0, 0.15), x=(1, 100), y=(1e-6, 1), words=("n", "error"))
    graph.place((n, error))      # a pair for shapes and handles
    graph.shapes()            # frame, numbers and words
    graph.x_at(POINTER)       # the number on the x axis at a place of the picture
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import log10

import sympy as sp

from courseware.figures.declaration import Area, Expr, Label, Line, Place

Range = tuple[float, float]
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Graph:
    """A graph in a box of the picture, (x_low, x_high, y_low, y_high) in metres.

    x, y: the ranges that it shows, by powers of ten; words: along the two axes.
    """

    box: tuple[float, float, float, float]
    x: Range
    y: Range
    words: tuple[str, str]

    def place(self, pair: Place) -> Place:
        """Where the picture shows a point of the graph."""
        (left, right), (low, high) = self.box[:2], self.box[2:]
        across, up = self._share(pair[0], self.x), self._share(pair[1], self.y)
        return left + (right - left) * across, low + (high - low) * up

    def x_at(self, place: Place) -> Expr:
        """The number on the x axis at a place of the picture."""
        left, right, low, high = *self.box[:2], *map(_power, self.x)
        return sp.Integer(10) ** (low + (high - low) * (place[0] - left) / (right - left))

    def shapes(self) -> tuple[Area | Line | Label, ...]:
        """The frame, the numbers and the words."""
        left, right, low, high = self.box
        corners = ((left, low), (right, low), (right, high), (left, high))
        beside = (right - left) / 16
        along = (
            Label("text", ((left + right) / 2, low - 3.6 * beside), self.words[0]),
            Label("text", (left, high + 1.3 * beside), self.words[1]),
        )
        x_ticks = (
            (self.place((x, self.y[0]))[0], low - 1.2 * beside, x) for x in self._ticks(self.x)
        )
        y_ticks = (  # but the lowest, which would meet the first below the axis
            (left - 1.8 * beside, self.place((self.x[0], y))[1], y) for y in self._ticks(self.y)[1:]
        )
        numbers = (Label("text", (p, q), _told(x)) for p, q, x in (*x_ticks, *y_ticks))
        return (
            Area("grid", corners),
            Line("text", ((left, high), (left, low), (right, low))),
            *numbers,
            *along,
        )

    def _share(self, number: Expr, ends: Range) -> Expr:
        low, high = map(_power, ends)
        return (_power(number) - low) / (high - low)

    def _ticks(self, ends: Range) -> Sequence[float]:
        """Every power of ten on an axis, or some where there are many."""
        low, high = (round(log10(end)) for end in ends)
        return [10.0**power for power in range(low, high + 1, 1 + (high - low) // 4)]


def _power(number: Expr) -> Expr:
    """The power of ten that a number is."""
    return sp.log(number) / sp.log(10)


def _told(number: float) -> str:
    return "10" + str(round(log10(number))).translate(RAISED)
