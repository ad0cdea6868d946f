"""The live figures of the chapter on the planar arm."""

from collections.abc import Mapping
from math import pi
from typing import Any

from sympy import (
    Abs,
    Integer,
    Matrix,
    Max,
    Min,
    Or,
    Piecewise,
    Symbol,
    atan2,
    ceiling,
    cos,
    floor,
    nan,
    oo,
    sin,
    sqrt,
    symbols,
)

from book.differential_drive.figures import n, t
from book.motion import formulas as motion
from book.planar_arm import formulas as arm
from book.planar_arm.exercises import (
    TWIST_OF,
    WHOLE_J,
    l_2_for_l_3,
    last_joint_only,
    not_derived,
    plus_sine,
    separate_rates,
    times_J,
    wrong_jacobian,
)
from book.planar_arm.formulas import (
    ANGLES,
    LENGTHS,
    POSE,
    TWIST,
    damping,
    gain,
    phi_dot,
    phi_hand,
    theta1,
    theta2,
    theta3,
    x,
    y,
)
from courseware.equations import Where, as_written, declarations, substitute
from courseware.equations.functions import solve
from courseware.figures import (
    POINTER,
    AngleArc,
    Arrow,
    Choice,
    Clock,
    Curve,
    Figure,
    Handle,
    Line,
    Point,
    Readout,
    Recurrence,
    Slider,
    Trail,
    distance,
)
from robokin._triangle import TOLERANCE

quantity, _ = declarations(__name__)

LINKS = (0.4, 0.3, 0.2)  # m, as in the exercise
START = (pi / 6, pi / 3, -pi / 2)  # rad, as in the exercise
SIZES = dict(zip(LENGTHS, LINKS, strict=True))
BASE = (0, 0)
CORNER = 0.05  # m, the sign of a right angle

line_x = quantity("line_x", "m", -0.4, 0.85, "where a line for the hand ends", latex="x_e")
line_y = quantity("line_y", "m", -0.1, 0.7, "where a line for the hand ends", latex="y_e")
s = Symbol("s")
lever_x, lever_y = symbols("lever_x lever_y")


def substitute_sizes(steps: Where, values: Mapping[Any, Any] = SIZES) -> list[tuple[Symbol, Any]]:
    """Return named steps with the figures' links in place of their symbols."""
    return [(symbol, substitute(step, values)) for symbol, step in steps]


def inline_steps(expression: Any, steps: Where) -> Any:
    """Return an expression with its named steps written out, the last first."""
    for symbol, step in reversed(list(steps)):
        expression = substitute(expression, {symbol: step})
    return expression


def angle_values(angles: tuple[Any, Any, Any]) -> dict[Any, Any]:
    """Return joint angles as values of their symbols."""
    return dict(zip(ANGLES, angles, strict=True))


def joints(angles: tuple[Any, Any, Any]) -> tuple[Any, Any, Any]:
    """Return elbow, wrist and hand, as points, of an arm at these angles."""
    place = inline_steps(arm.forward.right, arm.SHORT)
    without: tuple[dict[Any, Any], ...] = ({arm.l2: 0, arm.l3: 0}, {arm.l3: 0}, {})
    points = [
        substitute(place, {**SIZES, **missing, **angle_values(angles)}) for missing in without
    ]
    return tuple((point[0], point[1]) for point in points)  # type: ignore[return-value]


# One joint turns

TURNS = symbols("turns_1 turns_2 turns_3")  # 1 for the joint that turns


