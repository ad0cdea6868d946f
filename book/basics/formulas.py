"""What the course takes as known: the direction of a point, and a turn of the plane."""

import numpy as np
from sympy import MatMul, Matrix, atan2, cos, sin

from book.motion.formulas import theta
from robokin import motion
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

p_x = quantity("p_x", "m", -2, 2, "a point, along x")
p_y = quantity("p_y", "m", -2, 2, "a point, along y")
bearing = quantity("bearing", "rad", -3.14, 3.14, "direction of a point", latex=r"\varphi")
q_x = quantity("q_x", "m", -3, 3, "the turned point, along x", latex=r"p'_x")
q_y = quantity("q_y", "m", -3, 3, "the turned point, along y", latex=r"p'_y")


def turned_point(theta: Array, p: Array) -> Array:
    """A point turned about the origin, as the library turns the position part of a twist."""
    still = np.zeros_like(p[..., :1])
    return motion.to_world(theta, np.concatenate([p, still], axis=-1))[..., :2]


with as_written():
    direction = Equation(
        name="basics.direction",
        left=bearing,
        right=atan2(p_y, p_x),
        source="conventions of the exercises",
        function=np.arctan2,
        arguments=(p_y, p_x),
        tolerance=1e-15,
        reason="one rounding of a number up to pi, and that of the input",
        specials=({p_x: -1.0, p_y: 1.0}, {p_x: -1.0, p_y: -1.0}, {p_x: 0.0, p_y: 1.0}),
        is_angle=True,
    )

    turned = Equation(
        name="basics.turned",
        left=Matrix([q_x, q_y]),
        right=Matrix([p_x * cos(theta) - p_y * sin(theta), p_x * sin(theta) + p_y * cos(theta)]),
        textbook=MatMul(
            Matrix([[cos(theta), -sin(theta)], [sin(theta), cos(theta)]]), Matrix([p_x, p_y])
        ),
        source="conventions of the exercises",
        function=turned_point,
        arguments=(theta, (p_x, p_y)),
        tolerance=2e-15,
        reason="sine, cosine, two products and a sum, each rounded once, of sizes up to 2",
        specials=({theta: 0.0}, {theta: np.pi / 2}, {theta: np.pi}),
    )
