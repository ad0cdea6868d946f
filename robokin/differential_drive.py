"""Differential drive: two wheels on one axle, each with its own rate.

Wheels in the order left, right. Exercise 4; Siegwart, Nourbakhsh & Scaramuzza, chapter 3.
"""

import numpy as np

from robokin._arrays import vector
from robokin._checks import Array, ArrayLike
from robokin._door import data, door, positive

__all__ = ["body_twist", "turning_radius", "wheel_rates"]


@door(rate_left=data(), rate_right=data(), wheel_radius=positive(), wheel_distance=positive())
def body_twist(
    rate_left: ArrayLike, rate_right: ArrayLike, wheel_radius: ArrayLike, wheel_distance: ArrayLike
) -> Array:
    """The robot's velocity in its own frame from its two wheel rates.

    rate_left, rate_right: (…) in rad/s; wheel_radius, wheel_distance: (…) in m, positive
    → (…, 3) `[v, 0, omega]` in m/s, m/s, rad/s. The wheel distance is the whole distance between
    the wheels. Source: exercise 4, v = (v_R + v_L)/2, ω = (v_R − v_L)/b.

    >>> body_twist(5 / 3, 10 / 3, wheel_radius=0.03, wheel_distance=0.1).round(6)
    array([0.075, 0.   , 0.5  ])
    """
    v = wheel_radius * (rate_right + rate_left) / 2
    omega = wheel_radius * (rate_right - rate_left) / wheel_distance
    return vector(v, 0, omega)


@door(rate_left=data(), rate_right=data(), wheel_distance=positive())
def turning_radius(rate_left: ArrayLike, rate_right: ArrayLike, wheel_distance: ArrayLike) -> Array:
    """How far to the left of the robot the centre of its turn lies; to the right: negative.

    rate_left, rate_right: (…) in rad/s, or the wheels' speeds in m/s; wheel_distance: (…) in m,
    positive → (…) in m, +inf straight ahead, NaN standing still.
    Source: exercise 5, R = b/2 (v_R + v_L)/(v_R − v_L).

    >>> round(float(turning_radius(5 / 3, 10 / 3, wheel_distance=0.1)), 6)
    0.15
    """
    radius = wheel_distance / 2 * ((rate_right + rate_left) / (rate_right - rate_left))
    return np.where(np.isinf(radius), np.inf, radius)


@door(v=data(), omega=data(), wheel_radius=positive(), wheel_distance=positive())
def wheel_rates(
    v: ArrayLike, omega: ArrayLike, wheel_radius: ArrayLike, wheel_distance: ArrayLike
) -> Array:
    """The two wheel rates that give a wanted speed and turning rate: the inverse of `body_twist`.

    v: (…) in m/s; omega: (…) in rad/s; wheel_radius, wheel_distance: (…) in m, positive
    → (…, 2) `[left, right]` in rad/s. Source: exercise 7 (seed 003), ω_R = (v + ωb/2)/r.

    >>> wheel_rates(0.075, 0.5, wheel_radius=0.03, wheel_distance=0.1).round(6)
    array([1.666667, 3.333333])
    """
    left = (v - omega * wheel_distance / 2) / wheel_radius
    right = (v + omega * wheel_distance / 2) / wheel_radius
    return vector(left, right)
