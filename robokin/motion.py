"""Planar motion: frames of a moving robot, the exact arc, paths and the centre of rotation.

A pose is `[x, y, theta]`, a planar velocity (twist) `[v_x, v_y, omega]`, both on the last axis;
leading batch dimensions broadcast. Taught in the chapter on the differential drive.
"""

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, choice, finite, quiet, rows

__all__ = ["arc_step", "icr", "move", "path", "to_body", "to_world", "wrap_angle"]

METHODS = ("exact", "midpoint", "start", "end")


@quiet
def wrap_angle(angle: ArrayLike) -> Array:
    """The same direction as an angle in (-π, π].

    angle: (…) in rad. An angle already there is returned unchanged, digit for digit.
    """
    _, (a,) = rows(("angle", angle, ()))
    a = a - 2 * np.pi * np.ceil((a - np.pi) / (2 * np.pi))
    return np.where(a <= -np.pi, np.pi, np.minimum(a, np.pi))[()]


@quiet
def to_world(theta: ArrayLike, twist: ArrayLike) -> Array:
    """A body twist as seen from the world: its direction turned by the heading.

    theta: heading (…) in rad; twist: (…, 3) `[v_x, v_y, omega]` in m/s, m/s, rad/s → (…, 3).
    Source: exercise 4, ξ̇_I = R(θ) ξ̇_R.

    >>> to_world(np.pi / 2, [0.075, 0, 0.5]).round(6)
    array([0.   , 0.075, 0.5  ])
    """
    return _turn(theta, twist, 1.0)


@quiet
def to_body(theta: ArrayLike, twist: ArrayLike) -> Array:
    """A world twist as seen from the robot: the inverse of `to_world`.

    theta: heading (…) in rad; twist: (…, 3) `[x_dot, y_dot, omega]` → (…, 3).
    """
    return _turn(theta, twist, -1.0)


def _turn(theta: ArrayLike, twist: ArrayLike, sign: float) -> Array:
    shape, (th, tw) = rows(("theta", theta, ()), ("twist", twist, (3,)))
    c, s = np.cos(th), sign * np.sin(th)
    out = np.empty((*shape, 3))
    out[..., 0] = c * tw[..., 0] - s * tw[..., 1]
    out[..., 1] = s * tw[..., 0] + c * tw[..., 1]
    out[..., 2] = tw[..., 2] + 0 * th
    return out


@quiet
def arc_step(pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike) -> Array:
    """The pose after driving for dt with constant speed and turning rate: an exact circular arc.

    pose: (…, 3); v: (…) in m/s; omega: (…) in rad/s; dt: (…) in s, any finite number → (…, 3).
    The chord of the arc, v·dt·sinc(omega·dt/2), is laid along the middle heading; so a straight
    line (omega = 0) needs no case of its own and no digits are lost near it.
    Source: exercise 5, x' = x + R (sin(θ + ω δt) − sin θ), rewritten.

    >>> arc_step([0, 0, 0], v=1.0, omega=0.0, dt=2.0)
    array([2., 0., 0.])
    """
    dt = finite("dt", dt)
    shape, (p, v, omega) = rows(
        ("pose", pose, (3,)), ("v", v, ()), ("omega", omega, ()), parameters=(dt,)
    )
    half = 0.5 * (omega * dt)
    chord = v * dt * _sinc(half)
    heading = p[..., 2] + half
    out = np.empty((*shape, 3))
    out[..., 0] = p[..., 0] + chord * np.cos(heading)
    out[..., 1] = p[..., 1] + chord * np.sin(heading)
    out[..., 2] = p[..., 2] + omega * dt
    return out


@quiet
def move(pose: ArrayLike, twist: ArrayLike, dt: ArrayLike) -> Array:
    """The pose after moving for dt with a constant body twist, sideways speed included.

    pose: (…, 3); twist: (…, 3) in the body frame; dt: (…) in s → (…, 3). This is the
    exponential map of SE(2); with v_y = 0 it is `arc_step`.
    Source: Lynch & Park, Modern Robotics, section 3.3.3 (in the plane).
    """
    dt = finite("dt", dt)
    shape, (p, tw) = rows(("pose", pose, (3,)), ("twist", twist, (3,)), parameters=(dt,))
    half = 0.5 * (tw[..., 2] * dt)
    scale = dt * _sinc(half)
    c, s = np.cos(p[..., 2] + half), np.sin(p[..., 2] + half)
    out = np.empty((*shape, 3))
    out[..., 0] = p[..., 0] + scale * (c * tw[..., 0] - s * tw[..., 1])
    out[..., 1] = p[..., 1] + scale * (s * tw[..., 0] + c * tw[..., 1])
    out[..., 2] = p[..., 2] + tw[..., 2] * dt
    return out


@quiet
def path(
    pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike, method: str = "exact"
) -> Array:
    """All poses along a drive of N steps, the first included.

    pose: (…, 3) at the start; v, omega, dt: broadcast to (…, N) → (…, N+1, 3). Every step goes
    straight in one direction: the exact arc's chord ("exact"), or the step's full length along
    its middle ("midpoint"), its old ("start") or its new heading ("end"). A NaN makes the path
    NaN from its step on.
    """
    choice("method", method, METHODS)
    dt = np.atleast_1d(finite("dt", dt))
    steps, (v, omega) = rows(
        ("v", np.atleast_1d(v), ()), ("omega", np.atleast_1d(omega), ()), parameters=(dt,)
    )
    batch, (p,) = rows(("pose", pose, (3,)), parameters=(np.broadcast_to(0.0, steps[:-1]),))
    turn, length = omega * dt, v * dt
    out = np.empty((*batch, steps[-1] + 1, 3))
    out[..., 0, :] = p
    out[..., 1:, 2] = p[..., 2:] + np.cumsum(np.broadcast_to(turn, steps), axis=-1)
    if method == "exact":
        length = length * _sinc(0.5 * turn)
    if method == "start":
        heading = out[..., :-1, 2]
    elif method == "end":
        heading = out[..., 1:, 2]
    else:
        heading = out[..., :-1, 2] + 0.5 * turn
    out[..., 1:, 0] = p[..., :1] + np.cumsum(length * np.cos(heading), axis=-1)
    out[..., 1:, 1] = p[..., 1:2] + np.cumsum(length * np.sin(heading), axis=-1)
    return out


@quiet
def icr(pose: ArrayLike, v: ArrayLike, omega: ArrayLike) -> Array:
    """The instantaneous centre of rotation (ICR): the point of the plane that stands still.

    pose: (…, 3); v: (…) in m/s; omega: (…) in rad/s → (…, 2). It lies v/omega to the left of the
    robot. On a straight line there is none: both coordinates are +inf; standing still every
    point is one: NaN.
    Source: exercise 5, ICR = [x − R sin θ, y + R cos θ].

    >>> icr([0, 0, 0], v=0.075, omega=0.5)
    array([0.  , 0.15])
    """
    shape, (p, v, omega) = rows(("pose", pose, (3,)), ("v", v, ()), ("omega", omega, ()))
    radius = np.asarray(v / omega)
    out = np.empty((*shape, 2))
    out[..., 0] = p[..., 0] - radius * np.sin(p[..., 2])
    out[..., 1] = p[..., 1] + radius * np.cos(p[..., 2])
    out[np.isinf(np.broadcast_to(radius, shape))] = np.inf
    return out


def _sinc(x: Array) -> Array:
    """sin(x)/x, 1 at 0: at zero a number too small to change the sine's argument stands in."""
    x = x + 1e-300 * (x == 0)
    return np.sin(x) / x
