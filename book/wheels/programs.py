"""Programs that students write on wheels and the omni robot."""
# ruff: noqa: E741  (l is the field's own name)

from dataclasses import replace

import numpy as np
from sympy import cos, pi, sin

from book import things
from book.differential_drive.formulas import r
from book.motion.formulas import omega, theta, to_world, v, v_y, x_dot, y_dot
from book.wheels.exercises import (
    THREE,
    cos_alpha,
    forward,
    forward_by,
    heading_for_beta,
    plus_l_cos,
    plus_sign,
    rates,
    rates_by,
    turned_back,
    ways,
    wrong_rows,
)
from book.wheels.formulas import alpha, beta, gamma, l, omni_rates, omni_twist
from courseware.answers import Unknown
from courseware.figures import Arrow
from courseware.programs.program import Program
from robokin import motion, wheels

RATES = tuple(Unknown(f"wheel {k}", "rad/s") for k in (1, 2, 3))
VELOCITY = (Unknown("ẋ", "m/s"), Unknown("ẏ", "m/s"), Unknown("ω", "rad/s"))
SIZES = {l: (0.1, 0.5), r: (0.02, 0.1)}
STILL = {x_dot: 0.0, y_dot: 0.0, omega: 0.0}
ON_SPOKES = {"alpha": THREE, "beta": 0.0}  # the places of the three wheels


def of_robot(function):
    """Return a function of the exercises' numbers, for the arguments of the first program."""
    return lambda wanted, theta, spoke, r: function(
        l=spoke, r=r, theta=theta, **dict(zip(("x_dot", "y_dot", "omega"), wanted, strict=True))
    )


def of_rates(function):
    """Return one for the arguments of the third program."""
    return lambda rates, theta, spoke, r: function(
        l=spoke, r=r, theta=theta, **dict(zip(("w_1", "w_2", "w_3"), rates, strict=True))
    )


def omni_robot(pose, spoke, look=""):
    """Draw the omni robot with spokes of any length."""
    return replace(things.omni_robot(pose, look=look), size=spoke / 0.18)


def draw_motion(right, answer, theta, spoke):
    """Draw a velocity in the world as the way of half a second."""
    start = np.array([0, 0, theta])
    return (
        omni_robot(start, spoke, "ghost"),
        omni_robot(start + right / 2, spoke),
        omni_robot(start + answer / 2, spoke, "wrong"),
        Arrow("velocity", (0, 0), right[:2] / 2),
        Arrow("error", (0, 0), answer[:2] / 2),
    )


# --- p1 --------------------------------------------------------------------------------------


def draw_wanted(right, answer, wanted, heading, spoke, radius):
    """Draw the motion that rates make."""
    made = dict(zip(omni_rates, answer, strict=True)) | {l: spoke, r: radius}
    twist = dict(zip((v, v_y, omega), omni_twist.substitute(made), strict=True))
    found = np.array(to_world.substitute(twist | {theta: heading})).ravel()
    return draw_motion(wanted, found, heading, spoke)


PLACED = (
    "(The three wheels of the omni robot are at α = 0°, 120° and 240°, counter-clockwise from the "
    "robot's x axis, each with its axle along its spoke. A positive rate rolls a wheel towards "
    "α − 90°.)"
)
OMNI_TEXT = (
    "You can tell the motion from the rates. Go back: which rates give a motion that is wanted in "
    "the world? The rolling rows of three wheels have all that you need. At rest, on the spot and "
    f"without a turn it must work, too. {PLACED}"
)
OMNI = '''\
def omni_rates(wanted, theta, spoke, r):
    """Return the rates of the omni robot's three wheels in rad/s.

    wanted: array of x_dot, y_dot [m/s] and omega [rad/s], in the world;
    theta: heading [rad]; spoke: from the centre to a wheel [m]; r: radius of
    a wheel [m].
    """
    ...
'''
OMNI_HINTS = (
    "The rolling rows know the motion in the body frame only. What comes first?",
    "First turn x_dot and y_dot from the world to the robot. Then each wheel has its row: "
    "sin α, −cos α and −spoke, times forward speed, sideways speed and angular velocity.",
    "Forward speed is cos θ x_dot + sin θ y_dot, sideways speed is −sin θ x_dot + cos θ y_dot. Row "
    "times motion is how fast a wheel rolls, in m/s; over r it is the rate.",
)
OMNI_SOLUTION = """\
def omni_rates(wanted, theta, spoke, r):
    x_dot, y_dot, omega = wanted
    c, s = np.cos(theta), np.sin(theta)
    ahead, left = c * x_dot + s * y_dot, c * y_dot - s * x_dot
    at = np.radians([0, 120, 240])
    rolls = [np.sin(a) * ahead - np.cos(a) * left - spoke * omega for a in at]
    return np.array(rolls) / r
"""
OMNI_SPECIALS = {
    "at rest": STILL,
    "on the spot": {x_dot: 0.0, y_dot: 0.0},
    "without a turn": {omega: 0.0},
    "with the heading 0": {theta: 0.0},
}
OMNI_MISTAKES = {
    **ways(rates_by, plus_sign, heading_for_beta, plus_l_cos, cos_alpha, **ON_SPOKES),
    turned_back: turned_back.formula.wrap(rates),
}
OMNI_SLIPS = {
    "when the heading is forgotten": lambda theta, **numbers: rates(theta=0.0, **numbers),
    "for the speeds of the wheels; the division by r is missing": lambda r, **numbers: (
        r * rates(r=r, **numbers)
    ),
    "when wheels 2 and 3 are exchanged": lambda **numbers: rates(**numbers)[[0, 2, 1]],
    "when the turn of the robot is forgotten": lambda omega, **numbers: rates(omega=0.0, **numbers),
    "when the spoke is forgotten": lambda l, omega, **numbers: rates(l, omega=omega / l, **numbers),
}

