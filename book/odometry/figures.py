"""The live figures of the chapter on odometry: a robot vacuum in its room, all the way."""

from itertools import pairwise
from math import log, sqrt
from typing import Any

import numpy as np
import sympy as sp
from sympy import (
    Abs,
    And,
    Max,
    Min,
    Mod,
    Piecewise,
    Symbol,
    atan2,
    cos,
    nan,
    pi,
    sin,
    symbols,
)

from book import things
from book.differential_drive.figures import guess_x, guess_y, t
from book.differential_drive.formulas import b, r, v_L, v_R
from book.dragging import towards
from book.frames.figures import point_of
from book.letters import put_back
from book.motion.formulas import theta, x, y
from book.odometry import formulas as odometry
from book.odometry.exercises import arctan_heading, counter_jump, lost_heading, ticks_per_radian
from book.odometry.formulas import (
    D_L,
    D_R,
    N_L,
    N_R,
    C,
    D,
    b_true,
    count_before,
    count_now,
    counter_span,
    drive,
    dtheta,
    lever,
    noise,
    ratio,
    shift,
    slip,
    swing,
)
from book.things.graph import Graph
from courseware.equations import Equation, as_written, declarations, substitute
from courseware.figures import (
    POINTER,
    AngleArc,
    Area,
    Arrow,
    Choice,
    Clock,
    Cloud,
    Curve,
    Figure,
    Goal,
    Handle,
    Label,
    Length,
    Line,
    NamedSteps,
    Point,
    Readout,
    Recurrence,
    Slider,
    Sprite,
    Trail,
    assign,
    distance,
    when,
)
from robokin import motion
from robokin import odometry as library

quantity, _ = declarations(__name__)

# the robot of the exercise
TICKS, RADIUS, BASE = 512, 0.05, 0.2  # ticks a turn, wheel radius, wheel distance [m]
LEFT, RIGHT = 3072, 5120  # ticks of its wheels on a whole circle
CIRCLE = 0.4  # m, radius of that circle
SAMPLE, SAMPLE_TIME = {N_L: 384, N_R: 640}, 0.5  # ticks, and s, of the exercise
HALF = BASE / 2
ORIGIN, AT_ORIGIN = (0, 0), (0, 0, 0)
DEGREE = pi / 180
TABLE = np.random.default_rng(7).normal(size=(200, 2, 6)).round(2)  # of all drives that err

K = 1e-4  # m: variance of a wheel's travel per metre
HOLDS_95 = sqrt(-2 * log(0.05))  # half-axis of the ellipse that holds 95 %, by σ

samples = quantity("samples", "", 3, 32, "number of samples of the encoders", latex="n")
turned = quantity("turned", "rad", 0, 6.3, "how far the robot turns in a drive", latex=r"\Phi")
wheel_error = quantity(
    "wheel_error", "m", 0.001, 0.03, "standard deviation of a wheel's travel over 1 m"
)
minutes = quantity("minutes", "s", 0, 60, "time of the whole drive", latex="T")
near = quantity("near", "m", 0, 0.2, "how near to the dock the belief has to end")
dock_x = quantity("dock_x", "m", -2, 2, "where the robot is to stop, along x")
dock_y = quantity("dock_y", "m", -2, 2, "where the robot is to stop, along y")
dock_heading = quantity("dock_heading", "rad", -9, 9, "how the robot looks where it is to stop")
way = quantity("way", "m", 0, 0.4, "how far the wheel has rolled")
bend = quantity("bend", "rad", -3, 3, "how much the first half turns more than the second")
part = quantity("part", "", 0, 1, "part of the way before the slip")
count = quantity("count", "", 0, 200, "how many are shown")
set_off = quantity("set_off", "rad", -3.2, 3.2, "heading at the start", latex=r"\theta_0")
guess_b = quantity("guess_b", "m", 0.19, 0.22, "your wheel distance")
guess_ratio = quantity("guess_ratio", "", 0.97, 1.03, "your ratio of the wheels")
s = Symbol("s")


def vacuum(pose: Any, rolled: Any = (0, 0), look: str = "") -> Sprite:
    """Return the robot of the chapter; rolled: how far each of its wheels has."""
    return things.vacuum(pose, rolled, look, half=HALF)


def arc_to(length: Any, angle: Any, start: Any = AT_ORIGIN) -> Any:
    """Return the pose at the end of an exact arc."""
    values = dict(zip((x, y, theta), start, strict=True))
    return odometry.exact_arc.substitute({**values, D: length, dtheta: angle})


def roll(left: Any, right: Any, start: Any = AT_ORIGIN, apart: Any = BASE) -> Any:
    """Return the pose after both wheels rolled so far, along an exact arc."""
    return arc_to((left + right) / 2, (right - left) / apart, start)


def tracks(pose: Any, high: Any, low: Any = 0) -> tuple[Curve, ...]:
    """Return the strips that both wheels roll out; pose: an expression of s."""
    sides = (("left", HALF), ("right", -HALF))
    return tuple(Curve(kind, point_of(pose, 0, side), s, low, high) for kind, side in sides)


def inline_steps(steps: Any, values: dict[Any, Any]) -> dict[Any, Any]:
    """Return named steps, each written out in the symbols of the first ones."""
    known = dict(values)
    for symbol, expression in steps:
        known[symbol] = substitute(expression, known)
    return known


# --- Opening

PIECES_IN_DARK, DARK_NOISE = 16, 1.6e-3  # m: variance of a wheel's travel per metre
START = (0, 0, pi / 2)
WAYS = {  # seconds, how near to the dock its belief has to end, and where that is
    f"{time:.0f} s": (time, close, *(float(u) for u in arc_to(v * time, w * time, START)))
    for time, close, v, w in ((6.0, 0.05, 0.14, 0.2), (16.0, 0.1, 0.115, 0.3))
}
ARROW = 2  # s: an arrow is as long as the way in this time
index = Symbol("piece")  # of a drive that errs


def from_table(row: int, wheel: int) -> Any:
    """Return the random number of the piece that a loop is at."""
    numbers = TABLE[row : row + 3, wheel].ravel()[:PIECES_IN_DARK]
    cases = [(float(z), sp.Lt(index, k + 0.5)) for k, z in enumerate(numbers[:-1])]
    return Piecewise(*cases, (float(numbers[-1]), True))


def real_loop() -> Recurrence:
    """Return the real drive, whose wheels err a little in each piece."""
    with as_written():
        told = [u * minutes / PIECES_IN_DARK for u in (v_L, v_R)]
        rolled = [
            way + sp.sqrt(DARK_NOISE * Abs(way)) * from_table(17, wheel)
            for wheel, way in enumerate(told)
        ]
    return Recurrence(
        (x, y, theta, index),
        start=(*START, 0),
        step=(*roll(rolled[0], rolled[1], (x, y, theta)), index + 1),
        count=sp.Integer(PIECES_IN_DARK),
        most=PIECES_IN_DARK,
        ends=symbols("x_real y_real t_real piece_real"),
    )


def tips() -> tuple[tuple[Any, ...], tuple[Handle, ...]]:
    """Return the arrows of both wheels at the start, and handles at their tips."""
    ends = [point_of(START, ARROW * v, side) for v, side in ((v_L, HALF), (v_R, -HALF))]
    arrows = tuple(
        Arrow(v, point_of(START, 0, side), end)
        for (v, side), end in zip(((v_L, HALF), (v_R, -HALF)), ends, strict=True)
    )
    speed = POINTER[1] / ARROW
    return arrows, (
        Handle("tip of the left wheel's arrow", ends[0], {v_L: speed}),
        Handle("tip of the right wheel's arrow", ends[1], {v_R: speed}),
    )


