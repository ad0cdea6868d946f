"""Planar motion: frames of a moving robot, the exact arc, paths and the centre of rotation.

A pose is `[x, y, theta]`, a twist the robot's velocity in its own frame, `[v_x, v_y, omega]`.
Headings that add up along a path are not wrapped.

Siegwart, Nourbakhsh & Scaramuzza, Introduction to Autonomous Mobile Robots, chapter 3; Lynch &
Park, Modern Robotics, chapters 3 and 13.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, parts, vector
from robokin._paths import PATH, cos_sin_of_sum, follow, sinc
from robokin._validation import data, finite, validated

__all__ = ["arc_step", "icr", "move", "path", "to_body", "to_world", "wrap_angle"]


@validated(angle=data())
def wrap_angle(angle: ArrayLike) -> Array:
    """Wrap an angle to (-π, π].

    An angle already there is returned unchanged, digit for digit. After many turns the direction is
    as uncertain as the rounding of the angle itself, about 1e-16 of it.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in rad.

    Returns
    -------
    ndarray, shape (...)
        The same direction in rad.

    Examples
    --------
    >>> wrap_angle([np.pi, -np.pi, 7.0]).round(6)
    array([3.141593, 3.141593, 0.716815])
    """
    turned = angle - 2 * np.pi * np.rint(angle / (2 * np.pi))
    return np.where(turned <= -np.pi, np.pi, np.minimum(turned, np.pi))


@validated(theta=data(), twist=data(3))
def to_world(theta: ArrayLike, twist: ArrayLike) -> Array:
    """Turn a twist by the heading: the robot's velocity along the world's axes.

    Parameters
    ----------
    theta : array_like, shape (...)
        Heading in rad.
    twist : array_like, shape (..., 3)
        `[v_x, v_y, omega]` in m/s and rad/s.

    Returns
    -------
    ndarray, shape (..., 3)
        `[x_dot, y_dot, omega]` in m/s and rad/s, the velocity of the robot's own reference point.

    References
    ----------
    Siegwart et al., section 3.2.1, ξ̇_R = R(θ) ξ̇_I, solved for ξ̇_I.

    Examples
    --------
    >>> to_world(np.pi / 2, [0.075, 0, 0.5]).round(6)
    array([0.   , 0.075, 0.5  ])
    """
    v_x, v_y, omega = parts(twist)
    c, s = np.cos(theta), np.sin(theta)
    return vector(c * v_x - s * v_y, s * v_x + c * v_y, omega)


@validated(theta=data(), twist=data(3))
def to_body(theta: ArrayLike, twist: ArrayLike) -> Array:
    """Turn a velocity along the world's axes into the robot's twist: the inverse of `to_world`.

    Parameters
    ----------
    theta : array_like, shape (...)
        Heading in rad.
    twist : array_like, shape (..., 3)
        `[x_dot, y_dot, omega]` along the world's axes, in m/s and rad/s.

    Returns
    -------
    ndarray, shape (..., 3)
        `[v_x, v_y, omega]` in m/s and rad/s.

    References
    ----------
    Siegwart et al., section 3.2.1, ξ̇_R = R(θ) ξ̇_I.
    """
    x_dot, y_dot, omega = parts(twist)
    c, s = np.cos(theta), np.sin(theta)
    return vector(c * x_dot + s * y_dot, c * y_dot - s * x_dot, omega)


@validated(pose=data(3), v=data(), omega=data(), dt=finite())
def arc_step(pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike) -> Array:
    """Return the pose after an exact arc: constant speed and turning rate for the time dt.

    The chord of the arc, v·dt·sinc(omega·dt/2), is laid along the middle heading, so a straight
    line (omega = 0) is no special case and no digits are lost near it.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, theta]` in m and rad.
    v : array_like, shape (...)
        Speed in m/s.
    omega : array_like, shape (...)
        Turning rate in rad/s.
    dt : array_like, shape (...)
        Time in s; a negative one drives backwards.

    Returns
    -------
    ndarray, shape (..., 3)
        `[x, y, theta]` in m and rad.

    References
    ----------
    Lynch & Park, section 13.4, x' = x + v/ω (sin(θ + ω dt) − sin θ), rewritten.

    Examples
    --------
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
    """Return the pose after moving with a constant twist for the time dt.

    This is the exponential map of SE(2); with v_y = 0 it is `arc_step`.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, theta]` in m and rad.
    twist : array_like, shape (..., 3)
        `[v_x, v_y, omega]` in m/s and rad/s.
    dt : array_like, shape (...)
        Time in s; a negative one drives backwards.

    Returns
    -------
    ndarray, shape (..., 3)
        `[x, y, theta]` in m and rad.

    References
    ----------
    Lynch & Park, section 3.3.3, in the plane.
    """
    x, y, theta = parts(pose)
    v_x, v_y, omega = parts(twist)
    turn = omega * dt
    scale = dt * sinc(turn / 2)
    c, s = cos_sin_of_sum(theta, turn / 2)
    return vector(x + scale * (c * v_x - s * v_y), y + scale * (s * v_x + c * v_y), theta + turn)


@validated(v=data(), omega=data(), **PATH)
def path(
    pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike, method: str = "exact"
) -> Array:
    """Return all poses along a drive of N steps, the first included.

    A NaN goes into all places from its step on.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, theta]` at the start, in m and rad.
    v, omega, dt : array_like, shape (..., N)
        Speed in m/s, turning rate in rad/s and time in s of each step, or one for all steps. A
        negative time drives the step backwards.
    method : {"exact", "midpoint", "start", "end"}, default "exact"
        How each step goes straight: along the exact arc's chord, or for the step's full length
        along its middle, old or new heading.

    Returns
    -------
    ndarray, shape (..., N+1, 3)
        `[x, y, theta]` in m and rad.
    """
    return follow(pose, v * dt, omega * dt, method)


@validated(pose=data(3), v=data(), omega=data())
def icr(pose: ArrayLike, v: ArrayLike, omega: ArrayLike) -> Array:
    """Return the instantaneous centre of rotation (ICR): the point of the plane at rest.

    It lies v/omega to the left of the robot.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, theta]` in m and rad.
    v : array_like, shape (...)
        Speed in m/s.
    omega : array_like, shape (...)
        Turning rate in rad/s.

    Returns
    -------
    ndarray, shape (..., 2)
        `[x, y]` in m: +inf on a straight line, which has no ICR; NaN standing still, where every
        point is one.

    References
    ----------
    Siegwart et al., section 3.3.1, ICR = [x − R sin θ, y + R cos θ] with R = v/ω.

    Examples
    --------
    >>> icr([0, 0, 0], v=0.075, omega=0.5)
    array([0.  , 0.15])
    """
    x, y, theta = parts(pose)
    radius = v / omega
    straight = np.isinf(radius)
    x_icr, y_icr = x - radius * np.sin(theta), y + radius * np.cos(theta)
    return vector(np.where(straight, np.inf, x_icr), np.where(straight, np.inf, y_icr))
