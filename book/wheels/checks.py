"""How the library agrees with each formula of `formulas.py`."""
# ruff: noqa: E741  (l is the field's own name)

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from book.differential_drive.formulas import r
from book.motion.checks import QUARTERS
from book.motion.formulas import omega, theta, v, v_y
from book.wheels import formulas
from book.wheels.formulas import (
    alpha,
    beta,
    d,
    gamma,
    l,
    omni_rate4,
    omni_rates,
    rank_fixed,
    rank_steered,
    rate1,
    rate2,
    rate3,
    x_Q,
    y_Q,
)
from courseware.equations import Array, Check
from robokin import wheels

AT_CENTRE, ON_SPOKE = {l: 0.0}, {beta: 0.0}
LEFT_WHEEL, RIGHT_WHEEL = {alpha: np.pi / 2, beta: 0.0}, {alpha: -np.pi / 2, beta: np.pi}
APART = {l: (0.05, 1.0)}
ALIKE, SIDEWAYS, AHEAD = (
    dict(zip(omni_rates, rates, strict=True)) for rates in ([2, 2, 2], [-4, 2, 2], [0, 3, -3])
)
PLACES = (AT_CENTRE, ON_SPOKE, LEFT_WHEEL, RIGHT_WHEEL)


def times(
    rows: Callable[..., Array], make: Callable[..., wheels.Wheel], places: Array, twists: Array
) -> Array:
    """For many wheels: the row of each (`rolling`, `sliding`) times a twist of its own."""
    pairs = zip(places, twists, strict=True)
    return np.array([rows([make(*place)])[0] @ twist for place, twist in pairs])


def a_fixed_wheel(l: float, alpha: float, beta: float) -> wheels.Wheel:
    """A wheel of radius 1 m: what it rolls in a second is its rate."""
    return wheels.fixed(l, alpha, beta, 1.0)


def a_swedish_wheel(l: float, alpha: float, beta: float, gamma: float) -> wheels.Wheel:
    """The same with rollers."""
    return wheels.swedish(l, alpha, beta, 1.0, gamma)


def rolled(places: Array, twists: Array) -> Array:
    """What a wheel of radius 1 m rolls in a second: its row times the twist."""
    return times(wheels.rolling, a_fixed_wheel, places, twists)


def slid(places: Array, twists: Array) -> Array:
    """What a wheel would slide along its axle: its row times the twist."""
    return times(wheels.sliding, a_fixed_wheel, places, twists)


def swedish_rolled(places: Array, twists: Array) -> Array:
    """What a Swedish wheel of radius 1 m rolls in a second: its row times the twist."""
    return times(wheels.rolling, a_swedish_wheel, places, twists)


def hub_velocity(l: Array, alpha: Array, twists: Array) -> Array:
    """A wheel whose axle points along the body's y axis rolls along x and slides along y."""
    places = np.stack([l, alpha, np.pi / 2 - alpha], axis=-1)
    return np.stack([rolled(places, twists), slid(places, twists)], axis=-1)


def turn_about(centres: Array) -> Array:
    """The twist of a turn at 1 rad/s about a centre in the robot's frame."""
    x, y = centres[..., 0], centres[..., 1]
    return np.stack([y, -x, np.ones_like(x)], axis=-1)


def slid_by_turn(places: Array, centres: Array, omega: Array) -> Array:
    """What a wheel would slide in a turn at 1 rad/s about a centre, and at another rate."""
    twists = turn_about(centres)
    return np.stack([slid(places, twists), slid(places, omega[..., None] * twists)], axis=-1)


def rolled_by_turn(places: Array, centres: Array, omega: Array, r: Array) -> Array:
    """What a wheel of 1 m rolls in a turn at 1 rad/s, and the rate of another in the turn asked."""
    twists, turns = turn_about(centres), omega[..., None] * turn_about(centres)
    made = [wheels.swedish(a, b, c, size, d) for (a, b, c, d), size in zip(places, r, strict=True)]
    rates = [wheels.inverse([wheel], turn)[0] for wheel, turn in zip(made, turns, strict=True)]
    return np.stack([swedish_rolled(places, twists), np.array(rates)], axis=-1)


