"""The live figures of the chapter on the bicycle model."""

from typing import Any

from sympy import (
    Abs,
    Matrix,
    Piecewise,
    Symbol,
    atan2,
    cos,
    integrate,
    nan,
    pi,
    sign,
    sin,
    sqrt,
    symbols,
    tan,
)

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
    ahead,
    alpha_L,
    alpha_R,
    rate_rear,
    steering,
    track,
    v_F,
    wheelbase,
    y_heading,
)
from book.differential_drive.figures import n, t
from book.differential_drive.formulas import R, r
from book.frames.figures import point_of
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, theta_next, v, x, y
from courseware.equations import as_written, substitute
from courseware.figures import (
    POINTER,
    AngleArc,
    Area,
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
    Wheel,
    distance,
)

UP = pi / 2  # rad, the heading of a car that looks up in the picture
NO_ICR = {"inf": "none: straight ahead"}
NO_LANE = {"nan": "no lane: the car turns about a point under itself"}
s = Symbol("s")

radius = bicycle.turning_radius.right
angles = bicycle.ackermann.right


def to_pointer(pose: Any) -> Any:
    """Return the steering angle of a front wheel that points from the front axle to the pointer."""
    fx, fy = point_of(pose, wheelbase, 0)
    dx, dy = POINTER[0] - fx, POINTER[1] - fy
    heading = pose[2]
    return atan2(dy * cos(heading) - dx * sin(heading), dx * cos(heading) + dy * sin(heading))


START = (0, 0, UP)
TIP = 1.8  # m, from the front axle to the handle that steers
WHEEL = {"length": 0.7, "width": 0.22}  # m


def axle(kind: str, at: tuple[Any, Any], angle: Any) -> Line:
    """Return the line of a wheel's axle, far to both sides."""
    away = (30 * sin(angle), -30 * cos(angle))
    return Line(kind, ((at[0] - away[0], at[1] - away[1]), (at[0] + away[0], at[1] + away[1])))


def ackermann_figure() -> Figure:
    """Draw the steering: both front wheels, the bicycle between them, axles and ICR."""
    left, right = point_of(START, wheelbase, track / 2), point_of(START, wheelbase, -track / 2)
    middle = point_of(START, wheelbase, 0)
    tip = point_of(START, wheelbase + TIP * cos(steering), TIP * sin(steering))
    back = bicycle.equivalent_steering.substitute({alpha_L: angles[0], alpha_R: angles[1]})
    return Figure(
        name="ackermann-steering",
        title="A car from above with the bicycle that turns like it, the steering under your hand",
        view=(-6.4, 6.4, -1.3, 5.1),
        size="laboratory",
        controls=(
            Slider.degrees(
                steering, -80, 80, start=30,
                label="steering φ of the bicycle", kind="velocity",
            ),
            Slider(wheelbase, 1.5, 3.0, start=2.5, step=0.1, label="wheelbase L"),
            Slider(track, 0.8, 2.2, start=1.5, step=0.1, label="track b"),
        ),
        shapes=(
            axle("icr", (0, 0), UP),
            axle("left", left, UP + angles[0]),
            axle("right", right, UP + angles[1]),
            axle("ghost", middle, UP + steering),
            Line("body", (point_of(START, 0, -track / 2), point_of(START, 0, track / 2))),
            Line("body", (right, left)),
            Line("body", ((0, 0), middle)),
            Wheel("left", point_of(START, 0, track / 2), UP, **WHEEL),
            Wheel("right", point_of(START, 0, -track / 2), UP, **WHEEL),
            Wheel("left", left, UP + angles[0], **WHEEL),
            Wheel("right", right, UP + angles[1], **WHEEL),
            Wheel("body", (0, 0), UP, **WHEEL),
            Wheel("body", middle, UP + steering, **WHEEL),
            AngleArc("body", middle, UP, UP + steering, 1.2),
            Line("ghost", (middle, point_of(START, wheelbase + TIP, 0))),
            Arrow("velocity", middle, tip, label="φ"),
            Point("icr", (-radius, 0), label="ICR"),
        ),
        handles=(Handle("direction of the front wheel", tip, {steering: to_pointer(START)}),),
        readouts=(
            Readout("left", "left wheel α_L", angles[0], "rad", digits=2),
            Readout("right", "right wheel α_R", angles[1], "rad", digits=2),
            Readout("mean", "their mean", (angles[0] + angles[1]) / 2, "rad", digits=2),
            Readout("tangent", "2 / (cot α_L + cot α_R)", back, "", digits=4),
            Readout("radius", "turning radius R", radius, "m", digits=2, words=NO_ICR),
        ),
        sentence=(
            "Steered {steering}, the left front wheel stands at {left}, the right one at {right}; "
            "the mean of the two is {mean}. The turning radius is {radius}."
        ),
    )  # fmt: skip


# --- The vehicle of seed 004 ------------------------------------------------------------------

LENGTH, TRACK, RADIUS = 7.0, 1.5, 0.25  # m: chassis, between the wheels, of a wheel
DURATION = 10.0  # s, of the drive that is cut into steps


