"""The live figures of the chapter on the differential drive: one robot all the way."""

from typing import Any

from sympy import (
    Abs,
    And,
    Max,
    Min,
    Ne,
    Or,
    Piecewise,
    Rational,
    Symbol,
    atan2,
    cos,
    log,
    nan,
    oo,
    pi,
    sign,
    sin,
    sinc,
    sqrt,
    symbols,
)

from book import things
from book.differential_drive import formulas as drive
from book.differential_drive.exercises import (
    degrees_taken,
    differential_drive_1,
    differential_drive_2,
    double_distance,
    half_wheel_distance,
    world_to_robot,
)
from book.differential_drive.formulas import R, b, r, rate_L, rate_R, v_L, v_R
from book.frames.figures import point_of
from book.letters import put_back
from book.motion import formulas as motion
from book.motion.formulas import (
    dt,
    omega,
    theta,
    theta_m,
    theta_next,
    v,
    v_y,
    x,
    x_dot,
    x_icr,
    x_next,
    y,
    y_dot,
    y_icr,
    y_next,
)
from book.things.graph import Graph
from courseware.equations import declarations, substitute
from courseware.figures import (
    POINTER,
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
    Point,
    Readout,
    Recurrence,
    Scene,
    Slider,
    Sprite,
    Trail,
    assign,
    distance,
    ramp,
    when,
)

quantity, _ = declarations(__name__)

DISTANCE, RADIUS = 0.1, 0.03  # m, between the wheels, and of a wheel, as in the exercise
SPEEDS = {v_L: 0.05, v_R: 0.1}  # m/s, of the exercise's wheels
TWIST = {  # and so of the robot; rounded, as 0.05 + 0.1 has a last digit too many
    each.left: round(float(each.substitute({**SPEEDS, b: DISTANCE})), 15)
    for each in (drive.speed, drive.turning_rate)
}
ARROW = 1  # s: an arrow is as long as the way in this time, so that a slope is an ω
ORIGIN, START = (0, 0), (0, 0, pi / 2)  # the robot looks along the world's y axis
FAR = 1e12  # m: a handle is not at infinity
NO_ICR = {"inf": "at infinity", "nan": "nowhere: at rest"}
VELOCITY = ((b, DISTANCE), *assign(drive.speed, drive.turning_rate))
RADIUS_TOO = (*VELOCITY, *assign(drive.turning_radius))

t = quantity("t", "s", 0, 12, "time")
n = quantity("n", "", 1, 100, "number of steps")
slowed = quantity("slowed", "m/s", 0, 0.1, "by how much the right wheel is slower than at first")
share = quantity("share", "rad", -1.6, 1.6, "angle that shares the speed between the wheels")
way_L = quantity("way_L", "m", -1, 1, "how far the left wheel has rolled")
way_R = quantity("way_R", "m", -1, 1, "how far the right wheel has rolled")
power = quantity("power", "", 0, 16, "the angular velocity is ten to the minus this", latex="p")
guess_x = quantity("guess_x", "m", -0.3, 0.2, "your guess, along x")
guess_y = quantity("guess_y", "m", -0.1, 0.3, "your guess, along y")
pin_x = quantity("pin_x", "m", -0.3, 0.2, "your pin, along x")
pin_y = quantity("pin_y", "m", -0.1, 0.2, "your pin, along y")
believed_rate = quantity("believed_rate", "rad/s", -2, 2, "angular velocity as a mistake makes it")
believed_heading = quantity("believed_heading", "rad", -99, 99, "heading as a mistake makes it")
wish_x = quantity("wish_x", "m/s", -0.2, 0.2, "wished speed along the robot's own x axis")
wish_y = quantity("wish_y", "m/s", -0.2, 0.2, "wished speed to the robot's left")
aim = quantity("aim", "rad", -3.2, 3.2, "first turn on the spot; the last one is as much back")
reach = quantity("reach", "m", 0, 0.25, "how far straight on, between the two turns")
done = quantity("done", "", 0, 3, "how many of the three parts are done")
s = Symbol("s")


# The robot, and where its parts are.


def robot(pose: Any, time: Any = 0, rolled: Any = (), look: str = "") -> Sprite:
    """Return the robot; time: how long the wheels have rolled, or how far each of them."""
    return things.robot(pose, rolled or (v_L * time, v_R * time), look)


def mark(pose: Any, end: Any, words: str = "{off}, {turned} off") -> tuple[Any, ...]:
    """Return the mark on which the robot shall end; its lights go on when it does."""
    lights = when(is_parked(end, pose), things.pad_lights(pose))
    return things.pad(pose), *lights, Label("target", (pose[0], pose[1] - 0.085), words)


def tip(pose: Any, speed: Any, side: int) -> tuple[Any, Any]:
    """Return the end of the arrow of the left (1), the middle (0) or the right (-1)."""
    return point_of(pose, ARROW * speed, side * DISTANCE / 2)


def arrows(pose: Any, middle: bool = True, letters: bool = True) -> tuple[Arrow, ...]:
    """Return arrows of the speeds of the wheels, and of the middle of the axle."""
    sides = ((v_L, 1), (v_R, -1), (v, 0))[: 3 if middle else 2]
    label = None if letters else ""
    return tuple(Arrow(u, tip(pose, 0, side), tip(pose, u, side), label) for u, side in sides)


def tip_handles() -> tuple[Handle, Handle]:
    """Return handles at the tips of the wheels' arrows, of the robot at the start."""
    speed = POINTER[1] / ARROW
    return (
        Handle("tip of the left wheel's arrow", tip(START, v_L, 1), {v_L: speed}),
        Handle("tip of the right wheel's arrow", tip(START, v_R, -1), {v_R: speed}),
    )


