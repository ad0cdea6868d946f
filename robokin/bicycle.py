"""Bicycle model of a car: one front wheel in place of the two steered ones.

Reference point: the middle of the rear axle; rear drive, no slip. Positive steering turns left. A
steering angle means the line of its axle, so angles that are solved for lie in (-π/2, π/2].
The wheelbase L is the distance of the axles, the track b that of the front wheels. Siegwart,
Nourbakhsh & Scaramuzza, Introduction to Autonomous Mobile Robots, chapter 3; Lynch & Park, Modern
Robotics, section 13.3.1.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, vector
from robokin._paths import PATH, follow
from robokin._validation import data, positive, validated

__all__ = [
    "ackermann",
    "ackermann_error",
    "body_twist",
    "corner_cut",
    "equivalent_steering",
    "front_twist",
    "lane_width",
    "path",
    "steering",
    "turning_radius",
]

STEEPEST = 1 / np.finfo(float).eps  # tangents above: within 2.2e-16 rad of a steering of ±π/2


def _rolling(v: Array, phi: Array) -> tuple[Array, Array]:
    """Return v and tan φ; v is NaN at φ = ±π/2, where a driven rear axle cannot roll."""
    slope = np.tan(phi)
    return np.where(np.abs(slope) > STEEPEST, np.nan, v), slope


def _axle_angle(y: Array, x: Array) -> Array:
    """Return the angle in (-π/2, π/2] of the line along (x, y), which has no front and back."""
    angle = np.arctan(y / x)
    return np.where(angle <= -np.pi / 2, np.pi / 2, angle)


@validated(alpha_left=data(), alpha_right=data())
def equivalent_steering(alpha_left: ArrayLike, alpha_right: ArrayLike) -> Array:
    """Return the steering angle of the bicycle that turns like the car.

    All axles meet in one point: cot φ = (cot α_L + cot α_R)/2, multiplied by tan α_L tan α_R.

    Parameters
    ----------
    alpha_left, alpha_right : array_like, shape (...)
        Steering angles of the front wheels in rad.

    Returns
    -------
    ndarray, shape (...)
        Steering angle in (-π/2, π/2] rad. It is 0 if one wheel, or both, are straight ahead, and
        π/2 if they are equal and opposite: their axles meet in the middle of the rear axle.

    Examples
    --------
    >>> round(float(equivalent_steering(np.radians(35), np.radians(29))), 6)
    0.55411
    """
    left, right = np.tan(alpha_left), np.tan(alpha_right)
    both, product = left + right, left * right
    by_sum = np.tan(alpha_left + alpha_right) * (1 - product)  # keeps the digits that both loses
    both = np.where(both * both < -product, by_sum, both)
    return _axle_angle(2 * product, np.where(left == 0, 1.0, both)) + 0.0  # no -0.0


@validated(phi=data(), wheelbase=positive(), track=positive())
def ackermann(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """Return the two front wheels' steering angles for the bicycle's turn without slip.

    All axles meet in one point: tan α_L = L/(R − b/2), tan α_R = L/(R + b/2).

    Parameters
    ----------
    phi : array_like, shape (...)
        Steering angle in rad.
    wheelbase, track : array_like, shape (...)
        Sizes in m.

    Returns
    -------
    ndarray, shape (..., 2)
        `[left, right]` in (-π/2, π/2] rad. Where the turn is tighter than half the track, the inner
        wheel has turned past 90°, and its angle comes round with the other sign.

    Examples
    --------
    >>> np.degrees(ackermann(np.radians(30), wheelbase=2.5, track=1.5)).round(3)
    array([34.927, 26.202])
    """
    across, half = wheelbase * np.tan(phi), track / 2 * np.tan(phi)
    return vector(_axle_angle(across, wheelbase - half), _axle_angle(across, wheelbase + half))


@validated(phi=data(), wheelbase=positive())
def turning_radius(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return how far to the left of the rear axle's middle the centre of the turn lies.

    Parameters
    ----------
    phi : array_like, shape (...)
        Steering angle in rad.
    wheelbase : array_like, shape (...)
        Distance of the axles in m.

    Returns
    -------
    ndarray, shape (...)
        Radius in m, negative to the right; +inf straight ahead.

    References
    ----------
    Lynch & Park, section 13.3.1, tan φ = L/R.
    """
    return wheelbase / (np.tan(phi) + 0.0)  # + 0.0 makes a zero positive


