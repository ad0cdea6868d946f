"""Bicycle model of a car: one front wheel in place of the two steered ones.

Reference point: the middle of the rear axle; rear drive, no slip. Positive steering turns left;
wheels in the order left, right. A steering angle stands for the line of its axle, so angles that
are solved for lie in (-π/2, π/2]. Exercise 5; Siegwart, Nourbakhsh & Scaramuzza, chapter 3.
"""

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, finite, numbers, positive, quiet, rows
from robokin.motion import _follow

__all__ = [
    "ackermann",
    "ackermann_error",
    "body_twist",
    "equivalent_steering",
    "front_twist",
    "path",
    "turning_radius",
]

STEEPEST = 1 / np.finfo(float).eps  # tangents above: within 2.2e-16 rad of a steering of ±π/2


@quiet
def equivalent_steering(alpha_left: ArrayLike, alpha_right: ArrayLike) -> Array:
    """The steering angle of the bicycle that turns like the car: its axle meets theirs.

    alpha_left, alpha_right: (…) in rad → (…) in (-π/2, π/2]. One wheel straight ahead, or both:
    0. Equal and opposite: π/2, the axles meet in the middle of the rear axle.
    Source: exercise 5, tan φ = 2/(cot α_L + cot α_R), multiplied by sin α_L sin α_R.

    >>> round(float(equivalent_steering(np.radians(35), np.radians(29))), 6)
    0.55411
    """
    _, (left, right) = rows(("alpha_left", alpha_left, ()), ("alpha_right", alpha_right, ()))
    return _axle_angle(2 * np.sin(left) * np.sin(right), np.sin(left + right))[()]


@quiet
def ackermann(phi: ArrayLike, wheelbase: ArrayLike, track: ArrayLike) -> Array:
    """The two front wheels' steering angles that meet the bicycle's turn without slip.

    phi: (…) in rad; wheelbase, track (the distance of the front wheels): (…) in m, positive
    → (…, 2) `[left, right]` in (-π/2, π/2]. Where the turn is tighter than half the track, the
    inner wheel has turned past 90°, and its angle comes round with the other sign.
    Source: exercise 5, tan α_L = L/(R − l/2), tan α_R = L/(R + l/2), multiplied by tan φ = L/R.

    >>> np.degrees(ackermann(np.radians(30), wheelbase=2.5, track=1.5)).round(3)
    array([34.927, 26.202])
    """
    base, half = positive("wheelbase", wheelbase), 0.5 * positive("track", track)
    shape, (phi,) = rows(("phi", phi, ()), parameters=(base, half))
    ahead, across = base * np.cos(phi), np.sin(phi)
    out = np.empty((*shape, 2))
    out[..., 0] = _axle_angle(base * across, ahead - half * across)
    out[..., 1] = _axle_angle(base * across, ahead + half * across)
    return out


@quiet
def turning_radius(phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """How far to the left of the rear axle's middle the car turns about; to the right: negative.

    phi: (…) in rad; wheelbase: (…) in m, positive → (…) in m, +inf straight ahead.
    Source: exercise 5, tan φ = L/R.
    """
    base = positive("wheelbase", wheelbase)
    _, (phi,) = rows(("phi", phi, ()), parameters=(base,))
    return base / (np.tan(phi) + 0.0)  # + 0.0 makes a zero positive


@quiet
def ackermann_error(
    alpha_left: ArrayLike, alpha_right: ArrayLike, wheelbase: ArrayLike, track: ArrayLike
) -> Array:
    """How far two steering angles are from a turn without slip: 0 where the three axles meet.

    alpha_left, alpha_right: (…) in rad; wheelbase, track: (…) in m, positive
    → (…) cot α_R − cot α_L − track/wheelbase. Both straight ahead: 0, the axles are parallel and
    meet nowhere. One straight ahead: +inf (the right one) or −inf (the left one).
    Source: exercise 5; the cotangents' difference is sin(α_L − α_R)/(sin α_L sin α_R).
    """
    base, track = positive("wheelbase", wheelbase), positive("track", track)
    shape, (left, right) = rows(
        ("alpha_left", alpha_left, ()), ("alpha_right", alpha_right, ()), parameters=(base, track)
    )
    difference = np.sin(left - right) / np.sin(left) / np.sin(right)
    out = np.empty(shape)
    out[...] = difference - track / base
    out[np.broadcast_to((left == 0) & (right == 0), shape)] = 0.0
    return out[()]


@quiet
def body_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """The car's velocity in its own frame, at the middle of the rear axle.

    v: speed of the rear axle (…) in m/s; phi: (…) in rad; wheelbase: (…) in m, positive
    → (…, 3) `[v, 0, omega]`. At phi = ±π/2 a driven rear axle cannot roll: NaN.
    Source: exercise 5, θ̇ = (v/L) tan φ.

    >>> body_twist(2.0, np.pi / 4, wheelbase=2.5).round(6)
    array([2. , 0. , 0.8])
    """
    return _twist(v, phi, wheelbase, 0.0)


@quiet
def front_twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike) -> Array:
    """The velocity of the front axle's middle in the body frame: v/cos φ in the direction φ.

    v, phi, wheelbase: as in `body_twist` → (…, 3) `[v, v tan φ, omega]`; NaN at phi = ±π/2.
    Source: exercise 5; the rear axle's velocity plus omega times the wheelbase, sideways.
    """
    return _twist(v, phi, wheelbase, 1.0)


def _twist(v: ArrayLike, phi: ArrayLike, wheelbase: ArrayLike, sideways: float) -> Array:
    base = positive("wheelbase", wheelbase)
    shape, (v, phi) = rows(("v", v, ()), ("phi", phi, ()), parameters=(base,))
    tangent = _tangent(phi)
    out = np.empty((*shape, 3))
    out[..., 0] = v + 0 * tangent
    out[..., 1] = sideways * v * tangent + 0.0  # + 0.0 makes a zero positive
    out[..., 2] = v * tangent / base
    return out


@quiet
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
    base, dt = positive("wheelbase", wheelbase)[..., None], np.atleast_1d(finite("dt", dt))
    v, phi = np.atleast_1d(numbers("v", v), numbers("phi", phi))
    steps, (v, phi) = rows(("v", v, ()), ("phi", phi, ()), parameters=(base, dt))
    length = v * dt
    turn = np.broadcast_to(length * _tangent(phi) / base, steps)
    return _follow(pose, turn.cumsum(-1), turn, length + 0 * turn, method)


def _axle_angle(y: Array, x: Array) -> Array:
    """The angle in (-π/2, π/2] of the line along (x, y); a line has no front and no back."""
    sign = np.copysign(1.0, x)
    angle = np.asarray(np.arctan2(sign * y, sign * x))
    angle[angle <= -np.pi / 2] = np.pi / 2
    return angle


def _tangent(phi: Array) -> Array:
    """tan φ, NaN at ±π/2."""
    tangent = np.asarray(np.tan(phi))
    tangent[np.abs(tangent) > STEEPEST] = np.nan
    return tangent
