"""The live figures of the chapter on the planar arm: one arm that draws, all the way."""

from collections.abc import Mapping, Sequence
from math import pi
from typing import Any

from sympy import (
    Abs,
    And,
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
    sign,
    sin,
    sqrt,
    symbols,
)

from book import things
from book.differential_drive.figures import n, t
from book.letters import put_back
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
    RATES,
    TWIST,
    damping,
    g,
    gain,
    h,
    phi_dot,
    phi_hand,
    rate1,
    rate2,
    rate3,
    sigma,
    theta1,
    theta2,
    theta3,
    x,
    x_c,
    x_dot,
    y,
    y_c,
    y_dot,
)
from book.things.graph import Graph
from courseware.equations import Where, as_written, declarations, substitute
from courseware.equations.functions import solve
from courseware.figures import (
    POINTER,
    AngleArc,
    Area,
    Arrow,
    Choice,
    Clock,
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
    Scene,
    Slider,
    Track,
    Trail,
    assign,
    distance,
    when,
)
from robokin._triangle import TOLERANCE

quantity, _ = declarations(__name__)

LINKS = (0.4, 0.3, 0.2)  # m, as in the exercise
START = (pi / 6, pi / 3, -pi / 2)  # rad, as in the exercise
SIZES = dict(zip(LENGTHS, LINKS, strict=True))
BASE = (0, 0)
ELBOW, WRIST, HAND = (arm.x_2, arm.y_2), (arm.x_3, arm.y_3), (x, y)
JOINTS: tuple[Any, ...] = (BASE, ELBOW, WRIST)
CENTRE = (x_c, y_c)
s = Symbol("s")

line_x = quantity("line_x", "m", -0.4, 0.85, "where a line for the hand ends", latex="x_e")
line_y = quantity("line_y", "m", -0.1, 0.7, "where a line for the hand ends", latex="y_e")
guess_x = quantity("guess_x", "m", -0.6, 1, "your guess, along x")
guess_y = quantity("guess_y", "m", -0.3, 1, "your guess, along y")
turned = quantity("turned", "", 0, 1, "how much of its turn joint 2 has made")
laid = quantity("laid", "", 0, 1, "how much of the weights is laid on the joints")
push = quantity("push", "N", 0, 20, "size of a force on the hand", latex="f")
push_angle = quantity("push_angle", "rad", -3.2, 3.2, "direction of a force", r"\beta")
tilt4 = quantity("tilt4", "rad", -1, 1, "direction of link 3, of an arm with four links", r"\psi")


def substitute_sizes(steps: Where, values: Mapping[Any, Any] = SIZES) -> list[tuple[Symbol, Any]]:
    """Return named steps with the figures' links in place of their symbols."""
    return [(symbol, substitute(step, values)) for symbol, step in steps]


def inline_steps(expression: Any, steps: Where) -> Any:
    """Return an expression with its named steps written out, the last first."""
    for symbol, step in reversed(list(steps)):
        expression = substitute(expression, {symbol: step})
    return expression


def joints_at(angles: Sequence[Any], links: Sequence[float] = LINKS) -> list[tuple[Any, Any]]:
    """Return the places of all joints, and of the hand, of an arm at these angles."""
    places: list[tuple[Any, Any]] = [BASE]
    heading: Any = 0
    for angle, link in zip(angles, links, strict=True):
        heading += angle
        ahead, above = places[-1]
        places.append((ahead + link * cos(heading), above + link * sin(heading)))
    return places


def drawing_arm(angles: Sequence[Any] = ANGLES, look: str = "", tool: str = "pen") -> Any:
    """Return the arm from above; a ghost has no base of its own."""
    return things.arm((0, 0, 0), angles, LINKS, tool, base="" if look else "plate", look=look)


# The scene: the arm of the exercise, what its joints do, what its hand does.

PLACES: Where = (  # of joints and hand, from the angles
    *SIZES.items(),
    *arm.SHORT,
    *arm.JOINTS,
    *assign(arm.forward),
)
GIVEN: Where = (*zip(ANGLES, START, strict=True), *PLACES)
MOVES: Where = (*assign(arm.velocity), *assign(arm.hand_centre))
SIZE = 0.16  # m, radius of the weight of 1 rad/s
CORNER = 0.05  # m, the sign of a right angle
MIDDLE = pi / 36  # rad: the middle of the sliders, from -170° to 180°
PAIRS = tuple(zip(JOINTS, RATES, strict=True))
AT_INFINITY = {"inf": "at infinity", "-inf": "at infinity", "nan": "nowhere: at rest"}


def circle(kind: Any, at: Sequence[Any], radius: Any) -> Curve:
    """Return a circle."""
    place = at[0] + radius * cos(s), at[1] + radius * sin(s)
    return Curve(kind, place, s, 0, 2 * pi, samples=48)


def weight(at: Sequence[Any], rate: Any, kind: Any = None) -> tuple[Any, ...]:
    """Return a joint's rate as a weight: a disc whose area is its size, a ring if negative.

    From 4 rad/s on it grows no more: it would cover the arm.
    """
    radius, kind = SIZE * sqrt(Min(Abs(rate), 4)), kind or rate
    rim = tuple(
        (at[0] + radius * cos(k * pi / 12), at[1] + radius * sin(k * pi / 12)) for k in range(24)
    )
    bar = tuple(
        (at[0] + radius * a, at[1] + radius * b)
        for a, b in ((-0.6, -0.12), (0.6, -0.12), (0.6, 0.12), (-0.6, 0.12))
    )
    return (
        *when(rate > 0, *2 * (Area(kind, rim),)),
        *when(rate < 0, *3 * (Area("body", bar),)),
        circle(kind, at, radius),
    )


