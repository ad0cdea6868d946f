"""The live figures of the chapter on the elbow arm: one arm all the way, solid or from the side."""

from collections.abc import Sequence
from dataclasses import replace
from math import pi, remainder
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
    Symbol,
    atan2,
    cos,
    eye,
    nan,
    rad,
    sin,
    sqrt,
    symbols,
)
from sympy import pi as exact_pi

from book import things
from book.basics.formulas import p_x, p_y
from book.dragging import towards, turn_handle
from book.elbow_arm import formulas as arm
from book.elbow_arm.exercises import base_arctan, base_only, cubed_a_3, no_p_x, swapped_xy
from book.elbow_arm.formulas import (
    SIDES,
    a2,
    a3,
    apart,
    d1,
    high,
    out,
    p_z,
    phi1,
    phi2,
    phi3,
    theta1,
    theta2,
    theta3,
)
from book.letters import put_back
from book.motion import formulas as motion
from book.things import meshes, space
from book.things.arms import links
from book.things.outlines import disc
from courseware.equations import Where, declarations, substitute
from courseware.figures import (
    POINTER,
    VIEW,
    AngleArc,
    Area,
    Arrow,
    Button,
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
    Track,
    bring_forward,
    distance,
    ramp,
    when,
)
from robokin._triangle import TOLERANCE

quantity, _ = declarations(__name__)

UPPER, FOREARM, SHOULDER = 0.4, 0.3, 0.1  # m, of the exercise
LINKS = (UPPER, FOREARM)
TARGET = (-0.18, 0.24, 0.5)  # m, of the exercise
GIVEN = {a2: UPPER, a3: FOREARM, d1: SHOULDER}
JOINTS = (theta1, theta2, theta3)
s = Symbol("s")


# The arm in space, and what is dragged of it.


def base_ring(turn: Any = theta1) -> Handle:
    """Return a handle at the nose, which turns the base."""
    far, low = 0.2, 0.05
    az, el = VIEW.angles
    across = POINTER[0]
    ahead = (low * cos(el) - POINTER[1]) / sin(el)
    x, y = ahead * cos(az) - across * sin(az), ahead * sin(az) + across * cos(az)
    at = VIEW.project((far * cos(turn), far * sin(turn), low))
    return Handle("nose of the base", at, {turn: towards(turn, atan2(y, x))})


def stood(at: Sequence[float]) -> tuple[Any, ...]:
    """Return a ball on its stand."""
    foot = VIEW.solid(space.stand(at[2]), eye(3), (at[0], at[1], 0), floor=0)
    return foot, VIEW.solid(space.ball(), 0.025 * eye(3), at, floor=0)


def ground(half: float = 0.55, at: Sequence[Any] = (0, 0, 0)) -> tuple[Any, ...]:
    """Return the floor, and what the arm stands on."""
    foot = space.column(0.55 * SHOULDER, 0.085)
    return space.floor(0, half, at), VIEW.solid(foot, eye(3), floor=0)


def apart_from(place: Sequence[Any], other: Sequence[Any]) -> Any:
    """Return the distance of two points in space."""
    return sqrt(sum((a - b) ** 2 for a, b in zip(place, other, strict=True)))


def ways_to(p: Sequence[float]) -> list[list[float]]:
    """Return the joint angles of the four ways to a point, as numbers."""
    given = {**GIVEN, p_x: p[0], p_y: p[1], high: p[2] - SHOULDER, out: sqrt(p[0] ** 2 + p[1] ** 2)}
    d = sqrt(given[out] ** 2 + given[high] ** 2)
    lift, elbow = arm.half_angles.substitute({**GIVEN, apart: d})
    rise = atan2(given[high], given[out])
    (turn, _), found = arm.base.substitute(given), []
    for up in (1, -1):
        found.append([turn, rise + up * lift, -up * elbow])
    away = [arm.away.substitute(dict(zip(JOINTS, way, strict=True))) for way in found]
    return [[remainder(float(each), 2 * pi) for each in way] for way in (*found, *away)]


# Opening.

BALL = (0.32, 0.24, 0.4)  # m
shown = quantity("shown", "", 0, 8, "times that the arm has done it")
CLOSE = 0.02  # m


def grip_figure() -> Figure:
    """Draw the arm with three joints under the hand, and a ball to grip."""
    ways = ways_to(BALL)
    _, elbow, wrist = space.arm_places(JOINTS, LINKS, SHOULDER)
    held = apart_from(wrist, BALL) < CLOSE
    nose = base_ring()
    next_way = [
        Piecewise(
            *((ways[k % 4][joint], shown < k + 0.5) for k in range(8)), (ways[0][joint], True)
        )
        for joint in range(3)
    ]
    return Figure(
        name="grip",
        title="A solid arm on a turntable, with an upper link, a forearm and a gripper; and a ball",
        view=(-0.7, 0.9, -0.24, 0.8),
        ground="wall",
        controls=(
            Slider.degrees(theta1, start=-5, label="base θ_1"),
            Slider.degrees(theta2, start=75, label="shoulder θ_2"),
            Slider.degrees(theta3, start=-35, label="elbow θ_3"),
            Slider(shown, 0, 8, start=0, step=1, shown=False),
        ),
        shapes=(
            *ground(),
            *stood(BALL),
            *(
                part
                for k in range(2)
                for part in when(
                    shown > k + 0.5, *space.arm(ways[k], LINKS, SHOULDER, kind="ghost", opacity=0.2)
                )
            ),
            *space.arm(JOINTS, LINKS, SHOULDER, Piecewise((0, held), (1, True))),
            bring_forward(VIEW.line("ghost", (wrist, (*wrist[:2], 0))), -0.05),
            Label("target", VIEW.project(BALL), "{off} off"),
            Label(theta1, nose.at),
            Label(theta2, VIEW.project(elbow)),
            Label(theta3, VIEW.project(wrist)),
        ),
        handles=(
            nose,
            turn_handle("elbow", theta2, elbow),
            turn_handle("gripper", theta3, wrist),
        ),
        buttons=(
            Button(
                "let the arm do it",
                {
                    **dict(zip(JOINTS, next_way, strict=True)),
                    shown: Piecewise((shown + 1, shown < 7.5), (5, True)),
                },
            ),
        ),
        readouts=(Readout("off", "gripper to ball", apart_from(wrist, BALL), "cm", 0),),
        sentence="Joints at {theta1}, {theta2}, {theta3}: the gripper is {off} from the ball.",
        goal=(
            Goal(And(held, shown < 1), "Grip the ball by yourself: within 2 cm."),
            Goal(shown > 4.5, "Let the arm do it, again and again, until one way comes back."),
        ),
        seen_from=(-pi / 3, pi / 7),
    )


# The exercise.


def arc(
    kind: Any, at: Sequence[Any], axes: Sequence[Any], ends: Sequence[Any], radius: float
) -> tuple[Any, ...]:
    """Return an angle in space: about a point, between two axes, from one end to the other."""
    u, v = axes

    def place(angle: Any, far: float) -> list[Any]:
        pairs = zip(at, u, v, strict=True)
        return [a + far * (p * cos(angle) + q * sin(angle)) for a, p, q in pairs]

    here, middle = place(s, radius), place((ends[0] + ends[1]) / 2, radius + 0.06)
    start, end = ends
    curve = Curve(kind, VIEW.project(here), s, start, end, 24, depth=VIEW.depth(here) + 0.3)
    return curve, Label(kind, VIEW.project(middle))


