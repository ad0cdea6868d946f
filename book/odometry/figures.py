"""The live figures of the chapter on encoder odometry."""

from math import log, pi, sqrt
from typing import Any

import sympy as sp
from sympy import Max, Piecewise, Symbol, symbols

from book.differential_drive.formulas import b, r
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
    dtheta,
    noise,
    ratio,
)
from courseware.equations import Equation, as_written, declarations, substitute
from courseware.figures import (
    POINTER,
    Body,
    Choice,
    Curve,
    Figure,
    Handle,
    Label,
    Line,
    Point,
    Readout,
    Recurrence,
    Slider,
    Trail,
    distance,
)

quantity, _ = declarations(__name__)

# the robot of the exercise
TICKS, RADIUS, BASE = 512, 0.05, 0.2  # ticks a turn, wheel radius, wheel distance [m]
LEFT, RIGHT = 3072, 5120  # ticks of its wheels on a whole circle
CIRCLE = 0.4  # m, radius of that circle
ORIGIN = (0, 0)

samples = quantity("samples", "", 3, 32, "number of samples of the encoders", latex="n")
turned = quantity("turned", "rad", 0, 6.3, "how far the robot turns in a drive", latex=r"\Phi")
drive = quantity("drive", "m", 0.25, 3, "how far the robot drives", latex="s")
wheel_error = quantity(
    "wheel_error", "m", 0.001, 0.02, "standard deviation of a wheel's travel over 1 m"
)
s = Symbol("s")


def arc_to(length: Any, angle: Any, start: Any = (0, 0, 0)) -> Any:
    """Return the pose at the end of an exact arc."""
    values = dict(zip((x, y, theta), start, strict=True))
    return odometry.exact_arc.substitute({**values, D: length, dtheta: angle})


# --- Four rules -----------------------------------------------------------------------------


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
    """Draw one drive in n samples, by the four rules: the largest error and the one at the end."""
    old = rule_loop(odometry.old_heading, "old")
    new = rule_loop(odometry.new_heading, "new")
    middle = rule_loop(odometry.middle_heading, "middle")
    exact = rule_loop(odometry.exact_arc, "exact")
    with as_written():
        end = arc_to(CIRCLE * turned, turned)
        centre = 13 * pi / 12  # opposite the gap between a whole turn and the least one
        ahead = sp.atan2(
            sp.cos(centre) * POINTER[0] + sp.sin(centre) * (POINTER[1] - CIRCLE),
            sp.sin(centre) * POINTER[0] - sp.cos(centre) * (POINTER[1] - CIRCLE),
        )
    return Figure(
        name="four-rules",
        title="One drive of a robot, read from its encoders by four rules",
        view=(-0.86, 0.94, -0.15, 0.95),
        size="laboratory",
        controls=(
            Slider(samples, 3, 32, start=8, step=1, label="samples in the drive"),
            Slider.degrees(turned, 30, 360, start=270, step=5, label="turned in all"),
        ),
        shapes=(
            Curve("ghost", arc_to(CIRCLE * s, s), s, 0, 2 * pi),
            Curve("path", arc_to(CIRCLE * s, s), s, 0, turned),
            Trail("old_heading", (x, y), old),
            Trail("new_heading", (x, y), new),
            Trail("middle_heading", (x, y), middle),
            Trail("ghost", (x, y), exact),
            Body(ORIGIN, 0, 0.06, kind="ghost"),
            Body(end, turned, 0.06),
            Label("path", (0, CIRCLE), "exact arc"),
            Point("old_heading", (old.ends[0], old.ends[1]), "old"),
            Point("new_heading", (new.ends[0], new.ends[1]), "new"),
            Point("middle_heading", (middle.ends[0], middle.ends[1]), "middle"),
        ),
        handles=(Handle("end of the drive", end, {turned: centre + ahead}),),
        readouts=(
            *worst_readouts((exact, old, new, middle)),
            Readout("old_end", "old, at the end", distance(old.ends, end), "m", digits=4),
            Readout("middle_end", "middle, at the end", distance(middle.ends, end), "m", 4),
        ),
        sentence=(
            "The robot turns by {turned}, read in {samples} samples. Largest error on the way: "
            "old heading {old}, new heading {new}, middle heading {middle}, exact arc {exact}. "
            "At the end: old heading {old_end}, middle heading {middle_end}."
        ),
    )


def worst_readouts(loops: tuple[Recurrence, ...]) -> list[Readout]:
    """Return readouts of the largest error on the way, rule by rule."""
    names = ("exact", "old", "new", "middle")
    return [
        Readout(name, f"{name}, worst", loop.ends[-1], "m", digits=4)
        for name, loop in zip(names, loops, strict=True)
    ]


# --- The error ellipse ----------------------------------------------------------------------

STEPS = 6  # samples of the drive; ellipses after each second one
HOLDS_95 = sqrt(-2 * log(0.05))  # half-axis of the ellipse that holds 95 %, by σ


def inline_steps(steps: Any, values: dict[Any, Any]) -> dict[Any, Any]:
    """Return named steps, each written out in the symbols of the first ones."""
    known = dict(values)
    for symbol, expression in steps:
        known[symbol] = substitute(expression, known)
    return known