def counter(symbol: Any, at: Any, long: float, number: str) -> tuple[Any, ...]:
    """Return a counter that shows a number, with its letter beside it."""
    box, beside = things.counter((*at, 0), long, long / 2), (at[0] - 0.75 * long, at[1])
    return box, Label("text", at, number), Label(symbol, beside)


def docks(pose: Any) -> Sprite:
    """Return the dock for a robot that stops at a pose."""
    return things.dock((*point_of(pose, 0.2), pose[2] + pi))


def dark_figure() -> Figure:
    """Draw the opening: drive to the dock by belief alone; then the light goes on."""
    real, dock = real_loop(), (dock_x, dock_y, dock_heading)
    believed, end = (roll(v_L * time, v_R * time, START) for time in (minutes * s, minutes))
    lit = distance(end, dock) < near
    arrows, handles = tips()
    now = substitute(sp.Matrix(believed), {s: Min(t / minutes, 1)})
    gap, there = distance(real.ends, end), real.ends[:2]
    counted = [v * Min(t, minutes) * TICKS / (2 * pi * RADIUS) for v in (v_L, v_R)]
    wheels = (("left", HALF), ("right", -HALF))
    return Figure(
        name="dark-room",
        title="A dark room with a dock; of the robot vacuum only its own belief is seen",
        view=(-1.25, 0.95, -0.62, 0.9),
        ground="night",
        size="laboratory",
        controls=(
            Slider(v_L, -0.1, 0.25, start=0.1, step=0.005),
            Slider(v_R, -0.1, 0.25, start=0.1, step=0.005),
            Choice("drive_home", "drive for", (minutes, near, dock_x, dock_y, dock_heading), WAYS),
            Clock(t, 0.0, 16.0, start=16.0, step=0.2, rate=4.0, label="time"),
        ),
        shapes=(
            *when(lit, things.lamplight((-0.15, 0.14, 0), 1.6)),
            docks(dock),
            Curve("ghost", believed, s, 0, 1),
            *(
                when(lit, Trail(kind, point_of((x, y, theta), 0, side), real, dots=False))[0]
                for kind, side in wheels
            ),
            *when(lit, Line("error", (there, end)), vacuum((*there, real.ends[2]))),
            vacuum(now, look="ghost"),
            Point("ghost", now, "belief"),
            *arrows,
            *counter(N_L, (0.72, -0.16), 0.36, "{left}"),
            *counter(N_R, (0.72, -0.44), 0.36, "{right}"),
            Label("target", point_of(dock, 0.36), "dock"),
        ),
        handles=handles,
        readouts=(
            Readout("left", "left counter, ticks", counted[0], "", 0, symbol=N_L),
            Readout("right", "right counter, ticks", counted[1], "", 0, symbol=N_R),
            Readout("away", "belief to the dock", distance(end, dock), "cm", 0),
            Readout(
                "gap", "robot to belief", Piecewise((gap, lit), (nan, True)), "cm", 0,
                words={"nan": "dark"},
            ),
        ),
        goal=tuple(
            Goal(
                And(lit, Abs(minutes - time) < 1),
                f"Belief to the dock in {name}: within {100 * close:.0f} cm.",
            )
            for name, (time, close, *_) in WAYS.items()
        ),
    )  # fmt: skip


def exercise_figure() -> Figure:
    """Draw the robot of the exercise with all its symbols, at rest."""
    return Figure(
        name="encoder-exercise",
        title=(
            "A robot vacuum from above that looks along the x axis, two wheels at its sides, and "
            "two counters that show 384 for the left wheel and 640 for the right one"
        ),
        view=(-0.42, 0.62, -0.38, 0.38),
        ground="tiles",
        shapes=(
            Arrow("x_axis", ORIGIN, (0.52, 0), "x"),
            Arrow("y_axis", ORIGIN, (0, 0.35), "y"),
            vacuum(AT_ORIGIN),
            Length(b, (-0.02, HALF), (-0.02, -HALF), aside=-0.25, label="b = 20 cm"),
            Length(r, (-0.05, -HALF), (0, -HALF), aside=-0.12, label="r = 5 cm"),
            *counter(N_L, (0.42, 0.28), 0.28, str(SAMPLE[N_L])),
            *counter(N_R, (0.42, -0.28), 0.28, str(SAMPLE[N_R])),
        ),
    )


# --- 1 A tick

SLOTS = 12  # of a coarse disc, so that one sees them
WHEEL_AT, RULER_AT = 0.1, -0.02


def pulses(high: float, rises: float) -> Line:
    """Return what a light gate tells along the way; rises: at which part of a tick light comes."""
    tick = float(2 * pi * RADIUS / SLOTS)
    edges = [tick * (rises + k / 2) for k in range(2 * SLOTS + 8)]
    points = []
    for k, (one, other) in enumerate(pairwise([0.0, *(e for e in edges if e < 0.4), 0.4])):
        level = high + 0.022 * (k % 2)
        points += [(one, level), (other, level)]
    return Line("path", tuple(points))


def tick_figure() -> Figure:
    """Draw a wheel from the side with its slotted disc and light gates, rolled by hand."""
    hub = (way, RADIUS, 0)
    counted = sp.floor(way * SLOTS / (2 * pi * RADIUS) + sp.Rational(7, 8))
    return Figure(
        name="tick",
        title="A wheel from the side on a ruler, its slotted disc, two light gates and a counter",
        view=(-0.1, 0.5, -0.19, 0.215),
        ground="wall",
        controls=(Slider(way, 0.0, 0.4, start=0.0, step=0.001, label="distance rolled"),),
        shapes=(
            things.ruler((0, 0, 0), 0.1, 4),
            *(Label("text", (k / 10, -0.036), str(10 * k)) for k in range(5)),
            Label("text", (0.45, -0.036), "cm"),
            things.encoder_wheel((*hub[:2], pi / 2), way, RADIUS, SLOTS, "right2"),
            things.light_gate(hub, RADIUS, SLOTS),
            pulses(-0.095, 1 / 8),
            pulses(-0.15, 3 / 8),
            Line("right", ((way, -0.06), (way, -0.17))),
            *(Label("text", (x, y), "A") for x, y in ((-0.04, -0.086), (way - 0.03, 0.13))),
            *(Label("text", (x, y), "B") for x, y in ((-0.04, -0.141), (way + 0.03, 0.13))),
            things.counter((0.43, 0.178, 0), 0.1, 0.056),
            Label("text", (0.43, 0.178), "{counted}"),
        ),
        handles=(Handle("the wheel", hub[:2], {way: POINTER[0]}),),
        readouts=(Readout("counted", "counter, ticks", counted, "", 0, symbol=N_R),),
        goal=Goal(And(counted > 6.5, counted < 7.5), "Roll the wheel until the counter shows 7."),
        grid=False,
    )


# --- 2 The turn

EXERCISE = {D_L: 0.2356, D_R: 0.3927}
STRIP = -0.24  # m, where the strips lie side by side