def loop_figure() -> Figure:
    """Draw one drive of the long car in n straight steps beside the exact arc."""
    speed = bicycle.rear_speed.substitute({r: RADIUS})
    heading = UP - y_heading
    start = point_of((0, 0, heading), -ahead * LENGTH, 0)  # of the rear axle
    given = {v: speed, wheelbase: LENGTH}
    state = symbols("x_k y_k theta_k")
    end = symbols("x_n y_n theta_n")

    def exact(time: Any) -> tuple[Any, Any]:
        pose = {x: start[0], y: start[1], theta: heading}
        arc = bicycle.arc_step.substitute({**given, **pose, dt: time})
        return point_of(arc, ahead * LENGTH, 0)

    with as_written():
        velocity = bicycle.point_world.substitute({v: speed, theta: state[2]})
        turned = bicycle.euler_step.substitute({**given, theta: state[2], dt: DURATION / n})[2]
        step = [p + u * DURATION / n for p, u in zip(state, velocity, strict=False)]
        goal = exact(DURATION)
        error = distance(end, goal)
        pace = speed * sqrt(1 + (ahead * tan(steering)) ** 2) * DURATION / n
    loop = Recurrence(state, (0, 0, heading), (*step, turned), count=n, most=40, ends=end)
    return Figure(
        name="bicycle-steps",
        title="The exact arc of a long car and the same drive in straight steps",
        view=(-24, 24, -5, 23),
        size="laboratory",
        controls=(
            Slider(n, 1, 40, start=5, step=1, label="number of steps", kind="approximation"),
            Slider.degrees(
                steering, -60, 60, start=30,
                label="steering φ",
            ),
            Slider(rate_rear, 1, 12, start=8, step=0.5, label="wheel rate"),
            Slider.degrees(
                y_heading, step=5,
                label="heading ψ from the y axis, clockwise",
            ),
            Choice("point", "point that is followed", (ahead,),
                   {"rear axle": (0.0,), "front axle": (1.0,)}),
        ),
        shapes=(
            Curve("path", exact(s), s, 0, DURATION),
            Trail("approximation", state, loop),
            Line("approximation", (goal, end)),
            Point("path", (0, 0), label="start"),
            Point("target", goal, label="exact"),
        ),
        readouts=(
            Readout("apart", "error at the end", error, "m"),
            Readout("pace", "length of a step", pace, "m"),
            Readout("ratio", "error / length of a step", error / pace, ""),
            Readout("x", "exact x", goal[0], "m"),
            Readout("y", "exact y", goal[1], "m"),
        ),
        sentence=(
            "Following the {point} in {n} straight steps, the drive of 10 s ends {apart} from the "
            "exact end, {ratio} of a step's length; the exact end is at x = {x}, y = {y}."
        ),
    )  # fmt: skip


SPEED, LASTING = 3.0, 8.0  # m/s, s: 24 m of driving, once round in the tightest turn
FAR = 4.0  # m, from the front axle to the handle that steers
TYRE = {"length": 1.2, "width": 0.4}  # m, larger than true, to be seen


def lane_figure() -> Figure:
    """Draw a long car in a turn: paths of rear, centre and front, the lane between its wheels."""
    given = {v: SPEED, x: 0, y: 0, theta: UP}

    def at(time: Any, forward: Any, left: Any) -> tuple[Any, Any]:
        return point_of(bicycle.arc_step.substitute({**given, dt: time}), forward, left)

    pose, drawn = symbols("x_t y_t theta_t"), tuple(bicycle.arc_step.substitute({**given, dt: t}))
    side = track / 2
    # the inner edge of the lane is a rear wheel's, the outer one a front wheel's
    to_left = (1 + sign(steering)) / 2
    left_edge = ((1 - to_left) * wheelbase, side)
    right_edge = (to_left * wheelbase, -side)
    tip = point_of(START, wheelbase + FAR * cos(steering), FAR * sin(steering))
    corners = [(0, side), (0, -side), (wheelbase, -side), (wheelbase, side), (0, side)]
    lane = bicycle.lane.right
    edges = [
        tuple(Piecewise((c, Abs(R) >= side), (nan, True)) for c in at(s, *edge))
        for edge in (left_edge, right_edge)
    ]
    with as_written():  # in gentler turns the ICR lies outside the picture
        near = Piecewise((-wheelbase / tan(steering), Abs(steering) > pi / 18), (nan, True))
    return Figure(
        name="swept-lane",
        title="A long car in a turn, and the lane that it needs",
        view=(-14, 14, -4, 13),
        size="laboratory",
        controls=(
            Slider.degrees(
                steering, -60, 60, start=20,
                label="steering φ", kind="velocity",
            ),
            Slider(wheelbase, 2.0, 10.0, start=LENGTH, step=0.5, label="wheelbase L"),
            Slider(track, 1.0, 2.5, start=TRACK, step=0.1, label="track b"),
            Clock(t, 0.0, LASTING, step=0.1, label="time, at 3 m/s"),
        ),
        where=((R, radius), *zip(pose, drawn, strict=True)),
        shapes=(
            Curve("left", edges[0], s, 0, LASTING),
            Curve("right", edges[1], s, 0, LASTING),
            Curve("path", at(s, 0, 0), s, 0, LASTING),
            Curve("approximation", at(s, wheelbase / 2, 0), s, 0, LASTING),
            Curve("velocity", at(s, wheelbase, 0), s, 0, LASTING),
            Line("ghost", tuple(point_of(START, *corner) for corner in corners)),
            Line("body", tuple(point_of(pose, *corner) for corner in corners)),
            Wheel("left", point_of(pose, 0, side), pose[2], **TYRE),
            Wheel("right", point_of(pose, 0, -side), pose[2], **TYRE),
            Wheel("left", point_of(pose, wheelbase, side), pose[2] + angles[0], **TYRE),
            Wheel("right", point_of(pose, wheelbase, -side), pose[2] + angles[1], **TYRE),
            Point("path", point_of(pose, 0, 0)),
            Point("approximation", point_of(pose, wheelbase / 2, 0)),
            Point("velocity", point_of(pose, wheelbase, 0)),
            Arrow("velocity", point_of(START, wheelbase, 0), tip, label="φ"),
            Point("icr", (near, 0), label="ICR"),
        ),
        handles=(Handle("direction of the front wheels", tip, {steering: to_pointer(START)}),),
        readouts=(
            Readout("lane", "width of the lane", lane, "m", 2, NO_LANE),
            Readout("more", "wider than the car by", lane - track, "m", 2, {"nan": "no lane"}),
            Readout("cut", "corner cut c", bicycle.cut.right, "m", digits=2),
        ),
        sentence=(
            "The car is steered {steering}. Width of its lane: {lane}. Its rear axle runs {cut} "
            "inside its front axle. It has driven for {t}."
        ),
    )  # fmt: skip


