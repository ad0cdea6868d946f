"""Odometry: from the ticks of two wheel encoders to the robot's pose, and how sure that is."""

from typing import Any

from sympy import Abs, Matrix, Mod, Piecewise, Symbol, cos, pi, sin, sinc, sqrt, symbols

from book.differential_drive.formulas import b, r
from book.motion.formulas import dt, omega, theta, theta_next, v, x, x_next, y, y_next
from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

N_L = quantity("N_L", "ticks", -1000, 1000, "ticks of the left encoder in a sample")
N_R = quantity("N_R", "ticks", -1000, 1000, "ticks of the right encoder in a sample")
C = quantity("C", "ticks", 100, 5000, "ticks of an encoder in one turn of its wheel")
D_L = quantity("D_L", "m", -1, 1, "how far the left wheel rolls in a sample")
D_R = quantity("D_R", "m", -1, 1, "how far the right wheel rolls in a sample")
D = quantity("D", "m", -1, 1, "how far the middle of the axle moves in a sample")
dtheta = quantity(
    "dtheta", "rad", -3.14, 3.14, "how much the robot turns in a sample", latex=r"\Delta\theta"
)

count_before = quantity("count_before", "ticks", 0, 60000, "a counter's reading", latex="c")
count_now = quantity("count_now", "ticks", 0, 60000, "the reading after the step", latex="c'")
counter_span = quantity(
    "counter_span", "ticks", 4, 1e6, "numbers that a counter of m bits can show", latex="2^m"
)

noise = quantity("noise", "m", 0, 0.01, "variance of a wheel's travel per metre", "k", "k")
p_xx = quantity("p_xx", "m²", 0, 0.1, "variance of x", latex=r"\Sigma_{xx}")
p_xy = quantity("p_xy", "m²", -0.1, 0.1, "covariance of x and y", latex=r"\Sigma_{xy}")
p_xt = quantity("p_xt", "m rad", -0.1, 0.1, "covariance of x and θ", latex=r"\Sigma_{x\theta}")
p_yy = quantity("p_yy", "m²", 0, 0.1, "variance of y", latex=r"\Sigma_{yy}")
p_yt = quantity("p_yt", "m rad", -0.1, 0.1, "covariance of y and θ", latex=r"\Sigma_{y\theta}")
p_tt = quantity("p_tt", "rad²", 0, 0.1, "variance of θ", latex=r"\Sigma_{\theta\theta}")

side = quantity("side", "m", 1, 5, "side of the square in a calibration", latex="L")
x_cw = quantity("x_cw", "m", -0.4, 0.4, "where clockwise runs end, x", latex=r"x_\mathrm{cw}")
y_cw = quantity("y_cw", "m", -0.4, 0.4, "where clockwise runs end, y", latex=r"y_\mathrm{cw}")
x_ccw = quantity(
    "x_ccw", "m", -0.4, 0.4, "where counter-clockwise runs end, x", latex=r"x_\mathrm{ccw}"
)
y_ccw = quantity(
    "y_ccw", "m", -0.4, 0.4, "where counter-clockwise runs end, y", latex=r"y_\mathrm{ccw}"
)
short_turn = quantity(
    "short_turn", "rad", -0.2, 0.2, "angle by which a corner turns too little", latex=r"\alpha"
)
side_swing = quantity(
    "side_swing", "rad", -0.2, 0.2, "angle by which a side swings to the left", latex=r"\beta"
)
b_true = quantity("b_true", "m", 0.05, 1, "wheel distance after calibration", r"b_\mathrm{true}")
ratio = quantity("ratio", "", 0.9, 1.1, "diameter of the right wheel by the left", latex="E_d")

slip = quantity(
    "slip", "m", -0.1, 0.1, "slip: what a wheel counts and the robot does not drive", r"\varepsilon"
)
lever = quantity("lever", "m", 0.5, 3, "lever: from the other wheel's contact to the end", r"\ell")
swing = symbol("swing", "swing: how far the rest of the drive turns", r"\delta", "rad")
hinge_lever_L = symbol("lever_L", "lever from the left wheel's contact to the end", r"\ell_L", "m")
hinge_lever_R = symbol("lever_R", "lever from the right wheel's contact to the end", r"\ell_R", "m")
left_to_drive = symbol("left_to_drive", "how far is left to drive", "q", "m")
unit_i = symbol("unit_i", "a quarter turn to the left: the number whose square is −1", "i")
shift = symbol("shift", "shift of the end by a slip", "e_s", "m")
l_x = quantity("l_x", "m", -1, 1, "from the robot to the end of its drive, along x", r"\ell_x")
l_y = quantity("l_y", "m", -1, 1, "from the robot to the end of its drive, along y", r"\ell_y")
lever_L, lever_R = (
    tuple(
        symbol(
            f"l_{wheel}{axis}",
            f"from the {name} wheel's contact to the end, along {axis}",
            rf"\ell_{{{wheel}{axis}}}",
            "m",
        )
        for axis in "xy"
    )
    for wheel, name in (("L", "left"), ("R", "right"))
)
drive = quantity("drive", "m", 0.25, 3, "how far the robot drives", latex="s")
sigma_theta = symbol("sigma_theta", "standard deviation of the heading", r"\sigma_\theta", "rad")
sigma_y = symbol("sigma_y", "standard deviation across the drive", r"\sigma_y", "m")