def weight_handle(at: Sequence[Any], rate: Any, number: int) -> Handle:
    """Return a handle on the rim of a weight: above its joint, below if negative."""
    far = (POINTER[1] - at[1]) / SIZE
    place = (at[0], at[1] + SIZE * sign(rate) * sqrt(Abs(rate)))
    return Handle(f"weight of joint {number}", place, {rate: far * Abs(far)})


def angle_from_pointer(joint: Any, heading: Any) -> Any:
    """Return the angle of a link, from the heading before it, that points at the pointer."""
    with as_written():
        right, up = POINTER[0] - joint[0], POINTER[1] - joint[1]
        ahead = right * cos(heading + MIDDLE) + up * sin(heading + MIDDLE)
        left = up * cos(heading + MIDDLE) - right * sin(heading + MIDDLE)
        return MIDDLE + atan2(left, ahead)


def rate_sliders(*starts: float, most: float = 1) -> tuple[Slider, ...]:
    """Return sliders for the three rates."""
    pairs = zip(RATES, starts, strict=True)
    return tuple(
        Slider(rate, -most, most, start=start, step=0.01, label=f"joint {k}: θ̇_{k}")
        for k, (rate, start) in enumerate(pairs, 1)
    )


def angle_slider(angle: Any, start: float, step: float = 1) -> Slider:
    """Return the slider of a joint's angle, in degrees."""
    return Slider.degrees(angle, -170, 180, start=start, step=step, label=f"joint {str(angle)[-1]}")


def arrow_to(kind: Any, tail: Sequence[Any], by: Sequence[Any], label: str | None = None) -> Arrow:
    """Return an arrow from a place, by so much."""
    return Arrow(kind, tail, (tail[0] + by[0], tail[1] + by[1]), label)


HEADINGS = (0, theta1, theta1 + theta2)
SCENE = Scene(
    layers={
        "triangle": (Area("icr", JOINTS), Line("ghost", (*JOINTS, BASE))),
        "arm": (drawing_arm(),),
        "weights": tuple(part for pair in PAIRS for part in weight(*pair)),
        "letters": tuple(Label(rate, (at[0] - 0.07, at[1] + 0.05)) for at, rate in PAIRS),
        "spokes": tuple(Line("icr", (CENTRE, at)) for at in (*JOINTS, HAND)),
        "velocity": (arrow_to("velocity", HAND, (x_dot / 2, y_dot / 2), "v"),),
        "centre": (Point("icr", CENTRE, "balance point"),),
        "P": (Point("target", HAND, "P"),),
    },
    handles={
        "joints": (
            Handle("elbow, the end of link 1", ELBOW, {theta1: angle_from_pointer(BASE, 0)}),
            Handle("wrist, the end of link 2", WRIST, {theta2: angle_from_pointer(ELBOW, theta1)}),
            Handle("pen, end of link 3", HAND, {theta3: angle_from_pointer(WRIST, HEADINGS[2])}),
        ),
        "weights": tuple(weight_handle(*pair, k) for k, pair in enumerate(PAIRS, 1)),
    },
    common={
        "view": (-0.28, 0.94, -0.13, 0.63),
        "ground": "tiles",
        "where": GIVEN,
    },
)


# Opening, and the same line at the end.

BEGIN = tuple(float(each) for each in joints_at(START)[3])
LINE_END = (-0.1, 0.5)  # m
HALFWAY = ((BEGIN[0] + LINE_END[0]) / 2, 0.5)
BAND, NEAR_DOT = 0.01, 0.02  # m: so far from the line and from its dots the pen may be
DURATION = 4.0  # s, for the whole line
NOWHERE = (nan, nan)
PAPER = (
    things.sheet((0.22, 0.5, 0), 0.92, 0.3),
    Area(
        "target",
        tuple((end[0] + 0.01 * k, 0.5 + up) for end, k, ups in (
            (LINE_END, -1, (-BAND, BAND)), (BEGIN, 1, (BAND, -BAND))
        ) for up in ups),
    ),
    Line("ghost", (BEGIN, LINE_END)),
    Point("target", BEGIN, "start"),
    Point("target", HALFWAY),
    Point("target", LINE_END, "end"),
)  # fmt: skip
OUTSIDE = Or(Abs(y - 0.5) > BAND, x > BEGIN[0] + BAND, x < LINE_END[0] - BAND)
SPILT = tuple(Piecewise((each, OUTSIDE), (nan, True)) for each in HAND)


def draw_figure() -> Figure:
    """Draw the arm with a pen, three joints under the hand, and a line to draw."""
    return SCENE.figure(
        "draw-line",
        "An arm with a pen from above, its three joints under your hand, and a line on a paper",
        "",
        drag="joints",
        view=(-0.42, 0.82, -0.13, 0.67),
        ground="table",
        controls=tuple(angle_slider(a, b, 0.5) for a, b in zip(ANGLES, (30, 60, -90), strict=True)),
        where=PLACES,
        shapes=(
            *PAPER,
            Track("error", SPILT, "spilt ink"),
            Track("path", HAND, "ink"),
            drawing_arm(),
        ),
        readouts=(
            Readout("off", "pen off the line", Abs(y - 0.5), "cm", 1),
            Readout("middle", "to the middle dot", distance(HAND, HALFWAY), "cm", 1),
            Readout("end", "to the left dot", distance(HAND, LINE_END), "cm", 1),
        ),
        goal=(
            Goal(distance(HAND, HALFWAY) < NEAR_DOT, "Rest on the middle dot, within 2 cm."),
            Goal(distance(HAND, LINE_END) < NEAR_DOT, "Rest on the left dot, within 2 cm."),
        ),
    )


