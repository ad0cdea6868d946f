"""How the library agrees with each formula of `formulas.py`."""

import numpy as np
from numpy.typing import ArrayLike

from book.motion import formulas
from book.motion.formulas import angle, dt, omega, theta, theta_dot, v, v_y, x, x_dot, y, y_dot
from courseware.equations import Array, Check
from robokin import motion

STILL = {v: 0.0, v_y: 0.0, omega: 0.0}
STRAIGHT = ({omega: 0.0}, {omega: 1e-16}, {omega: -1e-16}, {omega: 1e-8})
QUARTERS = tuple({theta: quarter * np.pi / 2} for quarter in (-2, -1, 0, 1, 2))


def one_euler_step(pose: ArrayLike, v: ArrayLike, omega: ArrayLike, dt: ArrayLike) -> Array:
    """The first step of a path that keeps the old heading."""
    return motion.path(pose, v, omega, dt, method="start")[..., 1, :]


def chord_of_the_step(x: Array, y: Array, theta: Array, v: Array, omega: Array, dt: Array) -> Array:
    """The length and the direction of the way from start to end, for less than a whole turn."""
    end = motion.arc_step(np.stack([x, y, theta], axis=-1), v, omega, dt)
    way = motion.to_body(theta, np.stack([end[..., 0] - x, end[..., 1] - y, 0 * x], axis=-1))
    return np.stack(
        [np.hypot(way[..., 0], way[..., 1]), theta + np.arctan2(way[..., 1], way[..., 0])], axis=-1
    )


CHECKS = (
    Check(
        formulas.to_world,
        function=motion.to_world,
        arguments=(theta, (v, v_y, omega)),
        tolerance=1e-15,
        reason="sine, cosine, two products and a sum, each rounded once, of sizes up to 1",
        specials=(*QUARTERS, STILL),
    ),
    Check(
        formulas.to_body,
        function=motion.to_body,
        arguments=(theta, (x_dot, y_dot, theta_dot)),
        tolerance=1e-15,
        reason="as to_world",
        specials=QUARTERS,
    ),
    Check(
        formulas.icr,
        function=motion.icr,
        arguments=((x, y, theta), v, omega),
        ranges={omega: (0.1, 6)},
        tolerance=5e-15,
        reason="a few roundings of numbers up to v/omega = 10",
        specials=({omega: 0.0}, {omega: 0.0, v: 0.0}, {v: 0.0}, {omega: -0.5}, *QUARTERS),
    ),
    Check(
        formulas.arc_step,
        function=motion.arc_step,
        arguments=((x, y, theta), v, omega, dt),
        tolerance=2e-15,
        reason="a rounding of the heading (up to 9 rad), times a chord of at most 1 m",
        specials=(*STRAIGHT, *QUARTERS, {dt: 0.0}, {v: 0.0}),
    ),
    Check(
        formulas.chord,
        function=chord_of_the_step,
        arguments=(x, y, theta, v, omega, dt),
        ranges={v: (0.1, 1), dt: (0.1, 1)},
        tolerance=5e-13,
        reason="a rounding of a place up to 3 m away, over a chord of a tenth of a millimetre",
        specials=({omega: 0.0}, {omega: 1e-12}, *QUARTERS),
    ),
    Check(
        formulas.euler_step,
        function=one_euler_step,
        arguments=((x, y, theta), (v,), (omega,), (dt,)),
        tolerance=1e-15,
        reason="a few roundings of numbers up to 9",
        specials=(*STRAIGHT, {dt: 0.0}),
    ),
    Check(
        formulas.wrap_angle,
        function=motion.wrap_angle,
        arguments=(angle,),
        tolerance=2e-15,
        reason="a rounding of three turns (18.8 rad)",
        specials=({angle: 0.0}, {angle: 3.0}, {angle: -3.0}, {angle: 1e-16}),
    ),
)
