"""The live figures of the chapter on the bicycle model: one car, and its long sister."""

from dataclasses import replace
from functools import partial
from typing import Any

from sympy import (
    Abs,
    And,
    Lt,
    Matrix,
    Max,
    Min,
    Ne,
    Or,
    Piecewise,
    Rational,
    Symbol,
    atan,
    atan2,
    cos,
    integrate,
    nan,
    oo,
    pi,
    sin,
    sinc,
    sqrt,
    symbols,
    tan,
)

from book import things
from book.bicycle import formulas as bicycle
from book.bicycle.exercises import (
    along_heading,
    front_speed_used,
    mean_angle,
    reversed_turn,
    same_sine,
    sines_only,
)
from book.bicycle.formulas import (
    R_F,
    ahead,
    alpha_L,
    alpha_R,
    arc_length,
    arm,
    arm_angle,
    aside,
    corner_cut,
    kappa,
    lane_width,
    rod_x,
    rod_y,
    slide_L,
    slide_R,
    steering,
    track,
    v_F,
    wheelbase,
    y_heading,
)
from book.differential_drive.figures import angle_size, guess_x, guess_y, n, t
from book.differential_drive.formulas import R
from book.frames.figures import point_of
from book.letters import put_back
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, theta_dot, theta_next, v, x, x_dot, y, y_dot
from book.things.graph import Graph, LinearGraph
from courseware.equations import declarations, substitute
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
    Point,
    Readout,
    Recurrence,
    Scene,
    Slider,
    Trail,
    assign,
    distance,
    ramp,
    when,
)

quantity, _ = declarations(__name__)

L, B = 2.5, 1.5  # m: wheelbase and track of the car, as in the exercise
CAR = {wheelbase: L, track: B}
UP = pi / 2  # rad, the heading of a car that looks up in the picture
START = (0, 0, UP)
LOCK = 35  # degrees: so far a driver can steer
DEGREE = pi / 180
STRAIGHT = {"inf": "∞"}
s = Symbol("s")

done = quantity("done", "", 0, 2, "how many of the two arcs are driven")
first_steering, second_steering = (
    quantity(f"steering_{k}", "rad", -1, 1, f"steering on the {name} arc")
    for k, name in ((1, "first"), (2, "second"))
)
first_way, second_way = (
    quantity(f"way_{k}", "m", 0, 6, f"how far back on the {name} arc")
    for k, name in ((1, "first"), (2, "second"))
)
together = quantity("together", "", 0, 1, "slid together, from 0 to 1")
place_x = quantity("place_x", "m", -1, 1, "a point of the car, to the right of P")
place_y = quantity("place_y", "m", -1, 4, "a point of the car, ahead of P")
way_driven = quantity("way_driven", "m", 0, 24, "the way that P has driven")
before = quantity("before", "m", 0, 10, "how far before the corner the turn begins")
parts = quantity("parts", "", 0, 3, "how many of the parts are driven")
is_long = quantity("is_long", "", 0, 1, "1 for the long vehicle, 0 for the car")
rear_way, front_way = (
    quantity(f"told_{k}", "", 0, 1, "1 where the pose is told so, else 0") for k in (1, 2)
)


# The car, and where it goes.


def angles(steered: Any, car: Any = CAR) -> Any:
    """Return the angles of both front wheels."""
    return bicycle.ackermann.substitute({**car, steering: steered})


def car(pose: Any, steered: Any = 0, rolled: Any = 0, look: str = "") -> Any:
    """Return the car, steered like a bicycle."""
    return things.car(pose, angles(steered), rolled, look, L, B)


def along(pose: Any, steered: Any, way: Any, long: Any = L) -> Any:
    """Return the pose after a way on one arc, exactly."""
    start = dict(zip((x, y, theta), pose, strict=True))
    return bicycle.arc_step.substitute({**start, kappa: tan(steered) / long, v: way, dt: 1})


def arc_to(pose: Any, place: Any, ahead: int = 1) -> tuple[Any, Any]:
    """Return the steering and the way of the arc to a place, ahead (1) or back (−1)."""
    dx, dy = place[0] - pose[0], place[1] - pose[1]
    far = ahead * (dx * cos(pose[2]) + dy * sin(pose[2]))
    left = dy * cos(pose[2]) - dx * sin(pose[2])
    half, chord = atan2(left, far), sqrt(far**2 + left**2)
    return atan(2 * L * sin(half) / chord), chord / sinc(half)


REAR, FRONT, WIDTH = -0.78, 3.3, 1.72  # m: ends of the body, from P, and its width


def corners(pose: Any, rear: float = REAR, front: float = FRONT, wide: float = WIDTH) -> list[Any]:
    """Return the corners of the car's outline, from the left rear one, and this one again."""
    sides = ((rear, 1), (rear, -1), (front, -1), (front, 1), (rear, 1))
    return [point_of(pose, forward, side * wide / 2) for forward, side in sides]


# Opening.

ALONGSIDE = (6.89, 3.05, 0)  # where it starts, beside the car in front of the gap
PLACE = (1.6, 1.05, 0)  # where P, the middle of the rear axle, is to be
OFF, TURNED = 10, 3  # cm, degrees: how far from its place the car still counts as parked
WIDE_OPEN, NARROW = (-0.3, 6.72), (1.0, 7.2)  # m: from where to where the gaps are free


def two_arcs(done: Any) -> Any:
    """Return the pose when so many of the two arcs back are driven."""
    turned = along(ALONGSIDE, first_steering, -first_way * ramp(done, 0))
    return along(turned, second_steering, -second_way * ramp(done, 1))


def second_end_stays() -> dict[Any, Any]:
    """Return what a hand at the end of the first arc sets, so that the second one's end stays."""
    wanted = zip(arc_to(ALONGSIDE, POINTER, -1), (LOCK * DEGREE, 5), (-LOCK * DEGREE, 0.5),
                 strict=True)  # fmt: skip
    steered, way = (Max(low, Min(high, value)) for value, high, low in wanted)
    rest = arc_to(along(ALONGSIDE, steered, -way), two_arcs(2), -1)
    arcs = (first_steering, first_way, second_steering, second_way)
    return dict(zip(arcs, (steered, way, *rest), strict=True))


def outside(place: Any, pose: Any) -> Any:
    """Return how far a place is outside the car, as a rectangle; below 0 inside of it."""
    # as written, which is quicker
    size, most, least, root = (partial(f, evaluate=False) for f in (Abs, Max, Min, sqrt))
    dx, dy = place[0] - pose[0], place[1] - pose[1]
    forward = dx * cos(pose[2]) + dy * sin(pose[2]) - (FRONT + REAR) / 2
    beyond = size(forward) - (FRONT - REAR) / 2
    beside = size(dy * cos(pose[2]) - dx * sin(pose[2])) - WIDTH / 2
    return root(most(beyond, 0) ** 2 + most(beside, 0) ** 2) + least(most(beyond, beside), 0)


EACH = 60  # poses on each arc at which the car is measured, at most 9 cm apart