def by_itself_figure() -> Figure:
    """Draw the arm that follows the line by itself, over the reader's own ink."""
    solved = substitute_sizes(arm.inverse.where)
    with as_written():
        along = BEGIN[0] + (LINE_END[0] - BEGIN[0]) * t / DURATION
    return SCENE.figure(
        "by-itself",
        "The arm draws the line by itself, over what you have drawn at the top of the page",
        "",
        view=(-0.42, 0.82, -0.13, 0.67),
        ground="table",
        controls=(Clock(t, 0.0, DURATION, label="time"),),
        where=(
            (x, along),
            (y, 0.5),
            (phi_hand, 0),
            *solved,
            (theta3, arm.inverse.right[2]),
        ),
        shapes=(
            *PAPER,
            Track("error", NOWHERE, "spilt ink"),
            Track("path", NOWHERE, "ink"),
            Line("velocity", (BEGIN, HAND)),
            drawing_arm(),
        ),
        readouts=(Readout(theta1), Readout(theta2), Readout(theta3)),
    )


# The exercise, and step 1.

ALONG_X, AFTER_2 = (0.14, 0), 0.11  # m


def exercise_figure() -> Figure:
    """Draw the arm of the exercise with all its symbols, at rest."""
    ends = (*JOINTS, HAND)
    turns = ((theta1, 0), (theta2, theta1), (theta3, theta1 + theta2))
    onward = [
        Line("ghost", (at, (at[0] + 0.17 * cos(before), at[1] + 0.17 * sin(before))))
        for at, (_, before) in zip(JOINTS, turns, strict=True)
    ]
    return SCENE.figure(
        "planar-exercise",
        "The arm from above with its symbols: three links, three joint angles, the hand's point P",
        "arm P",
        view=(-0.3, 0.86, -0.12, 0.68),
        shapes=(
            Arrow("x_axis", BASE, (0.25, 0), "x"),
            Arrow("y_axis", BASE, (0, 0.25), "y"),
            *onward,
            *(
                AngleArc(angle, at, before, before + angle, AFTER_2)
                for at, (angle, before) in zip(JOINTS, turns, strict=True)
            ),
            *(
                Length(link, a, b, aside=-0.06 if k else 0.06)
                for k, (link, a, b) in enumerate(zip(LENGTHS, ends, ends[1:], strict=False))
            ),
            *(
                Label("body", (at[0] - 0.055, at[1] - 0.055), str(k))
                for k, at in enumerate(JOINTS, 1)
            ),
        ),
    )


def hand_guess_figure() -> Figure:
    """Draw the arm whose joint 2 will turn by a quarter, and a guess of where P will be."""
    angles = (START[0], START[1] + turned * pi / 2, START[2])
    return SCENE.figure(
        "hand-guess",
        "The arm, whose joint 2 will turn by a quarter, and your guess of where its pen will be",
        "",
        view=(-0.6, 0.95, -0.2, 0.76),
        controls=(
            Slider(guess_x, -0.58, 0.9, start=0.6, step=0.01, label="x"),
            Slider(guess_y, -0.18, 0.74, start=0.2, step=0.01, label="y"),
            Clock(turned, 0.0, 1.0, label="turned", rate=0.5),
        ),
        shapes=(
            drawing_arm(START, "ghost"),
            Curve(
                "approximation",
                joints_at((START[0], START[1] + s * pi / 2, START[2]))[3],
                s,
                0,
                turned,
            ),
            drawing_arm(angles),
            Label("body", (joints_at(START)[1][0] + 0.07, joints_at(START)[1][1] - 0.03), "2"),
            Point("target", (guess_x, guess_y), "your guess"),
        ),
        handles=(Handle("your guess", (guess_x, guess_y)),),
    )


TURNS = symbols("turns_1 turns_2 turns_3")  # 1 for the joint that turns


def levers_figure() -> Figure:
    """Draw one joint at 1 rad/s: its lever and, a quarter turn from it, the hand's velocity."""
    pivot = tuple(
        sum(turns * at[i] for turns, at in zip(TURNS, JOINTS, strict=True)) for i in range(2)
    )
    side = CORNER / sqrt(g**2 + h**2)
    corner = [(x + side * a, y + side * b) for a, b in ((-g, -h), (-g - h, g - h), (-h, g))]
    return SCENE.figure(
        "arm-levers",
        "One joint of an arm turns: its lever, and the velocity of the hand",
        "arm P",
        view=(-0.85, 1.1, -0.2, 1.12),
        controls=(
            Choice.one_hot(
                "joint",
                TURNS,
                ("joint 1", "joint 2", "joint 3"),
                label="joint that turns",
                start="joint 2",
            ),
            Slider.degrees(theta2, -30, 120, start=60, step=5, label="joint 2"),
        ),
        where=(
            (theta1, START[0]),
            (theta3, START[2]),
            *PLACES,
            (g, x - pivot[0]),
            (h, y - pivot[1]),
            (arm.rate, 1),
            *assign(arm.lever),
        ),
        shapes=(
            Arrow("approximation", pivot, HAND, "lever"),
            arrow_to("velocity", HAND, (-h, g), "v"),
            Line("text", tuple(corner)),
            Length(g, pivot, (x, pivot[1])),
            Length(h, (x, pivot[1]), HAND),
        ),
        handles=SCENE.handles["joints"][1:2],
        readouts=(Readout("length", "length of the lever", sqrt(g**2 + h**2), "m"),),
    )


# Steps 2 to 4: velocities add; three weights; back by areas.

EXERCISE_RATES = (0.2, -0.5, 0.4)  # rad/s
SECONDS = 2  # an arrow is as long as the way in this time


