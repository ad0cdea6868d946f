"""Differential drive: the robot's velocity from its wheels, and back."""

from sympy import Matrix, Ne, Piecewise, nan, oo

from book.motion.formulas import omega, theta, theta_m, v, v_y, x_dot, y_dot
from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

rate_L = quantity(
    "rate_L", "rad/s", -20, 20, "left rate: how fast the left wheel turns", latex=r"\dot\varphi_L"
)
rate_R = quantity(
    "rate_R", "rad/s", -20, 20, "right rate: how fast the right wheel turns", latex=r"\dot\varphi_R"
)
v_L = quantity("v_L", "m/s", -1, 1, "left wheel: its speed over the floor")
v_R = quantity("v_R", "m/s", -1, 1, "right wheel: its speed over the floor")
r = quantity("r", "m", 0.01, 0.5, "wheel radius")
b = quantity("b", "m", 0.05, 1, "distance between the wheels, the whole of it")
R = quantity("R", "m", -10, 10, "turning radius: how far to the left the ICR lies")
rate = symbol("rate", "rate of a wheel", r"\dot\varphi", "rad/s")
phi = symbol("phi", "how far a wheel has turned on its axle", r"\varphi", "rad")
u = symbol("u", "half of the angle that is turned in a step", unit="rad")

LOOKS = {
    v_L: "left",
    v_R: "right",
    rate_L: "left",
    rate_R: "right",
    v: "velocity",
    omega: "turning",
    R: "icr",
    theta: "heading",
    theta_m: "middle_heading",
    u: "middle_heading",
    x_dot: "x_axis",
    y_dot: "y_axis",
    b: "length",
    r: "length",
}

with as_written():
    speed = Equation(
        name="differential_drive.speed",
        left=v,
        right=(v_R + v_L) / 2,
    )

    about_icr = Equation(
        name="differential_drive.about_icr",
        left=Matrix([v_L, v_R]),
        right=Matrix([omega * (R - b / 2), omega * (R + b / 2)]),
    )

    turning_rate = Equation(
        name="differential_drive.turning_rate",
        left=omega,
        right=(v_R - v_L) / b,
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
    )

    body_twist = Equation(
        name="differential_drive.body_twist",
        left=Matrix([v, v_y, omega]),
        right=Matrix([r * (rate_R + rate_L) / 2, 0, r * (rate_R - rate_L) / b]),
    )

    wheel_speeds = Equation(
        name="differential_drive.wheel_speeds",
        left=Matrix([v_L, v_R]),
        right=Matrix([v - omega * b / 2, v + omega * b / 2]),
    )

    wheel_rates = Equation(
        name="differential_drive.wheel_rates",
        left=Matrix([rate_L, rate_R]),
        right=Matrix([(v - omega * b / 2) / r, (v + omega * b / 2) / r]),
    )
