"""Programs that students write on the differential drive."""

from dataclasses import replace

import numpy as np
from sympy import Symbol

from book import things
from book.differential_drive.exercises import (
    degrees_taken,
    double_distance,
    half_wheel_distance,
    world_to_robot,
)
from book.differential_drive.formulas import b, body_twist, r, rate_L, rate_R
from book.motion.formulas import arc_step, dt, omega, theta, v, x, y
from courseware.answers import Unknown
from courseware.figures import Arrow, Curve, Point
from courseware.programs.program import Program
from robokin import differential_drive, motion

RATES = (Unknown("left rate", "rad/s"), Unknown("right rate", "rad/s"))
VELOCITY = (Unknown("ẋ", "m/s"), Unknown("ẏ", "m/s"), Unknown("ω", "rad/s"))
ROBOT = {r: (0.02, 0.1), b: (0.1, 0.5)}


def by_mistakes(function, *names, mistakes=(half_wheel_distance,)):
    """Return a function of these arguments by each mistake."""

    def made(mistake):
        wrong = mistake.formula.wrap(function)
        return lambda *given: wrong(**dict(zip(names, given, strict=True)))

    return {mistake: made(mistake) for mistake in mistakes}


def with_whole_distance(function):
    """Return a function of arguments of which the fourth is the wheel distance, doubled."""
    return lambda *given: function(*given[:3], 2 * given[3], *given[4:])


WHOLE = "when each wheel gets ωb more or less than v, where it is ωb/2"


def robot(pose, distance, look=""):
    """Draw a robot of any wheel distance."""
    return replace(things.robot(pose, look=look), size=distance / 0.1)


def drive(rates, seconds, radius, distance):
    """Return the pose after a drive from the origin, of symbols."""
    given = {rate_L: rates[0], rate_R: rates[1], r: radius, b: distance}
    v_made, _, omega_made = body_twist.substitute(given)
    return arc_step.substitute({x: 0, y: 0, theta: 0, v: v_made, omega: omega_made, dt: seconds})


# --- p1 --------------------------------------------------------------------------------------


def arc_rates(place, dt, r, b, *, part=1.0, way=lambda chord, half: chord / np.sinc(half / np.pi)):
    """Return the rates of an arc to a place; the part of its turn, and its length by the chord."""
    half, chord = np.arctan2(place[1], place[0]), np.hypot(*place)
    return differential_drive.wheel_rates(way(chord, half) / dt, part * 2 * half / dt, r, b)


def draw_place(right, answer, place, dt, r, b):
    poses = (drive(rates, dt, r, b) for rates in (right, answer))
    part = Symbol("part", real=True)
    return (
        robot((0, 0, 0), b, "ghost"),
        Curve("path", drive(right, part * dt, r, b), part, 0, 1),
        Curve("error", drive(answer, part * dt, r, b), part, 0, 1),
        *map(robot, poses, (b, b), ("", "wrong")),
        Point("target", place),
    )


PLACE_TEXT = (
    "You can compute where the robot will be. Go back: which wheel rates bring P to a given place "
    "in the time dt, on one arc? The place is seen from the robot as it stands at the start. "
    "Places straight ahead, almost straight ahead, at the robot's side and behind it must work, "
    "too, but none straight behind. Several arcs lead there, forwards or backwards: each is right "
    "that does not go round more than once."
)
PLACE = '''\
def rates_to(place, dt, r, b):
    """Return the wheel rates [left, right] in rad/s that bring P to a place.

    place: array of x, y [m], x ahead of P and y to its left; dt: time [s];
    r: wheel radius [m]; b: wheel distance [m].
    """
    ...
'''
PLACE_HINTS = (
    "The straight line from the robot to the place is the chord of the arc. What do its length "
    "and its direction tell?",
    "The chord points along the middle heading, and that is half of the whole turn. So first find "
    "the turn, and with it ω.",
    "With u = np.arctan2(y, x), ω is 2u/dt. The arc is longer than the chord: v is the length of "
    "the chord over dt sin(u)/u, where sin(u)/u is np.sinc(u / np.pi). The wheels have v ± ω b/2.",
)
PLACE_SOLUTION = """\
def rates_to(place, dt, r, b):
    x, y = place
    half = np.arctan2(y, x)  # the chord points along the middle heading
    v = np.hypot(x, y) / (dt * np.sinc(half / np.pi))
    omega = 2 * half / dt
    return np.array([(v - omega * b / 2) / r, (v + omega * b / 2) / r])
"""
PLACE_SPECIALS = {
    "straight ahead": {x: 0.7, y: 0.0},
    "almost straight ahead": {x: 0.7, y: 1e-9},
    "behind, to the left": {x: -0.4, y: 0.5},
    "at the side": {x: 0.0},
}
PLACE_SLIPS = {
    "when the turn is taken to be the direction of the place: it is twice that": lambda *given: (
        arc_rates(*given, part=0.5, way=lambda chord, half: chord / np.sinc(half / 2 / np.pi))
    ),
    "when the robot turns only as far as the chord does: half of the turn is missing": (
        lambda *given: arc_rates(*given, part=0.5)
    ),
    "when the way is as long as the chord: the arc is longer": lambda *given: arc_rates(
        *given, way=lambda chord, half: chord
    ),
    "when np.sinc gets the angle itself: NumPy's sinc has π inside": lambda *given: arc_rates(
        *given, way=lambda chord, half: chord / np.sinc(half)
    ),
    "for the speeds of the wheels; the division by r is missing": lambda place, dt, r, b: (
        r * arc_rates(place, dt, r, b)
    ),
    "with x and y exchanged in arctan2: y comes first": lambda place, *given: arc_rates(
        place[::-1], *given
    ),
    "when it takes one second, whatever dt is": lambda place, dt, r, b: arc_rates(place, 1, r, b),
}

