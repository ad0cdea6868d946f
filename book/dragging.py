"""Angles under the hand: what the handles of several chapters set."""

from collections.abc import Sequence
from typing import Any

from sympy import Matrix, Max, atan2, cos, pi, sign, sin, sqrt

from courseware.figures import POINTER, VIEW, Handle


def around(angle: Any) -> Any:
    """Return an angle that a hand has turned past half a turn, from the other side."""
    over, under = (sign(x - pi - 1e-9, evaluate=False) for x in (angle, -angle))  # 1 or -1
    return angle - pi * (over - under)


def towards(angle: Any, direction: Any) -> Any:
    """Return an angle turned into a direction, the short way round."""
    off = direction - angle
    s, c = sin(off, evaluate=False), cos(off, evaluate=False)  # SymPy's evaluation takes seconds
    return around(angle + atan2(s, c, evaluate=False))


THIN = 0.02  # of the square of its long axis: less, and a circle is seen from its side
SHORT = 1e-6  # m²: a circle of a millimetre is a point, which no hand can lead round
ROUNDING = 1e-14


def turn_handle(label: str, angle: Any, at: Sequence[Any]) -> Handle:
    """Return a handle at a point in space that an angle turns: round its circle in the picture.

    at: an expression of the angle itself. In the picture its circle is an ellipse, and the hand's
    place along both axes tells the angle. On a thin one it only tells how far along; then the point
    stays on its side, until the hand goes past an end.
    """
    seen = Matrix(VIEW.project(at))
    at_0, at_90, at_180 = (seen.subs(angle, turn) for turn in (0, pi / 2, pi))
    middle = (at_0 + at_180) / 2
    one, other = at_0 - middle, at_90 - middle
    unlike = one.dot(one) - other.dot(other)
    first = atan2(2 * one.dot(other), unlike, evaluate=False) / 2  # where it is longest
    c, s, turned = cos(first), sin(first), angle - first
    off, long, short = Matrix(POINTER) - middle, c * one + s * other, c * other - s * one
    along = (off.dot(long) + SHORT * cos(turned)) / (long.dot(long) + SHORT)
    side = sign(sin(turned) + 1e-9, evaluate=False)  # at an end of the line, one of both
    stays = side * sqrt(Max(0, 1 - ROUNDING - along**2, evaluate=False))
    thin = THIN * long.dot(long)
    across = (off.dot(short) + thin * stays + SHORT * sin(turned)) / (
        short.dot(short) + thin + SHORT
    )
    direction = first + atan2(across, along, evaluate=False)
    return Handle(label, tuple(seen), {angle: towards(angle, direction)})