def plainly_rolled_by_turn(places: Array, centres: Array, omega: Array, r: Array) -> Array:
    """The same of fixed wheels."""
    twists, turns = turn_about(centres), omega[..., None] * turn_about(centres)
    made = [wheels.fixed(a, b, c, size) for (a, b, c), size in zip(places, r, strict=True)]
    rates = [
        wheels.inverse([wheel], turn, slipping="ignore")[0]
        for wheel, turn in zip(made, turns, strict=True)
    ]
    return np.stack([rolled(places, twists), np.array(rates)], axis=-1)


def omni_inverse(l: Array, r: Array, twists: Array) -> Array:
    """The rates of omni robots' wheels."""
    rows = zip(l, r, twists, strict=True)
    return np.array([wheels.inverse(wheels.omni_robot(a, b), twist) for a, b, twist in rows])


def castor_slid(l: Array, alpha: Array, beta: Array, d: Array, twists: Array) -> Array:
    """What a castor would slide if it did not turn: a fixed wheel at its contact point."""
    x = l * np.cos(alpha) + d * np.sin(alpha + beta)
    y = l * np.sin(alpha) - d * np.cos(alpha + beta)
    there = np.arctan2(y, x)
    return slid(np.stack([np.hypot(x, y), there, alpha + beta - there], axis=-1), twists)


def omni_speeds(l: Array, twists: Array) -> Array:
    """What the wheels of omni robots roll in a second."""
    pairs = zip(l, twists, strict=True)
    return np.array([wheels.inverse(wheels.omni_robot(size, 1.0), twist) for size, twist in pairs])


def omni_motion(l: Array, r: Array, rates: Array, theta: ArrayLike = 0.0) -> Array:
    """The velocity of omni robots in the world."""
    rows = zip(l, r, rates, np.broadcast_to(theta, l.shape), strict=True)
    return np.array([wheels.forward(wheels.omni_robot(a, b), c, None, e) for a, b, c, e in rows])


def turned_determinant(l: Array, beta: Array) -> Array:
    """The determinant of an omni robot's rows, its axles turned away from the spokes."""
    thirds = 2 * np.pi / 3 * np.arange(3)
    rows = [
        wheels.rolling([wheels.swedish(size, spoke, turn, 1.0, 0) for spoke in thirds])
        for size, turn in zip(l, beta, strict=True)
    ]
    return np.asarray(np.linalg.det(np.array(rows)))


def mecanum_slips(r: Array, rates: Array) -> Array:
    """How much faster wheel 1 of a Mecanum robot is moved than it drives."""
    places = ((0.2, 0.15, -1), (0.2, -0.15, 1), (-0.2, 0.15, 1), (-0.2, -0.15, -1))
    found = []
    for radius, each in zip(r, rates, strict=True):
        robot = []
        for x, y, side in places:
            spoke = np.arctan2(y, x)
            made = (np.hypot(x, y), spoke, np.pi / 2 - spoke, radius, side * np.pi / 4)
            robot.append(wheels.swedish(*made))
        found.append(wheels.slip(robot, each)[0])
    return np.array(found)


def mobility_of(rank_fixed: Array, rank_steered: Array) -> Array:
    """Of robots with as many fixed and steered wheels, no two alike, in the formula's order."""
    found = []
    for fixed, steered in zip(rank_fixed, rank_steered, strict=True):
        robot = [wheels.fixed(1.0, 2.0 * k, 1.0, 1.0) for k in range(round(fixed))]
        robot += [wheels.steered(1.0, 2.0 * k, 1.0, 1.0) for k in range(round(steered))]
        answer = wheels.mobility(robot)
        found.append([answer.delta_s, answer.delta_m, answer.delta_M])
    return np.array(found)