differential_drive_p1 = Program(
    "differential-drive-p1",
    title="To a place",
    text=PLACE_TEXT,
    starter=PLACE,
    symbols=(x, y, dt, r, b),
    arguments=lambda x, y, dt, r, b: ([x, y], dt, r, b),
    ranges=ROBOT | {dt: (0.5, 5)},
    when=lambda x, y, *_: x > -2 * abs(y),
    specials=PLACE_SPECIALS,
    answer=RATES,
    right=arc_rates,
    picture=draw_place,
    extent=0.08,
    compared_value=lambda rates, place, *robot: drive(rates, *robot)[:2],
    wrong=by_mistakes(arc_rates, "place", "dt", "r", "b"),
    likely_slips=PLACE_SLIPS | {WHOLE: with_whole_distance(arc_rates)},
    hints=PLACE_HINTS,
    solution=PLACE_SOLUTION,
)


# --- p2 --------------------------------------------------------------------------------------


def slowed(v, omega, r, b, top, *, largest=lambda rates: np.abs(rates).max(), above=1.0):
    """Return rates that are slowed down by one factor, where the largest is above the top rate."""
    rates = differential_drive.wheel_rates(v, omega, r, b)
    size = largest(rates)
    return rates * (top / size if size > above * top else 1.0)


def only_speed(v, omega, r, b, top):
    """Return rates of which v alone was slowed down."""
    largest = np.abs(differential_drive.wheel_rates(v, omega, r, b)).max()
    return differential_drive.wheel_rates(v * min(1, top / largest), omega, r, b)


def cut(v, omega, r, b, top):
    """Return rates of which each is cut off at the top rate alone."""
    return np.clip(differential_drive.wheel_rates(v, omega, r, b), -top, top)


def draw_limit(right, answer, v, omega, r, b, top):
    """Draw where the robot is after half a second."""
    poses = (drive(rates, 0.5, r, b) for rates in (right, answer))
    return robot((0, 0, 0), b, "ghost"), *map(robot, poses, (b, b), ("", "wrong"))


LIMIT_TEXT = (
    "A motor has a top rate. Write a function that gives the wheel rates for a wanted speed and "
    "turning rate, and slows the robot down where a wheel would have to be faster than that: v and "
    "ω get smaller by the same factor, so that the path keeps its shape. Where both wheels are "
    "slow enough, nothing changes. At rest it must work, too, and wheels may turn backwards."
)
LIMIT = '''\
def safe_rates(v, omega, r, b, top):
    """Return the wheel rates [left, right] in rad/s, none of them above top.

    v [m/s] and omega [rad/s] are wanted; r: wheel radius [m];
    b: wheel distance [m]; top: the largest rate of a wheel [rad/s], positive.
    """
    ...
'''
LIMIT_HINTS = (
    "First compute both rates without a limit. Which of the two decides?",
    "The one that is larger, without its sign. Both rates are multiplied by the same factor.",
    "The factor is top over the larger absolute value, and never more than 1. Do not divide by "
    "the rates themselves: at rest they are 0. Divide both by np.maximum(1, largest / top).",
)
LIMIT_SOLUTION = """\
def safe_rates(v, omega, r, b, top):
    left, right = (v - omega * b / 2) / r, (v + omega * b / 2) / r
    largest = np.maximum(abs(left), abs(right))
    times = np.maximum(1, largest / top)  # as fast as allowed
    return np.array([left / times, right / times])
"""
LIMIT_SPECIALS = {
    "at rest": {v: 0.0, omega: 0.0},
    "straight ahead": {omega: 0.0},
    "on the spot": {v: 0.0},
    "one wheel at rest": {v: 0.25, omega: 1.0, b: 0.5},
}
LIMIT_SLIPS = {
    "when a wheel is cut off only where it turns forwards: the path gets another shape": (
        lambda v, omega, r, b, top: np.minimum(differential_drive.wheel_rates(v, omega, r, b), top)
    ),
    "for the speeds of the wheels; the division by r is missing": lambda v, omega, r, b, top: (
        slowed(v, omega, 1.0, b, top)
    ),
    "when only v is slowed down: the path gets another shape": only_speed,
    "when each wheel is cut off alone: the path gets another shape": cut,
    "when slow wheels are made faster, up to the top rate": lambda *given: slowed(*given, above=0),
    "when a wheel that turns backwards is never too fast": lambda *given: slowed(
        *given, largest=np.max
    ),
    "when the mean of the two wheels is held below the top rate": lambda *given: slowed(
        *given, largest=lambda rates: abs(rates.mean())
    ),
    "without a limit": lambda v, omega, r, b, top: differential_drive.wheel_rates(v, omega, r, b),
}