def dimension(
    kind: Any, start: Sequence[Any], end: Sequence[Any], aside: float, label: str
) -> Length:
    """Return a length in space with its ends marked, as far beside it in the picture."""
    return Length(kind, VIEW.project(start), VIEW.project(end), label, aside)


def exercise_figure() -> Figure:
    """Draw the arm of the exercise with all its symbols, not yet at the point."""
    pose = (1.92, 2.1, -1.75)  # rad
    shoulder, elbow, wrist = space.arm_places(pose, LINKS, SHOULDER)
    flat, upper = space.tilt(pose[0], 0), space.tilt(pose[0], pose[1])
    on = (TARGET[0], TARGET[1], 0)
    level = [0.3 * flat[k, 0] + shoulder[k] for k in range(3)]
    ahead = [elbow[k] + 0.25 * upper[k, 0] for k in range(3)]
    x, y, z = eye(3)[:, 0], eye(3)[:, 1], eye(3)[:, 2]
    return Figure(
        name="arm-exercise",
        title=(
            "The arm with its symbols: the base axis, the angles of three joints, two links; "
            "and the point p behind it on the left, as a ball on a stand"
        ),
        view=(-0.5, 0.78, -0.3, 0.72),
        ground="wall",
        where=(
            *zip(JOINTS, pose, strict=True),
            *GIVEN.items(),
            *zip((p_x, p_y, p_z), TARGET, strict=True),
        ),
        shapes=(
            *ground(0.45),
            VIEW.arrow("x_axis", (0, 0, 0.002), (0.5, 0, 0.002), "x"),
            VIEW.arrow("y_axis", (0, 0, 0.002), (0, 0.5, 0.002), "y"),
            bring_forward(VIEW.line("ghost", ((0, 0, 0), (0, 0, 0.62))), -0.3),
            *stood(TARGET),
            *space.arm(pose, LINKS, SHOULDER),
            dimension(p_x, (0, on[1], 0), on, 0.05, "18 cm"),
            dimension(p_y, (0, 0, 0), (0, on[1], 0), -0.06, "24 cm"),
            dimension(p_z, on, TARGET, -0.12, "50 cm"),
            dimension(d1, (0, 0, 0), shoulder, 0.17, "d_1"),
            VIEW.line("ghost", (shoulder, level)),
            VIEW.line("ghost", (elbow, ahead)),
            *arc(theta1, (0, 0, 0.05), (x, y), (0, pose[0]), 0.38),
            *arc(theta2, shoulder, (flat[:, 0], z), (0, pose[1]), 0.24),
            *arc(theta3, elbow, (upper[:, 0], upper[:, 1]), (pose[2], 0), 0.2),
            Label(a2, VIEW.project([(a + b) / 2 for a, b in zip(shoulder, elbow, strict=True)])),
            Label(a3, VIEW.project([(a + b) / 2 for a, b in zip(elbow, wrist, strict=True)])),
            Label("target", VIEW.project((*TARGET[:2], TARGET[2] + 0.06)), "p"),
            Label("text", VIEW.project((0, 0, 0.66)), "base axis"),
        ),
        seen_from=(0.35, 0.4),
    )


# From the side: two links, a ball, the triangle between them.

PLANE: Where = (
    (a2, UPPER),
    (a3, FOREARM),
    (apart, arm.side.right[2]),
    *zip(symbols("least most", real=True), arm.reach.substitute(GIVEN), strict=True),
)
least, most = (symbol for symbol, _ in PLANE[3:])
done, rise = symbols("done rise", real=True)  # the nearest distance in reach, how steep it is
lift, bent = symbols("lift bent", real=True)
WAYS: Where = (
    *PLANE,
    (done, Max(least, Min(apart, most))),
    (rise, atan2(high, out)),
    *zip(
        (lift, bent),
        arm.half_angles.substitute({a2: UPPER, a3: FOREARM, apart: done}),
        strict=True,
    ),
    (phi1, lift),
    (phi2, exact_pi - bent),
    (phi3, rise),
    (SIDES["up2"], rise + lift),
    (SIDES["up3"], -bent),
    (SIDES["down2"], rise - lift),
    (SIDES["down3"], bent),
)
UP, DOWN = ((SIDES[f"{way}2"], SIDES[f"{way}3"]) for way in ("up", "down"))
OUTSIDE = Or(apart > most * (1 + TOLERANCE), apart < least - most * TOLERANCE)
NONE = {"nan": "none"}
ORIGIN = (0, 0)


def side_arm(angles: Sequence[Any], look: str = "", at: Any = ORIGIN, opening: Any = 0.3) -> Any:
    """Return the arm from the side."""
    base = "" if look else "stand"
    return things.arm((*at, 0), angles, LINKS, "gripper", opening, base, look, SHOULDER)


def joints_of(angles: Sequence[Any], at: Any = ORIGIN) -> tuple[Any, Any]:
    """Return elbow and wrist of the arm from the side."""
    near = (at[0] + UPPER * cos(angles[0]), at[1] + UPPER * sin(angles[0]))
    far = angles[0] + angles[1]
    return near, (near[0] + FOREARM * cos(far), near[1] + FOREARM * sin(far))


def circle(kind: Any, at: Sequence[Any], radius: Any) -> Curve:
    """Return a circle."""
    place = at[0] + radius * cos(s), at[1] + radius * sin(s)
    return Curve(kind, place, s, 0, 2 * exact_pi, samples=72)


def beside_elbow(way: Any) -> tuple[Any, Any]:
    """Return a place beside the circle of the elbows, in a direction from the shoulder."""
    return 1.15 * UPPER * cos(way), 1.15 * UPPER * sin(way)


BALL_AT = (out, high)
ELBOW_UP, WRIST = joints_of(UP)
ELBOW_DOWN, _ = joints_of(DOWN)
inside = Not(OUTSIDE)
SCENE = Scene(
    layers={
        "bench": (things.bench(-2, 3, -SHOULDER, -0.5),),
        "rims": (circle("ghost", ORIGIN, least), circle("ghost", ORIGIN, most)),
        "circles": (circle(a2, ORIGIN, UPPER), circle(a3, BALL_AT, FOREARM)),
        "below": when(inside, side_arm(DOWN, "ghost")),
        "arm": (side_arm(UP), *when(OUTSIDE, Line("error", (WRIST, BALL_AT)))),
        "ball": (things.ball((*BALL_AT, 0)),),
        "line": (Line(apart, (ORIGIN, BALL_AT)),),
        "sides": (
            Length(out, (0, high), BALL_AT, aside=0.05),
            Length(high, (out, 0), BALL_AT, aside=-0.06),
        ),
        "elbows": when(
            inside,
            Point("icr", ELBOW_UP),
            Point("icr", ELBOW_DOWN),
            Label("icr", beside_elbow(rise + lift + 0.35), "elbow up"),
            Label("icr", beside_elbow(rise - lift - 0.35), "elbow down"),
        ),
        "angles": when(
            inside,
            AngleArc(phi1, ORIGIN, rise, SIDES["up2"], 0.2),
            AngleArc(phi2, ELBOW_UP, SIDES["up2"] - exact_pi, SIDES["up2"] - bent, 0.1),
            AngleArc(phi3, ORIGIN, 0, rise, 0.13),
        ),
    },
    handles={"ball": (Handle("the ball", BALL_AT),)},
    common={
        "view": (-0.5, 1.06, -0.3, 0.74),
        "ground": "wall",
        "grid": False,
        "where": WAYS,
        "controls": (
            Slider(out, 0.0, 0.8, start=0.3, step=0.005, label="ball: ahead r"),
            Slider(high, -0.1, 0.7, start=0.4, step=0.005, label="ball: up h"),
        ),
    },
)


