"""Exercises on odometry: poses from encoder ticks, and the mistakes that are made there."""

from functools import partial

import numpy as np
from sympy import Add, Matrix, Pow, atan, atan2, ceiling, cos, pi, sin, sqrt, symbols

from book.differential_drive import formulas as drive
from book.differential_drive.exercises import degrees_taken, half_wheel_distance
from book.motion import formulas as planar
from book.odometry import formulas
from courseware.answers import Unknown, angle, integer
from courseware.equations import as_written
from courseware.practice import (
    Exercise,
    LocalEquation,
    Mistake,
    Solution,
    Step,
    WrongFormula,
    number_range,
    one_of,
)
from robokin import motion, odometry

N, TURNS, AROUND, JUMP, LEAST, LIMIT, ERROR = symbols("N n U Δc C_min Δω error")
X_OLD, Y_OLD, X_MID, Y_MID = symbols("x_old y_old x_mid y_mid")
BY_TURN = {planar.x: 0, planar.y: 0, formulas.dtheta: "turn"}  # from the origin
POSE_UNITS = ("m", "m", "rad")

with as_written():
    AFTER = planar.theta + formulas.dtheta
    HEADING = LocalEquation(planar.theta_next, atan2(sin(AFTER), cos(AFTER)), "rad")
    HALF_SEEN = atan(sin(AFTER) / cos(AFTER))
    FORGETFUL = formulas.one_sample("", formulas.dtheta).right
    PER_RADIAN = [drive.r * ticks / formulas.C for ticks in (formulas.N_L, formulas.N_R)]
    DIFFERENCE = formulas.count_now - formulas.count_before

lost_heading = Mistake(
    "M22",
    feedback="when the heading so far is forgotten and only the turn of this sample is put in",
    formula=WrongFormula(formulas.new_heading, instead=FORGETFUL),
    line="pose = [x + D * np.cos(dtheta), y + D * np.sin(dtheta), theta + dtheta]",
    why="Δθ only says how far the robot turned in this sample. The direction in which it drives is "
    "its heading in the world: the heading so far and the turn together. How much of the turn "
    "counts depends on the rule: old, middle or new heading.",
    unnoticed="In the first sample from heading 0, with the rule of the new heading. On a straight "
    "line along the x axis with every rule.",
    title="It forgets its heading",
    picture=(
        "The robot on its arc to the left. Its program believes that it drives straight on, "
        "nearly along the x axis."
    ),
    document="003",
    place="the first formulas for Δx and Δy",
    nth=1,
    quote="Δx = D cos Δθ, Δy = D sin Δθ",
    correction="Δx = D cos(«θ +» Δθ), Δy = D sin(«θ +» Δθ)",
    explanation="Δθ only says how far the robot turned in this sample. The direction in which it "
    "drives is the heading so far, θ, and the turn together. (This is the rule of the "
    "new heading, which the document uses in its third formula.)",
)
arctan_heading = Mistake(
    "M23",
    feedback="when the heading is taken as tan⁻¹(sin/cos), which never looks backward",
    formula=WrongFormula(HEADING, instead=HALF_SEEN),
    line="h = np.arctan(np.sin(theta + dtheta) / np.cos(theta + dtheta))\n"
    "pose = [x + D * np.cos(h), y + D * np.sin(h), h]",
    why="The quotient of sine and cosine is the same for opposite directions, and the inverse "
    "tangent answers with the one between −90° and 90°. Where the cosine is negative, it is off "
    "by half a turn. atan2(sin, cos) looks at both signs.",
    unnoticed="As long as the cosine of the heading is positive, so between −90° and 90°.",
    title="It never looks backward",
    picture=(
        "The robot on its arc to the left. Its program believes that it turns back where its "
        "heading passes 90°."
    ),
    document="003",
    place="the third formula, rotation",
    nth=2,
    quote="θ_{i+1} = tan⁻¹(sin(θ_i + w_{i+1} Δt)/cos(θ_i + w_{i+1} Δt))",
    correction="θ_{i+1} = «atan2»(sin(θ_i + w_{i+1} Δt), cos(θ_i + w_{i+1} Δt))",
)
ticks_per_radian = Mistake(
    "M24",
    feedback="when the ticks of a whole turn are taken for the ticks of one radian: 2π is lost",
    formula=WrongFormula(formulas.travel, instead=Matrix(PER_RADIAN)),
    line="D = r * N / C",
    why="N/C is a number of turns. In one turn the wheel rolls its circumference, 2πr, not its "
    "radius.",
    unnoticed="As long as the wheel stands still, and in the heading on a straight line, where "
    "both wheels lose the same.",
    title="It hardly moves",
    picture=(
        "The robot on its arc to the left. Its program believes that it came about a sixth "
        "of the way and hardly turned."
    ),
)
counter_jump = Mistake(
    "M25",
    feedback="when the counter wrapped round and its jump is taken for a huge step the other way",
    formula=WrongFormula(formulas.counter_step, instead=DIFFERENCE),
    line="D = 2 * np.pi * r / C * (after - before)",
    why="After its last number a counter shows 0, as a clock shows 0:00 after 23:59. Then the "
    "difference lacks a whole round, 65536 ticks in a counter of 16 bits: a small way forward "
    "looks like a huge way back. Backward past 0 it has a round too many. Of the two ways round, "
    "take the shorter.",
    unnoticed="As long as the counter does not pass its end: in every short test.",
    title="It leaps back in sample 9",
    picture=(
        "The robot on its arc to the left. Its program believes that it leaps back when its "
        "counters pass their end."
    ),
)

