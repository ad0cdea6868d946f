"""How the library agrees with each formula of `formulas.py`."""

from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from book.differential_drive.formulas import b, r
from book.motion.formulas import dt, theta, x, y
from book.odometry import formulas
from book.odometry.formulas import (
    D_L,
    D_R,
    N_L,
    N_R,
    C,
    D,
    count_before,
    count_now,
    counter_span,
    covariance_entries,
    drive,
    dtheta,
    l_x,
    l_y,
    lever,
    noise,
    p_xx,
    p_xy,
    p_yy,
    short_turn,
    side,
    side_swing,
    slip,
    x_ccw,
    x_cw,
    y_ccw,
    y_cw,
)
from courseware.equations import Array, Check
from robokin import motion, odometry

EXAMPLE = {N_L: 384.0, N_R: 640.0, C: 512.0, r: 0.05}
SAME, OPPOSITE = {D_L: 0.25, D_R: 0.25}, {D_L: -0.25, D_R: 0.25}
STILL, ONE_HELD = {D_L: 0.0, D_R: 0.0}, {D_L: 0.0, D_R: 0.25}
# u = 0.09: the slope by its series; as much noise as makes its last term show
NEARLY_SAME = {D_L: 0.16, D_R: 0.34, b: 1.0, noise: 10.0}
# The library takes whole ticks; a formula holds between them too. So a tick of the formula is
# 2**40 ticks of a finer encoder, and a metre 2**50 ticks: rounding to whole ones is 1e-15 m.
FINER = 2.0**40
TICKS_A_METRE = 2.0**50
STRAIGHT = ({dtheta: 0.0}, {dtheta: 1e-16}, {dtheta: -1e-16}, {dtheta: 1e-8})


def whole(ticks: ArrayLike) -> Array:
    """The nearest whole numbers of ticks."""
    return np.rint(ticks)


def travel_of_ticks(ticks: Array, C: Array, r: Array) -> Array:
    """What each of two wheels has rolled, from ticks (…, 2) that need not be whole."""
    return odometry.travel(whole(ticks * FINER), C[..., None] * FINER, r[..., None])


def velocity_of_travel(D_L: Array, D_R: Array, b: Array, dt: ArrayLike) -> Array:
    """Mean speed and turning rate from what the wheels have rolled."""
    ticks = whole(D_L * TICKS_A_METRE), whole(D_R * TICKS_A_METRE)
    found = odometry.velocity(*ticks, dt, TICKS_A_METRE, 0.5 / np.pi, b)
    return np.stack(found, axis=-1)


def distance_of_travel(D_L: Array, D_R: Array) -> Array:
    """How far the middle of the axle moves: its mean speed over one second."""
    return velocity_of_travel(D_L, D_R, np.ones_like(D_L), 1.0)[..., 0]


def turn_of_travel(D_L: Array, D_R: Array, b: Array) -> Array:
    """How much the robot turns, by the path of one sample."""
    ticks = whole(D_L * TICKS_A_METRE)[..., None], whole(D_R * TICKS_A_METRE)[..., None]
    return odometry.path(*ticks, TICKS_A_METRE, 0.5 / np.pi, b)[..., 1, 2]


def one_step(pose: Array, D: Array, dtheta: Array, method: str) -> Array:
    """The pose after one sample in which the robot moves by D and turns by dtheta."""
    left, right = (whole((D + s * dtheta / 2) * TICKS_A_METRE)[..., None] for s in (-1, 1))
    return odometry.path(left, right, TICKS_A_METRE, 0.5 / np.pi, 1.0, pose, method)[..., 1, :]


