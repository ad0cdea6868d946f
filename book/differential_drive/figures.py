"""The live figures of the chapter on the differential drive."""

from math import pi
from typing import Any

from sympy import Symbol, sqrt, symbols

from book.differential_drive import formulas as drive
from book.differential_drive.formulas import b, v_L, v_R
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, v, v_y, x, y
from workshop.equations.core import as_written, quantity
from workshop.figures import (
    POINTER,
    Arrow,
    Body,
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
)

DISTANCE = 0.1  # m, between the wheels, as in the exercise
WHEEL = {"length": 0.06, "width": 0.014}  # m, a wheel of radius 3 cm from above
ORIGIN = (0, 0)
NO_ICR = {"inf": "none: straight line", "nan": "every point: standing still"}

t = quantity("t", "s", 0, 12, "time")
n = quantity("n", "", 1, 40, "number of steps")
s = Symbol("s")

speed = drive.speed.right
rate = drive.turning_rate.at({b: DISTANCE})
radius = drive.turning_radius.at({b: DISTANCE})
icr = motion.icr.at({x: 0, y: 0, v: speed, omega: rate})


def pose_after(time: Any) -> Any:
    """The pose [x, y, theta] after driving for a time from the origin."""
    return motion.arc_step.at({x: 0, y: 0, v: speed, omega: rate, dt: time})


def turned(forward: Any, left: Any) -> tuple[Any, Any]:
    """An arrow of the robot's frame, at its starting heading, as seen from the world."""
    arrow = motion.to_world.at({v: forward, v_y: left, omega: 0})
    return arrow[0], arrow[1]


def wheel_at(side: int, forward: Any = 0) -> tuple[Any, Any]:
    """A point ahead of the left (1) or right (-1) wheel at the start."""
    return turned(forward, side * DISTANCE / 2)


def pulled() -> Any:
    """The speed that puts an arrow's tip where the pointer is."""
    x_dot, y_dot = motion.x_dot, motion.y_dot
    return motion.to_body.at({x_dot: POINTER[0], y_dot: POINTER[1]})[0]


def speed_sliders() -> tuple[Slider, Slider]:
    """The two wheel speeds under the hand, set as in the exercise."""
    return (
        Slider(v_L, -0.15, 0.15, start=0.05, step=0.005, label="left wheel v_L", kind="left"),
        Slider(v_R, -0.15, 0.15, start=0.1, step=0.005, label="right wheel v_R", kind="right"),
    )


def drive_figure() -> Figure:
    """Wheel speeds under the hand: the motion, the ICR and the arc, played or scrubbed."""
    now = pose_after(t)
    return Figure(
        name="wheel-speeds",
        title="A differential-drive robot seen from above, its wheel speeds under your hand",
        view=(-0.42, 0.28, -0.21, 0.25),
        controls=(
            *speed_sliders(),
            Slider(theta, -pi, pi, start=pi / 2, step=pi / 36, label="heading at the start"),
            Clock(t, 0.0, 12.0, start=0.0, step=0.05, label="time"),
        ),
        scene=(
            Curve("ghost", (pose_after(s)[0], pose_after(s)[1]), s, 0, 12),
            Curve("path", (pose_after(s)[0], pose_after(s)[1]), s, 0, t),
            Line("icr", (ORIGIN, (icr[0], icr[1]))),
            Body(ORIGIN, theta, 0.065, kind="ghost"),
            Wheel("left", wheel_at(1), theta, **WHEEL),
            Wheel("right", wheel_at(-1), theta, **WHEEL),
            Body((now[0], now[1]), now[2], 0.065),
            Arrow("left", wheel_at(1), wheel_at(1, v_L), label="v_L"),
            Arrow("right", wheel_at(-1), wheel_at(-1, v_R), label="v_R"),
            Arrow("velocity", ORIGIN, turned(speed, 0), label="v"),
            Point("icr", (icr[0], icr[1]), label="ICR"),
        ),
        handles=(
            Handle("tip of the left wheel's arrow", wheel_at(1, v_L), {v_L: pulled()}),
            Handle("tip of the right wheel's arrow", wheel_at(-1, v_R), {v_R: pulled()}),
        ),
        readouts=(
            Readout("v", "speed v", speed, "m/s"),
            Readout("omega", "turning rate ω", rate, "rad/s"),
            Readout("radius", "turning radius R", radius, "m", words=NO_ICR),
            Readout("x", "x at this time", now[0], "m"),
            Readout("y", "y at this time", now[1], "m"),
            Readout("heading", "heading at this time", now[2], "rad", digits=1),
        ),
        says=(
            "Left wheel {v_L}, right wheel {v_R}: the robot drives at {v} and turns at {omega}; "
            "its turning radius is {radius}. After {t} it is at x = {x}, y = {y}, "
            "heading {heading}."
        ),
    )


DURATION = 6.0  # s, of the drive that is cut into steps


def steps_figure() -> Figure:
    """One drive in n straight steps beside the exact arc: the error shrinks with the step."""
    state = symbols("x_k y_k theta_k")
    end = symbols("x_n y_n theta_n")
    exact = pose_after(DURATION)
    with as_written():
        values = {x: state[0], y: state[1], theta: state[2], v: speed, omega: rate}
        step = motion.euler_step.at({**values, dt: DURATION / n})
        apart = sqrt((end[0] - exact[0]) ** 2 + (end[1] - exact[1]) ** 2)
    loop = Recurrence(state, (0, 0, theta), tuple(step), count=n, most=40, ends=end)
    return Figure(
        name="steps",
        title="The exact arc and the same drive in straight steps",
        view=(-0.42, 0.28, -0.11, 0.31),
        controls=(
            Slider(n, 1, 40, start=6, step=1, label="number of steps", kind="approximation"),
            *speed_sliders(),
            Slider(theta, -pi, pi, start=pi / 2, step=pi / 36, label="heading at the start"),
        ),
        scene=(
            Curve("path", (pose_after(s)[0], pose_after(s)[1]), s, 0, DURATION),
            Trail("approximation", (state[0], state[1]), loop),
            Body(ORIGIN, theta, 0.065, kind="ghost"),
            Body((exact[0], exact[1]), exact[2], 0.065),
            Line("approximation", ((exact[0], exact[1]), (end[0], end[1]))),
            Point("target", (exact[0], exact[1]), label="exact"),
        ),
        readouts=(
            Readout("apart", "error at the end", apart, "m", digits=4),
            Readout("x", "exact x", exact[0], "m"),
            Readout("y", "exact y", exact[1], "m"),
        ),
        says=(
            "With {n} straight steps the drive of 6 s ends {apart} from the exact end, "
            "which is at x = {x}, y = {y}."
        ),
    )


FIGURES = (drive_figure(), steps_figure())
