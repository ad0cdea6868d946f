"""Wheel constraints: what each kind of wheel demands, mobility, and the omni robot."""
# ruff: noqa: E741  (l is the field's own name)

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from sympy import Add, MatMul, Matrix, Max, Min, Rational, Symbol, cos, sin, sqrt

from book.differential_drive.formulas import r
from book.motion.formulas import (
    QUARTERS,
    omega,
    rotation,
    theta,
    theta_dot,
    v,
    v_y,
    x_dot,
    y_dot,
)
from robokin import wheels
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

l = quantity("wheel_l", "m", 0, 1, "distance of a wheel from the robot's centre", latex="l")
alpha = quantity(
    "wheel_alpha", "rad", -3.14, 3.14, "from the robot's x axis to a wheel's spoke", latex=r"\alpha"
)
beta = quantity(
    "wheel_beta", "rad", -3.14, 3.14, "from a wheel's spoke to its axle", latex=r"\beta"
)
gamma = quantity(
    "wheel_gamma", "rad", -1.4, 1.4, "angle of the rollers on a Swedish wheel", latex=r"\gamma"
)
d = quantity("castor_d", "m", -0.2, -0.02, "from a castor's pivot to its contact point", latex="d")
rate = quantity("wheel_rate", "rad/s", -20, 20, "rate of a wheel", latex=r"\dot\varphi")
omni_rates = [
    quantity(f"omni_rate{k}", "rad/s", -20, 20, f"rate of wheel {k}", latex=rf"\dot\varphi_{k}")
    for k in (1, 2, 3)
]

contact_x, contact_y, across = Symbol("c_x"), Symbol("c_y"), Symbol(r"v_\mathrm{axle}")
beta_dot = Symbol(r"\dot{\beta}")
delta_m, delta_s, delta_M = Symbol(r"\delta_m"), Symbol(r"\delta_s"), Symbol(r"\delta_M")
rank_fixed = quantity(
    "rank_fixed", "", 0, 3, "independent sliding rows of the fixed wheels",
    latex=r"\operatorname{rank}C_{1f}",
)  # fmt: skip
rank_steered = quantity(
    "rank_steered", "", 0, 3, "independent sliding rows of the steered wheels",
    latex=r"\operatorname{rank}C_{1s}",
)  # fmt: skip

AT_CENTRE, ON_SPOKE = {l: 0.0}, {beta: 0.0}
LEFT_WHEEL, RIGHT_WHEEL = {alpha: np.pi / 2, beta: 0.0}, {alpha: -np.pi / 2, beta: np.pi}
APART = {l: (0.05, 1.0)}
ALIKE, SIDEWAYS, AHEAD = (
    dict(zip(omni_rates, rates, strict=True)) for rates in ([2, 2, 2], [-4, 2, 2], [0, 3, -3])
)
PLACES = (AT_CENTRE, ON_SPOKE, LEFT_WHEEL, RIGHT_WHEEL)


def times(rows: Callable[..., Array], make: Callable[..., wheels.Wheel]) -> Callable[..., Array]:
    """For many wheels: the row of each (`rolling`, `sliding`) times a twist of its own."""

    def speeds(places: Array, twists: Array) -> Array:
        pairs = zip(places, twists, strict=True)
        return np.array([rows([make(*place)])[0] @ twist for place, twist in pairs])

    return speeds


def a_fixed_wheel(l: float, alpha: float, beta: float) -> wheels.Wheel:
    """A wheel of radius 1 m: what it rolls in a second is its rate."""
    return wheels.fixed(l, alpha, beta, 1.0)


def a_swedish_wheel(l: float, alpha: float, beta: float, gamma: float) -> wheels.Wheel:
    """The same with rollers."""
    return wheels.swedish(l, alpha, beta, 1.0, gamma)


rolled = times(wheels.rolling, a_fixed_wheel)
slid = times(wheels.sliding, a_fixed_wheel)
swedish_rolled = times(wheels.rolling, a_swedish_wheel)