def levers_figure() -> Figure:
    """Draw one joint at 1 rad/s: its lever and, a quarter turn from it, the hand's velocity."""
    with_first = {theta1: START[0]}
    elbow, wrist, hand = (
        tuple(substitute(part, with_first) for part in point) for point in joints(ANGLES)
    )
    with as_written():
        turning = [
            sum(turns * at[i] for turns, at in zip(TURNS, (BASE, elbow, wrist), strict=True))
            for i in range(2)
        ]
        lever = lever_x, lever_y
        length = sqrt(lever[0] ** 2 + lever[1] ** 2)
        tip = hand[0] - lever[1], hand[1] + lever[0]
        side = CORNER / length
        corner = [
            (hand[0] + side * a, hand[1] + side * b)
            for a, b in (
                (-lever[0], -lever[1]),
                (-lever[0] - lever[1], lever[0] - lever[1]),
                (-lever[1], lever[0]),
            )
        ]
        steps = [(symbol, hand[i] - turning[i]) for i, symbol in enumerate((lever_x, lever_y))]
    return Figure(
        name="arm-levers",
        title="One joint of an arm turns: its lever, and the velocity of the hand",
        view=(-0.9, 1.3, -0.22, 1.28),
        size="laboratory",
        controls=(
            Choice.one_hot(
                "joint", TURNS, ("joint 1", "joint 2", "joint 3"), label="joint that turns"
            ),
            Slider(theta2, 0, 2 * pi / 3, start=START[1], step=pi / 36, label="θ_2"),
            Slider(theta3, -17 * pi / 18, pi, start=START[2], step=pi / 36, label="θ_3"),
        ),
        where=tuple(steps),
        shapes=(
            Line("path", (BASE, elbow, wrist, hand)),
            Point("left", BASE, label="1"),
            Point("body", elbow, label="2"),
            Point("body", wrist, label="3"),
            Arrow("approximation", tuple(turning), hand),
            Arrow("velocity", hand, tip),
            Line("text", tuple(corner)),
            Point("target", hand, label="P"),
        ),
        handles=(
            Handle(
                "wrist, the end of link 2", wrist, {theta2: angle_from_pointer(elbow, START[0])}
            ),
            Handle(
                "hand, the end of link 3",
                hand,
                {theta3: angle_from_pointer(wrist, START[0] + theta2)},
            ),
        ),
        readouts=(
            Readout("length", "length of the lever", length, "m"),
            Readout("x_dot", "first number of the column, ẋ at 1 rad/s", -lever_y, "m/s"),
            Readout("y_dot", "second number, ẏ at 1 rad/s", lever_x, "m/s"),
        ),
        sentence=(
            "{joint} turns at 1 rad/s, with θ2 at {theta2} and θ3 at {theta3}. Its lever to the "
            "hand is {length} long, and the hand moves at {x_dot} along x and {y_dot} along y."
        ),
    )


# The arm under the hand

MIDDLE = pi / 36  # rad: the middle of the sliders, from -170° to 180°
ELLIPSE = 0.25  # s: an ellipse of velocities, drawn as what they reach in this time
SPEED_OUT = 0.1  # m/s
SINGULAR = 1e-9  # |sin θ2|: a reader's idea of 0
NEAR = 0.1  # |sin θ2|, 6° from stretched or folded


def angle_from_pointer(joint: Any, heading: Any) -> Any:
    """Return the angle of a link, from the heading before it, that points at the pointer."""
    with as_written():
        right, up = POINTER[0] - joint[0], POINTER[1] - joint[1]
        ahead = right * cos(heading + MIDDLE) + up * sin(heading + MIDDLE)
        left = up * cos(heading + MIDDLE) - right * sin(heading + MIDDLE)
        return MIDDLE + atan2(left, ahead)