def closest(gap: tuple[float, float]) -> Recurrence:
    """Return a loop along both arcs: the least distances so far, and where it first touches."""
    pose, k, hit = symbols("x_k y_k theta_k", real=True), Symbol("k"), Symbol("hit")
    least = symbols("front_k behind_k kerb_k", real=True)
    ends = symbols("x_e y_e theta_e k_e front behind kerb touched", real=True)
    steered = Piecewise((first_steering, k < EACH), (second_steering, True))
    way = Piecewise((first_way, k < EACH), (second_way, k < 2 * EACH), (0, True))
    parked = [(gap[1] - REAR, PLACE[1], 0), (gap[0] - FRONT, PLACE[1], 0)]
    near = [
        Min(*(outside(a, pose) for a in corners(other)[:4]),
            *(outside(a, other) for a in corners(pose)[:4]), evaluate=False)
        for other in parked
    ] + [Min(*(corner[1] for corner in corners(pose)[:4]), evaluate=False)]  # fmt: skip
    touches = And(hit > 2, Or(*(Lt(far, 0, evaluate=False) for far in near)))
    step = (*along(pose, steered, -way / EACH), k + 1,
            *(Min(a, b, evaluate=False) for a, b in zip(least, near, strict=True)),
            Piecewise((k / EACH, touches), (hit, True)))  # fmt: skip
    start = (*ALONGSIDE, 0, 9, 9, 9, 3)
    return Recurrence((*pose, k, *least, hit), start, step, 2 * EACH + 1, 2 * EACH + 1, ends)


def parking(gap: tuple[float, float], readouts: Any, goal: Any, **parts: Any) -> Figure:
    """Return a figure of a car beside a gap at the kerb, and two arcs back to set."""
    middle, end, now = two_arcs(1), two_arcs(2), symbols("x_now y_now theta_now")
    loop = closest(gap)
    *_, front, behind, kerb, touched = loop.ends
    free = And(front > 0, behind > 0, kerb > 0)
    shapes = (
        things.kerb((-1.6, 0, 0), 12.8),
        things.car((gap[0] - FRONT, PLACE[1], 0)),
        things.car((gap[1] - REAR, PLACE[1], 0)),
        *parts.pop("place", ()),
        Trail("approximation", point_of(loop.state[:3], 3.05, 0.72), loop, dots=False),  # it swings
        Curve("path", two_arcs(s), s, 0, 2),
        car(ALONGSIDE, look="ghost"),
        car(middle, first_steering, look="ghost"),
        car(end, second_steering, look="ghost"),
        car(now, Piecewise((first_steering, done < 1), (second_steering, True))),
        *parts.pop("marks", ()),
        Point("path", now),
        *when(
            touched <= 2,
            Line("error", tuple(corners(two_arcs(touched)))),
            Label("error", point_of(two_arcs(touched), 1.3), "touches here"),
        ),
    )
    return Figure(
        view=(-1.5, 11, -0.75, 4.9),
        ground="asphalt",
        size="laboratory",
        controls=(
            Slider.degrees(first_steering, -LOCK, LOCK, start=-12, label="first arc: steering"),
            Slider(first_way, 0.5, 5.0, start=2.0, step=0.05, label="first arc: how far back"),
            Slider.degrees(second_steering, -LOCK, LOCK, start=10, label="second arc: steering"),
            Slider(second_way, 0.5, 5.0, start=2.5, step=0.05, label="second arc: how far back"),
            Clock(done, 0.0, 2.0, step=0.02, loops=True, label="arcs driven", rate=0.5),
        ),
        where=tuple(zip(now, two_arcs(done), strict=True)),
        shapes=shapes,
        handles=(
            Handle("end of the first arc", middle, second_end_stays()),
            Handle(
                "end of the second arc",
                end,
                dict(zip((second_steering, second_way), arc_to(middle, POINTER, -1), strict=True)),
            ),
        ),
        readouts=readouts(end, front, behind, kerb),
        goal=Goal(And(free, goal[0](end, kerb)), goal[1]),
        **parts,
    )  # fmt: skip


def park_figure() -> Figure:
    """Draw the opening: a wide gap, a place in it, and how far off the end is."""
    return parking(
        WIDE_OPEN,
        lambda end, *_: (
            Readout("off", "at the end: off its place", distance(end, PLACE), "m", 2),
            Readout("turned", "at the end: turned by", angle_size(end[2]), "rad", 0),
        ),
        (
            lambda end, _: And(
                distance(end, PLACE) < OFF / 100, angle_size(end[2]) < TURNED * DEGREE
            ),
            f"Park in two arcs backwards: within {OFF} cm and {TURNED}°.",
        ),
        name="park-car",
        title="A car from above beside a gap at the kerb, and where two arcs backwards take it",
        place=(Area("target", tuple(corners(PLACE))), Line("target", tuple(corners(PLACE)))),
        marks=(Point("target", PLACE), Label("target", (3.4, 1.05), "park here")),
    )


def gap_figure() -> Figure:
    """Draw the narrow gap: how near the car comes to the two others and to the kerb."""
    touches = {"nan": "touches"}

    def clear(name: str, what: str, far: Any) -> Readout:
        value = Piecewise((far, far > 0), (nan, True))
        return Readout(name, f"clear of the {what} by", value, "m", 2, touches)

    return parking(
        NARROW,
        lambda end, front, behind, kerb: (
            clear("front", "car in front", front),
            clear("behind", "car behind", behind),
            clear("kerb", "kerb", kerb),
            Readout("turned", "at the end: turned by", angle_size(end[2]), "rad", 0),
        ),
        (
            lambda end, kerb: And(kerb < 0.3, angle_size(end[2]) < TURNED * DEGREE),
            f"Park in a gap of {NARROW[1] - NARROW[0]:.1f} m, touching nothing: less than 30 cm "
            f"from the kerb, within {TURNED}°.",
        ),
        name="narrow-gap",
        title="The car beside a narrow gap at the kerb, and where two arcs backwards take it",
        marks=(
            Length("length", (NARROW[0], -0.25), (NARROW[1], -0.25), ""),
            Label("text", (sum(NARROW) / 2, -0.52), f"{NARROW[1] - NARROW[0]:.1f} m"),
        ),
    )


# The scene: the car at its start, and what its wheels' axles say. P is the origin.

AXLE = ((-9, 0), (9, 0))
SPEED = 2.0  # m/s, of the rear axle, as in the exercise
BEND = 0.25  # 1/m: one over the turning radius of the exercise
TURN = {R: Piecewise((1 / kappa, Ne(kappa, 0)), (oo, True)), steering: atan(L * kappa)}
turns = Abs(kappa) > 1e-6
FRONTS = ((alpha_L, B / 2, "left"), (alpha_R, -B / 2, "right"))
HUBS = tuple((kind, point_of(START, ahead, left)) for _, left, kind in FRONTS for ahead in (0, L))


def circle(kind: Any, radius: Any, low: Any = 0, high: Any = 2 * pi) -> Curve:
    """Return a circle about the ICR, which is on the line of the rear axle."""
    at = (-R + radius * cos(s), radius * sin(s))
    return Curve(kind, tuple(Piecewise((each, turns), (nan, True)) for each in at), s, low, high)


