"""Differential drive: two wheels on one axle, each with its own rate.

The wheel distance is the whole distance between the wheels. The instantaneous centre of rotation is
`motion.icr`, the pose after a time step `motion.arc_step`. Siegwart, Nourbakhsh & Scaramuzza,
Introduction to Autonomous Mobile Robots, chapter 3; Lynch & Park, Modern Robotics, section 13.3.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, vector
from robokin._validation import data, positive, validated

__all__ = ["body_twist", "turning_radius", "wheel_rates"]

SIZES = {"wheel_radius": positive(), "wheel_distance": positive()}


@validated(rate_left=data(), rate_right=data(), **SIZES)
def body_twist(
    rate_left: ArrayLike, rate_right: ArrayLike, wheel_radius: ArrayLike, wheel_distance: ArrayLike
) -> Array:
    """Return the robot's twist from its two wheel rates.

    Parameters
    ----------
    rate_left, rate_right : array_like, shape (...)
        Wheel rates in rad/s.
    wheel_radius, wheel_distance : array_like, shape (...)
        Sizes in m.

    Returns
    -------
    ndarray, shape (..., 3)
        `[v, 0, omega]` in m/s and rad/s.

    References
    ----------
    Siegwart et al., section 3.2.2, v = (v_R + v_L)/2, ω = (v_R − v_L)/b.

    Examples
    --------
    >>> body_twist(5 / 3, 10 / 3, wheel_radius=0.03, wheel_distance=0.1).round(6)
    array([0.075, 0.   , 0.5  ])
    """
    v = wheel_radius * (rate_right + rate_left) / 2
    omega = wheel_radius * (rate_right - rate_left) / wheel_distance
    return vector(v, 0, omega)


@validated(rate_left=data(), rate_right=data(), wheel_distance=positive())
def turning_radius(rate_left: ArrayLike, rate_right: ArrayLike, wheel_distance: ArrayLike) -> Array:
    """Return how far to the left of the robot the centre of its turn lies.

    By R = v/ω it is b/2 (v_R + v_L)/(v_R − v_L).

    Parameters
    ----------
    rate_left, rate_right : array_like, shape (...)
        Wheel rates in rad/s, or the wheels' speeds in m/s.
    wheel_distance : array_like, shape (...)
        Distance between the wheels in m.

    Returns
    -------
    ndarray, shape (...)
        Radius in m, negative to the right; +inf straight ahead, NaN standing still.

    Examples
    --------
    >>> round(float(turning_radius(5 / 3, 10 / 3, wheel_distance=0.1)), 6)
    0.15
    """
    radius = wheel_distance / 2 * ((rate_right + rate_left) / (rate_right - rate_left))
    return np.where(np.isinf(radius), np.inf, radius)


@validated(v=data(), omega=data(), **SIZES)
def wheel_rates(
    v: ArrayLike, omega: ArrayLike, wheel_radius: ArrayLike, wheel_distance: ArrayLike
) -> Array:
    """Return the two wheel rates for a wanted speed and turning rate: the inverse of `body_twist`.

    Parameters
    ----------
    v : array_like, shape (...)
        Speed in m/s.
    omega : array_like, shape (...)
        Turning rate in rad/s.
    wheel_radius, wheel_distance : array_like, shape (...)
        Sizes in m.

    Returns
    -------
    ndarray, shape (..., 2)
        `[left, right]` in rad/s.

    References
    ----------
    Lynch & Park, section 13.3.1, ω_R = (v + ωb/2)/r.

    Examples
    --------
    >>> wheel_rates(0.075, 0.5, wheel_radius=0.03, wheel_distance=0.1).round(6)
    array([1.666667, 3.333333])
    """
    left = (v - omega * wheel_distance / 2) / wheel_radius
    right = (v + omega * wheel_distance / 2) / wheel_radius
    return vector(left, right)