BITS = 16


def turned(before, after):
    """Return the ticks between two readings of a counter."""
    return float(odometry.unwrap_counter([before, after], BITS)[0])


def jumped(before, after):
    """Return the ticks as M25 reads them."""
    return counter_jump.formula.evaluate(count_before=before, count_now=after)


def rolled(ticks, C, r):
    """Return how far a wheel rolls."""
    return odometry.travel(ticks, C, r)


def rolled_per_radian(ticks, C, r):
    """Return how far it rolls by M24."""
    return ticks_per_radian.formula.evaluate(N_L=ticks, N_R=ticks, C=C, r=r)[0, 0]


def way_and_turn(D_L, D_R, b):
    """Return how far the robot goes, and by how much it turns."""
    return (D_L + D_R) / 2, (D_R - D_L) / b


def one_step(method, theta, D_L, D_R, b, x=0, y=0):
    """Return the pose after one step by a rule of `motion.path`."""
    return motion.path([x, y, theta], *way_and_turn(D_L, D_R, b), 1.0, method)[-1]


def heading_forgotten(theta, D_L, D_R, b, x=0, y=0):
    """Return the pose after one step by M22."""
    D, turn = way_and_turn(D_L, D_R, b)
    return lost_heading.formula.evaluate(x=x, y=y, theta=theta, D=D, dtheta=turn).ravel()


def half_seen(heading):
    """Return a heading as M23 has it: tan⁻¹(sin/cos)."""
    return arctan_heading.formula.evaluate(theta=heading, dtheta=0)


def half_seen_step(theta, D_L, D_R, b, x, y):
    """Return the step with the new heading, by M23."""
    D, turn = way_and_turn(D_L, D_R, b)
    heading = half_seen(theta + turn)
    return [x + D * np.cos(heading), y + D * np.sin(heading), heading]


def half_seen_heading(theta, D_L, D_R, b, x, y):
    """M23 in the heading alone; the way is laid along the right one."""
    *place, heading = one_step("end", theta, D_L, D_R, b, x, y)
    return [*place, half_seen(heading)]


def degrees_step(theta, D_L, D_R, b, x, y):
    """Return the step with the new heading, by M13."""
    D, turn = way_and_turn(D_L, D_R, b)
    h = degrees_taken.formula.replace(theta=theta + turn)["theta"]
    return [x + D * np.cos(h), y + D * np.sin(h), theta + turn]


def backward(heading):
    """Whether a direction clearly has a negative cosine."""
    return np.cos(heading) < -0.1


def gap(turn, D, heading, theta):
    """Return how far D along a heading ends from D along the arc that begins with heading theta."""
    straight = D * np.array([np.cos(heading), np.sin(heading)])
    return np.linalg.norm(straight - motion.arc_step([0, 0, theta], D, turn, 1.0)[:2])


def resolution(roll, r, b, period, limit):
    """Return the ticks a turn, not yet whole, with which one tick changes the rate by limit."""
    return roll(1, 1, r) / (b * period * limit)


def finest(**design):
    """Return the smallest whole number of ticks a turn."""
    return np.ceil(resolution(rolled, **design))


def wheel_ways(r, C, left_before, left_after, right_before, right_after, count, roll):
    """Return how far both wheels roll, from the readings of their counters."""
    ticks = {"D_L": count(left_before, left_after), "D_R": count(right_before, right_after)}
    return {wheel: roll(n, C, r) for wheel, n in ticks.items()}


