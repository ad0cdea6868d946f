"""The live figures of the chapter on wheel constraints."""

from math import pi
from typing import Any

from sympy import Abs, Matrix, Piecewise, Symbol, atan2, cos, nan, sin, sqrt, symbols, tan

from book.differential_drive.figures import t
from book.differential_drive.formulas import r
from book.frames.figures import point_of
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, theta_dot, v, v_y, x, x_dot, y, y_dot
from book.wheels import formulas as wheels
from book.wheels.exercises import cos_alpha, heading_for_beta, plus_l_cos, plus_sign, turned_back
from book.wheels.formulas import alpha, beta, l, omni_rates, rolling_row, sliding_row
from courseware.equations import as_written, declarations
from courseware.equations.functions import null_projector, rank
from courseware.figures import (
    POINTER,
    Arrow,
    Body,
    Choice,
    Clock,
    Curve,
    Figure,
    Handle,
    Line,
    NamedSteps,
    Point,
    Readout,
    Slider,
    Wheel,
    distance,
)

quantity, _ = declarations(__name__)

ORIGIN = (0, 0)
QUARTER = pi / 2
ASIDE = 1.0  # rad
s = Symbol("s")


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


# --- One wheel of each kind

SPEED = 0.2  # m/s
KINDS = ("fixed", "castor", "Swedish, 90°", "Swedish, 45°", "ball")
CHOSEN = symbols("is_fixed is_castor is_90 is_45 is_ball")  # 1 for the kind that is chosen
LONG, WIDE = 0.16, 0.05  # m

course = quantity("course", "rad", -pi, pi, "the direction in which a wheel is moved", r"\chi")


def kinds_figure() -> Figure:
    """Draw a wheel of each kind as it is moved: the part that it rolls, and how it gives way."""
    fixed, castor, straight, slanted, ball = CHOSEN
    with as_written():
        gamma = pi / 4 * slanted
        tip = SPEED * cos(course), SPEED * sin(course)
        rolled, aside = tip[0] + tip[1] * tan(gamma), tip[1] / cos(gamma)
        contact = (-2 * TRAIL * castor, 0)
        along = [Piecewise((part, ball < 0.5), (nan, True)) for part in (rolled, aside)]
        rounds = [(0.08, 0.08, "ghost"), (0.06, 0.06, "body")]
        rounds += [(0.06, 0.02, "body"), (0.02, 0.06, "body")]

    def rollers(when: Any, turned: float, size: float) -> list[Wheel]:
        return [
            Wheel("left", place_if(when, (at, 0)), turned, length=size, width=0.02)
            for at in (-0.055, 0, 0.055)
        ]

    return Figure(
        name="wheel-kinds",
        title="A wheel from above is moved: what it rolls, and how it gives way",
        view=(-0.36, 0.36, -0.23, 0.23),
        size="laboratory",
        controls=(
            Choice.one_hot("kind", CHOSEN, KINDS, "wheel"),
            Slider.degrees(course, start=30, step=5, label="direction of the motion"),
        ),
        shapes=(
            Line("body", (place_if(fixed, (0, -0.09)), place_if(fixed, (0, 0.09)))),
            Line("body", (place_if(castor, (0, 0)), place_if(castor, contact))),
            Wheel("ghost", place_if(1 - ball, contact), 0, length=LONG, width=WIDE),
            *rollers(straight, 0, 0.048),
            *rollers(slanted, pi / 4, 0.07),
            *(
                Curve(kind, place_if(ball, (wide * cos(s), high * sin(s))), s, 0, 2 * pi)
                for wide, high, kind in rounds
            ),
            Arrow("left", ORIGIN, (along[0], 0)),
            Arrow("approximation", (along[0], 0), place_if(1 - ball, tip)),
            Arrow("velocity", ORIGIN, tip),
            Point("body", ORIGIN),
        ),
        handles=(
            Handle("tip of the arrow", tip, {course: atan2(POINTER[1], POINTER[0])}),
        ),
        readouts=(
            Readout("rolled", "rolls at", along[0], "m/s", words={"nan": "any speed, any way"}),
            Readout("aside", "the rest", along[1], "m/s", words={"nan": "nothing"}),
        ),
        sentence=(
            "{kind} wheel, moved at 0.2 m/s in the direction {course} from where it rolls. It "
            "rolls at {rolled}; the rest is {aside}."
        ),
    )  # fmt: skip


