"""Odometry: where a robot with two driven wheels is, from its wheel encoders.

Wheels in the order left, right. Ticks are whole numbers, forward positive; a missing reading is
NaN. Exercise 7; Siegwart, Nourbakhsh & Scaramuzza, section 5.2.4.
"""

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, _refuse, finite, numbers, positive, quiet, rows
from robokin.errors import RobokinError
from robokin.motion import _follow, _sinc

__all__ = ["covariance", "path", "travel", "umbmark", "unwrap_counter", "velocity"]


@quiet
def travel(ticks: ArrayLike, ticks_per_turn: ArrayLike, wheel_radius: ArrayLike) -> Array:
    """How far a wheel has rolled.

    ticks: (…) whole numbers; ticks_per_turn (a gear can make it a fraction): (…) positive;
    wheel_radius: (…) in m, positive → (…) in m. Source: exercise 7, D = 2π r N/C.

    >>> round(float(travel(500, ticks_per_turn=1000, wheel_radius=0.05)), 6)
    0.15708
    """
    per_turn = positive("ticks_per_turn", ticks_per_turn)
    radius = positive("wheel_radius", wheel_radius)
    _, (ticks,) = rows(("ticks", _whole("ticks", ticks), ()), parameters=(per_turn, radius))
    return 2 * np.pi * radius / per_turn * ticks


@quiet
def unwrap_counter(counts: ArrayLike, bits: ArrayLike) -> Array:
    """The ticks between the readings of a counter that wraps round after 2**bits.

    counts: (…, N) whole numbers, signed or unsigned; bits: (…) from 1 to 52, one for each counter
    → (…, N-1), the shorter way round, from -2**(bits-1) to 2**(bits-1) - 1. A count that such a
    counter cannot show is refused; a NaN makes the steps on both its sides NaN.

    >>> unwrap_counter([65530, 4, 65533], bits=16)
    array([10., -7.])
    """
    bits = finite("bits", bits)
    _refuse("bits", bits, (bits != np.rint(bits)) | (bits < 1) | (bits > 52), "1, 2, … or 52")
    span = 2.0 ** bits[..., None]
    counts = np.atleast_1d(_whole("counts", counts))
    shape, (counts,) = rows(("counts", counts, ()), parameters=(span,))
    counts = np.broadcast_to(counts, shape)
    outside = (counts < -span / 2) | (counts >= span)
    _refuse("counts", counts, outside, "from -2**(bits-1) to 2**bits - 1")
    return (np.diff(counts) + span / 2) % span - span / 2


@quiet
def path(
    ticks_left: ArrayLike,
    ticks_right: ArrayLike,
    ticks_per_turn: ArrayLike,
    wheel_radius: ArrayLike,
    wheel_distance: ArrayLike,
    pose: ArrayLike = (0, 0, 0),
    method: str = "exact",
) -> Array:
    """All poses along a drive of N encoder steps, the first included; rules as in `motion.path`.

    ticks_left, ticks_right: broadcast to (…, N); ticks_per_turn, wheel_radius, wheel_distance:
    (…), one for each path, lengths in m, positive; pose: (…, 3) at the start → (…, N+1, 3). The
    heading comes from the whole number of ticks so far, so its error does not grow with N.
    A missing reading makes the path NaN from its step on.
    Source: exercise 7, Δθ = (D_R − D_L)/b.

    >>> path([0, 9], [9, 9], ticks_per_turn=36, wheel_radius=0.1, wheel_distance=0.2).round(3)
    array([[0.   , 0.   , 0.   ],
           [0.071, 0.029, 0.785],
           [0.182, 0.14 , 0.785]])
    """
    left, right, per_tick, distance = _readings(
        ticks_left, ticks_right, ticks_per_turn, wheel_radius, wheel_distance
    )
    difference, angle = right - left, per_tick / distance
    turned = difference.cumsum(-1) * angle
    return _follow(pose, turned, difference * angle, 0.5 * per_tick * (right + left), method)


