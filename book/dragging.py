"""Angles under the hand: what the handles of several chapters set."""

from collections.abc import Sequence
from typing import Any

from sympy import Matrix, Piecewise, atan2, cos, pi, sin

from courseware.figures import POINTER, VIEW, Handle


def around(angle: Any) -> Any:
    """Return an angle that a hand has turned past half a turn, from the other side."""
    most, whole = pi + 1e-9, 2 * pi
    return Piecewise((angle - whole, angle > most), (angle + whole, angle < -most), (angle, True))


def towards(angle: Any, direction: Any) -> Any:
    """Return an angle turned into a direction, the short way round."""
    off = direction - angle
    return around(angle + atan2(sin(off), cos(off)))


def turn_handle(label: str, angle: Any, at: Sequence[Any]) -> Handle:
    """Return a handle at a point in space that an angle turns: along its way in the picture.

    at: an expression of the angle itself. Where the point comes towards the viewer, its way is
    short, and the hand turns it little.
    """
    seen = Matrix(VIEW.project(at))
    way = seen.diff(angle)
    off = (Matrix(POINTER) - seen).dot(way) / (way.dot(way) + 0.002)
    return Handle(label, tuple(seen), {angle: around(angle + off)})