differential_drive_p2 = Program(
    "differential-drive-p2",
    title="Not too fast",
    text=LIMIT_TEXT,
    starter=LIMIT,
    symbols=(v, omega, r, b, rate_R),
    ranges=ROBOT | {rate_R: (2, 20)},
    specials=LIMIT_SPECIALS,
    answer=RATES,
    right=slowed,
    picture=draw_limit,
    extent=0.08,
    wrong=by_mistakes(slowed, "v", "omega", "r", "b", "top"),
    likely_slips=LIMIT_SLIPS | {WHOLE: with_whole_distance(slowed)},
    hints=LIMIT_HINTS,
    solution=LIMIT_SOLUTION,
)


# --- p3 --------------------------------------------------------------------------------------


def moving(rate_L, rate_R, theta, r, b):
    """Return the velocity in the world."""
    return motion.to_world(theta, differential_drive.body_twist(rate_L, rate_R, r, b))


def draw_velocity(right, answer, rate_L, rate_R, theta, r, b):
    """Draw the velocity as the way of a second, and where the robot would look after it."""
    start = np.array([0, 0, theta])
    return (
        robot(start, b, "ghost"),
        robot(start + right, b),
        robot(start + answer, b, "wrong"),
        Arrow("velocity", (0, 0), right[:2]),
        Arrow("error", (0, 0), answer[:2]),
    )


WORLD_TEXT = (
    "This program computes the velocity of a robot from its wheel rates, as the world sees it: of "
    "P, the middle of its axle, along x and y, and the angular velocity. The program is wrong. "
    "Find the mistake, and mend it. At rest and on the spot it must work, too."
)
WORLD = '''\
def world_velocity(rate_L, rate_R, theta, r, b):
    """Return [x_dot, y_dot, omega] in the world, in m/s, m/s and rad/s.

    rate_L, rate_R: wheel rates [rad/s]; theta: heading [rad];
    r: wheel radius [m]; b: wheel distance [m].
    """
    v_L, v_R = r * rate_L, r * rate_R
    v = (v_L + v_R) / 2
    omega = (v_R - v_L) / b
    c, s = np.cos(theta), np.sin(theta)
    to_world = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return to_world @ [v, 0, omega]
'''
WORLD_HINTS = (
    "Which of the three numbers are wrong, and which are right?",
    "Try it with both wheels equally fast and the heading 90°: the robot drives up, along y. What "
    "does the program say?",
    "It says down. The matrix of the program leads from the world to the robot: the minus stands "
    "at the wrong sine.",
)
WORLD_SPECIALS = {
    "at rest": {rate_L: 0.0, rate_R: 0.0},
    "straight ahead": {rate_L: 3.0, rate_R: 3.0},
    "on the spot": {rate_L: -2.0, rate_R: 2.0},
    "with the heading 0": {theta: 0.0},
}
WORLD_SLIPS = {
    "with sine and cosine exchanged": lambda rate_L, rate_R, theta, r, b: moving(
        rate_L, rate_R, np.pi / 2 - theta, r, b
    ),
    "when the left and the right wheel are exchanged": lambda rate_L, rate_R, theta, r, b: moving(
        rate_R, rate_L, theta, r, b
    ),
    "when the heading is forgotten": lambda rate_L, rate_R, theta, r, b: moving(
        rate_L, rate_R, 0.0, r, b
    ),
}
WORLD_MISTAKES = by_mistakes(
    moving,
    "rate_L",
    "rate_R",
    "theta",
    "r",
    "b",
    mistakes=(half_wheel_distance, degrees_taken, world_to_robot, double_distance),
)

differential_drive_p3 = Program(
    "differential-drive-p3",
    title="Mend the velocity in the world",
    text=WORLD_TEXT,
    starter=WORLD,
    symbols=(rate_L, rate_R, theta, r, b),
    ranges=ROBOT,
    specials=WORLD_SPECIALS,
    answer=VELOCITY,
    right=moving,
    picture=draw_velocity,
    extent=0.08,
    wrong=WORLD_MISTAKES,
    likely_slips=WORLD_SLIPS,
    hints=WORLD_HINTS,
    solution=WORLD.replace("[c, s, 0], [-s, c, 0]", "[c, -s, 0], [s, c, 0]"),
)
