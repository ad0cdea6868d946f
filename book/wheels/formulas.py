"""Wheel constraints: what each kind of wheel demands, mobility, and the omni robot."""
# ruff: noqa: E741  (l is the field's own name)

from typing import Any

from sympy import MatMul, Matrix, Max, Min, Rational, cos, sin, sqrt

from book.differential_drive.formulas import r
from book.motion.formulas import (
    omega,
    rotation,
    theta,
    theta_dot,
    v,
    v_y,
    x_dot,
    y_dot,
)
from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

l = quantity("wheel_l", "m", 0, 1, "distance of a wheel from the robot's centre", latex="l")
alpha = quantity(
    "wheel_alpha",
    "rad",
    -3.14,
    3.14,
    "from the robot's x axis to a wheel's spoke",
    r"\alpha",
    "alpha",
)
beta = quantity(
    "wheel_beta", "rad", -3.14, 3.14, "from a wheel's spoke to its axle", r"\beta", "beta"
)
gamma = quantity(
    "wheel_gamma", "rad", -1.4, 1.4, "angle of the rollers on a Swedish wheel", r"\gamma", "gamma"
)
d = quantity("castor_d", "m", -0.2, -0.02, "from a castor's pivot to its contact point", "d")
rate = quantity("wheel_rate", "rad/s", -20, 20, "rate of a wheel", latex=r"\dot\varphi")
omni_rates = [
    quantity(f"omni_rate{k}", "rad/s", -20, 20, f"rate of wheel {k}", latex=rf"\dot\varphi_{k}")
    for k in (1, 2, 3)
]

omni_rate4 = quantity("omni_rate4", "rad/s", -20, 20, "rate of wheel 4", latex=r"\dot\varphi_4")
determinant = symbol("det", "determinant of the omni robot's rolling rows", r"\det J_1", "m")
slip = symbol("slip", "speed at which a wheel slips along its roller's axis", "s", "m/s")
x_Q = quantity("x_Q", "m", -1, 1, "how far ahead of the robot's centre the ICR is")
y_Q = quantity("y_Q", "m", -1, 1, "how far to the left of the robot's centre the ICR is")

hub_x = symbol("v_hx", "velocity of a wheel's hub, ahead", "v_{hx}", "m/s")
hub_y = symbol("v_hy", "velocity of a wheel's hub, to the left", "v_{hy}", "m/s")
across = symbol("v_axle", "velocity of a wheel's hub along its axle", r"v_\mathrm{axle}", "m/s")
from_push = symbol("p", "how far to the left of the push line the ICR is", unit="m")
from_axle = symbol("a", "how far to the left of the axle line the ICR is", unit="m")
beta_dot = symbol("beta_dot", "rate at which a castor swivels", r"\dot{\beta}", "rad/s")
beta_s = symbol("beta_s", "the angles β of the steered wheels", r"\beta_s", "rad")
delta_m = symbol("delta_m", "degree of mobility", r"\delta_m")
delta_s = symbol("delta_s", "degree of steerability", r"\delta_s")
delta_M = symbol("delta_M", "degree of manoeuvrability", r"\delta_M")
J_1 = symbol("J_1", "the rolling rows of all wheels", code="J1")
J_2 = symbol(
    "J_2",
    "r cos γ of each wheel on the diagonal: how far it drives the robot along the roller's axis "
    "at a rate of 1",
    code="J2",
)
rates = symbol("rates", "the rates of all wheels, a column", r"\boldsymbol{\dot\varphi}", "rad/s")
C_1 = symbol("C_1", "the sliding rows of fixed and steered wheels")
C_1f = symbol("C_1f", "the sliding rows of the fixed wheels", "C_{1f}")
C_1s = symbol("C_1s", "the sliding rows of the steered wheels", "C_{1s}")
R = symbol("R", "the matrix that takes a velocity from the world to the robot")
Q = symbol("Q", "the ICR, the point that the robot turns about")
half_sum = symbol("k", "half a robot's length plus half its width", unit="m")
delta = symbol("delta", "angle by which a car's front wheel is turned", r"\delta", "rad")
L = symbol("L", "wheelbase of a car", unit="m")
x, y = (symbol(f"{axis}_axis", f"the robot's {axis} axis", axis) for axis in "xy")
xi_dot = symbol("xi_dot", "velocity of the robot in the world", r"\dot\xi_I")
rank_fixed = quantity(
    "rank_fixed", "", 0, 3, "independent sliding rows of the fixed wheels",
    latex=r"\operatorname{rank}C_{1f}",
)  # fmt: skip
rank_steered = quantity(
    "rank_steered", "", 0, 3, "independent sliding rows of the steered wheels",
    latex=r"\operatorname{rank}C_{1s}",
)  # fmt: skip


def sliding_row(l: Any, alpha: Any, beta: Any) -> list[Any]:
    """A row of C1."""
    return [cos(alpha + beta), sin(alpha + beta), l * sin(beta)]


def rolling_row(l: Any, alpha: Any, beta: Any) -> list[Any]:
    """A row of J1."""
    return [sin(alpha + beta), -cos(alpha + beta), -l * cos(beta)]


