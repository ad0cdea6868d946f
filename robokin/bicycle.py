"""Bicycle model of a car: one front wheel in place of the two steered ones.

Reference point: the middle of the rear axle; rear drive, no slip. Positive steering turns left;
wheels in the order left, right. A steering angle stands for the line of its axle, so angles that
are solved for lie in (-π/2, π/2]. Siegwart, Nourbakhsh & Scaramuzza, Introduction to Autonomous
Mobile Robots, chapter 3; Lynch & Park, Modern Robotics, section 13.3.1.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, vector
from robokin._paths import PATH, follow
from robokin._validation import STEPS, data, positive, validated

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


def _rolling(v: Array, phi: Array) -> tuple[Array, Array]:
    """Return v and tan φ; v is NaN at φ = ±π/2, where a driven rear axle cannot roll."""
    slope = np.tan(phi)
    return np.where(np.abs(slope) > STEEPEST, np.nan, v), slope


def _axle_angle(y: Array, x: Array) -> Array:
    """Return the angle in (-π/2, π/2] of the line along (x, y), which has no front and back."""
    sign = np.copysign(1.0, x)
    angle = np.arctan2(sign * y, sign * x)
    return np.where(angle <= -np.pi / 2, np.pi / 2, angle)


@validated(alpha_left=data(), alpha_right=data())
def equivalent_steering(alpha_left: ArrayLike, alpha_right: ArrayLike) -> Array:
    """Return the steering angle of the bicycle that turns like the car: its axle meets theirs.

    alpha_left, alpha_right: (…) in rad → (…) in (-π/2, π/2]. One wheel straight ahead, or both:
    0. Equal and opposite: π/2, the axles meet in the middle of the rear axle.
    All axles meet in one point: cot φ = (cot α_L + cot α_R)/2, multiplied by sin α_L sin α_R.

    >>> round(float(equivalent_steering(np.radians(35), np.radians(29))), 6)
    0.55411
    """
    s_left, s_right = np.sin(alpha_left), np.sin(alpha_right)
    return _axle_angle(2 * s_left * s_right, np.sin(alpha_left + alpha_right))


@validated(phi=data(), wheelbase=positive(), track=positive())
def ackermann(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """Return the two front wheels' steering angles for the bicycle's turn without slip.

    phi: (…) in rad; wheelbase, track (the distance of the front wheels): (…) in m, positive
    → (…, 2) `[left, right]` in (-π/2, π/2]. Where the turn is tighter than half the track, the
    inner wheel has turned past 90°, and its angle comes round with the other sign.
    All axles meet in one point: tan α_L = L/(R − b/2), tan α_R = L/(R + b/2) with the track b.

    >>> np.degrees(ackermann(np.radians(30), wheelbase=2.5, track=1.5)).round(3)
    array([34.927, 26.202])
    """
    forth, across = wheelbase * np.cos(phi), wheelbase * np.sin(phi)
    half = track / 2 * np.sin(phi)
    return vector(_axle_angle(across, forth - half), _axle_angle(across, forth + half))


@validated(phi=data(), wheelbase=positive())
def turning_radius(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return how far to the left of the rear axle's middle the car turns about; right: negative.

    phi: (…) in rad; wheelbase: (…) in m, positive → (…) in m, +inf straight ahead.
    Source: Lynch & Park, section 13.3.1, tan φ = L/R.
    """
    return wheelbase / (np.tan(phi) + 0.0)  # + 0.0 makes a zero positive


@validated(phi=data(), wheelbase=positive())
def corner_cut(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return how far inside the front axle's circle the rear axle runs: the radii's difference.

    phi: (…) in rad; wheelbase: (…) in m, positive → (…) in m; 0 straight ahead, the whole
    wheelbase at phi = ±π/2. By Pythagoras `√(R² + L²) − |R|`, which is `L tan(|φ|/2)`.

    >>> round(float(corner_cut(np.radians(30), wheelbase=7.0)), 3)
    1.876
    """
    return wheelbase * np.abs(np.sin(phi)) / (1 + np.abs(np.cos(phi)))


@validated(phi=data(), wheelbase=positive(), track=positive())
def lane_width(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """Return the width of the lane that the wheels need, inner rear to outer front wheel's circle.

    phi: (…) in rad; wheelbase, track: (…) in m, positive → (…) in m; the track straight ahead.
    Where the turn is tighter than half the track, its centre lies under the car: there is no lane
    but a disc, and this is its radius.
    By Pythagoras `√((|R| + b/2)² + L²) − (|R| − b/2)`, with no difference of large radii.

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

    alpha_left, alpha_right: (…) in rad; wheelbase, track: (…) in m, positive
    → (…) cot α_R − cot α_L − track/wheelbase. Both straight ahead: 0, the axles are parallel and
    meet nowhere. One straight ahead: +inf (the right one) or −inf (the left one).
    The cotangents' difference is sin(α_L − α_R)/(sin α_L sin α_R).
    """
    alpha_left, alpha_right = alpha_left + 0.0, alpha_right + 0.0  # no -0.0: 1/-0.0 is -inf
    difference = np.sin(alpha_left - alpha_right) / np.sin(alpha_left) / np.sin(alpha_right)
    straight = (alpha_left == 0) & (alpha_right == 0)
    return np.where(straight, 0.0, difference - track / wheelbase)


@validated(v=data(), phi=data(), wheelbase=positive())
def body_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return the car's velocity in its own frame, at the middle of the rear axle.

    v: speed of the rear axle (…) in m/s; phi: (…) in rad; wheelbase: (…) in m, positive
    → (…, 3) `[v, 0, omega]`. At phi = ±π/2 a driven rear axle cannot roll: NaN.
    Source: Lynch & Park, section 13.3.1, θ̇ = (v/L) tan φ.

    >>> body_twist(2.0, np.pi / 4, wheelbase=2.5).round(6)
    array([2. , 0. , 0.8])
    """
    v, slope = _rolling(v, phi)
    return vector(v, 0 * v, v * slope / wheelbase)


@validated(v=data(), phi=data(), wheelbase=positive())
def front_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """Return the velocity of the front axle's middle in the body frame: v/cos φ, direction φ.

    v, phi, wheelbase: as in `body_twist` → (…, 3) `[v, v tan φ, omega]`; NaN at phi = ±π/2.
    It is the rear axle's velocity plus omega times the wheelbase, sideways.
    """
    v, slope = _rolling(v, phi)
    return vector(v, v * slope, v * slope / wheelbase)


@validated(v=data(STEPS), phi=data(STEPS), wheelbase=positive(), **PATH)
def path(
    pose: ArrayLike,
    v: ArrayLike,
    phi: ArrayLike,
    wheelbase: ArrayLike,
    dt: ArrayLike,
    method: str = "exact",
) -> Array:
    """Return all poses along a drive of N steps, the first included; methods as in `motion.path`.

    pose: (…, 3) at the start; v, phi, dt: broadcast to (…, N); wheelbase: (…), one for each path
    → (…, N+1, 3). A NaN, or phi = ±π/2, makes the path NaN from its step on.

    >>> path([0, 0, 0], v=1.0, phi=[0.0, np.arctan(2.5)], wheelbase=2.5, dt=np.pi / 2).round(3)
    array([[0.   , 0.   , 0.   ],
           [1.571, 0.   , 0.   ],
           [2.571, 1.   , 1.571]])
    """
    v, slope = _rolling(v, phi)
    turn = v * dt * slope / wheelbase[..., None]
    return follow(pose, v * dt, turn, method)