def added_figure() -> Figure:
    """Draw the hand's velocity as three arrows, tip to tail, and their sum."""
    tails: list[tuple[Any, Any]] = [HAND]
    for at, rate in PAIRS:
        tail = tails[-1]
        tails.append(
            (tail[0] - SECONDS * rate * (y - at[1]), tail[1] + SECONDS * rate * (x - at[0]))
        )
    return SCENE.figure(
        "tip-to-tail",
        "The arm, and at its hand three arrows tip to tail, one for each joint; and their sum",
        "arm",
        view=(-0.35, 1.15, -0.22, 0.86),
        controls=rate_sliders(*EXERCISE_RATES, most=0.6),
        where=(*GIVEN, *assign(arm.velocity)),
        shapes=(
            *(
                Arrow(rate, a, b, f"joint {k}")
                for k, (rate, a, b) in enumerate(zip(RATES, tails, tails[1:], strict=False), 1)
            ),
            Arrow("velocity", HAND, tails[3], "v"),
            Point("target", HAND, "P"),
        ),
        readouts=(Readout(x_dot), Readout(y_dot), Readout(phi_dot)),
    )


def balance_guess_figure() -> Figure:
    """Draw the arm with three equal rates, and a pin to put where the hand's sheet rests."""
    each = 0.3
    at = tuple(sum(place[i] for place in joints_at(START)[:3]) / 3 for i in range(2))
    weights = [part for place in JOINTS for part in weight(place, each * laid, "icr")]
    return SCENE.figure(
        "balance-guess",
        "The arm with three joints that turn alike, and a pin to put where the hand's sheet rests",
        "arm P",
        view=(-0.32, 0.98, -0.22, 0.66),
        controls=(
            Slider(guess_x, -0.2, 0.7, start=0.6, step=0.01, label="x"),
            Slider(guess_y, -0.1, 0.6, start=0.2, step=0.01, label="y"),
            Clock(laid, 0.0, 1.0, label="weights laid on"),
        ),
        shapes=(
            *(AngleArc("turning", place, 0.6, 0.6 + 4 * each, 0.09) for place in JOINTS),
            *weights,
            *when(laid > 0.9, Point("icr", at, "at rest")),
            Point("target", (guess_x, guess_y), "your pin"),
        ),
        handles=(Handle("your pin", (guess_x, guess_y)),),
    )


def balance_figure() -> Figure:
    """Draw the rates as weights on the joints, and their balance point."""
    middle = tuple(each / 2 for each in joints_at(START)[1])
    moving = Max(*map(Abs, RATES)) > 0.05
    return SCENE.figure(
        "balance",
        "The arm with a disc on each joint, as large as its rate, and the point that balances them",
        "triangle arm weights letters spokes velocity centre P",
        drag="weights",
        view=(-0.35, 1.0, -0.24, 0.68),
        controls=rate_sliders(0.2, 0.3, 0.2),
        where=(*GIVEN, *MOVES),
        readouts=(Readout(phi_dot),),
        goal=(
            Goal(
                And(Abs(phi_dot) < 0.02, moving),
                "Send the balance point far away: a sum of 0, within 0.02 rad/s.",
            ),
            Goal(
                And(distance(CENTRE, middle) < 0.02, moving),
                "Bring it to the middle of link 1, within 2 cm.",
            ),
        ),
    )


def areas_figure() -> Figure:
    """Draw the balance point under the hand, and the rates as areas around it."""
    triangles = tuple(
        Area(rate, (CENTRE, JOINTS[(k + 1) % 3], JOINTS[(k + 2) % 3]))
        for k, rate in enumerate(RATES)
    )
    elbow = joints_at(START)[1]
    names = [
        Label(rate, [sum(corner[i] for corner in area.points) / 3 for i in range(2)], f"A_{k}")
        for k, (rate, area) in enumerate(zip(RATES, triangles, strict=True), 1)
    ]
    return SCENE.figure(
        "areas",
        "The triangle of the three joints, cut from the balance point into three small ones",
        "arm weights letters spokes P",
        view=(-0.35, 1.0, -0.24, 0.68),
        controls=(
            Slider(x_c, -0.3, 0.9, start=0.1, step=0.01, label="centre: x_c"),
            Slider(y_c, -0.1, 0.6, start=0.4, step=0.01, label="centre: y_c"),
        ),
        where=(*GIVEN, (phi_dot, 0.5), *arm.AREAS, *assign(arm.areas), *assign(arm.det)),
        shapes=(*triangles, *triangles, *names, Point("icr", CENTRE, "centre")),
        handles=(Handle("the centre of the turn", CENTRE),),
        readouts=tuple(map(Readout, RATES)),
        goal=(
            Goal(distance(CENTRE, elbow) < 0.02, "Let joint 2 alone turn: within 2 cm."),
            Goal(
                And(Abs(rate2) < 0.03, Abs(rate1) > 0.05, Abs(rate3) > 0.05),
                "Let joint 2 rest, within 0.03 rad/s, and the two others not.",
            ),
        ),
    )


LIFT_SCALE = 1.5  # s: the wish arrow


def lift_figure() -> Figure:
    """Draw a wished motion of a hand that does not turn, and the weights that make it."""
    tip = (x + LIFT_SCALE * x_dot, y + LIFT_SCALE * y_dot)
    return SCENE.figure(
        "lift",
        "The arm with an arrow at its hand, the wished velocity, and the weights on its joints",
        "triangle arm weights letters P",
        view=(-0.35, 1.0, -0.24, 0.82),
        controls=(
            Slider(x_dot, -0.2, 0.2, start=0.0, step=0.005, label="wanted ẋ"),
            Slider(y_dot, -0.2, 0.2, start=0.1, step=0.005, label="wanted ẏ"),
        ),
        where=(*GIVEN, (phi_dot, 0), *arm.BENDS, *assign(arm.joint_rates)),
        shapes=(Arrow("velocity", HAND, tip, "v"),),
        handles=(
            Handle(
                "tip of the wished velocity",
                tip,
                {x_dot: (POINTER[0] - x) / LIFT_SCALE, y_dot: (POINTER[1] - y) / LIFT_SCALE},
            ),
        ),
        readouts=tuple(map(Readout, RATES)),
    )