SHORT, WIDE, PACE = 2.5, 2.0, 2.0  # m, m, m/s: the car of the mistakes
MISTAKES = symbols("mistake:6", real=True)  # 1 for the one that is made, else 0


def pose_by_mistake(time: Any) -> dict[str, Any]:
    """Return the rear axle's pose by each mistake, and whether it is one of the front axle."""
    car = {wheelbase: SHORT, v: PACE, v_F: PACE / cos(steering)}
    steered = (substitute(each, {**car, track: WIDE}) for each in angles)
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


def car(kind: str, pose: Any, steered: Any) -> tuple[Any, ...]:
    """Return a car from above: its outline, and its wheels."""
    side, end = WIDE / 2, 0.5
    rim = [(-end, side), (-end, -side), (SHORT + end, -side), (SHORT + end, side), (-end, side)]
    outline = tuple(point_of(pose, *corner) for corner in rim)
    wheels = zip((0, 0, SHORT, SHORT), (side, -side) * 2, (0, 0, *steered), strict=True)
    return (
        Area(kind, outline),
        Line(kind, outline),
        *(Wheel(kind, point_of(pose, a, b), pose[2] + turn, **WHEEL) for a, b, turn in wheels),
    )


def mistakes_figure() -> Figure:
    """Draw a car in a left turn, and where a program with a mistake believes it to be."""
    here, there = symbols("x_t y_t theta_t", real=True), symbols("x_b y_b theta_b", real=True)
    poses = pose_by_mistake(t)
    true = bicycle.arc_step.substitute({x: 0, y: 0, theta: UP, v: PACE, wheelbase: SHORT, dt: t})
    wrong = Matrix([list(pose) for pose in poses.values()]).T * Matrix(MISTAKES)
    point, ghost = (point_of(pose, SHORT * ahead, 0) for pose in (here, there))
    ways = (tuple(point_of(pose.subs(t, s)[:3], SHORT * ahead, 0)) for pose in (true, wrong))
    steered = [substitute(each, {wheelbase: SHORT, track: WIDE}) for each in angles]
    return Figure(
        name="wrong-car",
        title="A car, and where a program with a mistake believes it to be",
        view=(-7.9, 5.1, -4.1, 5.7),
        controls=(
            Choice.one_hot("mistake", MISTAKES, poses, start=sines_only.title),
            Slider.degrees(
                steering, 35, 60, start=55,
                label="steering φ",
            ),
            Clock(t, 0.0, 3.0, start=3.0, loops=True, label="time, at 2 m/s"),
        ),
        where=(*zip(here, true, strict=True), *zip((*there, ahead), wrong, strict=True)),
        shapes=(
            *(Curve(*way, s, 0, t) for way in zip(("path", "approximation"), ways, strict=True)),
            *car("approximation", there, steered),
            *car("body", here, steered),
            Line("error", (point, ghost)),
        ),
        readouts=(
            Readout("apart", "apart", distance(ghost, point), "m", digits=2),
            Readout("off", "heading off by", motion.wrap(there[2] - here[2]), "rad", digits=0),
        ),
    )  # fmt: skip


FIGURES = (ackermann_figure(), loop_figure(), lane_figure(), mistakes_figure())
