"""Exercises on the differential drive, and the mistakes that are made there."""

from functools import partial

import numpy as np
from sympy import Matrix, cos, pi, sin, symbols

from book.differential_drive import formulas
from book.differential_drive.formulas import b
from book.motion import formulas as planar
from courseware.answers import Unknown, angle
from courseware.equations import as_written
from courseware.practice import (
    Exercise,
    LocalEquation,
    Mistake,
    Solution,
    Step,
    WrongFormula,
    number_range,
)
from robokin import differential_drive, motion

RADIUS, TIME, DISTANCE, WORN = symbols("radius time distance worn")
D_L, D_R, D, DTHETA = symbols(r"D_L D_R D \Delta\theta")
with as_written():
    MEAN_WAY = LocalEquation(D, (D_L + D_R) / 2, "m")
    ON_ARC = LocalEquation(
        Matrix([planar.x_next, planar.y_next]),
        Matrix([formulas.R * sin(DTHETA), formulas.R * (1 - cos(DTHETA))]),
        "m",
    )
FROM_ORIGIN = {planar.x: 0, planar.y: 0, planar.theta: 0}

ASTRAY = motion.wrap_angle(60 - np.radians(60))  # 60 radians in place of 60 degrees
OMEGA = Unknown("ω", "rad/s")

half_wheel_distance = Mistake(
    "M12",
    feedback="with half the wheel distance in place of the whole",
    formula=WrongFormula(formulas.turning_rate, {b: b / 2}),
    line="omega = (v_R - v_L) / (b / 2)",
    why="The right wheel circles around the left one at the whole distance b, not at the distance "
    "from a wheel to the middle. The angular velocity comes out twice too large.",
    unnoticed="On a straight line, where the angular velocity is zero either way.",
    title="It turns too fast",
    picture=(
        "The robot on its arc to the right. Its program believes it on an arc of half the radius."
    ),
)
degrees_taken = Mistake(
    "M13",
    feedback="when degrees are handed to cosine and sine, which want radians",
    formula=WrongFormula(planar.to_world, {planar.theta: 180 * planar.theta / pi}),
    line="velocity = [v * np.cos(theta_deg), v * np.sin(theta_deg)]",
    why="np.cos and np.sin want radians. 60 radians are 9 turns and a half, so the robot seems to "
    "drive in a direction that has nothing to do with its heading.",
    unnoticed="With a heading of 0, and by chance at every multiple of "
    f"{360 / (180 / np.pi - 1):.3f}°. Test with 90°.",
    title="It goes astray",
    picture=(
        "The robot on its arc to the right. Its program believes that it set off "
        f"{np.degrees(ASTRAY):.0f}° more to the left."
    ),
)
world_to_robot = Mistake(
    "M14",
    feedback="with the transposed rotation matrix, which leads from the world to the robot",
    formula=WrongFormula(planar.to_world, {planar.theta: -planar.theta}),
    line="c, s = np.cos(theta), np.sin(theta)\nvelocity = [[c, s], [-s, c]] @ np.array([v, 0])",
    why="This matrix takes a velocity from the world to the robot, not from the robot to the "
    "world. It mirrors the direction at the x axis.",
    unnoticed="With a heading of 0 or 180°, where both matrices are the same. Test with 90°.",
    title="Down instead of up",
    picture=(
        "The robot drives up to the right. Its program believes that it drives down to the right."
    ),
)
double_distance = Mistake(
    "M31",
    feedback="when the wheel distance is counted twice",
    formula=WrongFormula(formulas.turning_rate, {b: 2 * b}),
    line="omega = (v_R - v_L) / (2 * b)",
    why="Some books divide by 2d, where d is half the wheel distance. Here b is the whole distance "
    "already; with 2b it is counted twice, and the angular velocity comes out half as "
    "large as it is.",
    unnoticed="On a straight line.",
    title="It turns too slowly",
    picture=(
        "The robot on its arc to the right. Its program believes it on an arc of twice the radius."
    ),
)


