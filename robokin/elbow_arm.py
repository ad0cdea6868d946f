"""The three-joint elbow arm: a base that turns, a shoulder and an elbow in one vertical plane.

Joint angles `[theta1, theta2, theta3]` and points `[x, y, z]`, seen from the base, stand on the
last axis; leading batch dimensions broadcast. The shoulder is d1 above the base, the upper link
is a2 long, the forearm a3; at zero the arm lies stretched along x, positive theta2 and theta3
raise it. Exercise 1; Spong, Hutchinson & Vidyasagar, Robot Modeling and Control, section 3.3.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robokin._checks import Array, choice, finite, positive, quiet, rows
from robokin.errors import UnreachableError

__all__ = [
    "forward",
    "inverse",
    "joint_positions",
    "nearest_reachable",
    "on_base_axis",
    "reach",
]

TOLERANCE = 1e-12  # a wrist that rounding put outside the shell, in parts of a2 + a3


@quiet
def forward(theta: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0) -> Array:
    """The wrist's position from the joint angles.

    theta: (…, 3) in rad; a2, a3: (…) in m, positive; d1: (…) in m, any finite number
    → (…, 3) in m. Source: exercise 1, r = a2 cos θ2 + a3 cos(θ2+θ3).

    >>> forward([0, np.pi / 2, -np.pi / 2], a2=0.4, a3=0.3, d1=0.1).round(6)
    array([0.3, 0. , 0.5])
    """
    a2, a3, d1 = positive("a2", a2), positive("a3", a3), finite("d1", d1)
    shape, (t,) = rows(("theta", theta, (3,)), parameters=(a2, a3, d1))
    raised = t[..., 1] + t[..., 2]
    r = a2 * np.cos(t[..., 1]) + a3 * np.cos(raised)
    out = np.empty((*shape, 3))
    out[..., 0] = r * np.cos(t[..., 0])
    out[..., 1] = r * np.sin(t[..., 0])
    out[..., 2] = a2 * np.sin(t[..., 1]) + a3 * np.sin(raised) + d1
    return out


@quiet
def joint_positions(theta: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0) -> Array:
    """Where base, shoulder, elbow and wrist are, in this order: the arm as it is drawn.

    theta: (…, 3) in rad; a2, a3, d1: (…) in m → (…, 4, 3) in m, a row for each point.
    """
    a2, a3, d1 = positive("a2", a2), positive("a3", a3), finite("d1", d1)
    shape, (t,) = rows(("theta", theta, (3,)), parameters=(a2, a3, d1))
    raised = t[..., 1] + t[..., 2]
    c, s = np.cos(t[..., 0]), np.sin(t[..., 0])
    r = a2 * np.cos(t[..., 1])
    z = a2 * np.sin(t[..., 1]) + d1
    out = np.empty((*shape, 4, 3))
    out[..., :2, :] = 0 * t[..., None, :]
    out[..., 1, 2] += d1
    out[..., 2, 0], out[..., 2, 1], out[..., 2, 2] = r * c, r * s, z
    r, z = r + a3 * np.cos(raised), z + a3 * np.sin(raised)
    out[..., 3, 0], out[..., 3, 1], out[..., 3, 2] = r * c, r * s, z
    return out


@quiet
def inverse(
    p: ArrayLike,
    a2: ArrayLike,
    a3: ArrayLike,
    d1: ArrayLike = 0.0,
    unreachable: str = "raise",
) -> Array:
    """All four ways to bring the wrist to a point.

    p: (…, 3) in m; a2, a3: (…) in m, positive; d1: (…) in m → (…, 4, 3) in rad. The rows:
    facing the target, elbow up (theta3 ≤ 0); facing it, elbow down (theta3 ≥ 0); facing away,
    elbow up (theta3 ≥ 0); facing away, elbow down (theta3 ≤ 0). Up is the elbow above the line
    from shoulder to wrist. theta1 and theta2 are in (-π, π], theta3 in [-π, π].
    Stretched or folded, up and down are one. On the base axis theta1 is free: 0 facing, π away.
    With a2 = a3 and p at the shoulder theta2 is free too: 0.
    Outside the shell of `reach` (by more than 1e-12 of a2 + a3) there is no answer:
    `UnreachableError`, or NaN with unreachable="nan".
    Source: exercise 1; the law of cosines in half angles, which keep the digits of the distance
    from the shoulder at full stretch.

    >>> inverse([0.3, 0, 0.4], a2=0.4, a3=0.3)[0].round(6)
    array([ 0.      ,  1.570796, -1.570796])
    """
    choice("unreachable", unreachable, ("raise", "nan"))
    a2, a3, d1 = positive("a2", a2), positive("a3", a3), finite("d1", d1)
    shape, (p,) = rows(("p", p, (3,)), parameters=(a2, a3, d1))
    x, y, h = p[..., 0] + 0.0, p[..., 1] + 0.0, p[..., 2] - d1  # + 0.0 turns -0.0 into 0.0
    r_squared = x * x + y * y
    distance = np.sqrt(r_squared + h * h)
    bad = _out_of_reach("p", distance, a2, a3, unreachable)
    lift, elbow = _triangle(distance, a2, a3)
    elevation = np.arctan2(h, np.sqrt(r_squared))
    up, down = elevation + lift, elevation - lift
    theta1 = _raise_minus_pi(np.arctan2(y, x))
    away = _half_turn(theta1)
    out = np.empty((*shape, 4, 3))
    out[..., 0, 0] = out[..., 1, 0] = theta1
    out[..., 2, 0] = out[..., 3, 0] = away
    out[..., 0, 1] = up - 2 * np.pi * (up > np.pi)
    out[..., 1, 1] = _raise_minus_pi(down)
    out[..., 2, 1] = _half_turn(-up)  # away: the same arm seen from behind, π - theta2, -theta3
    out[..., 3, 1] = _half_turn(-down)
    out[..., 1, 2] = out[..., 2, 2] = elbow
    out[..., 0, 2] = out[..., 3, 2] = 0.0 - elbow
    out[(distance == 0) & ~bad, :, 1] = 0.0
    out[bad] = np.nan
    return out


@quiet
def reach(a2: ArrayLike, a3: ArrayLike) -> tuple[Array, Array]:
    """The smallest and the largest distance from shoulder to wrist: folded and stretched.

    a2, a3: (…) in m, positive → minimum `|a2 - a3|` (…) and maximum a2 + a3 (…) in m.
    """
    a2, a3 = positive("a2", a2), positive("a3", a3)
    rows(parameters=(a2, a3))
    return np.abs(a2 - a3), a2 + a3


@quiet
def nearest_reachable(p: ArrayLike, a2: ArrayLike, a3: ArrayLike, d1: ArrayLike = 0.0) -> Array:
    """The point within reach that is nearest to p: p itself, or p moved along its ray.

    p: (…, 3) in m; a2, a3: (…) in m, positive; d1: (…) in m → (…, 3) in m. The ray starts at
    the shoulder; where p is the shoulder itself all directions are as near, and x is taken.

    >>> nearest_reachable([3, 0, 4], a2=0.4, a3=0.1).round(6)
    array([0.3, 0. , 0.4])
    """
    d1 = finite("d1", d1)
    low, high = reach(a2, a3)
    shape, (p,) = rows(("p", p, (3,)), parameters=(low, d1))
    ray = np.broadcast_to(p, (*shape, 3)).copy()
    ray[..., 2] -= d1
    largest = np.abs(ray).max(axis=-1)
    ray[largest == 0, 0] = 1.0
    ray /= np.abs(ray).max(axis=-1, keepdims=True)  # so that no square overflows or vanishes
    length = np.sqrt((ray * ray).sum(axis=-1))
    distance = largest * length
    out = ray * (np.clip(distance, low, high) / length)[..., None]
    out[..., 2] += d1
    inside = (low <= distance) & (distance <= high)
    return np.where(inside[..., None], p, out)


@quiet
def on_base_axis(p: ArrayLike, tol: ArrayLike = 1e-9) -> NDArray[np.bool_]:
    """Whether a point lies on the base axis (x = y = 0), where theta1 is free.

    p: (…, 3) in m; tol: (…) distance from the axis in m, positive → (…) bool; False for NaN.
    """
    tol = positive("tol", tol)
    _, (p,) = rows(("p", p, (3,)), parameters=(tol,))
    return np.asarray(np.hypot(p[..., 0], p[..., 1]) <= tol)[()]


def _triangle(distance: Array, a2: Array, a3: Array) -> tuple[Array, Array]:
    """The triangle shoulder, elbow, wrist: its angle at the shoulder, and theta3, both ≥ 0."""
    high, difference = a2 + a3, a2 - a3
    d = np.minimum(np.maximum(distance, np.abs(difference)), high)
    a, b, c, e = high - d, high + d, d - difference, d + difference
    lift = 2 * np.arctan2(np.sqrt(a * c), np.sqrt(b * e))
    elbow = 2 * np.arctan2(np.sqrt(a * b), np.sqrt(c * e))
    return lift, elbow


def _out_of_reach(
    name: str, distance: Array, a2: Array, a3: Array, unreachable: str
) -> NDArray[np.bool_]:
    """Where the wrist is asked outside the shell; in mode "raise" the first one is refused."""
    low, high = np.abs(a2 - a3), a2 + a3
    bad = (distance > high * (1 + TOLERANCE)) | (distance < low - high * TOLERANCE)
    if unreachable == "raise" and bad.any():
        d, low, high = np.broadcast_arrays(distance, low, high)
        index, where = _first(bad)
        gap = max(low[index] - d[index], d[index] - high[index])
        raise UnreachableError(
            f"{name}{where} is out of reach by {gap:.6g} m: its wrist is {d[index]:.6g} m "
            f"from the shoulder, allowed {low[index]:.6g} to {high[index]:.6g} m"
        )
    return np.asarray(bad)


def _first(bad: NDArray[np.bool_]) -> tuple[tuple[int, ...], str]:
    """The index of the first bad item, and how a message names it."""
    index = tuple(np.argwhere(bad)[0])
    return index, f" at index {', '.join(map(str, index))}" if index else ""


def _raise_minus_pi(angle: Array) -> Array:
    """An angle in (-3π, π] brought into (-π, π]."""
    return angle + 2 * np.pi * (angle <= -np.pi)


def _half_turn(angle: Array) -> Array:
    """The opposite direction of an angle in (-2π, 2π), in (-π, π]."""
    return _raise_minus_pi(angle - np.copysign(np.pi, angle))
