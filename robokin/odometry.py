"""Odometry: where a robot with two driven wheels is, from its wheel encoders.

Ticks are whole numbers, forward positive; a missing reading is NaN. Siegwart, Nourbakhsh &
Scaramuzza, Introduction to Autonomous Mobile Robots, section 5.2.4; Lynch & Park, Modern Robotics,
section 13.4.
"""

from typing import Any

import numpy as np

from robokin._arrays import Array, ArrayLike, entries, first, matrix, parts, vector
from robokin._paths import METHOD, follow, sinc, sinc_slope
from robokin._rotations import square
from robokin._validation import Sizes, data, not_negative, positive, refuse, validated, whole
from robokin.errors import RobokinError, at_index

__all__ = ["covariance", "ellipse", "path", "travel", "umbmark", "unwrap_counter", "velocity"]


def _ticks(name: str, value: Any, sizes: Sizes) -> Array:
    """Validate whole numbers; unsigned ones must not be differences that wrapped round."""
    ticks = whole(name, value, sizes)
    dtype = np.asarray(value).dtype
    if dtype.kind == "u":
        allowed = "ticks of one step (unsigned differences wrap round: use unwrap_counter)"
        refuse(name, ticks, ticks <= np.iinfo(dtype).max // 2, allowed)
    return ticks


TICKS = {"ticks_left": _ticks, "ticks_right": _ticks}
WHEEL = {"ticks_per_turn": positive(), "wheel_radius": positive()}
ROBOT = {**WHEEL, "wheel_distance": positive()}
UMBMARK_LIMIT = 0.25  # rad; the first-order theory is off by more than half from there
ROUNDING = 1e-12  # of the variances, between numbers that should be the same


def _per_tick(ticks_per_turn: ArrayLike, wheel_radius: ArrayLike) -> Array:
    """Return how far a wheel rolls in a tick, m."""
    return 2 * np.pi * wheel_radius / ticks_per_turn


@validated(ticks=_ticks, **WHEEL)
def travel(ticks: ArrayLike, ticks_per_turn: ArrayLike, wheel_radius: ArrayLike) -> Array:
    """Return how far a wheel has rolled.

    One turn of C ticks is 2π r: D = 2π r N/C.

    Parameters
    ----------
    ticks : array_like, shape (...)
        Ticks N of one step; for readings of a counter `unwrap_counter` first.
    ticks_per_turn : array_like, shape (...)
        Ticks C of one turn; a gear can make it a fraction.
    wheel_radius : array_like, shape (...)
        Radius r in m.

    Returns
    -------
    ndarray, shape (...)
        Travel D in m.

    Examples
    --------
    >>> round(float(travel(500, ticks_per_turn=1000, wheel_radius=0.05)), 6)
    0.15708
    """
    return _per_tick(ticks_per_turn, wheel_radius) * ticks


@validated(
    bits=data(ok=lambda n: (n == np.rint(n)) & (n >= 1) & (n <= 52), allowed="1, 2, … or 52"),
    modulus=data(ok=lambda n: (n == np.rint(n)) & (n >= 2) & (n <= 2**52), allowed="2, … or 2**52"),
    counts=whole,
)
def unwrap_counter(
    counts: ArrayLike, bits: ArrayLike | None = None, modulus: ArrayLike | None = None
) -> Array:
    """Return the ticks between the readings of a counter that wraps round.

    The shorter way round is taken. A NaN makes the steps on both its sides NaN. Name the counter's
    size in one of the two ways.

    Parameters
    ----------
    counts : array_like, shape (..., N)
        Whole numbers, signed or unsigned.
    bits : array_like, shape (...), optional
        Bits of each counter, from 1 to 52: a modulus of `2**bits`.
    modulus : array_like, shape (...), optional
        How many different counts each counter has, from 2 to `2**52`.

    Returns
    -------
    ndarray, shape (..., N-1)
        Ticks from -modulus/2 up to, but not including, modulus/2.

    Raises
    ------
    RobokinError
        If a count is outside -modulus/2 to modulus - 1: that counter cannot show it. If both or
        neither of `bits` and `modulus` are given.

    Examples
    --------
    >>> unwrap_counter([65530, 4, 65533], bits=16)
    array([10., -7.])
    >>> unwrap_counter([3990, 10], modulus=4000)
    array([20.])
    """
    if (bits is None) == (modulus is None):
        raise RobokinError("unwrap_counter needs either bits or modulus, got both or neither")
    counts = np.atleast_1d(counts)
    span = (np.asarray(modulus) if bits is None else 2.0**bits)[..., None]
    outside = (counts < -span / 2) | (counts >= span)
    allowed = "from -modulus/2 to modulus - 1 (modulus: 2**bits)"
    refuse("counts", counts, ~(outside & np.isfinite(counts)), allowed)
    ticks = np.diff(counts)
    return ticks - span * (ticks >= span / 2) + span * (ticks < -span / 2)


@validated(**TICKS, **ROBOT, pose=data(3), method=METHOD)
def path(
    ticks_left: ArrayLike,
    ticks_right: ArrayLike,
    ticks_per_turn: ArrayLike,
    wheel_radius: ArrayLike,
    wheel_distance: ArrayLike,
    pose: ArrayLike = (0, 0, 0),
    method: str = "exact",
) -> Array:
    """Return all poses along a drive of N encoder steps, the first included.

    The heading comes from the whole number of ticks so far, so its error does not grow with N. A
    missing reading makes the path NaN from its step on.

    Parameters
    ----------
    ticks_left, ticks_right : array_like, shape (..., N)
        Ticks of each step; for readings of a counter `unwrap_counter` first.
    ticks_per_turn : array_like, shape (...)
        Ticks of one turn of a wheel.
    wheel_radius, wheel_distance : array_like, shape (...)
        Sizes in m.
    pose : array_like, shape (..., 3), default (0, 0, 0)
        `[x, y, theta]` at the start, in m and rad.
    method : {"exact", "midpoint", "start", "end"}, default "exact"
        As in `motion.path`.

    Returns
    -------
    ndarray, shape (..., N+1, 3)
        `[x, y, theta]` in m and rad.

    References
    ----------
    Siegwart et al., section 5.2.4, Δθ = (D_R − D_L)/b.

    Examples
    --------
    >>> path([0, 9], [9, 9], ticks_per_turn=36, wheel_radius=0.1, wheel_distance=0.2).round(3)
    array([[0.   , 0.   , 0.   ],
           [0.071, 0.029, 0.785],
           [0.182, 0.14 , 0.785]])
    """
    per_tick = _per_tick(ticks_per_turn, wheel_radius)[..., None]
    length = per_tick * (ticks_right + ticks_left) / 2
    angle, difference = per_tick / wheel_distance[..., None], ticks_right - ticks_left
    turned = angle * difference.cumsum(axis=-1)
    return follow(pose, length, angle * difference, method, turned)


@validated(**TICKS, dt=not_negative(), **ROBOT)
def velocity(
    ticks_left: ArrayLike,
    ticks_right: ArrayLike,
    dt: ArrayLike,
    ticks_per_turn: ArrayLike,
    wheel_radius: ArrayLike,
    wheel_distance: ArrayLike,
) -> tuple[Array, Array]:
    """Return the mean speed and turning rate of the robot over a time step.

    Parameters
    ----------
    ticks_left, ticks_right : array_like, shape (...)
        Ticks of the step; for readings of a counter `unwrap_counter` first.
    dt : array_like, shape (...)
        Time in s, not negative. Two readings of one time have no velocity: 0 gives NaN.
    ticks_per_turn : array_like, shape (...)
        Ticks of one turn of a wheel.
    wheel_radius, wheel_distance : array_like, shape (...)
        Sizes in m.

    Returns
    -------
    v : ndarray, shape (...)
        Speed in m/s.
    omega : ndarray, shape (...)
        Turning rate in rad/s.

    References
    ----------
    Siegwart et al., section 5.2.4, divided by Δt: v = (D_R + D_L)/(2Δt), ω = (D_R − D_L)/(bΔt).

    Examples
    --------
    >>> v, omega = velocity(100, 200, 0.1, ticks_per_turn=400, wheel_radius=0.1, wheel_distance=0.2)
    >>> round(float(v), 3), round(float(omega), 3)
    (2.356, 7.854)
    """
    per_tick = _per_tick(ticks_per_turn, wheel_radius)
    dt = np.where(dt > 0, dt, np.nan)
    v = per_tick * (ticks_right + ticks_left) / (2 * dt)
    omega = per_tick * (ticks_right - ticks_left) / (wheel_distance * dt)
    v, omega = parts(vector(v, omega))  # of one shape
    return v, omega


@validated(**TICKS, **ROBOT, noise=not_negative(), pose=data(3), start=data(3, 3))
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
    """Return how uncertain each pose of `path` is: covariances of x, y, theta, to first order.

    Each wheel errs by itself in each step. F_p of many steps is that of one from the first to the
    last place, so the steps are summed in one frame. A missing reading makes it NaN from its step
    on.

    Parameters
    ----------
    ticks_left, ticks_right : array_like, shape (..., N)
        Ticks of each step; for readings of a counter `unwrap_counter` first.
    ticks_per_turn : array_like, shape (...)
        Ticks of one turn of a wheel.
    wheel_radius, wheel_distance : array_like, shape (...)
        Sizes in m.
    noise : array_like, shape (...)
        Variance of a wheel's travel for each metre travelled, in m, not negative.
    pose : array_like, shape (..., 3), default (0, 0, 0)
        `[x, y, theta]` at the start, in m and rad.
    start : array_like, shape (..., 3, 3), optional
        Covariance of the first pose in m², m rad and rad²; zero if not given.

    Returns
    -------
    ndarray, shape (..., N+1, 3, 3)
        Covariances in m², m rad and rad².

    References
    ----------
    Siegwart et al., section 5.2.4, Σ' = F_p Σ F_pᵀ + F_Δ Q F_Δᵀ, along exact arcs.
    """
    per_tick = _per_tick(ticks_per_turn, wheel_radius)[..., None]
    turn = per_tick / wheel_distance[..., None] * (ticks_right - ticks_left)
    left, right = per_tick * ticks_left, per_tick * ticks_right
    half, length = turn / 2, (left + right) / 2
    heading = pose[..., 2:] + turn.cumsum(axis=-1) - half  # in the middle of each step
    ahead, chord = np.exp(1j * heading), sinc(half)  # x + iy for all that lies in the plane
    place = (length * chord * ahead).cumsum(axis=-1)

    along = ahead * chord / 2  # what a metre more of a wheel adds, and then what its turn adds:
    across = ahead * length * (sinc_slope(half) + 1j * chord) / 2 - 1j * place  # at the origin
    turns = np.array([-1.0, 1.0]) / wheel_distance[..., None, None]
    moved = along[..., None] + across[..., None] * turns
    spread = np.sqrt(noise[..., None, None] * np.abs(vector(left, right)))
    errors = vector(moved.real, moved.imag, turns).swapaxes(-1, -2) * spread[..., None, :]
    steps = errors @ errors.swapaxes(-1, -2)
    total = np.zeros((*steps.shape[:-3], steps.shape[-3] + 1, 3, 3))  # at the origin, too
    np.cumsum(steps, axis=-3, out=total[..., 1:, :, :])
    if start is not None:
        total = total + start[..., None, :, :]
    lever = np.zeros((*place.shape[:-1], place.shape[-1] + 1, 3))  # from there to each place
    lever[..., 1:, 0], lever[..., 1:, 1] = -place.imag, place.real
    half_row = total[..., 2:, :] + 0.5 * total[..., 2:, 2:] * lever[..., None, :]
    carried = lever[..., None] * half_row
    return total + (carried + carried.swapaxes(-1, -2))


@validated(covariance=square(2, 3))
def ellipse(covariance: ArrayLike) -> tuple[Array, Array]:
    """Return the error ellipse of a position: how uncertain it is, and in which direction.

    It comes from the eigenvalues and -vectors of a symmetric 2 × 2 matrix.

    Parameters
    ----------
    covariance : array_like, shape (..., 3, 3) or (..., 2, 2)
        Covariance of a pose, as from `covariance`, or of x and y, in m².

    Returns
    -------
    half_axes : ndarray, shape (..., 2)
        Standard deviations along the axes in m, the larger first; NaN for what is no covariance.
    directions : ndarray, shape (..., 2, 2)
        Directions of the axes as columns, the second a quarter turn from the first.

    Examples
    --------
    >>> ellipse([[0.05, 0.03], [0.03, 0.05]])[0].round(6)
    array([0.282843, 0.141421])
    """
    (xx, xy, *_), (yx, yy, *_), *_ = entries(covariance)
    size, det = xx + yy, xx * yy - xy * xy  # rounding can make a line's a little less than 0
    sure = (xx >= 0) & (yy >= 0) & (np.abs(xy - yx) <= ROUNDING * size)
    bad = ~(sure & (det >= -ROUNDING * size**2))
    large = np.sqrt(np.where(bad, np.nan, size / 2 + np.hypot((xx - yy) / 2, xy)))
    small = np.where(large > 0, np.sqrt(np.maximum(det, 0.0)) / large, large)
    angle = np.where(bad, np.nan, np.arctan2(2 * xy, xx - yy) / 2)
    c, s = np.cos(angle), np.sin(angle)
    return vector(large, small), matrix([[c, -s], [s, c]])


@validated(ends_cw=data("n", 2), ends_ccw=data("m", 2), side=positive(), wheel_distance=positive())
def umbmark(
    ends_cw: ArrayLike, ends_ccw: ArrayLike, side: ArrayLike, wheel_distance: ArrayLike
) -> tuple[Array, Array]:
    """Return a calibration by square runs both ways: wheel distance, and ratio of the wheels.

    Each run starts at the origin along x, makes three more sides after right turns (clockwise) or
    left turns, and by its odometry ends where it started. The result is right to first order in the
    errors, so run it again with the corrected values.

    Parameters
    ----------
    ends_cw, ends_ccw : array_like, shape (..., n, 2)
        Where the robot really ended, in m; the numbers of runs may differ.
    side : array_like, shape (...)
        Side of the square in m.
    wheel_distance : array_like, shape (...)
        Distance between the wheels used so far, in m.

    Returns
    -------
    wheel_distance : ndarray, shape (...)
        Corrected distance between the wheels in m.
    ratio : ndarray, shape (...)
        Diameter of the right wheel divided by that of the left: with their mean radius r they have
        the radii 2r/(1 + ratio) on the left and 2r·ratio/(1 + ratio) on the right.

    Raises
    ------
    RobokinError
        If a corner or a side would be bent by over 0.25 rad, or by more than wheels can: sizes are
        not all in metres, or `wheel_distance` is far from right.

    References
    ----------
    Borenstein & Feng (1996), Measurement and Correction of Systematic Odometry Errors in Mobile
    Robots, their x and y formulas averaged: the robot turns too little by alpha at each corner and
    to the left by beta on each side.
    """
    (x_cw, y_cw), (x_ccw, y_ccw) = (parts(ends.mean(axis=-2)) for ends in (ends_cw, ends_ccw))
    alpha = (y_ccw - x_ccw - x_cw - y_cw) / (8 * side)
    beta = (x_ccw - y_ccw - x_cw - y_cw) / (8 * side)
    corrected = wheel_distance * np.pi / (np.pi - 2 * alpha)
    bulge = corrected * np.sin(beta / 2)  # side * (half the distance / radius of a side's arc)
    bend = np.maximum(np.abs(alpha), np.abs(beta))
    bad = np.isfinite(bend) & ((bend > UMBMARK_LIMIT) | (np.abs(bulge) >= side))
    if bad.any():
        index = first(bad)
        off = np.broadcast_to(bend, bad.shape)[index]
        raise RobokinError(
            f"ends_cw, ends_ccw{at_index(index)} mean that a corner or a side is bent by {off:.3g} "
            f"rad, allowed {UMBMARK_LIMIT}: give ends, side and wheel_distance in m, and start "
            "from a wheel_distance that is nearly right"
        )
    return corrected, (side + bulge) / (side - bulge)