def covariance_loop(count: int) -> Recurrence:
    """Return the covariance after some samples: the wheels' part is computed once, at the start."""
    with as_written():
        half = BASE * turned / 2
        wheels = {D_L: (drive - half) / STEPS, D_R: (drive + half) / STEPS}
        wheels |= {b: BASE, noise: wheel_error**2}
    once = inline_steps(odometry.of_the_wheels, wheels)
    kept = [symbol for symbol, _ in odometry.of_the_wheels]
    entries = odometry.covariance_entries
    each = inline_steps(odometry.of_the_heading, {})
    with as_written():
        step = substitute(odometry.covariance_step.right, {**each, b: BASE})
        next_heading = theta + 2 * odometry.u
    place = arc_to(D, 2 * odometry.u, (x, y, theta))[:2]
    place = [substitute(p, {D: drive / STEPS}) for p in place]
    state = (x, y, theta, *kept, *entries)
    return Recurrence(
        state,
        start=(0, 0, 0, *(once[symbol] for symbol in kept), *(0 for _ in entries)),
        step=(*place, next_heading, *kept, *step),
        count=sp.Integer(count),
        most=count,
        ends=symbols(f"e{count}_:{len(state)}", real=True),
    )


def ellipse(loop: Recurrence, count: int) -> Curve:
    """Return the ellipse that holds 95 % of the ends of a part of the drive."""
    xx, xy, _, yy, *_ = loop.ends[-6:]
    with as_written():
        part = sp.Rational(count, STEPS)
        centre = arc_to(drive * part, turned * part)
        wide = sp.sqrt(xx)
        at = (
            centre[0] + HOLDS_95 * wide * sp.cos(s),
            centre[1] + HOLDS_95 * (xy / wide * sp.cos(s) + sp.sqrt(yy - xy**2 / xx) * sp.sin(s)),
        )
    return Curve("uncertainty", at, s, 0, 2 * pi)


def ellipse_figure() -> Figure:
    """Draw the error ellipse growing along a drive: noise, distance and turn under the hand."""
    loops = {count: covariance_loop(count) for count in (2, 4, 6)}
    end = arc_to(drive, turned)
    xx, xy, _, yy, _, tt = loops[STEPS].ends[-6:]
    values = {odometry.p_xx: xx, odometry.p_xy: xy, odometry.p_yy: yy}
    axes = substitute(
        odometry.ellipse_axes.right, {**inline_steps(odometry.ellipse_axes.where, values), **values}
    )
    with as_written():
        direction = sp.atan2(POINTER[1], POINTER[0])
        chord = sp.sqrt(POINTER[0] ** 2 + POINTER[1] ** 2)
        long_axis, short_axis = (HOLDS_95 * axis for axis in axes)
        heading = sp.sqrt(tt)
    return Figure(
        name="error-ellipse",
        title="A drive and the ellipses that hold 95 of 100 of its ends",
        view=(-0.9, 3.5, -0.7, 2.2),
        size="laboratory",
        controls=(
            Slider(
                wheel_error, 0.001, 0.02, start=0.008, step=0.001, kind="uncertainty",
                label="wheel error over 1 m",
            ),
            Slider(drive, 0.25, 3, start=2.5, step=0.05, label="distance"),
            Slider.degrees(turned, 0, 360, start=60, step=5, label="turned in all"),
        ),
        shapes=(
            Curve("path", arc_to(drive * s, turned * s), s, 0, 1),
            *(ellipse(loop, count) for count, loop in loops.items()),
            *(Trail("ghost", (x, y), loop) for loop in loops.values()),
            Body(ORIGIN, 0, 0.13, kind="ghost"),
            Body(end, turned, 0.13),
        ),
        handles=(
            Handle(
                "end of the drive", end,
                {drive: chord / sp.sinc(direction), turned: 2 * direction},
            ),
        ),
        readouts=(
            Readout("long_axis", "half the length", long_axis, "m"),
            Readout("short_axis", "half the width", short_axis, "m"),
            Readout("heading", "heading error", heading, "rad"),
        ),
        sentence=(
            "A drive of {drive} that turns by {turned}, with wheels that err by {wheel_error} over "
            "1 m: of 100 robots 95 end in an ellipse of half-axes {long_axis} and {short_axis}; "
            "the heading errs by {heading}."
        ),
    )  # fmt: skip


# --- The square path ------------------------------------------------------------------------

SIDE, PIECES = 1.0, 6  # m; pieces of a side, so that one sees it bend
PLACE = -1.25  # m, where the robot with its enlarged errors is drawn
APART, HALF = 0.3, 0.2  # m, its wheels from the middle and half as long, when they are right
WIDER, LONGER = 14, 7  # how much its errors are enlarged


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


