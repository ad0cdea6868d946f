"""The live figures of the chapter on wheel constraints: a trolley, then one robot all the way."""

import re
from typing import Any

from sympy import (
    Abs,
    And,
    Matrix,
    Max,
    Min,
    Not,
    Or,
    Piecewise,
    Rational,
    Symbol,
    asin,
    atan2,
    cos,
    nan,
    pi,
    sign,
    sin,
    sqrt,
    symbols,
    tan,
)

from book import things
from book.differential_drive.figures import angle_size, t
from book.differential_drive.formulas import r
from book.frames.figures import point_of
from book.letters import put_back
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, theta_dot, v, v_y, x, x_dot, y, y_dot
from book.things.outlines import box, disc, line
from book.things.vehicles import CASTORS
from book.wheels import formulas as wheels
from book.wheels.exercises import DRAWN as DRAWN_ROBOTS
from book.wheels.exercises import cos_alpha, heading_for_beta, plus_l_cos, plus_sign, turned_back
from book.wheels.formulas import (
    alpha,
    beta,
    d,
    from_axle,
    from_push,
    gamma,
    l,
    omni_rates,
    rate,
    rolling_row,
    sliding_row,
    x_Q,
    y_Q,
)
from courseware.equations import as_written, declarations
from courseware.equations.functions import null_projector, rank
from courseware.figures import (
    POINTER,
    AngleArc,
    Area,
    Arrow,
    Bracket,
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
    Outline,
    Point,
    Readout,
    Scene,
    Slider,
    Sprite,
    assign,
    distance,
    when,
)

quantity, _ = declarations(__name__)

ORIGIN, QUARTER, DEGREE = (0, 0), pi / 2, pi / 180
SIZE, RADIUS = 0.2, 0.05  # m, of the exercise's robot: its spokes, and its wheels
ANGLES = (0, 2 * pi / 3, 4 * pi / 3)
KINDS = ("left", "right", "turning")  # the looks of its wheels 1, 2 and 3
s = Symbol("s")


# --- The trolley

AXLE, HAND, TRAIL = -0.42, -0.54, 0.09  # m: rear wheels, handle, from a castor's pivot to its wheel
BAY = (0.7, 0.85, 0)
NEAR, STRAIGHT = 10, 8  # cm, degrees: how far from the bay the trolley still counts as in it

locked = Symbol("locked")  # 1 while the rear wheels do not swivel
WAYS = {"x": "ahead", "y": "to the left"}
# one with wheels that swivel, then two with locked ones
PUSHES = tuple(
    tuple(
        quantity(f"push{k}_{axis}", "m", -1.5, 1.5, f"push of the hand, {way}", f"{axis}_{k}")
        for axis, way in WAYS.items()
    )
    for k in range(3)
)


def after_push(steps: NamedSteps, k: int, pose: Any, push: Any) -> tuple[Any, Any]:
    """Return the pose after a push; and how far to the left it turned about a point, and by what.

    With the rear wheels locked this point is on their axle line, and as far from the hand before
    the push as after it.
    """
    c, sn, arm = cos(pose[2]), sin(pose[2]), HAND - AXLE
    ahead = steps.add(f"ahead_{k}", arm + c * push[0] + sn * push[1])
    left = steps.add(f"left_{k}", c * push[1] - sn * push[0])
    turns = steps.add(f"turns_{k}", Piecewise((locked, Abs(left) > 1e-4), (0, True))) > 0.5
    centre = (ahead**2 + left**2 - arm**2) / (2 * left)
    far = steps.add(f"far_{k}", Piecewise((centre, turns), (0, True)))
    angle = atan2(far * ahead + arm * (left - far), arm * ahead - far * (left - far))
    turn = steps.add(f"turn_{k}", Piecewise((angle, turns), (0, True)))
    along = Piecewise((far * sin(turn), turns), (ahead - arm, True))
    aside = Piecewise((far * (1 - cos(turn)), turns), (left * (1 - locked), True))
    rear = point_of((*point_of(pose, AXLE), pose[2]), along, aside)
    end = point_of((*rear, pose[2] + turn), -AXLE)
    return tuple(steps.add(f"end{k}_{n}", part) for n, part in enumerate((*end, pose[2] + turn))), (
        far,
        turn,
        turns,
    )


def swivels(pose: Any, push: Any, turned: Any) -> tuple[list[Any], list[Any]]:
    """Return how the four castors swivel at the end of a push, and how far they have rolled."""
    far, turn, turns = turned
    straight = atan2(push[1], push[0]) - pose[2]
    angles, ways = [], []
    for px, py in CASTORS:
        lever = sqrt((px - AXLE) ** 2 + (far - py) ** 2)
        round_ = sign(turn) * (atan2(px - AXLE, far - py) - asin(Min(1, TRAIL / lever)))
        round_ += Piecewise((pi, turn < 0), (0, True))
        angle = Piecewise((round_, turns), (straight, distance(push, ORIGIN) > 1e-9), (0, True))
        angles.append(angle * (1 if px > 0 else 1 - locked))
        ways.append(Piecewise((lever * Abs(turn), turns), (distance(push, ORIGIN), True)))
    return angles, ways


def bay(end: Any) -> tuple[Any, ...]:
    """Return the place where the trolley is to be; its lamps go on when it is there."""
    corners = [
        point_of(BAY, a, b) for a, b in ((-0.6, -0.36), (0.56, -0.36), (0.56, 0.36), (-0.6, 0.36))
    ]
    lamps = "".join(disc(0.03, a, b) for a, b in corners)
    return (
        Area("target", tuple(corners)),
        Line("target", (*corners, corners[0])),
        *when(is_in_bay(end), Sprite((0, 0, 0), (Outline(lamps, "lamp", "goal_edge"),))),
        Label("target", (BAY[0], BAY[1] + 0.28), "bay"),
    )


def is_in_bay(end: Any) -> Any:
    """Return whether the trolley is in the bay."""
    return And(distance(end, BAY) < NEAR / 100, angle_size(end[2]) < STRAIGHT * DEGREE)


def trolley_figure() -> Figure:
    """Draw the opening: a trolley to push by its handle; the rear wheels can be locked."""
    start, steps, is_locked = (0, 0, 0), NamedSteps(), locked > 0.5
    once = tuple((1 - locked) * a + locked * b for a, b in zip(*PUSHES[:2], strict=True))
    again = tuple(locked * push for push in PUSHES[2])
    middle, turned = after_push(steps, 1, start, once)
    end, turned_2 = after_push(steps, 2, middle, again)
    moved = steps.add("moved", distance(again, ORIGIN)) > 1e-9
    first, second = swivels(start, once, turned), swivels(middle, again, turned_2)
    angles, ways = (
        [
            steps.add(f"{name}{k}", Piecewise((b, moved), (a, True)))
            for k, (a, b) in enumerate(zip(*pair, strict=True))
        ]
        for name, pair in zip(("swivel", "rolled"), zip(first, second, strict=True), strict=True)
    )
    shapes: list[Any] = []
    for k, (pose, push) in enumerate(((start, once), (middle, again)), 1):
        hand = point_of(pose, HAND)
        there = (hand[0] + push[0], hand[1] + push[1])
        kept = cos(pose[2]) * push[0] + sin(pose[2]) * push[1]
        shapes += when(is_locked, Line("error", (point_of((*hand, pose[2]), kept), there)))
        shapes.append(Arrow("velocity", hand, there, f"push {k}"))
    made = And(is_locked, distance(once, ORIGIN) > 0.02)
    grip = point_of(middle, HAND - 0.13)  # of the second push, behind that of the first
    shapes += when(And(made, distance(again, ORIGIN) < 0.02), Point("velocity", grip, "push again"))
    holds = ((point_of(start, HAND), locked < 0.5), (point_of(start, HAND), is_locked))
    handles = []
    for k, ((at, there), pair) in enumerate(zip((*holds, (grip, made)), PUSHES, strict=True)):
        pulled = (POINTER[0] - at[0], POINTER[1] - at[1])
        place = (at[0] + pair[0], Piecewise((at[1] + pair[1], there), (nan, True)))
        handles.append(
            Handle(f"the hand, push {max(k, 1)}", place, dict(zip(pair, pulled, strict=True)))
        )
    return Figure(
        name="trolley",
        title="A shopping trolley from above, its handle under your hand, and a bay beside it",
        view=(-0.95, 1.45, -0.48, 1.3),
        ground="tiles",
        size="laboratory",
        controls=(
            Choice("rear", "rear wheels", (locked,), {"swivel": (0,), "locked": (1,)}),
            *(
                Slider(
                    push,
                    -1.2,
                    1.5,
                    start=0.0,
                    step=0.02,
                    label=f"push{name}: {way}",
                    shown=is_locked if name else locked < 0.5,
                )
                for name, pair in zip(("", " 1", " 2"), PUSHES, strict=True)
                for push, way in zip(pair, WAYS.values(), strict=True)
            ),
        ),
        where=steps,
        shapes=(
            *bay(end),
            things.trolley(start, look="ghost"),
            *when(And(is_locked, moved), things.trolley(middle, look="ghost")),
            *when(is_locked, Line("icr", (point_of(end, AXLE, -3), point_of(end, AXLE, 3)))),
            things.trolley(end, angles, ways),
            *shapes,
        ),
        handles=tuple(handles),
        readouts=(
            Readout("off", "off the bay", distance(end, BAY), "m"),
            Readout("turned", "turned by", end[2], "rad", 0),
        ),
        goal=(
            Goal(is_in_bay(end), f"Push it into the bay: within {NEAR} cm and {STRAIGHT}°."),
            Goal(And(is_locked, is_in_bay(end)), "Again, with the rear wheels locked."),
        ),
    )


