"""How the library agrees with each formula of `formulas.py`."""

from numpy.typing import ArrayLike

from book.differential_drive import formulas
from book.differential_drive.formulas import R, b, r, rate_L, rate_R, v_L, v_R
from book.motion.formulas import omega, v
from courseware.equations import Array, Check
from robokin import differential_drive

STRAIGHT = {v_L: 0.25, v_R: 0.25, r: 0.03, b: 0.1}
ON_THE_SPOT = {v_L: -0.25, v_R: 0.25}
STILL = {v_L: 0.0, v_R: 0.0}


def twist_of_speeds(v_L: Array, v_R: Array, r: Array, b: Array) -> Array:
    """The body twist from wheel speeds, where a formula is written in speeds and not in rates."""
    return differential_drive.body_twist(v_L / r, v_R / r, r, b)


def speeds_of_twist(v: ArrayLike, omega: ArrayLike, r: Array, b: Array) -> Array:
    """The wheel speeds [left, right] from the wheel rates."""
    return r[..., None] * differential_drive.wheel_rates(v, omega, r, b)


def speeds_about_icr(omega: Array, R: Array, r: Array, b: Array) -> Array:
    """The wheel speeds [left, right] of a turn about an ICR."""
    return speeds_of_twist(omega * R, omega, r, b)


CHECKS = (
    Check(
        formulas.speed,
        function=twist_of_speeds,
        component=0,
        arguments=(v_L, v_R, r, b),
        tolerance=1e-15,
        reason="four roundings of numbers up to 1 (v = rate x radius on the way)",
        specials=(STRAIGHT, ON_THE_SPOT, STILL),
    ),
    Check(
        formulas.about_icr,
        function=speeds_about_icr,
        arguments=(omega, R, r, b),
        tolerance=5e-14,
        reason="five roundings of numbers up to 6 rad/s x 10.5 m = 63 m/s",
        specials=({omega: 0.0}, {R: 0.0}, {R: 0.05, b: 0.1}),
    ),
    Check(
        formulas.turning_rate,
        function=twist_of_speeds,
        component=2,
        arguments=(v_L, v_R, r, b),
        tolerance=2e-14,
        reason="four roundings of numbers up to 2 m/s / 0.05 m = 40 rad/s",
        specials=(STRAIGHT, ON_THE_SPOT, STILL),
    ),
    Check(
        formulas.turning_radius,
        function=differential_drive.turning_radius,
        arguments=(v_L, v_R, b),
        ranges={v_L: (-1, 0.4), v_R: (0.5, 1)},
        tolerance=2e-14,
        reason="roundings of v/omega: numbers up to 10 m",
        specials=({v_L: 0.25, v_R: 0.25, b: 0.1}, ON_THE_SPOT, STILL),
    ),
    Check(
        formulas.body_twist,
        function=differential_drive.body_twist,
        arguments=(rate_L, rate_R, r, b),
        tolerance=2e-13,
        reason="three roundings of numbers up to 0.5 m x 40 rad/s / 0.05 m = 400 rad/s",
        specials=({rate_L: 3.0, rate_R: 3.0}, {rate_L: -3.0, rate_R: 3.0}),
    ),
    Check(
        formulas.wheel_speeds,
        function=speeds_of_twist,
        arguments=(v, omega, r, b),
        tolerance=5e-15,
        reason="four roundings of numbers up to 4 m/s",
        specials=({omega: 0.0}, {v: 0.0}),
    ),
    Check(
        formulas.wheel_rates,
        function=differential_drive.wheel_rates,
        arguments=(v, omega, r, b),
        tolerance=5e-13,
        reason="three roundings of numbers up to 4 m/s / 0.01 m = 400 rad/s",
        specials=({omega: 0.0}, {v: 0.0}),
    ),
)