LOOKS = {
    N_L: "left",
    N_R: "right",
    D_L: "left",
    D_R: "right",
    D: "path",
    dtheta: "turning",
    slip: "error",
    swing: "turning",
    lever: "icr",
    shift: "error",
    drive: "path",
    b_true: "length",
    ratio: "right",
    sigma_theta: "turning",
    sigma_y: "uncertainty",
}

long_axis, short_axis = symbols(r"\sigma_1 \sigma_2")
dN = symbol("dN", "ticks between two readings", r"\Delta N", "ticks")
bits = symbol("m", "bits of a counter")
N = symbol("N", "ticks of an encoder", unit="ticks")
rho = symbol("rho", "distance of the left wheel from the centre of the arc", r"\rho", "m")
Sigma = symbol("Sigma", "covariance of the pose", r"\Sigma")
Sigma_next = symbol("Sigma_next", "covariance after the step", r"\Sigma'")
F = symbol("F", "derivative of the new pose with respect to the old one")
G = symbol("G", "derivative of the new pose with respect to the travel of the wheels")
error = symbol("pose_error", "small errors of the pose", "e")
covariance_entries = (p_xx, p_xy, p_xt, p_yy, p_yt, p_tt)
p_next = tuple(
    symbol(
        f"{entry}_next",
        f"{entry.meaning}, after a piece of the drive",
        f"{entry.latex}'",
        entry.unit,
    )
    for entry in covariance_entries
)
p_piece = tuple(
    symbol(
        f"{entry}_piece",
        f"what a piece of the drive adds to the {entry.meaning}",
        rf"\Delta{entry.latex}",
        entry.unit,
    )
    for entry in (p_xx, p_xy, p_yy)
)


def one_sample(name: str, heading: Any) -> Equation:
    """The rule that lays all of a sample's travel along one heading."""
    return Equation(
        name=f"odometry.{name}",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix([x + D * cos(heading), y + D * sin(heading), theta + dtheta]),
    )