# --- The robot, and one wheel of it

HEADING = 30 * DEGREE
RATES = dict(zip(omni_rates, (-2, 4, 1), strict=True))
SIZES = ((l, SIZE), (r, RADIUS))
SLOW = 0.5  # rad/s, at which the plate turns
WHEEL_2 = ((l, SIZE), (alpha, 2 * pi / 3), (beta, 0))
HUB = (l * cos(alpha), l * sin(alpha))
FAR = 2  # m: so far lines go


def plate(pose: Any, *parts: Any, look: str = "") -> Sprite:
    """Return a round plate that wheels are fixed to."""
    nose = line((0.08, -0.03), (0.115, 0), (0.08, 0.03))
    body = (
        Outline(disc(0.15), "side", "edge"),
        Outline(disc(0.137), "dome", "shell_dark", 0.0015),
        Outline(nose, "", "dark", 0.009),
        Outline(disc(0.008), "dark"),
    )
    return Sprite(pose, (*parts, *body), 0.02, look, silhouette=disc(0.15))


def arm(place: Any) -> Sprite:
    """Return the arm from a plate's middle to a wheel at a place of its frame."""
    return Sprite(
        (*ORIGIN, place), (Outline(box(SIZE, 0.034, SIZE / 2, corner=0.01), "metal_mid", "edge"),)
    )


def wheel_on_plate(pose: Any, look: str = "") -> tuple[Any, ...]:
    """Return the plate at a pose with wheel 2 of the exercise, for now an ordinary one."""
    hub = (*point_of(pose, *HUB), pose[2] + alpha + beta - QUARTER)
    return plate(pose, arm(alpha), look=look), things.wheel(
        hub, 2 * RADIUS, 0.036, "left2", height=0.01
    )


def along(place: Any, direction: Any, far: Any = FAR) -> tuple[Any, Any]:
    """Return both ends of a line through a place."""
    return point_of((*place[:2], direction), -far), point_of((*place[:2], direction), far)


def foot(place: Any, direction: Any, point: Any) -> tuple[Any, Any]:
    """Return the point of a line that is nearest to another point."""
    ahead = cos(direction) * (point[0] - place[0]) + sin(direction) * (point[1] - place[1])
    return point_of((*place[:2], direction), ahead)


def spin(centre: Any, rate: Any = omega) -> tuple[Any, ...]:
    """Return the turning arrow about a centre; longer for a larger rate."""

    def place(angle: Any) -> tuple[Any, Any]:
        return centre[0] + 0.035 * cos(angle), centre[1] + 0.035 * sin(angle)

    end = 0.6 + 3 * rate
    return (
        Curve(omega, place(0.6 + s * 3 * rate), s, 0, 1),
        Arrow(omega, place(end - 0.3 * sign(rate)), place(end), ""),
    )


# the twist of a turn about Q
ABOUT_Q = ((v, omega * y_Q), (v_y, -omega * x_Q))
Q = (x_Q, y_Q)
AXIS, ROLLS = alpha + beta, alpha + beta - QUARTER
AXLE_LINE = (Line("icr", along(HUB, AXIS)),)
PLACED = (
    Arrow("text", ORIGIN, (0.3, 0), "x"),
    Line("ghost", (ORIGIN, HUB)),
    AngleArc(alpha, ORIGIN, 0, alpha, 0.075),
)


def q_sliders(x_start: float, y_start: float) -> tuple[Slider, Slider]:
    """Return sliders for the centre of the turn."""
    return (
        Slider(x_Q, -0.5, 0.7, start=x_start, step=0.01, label="Q ahead"),
        Slider(y_Q, -0.5, 0.5, start=y_start, step=0.01, label="Q to the left"),
    )


def q_handle() -> tuple[Handle]:
    return (Handle("the centre Q of the turn", Q),)


SCENE = Scene(
    layers={
        "axle": AXLE_LINE,
        "plate": wheel_on_plate((0, 0, 0)),
        "placed": PLACED,
        "lever": (Line("ghost", (HUB, Q)),),
        "turn": spin(Q),
        "Q": (Point("icr", Q, "Q"),),
    },
    handles={"Q": q_handle()},
    common={
        "view": (-0.45, 0.49, -0.17, 0.45),
        "ground": "tiles",
        "controls": q_sliders(0, 0.4),
    },
)


def exercise_figure() -> Figure:
    """Draw the robot of the exercise with its symbols, at rest."""
    pose = (0, 0, HEADING)
    rolls = []
    for k, (kind, each) in enumerate(zip(KINDS, omni_rates, strict=True)):
        spoke = HEADING + ANGLES[k]
        hub = point_of((0, 0, spoke), 1.16 * SIZE)
        tip = point_of((*hub, spoke - QUARTER), RADIUS * RATES[each])
        rolls += [
            Arrow(kind, hub, tip, ""),
            Label(
                kind,
                point_of((0, 0, spoke), 1.5 * SIZE),
                f"{k + 1}: {RATES[each]} rad/s".replace("-", "−"),
            ),
        ]
    return Figure(
        name="omni-exercise",
        title=(
            "A robot from above on three wheels with rollers, 120° apart; arrows show how far each "
            "rolls in a second"
        ),
        view=(-0.48, 0.48, -0.3, 0.35),
        ground="tiles",
        where=((theta, HEADING), *SIZES),
        shapes=(
            Arrow("x_axis", ORIGIN, (0.42, 0), "x"),
            Arrow("y_axis", ORIGIN, (0, 0.33), "y"),
            things.omni_robot(pose, distance=SIZE),
            AngleArc(theta, ORIGIN, 0, theta, 0.11),
            Line("heading", (ORIGIN, point_of(pose, 0.15))),
            Length(
                l,
                ORIGIN,
                point_of((0, 0, HEADING + ANGLES[2]), SIZE),
                aside=0.05,
                label="l = 20 cm",
            ),
            *rolls,
        ),
    )


def place_figure() -> Figure:
    """Draw where a wheel is, in three numbers, and where it rolls."""
    rolls = point_of((*HUB, ROLLS), 0.16)
    return Figure(
        name="wheel-place",
        title="A plate with one wheel: its spoke, its axle, and the direction in which it rolls",
        view=(-0.38, 0.42, -0.13, 0.4),
        ground="tiles",
        controls=(
            Slider.degrees(alpha, -60, 180, start=120, step=5, label="spoke α"),
            Slider.degrees(beta, -90, 90, start=25, step=5, label="axle β"),
        ),
        where=((l, SIZE),),
        shapes=(
            *AXLE_LINE,
            *wheel_on_plate((0, 0, 0)),
            Arrow("text", ORIGIN, (0.3, 0), "x"),
            Length(l, ORIGIN, HUB, aside=-0.03),
            Line(alpha, (ORIGIN, point_of((0, 0, alpha), 0.34))),
            Line(beta, (HUB, point_of((*HUB, AXIS), 0.15))),
            AngleArc(alpha, ORIGIN, 0, alpha, 0.075),
            AngleArc(beta, HUB, alpha, alpha + beta, 0.11),
            Arrow("left", HUB, rolls, "rolls"),
        ),
        handles=(
            Handle("the wheel", HUB, {alpha: atan2(POINTER[1], POINTER[0])}),
            Handle(
                "the axle",
                point_of((*HUB, AXIS), 0.15),
                {
                    beta: atan2(
                        sin(atan2(POINTER[1] - HUB[1], POINTER[0] - HUB[0]) - alpha),
                        cos(atan2(POINTER[1] - HUB[1], POINTER[0] - HUB[0]) - alpha),
                    ),
                },
            ),
        ),
        readouts=(Readout("rolls", "rolls towards", ROLLS, "rad", 0),),
        goal=Goal(
            And(angle_size(ROLLS) < 2 * DEGREE, Abs(alpha - 120 * DEGREE) > 9 * DEGREE),
            "Move the wheel elsewhere, and let it roll along x: within 2°.",
        ),
    )


pin = quantity("pin", "m", -0.4, 0.4, "your pin, along the dashed line")
HIGH = 0.3  # m: the line on which the pin is