# Step 1: forward.

guess_r = quantity("guess_r", "m", -0.7, 0.7, "your guess, ahead")
guess_h = quantity("guess_h", "m", -0.7, 0.7, "your guess, up")
t = quantity("t", "s", 0, 2, "time: the shoulder turns in the first second, then the elbow")
LIFTS, BENDS = 60, -100  # degrees, of the arm that is guessed


def guess_figure() -> Figure:
    """Draw a level arm whose joints will turn, and a guess of where the wrist will be."""
    angles = (ramp(t, 0) * rad(LIFTS), ramp(t, 1) * rad(BENDS))
    return Figure(
        name="wrist-guess",
        title="The arm from the side, stretched and level, and your guess of where it will be",
        view=(-0.5, 1.0, -0.24, 0.68),
        ground="wall",
        grid=False,
        controls=(
            Slider(guess_r, -0.4, 0.8, start=0.6, step=0.01, label="ahead"),
            Slider(guess_h, -0.1, 0.6, start=0.5, step=0.01, label="up from the shoulder"),
            Clock(t, 0.0, 2.0, label="time", rate=0.7),
        ),
        shapes=(
            things.bench(-2, 3, -SHOULDER, -0.5),
            side_arm((0, 0), "ghost"),
            side_arm(angles),
            Point("target", (guess_r, guess_h), "your guess"),
        ),
        handles=(Handle("your guess", (guess_r, guess_h)),),
    )


def bend_sliders(lift_start: float, bend_start: float) -> tuple[Slider, Slider]:
    """Return sliders for shoulder and elbow."""
    return (
        Slider.degrees(theta2, start=lift_start, label="shoulder θ_2"),
        Slider.degrees(theta3, start=bend_start, label="elbow θ_3"),
    )


def ring_handles(at: Any = ORIGIN) -> tuple[Handle, Handle]:
    """Return handles at elbow and wrist of the arm from the side."""
    elbow, wrist = joints_of((theta2, theta3), at)
    found = []
    for label, joint, place, pivot, before in (
        ("elbow", theta2, elbow, at, 0),
        ("gripper", theta3, wrist, elbow, theta2),
    ):
        way = atan2(POINTER[1] - pivot[1], POINTER[0] - pivot[0])
        found.append(Handle(label, place, {joint: towards(joint, way - before)}))
    return found[0], found[1]


def forward_figure() -> Figure:
    """Draw both links, and what each reaches ahead and up."""
    elbow, wrist = joints_of((theta2, theta3))
    ahead = (elbow[0] + 0.22 * cos(theta2), elbow[1] + 0.22 * sin(theta2))
    return Figure(
        name="forward",
        title="The arm from the side; dashed legs show what each link reaches ahead and up",
        view=(-0.75, 1.05, -0.42, 0.78),
        ground="wall",
        grid=False,
        controls=bend_sliders(LIFTS, BENDS),
        where=((a2, UPPER), (a3, FOREARM), (out, wrist[0]), (high, wrist[1])),
        shapes=(
            things.bench(-2, 3, -SHOULDER, -0.5),
            side_arm((theta2, theta3)),
            Line("ghost", (ORIGIN, (0.3, 0))),
            Line("ghost", (elbow, ahead)),
            Line(a2, (ORIGIN, (elbow[0], 0), elbow)),
            Line(a3, (elbow, (wrist[0], elbow[1]), wrist)),
            AngleArc(theta2, ORIGIN, 0, theta2, 0.14),
            AngleArc(theta3, elbow, theta2, theta2 + theta3, 0.14),
            Label(a2, (elbow[0] / 2, elbow[1] / 2)),
            Label(a3, ((elbow[0] + wrist[0]) / 2, (elbow[1] + wrist[1]) / 2)),
            Point("target", wrist, "wrist"),
        ),
        handles=ring_handles(),
        readouts=(Readout(out, "wrist ahead: r"), Readout(high, "wrist up: h")),
    )


# Step 2: the base, from above and from the side.

face = Symbol("face", real=True)  # 1 facing, -1 away
NEXT_TO = 1.0  # m, how far to the right of the view from above the view from the side is
HEIGHT = TARGET[2]
bearing = SIDES["facing1"]
NOSE = "M.12 .05L.21 0L.12 -.05z"


def from_above(angle: Any) -> Any:
    """Return what the arm stands on, from above, with its nose."""
    plate = Outline(disc(0.13), "drum", "edge")
    nose = Outline(NOSE, "accent", "accent_edge")
    return Sprite((0, 0, angle), (plate, nose), 0.02)


def base_figure() -> Figure:
    """Draw the arm from above and from the side: one ball, two turns of the base."""
    given = {p_z: HEIGHT, d1: SHOULDER}
    turn = bearing + (1 - face) / 2 * exact_pi
    places = [(x * cos(bearing), x * sin(bearing)) for x in (0, ELBOW_UP[0], out)]
    far = 0.75
    side = (NEXT_TO, -0.25)
    return Figure(
        name="base-views",
        title="The arm from above, a stick on a turntable; beside it the same arm from the side",
        view=(-0.72, 1.62, -0.6, 0.62),
        ground="wall",
        grid=False,
        controls=(
            Slider(p_x, -0.45, 0.45, start=TARGET[0], step=0.01, label="ball: p_x"),
            Slider(p_y, -0.35, 0.35, start=TARGET[1], step=0.01, label="ball: p_y"),
            Choice("facing", "the base faces", (face,), {"the ball": (1,), "away": (-1,)}),
        ),
        where=(
            *given.items(),
            (out, arm.side.right[0]),
            (high, HEIGHT - SHOULDER),
            (bearing, atan2(p_y, p_x)),
            (SIDES["away1"], bearing + exact_pi),
            *WAYS,
        ),
        shapes=(
            things.bench(NEXT_TO - 0.2, 3, side[1] - SHOULDER, -1),
            Line("grid", ((0.69, -1), (0.69, 1))),
            Arrow("x_axis", ORIGIN, (0.55, 0), "x"),
            Arrow("y_axis", ORIGIN, (0, 0.5), "y"),
            Line(
                "ghost",
                (
                    (-far * cos(bearing), -far * sin(bearing)),
                    (far * cos(bearing), far * sin(bearing)),
                ),
            ),
            from_above(turn),
            *links(places),
            AngleArc(theta1, ORIGIN, 0, turn, 0.28),
            things.ball((p_x, p_y, 0)),
            side_arm(UP, at=side),
            things.ball((side[0] + out, side[1] + high, 0)),
            Length(out, (side[0], side[1] + high), (side[0] + out, side[1] + high), aside=0.07),
            Length(high, (side[0] + out, side[1]), (side[0] + out, side[1] + high), aside=-0.07),
            Arrow(
                theta1, (side[0], side[1] - 0.07), (side[0] + 0.2 * face, side[1] - 0.07), "front"
            ),
            Label("text", (-0.4, 0.54), "from above"),
            Label("text", (1.05, 0.54), "from the side"),
        ),
        handles=(Handle("the ball", (p_x, p_y)),),
        readouts=(Readout("turn", "base θ_1", turn, "rad"), Readout(out)),
    )