# --- The wheel laboratory

# there, fixed, steered; what forbids nothing is there as a castor (1) or as a Swedish wheel (2)
FIXED, STEERED, CASTOR, SWEDISH = (1, 1, 0), (1, 0, 1), (1, 0, 0), (2, 0, 0)
WHEEL = {"length": 0.1, "width": 0.03}  # m
TRAIL = 0.05  # m, from a castor's pivot back to its wheel
ABSENT = (0.0, 0.0, 0.0, 0, 0, 0)
OMNI_PLACES = [(0.2, 0.0, -QUARTER), (-0.1, 0.17, pi / 6), (-0.1, -0.17, 5 * pi / 6)]

# x, y, the direction that a wheel rolls in; its kind. The first two can be moved and turned.
ROBOTS = {
    "car": [
        (0.3, 0.12, 0.0, *STEERED),
        (0.0, 0.12, 0.0, *FIXED),
        (0.0, -0.12, 0.0, *FIXED),
        (0.3, -0.12, 0.0, *STEERED),
    ],
    "bicycle": [(0.3, 0.0, 0.0, *STEERED), (0.0, 0.0, 0.0, *FIXED)],
    "tricycle": [(0.3, 0.0, 0.0, *STEERED), (0.0, 0.12, 0.0, *FIXED), (0.0, -0.12, 0.0, *FIXED)],
    "differential drive, castor": [
        (0.0, 0.12, 0.0, *FIXED),
        (0.0, -0.12, 0.0, *FIXED),
        (-0.2, 0.0, 0.0, *CASTOR),
    ],
    "two steered wheels, castors": [
        (0.2, 0.0, 0.0, *STEERED),
        (-0.2, 0.0, 0.0, *STEERED),
        (0.0, 0.12, 0.0, *CASTOR),
        (0.0, -0.12, 0.0, *CASTOR),
    ],
    "one steered wheel, castors": [
        (0.2, 0.0, 0.0, *STEERED),
        (-0.12, 0.12, 0.0, *CASTOR),
        (-0.12, -0.12, 0.0, *CASTOR),
    ],
    "three Swedish wheels": [(*place, *SWEDISH) for place in OMNI_PLACES],
}
WISHES = {
    "drive ahead": (0.15, 0.0, 0.0),
    "move to the left": (0.0, 0.15, 0.0),
    "turn on the spot": (0.0, 0.0, 0.5),
    "all three at once": (0.15, 0.15, 0.5),
}

centre_x = quantity("centre_x", "m", -1, 1, "how far ahead the steered axles meet", latex="C_x")
centre_y = quantity(
    "centre_y", "m", -1, 1, "how far to the left the steered axles meet", latex="C_y"
)
shift_x = quantity("shift_x", "m", -0.2, 0.2, "a wheel moved ahead", latex=r"\Delta x")
shift_y = quantity("shift_y", "m", -0.2, 0.2, "a wheel moved to the left", latex=r"\Delta y")
shift_angle = quantity(
    "shift_angle", "rad", -pi / 2, pi / 2, "a wheel turned to the left", latex=r"\Delta\beta"
)

NUMBERS = [symbols(f"x_{k} y_{k} ahead_{k} there_{k} fixed_{k} steered_{k}") for k in range(4)]
WHICH = symbols("which_0 which_1")
WISH = Matrix(symbols("wish_v wish_vy wish_omega"))


def robot_numbers(name: str) -> tuple[float, ...]:
    """Return all numbers of a robot, four wheels of six each."""
    chosen = [*ROBOTS[name], *[ABSENT] * 4][:4]
    return tuple(float(number) for wheel in chosen for number in wheel)