def pin_figure() -> Figure:
    """Draw a pin to place: the plate swings about it, and the wheel must not skid."""

    def swung(time: Any) -> Any:
        c, sn = cos(SLOW * time), sin(SLOW * time)
        return pin - pin * c + HIGH * sn, HIGH - HIGH * c - pin * sn, SLOW * time

    return Figure(
        name="pin",
        title="A plate with one wheel, and a pin that it can be swung about",
        view=(-0.46, 0.46, -0.17, 0.41),
        ground="tiles",
        controls=(
            Slider(pin, -0.4, 0.4, start=0.3, step=0.01, label="pin: x"),
            Clock(t, 0.0, 1.5, label="time"),
        ),
        where=WHEEL_2,
        shapes=(
            Line("ghost", ((-0.5, HIGH), (0.5, HIGH))),
            *wheel_on_plate((0, 0, 0), look="ghost")[:1],
            Line("ghost", ((pin, HIGH), swung(t))),
            Curve("path", point_of(swung(s), *HUB), s, 0, t),
            *wheel_on_plate(swung(t)),
            Point("target", (pin, HIGH), "your pin"),
        ),
        handles=(Handle("the pin", (pin, HIGH), {pin: POINTER[0]}),),
    )


def sliding_figure() -> Figure:
    """Draw a turn about Q: the hub's velocity, and its parts along the wheel and along the axle."""
    velocity = (HUB[0] + wheels.hub_x, HUB[1] + wheels.hub_y)
    kept = foot(HUB, ROLLS, velocity)
    aside = foot(HUB, AXIS, velocity)
    return SCENE.figure(
        "sliding",
        "A plate turns about a point Q; the velocity of its wheel's hub, and two parts of it",
        "axle plate placed lever turn Q",
        drag="Q",
        where=(*WHEEL_2, (omega, SLOW), *ABOUT_Q, *assign(wheels.hub, wheels.sliding_by_distance)),
        shapes=(
            Line("ghost", (kept, velocity, aside)),
            Arrow("left", HUB, kept, "rolls"),
            *when(Abs(wheels.across) > 0.002, Line("error", (HUB, aside))),
            Arrow("velocity", HUB, velocity, "hub"),
            *when(Abs(from_axle) > 0.01, Length(from_axle, foot(HUB, AXIS, Q), Q)),
        ),
        readouts=(Readout(from_axle, digits=4), Readout(wheels.across, digits=4)),
        goal=(
            Goal(
                And(Abs(from_axle) < 0.008, distance(Q, HUB) > 0.12),
                "Put Q where nothing slides: a between −8 and 8 mm.",
            ),
            Goal(
                And(Abs(from_axle) < 0.008, distance(Q, HUB) > 0.12, y_Q < 0.1),
                "And on the other side of the plate's middle.",
            ),
        ),
    )


def rolling_figure() -> Figure:
    """Draw a turn about Q: how far Q is from the line along which the wheel rolls."""
    return SCENE.figure(
        "rolling",
        "A plate turns about Q; the line along which its wheel rolls, and how far Q is from it",
        "plate placed turn Q",
        drag="Q",
        where=(
            *WHEEL_2,
            (r, RADIUS),
            (omega, SLOW),
            *ABOUT_Q,
            *assign(wheels.rolling_by_distance),
        ),
        shapes=(
            Line("left", along(HUB, ROLLS)),
            *when(Abs(from_push) > 0.01, Length(from_push, foot(HUB, ROLLS, Q), Q)),
            Arrow("left", HUB, point_of((*HUB, ROLLS), RADIUS * rate), ""),
        ),
        readouts=(Readout(from_push), Readout(rate)),
        goal=(
            Goal(Abs(rate) < 0.06, "Let the wheel rest while the plate turns: within 0.06 rad/s."),
            Goal(Abs(rate + 2) < 0.06, "Let it roll backwards, at −2 rad/s: within 0.06."),
        ),
    )


# --- Several wheels: axle lines that meet, or do not

turned = quantity("turned", "rad", -1.6, 1.6, "by how much the last wheel is turned")
THIRD = (-0.14, -0.14, 45 * DEGREE)
# place, direction of the axle, whether it is there, whether the slider turns it
FIRST, SAME = (0, 0.2, QUARTER, 1, 0), (0, -0.2, QUARTER, 1, 0)
ARRANGED = {
    "one": ((0, 0.2, QUARTER, 1, 1), (0, 0, 0, 0, 0), (0, 0, 0, 0, 0)),
    "two on one line": (FIRST, (*SAME[:4], 1), (0, 0, 0, 0, 0)),
    "two in a row": (FIRST, (0.2, 0.2, QUARTER, 1, 1), (0, 0, 0, 0, 0)),
    "three": (FIRST, (0.2, 0, 0, 1, 0), (*THIRD, 1, 1)),
}
PARTS = [symbols(f"x_{k} y_{k} axle_{k} there_{k} own_{k}") for k in (1, 2, 3)]


def numbered(option: Any) -> tuple[float, ...]:
    """Return the numbers of an option, one after the other."""
    return tuple(float(number) for wheel in option for number in wheel)


def row_of(place: Any, axle: Any) -> list[Any]:
    """Return the sliding row of a wheel at a place."""
    spoke = atan2(place[1], place[0])
    return sliding_row(sqrt(place[0] ** 2 + place[1] ** 2), spoke, axle - spoke)


def turn_left(steps: NamedSteps, rows: Any) -> tuple[Any, Any]:
    """Return what the rows leave of any twist, and the centre of the one turn that is left."""
    free = null_projector(rows)
    P = Matrix(3, 3, lambda i, j: Symbol(f"P{min(i, j)}{max(i, j)}"))
    steps += [(P[i, j], free[i, j]) for i in range(3) for j in range(i, 3)]
    now = steps.add("rank_now", rank(rows))
    one = And(now > 1.5, now < 2.5, P[2, 2] > 0.02)
    return P, [Piecewise((part / P[2, 2], one), (nan, True)) for part in (-P[1, 2], P[0, 2])]


def band(kind: str, place: Any, direction: Any, half: float) -> Area:
    """Return a strip along the line through a place, in the colour of its wheel."""
    ends = (*along(place, direction), *along(place, direction)[::-1])
    sides = (half, half, -half, -half)
    corners = (point_of((*end, direction), 0, side) for end, side in zip(ends, sides, strict=True))
    return Area(kind, tuple(corners))


def lines_figure() -> Figure:
    """Draw up to three fixed wheels, their axle lines and their rows: where do the lines meet?"""
    steps = NamedSteps()
    axles = [steps.add(f"axis_{k}", w[2] + w[4] * turned) for k, w in enumerate(PARTS, 1)]
    with as_written():
        rows = [
            [w[3] * entry for entry in row_of(w, axle)]
            for w, axle in zip(PARTS, axles, strict=True)
        ]
    C = steps.add("C", Matrix(rows))
    _, centre = turn_left(steps, C)
    now = Symbol("rank_now", real=True)
    many, shared = sum(w[3] for w in PARTS), sum(w[3] for w in PARTS) - now > 0.5
    meet = And(many > 1.5, now < 2.5)
    shapes: list[Any] = []
    for k, (w, axle) in enumerate(zip(PARTS, axles, strict=True)):
        there = w[3] > 0.5
        shapes += when(there, band(KINDS[k], w, axle, 0.005), Line("icr", along(w, axle)))
        shapes += when(And(there, meet), band(KINDS[k], w, axle, 0.016))
        shapes += when(there, arm_to(w))
    shapes.append(plate((0, 0, 0)))
    for k, (w, axle) in enumerate(zip(PARTS, axles, strict=True)):
        wheel = things.wheel((*w[:2], axle - QUARTER), 0.1, 0.036, f"{KINDS[k]}2", height=0.01)
        number = Label(KINDS[k], point_of((*w[:2], axle), -0.05), str(k + 1))
        shapes += when(w[3] > 0.5, wheel, number)
    shapes.append(
        Sprite(
            (0.56, 0.16, 0),
            (Outline(box(0.44, 0.34, corner=0.02), "paper", "edge"),),
            silhouette="",
        )
    )
    for count in (1, 2, 3):
        known = And(many > count - 0.5, many < count + 0.5)
        for is_last_new in (True, False)[: 2 if count > 1 else 1]:
            looks = KINDS[:count] if is_last_new else (*KINDS[: count - 1], "ghost")
            written = Bracket(C[:count, :], (0.56, 0.2), "C_1", looks, digits=2, by_row=True)
            shapes += when(And(known, Not(shared) if is_last_new else shared), written)
    return Figure(
        name="axle-lines",
        title="A plate on one to three fixed wheels, the lines of their axles, and their rows",
        view=(-0.42, 0.8, -0.34, 0.36),
        ground="tiles",
        controls=(
            Choice(
                "wheels",
                "wheels",
                tuple(x for w in PARTS for x in w),
                {k: numbered(o) for k, o in ARRANGED.items()},
                start="three",
            ),
            Slider.degrees(turned, -90, 90, start=25, label="turn the last one"),
        ),
        where=steps,
        shapes=(
            *shapes,
            Point("icr", centre, "Q"),
        ),
        readouts=(
            Readout("rank", "rank of C_1", now, digits=0),
            Readout("ways", "ways to move", 3 - now, digits=0),
        ),
        goal=(
            Goal(
                And(now < 2.5, PARTS[2][3] > 0.5),
                "Three wheels: turn the last until one way is left.",
            ),
            Goal(And(now < 1.5, PARTS[1][3] > 0.5), "Two wheels, two ways."),
        ),
    )