def twist(v_L, v_R, b):
    """Return speed and angular velocity [v, omega] from wheel speeds."""
    return differential_drive.body_twist(v_L, v_R, 1.0, b)[[0, 2]]


def moving(theta, v_L, v_R):
    """Return the velocity [x, y] in the world of the middle of the axle."""
    return motion.to_world(theta, [(v_L + v_R) / 2, 0, 0])[:2]


def ways(formula):
    """Return a formula by M12 and M31: the wheel distance halved and doubled."""
    return {
        mistake: mistake.formula.wrap(formula) for mistake in (half_wheel_distance, double_distance)
    }


def turned_ways(formula):
    """Return a formula by M13 and M14: another heading."""
    return {mistake: mistake.formula.wrap(formula) for mistake in (degrees_taken, world_to_robot)}


def made_after(first, wrong):
    """Return formulas by two mistakes: the numbers of the first, the formula of another."""
    return {(first, other): first.formula.wrap(f) for other, f in wrong.items() if other != first}


def centre(x, y, theta, v_L, v_R, b):
    """Return the centre of rotation in the world."""
    return motion.icr([x, y, theta], *twist(v_L, v_R, b))


def rates_on_circle(radius, time, r, b):
    """Return wheel rates for one full circle, counter-clockwise."""
    omega = 2 * np.pi / time
    return differential_drive.wheel_rates(radius * omega, omega, r, b)


def end(v_L, v_R, b, time):
    """Return where the robot is after driving from the origin along an arc."""
    return motion.arc_step([0, 0, 0], *twist(v_L, v_R, b), time)


def straight_end(turned, v_L, v_R, b, time):
    """Return the same if the whole way is straight: in the heading after this part of the turn."""
    v, omega = twist(v_L, v_R, b)
    way, turn = v * time, omega * time
    return [way * np.cos(turned * turn), way * np.sin(turned * turn), turn]


def degrees_end(v_L, v_R, b, time):
    """Return the end of the arc by M13: its sine and cosine get degrees."""
    v, omega = twist(v_L, v_R, b)
    turned = degrees_taken.formula.replace(theta=omega * time)["theta"]
    return [v / omega * np.sin(turned), v / omega * (1 - np.cos(turned)), omega * time]


def worn_end(worn, distance, b):
    """Return where a robot with a smaller left wheel ends that wants to drive straight ahead."""
    return end((1 - worn) * distance, distance, b, 1.0)[:2]


SPEEDS = {
    "b": number_range(20, 60, 5, "cm"),
    "v_L": number_range(0.1, 0.8, 0.05, "m/s"),
    "v_R": number_range(0.1, 0.8, 0.05, "m/s"),
}


def different(v_L, v_R, **_):
    """Whether it really turns, and not drives straight on."""
    return abs(v_R - v_L) > 0.04


differential_drive_1 = Exercise(
    "differential-drive-1",
    title="How fast does it turn?",
    text="The wheels of a robot are {b} apart. The left wheel moves over the floor at {v_L}, the "
    "right one at {v_R}. How fast does the robot turn, counter-clockwise positive?",
    given=SPEEDS,
    unknowns=(OMEGA,),
    right=lambda v_L, v_R, b: twist(v_L, v_R, b)[1],
    wrong={
        half_wheel_distance: half_wheel_distance.formula.evaluate,
        double_distance: double_distance.formula.evaluate,
    },
    when=different,
    likely_slips={"when the wheel distance is forgotten": lambda v_L, v_R, **_: v_R - v_L},
    solution=Solution(
        "Seen from the left wheel, the right one moves at the difference of the two speeds, on a "
        "circle whose radius is the wheel distance:\n\n{omega}",
        omega=Step(formulas.turning_rate),
    ),
    example={"v_L": 0.12, "v_R": 0.08, "b": 0.1},
)