def axle(kind: Any, hub: Any, angle: Any, long: float = 40) -> Line:
    """Return the line of a wheel's axle, far to both sides."""
    return Line(kind, tuple(point_of((*hub, UP + angle), 0, far) for far in (long, -long)))


def numbered_ruler(unit: float = L, count: int = 2) -> tuple[Any, ...]:
    """Return a ruler along the rear axle, counted in wheelbases to the left of P."""
    numbers = (Label("text", (-k * unit, -0.33 * unit), str(k)) for k in range(1, count + 1))
    return things.ruler((-count * unit, 0, 0), unit, count), *numbers


def lane_area(far: Any = 2 * pi, start: Any = 0, parts: int = 36) -> Area:
    """Return the lane of all wheels: the ring between the inner rear and the outer front wheel."""
    side = Piecewise((1, kappa >= 0), (-1, True))
    inner, outer = Abs(R) - B / 2, sqrt((Abs(R) + B / 2) ** 2 + L**2)
    steps = [start + far * Rational(k, parts) for k in range(parts + 1)]
    around = [(inner, a) for a in steps] + [(outer, a) for a in reversed(steps)]
    return Area("path", tuple((side * r * cos(a) - R, r * sin(a)) for r, a in around))


SCENE = Scene(
    layers={
        "lane": when(turns, lane_area()),
        "ruler": numbered_ruler(),
        "circles": tuple(circle(kind, distance((-R, 0), hub)) for kind, hub in HUBS),
        "axle": (Line("icr", AXLE),),
        "car": (things.car(START, (alpha_L, alpha_R), 0, "", L, B),),
        "bicycle": (things.bicycle_wheel((0, L, UP), steering),),
        "axles": tuple(axle(kind, point_of(START, L, left), alpha) for alpha, left, kind in FRONTS),
        "spokes": when(
            turns,
            *(Line(kind, ((-R, 0), point_of(START, L, left))) for _, left, kind in FRONTS),
        ),
        "middle": when(turns, Line("velocity", ((-R, 0), (0, L)))),
        "radius": when(turns, Length(R, (0, 0), (-R, 0), aside=0.75)),
        "icr": when(turns, Point("icr", (-R, 0), "ICR")),
        "P": (Point("path", (0, 0), "P"),),
    },
    handles={
        "icr": (Handle("the ICR", (-R, 0), {kappa: -1 / POINTER[0]}),),
        "wheels": tuple(
            Handle(
                f"the {kind} front wheel",
                point_of((*point_of(START, L, left), UP + alpha), 1.4),
                {alpha: atan2(-left - POINTER[0], POINTER[1] - L)},
            )
            for alpha, left, kind in FRONTS
        ),
    },
    common={
        "view": (-5.6, 2.4, -1.2, 4.0),
        "ground": "asphalt",
        "where": (*TURN.items(), (wheelbase, L), (track, B), *assign(bicycle.ackermann)),
        "controls": (Slider(kappa, 0.1, 0.45, start=BEND, step=0.01, label="one over R"),),
    },
)


# The exercise, and the steps.


def exercise_figure() -> Figure:
    """Draw the car of the exercise with all its symbols, at rest."""
    fronts = [
        AngleArc(alpha, (*point_of(START, L, left),), UP, UP + alpha, 1.0)
        for alpha, left, _ in FRONTS
    ]
    return SCENE.figure(
        "car-exercise",
        "A car from above that points up along the y axis, its front wheels turned to the left",
        "car bicycle P",
        view=(-4.2, 4.2, -2.0, 4.6),
        controls=(),
        where=((kappa, BEND), *TURN.items(), (wheelbase, L), (track, B), (v, SPEED),
               *assign(bicycle.ackermann)),
        shapes=(
            *fronts,
            AngleArc(steering, (0, L), UP, UP + steering, 1.25),
            Arrow(v, (0, 0), (0, SPEED), "v"),
            Point("path", (0, L), "O"),
            Length(wheelbase, (0, 0), (0, L), aside=-1.9, label="L = 2.5 m"),
            Length(track, (-B / 2, 0), (B / 2, 0), aside=-1.3, label="b = 1.5 m"),
        ),
    )  # fmt: skip


SLIDES = 8  # a slide is drawn so many times as long as it is for each metre


def axles_figure() -> Figure:
    """Draw both front wheels, each steered by itself: where the axles miss, tyres slide."""
    turned = Max(Abs(alpha_L), Abs(alpha_R)) > 10 * DEGREE
    slides: list[Any] = []
    for (alpha, left, _), slide in zip(FRONTS, (slide_L, slide_R), strict=True):
        hub = point_of(START, L, left)
        end = point_of((*hub, UP + alpha), 0, -SLIDES * slide)
        slides += when(Abs(slide) > 0.004, Line("error", (hub, end)))
    return SCENE.figure(
        "axles",
        "The car from above; the lines of its front axles meet the line of the rear axle",
        "axle car axles P",
        drag="wheels",
        view=(-5.6, 2.4, -1.2, 4.2),
        controls=(
            Slider.degrees(alpha_L, -45, 45, start=30, label="left wheel α_L"),
            Slider.degrees(alpha_R, -45, 45, start=30, label="right wheel α_R"),
        ),
        where=(
            (wheelbase, L),
            (track, B),
            *bicycle.levers,
            *assign(bicycle.least_scrub, bicycle.scrub),
            (R, Piecewise((1 / kappa, Ne(kappa, 0)), (oo, True))),
        ),
        shapes=(*slides, Point("icr", (-R, 0), "turns here")),
        readouts=(
            Readout("left_slide", "left tyre slides, each metre", slide_L, "cm", 1),
            Readout("right_slide", "right tyre slides, each metre", slide_R, "cm", 1),
            Readout(R, "turns about, to the left", digits=2, words=STRAIGHT),
        ),
        goal=Goal(
            And(turned, Max(Abs(slide_L), Abs(slide_R)) < 0.01),
            "Turn both by more than 10°, and let no tyre slide more than 1 cm a metre.",
        ),
    )


def circles_figure() -> Figure:
    """Draw the carrying picture: circles and spokes, the ICR under the hand, a ruler."""
    return SCENE.figure(
        "wheel-circles",
        "Circles about one point through the four wheels of a car, and a ruler in wheelbases",
        "lane ruler circles axle car spokes icr P",
        drag="icr",
        view=(-6.2, 2.8, -1.7, 4.0),
        shapes=(
            AngleArc(alpha_L, (-R, 0), 0, atan2(L, R - B / 2), 1.3),
            AngleArc(alpha_R, (-R, 0), 0, atan2(L, R + B / 2), 2.1),
            Length(R, (0, 0), (-R, 0), aside=1.3),
            Length(wheelbase, (0, 0), (0, L), aside=-1.3),
            Length(track, (B / 2, 0), (0, 0), aside=1.3, label="b/2"),
        ),
        readouts=(Readout(alpha_L), Readout(alpha_R), Readout(R)),
        goal=Goal(
            Abs(Abs(R) - 1.3 * L) < 0.05,
            f"Bring the ICR to 1.3 wheelbases, {1.3 * L:g} m, from P: within 5 cm.",
        ),
    )