def joints_figure() -> Figure:
    """Draw the arm by its joints, the velocities of its hand, how near it is to singular."""
    elbow, wrist, hand = joints(ANGLES)
    place = arm.forward.substitute(SIZES)
    steps = [*substitute_sizes(arm.ellipse.where), (arm.small, arm.ellipse.right[1])]
    with as_written():
        tilt = arm.ellipse_tilt.right / 2
        along, across = ELLIPSE * arm.large * cos(s), ELLIPSE * arm.small * sin(s)
        rim = (
            place[0] + along * cos(arm.tilt) - across * sin(arm.tilt),
            place[1] + along * sin(arm.tilt) + across * cos(arm.tilt),
        )
        ahead = (elbow[0] + 0.13 * cos(theta1), elbow[1] + 0.13 * sin(theta1))
        bend = Abs(sin(theta2))
        near = Piecewise((oo, bend <= SINGULAR), (nan, bend < NEAR), (bend, True))
        heading = theta1 + theta2
    return Figure(
        name="arm-joints",
        title="An arm with three links, its joints under your hand",
        view=(-1.28, 1.28, -0.96, 0.96),
        size="",
        controls=(
            Slider(theta1, -17 * pi / 18, pi, start=START[0], step=pi / 36, label="joint θ_1"),
            Slider(theta2, -17 * pi / 18, pi, start=START[1], step=pi / 90, label="joint θ_2"),
            Slider(theta3, -17 * pi / 18, pi, start=START[2], step=pi / 36, label="joint θ_3"),
        ),
        where=(*steps, (arm.tilt, tilt)),
        shapes=(
            Line("ghost", (elbow, ahead)),
            AngleArc("approximation", elbow, theta1, heading, 0.1, label="θ_2"),
            Curve("velocity", rim, s, 0, 2 * pi),
            Line("path", (BASE, elbow, wrist, hand)),
            Point("left", BASE),
            Point("body", elbow),
            Point("body", wrist),
            Point("target", hand, label="hand"),
        ),
        handles=(
            Handle("elbow, the end of link 1", elbow, {theta1: angle_from_pointer(BASE, 0)}),
            Handle("wrist, the end of link 2", wrist, {theta2: angle_from_pointer(elbow, theta1)}),
            Handle("hand, the end of link 3", hand, {theta3: angle_from_pointer(wrist, heading)}),
        ),
        readouts=(
            Readout("x", "hand x", place[0], "m"),
            Readout("y", "hand y", place[1], "m"),
            Readout("phi", "hand angle φ", place[2], "rad", digits=0),
            Readout("det", "det J", arm.det.substitute(SIZES), "m²"),
            Readout("w", "manipulability w", arm.w, "m²"),
            Readout("long", "top speed at 1 rad/s, best direction", arm.large, "m/s"),
            Readout("short", "top speed at 1 rad/s, worst direction", arm.small, "m/s"),
            Readout(
                "elbow",
                "elbow's rate, wrist outward at 0.1 m/s",
                arm.elbow_rate.substitute({**SIZES, arm.v_out: SPEED_OUT}),
                "rad/s",
                digits=2,
                words={"nan": "no rate does it"},
            ),
            Readout(
                "near",
                "pose: |sin θ_2|",
                near,
                "",
                digits=2,
                words={"inf": "0: singular", "nan": "below 0.1: nearly singular"},
            ),
        ),
        sentence=(
            "Joints at {theta1}, {theta2} and {theta3}: the hand is at x = {x}, y = {y} and "
            "points at {phi}. det J is {det}, the manipulability {w}. At joint rates of 1 rad/s in "
            "all the hand moves at most at {long}, in the worst direction at {short}. "
            "|sin θ2|: {near}; elbow's rate: {elbow}."
        ),
    )


# A straight line

DURATION = 4.0  # s, for the whole line
PARTS = 60  # pieces of the hand's path, at least
EARLY = 1e-6  # of a step: how early its end counts


def wanted_at(count: Any, angles: tuple[Any, Any, Any]) -> list[tuple[Symbol, Any]]:
    """Return the wanted pose after `count` of n steps, and the twist commanded at some angles."""
    begin = substitute(inline_steps(arm.forward.right, arm.SHORT), {**SIZES, **angle_values(START)})
    place = substitute(
        inline_steps(arm.forward.right, arm.SHORT), {**SIZES, **angle_values(angles)}
    )
    with as_written():
        way = (line_x - begin[0], line_y - begin[1])
        values = {
            arm.x_d: begin[0] + way[0] * count / n,
            arm.y_d: begin[1] + way[1] * count / n,
            arm.phi_d: 0,
            arm.vx_d: way[0] / DURATION,
            arm.vy_d: way[1] / DURATION,
            arm.omega_d: 0,
            **dict(zip(POSE, place, strict=True)),
        }
    wanted = [(symbol, values[symbol]) for symbol in (arm.x_d, arm.y_d)]
    return [*wanted, *zip(TWIST, arm.command.substitute(values), strict=True)]


