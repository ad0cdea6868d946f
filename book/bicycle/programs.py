"""Programs that students write on the bicycle model."""

from dataclasses import replace

import numpy as np
from sympy import Symbol, atan2, cos, pi, sin, sinc, sqrt, tan

from book import things
from book.bicycle.exercises import (
    along_heading,
    front_speed_used,
    reversed_turn,
    same_sine,
    same_sines,
    sines_only,
    too_fast,
)
from book.bicycle.formulas import arc_step, kappa, steering, wheelbase, y_heading
from book.motion.formulas import dt, theta, v, x, y
from courseware.answers import Unknown, angle
from courseware.figures import Curve, Point
from courseware.programs.program import Program
from robokin import bicycle, motion

POSE = (Unknown("x", "m"), Unknown("y", "m"), angle("θ"))
COMPASS_POSE = (Unknown("x", "m"), Unknown("y", "m"), angle("ψ"))
DRIVE = {v: (-5, 5), dt: (0.1, 3), wheelbase: (1, 5)}
AHEAD, REST = {steering: 0.0}, {v: 0.0}


def car(pose, phi, L, look=""):
    """Draw a car of any wheelbase."""
    return replace(things.car(pose, (phi, phi), look=look), size=L / 2.5)


# --- p1 --------------------------------------------------------------------------------------


def stepped(method="exact"):
    """Return the step by a rule of `motion.path`."""
    return lambda pose, v, phi, L, dt: bicycle.path(pose, v, phi, L, dt, method)[-1]


def draw_step(right, answer, pose, v, phi, L, dt):
    return car(pose, phi, L, "ghost"), car(right, phi, L), car(answer, phi, L, "wrong")


def on_circle(pose, v, phi, L, dt):
    """M15 in a step that begins anywhere."""
    *place, theta = pose
    return same_sines(theta, v, phi, L, dt) + np.array([*place, 0])


STEP_TEXT = (
    "Write the exact step: where is the middle of the rear axle after dt "
    "seconds, at constant speed v and steering angle φ, positive to the left? Straight ahead and "
    "at rest it must work, too. Where the car goes almost straight, with a steering angle of 1e-5 "
    "or of 1e-12, no digits may be lost."
)
STEP = '''\
def car_step(pose, v, phi, L, dt):
    """Return the pose [x, y, theta] after a drive of dt seconds.

    pose: array of x, y [m] and heading [rad] at the start;
    v [m/s], phi [rad], L [m], dt [s]: numbers.
    """
    ...
'''
STEP_HINTS = (
    "The car drives an arc, whose radius is R = L/tan φ. By how much does it turn on its way v dt?",
    "R is infinite straight ahead. Go along the chord instead, the straight line from the start to "
    "the end of the arc: in which direction does it lie, and how long is it?",
    "With the turn v dt tan φ/L, the chord lies along θ + turn/2. Its length is v dt times "
    "sin(u)/u, with u = turn/2. np.sinc(u / np.pi) is this quotient, and 1 at u = 0.",
)
STEP_SOLUTION = """\
def car_step(pose, v, phi, L, dt):
    x, y, theta = pose
    turn = v * dt / L * np.tan(phi)
    middle = theta + turn / 2
    chord = v * dt * np.sinc(turn / 2 / np.pi)  # NumPy's sinc has pi inside
    x, y = x + chord * np.cos(middle), y + chord * np.sin(middle)
    return np.array([x, y, theta + turn])
"""
STEP_SPECIALS = {
    "straight ahead": AHEAD,
    "almost straight ahead": {steering: 1e-12},
    "hardly steered": {steering: 1e-5},
    "at rest": REST,
    "at rest, straight ahead": REST | AHEAD,
    "no time": {dt: 0.0},
    "past half a turn": {theta: 3.1, v: 2.0, steering: 0.5, dt: 1.0},
}
STEP_SLIPS = {
    "with a straight way along the old heading": stepped("start"),
    "with a straight way along the new heading": stepped("end"),
    "with the whole way along the middle heading: the chord is shorter than the arc": stepped(
        "midpoint"
    ),
    "with φ where tan φ belongs": lambda pose, v, phi, L, dt: motion.arc_step(
        pose, v, v * phi / L, dt
    ),
    "when the car turns to the right for a positive φ": lambda pose, v, phi, L, dt: motion.arc_step(
        pose, v, bicycle.body_twist(v, -phi, L)[2], dt
    ),
    "when the place at the start is not added": lambda pose, *drive: stepped()(
        np.array([0, 0, pose[2]]), *drive
    ),
    "when the heading at the start is forgotten": lambda pose, *drive: stepped()(
        np.array([*pose[:2], 0]), *drive
    ),
}