@validated(phi=data(), wheelbase=positive())
def corner_cut(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return how far inside the front axle's circle the rear axle runs: the radii's difference.

    By Pythagoras it is `√(R² + L²) − |R|`, which is `L tan(|φ|/2)`.

    Parameters
    ----------
    phi : array_like, shape (...)
        Steering angle in rad.
    wheelbase : array_like, shape (...)
        Distance of the axles in m.

    Returns
    -------
    ndarray, shape (...)
        Difference in m: 0 straight ahead, the whole wheelbase at phi = ±π/2.

    Examples
    --------
    >>> round(float(corner_cut(np.radians(30), wheelbase=7.0)), 3)
    1.876
    """
    slope = np.abs(np.tan(phi))
    return wheelbase * slope / (1 + np.sqrt(1 + slope * slope))


@validated(phi=data(), wheelbase=positive(), track=positive())
def lane_width(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """Return the width of the lane that the wheels need, inner rear to outer front wheel's circle.

    By Pythagoras it is `√((|R| + b/2)² + L²) − (|R| − b/2)`, here with no difference of large
    radii. Where the turn is tighter than half the track, its centre lies under the car: there is no
    lane but a disc, and this is its radius.

    Parameters
    ----------
    phi : array_like, shape (...)
        Steering angle in rad.
    wheelbase, track : array_like, shape (...)
        Sizes in m.

    Returns
    -------
    ndarray, shape (...)
        Width in m; straight ahead the track.

    Examples
    --------
    >>> round(float(lane_width(np.radians(30), wheelbase=7.0, track=1.5)), 2)
    3.28
    """
    outer = np.abs(wheelbase / np.tan(phi)) + track / 2
    reach = np.hypot(outer, wheelbase)
    return np.minimum(outer, track) + wheelbase * (wheelbase / (reach + outer))


@validated(alpha_left=data(), alpha_right=data(), wheelbase=positive(), track=positive())
def ackermann_error(
    alpha_left: ArrayLike, alpha_right: ArrayLike, wheelbase: ArrayLike, track: ArrayLike
) -> Array:
    """Return how far two steering angles are from a turn without slip: 0 where the axles meet.

    It is cot α_R − cot α_L − b/L; the cotangents' difference is sin(α_L − α_R)/(sin α_L sin α_R),
    which keeps its digits near straight ahead.

    Parameters
    ----------
    alpha_left, alpha_right : array_like, shape (...)
        Steering angles of the front wheels in rad.
    wheelbase, track : array_like, shape (...)
        Sizes in m.

    Returns
    -------
    ndarray, shape (...)
        Error, without unit: 0 if both are straight ahead (parallel axles meet nowhere), +inf if
        only the right one is, −inf if only the left one is.
    """
    left, right = alpha_left + 0.0, alpha_right + 0.0  # no -0.0: 1/-0.0 is -inf
    difference = np.sin(left - right) / np.sin(left) / np.sin(right)
    return np.where((left == 0) & (right == 0), 0.0, difference - track / wheelbase)


@validated(v=data(), phi=data(), wheelbase=positive())
def body_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return the car's twist at the middle of the rear axle.

    Parameters
    ----------
    v : array_like, shape (...)
        Speed of the rear axle in m/s; v_F cos φ for a driven front wheel of speed v_F.
    phi : array_like, shape (...)
        Steering angle in rad.
    wheelbase : array_like, shape (...)
        Distance of the axles in m.

    Returns
    -------
    ndarray, shape (..., 3)
        `[v, 0, omega]` in m/s and rad/s; NaN at phi = ±π/2, where a driven rear axle cannot roll.

    References
    ----------
    Lynch & Park, section 13.3.1, θ̇ = (v/L) tan φ.

    Examples
    --------
    >>> body_twist(2.0, np.pi / 4, wheelbase=2.5).round(6)
    array([2. , 0. , 0.8])
    """
    v, slope = _rolling(v, phi)
    return vector(v, 0 * v, v * slope / wheelbase)


@validated(v=data(), omega=data(), wheelbase=positive())
def steering(v: ArrayLike, omega: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return the steering angle of a drive: the inverse of `body_twist`.

    Parameters
    ----------
    v : array_like, shape (...)
        Speed of the rear axle in m/s.
    omega : array_like, shape (...)
        Turning rate in rad/s.
    wheelbase : array_like, shape (...)
        Distance of the axles in m.

    Returns
    -------
    ndarray, shape (...)
        Steering angle in [-π/2, π/2] rad: 0 at rest, NaN for a turn on the spot, which the rear
        axle cannot make.

    References
    ----------
    Lynch & Park, section 13.3.1, θ̇ = (v/L) tan φ, solved for φ.

    Examples
    --------
    >>> round(float(steering(2.0, 0.8, wheelbase=2.5)), 6)
    0.785398
    """
    angle = np.arctan(wheelbase * omega / v) + 0.0
    return np.where(v == 0, np.where(omega == 0, 0.0, np.nan), angle)


@validated(v=data(), phi=data(), wheelbase=positive())
def front_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return the twist at the middle of the front axle: v/cos φ in the direction φ.

    It is the rear axle's velocity plus omega times the wheelbase, sideways.

    Parameters
    ----------
    v : array_like, shape (...)
        Speed of the rear axle in m/s.
    phi : array_like, shape (...)
        Steering angle in rad.
    wheelbase : array_like, shape (...)
        Distance of the axles in m.

    Returns
    -------
    ndarray, shape (..., 3)
        `[v, v tan φ, omega]` in m/s and rad/s; NaN at phi = ±π/2.
    """
    v, slope = _rolling(v, phi)
    return vector(v, v * slope, v * slope / wheelbase)


@validated(v=data(), phi=data(), wheelbase=positive(), **PATH)
def path(
    pose: ArrayLike,
    v: ArrayLike,
    phi: ArrayLike,
    wheelbase: ArrayLike,
    dt: ArrayLike,
    method: str = "exact",
) -> Array:
    """Return all poses along a drive of N steps, the first included.

    A NaN, or phi = ±π/2, makes the path NaN from its step on.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, theta]` at the start, in m and rad.
    v, phi : array_like, shape (..., N)
        Speed in m/s and steering angle in rad of each step, or one for all steps.
    wheelbase : array_like, shape (...)
        Distance of the axles in m, one for each path.
    dt : array_like, shape (..., N)
        Time of each step in s, or one for all steps. A negative time drives the step backwards.
    method : {"exact", "midpoint", "start", "end"}, default "exact"
        As in `motion.path`.

    Returns
    -------
    ndarray, shape (..., N+1, 3)
        `[x, y, theta]` in m and rad.

    Examples
    --------
    >>> path([0, 0, 0], v=1.0, phi=[0.0, np.arctan(2.5)], wheelbase=2.5, dt=np.pi / 2).round(3)
    array([[0.   , 0.   , 0.   ],
           [1.571, 0.   , 0.   ],
           [2.571, 1.   , 1.571]])
    """
    v, slope = _rolling(v, phi)
    turn = v * dt * slope / wheelbase[..., None]
    return follow(pose, v * dt, turn, method)