def strips_figure() -> Figure:
    """Draw the strips that two wheels roll out, on the ground and side by side."""
    end, along = roll(D_L, D_R), roll(s * D_L, s * D_R)
    longer = (Max(D_L, D_R), Min(D_L, D_R))
    return Figure(
        name="strips",
        title="The robot rolls out two strips of paper, which lie side by side at the left, too",
        view=(-0.34, 0.62, -0.3, 0.36),
        ground="tiles",
        controls=(
            Slider(D_L, -0.1, 0.4, start=0.2, step=0.001, label="left strip D_L"),
            Slider(D_R, -0.1, 0.4, start=0.2, step=0.001, label="right strip D_R"),
        ),
        where=((b, BASE), *assign(odometry.distance, odometry.turn)),
        shapes=(
            vacuum(AT_ORIGIN, look="ghost"),
            *tracks(along, 1),
            vacuum(end, (D_L, D_R)),
            *when(Abs(dtheta) > 0.15, AngleArc(dtheta, end[:2], 0, dtheta, 0.2)),
            Line("ghost", (end, (end[0] + 0.24, end[1]))),
            Arrow("heading", end, point_of(end, 0.24), ""),
            Area("left", _strip(STRIP, D_L)),
            Area("right", _strip(STRIP + 0.04, D_R)),
            *when(
                Abs(D_R - D_L) > 0.03,
                Length(
                    "turning",
                    (STRIP - 0.03, longer[1] - 0.15),
                    (STRIP - 0.03, longer[0] - 0.15),
                    "",
                ),
                Label("turning", (STRIP, longer[0] - 0.1), "difference"),
            ),
        ),
        handles=(
            Handle("end of the left strip", (STRIP, D_L - 0.15), {D_L: POINTER[1] + 0.15}),
            Handle("end of the right strip", (STRIP + 0.04, D_R - 0.15), {D_R: POINTER[1] + 0.15}),
        ),
        readouts=(Readout(D), Readout(dtheta)),
        goal=(
            Goal(
                And(Abs(D_L) < 0.006, Abs(dtheta - pi / 2) < 3 * DEGREE),
                "Hold the left wheel still, and turn by 90°: within 3°.",
            ),
            Goal(And(Abs(D) < 0.006, Abs(dtheta) > 0.5), "Turn on the spot, by more than 30°."),
        ),
    )


def _strip(left: float, long: Any) -> tuple[Any, ...]:
    low = -0.15
    return ((left, low), (left + 0.03, low), (left + 0.03, low + long), (left, low + long))


LONG = 1.2  # m, the drive that is bent


def bent_figure() -> Figure:
    """Draw a drive that is bent into any shape; its two strips keep their difference."""
    turns = (turned + bend) / 2, (turned - bend) / 2
    first = arc_to(LONG / 2 * s, turns[0] * s)
    middle = arc_to(LONG / 2, turns[0])
    second = arc_to(LONG / 2 * s, turns[1] * s, middle)
    end = arc_to(LONG / 2, turns[1], middle)
    return Figure(
        name="bent",
        title="A drive of two arcs that is bent, and the strips of its two wheels",
        view=(-0.5, 1.6, -0.65, 0.85),
        ground="tiles",
        controls=(
            Slider.degrees(turned, 0, 120, start=45, step=5, label="turned in all Φ"),
            Slider.degrees(bend, -150, 150, start=0, step=5, label="first half more than second"),
        ),
        where=(
            (b, BASE),
            (D_L, LONG - BASE * turned / 2),
            (D_R, LONG + BASE * turned / 2),
        ),
        shapes=(
            vacuum(AT_ORIGIN, look="ghost"),
            *tracks(first, 1),
            *tracks(second, 1),
            vacuum(end),
            Arrow("heading", end, point_of(end, 0.34), "Φ"),
        ),
        readouts=(
            Readout(D_L, "left strip D_L"),
            Readout(D_R, "right strip D_R"),
            Readout("difference", "difference", D_R - D_L, "cm", 1),
        ),
        goal=Goal(
            And(Abs(end[1]) < 0.02, Abs(turned - 60 * DEGREE) < 3 * DEGREE),
            "Turned by 60°, end on the line that it looked along at first: within 2 cm.",
        ),
    )


# --- 3 Where is it?


def guess_figure() -> Figure:
    """Draw a place to guess: where the robot of the exercise is after its sample."""
    rolled, so_far = ([EXERCISE[D] * u / SAMPLE_TIME for D in (D_L, D_R)] for u in (t, s))
    end, along = roll(*rolled), roll(*so_far)
    return Figure(
        name="rule-guess",
        title="The robot of the exercise at its start, and your guess of where it is after it",
        view=(-0.25, 0.6, -0.24, 0.34),
        ground="tiles",
        controls=(
            Slider(guess_x, -0.1, 0.5, start=0.1, step=0.005, label="x"),
            Slider(guess_y, -0.2, 0.3, start=-0.1, step=0.005, label="y"),
            Clock(t, 0.0, SAMPLE_TIME, step=0.01, rate=0.25, label="time"),
        ),
        shapes=(
            vacuum(AT_ORIGIN, look="ghost"),
            Line("ghost", (ORIGIN, (0.6, 0))),
            *tracks(along, t),
            vacuum(end, rolled),
            Point("target", (guess_x, guess_y), "your guess"),
        ),
        handles=(Handle("your guess", (guess_x, guess_y)),),
    )


RULES = (
    ("old_heading", odometry.old_heading, "old"),
    ("new_heading", odometry.new_heading, "new"),
    ("middle_heading", odometry.middle_heading, "middle"),
)


def rules_step_figure() -> Figure:
    """Draw one sample by four rules: straight on along one of three headings, and the arc."""
    known = {x: 0, y: 0, theta: 0}
    ends = {kind: substitute(rule.right, known) for kind, rule, _ in RULES}
    end, along = arc_to(D, dtheta), arc_to(D * s, dtheta * s)
    return Figure(
        name="rules-step",
        title="One sample: the arc, and three straight steps along the old, new, middle heading",
        view=(-0.2, 0.66, -0.2, 0.4),
        ground="tiles",
        controls=(
            Slider(D, 0.1, 0.45, start=0.31, step=0.01),
            Slider.degrees(dtheta, 0, 90, start=45, step=5),
        ),
        shapes=(
            vacuum(AT_ORIGIN, look="ghost"),
            vacuum(end, (D, D)),
            *(Arrow(kind, ORIGIN, ends[kind], "") for kind, *_ in RULES),
            Curve("path", along, s, 0, 1),
            *(Point(kind, ends[kind], word) for kind, _, word in RULES),
            Point("path", arc_to(D / 2, dtheta / 2), "arc"),
        ),
        readouts=tuple(
            Readout(
                f"off_{word}", f"{word} heading off by", distance(ends[kind], end), "cm", 1,
                symbol=kind,
            )
            for kind, _, word in RULES
        ),
        goal=Goal(
            And(distance(ends["old_heading"], end) < 0.03, D > 0.299, dtheta > 9.9 * DEGREE),
            "Drive at least 30 cm and turn at least 10° with the old heading off by less than "
            "3 cm.",
        ),
    )  # fmt: skip


# --- 4 Many samples


def motion_in_sample(ticks: Any, travel: Any = odometry.travel) -> tuple[Any, Any]:
    """Return how far the robot moves and turns in a sample, from the ticks of its wheels."""
    rolled = travel.substitute({N_L: ticks[0], N_R: ticks[1], C: TICKS, r: RADIUS})
    wheels = {D_L: rolled[0], D_R: rolled[1]}
    return odometry.distance.substitute(wheels), odometry.turn.substitute({**wheels, b: BASE})


def rule_loop(rule: Equation, name: str) -> Recurrence:
    """Return the drive by one rule; its state ends with the largest error so far."""
    state = (x, y, theta, D, dtheta, Symbol("worst"))
    with as_written():
        ticks = [each * (turned / (2 * pi)) / samples for each in (LEFT, RIGHT)]
        angle = theta + dtheta
        there = arc_to(CIRCLE * angle, angle)
    place = rule.right
    worst = Max(state[-1], distance(place, there), evaluate=False)
    return Recurrence(
        state,
        start=(0, 0, 0, *motion_in_sample(ticks), 0),
        step=(*place, D, dtheta, worst),
        count=samples,
        most=32,
        ends=symbols(" ".join(f"{part}_{name}" for part in ("x", "y", "t", "D", "d", "worst"))),
    )