def speed_sliders(
    left: float, right: float, most: float = 0.15, least: float = -0.15
) -> tuple[Slider, Slider]:
    """Return sliders for the two wheel speeds."""
    return (
        Slider(v_L, least, most, start=left, step=0.005),
        Slider(v_R, least, most, start=right, step=0.005),
    )


def drive_for(time: Any, start: Any = START) -> Any:
    """Return the pose after driving for a time from a start."""
    return motion.arc_step.substitute({x: start[0], y: start[1], theta: start[2], dt: time})


def way(kind: str, low: Any, high: Any, forward: Any = 0, left: Any = 0) -> Curve:
    """Return the track of a point of the robot between two times."""
    return Curve(kind, point_of(drive_for(s), forward, left), s, low, high)


def tracks(low: Any, high: Any) -> tuple[Curve, ...]:
    """Return the tracks of both wheels and of the middle."""
    half = DISTANCE / 2
    ways = (("left", half), ("right", -half), ("path", 0))
    return tuple(way(kind, low, high, left=left) for kind, left in ways)


def angle_size(angle: Any) -> Any:
    """Return the size of an angle, round the circle."""
    return Abs(atan2(sin(angle), cos(angle)))


OFF, TURNED = 2, 5  # cm, degrees: how far from a mark the robot still counts as parked
TIMES = 3  # the laboratory's right track, by the left one


def is_parked(end: Any, mark: Any) -> Any:
    """Return whether the robot ends on the mark."""
    return And(distance(end, mark) < OFF / 100, angle_size(end[2] - mark[2]) < TURNED * pi / 180)


# The scene: of what is drawn of the robot at its start, each figure shows some layers.

moves = Or(Ne(v_L, 0), Ne(v_R, 0))
turns = Ne(v_L, v_R)
AXLE = (-0.6, 0.6)  # m: from where to where lines across the picture go
towards = Piecewise((0, v_R > v_L), (pi, True))  # from the ICR to the robot
seen = Max(-0.55, Min(0.55, -R))  # where the ICR is, or how far R is drawn towards it
SPAN = tuple(Piecewise((end(0, seen), moves), (nan, True)) for end in (Min, Max))
TIPS = (point_of(START, v_L, DISTANCE / 2), point_of(START, v_R, -DISTANCE / 2))
RUN = (TIPS[0], (TIPS[1][0], TIPS[0][1]))  # the slope of the line through the tips: run and rise
RISE = ((TIPS[1][0], Min(v_L, v_R)), (TIPS[1][0], Max(v_L, v_R)))


def point_on_tips(right: Any) -> tuple[Any, Any]:
    """Return the point of the line through the tips that is so far to the right of the middle."""
    return right, ARROW * (v + omega * right)


def across(places: Any) -> tuple[Arrow, ...]:
    """Return pale arrows of points of the axle's line, so far to the right of the middle."""
    return tuple(Arrow("ghost", (x, 0), point_on_tips(x), "") for x in places)


SCENE = Scene(
    layers={
        "axle": when(moves, Line("icr", ((AXLE[0], 0), (AXLE[1], 0)))),
        "everywhere": when(moves, *across(Rational(k, 40) for k in range(-12, 7) if abs(k) > 2)),
        "tips": when(moves, Line("turning", (point_on_tips(AXLE[0]), point_on_tips(AXLE[1])))),
        "robot": (robot(START),),
        "between": across(Rational(k, 80) for k in (-3, -2, -1, 1, 2, 3)),
        "wheels": arrows(START, middle=False),
        "speed": (Arrow(v, ORIGIN, (0, ARROW * v)),),
        "slope": when(turns, Length(b, *RUN), Length(omega, *RISE, "ω b", aside=-0.03)),
        "radius": (Length(R, (SPAN[0], 0), (SPAN[1], 0), aside=-0.095),),
        "icr": (Point("icr", (-R, 0), label="ICR"),),
    },
    handles={"wheels": tip_handles()},
    common={
        "view": (-0.26, 0.18, -0.11, 0.2),
        "ground": "tiles",
        "where": RADIUS_TOO,
        "controls": speed_sliders(SPEEDS[v_L], SPEEDS[v_R], least=-0.06),
    },
)


# Opening.

TIME = 3.0  # s, of the opening's drive
MARK = tuple(
    motion.arc_step.substitute({x: 0, y: 0, theta: pi / 2, v: 0.09, omega: 0.6, dt: TIME}).evalf(17)
)


def park_figure() -> Figure:
    """Draw a robot with two wheel speeds to set, and a mark to end on."""
    now, end = drive_for(t), drive_for(TIME)
    return Figure(
        name="park",
        title="A robot seen from above, its two wheels under your hand, and a mark to park on",
        view=(-0.34, 0.2, -0.1, 0.27),
        ground="tiles",
        controls=(*speed_sliders(0.05, 0.05), Clock(t, 0.0, TIME, loops=True, label="time")),
        where=VELOCITY,
        shapes=(
            *mark(MARK, end),
            Curve("ghost", drive_for(s), s, 0, TIME),
            robot(START, look="ghost"),
            robot(end, look="ghost"),
            robot(now, time=t),
            *arrows(START, middle=False),
        ),
        handles=tip_handles(),
        readouts=(
            Readout("off", "at the end: off the mark", distance(end, MARK), "cm", 0),
            Readout("turned", "at the end: heading off by", angle_size(end[2] - MARK[2]), "rad", 0),
        ),
        goal=Goal(
            is_parked(end, MARK), f"Park the robot on the mark: within {OFF} cm and {TURNED}°."
        ),
    )


# The exercise, and the steps.


