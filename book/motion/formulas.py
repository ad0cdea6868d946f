"""Planar motion: world and body frame, centre of rotation, the exact arc."""

from typing import Any

from sympy import MatMul, Matrix, Ne, Piecewise, ceiling, cos, nan, oo, pi, sin, sinc

from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

x = quantity("x", "m", -2, 2, "position of the robot in the world")
y = quantity("y", "m", -2, 2, "position of the robot in the world")
theta = quantity("theta", "rad", -3.14, 3.14, "heading: from the world's x axis to the robot's")
v = quantity(
    "v", "m/s", -1, 1, "speed: of a robot, along its own x axis; of a point, along its way"
)
v_y = quantity("v_y", "m/s", -1, 1, "speed of the robot along its own y axis, to the left")
omega = quantity("omega", "rad/s", -6, 6, "angular velocity: counter-clockwise")
dt = quantity("dt", "s", 0, 1, "time: how long a step takes", latex=r"\Delta t")
angle = quantity("angle", "rad", -20, 20, "any angle", latex=r"\alpha")

x_dot = quantity("x_dot", "m/s", -1, 1, "speed along the world's x axis", latex=r"\dot{x}")
y_dot = quantity("y_dot", "m/s", -1, 1, "speed along the world's y axis", latex=r"\dot{y}")
theta_dot = quantity("theta_dot", "rad/s", -6, 6, "rate of the heading", latex=r"\dot{\theta}")
x_next = symbol("x_next", "position after the step", "x'", "m")
y_next = symbol("y_next", "position after the step", "y'", "m")
theta_next = symbol("theta_next", "heading after the step", r"\theta'", "rad")
x_icr = symbol("x_icr", "the ICR, in the world", r"x_\mathrm{ICR}", "m")
y_icr = symbol("y_icr", "the ICR, in the world", r"y_\mathrm{ICR}", "m")
chord_length = symbol("chord_length", "straight from the old place to the new", "c", "m")
theta_m = quantity("theta_m", "rad", -6, 6, "middle heading: halfway through the turn")
wrapped = symbol("wrapped", "the same angle in (−π, π]", r"\operatorname{wrap}\alpha", "rad")


with as_written():
    rotation = Matrix([[cos(theta), -sin(theta), 0], [sin(theta), cos(theta), 0], [0, 0, 1]])
    rotation_back = Matrix([[cos(theta), sin(theta), 0], [-sin(theta), cos(theta), 0], [0, 0, 1]])

    to_world = Equation(
        name="motion.to_world",
        left=Matrix([x_dot, y_dot, theta_dot]),
        right=Matrix([v * cos(theta) - v_y * sin(theta), v * sin(theta) + v_y * cos(theta), omega]),
        textbook=MatMul(rotation, Matrix([v, v_y, omega])),
    )

    to_body = Equation(
        name="motion.to_body",
        left=Matrix([v, v_y, omega]),
        right=Matrix(
            [
                x_dot * cos(theta) + y_dot * sin(theta),
                -x_dot * sin(theta) + y_dot * cos(theta),
                theta_dot,
            ]
        ),
        textbook=MatMul(rotation_back, Matrix([x_dot, y_dot, theta_dot])),
    )

    icr = Equation(
        name="motion.icr",
        left=Matrix([x_icr, y_icr]),
        right=Matrix(
            [
                Piecewise((x - v / omega * sin(theta), Ne(omega, 0)), (oo, Ne(v, 0)), (nan, True)),
                Piecewise((y + v / omega * cos(theta), Ne(omega, 0)), (oo, Ne(v, 0)), (nan, True)),
            ]
        ),
        textbook=Matrix([x - v / omega * sin(theta), y + v / omega * cos(theta)]),
    )

    arc_step = Equation(
        name="motion.arc_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix(
            [
                x + v * dt * sinc(omega * dt / 2) * cos(theta + omega * dt / 2),
                y + v * dt * sinc(omega * dt / 2) * sin(theta + omega * dt / 2),
                theta + omega * dt,
            ]
        ),
        textbook=Matrix(
            [
                x + v / omega * (sin(theta + omega * dt) - sin(theta)),
                y - v / omega * (cos(theta + omega * dt) - cos(theta)),
                theta + omega * dt,
            ]
        ),
    )

    chord = Equation(
        name="motion.chord",
        left=Matrix([chord_length, theta_m]),
        right=Matrix([v * dt * sinc(omega * dt / 2), theta + omega * dt / 2]),
    )

    euler_step = Equation(
        name="motion.euler_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix([x + v * cos(theta) * dt, y + v * sin(theta) * dt, theta + omega * dt]),
    )

    wrap_angle = Equation(
        name="motion.wrap_angle",
        left=wrapped,
        right=angle - 2 * pi * ceiling((angle - pi) / (2 * pi)),
    )


def wrap(value: Any) -> Any:
    """Another angle in (−π, π]."""
    return wrap_angle.substitute({angle: value})
