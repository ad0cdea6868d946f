"""How the library agrees with each formula of `formulas.py`."""

import numpy as np

from book.frames import formulas
from book.frames.formulas import (
    alpha,
    bc_turn,
    bc_x,
    bc_y,
    beta,
    bp_x,
    bp_y,
    db_turn,
    db_x,
    db_y,
    de_turn,
    de_x,
    de_y,
    error,
    fb_x,
    fb_y,
    fb_z,
    gamma,
    l_1,
    l_2,
    lever,
    pitch,
    roll,
    yaw,
)
from book.motion.formulas import theta
from courseware.equations import Array, Check
from robokin import euler, frames, planar_arm

QUARTERS = tuple(np.pi / 2 * np.arange(-2, 3))


def hand(joints: Array, lengths: Array) -> Array:
    """The pose of a frame at the third joint: where two links end, turned by all three angles."""
    there = planar_arm.forward(joints[..., :2], lengths)
    there[..., 2] += joints[..., 2]
    return there


def inverse(x: Array, y: Array, theta: Array) -> Array:
    """A planar pose seen from the other end."""
    return frames.pose(frames.inverse(frames.se2(x, y, theta)))


def seen_from(first: Array, second: Array) -> Array:
    """The second pose as seen from the first, both known from one place."""
    back = frames.inverse(frames.se2(*np.moveaxis(first, -1, 0)))
    return frames.pose(frames.compose(back, frames.se2(*np.moveaxis(second, -1, 0))))


def joined(first: Array, second: Array) -> Array:
    """Two poses in a chain."""
    return frames.pose(
        frames.compose(*(frames.se2(*np.moveaxis(each, -1, 0)) for each in (first, second)))
    )


def back_in_space(angles: Array, position: Array) -> Array:
    """The position part of the inverse of a pose in space."""
    return frames.inverse(frames.se3(euler.to_matrix("ZYX", angles), position))[..., :3, 3]


def seen_from_above(position: Array, heading: Array) -> Array:
    """A platform that stands upright, seen from a camera that looks straight down."""
    camera = frames.se3(np.diag([1.0, -1.0, -1.0]), np.zeros(3))  # seen from the room
    upright = euler.to_matrix("Z", heading[..., None])
    there = frames.transform(camera, position)  # the platform in the room
    return frames.compose(frames.inverse(camera), frames.se3(upright, there))


def named_anew(x: Array, y: Array, theta: Array, point: Array) -> Array:
    """Return a point of a frame as seen from where the frame's pose is seen from."""
    return frames.transform(frames.se2(x, y, theta), point)


def pole(x: Array, y: Array, theta: Array) -> Array:
    """Return the point that a pose leaves where it is, by a linear system."""
    T = frames.se2(x, y, theta)
    return np.asarray(np.linalg.solve(np.eye(2) - T[..., :2, :2], T[..., :2, 2:])[..., 0], float)


def turned_away(lever: Array, error: Array) -> Array:
    """How far a point moves when it is turned by an error."""
    point = np.stack([lever, 0 * lever], axis=-1)
    moved = frames.transform(frames.se2(0, 0, error), point)
    return np.hypot(moved[..., 0] - point[..., 0], moved[..., 1] - point[..., 1])


CHECKS = (
    Check(
        formulas.matrix,
        function=frames.se2,
        arguments=(db_x, db_y, db_turn),
        tolerance=3e-16,
        reason="one rounding of a sine or cosine",
        specials=tuple({db_turn: quarter} for quarter in QUARTERS),
    ),
    Check(
        formulas.point,
        function=named_anew,
        arguments=(db_x, db_y, db_turn, (bp_x, bp_y)),
        tolerance=2e-15,
        reason="two products and two sums of sizes up to 4, each rounded once",
        specials=({bp_x: 0.0, bp_y: 0.0}, *({db_turn: quarter} for quarter in QUARTERS)),
    ),
    Check(
        formulas.pole,
        function=pole,
        arguments=(db_x, db_y, db_turn),
        tolerance=1e-12,
        reason="at 0.2 rad a linear system with a condition of 10, numbers up to 20 m",
        ranges={db_turn: (0.2, 3.1)},
        specials=({db_turn: np.pi}, {db_turn: -np.pi / 2}),
    ),
    Check(
        formulas.hand_pose,
        function=hand,
        arguments=((alpha, beta, gamma), (l_1, l_2)),
        tolerance=4e-15,
        reason="the sum of angles up to 9.4 rad rounded, and numbers up to 2 m made of it",
        specials=({alpha: 0.0, beta: 0.0, gamma: 0.0}, {beta: np.pi}, {alpha: np.pi, beta: -np.pi}),
    ),
    Check(
        formulas.turned_round,
        function=inverse,
        arguments=(db_x, db_y, db_turn),
        tolerance=2e-15,
        reason="sine, cosine, two products and a sum, each rounded once, of sizes up to 2",
        specials=({db_x: 0.0, db_y: 0.0}, *({db_turn: quarter} for quarter in QUARTERS)),
    ),
    Check(
        formulas.inverse_in_space,
        function=back_in_space,
        arguments=((yaw, pitch, roll), (fb_x, fb_y, fb_z)),
        tolerance=4e-15,
        reason="a matrix of three turns, then three products and two sums, of sizes up to 5",
        specials=({yaw: 0.0, pitch: 0.0, roll: np.pi}, {pitch: np.pi / 2}),
    ),
    Check(
        formulas.object_seen,
        function=seen_from,
        arguments=((db_x, db_y, db_turn), (de_x, de_y, de_turn)),
        tolerance=5e-15,
        reason="two differences of numbers up to 2 turned, each step rounded, of sizes up to 6",
        specials=({de_x: 0.0, de_y: 0.0, de_turn: 0.0}, *({db_turn: q} for q in QUARTERS)),
    ),
    Check(
        formulas.chained,
        function=joined,
        arguments=((db_x, db_y, db_turn), (bc_x, bc_y, bc_turn)),
        tolerance=5e-15,
        reason="two products and two sums, each rounded once, of sizes up to 6",
        specials=({bc_x: 0.0, bc_y: 0.0}, *({db_turn: quarter} for quarter in QUARTERS)),
    ),
    Check(
        formulas.looking_down,
        function=seen_from_above,
        arguments=((fb_x, fb_y, fb_z), theta),
        tolerance=3e-16,
        reason="one rounding of a sine or cosine",
        specials=tuple({theta: quarter} for quarter in QUARTERS),
    ),
    Check(
        formulas.miss,
        function=turned_away,
        arguments=(lever, error),
        tolerance=2e-15,
        reason="the difference of two points up to 5 m away, rounded once each",
        specials=({error: 0.0}, {lever: 0.0}),
    ),
)