with as_written():
    travel = Equation(
        name="odometry.travel",
        left=Matrix([D_L, D_R]),
        right=Matrix([2 * pi * r * N_L / C, 2 * pi * r * N_R / C]),
    )

    distance = Equation(
        name="odometry.distance",
        left=D,
        right=(D_R + D_L) / 2,
    )

    turn = Equation(
        name="odometry.turn",
        left=dtheta,
        right=(D_R - D_L) / b,
    )

    velocity = Equation(
        name="odometry.velocity",
        left=Matrix([v, omega]),
        right=Matrix([(D_R + D_L) / (2 * dt), (D_R - D_L) / (b * dt)]),
    )

    old_heading = one_sample("old_heading", theta)
    new_heading = one_sample("new_heading", theta + dtheta)
    middle_heading = one_sample("middle_heading", theta + dtheta / 2)

    exact_arc = Equation(
        name="odometry.exact_arc",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix(
            [
                x + D * sinc(dtheta / 2) * cos(theta + dtheta / 2),
                y + D * sinc(dtheta / 2) * sin(theta + dtheta / 2),
                theta + dtheta,
            ]
        ),
        textbook=Matrix(
            [
                x + D / dtheta * (sin(theta + dtheta) - sin(theta)),
                y - D / dtheta * (cos(theta + dtheta) - cos(theta)),
                theta + dtheta,
            ]
        ),
    )

    counter_step = Equation(
        name="odometry.counter_step",
        left=dN,
        right=Mod(count_now - count_before + counter_span / 2, counter_span) - counter_span / 2,
    )

    u, chord, x_step, y_step = symbols(r"u s \Delta{x} \Delta{y}", real=True)
    w, a_L, a_R = symbols("w a_L a_R", real=True)
    slope = Symbol(r"\frac{\mathrm{d}}{\mathrm{d}u}\operatorname{sinc}u", real=True)
    x_by_L, y_by_L, x_by_R, y_by_R = symbols("g_{xL} g_{yL} g_{xR} g_{yR}", real=True)
    q_L, q_R = symbols("q_L q_R", real=True)

    # what depends on the wheels alone, then what depends on the heading too
    of_the_wheels = (
        (u, (D_R - D_L) / (2 * b)),
        (chord, (D_R + D_L) / 2 * sinc(u)),
        (
            slope,
            Piecewise(
                ((cos(u) - sinc(u)) / u, Abs(u) >= 0.1),
                (-u / 3 * (1 - u**2 / 10 * (1 - u**2 / 28 * (1 - u**2 / 54))), True),
            ),
        ),
        (w, chord / (2 * b)),
        (a_L, sinc(u) / 2 - (D_R + D_L) * slope / (4 * b)),
        (a_R, sinc(u) / 2 + (D_R + D_L) * slope / (4 * b)),
        (q_L, noise * Abs(D_L)),
        (q_R, noise * Abs(D_R)),
    )
    of_the_heading = (
        (x_step, chord * cos(theta + u)),
        (y_step, chord * sin(theta + u)),
        (x_by_L, a_L * cos(theta + u) + w * sin(theta + u)),
        (y_by_L, a_L * sin(theta + u) - w * cos(theta + u)),
        (x_by_R, a_R * cos(theta + u) - w * sin(theta + u)),
        (y_by_R, a_R * sin(theta + u) + w * cos(theta + u)),
    )
    covariance_step = Equation(
        name="odometry.covariance_step",
        left=Matrix(p_next),
        right=Matrix(
            [
                p_xx - 2 * y_step * p_xt + y_step**2 * p_tt + q_L * x_by_L**2 + q_R * x_by_R**2,
                p_xy + x_step * p_xt - y_step * p_yt - x_step * y_step * p_tt
                + q_L * x_by_L * y_by_L + q_R * x_by_R * y_by_R,
                p_xt - y_step * p_tt + (q_R * x_by_R - q_L * x_by_L) / b,
                p_yy + 2 * x_step * p_yt + x_step**2 * p_tt + q_L * y_by_L**2 + q_R * y_by_R**2,
                p_yt + x_step * p_tt + (q_R * y_by_R - q_L * y_by_L) / b,
                p_tt + (q_L + q_R) / b**2,
            ]
        ),
        where=(*of_the_wheels, *of_the_heading),
    )  # fmt: skip

    door_angle = Equation(name="odometry.door_angle", left=swing, right=slip / b)

    door_shift = Equation(name="odometry.door_shift", left=shift, right=slip / b * lever)

    sides = ((lever_L, -1), (lever_R, 1))
    lever_term = Equation(
        name="odometry.lever_term",
        left=Matrix(p_piece),
        right=Matrix(
            [
                noise / b**2 * (Abs(D_R) * lever_L[1] ** 2 + Abs(D_L) * lever_R[1] ** 2),
                -(
                    noise
                    / b**2
                    * (Abs(D_R) * lever_L[0] * lever_L[1] + Abs(D_L) * lever_R[0] * lever_R[1])
                ),
                noise / b**2 * (Abs(D_R) * lever_L[0] ** 2 + Abs(D_L) * lever_R[0] ** 2),
            ]
        ),
        where=tuple(
            pair
            for (along, up), side in sides
            for pair in (
                (along, l_x - side * b / 2 * sin(theta)),
                (up, l_y + side * b / 2 * cos(theta)),
            )
        ),
    )

    straight_spread = Equation(
        name="odometry.straight_spread",
        left=Matrix([sigma_theta, sigma_y]),
        right=Matrix([sqrt(2 * noise * drive) / b, sqrt(2 * noise * drive**3 / 3) / b]),
    )

    half_trace, spread = symbols("m d", real=True)
    ellipse_axes = Equation(
        name="odometry.ellipse_axes",
        left=Matrix([long_axis, short_axis]),
        right=Matrix(
            [
                sqrt(half_trace + spread),
                sqrt((p_xx * p_yy - p_xy**2) / (half_trace + spread)),
            ]
        ),
        where=(
            (half_trace, (p_xx + p_yy) / 2),
            (spread, sqrt(((p_xx - p_yy) / 2) ** 2 + p_xy**2)),
        ),
    )

    square_ends = Equation(
        name="odometry.square_ends",
        left=Matrix([x_ccw, y_ccw, x_cw, y_cw]),
        right=Matrix(
            [
                2 * side * (side_swing - short_turn),
                2 * side * (short_turn - side_swing),
                -2 * side * (short_turn + side_swing),
                -2 * side * (short_turn + side_swing),
            ]
        ),
    )

    calibration_angles = Equation(
        name="odometry.calibration_angles",
        left=Matrix([short_turn, side_swing]),
        right=Matrix(
            [
                (y_ccw - x_ccw - x_cw - y_cw) / (8 * side),
                (x_ccw - y_ccw - x_cw - y_cw) / (8 * side),
            ]
        ),
    )

    calibration = Equation(
        name="odometry.calibration",
        left=Matrix([b_true, ratio]),
        right=Matrix(
            [
                pi * b / (pi - 2 * short_turn),
                (side + b_true * sin(side_swing / 2)) / (side - b_true * sin(side_swing / 2)),
            ]
        ),
        where=((b_true, pi * b / (pi - 2 * short_turn)),),
    )
