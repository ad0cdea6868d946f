"""How the library agrees with each formula of `formulas.py`."""

import numpy as np
from numpy.typing import ArrayLike

from book.basics.formulas import p_x, p_y
from book.elbow_arm import formulas
from book.elbow_arm.formulas import (
    a2,
    a3,
    along,
    apart,
    aside,
    d1,
    dh_a,
    dh_alpha,
    dh_d,
    dh_theta,
    high,
    out,
    p_z,
    theta1,
    theta2,
    theta3,
)
from book.motion.formulas import v
from courseware.equations import Array, Check
from robokin import elbow_arm, euler, frames, motion

THETA = (theta1, theta2, theta3)
LONG = 3.0  # m, links of an arm that reaches any point that is drawn
STRETCHED = {a2: 0.5, a3: 0.25, apart: 0.75}
FOLDED = ({a2: 0.5, a3: 0.25, apart: 0.25}, {a2: 0.25, a3: 0.5, apart: 0.25})
WITHIN_REACH = {p_x: (0.25, 0.35), p_y: (0.1, 0.25)}  # whatever the height and the links


def all_four(out: Array, high: Array, a2: ArrayLike, a3: ArrayLike) -> Array:
    """The answers for a wrist ahead of the base, measured from the shoulder."""
    return elbow_arm.inverse(np.stack([out, 0 * out, high], axis=-1), a2, a3)


def base_turns(p: Array) -> Array:
    """The two turns of the base: facing the target, and away from it."""
    return elbow_arm.inverse(p, LONG, LONG)[..., [0, 2], 0]


def seen_from_the_side(p: Array, d1: Array) -> Array:
    """Out and up from the shoulder, once the base is turned back, and out if it lies level."""
    theta = elbow_arm.inverse(p, LONG, LONG, d1)[..., 0, :]
    out, _, high = np.moveaxis(elbow_arm.forward(theta * [0, 1, 1], LONG, LONG), -1, 0)
    level = theta * [0, 0, 1] - [0, 0.5, 0] * theta[..., 2:]  # links alike: the elbow in the middle
    return np.stack([out, high, elbow_arm.forward(level, LONG, LONG)[..., 0]], axis=-1)