def exercise_figure() -> Figure:
    """Draw the robot of the exercise with all its symbols, at rest."""
    given = ((b, DISTANCE), (r, RADIUS), (theta, pi / 2), *SPEEDS.items())
    left, right = point_of(START, 0, DISTANCE / 2), point_of(START, 0, -DISTANCE / 2)
    return Figure(
        name="exercise",
        title=(
            "A round robot from above that looks along the y axis of the world; its left wheel has "
            "a short arrow forward, its right wheel an arrow twice as long"
        ),
        view=(-0.2, 0.2, -0.12, 0.18),
        ground="tiles",
        where=given,
        shapes=(
            Arrow("x_axis", ORIGIN, (0.17, 0), "x"),
            Arrow("y_axis", ORIGIN, (0, 0.16), "y"),
            robot(START),
            *arrows(START, middle=False),
            Point("body", ORIGIN, "P"),
            AngleArc(theta, ORIGIN, 0, theta, 0.04),
            Length(b, left, right, aside=-0.085, label="b = 10 cm"),
            Length(r, (-0.05, 0), (-0.05, -RADIUS), aside=-0.03, label="r = 3 cm"),
        ),
    )


def axle_figure() -> Figure:
    """Draw the arrows of the points of the axle: it is stiff, so their tips lie on one line."""
    return SCENE.figure(
        "axle",
        "The robot from above, an arrow at each wheel and smaller ones between; all end on a line",
        "tips robot between wheels speed",
        drag="wheels",
        view=(-0.17, 0.17, -0.1, 0.18),
        readouts=(Readout(v),),
    )


def still_figure() -> Figure:
    """Draw a pin to place, in a sheet that turns with the robot: one point of it stays."""
    now, pin = drive_for(t), (pin_x, pin_y)
    stuck, there = (  # the robot looks along y at the start
        point_of(drive_for(time), pin_y, -pin_x) for time in (s, t)
    )
    return Figure(
        name="still",
        title="The robot of the exercise, and a pin to stick into a sheet that turns with it",
        view=(-0.28, 0.2, -0.12, 0.19),
        ground="tiles",
        controls=(
            Slider(pin_x, -0.25, 0.15, start=0.1, step=0.005, label="pin: x"),
            Slider(pin_y, -0.1, 0.15, start=0.1, step=0.005, label="pin: y"),
            Clock(t, 0.0, 1.5, label="time"),
        ),
        where=(*SPEEDS.items(), *VELOCITY),
        shapes=(
            robot(START, look="ghost"),
            Curve("target", stuck, s, 0, t),
            Line("ghost", (now, there)),
            robot(now, time=t),
            *arrows(START, middle=False),
            Point("target", there, "your pin"),
        ),
        handles=(Handle("the pin", pin),),
    )


def tips_figure() -> Figure:
    """Draw the point at rest, and the slope of the line through it and the tips."""
    moving = Max(Abs(v_L), Abs(v_R)) > 0.02
    return SCENE.figure(
        "tips",
        "The line through the tips, down to the point of the axle's line that stands still",
        "axle everywhere tips robot wheels slope radius icr",
        drag="wheels",
        view=(-0.3, 0.18, -0.2, 0.17),
        shapes=(
            Point("body", ORIGIN, "P"),
            *when(
                And(turns, Abs(R) < 0.3),
                Length("left", (-R, 0), (-DISTANCE / 2, 0), "R − b/2", aside=-0.13),
                Length("right", (-R, 0), (DISTANCE / 2, 0), "R + b/2", aside=-0.165),
            ),
        ),
        readouts=(Readout(v), Readout(omega), Readout(R, words={"inf": "∞", "nan": "…"})),
        goal=(
            Goal(And(Abs(v_L) < 0.003, moving), "Bring the ICR to the left wheel."),
            Goal(And(Abs(v_L + v_R) < 0.006, moving), "Bring it to P: v below 3 mm/s."),
            Goal(
                And(Abs(v_L - v_R) < 0.003, moving),
                "Send it away: the same speed, within 3 mm/s.",
            ),
        ),
    )


def away_figure() -> Figure:
    """Draw where the ICR goes when the right wheel slows down."""
    return SCENE.figure(
        "away",
        "The robot small, the line of its axle, the line through the tips, and where both meet",
        "axle tips robot wheels radius icr",
        view=(-0.47, 0.47, -0.16, 0.19),
        controls=(Clock(slowed, 0.0, 0.07, step=0.0005, rate=0.02, label="slower by"),),
        where=((v_L, SPEEDS[v_L]), (v_R, SPEEDS[v_R] - slowed), *RADIUS_TOO),
        shapes=across(Rational(k, 20) for k in range(-10, 11) if abs(k) > 1),
        handles=(
            Handle(
                "the ICR",
                (Max(-FAR, Min(FAR, -R)), 0),
                {slowed: SPEEDS[v_R] - v_L * (1 - b / (POINTER[0] + b / 2))},
            ),
        ),
        readouts=(Readout(v_R), Readout(R, words={"inf": "∞"})),
        goal=Goal(Abs(R + 0.25) < 0.02, "Bring the ICR 25 cm to the right of P, within 2 cm."),
    )