@quiet
def velocity(
    ticks_left: ArrayLike,
    ticks_right: ArrayLike,
    dt: ArrayLike,
    ticks_per_turn: ArrayLike,
    wheel_radius: ArrayLike,
    wheel_distance: ArrayLike,
) -> tuple[Array, Array]:
    """Mean speed and turning rate of the robot over a time step.

    ticks_left, ticks_right: (…) in the step; dt: (…) in s, positive; ticks_per_turn,
    wheel_radius, wheel_distance: (…) positive → v (…) in m/s and omega (…) in rad/s.
    Source: exercise 7, V = (D_R + D_L)/(2Δt), ω = (D_R − D_L)/(bΔt).

    >>> v, omega = velocity(100, 200, 0.1, ticks_per_turn=400, wheel_radius=0.1, wheel_distance=0.2)
    >>> round(float(v), 3), round(float(omega), 3)
    (2.356, 7.854)
    """
    per_turn, dt = positive("ticks_per_turn", ticks_per_turn), positive("dt", dt)
    radius = positive("wheel_radius", wheel_radius)
    distance = positive("wheel_distance", wheel_distance)
    shape, (left, right) = rows(
        ("ticks_left", _whole("ticks_left", ticks_left), ()),
        ("ticks_right", _whole("ticks_right", ticks_right), ()),
        parameters=(per_turn, dt, radius, distance),
    )
    per_tick = 2 * np.pi * radius / per_turn
    out = np.empty((2, *shape))
    out[0] = 0.5 * per_tick * (right + left) / dt
    out[1] = per_tick * (right - left) / (distance * dt)
    return out[0], out[1]


@quiet
def covariance(
    ticks_left: ArrayLike,
    ticks_right: ArrayLike,
    ticks_per_turn: ArrayLike,
    wheel_radius: ArrayLike,
    wheel_distance: ArrayLike,
    noise: ArrayLike,
    pose: ArrayLike = (0, 0, 0),
    start: ArrayLike | None = None,
) -> Array:
    """How uncertain each pose of `path` is: the covariance of its x, y and theta, to first order.

    noise: (…) the variance of a wheel's travel for each metre travelled, in m, not negative;
    start: (…, 3, 3) covariance of the first pose, zero if not given; the others as in `path`
    → (…, N+1, 3, 3). Each wheel errs by itself in each step. A missing reading makes it NaN from
    its step on.
    Source: Siegwart et al., Σ' = F_p Σ F_pᵀ + F_Δ Q F_Δᵀ, along exact arcs. F_p of many steps is
    that of one from the first to the last place, so the steps can be summed in one frame.
    """
    noise = finite("noise", noise)
    _refuse("noise", noise, noise < 0, "zero or positive")
    left, right, per_tick, distance = _readings(
        ticks_left, ticks_right, ticks_per_turn, wheel_radius, wheel_distance
    )
    half, length = 0.5 * per_tick / distance * (right - left), 0.5 * per_tick * (right + left)
    batch, (pose, start) = rows(
        ("pose", pose, (3,)),
        ("start", np.zeros((3, 3)) if start is None else start, (3, 3)),
        parameters=(noise, np.empty(half.shape[:-1])),
    )
    turned = np.broadcast_to(2 * half.cumsum(-1), (*batch, half.shape[-1]))
    place = _follow(pose * [0, 0, 1], turned, 2 * half, length, "exact")

    errors = _step_errors(place, half, length, distance)
    errors[..., 0] *= np.sqrt(noise[..., None] * per_tick * np.abs(left))[..., None]
    errors[..., 1] *= np.sqrt(noise[..., None] * per_tick * np.abs(right))[..., None]
    total = np.empty((*place.shape, 3))
    total[..., 0, :, :] = start
    total[..., 1:, :, :] = errors @ np.swapaxes(errors, -1, -2)
    np.cumsum(total, axis=-3, out=total)

    lever = np.zeros_like(place)
    lever[..., 0], lever[..., 1] = -place[..., 1], place[..., 0]
    half_row = total[..., 2:, :] + 0.5 * total[..., 2:, 2:] * lever[..., None, :]
    carried = lever[..., None] * half_row
    total += carried + np.swapaxes(carried, -1, -2)
    return total