def wheels_of_robot(steps: NamedSteps) -> tuple[list[Any], list[Any], Any, Any]:
    """Return each wheel's place and axle, and the sliding rows, of all and of the fixed."""
    places, axles, rows, fixed_rows = [], [], [], []
    for k, (px, py, ahead, _, fixed, steered) in enumerate(NUMBERS):
        mine = WHICH[k] if k < 2 else 0
        at_x = steps.add(f"at_x{k}", px + mine * shift_x)
        at_y = steps.add(f"at_y{k}", py + mine * shift_y)
        aimed = atan2(centre_y - at_y, centre_x - at_x)
        own = steered * aimed + (1 - steered) * (ahead + QUARTER)
        axle = steps.add(f"axle{k}", own + mine * shift_angle)
        far = steps.add(f"l{k}", sqrt(at_x**2 + at_y**2))
        spoke = steps.add(f"alpha{k}", atan2(at_y, at_x))
        row = sliding_row(far, spoke, steps.add(f"beta{k}", axle - spoke))
        rows.append([(fixed + steered) * entry for entry in row])
        fixed_rows.append([fixed * entry for entry in row])
        places.append((at_x, at_y, far, spoke))
        axles.append(axle)
    return places, axles, Matrix(rows), Matrix(fixed_rows)


def motion_left(steps: NamedSteps, rows: Any) -> tuple[Any, Any]:
    """Return what the rows leave of any twist, as a matrix, and of the twist that is asked for."""
    free = null_projector(rows)
    P = Matrix(3, 3, lambda i, j: Symbol(f"P{min(i, j)}{max(i, j)}"))
    steps += [(P[i, j], free[i, j]) for i in range(3) for j in range(i, 3)]
    twist = [
        steps.add(f"twist{i}", sum((P[i, j] * WISH[j] for j in (1, 2)), P[i, 0] * WISH[0]))
        for i in range(3)
    ]
    return P, twist


def degrees_of_freedom(steps: NamedSteps, of_fixed: Any) -> tuple[Any, Any]:
    """Return mobility and steerability of the robot, from the rank of its fixed wheels."""
    count = NUMBERS[0][5] + NUMBERS[1][5] + NUMBERS[2][5] + NUMBERS[3][5]
    ranks = {wheels.rank_fixed: of_fixed, wheels.rank_steered: count}
    delta_s = steps.add("delta_s", wheels.STEERABLE.xreplace(ranks))
    return steps.add("delta_m", 3 - of_fixed - delta_s), delta_s