# Steps 3 and 4: two circles, one triangle.

TOUCH = 0.008  # m


def circles_figure() -> Figure:
    """Draw the circles on which the elbow must lie, about the shoulder and about the ball."""
    return SCENE.figure(
        "circles",
        "The arm from the side; a circle about its shoulder, one about the ball; they cross twice",
        "bench circles below arm line ball sides elbows",
        drag="ball",
        view=(-0.56, 1.12, -0.3, 0.82),
        readouts=(Readout(apart, "shoulder to ball: d"),),
        goal=(
            Goal(Abs(apart - most) < TOUCH, "Let the circles touch from outside: within 8 mm."),
            Goal(Abs(apart - least) < TOUCH, "Let the small one touch the large one from inside."),
            Goal(
                apart < least - TOUCH,
                "Let them not meet, with the ball near the shoulder.",
            ),
        ),
    )


def triangle_figure() -> Figure:
    """Draw the triangle of shoulder, elbow and wrist, with its three angles."""
    return SCENE.figure(
        "triangle",
        "The triangle of shoulder, elbow and wrist over the arm; its ghost, folded over",
        "bench below arm line ball angles",
        drag="ball",
        view=(-0.42, 0.98, -0.22, 0.68),
        shapes=(
            *when(
                inside,
                Label(a2, (0.45 * ELBOW_UP[0], 0.45 * ELBOW_UP[1])),
                Label(a3, ((ELBOW_UP[0] + out) / 2, (ELBOW_UP[1] + high) / 2)),
                Label(apart, (0.6 * out, 0.6 * high)),
            ),
        ),
        readouts=tuple(
            Readout(angle, value=Piecewise((nan, OUTSIDE), (angle, True)), words=NONE)
            for angle in (phi1, phi2, phi3)
        ),
    )


# Step 5: the same with one cosine.

lead = quantity("lead", "rad", -1, 1, "angle from the upper link to the line to the wrist")


def cosine_figure() -> Figure:
    """Draw the wrist as the upper link sees it: ahead of it and aside, a right triangle."""
    elbow, wrist = joints_of((theta2, theta3))
    ahead = UPPER + FOREARM * cos(theta3)
    foot = (ahead * cos(theta2), ahead * sin(theta2))
    beside = FOREARM * sin(theta3)
    return Figure(
        name="one-cosine",
        title="The arm from the side; the wrist, ahead of the upper link and aside of it",
        view=(-0.6, 1.05, -0.36, 0.74),
        ground="wall",
        grid=False,
        controls=bend_sliders(20, 70),
        where=(
            (a2, UPPER),
            (a3, FOREARM),
            (out, wrist[0]),
            (high, wrist[1]),
            (arm.A, cos(theta3)),
            (lead, atan2(beside, ahead)),
            (SIDES["facing2"], theta2),
            (arm.ELBOW_BOTH[0], Abs(theta3)),
            (arm.ELBOW_BOTH[1], -Abs(theta3)),
        ),
        shapes=(
            things.bench(-2, 3, -SHOULDER, -0.5),
            side_arm((theta2, theta3)),
            Area("approximation", (ORIGIN, foot, wrist)),
            Line("ghost", (ORIGIN, (0.7 * cos(theta2), 0.7 * sin(theta2)))),
            Length("left", ORIGIN, foot, "a_2 + a_3 cos θ_3", aside=-0.1),
            Length("right", foot, wrist, "a_3 sin θ_3", aside=-0.04),
            Line("heading", (ORIGIN, wrist)),
            AngleArc("approximation", ORIGIN, theta2, theta2 + lead, 0.24, "atan2"),
            AngleArc(theta3, elbow, theta2, theta2 + theta3, 0.1),
            Point("target", wrist),
        ),
        handles=ring_handles(),
        readouts=(
            Readout("ahead", "ahead of the upper link", ahead, "m"),
            Readout("beside", "aside of it", beside, "m"),
            Readout(lead, "so the angle between"),
        ),
    )


# Step 6: facing away.

DONE = quantity("parts", "s", 0, 2, "time: the base turns in the first second, then the arm")


def turn_round_figure() -> Figure:
    """Draw the base that turns half round, and the arm that leans over its back."""
    facing = ways_to(TARGET)[1]
    one, two = ramp(DONE, 0), ramp(DONE, 1)
    angles = (
        facing[0] - one * exact_pi,
        facing[1] + two * (exact_pi - 2 * facing[1]),
        facing[2] * (1 - 2 * two),
    )
    return Figure(
        name="turn-round",
        title="The solid arm at the ball; its base turns half round, then it leans over its back",
        view=(-0.62, 0.72, -0.32, 0.7),
        ground="wall",
        controls=(Clock(DONE, 0.0, 2.0, step=0.02, label="time", rate=0.5),),
        where=tuple(zip(JOINTS, angles, strict=True)),
        shapes=(
            *ground(),
            *stood(TARGET),
            *space.arm(facing, LINKS, SHOULDER, 0, kind="ghost", opacity=0.2)[1:],
            *space.arm(JOINTS, LINKS, SHOULDER, 0),
            Label("target", VIEW.project(TARGET), "ball"),
        ),
        readouts=(Readout(theta1), Readout(theta2), Readout(theta3)),
        seen_from=(0.6, 0.4),
    )


# Steps 7 and 8: the map of all joint angles.

MAP, WIDE = (-1.9, -0.4), 1.15  # m: its lower left corner in the picture, and its side
MIDDLE = exact_pi / 2  # θ_2 in its middle: so no region is in two halves
WITH_MAP = (-2.14, 0.76, -0.61, 0.83)
borders = quantity("borders", "", 0, 1, "whether the map shows its borders")
COUNTRIES = {  # of the map: kind, side of the base, sign of θ_3
    "facing, up": ("left", 1, -1),
    "facing, down": ("right", 1, 1),
    "away, up": ("velocity", -1, 1),
    "away, down": ("turning", -1, -1),
}


def at_turns(*turns: Any) -> tuple[Any, Any]:
    """Return the place on the map of two angles from its middle, in turns."""
    return tuple(low + WIDE * (each + 0.5) for low, each in zip(MAP, turns, strict=True))


def on_map(lifted: Any, bend: Any) -> tuple[Any, Any]:
    """Return the place on the map of two joint angles."""
    lifted = Piecewise((lifted + 2 * exact_pi, lifted < -exact_pi / 2), (lifted, True))
    return at_turns((lifted - MIDDLE) / (2 * exact_pi), bend / (2 * exact_pi))


def lean(bend: Any) -> Any:
    """Return how far the line to the wrist leads the upper link, in turns."""
    return atan2(FOREARM * sin(bend), UPPER + FOREARM * cos(bend)) / (2 * exact_pi)