CROSSINGS = (("left", alpha_L, B / 2), ("velocity", steering, 0), ("right", alpha_R, -B / 2))


def slide_figure() -> Figure:
    """Draw the proof: three front wheels slide into one, and their lines fan out evenly."""
    shapes: list[Any] = []
    for kind, alpha, left in CROSSINGS:
        at = left * (1 - together)
        hub, crossing = (-at, L), (-at - L / tan(alpha), 0)
        shapes += [
            Line(kind, (hub, crossing)),
            things.bicycle_wheel((*hub, UP), alpha, stripe=f"{kind}2"),
            Point(kind, crossing),
        ]
    handle = point_of((0, L, UP), 0, B / 2 * (1 - together))
    return SCENE.figure(
        "one-wheel",
        "Three front wheels of a car that slide together, their axle lines, and a ruler",
        "ruler axle P",
        view=(-5.7, 2.7, -1.15, 3.5),
        controls=(Slider(together, 0.0, 1.0, start=0.0, step=0.05, label="slid together"),),
        where=((kappa, BEND), *TURN.items(), (wheelbase, L), (track, B),
               *assign(bicycle.ackermann)),
        shapes=(car(START, atan(L * BEND), look="ghost"), *shapes),
        handles=(
            Handle("the left wheel", handle, {together: 1 + POINTER[0] / (B / 2)}),
        ),
        readouts=tuple(
            Readout(
                f"at_{k}", f"{name} line hits it at",
                (left * (1 - together) + L / tan(alpha)) / L, "", 2,
            )
            for k, (name, (_, alpha, left)) in enumerate(
                zip(("left", "middle", "right"), CROSSINGS, strict=True)
            )
        ),
    )  # fmt: skip


def world_figure() -> Figure:
    """Draw how P moves, and how the car turns about the ICR, in the axes of the world."""
    pose, end = (0, 0, theta), (x_dot, y_dot)
    centre = point_of(pose, 0, Piecewise((1 / kappa, Abs(kappa) > 0.01), (nan, True)))
    return Figure(
        name="car-world",
        title="A car in the axes of the world: the velocity of P, and its turn about the ICR",
        view=(-5.9, 5.9, -4.5, 4.5),
        ground="asphalt",
        controls=(
            Slider.degrees(theta, start=60, step=5),
            Slider.degrees(steering, -LOCK, LOCK, start=32, label="steering φ"),
        ),
        where=((v, SPEED), (wheelbase, L), (track, B), *assign(bicycle.world, bicycle.curvature),
               *assign(bicycle.turning_radius)),
        shapes=(
            Arrow("x_axis", (0, 0), (3.6, 0), "x"),
            Arrow("y_axis", (0, 0), (0, 3.3), "y"),
            *when(Abs(kappa) > 0.01, Line("icr", ((0, 0), centre))),
            car(pose, steering),
            AngleArc(theta, (0, 0), 0, theta, 1.2),
            things.bicycle_wheel((*point_of(pose, L), theta), steering),
            AngleArc(steering, point_of(pose, L), theta, theta + steering, 1.2),
            Line("ghost", ((x_dot, 0), end, (0, y_dot))),
            Arrow(v, (0, 0), end),
            *when(
                Abs(kappa) > 0.01,
                AngleArc(
                    omega, centre, atan2(-centre[1], -centre[0]),
                    atan2(-centre[1], -centre[0]) + theta_dot, 1.0, "in 1 s",
                ),
                Point("icr", centre, "ICR"),
            ),
            Point("path", (0, 0), "P"),
        ),
        handles=(Handle("tip of the velocity", end, {theta: atan2(POINTER[1], POINTER[0])}),),
        readouts=(Readout(x_dot), Readout(y_dot), Readout(theta_dot)),
    )  # fmt: skip


def points_figure() -> Figure:
    """Draw the velocity of any point of the car: at right angles to its line to the ICR."""
    speed = SPEED * BEND * sqrt((place_x + 1 / BEND) ** 2 + place_y**2)
    turned = SPEED * BEND
    end = (place_x - turned * place_y, place_y + SPEED + turned * place_x)
    slip = atan2(turned * place_y, SPEED + turned * place_x)
    return SCENE.figure(
        "every-point",
        "The car in a turn, and a point of it with its velocity and its line to the ICR",
        "axle car middle icr P",
        controls=(
            Slider(place_x, -0.86, 0.86, start=0.4, step=0.02, label="point: to the right"),
            Slider(place_y, -0.78, 3.3, start=1.2, step=0.02, label="point: ahead"),
        ),
        where=((kappa, BEND), *TURN.items(), (v, SPEED), (wheelbase, L), (track, B),
               *assign(bicycle.ackermann)),
        shapes=(
            Line("icr", ((-R, 0), (place_x, place_y))),
            Line("ghost", ((place_x, place_y), (place_x, place_y + SPEED))),
            Point("velocity", (0, L), "O"),
            Arrow("velocity", (place_x, place_y), end, "{speed}"),
            Point("target", (place_x, place_y)),
        ),
        handles=(Handle("the point", (place_x, place_y)),),
        readouts=(
            Readout("speed", "its speed", speed, "m/s"),
            Readout("slip", "its direction, from the heading", slip, "rad"),
        ),
        goal=Goal(
            And(speed < 1.6, place_x < -0.8),
            "Find the slowest point of the car: to 2 cm/s.",
        ),
    )  # fmt: skip


def ackermann_figure() -> Figure:
    """Draw one steering angle, and the two that a car makes of it."""
    middle = (0, L, UP + steering)
    return SCENE.figure(
        "ackermann-steering",
        "A car from above with the bicycle's wheel in its middle, the steering under your hand",
        "axle car bicycle axles middle radius icr P",
        controls=(Slider.degrees(steering, -60, 60, start=32, label="steering φ"),),
        where=((wheelbase, L), (track, B), *assign(bicycle.curvature, bicycle.turning_radius),
               *assign(bicycle.ackermann)),
        shapes=(AngleArc(steering, (0, L), UP, UP + steering, 1.1),),
        handles=(
            Handle(
                "the bicycle's wheel", point_of(middle, 1.1),
                {steering: atan2(-POINTER[0], POINTER[1] - L)},
            ),
        ),
        readouts=(Readout(alpha_L), Readout(alpha_R), Readout(R, words=STRAIGHT)),
    )  # fmt: skip


ARM = 0.2  # m, of a steering arm
NEAR = 0.75  # degrees: how far off Ackermann's angle the goal allows


def off_ackermann(inner: Any) -> Any:
    """Return how far the trapezoid's outer wheel is off, at an angle of the inner one."""
    given = {alpha_L: inner, arm: ARM, track: B}
    rods = [(symbol, substitute(step, given)) for symbol, step in bicycle.trapezoid.where]
    outer = substitute(bicycle.trapezoid.right, {**given, **dict(rods)})
    return outer - atan2(L * sin(inner), L * cos(inner) + B * sin(inner))