def rules_figure() -> Figure:
    """Draw one drive in n samples, by the rules; and how its largest error falls."""
    old = rule_loop(odometry.old_heading, "old")
    new = rule_loop(odometry.new_heading, "new")
    middle = rule_loop(odometry.middle_heading, "middle")
    graph = Graph((0.78, 1.3, -0.03, 0.72), (1, 100), (1e-4, 1), ("samples", "error in m"))
    with as_written():
        end = arc_to(CIRCLE * turned, turned)
        widest = 2 * CIRCLE * sin(Min(turned, pi) / 2)
        half = turned / s / 2
        longer = half / sin(half)
        off = sp.sqrt((longer - 1) ** 2 + 4 * longer * sin(half / 2) ** 2)
    loops = tuple(zip(RULES, (old, new, middle), strict=True))
    first = {x: 0, y: 0, theta: 0, D: CIRCLE * turned / samples, dtheta: turned / samples}
    laws = (("old_heading", widest * off), ("middle_heading", widest * (longer - 1)))
    return Figure(
        name="four-rules",
        title="One drive read in samples, by three rules; beside it the largest error of each",
        view=(-0.62, 1.36, -0.28, 1.0),
        ground="paper",
        controls=(
            Slider(samples, 3, 32, start=8, step=1, label="samples in the drive"),
            Slider.degrees(turned, 30, 360, start=270, step=5, label="turned in all"),
        ),
        shapes=(
            Curve("path", arc_to(CIRCLE * s, s), s, 0, turned),
            *(Trail(kind, (x, y), loop) for (kind, *_), loop in loops),
            *(Label(kind, rule.substitute(first)[:2], word) for kind, rule, word in RULES[:2]),
            vacuum(AT_ORIGIN, look="ghost"),
            vacuum(end),
            *graph.shapes(),
            *(Curve(kind, graph.place((s, Max(law, 1e-4))), s, 4, 40, 32) for kind, law in laws),
            *(
                Point(kind, graph.place((samples, Max(loop.ends[-1], 1e-4))), "")
                for (kind, *_), loop in loops
            ),
            *(
                Label(kind, graph.place((30, 2.5 * substitute(law, {s: 30}))), word)
                for (kind, law), word in zip(laws, ("old, new", "middle"), strict=True)
            ),
        ),
        readouts=tuple(
            Readout(word, f"{word}, largest error", loop.ends[-1], "m", 4, symbol=kind)
            for (kind, _, word), loop in loops
        ),
        sentence=(
            "The robot turns by {turned}, read in {samples} samples. Largest error on the way: "
            "old heading {old}, new heading {new}, middle heading {middle}."
        ),
        goal=Goal(
            And(middle.ends[-1] < 0.002, samples < 27, turned > 358 * DEGREE),
            "On the whole circle, keep the middle heading within 2 mm in at most 26 samples.",
        ),
        grid=False,
    )


# --- 5 A door

ARC, TURN = 1.0, 1.4  # m and rad: the S-shaped way has two such arcs, to the left, to the right
S_START = (0, 0, -0.35)
S_MIDDLE = tuple(map(float, arc_to(ARC, TURN, S_START)))
S_END = tuple(map(float, arc_to(ARC, -TURN, S_MIDDLE)))


def on_s(q: Any) -> tuple[Any, ...]:
    """Return the pose after a part of the S-shaped way."""
    halves = (
        arc_to(2 * ARC * q, 2 * TURN * q, S_START),
        arc_to(ARC * (2 * q - 1), TURN * (1 - 2 * q), S_MIDDLE),
    )
    return tuple(Piecewise((a, q < 0.5), (b, True)) for a, b in zip(*halves, strict=True))


def swung(pose: Any, hinge: Any, angle: Any) -> tuple[Any, ...]:
    """Return a pose after a turn about a point."""
    dx, dy = pose[0] - hinge[0], pose[1] - hinge[1]
    return (
        hinge[0] + dx * cos(angle) - dy * sin(angle),
        hinge[1] + dx * sin(angle) + dy * cos(angle),
        pose[2] + angle,
    )


def door_figure() -> Figure:
    """Draw a slip of the right wheel: all that follows swings about the left wheel's contact."""
    here, hinge = on_s(part), point_of(on_s(part), 0, HALF)
    off = POINTER[0] - here[0], POINTER[1] - here[1]
    ahead = off[0] * cos(here[2]) + off[1] * sin(here[2])  # of the place, along the way
    end, along = swung(S_END, hinge, swing), swung(on_s(s), hinge, swing)
    middle = ((hinge[0] + S_END[0]) / 2, (hinge[1] + S_END[1]) / 2)
    return Figure(
        name="door",
        title="An S-shaped way; after a slip of the right wheel its rest swings like a door",
        view=(-0.5, 2.4, -0.65, 1.35),
        ground="tiles",
        controls=(
            Slider(part, 0.0, 0.95, start=0.5, step=0.01, label="where: part of the way"),
            Slider(slip, -0.06, 0.06, start=0.02, step=0.005),
        ),
        where=(
            (b, BASE),
            *assign(odometry.door_angle),
            (lever, distance(hinge, S_END)),
            *assign(odometry.door_shift),
        ),
        shapes=(
            vacuum(S_START, look="ghost"),
            Curve("path", on_s(s), s, 0, 1),
            vacuum(S_END),
            Line(lever, (hinge, S_END)),
            Line(lever, (hinge, end)),
            *when(Abs(slip) > 0.004, Curve("error", along, s, part, 1)),
            vacuum(end, look="wrong"),
            vacuum(here, look="ghost"),
            Point("icr", hinge, ""),
            Label(lever, middle),
        ),
        handles=(
            Handle(
                "place of the slip",
                here[:2],
                {part: part + ahead / (2 * ARC)},
            ),
        ),
        readouts=(
            Readout(swing, "swing δ"),
            Readout(lever, "lever ℓ"),
            Readout(shift, "shift, by the formula"),
        ),
        goal=Goal(
            And(Abs(slip - 0.06) < 0.004, Abs(shift - 0.3) < 0.02),
            "Let a slip of 6 cm shift the end by 30 cm: within 2 cm.",
        ),
    )


TEN = 10


def lever_terms() -> list[tuple[Any, ...]]:
    """Return for each tenth of the S-shaped way both contacts with their bars, and its term.

    A bar is the shift of the end by a slip of that wheel's own size, as large as the ellipse.
    """
    found = []
    for k in range(TEN):
        pose = tuple(float(u) for u in on_s((k + 0.5) / TEN))
        sign = 1 if k < TEN / 2 else -1
        ways = [2 * ARC / TEN + side * sign * 2 * TURN / TEN * HALF for side in (-1, 1)]
        known = dict(zip((odometry.l_x, odometry.l_y), np.subtract(S_END, pose)[:2], strict=True))
        known |= {theta: pose[2], b: BASE, noise: K, **dict(zip((D_L, D_R), ways, strict=True))}
        known = inline_steps(odometry.lever_term.where, known)
        term = [float(u) for u in substitute(odometry.lever_term.right, known)]
        doors = []
        wheels = ((HALF, odometry.lever_L, ways[1]), (-HALF, odometry.lever_R, ways[0]))
        for side, (along, up), rolled in wheels:
            size = HOLDS_95 * sqrt(K * rolled) / BASE
            turned = -size * float(known[up]), size * float(known[along])
            bar = tuple((S_END[0] + f * turned[0], S_END[1] + f * turned[1]) for f in (-1, 1))
            doors.append((tuple(map(float, point_of(pose, 0, side))), bar))
        found.append((doors, term))
    return found


