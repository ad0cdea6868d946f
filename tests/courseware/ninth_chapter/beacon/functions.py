"""What a robot measures of a beacon: how far it is, and in which direction."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robokin.motion import wrap_angle

__all__ = ["range_and_bearing"]


def range_and_bearing(pose: ArrayLike, beacon: ArrayLike) -> NDArray[np.float64]:
    """Return how far a beacon is, and in which direction the robot sees it.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, theta]` in m and rad.
    beacon : array_like, shape (..., 2)
        `[x, y]` in m.

    Returns
    -------
    ndarray, shape (..., 2)
        Distance in m and bearing in (-π, π] rad, 0 straight ahead.

    Examples
    --------
    >>> range_and_bearing([0, 0, np.pi / 2], [0, 2]).round(6)
    array([2., 0.])
    """
    x, y, theta = np.moveaxis(np.asarray(pose, dtype=float), -1, 0)
    b_x, b_y = np.moveaxis(np.asarray(beacon, dtype=float), -1, 0)
    bearing = wrap_angle(np.arctan2(b_y - y, b_x - x) - theta)
    return np.stack(np.broadcast_arrays(np.hypot(b_x - x, b_y - y), bearing), axis=-1)