def countries() -> tuple[Any, ...]:
    """Return the four regions of the map, each with its name; two go over the glued edge."""
    found: list[Any] = []
    for name, (kind, side, sign) in COUNTRIES.items():
        rows = [(float(lean(sign * k * pi / 16)), sign * k / 32) for k in range(17)]
        near, far = (-0.5, 0) if side > 0 else (0, 0.5)
        whole = side * sign < 0
        edges = [(near, far)] if whole else [(near, far), (near + side, far + side)]
        for edge in edges:
            ends = [[min(max(x - off, -0.5), 0.5) for x in edge] for off, _ in rows]
            heights = [y for _, y in rows]
            corners = [(x, y) for (x, _), y in zip(ends, heights, strict=True)]
            corners += [(x, y) for (_, x), y in zip(ends[::-1], heights[::-1], strict=True)]
            found.append(Area(kind, tuple(at_turns(*corner) for corner in corners)))
        for k, word in enumerate(name.split(", ")):
            place = at_turns(-0.25 * side - 0.065 * sign, 0.34 * sign + 0.079 - 0.158 * k)
            found.append(Label(kind, place, word))
    return tuple(found)


def border_lines() -> tuple[Any, ...]:
    """Return what parts the regions: stretched, folded, wrist on the base axis."""
    lines = [Line("path", (at_turns(-0.5, y), at_turns(0.5, y))) for y in (0, -0.5, 0.5)]
    curves = [
        Curve("icr", at_turns(x - lean(s), s / (2 * exact_pi)), s, start, end, 48)
        for x, start, end in ((0, -exact_pi, exact_pi), (0.5, 0, exact_pi), (-0.5, -exact_pi, 0))
    ]
    return *lines, *curves


