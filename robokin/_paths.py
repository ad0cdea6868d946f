"""A path of steps, each straight in one direction: what the drives and odometry share."""

import numpy as np

from robokin._arrays import Array, ArrayLike
from robokin._validation import data, finite, one_of

METHOD = one_of("exact", "midpoint", "start", "end")
PATH = {"pose": data(3), "dt": finite(), "method": METHOD}


def follow(
    pose: Array, length: ArrayLike, turn: ArrayLike, method: str, turned: Array | None = None
) -> Array:
    """Return the poses (…, N+1, 3) from the first one on.

    pose: (…, 3); length, turn: of each step, (…, N) together, or one for all; turned: (…, N) since
    the start, where it is known better than by summing the turns.
    """
    steps = np.broadcast(pose[..., :1], length, turn).shape
    turn = np.broadcast_to(turn, steps)
    out = np.empty((*steps[:-1], steps[-1] + 1, 3))
    out[..., 0, :] = pose
    out[..., 1:, 2] = pose[..., 2:] + (turn.cumsum(-1) if turned is None else turned)
    if method == "exact":
        length = length * sinc(turn / 2)
    old, new = out[..., :-1, 2], out[..., 1:, 2]
    heading = {"start": old, "end": new}.get(method, old + turn / 2)
    out[..., 1:, 0] = pose[..., :1] + (length * np.cos(heading)).cumsum(-1)
    out[..., 1:, 1] = pose[..., 1:2] + (length * np.sin(heading)).cumsum(-1)
    return out


def sinc(x: ArrayLike) -> Array:
    """Return sin(x)/x, 1 at 0: it is even, and 1e-300 is lost in every |x| not next to 0."""
    x = np.abs(x) + 1e-300
    return np.sin(x) / x


def sinc_slope(x: Array) -> Array:
    """Return the derivative of sin(x)/x; near 0 by its series, which keeps the digits there."""
    x2 = x * x
    series = -x / 3 * (1 - x2 / 10 * (1 - x2 / 28 * (1 - x2 / 54)))
    return np.where(np.abs(x) < 0.1, series, (np.cos(x) - sinc(x)) / x)


def cos_sin_of_sum(theta: Array, half: Array) -> tuple[Array, Array]:
    """Return cosine and sine of theta + half; corrected for the sum's rounding error."""
    heading = theta + half
    rest = theta - heading + half
    c, s = np.cos(heading), np.sin(heading)
    return c - rest * s, s + rest * c