def counted(theta, b, count=turned, roll=rolled, step=one_step, rule="exact", **drive):
    """Return the pose after one step, from the readings."""
    ways = wheel_ways(count=count, roll=roll, **drive)
    return step(rule, theta=theta, b=b, **ways)


def without_heading(_, **step):
    """M22 as a step of `counted`."""
    return heading_forgotten(**step)


def half_seen_pose(**drive):
    """M23 in the heading of the answer."""
    *place, heading = counted(**drive)
    return [*place, half_seen(heading)]


def counted_from(start, theta, **drive):
    """Return the pose after one step if the heading at the start is taken for this one."""
    return counted(start, **drive)


def arc_from_zero(**drive):
    """M22 with the exact arc: it starts with heading 0, the heading in the answer is right."""
    return [*counted_from(0.0, **drive)[:2], counted(**drive)[2]]


def turn_between(theta, b, **drive):
    """Return how much the robot turns, from the readings."""
    ways = wheel_ways(count=turned, roll=rolled, **drive)
    return (ways["D_R"] - ways["D_L"]) / b


def around(before, after, **_):
    """Return the ticks between two readings that lie on two sides of the counter's end."""
    return FORWARD if after < before else BACKWARD


def error_of(x, y):
    """Return how far a place is from the end of the real way."""
    squares = [(end - place) ** 2 for end, place in ((planar.x_next, x), (planar.y_next, y))]
    return LocalEquation(ERROR, sqrt(Add(*squares)), "m")


def readings(side=""):
    """Return the names of the readings of a counter, for the formula's letters."""
    names = (f"{side}_{name}".strip("_") for name in ("before", "after"))
    return dict(zip((formulas.count_before, formulas.count_now), names, strict=True))


with as_written():
    FORWARD = LocalEquation(formulas.dN, JUMP + formulas.counter_span, "ticks")
    BACKWARD = LocalEquation(formulas.dN, JUMP - formulas.counter_span, "ticks")
    JUMPED = LocalEquation(JUMP, DIFFERENCE, "ticks")
    SPAN = LocalEquation(formulas.counter_span, Pow(2, BITS))
    DISTANCE = LocalEquation(drive.b, (formulas.D_R - formulas.D_L) / formulas.dtheta)
    WHOLE_TURNS = LocalEquation(formulas.dtheta, 2 * pi * TURNS, "rad")
    RESOLUTION = LocalEquation(LEAST, 2 * pi * drive.r / (drive.b * planar.dt * LIMIT))
    OLD_ERROR, MID_ERROR = error_of(X_OLD, Y_OLD), error_of(X_MID, Y_MID)


odometry_1 = Exercise(
    "odometry-1",
    title="How far has the wheel rolled?",
    text="The encoder of a wheel gives {C} ticks in one turn of the wheel. The wheel has the "
    "radius {r}. Since the last reading, {N} ticks were counted. How far has the wheel rolled?",
    given={
        "C": one_of(360, 500, 512, 1000, 1024, 2048),
        "r": number_range(2, 10, 0.5, "cm"),
        "N": number_range(150, 950, 50),
    },
    unknowns=(Unknown("D", "m"),),
    right=lambda C, r, N: rolled(N, C, r),
    wrong={ticks_per_radian: lambda C, r, N: rolled_per_radian(N, C, r)},
    likely_slips={
        "with the diameter where the radius belongs": lambda C, r, N: rolled(N, C, 2 * r),
        "when ticks and ticks a turn are exchanged": lambda C, r, N: rolled(C, N, r),
    },
    solution=Solution(
        "The wheel made so many turns:\n\n{turns}\n\nIn one turn it rolls its circumference:"
        "\n\n{around}\n\nThe distance is the product of the two:\n\n{way}",
        turns=Step(
            LocalEquation(TURNS, N / formulas.C),
            expected=lambda C, r, N: odometry.travel(N, C, 1.0) / (2 * np.pi),
        ),
        around=Step(
            LocalEquation(AROUND, 2 * pi * drive.r, "m"),
            expected=lambda C, r, N: odometry.travel(C, C, r),
        ),
        way=Step(formulas.travel, {formulas.N_L: N}, part=(0,), values=(formulas.D,)),
    ),
    example={"C": 1000, "r": 0.05, "N": 500},
)