def line_figure() -> Figure:
    """Draw a straight line at constant speed, by joint rates: steps, damping and feedback."""
    state = symbols("theta1_k theta2_k theta3_k k rate1_k rate2_k rate3_k")
    end = symbols("theta1_n theta2_n theta3_n k_n rate1_n rate2_n rate3_n")
    angles, last, held = state[:3], end[:3], state[4:]
    matrix = substitute_sizes(arm.damped.where, {**SIZES, **angle_values(angles)})
    # Within a step the rates stay: parts of it show the curve on which the hand then runs.
    with as_written():
        parts = ceiling(PARTS / n)  # of one step
        done = floor((state[3] + EARLY) / parts)  # whole steps
        begins = state[3] - done * parts < 0.5
        since = Max(0, t * n / DURATION - EARLY)  # steps, the one that runs included
    commanded = inline_steps(arm.damped_rates, [*wanted_at(done, angles), *matrix])
    with as_written():
        rates = [
            Piecewise((new, begins), (old, True)) for new, old in zip(commanded, held, strict=True)
        ]
        lasts = Min(1, t * n / DURATION * parts - state[3]) * DURATION / (n * parts)
        step = [a + rate * lasts for a, rate in zip(angles, rates, strict=True)]
    loop = Recurrence(
        state,
        (*START, 0, 0, 0, 0),
        (*step, state[3] + 1, *rates),
        ceiling(since * parts),
        most=2 * PARTS,
        ends=end,
    )
    elbow, wrist, hand = joints(last)
    now = joints(angles)[2]
    begin = joints(START)[2]
    l1, l2, l3 = LINKS
    with as_written():
        off = sqrt((hand[0] - arm.x_d) ** 2 + (hand[1] - arm.y_d) ** 2)
        turned = substitute(arm.forward.right[2], angle_values(last))
        busy = sqrt(sum(rate**2 for rate in end[4:]))
        reach = sqrt((line_x - l3) ** 2 + line_y**2)
        room = Min(l1 + l2 - reach, reach - Abs(l1 - l2))  # from both edges of the workspace
        room = Piecewise((room, room >= 0), (nan, True))
    return Figure(
        name="arm-line",
        title="An arm follows a straight line, step by step",
        view=(-0.62, 1.02, -0.22, 0.92),
        size="",
        controls=(
            Clock(t, 0.0, DURATION, label="time"),
            Slider(n, 5, 100, start=10, step=1, label="number of steps", kind="approximation"),
            Slider(gain, 0.0, 2.0, start=0.0, step=0.1, label="feedback K"),
            Slider(damping, 0.0, 0.3, start=0.0, step=0.01, label="damping λ"),
            Slider(line_x, -0.4, 0.85, start=-0.1, step=0.01, label="end of the line, x"),
            Slider(line_y, -0.1, 0.7, start=0.5, step=0.01, label="end of the line, y"),
        ),
        where=tuple(wanted_at(t * n / DURATION, last)[:2]),
        shapes=(
            *(
                Curve("ghost", (l3 + edge * cos(s), edge * sin(s)), s, 0, 2 * pi)
                for edge in (l1 + l2, Abs(l1 - l2))
            ),
            Line("icr", (begin, (line_x, line_y))),
            Line("path", (BASE, elbow, wrist, hand)),
            Trail("approximation", now, loop, dots=False),
            Point("left", BASE),
            Point("body", elbow),
            Point("body", wrist),
            Point("icr", (line_x, line_y), label="end"),
            Point("target", (arm.x_d, arm.y_d)),
        ),
        handles=(Handle("end of the line", (line_x, line_y)),),
        readouts=(
            Readout("off", "hand off the wanted point", off, "m", digits=4),
            Readout("turned", "hand turned by", turned, "rad"),
            Readout("rates", "size of the joint rates", busy, "rad/s"),
            Readout(
                "room",
                "end inside the workspace by",
                room,
                "m",
                words={"nan": "out of reach"},
            ),
        ),
        sentence=(
            "After {t} of 4 s, in steps of which {n} make the line, with feedback {gain} and "
            "damping {damping}, the hand is {off} off the wanted point and turned by {turned}; "
            "the joint rates are {rates}. End of the line inside the workspace by: {room}."
        ),
    )