def trapezoid_figure() -> Figure:
    """Draw a real steering: two arms and a rod; how far its outer wheel is off Ackermann's."""
    left, right = (-B / 2, 0), (B / 2, 0)
    graph = LinearGraph((-1.2, 1.3, -1.5, -0.85), (0, 40 * DEGREE), (-1.5 * DEGREE, 4 * DEGREE))
    wanted, off = symbols("wanted off")
    arms = (
        (left, arm_angle + alpha_L - UP), (right, alpha_R - arm_angle - UP),
    )  # fmt: skip
    ends = [point_of((*hub, angle), ARM) for hub, angle in arms]
    grip, back = point_of((*left, arms[0][1]), 0.62), alpha_L - UP
    hubs = ((left, alpha_L, "left"), (right, alpha_R, "right"))
    return Figure(
        name="trapezoid",
        title="The front axle of a car: two wheels, an arm at each, and a rod between the arms",
        view=(-1.45, 1.45, -1.75, 0.75),
        ground="paper",
        controls=(
            Slider.degrees(alpha_L, 0, 40, start=0, label="inner wheel α_L"),
            Slider.degrees(arm_angle, 10, 25, start=12, step=0.5, label="arms point inwards by γ"),
        ),
        where=((arm, ARM), (track, B), (wheelbase, L), *bicycle.trapezoid.where,
               *assign(bicycle.trapezoid),
               (wanted, atan2(L * sin(alpha_L), L * cos(alpha_L) + B * sin(alpha_L))),
               (off, alpha_R - wanted)),
        shapes=(
            Line("body", (left, right)),
            *(
                things.wheel((*hub, UP + alpha), 0.66, 0.24, f"{kind}2")
                for hub, alpha, kind in hubs
            ),
            *(things.rod((*hub, angle), ARM) for hub, angle in arms),
            Line("path", tuple(ends)),
            Line("ghost", (ends[0], right)),
            Line("ghost", (left, point_of((*left, back), 0.62))),
            Line("length", (left, grip)),
            AngleArc(arm_angle, left, back, back + arm_angle, 0.55),
            Length(arm, left, ends[0], aside=-0.3),
            Length(rod_x, ends[0], (B / 2, ends[0][1]), aside=-0.33),
            Length(rod_y, (B / 2, ends[0][1]), right, aside=-0.5),
            Label("text", ((ends[0][0] + ends[1][0]) / 2, ends[0][1] - 0.11), "tie rod"),
            *(Line(kind, (hub, point_of((*hub, UP + alpha), 0.6))) for hub, alpha, kind in hubs),
            Line("ghost", (right, point_of((*right, UP + wanted), 0.75))),
            AngleArc("error", right, UP + wanted, UP + alpha_R, 0.62),
            *graph.shapes(
                "inner wheel", "outer wheel off by", {k * DEGREE: f"{k}°" for k in (0, 40)},
                {k * DEGREE: f"{k}°" for k in (0, 2, 4)},
            ),
            Curve("approximation", graph.place((s, off_ackermann(s))), s, 0, alpha_L),
            Point("error", graph.place((alpha_L, off))),
        ),
        handles=(
            Handle(
                "the inner wheel", point_of((*left, UP + alpha_L), 0.6),
                {alpha_L: atan2(left[0] - POINTER[0], POINTER[1])},
            ),
            Handle(
                "the arms", grip,
                {arm_angle: atan2(POINTER[1], POINTER[0] - left[0]) - back},
            ),
        ),
        readouts=(
            Readout("outer", "outer wheel, by the rods", alpha_R, "rad"),
            Readout("wanted", "outer wheel, by Ackermann", wanted, "rad"),
            Readout("off", "off by", off, "rad", 2),
        ),
        goal=Goal(
            And(*(Abs(off_ackermann(k * DEGREE)) < NEAR * DEGREE for k in (10, 20, 24, 30, 40))),
            f"Turn the arms until the outer wheel is at most {NEAR}° off, up to 40°.",
        ),
        grid=False,
    )  # fmt: skip


def guess_figure() -> Figure:
    """Draw a place to guess: where P will be after two seconds."""
    now = along(START, atan(L * BEND), SPEED * t)
    return Figure(
        name="guess-arc",
        title="The car of the exercise, and your guess of where its rear axle will be",
        view=(-5.6, 3.4, -1.2, 6.2),
        ground="asphalt",
        controls=(
            Slider(guess_x, -5.0, 2.5, start=1.5, step=0.05, label="x"),
            Slider(guess_y, -1.0, 5.5, start=4.5, step=0.05, label="y"),
            Clock(t, 0.0, 2.0, label="time"),
        ),
        where=((v, SPEED), (wheelbase, L), (steering, atan(L * BEND)), (theta, UP), (x, 0), (y, 0),
               (dt, 2.0), *assign(bicycle.curvature, bicycle.arc_step)),
        shapes=(
            car(START, steering, look="ghost"),
            Curve("path", along(START, steering, SPEED * s), s, 0, t),
            car(now, steering, SPEED * t),
            Arrow("x_axis", (-5.4, 0), (3.0, 0), "x"),
            Arrow("y_axis", (0, 0), (0, 5.9), "y"),
            *(Line("text", ((k, -0.1), (k, 0.1))) for k in (-4, -2, 2)),
            *(Label("text", (k, -0.45), f"{k} m".replace("-", "−")) for k in (-4, -2, 2)),
            *(Line("text", ((-0.1, k), (0.1, k))) for k in (2, 4)),
            Label("text", (0.5, 4), "4 m"),
            Arrow(v, (0, 0), (0, SPEED)),
            Point("path", now, "P"),
            Point("target", (guess_x, guess_y), "your guess"),
        ),
        handles=(Handle("your guess", (guess_x, guess_y)),),
    )  # fmt: skip


# The two errors of a step, and the long vehicle.

LENGTH, TRACK, RADIUS = 7.0, 1.5, 0.25  # m: wheelbase, between the wheels, of a wheel
LONG = {wheelbase: LENGTH, track: TRACK}
PACE, THIRTY = 2.0, pi / 6  # m/s, rad: how the long vehicle drives and steers
DURATION = 10.0  # s, of the drive that is cut into steps
SMALL = 0.35  # times as large as it is, that drive is drawn


def swept_by(far: Any) -> Area:
    """Return the long vehicle's lane on an arc to the left: inner rear and outer front wheel."""
    ways = [far * Rational(k, 24) for k in range(25)]
    inner, outer = (
        [point_of(along(START, steering, way, LENGTH), ahead, left) for way in ways]
        for ahead, left in ((0, TRACK / 2), (LENGTH, -TRACK / 2))
    )
    return Area("path", (*inner, *reversed(outer)))


def long_car(pose: Any, steered: Any, rolled: Any = 0, look: str = "") -> Any:
    """Return the long vehicle, steered like a bicycle."""
    return things.bus(pose, angles(steered, LONG), rolled, look, LENGTH, TRACK)