odometry_2 = Exercise(
    "odometry-2",
    title="The counter jumps",
    text="A counter of 16 bits counts the ticks of a wheel: up when the wheel rolls forward, down "
    "when it rolls backward. It showed {before}, and now it shows {after}. In the meantime the "
    "wheel has made only a few turns. One turn is {C} ticks, and the radius of the wheel is {r}. "
    "How far has the wheel rolled? Forward is positive.",
    given={
        "before": one_of(*range(120, 1000, 80), *range(64600, 65500, 80)),
        "after": one_of(*range(75, 1000, 50), *range(64610, 65500, 50)),
        "C": one_of(360, 500, 512, 1000),
        "r": number_range(2, 8, 1, "cm"),
    },
    # four decimals, less than half a tick: so 65535 in place of 65536 shows
    unknowns=(Unknown("D", "m", tolerance=6e-5),),
    right=lambda before, after, C, r: rolled(turned(before, after), C, r),
    wrong={
        ticks_per_radian: lambda before, after, C, r: rolled_per_radian(
            turned(before, after), C, r
        ),
        counter_jump: lambda before, after, C, r: rolled(jumped(before, after), C, r),
    },
    likely_slips={
        "with 65535 numbers of the counter: with 0 it has 65536": lambda before, after, C, r: (
            rolled(turned(before, after) + np.sign(after - before), C, r)
        ),
    },
    when=lambda before, after, **_: abs(after - before) > 2**15,
    derive=lambda before, after, C, r: {
        "end": "past its last number to 0" if after < before else "below 0 to its last number",
    },
    solution=Solution(
        "The difference of the two readings is far too much for a few turns:\n\n{jump}\n\n"
        "So the counter went {end}. It has as many numbers as its bits allow:\n\n{span}\n\n"
        "Of the two ways round, the shorter one is meant:\n\n{ticks}\n\n"
        "That many ticks are this distance:\n\n{way}\n\n"
        "A formula with the rest of a division needs no such thought. It gives the same number of "
        "ticks:\n\n{both}",
        answer=("way",),
        jump=Step(JUMPED, readings()),
        span=Step(SPAN),
        ticks=Step(around),
        way=Step(formulas.travel, {formulas.N_L: formulas.dN}, part=(0,), values=(formulas.D,)),
        both=Step(
            formulas.counter_step,
            readings(),
            unit="ticks",
            expected=lambda before, after, **_: turned(before, after),
        ),
    ),
    example={"before": 65500, "after": 464, "C": 1000, "r": 0.05},
)

odometry_3 = Exercise(
    "odometry-3",
    title="One sample with the new heading",
    text="A robot is at x = {x}, y = {y} with the heading {theta}. In one sample its left wheel "
    "rolls {D_L} and its right wheel {D_R}; the wheels are {b} apart. Update the pose by the rule "
    "of the new heading: the robot first turns, and then drives straight. What are its new x, y "
    "(of the middle of its axle) and heading?",
    given={
        "x": number_range(1, 4, 0.5, "m"),
        "y": number_range(1, 4, 0.5, "m"),
        "theta": number_range(80, 170, 5, "°"),
        "D_L": number_range(5, 40, 2.5, "cm"),
        "D_R": number_range(5, 40, 2.5, "cm"),
        "b": number_range(20, 60, 5, "cm"),
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), angle("θ")),
    right=lambda **step: one_step("end", **step),
    wrong={lost_heading: heading_forgotten, arctan_heading: half_seen_step},
    when=lambda theta, D_L, D_R, b, **_: (
        abs(D_R - D_L) > 0.04 and abs(D_R - D_L) < b and backward(theta + (D_R - D_L) / b)
    ),
    derive=lambda theta, D_L, D_R, b, **_: {
        "D": (D_L + D_R) / 2,
        "dtheta": (D_R - D_L) / b,
    },
    likely_slips={
        "by the rule of the old heading": lambda **step: one_step("start", **step),
        "by the rule of the middle heading": lambda **step: one_step("midpoint", **step),
        "along the exact arc": lambda **step: one_step("exact", **step),
        half_wheel_distance.feedback: half_wheel_distance.formula.wrap(
            lambda **step: one_step("end", **step)
        ),
        degrees_taken.feedback: degrees_step,
        "when only the heading that is answered is taken as tan⁻¹(sin/cos)": half_seen_heading,
        "when left and right are exchanged": lambda D_L, D_R, **step: one_step(
            "end", D_L=D_R, D_R=D_L, **step
        ),
    },
    solution=Solution(
        "The middle of the axle moves by the mean of the two ways, and the robot turns by their "
        "difference over the wheel distance:\n\n{distance}\n\n{turned}\n\n"
        "The rule lays all of it in the direction of the new heading, which is the old heading "
        "and the turn together:\n\n{pose}",
        distance=Step(formulas.distance),
        turned=Step(formulas.turn),
        pose=Step(formulas.new_heading, unit=POSE_UNITS),
    ),
    example={"x": 0.0, "y": 0.0, "theta": np.pi / 2, "D_L": 0.1, "D_R": 0.2, "b": 0.5},
)