# Steps 5 to 7: a flat triangle; all at once; damping.

SPEED_OUT = 0.1  # m/s
FLAT = Graph((0.68, 1.2, 0.1, 0.66), (0.01, 1), (0.1, 100), ("sin θ_2", "|θ̇_2|"))
far_out = Symbol("far_out", real=True)


def flat_figure() -> Figure:
    """Draw the wrist moving outward as the elbow stretches: the weights swell."""
    sine, reach = 10**s, arm.distance.subs({cos(theta2): sqrt(1 - 100**s), **SIZES})
    law = FLAT.place((sine, SPEED_OUT * reach / (LINKS[0] * LINKS[1] * sine)))
    return SCENE.figure(
        "flat",
        "The arm whose wrist moves outward, its weights, and a graph of the elbow's rate",
        "triangle arm weights",
        view=(-0.28, 1.26, -0.26, 0.82),
        grid=False,
        controls=(Slider.degrees(theta2, 0.6, 90, start=60, step=0.2, label="joint 2"),),
        where=(
            (theta1, pi / 3),
            (theta3, -pi / 3),
            *PLACES,
            (arm.v_out, SPEED_OUT),
            (far_out, sqrt(arm.x_3**2 + arm.y_3**2)),
            (x_dot, SPEED_OUT * arm.x_3 / far_out),
            (y_dot, SPEED_OUT * arm.y_3 / far_out),
            (phi_dot, 0),
            *arm.BENDS,
            (rate1, arm.rates[0]),
            *assign(arm.elbow_rate),
            (rate3, arm.rates[2]),
        ),
        shapes=(
            arrow_to("velocity", WRIST, (1.5 * x_dot, 1.5 * y_dot), "v_out"),
            *FLAT.shapes(),
            Curve(rate2, law, s, -2, 0),
            Point("target", FLAT.place((sin(theta2), Abs(rate2)))),
        ),
        readouts=(Readout(rate1), Readout(rate2), Readout(rate3)),
    )


ELLIPSE = 0.25  # s: an ellipse of velocities, drawn as what they reach in this time
MEASURES: Where = (
    *zip(arm.J[:2, :], arm.jacobian.right[:2, :], strict=True),
    *arm.GRAM,
    *arm.BENDS,
    *assign(arm.manipulability),
    (arm.large, arm.longest),
    (arm.small, arm.ellipse.right[1]),
    (arm.tilt, arm.ellipse_tilt.right / 2),
)
ROUND = 1.05  # the larger half-axis by the smaller one, of what still counts as a circle


def ellipse_shapes(seconds: float = ELLIPSE) -> tuple[Any, ...]:
    """Return the ellipse of the hand's velocities, as far as they reach, with its half-axes."""
    c, b = cos(arm.tilt), sin(arm.tilt)
    long, short = seconds * arm.large, seconds * arm.small
    rim = (
        x + long * cos(s) * c - short * sin(s) * b,
        y + long * cos(s) * b + short * sin(s) * c,
    )
    return (
        Curve("velocity", rim, s, 0, 2 * pi),
        arrow_to("velocity", HAND, (long * c, long * b), "σ_1"),
        arrow_to("velocity", HAND, (-short * b, short * c), "σ_2"),
    )


def ellipse_figure() -> Figure:
    """Draw the velocities of the hand for all rates of length 1."""
    return SCENE.figure(
        "ellipse",
        "The arm, and around its hand the ellipse of all velocities at joint rates of length 1",
        "arm P",
        view=(-0.6, 0.9, -0.22, 0.74),
        controls=(angle_slider(theta2, 60), angle_slider(theta3, -90)),
        where=((theta1, START[0]), *PLACES, *MEASURES),
        shapes=ellipse_shapes(),
        handles=SCENE.handles["joints"][1:],
        readouts=(
            Readout(arm.large),
            Readout("round", "σ_2/σ_1", arm.small / arm.large, "%", 0),
            Readout(arm.w),
        ),
        goal=Goal(
            arm.large < ROUND * arm.small, "Bend the arm until the ellipse is a circle, within 5 %."
        ),
    )


HUMP = Graph((0, 1.1, 0, 0.5), (0.001, 1), (0.01, 100), ("σ in m", "rate u in rad/s"))
WISH = 0.1  # m/s


def damping_figure() -> Figure:
    """Draw the rate against σ: with damping a hump, without it 1/σ."""
    hump = WISH * 10**s / (100**s + damping**2)
    top = WISH / (2 * damping)
    return Figure(
        name="damping-hump",
        title="Graph of a rate against σ: a straight line without damping, a hump with it",
        view=(-0.2, 1.25, -0.3, 0.66),
        grid=False,
        controls=(
            Slider(sigma, 0.0, 0.5, start=0.2, step=0.005, label="σ"),
            Slider(damping, 0.01, 0.3, start=0.05, step=0.01, label="damping λ"),
        ),
        where=((arm.v, WISH), *assign(arm.damped_single)),
        shapes=(
            *HUMP.shapes(),
            Curve("ghost", HUMP.place((10**s, WISH / 10**s)), s, -3, 0),
            Curve("velocity", HUMP.place((10**s, hump)), s, -3, 0),
            Line("approximation", (HUMP.place((damping, 0.01)), HUMP.place((damping, top)))),
            Label("approximation", HUMP.place((damping, top * 1.7)), "v/(2λ)"),
            Point("target", HUMP.place((Max(sigma, 0.001), Max(arm.u, 0.01)))),
        ),
        readouts=(Readout(arm.u),),
    )


