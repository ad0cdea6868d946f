"""Planar motion: world and body frame, centre of rotation, the exact arc."""

import numpy as np
from numpy.typing import ArrayLike
from sympy import MatMul, Matrix, Ne, Piecewise, Symbol, ceiling, cos, nan, oo, pi, sin, sinc

from robokin import motion
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

x = quantity("x", "m", -2, 2, "position of the robot in the world")
y = quantity("y", "m", -2, 2, "position of the robot in the world")
theta = quantity("theta", "rad", -3.14, 3.14, "heading: from the world's x axis to the robot's")
v = quantity("v", "m/s", -1, 1, "forward speed")
v_y = quantity("v_y", "m/s", -1, 1, "sideways speed, to the left")
omega = quantity("omega", "rad/s", -6, 6, "turning rate, counter-clockwise")
dt = quantity("dt", "s", 0, 1, "length of a time step", latex=r"\Delta t")
angle = quantity("angle", "rad", -20, 20, "any angle", latex=r"\alpha")

x_dot = quantity("x_dot", "m/s", -1, 1, "speed along the world's x axis", latex=r"\dot{x}")
y_dot = quantity("y_dot", "m/s", -1, 1, "speed along the world's y axis", latex=r"\dot{y}")
theta_dot = quantity("theta_dot", "rad/s", -6, 6, "turning rate", latex=r"\dot{\theta}")
x_next, y_next, theta_next = (Symbol(rf"{name}'") for name in ("x", "y", r"\theta"))
x_icr, y_icr = Symbol(r"x_\mathrm{ICR}"), Symbol(r"y_\mathrm{ICR}")
wrapped = Symbol(r"\operatorname{wrap}\alpha")

STILL = {v: 0.0, v_y: 0.0, omega: 0.0}
STRAIGHT = ({omega: 0.0}, {omega: 1e-16}, {omega: -1e-16}, {omega: 1e-8})
QUARTERS = tuple({theta: quarter * np.pi / 2} for quarter in (-2, -1, 0, 1, 2))


def one_euler_step(pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike) -> Array:
    """The first step of a path that keeps the old heading."""
    return motion.path(pose, v, omega, dt, method="start")[..., 1, :]


with as_written():
    rotation = Matrix([[cos(theta), -sin(theta), 0], [sin(theta), cos(theta), 0], [0, 0, 1]])
    rotation_back = Matrix([[cos(theta), sin(theta), 0], [-sin(theta), cos(theta), 0], [0, 0, 1]])

    to_world = Equation(
        name="motion.to_world",
        left=Matrix([x_dot, y_dot, theta_dot]),
        right=Matrix([v * cos(theta) - v_y * sin(theta), v * sin(theta) + v_y * cos(theta), omega]),
        textbook=MatMul(rotation, Matrix([v, v_y, omega])),
        source="exercise 4",
        function=motion.to_world,
        arguments=(theta, (v, v_y, omega)),
        tolerance=1e-15,
        reason="sine, cosine, two products and a sum, each rounded once, of sizes up to 1",
        specials=(*QUARTERS, STILL),
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
        source="exercise 4",
        function=motion.to_body,
        arguments=(theta, (x_dot, y_dot, theta_dot)),
        tolerance=1e-15,
        reason="as to_world",
        specials=QUARTERS,
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
        source="exercise 5",
        function=motion.icr,
        arguments=((x, y, theta), v, omega),
        ranges={omega: (0.1, 6)},
        tolerance=5e-15,
        reason="a few roundings of numbers up to v/omega = 10",
        specials=({omega: 0.0}, {omega: 0.0, v: 0.0}, {v: 0.0}, {omega: -0.5}, *QUARTERS),
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
        source="exercise 5",
        function=motion.arc_step,
        arguments=((x, y, theta), v, omega, dt),
        tolerance=2e-15,
        reason="a rounding of the heading (up to 9 rad), times a chord of at most 1 m",
        specials=(*STRAIGHT, *QUARTERS, {dt: 0.0}, {v: 0.0}),
    )

    euler_step = Equation(
        name="motion.euler_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix([x + v * cos(theta) * dt, y + v * sin(theta) * dt, theta + omega * dt]),
        source="exercise 5 (seed 004)",
        function=one_euler_step,
        arguments=((x, y, theta), (v,), (omega,), (dt,)),
        tolerance=1e-15,
        reason="a few roundings of numbers up to 9",
        specials=(*STRAIGHT, {dt: 0.0}),
    )

    wrap_angle = Equation(
        name="motion.wrap_angle",
        left=wrapped,
        right=angle - 2 * pi * ceiling((angle - pi) / (2 * pi)),
        source="conventions",
        function=motion.wrap_angle,
        arguments=(angle,),
        tolerance=2e-15,
        reason="a rounding of three turns (18.8 rad)",
        is_angle=True,
        specials=({angle: 0.0}, {angle: 3.0}, {angle: -3.0}, {angle: 1e-16}),
    )