def laboratory_figure() -> Figure:
    """Draw any wheel moved and turned: the motions that are left, and how many."""
    steps = NamedSteps()
    with as_written():
        places, axles, rows, fixed_rows = wheels_of_robot(steps)
        now = steps.add("rank_now", rank(rows))
        of_fixed = steps.add("rank_of_fixed", rank(fixed_rows))
        P, twist = motion_left(steps, rows)
        delta_m, delta_s = degrees_of_freedom(steps, of_fixed)
        one_motion = (now > 1.5) & (now < 2.5) & (P[2, 2] > 0.2)  # and its centre within 2 m
        icr = [Piecewise((part / P[2, 2], one_motion), (nan, True)) for part in (-P[1, 2], P[0, 2])]
        end, along = move(0, twist, t), move(0, twist, s)
        end = tuple(steps.add(f"end_{name}", part) for name, part in zip("xyt", end, strict=True))
        rolls = [rolling_direction(k, places[k], axles[k], twist) for k in range(4)]
        rolls = [steps.add(f"rolls{k}", direction) for k, direction in enumerate(rolls)]
        chosen = [sum(WHICH[k] * NUMBERS[k][i] for k in range(2)) for i in range(2)]

    return Figure(
        name="wheel-laboratory",
        title="A robot seen from above, its wheels, their axles and the motion they allow",
        view=(-0.6, 0.8, -0.55, 0.55),
        size="",
        controls=(
            Choice(
                "robot",
                "robot",
                tuple(symbol for wheel in NUMBERS for symbol in wheel),
                {name: robot_numbers(name) for name in ROBOTS},
            ),
            Choice("wish", "asked to", tuple(WISH), WISHES, start="turn on the spot"),
            Slider(centre_x, -0.5, 0.7, start=0.0, step=0.05, label="ring Q ahead"),
            Slider(centre_y, -0.5, 0.5, start=0.4, step=0.05, label="ring Q to the left"),
            Choice.one_hot("which", WHICH, ("wheel 1", "wheel 2"), label="change"),
            Slider(shift_x, -0.2, 0.2, start=0.0, step=0.05, label="move it ahead"),
            Slider(shift_y, -0.2, 0.2, start=0.0, step=0.05, label="move it to the left"),
            Slider.degrees(shift_angle, -90, 90, step=5, label="turn it"),
            Clock(t, 0.0, 6.0, label="time"),
        ),
        shapes=(
            *(axle_line(k, places[k], axles[k]) for k in range(4)),
            Curve("ghost", along, s, 0, 6),
            Curve("path", along, s, 0, t),
            Body(ORIGIN, 0, 0.05, kind="ghost"),
            *(
                Wheel("ghost", place_if(NUMBERS[k][3], places[k]), rolls[k], **WHEEL)
                for k in range(4)
            ),
            *(shape for k in range(4) for shape in wheel_shapes(k, places[k], rolls[k], end)),
            Body(end[:2], end[2], 0.05),
            *(contact_velocity(k, places[k], twist) for k in range(4)),
            Point("icr", icr, label="ICR"),
            Point("target", (centre_x, centre_y)),
            *(
                Point("approximation", place_if(WHICH[k], places[k]), label=f"{k + 1}")
                for k in (0, 1)
            ),
        ),
        handles=(
            Handle("ring Q, which the steered axles look at", (centre_x, centre_y)),
            Handle("the wheel that is changed", (chosen[0] + shift_x, chosen[1] + shift_y), {
                shift_x: POINTER[0] - chosen[0], shift_y: POINTER[1] - chosen[1],
            }),
        ),
        readouts=(
            Readout("rank", "independent sliding rows, as the wheels stand", now, "", digits=0),
            Readout("now", "ways to move, as the wheels stand", 3 - now, "", digits=0),
            Readout("mobility", "degree of mobility δ_m", delta_m, "", digits=0),
            Readout("steerability", "degree of steerability δ_s", delta_s, "", digits=0),
            Readout("both", "degree of manoeuvrability δ_M", delta_m + delta_s, "", digits=0),
            Readout("v", "speed ahead v", twist[0], "m/s"),
            Readout("v_y", "speed to the left v_y", twist[1], "m/s"),
            Readout("omega", "turning rate ω", twist[2], "rad/s"),
        ),
        sentence=(
            "{robot}: mobility {mobility}, steerability {steerability}, manoeuvrability {both}. "
            "As the wheels stand there are {now} independent ways to move. Asked to {wish}, the "
            "robot moves ahead at {v}, to the left at {v_y} and turns at {omega}."
        ),
        where=steps,
    )  # fmt: skip


def place_if(when: Any, place: Any) -> tuple[Any, Any]:
    """Return a place that is there when a number is 1 and nowhere when it is 0."""
    shown = [Piecewise((coordinate, when > 0.5), (nan, True)) for coordinate in place[:2]]
    return shown[0], shown[1]


def axle_line(k: int, place: Any, axle: Any) -> Line:
    """Return the line on which a fixed or steered wheel wants the centre of rotation."""
    _, _, _, _, fixed, steered = NUMBERS[k]
    x_k, y_k = place_if(fixed + steered, place)
    ends = [(x_k + side * 2 * cos(axle), y_k + side * 2 * sin(axle)) for side in (-1, 1)]
    return Line("icr", tuple(ends))


def rolling_direction(k: int, place: Any, axle: Any, twist: Any) -> Any:
    """Return the direction of a wheel: along its plane; of a castor, to where it is dragged."""
    _, _, _, there, fixed, steered = NUMBERS[k]
    along, across = pivot_speed(place, twist)
    dragged = ((there - fixed - steered) * (2 - there) > 0.5) & (along**2 + across**2 > 1e-9)
    # seen from a direction that no setting meets: dragged straight back, rounding may not choose
    # between half a turn to the left and one to the right
    ahead = cos(ASIDE) * along + sin(ASIDE) * across
    left = cos(ASIDE) * across - sin(ASIDE) * along
    return Piecewise((ASIDE + atan2(left, ahead), dragged), (axle - QUARTER, True))