# Step 8: along the line. The state of a follower: angles, parts done, rates, the worst so far.

PARTS = 60  # pieces of the hand's path, at least
EARLY = 1e-6  # of a step: how early its end counts


def place_of(angles: Sequence[Any]) -> Any:
    """Return the hand's pose at these angles."""
    values = {**SIZES, **dict(zip(ANGLES, angles, strict=True))}
    return substitute(inline_steps(arm.forward.right, arm.SHORT), values)


def wanted_at(count: Any, angles: Sequence[Any]) -> list[tuple[Symbol, Any]]:
    """Return the wanted pose after `count` of n steps, and the twist commanded at some angles."""
    begin, place = place_of(START), place_of(angles)
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


def follower() -> tuple[Recurrence, Sequence[Any]]:
    """Return the loop that follows the line, and the symbols of its last state."""
    names = ["theta1", "theta2", "theta3", "k", "rate1", "rate2", "rate3", "worst", "busiest"]
    state, end = (symbols(" ".join(f"{name}_{which}" for name in names)) for which in "kn")
    angles, held = state[:3], state[4:7]
    values = {**SIZES, **dict(zip(ANGLES, angles, strict=True))}
    matrix = substitute_sizes(arm.damped.where, values)
    # Within a step the rates stay: parts of it show the curve on which the hand then runs.
    with as_written():
        parts = ceiling(PARTS / n)  # of one step
        done = floor((state[3] + EARLY) / parts)  # whole steps
        begins = state[3] - done * parts < 0.5
        since = Max(0, t * n / DURATION - EARLY)  # steps, the one that runs included
        made = Min(state[3] + 1, t * n / DURATION * parts) / parts  # steps, after this part
    commanded = inline_steps(arm.damped_rates, [*wanted_at(done, angles), *matrix])
    with as_written():
        rates = [
            Piecewise((new, begins), (old, True)) for new, old in zip(commanded, held, strict=True)
        ]
        lasts = Min(1, t * n / DURATION * parts - state[3]) * DURATION / (n * parts)
        turned_on = [a + rate * lasts for a, rate in zip(angles, rates, strict=True)]
        wanted = [place for _, place in wanted_at(made, angles)[:2]]
        off = distance(place_of(turned_on), wanted)
    step = (
        *turned_on,
        state[3] + 1,
        *rates,
        Max(state[7], off, evaluate=False),  # as written, which is quicker
        Max(state[8], *map(Abs, rates), evaluate=False),
    )
    start = (*START, 0, 0, 0, 0, 0, 0)
    return Recurrence(state, start, step, ceiling(since * parts), 2 * PARTS, end), end