odometry_4 = Exercise(
    "odometry-4",
    title="How far apart are the wheels?",
    text="You want to measure the wheel distance of a robot by driving. Its wheels have the radius "
    "{r} and encoders with {C} ticks a turn. The robot turns on the spot to the left, exactly "
    "{n} full turns. The right wheel counts {N_R} ticks, the left one the same number backward, "
    "−{N_R}. How far apart are the wheels?",
    given={
        "r": number_range(2, 6, 0.5, "cm"),
        "C": one_of(360, 500, 512, 1000),
        "n": number_range(2, 10, 1),
        "N_R": number_range(4000, 16000, 500),
    },
    unknowns=(Unknown("b", "m"),),
    right=lambda r, C, n, N_R: rolled(2 * N_R, C, r) / (2 * np.pi * n),
    wrong={
        ticks_per_radian: lambda r, C, n, N_R: rolled_per_radian(2 * N_R, C, r) / (2 * np.pi * n)
    },
    when=lambda r, C, n, N_R: 0.15 < 2 * r * N_R / (C * n) < 0.8,
    likely_slips={
        "for one full turn; the robot made several": lambda r, C, n, N_R: (
            rolled(2 * N_R, C, r) / (2 * np.pi)
        ),
        "with the way of one wheel only": lambda r, C, n, N_R: rolled(N_R, C, r) / (2 * np.pi * n),
    },
    solution=Solution(
        "The two wheels roll the same distance, the left one backward:\n\n{ways}\n\n"
        "The robot makes {n} full turns:\n\n{turned}\n\n"
        "The turn is the difference of both distances, over the wheel distance. So the wheel "
        "distance is the difference over the turn:\n\n{b}",
        ways=Step(formulas.travel, {formulas.N_L: -formulas.N_R}),
        turned=Step(WHOLE_TURNS),
        b=Step(DISTANCE),
    ),
)

odometry_5 = Exercise(
    "odometry-5",
    title="How fine must the encoder be?",
    text="A robot has wheels of radius {r}, {b} apart. Its program reads the encoders every "
    "{period} and computes the turning rate from the ticks. One tick more or less of one wheel "
    "may change this turning rate by at most {limit}. An encoder gives C ticks in one turn of its "
    "wheel, a whole number. How large must C be at least?",
    given={
        "r": number_range(2, 8, 0.5, "cm"),
        "b": number_range(20, 60, 5, "cm"),
        "period": one_of(10, 20, 50, 100, unit="ms"),
        "limit": one_of(0.5, 1, 2, 5, unit="°/s"),
    },
    unknowns=(integer("C", "ticks"),),
    right=finest,
    wrong={ticks_per_radian: lambda **design: np.ceil(resolution(rolled_per_radian, **design))},
    likely_slips={
        "when it is rounded down: with one tick less the change is more than allowed": (
            lambda **design: np.floor(resolution(rolled, **design))
        ),
    },
    when=lambda **design: (
        100 < resolution(rolled, **design) < 10000
        and 0.01 < resolution(rolled, **design) % 1 < 0.99
    ),
    solution=Solution(
        "In one tick the wheel rolls its circumference over C. This changes the turning rate by "
        "that over b and over the time Δt. The change must be at most Δω, which is {limit:.6f} "
        "rad/s. So C must be at least\n\n{least}\n\nThe smallest such whole number is {C.value} a "
        "turn.\n\nA test: with this C, one tick is the distance\n\n{way}\n\nIt changes the turning "
        "rate by\n\n{change}\n\nThis is not more than Δω.",
        answer=("C",),
        least=Step(RESOLUTION, {planar.dt: "period", LIMIT: "limit"}),
        C=Step(LocalEquation(formulas.C, ceiling(LEAST))),
        way=Step(
            formulas.travel,
            {formulas.N_R: 1},
            part=(1,),
            expected=lambda **design: odometry.travel(1, finest(**design), design["r"]),
        ),
        change=Step(
            formulas.velocity,
            {formulas.D_L: 0, planar.dt: "period"},
            part=(1,),
            expected=lambda r, b, period, **limit: odometry.velocity(
                0, 1, period, finest(r=r, b=b, period=period, **limit), r, b
            )[1],
        ),
    ),
)