@quiet
def umbmark(
    ends_cw: ArrayLike, ends_ccw: ArrayLike, side: ArrayLike, wheel_distance: ArrayLike
) -> tuple[Array, Array]:
    """Calibration by square runs both ways: the wheel distance, and how unequal the wheels are.

    ends_cw, ends_ccw: (…, n, 2) in m, where the robot really ended runs that by its odometry end
    where they start, at the origin: first along x, then three right turns more and three sides
    (clockwise), or left turns; the numbers of runs may differ. side of the square, wheel_distance
    used so far: (…) in m, positive → corrected wheel distance (…) in m and diameter of the right
    wheel by that of the left (…). Right to first order in the errors, so run it again with the
    corrected values.
    Source: Borenstein & Feng 1996, their x and y formulas averaged: the robot turns too little
    by alpha at each corner and to the left by beta on each side.
    """
    side, distance = positive("side", side), positive("wheel_distance", wheel_distance)
    _, (cw, ccw) = rows(
        ("ends_cw", _mean_end("ends_cw", ends_cw), (2,)),
        ("ends_ccw", _mean_end("ends_ccw", ends_ccw), (2,)),
        parameters=(side, distance),
    )
    both = (cw[..., 0] + cw[..., 1]) / (-4 * side)  # alpha + beta
    difference = (ccw[..., 0] - ccw[..., 1]) / (-4 * side)  # alpha - beta
    alpha, beta = 0.5 * (both + difference), 0.5 * (both - difference)
    corrected = distance * (np.pi / 2) / (np.pi / 2 - alpha)
    bulge = corrected * np.sin(0.5 * beta)  # side * (half the distance / radius of a side's arc)
    return corrected, (side + bulge) / (side - bulge)


def _whole(name: str, value: ArrayLike) -> Array:
    array = numbers(name, value)
    fractional = np.abs(array - np.rint(array)) > 0
    return _refuse(name, array, fractional, "whole numbers (NaN where a reading is missing)")


def _readings(
    ticks_left: ArrayLike,
    ticks_right: ArrayLike,
    ticks_per_turn: ArrayLike,
    wheel_radius: ArrayLike,
    wheel_distance: ArrayLike,
) -> tuple[Array, Array, Array, Array]:
    """The ticks (…, N) of both wheels, and metres a tick and wheel distance (…, 1) for them."""
    per_turn = positive("ticks_per_turn", ticks_per_turn)[..., None]
    radius = positive("wheel_radius", wheel_radius)[..., None]
    distance = positive("wheel_distance", wheel_distance)[..., None]
    left, right = np.atleast_1d(
        _whole("ticks_left", ticks_left), _whole("ticks_right", ticks_right)
    )
    _, (left, right) = rows(
        ("ticks_left", left, ()),
        ("ticks_right", right, ()),
        parameters=(per_turn, radius, distance),
    )
    return left, right, 2 * np.pi * radius / per_turn, distance


def _step_errors(place: Array, half: Array, length: Array, distance: Array) -> Array:
    """What a metre more of the left and of the right wheel in each step adds: (…, N, 3, 2).

    Added to the pose after the step, and taken back to the origin of `place`.
    """
    heading, sinc = place[..., :-1, 2] + half, _sinc(half)
    side = np.array([-1.0, 1.0]) / distance[..., None]
    along = 0.5 * sinc[..., None] + side * (0.5 * length * _sinc_slope(half))[..., None]
    across = side * (0.5 * length * sinc)[..., None]
    c, s = np.cos(heading)[..., None], np.sin(heading)[..., None]
    out = np.empty((*heading.shape, 3, 2))
    out[..., 0, :] = c * along - s * across + place[..., 1:, 1:2] * side
    out[..., 1, :] = s * along + c * across - place[..., 1:, 0:1] * side
    out[..., 2, :] = side
    return out


def _sinc_slope(x: Array) -> Array:
    """The derivative of sin(x)/x; near 0, where the plain formula loses digits, by its series."""
    x2 = x * x
    series = -x / 3 * (1 - x2 / 10 * (1 - x2 / 28 * (1 - x2 / 54)))
    return np.where(np.abs(x) < 0.1, series, (np.cos(x) - _sinc(x)) / x)


def _mean_end(name: str, ends: ArrayLike) -> Array:
    array = numbers(name, ends)
    if array.ndim < 2 or array.shape[-1] != 2 or array.shape[-2] == 0:
        raise RobokinError(f"{name} must have shape (…, n, 2), n at least 1, got {array.shape}")
    return np.asarray(array.sum(axis=-2) / array.shape[-2])