def infinity_figure() -> Figure:
    """Draw the ICR that goes out to one side and comes back from the other: infinity is a point."""
    far = 0.13  # m: radius of the circle that touches the axle at P
    dot = (-far * sin(2 * share), -far - far * cos(2 * share))
    turn = DISTANCE / (4 * far) * sin(share)
    return Figure(
        name="infinity",
        title="A small robot, the line of its axle, and below it the same line bent into a circle",
        view=(-0.42, 0.42, -0.3, 0.18),
        ground="tiles",
        controls=(Slider.degrees(share, -90, 90, start=40, label="angle of the ray from ∞"),),
        where=((v_L, 0.07 * (cos(share) - turn)), (v_R, 0.07 * (cos(share) + turn)), *RADIUS_TOO),
        shapes=(
            Line("icr", ((-0.5, 0), (0.5, 0))),
            way("path", -12, 12),
            Curve("icr", (far * cos(s), -far + far * sin(s)), s, 0, 2 * pi),
            Line("ghost", ((0, -2 * far), (-R, 0))),
            robot(START),
            *arrows(START, middle=False, letters=False),
            Label("text", (far + 0.11, -1.7 * far), "the line, bent"),
            Point("icr", dot),
            Point("target", (0, -2 * far), label="∞"),
            Point("icr", (-R, 0), label="ICR"),
        ),
        handles=(
            Handle("the ICR on the map", dot, {share: atan2(-POINTER[0], -POINTER[1] - far) / 2}),
        ),
        buttons=(
            Button("to the left", {share: 1.2}),
            Button("through ∞", {share: 0}),
            Button("to the right", {share: -1.2}),
        ),
        readouts=(Readout(R, words={"inf": "∞"}),),
    )


def icr_figure() -> Figure:
    """Draw the ICR in the world: from P as far as R, across the heading."""
    place, centre = (x, y), (x_icr, y_icr)
    corner = (x_icr, y)
    return Figure(
        name="icr",
        title="The robot at a place of the world, its heading, and the ICR to its left",
        view=(-0.04, 0.42, -0.05, 0.33),
        ground="tiles",
        controls=(Slider.degrees(theta, -175, 175, start=40, step=5),),
        where=(
            (x, 0.2),
            (y, 0.16),
            *SPEEDS.items(),
            *RADIUS_TOO,
            *assign(motion.icr),
        ),
        shapes=(
            Arrow("text", ORIGIN, (0.39, 0), "x axis"),
            Arrow("text", ORIGIN, (0, 0.3), "y axis"),
            Line("ghost", ((0, y), place, (x, 0))),
            Label("text", (0.03, y + 0.013), "x"),
            Label("text", (x + 0.013, 0.03), "y"),
            robot((x, y, theta)),
            Line("ghost", (place, (x + 0.12, y))),
            AngleArc(theta, place, 0, theta, 0.045),
            Arrow("heading", place, point_of((x, y, theta), 0.11), ""),
            Line("x_axis", (place, corner)),
            Line("y_axis", (corner, centre)),
            *when(Abs(sin(theta)) > 0.3, Label("x_axis", ((x + x_icr) / 2, y - 0.014), "R sin θ")),
            *when(Abs(cos(theta)) > 0.3, Label("y_axis", (x_icr, (y + y_icr) / 2), "R cos θ")),
            Line(R, (place, centre)),
            Label(R, ((x + x_icr) / 2, (y + y_icr) / 2)),
            Point("icr", centre, label="ICR"),
            Point("body", place, "P"),
        ),
        handles=(
            Handle(
                "tip of the heading",
                point_of((x, y, theta), 0.11),
                {theta: atan2(POINTER[1] - y, POINTER[0] - x)},
            ),
        ),
        readouts=(Readout(x_icr), Readout(y_icr)),
    )


def world_figure() -> Figure:
    """Draw one velocity, and its parts along the world's axes."""
    end = (ARROW * x_dot, ARROW * y_dot)
    return Figure(
        name="world",
        title="The robot's velocity and its parts along the axes of the world",
        view=(-0.14, 0.15, -0.11, 0.12),
        ground="tiles",
        controls=(Slider.degrees(theta, start=40),),
        where=(*SPEEDS.items(), *TWIST.items(), (v_y, 0), *assign(motion.to_world)),
        shapes=(
            Line("ghost", ((-0.3, 0), (0.3, 0))),
            Line("ghost", ((0, -0.3), (0, 0.3))),
            robot((0, 0, theta)),
            AngleArc(theta, ORIGIN, 0, theta, 0.04),
            *when(Abs(x_dot) > 0.004, Arrow(x_dot, ORIGIN, (end[0], 0))),
            *when(Abs(y_dot) > 0.004, Arrow(y_dot, ORIGIN, (0, end[1]))),
            Label("text", (0.14, -0.01), "x"),
            Label("text", (0.01, 0.11), "y"),
            Line("ghost", ((end[0], 0), end, (0, end[1]))),
            Arrow(v, ORIGIN, end),
        ),
        handles=(Handle("tip of the velocity", end, {theta: atan2(POINTER[1], POINTER[0])}),),
        readouts=(Readout(x_dot), Readout(y_dot)),
    )


def added_figure() -> Figure:
    """Draw driving and turning, one by one and added: what each wheel has to do."""
    wheels = []
    for speed, side in ((v_L, 1), (v_R, -1)):
        part = -side * omega * b / 2
        wheels += [
            Arrow(v, point_of(START, 0, side * 0.042), point_of(START, ARROW * v, side * 0.042)),
            *when(
                Ne(omega, 0),
                Arrow(
                    omega,
                    point_of(START, ARROW * v, side * 0.058),
                    point_of(START, ARROW * (v + part), side * 0.058),
                    "ωb/2" if side < 0 else "−ωb/2",
                ),
            ),
            Arrow(
                speed,
                point_of(START, 0, side * 0.095),
                point_of(START, ARROW * speed, side * 0.095),
            ),
        ]
    drives, spins = TWIST[v], TWIST[omega]
    return Figure(
        name="added",
        title="The robot that drives, that turns, and that does both: its wheels' arrows are added",
        view=(-0.17, 0.17, -0.1, 0.16),
        ground="tiles",
        controls=(
            Slider(v, 0.0, 0.1, start=drives, step=0.005),
            Slider(omega, -1.0, 1.0, start=0.0, step=0.05),
        ),
        where=((b, DISTANCE), *assign(drive.wheel_speeds)),
        shapes=(robot(START), *wheels),
        buttons=(
            Button("only drive", {v: drives, omega: 0}),
            Button("only turn", {v: 0, omega: spins}),
            Button("both", {v: drives, omega: spins}),
        ),
        readouts=(Readout(v_L), Readout(v_R)),
    )