def pivot_speed(place: Any, twist: Any) -> Any:
    """Return the velocity of the point of the robot where a wheel is fixed."""
    values = dict(zip((v, v_y, omega), twist, strict=True))
    return wheels.contact.substitute({**values, l: place[2], alpha: place[3]})


def wheel_shapes(k: int, place: Any, along: Any, pose: Any) -> tuple[Any, ...]:
    """Return a wheel, taken along by the robot, in the look of its kind."""
    _, _, _, there, fixed, steered = NUMBERS[k]
    free = there - fixed - steered
    castor = free * (2 - there)  # 1 for a castor only

    def beside(ahead: float, left: float = 0.0) -> tuple[Any, Any]:
        """Return a point so far from the wheel, ahead and to the left of where it rolls."""
        return point_of(pose, *point_of((*place[:2], along), ahead, left))

    def line(when: Any, *points: tuple[float, float]) -> Line:
        return Line("body", tuple(place_if(when, beside(*point)) for point in points))

    def wheel(kind: str, when: Any, ahead: float = 0.0) -> Wheel:
        return Wheel(kind, place_if(when, beside(ahead)), along + pose[2], **WHEEL)

    with as_written():
        rollers = [line(free - 1, (at, -0.025), (at, 0.025)) for at in (-0.03, 0.0, 0.03)]
        return (
            line(fixed + steered, (-0.09, 0.0), (0.09, 0.0)),
            wheel("body", fixed),
            wheel("left", steered),
            wheel("ghost", castor, -TRAIL),
            line(castor, (0.0, 0.0), (-TRAIL, 0.0)),
            wheel("ghost", free - 1),
            *rollers,
        )


def contact_velocity(k: int, place: Any, twist: Any) -> Arrow:
    """Return the velocity of a wheel's contact point as an arrow."""
    x_k, y_k = place[:2]
    with as_written():
        over = pivot_speed(place, twist)
        tail = place_if(NUMBERS[k][3], place)
        return Arrow("velocity", tail, (x_k + over[0], y_k + over[1]))


# --- The omni robot of the exercise

SIZE, RADIUS = 0.2, 0.05  # m
ANGLES = (0.0, 2 * pi / 3, 4 * pi / 3)
WHEELS = ("left", "right", "approximation")  # the looks of wheels 1, 2 and 3


def omni_figure() -> Figure:
    """Draw the omni robot's motion in the world, from three wheel rates."""
    sizes = {l: SIZE, r: RADIUS}
    twist = list(wheels.omni_twist.substitute(sizes))
    turn = twist[2]
    now, along = move(theta, twist, t), move(theta, twist, s)
    world = wheels.omni_world.substitute({**sizes, theta: now[2]})
    arrow = motion.to_world.substitute({v: twist[0], v_y: twist[1], omega: 0})
    with as_written():
        centre = motion.to_world.substitute({v: -twist[1] / turn, v_y: twist[0] / turn})
        icr = [Piecewise((part, Abs(turn) > 0.05), (nan, True)) for part in centre[:2]]
    return Figure(
        name="omni",
        title="A robot on three Swedish wheels seen from above, their rates under your hand",
        view=(-0.5, 1.7, -0.5, 1.0),
        size="",
        controls=(
            *(
                Slider(rate, -6.0, 6.0, start=start, step=0.5, label=f"wheel {k}", kind=kind)
                for k, (rate, start, kind) in enumerate(
                    zip(omni_rates, (-2.0, 4.0, 1.0), WHEELS, strict=True), start=1
                )
            ),
            Slider.degrees(theta, start=30, step=5, label="heading at the start"),
            Clock(t, 0.0, 12.0, label="time"),
        ),
        shapes=(
            Curve("ghost", along, s, 0, 12),
            Curve("path", along, s, 0, t),
            Body(ORIGIN, theta, 0.13, kind="ghost"),
            Body(now[:2], now[2], 0.13),
            *(omni_wheel(k, ORIGIN, theta) for k in range(3)),
            *(omni_wheel(k, now, now[2]) for k in range(3)),
            *(
                Arrow(WHEELS[k], omni_place(k), arrow_tip(k))
                for k in range(3)
            ),
            *(Point(WHEELS[k], omni_place(k), label=f"{k + 1}") for k in range(3)),
            Arrow("velocity", ORIGIN, arrow),
            Point("icr", icr, label="ICR"),
        ),
        handles=tuple(
            Handle(
                f"tip of the arrow of wheel {k + 1}",
                arrow_tip(k),
                {omni_rates[k]: rate_from_pointer(k)},
            )
            for k in range(3)
        ),
        readouts=(
            Readout("v", "speed ahead v", twist[0], "m/s"),
            Readout("v_y", "speed to the left v_y", twist[1], "m/s"),
            Readout("turning", "turning rate ω", turn, "rad/s"),
            Readout("x_dot", "along the world's x axis, at this time", world[0], "m/s"),
            Readout("y_dot", "along the world's y axis, at this time", world[1], "m/s"),
            Readout("x", "now at x", now[0], "m"),
            Readout("y", "now at y", now[1], "m"),
            Readout("heading", "heading now", now[2], "rad"),
        ),
        sentence=(
            "Wheels at {omni_rate1}, {omni_rate2} and {omni_rate3}: the robot moves ahead at {v}, "
            "to the left at {v_y} and turns at {turning}. After {t} it is at x = {x}, y = {y}, "
            "heading {heading}."
        ),
    )  # fmt: skip