def by_old_heading(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample, all of it along the heading before."""
    return one_step(pose, D, dtheta, "start")


def by_new_heading(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample, all of it along the heading after."""
    return one_step(pose, D, dtheta, "end")


def by_middle_heading(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample, all of it along the heading half way."""
    return one_step(pose, D, dtheta, "midpoint")


def by_exact_arc(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample along the arc that the robot really drives."""
    return one_step(pose, D, dtheta, "exact")


def counter_difference(before: Array, now: Array, span: Array) -> Array:
    """Ticks between two readings of a counter that wraps round, by the same finer encoder."""
    finer = 2.0**52 / span
    counts = whole(np.stack([before, now], axis=-1) * finer[..., None])
    return odometry.unwrap_counter(counts, 52)[..., 0] / finer


def covariance_of_step(
    theta: Array, D_L: Array, D_R: Array, b: Array, noise: Array, start: Array
) -> Array:
    """The six different entries of a pose's covariance after one sample, from those before."""
    ticks = whole(D_L * TICKS_A_METRE)[..., None], whole(D_R * TICKS_A_METRE)[..., None]
    xx, xy, xt, yy, yt, tt = np.moveaxis(start, -1, 0)
    before = np.stack([xx, xy, xt, xy, yy, yt, xt, yt, tt], axis=-1).reshape(*xx.shape, 3, 3)
    pose = np.stack([0 * theta, 0 * theta, theta], axis=-1)
    robot = TICKS_A_METRE, 0.5 / np.pi, b
    after = odometry.covariance(*ticks, *robot, noise, pose, before)[..., 1, :, :]
    return after[..., [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]


def half_axes(xx: Array, xy: Array, yy: Array) -> Array:
    """Its half-axes alone, from the three numbers of the covariance."""
    matrix = np.stack([xx, xy, xy, yy], axis=-1).reshape(*xx.shape, 2, 2)
    return odometry.ellipse(matrix)[0]


def ends_of_runs(alpha: Array, beta: Array, side: Array) -> tuple[Array, Array]:
    """Where square runs end, to first order: clockwise and counter-clockwise, (…, 1, 2) each."""
    cw, ccw = -2 * side * (alpha + beta), -2 * side * (alpha - beta)
    ends = np.stack([cw, cw], axis=-1), np.stack([ccw, -ccw], axis=-1)
    return ends[0][..., None, :], ends[1][..., None, :]


def angles_of_ends(cw: Array, ccw: Array, side: Array) -> Array:
    """The two angles that the calibration finds on its way, from what it answers."""
    corrected, ratio = odometry.umbmark(cw[..., None, :], ccw[..., None, :], side, 1.0)
    swing = 2 * np.arcsin(side / corrected * (ratio - 1) / (ratio + 1))
    return np.stack([np.pi / 2 * (1 - 1 / corrected), swing], axis=-1)


def calibration_of_angles(alpha: Array, beta: Array, b: Array, side: Array) -> Array:
    """The corrected wheel distance and the ratio of diameters of runs with these two angles."""
    return np.stack(odometry.umbmark(*ends_of_runs(alpha, beta, side), side, b), axis=-1)


TINY = 2.0**-40  # of a piece is driven in its place: its own length does not count


def swing_of_slip(slip: Array, b: Array) -> Array:
    """How much the robot turns when one wheel alone rolls so far."""
    return turn_of_travel(0 * slip, slip, b)


def carry(covariance: Array, heading: Array, far: Array, b: Array) -> Array:
    """The covariance of a pose, propagated along a straight line without noise."""
    ticks = whole(far * TICKS_A_METRE)[..., None]
    pose = np.stack([0 * heading, 0 * heading, heading], axis=-1)
    robot = TICKS_A_METRE, 0.5 / np.pi, b
    return odometry.covariance(ticks, ticks, *robot, 0 * b, pose, covariance)[..., -1, :, :]


def shift_of_slip(slip: Array, b: Array, lever: Array) -> Array:
    """The end's standard deviation, if a turn about the left wheel errs by one slip."""
    turn = slip / b
    error = np.stack([turn * b / 2, 0 * turn, turn], axis=-1)
    start = error[..., :, None] * error[..., None, :]
    end = carry(start, 0 * b, np.sqrt(lever**2 - b**2 / 4), b)
    return np.sign(slip) * np.sqrt(end[..., 0, 0] + end[..., 1, 1])


def covariance_of_piece(
    to_end: Array, theta: Array, D_L: Array, D_R: Array, b: Array, noise: Array
) -> Array:
    """The end's variances by a small piece: the propagated covariance of piece and rest."""
    zero = 0 * theta
    left, right = (whole(D * TICKS_A_METRE)[..., None] for D in (D_L, D_R))
    ticks_per_turn, radius = TICKS_A_METRE / TINY, 0.5 / np.pi
    pose = np.stack([zero, zero, theta], axis=-1)
    after = odometry.covariance(left, right, ticks_per_turn, radius, b, noise / TINY, pose)
    heading = np.arctan2(to_end[..., 1], to_end[..., 0])
    end = carry(after[..., -1, :, :], heading, np.hypot(to_end[..., 0], to_end[..., 1]), b)
    return end[..., [0, 0, 1], [0, 1, 1]]


def spread_of_straight(noise: Array, drive: Array, b: Array) -> Array:
    """Standard deviations of heading and y after a straight drive in ever more samples."""
    few, more = (
        odometry.covariance(ticks, ticks, TICKS_A_METRE * n, 0.5 / np.pi, b, noise)
        for n in (1, 2)
        for ticks in [np.repeat(whole(drive * TICKS_A_METRE / 8)[..., None], 8 * n, axis=-1)]
    )
    end = (4 * more[..., -1, :, :] - few[..., -1, :, :]) / 3
    return np.sqrt(np.stack([end[..., 2, 2], end[..., 1, 1]], axis=-1))


def ends_of_driven_squares(side: Array, alpha: Array, beta: Array) -> Array:
    """What the ends of both squares do at small errors: their derivative, extrapolated."""

    def ends(part: float) -> Array:
        both = []
        for turns in (1, -1):
            bend, corner = part * beta, turns * (np.pi / 2 - part * alpha)
            v = np.stack([side, 0 * side] * 4, axis=-1)
            omega = np.stack([bend, corner] * 4, axis=-1)
            both.append(motion.path([0, 0, 0], v, omega, 1.0)[..., -1, :2])
        return np.concatenate(both, axis=-1)

    slopes = [(ends(h) - ends(-h)) / (2 * h) for h in (1 / 16, 1 / 32, 1 / 64)]
    better = [(4 * b - a) / 3 for a, b in pairwise(slopes)]
    return (16 * better[1] - better[0]) / 15


CHECKS = (
    Check(
        formulas.door_angle,
        function=swing_of_slip,
        arguments=(slip, b),
        tolerance=5e-14,
        reason="roundings of 1e-15 m, divided by 0.05 m",
        specials=({slip: 0.0},),
    ),
    Check(
        formulas.door_shift,
        function=shift_of_slip,
        arguments=(slip, b, lever),
        tolerance=1e-13,
        reason="a few roundings of numbers up to 6 m",
        specials=({slip: 0.0},),
    ),
    Check(
        formulas.lever_term,
        function=covariance_of_piece,
        arguments=((l_x, l_y), theta, D_L, D_R, b, noise),
        tolerance=1e-11,
        reason="half of the tiny piece, up to 1e-11 rad, times terms of up to 30 m",
        specials=(ONE_HELD, OPPOSITE, STILL),
    ),
    Check(
        formulas.straight_spread,
        function=spread_of_straight,
        arguments=(noise, drive, b),
        tolerance=1e-13,
        reason="some roundings of numbers up to 20 m; 8 samples lack a part of 1/8² exactly, so "
        "two numbers of samples give the limit",
        specials=({noise: 0.0},),
    ),
    Check(
        formulas.square_ends,
        function=ends_of_driven_squares,
        arguments=(side, short_turn, side_swing),
        tolerance=1e-11,
        reason="roundings of 1e-15 m, divided by a step of 1/64; what the extrapolation leaves is "
        "a part of (0.2/64)⁶",
        specials=({short_turn: 0.0, side_swing: 0.0},),
    ),
    Check(
        formulas.travel,
        function=travel_of_ticks,
        arguments=((N_L, N_R), C, r),
        tolerance=5e-14,
        reason="five roundings of numbers up to 2π 0.5 m x 1000 / 100 = 31 m",
        specials=(EXAMPLE, {N_L: 0.0, N_R: 0.0}),
    ),
    Check(
        formulas.distance,
        function=distance_of_travel,
        arguments=(D_L, D_R),
        tolerance=2e-15,
        reason="a few roundings of numbers up to 1 m, and whole ticks of 1e-15 m",
        specials=(SAME, OPPOSITE, STILL),
    ),
    Check(
        formulas.turn,
        function=turn_of_travel,
        arguments=(D_L, D_R, b),
        tolerance=5e-14,
        reason="roundings of 1e-15 m, divided by 0.05 m",
        specials=(SAME, OPPOSITE, STILL),
    ),
    Check(
        formulas.velocity,
        function=velocity_of_travel,
        arguments=(D_L, D_R, b, dt),
        ranges={dt: (0.05, 1)},
        tolerance=1e-12,
        reason="roundings of 1e-15 m, divided by 0.05 m x 0.05 s",
        specials=(SAME, OPPOSITE, STILL),
    ),
    Check(
        formulas.old_heading,
        function=by_old_heading,
        arguments=((x, y, theta), D, dtheta),
        tolerance=5e-15,
        reason="a rounding of headings up to 6 rad, and of travel to whole ticks of 1e-15 m",
        specials=(*STRAIGHT, {D: 0.0}),
    ),
    Check(
        formulas.new_heading,
        function=by_new_heading,
        arguments=((x, y, theta), D, dtheta),
        tolerance=5e-15,
        reason="a rounding of headings up to 6 rad, and of travel to whole ticks of 1e-15 m",
        specials=(*STRAIGHT, {D: 0.0}),
    ),
    Check(
        formulas.middle_heading,
        function=by_middle_heading,
        arguments=((x, y, theta), D, dtheta),
        tolerance=5e-15,
        reason="a rounding of headings up to 6 rad, and of travel to whole ticks of 1e-15 m",
        specials=(*STRAIGHT, {D: 0.0}),
    ),
    Check(
        formulas.exact_arc,
        function=by_exact_arc,
        arguments=((x, y, theta), D, dtheta),
        tolerance=5e-15,
        reason="a rounding of headings up to 6 rad, and of travel to whole ticks of 1e-15 m",
        specials=(*STRAIGHT, {D: 0.0}),
    ),
    Check(
        formulas.counter_step,
        function=counter_difference,
        arguments=(count_before, count_now, counter_span),
        ranges={counter_span: (65536, 65536)},
        tolerance=1e-10,
        reason="readings between whole numbers, rounded to 2**-36 of a tick",
        specials=({count_before: 65530.0, count_now: 4.0}, {count_before: 3.0, count_now: 65533.0}),
    ),
    Check(
        formulas.covariance_step,
        function=covariance_of_step,
        arguments=(theta, D_L, D_R, b, noise, covariance_entries),
        tolerance=2e-14,
        reason="some fifty roundings of numbers up to 1; s: the chord, g: what a metre more of a "
        "wheel adds to the pose, q: the variances of the wheels' travel",
        specials=(SAME, OPPOSITE, STILL, {**SAME, noise: 0.0}, NEARLY_SAME),
    ),
    Check(
        formulas.ellipse_axes,
        function=half_axes,
        arguments=(p_xx, p_xy, p_yy),
        ranges={p_xx: (0.05, 0.1), p_yy: (0.05, 0.1), p_xy: (-0.04, 0.04)},
        tolerance=2e-15,
        reason="a few roundings; m: half the sum of the variances, d: what the axes differ by",
        specials=({p_xx: 0.1, p_xy: 0.0, p_yy: 0.1}, {p_xx: 0.05, p_xy: 0.0, p_yy: 0.1}),
    ),
    Check(
        formulas.calibration_angles,
        function=angles_of_ends,
        arguments=((x_cw, y_cw), (x_ccw, y_ccw), side),
        tolerance=2e-14,
        reason="the swing is found back from a ratio near 1, times side / wheel distance = 5",
        specials=({x_cw: 0.0, y_cw: 0.0, x_ccw: 0.0, y_ccw: 0.0},),
    ),
    Check(
        formulas.calibration,
        function=calibration_of_angles,
        arguments=(short_turn, side_swing, b, side),
        tolerance=2e-15,
        reason="a few roundings of numbers up to 1.15",
        specials=({short_turn: 0.0, side_swing: 0.0}, {short_turn: 0.0}, {side_swing: 0.0}),
    ),
)
