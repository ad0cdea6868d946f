"""The triangle of two links, shoulder, elbow and wrist: what the two arms share."""

import numpy as np

from robokin._checks import Array, Bools, at, first
from robokin.errors import UnreachableError

TOLERANCE = 1e-12  # a wrist that rounding put outside the shell, in parts of both links together


def triangle(distance: Array, upper: Array, fore: Array) -> tuple[Array, Array]:
    """From the wrist's distance the angle at the shoulder, and how far the elbow is bent; ≥ 0.

    Law of cosines in half angles: the digits of the distance are kept at full stretch.
    """
    high, difference = upper + fore, upper - fore
    d = np.minimum(np.maximum(distance, np.abs(difference)), high)
    a, b, c, e = high - d, high + d, d - difference, d + difference
    lift = 2 * np.arctan2(np.sqrt(a * c), np.sqrt(b * e))
    elbow = 2 * np.arctan2(np.sqrt(a * b), np.sqrt(c * e))
    return lift, elbow


def out_of_reach(name: str, distance: Array, upper: Array, fore: Array, unreachable: str) -> Bools:
    """Where the wrist would be outside the shell; with "raise" the first one is refused."""
    low, high = np.abs(upper - fore), upper + fore
    bad = (distance > high * (1 + TOLERANCE)) | (distance < low - high * TOLERANCE)
    if unreachable == "raise" and np.count_nonzero(bad):
        index = first(bad)
        d, low, high = (np.broadcast_to(a, bad.shape)[index] for a in (distance, low, high))
        raise UnreachableError(
            f"{name}{at(index)} is out of reach by {max(low - d, d - high):.6g} m: the wrist would "
            f"be {d:.6g} m from the shoulder, allowed {low:.6g} to {high:.6g} m"
        )
    return bad
