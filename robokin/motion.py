"""Planar motion: frames of a moving robot, the exact arc, paths and the centre of rotation.

A pose is `[x, y, theta]`, a planar velocity (twist) `[v_x, v_y, omega]`, both on the last axis;
leading batch dimensions broadcast. Taught in the chapter on the differential drive.
"""

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, choice, finite, numbers, quiet, rows

__all__ = ["arc_step", "icr", "move", "path", "to_body", "to_world", "wrap_angle"]

METHODS = ("exact", "midpoint", "start", "end")


@quiet
def wrap_angle(angle: ArrayLike) -> Array:
    """The same direction as an angle in (-π, π].

    angle: (…) in rad → (…). An angle already there is returned unchanged, digit for digit.

    >>> wrap_angle([np.pi, -np.pi, 7.0]).round(6)
    array([3.141593, 3.141593, 0.716815])
    """
    _, (a,) = rows(("angle", angle, ()))
    a = np.minimum(a - 2 * np.pi * np.rint(a / (2 * np.pi)), np.pi)
    return np.where(a <= -np.pi, np.pi, a)[()]


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
    c, s = np.cos(th), np.sin(th)
    s *= sign
    out = np.empty((*shape, 3))
    out[..., 0] = c * tw[..., 0] - s * tw[..., 1]
    out[..., 1] = s * tw[..., 0] + c * tw[..., 1]
    out[..., 2] = tw[..., 2]
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
    turn = omega * dt
    chord = v * dt * _sinc(0.5 * turn)
    c, s = _cos_sin(p[..., 2], 0.5 * turn)
    out = np.empty((*shape, 3))
    out[...] = p
    out[..., 0] += chord * c
    out[..., 1] += chord * s
    out[..., 2] += turn
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
    turn = tw[..., 2] * dt
    scale = dt * _sinc(0.5 * turn)
    c, s = _cos_sin(p[..., 2], 0.5 * turn)
    out = np.empty((*shape, 3))
    out[...] = p
    out[..., 0] += scale * (c * tw[..., 0] - s * tw[..., 1])
    out[..., 1] += scale * (s * tw[..., 0] + c * tw[..., 1])
    out[..., 2] += turn
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
    dt = np.atleast_1d(finite("dt", dt))
    v, omega = np.atleast_1d(numbers("v", v), numbers("omega", omega))
    steps, (v, omega) = rows(("v", v, ()), ("omega", omega, ()), parameters=(dt,))
    turn = np.broadcast_to(omega * dt, steps)
    return _follow(pose, turn.cumsum(-1), turn, v * dt, method)


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


def _follow(pose: ArrayLike, turned: Array, turn: Array, length: Array, method: str) -> Array:
    """The poses of `path`, (…, N+1, 3), by the four step rules that odometry shares.

    turned: (…, N) how far the robot has turned since the start; turn, length: (…, N) of each step.
    """
    choice("method", method, METHODS)
    batch, (p,) = rows(("pose", pose, (3,)), parameters=(np.empty(turned.shape[:-1]),))
    out = np.empty((*batch, turned.shape[-1] + 1, 3))
    out[..., 0, :] = p
    out[..., 1:, 2] = p[..., 2:] + turned
    if method == "exact":
        length = length * _sinc(0.5 * turn)
    if method == "start":
        heading = out[..., :-1, 2]
    elif method == "end":
        heading = out[..., 1:, 2]
    else:
        heading = out[..., :-1, 2] + 0.5 * turn
    out[..., 1:, 0] = p[..., :1] + (length * np.cos(heading)).cumsum(-1)
    out[..., 1:, 1] = p[..., 1:2] + (length * np.sin(heading)).cumsum(-1)
    return out


def _sinc(x: Array) -> Array:
    """sin(x)/x, 1 at 0: an even function, and 1e-300 is lost in every |x| that is not next to 0."""
    x = np.abs(x) + 1e-300
    return np.sin(x) / x


def _cos_sin(theta: Array, half: Array) -> tuple[Array, Array]:
    """Cosine and sine of theta + half; what rounding took from the sum is turned in afterwards."""
    heading = theta + half
    rest = theta - heading + half
    c, s = np.cos(heading), np.sin(heading)
    c -= rest * s
    s += rest * c
    return c, s