differential_drive_2 = Exercise(
    "differential-drive-2",
    title="Which way does it go?",
    text="The robot's heading is {theta}. Its left wheel moves over the floor at {v_L}, its right "
    "wheel at {v_R}. What is the velocity of the middle of its axle in the world, along x and y?",
    given={"theta": number_range(20, 160, 5, "°"), "v_L": SPEEDS["v_L"], "v_R": SPEEDS["v_R"]},
    unknowns=(Unknown("ẋ", "m/s"), Unknown("ẏ", "m/s")),
    right=moving,
    wrong=turned_ways(moving),
    together=made_after(world_to_robot, {degrees_taken: degrees_taken.formula.wrap(moving)}),
    likely_slips={
        "with the difference of the wheel speeds in place of their mean": lambda theta, v_L, v_R: (
            moving(theta, v_R - v_L, v_R - v_L)
        ),
    },
    derive=lambda theta, v_L, v_R: {"v": (v_L + v_R) / 2, "theta_deg": np.degrees(theta)},
    solution=Solution(
        "The middle moves at the mean of the two speeds, along the heading:\n\n{speed}\n\n{world}",
        speed=Step(formulas.speed),
        world=Step(planar.to_world, {planar.v_y: 0}, part=(0, 1)),
    ),
    example={"v_L": 0.12, "v_R": 0.08, "theta": np.pi / 3},
)

differential_drive_3 = Exercise(
    "differential-drive-3",
    title="Which point does it turn about?",
    text="A robot stands with the middle of its axle at x = {x}, y = {y} and has the heading "
    "{theta}. Its wheels are {b} apart and move at {v_L} (left) and {v_R} (right). Where in the "
    "world is the point that it turns about, the instantaneous centre of rotation (ICR)?",
    given={
        "x": number_range(1, 4, 0.5, "m"),
        "y": number_range(1, 4, 0.5, "m"),
        "theta": number_range(20, 160, 10, "°"),
    }
    | SPEEDS,
    unknowns=(Unknown("x", "m"), Unknown("y", "m")),
    right=centre,
    wrong=ways(centre) | turned_ways(centre),
    together={
        k: v
        for m in (half_wheel_distance, double_distance)
        for k, v in made_after(m, turned_ways(centre)).items()
    },
    when=different,
    derive=lambda v_L, v_R, b, **_: {"R": centre(0, 0, 0, v_L, v_R, b)[1]},
    likely_slips={
        "with the ICR as the robot sees it, not as the world does": lambda v_L, v_R, b, **_: centre(
            0, 0, 0, v_L, v_R, b
        ),
        "when the robot's own place is not added": lambda x, y, **drive: centre(0, 0, **drive),
        "when R is measured to the wrong side of the robot": lambda x, y, **drive: (
            2 * np.array([x, y]) - centre(x, y, **drive)
        ),
        "with sine and cosine exchanged": lambda theta, **drive: centre(
            theta=np.pi / 2 - theta, **drive
        ),
        "when R is measured ahead of the robot": lambda x, y, theta, **speeds: centre(
            x, y, theta - np.pi / 2, **speeds
        ),
    },
    solution=Solution(
        "The ICR lies v/ω to the left of the robot, on the line of its axle; where that is "
        "negative, to the right. So find the speed and the angular velocity first:\n\n"
        "{v_}\n\n{omega_}\n\n{centre}",
        v_=Step(formulas.speed),
        omega_=Step(formulas.turning_rate),
        centre=Step(planar.icr, textbook=True, unit="m"),
    ),
)

differential_drive_4 = Exercise(
    "differential-drive-4",
    title="Once around a circle",
    text="A robot has wheels of radius {r}, {b} apart. The middle of its axle must run once "
    "around a circle of radius {radius}, to the left, in {time}. How fast must the left and the "
    "right wheel turn?",
    given={
        "r": number_range(2, 6, 1, "cm"),
        "b": SPEEDS["b"],
        "radius": number_range(0.6, 2, 0.2, "m"),
        "time": number_range(10, 40, 5, "s"),
    },
    unknowns=(Unknown("left", "rad/s"), Unknown("right", "rad/s")),
    right=rates_on_circle,
    wrong=ways(rates_on_circle),
    derive=lambda radius, time, **_: {
        "omega": 2 * np.pi / time,
        "v": radius * 2 * np.pi / time,
    },
    likely_slips={
        "for the speeds of the wheels; the division by r is missing": lambda **circle: (
            circle["r"] * rates_on_circle(**circle)
        ),
    },
    solution=Solution(
        "One turn takes {time}, and on a circle the speed is radius times angular velocity:\n\n"
        "{turning}\n\n{speed}\n\nEach wheel is half the wheel distance from the middle:\n\n{rates}",
        turning=Step(LocalEquation(planar.omega, 2 * pi / TIME, "rad/s")),
        speed=Step(LocalEquation(planar.v, RADIUS * planar.omega, "m/s")),
        rates=Step(formulas.wheel_rates),
    ),
)