bicycle_p1 = Program(
    "bicycle-p1",
    title="The exact step",
    text=STEP_TEXT,
    starter=STEP,
    symbols=(x, y, theta, v, steering, wheelbase, dt),
    arguments=lambda x, y, theta, v, phi, L, dt: ([x, y, theta], v, phi, L, dt),
    ranges=DRIVE,
    specials=STEP_SPECIALS,
    answer=POSE,
    right=stepped(),
    picture=draw_step,
    extent=3,
    wrong={
        sines_only: on_circle,
        front_speed_used: lambda pose, v, phi, L, dt: motion.arc_step(
            pose, v, too_fast(v, phi, L), dt
        ),
    },
    likely_slips=STEP_SLIPS,
    hints=STEP_HINTS,
    solution=STEP_SOLUTION,
)


# --- p2 --------------------------------------------------------------------------------------


def steer_by(radius, mistaken=np.arctan):
    """Return the steering for a circle whose radius is a function of the place."""
    return lambda place, L: mistaken(L / radius(*place))


def draw_steering(right, answer, place, L):
    half, part = atan2(place[1], place[0]), Symbol("part", real=True)
    way = sqrt(place[0] ** 2 + place[1] ** 2) / sinc(half)

    def after(phi, part):
        start = {x: 0, y: 0, theta: 0}
        return arc_step.substitute(start | {v: way, kappa: tan(phi) / L, dt: part})

    return (
        car((0, 0, 0), right, L, "ghost"),
        Curve("path", after(right, part), part, 0, 1),
        Curve("error", after(answer, part), part, 0, 1),
        car(after(right, 1), right, L),
        car(after(answer, 1), answer, L, "wrong"),
        Point("target", place),
    )


STEER_TEXT = (
    "Go back: with which steering angle does a car reach a place on one arc? The place is given "
    "as the car sees it: x ahead of the middle of its rear axle, y to the left. This point, not "
    "the front axle, must come through the place. (Programs that follow a path do this many times "
    "a second, with a point of the path a few metres ahead: pure pursuit.) Places straight ahead, "
    "at the side of the car and behind it must work, too."
)
STEER = '''\
def steer_to(place, L):
    """Return the steering angle [rad], positive to the left.

    place: array of x, y [m]; L: wheelbase [m].
    """
    ...
'''
STEER_HINTS = (
    "The car starts along its x axis, so the centre of its circle lies on the y axis: at (0, R). "
    "Find R first.",
    "The place is as far from the centre as the start is: x² + (y − R)² = R².",
    "This gives 2 R y = x² + y². With tan φ = L/R the radius goes away, and nothing is divided by "
    "y.",
)
STEER_SOLUTION = """\
def steer_to(place, L):
    x, y = place
    return np.arctan(2 * L * y / (x**2 + y**2))
"""
STEER_SPECIALS = {
    "straight ahead": {y: 0.0},
    "almost straight ahead": {y: 1e-9},
    "at the side": {x: 0.0},
    "behind the car": {x: -2.0},
}
STEER_SLIPS = {
    "when the wheel points straight at the place": lambda place, L: np.arctan2(place[1], place[0]),
    "with half the curvature: R is (x² + y²)/(2y)": steer_by(lambda x, y: (x**2 + y**2) / y),
    "with the distance of the place in place of its square": steer_by(
        lambda x, y: np.hypot(x, y) / (2 * y)
    ),
    "with x and y exchanged": steer_by(lambda x, y: (x**2 + y**2) / (2 * x)),
    "when the distance of the place is taken for the radius": steer_by(
        lambda x, y: np.sign(y) * np.hypot(x, y)
    ),
    "with the tangent of the angle for the angle itself": steer_by(
        lambda x, y: (x**2 + y**2) / (2 * y), mistaken=lambda slope: slope
    ),
    "when the radius is upside down": lambda place, L: np.arctan(
        place @ place / (2 * L * place[1])
    ),
    "with the arguments of arctan2 exchanged: y comes first": lambda place, L: np.arctan2(
        place @ place, 2 * L * place[1]
    ),
}

bicycle_p2 = Program(
    "bicycle-p2",
    title="Steer to a place",
    text=STEER_TEXT,
    starter=STEER,
    symbols=(x, y, wheelbase),
    arguments=lambda x, y, L: ([x, y], L),
    ranges={x: (0.5, 20), y: (-10, 10), wheelbase: (1, 5)},
    specials=STEER_SPECIALS,
    answer=(angle("φ"),),
    right=lambda place, L: bicycle.steering(place @ place, 2 * place[1], L),
    picture=draw_steering,
    extent=3,
    likely_slips=STEER_SLIPS,
    hints=STEER_HINTS,
    solution=STEER_SOLUTION,
)


# --- p3 --------------------------------------------------------------------------------------