def ten_doors_figure() -> Figure:
    """Draw ten pieces, each with both levers; their terms add up to the ellipse of the end."""
    terms = lever_terms()
    shapes: list[Any] = []
    bars: list[Any] = []
    for k, (doors, _) in enumerate(terms):
        so_far, now = count > k + 0.5, And(count > k + 0.5, count < k + 1.5)
        for contact, bar in doors:
            shapes += when(so_far, Line("ghost", (contact, S_END[:2])), Point("icr", contact, ""))
            shapes += when(now, Line("icr", (contact, S_END[:2])))
            bars += when(so_far, Line("turning", bar))
    steps = NamedSteps()
    xx, xy, yy = (
        steps.add(
            name,
            sp.Add(
                *(Piecewise((e[i], count > k + 0.5), (0, True)) for k, (_, e) in enumerate(terms))
            ),
        )
        for i, name in enumerate(("xx", "xy", "yy"))
    )
    return Figure(
        name="ten-doors",
        title="Slips in ten pieces of the S-shaped way, their levers, and the ellipse of their sum",
        view=(-0.25, 2.1, -0.42, 1.08),
        ground="tiles",
        controls=(Slider(count, 1, TEN, start=1, step=1, label="pieces so far"),),
        where=steps,
        shapes=(
            vacuum(S_START, look="ghost"),
            Curve("path", on_s(s), s, 0, 1),
            *shapes,
            *_ellipse(S_END, (xx, xy, yy)),
            *bars,
        ),
        readouts=(
            Readout("sigma_x", "σ along x", sp.sqrt(xx), "cm", 1),
            Readout("sigma_y_end", "σ along y", sp.sqrt(yy), "cm", 1),
        ),
    )


def _ellipse(centre: Any, entries: Any) -> tuple[Curve, Label]:
    """Return the ellipse that holds 95 % of what has a covariance of x and y, with its label."""
    xx, xy, yy = (HOLDS_95**2 * entry for entry in entries)
    wide, high = sp.sqrt(xx), sp.sqrt(yy)
    at = (
        centre[0] + wide * cos(s),
        centre[1] + xy / wide * cos(s) + sp.sqrt(Max(yy - xy**2 / xx, 0)) * sin(s),
    )
    top = centre[0] + xy / high, centre[1] + high
    return Curve("uncertainty", at, s, 0, 2 * pi), Label("uncertainty", top, "95 %")


# --- 6 Many small doors

STEPS = 6  # samples of the drive


def covariance_loop(
    steps: int = STEPS, count: int = STEPS, k: Any = wheel_error**2, start: Any = 0, name: str = ""
) -> Recurrence:
    """Return the covariance after samples: the wheels' part is computed once, at the start."""
    with as_written():
        half = BASE * turned / 2
        wheels = {D_L: (drive - half) / steps, D_R: (drive + half) / steps, b: BASE, noise: k}
    once = inline_steps(odometry.of_the_wheels, wheels)
    kept = [symbol for symbol, _ in odometry.of_the_wheels]
    entries = odometry.covariance_entries
    each = inline_steps(odometry.of_the_heading, {})
    with as_written():
        step = substitute(odometry.covariance_step.right, {**each, b: BASE})
        next_heading = theta + 2 * odometry.u
    place = arc_to(drive / steps, 2 * odometry.u, (x, y, theta))[:2]
    state = (x, y, theta, *kept, *entries)
    return Recurrence(
        state,
        start=(0, 0, start, *(once[symbol] for symbol in kept), *(0 for _ in entries)),
        step=(*place, next_heading, *kept, *step),
        count=sp.Integer(count),
        most=count,
        ends=symbols(f"e{name}_:{len(state)}", real=True),
    )


def loop_entries(loop: Recurrence) -> tuple[Any, ...]:
    """Return the variances of x, of x and y, and of y, at the end of a loop."""
    xx, xy, _, yy, *_ = loop.ends[-6:]
    return xx, xy, yy


def half_axes(entries: Any) -> Any:
    """Return the half-axes of the ellipse that holds 95 %."""
    values = dict(zip((odometry.p_xx, odometry.p_xy, odometry.p_yy), entries, strict=True))
    steps = inline_steps(odometry.ellipse_axes.where, values)
    return [HOLDS_95 * axis for axis in substitute(odometry.ellipse_axes.right, steps)]


ROW = symbols("row z_L:6 z_R:6", real=True)


def noisy_end() -> tuple[Any, ...]:
    """Return where a drive of the table ends, by the numbers of its row."""
    pose: tuple[Any, ...] = AT_ORIGIN
    half = BASE * turned / 2
    for k in range(STEPS):
        told = [(drive + side * half) / STEPS for side in (-1, 1)]
        left, right = (
            way + wheel_error * sp.sqrt(Abs(way)) * ROW[1 + k + STEPS * wheel]
            for wheel, way in enumerate(told)
        )
        pose = tuple(roll(left, right, pose))
    return pose


def ellipse_figure() -> Figure:
    """Draw two hundred drives, and the ellipse that was computed for them."""
    loop, end = covariance_loop(STEPS), arc_to(drive, turned)
    rows = tuple((k, *map(float, row.ravel())) for k, row in enumerate(TABLE))
    place = noisy_end()
    shown = [Piecewise((u, ROW[0] < count - 0.5), (nan, True)) for u in place[:2]]
    entries, tt = loop_entries(loop), loop.ends[-1]
    long_axis, short_axis = half_axes(entries)
    high = HOLDS_95 * sp.sqrt(entries[2])
    near_by = ((-0.4, -0.5), (0.4, 0.5), (0, -high), (0, high))
    on_way = (arc_to(drive * part, turned * part) for part in (0.25, 0.5, 0.75))
    return Figure(
        name="error-ellipse",
        title="The ends of two hundred drives, and the ellipse that was computed for them",
        view=(-1.1, 1.1, -0.75, 0.75),
        contain=(
            (-0.2, -0.2), (0.2, 0.2), *on_way, *((end[0] + dx, end[1] + dy) for dx, dy in near_by)
        ),
        ground="tiles",
        size="laboratory",
        controls=(
            Slider(
                wheel_error, 0.001, 0.03, start=0.01, step=0.001, kind="uncertainty",
                label="wheel error over 1 m",
            ),
            Slider(drive, 0.25, 3, start=1, step=0.05, label="distance s"),
            Slider.degrees(turned, 0, 360, start=0, step=5, label="turned in all"),
            Clock(count, 0, 200, start=200, step=1, rate=40, label="drives"),
        ),
        shapes=(
            vacuum(AT_ORIGIN, look="ghost"),
            Curve("path", arc_to(drive * s, turned * s), s, 0, 1),
            Trail("ghost", (x, y), loop),
            Cloud("approximation", shown, ROW, rows),
            *_ellipse(end, entries),
        ),
        readouts=(
            Readout("long_axis", "long half axis", long_axis, "m"),
            Readout("short_axis", "short half axis", short_axis, "m"),
            Readout("heading", "heading error", sp.sqrt(tt), "rad"),
        ),
        sentence=(
            "A drive of {drive} that turns by {turned}, with wheels that err by {wheel_error} over "
            "1 m. The ellipse, of half axes {long_axis} and {short_axis}, would hold 95 of 100 "
            "ends if the cloud did not bend. The heading errs by {heading}. {count} drives shown."
        ),
    )  # fmt: skip


# --- 7 Two squares

SIDE, PIECES = 1.0, 6  # m; pieces of a side, so that one sees it bend