def rolling_wheel(speed: Any, rate: Any, way: Any, high: float, stripe: str) -> tuple[Any, ...]:
    """Return a wheel from the side that rolls along a ruler: its radius, its rate, its way."""
    start, hub = 0.12, (0.12 + way, high + RADIUS)

    def rim(turned: Any) -> tuple[Any, Any]:
        """Return the place beside the rim after a turn from the top, clockwise."""
        return hub[0] + 1.35 * RADIUS * sin(turned), hub[1] + 1.35 * RADIUS * cos(turned)

    turned = rate / 2  # as in half a second
    rolls = And(Abs(way) > 0.001, Abs(way) < 6 * RADIUS)  # less than once round
    return (
        things.ruler((start, high, 0), 0.1, 2),
        *(Label("text", (start + k / 10, high - 0.034), f"0.{k} m") for k in (1, 2)),
        things.encoder_wheel((*hub, pi / 2), way, RADIUS, slots=12, stripe=stripe),
        Length(r, (hub[0], high), hub, aside=0.042),
        *when(rolls, AngleArc(speed, hub, pi / 2, pi / 2 - way / r, 0.02, "φ")),
        Curve(rate, rim(s * turned), s, 0, 1, 8),
        *when(Abs(turned) > 0.2, Arrow(rate, rim(turned - 0.25 * sign(turned)), rim(turned))),
        Length(speed, (start, high), (hub[0], high), aside=-0.054, label=f"r φ = {{{way}}}"),
    )


def rates_figure() -> Figure:
    """Draw a wanted motion, and the two wheels that roll for it, seen from the side."""
    return Figure(
        name="rates",
        title="A robot from above; beside it its two wheels from the side",
        view=(-0.1, 0.4, -0.16, 0.2),
        ground="wall",
        controls=(
            Slider(v, 0.0, 0.1, start=TWIST[v], step=0.005),
            Slider(omega, -1.0, 1.0, start=TWIST[omega], step=0.05),
            Clock(t, 0.0, 1.5, loops=True, label="time"),
        ),
        where=(
            (b, DISTANCE),
            (r, RADIUS),
            *assign(drive.wheel_speeds, drive.wheel_rates),
            (way_L, r * rate_L * t),
            (way_R, r * rate_R * t),
        ),
        shapes=(
            robot(START, time=t),
            *arrows(START),
            *rolling_wheel(v_L, rate_L, way_L, 0.08, "left2"),
            *rolling_wheel(v_R, rate_R, way_R, -0.09, "right2"),
        ),
        readouts=(Readout(rate_L), Readout(rate_R)),
        grid=False,
    )


def guess_figure() -> Figure:
    """Draw a place to guess: where the robot of the exercise will be."""
    return Figure(
        name="guess",
        title="The robot of the exercise with its wheel arrows, and your guess of where it will be",
        view=(-0.3, 0.2, -0.09, 0.3),
        ground="tiles",
        controls=(
            Slider(guess_x, -0.25, 0.15, start=0.1, step=0.005, label="x"),
            Slider(guess_y, -0.05, 0.25, start=0.2, step=0.005, label="y"),
            Clock(t, 0.0, 2.0, label="time"),
        ),
        where=(*SPEEDS.items(), *VELOCITY),
        shapes=(
            robot(START, look="ghost"),
            way("path", 0, t),
            robot(drive_for(t), time=t),
            *arrows(START, middle=False),
            Point("target", (guess_x, guess_y), "your guess"),
        ),
        handles=(Handle("your guess", (guess_x, guess_y)),),
    )


def spokes_figure() -> Figure:
    """Draw the two spokes from the ICR to the robot, before and after the step."""
    down, end = -pi / 2, (x_next, y_next, theta_next)
    centre = (-R * sin(theta), R * cos(theta))  # as P is at the origin

    def from_icr(heading: Any, far: float) -> tuple[Any, Any]:
        """Return a place on the spoke of a heading: straight down for 0, turned as the robot is."""
        return centre[0] + far * sin(heading), centre[1] - far * cos(heading)

    def spoke(kind: str, heading: Any, tip: Any) -> tuple[Any, ...]:
        """Return a spoke, and its parts along x and y."""
        middle = from_icr(heading, R / 2)
        return (
            Line("ghost", (tip[:2], (centre[0], tip[1]))),
            Arrow(kind, centre, tip, ""),
            Label(kind, middle, "R"),
        )

    return Figure(
        name="spokes",
        title="From the ICR two spokes go to the robot, one before and one after the step",
        view=(-0.26, 0.14, -0.11, 0.23),
        ground="tiles",
        controls=(
            Slider.degrees(theta, 30, 120, start=60, step=5),
            Slider(dt, 0.0, 3.0, start=2.0, step=0.1),
        ),
        where=((x, 0), (y, 0), *SPEEDS.items(), *RADIUS_TOO, *assign(motion.arc_step)),
        shapes=(
            robot((0, 0, theta), look="ghost"),
            Curve("path", motion.arc_step.right.subs(dt, s)[:2], s, 0, dt),
            robot(end, time=dt),
            Line("ghost", (centre, (centre[0], centre[1] - R))),
            AngleArc(theta, centre, down, down + theta, 0.06),
            AngleArc("new_heading", centre, down, down + theta_next, 0.04, ""),
            *spoke("old_heading", theta, ORIGIN),
            *spoke("new_heading", theta_next, end),
            Label("new_heading", from_icr(theta_next - 0.4, 0.064), "θ′"),
            *when(dt > 0.3, AngleArc(omega, centre, down + theta, down + theta_next, 0.1, "ωΔt")),
            Point("icr", centre, label="ICR"),
            Point("body", ORIGIN, "x, y"),
            *when(dt > 0.3, Point("body", end[:2], "x′, y′")),
        ),
        readouts=(Readout(x_next), Readout(y_next), Readout(theta_next)),
    )