def omni_wheel(k: int, at: Any, heading: Any) -> Wheel:
    """Return wheel k of the robot at a pose; it rolls at right angles to its spoke."""
    spoke = heading + ANGLES[k]
    place = (at[0] + SIZE * cos(spoke), at[1] + SIZE * sin(spoke))
    return Wheel(WHEELS[k], place, spoke - QUARTER, length=2 * RADIUS, width=0.035)


def omni_place(k: int) -> tuple[Any, Any]:
    """Return the place of wheel k at the start."""
    return SIZE * cos(theta + ANGLES[k]), SIZE * sin(theta + ANGLES[k])


def arrow_tip(k: int) -> tuple[Any, Any]:
    """Return the place where wheel k would be after a second at its own speed."""
    x_k, y_k = omni_place(k)
    speed, spoke = RADIUS * omni_rates[k], theta + ANGLES[k]
    return x_k + speed * sin(spoke), y_k - speed * cos(spoke)


def rate_from_pointer(k: int) -> Any:
    """Return the rate that puts the tip of the arrow where the pointer is."""
    row = rolling_row(0, ANGLES[k], 0)
    back = motion.to_body.substitute({motion.x_dot: POINTER[0], motion.y_dot: POINTER[1]})
    return (row[0] * back[0] + row[1] * back[1]) / RADIUS


# --- Mistakes

WANTED = {x_dot: -0.08, y_dot: 0.12, theta_dot: -0.6}  # in the world, m/s and rad/s
MADE = (
    plus_sign,
    heading_for_beta,
    plus_l_cos,
    cos_alpha,
    turned_back,
)
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
        view=(-0.8, 0.8, -0.6, 0.65),
        controls=(
            Choice.one_hot("mistake", MISTAKES, (m.title for m in MADE)),
            Slider.degrees(theta, 0, 180, start=60, step=5, label="heading at the start"),
            Clock(t, 0.0, 2.5, start=2.3, loops=True, label="time"),
        ),
        where=tuple(zip(REALLY, really, strict=True)),
        shapes=(
            Curve("path", move(theta, REALLY, s), s, 0, t),
            Curve("approximation", move(theta, wish, s), s, 0, t),
            Line("error", (real, believed)),
            Body(real[:2], real[2], 0.13),
            *(omni_wheel(k, real, real[2]) for k in range(3)),
            Body(believed[:2], believed[2], 0.13, kind="approximation"),
        ),
        readouts=(
            Readout("apart", "apart", distance(real, believed), "m"),
            Readout("turned", "heading off by", believed[2] - real[2], "rad", digits=0),
        ),
        sentence="{mistake}: after {t} the robot is {apart} from where its program believes it. "
        "The heading is off by {turned}.",
    )


FIGURES = (kinds_figure(), laboratory_figure(), omni_figure(), mistakes_figure())