wheels_p1 = Program(
    "wheels-p1",
    title="Drive the omni robot",
    text=OMNI_TEXT,
    starter=OMNI,
    symbols=(x_dot, y_dot, omega, theta, l, r),
    arguments=lambda x_dot, y_dot, omega, theta, l, r: ([x_dot, y_dot, omega], theta, l, r),
    ranges=SIZES,
    specials=OMNI_SPECIALS,
    answer=RATES,
    right=of_robot(rates),
    picture=draw_wanted,
    extent=0.26,
    wrong={mistake: of_robot(function) for mistake, function in OMNI_MISTAKES.items()},
    likely_slips={words: of_robot(function) for words, function in OMNI_SLIPS.items()},
    hints=OMNI_HINTS,
    solution=OMNI_SOLUTION,
)


# --- p2 --------------------------------------------------------------------------------------


def swedish(twist, l, alpha, beta, gamma, r):
    """Return the rate of a Swedish wheel."""
    return wheels.inverse([wheels.swedish(l, alpha, beta, r, gamma)], twist)[0]


def swedish_by(mistake):
    """Return the rate by a mistake in the rolling row, which is turned by gamma."""
    return lambda twist, l, alpha, beta, gamma, r: (
        wrong_rows(mistake, l, alpha, beta + gamma, 0.0)[0] @ twist / (r * np.cos(gamma))
    )


def draw_wheel(right, answer, twist, spoke, alpha, beta, gamma, r):
    """Draw how far the wheel rolls in a second, along its rolling direction."""
    x, y, way = spoke * cos(alpha), spoke * sin(alpha), alpha + beta - pi / 2
    ends = [(x + r * rate * cos(way), y + r * rate * sin(way)) for rate in (right, answer)]
    return (
        omni_robot((0, 0, 0), spoke, "ghost"),
        replace(things.wheel((x, y, way), 0.1, 0.04, "left2"), size=r / 0.05),
        Arrow("velocity", (x, y), ends[0]),
        Arrow("error", (x, y), ends[1]),
    )


SWEDISH_TEXT = (
    "A Swedish wheel is anywhere on a robot: α is the angle from the robot's x axis to its spoke, "
    "β from the spoke to its axle, and γ from the rolling direction, α + β − 90°, to the axis of "
    "its roller on the ground, all counter-clockwise. A positive rate rolls it in the rolling "
    "direction. How fast does it turn while the robot moves? With γ = 0 it must give the rate of "
    "the omni robot's wheels. (With γ = ±90° the wheel turns as it likes; this is not asked.)"
)
SWEDISH = '''\
def swedish_rate(twist, spoke, alpha, beta, gamma, r):
    """Return the rate of a Swedish wheel in rad/s.

    twist: array of v, v_y [m/s] and omega [rad/s], in the body frame;
    spoke: from the centre to the wheel [m]; alpha, beta, gamma [rad];
    r: radius of the wheel [m].
    """
    ...
'''
SWEDISH_HINTS = (
    "Begin with the rolling row of an ordinary wheel. What does γ change in it?",
    "All three entries of the row are turned by γ: put β + γ in place of β. And of the speed r "
    "times rate only a part counts.",
    "Row times twist equals r cos γ times the rate. The row is sin(α + β + γ), −cos(α + β + γ), "
    "−spoke cos(β + γ).",
)
SWEDISH_SOLUTION = """\
def swedish_rate(twist, spoke, alpha, beta, gamma, r):
    v, v_y, omega = twist
    along = alpha + beta + gamma
    rolls = np.sin(along) * v - np.cos(along) * v_y - spoke * np.cos(beta + gamma) * omega
    return rolls / (r * np.cos(gamma))
"""
SWEDISH_SPECIALS = {
    "with γ = 0": {gamma: 0.0},
    "with the axle along the spoke": {beta: 0.0},
    "at rest": {v: 0.0, v_y: 0.0, omega: 0.0},
    "on the spot": {v: 0.0, v_y: 0.0},
    "at the centre": {l: 0.0},
}
SWEDISH_SLIPS = {
    "when γ is forgotten": lambda twist, l, alpha, beta, gamma, r: swedish(
        twist, l, alpha, beta, 0.0, r
    ),
    "when γ has the other sign": lambda twist, l, alpha, beta, gamma, r: swedish(
        twist, l, alpha, beta, -gamma, r
    ),
    "when the whole speed of the rim counts: cos γ is missing": lambda *given: (
        np.cos(given[4]) * swedish(*given)
    ),
    "when the row is not turned by γ": lambda twist, l, alpha, beta, gamma, r: (
        swedish(twist, l, alpha, beta, 0.0, r) / np.cos(gamma)
    ),
    "when γ is missing in the last entry of the row": lambda twist, l, alpha, beta, gamma, r: (
        swedish([*twist[:2], 0], l, alpha, beta, gamma, r)
        + swedish([0, 0, twist[2]], l, alpha, beta, 0.0, r) / np.cos(gamma)
    ),
    "for the speed; the division by r is missing": lambda *given: given[-1] * swedish(*given),
}