odometry_6 = Exercise(
    "odometry-6",
    title="The error of the old heading",
    text="A robot reads its encoders too seldom: in one sample it drives {D} and turns to the left "
    "by {turn}. Before it the robot is at the origin, with the heading {theta}. Really it drives "
    "along an arc of a circle. The program uses the old heading instead: it lets the robot drive "
    "straight, and then turn. How far is the program's place of the middle of its axle from "
    "the real one?",
    given={
        "D": number_range(20, 80, 5, "cm"),
        "turn": number_range(15, 60, 5, "°"),
        "theta": number_range(20, 160, 10, "°"),
    },
    unknowns=(Unknown("error", "m"),),
    right=lambda D, turn, theta: gap(turn, D, theta, theta),
    wrong={lost_heading: lambda D, turn, theta: gap(turn, D, turn, theta)},
    likely_slips={
        "by the rule of the middle heading": lambda D, turn, theta: gap(
            turn, D, theta + turn / 2, theta
        ),
    },
    solution=Solution(
        "By the old heading the robot goes straight on:\n\n{old}\n\n"
        "The real way is an arc:\n\n{real}\n\nThe distance between the two places:\n\n{error}"
        "\n\nThe straight line between the ends of the arc points along the middle heading. So "
        "the rule of the middle heading would be much nearer:\n\n{middle}\n\n"
        "It is off by {middle_error.value} only.",
        answer=("error",),
        old=Step(formulas.old_heading, BY_TURN, part=(0, 1), values=(X_OLD, Y_OLD), unit="m"),
        real=Step(formulas.exact_arc, BY_TURN, textbook=True, part=(0, 1), unit="m"),
        error=Step(OLD_ERROR),
        middle=Step(
            formulas.middle_heading,
            BY_TURN,
            part=(0, 1),
            values=(X_MID, Y_MID),
            unit="m",
            expected=lambda D, turn, theta: motion.path([0, 0, theta], D, turn, 1.0, "midpoint")[
                1, :2
            ],
        ),
        middle_error=Step(
            MID_ERROR, expected=lambda D, turn, theta: gap(turn, D, theta + turn / 2, theta)
        ),
    ),
)

odometry_7 = Exercise(
    "odometry-7",
    title="From two counters to a pose",
    text="A robot stands at the origin with the heading {theta}. Its wheels have the radius {r} "
    "and are {b} apart; one turn of a wheel is {C} ticks. Two counters of 16 bits count the ticks. "
    "Before a sample they showed {left_before} (left) and {right_before} (right), after it "
    "{left_after} and {right_after}. No wheel has made more than a few turns. The robot has "
    "driven along the exact arc. What are the x and y of the middle of its axle, and its heading "
    "now?",
    given={
        "theta": number_range(100, 170, 5, "°"),
        "r": number_range(3, 6, 1, "cm"),
        "b": number_range(30, 60, 5, "cm"),
        "C": one_of(500, 512, 1000),
        "left_before": number_range(64850, 65450, 50),
        "left_after": number_range(20, 620, 40),
        "right_before": number_range(1500, 2500, 100),
        "right_after": number_range(2000, 4000, 100),
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), angle("θ")),
    right=counted,
    wrong={
        lost_heading: partial(counted, step=without_heading),
        arctan_heading: half_seen_pose,
        ticks_per_radian: partial(counted, roll=rolled_per_radian),
        counter_jump: partial(counted, count=jumped),
    },
    together={
        (lost_heading, ticks_per_radian): partial(
            counted, step=without_heading, roll=rolled_per_radian
        ),
        (lost_heading, counter_jump): partial(counted, step=without_heading, count=jumped),
        (arctan_heading, ticks_per_radian): partial(half_seen_pose, roll=rolled_per_radian),
        (arctan_heading, counter_jump): partial(half_seen_pose, count=jumped),
        (ticks_per_radian, counter_jump): partial(counted, roll=rolled_per_radian, count=jumped),
    },
    when=lambda **drive: backward(counted(**drive)[2]) and 0.2 < abs(turn_between(**drive)) < 2.0,
    likely_slips={
        "by the rule of the old heading": partial(counted, rule="start"),
        "by the rule of the new heading": partial(counted, rule="end"),
        "by the rule of the middle heading": partial(counted, rule="midpoint"),
        "along the exact arc of a robot that starts with heading 0": arc_from_zero,
        "when the heading at the start is forgotten, in the arc and in the answer": partial(
            counted_from, 0.0
        ),
    },
    solution=Solution(
        "The left counter went past its last number to 0. It has as many numbers as its bits "
        "allow:\n\n{span}\n\nFor each counter the shorter way round is meant. A formula with "
        "the rest of a division finds it:\n\n{left}\n\n{right_ticks}\n\n"
        "So far the wheels roll:\n\n{ways}\n\n"
        "The middle of the axle drives the mean of the two, and the robot turns by their "
        "difference over the wheel distance:\n\n{distance}\n\n{turned}\n\n"
        "From the origin this is an arc:\n\n{pose}",
        span=Step(SPAN, expected=lambda **_: 2**BITS),  # the formula for both ways is even in it
        left=Step(formulas.counter_step, readings("left"), values=(formulas.N_L,)),
        right_ticks=Step(formulas.counter_step, readings("right"), values=(formulas.N_R,)),
        ways=Step(formulas.travel),
        distance=Step(formulas.distance),
        turned=Step(formulas.turn),
        pose=Step(formulas.exact_arc, {planar.x: 0, planar.y: 0}, textbook=True, unit=POSE_UNITS),
    ),
)

