"""The three-joint elbow arm: a base that turns, a shoulder and an elbow in one vertical plane.

Joint angles are `[theta1, theta2, theta3]`, points `[x, y, z]` as seen from the base. The shoulder
is d1 above the base, the upper link is a2 long, the forearm a3; at zero the arm lies stretched
along x, positive theta2 and theta3 raise it. Spong, Hutchinson & Vidyasagar, Robot Modeling and
Control, section 3.3.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, Bools, matrix, opposite, parts, vector, wrap
from robokin._triangle import out_of_reach, triangle
from robokin._validation import data, finite, one_of, positive, validated

__all__ = ["forward", "inverse", "joint_positions", "nearest_reachable", "on_base_axis", "reach"]

LINKS = {"a2": positive(), "a3": positive(), "d1": finite()}


@validated(theta=data(3), **LINKS)
def forward(theta: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0) -> Array:
    """Return the wrist's position from the joint angles.

    Its distance from the base axis is r = a2 cos θ2 + a3 cos(θ2 + θ3).

    Parameters
    ----------
    theta : array_like, shape (..., 3)
        Joint angles in rad.
    a2, a3 : array_like, shape (...)
        Lengths of the links in m.
    d1 : array_like, shape (...), default 0.0
        Height of the shoulder in m, any finite number.

    Returns
    -------
    ndarray, shape (..., 3)
        Wrist in m.

    Examples
    --------
    >>> forward([0, np.pi / 2, -np.pi / 2], a2=0.4, a3=0.3, d1=0.1).round(6)
    array([0.3, 0. , 0.5])
    """
    theta1, theta2, theta3 = parts(theta)
    r = a2 * np.cos(theta2) + a3 * np.cos(theta2 + theta3)
    h = a2 * np.sin(theta2) + a3 * np.sin(theta2 + theta3)
    return vector(r * np.cos(theta1), r * np.sin(theta1), h + d1)


@validated(theta=data(3), **LINKS)
def joint_positions(theta: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0) -> Array:
    """Return where base, shoulder, elbow and wrist are: the arm as it is drawn.

    Parameters
    ----------
    theta : array_like, shape (..., 3)
        Joint angles in rad.
    a2, a3 : array_like, shape (...)
        Lengths of the links in m.
    d1 : array_like, shape (...), default 0.0
        Height of the shoulder in m, any finite number.

    Returns
    -------
    ndarray, shape (..., 4, 3)
        Points in m, in this order.
    """
    theta1, theta2, theta3 = parts(theta)
    c, s = np.cos(theta1), np.sin(theta1)
    r2, z2 = a2 * np.cos(theta2), a2 * np.sin(theta2) + d1
    r3, z3 = r2 + a3 * np.cos(theta2 + theta3), z2 + a3 * np.sin(theta2 + theta3)
    return matrix([[0, 0, 0], [0, 0, d1], [r2 * c, r2 * s, z2], [r3 * c, r3 * s, z3]])


@validated(p=data(3), **LINKS, unreachable=one_of("raise", "nan"))
def inverse(
    p: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0, unreachable: str = "raise"
) -> Array:
    """Return all four ways to bring the wrist to a point.

    Stretched or folded, elbow up and elbow down are one. On the base axis theta1 is free: 0 facing,
    π away. With a2 = a3 and p at the shoulder theta2 is free too: 0. The law of cosines is used in
    half angles, which keep the digits of the distance from the shoulder at full stretch.

    Parameters
    ----------
    p : array_like, shape (..., 3)
        Wrist in m.
    a2, a3 : array_like, shape (...)
        Lengths of the links in m.
    d1 : array_like, shape (...), default 0.0
        Height of the shoulder in m, any finite number.
    unreachable : {"raise", "nan"}, default "raise"
        Whether a point out of reach raises or gives NaN.

    Returns
    -------
    ndarray, shape (..., 4, 3)
        Joint angles in rad, theta1 and theta2 in (-π, π], theta3 in [-π, π]. The rows: facing the
        target, elbow up (theta3 ≤ 0); facing it, elbow down (theta3 ≥ 0); facing away, elbow up
        (theta3 ≥ 0); facing away, elbow down (theta3 ≤ 0). Up is above the line from shoulder to
        wrist.

    Raises
    ------
    UnreachableError
        If p is outside the shell of `reach` by more than 1e-12 of a2 + a3.

    References
    ----------
    Spong et al., section 3.3.

    Examples
    --------
    >>> inverse([0.3, 0, 0.4], a2=0.4, a3=0.3)[0].round(6)
    array([ 0.      ,  1.570796, -1.570796])
    """
    x, y, z = parts(p)
    h, r_squared = z - d1, x * x + y * y
    d = np.sqrt(r_squared + h * h)
    outside = out_of_reach("p", p, d, a2, a3, unreachable)
    lift, elbow = triangle(d, a2, a3)
    rise = np.arctan2(h, np.sqrt(r_squared))
    up, down = rise + lift, rise - lift
    facing = wrap(np.arctan2(y + 0.0, x + 0.0))  # + 0.0 turns -0.0 into 0.0
    away = opposite(facing)  # the same arm seen from behind: π - theta2 and -theta3
    out = matrix(
        [
            [facing, up - 2 * np.pi * (up > np.pi), -elbow],
            [facing, wrap(down), elbow],
            [away, opposite(-up), elbow],
            [away, opposite(-down), -elbow],
        ]
    )
    out[(d == 0) & ~outside, :, 1] = 0.0
    out[outside] = np.nan
    return out


@validated(a2=positive(), a3=positive())
def reach(a2: ArrayLike, a3: ArrayLike) -> tuple[Array, Array]:
    """Return the smallest and largest distance from shoulder to wrist: folded and stretched.

    Parameters
    ----------
    a2, a3 : array_like, shape (...)
        Lengths of the links in m.

    Returns
    -------
    minimum : ndarray, shape (...)
        `|a2 - a3|` in m.
    maximum : ndarray, shape (...)
        a2 + a3 in m.
    """
    return np.abs(a2 - a3), a2 + a3


@validated(p=data(3), **LINKS)
def nearest_reachable(p: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0) -> Array:
    """Return the point within reach that is nearest to p: p itself, or p moved along its ray.

    The ray starts at the shoulder. Where p is the shoulder itself, all directions are as near, and
    x is taken.

    Parameters
    ----------
    p : array_like, shape (..., 3)
        Point in m.
    a2, a3 : array_like, shape (...)
        Lengths of the links in m.
    d1 : array_like, shape (...), default 0.0
        Height of the shoulder in m, any finite number.

    Returns
    -------
    ndarray, shape (..., 3)
        Point in m.

    Examples
    --------
    >>> nearest_reachable([3, 0, 4], a2=0.4, a3=0.1).round(6)
    array([0.3, 0. , 0.4])
    """
    x, y, z = parts(p)
    h = z - d1
    size = np.maximum(np.maximum(np.abs(x), np.abs(y)), np.abs(h))  # no square may overflow
    at = size == 0  # p is the shoulder itself: along x
    x, y, h = (x + at) / (size + at), y / (size + at), h / (size + at)
    length = np.sqrt(x * x + y * y + h * h)
    d, low, high = size * length, np.abs(a2 - a3), a2 + a3
    scale = np.clip(d, low, high) / length
    within = (low <= d) & (d <= high)
    return np.where(within[..., None], p, vector(x * scale, y * scale, d1 + h * scale))


@validated(p=data(3), tol=positive())
def on_base_axis(p: ArrayLike, tol: ArrayLike = 1e-9) -> Bools:
    """Return whether a point lies on the base axis (x = y = 0), where theta1 is free.

    Parameters
    ----------
    p : array_like, shape (..., 3)
        Point in m.
    tol : array_like, shape (...), default 1e-9
        Largest distance from the axis in m.

    Returns
    -------
    ndarray of bool, shape (...)
        Whether it lies there; False for NaN.
    """
    x, y, _ = parts(p)
    return np.hypot(x, y) <= tol
