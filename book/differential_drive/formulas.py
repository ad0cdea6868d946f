"""Differential drive: the robot's velocity from its wheels, and back."""

from numpy.typing import ArrayLike
from sympy import Matrix, Ne, Piecewise, nan, oo

from book.motion.formulas import omega, v, v_y
from robokin import differential_drive, motion
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

rate_L = quantity("rate_L", "rad/s", -20, 20, "rate of the left wheel", latex=r"\dot\varphi_L")
rate_R = quantity("rate_R", "rad/s", -20, 20, "rate of the right wheel", latex=r"\dot\varphi_R")
v_L = quantity("v_L", "m/s", -1, 1, "speed of the left wheel over the floor")
v_R = quantity("v_R", "m/s", -1, 1, "speed of the right wheel over the floor")
r = quantity("r", "m", 0.01, 0.5, "wheel radius")
b = quantity("b", "m", 0.05, 1, "distance between the wheels, the whole of it")
R = quantity("R", "m", -10, 10, "turning radius: how far to the left the ICR lies")

STRAIGHT = {v_L: 0.25, v_R: 0.25, r: 0.03, b: 0.1}
ON_THE_SPOT = {v_L: -0.25, v_R: 0.25}
STILL = {v_L: 0.0, v_R: 0.0}


def twist_of_speeds(v_L: Array, v_R: Array, r: Array, b: Array) -> Array:
    """The body twist from wheel speeds, where a formula is written in speeds and not in rates."""
    return differential_drive.body_twist(v_L / r, v_R / r, r, b)


def radius_of_speeds(v_L: Array, v_R: Array, r: Array, b: Array) -> Array:
    """The turning radius: how far to the left of the robot the ICR lies."""
    twist = twist_of_speeds(v_L, v_R, r, b)
    return motion.icr([0, 0, 0], twist[..., 0], twist[..., 2])[..., 1]


def speeds_of_twist(v: ArrayLike, omega: ArrayLike, r: Array, b: Array) -> Array:
    """The wheel speeds [left, right] from the wheel rates."""
    return r[..., None] * differential_drive.wheel_rates(v, omega, r, b)


with as_written():
    speed = Equation(
        name="differential_drive.speed",
        left=v,
        right=(v_R + v_L) / 2,
        source="exercise 4",
        function=twist_of_speeds,
        component=0,
        arguments=(v_L, v_R, r, b),
        tolerance=1e-15,
        reason="four roundings of numbers up to 1 (v = rate x radius on the way)",
        specials=(STRAIGHT, ON_THE_SPOT, STILL),
    )

    turning_rate = Equation(
        name="differential_drive.turning_rate",
        left=omega,
        right=(v_R - v_L) / b,
        source="exercise 4",
        function=twist_of_speeds,
        component=2,
        arguments=(v_L, v_R, r, b),
        tolerance=2e-14,
        reason="four roundings of numbers up to 2 m/s / 0.05 m = 40 rad/s",
        specials=(STRAIGHT, ON_THE_SPOT, STILL),
    )

    turning_radius = Equation(
        name="differential_drive.turning_radius",
        left=R,
        right=Piecewise(
            (b / 2 * (v_R + v_L) / (v_R - v_L), Ne(v_R, v_L)),
            (oo, Ne(v_L, 0)),
            (nan, True),
        ),
        textbook=b / 2 * ((v_R + v_L) / (v_R - v_L)),
        source="exercise 5",
        function=radius_of_speeds,
        arguments=(v_L, v_R, r, b),
        ranges={v_L: (-1, 0.4), v_R: (0.5, 1)},
        tolerance=2e-14,
        reason="roundings of v/omega: numbers up to 10 m",
        specials=(STRAIGHT, ON_THE_SPOT, STILL),
    )

    body_twist = Equation(
        name="differential_drive.body_twist",
        left=Matrix([v, v_y, omega]),
        right=Matrix([r * (rate_R + rate_L) / 2, 0, r * (rate_R - rate_L) / b]),
        source="exercise 4",
        function=differential_drive.body_twist,
        arguments=(rate_L, rate_R, r, b),
        tolerance=2e-13,
        reason="three roundings of numbers up to 0.5 m x 40 rad/s / 0.05 m = 400 rad/s",
        specials=({rate_L: 3.0, rate_R: 3.0}, {rate_L: -3.0, rate_R: 3.0}),
    )

    wheel_speeds = Equation(
        name="differential_drive.wheel_speeds",
        left=Matrix([v_L, v_R]),
        right=Matrix([v - omega * b / 2, v + omega * b / 2]),
        source="exercise 7 (seed 003)",
        function=speeds_of_twist,
        arguments=(v, omega, r, b),
        tolerance=5e-15,
        reason="four roundings of numbers up to 4 m/s",
        specials=({omega: 0.0}, {v: 0.0}),
    )

    wheel_rates = Equation(
        name="differential_drive.wheel_rates",
        left=Matrix([rate_L, rate_R]),
        right=Matrix([(v - omega * b / 2) / r, (v + omega * b / 2) / r]),
        source="exercise 7 (seed 003)",
        function=differential_drive.wheel_rates,
        arguments=(v, omega, r, b),
        tolerance=5e-13,
        reason="three roundings of numbers up to 4 m/s / 0.01 m = 400 rad/s",
        specials=({omega: 0.0}, {v: 0.0}),
    )