ROOM, LOST_MOST, MOST = symbols("room g n")
# five ends, in cm from their middle
OFFSETS = ((1, -2), (-1, 0), (2, 1), (-2, 2), (0, -1))


def five_ends(place):
    """Return the five ends round a middle as words, in cm."""
    ends = [f"({100 * place[0] + dx:.0f}, {100 * place[1] + dy:.0f})" for dx, dy in OFFSETS]
    return ", ".join(ends).replace("-", "−")


def calibrated(x_cw, y_cw, x_ccw, y_ccw, side, b):
    """Return the wheel distance and the ratio that the ends of squares mean."""
    ends = (np.array([[x_cw, y_cw]]), np.array([[x_ccw, y_ccw]]))
    return list(odometry.umbmark(*ends, side=side, wheel_distance=b))


def spread(noise, drive, b):
    """Return the standard deviations of the heading and across a straight drive."""
    return [np.sqrt(2 * noise * drive) / b, np.sqrt(2 * noise * drive**3 / 3) / b]


def readings_lost(span, most):
    """Return how many readings in a row may be lost, so that fewer ticks pass than half a span."""
    return np.ceil(span / 2 / most) - 2


odometry_8 = Exercise(
    "odometry-8",
    title="The size of a door",
    text="The right wheel of a robot slips once: its encoder counts {slip} that the robot does not "
    "drive. The wheels are {b} apart. From where the left wheel stands at that moment it is "
    "{lever} to the end of the drive, in a straight line. By which angle δ does the odometry's "
    "picture of the rest swing? And how far does this shift the end, by the formula for small "
    "angles?",
    given={
        "slip": number_range(1, 6, 0.5, "cm"),
        "b": number_range(20, 50, 5, "cm"),
        "lever": number_range(1, 3, 0.1, "m"),
    },
    unknowns=(Unknown("δ", "rad", circle=True), Unknown("shift", "m")),
    right=lambda slip, b, lever: [slip / b, slip / b * lever],
    wrong={},
    likely_slips={
        "with half the wheel distance, as if the robot turned about its middle": (
            lambda slip, b, lever: [2 * slip / b, 2 * slip / b * lever]
        ),
        "without the lever: the shift is the slip itself": lambda slip, b, lever: [slip / b, slip],
    },
    solution=Solution(
        "The robot does not move, but the odometry lets the right wheel roll on. It turns about "
        "the other wheel, which is b away:\n\n{angle}\n\nAll that follows turns with it. The end "
        "moves on a circle about the left wheel's contact, by the angle times the lever:\n\n"
        "{shift}",
        answer=(("angle", "shift"),),
        angle=Step(formulas.door_angle, values=(formulas.swing,)),
        shift=Step(formulas.door_shift, values=(formulas.shift,)),
    ),
)