LOOKS = {
    v: "velocity", v_y: "velocity", hub_x: "velocity", hub_y: "velocity",
    omega: "turning", rate: "left", across: "error", beta_dot: "turning",
    from_push: "left", from_axle: "icr", x_Q: "icr", y_Q: "icr", l: "length", d: "length",
    r: "length", alpha: "middle_heading", beta: "heading", gamma: "new_heading", theta: "heading",
    omni_rates[0]: "left", omni_rates[1]: "right", omni_rates[2]: "turning",
    x_dot: "x_axis", y_dot: "y_axis",
}  # fmt: skip

half, third = Rational(1, 2), Rational(1, 3)
J1 = Matrix([[0, -1, -l], [sqrt(3) / 2, half, -l], [-(sqrt(3) / 2), half, -l]])
J1_inverse = Matrix(
    [
        [0, sqrt(3) / 3, -sqrt(3) / 3],
        [-2 * third, third, third],
        [-1 / (3 * l), -1 / (3 * l), -1 / (3 * l)],
    ]
)

with as_written():
    SUM = alpha + beta + gamma
    STEERABLE = Max(0, Min(rank_steered, 2 - rank_fixed))

    hub = Equation(
        name="wheels.hub_velocity",
        left=Matrix([hub_x, hub_y]),
        right=Matrix([v - omega * l * sin(alpha), v_y + omega * l * cos(alpha)]),
    )

    rolling = Equation(
        name="wheels.rolling",
        left=r * rate,
        right=v * sin(alpha + beta) - v_y * cos(alpha + beta) - omega * l * cos(beta),
        textbook=MatMul(Matrix([rolling_row(l, alpha, beta)]), Matrix([v, v_y, omega])),
    )

    sliding = Equation(
        name="wheels.sliding",
        left=across,
        right=v * cos(alpha + beta) + v_y * sin(alpha + beta) + omega * l * sin(beta),
        textbook=MatMul(Matrix([sliding_row(l, alpha, beta)]), Matrix([v, v_y, omega])),
    )

    axle_distance = -x_Q * sin(alpha + beta) + y_Q * cos(alpha + beta) + l * sin(beta)
    push_distance = x_Q * cos(alpha + beta) + y_Q * sin(alpha + beta) - l * cos(beta)
    roller_distance = x_Q * cos(SUM) + y_Q * sin(SUM) - l * cos(beta + gamma)

    sliding_by_distance = Equation(
        name="wheels.sliding_by_distance",
        left=Matrix([from_axle, across]),
        right=Matrix([axle_distance, omega * from_axle]),
        where=((from_axle, axle_distance),),
    )

    rolling_by_distance = Equation(
        name="wheels.rolling_by_distance",
        left=Matrix([from_push, rate]),
        right=Matrix([push_distance, omega * from_push / r]),
        where=((from_push, push_distance),),
    )

    swedish_by_distance = Equation(
        name="wheels.swedish_by_distance",
        left=Matrix([from_push, rate]),
        right=Matrix([roller_distance, omega * from_push / (r * cos(gamma))]),
        where=((from_push, roller_distance),),
    )

    castor = Equation(
        name="wheels.castor",
        left=-d * beta_dot,
        right=v * cos(alpha + beta) + v_y * sin(alpha + beta) + omega * (d + l * sin(beta)),
    )

    swedish = Equation(
        name="wheels.swedish",
        left=r * rate * cos(gamma),
        right=v * sin(alpha + beta + gamma)
        - v_y * cos(alpha + beta + gamma)
        - omega * l * cos(beta + gamma),
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
                -(sqrt(3) / 2 * v) + v_y / 2 - l * omega,
            ]
        ),
        textbook=MatMul(J1, Matrix([v, v_y, omega])),
    )

    omni_wheel_rates = Equation(
        name="wheels.omni_rates",
        left=Matrix([rate1, rate2, rate3]),
        right=Matrix(
            [
                (-v_y - l * omega) / r,
                (sqrt(3) / 2 * v + v_y / 2 - l * omega) / r,
                (-(sqrt(3) / 2 * v) + v_y / 2 - l * omega) / r,
            ]
        ),
    )

    omni_twist = Equation(
        name="wheels.omni_twist",
        left=Matrix([v, v_y, omega]),
        right=Matrix([omni_v, omni_v_y, omni_omega]),
        textbook=MatMul(J1_inverse, rolled_by_rates),
    )

    omni_world = Equation(
        name="wheels.omni_world",
        left=Matrix([x_dot, y_dot, theta_dot]),
        right=Matrix([v * cos(theta) - v_y * sin(theta), v * sin(theta) + v_y * cos(theta), omega]),
        textbook=MatMul(rotation, Matrix([v, v_y, omega])),
        where=((v, omni_v), (v_y, omni_v_y), (omega, omni_omega)),
    )

    omni_determinant = Equation(
        name="wheels.omni_determinant",
        left=determinant,
        right=-(3 * sqrt(3) / 2 * l * cos(beta)),
    )

    mecanum_slip = Equation(
        name="wheels.mecanum_slip",
        left=slip,
        right=-r * sqrt(2) / 8 * (rate1 + rate2 - rate3 - omni_rate4),
    )

    mobility = Equation(
        name="wheels.mobility",
        left=Matrix([delta_s, delta_m, delta_M]),
        right=Matrix([STEERABLE, 3 - rank_fixed - delta_s, delta_m + delta_s]),
        where=((delta_s, STEERABLE), (delta_m, 3 - rank_fixed - delta_s)),
    )