def arc_figure() -> Figure:
    """Draw the step along the arc: as far as the chord, along the middle heading."""
    end = (x_next, y_next, theta_next)
    half = atan2(-POINTER[0], POINTER[1])
    time = sqrt(POINTER[0] ** 2 + POINTER[1] ** 2) / (v * sinc(half))
    still = {v_L: v - omega * DISTANCE / 2, v_R: v + omega * DISTANCE / 2}
    middle = (x_next / 2, y_next / 2)
    turned = omega * dt / 2
    halfway = motion.arc_step.right.subs({dt: dt / 2, x: 0, y: 0, theta: pi / 2})
    return Figure(
        name="arc",
        title="A step along an arc: the chord from the old place to the new, the middle heading",
        view=(-0.3, 0.2, -0.09, 0.3),
        ground="tiles",
        controls=(
            Slider(omega, -1.0, 1.0, start=TWIST[omega], step=0.05),
            Slider(dt, 0.5, 3.0, start=2.0, step=0.1),
        ),
        where=(
            (v, TWIST[v]), (x, 0), (y, 0), (theta, pi / 2), *still.items(),
            *assign(motion.arc_step, motion.chord),
            (R, Piecewise((v / omega, Ne(omega, 0)), (oo, True))),
        ),
        shapes=(
            Area("icr", ((-R, 0), ORIGIN, end)),
            Line("icr", (ORIGIN, (-R, 0), end)),
            Line("icr", ((-R, 0), middle)),
            robot(START, look="ghost"),
            Line("ghost", (ORIGIN, (0, 0.3))),
            way("path", 0, dt),
            *when(Abs(turned) > 0.1, AngleArc(drive.u, ORIGIN, pi / 2, theta_m, 0.09)),
            *when(
                Ne(omega, 0),
                AngleArc(drive.u, (-R, 0), towards, towards + turned, 0.07),
                AngleArc(drive.u, (-R, 0), towards + turned, towards + 2 * turned, 0.06),
            ),
            robot(end, look="ghost"),
            Arrow("middle_heading", ORIGIN, end, "c"),
            Arrow("heading", halfway, point_of(halfway, 0.07), "θ_m"),
            Point("icr", (-R, 0), label="ICR"),
        ),
        handles=(Handle("the end", end, {omega: 2 * half / time, dt: time}),),
        readouts=(Readout(x_next), Readout(y_next), Readout(theta_next)),
    )  # fmt: skip


# Almost straight: lost digits.

FAST, SLANTED, LONG = 0.1, 1.0, 2.0  # m/s, rad, s: of the drive that is almost straight
LOST = symbols("x_lost y_lost")  # by the textbook's form, which loses digits
LEAST = 1e-18  # m: no error is drawn as this one


def almost_figure() -> Figure:
    """Draw the textbook's form and the chord, nearer and nearer to a straight line."""
    graph = Graph((0.25, 0.56, 0.02, 0.29), (1e-16, 1), (1e-18, 1), ("ω in rad/s", "error in m"))
    drive_on = {x: 0, y: 0, theta: SLANTED, v: FAST, dt: LONG}
    forms = (motion.arc_step.right, motion.arc_step.textbook)
    exact, textbook = (substitute(form, drive_on) for form in forms)
    tenth = 10**-s
    errors = Max(distance(*(substitute(form, {omega: tenth}) for form in (textbook, exact))), LEAST)
    dot = graph.place((omega, Max(distance(LOST, exact), LEAST)))
    return Figure(
        name="digits",
        title="Two robots, placed by the textbook's form and by the chord; the error against ω",
        view=(-0.09, 0.6, -0.12, 0.34),
        ground="paper",
        controls=(Slider(power, 0.0, 16.0, start=6.0, step=0.1, label="p, where ω = 1/10ᵖ rad/s"),),
        where=((omega, 10**-power), (v_L, FAST), (v_R, FAST), *zip(LOST, textbook, strict=False)),
        shapes=(
            Line("path", (ORIGIN, exact)),
            robot((0, 0, SLANTED), look="ghost"),
            robot(exact),
            robot((*LOST, exact[2]), look="wrong"),
            Line("error", (LOST, exact)),
            *graph.shapes(),
            Curve("approximation", graph.place((tenth, errors)), s, 0, power),
            Point("error", dot),
        ),
        handles=(Handle("the dot in the graph", dot, {power: -log(graph.x_at(POINTER), 10)}),),
        readouts=(
            Readout("after", "sin(θ + ωΔt)", sin(SLANTED + LONG * omega), digits=16),
            Readout("before", "sin θ", sin(SLANTED), digits=16),
            Readout("error", "error, textbook's form", distance(LOST, exact), "m", digits=-2),
        ),
        grid=False,
    )


DURATION = 6.0  # s, of the drive that is cut into steps