def arm_to(place: Any) -> Sprite:
    """Return the arm from a plate's middle to a place."""
    far = sqrt(place[0] ** 2 + place[1] ** 2)
    bar = Outline(box(0.2, 0.034, 0.1, corner=0.01), "metal_mid", "edge")
    return Sprite((0, 0, atan2(place[1], place[0])), (bar,), size=far / 0.2)


steer_L = quantity("steer_L", "rad", -1, 1, "left front wheel: turned by", latex=r"\delta_L")
steer_R = quantity("steer_R", "rad", -1, 1, "right front wheel: turned by", latex=r"\delta_R")
LONG, HALF = 2.5, 0.75  # m, of the car: between the axles, and half between its wheels
AHEAD = (0, 0, QUARTER)  # where the car is, its rear axle at the origin


def front_figure() -> Figure:
    """Draw a car whose front wheels are turned one by one: their axle lines and the rear one."""
    left, right = symbols("meets_L meets_R", real=True)
    middle = (-(left + right) / 2, 0)
    miss = Abs(left - right)
    shapes: list[Any] = [Line("icr", ((-30, 0), (30, 0)))]
    for side, steer, meet, kind in ((1, steer_L, left, "left"), (-1, steer_R, right, "right")):
        place = point_of(AHEAD, LONG, side * HALF)
        shapes += [
            Line("icr", along(place, steer + pi, 30)),
            Line("ghost", (place, (place[0], place[1] + 1.1))),
            AngleArc(kind, place, QUARTER, QUARTER + steer, 0.9, f"δ_{kind[0].upper()}"),
            *when(
                miss > 0.1,
                Point(kind, (-meet, 0)),
                Line("error", (middle, foot(place, steer + pi, middle))),
            ),
        ]
    shapes += when(miss <= 0.1, Point("icr", middle, "Q"))
    return Figure(
        name="front-wheels",
        title="A car from above, its front wheels turned each by itself, and three axle lines",
        view=(-9, 2, -1.3, 3.9),
        ground="asphalt",
        controls=(
            Slider.degrees(steer_L, 15, 50, start=20, step=0.5, label="left front wheel"),
            Slider.degrees(steer_R, 10, 50, start=20, step=0.5, label="right front wheel"),
        ),
        where=(
            (left, HALF + LONG / tan(steer_L)),
            (right, -HALF + LONG / tan(steer_R)),
        ),
        shapes=(*shapes, things.car(AHEAD, (steer_L, steer_R))),
        readouts=(Readout("gap", "they miss each other, on the rear axle, by", miss, "m", 2),),
        goal=Goal(miss < 0.1, "Let all axle lines meet: within 10 cm."),
    )


# eight robots: place, the direction in which a wheel rolls, its kind
DRAWN = {
    "differential drive": ((0, 0.12, 0, "fixed"), (0, -0.12, 0, "fixed"), (-0.2, 0, 0, "castor")),
    "bicycle": ((0.3, 0, 0, "steered"), (0, 0, 0, "fixed")),
    "tricycle": ((0.3, 0, 0, "steered"), (0, 0.12, 0, "fixed"), (0, -0.12, 0, "fixed")),
    "car": (
        (0.3, 0.12, 0, "steered"),
        (0.3, -0.12, 0, "steered"),
        (0, 0.12, 0, "fixed"),
        (0, -0.12, 0, "fixed"),
    ),
    "one steered wheel": (
        (0.2, 0, 0, "steered"),
        (-0.12, 0.12, 0, "castor"),
        (-0.12, -0.12, 0, "castor"),
    ),
    "two steered wheels": (
        (0.2, 0, 0, "steered"),
        (-0.2, 0, 0, "steered"),
        (0, 0.12, 0, "castor"),
        (0, -0.12, 0, "castor"),
    ),
    "omni robot": (
        (0.2, 0, -QUARTER, "omni"),
        (-0.1, 0.1732, pi / 6, "omni"),
        (-0.1, -0.1732, 5 * pi / 6, "omni"),
    ),
    "Mecanum robot": (
        (0.2, 0.15, 0, "Mecanum −45°"),
        (0.2, -0.15, 0, "Mecanum 45°"),
        (-0.2, 0.15, 0, "Mecanum 45°"),
        (-0.2, -0.15, 0, "Mecanum −45°"),
    ),
}
DELTAS = {
    "differential drive": (2, 0),
    "bicycle": (1, 1),
    "tricycle": (1, 1),
    "car": (1, 1),
    "one steered wheel": (2, 1),
    "two steered wheels": (1, 2),
    "omni robot": (3, 0),
    "Mecanum robot": (3, 0),
}
MAKERS: dict[str, Any] = {
    "fixed": lambda at, roll=0: things.wheel(at, 0.1, 0.036, "", roll),
    "steered": lambda at, roll=0: things.steered_wheel(at, 0, "left2", roll, 0.1),
    "castor": lambda at, roll=0: things.castor(at, 0, TRAIL_LAB, "", roll),
    "omni": lambda at, roll=0: things.omni_wheel(at, "", roll, 0.1),
    "Mecanum 45°": lambda at, roll=0: things.mecanum_wheel(at, "", roll, 0.1, float(pi / 4)),
    "Mecanum −45°": lambda at, roll=0: things.mecanum_wheel(at, "", roll, 0.1, float(-pi / 4)),
    "ball": lambda at, roll=0: things.ball_wheel(at, 0.025),
}
TRAIL_LAB = 0.05  # m