def steps_figure() -> Figure:
    """Draw the drive of O in n straight steps: errors of one step, slope 2, and of all, slope 1."""
    graph = Graph((5.6, 11.6, -1.4, 10.6), (0.1, 10), (1e-3, 10), ("step in s", "error in m"))
    exact, step = along(START, THIRTY, PACE * DURATION, LENGTH), DURATION / n
    rate, speed = PACE / LENGTH * tan(THIRTY), PACE / cos(THIRTY)
    state, ends = symbols("x_k y_k theta_k"), symbols("x_n y_n theta_n")
    velocity = bicycle.front_world.substitute(
        {theta: state[2], v: PACE, steering: THIRTY, wheelbase: LENGTH}
    )
    straight = [a + b * step for a, b in zip(state, (*velocity, rate), strict=True)]
    loop = Recurrence(state, (0, LENGTH, UP), tuple(straight), n, 40, ends)
    half = rate * s / 2  # of the turn in a step s
    # the steps' own chord: longer than the true one, and turned by the old heading
    long, chord = 1 / sinc(half), 2 * speed / rate * Abs(sin(rate * DURATION / 2))
    of_all = chord * sqrt((long - 1) ** 2 + 4 * long * sin(half / 2) ** 2)
    of_one = speed * s * sqrt((1 - sinc(half)) ** 2 + 4 * sinc(half) * sin(half / 2) ** 2)
    one = of_one.subs(s, step)

    def small(pose: Any, forward: float = 0) -> tuple[Any, Any, Any]:
        """Draw the drive small, beside the graph."""
        at = point_of(pose, forward)
        return SMALL * at[0], SMALL * at[1], pose[2]

    end = point_of(exact, LENGTH)
    return Figure(
        name="bicycle-steps",
        title="A long vehicle on its arc, the same drive in straight steps, and both errors",
        view=(-8.8, 12.8, -4.0, 12.2),
        ground="paper",
        controls=(Slider(n, 1, 40, start=10, step=1, label="number of steps"),),
        shapes=(
            Curve("path", small(along(START, THIRTY, PACE * s, LENGTH), LENGTH), s, 0, DURATION),
            replace(long_car(START, THIRTY, look="ghost"), size=SMALL),
            replace(long_car(small(exact), THIRTY), size=SMALL),
            Point("path", small(START, LENGTH), "O"),
            *graph.shapes(),
            Trail("approximation", small(state), loop),
            Line("error", (small(exact, LENGTH), small(ends))),
            Curve("approximation", graph.place((s, of_all)), s, 0.25, 10),
            Curve("old_heading", graph.place((s, of_one)), s, 0.25, 10),
            Point("approximation", graph.place((step, distance(ends, end))), "all steps"),
            Point("old_heading", graph.place((step, one)), "one step"),
        ),
        handles=(
            Handle(
                "the upper dot in the graph", graph.place((step, of_all.subs(s, step))),
                {n: DURATION / graph.x_at(POINTER)},
            ),
        ),
        readouts=(
            Readout("one", "error of one step", one, "m"),
            Readout("apart", "error at the end", distance(ends, end), "m"),
        ),
        grid=False,
    )  # fmt: skip


def conventions_figure() -> Figure:
    """Draw one vehicle whose pose is told in two ways."""
    pose = along((0, -LENGTH, UP), THIRTY, PACE * t, LENGTH)  # O starts at the origin
    front = point_of(pose, LENGTH)
    here = tuple(rear_way * a + front_way * b for a, b in zip(pose, front, strict=False))
    compass = UP - pose[2]
    return Figure(
        name="conventions",
        title="The long vehicle in a turn, its pose told from the rear or from the front axle",
        view=(-15.5, 11, -9.2, 8.8),
        ground="asphalt",
        controls=(
            Choice.one_hot(
                "told", (rear_way, front_way),
                ("P, θ from x", "O, ψ from y"), label="pose given by",
            ),
            Clock(t, 0.0, 4.0, start=2.0, label="time, at 2 m/s"),
        ),
        shapes=(
            Arrow("x_axis", (0, 0), (4, 0), "x"),
            Arrow("y_axis", (0, 0), (0, 6.5), "y"),
            long_car(pose, THIRTY, PACE * t),
            Line("ghost", (here, (here[0] + 5 * rear_way, here[1] + 5 * front_way))),
            *when(rear_way > 0, AngleArc(theta, here, 0, pose[2], 2.5)),
            *when(front_way > 0, AngleArc(y_heading, here, UP, pose[2], 2.5)),
            Point("path", pose, "P"),
            Point("velocity", front, "O"),
            Point("target", here),
        ),
        readouts=(
            Readout("x", "x", here[0], "m", 2),
            Readout("y", "y", here[1], "m", 2),
            Readout("heading", "heading", rear_way * pose[2] + front_way * compass, "rad"),
        ),
    )  # fmt: skip


def lane_figure() -> Figure:
    """Draw the long vehicle in a turn, the lane of its wheels, and the triangle that explains."""

    def at(way: Any, forward: Any, left: Any) -> tuple[Any, Any]:
        return point_of(along(START, steering, way, LENGTH), forward, left)

    side, far = TRACK / 2, 24
    return Figure(
        name="swept-lane",
        title="A long vehicle in a turn, the lane that its wheels need, and a right triangle",
        view=(-22, 5, -3.4, 17.4),
        ground="asphalt",
        controls=(
            Slider.degrees(steering, 24, 45, start=30, label="steering φ"),
            Clock(way_driven, 0.0, 24.0, step=0.2, label="driven", rate=4),
        ),
        where=((wheelbase, LENGTH), (track, TRACK), *assign(bicycle.turning_radius),
               *assign(bicycle.front_radius, bicycle.lane, bicycle.cut)),
        shapes=(
            swept_by(far),
            Curve("left", at(s, 0, side), s, 0, far),
            Curve("right", at(s, LENGTH, -side), s, 0, far),
            Line("icr", ((0, 0), (-R, 0))),
            Line(R_F, ((-R, 0), (0, LENGTH))),
            long_car(along(START, steering, way_driven, LENGTH), steering, way_driven),
            Length(R, (0, 0), (-R, 0), aside=0.6),
            Length(wheelbase, (0, 0), (0, LENGTH), aside=-2.2),
            Label(R_F, (-R / 2, LENGTH / 2 + 0.9)),
            Length(lane_width, (-R, R - side), (-R, sqrt((R + side) ** 2 + LENGTH**2))),
            Length(corner_cut, (0, 0), (R_F - R, 0), aside=-1.8),
            Point("icr", (-R, 0), "ICR"),
        ),
        readouts=(
            Readout(lane_width, "width of the lane w", digits=2),
            Readout(R, digits=2),
            Readout(R_F, digits=2),
        ),
        goal=Goal(
            Abs(lane_width - 3) < 0.06, "Steer for a lane of 3 m: within 6 cm."
        ),
    )  # fmt: skip


# Where it fails, and the laboratory.


def under_figure() -> Figure:
    """Draw the ICR as it comes near, reaches the inner rear wheel, and goes under the car."""
    return SCENE.figure(
        "centre-under",
        "The car with its front wheels turned far, all axle lines, and the ICR near the rear axle",
        "axle car bicycle axles icr P",
        view=(-5.0, 3.8, -1.1, 3.8),
        controls=(Slider.degrees(steering, -85, 85, start=55, label="steering φ"),),
        where=((wheelbase, L), (track, B), *assign(bicycle.curvature, bicycle.turning_radius),
               *assign(bicycle.ackermann, bicycle.lane)),
        readouts=(
            Readout(alpha_L),
            Readout(R, words=STRAIGHT),
            Readout(lane_width, "width of the lane", digits=2, words={"nan": "no lane"}),
        ),
        goal=Goal(
            And(Abs(R - B / 2) < 0.03), "Bring the ICR to the left rear wheel: within 3 cm."
        ),
    )  # fmt: skip


