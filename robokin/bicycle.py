"""Bicycle model of a car: one front wheel in place of the two steered ones.

Reference point: the middle of the rear axle; rear drive, no slip. Positive steering turns left;
wheels in the order left, right. A steering angle stands for the line of its axle, so angles that
are solved for lie in (-π/2, π/2]. Exercise 5; Siegwart, Nourbakhsh & Scaramuzza, chapter 3.
"""

import numpy as np

from robokin._arrays import vector
from robokin._checks import Array, ArrayLike, Bools, every
from robokin._door import data, door, finite, one_of, positive, steps
from robokin._paths import METHODS, follow

__all__ = [
    "ackermann",
    "ackermann_error",
    "body_twist",
    "corner_cut",
    "equivalent_steering",
    "front_twist",
    "lane_width",
    "path",
    "turning_radius",
]

STEEPEST = 1 / np.finfo(float).eps  # tangents above: within 2.2e-16 rad of a steering of ±π/2


def _can_roll(phi: Array) -> Bools:
    """Where a driven rear axle can roll: not at phi = ±π/2, the front wheel across."""
    ahead = np.abs(phi) < 1.5  # most angles: they need no tangent here
    return ahead if every(ahead) else ahead | (np.abs(np.tan(phi)) <= STEEPEST)


def _axle_angle(y: Array, x: Array) -> Array:
    """The angle in (-π/2, π/2] of the line along (x, y); a line has no front and no back."""
    sign = np.copysign(1.0, x)
    angle = np.arctan2(sign * y, sign * x)
    return np.where(angle <= -np.pi / 2, np.pi / 2, angle)


@door(alpha_left=data(), alpha_right=data())
def equivalent_steering(alpha_left: ArrayLike, alpha_right: ArrayLike) -> Array:
    """The steering angle of the bicycle that turns like the car: its axle meets theirs.

    alpha_left, alpha_right: (…) in rad → (…) in (-π/2, π/2]. One wheel straight ahead, or both:
    0. Equal and opposite: π/2, the axles meet in the middle of the rear axle.
    Source: exercise 5, tan φ = 2/(cot α_L + cot α_R), multiplied by sin α_L sin α_R.

    >>> round(float(equivalent_steering(np.radians(35), np.radians(29))), 6)
    0.55411
    """
    s_left, s_right = np.sin(alpha_left), np.sin(alpha_right)
    return _axle_angle(2 * s_left * s_right, np.sin(alpha_left + alpha_right))


