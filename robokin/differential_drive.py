"""Differential drive: two wheels on one axle, each with its own rate.

Wheels in the order left, right. Exercise 4; Siegwart, Nourbakhsh & Scaramuzza, chapter 3.
"""

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, positive, quiet, rows

__all__ = ["body_twist", "wheel_rates"]


@quiet
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
    radius = positive("wheel_radius", wheel_radius)
    distance = positive("wheel_distance", wheel_distance)
    shape, (left, right) = rows(
        ("rate_left", rate_left, ()),
        ("rate_right", rate_right, ()),
        parameters=(radius, distance),
    )
    out = np.empty((*shape, 3))
    out[..., 0] = 0.5 * radius * (right + left)
    out[..., 1] = left - left  # 0, or NaN in a NaN row
    out[..., 2] = radius / distance * (right - left)
    return out


@quiet
def wheel_rates(
    v: ArrayLike, omega: ArrayLike, wheel_radius: ArrayLike, wheel_distance: ArrayLike
) -> Array:
    """The two wheel rates that give a wanted speed and turning rate: the inverse of `body_twist`.

    v: (…) in m/s; omega: (…) in rad/s; wheel_radius, wheel_distance: (…) in m, positive
    → (…, 2) `[left, right]` in rad/s. Source: exercise 7 (seed 003), ω_R = (v + ωb/2)/r.

    >>> wheel_rates(0.075, 0.5, wheel_radius=0.03, wheel_distance=0.1).round(6)
    array([1.666667, 3.333333])
    """
    radius = positive("wheel_radius", wheel_radius)
    distance = positive("wheel_distance", wheel_distance)
    shape, (v, omega) = rows(("v", v, ()), ("omega", omega, ()), parameters=(radius, distance))
    half = 0.5 * distance * omega
    out = np.empty((*shape, 2))
    out[..., 0] = (v - half) / radius
    out[..., 1] = (v + half) / radius
    return out