def sideways_figure() -> Figure:
    """Draw two arcs and a straight way back: what is gained sideways, against the arcs' length."""
    graph = LinearGraph((4.2, 11.4, 0.4, 6.4), (0, 2), (0, 1))
    steered = atan(L * BEND)
    turned = along(START, steered, arc_length * ramp(parts, 0))
    there = along(turned, -steered, arc_length * ramp(parts, 1))
    forth = 2 * sin(BEND * arc_length) / BEND
    now = along(there, 0, -forth * ramp(parts, 2))
    gain = bicycle.sideways.substitute({kappa: BEND, arc_length: s})
    dot = graph.place((arc_length, aside))
    return Figure(
        name="sideways-car",
        title="A car that goes two arcs ahead and straight back, and what it gains sideways",
        view=(-3.0, 12.2, -1.9, 7.5),
        ground="paper",
        controls=(
            Slider(arc_length, 0.2, 2.0, start=1.6, step=0.1, label="each arc s"),
            Clock(parts, 0.0, 3.0, step=0.02, start=3.0, label="parts driven", rate=0.6),
        ),
        where=((kappa, BEND), *assign(bicycle.sideways)),
        shapes=(
            car(START, look="ghost"),
            Curve("path", along(along(START, steered, arc_length * ramp(s, 0)), -steered,
                                arc_length * ramp(s, 1)), s, 0, 2),
            Line("path", ((-aside, forth), (-aside, 0))),
            car(now, Piecewise((steered, parts < 1), (-steered, parts < 2), (0, True))),
            Length(aside, (0, 0), (-aside, 0), aside=1.15),
            *graph.shapes("arc s in m", "gain d in m", {k: str(k) for k in (0, 1, 2)},
                          {0.25: "0.25", 1: "1"}),
            Curve("approximation", graph.place((s, gain)), s, 0.01, 2.0),
            Point("target", dot),
        ),
        handles=(Handle("the dot in the graph", dot, {arc_length: (POINTER[0] - 4.2) / 3.6}),),
        readouts=(Readout(aside, "gain sideways d", digits=2),),
        grid=False,
    )  # fmt: skip


KERBS = 9.5  # m, between the kerbs of the street
LANE = 3.0  # m, of the second task; to turn in it takes nearly the whole way of the clock


def lab_figure() -> Figure:
    """Draw the laboratory: a car or a long vehicle, driven on one arc between two kerbs."""
    long = (1 - is_long) * L + is_long * LENGTH
    now = along(START, steering, way_driven, long)
    steered = bicycle.ackermann.substitute({track: B, wheelbase: long})
    curb = B / 2 + 0.1  # where the right kerb is, beside the car at its start
    wheel_radius = sqrt((Abs(R) + B / 2) ** 2 + long**2)
    inside = R + wheel_radius < KERBS - curb
    street = wheel_radius + Abs(R) + B / 2  # from the outer rear wheel to the outer front wheel
    shown = [
        *when(is_long < 0.5, things.car(now, steered, way_driven, "", L, B)),
        *when(is_long > 0.5, things.bus(now, steered, way_driven, "", LENGTH, TRACK)),
    ]
    tracks = [
        Curve(
            kind, point_of(along(START, steering, s, long), ahead, side * B / 2), s, 0, way_driven
        )
        for kind, ahead, side in (("left", 0, 1), ("right", long, -1))
    ]
    return Figure(
        name="car-laboratory",
        title="A street from above with two kerbs, and a car or a long vehicle that turns in it",
        view=(-16.5, 7.0, -3.4, 11.8),
        contain=((-10, -2), (2, 9), *(point_of(now, forward * long) for forward in (-0.4, 1.4))),
        ground="asphalt",
        size="laboratory",
        controls=(
            Choice("vehicle", "vehicle", (is_long,), {"car, L 2.5 m": (0,), "long, L 7 m": (1,)}),
            Slider.degrees(steering, -LOCK, LOCK, start=20, label="steering φ"),
            Clock(way_driven, 0.0, 24.0, step=0.1, start=5.0, label="driven", rate=4),
        ),
        where=((wheelbase, long), (track, B), *assign(bicycle.turning_radius, bicycle.lane)),
        shapes=(
            *when(
                is_long < 0.5,
                things.kerb((curb, -30, UP), 60, 2, pavement=20),
                things.kerb((curb - KERBS, 30, -UP), 60, 2, pavement=20),
            ),
            *when(And(is_long > 0.5, steering > 0), swept_by(way_driven)),
            *tracks,
            *shown,
            Point("icr", (-R, 0), "ICR"),
        ),
        readouts=(
            Readout(R, digits=2, words={"inf": "none: straight ahead"}),
            Readout("street", "a half turn needs a street of", street, "m", 2,
                    {"inf": "none: straight ahead"}),
            Readout(lane_width, "width of the lane", digits=2),
            Readout("heading", "turned by", now[2] - UP, "rad", 0),
        ),
        goal=(
            Goal(
                And(is_long < 0.5, Abs(now[2] - UP - pi) < 4 * DEGREE, inside, R > 0),
                f"Turn the car round, by 180° within 4°, between kerbs {KERBS} m apart.",
            ),
            Goal(
                And(is_long > 0.5, Abs(Abs(now[2] - UP) - UP) < 3 * DEGREE,
                    lane_width < LANE + 0.02),
                f"Turn the long vehicle by 90°, within 3°, in a lane of {LANE:.0f} m.",
            ),
        ),
    )  # fmt: skip


STREET = 7.0  # m wide, with a right-angled corner
NOSE, SIDE = LENGTH + 0.95, TRACK / 2 + 0.13  # m: of the long vehicle's body, from P