def square_loop(turns: int, name: str) -> Recurrence:
    """Return the real way when the encoders report a square: turns to the left 1, right -1.

    The wheels roll what their true diameters make of the ticks, on the true wheel distance.
    """
    piece = Symbol("piece")
    state = (x, y, theta, piece)
    corner = pi / 4 * BASE
    with as_written():
        on_a_side = piece < PIECES - 0.5
        told_left = Piecewise((SIDE / PIECES, on_a_side), (-turns * corner, True))
        told_right = Piecewise((SIDE / PIECES, on_a_side), (turns * corner, True))
        wheels = {D_L: told_left * 2 / (1 + ratio), D_R: told_right * 2 * ratio / (1 + ratio)}
        step = odometry.exact_arc.substitute(
            {
                D: odometry.distance.substitute(wheels),
                dtheta: odometry.turn.substitute({**wheels, b: b_true}),
            }
        )
        next_piece = Piecewise((piece + 1, on_a_side), (0, True))
    ends = symbols(" ".join(f"{part}_{name}" for part in ("x", "y", "t", "piece")), real=True)
    count = sp.Integer(4 * (PIECES + 1))
    return Recurrence(state, (0, 0, 0, 0), (*step, next_piece), count, int(count), ends)


RUNS = 5


def scatter(turns: int) -> tuple[tuple[float, float], ...]:
    """Return how far five square runs of the table end from one without random errors, m."""
    corner = float(pi / 4) * BASE
    told = np.tile([[1.0, 1.0], [-turns * corner, turns * corner]], (4, 1)).T
    numbers = TABLE[: 8 * RUNS].ravel()[: 16 * RUNS].reshape(RUNS, 2, 8)
    wheels = told + 0.004 * np.sqrt(np.abs(told)) * numbers
    ends = motion.path([0, 0, 0], wheels.mean(axis=1), (wheels[:, 1] - wheels[:, 0]) / BASE, 1.0)
    return tuple((float(px), float(py)) for px, py in ends[:, -1, :2])


def mean_of(rows: Any) -> tuple[float, float]:
    """Return the middle of some places."""
    return float(np.mean([row[0] for row in rows])), float(np.mean([row[1] for row in rows]))


def square_figure() -> Figure:
    """Draw squares both ways of a robot with unequal wheels or a wrong wheel distance."""
    cw, ccw = square_loop(-1, "to_right"), square_loop(1, "to_left")
    ends = {
        odometry.x_cw: cw.ends[0], odometry.y_cw: cw.ends[1],
        odometry.x_ccw: ccw.ends[0], odometry.y_ccw: ccw.ends[1],
    }  # fmt: skip
    dx, dy = ROW[:2]
    shapes: list[Any] = []
    for kind, loop, turns in (("left", ccw, 1), ("right", cw, -1)):
        corners = (ORIGIN, (SIDE, 0), (SIDE, turns * SIDE), (0, turns * SIDE), ORIGIN)
        at = (loop.ends[0] + dx, loop.ends[1] + dy)
        shapes += [
            Line("ghost", corners),
            Trail(kind, (x, y), loop, dots=False),
            Cloud(kind, at, (dx, dy), scatter(turns)),
            Point(kind, loop.ends[:2], ""),
        ]
    return Figure(
        name="square-path",
        title="Square drives to the left and to the right of a robot that believes it is right",
        view=(-1.0, 2.2, -1.3, 1.18),
        ground="tiles",
        size="laboratory",
        controls=(
            Slider(b_true, 0.19, 0.21, start=0.206, step=0.001, label="true wheel distance"),
            Slider(ratio, 0.98, 1.02, start=1.006, step=0.002, label="right diameter / left"),
        ),
        shapes=(
            vacuum(AT_ORIGIN, look="ghost"),
            *shapes,
            Label("turning", (SIDE, SIDE), "α"),
            Label("turning", (SIDE / 2, 0), "β"),
            Label("right", (SIDE / 2, -0.7 * SIDE), "clockwise"),
            Label("left", (SIDE / 2, 0.6 * SIDE), "counter-clockwise"),
        ),
        where=(
            *ends.items(),
            (odometry.side, SIDE),
            *assign(odometry.calibration_angles),
        ),
        readouts=(
            Readout(odometry.x_cw, "cw end, x"),
            Readout(odometry.y_cw, "cw end, y"),
            Readout(odometry.x_ccw, "ccw end, x"),
            Readout(odometry.y_ccw, "ccw end, y"),
            Readout(odometry.short_turn, "a corner turns too little by α"),
            Readout(odometry.side_swing, "a side swings by β"),
        ),
        sentence=(
            "With a wheel distance of {b_true} where {base} is believed and diameters of ratio "
            "{ratio}, the clockwise square ends at x = {x_cw}, y = {y_cw}, the counter-clockwise "
            "one at x = {x_ccw}, y = {y_ccw}."
        ).replace("{base}", f"{BASE} m"),
        goal=(
            Goal(
                And(distance(ccw.ends, ORIGIN) < 0.01, distance(cw.ends, ORIGIN) > 0.1),
                "Close the counter-clockwise square within 1 cm, and leave the other open by more "
                "than 10 cm.",
            ),
            Goal(
                And(distance(ccw.ends, ORIGIN) < 0.01, distance(cw.ends, ORIGIN) < 0.01),
                "Close both squares: within 1 cm.",
            ),
        ),
    )


# --- Where it fails

NUMBERS = 2**16  # of a counter of 16 bits


def dial(reading: Any, radius: float = 0.4) -> tuple[Any, Any]:
    """Return the place on the counter's dial: 0 on top, clockwise."""
    return radius * sin(2 * pi * reading / NUMBERS), radius * cos(2 * pi * reading / NUMBERS)


def counter_figure() -> Figure:
    """Draw a counter as a clock face: two readings, and the two ways between them."""
    step, jump = odometry.dN, count_now - count_before
    kept = 2 * pi / NUMBERS
    start, ways = pi / 2 - kept * count_before, (step, jump)
    around = [
        Curve(
            kind,
            (far * cos(start - kept * way * s), far * sin(start - kept * way * s)),
            s, 0, 1,
        )
        for kind, far, way in zip(("path", "error"), (0.3, 0.22), ways, strict=True)
    ]  # fmt: skip
    return Figure(
        name="counter-clock",
        title="A counter of 16 bits as the face of a clock, with two readings on it",
        view=(-0.9, 0.9, -0.56, 0.56),
        ground="wall",
        controls=(
            Slider(count_before, 0, NUMBERS - 1, start=10000, step=1, label="reading c"),
            Slider(count_now, 0, NUMBERS - 1, start=30000, step=1, label="reading c′, later"),
        ),
        where=(
            (counter_span, sp.Integer(NUMBERS)),
            (odometry.dN, odometry.counter_step.right),
        ),
        shapes=(
            Curve("length", (0.4 * cos(s), 0.4 * sin(s)), s, 0, 2 * pi),
            *(
                Line("text", (dial(k * NUMBERS / 8, 0.38), dial(k * NUMBERS / 8, 0.42)))
                for k in range(8)
            ),
            Label("text", (0, 0.48), "0"),
            Label("text", (0.56, 0), "16384"),
            Label("text", (0, -0.49), "32768"),
            Label("text", (-0.56, 0), "49152"),
            *around,
            Line("ghost", (ORIGIN, dial(count_before))),
            Arrow("path", ORIGIN, dial(count_now), ""),
            Point("left", dial(count_before), ""),
            Point("right", dial(count_now), ""),
        ),
        handles=tuple(
            Handle(name, dial(each), {each: Mod(atan2(*POINTER) / (2 * pi), 1) * NUMBERS})
            for name, each in (("reading c", count_before), ("reading c′", count_now))
        ),
        readouts=(
            Readout(odometry.dN, "the shorter way", digits=0),
            Readout("naive", "naive difference", jump, "ticks", 0),
        ),
        goal=Goal(
            And(odometry.dN < 0, jump > 40000),
            "Find two readings with a step back whose naive difference is above 40,000.",
        ),
        grid=False,
    )