wheels_p2 = Program(
    "wheels-p2",
    title="A wheel with rollers at any angle",
    text=SWEDISH_TEXT,
    starter=SWEDISH,
    symbols=(v, v_y, omega, l, alpha, beta, gamma, r),
    arguments=lambda v, v_y, omega, *wheel: ([v, v_y, omega], *wheel),
    ranges=SIZES,
    specials=SWEDISH_SPECIALS,
    answer=(Unknown("rate", "rad/s"),),
    right=swedish,
    picture=draw_wheel,
    extent=0.26,
    wrong={mistake: swedish_by(mistake) for mistake in (plus_sign, plus_l_cos, cos_alpha)},
    likely_slips=SWEDISH_SLIPS,
    hints=SWEDISH_HINTS,
    solution=SWEDISH_SOLUTION,
)


# --- p3 --------------------------------------------------------------------------------------

MOTION_TEXT = (
    "This program computes how the omni robot moves in the world, from the rates of its three "
    "wheels. The program is wrong. Find the mistake, and mend it. At rest, on the spot and with "
    f"the heading 0 it must work, too. {PLACED}"
)
MOTION = '''\
def omni_motion(rates, theta, spoke, r):
    """Return [x_dot, y_dot, omega] in the world, in m/s, m/s and rad/s.

    rates: array of three rates [rad/s]; theta: heading [rad];
    spoke: from the centre to a wheel [m]; r: radius of a wheel [m].
    """
    at = np.radians([0, 120, 240])
    J_1 = np.transpose([np.sin(at), -np.cos(at), [-spoke] * 3])
    twist = np.linalg.solve(J_1, r * rates)
    c, s = np.cos(theta), np.sin(theta)
    R = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return R @ twist
'''
MOTION_HINTS = (
    "With the heading 0 the answers are right. So the three rows are right, too. Which lines have "
    "to do with the heading?",
    "R leads from the world to the robot, as in the chapter. Which way must the twist go?",
    "The twist goes from the robot to the world, so with the inverse of R. Of a rotation matrix "
    "this is the transposed one, R.T.",
)
MOTION_SPECIALS = {
    "at rest": dict.fromkeys(omni_rates, 0.0),
    "on the spot": dict.fromkeys(omni_rates, 2.0),
    "with the heading 0": {theta: 0.0},
    "past half a turn": {theta: -3.1},
}
MOTION_MISTAKES = {
    **ways(forward_by, plus_sign, heading_for_beta, plus_l_cos, **ON_SPOKES),
    turned_back: lambda theta, **numbers: motion.to_body(theta, forward(theta=0.0, **numbers)),
}
MOTION_SLIPS = {
    "when the heading is forgotten": lambda theta, **numbers: forward(theta=0.0, **numbers),
    "when wheels 2 and 3 are exchanged": lambda w_2, w_3, **numbers: forward(
        w_2=w_3, w_3=w_2, **numbers
    ),
    "when the rates are taken for the speeds of the wheels: r is missing": lambda r, **numbers: (
        forward(r=1.0, **numbers)
    ),
}

wheels_p3 = Program(
    "wheels-p3",
    title="Mend the omni robot",
    text=MOTION_TEXT,
    starter=MOTION,
    symbols=(*omni_rates, theta, l, r),
    arguments=lambda w_1, w_2, w_3, theta, l, r: ([w_1, w_2, w_3], theta, l, r),
    ranges=SIZES,
    specials=MOTION_SPECIALS,
    answer=VELOCITY,
    right=of_rates(forward),
    picture=lambda right, answer, rates, theta, spoke, r: draw_motion(right, answer, theta, spoke),
    extent=0.26,
    wrong={mistake: of_rates(function) for mistake, function in MOTION_MISTAKES.items()},
    likely_slips={words: of_rates(function) for words, function in MOTION_SLIPS.items()},
    hints=MOTION_HINTS,
    solution=MOTION.replace("R @ twist", "R.T @ twist"),
)
