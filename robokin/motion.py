"""Planar motion: frames of a moving robot, the exact arc, paths and the centre of rotation.

A pose is `[x, y, theta]`, a twist the robot's velocity in its own frame, `[v_x, v_y, omega]`, both
on the last axis; leading batch dimensions broadcast. Siegwart,
Nourbakhsh & Scaramuzza, Introduction to Autonomous Mobile Robots, chapter 3; Lynch & Park, Modern
Robotics, chapters 3 and 13.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, parts, vector
from robokin._paths import PATH, cos_sin_of_sum, follow, sinc
from robokin._validation import STEPS, data, finite, validated

__all__ = ["arc_step", "icr", "move", "path", "to_body", "to_world", "wrap_angle"]


@validated(angle=data())
def wrap_angle(angle: ArrayLike) -> Array:
    """Return the same direction as an angle in (-π, π].

    angle: (…) in rad → (…). An angle already there is returned unchanged, digit for digit. Of many
    turns the direction is as uncertain as the angle's own rounding, about 1e-16 of it.

    >>> wrap_angle([np.pi, -np.pi, 7.0]).round(6)
    array([3.141593, 3.141593, 0.716815])
    """
    turned = angle - 2 * np.pi * np.rint(angle / (2 * np.pi))
    return np.where(turned <= -np.pi, np.pi, np.minimum(turned, np.pi))


@validated(theta=data(), twist=data(3))
def to_world(theta: ArrayLike, twist: ArrayLike) -> Array:
    """Return the robot's velocity along the world's axes: its twist turned by the heading.

    theta: heading (…) in rad; twist: (…, 3) `[v_x, v_y, omega]` in m/s, m/s, rad/s
    → (…, 3) `[x_dot, y_dot, omega]`, the velocity of the robot's own reference point.
    Source: Siegwart et al., section 3.2.1, ξ̇_R = R(θ) ξ̇_I, solved for ξ̇_I.

    >>> to_world(np.pi / 2, [0.075, 0, 0.5]).round(6)
    array([0.   , 0.075, 0.5  ])
    """
    v_x, v_y, omega = parts(twist)
    c, s = np.cos(theta), np.sin(theta)
    return vector(c * v_x - s * v_y, s * v_x + c * v_y, omega)


@validated(theta=data(), twist=data(3))
def to_body(theta: ArrayLike, twist: ArrayLike) -> Array:
    """Return the robot's twist from its velocity in the world: the inverse of `to_world`.

    theta: heading (…) in rad; twist: here the velocity along the world's axes, (…, 3)
    `[x_dot, y_dot, omega]` in m/s, m/s, rad/s → (…, 3) `[v_x, v_y, omega]`.
    Source: Siegwart et al., section 3.2.1, ξ̇_R = R(θ) ξ̇_I.
    """
    x_dot, y_dot, omega = parts(twist)
    c, s = np.cos(theta), np.sin(theta)
    return vector(c * x_dot + s * y_dot, c * y_dot - s * x_dot, omega)


@validated(pose=data(3), v=data(), omega=data(), dt=finite())
def arc_step(pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike) -> Array:
    """Return the pose after an exact arc: constant speed and turning rate for the time dt.

    pose: (…, 3); v: (…) in m/s; omega: (…) in rad/s; dt: (…) in s, any finite number → (…, 3).
    The chord of the arc, v·dt·sinc(omega·dt/2), is laid along the middle heading; so a straight
    line (omega = 0) needs no case of its own and no digits are lost near it.
    Source: Lynch & Park, section 13.4, x' = x + v/ω (sin(θ + ω dt) − sin θ), rewritten.

    >>> arc_step([0, 0, 0], v=1.0, omega=0.0, dt=2.0)
    array([2., 0., 0.])
    """
    x, y, theta = parts(pose)
    turn = omega * dt
    chord = v * dt * sinc(turn / 2)
    c, s = cos_sin_of_sum(theta, turn / 2)
    return vector(x + chord * c, y + chord * s, theta + turn)


@validated(pose=data(3), twist=data(3), dt=finite())
def move(pose: ArrayLike, twist: ArrayLike, dt: ArrayLike) -> Array:
    """Return the pose after moving for dt with a constant body twist, sideways speed included.

    pose: (…, 3); twist: (…, 3) in the body frame; dt: (…) in s → (…, 3). This is the
    exponential map of SE(2); with v_y = 0 it is `arc_step`.
    Source: Lynch & Park, section 3.3.3, in the plane.
    """
    x, y, theta = parts(pose)
    v_x, v_y, omega = parts(twist)
    turn = omega * dt
    scale = dt * sinc(turn / 2)
    c, s = cos_sin_of_sum(theta, turn / 2)
    return vector(x + scale * (c * v_x - s * v_y), y + scale * (s * v_x + c * v_y), theta + turn)


@validated(v=data(STEPS), omega=data(STEPS), **PATH)
def path(
    pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike, method: str = "exact"
) -> Array:
    """Return all poses along a drive of N steps, the first included.

    pose: (…, 3) at the start; v, omega, dt: broadcast to (…, N) → (…, N+1, 3). Every step goes
    straight in one direction: the exact arc's chord ("exact"), or the step's full length along
    its middle ("midpoint"), its old ("start") or its new heading ("end"). A NaN goes
    into all places from its step on.
    """
    return follow(pose, v * dt, omega * dt, method)


@validated(pose=data(3), v=data(), omega=data())
def icr(pose: ArrayLike, v: ArrayLike, omega: ArrayLike) -> Array:
    """Return the instantaneous centre of rotation (ICR): the point of the plane at rest.

    pose: (…, 3); v: (…) in m/s; omega: (…) in rad/s → (…, 2). It lies v/omega to the left of the
    robot. On a straight line there is none: both coordinates are +inf; standing still every
    point is one: NaN.
    Source: Siegwart et al., section 3.3.1; ICR = [x − R sin θ, y + R cos θ] with R = v/ω.

    >>> icr([0, 0, 0], v=0.075, omega=0.5)
    array([0.  , 0.15])
    """
    x, y, theta = parts(pose)
    radius = v / omega
    straight = np.isinf(radius)
    x_icr, y_icr = x - radius * np.sin(theta), y + radius * np.cos(theta)
    return vector(np.where(straight, np.inf, x_icr), np.where(straight, np.inf, y_icr))