def contact_velocity(l: Array, alpha: Array, twists: Array) -> Array:
    """A wheel whose axle points along the body's y axis rolls along x and slides along y."""
    places = np.stack([l, alpha, np.pi / 2 - alpha], axis=-1)
    return np.stack([rolled(places, twists), slid(places, twists)], axis=-1)


def castor_slid(l: Array, alpha: Array, beta: Array, d: Array, twists: Array) -> Array:
    """What a castor would slide if it did not turn: a fixed wheel at its contact point."""
    x = l * np.cos(alpha) + d * np.sin(alpha + beta)
    y = l * np.sin(alpha) - d * np.cos(alpha + beta)
    there = np.arctan2(y, x)
    return slid(np.stack([np.hypot(x, y), there, alpha + beta - there], axis=-1), twists)


def omni_speeds(l: Array, twists: Array) -> Array:
    """What the wheels of omni robots roll in a second, (n, 3)."""
    pairs = zip(l, twists, strict=True)
    return np.array([wheels.inverse(wheels.omni_robot(size, 1.0), twist) for size, twist in pairs])


def omni_motion(l: Array, r: Array, rates: Array, theta: ArrayLike = 0.0) -> Array:
    """The velocity of omni robots in the world, (n, 3)."""
    rows = zip(l, r, rates, np.broadcast_to(theta, l.shape), strict=True)
    return np.array([wheels.forward(wheels.omni_robot(a, b), c, None, e) for a, b, c, e in rows])


def sliding_row(l: Any, alpha: Any, beta: Any) -> list[Any]:
    """A row of C1."""
    return [cos(alpha + beta), sin(alpha + beta), l * sin(beta)]


def rolling_row(l: Any, alpha: Any, beta: Any) -> list[Any]:
    """A row of J1."""
    return [sin(alpha + beta), -cos(alpha + beta), -l * cos(beta)]


half, third = Rational(1, 2), Rational(1, 3)
J1 = Matrix([[0, -1, -l], [sqrt(3) / 2, half, -l], [-sqrt(3) / 2, half, -l]])
J1_inverse = Matrix(
    [
        [0, sqrt(3) / 3, -sqrt(3) / 3],
        [-2 * third, third, third],
        [-1 / (3 * l), -1 / (3 * l), -1 / (3 * l)],
    ]
)