def compass_step(velocity=None, turn=None, sense=-1):
    """Return the step of the front axle, heading clockwise; its velocity or rate by a mistake."""

    def step(pose, v, phi, L, dt):
        theta = np.pi / 2 - pose[2]
        x_dot, y_dot, omega = motion.to_world(theta, bicycle.front_twist(v, phi, L))
        if velocity:
            x_dot, y_dot = velocity(theta, v / np.cos(phi), phi)
        if turn:
            omega = turn(v, phi, L)
        return pose + dt * np.array([x_dot, y_dot, sense * omega])

    return step


def draw_front(right, answer, pose, v, phi, L, dt):
    def bus(of, look=""):
        x, y, psi = of
        rear = x - L * sin(psi), y - L * cos(psi), pi / 2 - psi
        return replace(things.bus(rear, (phi, phi), look=look), size=L / 7)

    return bus(pose, "ghost"), bus(right), bus(answer, "wrong")


def nose(theta, v_F, phi):
    """M17: the velocity of the front axle along the heading."""
    return along_heading.formula.evaluate(theta=theta, v_F=v_F, steering=phi).ravel()


COMPASS_TEXT = (
    "This program follows O, the middle of the front axle, as in step 7 of the chapter: in a "
    "straight step of dt seconds, with the velocity that O has at the start of the step. The "
    "heading ψ is measured as on a compass: clockwise, from the y axis. The program is wrong. Find "
    "the mistake, and mend it. Any speed and any steering must work, at rest and straight ahead, "
    "too."
)
COMPASS = '''\
def front_step(pose, v, phi, L, dt):
    """Return the pose [x, y, psi] of O after a straight step of dt seconds.

    pose: array of x, y [m] of O and psi [rad], clockwise from y; v: speed of
    the rear axle [m/s]; phi [rad], positive to the left; L [m], dt [s].
    """
    x, y, psi = pose
    v_front = v / np.cos(phi)
    direction = psi - phi
    omega = v / L * np.tan(phi)
    x = x + v_front * np.sin(direction) * dt
    y = y + v_front * np.cos(direction) * dt
    psi = psi + omega * dt
    return np.array([x, y, psi])
'''
COMPASS_HINTS = (
    "Which of the three numbers are wrong in the simplest input? And with φ = 0?",
    "A car that looks along y, ψ = 0, turns to the left. Where does it look then, and is that "
    "a larger ψ or a smaller one?",
    "φ is positive to the left, ψ to the right. One line has the minus for this already, another "
    "line lacks it.",
)
COMPASS_SPECIALS = {
    "straight ahead": AHEAD,
    "almost straight ahead": {steering: 1e-9},
    "at rest": REST,
    "heading along y": {y_heading: 0.0},
    "past half a turn": {y_heading: -3.1, v: 2.0, steering: 0.5, dt: 1.0},
}
COMPASS_MISTAKES = {
    front_speed_used: compass_step(turn=too_fast),
    along_heading: compass_step(nose),
    reversed_turn: compass_step(sense=1),
    same_sine: compass_step(lambda theta, v_F, phi: 2 * [v_F * np.cos(theta + phi)]),
}
COMPASS_SLIPS = {
    "when the direction of the front wheel is changed, along ψ + φ, where the turn is wrong": (
        compass_step(
            lambda theta, v_F, phi: [v_F * np.cos(theta - phi), v_F * np.sin(theta - phi)], sense=1
        )
    ),
    "when the front wheel points to the wrong side, along ψ + φ": compass_step(
        lambda theta, v_F, phi: [v_F * np.cos(theta - phi), v_F * np.sin(theta - phi)]
    ),
    "with the speed of the rear axle": compass_step(
        lambda theta, v_F, phi: np.cos(phi) * motion.to_world(theta + phi, [v_F, 0, 0])[:2]
    ),
    "with sine and cosine exchanged": compass_step(
        lambda theta, v_F, phi: motion.to_world(theta + phi, [v_F, 0, 0])[1::-1]
    ),
}

bicycle_p3 = Program(
    "bicycle-p3",
    title="Mend the long vehicle",
    text=COMPASS_TEXT,
    starter=COMPASS,
    symbols=(x, y, y_heading, v, steering, wheelbase, dt),
    arguments=lambda x, y, psi, v, phi, L, dt: ([x, y, psi], v, phi, L, dt),
    ranges=DRIVE | {wheelbase: (2, 10)},
    specials=COMPASS_SPECIALS,
    answer=COMPASS_POSE,
    right=compass_step(),
    picture=draw_front,
    extent=7,
    wrong=COMPASS_MISTAKES,
    likely_slips=COMPASS_SLIPS,
    hints=COMPASS_HINTS,
    solution=COMPASS.replace("psi + omega", "psi - omega"),
)