odometry_9 = Exercise(
    "odometry-9",
    title="How sure after a straight drive?",
    text="Each wheel of a robot errs by itself; over a metre its standard deviation is {error}. "
    "The wheels are {b} apart. The robot drives {drive} straight on. What are the standard "
    "deviations of its heading and of its place across the drive?",
    given={
        "error": number_range(2, 10, 1, "mm"),
        "b": number_range(20, 50, 5, "cm"),
        "drive": number_range(1, 6, 0.5, "m"),
    },
    unknowns=(Unknown("σ_θ", "rad", circle=True), Unknown("σ_y", "m")),
    right=lambda error, b, drive: spread(error**2, drive, b),
    wrong={},
    likely_slips={
        "with one wheel that errs, where both do": lambda error, b, drive: [
            each / np.sqrt(2) for each in spread(error**2, drive, b)
        ],
        "with the longest lever for all slips; the third is missing": lambda error, b, drive: [
            spread(error**2, drive, b)[0],
            spread(error**2, drive, b)[0] * drive,
        ],
    },
    derive=lambda error, **_: {"noise": error**2},
    solution=Solution(
        "Variances add. Over a metre that of a wheel is k, the square of its standard deviation: "
        "{noise:.6f} m. Each slip ε turns the robot by ε/b, and both wheels slip. A slip with the "
        "distance q left to drive has about the lever q; the mean of q² over the drive is s²/3:"
        "\n\n{both}",
        both=Step(formulas.straight_spread),
    ),
)

odometry_10 = Exercise(
    "odometry-10",
    title="Squares of your own",
    text="A robot that believes in a wheel distance of {b} drives squares of side {side}, five "
    "each way, and each time its odometry says that it is home. Really the clockwise ones end at "
    "x, y = {cw} cm from the start, the counter-clockwise ones at {ccw} cm. What are its true "
    "wheel distance and the ratio of the wheels' diameters, right by left?",
    given={
        "x_cw": number_range(-16, -4, 1, "cm"),
        "y_cw": number_range(-16, -4, 1, "cm"),
        "x_ccw": number_range(-12, 12, 1, "cm"),
        "y_ccw": number_range(-12, 12, 1, "cm"),
        "side": one_of(2, 2.5, 3, 4, unit="m"),
        "b": number_range(20, 50, 5, "cm"),
    },
    unknowns=(Unknown("b", "m", tolerance=6e-5), Unknown("ratio", tolerance=6e-5)),
    right=calibrated,
    wrong={},
    likely_slips={
        "when the two ways are exchanged": lambda x_cw, y_cw, x_ccw, y_ccw, **robot: calibrated(
            x_ccw, y_ccw, x_cw, y_cw, **robot
        ),
        "when x and y of the counter-clockwise ends are exchanged": (
            lambda x_ccw, y_ccw, **rest: calibrated(x_ccw=y_ccw, y_ccw=x_ccw, **rest)
        ),
    },
    when=lambda x_cw, y_cw, x_ccw, y_ccw, **_: (
        abs(x_ccw - y_ccw) > 0.03 and abs(x_cw + y_cw - x_ccw - y_ccw) > 0.03
    ),
    derive=lambda x_cw, y_cw, x_ccw, y_ccw, **_: {
        "cw": five_ends((x_cw, y_cw)),
        "ccw": five_ends((x_ccw, y_ccw)),
    },
    solution=Solution(
        "The middles of the five ends are ({x_cw}, {y_cw}) clockwise and ({x_ccw}, {y_ccw}) "
        "counter-clockwise; in them random errors mostly cancel. Their sum and difference give the "
        "angle by which a corner turns too little, and the one by which a side swings to the left:"
        "\n\n{angles}\n\nShort corners mean another wheel distance, swinging sides unequal wheels:"
        "\n\n{sizes}",
        angles=Step(formulas.calibration_angles),
        sizes=Step(formulas.calibration),
    ),
)

with as_written():
    MOST_LOST = LocalEquation(LOST_MOST, ceiling(formulas.counter_span / (2 * MOST)) - 2)

odometry_11 = Exercise(
    "odometry-11",
    title="Lost readings",
    text="A counter has {span} numbers. Between two readings, one after the other, its wheel makes "
    "at most {most} ticks, forward or backward. Readings can get lost. How many in a row may be "
    "lost at most, so that the shorter way round is still right for certain: fewer ticks than half "
    "the numbers?",
    given={"span": one_of(256, 1024, 4096, 65536), "most": number_range(10, 120, 5)},
    unknowns=(integer("g"),),
    right=readings_lost,
    wrong={},
    likely_slips={
        "with the whole counter: then the sign is not known": lambda span, most: readings_lost(
            2 * span, most
        ),
        "when g lost readings are taken for g steps; they make g + 1": lambda span, most: (
            readings_lost(span, most) + 1
        ),
    },
    when=lambda span, most: readings_lost(span, most) >= 1,
    solution=Solution(
        "With g readings lost, g + 1 steps pass, and at most (g + 1) n ticks. That must be less "
        "than half of the counter's numbers. The largest such g is\n\n{lost}",
        lost=Step(MOST_LOST, {formulas.counter_span: "span", MOST: "most"}),
    ),
)