def triangle_of(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """The angle at the shoulder, at the elbow, and the rise of the line to the wrist."""
    up, down = np.moveaxis(all_four(out, high, a2, a3)[..., :2, :], -2, 0)
    lift, rise = (up[..., 1] - down[..., 1]) / 2, (up[..., 1] + down[..., 1]) / 2
    return np.stack([lift, np.pi - down[..., 2], rise], axis=-1)


def bends(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta2, theta3 with the elbow up, then down."""
    return all_four(out, high, a2, a3)[..., :2, 1:].reshape(*out.shape, 4)


def cosine_of_elbow(p: Array, a2: Array, a3: Array) -> Array:
    """The cosine of theta3, the same in all four answers."""
    return np.cos(elbow_arm.inverse(p, a2, a3)[..., 0, 2])


def elbows(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta3, the positive one first."""
    return all_four(out, high, a2, a3)[..., [1, 0], 2]


def shoulder(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta2 for a positive theta3, facing."""
    return all_four(out, high, a2, a3)[..., 1, 1]


def shoulder_away(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta2 for a positive theta3, facing away."""
    return all_four(out, high, a2, a3)[..., 2, 1]


def lift_and_elbow(apart: Array, a2: Array, a3: Array) -> Array:
    """The angle at the shoulder and theta3, both positive or zero."""
    level = all_four(apart, 0 * apart, a2, a3)
    return np.stack([level[..., 0, 1], level[..., 1, 2]], axis=-1)


def turned_round(theta: Array, a2: Array, a3: Array) -> Array:
    """The answer that faces away, from one that faces the target with its elbow down."""
    return elbow_arm.inverse(elbow_arm.forward(theta, a2, a3), a2, a3)[..., 3, :]


def limits(a2: Array, a3: Array) -> Array:
    """The smallest and the largest distance from shoulder to wrist."""
    return np.stack(elbow_arm.reach(a2, a3), axis=-1)


def wrist_frame(theta: Array, a2: Array, a3: Array, d1: Array) -> Array:
    """The wrist's pose: turned as by three Euler angles, placed as `forward` says."""
    quarter = np.full_like(theta[..., 0], np.pi / 2)
    turns = np.stack([theta[..., 0], quarter, theta[..., 1] + theta[..., 2]], axis=-1)
    return frames.se3(euler.to_matrix("ZXZ", turns), elbow_arm.forward(theta, a2, a3, d1))


def in_plane(theta: Array, a2: Array, a3: Array) -> Array:
    """The wrist from the shoulder, ahead and up, where the base is not turned."""
    return elbow_arm.forward(theta * [0, 1, 1], a2, a3)[..., [0, 2]]


STEP = 1e-5  # rad, of differences


def determinant(theta: Array, a2: Array, a3: Array) -> Array:
    """The determinant of how the wrist moves with each joint, by differences."""
    steps = STEP * np.eye(3)
    links = a2[..., None], a3[..., None]
    ends = [elbow_arm.forward(theta[..., None, :] + way, *links) for way in (steps, -steps)]
    found: Array = np.linalg.det((ends[0] - ends[1]) / (2 * STEP))
    return found


def base_rate(v: Array, aside: Array, along: Array) -> Array:
    """The rate of joint 1 on a line beside the base axis: the velocity across, by the distance."""
    turn = base_turns(np.stack([aside, along, 0 * along], axis=-1))[..., 0]
    across = motion.to_body(turn, np.stack([0 * v, v, 0 * v], axis=-1))[..., 1]
    return across / np.hypot(aside, along)


CHECKS = (
    Check(
        formulas.plane,
        function=in_plane,
        arguments=(THETA, a2, a3),
        tolerance=1e-15,
        reason="as forward",
        specials=({theta2: 0.0, theta3: 0.0}, {theta3: np.pi}),
    ),
    Check(
        formulas.determinant,
        function=determinant,
        arguments=(THETA, a2, a3),
        tolerance=2e-10,
        reason="differences over 2e-5 rad: h²/6 and a rounding of the wrist divided by h",
        specials=({theta3: 0.0}, {theta3: np.pi}, {theta2: np.pi / 2, theta3: 0.0}),
    ),
    Check(
        formulas.base_rate,
        function=base_rate,
        arguments=(v, aside, along),
        tolerance=1e-13,
        reason="a few roundings of rates up to 50 rad/s",
        specials=({along: 0.0},),
    ),
    Check(
        formulas.forward,
        function=elbow_arm.forward,
        arguments=(THETA, a2, a3, d1),
        tolerance=1e-15,
        reason="a rounding of the angles' sum (up to 6 rad) and some of lengths up to 1.4 m",
        specials=({theta2: 0.0, theta3: 0.0}, {theta1: np.pi / 2, theta3: np.pi}),
    ),
    Check(
        formulas.base,
        function=base_turns,
        arguments=((p_x, p_y, p_z),),
        tolerance=1e-15,
        reason="two roundings of numbers up to 2 pi",
        specials=({p_x: 0.0, p_y: 0.0}, {p_x: -1.0, p_y: 0.0}, {p_x: -1.0, p_y: -1.0}),
    ),
    Check(
        formulas.side,
        function=seen_from_the_side,
        arguments=((p_x, p_y, p_z), d1),
        tolerance=2e-14,
        reason="through joint angles up to pi and back, of an arm of 6 m",
        specials=({p_x: 0.0, p_y: 0.0}, {p_x: -1.0, p_y: 0.0}),
    ),
    Check(
        formulas.triangle,
        function=triangle_of,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="roundings of angles up to pi, and of d (5e-17 m) times at most 1/0.1 m",
        specials=({high: 0.0},),
    ),
    Check(
        formulas.first_way,
        function=bends,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="as triangle",
        specials=({high: 0.0},),
    ),
    Check(
        formulas.cosine,
        function=cosine_of_elbow,
        arguments=((p_x, p_y, high), a2, a3),
        ranges=WITHIN_REACH,
        tolerance=2e-15,
        reason="as triangle, and a cosine",
        specials=({high: 0.0},),
    ),
    Check(
        formulas.elbow,
        function=elbows,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="as triangle",
        specials=({high: 0.0},),
    ),
    *(
        Check(
            formula,
            function=function,
            arguments=(out, high, a2, a3),
            tolerance=2e-15,
            reason="as triangle",
            specials=({high: 0.0},),
        )
        for formula, function in (
            (formulas.shoulder, shoulder),
            (formulas.shoulder_away, shoulder_away),
        )
    ),
    Check(
        formulas.half_angles,
        function=lift_and_elbow,
        arguments=(apart, a2, a3),
        tolerance=5e-15,
        reason="roundings of angles up to pi and of the four lengths, at least 0.05 m",
        specials=(STRETCHED, *FOLDED),
    ),
    Check(
        formulas.away,
        function=turned_round,
        arguments=(THETA, a2, a3),
        ranges={theta2: (-0.5, 0.5), theta3: (0.1, 1.5)},
        tolerance=1e-14,
        reason="there and back; where the arm is nearly stretched (0.1 rad) ten times a rounding",
        specials=({theta1: 0.0}, {theta1: np.pi}),
    ),
    Check(
        formulas.reach,
        function=limits,
        arguments=(a2, a3),
        tolerance=2e-16,
        reason="one rounding of a number up to 1",
        specials=({a2: 0.4, a3: 0.4},),
    ),
    Check(
        formulas.nearest,
        function=elbow_arm.nearest_reachable,
        arguments=((p_x, p_y, p_z), a2, a3, d1),
        tolerance=2e-15,
        reason="a few roundings of lengths up to 3 m",
        specials=({p_x: 0.0, p_y: 0.0}, {p_x: 0.01, p_y: 0.01, p_z: 0.25, d1: 0.25}),
    ),
    Check(
        formulas.dh_step,
        function=frames.dh,
        arguments=(dh_theta, dh_d, dh_a, dh_alpha),
        tolerance=1e-15,
        reason="sines, cosines and products of sizes up to 1",
        specials=({dh_alpha: np.pi / 2}, {dh_alpha: 0.0}),
    ),
    Check(
        formulas.dh_wrist,
        function=wrist_frame,
        arguments=(THETA, a2, a3, d1),
        tolerance=2e-15,
        reason="as forward; the sum of two angles, rounded",
        specials=({theta1: 0.0, theta2: 0.0, theta3: 0.0},),
    ),
)