CHECKS = (
    Check(
        formulas.hub,
        function=hub_velocity,
        arguments=(l, alpha, (v, v_y, omega)),
        tolerance=2e-14,
        reason="sines, cosines, products and sums, each rounded once, of sizes up to 7",
        specials=(AT_CENTRE, {omega: 0.0}, *({alpha: k * np.pi / 2} for k in (-1, 1, 2))),
    ),
    Check(
        formulas.rolling,
        function=rolled,
        arguments=((l, alpha, beta), (v, v_y, omega)),
        tolerance=1e-14,
        reason="the angle, sines, cosines, products and sums, each rounded once, of sizes up to 8",
        specials=PLACES,
    ),
    Check(
        formulas.sliding,
        function=slid,
        arguments=((l, alpha, beta), (v, v_y, omega)),
        tolerance=1e-14,
        reason="as wheels.rolling",
        specials=PLACES,
    ),
    Check(
        formulas.sliding_by_distance,
        function=slid_by_turn,
        arguments=((l, alpha, beta), (x_Q, y_Q), omega),
        tolerance=2e-14,
        reason="as wheels.rolling",
        specials=(*PLACES, {omega: 0.0}, {x_Q: 0.0, y_Q: 0.0}),
    ),
    Check(
        formulas.rolling_by_distance,
        function=plainly_rolled_by_turn,
        arguments=((l, alpha, beta), (x_Q, y_Q), omega, r),
        ranges={r: (0.1, 0.5)},
        tolerance=1e-12,
        reason="as wheels.rolling; rates up to 500 rad/s",
        specials=(*PLACES, {omega: 0.0}, {x_Q: 0.0, y_Q: 0.0}),
    ),
    Check(
        formulas.swedish_by_distance,
        function=rolled_by_turn,
        arguments=((l, alpha, beta, gamma), (x_Q, y_Q), omega, r),
        ranges={r: (0.1, 0.5), gamma: (-1.2, 1.2)},
        tolerance=1e-12,
        reason="as wheels.rolling; rates up to 500 rad/s",
        specials=(*PLACES, {omega: 0.0}, {gamma: 0.0}, {x_Q: 0.0, y_Q: 0.0}),
    ),
    Check(
        formulas.omni_wheel_rates,
        function=omni_inverse,
        arguments=(l, r, (v, v_y, omega)),
        ranges=APART | {r: (0.1, 0.5)},
        tolerance=1e-13,
        reason="as wheels.omni_rolling; rates up to 80 rad/s",
        specials=({omega: 0.0}, {v: 0.0, v_y: 0.0}),
    ),
    Check(
        formulas.castor,
        function=castor_slid,
        arguments=(l, alpha, beta, d, (v, v_y, omega)),
        tolerance=2e-14,
        reason="as wheels.rolling, through the contact point's place",
        specials=(ON_SPOKE, LEFT_WHEEL, RIGHT_WHEEL),
    ),
    Check(
        formulas.swedish,
        function=swedish_rolled,
        arguments=((l, alpha, beta, gamma), (v, v_y, omega)),
        tolerance=2e-14,
        reason="as wheels.rolling",
        specials=(*PLACES, {gamma: 0.0}, {gamma: np.pi / 4}),
    ),
    Check(
        formulas.omni_rolling,
        function=omni_speeds,
        arguments=(l, (v, v_y, omega)),
        tolerance=1e-14,
        reason="sines of 120°, products and sums, each rounded once, of sizes up to 8",
        specials=({omega: 0.0}, {v: 0.0, v_y: 0.0}, AT_CENTRE),
    ),
    Check(
        formulas.omni_twist,
        function=omni_motion,
        arguments=(l, r, (rate1, rate2, rate3)),
        ranges=APART,
        tolerance=1e-12,
        reason="a matrix inverted numerically; rates of turning up to 200 rad/s",
        specials=(ALIKE, SIDEWAYS, AHEAD),
    ),
    Check(
        formulas.omni_world,
        function=omni_motion,
        arguments=(l, r, (rate1, rate2, rate3), theta),
        ranges=APART,
        tolerance=1e-12,
        reason="as wheels.omni_twist",
        specials=(ALIKE, SIDEWAYS, AHEAD, *QUARTERS),
    ),
    Check(
        formulas.omni_determinant,
        function=turned_determinant,
        arguments=(l, beta),
        tolerance=1e-14,
        reason="sines, cosines, products and sums, each rounded once, of sizes up to 3",
        specials=(ON_SPOKE, AT_CENTRE, {beta: np.pi / 2}),
    ),
    Check(
        formulas.mecanum_slip,
        function=mecanum_slips,
        arguments=(r, (rate1, rate2, rate3, omni_rate4)),
        tolerance=1e-12,
        reason="a matrix inverted numerically; speeds up to 10 m/s",
        specials=(dict.fromkeys((rate1, rate2, rate3, omni_rate4), 2.0),),
    ),
    Check(
        formulas.mobility,
        function=mobility_of,
        arguments=(rank_fixed, rank_steered),
        integers=(rank_fixed, rank_steered),
        tolerance=1e-12,
        reason="whole numbers",
    ),
)