differential_drive_5 = Exercise(
    "differential-drive-5",
    title="Along the arc",
    text="A robot starts at the origin with heading 0. Its wheels are {b} apart. For {time} the "
    "left wheel moves at {v_L} and the right one at {v_R}. Where is the middle of its axle then, "
    "and what is the robot's heading?",
    given=SPEEDS | {"time": number_range(1, 3, 0.5, "s")},
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), angle("θ")),
    right=end,
    wrong=ways(end),
    when=different,
    derive=lambda v_L, v_R, b, time: {
        "v": (v_L + v_R) / 2,
        "omega": (v_R - v_L) / b,
        "turn": (v_R - v_L) / b * time,
    },
    likely_slips={
        degrees_taken.feedback: degrees_end,
        "when the left and the right wheel are exchanged": lambda v_L, v_R, b, time: end(
            v_R, v_L, b, time
        ),
        "when the robot drives straight on and only then turns": partial(straight_end, 0.0),
        "when the robot turns first and then drives straight on": partial(straight_end, 1.0),
        "when the whole way is laid along the middle heading, not along the arc": partial(
            straight_end, 0.5
        ),
    },
    solution=Solution(
        "Speed and angular velocity come first:\n\n{v_}\n\n{omega_}\n\n"
        "The robot starts at the origin with heading 0 and keeps both for {time}, along an arc "
        "of radius v/ω:\n\n{arc}",
        v_=Step(formulas.speed),
        omega_=Step(formulas.turning_rate),
        arc=Step(
            planar.arc_step,
            FROM_ORIGIN | {planar.dt: "time"},
            unit=("m", "m", "rad"),
            textbook=True,
        ),
    ),
)

differential_drive_6 = Exercise(
    "differential-drive-6",
    title="A worn wheel",
    text="The left wheel of a robot is worn: its radius is {worn} smaller than the program "
    "believes; the right one is as it believes. The wheels are {b} apart. The program "
    "wants to drive straight ahead along x, from the origin. It gives both wheels the same rate "
    "until, by its own count, it has driven {distance}. Where does the middle of its axle end?",
    given={
        "worn": number_range(1, 4, 0.5, "%"),
        "b": SPEEDS["b"],
        "distance": number_range(1, 4, 0.5, "m"),
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m")),
    right=worn_end,
    wrong=ways(worn_end),
    likely_slips={
        "when the robot turns to the wrong side": lambda **drive: worn_end(**drive) * [1, -1],
        "when it drives straight on by the mean of both wheels": lambda worn, distance, **_: [
            (1 - worn / 2) * distance,
            0,
        ],
    },
    solution=Solution(
        "The right wheel travels D_R = {distance}, the left one less:\n\n{short}\n\n"
        "The middle of the axle travels their mean, and the robot turns by their difference over "
        "the wheel distance, to the left:\n\n{mean}\n\n{turn}\n\n"
        "The way is an arc that turns by Δθ. So its radius is D/Δθ, and the middle of the axle "
        "starts at the lowest point of that circle:\n\n{radius}\n\n{arc}",
        short=Step(LocalEquation(D_L, (1 - WORN) * DISTANCE, "m")),
        mean=Step(MEAN_WAY, {D_R: "distance"}),
        turn=Step(LocalEquation(DTHETA, (D_R - D_L) / b, "rad"), {D_R: "distance"}),
        radius=Step(LocalEquation(formulas.R, D / DTHETA, "m")),
        arc=Step(ON_ARC),
    ),
)