def corner_figure() -> Figure:
    """Draw the long vehicle that goes round a corner: where it begins, and how far it steers."""
    half, back, outer = STREET / 2, 12.0, Symbol("outer", real=True)
    curb = (-half, 0)  # the corner within
    begin = (0, -before, UP)
    quarter = pi / 2 * R
    turned = along(begin, steering, quarter * ramp(parts, 1), LENGTH)
    now = along(
        (turned[0], turned[1] - (back - before) * (1 - ramp(parts, 0)), turned[2]),
        0, 6 * ramp(parts, 2), LENGTH,
    )  # fmt: skip
    cut = distance((-R, -before), curb) - (R - SIDE)
    over = outer - before - STREET
    way = along(begin, steering, s, LENGTH)
    return Figure(
        name="street-corner",
        title="Two streets that meet at a right angle, and a long vehicle that turns left",
        view=(-20, 6.5, -13.5, 8.5),
        ground="asphalt",
        controls=(
            Slider(before, 0.0, 10.0, start=8.0, step=0.1, label="P turns before the corner, by"),
            Slider.degrees(steering, 15, 45, start=38, label="steering φ"),
            Clock(parts, 0.0, 3.0, step=0.02, start=1.5, label="parts driven", rate=0.5),
        ),
        where=((wheelbase, LENGTH), (track, TRACK), *assign(bicycle.turning_radius),
               (outer, sqrt((R + SIDE) ** 2 + NOSE**2))),
        shapes=(
            things.kerb((-25, 0, 0), 25 - half, 3, pavement=30),
            things.kerb((*curb, -UP), 15, 3, pavement=1),
            things.kerb((half, -15, UP), 15 + STREET, 3, pavement=9),
            things.kerb((half + 9, STREET, pi), 40, 3, pavement=9),
            Curve("left", point_of(way, 0, SIDE), s, 0, quarter),
            Curve("right", point_of(way, NOSE, -SIDE), s, 0, quarter),
            Length("length", (0, -before), (0, 0), "", aside=-1.8),
            long_car(now, Piecewise((steering, And(parts > 1, parts < 2)), (0, True))),
            *when(cut > 0, Point("error", curb, "side over the kerb")),
            *when(over > 0, Point("error", (-R, outer - before), "front over the kerb")),
        ),
        readouts=(
            Readout("cut", "inner side over the kerb by", Max(cut, 0), "m", 2),
            Readout("over", "outer front over the kerb by", Max(over, 0), "m", 2),
        ),
        goal=Goal(
            And(cut < 0, over < 0), f"Go round the corner of two streets, each {STREET:g} m wide."
        ),
    )  # fmt: skip


SHORT, WIDE = 2.5, 2.0  # m: the car of the mistakes, wider than the other
MISTAKES = symbols("mistake:6", real=True)  # 1 for the one that is made, else 0


def pose_by_mistake(time: Any) -> dict[str, Any]:
    """Return the rear axle's pose by each mistake, and whether it is one of the front axle."""
    car = {wheelbase: SHORT, v: PACE, v_F: PACE / cos(steering)}
    steered = (substitute(each, {**car, track: WIDE}) for each in bicycle.ackermann.right)
    alone = mean_angle.substitute(dict(zip((alpha_L, alpha_R), steered, strict=True)))
    rate, front = PACE / SHORT * tan(steering), point_of(START, SHORT, 0)
    turned = UP + rate * time

    def turning(rate: Any) -> Any:
        arc = motion.arc_step.substitute({x: 0, y: 0, theta: UP, v: PACE, omega: rate, dt: time})
        return (*arc, 0)

    def leading(mistake: Any) -> Any:
        way = (integrate(u, (theta, UP, turned)) / rate for u in mistake.substitute(car))
        there = (a + b for a, b in zip(front, way, strict=True))
        return (*point_of((*there, turned), -SHORT, 0), turned, 1)

    return {
        sines_only.title: (
            *sines_only.substitute({R: PACE / rate, theta: UP, theta_next: turned}),
            turned,
            0,
        ),
        front_speed_used.title: turning(front_speed_used.substitute(car)),
        along_heading.title: leading(along_heading),
        same_sine.title: leading(same_sine),
        mean_angle.title: turning(PACE / SHORT * tan(alone)),
        reversed_turn.title: turning(-reversed_turn.substitute({**car, y_heading: 0, dt: 1})),
    }


def mistakes_figure() -> Figure:
    """Draw a car in a left turn, and where a program with a mistake believes it to be."""
    here, there = symbols("x_t y_t theta_t", real=True), symbols("x_b y_b theta_b", real=True)
    poses = pose_by_mistake(t)
    true = along(START, steering, PACE * t)
    wrong = Matrix([list(pose) for pose in poses.values()]).T * Matrix(MISTAKES)
    point, ghost = (point_of(pose, SHORT * ahead, 0) for pose in (here, there))
    ways = (tuple(point_of(pose.subs(t, s)[:3], SHORT * ahead, 0)) for pose in (true, wrong))
    steered = angles(steering, {wheelbase: SHORT, track: WIDE})
    return Figure(
        name="wrong-car",
        title="A car, and where a program with a mistake believes it to be",
        view=(-9.2, 6.4, -4.1, 5.7),
        ground="asphalt",
        controls=(
            Choice.one_hot("mistake", MISTAKES, poses, start=front_speed_used.title),
            Slider.degrees(steering, 35, 60, start=55, label="steering φ"),
            Clock(t, 0.0, 3.0, start=3.0, loops=True, label="time, at 2 m/s"),
        ),
        where=(*zip(here, true, strict=True), *zip((*there, ahead), wrong, strict=True)),
        shapes=(
            *(Curve(*way, s, 0, t) for way in zip(("path", "approximation"), ways, strict=True)),
            things.car(here, steered, PACE * t, "", SHORT, WIDE),
            things.car(there, steered, PACE * t, "wrong", SHORT, WIDE),
            Line("error", (point, ghost)),
            Point("approximation", ghost, "believed"),
        ),
        readouts=(
            Readout("apart", "apart", distance(ghost, point), "m", digits=2),
            Readout("off", "heading off by", motion.wrap(there[2] - here[2]), "rad", digits=0),
        ),
    )


def recap_figure() -> Figure:
    """Draw all of it at rest: circles, spokes, ruler, lane."""
    return SCENE.figure(
        "car-summary",
        "A car in a turn: circles of its wheels, spokes to the ICR, a ruler, and the lane",
        "lane ruler circles axle car spokes middle icr P",
        view=(-6.2, 2.6, -1.2, 4.2),
        controls=(),
        where=((kappa, BEND), *TURN.items(), (wheelbase, L), (track, B),
               *assign(bicycle.ackermann)),
    )  # fmt: skip


def letters_figure() -> Figure:
    """Draw the car with two letters that are to be put back."""
    answers = {"R": (-2.0, -0.55), "φ": (-0.42, 3.75)}
    letters = put_back(quantity, ("φ", "L", "R", "b"), answers)
    return SCENE.figure(
        "car-letters",
        "A car in a turn with the bicycle's wheel and the ICR, and the numbers 1 and 2",
        "axle car bicycle middle icr P",
        view=(-6.7, 3.9, -1.1, 3.95),
        controls=letters.controls,
        where=((kappa, BEND), *TURN.items(), (wheelbase, L), (track, B),
               *assign(bicycle.ackermann)),
        shapes=(
            Length("icr", (0, 0), (-R, 0), aside=0.35, label=""),
            AngleArc("velocity", (0, L), UP, UP + steering, 1.1, label=""),
            Line("ghost", ((0, L), (0, L + 1.3))),
            *letters.shapes,
        ),
        goal=letters.goal,
    )  # fmt: skip


FIGURES = (
    park_figure(),
    exercise_figure(),
    axles_figure(),
    circles_figure(),
    slide_figure(),
    world_figure(),
    points_figure(),
    ackermann_figure(),
    trapezoid_figure(),
    guess_figure(),
    steps_figure(),
    conventions_figure(),
    lane_figure(),
    under_figure(),
    sideways_figure(),
    lab_figure(),
    corner_figure(),
    gap_figure(),
    mistakes_figure(),
    letters_figure(),
    recap_figure(),
)