@door(phi=data(), wheelbase=positive(), track=positive())
def ackermann(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """The two front wheels' steering angles that meet the bicycle's turn without slip.

    phi: (…) in rad; wheelbase, track (the distance of the front wheels): (…) in m, positive
    → (…, 2) `[left, right]` in (-π/2, π/2]. Where the turn is tighter than half the track, the
    inner wheel has turned past 90°, and its angle comes round with the other sign.
    Source: exercise 5, tan α_L = L/(R − b/2), tan α_R = L/(R + b/2) with the track b.

    >>> np.degrees(ackermann(np.radians(30), wheelbase=2.5, track=1.5)).round(3)
    array([34.927, 26.202])
    """
    forth, across = wheelbase * np.cos(phi), wheelbase * np.sin(phi)
    half = track / 2 * np.sin(phi)
    return vector(_axle_angle(across, forth - half), _axle_angle(across, forth + half))


@door(phi=data(), wheelbase=positive())
def turning_radius(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """How far to the left of the rear axle's middle the car turns about; to the right: negative.

    phi: (…) in rad; wheelbase: (…) in m, positive → (…) in m, +inf straight ahead.
    Source: exercise 5, tan φ = L/R.
    """
    return wheelbase / (np.tan(phi) + 0.0)  # + 0.0 makes a zero positive


@door(phi=data(), wheelbase=positive())
def corner_cut(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """How far inside the front axle's circle the rear axle runs: the difference of their radii.

    phi: (…) in rad; wheelbase: (…) in m, positive → (…) in m; 0 straight ahead, the whole
    wheelbase at phi = ±π/2. Source: exercise 5, `√(R² + L²) − |R|`, which is `L tan(|φ|/2)`.

    >>> round(float(corner_cut(np.radians(30), wheelbase=7.0)), 3)
    1.876
    """
    cut: Array = wheelbase * np.abs(np.sin(phi)) / (1 + np.abs(np.cos(phi)))
    return cut


@door(phi=data(), wheelbase=positive(), track=positive())
def lane_width(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """How wide a lane the wheels need: from the inner rear wheel's circle to the outer front one's.

    phi: (…) in rad; wheelbase, track: (…) in m, positive → (…) in m; the track straight ahead.
    Where the turn is tighter than half the track, its centre lies under the car: there is no lane
    but a disc, and this is its radius.
    Source: exercise 5, `√((|R| + b/2)² + L²) − (|R| − b/2)`, with no difference of large radii.

    >>> round(float(lane_width(np.radians(30), wheelbase=7.0, track=1.5)), 2)
    3.28
    """
    outer = np.abs(wheelbase / np.tan(phi)) + track / 2
    reach = np.hypot(outer, wheelbase)
    width: Array = np.minimum(outer, track) + wheelbase * (wheelbase / (reach + outer))
    return width


@door(alpha_left=data(), alpha_right=data(), wheelbase=positive(), track=positive())
def ackermann_error(
    alpha_left: ArrayLike, alpha_right: ArrayLike, wheelbase: ArrayLike, track: ArrayLike
) -> Array:
    """How far two steering angles are from a turn without slip: 0 where the three axles meet.

    alpha_left, alpha_right: (…) in rad; wheelbase, track: (…) in m, positive
    → (…) cot α_R − cot α_L − track/wheelbase. Both straight ahead: 0, the axles are parallel and
    meet nowhere. One straight ahead: +inf (the right one) or −inf (the left one).
    Source: exercise 5; the cotangents' difference is sin(α_L − α_R)/(sin α_L sin α_R).
    """
    alpha_left, alpha_right = alpha_left + 0.0, alpha_right + 0.0  # no -0.0: 1/-0.0 is -inf
    difference = np.sin(alpha_left - alpha_right) / np.sin(alpha_left) / np.sin(alpha_right)
    straight = (alpha_left == 0) & (alpha_right == 0)
    return np.where(straight, 0.0, difference - track / wheelbase)


@door(v=data(), phi=data(good=_can_roll), wheelbase=positive())
def body_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """The car's velocity in its own frame, at the middle of the rear axle.

    v: speed of the rear axle (…) in m/s; phi: (…) in rad; wheelbase: (…) in m, positive
    → (…, 3) `[v, 0, omega]`. At phi = ±π/2 a driven rear axle cannot roll: NaN.
    Source: exercise 5, θ̇ = (v/L) tan φ.

    >>> body_twist(2.0, np.pi / 4, wheelbase=2.5).round(6)
    array([2. , 0. , 0.8])
    """
    return vector(v, 0, v * np.tan(phi) / wheelbase)


@door(v=data(), phi=data(good=_can_roll), wheelbase=positive())
def front_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """The velocity of the front axle's middle in the body frame: v/cos φ in the direction φ.

    v, phi, wheelbase: as in `body_twist` → (…, 3) `[v, v tan φ, omega]`; NaN at phi = ±π/2.
    Source: exercise 5; the rear axle's velocity plus omega times the wheelbase, sideways.
    """
    v_y = v * np.tan(phi)
    return vector(v, v_y, v_y / wheelbase)


@door(
    pose=data(3),
    v=data(steps),
    phi=data(steps, good=_can_roll),
    wheelbase=positive(),
    dt=finite(steps),
    method=one_of(*METHODS),
)
def path(
    pose: ArrayLike,
    v: ArrayLike,
    phi: ArrayLike,
    wheelbase: ArrayLike,
    dt: ArrayLike,
    method: str = "exact",
) -> Array:
    """All poses along a drive of N steps, the first included; step rules as in `motion.path`.

    pose: (…, 3) at the start; v, phi, dt: broadcast to (…, N); wheelbase: (…), one for each path
    → (…, N+1, 3). A NaN, or phi = ±π/2, makes the path NaN from its step on.

    >>> path([0, 0, 0], v=1.0, phi=[0.0, np.arctan(2.5)], wheelbase=2.5, dt=np.pi / 2).round(3)
    array([[0.   , 0.   , 0.   ],
           [1.571, 0.   , 0.   ],
           [2.571, 1.   , 1.571]])
    """
    length = v * dt
    return follow(pose, length, length * np.tan(phi) / wheelbase, method)