def map_frame() -> tuple[Any, ...]:
    """Return the empty map with its axes."""
    corners = [at_turns(x, y) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
    left, low = MAP
    return (
        Line("grid", (at_turns(-0.5, 0), at_turns(0.5, 0))),
        Line("text", (*corners, corners[0])),
        Label(theta2, (left + 0.75 * WIDE, low - 0.11)),
        Label(theta3, (left - 0.12, low + 0.75 * WIDE)),
        *(
            Label("text", (left + k * WIDE / 2, low - 0.11), f"{180 * k - 90}°".replace("-", "−"))
            for k in range(3)
        ),
        Label("text", (left - 0.09, low + WIDE / 2), "0°"),
    )


def borders_figure() -> Figure:
    """Draw the arm and the map of its angles, over which the reader drives it."""
    target = (distance(TARGET, ORIGIN), TARGET[2] - SHOULDER)
    start = ways_to(TARGET)[0][1:]
    return Figure(
        name="four-countries",
        title="The arm at a ball, and a square map of its two angles, in which a dot is the arm",
        view=WITH_MAP,
        ground="wall",
        grid=False,
        size="laboratory",
        controls=(
            *bend_sliders(*(round(float(each) * 180 / pi) for each in start)),
            Slider(borders, 0, 1, start=0, step=1, shown=False),
        ),
        where=((out, joints_of((theta2, theta3))[1][0]), (a2, UPPER), (a3, FOREARM)),
        shapes=(
            things.bench(-0.5, 3, -SHOULDER, -0.6),
            things.ball((*target, 0)),
            side_arm((theta2, theta3)),
            *map_frame(),
            *when(borders > 0.5, *countries()),
            *when(borders > 0.5, *border_lines()),
            Track("path", on_map(theta2, theta3)),
            Point("target", on_map(theta2, theta3)),
        ),
        handles=(
            *ring_handles(),
            Handle(
                "the dot in the map",
                on_map(theta2, theta3),
                {
                    joint: towards(joint, middle + (POINTER[k] - MAP[k]) / WIDE * 2 * exact_pi)
                    for k, (joint, middle) in enumerate(((theta2, -MIDDLE), (theta3, -exact_pi)))
                },
            ),
        ),
        readouts=(
            Readout(out, "wrist ahead: r"),
            Readout(arm.det_J, value=arm.determinant.right, digits=4),
        ),
    )


def dots_figure() -> Figure:
    """Draw a ball under the hand, and its four dots on the map."""
    ways = {
        "up": UP,
        "down": DOWN,
        "away up": [motion.wrap(exact_pi - UP[0]), -UP[1]],
        "away down": [motion.wrap(exact_pi - DOWN[0]), -DOWN[1]],
    }
    kinds = ("left", "right", "velocity", "turning")
    return Figure(
        name="four-dots",
        title="The arm with a ball to drag, and on the map of its angles four dots, one a region",
        view=WITH_MAP,
        ground="wall",
        grid=False,
        size="laboratory",
        controls=(
            replace(SCENE.common["controls"][0], start=0.42),
            replace(SCENE.common["controls"][1], start=0.35),
        ),
        where=WAYS,
        shapes=(
            things.bench(-0.5, 3, -SHOULDER, -0.6),
            *SCENE.layers["rims"],
            *SCENE.layers["below"],
            *SCENE.layers["arm"],
            *SCENE.layers["ball"],
            *map_frame(),
            *countries(),
            *border_lines(),
            *when(
                inside,
                *(
                    Point(kind, on_map(*way))
                    for kind, way in zip(kinds, ways.values(), strict=True)
                ),
            ),
        ),
        handles=SCENE.handles["ball"],
        readouts=(Readout(apart, "shoulder to ball: d"),),
        goal=(
            Goal(
                And(Abs(apart - most) < TOUCH, out > 0.1),
                "Let dots meet where the arm is stretched: within 8 mm.",
            ),
            Goal(
                And(Abs(apart - least) < TOUCH, out > 0.03),
                "Let them meet where it is folded. Look at the edges.",
            ),
            Goal(
                And(out < 0.01, apart < most - TOUCH, apart > least + TOUCH),
                "Let them meet on the curves: r below 1 cm.",
            ),
        ),
    )


# Where it fails.


def on_axis_figure() -> Figure:
    """Draw the wrist on the base axis: the base turns, and it stays."""
    ball = (0.0, 0.0, TARGET[2])
    _, lifted, bend = ways_to(ball)[0]
    return Figure(
        name="on-the-axis",
        title="The arm with its wrist straight above the base, at a ball; only the base turns",
        view=(-0.5, 0.6, -0.26, 0.64),
        ground="wall",
        controls=(Slider.degrees(theta1, start=-40, label="base θ_1"),),
        shapes=(
            *ground(0.45),
            bring_forward(VIEW.line("icr", ((0, 0, 0), (0, 0, 0.7))), -0.1),
            *space.arm((theta1, lifted, bend), LINKS, SHOULDER, 0),
            VIEW.solid(space.ball(), 0.025 * eye(3), ball),
            Label("icr", VIEW.project((0, 0, 0.7)), "base axis"),
        ),
        seen_from=(-pi / 3, pi / 7),
    )


SPEED, REACH, LEVEL = 0.1, 0.6, 0.3  # m/s, of the wrist; m: half of a way through the axis; above
LINE_SIDE, TALL = 1.5, 0.9  # m: the graph's width and height
share = quantity("share", "", -1, 1, "how far along the line, from end to end")


def spike_figure() -> Figure:
    """Draw the wrist on a line past the base axis, and the rate of the base as a graph."""
    half = sqrt(REACH**2 - arm.aside**2)
    bearing = atan2(arm.along, arm.aside)
    ends = (atan2(half, arm.aside), exact_pi / 2)
    d = sqrt(out**2 + LEVEL**2)
    lifted = arm.half_angles.substitute({a2: UPPER, a3: FOREARM, apart: d})[0]
    near = UPPER * cos(atan2(LEVEL, out) + lifted)
    low, left, high_rate = -0.45, 0.85, 3.5  # of the graph; rad/s at its top

    def on_graph(place: Any, rate: Any) -> tuple[Any, Any]:
        return left + (place + REACH) * LINE_SIDE / (
            2 * REACH
        ) / 1.25, low + rate * TALL / high_rate

    at = (arm.aside, arm.along)
    rate = substitute(arm.base_rate.right, {motion.v: SPEED})
    corners = (on_graph(-REACH, high_rate), on_graph(-REACH, 0), on_graph(REACH, 0))
    return Figure(
        name="spike",
        title="The arm from above; its wrist passes the base axis on a line; a graph has a spike",
        view=(-0.5, 2.2, -0.66, 0.66),
        ground="wall",
        grid=False,
        controls=(
            Slider(arm.aside, 0.03, 0.3, start=0.2, step=0.01, label="line passes the axis at δ"),
            Clock(share, -1.0, 1.0, start=-0.6, step=0.01, label="part of the way", rate=0.25),
        ),
        where=(
            (arm.along, share * half),
            (motion.v, SPEED),
            (out, sqrt(arm.aside**2 + arm.along**2)),
            (arm.rate1, arm.base_rate.right),
        ),
        shapes=(
            Line("path", ((arm.aside, -half), (arm.aside, half))),
            AngleArc("turning", ORIGIN, -ends[0], ends[0], 0.2, ""),
            Length(arm.aside, ORIGIN, (arm.aside, 0), aside=-0.03),
            from_above(bearing),
            *links([(x * cos(bearing), x * sin(bearing)) for x in (0, near, out)]),
            Point("target", at, "wrist"),
            Line("text", corners),
            Curve(arm.rate1, on_graph(s, substitute(rate, {arm.along: s})), s, -half, half, 160),
            Line("ghost", (on_graph(arm.along, 0), on_graph(arm.along, arm.rate1))),
            Point("turning", on_graph(arm.along, arm.rate1)),
            Label("text", (left + 0.5 * LINE_SIDE / 1.25, low - 0.11), "along the line"),
            Label(arm.rate1, (left + 0.14, low + TALL - 0.04)),
        ),
        handles=(Handle("the wrist", at, {share: POINTER[1] / half}),),
        readouts=(
            Readout(arm.rate1, "rate of the base", digits=2),
            Readout("turned", "angle between the ends", 2 * ends[0], "rad"),
        ),
    )


def nearest_figure() -> Figure:
    """Draw a ball out of reach, the nearest point that the wrist can reach, and how far it is."""
    best = (done * cos(rise), done * sin(rise))
    way = (rise + lift, -bent)
    missed = Max(0, apart - most, least - apart)
    return SCENE.figure(
        "nearest",
        "The arm reaches for a ball out of its reach; two circles are the limits of its workspace",
        "bench rims ball",
        drag="ball",
        view=(-0.6, 1.2, -0.36, 0.86),
        controls=(
            Slider(out, 0.0, 1.0, start=0.8, step=0.01, label="ball: ahead r"),
            Slider(high, -0.1, 0.8, start=0.3, step=0.01, label="ball: up h"),
        ),
        where=(*WAYS, (arm.d_min, least), (arm.d_max, most), (arm.D, done)),
        shapes=(
            side_arm(way),
            Line("ghost", (ORIGIN, BALL_AT)),
            *when(OUTSIDE, Line("error", (best, BALL_AT))),
            *when(OUTSIDE, Point("target", best, "nearest")),
        ),
        readouts=(Readout(apart), Readout("missed", "out of reach by", missed, "m")),
        goal=(
            Goal(Abs(apart - most - 0.1) < 0.006, "Put the ball 10 cm out of reach: within 6 mm."),
            Goal(apart < least - 0.02, "Find a ball whose nearest point is further out."),
        ),
    )


def one_circle_figure() -> Figure:
    """Draw equal links and a ball at the shoulder: both circles are one."""
    elbow = (UPPER * cos(theta2), UPPER * sin(theta2))
    return Figure(
        name="one-circle",
        title="An arm with equal links, folded, its wrist at the shoulder; its elbow on a circle",
        view=(-0.72, 0.72, -0.46, 0.5),
        ground="wall",
        grid=False,
        controls=(Slider.degrees(theta2, start=60, label="shoulder θ_2"),),
        shapes=(
            things.bench(-2, 3, -SHOULDER, -0.6),
            circle(a2, ORIGIN, UPPER),
            circle(a3, ORIGIN, UPPER),
            things.arm(
                (0, 0, 0), (theta2, exact_pi), (UPPER, UPPER), "", base="stand", shoulder=SHOULDER
            ),
            Point("icr", elbow, "elbow"),
            things.ball((0, 0, 0)),
        ),
        handles=(Handle("elbow", elbow, {theta2: towards(theta2, atan2(POINTER[1], POINTER[0]))}),),
    )


def det_figure() -> Figure:
    """Draw the triangle of shoulder, elbow and wrist, and how far the wrist is from the axis."""
    elbow, wrist = joints_of((theta2, theta3))
    flat = Abs(sin(theta3)) < 0.02
    return Figure(
        name="det-j",
        title="The arm from the side, the triangle of its joints, its wrist and the base axis",
        view=(-0.75, 1.05, -0.42, 0.8),
        ground="wall",
        grid=False,
        controls=bend_sliders(70, -60),
        where=((a2, UPPER), (a3, FOREARM), (out, wrist[0]), (arm.det_J, arm.determinant.right)),
        shapes=(
            things.bench(-2, 3, -SHOULDER, -0.5),
            side_arm((theta2, theta3)),
            Line("icr", ((0, -0.3), (0, 1))),
            Area("turning", (ORIGIN, elbow, wrist)),
            Line("heading", (ORIGIN, wrist)),
            Length(out, (0, wrist[1]), wrist),
            AngleArc(theta3, elbow, theta2, theta2 + theta3, 0.1),
            *when(Abs(arm.det_J) < 0.0003, Label("error", (0.75, 0.72), "a direction is lost")),
        ),
        handles=ring_handles(),
        readouts=(Readout(arm.det_J, digits=4),),
        goal=(
            Goal(And(flat, cos(theta3) > 0), "Lose a direction with the arm stretched: within 1°."),
            Goal(And(flat, cos(theta3) < 0), "Lose one with the arm folded: within 1°."),
            Goal(
                And(Abs(out) < 0.005, Abs(sin(theta3)) > 0.2),
                "Lose one with the elbow bent: r below 5 mm.",
            ),
        ),
    )


# The laboratory.

limits, bend = symbols("limits bend", real=True)  # 1: on, off is 0; 1: elbow up, down is -1
MARK, SHELF, BOARD = (0.2, 0.0, 0.3), 0.45, (-0.1, 0.5, -0.14, 0.14)  # m; height; x and y of it
ELBOW = 0.042  # m, its radius
LIMITS = {"shoulder": (-30, 120), "elbow": (-150, 150)}  # degrees


def depth_in_shelf(start: Sequence[Any], end: Sequence[Any]) -> Any:
    """Return a number that is positive if a straight link passes through the shelf."""
    rises = end[2] - start[2]
    part = (SHELF - start[2]) / Piecewise((rises, Abs(rises) > 1e-9), (1, True))
    x, y = (a + part * (b - a) for a, b in zip(start[:2], end[:2], strict=True))
    rooms = (part, 1 - part, x - BOARD[0], BOARD[1] - x, y - BOARD[2], BOARD[3] - y)
    return Min(*rooms, evaluate=False)  # as written, which is quicker


def room_in_limits(angles: Sequence[Any]) -> Any:
    """Return a number that is positive if shoulder and elbow are within their limits."""
    pairs = zip(angles, LIMITS.values(), strict=True)
    return Min(*(room for x, (low, high) in pairs for room in (x - rad(low), rad(high) - x)))


def shelf() -> tuple[Any, ...]:
    """Return the shelf on its two posts."""
    x, X, y, Y = BOARD
    middle = ((x + X) / 2, (y + Y) / 2, SHELF)
    posts = [meshes.cylinder("metal_mid", (0.012, 0.012), (0, SHELF), n=12) for _ in "12"]
    plank = replace(meshes.box("wood", (X - x, Y - y, 0.02), middle), edge="wood_edge")
    feet = ((X - 0.02, y + 0.02, 0), (X - 0.02, Y - 0.02, 0))
    return VIEW.solid((plank,), eye(3), floor=0), *(
        VIEW.solid((replace(post, edge="edge"),), eye(3), at, floor=0)
        for post, at in zip(posts, feet, strict=True)
    )


def laboratory_figure() -> Figure:
    """Draw the arm with a ball over the floor, a shelf, joint limits, and all four ways."""
    steps = NamedSteps(
        (
            (d1, SHOULDER),
            (out, arm.side.right[0]),
            (high, p_z - SHOULDER),
            (bearing, atan2(p_y, p_x)),
            *WAYS,
            (theta1, motion.wrap(bearing + (1 - face) / 2 * exact_pi)),
            (theta2, motion.wrap((1 - face) / 2 * exact_pi + face * (rise + bend * lift))),
            (theta3, -face * bend * bent),
        )
    )
    up, down = (
        [steps.add(f"{n}{k}", x) for k, x in enumerate(w)] for n, w in (("u", UP), ("w", DOWN))
    )
    hits, frees = [], []
    for name, way in (("up", up), ("down", down)):
        _, elbow, wrist = (
            steps.add(name + part, Matrix(place))
            for part, place in zip(
                "sew", space.arm_places((bearing, *way), LINKS, SHOULDER), strict=True
            )
        )
        hits.append(
            [
                steps.add(
                    f"{name}_upper",
                    Max(depth_in_shelf((0, 0, SHOULDER), elbow), ELBOW - elbow[2]),
                ),
                steps.add(f"{name}_fore", depth_in_shelf(elbow, wrist)),
            ]
        )
        for side, pose in (("f", way), ("a", (exact_pi - way[0], -way[1]))):
            within = room_in_limits((motion.wrap(pose[0]), pose[1]))
            frees.append(steps.add(f"{name}_{side}", Max(within, 9 * (1 - limits) - 4)))
    reached = steps.add("reached", Min(most - apart, apart - least) + most * TOLERANCE)
    free = [Min(room, reached, *(-h for h in hits[k // 2])) for k, room in enumerate(frees)]
    free = [steps.add(f"free_{k}", room) for k, room in enumerate(free)]
    left = sum(Piecewise((1, room > 0), (0, True)) for room in free)
    upper, fore = (
        steps.add(f"hit_{k}", Piecewise((u, bend > 0), (w, True)))
        for k, (u, w) in enumerate(zip(*hits, strict=True))
    )
    ours = steps.add(
        "ours",
        sum(
            room * (1 + side * face) * (1 + sign * face * bend) / 4
            for room, (sign, side) in zip(free, ((1, 1), (1, -1), (-1, 1), (-1, -1)), strict=True)
        ),
    )
    ball, foot = (p_x, p_y, p_z), (p_x, p_y, 0)
    on_mark = apart_from(ball, MARK) < 0.03
    az, el = VIEW.angles
    ahead = -POINTER[1] / sin(el)
    lifted = POINTER[1] - VIEW.project(ball)[1]
    body, wrong = (space.arm(JOINTS, LINKS, SHOULDER, 0.2, kind) for kind in ("", "error"))
    return Figure(
        name="arm-laboratory",
        title="The solid arm with a ball that is dragged over the floor and in height, and a shelf",
        view=(-0.86, 0.92, -0.42, 0.84),
        ground="wall",
        size="laboratory",
        controls=(
            Slider(p_x, -0.6, 0.6, start=TARGET[0], step=0.01, label="ball p_x"),
            Slider(p_y, -0.6, 0.6, start=TARGET[1], step=0.01, label="ball p_y"),
            Slider(p_z, 0.03, 0.8, start=TARGET[2], step=0.01, label="ball p_z"),
            Choice(
                "way",
                "way",
                (face, bend),
                {
                    "facing, up": (1, 1),
                    "facing, down": (1, -1),
                    "away, up": (-1, 1),
                    "away, down": (-1, -1),
                },
                start="facing, down",
            ),
            Choice("joint_limits", "joint limits", (limits,), {"off": (0,), "on": (1,)}),
        ),
        where=steps,
        shapes=(
            *ground(0.62),
            *shelf(),
            bring_forward(VIEW.line("ghost", (foot, ball)), 0.01),
            VIEW.point("target", foot),
            VIEW.solid(space.ball(), 0.03 * eye(3), MARK, floor=0, opacity=0.4),
            bring_forward(VIEW.line("target", (MARK, (*MARK[:2], 0))), 0.01),
            Label("target", VIEW.project(MARK), "mark"),
            Label("target", VIEW.project(foot), "foot"),
            VIEW.solid(space.ball(), 0.025 * eye(3), ball, floor=0),
            body[0],
            *when(upper <= 0, body[1]),
            *when(upper > 0, wrong[1]),
            *when(fore <= 0, *body[2:]),
            *when(fore > 0, *wrong[2:]),
        ),
        handles=(
            Handle(
                "the ball's foot",
                VIEW.project(foot),
                {
                    p_x: ahead * cos(az) - POINTER[0] * sin(az),
                    p_y: ahead * sin(az) + POINTER[0] * cos(az),
                },
            ),
            Handle(
                "the ball",
                VIEW.project(ball),
                {p_z: p_z + lifted * cos(el) / (cos(el) ** 2 + 0.002)},
            ),
        ),
        readouts=(
            Readout(theta1),
            Readout(theta2),
            Readout(theta3),
            Readout("off", "ball to mark", apart_from(ball, MARK), "cm", 0),
            Readout("left", "ways left", left, "", 0),
        ),
        goal=(
            Goal(
                And(on_mark, ours > 0, limits < 0.5),
                "Bring the ball to the mark, within 3 cm. Then choose a way without red.",
            ),
            Goal(And(on_mark, ours > 0, limits > 0.5), "The same with the joint limits on."),
            Goal(
                And(left < 0.5, reached > 0, limits > 0.5),
                "With the limits on, find a place in reach with no way left.",
            ),
            Goal(
                And(Abs(apart - most) < TOUCH, p_z > 0.1),
                "Find a place where up and down are one: within 8 mm.",
            ),
        ),
        seen_from=(1.0, 0.45),
    )


# The mistakes.

MISTAKES = symbols("mistake:5", real=True)  # 1 for the one that is made, else 0
ARM = {a2: 0.3, a3: 0.4, d1: 0.3}  # m, of the mistakes
PLACE = {p_y: 0.2, p_z: 0.5}  # m, of the target


def joint_angles_by(base: Any, cosine: Any, elevation: Any) -> Matrix:
    """Return the three joint angles, elbow up, from three numbers that may be wrong."""
    turn = arm.elbow.right[1].xreplace({arm.A: cosine})
    there = ARM[a2] + ARM[a3] * cos(turn), ARM[a3] * sin(turn)
    return Matrix([base, elevation - atan2(there[1], there[0]), turn])


def joint_angles() -> tuple[Matrix, dict[str, Matrix]]:
    """Return the right joint angles, and those by each mistake."""
    level = PLACE[p_z] - ARM[d1]
    given = {**ARM, **PLACE, high: level}
    base, cosine = arm.base.substitute(given)[0], arm.cosine.substitute(given)
    elevation = atan2(level, arm.side.substitute(given)[0])
    right = joint_angles_by(base, cosine, elevation)
    short, steep = no_p_x.substitute({p_y: PLACE[p_y], p_z: level})
    return right, {
        swapped_xy.title: joint_angles_by(swapped_xy.substitute(given), cosine, elevation),
        base_arctan.title: joint_angles_by(base_arctan.substitute(given), cosine, elevation),
        no_p_x.title: joint_angles_by(
            base, arm.cosine.substitute({**ARM, p_x: short, p_y: 0, high: 0}), steep
        ),
        cubed_a_3.title: joint_angles_by(base, cubed_a_3.substitute(given), elevation),
        base_only.title: base_only.substitute(dict(zip(JOINTS, right, strict=True))),
    }


def mistakes_figure() -> Figure:
    """Draw the arm at its target, and in red where a mistake sends it."""
    right, ways = joint_angles()
    away = arm.away.substitute(dict(zip(JOINTS, right, strict=True)))
    true_arm = right + MISTAKES[4] * (away - right)  # where the red base turns round, it does too
    wrong = Matrix.hstack(*ways.values()) * Matrix(MISTAKES)
    here, there = symbols("right:3", real=True), symbols("wrong:3", real=True)
    long, height = (ARM[a2], ARM[a3]), ARM[d1]
    _, _, missed = space.arm_places(there, long, height)
    target = (p_x, PLACE[p_y], PLACE[p_z])
    return Figure(
        name="wrong-reach",
        title="An arm that holds its target p, and a red one that a mistake sends elsewhere",
        view=(-0.86, 0.86, -0.45, 0.84),
        ground="wall",
        controls=(
            Choice.one_hot("mistake", MISTAKES, ways, start=swapped_xy.title),
            Slider(p_x, -0.5, 0.5, start=-0.45, step=0.05, label="target p_x"),
        ),
        where=(*zip(here, true_arm, strict=True), *zip(there, wrong, strict=True)),
        shapes=(
            space.floor(0, 0.7),
            VIEW.solid(space.column(0.5 * height), eye(3), floor=0),
            VIEW.arrow("text", (0, 0, 0), (0.7, 0, 0), "x"),
            VIEW.arrow("text", (0, 0, 0), (0, 0.7, 0), "y"),
            *space.arm(here, long, height, 0),
            *space.arm(there, long, height, 0, kind="error"),
            VIEW.line("error", (missed, target)),
            bring_forward(VIEW.point("target", target, "p"), 0.1),
        ),
        readouts=(
            Readout("d", "shoulder to p", apart_from(target, (0, 0, height)), "m"),
            Readout("reach", "shoulder to wrist", apart_from(missed, (0, 0, height)), "m"),
            Readout("off", "off by", apart_from(missed, target), "m"),
        ),
        seen_from=(-5 * pi / 9, pi / 7),
    )


# The recap, and DH.


def letters_figure() -> Figure:
    """Draw the picture of the chapter with two letters that are to be put back."""
    middles = [
        ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in ((ELBOW_UP, BALL_AT), (ORIGIN, BALL_AT))
    ]
    answers = dict(zip(("a_3", "d"), middles, strict=True))
    letters = put_back(quantity, ("a_2", "a_3", "d", "r"), answers)
    return SCENE.figure(
        "arm-letters",
        "The two circles, the arm at one of their crossings, with the numbers 1 and 2",
        "bench circles below arm line ball elbows",
        controls=letters.controls,
        where=((out, 0.42), (high, 0.28), *WAYS),
        shapes=letters.shapes,
        goal=letters.goal,
    )


def recap_figure() -> Figure:
    """Draw the picture of the chapter at rest: two circles, and the triangle between them."""
    return SCENE.figure(
        "arm-recap",
        "A circle about the shoulder and one about the ball; the elbow is where they cross",
        "bench circles below arm line ball elbows angles",
        controls=(),
        where=((out, 0.42), (high, 0.28), *WAYS),
    )


def dh_figure() -> Figure:
    """Draw the frames of the DH table on the solid arm."""
    shoulder, elbow, wrist = space.arm_places(JOINTS, LINKS, SHOULDER)
    places = ((0, 0, 0), shoulder, elbow, wrist)
    frames = (
        eye(3),
        space.tilt(theta1, 0),
        space.tilt(theta1, theta2),
        space.tilt(theta1, theta2 + theta3),
    )
    return Figure(
        name="dh-frames",
        title="The solid arm with four frames: on the floor, at its shoulder, elbow and wrist",
        view=(-0.5, 0.72, -0.3, 0.68),
        ground="wall",
        controls=(Slider.degrees(theta1, start=30, label="base θ_1"), *bend_sliders(70, -60)),
        shapes=(
            *ground(0.5),
            *space.arm(JOINTS, LINKS, SHOULDER),
            *(
                replace(arrow, depth=arrow.depth + 0.15)
                for k, (frame, at) in enumerate(zip(frames, places, strict=True))
                for arrow in VIEW.frame(frame, at, 0.16, (f"x_{k}", "", f"z_{k}"))
            ),
        ),
        seen_from=(-pi / 4, pi / 7),
    )


FIGURES = (
    grip_figure(),
    exercise_figure(),
    guess_figure(),
    forward_figure(),
    base_figure(),
    circles_figure(),
    triangle_figure(),
    cosine_figure(),
    turn_round_figure(),
    borders_figure(),
    dots_figure(),
    det_figure(),
    on_axis_figure(),
    spike_figure(),
    one_circle_figure(),
    nearest_figure(),
    laboratory_figure(),
    mistakes_figure(),
    letters_figure(),
    recap_figure(),
    dh_figure(),
)