ICE_AT, ICE_LENGTH = 0.2, 1.96  # m: where, of the drive


def ice_figure() -> Figure:
    """Draw a straight drive whose wheel slips on ice: the belief, and its ellipse."""
    hinge, end = (ICE_AT, HALF), (ICE_LENGTH, 0, 0)
    angle = slip / BASE
    told, along = swung(end, hinge, angle), swung((s, 0, 0), hinge, angle)
    spread = odometry.straight_spread.substitute({noise: K, drive: ICE_LENGTH, b: BASE})
    across, along_it = float(spread[1]), sqrt(K * ICE_LENGTH / 2)
    turn = sp.Matrix([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])
    xx, xy, _, yy = turn * sp.diag(along_it**2, across**2) * turn.T
    return Figure(
        name="ice",
        title="A robot that drives straight over ice, and its belief, which swings away",
        view=(-0.3, 2.35, -0.6, 1.0),
        ground="tiles",
        controls=(Slider(slip, -0.03, 0.08, start=0.0, step=0.002),),
        where=((b, BASE), *assign(odometry.door_angle)),
        shapes=(
            Area("left", ((0.12, -0.19), (0.3, -0.19), (0.3, -0.02), (0.12, -0.02))),
            Label("left", (0.21, -0.3), "ice"),
            vacuum(AT_ORIGIN, look="ghost"),
            Line("path", (ORIGIN, end)),
            Curve("error", along, s, ICE_AT, ICE_LENGTH),
            vacuum(end),
            vacuum(told, look="wrong"),
            *_ellipse(told, (xx, xy, yy)),
        ),
        readouts=(
            Readout(swing, "belief turned by δ"),
            Readout("aside", "belief's y", told[1], "m"),
            Readout("many", "that is so many σ", told[1] / across, "", 1),
        ),
        goal=Goal(
            Abs(Abs(told[1]) - 3 * across) < 0.01,
            "Find the slip that puts the belief 3 σ beside the robot: within 1 cm.",
        ),
    )


def half_seen_figure() -> Figure:
    """Draw a heading, and what the arctangent of sine over cosine makes of it."""
    seen = sp.atan(sin(set_off) / cos(set_off))
    return Figure(
        name="half-seen",
        title="A robot that turns, and a program that never sees it look backward",
        view=(-0.75, 0.75, -0.45, 0.45),
        ground="tiles",
        controls=(Slider.degrees(set_off, -175, 175, start=60, step=5, label="heading θ"),),
        shapes=(
            vacuum((0, 0, set_off)),
            Arrow("heading", ORIGIN, (0.38 * cos(set_off), 0.38 * sin(set_off)), ""),
            Arrow("error", (0.5 * cos(s) * 0, 0), (0.3 * cos(seen), 0.3 * sin(seen)), ""),
            Label("text", (0.6, -0.38), "θ = {set_off}"),
        ),
        readouts=(Readout("seen", "tan⁻¹(sin θ / cos θ)", seen, "rad"),),
        goal=Goal(
            And(set_off > 100 * DEGREE, Abs(seen + 30 * DEGREE) < 3 * DEGREE),
            "Find a heading beyond 100° that the program takes for −30°: within 3°.",
        ),
    )


# --- Laboratory

LAB_STEPS, LAB_SLIP = 12, 0.06  # pieces; m
LAB_DOCK = (0.92, 0.5)


def lab_loop() -> Recurrence:
    """Return the covariance after the drive of the laboratory."""
    return covariance_loop(LAB_STEPS, LAB_STEPS, K, set_off, "lab")


def lab_figure() -> Figure:
    """Draw the laboratory: a drive with its doors, its ellipse, its dock; a wheel may slip once."""
    loop = lab_loop()
    start = (0, 0, set_off)
    along, told = arc_to(drive * s, turned * s, start), arc_to(drive, turned, start)
    slips, slips_at = 0.2 / drive, arc_to(0.2, 0.2 * turned / drive, start)
    hinge = point_of(slips_at, 0, HALF)
    real = swung(told, hinge, -slip / BASE)
    real_along = swung(along, hinge, -slip / BASE)
    long_axis, short_axis = half_axes(loop_entries(loop))
    dock = (*LAB_DOCK, 0.5)
    there = distance(real, LAB_DOCK) < 0.05
    return Figure(
        name="odometry-lab",
        title="The room with its dock, a drive under the hand, its ellipse, a wheel that may slip",
        view=(-0.9, 2.0, -0.95, 0.95),
        follow=told[:2],
        ground="tiles",
        size="laboratory",
        controls=(
            Slider.degrees(set_off, -180, 180, start=0, step=1, label="heading at the start"),
            Slider(drive, 0.25, 3, start=1.5, step=0.01, label="distance s"),
            Slider.degrees(turned, 0, 360, start=90, step=1, label="turned in all Φ"),
            Slider(slip, 0.0, LAB_SLIP, start=0.0, step=0.005, label="slip after 20 cm"),
        ),
        shapes=(
            docks(dock),
            vacuum(start, look="ghost"),
            Trail("ghost", (x, y), loop),
            *tracks(along, slips),
            *tracks(real_along, 1, slips),
            Curve("path", along, s, 0, slips),
            Curve("path", real_along, s, slips, 1),
            *when(
                slip > 0.001,
                Curve("error", along, s, slips, 1),
                Point("icr", hinge, ""),
            ),
            vacuum(real),
            *when(slip > 0.001, vacuum(told, look="wrong")),
            *_ellipse(told, loop_entries(loop)),
            Label("target", (1.45, 0.8), "dock"),
        ),
        handles=(
            Handle(
                "the end by its belief", told,
                {
                    set_off: towards(set_off, atan2(POINTER[1], POINTER[0]) - turned / 2),
                    drive: sp.sqrt(POINTER[0] ** 2 + POINTER[1] ** 2) / sp.sinc(turned / 2),
                },
            ),
        ),
        readouts=(
            Readout("lab_long", "long half axis", long_axis, "cm", 1),
            Readout("lab_short", "short half axis", short_axis, "cm", 1),
            Readout("to_dock", "the robot to the dock", distance(real, LAB_DOCK), "cm", 1),
        ),
        goal=(
            Goal(
                And(there, long_axis < 0.12),
                "Reach the dock, within 5 cm, with the long half axis below 12 cm.",
            ),
            Goal(
                And(drive > 2.495, short_axis > long_axis / 2),
                "Drive at least 2.5 m with the short half axis at least half of the long one.",
            ),
            Goal(
                And(there, slip > 0.055),
                "Reach the dock, within 5 cm, with a right wheel that slips by 6 cm.",
            ),
        ),
    )  # fmt: skip


SECRET = {b_true: 0.2065, ratio: 1.004}  # stand nowhere on the page


def secret_ends(turns: int) -> tuple[tuple[float, float], ...]:
    """Return five ends of squares of the robot with hidden sizes, m."""
    wheels = np.array([2 / (1 + SECRET[ratio]), 2 * SECRET[ratio] / (1 + SECRET[ratio])])
    corner = float(pi / 4) * BASE
    told = np.tile([[1.0, 1.0], [-turns * corner, turns * corner]], (4, 1)).T * wheels[:, None]
    v, omega = told.mean(axis=0), (told[1] - told[0]) / SECRET[b_true]
    end = motion.path([0, 0, 0], v, omega, 1.0)[-1]
    return tuple(
        (round(float(end[0]) + dx, 3), round(float(end[1]) + dy, 3)) for dx, dy in scatter(turns)
    )