def steps_figure() -> Figure:
    """Draw one drive in n straight steps: the error against the step has slope 1, or slope 2."""
    graph = Graph((0.22, 0.58, 0.0, 0.28), (0.1, 10), (1e-6, 1), ("step Δt in s", "error in m"))
    exact, step = substitute(drive_for(DURATION), TWIST), DURATION / n
    straight = substitute(motion.euler_step.right, {**TWIST, dt: step})
    shapes, readouts, dots, ends = [], [], [], []
    half = TWIST[omega] * s / 2  # of the turn in a step s
    for kind, early, words in (("approximation", 0, "old"), ("middle_heading", 1, "middle")):
        state, end = (
            symbols(f"{x}_{early} {y}_{early} {turn}_{early}") for x, y, turn in ("xyt", "XYT")
        )
        turn = early * TWIST[omega] * step / 2
        to_next = substitute(straight, {x: state[0], y: state[1], theta: state[2] + turn})
        loop = Recurrence(state, START, (to_next[0], to_next[1], to_next[2] - turn), n, 60, end)
        # the steps' own chord: longer than the true one, and turned by the old heading
        long, turned = 1 / sinc(half), (1 - early) * half
        error = distance(exact, ORIGIN) * sqrt((long - 1) ** 2 + 4 * long * sin(turned / 2) ** 2)
        shapes += [
            Trail(kind, state, loop),
            Line("error", (end, exact)),
            Curve(kind, graph.place((s, error)), s, step, 3),
            Point(kind, graph.place((step, distance(end, exact))), words),
        ]
        ends.append(end)
        dots.append(graph.place((step, error.subs(s, step))))
        readouts += [
            Readout(f"error_{early}", f"error, {words} heading", distance(end, exact), "m", 5)
        ]
    return Figure(
        name="steps",
        title="A drive along an arc, cut into straight steps, and the error against the step",
        view=(-0.38, 0.62, -0.14, 0.36),
        ground="paper",
        controls=(Slider(n, 2, 60, start=3, step=1, label="number of steps n"),),
        where=tuple(SPEEDS.items()),
        shapes=(
            Curve("path", substitute(drive_for(s), TWIST), s, 0, DURATION),
            robot(START, look="ghost"),
            robot(exact),
            *graph.shapes(),
            *shapes,
        ),
        handles=(
            Handle("the upper dot in the graph", dots[0], {n: DURATION / graph.x_at(POINTER)}),
        ),
        readouts=tuple(readouts),
        goal=tuple(
            Goal(
                And(distance(end, exact) < 0.01, n < most),
                f"By the {words}: within 1 cm, in as few steps as you can.",
            )
            for end, most, words in ((ends[1], 5, "middle heading"), (ends[0], 46, "old heading"))
        ),
        grid=False,
    )


# Where it fails, and the laboratory.


def sideways_figure() -> Figure:
    """Draw a wished velocity, whose part along the axle cannot be had."""
    wished, ahead = (-ARROW * wish_y, ARROW * wish_x), (0, ARROW * wish_x)
    return Figure(
        name="sideways",
        title="The robot, a velocity that you wish, and what its wheels can do of it",
        view=(-0.26, 0.26, -0.14, 0.24),
        ground="tiles",
        controls=(
            Slider(wish_x, -0.08, 0.15, start=0.08, step=0.01, label="wish: ahead"),
            Slider(wish_y, -0.15, 0.15, start=0.1, step=0.01, label="wish: to the left"),
        ),
        where=((v, wish_x), (v_L, wish_x), (v_R, wish_x)),
        shapes=(
            Line("icr", ((-0.3, 0), (0.3, 0))),
            robot(START),
            Line("error", (ahead, wished)),
            Arrow("approximation", ORIGIN, wished, "wish"),
            Arrow(v, ORIGIN, ahead),
        ),
        handles=(
            Handle("the wish", wished, {wish_x: POINTER[1] / ARROW, wish_y: -POINTER[0] / ARROW}),
        ),
        readouts=(
            Readout(v, "what it can do: v"),
            Readout("lost", "what it cannot", wish_y, "m/s"),
        ),
        goal=Goal(And(Abs(wish_y) < 0.006, Abs(wish_x) > 0.02), "Wish for something it can do."),
    )


SIDE = (-0.2, 0, pi / 2)  # 20 cm to the left of the start, and no turn


def side_figure() -> Figure:
    """Draw the place at its side: turn, drive straight on, turn back; two seconds for each."""
    first, straight, last = (ramp(done, k) for k in range(3))
    heading = pi / 2 + aim
    end = (reach * cos(heading), reach * sin(heading), pi / 2)
    now = (straight * end[0], straight * end[1], pi / 2 + aim * (first - last))
    spin = aim * DISTANCE / 2  # by which the right wheel rolls in the first part
    return Figure(
        name="side",
        title="The robot, and a place at its side to which it drives in three parts",
        view=(-0.36, 0.22, -0.16, 0.26),
        ground="tiles",
        controls=(
            Slider.degrees(
                aim, -40, 110, start=30, step=5, label="first: turn; at the end turn back"
            ),
            Slider(reach, 0.02, 0.25, start=0.1, step=0.01, label="between: drive straight on"),
            Clock(
                done,
                0.0,
                3.0,
                step=0.02,
                label="how far: 1 turned, 2 there, 3 turned back",
                rate=0.5,
            ),
        ),
        where=tuple(
            (speed, Piecewise((turn, done < 1), (reach, done < 2), (-turn, True)) / 2)
            for speed, turn in ((v_L, -spin), (v_R, spin))
        ),
        shapes=(
            *mark(SIDE, end, "{off} off"),
            Line("icr", ((-0.4, 0), (0.3, 0))),
            robot(START, look="ghost"),
            Line("path", (ORIGIN, end)),
            robot(end, look="ghost"),
            robot(now, rolled=[reach * straight + side * (first - last) for side in (-spin, spin)]),
            *arrows(now, middle=False),
        ),
        handles=(
            Handle(
                "the end of the straight way",
                end,
                {
                    aim: atan2(-POINTER[0], POINTER[1]),
                    reach: sqrt(POINTER[0] ** 2 + POINTER[1] ** 2),
                },
            ),
        ),
        readouts=(Readout("off", "at the end: off the mark", distance(end, SIDE), "cm", 0),),
        goal=Goal(is_parked(end, SIDE), f"Find the way to the place at its side: within {OFF} cm."),
    )