with as_written():
    SUM = Add(alpha, beta, gamma)
    STEERABLE = Max(0, Min(rank_steered, 2 - rank_fixed))

    contact = Equation(
        name="wheels.contact_velocity",
        left=Matrix([contact_x, contact_y]),
        right=Matrix([v - omega * l * sin(alpha), v_y + omega * l * cos(alpha)]),
        source="exercise 6",
        function=contact_velocity,
        arguments=(l, alpha, (v, v_y, omega)),
        tolerance=2e-14,
        reason="sines, cosines, products and sums, each rounded once, of sizes up to 7",
        specials=(AT_CENTRE, {omega: 0.0}, *({alpha: k * np.pi / 2} for k in (-1, 1, 2))),
    )

    rolling = Equation(
        name="wheels.rolling",
        left=r * rate,
        right=v * sin(alpha + beta) - v_y * cos(alpha + beta) - omega * l * cos(beta),
        textbook=MatMul(Matrix([rolling_row(l, alpha, beta)]), Matrix([v, v_y, omega])),
        source="exercise 6",
        function=rolled,
        arguments=((l, alpha, beta), (v, v_y, omega)),
        tolerance=1e-14,
        reason="the angle, sines, cosines, products and sums, each rounded once, of sizes up to 8",
        specials=PLACES,
    )

    sliding = Equation(
        name="wheels.sliding",
        left=across,
        right=v * cos(alpha + beta) + v_y * sin(alpha + beta) + omega * l * sin(beta),
        textbook=MatMul(Matrix([sliding_row(l, alpha, beta)]), Matrix([v, v_y, omega])),
        source="exercise 6",
        function=slid,
        arguments=((l, alpha, beta), (v, v_y, omega)),
        tolerance=1e-14,
        reason="as wheels.rolling",
        specials=PLACES,
    )

    castor = Equation(
        name="wheels.castor",
        left=-d * beta_dot,
        right=Add(v * cos(alpha + beta), v_y * sin(alpha + beta), omega * (d + l * sin(beta))),
        source="exercise 6",
        function=castor_slid,
        arguments=(l, alpha, beta, d, (v, v_y, omega)),
        tolerance=2e-14,
        reason="as wheels.rolling, through the contact point's place",
        specials=(ON_SPOKE, LEFT_WHEEL, RIGHT_WHEEL),
    )

    swedish = Equation(
        name="wheels.swedish",
        left=r * rate * cos(gamma),
        right=v * sin(alpha + beta + gamma)
        - v_y * cos(alpha + beta + gamma)
        - omega * l * cos(beta + gamma),
        textbook=MatMul(
            Matrix([[sin(SUM), -cos(SUM), -l * cos(beta + gamma)]]), Matrix([v, v_y, omega])
        ),
        source="exercise 6",
        function=swedish_rolled,
        arguments=((l, alpha, beta, gamma), (v, v_y, omega)),
        tolerance=2e-14,
        reason="as wheels.rolling",
        specials=(*PLACES, {gamma: 0.0}, {gamma: np.pi / 4}),
    )

    rate1, rate2, rate3 = omni_rates
    rolled_by_rates = Matrix([r * rate1, r * rate2, r * rate3])
    omni_v = r * sqrt(3) / 3 * (rate2 - rate3)
    omni_v_y = r * (rate2 + rate3 - 2 * rate1) / 3
    omni_omega = -r * (rate1 + rate2 + rate3) / (3 * l)

    omni_rolling = Equation(
        name="wheels.omni_rolling",
        left=rolled_by_rates,
        right=Matrix(
            [
                -v_y - l * omega,
                sqrt(3) / 2 * v + v_y / 2 - l * omega,
                -sqrt(3) / 2 * v + v_y / 2 - l * omega,
            ]
        ),
        textbook=MatMul(J1, Matrix([v, v_y, omega])),
        source="exercise 6",
        function=omni_speeds,
        arguments=(l, (v, v_y, omega)),
        tolerance=1e-14,
        reason="sines of 120°, products and sums, each rounded once, of sizes up to 8",
        specials=({omega: 0.0}, {v: 0.0, v_y: 0.0}, AT_CENTRE),
    )

    omni_twist = Equation(
        name="wheels.omni_twist",
        left=Matrix([v, v_y, omega]),
        right=Matrix([omni_v, omni_v_y, omni_omega]),
        textbook=MatMul(J1_inverse, rolled_by_rates),
        source="exercise 6",
        function=omni_motion,
        arguments=(l, r, (rate1, rate2, rate3)),
        ranges=APART,
        tolerance=1e-12,
        reason="a matrix inverted numerically; rates of turning up to 200 rad/s",
        specials=(ALIKE, SIDEWAYS, AHEAD),
    )

    omni_world = Equation(
        name="wheels.omni_world",
        left=Matrix([x_dot, y_dot, theta_dot]),
        right=Matrix(
            [
                omni_v * cos(theta) - omni_v_y * sin(theta),
                omni_v * sin(theta) + omni_v_y * cos(theta),
                omni_omega,
            ]
        ),
        textbook=MatMul(rotation, J1_inverse, rolled_by_rates),
        source="exercise 6",
        function=omni_motion,
        arguments=(l, r, (rate1, rate2, rate3), theta),
        ranges=APART,
        tolerance=1e-12,
        reason="as wheels.omni_twist",
        specials=(ALIKE, SIDEWAYS, AHEAD, *QUARTERS),
    )

    mobility = Equation(
        name="wheels.mobility",
        left=Matrix([delta_s, delta_m, delta_M]),
        right=Matrix([STEERABLE, Add(3, -rank_fixed, -delta_s), delta_m + delta_s]),
        where=((delta_s, STEERABLE), (delta_m, Add(3, -rank_fixed, -delta_s))),
        source="exercise 6",
        checked_by="tests/test_wheels.py::test_mobility_is_what_the_ranks_say",
        tolerance=1e-12,
        reason="whole numbers",
    )