# Two elbows


def elbows_figure() -> Figure:
    """Draw the hand by its pose: the two arms that bring it there, or as near as they can."""
    turn = motion.wrap_angle
    place = substitute_sizes(arm.inverse.where)[:3]
    (_, bend), (_, shoulder) = substitute_sizes(arm.inverse.where)[3:]
    least, most = substitute(Matrix([arm.l1 - arm.l2, arm.l1 + arm.l2]), SIZES)
    done, missed = symbols("done missed")  # how far the wrist comes, and what then is missing
    outside = Or(arm.d > most * (1 + TOLERANCE), arm.d < least - most * TOLERANCE)
    with as_written():
        clamped, short = Max(least, Min(arm.d, most)), Max(0, arm.d - most, least - arm.d)
    named = symbols("theta2_left theta1_left theta3_left theta2_right theta1_right theta3_right")
    steps, arms, angles = [*place, (done, clamped), (missed, short)], [], []
    for side, (a2, a1, a3) in ((1, named[:3]), (-1, named[3:])):
        steps.append((a2, side * substitute(bend, {arm.d: done})))
        steps.append((a1, substitute(shoulder, {theta2: a2})))
        steps.append((a3, substitute(arm.inverse.right[2], {theta1: a1, theta2: a2})))
        arms.append(joints((a1, a2, a3)))
        angles.append(
            [
                Piecewise((nan, outside), (turn.substitute({motion.angle: a}), True))
                for a in (a1, a2, a3)
            ]
        )
    out = {"nan": "out of reach"}
    return Figure(
        name="arm-elbows",
        title="One pose of the hand, two arms that reach it",
        view=(-1.28, 1.28, -0.96, 0.96),
        size="",
        controls=(
            Slider(x, -0.9, 0.9, start=0.55, step=0.01, label="hand x"),
            Slider(y, -0.9, 0.9, start=0.5, step=0.01, label="hand y"),
            Slider.degrees(phi_hand, step=5, label="hand angle φ"),
        ),
        where=tuple(steps),
        shapes=(
            Curve("ghost", (most * cos(s), most * sin(s)), s, 0, 2 * pi),
            Curve("ghost", (least * cos(s), least * sin(s)), s, 0, 2 * pi),
            Line("approximation", (arms[0][2], (x, y))),
            Line("left", (BASE, *arms[0])),
            Line("right", (BASE, *arms[1])),
            Point("left", arms[0][0]),
            Point("right", arms[1][0]),
            Point("body", arms[0][1]),
            Point("target", (x, y), label="hand"),
        ),
        handles=(Handle("hand", (x, y)),),
        readouts=(
            Readout("distance", "wrist from the base", arm.d, "m"),
            *(
                Readout(f"{side}{i + 1}", f"{side}: θ_{i + 1}", angles[k][i], "rad", words=out)
                for k, side in enumerate(("solid", "dashed"))
                for i in range(3)
            ),
            Readout("missed", "out of reach by", missed, "m"),
        ),
        sentence=(
            "The hand at x = {x}, y = {y}, angle {phi_hand}; its wrist is {distance} from the "
            "base, out of reach by {missed}. One arm: joints at {solid1}, {solid2}, {solid3}; the "
            "other: {dashed1}, {dashed2}, {dashed3}."
        ),
    )


