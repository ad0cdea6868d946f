"""How the library agrees with each formula of `formulas.py`."""

import numpy as np

from book.basics import formulas
from book.basics.formulas import p_x, p_y, theta
from courseware.equations import Array, Check
from robokin import motion


def turned_point(theta: Array, p: Array) -> Array:
    """A point turned about the origin, as the library turns the position part of a twist."""
    still = np.zeros_like(p[..., :1])
    return motion.to_world(theta, np.concatenate([p, still], axis=-1))[..., :2]


CHECKS = (
    Check(
        formulas.direction,
        function=np.arctan2,
        arguments=(p_y, p_x),
        tolerance=1e-15,
        reason="one rounding of a number up to pi, and that of the input",
        specials=({p_x: -1.0, p_y: 1.0}, {p_x: -1.0, p_y: -1.0}, {p_x: 0.0, p_y: 1.0}),
    ),
    Check(
        formulas.turned,
        function=turned_point,
        arguments=(theta, (p_x, p_y)),
        tolerance=2e-15,
        reason="sine, cosine, two products and a sum, each rounded once, of sizes up to 2",
        specials=({theta: 0.0}, {theta: np.pi / 2}, {theta: np.pi}),
    ),
)