def square_figure() -> Figure:
    """Draw unequal wheels or a wrong wheel distance, and the square path, both ways, that tells."""
    cw, ccw = square_loop(-1, "cw"), square_loop(1, "ccw")
    ends = {
        odometry.x_cw: cw.ends[0], odometry.y_cw: cw.ends[1],
        odometry.x_ccw: ccw.ends[0], odometry.y_ccw: ccw.ends[1],
        odometry.side: SIDE,
    }  # fmt: skip
    angles = odometry.calibration_angles.substitute(ends)
    known = {odometry.short_turn: angles[0], odometry.side_swing: angles[1]}
    known |= {odometry.side: SIDE, b: BASE}
    steps = inline_steps(odometry.calibration.where, known)
    found_b, found_ratio = substitute(odometry.calibration.right, steps)
    with as_written():
        wheel = APART + WIDER * (b_true - BASE)
        tip = PLACE + HALF + LONGER * (ratio - 1)
        back = PLACE - HALF - LONGER * (ratio - 1)
    return Figure(
        name="square-path",
        title="Square drives to the left and to the right of a robot that believes it is right",
        view=(-1.9, 1.7, -1.3, 1.3),
        size="laboratory",
        controls=(
            Slider(b_true, 0.19, 0.21, start=0.206, step=0.001, label="true wheel distance"),
            Slider(ratio, 0.98, 1.02, start=1.006, step=0.002, label="right diameter / left"),
        ),
        shapes=(
            Line("ghost", (ORIGIN, (SIDE, 0), (SIDE, SIDE), (0, SIDE), ORIGIN)),
            Line("ghost", (ORIGIN, (SIDE, 0), (SIDE, -SIDE), (0, -SIDE), ORIGIN)),
            Trail("path", (x, y), cw),
            Trail("path", (x, y), ccw),
            Body(ORIGIN, 0, 0.1, kind="ghost"),
            Point("target", (cw.ends[0], cw.ends[1])),
            Point("target", (ccw.ends[0], ccw.ends[1])),
            Label("target", (SIDE / 2, -SIDE / 2), "cw"),
            Label("target", (SIDE / 2, SIDE / 2), "ccw"),
            Body((PLACE, 0), 0, 0.55),
            Line("left", ((PLACE - HALF, wheel), (PLACE + HALF, wheel))),
            Line("right", ((back, -wheel), (tip, -wheel))),
        ),
        handles=(
            Handle("left wheel, outwards", (PLACE, wheel), {b_true: base_from_pointer()}),
            Handle("front of the right wheel", (tip, -wheel), {ratio: ratio_from_pointer()}),
        ),
        readouts=(
            Readout("x_cw", "cw end, x", cw.ends[0], "m"),
            Readout("y_cw", "cw end, y", cw.ends[1], "m"),
            Readout("x_ccw", "ccw end, x", ccw.ends[0], "m"),
            Readout("y_ccw", "ccw end, y", ccw.ends[1], "m"),
            Readout("found_b", "distance found", found_b, "m", digits=4),
            Readout("found_ratio", "ratio found", found_ratio, "", digits=4),
        ),
        sentence=(
            "With a wheel distance of {b_true} where {base} is believed and diameters of ratio "
            "{ratio}, the clockwise square ends at x = {x_cw}, y = {y_cw}, the counter-clockwise "
            "one at x = {x_ccw}, y = {y_ccw}. From these ends the calibration finds {found_b} and "
            "{found_ratio}."
        ).replace("{base}", f"{BASE} m"),
    )


def base_from_pointer() -> Any:
    """Return the wheel distance that puts the left wheel where the pointer is."""
    with as_written():
        return BASE + (POINTER[1] - APART) / WIDER


def ratio_from_pointer() -> Any:
    """Return the ratio that puts the front of the right wheel where the pointer is."""
    with as_written():
        return 1 + (POINTER[0] - PLACE - HALF) / LONGER


# --- Mistakes -------------------------------------------------------------------------------

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
set_off = quantity("set_off", "rad", 0, 1.6, "heading at the start", latex=r"\theta_0")


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
        real, part = (arc_to(each * k, turn * k, (0, 0, set_off)) for k in (samples, s))
    end, told = tuple(real[:2]), loop.ends[:2]
    return Figure(
        name="wrong-poses",
        title="A robot, and where a program with a mistake believes it to be",
        view=(-0.75, 1.1, -0.4, 0.98),
        size="laboratory",
        controls=(
            Choice.one_hot("mistake", MISTAKES, (m.title for m in MADE)),
            Slider(samples, 3, 16, start=14, step=1, label="samples so far"),
            Slider.degrees(set_off, 0, 90, start=40, step=5, label="heading at the start"),
        ),
        shapes=(
            Curve("path", part, s, 0, samples),
            Trail("approximation", (x, y), loop),
            Line("error", (end, told)),
            Body(end, real[2], 0.09),
            Body(told, loop.ends[2], 0.09, kind="approximation"),
        ),
        readouts=(
            Readout("apart", "apart", distance(end, told), "m"),
            Readout("turned", "heading off by", loop.ends[2] - real[2], "rad", digits=0),
        ),
        sentence=(
            "{mistake}: after {samples} samples the robot is {apart} from where its program "
            "believes it. The heading is off by {turned}."
        ),
    )


FIGURES = (rules_figure(), ellipse_figure(), square_figure(), mistakes_figure())