# Mistakes

SET_OFF = (pi / 12, pi / 2, -pi / 9)  # rad
SPEED, LASTS, TIMES = -0.15, 2.0, 24  # m/s along x; s; how often the joint rates are computed
MADE = (
    last_joint_only,
    separate_rates,
    l_2_for_l_3,
    times_J,
    plus_sine,
    not_derived,
)
MISTAKES = symbols(f"mistake:{len(MADE)}", real=True)  # 1 for the one that is made, else 0


def wrong_rates(angles: tuple[Any, Any, Any]) -> Any:
    """Return the joint rates at some angles, by the mistake that is chosen."""
    right, chosen = wrong_jacobian(), dict(zip(MADE, MISTAKES, strict=True))
    wrong = {
        is_one > 0.5: wrong_jacobian(m.formula) for m, is_one in chosen.items() if m is not times_J
    }
    entries = [
        Piecewise(*((J[i], one) for one, J in wrong.items() if J[i] != right[i]), (right[i], True))
        for i in range(9)
    ]
    twist = Matrix([SPEED, 0, phi_dot])
    multiplied = times_J.substitute({WHOLE_J: right, TWIST_OF: twist}).doit()
    rates = zip(multiplied, solve(Matrix(3, 3, entries), twist), strict=True)
    both = Matrix([Piecewise((a, chosen[times_J] > 0.5), (b, True)) for a, b in rates])
    return inline_steps(both, substitute_sizes(arm.SHORT, angle_values(angles))).xreplace(SIZES)


def mistakes_figure() -> Figure:
    """Draw a hand that shall move along x and turn: the arm's motion, and its program's belief."""
    state = symbols("theta1_k theta2_k theta3_k")
    end = symbols("theta1_n theta2_n theta3_n")
    step = [a + rate * t / TIMES for a, rate in zip(state, wrong_rates(state), strict=True)]
    loop = Recurrence(state, SET_OFF, tuple(step), Integer(TIMES), TIMES, end)
    start = substitute(
        inline_steps(arm.forward.right, arm.SHORT), {**SIZES, **angle_values(SET_OFF)}
    )
    wanted = zip(POSE, start, (SPEED, 0, phi_dot), strict=True)
    real, believed = joints(end), joints(ANGLES)
    return Figure(
        name="wrong-arm",
        title="An arm, and where its program with a mistake believes it to be",
        view=(-0.48, 0.72, -0.24, 0.7),
        controls=(
            Choice.one_hot("mistake", MISTAKES, (m.title for m in MADE)),
            Slider(phi_dot, -0.6, 0.6, start=-0.6, step=0.1, label="wanted turning rate φ̇"),
            Clock(t, 0.0, LASTS, start=LASTS, loops=True, label="time"),
        ),
        where=(
            *((symbol, begin + rate * t) for symbol, begin, rate in wanted),
            *substitute_sizes(arm.inverse.where),
            (theta3, arm.inverse.right[2]),
        ),
        shapes=(
            Line("approximation", (start, (x, y))),
            Trail("path", joints(state)[2], loop, dots=False),
            Line("error", (real[2], (x, y))),
            Line("approximation", (BASE, *believed)),
            Line("path", (BASE, *real)),
            Point("left", BASE),
            *(Point("body", joint) for joint in real[:2]),
            Point("target", real[2], label="hand"),
        ),
        readouts=(
            Readout("apart", "hands apart", distance(real[2], (x, y)), "m"),
            Readout("turned", "hand's heading off by", phi_hand - sum(end), "rad", digits=0),
        ),
        sentence=(
            "{mistake}: after {t} the hand is {apart} from where its program believes it. Its "
            "heading is off by {turned}."
        ),
    )


FIGURES = (levers_figure(), joints_figure(), line_figure(), elbows_figure(), mistakes_figure())