def secret_figure() -> Figure:
    """Draw ten ends of a robot with hidden sizes; its squares close once these are found."""
    cw, ccw = secret_ends(-1), secret_ends(1)
    found = [
        float(u)
        for u in library.umbmark(np.array(cw), np.array(ccw), side=SIDE, wheel_distance=BASE)
    ]
    right = And(Abs(guess_b - found[0]) < 0.0005, Abs(guess_ratio - found[1]) < 0.001)
    dx, dy = ROW[:2]
    middles = (("right", cw, mean_of(cw), -1), ("left", ccw, mean_of(ccw), 1))
    return Figure(
        name="two-secrets",
        title="The start of squares, and where five drives each way really ended",
        view=(-0.55, 0.55, -0.34, 0.34),
        ground="tiles",
        size="laboratory",
        controls=(
            Slider(guess_b, 0.19, 0.22, start=0.2, step=0.0005, label="wheel distance b"),
            Slider(guess_ratio, 0.97, 1.03, start=1.0, step=0.001, label="right diameter / left"),
        ),
        shapes=(
            *when(right, things.lamplight((0, 0, 0), 0.8)),
            vacuum(AT_ORIGIN, look="ghost"),
            *(Cloud(kind, (dx, dy), (dx, dy), rows) for kind, rows, *_ in middles),
            *(Point(kind, middle, "") for kind, _, middle, _ in middles),
            *(
                Label(kind, (0.3 * side - 0.12, 0.29 * side), words)
                for kind, side, words in (
                    ("right", -1, _place_words("cw", mean_of(cw))),
                    ("left", 1, _place_words("ccw", mean_of(ccw))),
                )
            ),
            *when(right, Label("target", (0.3, -0.29), "found")),
        ),
        goal=Goal(
            right,
            "Find the robot's wheel distance within 0.5 mm and its ratio within 0.001, from the "
            "middles of its ends.",
        ),
    )


def _place_words(name: str, place: Any) -> str:
    return f"{name}: {place[0]:.4f}, {place[1]:.4f}".replace("-", "−")


# --- Mistakes

EACH = (80, 120)  # ticks of the left and the right wheel in a sample
SPAN = 2**10  # numbers that a counter of 10 bits can show
READ = [SPAN - 8.5 * ticks for ticks in EACH]  # at the start: both wrap in sample 9
MADE = (
    lost_heading,
    arctan_heading,
    ticks_per_radian,
    counter_jump,
)
MISTAKES = symbols(f"mistake:{len(MADE)}", real=True)  # 1 for the one that is made, else 0


def choose(mistake: Any, wrong: Any, right: Any) -> Any:
    """Return the wrong expressions if this mistake is chosen, else the right ones."""
    chosen = MISTAKES[MADE.index(mistake)] > 0.5
    with as_written():
        return [Piecewise((a, chosen), (b, True)) for a, b in zip(wrong, right, strict=True)]


def believed_loop() -> Recurrence:
    """Return the pose that a program with a mistake makes of the readings of two counters."""
    counts = symbols("count_L count_R")
    with as_written():
        after = [sp.Mod(count + each, SPAN) for count, each in zip(counts, EACH, strict=True)]
    pairs = [{count_before: c, count_now: n} for c, n in zip(counts, after, strict=True)]
    right = [odometry.counter_step.substitute({**pair, counter_span: SPAN}) for pair in pairs]
    ticks = choose(counter_jump, [counter_jump.substitute(pair) for pair in pairs], right)
    sample = choose(
        ticks_per_radian, motion_in_sample(ticks, ticks_per_radian), motion_in_sample(ticks)
    )
    known = dict(zip((D, dtheta), sample, strict=True))
    half_seen = odometry.new_heading.substitute(
        {**known, theta: arctan_heading.substitute(known), dtheta: 0}
    )
    pose = choose(arctan_heading, half_seen, odometry.exact_arc.substitute(known))
    return Recurrence(
        (x, y, theta, *counts),
        start=(0, 0, set_off, *READ),
        step=(*choose(lost_heading, lost_heading.substitute(known), pose), *after),
        count=samples,
        most=16,
        ends=symbols("x_told y_told t_told left_told right_told"),
    )


def mistakes_figure() -> Figure:
    """Draw the robot, and where a program with a mistake believes it to be."""
    loop, (each, turn) = believed_loop(), motion_in_sample(EACH)
    with as_written():
        real, along = (arc_to(each * k, turn * k, (0, 0, set_off)) for k in (samples, s))
    end, told = tuple(real), loop.ends[:3]
    return Figure(
        name="wrong-poses",
        title="A robot, and where a program with a mistake believes it to be",
        view=(-0.95, 1.3, -0.5, 1.1),
        ground="tiles",
        size="laboratory",
        controls=(
            Choice.one_hot("mistake", MISTAKES, (m.title for m in MADE)),
            Slider(samples, 3, 16, start=14, step=1, label="samples so far"),
            Slider.degrees(set_off, 0, 90, start=40, step=5, label="heading at the start"),
        ),
        shapes=(
            Curve("path", along, s, 0, samples),
            Trail("approximation", (x, y), loop),
            Line("error", (end, told)),
            vacuum(end),
            vacuum(told, look="wrong"),
        ),
        readouts=(
            Readout("apart", "apart", distance(end, told), "m"),
            Readout("turned", "heading off by", told[2] - end[2], "rad", digits=0),
        ),
        sentence=(
            "{mistake}: after {samples} samples the robot is {apart} from where its program "
            "believes it. The heading is off by {turned}."
        ),
    )


def letters_figure() -> Figure:
    """Draw the door at rest, with three letters that are to be put back."""
    angle = float(odometry.door_angle.substitute({slip: 0.06, b: BASE}))
    hinge = tuple(map(float, point_of(S_MIDDLE, 0, HALF)))
    end = tuple(map(float, swung(S_END, hinge, angle)))
    looks = float(np.arctan2(S_END[1] - hinge[1], S_END[0] - hinge[0]))
    sector = tuple(map(float, point_of((*hinge, looks + angle / 2), 0.64)))
    places = ((1.32, 0.4), (S_END[0] + 0.12, S_END[1] + 0.22), sector)
    answers = dict(zip(("ℓ", "εℓ/b", "ε/b"), places, strict=True))
    letters = put_back(quantity, ("b", "ℓ", "ε/b", "εℓ/b"), answers)
    return Figure(
        name="odometry-letters",
        title="The S-shaped way, a slip in its middle, the lever to the end and the swung rest",
        view=(-0.5, 2.4, -0.65, 1.35),
        ground="tiles",
        controls=letters.controls,
        shapes=(
            vacuum(S_START, look="ghost"),
            Curve("path", on_s(s), s, 0, 1),
            vacuum(S_END),
            Curve("error", swung(on_s(s), hinge, angle), s, 0.5, 1),
            vacuum(end, look="wrong"),
            Line("icr", (end, hinge, S_END)),
            Line("error", (S_END, end)),
            AngleArc("turning", hinge, looks, looks + angle, 0.5, ""),
            Point("icr", hinge, ""),
            *letters.shapes,
        ),
        goal=letters.goal,
    )  # fmt: skip


FIGURES = (
    dark_figure(),
    exercise_figure(),
    tick_figure(),
    strips_figure(),
    bent_figure(),
    guess_figure(),
    rules_step_figure(),
    rules_figure(),
    door_figure(),
    ten_doors_figure(),
    ellipse_figure(),
    square_figure(),
    counter_figure(),
    ice_figure(),
    half_seen_figure(),
    lab_figure(),
    secret_figure(),
    mistakes_figure(),
    letters_figure(),
)
