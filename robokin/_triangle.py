"""The triangle of two links, shoulder, elbow and wrist: what the two arms share."""

import numpy as np

from robokin._arrays import Array, Bools, first
from robokin.errors import UnreachableError, at_index

TOLERANCE = 1e-12  # a wrist that rounding put outside the shell, in parts of both links together


def triangle(distance: Array, upper: Array, fore: Array) -> tuple[Array, Array]:
    """Return the angle at the shoulder, and how far the elbow is bent; both ≥ 0.

    Law of cosines in half angles. The sides are taken in the order of their lengths, so that no
    sum is rounded before the difference: the digits of the distance are kept next to full stretch
    and to the folded arm. At the limits of reach, as rounded, and beyond, it is flat.
    Source: Kahan, Miscalculating Area and Angles of a Needle-like Triangle.
    """
    longer, shorter = np.maximum(upper, fore), np.minimum(upper, fore)
    middle, least = np.maximum(distance, shorter), np.minimum(distance, shorter)
    room = ((longer - distance) + shorter) * (distance < upper + fore)
    near = (least - (longer - middle)) * (distance > longer - shorter)
    span, far = (longer + distance) + shorter, distance + (longer - shorter)
    by_upper = upper >= fore  # the longer one
    above, below = np.where(by_upper, near, far), np.where(by_upper, far, near)
    lift = 2 * np.arctan2(np.sqrt(room * above), np.sqrt(span * below))
    elbow = 2 * np.arctan2(np.sqrt(room * span), np.sqrt(near * far))
    return lift, elbow


def out_of_reach(
    name: str, target: Array, distance: Array, upper: Array, fore: Array, unreachable: str
) -> Bools:
    """Return where the wrist would be outside the shell; with "raise" refuse the first target.

    A target that is not finite is not refused: it gives NaN.
    """
    low, high = np.abs(upper - fore), upper + fore
    bad: Bools = (distance > high * (1 + TOLERANCE)) | (distance < low - high * TOLERANCE)
    refused = bad & np.isfinite(target).all(axis=-1)
    if unreachable == "raise" and refused.any():
        index = first(refused)
        d, low, high = (np.broadcast_to(a, bad.shape)[index] for a in (distance, low, high))
        raise UnreachableError(
            f"{name}{at_index(index)} is out of reach by {max(low - d, d - high):.6g} m: the wrist "
            f"would be {d:.12g} m from the shoulder, allowed {low:.12g} to {high:.12g} m"
        )
    return bad