BACK = {x: 0, y: 0, theta: pi / 2, **TWIST, omega: -TWIST[omega], dt: 5}  # to the other side
BAY = tuple(motion.arc_step.substitute(BACK).evalf(17))


def drive_figure() -> Figure:
    """Draw the laboratory: drive, follow, tracks of both wheels around one centre, park."""
    now = drive_for(t)
    centre = motion.icr.substitute({x: 0, y: 0, theta: pi / 2})
    return Figure(
        name="wheel-speeds",
        title="The robot in its laboratory, driven by two wheel speeds and a time",
        view=(-0.42, 0.38, -0.2, 0.28),
        ground="tiles",
        controls=(
            *speed_sliders(SPEEDS[v_L], SPEEDS[v_R], most=0.12, least=-0.12),
            Clock(t, 0.0, 12.0, start=2.0, label="time"),
        ),
        where=RADIUS_TOO,
        shapes=(
            *mark(BAY, now),
            *tracks(0, t),
            robot(START, look="ghost"),
            Line("icr", (now, centre)),
            robot(now, time=t),
            *arrows(now),
            *arrows(START, middle=False, letters=False),
            Point("icr", centre, label="ICR"),
        ),
        handles=tip_handles(),
        readouts=(
            Readout(v),
            Readout(omega),
            Readout(R, words=NO_ICR),
            Readout("x", "now at x", now[0], "m"),
            Readout("y", "now at y", now[1], "m"),
            Readout("heading", "heading now", now[2], "rad"),
            Readout("off", "to the bay", distance(now, BAY), "cm", 0),
            Readout("turned", "heading off by", angle_size(now[2] - BAY[2]), "rad", 0),
        ),
        goal=(
            Goal(And(Abs(v_L) < 0.0005, Abs(v_R) > 0.01), "Turn about the left wheel."),
            Goal(
                And(Abs(Abs(v_R) - TIMES * Abs(v_L)) < 0.002, Abs(v_L) > 0.01),
                f"Leave two tracks around one centre, the right one {TIMES} times as long.",
            ),
            Goal(
                is_parked(now, BAY),
                f"Park in the bay: within {OFF} cm and {TURNED}°, by two speeds and a time.",
            ),
        ),
        follow=now,
        size="laboratory",
    )


def damage_figure() -> Figure:
    """Draw the robot, and where a program with a mistake believes it to be."""
    speeds = {side: differential_drive_1.example[str(side)] for side in (v_L, v_R)}
    heading, right = float(differential_drive_2.example["theta"]), {**speeds, b: DISTANCE}
    rate = drive.turning_rate.substitute(right)
    wrong = {
        half_wheel_distance.title: (half_wheel_distance.substitute(right), heading),
        double_distance.title: (double_distance.substitute(right), heading),
        degrees_taken.title: (rate, degrees_taken.formula.replaced[theta].subs(theta, heading)),
        world_to_robot.title: (rate, world_to_robot.formula.replaced[theta].subs(theta, heading)),
    }
    options = {name: tuple(map(float, each)) for name, each in wrong.items()}
    seen, believed = (
        substitute(drive_for(s, (0, 0, look)), {v: drive.speed.substitute(right), omega: turn})
        for turn, look in ((rate, heading), (believed_rate, believed_heading))
    )
    now, there = (substitute(pose, {s: t}) for pose in (seen, believed))
    return Figure(
        name="damage",
        title="The robot, and where a program with a mistake believes it to be",
        view=(-0.3, 0.3, -0.23, 0.22),
        ground="tiles",
        controls=(
            Choice("mistake", "mistake", (believed_rate, believed_heading), options),
            Clock(t, 0.0, 2.0, start=1.5, loops=True, label="time"),
        ),
        where=tuple(speeds.items()),
        shapes=(
            Curve("path", seen, s, 0, t),
            Curve("approximation", believed, s, 0, t),
            Line("error", (now, there)),
            robot(now, time=t),
            robot(there, look="wrong"),
        ),
        readouts=(Readout("apart", "apart", distance(now, there), "m"),),
    )


def letters_figure() -> Figure:
    """Draw all of it at rest, with three letters that are to be put back."""
    end = drive_for(2.0)
    places = ((-R / 2, -0.06), (0.095, (v_L + v_R) / 2), (0.62 * end[0] - 0.02, 0.62 * end[1]))
    answers = dict(zip(("R", "ωb", "c"), places, strict=True))
    letters = put_back(quantity, ("θ", "ωb", "c", "R"), answers)
    return SCENE.figure(
        "letters",
        "The robot, the line through the tips of its arrows, the ICR, the arc and its chord",
        "axle tips robot wheels speed icr",
        view=(-0.26, 0.16, -0.11, 0.22),
        controls=letters.controls,
        where=(*SPEEDS.items(), *RADIUS_TOO),
        shapes=(
            way("path", 0, 2.0),
            robot(end, look="ghost"),
            Arrow("middle_heading", ORIGIN, end, ""),
            Length("icr", ORIGIN, (-R, 0), aside=0.045, label=""),
            Length(b, *RUN),
            Length("turning", *RISE, "", aside=-0.03),
            *letters.shapes,
        ),
        goal=letters.goal,
    )


FIGURES = (
    park_figure(),
    exercise_figure(),
    axle_figure(),
    still_figure(),
    tips_figure(),
    away_figure(),
    infinity_figure(),
    icr_figure(),
    world_figure(),
    added_figure(),
    rates_figure(),
    guess_figure(),
    spokes_figure(),
    arc_figure(),
    almost_figure(),
    steps_figure(),
    sideways_figure(),
    side_figure(),
    drive_figure(),
    damage_figure(),
    letters_figure(),
)