def line_figure() -> Figure:
    """Draw a straight line at constant speed, by joint rates: steps, damping and feedback."""
    loop, end = follower()
    now = joints_at(loop.state[:3])[3]
    hand = joints_at(end[:3])[3]
    l1, l2, l3 = LINKS
    with as_written():
        off = sqrt((hand[0] - arm.x_d) ** 2 + (hand[1] - arm.y_d) ** 2)
        reach = sqrt((line_x - l3) ** 2 + line_y**2)
        room = Min(l1 + l2 - reach, reach - Abs(l1 - l2))  # from both edges of the workspace
        room = Piecewise((room, room >= 0), (nan, True))
    whole = And(t > DURATION - 0.01, Abs(line_x + 0.1) < 0.006, Abs(line_y - 0.5) < 0.006)
    return SCENE.figure(
        "arm-line",
        "An arm follows a straight line, step by step, in the ring that its hand reaches",
        "",
        view=(-0.66, 1.02, -0.24, 0.8),
        size="laboratory",
        controls=(
            Clock(t, 0.0, DURATION, label="time"),
            Slider(n, 5, 100, start=10, step=1, label="number of steps", kind="approximation"),
            Slider(gain, 0.0, 6.0, start=0.0, step=0.1, label="feedback K"),
            Slider(damping, 0.0, 0.3, start=0.0, step=0.01, label="damping λ"),
            Slider(line_x, -0.4, 0.85, start=-0.1, step=0.01, label="end of the line, x"),
            Slider(line_y, -0.1, 0.7, start=0.5, step=0.01, label="end of the line, y"),
        ),
        where=tuple(wanted_at(t * n / DURATION, end[:3])[:2]),
        shapes=(
            *(circle("ghost", (l3, 0), edge) for edge in (l1 + l2, l1 - l2)),
            Label("ghost", (l3, l1 + l2 - 0.06), "outer edge"),
            Label("ghost", (l3, l2 - l1 - 0.06), "inner edge"),
            Line("icr", (BEGIN, (line_x, line_y))),
            drawing_arm(end[:3]),
            Trail("approximation", now, loop, dots=False),
            Point("icr", (line_x, line_y), label="end"),
            Point("target", (arm.x_d, arm.y_d)),
        ),
        handles=(Handle("end of the line", (line_x, line_y)),),
        readouts=(
            Readout("off", "hand off the wanted point", off, "m", 4),
            Readout("worst", "farthest off so far", end[7], "m", 4),
            Readout("busiest", "fastest joint so far", end[8], "rad/s"),
            Readout("room", "end inside the workspace by", room, "m", words={"nan": "no: outside"}),
        ),
        goal=(
            Goal(And(whole, end[7] < 0.001), "Draw the whole line to x −0.1 m within 1 mm."),
            Goal(
                And(whole, end[7] < 0.005, end[8] < 0.52),
                "Draw it within 5 mm, and no joint faster than 0.52 rad/s.",
            ),
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
    steps, found = [*place, (done, clamped), (missed, short)], []
    for side, (a2, a1, a3) in ((1, named[:3]), (-1, named[3:])):
        steps.append((a2, side * substitute(bend, {arm.d: done})))
        steps.append((a1, substitute(shoulder, {theta2: a2})))
        steps.append((a3, substitute(arm.inverse.right[2], {theta1: a1, theta2: a2})))
        found.append((a1, a2, a3))
    solved = [
        [Piecewise((nan, outside), (turn.substitute({motion.angle: a}), True)) for a in each]
        for each in found
    ]
    out = {"nan": "out of reach"}
    return SCENE.figure(
        "arm-elbows",
        "One pose of the hand, two arms that reach it, and the ring that the wrist reaches",
        "",
        view=(-1.0, 1.0, -0.72, 0.78),
        size="laboratory",
        controls=(
            Slider(x, -0.9, 0.9, start=0.55, step=0.01, label="hand x"),
            Slider(y, -0.9, 0.9, start=0.5, step=0.01, label="hand y"),
            Slider.degrees(phi_hand, step=5, label="hand angle φ"),
        ),
        where=tuple(steps),
        shapes=(
            *(circle("ghost", BASE, each) for each in (most, least)),
            Line("error", (joints_at(found[0])[3], (x, y))),
            drawing_arm(found[1], "ghost"),
            drawing_arm(found[0]),
            Point("target", (x, y), label="hand"),
        ),
        handles=(Handle("hand", (x, y)),),
        readouts=(
            Readout("distance", "wrist from the base", arm.d, "m"),
            *(
                Readout(f"{side}{i + 1}", f"{side} arm: θ_{i + 1}", solved[k][i], "rad", words=out)
                for k, side in enumerate(("solid", "pale"))
                for i in range(3)
            ),
            Readout("missed", "out of reach by", missed, "m"),
        ),
    )


# The laboratory: all layers.

SINGULAR = 1e-9  # |sin θ2|: a reader's idea of 0
NEAR = 0.1  # |sin θ2|, 6° from stretched or folded
MARK = (0.1, 0.35)  # m, about which the hand shall turn


def joints_figure() -> Figure:
    """Draw the arm by its joints and rates, with all layers of the chapter."""
    bend = Abs(sin(theta2))
    near = Piecewise((oo, bend <= SINGULAR), (nan, bend < NEAR), (bend, True))
    alone = And(Abs(rate1) < 0.015, Abs(rate3) < 0.015, rate2 > 0.05)
    return SCENE.figure(
        "arm-joints",
        "The arm with its joints and rates under your hand: weights, balance point, ellipse",
        "triangle arm weights spokes velocity P",
        drag="joints",
        view=(-1.0, 1.0, -0.6, 0.9),
        size="laboratory",
        controls=(
            *(angle_slider(*each) for each in zip(ANGLES, (30, 60, -90), strict=True)),
            *rate_sliders(0.2, 0.3, 0.2),
        ),
        where=(*PLACES, *MOVES, *MEASURES, *assign(arm.det), (arm.v_out, SPEED_OUT)),
        shapes=(*ellipse_shapes(0.5), Point("icr", CENTRE), Point("target", MARK, "mark")),
        readouts=(
            Readout(phi_dot),
            Readout(arm.det_J),
            Readout(arm.w),
            Readout(arm.large),
            Readout(arm.small),
            Readout(
                "elbow",
                "elbow's rate, wrist outward at 0.1 m/s",
                arm.elbow_rate.right,
                "rad/s",
                digits=2,
                words={"nan": "no rate does it"},
            ),
            Readout(
                "near",
                "pose: |sin θ_2|",
                near,
                digits=2,
                words={"inf": "0: singular", "nan": "below 0.1: nearly singular"},
            ),
        ),
        goal=(
            Goal(
                And(alone, Abs(y - arm.y_2) < 0.02, x > arm.x_2 + 0.05),
                "Let joint 2 alone turn, and move P straight up: both as high, within 2 cm.",
            ),
            Goal(
                And(distance(CENTRE, MARK) < 0.02, Abs(phi_dot) > 0.1),
                "Turn the hand about the mark, within 2 cm, faster than 0.1 rad/s.",
            ),
            Goal(
                And(bend < 0.02, arm.large < 2 * arm.small),
                "Stretch or fold the elbow, within 1°, and keep σ_1 below 2 σ_2.",
            ),
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
    at = dict(zip(ANGLES, angles, strict=True))
    return inline_steps(both, substitute_sizes(arm.SHORT, at)).xreplace(SIZES)


def mistakes_figure() -> Figure:
    """Draw a hand that shall move along x and turn: the arm's motion, and its program's belief."""
    state = symbols("theta1_k theta2_k theta3_k")
    end = symbols("theta1_n theta2_n theta3_n")
    step = [a + rate * t / TIMES for a, rate in zip(state, wrong_rates(state), strict=True)]
    loop = Recurrence(state, SET_OFF, tuple(step), Integer(TIMES), TIMES, end)
    start, real = place_of(SET_OFF), joints_at(end)[3]
    wanted = zip(POSE, start, (SPEED, 0, phi_dot), strict=True)
    return SCENE.figure(
        "wrong-arm",
        "An arm, and where its program with a mistake believes it to be",
        "",
        view=(-0.6, 0.85, -0.14, 0.68),
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
            Line("approximation", (start, HAND)),
            drawing_arm(look="ghost"),
            drawing_arm(end, "wrong"),
            Trail("path", joints_at(state)[3], loop, dots=False),
            Line("error", (real, HAND)),
            Point("target", real, label="hand"),
        ),
        readouts=(
            Readout("apart", "hands apart", distance(real, HAND), "m"),
            Readout("turned", "hand's heading off by", phi_hand - sum(end), "rad", digits=0),
        ),
    )


# Glances: a force is a line; four links. And the recap.


def force_figure() -> Figure:
    """Draw a force on the hand as a line, and each joint's distance from it."""
    way = (cos(push_angle), sin(push_angle))
    levers = [(x - at[0]) * way[1] - (y - at[1]) * way[0] for at in JOINTS]
    feet = [
        (at[0] + lever * way[1], at[1] - lever * way[0])
        for at, lever in zip(JOINTS, levers, strict=True)
    ]
    far = [(x + k * way[0], y + k * way[1]) for k in (-2, 2)]
    return SCENE.figure(
        "force-line",
        "The arm, a force at its hand, the line of the force, and the joints' distances from it",
        "arm",
        view=(-0.35, 1.0, -0.24, 0.68),
        controls=(
            Slider(push, 1, 20, start=10, step=1, label="force f"),
            Slider.degrees(push_angle, start=20, label="its direction"),
        ),
        shapes=(
            Line("ghost", tuple(far)),
            *(Line(rate, (at, foot)) for rate, at, foot in zip(RATES, JOINTS, feet, strict=True)),
            arrow_to("velocity", HAND, (push * way[0] / 60, push * way[1] / 60), "f"),
            Point("target", HAND, "P"),
        ),
        handles=(
            Handle(
                "tip of the force",
                (x + 0.2 * way[0], y + 0.2 * way[1]),
                {push_angle: atan2(POINTER[1] - y, POINTER[0] - x)},
            ),
        ),
        readouts=tuple(
            Readout(f"torque{k}", f"torque of joint {k}", push * lever, "N·m")
            for k, lever in enumerate(levers, 1)
        ),
    )


FOUR = (0.4, 0.3, 0.2, 0.1)  # m
FOUR_START = (30, 60, -90, 40)  # degrees


def four_links_figure() -> Figure:
    """Draw an arm with four links whose hand stays while its elbows move, and its weights."""
    start = joints_at([pi / 180 * each for each in FOUR_START], FOUR)
    hand, wrist = start[4], start[3]
    l1, l2 = FOUR[:2]
    steps = NamedSteps()
    third = (
        steps.add("third_x", wrist[0] - FOUR[2] * cos(tilt4)),
        steps.add("third_y", wrist[1] - FOUR[2] * sin(tilt4)),
    )
    far = steps.add("far", sqrt(third[0] ** 2 + third[1] ** 2))
    bend = steps.add("bend", substitute(arm.ELBOW, {arm.l1: l1, arm.l2: l2, arm.d: far}))
    ahead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    lead = steps.add("lead", atan2(third[1], third[0]) - ahead)
    angles = (lead, bend, tilt4 - lead - bend, pi / 180 * sum(FOUR_START) - tilt4)
    places = [BASE, (l1 * cos(lead), l1 * sin(lead)), third, wrist]
    sizes = []
    for k in range(4):
        (ax, ay), (bx, by), (cx, cy) = (at for i, at in enumerate(places) if i != k)
        area = (-1) ** k * ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))
        sizes.append(steps.add(f"area_{k}", area))
    whole = steps.add("whole", 3 * sqrt(sum(each**2 for each in sizes)))
    rates = [steps.add(f"idle_{k}", each / whole) for k, each in enumerate(sizes)]
    return SCENE.figure(
        "four-links",
        "An arm with four links whose hand stays in its place while its elbows move",
        "",
        view=(-0.42, 1.0, -0.22, 0.72),
        controls=(Slider(tilt4, -0.4, 0.9, start=0.0, step=0.01, label="direction of link 3"),),
        where=steps,
        shapes=(
            things.arm((0, 0, 0), angles, FOUR),
            *(part for pair in zip(places, rates, strict=True) for part in weight(*pair, "icr")),
            Point("target", hand, "hand"),
        ),
        handles=(
            Handle(
                "end of link 2",
                third,
                {tilt4: atan2(wrist[1] - POINTER[1], wrist[0] - POINTER[0])},
            ),
        ),
        readouts=(Readout("first", "angle of joint 1", lead, "rad"),),
    )


def letters_figure() -> Figure:
    """Draw the chapter's picture at rest, with two letters that are to be put back."""
    answers = {"ICR": (x_c - 0.1, y_c + 0.06), "½ det J": (0.275, 0.36)}
    letters = put_back(quantity, ("ICR", "½ det J", "w", "φ̇"), answers)
    return SCENE.figure(
        "weight-letters",
        "Weights on three joints, the triangle between them, the hand's motion, and two numbers",
        "triangle arm weights letters spokes velocity P",
        view=(-0.35, 1.0, -0.2, 0.68),
        controls=letters.controls,
        where=(*GIVEN, *zip(RATES, (0.2, 0.3, 0.2), strict=True), *MOVES),
        shapes=(Point("icr", CENTRE), *letters.shapes),
        goal=letters.goal,
    )


FIGURES = (
    draw_figure(),
    exercise_figure(),
    hand_guess_figure(),
    levers_figure(),
    added_figure(),
    balance_guess_figure(),
    balance_figure(),
    areas_figure(),
    lift_figure(),
    flat_figure(),
    ellipse_figure(),
    damping_figure(),
    line_figure(),
    by_itself_figure(),
    elbows_figure(),
    joints_figure(),
    mistakes_figure(),
    force_figure(),
    four_links_figure(),
    letters_figure(),
)