def robots_figure() -> Figure:
    """Draw eight robots, small, with the axle lines that hold them back, and their numbers."""
    shapes: list[Any] = []
    for k, (name, made) in enumerate(DRAWN.items()):
        at = (0.95 * (k % 4), -1.15 * (k // 4), QUARTER)
        places = [(*point_of(at, px, py), ahead + QUARTER, kind) for px, py, ahead, kind in made]
        held = [place for place in places if place[3] in ("fixed", "steered")]
        shapes += [Line("icr", along(place, place[2] + QUARTER, 0.4)) for place in held]
        shapes += [Line("body", (at, place)) for place in places]
        shapes.append(Sprite(at, plate(at).parts, 0.02, size=0.6))
        shapes += [MAKERS[kind](tuple(place)) for *place, kind in places]
        m, steered = DELTAS[name]
        shapes += [
            Label("text", (at[0] - 0.38, at[1] + 0.3), f"{k + 1}"),
            Label("text", (at[0], at[1] - 0.42), f"{m} + {steered} = {m + steered}"),
        ]
    return Figure(
        name="robots",
        title="Eight robots from above, each with the axle lines of its fixed and steered wheels",
        view=(-0.5, 3.35, -2.2, 0.5),
        ground="tiles",
        shapes=tuple(shapes),
    )


# --- Wheels that forbid nothing

PUSH = 0.2  # m/s
SORTS = ("Mecanum, 45°", "omni, 90°", "castor", "ball", "fixed")
CHOSEN = symbols("is_45 is_90 is_castor is_ball is_fixed")  # 1 for the kind that is chosen
course = quantity("course", "rad", -pi, pi, "the direction in which a wheel is moved", r"\chi")


def kinds_figure() -> Figure:
    """Draw a wheel of each kind as it is moved: the part that it rolls, and how it gives way."""
    slanted, _, _, ball, fixed = CHOSEN
    with as_written():
        turn = pi / 4 * slanted
        tip = PUSH * cos(course), PUSH * sin(course)
        rolled, aside = tip[0] + tip[1] * tan(turn), tip[1] / cos(turn)
        parts = [Piecewise((part, ball < 0.5), (nan, True)) for part in (rolled, aside)]
        wheels_drawn = (
            things.mecanum_wheel((0, 0, 0), "", rolled, 0.2),
            things.omni_wheel((0, 0, 0), "", rolled, 0.2),
            things.castor((0, 0, 0), 0, 0.1, "", rolled),
            things.ball_wheel((0, 0, 0), 0.06),
            things.wheel((0, 0, 0), 0.2, 0.07, "", rolled, 0.01),
        )
        drawn = [
            thing
            for thing, mine in zip(wheels_drawn, CHOSEN, strict=True)
            for thing in when(mine > 0.5, thing)
        ]
    push = pi / 4 * slanted
    return Figure(
        name="wheel-kinds",
        title="A wheel from above is moved: what it rolls, and how it gives way",
        view=(-0.4, 0.4, -0.23, 0.26),
        ground="tiles",
        controls=(
            Choice.one_hot("kind", CHOSEN, SORTS, "wheel"),
            Slider.degrees(course, start=0, step=5, label="direction of the push"),
        ),
        shapes=(
            *when(ball < 0.5, Line("left", along(ORIGIN, push))),
            *when(fixed > 0.5, Line("icr", along(ORIGIN, QUARTER))),
            *drawn,
            Arrow("left", ORIGIN, (parts[0], 0), "rolls"),
            *when(fixed > 0.5, Line("error", ((rolled, 0), tip))),
            *when(
                And(fixed < 0.5, ball < 0.5, Abs(aside) > 0.002),
                Arrow("approximation", (rolled, 0), tip, "gives way"),
            ),
            Arrow("velocity", ORIGIN, tip, "push"),
        ),
        handles=(Handle("tip of the arrow", tip, {course: atan2(POINTER[1], POINTER[0])}),),
        readouts=(
            Readout("rolled", "rolls at", parts[0], "m/s", words={"nan": "any speed, any way"}),
            Readout("aside", "the rest", parts[1], "m/s", words={"nan": "nothing"}),
        ),
        sentence=(
            "{kind} wheel, moved at 0.2 m/s in the direction {course} from where it rolls. It "
            "rolls at {rolled}; the rest is {aside}."
        ),
    )


CASTOR = ((l, SIZE), (alpha, pi), (d, -TRAIL_LAB))
MOVING = ((v, 0.2), (v_y, 0), (omega, SLOW))


def castor_figure() -> Figure:
    """Draw a castor at some angle: how fast it swivels while the plate turns about Q."""
    with as_written():
        slid = wheels.castor.right
    contact = point_of((*HUB, ROLLS), -TRAIL_LAB)
    swivel, tip = wheels.beta_dot, point_of((*contact, AXIS), -TRAIL_LAB * wheels.beta_dot / 4)
    velocity = point_of((*HUB, 0), v, -omega * SIZE)
    return Figure(
        name="castor",
        title="A plate turns about a point Q; behind it a castor that swivels about its pivot",
        view=(-0.54, 0.42, -0.18, 0.45),
        ground="tiles",
        controls=(Slider.degrees(beta, -180, 180, start=-30, step=1, label="castor β"),),
        where=(*CASTOR, *MOVING, (swivel, slid / -d)),
        shapes=(
            Line("icr", along(contact, AXIS)),
            plate((0, 0, 0), arm(alpha)),
            things.castor((*HUB, ROLLS), 0, TRAIL_LAB),
            AngleArc(beta, HUB, alpha, alpha + beta, 0.075),
            Line("ghost", (HUB, (0, 0.4))),
            Arrow("velocity", HUB, velocity, "its velocity"),
            Arrow(swivel, contact, tip),
            Length(d, HUB, contact, aside=-0.04),
            Point("icr", (0, 0.4), "Q"),
            *spin((0, 0.4)),
        ),
        readouts=(Readout(swivel),),
        goal=Goal(
            And(Abs(swivel) < 0.12, beta < 0),
            "Stop its swivelling, with its wheel behind the pivot: within 0.12 rad/s.",
        ),
    )


roller = symbols("roller", real=True)
ROLLERS = {"−45°": float(-pi / 4), "0°": 0.0, "45°": float(pi / 4)}


def rollers_figure() -> Figure:
    """Draw a wheel with rollers: the line along which the floor can push its motor."""
    push = ROLLS + gamma
    hub = (*HUB, ROLLS)
    return Figure(
        name="rollers",
        title="A plate turns about a point Q, on a wheel with rollers; its push line is turned",
        view=(-0.42, 0.46, -0.17, 0.45),
        ground="tiles",
        size="laboratory",
        controls=(
            Choice(
                "rollers",
                "roller angle γ",
                (gamma,),
                {name: (angle,) for name, angle in ROLLERS.items()},
                start="45°",
            ),
            *q_sliders(0, 0.4),
        ),
        where=(
            *WHEEL_2,
            (r, RADIUS),
            (omega, SLOW),
            *ABOUT_Q,
            *assign(wheels.swedish_by_distance),
        ),
        shapes=(
            plate((0, 0, 0), arm(alpha)),
            *PLACED,
            *(
                thing
                for angle in ROLLERS.values()
                for thing in when(
                    Abs(gamma - angle) < 0.1, things.roller_wheel(hub, angle, "left2", length=0.1)
                )
            ),
            *when(
                Abs(gamma) > 0.1,
                Line("ghost", along(HUB, ROLLS, 0.2)),
                AngleArc(gamma, HUB, ROLLS, push, 0.15),
            ),
            Line("left", along(HUB, push)),
            *when(Abs(from_push) > 0.01, Length(from_push, foot(HUB, push, Q), Q)),
            *spin(Q),
            Point("icr", Q, "Q"),
        ),
        handles=q_handle(),
        readouts=(Readout(gamma, digits=0), Readout(from_push), Readout(rate)),
        goal=Goal(
            And(Abs(rate) < 0.06, Abs(gamma) > 0.1, distance(Q, HUB) > 0.12),
            "A Mecanum wheel, and the plate turns: let the wheel rest, within 0.06 rad/s.",
        ),
    )


# --- Three push lines

PUSH_LINES = tuple(
    Line(kind, along(point_of((0, 0, angle), SIZE), angle - QUARTER))
    for kind, angle in zip(KINDS, ANGLES, strict=True)
)
HUBS = tuple(point_of((0, 0, angle), SIZE) for angle in ANGLES)
CORNERS = tuple(point_of((0, 0, angle + pi), 2 * SIZE) for angle in ANGLES)  # of the triangle


def triangle_figure() -> Figure:
    """Draw the omni robot in the triangle of its push lines: rates are distances from its sides."""
    distances = [foot(hub, angle - QUARTER, Q) for hub, angle in zip(HUBS, ANGLES, strict=True)]
    return Figure(
        name="push-lines",
        title="The omni robot, the triangle of its push lines, and how far a point Q is from them",
        view=(-0.62, 0.82, -0.46, 0.46),
        ground="tiles",
        size="laboratory",
        controls=q_sliders(0.06, -0.1),
        where=(*SIZES, (omega, -Rational(1, 4)), *ABOUT_Q, *assign(wheels.omni_wheel_rates)),
        shapes=(
            Area("icr", CORNERS),
            *PUSH_LINES,
            things.omni_robot((0, 0, 0), distance=SIZE),
            *(Line(kind, (Q, end)) for kind, end in zip(KINDS, distances, strict=True)),
            *(
                Arrow(kind, hub, point_of((*hub, angle - QUARTER), RADIUS * each), "")
                for kind, hub, angle, each in zip(KINDS, HUBS, ANGLES, omni_rates, strict=True)
            ),
            *(
                Label(kind, point_of((0, 0, angle), 0.29), str(k))
                for k, (kind, angle) in enumerate(zip(KINDS, ANGLES, strict=True), 1)
            ),
            *spin(Q),
            Point("icr", Q, "Q"),
        ),
        handles=q_handle(),
        readouts=tuple(Readout(each, f"wheel {k}") for k, each in enumerate(omni_rates, 1)),
        goal=(
            Goal(
                And(*(Abs(each - 1) < 0.06 for each in omni_rates)),
                "All three at the same rate: within 0.06 rad/s.",
            ),
            Goal(
                And(
                    Abs(omni_rates[0]) < 0.06,
                    Max(*map(Abs, Q)) > 0.1,
                    Abs(omni_rates[1] - omni_rates[2]) > 1,
                ),
                "Wheel 1 rests, and the other two differ by more than 1 rad/s.",
            ),
            Goal(
                And(*(Abs(each - RATES[each]) < 0.12 for each in omni_rates)),
                "The rates of the exercise, −2, 4 and 1: within 0.12 rad/s.",
            ),
        ),
    )


def move(start: Any, twist: Any, time: Any) -> tuple[Any, Any, Any]:
    """Return the pose after moving for a time from the origin, sideways speed included.

    Two arcs, one for the speed ahead and one for the speed to the left: the chords add up.
    """
    ahead, left, turn = twist
    with as_written():
        there = motion.arc_step.substitute(
            {x: 0, y: 0, theta: start, v: ahead, omega: turn, dt: time}
        )
        aside = {x: 0, y: 0, theta: start + QUARTER, v: left, omega: turn, dt: time}
        sideways = motion.arc_step.substitute(aside)
        return there[0] + sideways[0], there[1] + sideways[1], there[2]


STOP = (0.6, 0.9)  # m: where the robot is to end


def omni_figure() -> Figure:
    """Draw the omni robot's motion in the world, from three wheel rates."""
    now, ahead = (move(theta, (v, v_y, omega), time) for time in (t, s))
    arrow = motion.to_world.substitute({v: v, v_y: v_y, omega: 0})
    centre = motion.to_world.substitute({v: -v_y / omega, v_y: v / omega})
    icr = [Piecewise((part, Abs(omega) > 0.05), (nan, True)) for part in centre[:2]]
    hubs = [(*point_of((0, 0, theta + angle), SIZE), theta + angle - QUARTER) for angle in ANGLES]
    tips = [point_of(hub, RADIUS * each) for hub, each in zip(hubs, omni_rates, strict=True)]
    return Figure(
        name="omni",
        title="A robot on three omni wheels seen from above, their rates under your hand",
        view=(-0.55, 1.35, -0.42, 1.06),
        follow=now,
        ground="tiles",
        size="laboratory",
        controls=(
            *(
                Slider(
                    each,
                    -6.0,
                    6.0,
                    start=float(RATES[each]),
                    step=0.1,
                    label=f"wheel {k}",
                    kind=kind,
                )
                for k, (each, kind) in enumerate(zip(omni_rates, KINDS, strict=True), 1)
            ),
            Slider.degrees(theta, start=30, label="heading at the start"),
            Clock(t, 0.0, 12.0, label="time"),
        ),
        where=(*SIZES, *assign(wheels.omni_twist, wheels.omni_world)),
        shapes=(
            Area(
                "target",
                tuple(
                    (STOP[0] + a, STOP[1] + b)
                    for a, b in ((-0.08, -0.08), (0.08, -0.08), (0.08, 0.08), (-0.08, 0.08))
                ),
            ),
            Label("target", (STOP[0], STOP[1] - 0.13), "stop"),
            Curve("ghost", ahead, s, 0, 12),
            Curve("path", ahead, s, 0, t),
            things.omni_robot((0, 0, theta), look="ghost", distance=SIZE),
            things.omni_robot(now, [RADIUS * each * t for each in omni_rates], distance=SIZE),
            *(
                Arrow(kind, hub, tip, f"{k}")
                for k, (kind, hub, tip) in enumerate(zip(KINDS, hubs, tips, strict=True), 1)
            ),
            Arrow("velocity", ORIGIN, arrow[:2], ""),
            Point("icr", icr, "Q"),
        ),
        handles=tuple(
            Handle(
                f"tip of the arrow of wheel {k}",
                tip,
                {
                    each: (
                        cos(hub[2]) * (POINTER[0] - hub[0]) + sin(hub[2]) * (POINTER[1] - hub[1])
                    )
                    / RADIUS,
                },
            )
            for k, (each, hub, tip) in enumerate(zip(omni_rates, hubs, tips, strict=True), 1)
        ),
        readouts=(
            Readout(v),
            Readout(v_y),
            Readout("turning", "angular velocity ω", omega, "rad/s"),
            Readout(x_dot),
            Readout(y_dot),
            Readout("x", "now at x", now[0], "m"),
            Readout("y", "now at y", now[1], "m"),
            Readout("heading", "heading now", now[2], "rad"),
        ),
        goal=(
            Goal(
                And(Abs(v) > 0.05, Abs(v_y) < 0.006, Abs(omega) < 0.01),
                "Drive along the robot's own x axis, without a turn.",
            ),
            Goal(
                And(distance(now, STOP) < 0.05, Abs(omega) < 0.01),
                "Stop on the mark, still looking as at the start: within 5 cm.",
            ),
        ),
    )


# --- Where it fails


def turned_figure() -> Figure:
    """Draw the omni robot with all its axles turned away from the spokes: the triangle shrinks."""
    ends = [along(hub, angle + beta - QUARTER) for hub, angle in zip(HUBS, ANGLES, strict=True)]
    inner = l * cos(beta)
    corners = [point_of((0, 0, angle + pi + beta), 2 * inner) for angle in ANGLES]
    return Figure(
        name="turned-wheels",
        title="The omni robot with its wheels turned, and the triangle of its push lines",
        view=(-0.53, 0.53, -0.35, 0.35),
        ground="tiles",
        controls=(Slider.degrees(beta, -120, 120, start=25, label="all axles turned by β"),),
        where=(*SIZES, *assign(wheels.omni_determinant)),
        shapes=(
            Area("icr", tuple(corners)),
            *(Line(kind, pair) for kind, pair in zip(KINDS, ends, strict=True)),
            things.omni_robot((0, 0, 0), distance=SIZE, beta=beta),
            Line("ghost", (ORIGIN, point_of((0, 0, 0), 0.36))),
            AngleArc(beta, HUBS[0], 0, beta, 0.1),
        ),
        readouts=(Readout("det", "det J_1", wheels.determinant, "m", 3),),
        goal=Goal(
            Abs(wheels.determinant) < 0.004,
            "Let the rates no longer tell the motion: det J₁ within 0.004 m of zero.",
        ),
    )


faster = quantity("faster", "rad/s", -8, 8, "by how much one wheel is too fast")
WRONG = symbols("wrong:4")
BASE = 2  # rad/s


def mecanum_figure() -> Figure:
    """Draw four Mecanum wheels, one of them too fast: how far each of them slips in a second."""
    rates = (*omni_rates, wheels.omni_rate4)
    where = [(each, BASE + wrong * faster) for each, wrong in zip(rates, WRONG, strict=True)]
    shapes: list[Any] = []
    places = DRAWN["Mecanum robot"]
    for k, (px, py, _, kind) in enumerate(places):
        lean = (-1 if "−" in kind else 1) * pi / 4
        hub = point_of(AHEAD, px, py)
        slipped = (1 if k < 2 else -1) * wheels.slip * 5
        shapes += [
            Arrow("left", hub, point_of((*hub, QUARTER), RADIUS * where[k][1]), ""),
            *when(
                Abs(wheels.slip) > 0.0005,
                Line("error", (hub, point_of((*hub, QUARTER + lean), slipped))),
            ),
            Label("text", point_of(AHEAD, px, py * 1.8), str(k + 1)),
        ]
    return Figure(
        name="mecanum",
        title="A robot on four Mecanum wheels, one of them too fast, and how far each slips",
        view=(-0.5, 0.5, -0.32, 0.36),
        ground="tiles",
        controls=(
            Choice.one_hot("wheel", WRONG, ("1", "2", "3", "4"), "too fast is wheel", start="1"),
            Slider(faster, -8.0, 8.0, start=0.0, step=0.5, label="too fast by"),
        ),
        where=((r, RADIUS), *where, *assign(wheels.mecanum_slip)),
        shapes=(
            plate(AHEAD),
            *(Line("body", (ORIGIN, point_of(AHEAD, *place[:2]))) for place in places),
            *(
                MAKERS[kind]((*point_of(AHEAD, px, py), ahead + QUARTER), RADIUS * where[k][1] / 8)
                for k, (px, py, ahead, kind) in enumerate(places)
            ),
            *shapes,
        ),
        readouts=(Readout(wheels.slip, "slip of wheels 1 and 2; of 3 and 4: minus this"),),
    )


# --- The laboratory: a robot of up to four wheels

KIND_NAMES = ("none", *MAKERS)  # a wheel's kind is a place in this list
NO_WHEEL = (0, 0, 0, "none")
BASE_ROBOTS = {"nothing yet": (), **DRAWN}
START = (0, 0, QUARTER)
COUNT = 4
WHEELS = [symbols(f"base_x{k} base_y{k} base_ahead{k} base_kind{k}") for k in range(1, COUNT + 1)]
ROBOT, WHICH = symbols("robot which")
OTHER = symbols("other_kind1:5")
SHIFTS = tuple(
    tuple(
        quantity(f"{name}{k}", unit, -1, 1, f"wheel {k}: {words}")
        for name, unit, words in (
            ("shift_x", "m", "moved ahead"),
            ("shift_y", "m", "moved to the left"),
            ("shift_axle", "rad", "turned to the left"),
        )
    )
    for k in range(1, COUNT + 1)
)
wish_v = quantity("wish_v", "m/s", -0.3, 0.3, "wished speed ahead")
wish_vy = quantity("wish_vy", "m/s", -0.3, 0.3, "wished speed to the left")
wish_omega = quantity("wish_omega", "rad/s", -1, 1, "wished turn ω")
WISH = Matrix([wish_v, wish_vy, wish_omega])
DRAWN_AT = 2.5  # times the metres a second, so that a wish is not under a wheel
MARK = (-0.45, 0.0)  # m: a corner of the drawn square; the robot starts at another one


def base_numbers(name: str) -> tuple[float, ...]:
    """Return a robot's number, and four numbers for each of four wheels."""
    chosen = [*BASE_ROBOTS[name], *[NO_WHEEL] * COUNT][:COUNT]
    numbers = [[*wheel[:3], KIND_NAMES.index(wheel[3])] for wheel in chosen]
    return (list(BASE_ROBOTS).index(name), *(float(x) for wheel in numbers for x in wheel))


def outside(left: Any, by: float) -> Any:
    """Return a place farther to the left, or to the right if it is there."""
    return left + Piecewise((by, left > -0.01), (-by, True))


def built(steps: NamedSteps) -> list[Any]:
    """Return of each wheel: its kind, its place, the direction that it rolls in."""
    found = []
    for k, (base, other, (dx, dy, turn)) in enumerate(zip(WHEELS, OTHER, SHIFTS, strict=True), 1):
        kind = steps.add(f"kind{k}", Piecewise((other, other > -0.5), (base[3], True)))
        px, py = steps.add(f"x{k}", base[0] + dx), steps.add(f"y{k}", base[1] + dy)
        wished = atan2(wish_vy + wish_omega * px, wish_v - wish_omega * py)
        ahead = Piecewise((wished, is_kind(kind, "steered")), (base[2] + turn, True))
        found.append((kind, (px, py), steps.add(f"ahead{k}", ahead)))
    return found


def is_kind(number: Any, *names: str) -> Any:
    """Return whether a kind is one of these."""
    return Or(
        *(And(number > place - 0.5, number < place + 0.5) for place in map(KIND_NAMES.index, names))
    )


def constraints(steps: NamedSteps, wheels_built: list[Any]) -> tuple[Any, Any, Any, Any]:
    """Return the twist that is nearest to the wish, the ICR, and the two degrees."""
    rows = []
    for k, (kind, place, ahead) in enumerate(wheels_built, 1):
        held = steps.add(f"held{k}", Piecewise((1, is_kind(kind, "fixed", "steered")), (0, True)))
        fixed = steps.add(f"fixed{k}", Piecewise((1, is_kind(kind, "fixed")), (0, True)))
        entries = steps.add(f"row{k}_", Matrix([row_of(place, ahead + QUARTER)]))
        rows.append((held, fixed, entries))
    P, centre = turn_left(steps, Matrix([[held * x for x in row] for held, _, row in rows]))
    of_fixed = steps.add(
        "rank_of_fixed", rank(Matrix([[fixed * x for x in row] for _, fixed, row in rows]))
    )
    steered = sum(held - fixed for held, fixed, _ in rows)
    ranks = {wheels.rank_fixed: of_fixed, wheels.rank_steered: steered}
    delta_s = steps.add("delta_s", wheels.STEERABLE.xreplace(ranks))
    twist = [steps.add(f"twist{i}", sum(P[i, j] * WISH[j] for j in range(3))) for i in range(3)]
    return twist, centre, steps.add("delta_m", 3 - of_fixed - delta_s), delta_s


def built_wheel(steps: NamedSteps, k: int, wheel: Any, twist: Any, end: Any) -> list[Any]:
    """Return a wheel of any kind that the robot takes along, its axle line, and its spoke."""
    kind, place, ahead = wheel
    along_x, along_y = twist[0] - twist[2] * place[1], twist[1] + twist[2] * place[0]
    dragged = And(is_kind(kind, "castor"), along_x**2 + along_y**2 > 1e-8)
    # seen from a direction that no wish has: dragged straight back, rounding must not choose a side
    trailing = 1 + atan2(cos(1) * along_y - sin(1) * along_x, cos(1) * along_x + sin(1) * along_y)
    own = steps.add(f"own{k}", Piecewise((trailing, dragged), (ahead, True)))
    lean = Piecewise(
        (1, is_kind(kind, "Mecanum 45°")), (-1, is_kind(kind, "Mecanum −45°")), (0, True)
    )
    rolled = (
        along_x * cos(own) + along_y * sin(own) + lean * (along_y * cos(own) - along_x * sin(own))
    )
    rolled = steps.add(f"rolled{k}", rolled * t)
    hub = (*point_of(end, *place), end[2] + own)
    hub = tuple(steps.add(f"hub{k}_{n}", part) for n, part in enumerate(hub))
    held = is_kind(kind, "fixed", "steered")
    shapes = [
        *when(kind > 0.5, Line("body", (end, hub))),
        *when(held, Line("icr", along(hub, hub[2] + QUARTER))),
    ]
    for name, make in MAKERS.items():
        shapes += when(is_kind(kind, name), make(hub, rolled))
    return shapes


def laboratory_controls(wheels_built: list[Any]) -> tuple[Any, ...]:
    """Return at most six controls at a time; those of the chosen wheel, and of it what acts."""
    numbers = (ROBOT, *(number for base in WHEELS for number in base))
    kinds, places, axles = [], [], []
    names = {"as drawn": (-1.0,), **{name: (float(n),) for n, name in enumerate(KIND_NAMES)}}
    for k, (other, (dx, dy, turn)) in enumerate(zip(OTHER, SHIFTS, strict=True), 1):
        mine = And(k - 0.5 < WHICH, k + 0.5 > WHICH)
        acts = And(
            mine, is_kind(wheels_built[k - 1][0], *(set(MAKERS) - {"steered", "castor", "ball"}))
        )
        kinds.append(Choice(f"kind{k}", f"wheel {k} is", (other,), names, shown=mine))
        places += [
            Slider(each, -0.4, 0.4, 0.0, 0.01, label=f"wheel {k}: moved {way}", shown=False)
            for each, way in zip((dx, dy), WAYS.values(), strict=True)
        ]
        axles.append(Slider.degrees(turn, -90, 90, step=5, label=f"turn wheel {k}", shown=acts))
    wishes = (
        Slider(each, -0.2, 0.2, begin, 0.01, label=f"wished speed {way}", shown=False)
        for each, begin, way in zip(WISH[:2], (0.16, 0.0), WAYS.values(), strict=True)
    )
    return (
        Choice(
            "robot",
            "robot",
            numbers,
            {name: base_numbers(name) for name in BASE_ROBOTS},
            start="car",
        ),
        Choice("which", "change", (WHICH,), {f"wheel {k}": (k,) for k in range(1, COUNT + 1)}),
        *kinds,
        *places,
        *axles,
        *wishes,
        Slider(wish_omega, -1.0, 1.0, start=0.0, step=0.05, label="wished turn ω"),
        Clock(t, 0.0, 4.0, label="time"),
    )


def laboratory_figure() -> Figure:
    """Draw a robot that is built by hand, the motion that its wheels allow, and how many."""
    steps = NamedSteps()
    with as_written():
        wheels_built = built(steps)
        twist, centre, delta_m, delta_s = constraints(steps, wheels_built)
        end = tuple(
            steps.add(f"end_{n}", part)
            for n, part in zip("xyt", move(QUARTER, twist, t), strict=True)
        )
        drawn = [
            shape
            for k, wheel in enumerate(wheels_built, 1)
            for shape in built_wheel(steps, k, wheel, twist, end)
        ]
    now = Symbol("rank_now", real=True)
    wish, made = (
        point_of(START, *(DRAWN_AT * speed for speed in pair))
        for pair in ((wish_v, wish_vy), twist[:2])
    )
    hands = []
    every = zip(wheels_built, WHEELS, SHIFTS, strict=True)
    for k, ((kind, place, _), base, shifts) in enumerate(every, 1):
        ahead, left = POINTER[1] - base[0], -POINTER[0] - base[1]
        hub = point_of(START, *place)
        there = (Piecewise((hub[0], kind > 0.5), (nan, True)), hub[1])
        hands.append(Handle(f"wheel {k}", there, dict(zip(shifts, (ahead, left), strict=False))))
    by_number = list(BASE_ROBOTS).index
    is_robot = {
        name: And(by_number(name) - 0.5 < ROBOT, by_number(name) + 0.5 > ROBOT)
        for name in BASE_ROBOTS
    }
    corner = [(MARK[0] * a, 0.45 * b) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return Figure(
        name="wheel-laboratory",
        title="A robot seen from above, built of up to four wheels, and the motion that they allow",
        view=(-0.7, 0.7, -0.45, 0.62),
        follow=end,
        ground="tiles",
        size="laboratory",
        controls=laboratory_controls(wheels_built),
        where=steps,
        shapes=(
            Line("target", (*corner, corner[0])),
            *(Curve("path", move(QUARTER, twist, s), s, 0, t),),
            *drawn,
            Sprite(end, plate(end).parts, 0.02, size=0.6),
            Arrow("approximation", ORIGIN, wish, "wish"),
            Arrow("velocity", ORIGIN, made, ""),
            Point("icr", point_of(START, *centre), "Q"),
            *(
                label
                for k, (kind, place, _) in enumerate(wheels_built, 1)
                for label in when(
                    kind > 0.5,
                    Label(
                        "text", point_of(START, place[0] - 0.02, outside(place[1], 0.09)), f"{k}"
                    ),
                )
            ),
        ),
        handles=(
            *hands,
            Handle(
                "the wish", wish, {wish_v: POINTER[1] / DRAWN_AT, wish_vy: -POINTER[0] / DRAWN_AT}
            ),
        ),
        readouts=(
            Readout("now", "ways to move, as the wheels are now", 3 - now, digits=0),
            Readout("mobility", "degree of mobility δ_m", delta_m, digits=0),
            Readout("steerability", "degree of steerability δ_s", delta_s, digits=0),
            Readout("both", "degree of manoeuvrability δ_M", delta_m + delta_s, digits=0),
            Readout("v", "speed v", twist[0], "m/s"),
            Readout("v_y", "speed v_y", twist[1], "m/s"),
            Readout("omega", "angular velocity ω", twist[2], "rad/s"),
        ),
        goal=(
            Goal(
                And(
                    is_robot["nothing yet"],
                    now > 0.5,
                    now < 1.5,
                    Abs(twist[1]) < 0.01,
                    Abs(wish_vy) > 0.04,
                    Abs(wish_omega) > 0.1,
                    Abs(twist[2] - wish_omega) < 0.01,
                ),
                "From “nothing yet”: build what turns and never goes sideways. Wish for ω and v_y.",
            ),
            Goal(
                And(is_robot["differential drive"], delta_m < 1.5, delta_m > 0.5, delta_s > 0.5),
                "From the differential drive: δ_m = 1 and δ_s = 1.",
            ),
            Goal(And(is_robot["car"], delta_m > 1.5, delta_m < 2.5), "From the car: δ_m = 2."),
            Goal(
                And(
                    is_robot["car"],
                    now > 2.5,
                    Abs(wish_vy) < 0.005,
                    Or(Abs(SHIFTS[2][2]) > 0.04, Abs(SHIFTS[3][2]) > 0.04),
                ),
                "Lock the car by turning one of its wheels; wish straight ahead.",
            ),
            Goal(
                And(
                    is_robot["omni robot"],
                    distance(end, MARK) < 0.05,
                    angle_size(end[2] - QUARTER) < 2 * DEGREE,
                ),
                "Drive the omni robot sideways along the square to its next corner, without a "
                "turn: within 5 cm.",
            ),
        ),
    )


# --- A robot to draw, for an exercise

SPOTS = {"A": (0, 1), "B": (0, -1), "C": (1, 0), "D": (-1, 0), "E": (1, 1)}
SET = [Symbol(f"wheel_at_{name}") for name in SPOTS]  # its kind, a place in KIND_NAMES


def placed(robot: str) -> tuple[int, ...]:
    """Return the kinds of the wheels at the five places, of a robot in the exercise's words."""
    found = dict.fromkeys(SPOTS, "none")
    for part in robot.split(", and "):
        kind = next(name for name in MAKERS if name in part)
        found |= dict.fromkeys(re.findall("[A-E]", part), kind)
    return tuple(KIND_NAMES.index(kind) for kind in found.values())


def drawn_figure() -> Figure:
    """Draw the robots of the exercise on three numbers."""
    spots = {name: (0.4 * a, 0.2 * b) for name, (a, b) in SPOTS.items()}
    shapes: list[Any] = []
    for spot, kind in zip(spots.values(), SET, strict=True):
        shapes += when(kind > 0.5, Line("body", (ORIGIN, spot)))
    shapes.append(Sprite((0, 0, 0), plate((0, 0, 0)).parts, 0.02, size=0.6))
    for (name, spot), kind in zip(spots.items(), SET, strict=True):
        for made in ("fixed", "steered", "castor", "ball"):
            shapes += when(is_kind(kind, made), MAKERS[made]((*spot, 0)))
        shapes.append(Point("ghost", spot, name))
    short = {re.sub(r"\b(a|wheels?|at|and) ", "", robot): placed(robot) for robot in DRAWN_ROBOTS}
    return Figure(
        name="drawn-robot",
        title="The places A to E around a robot's centre, and the wheels of a robot",
        view=(-0.6, 0.7, -0.3, 0.32),
        controls=(Choice("robot", "it has", tuple(SET), short),),
        shapes=(
            Arrow("text", ORIGIN, (0.6, 0), "x"),
            Arrow("text", ORIGIN, (0, 0.29), "y"),
            *shapes,
        ),
    )


# --- Mistakes

WANTED = {x_dot: -0.08, y_dot: 0.12, theta_dot: -0.6}  # in the world, m/s and rad/s
MADE = (plus_sign, heading_for_beta, plus_l_cos, cos_alpha, turned_back)
MISTAKES = symbols(f"mistake:{len(MADE)}", real=True)  # 1 for the one that is made, else 0
REALLY = symbols("really_v really_vy really_omega")


def twist_by_mistake(mistake: Any) -> Any:
    """Return the omni robot's twist by a program with a mistake in the rates of its wheels."""
    to_body = (
        turned_back.formula.transfer(motion.to_body) if mistake is turned_back else motion.to_body
    )
    wish = to_body.substitute(WANTED)
    places = ({l: SIZE, alpha: spoke, beta: 0} for spoke in ANGLES)
    rows = [
        rolling_row(*p.values()) if mistake is turned_back else mistake.substitute(p)
        for p in places
    ]
    with as_written():
        speeds = [sum(a * b for a, b in zip(row, wish, strict=True)) for row in rows]
        rates = [speed / RADIUS for speed in speeds]
    return wheels.omni_twist.substitute(
        {l: SIZE, r: RADIUS, **dict(zip(omni_rates, rates, strict=True))}
    )


def mistakes_figure() -> Figure:
    """Draw the omni robot, and where its program believes it to be; rates are set at the start."""
    twists = [twist_by_mistake(mistake).doit() for mistake in MADE]
    with as_written():
        really = [
            sum(chosen * twist[i] for chosen, twist in zip(MISTAKES, twists, strict=True))
            for i in range(3)
        ]
    wish = motion.to_body.substitute(WANTED)
    real, believed = move(theta, REALLY, t), move(theta, wish, t)
    return Figure(
        name="wrong-rates",
        title="An omni robot, and where its program with a mistake believes it to be",
        view=(-0.8, 0.8, -0.54, 0.59),
        ground="tiles",
        controls=(
            Choice.one_hot("mistake", MISTAKES, (m.title for m in MADE)),
            Slider.degrees(theta, 0, 180, start=60, step=5, label="heading at the start"),
            Clock(t, 0.0, 2.5, start=2.3, loops=True, label="time"),
        ),
        where=tuple(zip(REALLY, really, strict=True)),
        shapes=(
            things.omni_robot((0, 0, theta), look="ghost"),
            Curve("path", move(theta, REALLY, s), s, 0, t),
            Curve("approximation", move(theta, wish, s), s, 0, t),
            things.omni_robot(real, distance=SIZE),
            things.omni_robot(believed, look="wrong", distance=SIZE),
            Line("error", (real, believed)),
        ),
        readouts=(
            Readout("apart", "apart", distance(real, believed), "m"),
            Readout("turned", "heading off by", believed[2] - real[2], "rad", digits=0),
        ),
        sentence="{mistake}: after {t} the robot is {apart} from where its program believes it. "
        "The heading is off by {turned}.",
    )


# --- Recap

LAST = (*WHEEL_2, (x_Q, 0.05), (y_Q, 0.38))  # the plate of the first steps, and Q


def both_lines(labels: tuple[str, str]) -> tuple[Any, ...]:
    """Return the two lines of a wheel, and how far Q is from each."""
    return (
        Line("icr", along(HUB, AXIS)),
        Line("left", along(HUB, ROLLS)),
        *wheel_on_plate((0, 0, 0)),
        Length(from_axle, foot(HUB, AXIS, Q), Q, labels[0]),
        Length(from_push, foot(HUB, ROLLS, Q), Q, labels[1]),
        Point("icr", Q, "Q"),
    )


def summary_figure() -> Figure:
    """Draw a wheel with its two lines, and the distances of Q from them, at rest."""
    return Figure(
        name="wheel-summary",
        title="A wheel on a plate, its axle line and its push line, and Q's distances from both",
        view=(-0.46, 0.46, -0.17, 0.43),
        ground="tiles",
        where=LAST,
        shapes=(
            *both_lines(("× ω: slides", "× ω: rolls")),
            Label("icr", (0.12, -0.12), "axle line"),
            Label("left", (0.32, 0.4), "push line"),
        ),
    )


def letters_figure() -> Figure:
    """Draw a wheel with its two lines; two letters are to be put back."""
    letters = put_back(quantity, ("β", "p", "l", "a"), {"a": (-0.07, 0.35), "p": (0.11, 0.36)})
    return Figure(
        name="wheel-letters",
        title="A wheel on a plate, its axle line and its push line, and the numbers 1 and 2",
        view=(-0.46, 0.46, -0.17, 0.43),
        ground="tiles",
        controls=letters.controls,
        where=LAST,
        shapes=(
            *both_lines(("", "")),
            *letters.shapes,
        ),
        goal=letters.goal,
    )


FIGURES = (
    trolley_figure(),
    exercise_figure(),
    place_figure(),
    pin_figure(),
    sliding_figure(),
    rolling_figure(),
    lines_figure(),
    front_figure(),
    robots_figure(),
    kinds_figure(),
    castor_figure(),
    rollers_figure(),
    triangle_figure(),
    omni_figure(),
    turned_figure(),
    mecanum_figure(),
    laboratory_figure(),
    drawn_figure(),
    mistakes_figure(),
    letters_figure(),
    summary_figure(),
)
