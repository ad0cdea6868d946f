"""The planar arm with three links: pose, velocity, singular poses, limits, and the way back."""

from sympy import Abs, Add, Matrix, Piecewise, Symbol, atan2, cos, eye, nan, sin, sqrt

from courseware.equations import Equation, as_written, declarations
from courseware.equations.functions import solve

quantity, symbol = declarations(__name__)

l1 = quantity("l1", "m", 0.1, 1, "length of the first link", latex="l_1")
l2 = quantity("l2", "m", 0.1, 1, "length of the second link", latex="l_2")
l3 = quantity("l3", "m", 0.1, 1, "length of the third link", latex="l_3")
theta1 = quantity("theta1", "rad", -3.14, 3.14, "angle of joint 1", latex=r"\theta_1")
theta2 = quantity("theta2", "rad", -3.14, 3.14, "angle of joint 2", latex=r"\theta_2")
theta3 = quantity("theta3", "rad", -3.14, 3.14, "angle of joint 3", latex=r"\theta_3")
rate1 = quantity("rate1", "rad/s", -3, 3, "rate of joint 1", r"\dot\theta_1", "rate_1")
rate2 = quantity("rate2", "rad/s", -3, 3, "rate of joint 2", r"\dot\theta_2", "rate_2")
rate3 = quantity("rate3", "rad/s", -3, 3, "rate of joint 3", latex=r"\dot\theta_3")
x = quantity("x", "m", -2, 2, "place of the hand's point")
y = quantity("y", "m", -2, 2, "place of the hand's point")
x_dot = quantity(
    "x_dot",
    "m/s",
    -1,
    1,
    "speed along the world's x; damped, the wanted one",
    latex=r"\dot{x}",
)
y_dot = quantity(
    "y_dot",
    "m/s",
    -1,
    1,
    "speed along the world's y; damped, the wanted one",
    latex=r"\dot{y}",
)
phi_hand = quantity("phi_hand", "rad", -3.14, 3.14, "where the hand points", latex=r"\varphi")
phi_dot = quantity("phi_dot", "rad/s", -3, 3, "turning rate of the hand", latex=r"\dot\varphi")
v_out = quantity(
    "v_out",
    "m/s",
    -1,
    1,
    "speed of the wrist, straight away from the base",
    latex=r"v_\mathrm{out}",
)
damping = quantity(
    "damping", "", 0.05, 1, "damping of the least squares; one number for m and rad", r"\lambda"
)
gain = quantity("gain", "1/s", 0, 6, "how much of an error is taken back in a second", latex="K")
x_d = quantity("x_d", "m", -1, 1, "wanted position of the hand", r"x_\mathrm{des}")
y_d = quantity("y_d", "m", -1, 1, "wanted position of the hand", r"y_\mathrm{des}")
phi_d = quantity(
    "phi_d", "rad", -3.14, 3.14, "wanted direction of the hand", r"\varphi_\mathrm{des}"
)
vx_d = quantity("vx_d", "m/s", -1, 1, "wanted velocity of the hand", latex=r"\dot{x}_\mathrm{des}")
vy_d = quantity("vy_d", "m/s", -1, 1, "wanted velocity of the hand", latex=r"\dot{y}_\mathrm{des}")
omega_d = quantity(
    "omega_d", "rad/s", -3, 3, "wanted turning rate of the hand", r"\dot{\varphi}_\mathrm{des}"
)

LENGTHS, ANGLES, RATES = (l1, l2, l3), (theta1, theta2, theta3), (rate1, rate2, rate3)
POSE, TWIST = (x, y, phi_hand), (x_dot, y_dot, phi_dot)

# The short names of every book: c_12 is the cosine of θ1 + θ2.
SUMS = {"1": "θ_1", "12": "θ_1 + θ_2", "123": "θ_1 + θ_2 + θ_3"}
c1, c12, c123 = (symbol(f"c_{k}", f"cos({sum_})", f"c_{{{k}}}") for k, sum_ in SUMS.items())
s1, s12, s123 = (symbol(f"s_{k}", f"sin({sum_})", f"s_{{{k}}}") for k, sum_ in SUMS.items())
s2, s3 = symbol("s_2", "sin θ_2"), symbol("s_3", "sin θ_3")
s23 = symbol("s_23", "sin(θ_2 + θ_3)", "s_{23}")
J = Matrix(3, 3, lambda i, j: symbol(f"J_{i + 1}{j + 1}", "entry of the Jacobian: row, column"))
G_xx, G_yy, G_xy = Symbol("G_xx"), Symbol("G_yy"), Symbol("G_xy")
x_w, y_w = (symbol(f"{x}_w", f"the wrist, along {x}", rf"{x}_\mathrm{{wr}}", "m") for x in "xy")
d = symbol("d", "distance of the wrist from the base", unit="m")
ROUNDING = 1e-14  # a sine so small is rounding: that of π in floating point is 1.2e-16
w = symbol("w", "manipulability", unit="m²")
large = symbol("sigma_1", "half-axis of the ellipse, the larger one", r"\sigma_1", "m/s")
small = symbol("sigma_2", "half-axis of the ellipse, the smaller one", r"\sigma_2", "m/s")
tilt = Symbol(r"\alpha")
whole_J = symbol("J", "the Jacobian")
det_J = symbol("det_J", "determinant of the Jacobian", r"\det J", "m²")
identity = symbol("I", "the identity matrix")
theta_dot = symbol("theta_dot", "the joint rates, a column", r"\dot\theta", code="rates")
p_dot = symbol(
    "p_dot", "the wanted velocity of the hand and its turning rate", r"\dot{p}", code="wanted"
)
u = symbol("u", "joint rate along a single direction", unit="rad/s")
sigma = quantity(
    "sigma", "m", 0, 1, "by what the arm multiplies a rate in a single direction", r"\sigma"
)
v = quantity("v", "m/s", -1, 1, "velocity that is wanted in a single direction")
g, h = (
    quantity(part, "m", -2, 2, f"{which} part of a lever, from the joint to the hand")
    for part, which in {"g": "first", "h": "second"}.items()
)
rate = quantity("rate", "rad/s", -3, 3, "rate of the one joint that turns", r"\dot\theta_i")
x_c, y_c = (
    quantity(f"{axis}_c", "m", -2, 2, f"centre of the hand's rotation, along {axis}")
    for axis in "xy"
)
(x_2, y_2), (x_3, y_3) = (
    [symbol(f"{axis}_{k}", f"joint {k}, along {axis}", unit="m") for axis in "xy"] for k in (2, 3)
)
p_1, p_2, p_3, p_i = (
    symbol(f"p_{k}", f"place of joint {k}, an arrow from the base", unit="m") for k in "123i"
)
c, i = symbol("c", "a point of the hand's sheet, an arrow", unit="m"), symbol("i", "a number")
U, S, V = (
    symbol(name, f"of the singular value decomposition: {what}", latex)
    for name, what, latex in (
        ("U", "directions in task space", ""),
        ("Sigma", "the singular values", r"\Sigma"),
        ("V", "directions in joint space", ""),
    )
)
u_i, v_i, sigma_i = (
    symbol("u_i", "column of U"),
    symbol("v_i", "column of V"),
    symbol("sigma_i", "singular value", r"\sigma_i"),
)
A, *PARTS = (
    symbol(name, f"twice the area of the triangle {what}, signed", unit="m²")
    for name, what in {
        "A": "of the three joints",
        "A_1": "that has the centre in place of joint 1",
        "A_2": "that has the centre in place of joint 2",
        "A_3": "that has the centre in place of joint 3",
    }.items()
)
time_step = quantity("dt", "s", 0.01, 1, "time of a step", r"\Delta t")
error = quantity("error", "m", -1, 1, "what is missing of the hand's place", "e")
drift = quantity("drift", "m", -0.1, 0.1, "what one step adds to the error", r"\delta")
error_next = symbol("error_next", "the error after the step", "e'", "m")


LOOKS = {
    theta1: "left",
    theta2: "right",
    theta3: "turning",
    rate1: "left",
    rate2: "right",
    rate3: "turning",
    x_dot: "x_axis",
    y_dot: "y_axis",
    phi_dot: "icr",
    phi_hand: "heading",
    x_c: "icr",
    y_c: "icr",
    l1: "length",
    l2: "length",
    l3: "length",
    large: "velocity",
    small: "velocity",
    sigma: "velocity",
    v: "velocity",
    damping: "approximation",
    g: "approximation",
    h: "approximation",
}


with as_written():
    sum12, sum123 = theta1 + theta2, theta1 + theta2 + theta3
    SHORT = (
        (c1, cos(theta1)),
        (s1, sin(theta1)),
        (c12, cos(sum12)),
        (s12, sin(sum12)),
        (c123, cos(sum123)),
        (s123, sin(sum123)),
    )
    BENDS = ((s2, sin(theta2)), (s3, sin(theta3)), (s23, sin(theta2 + theta3)))

    ahead = l1 * c1 + l2 * c12 + l3 * c123
    above = l1 * s1 + l2 * s12 + l3 * s123
    rate12, rate123 = rate1 + rate2, rate1 + rate2 + rate3

    forward = Equation(
        name="planar_arm.forward",
        left=Matrix(POSE),
        right=Matrix([ahead, above, sum123]),
        where=SHORT,
    )

    velocity = Equation(
        name="planar_arm.velocity",
        left=Matrix(TWIST),
        right=Matrix(
            [
                -(l1 * s1 * rate1) - l2 * s12 * rate12 - l3 * s123 * rate123,
                l1 * c1 * rate1 + l2 * c12 * rate12 + l3 * c123 * rate123,
                rate123,
            ]
        ),
        where=SHORT,
    )

    jacobian = Equation(
        name="planar_arm.jacobian",
        left=whole_J,
        right=Matrix(
            [
                [-(l1 * s1) - l2 * s12 - l3 * s123, -l2 * s12 - l3 * s123, -l3 * s123],
                [ahead, l2 * c12 + l3 * c123, l3 * c123],
                [1, 1, 1],
            ]
        ),
        where=SHORT,
    )

    lever = Equation(
        name="planar_arm.lever",
        left=Matrix(TWIST),
        right=Matrix([-(h * rate), g * rate, rate]),
    )

    JOINTS = (
        (x_2, l1 * c1),
        (y_2, l1 * s1),
        (x_3, l1 * c1 + l2 * c12),
        (y_3, l1 * s1 + l2 * s12),
    )
    hand_centre = Equation(
        name="planar_arm.hand_centre",
        left=Matrix([x_c, y_c]),
        right=Matrix(
            [(rate2 * x_2 + rate3 * x_3) / phi_dot, (rate2 * y_2 + rate3 * y_3) / phi_dot]
        ),
        where=(*SHORT, *JOINTS, (phi_dot, rate123)),
    )

    AREAS = (
        (A, x_2 * y_3 - x_3 * y_2),
        (PARTS[0], (x_2 - x_c) * (y_3 - y_c) - (x_3 - x_c) * (y_2 - y_c)),
        (PARTS[1], x_c * y_3 - x_3 * y_c),
        (PARTS[2], x_2 * y_c - x_c * y_2),
    )
    areas = Equation(
        name="planar_arm.areas",
        left=Matrix(RATES),
        right=Matrix([phi_dot * part / A for part in PARTS]),
        where=(*SHORT, *JOINTS, *AREAS),
    )

    det = Equation(
        name="planar_arm.determinant",
        left=det_J,
        right=l1 * l2 * sin(theta2),
    )

    along2 = x_dot * c12 + y_dot * s12 + l3 * phi_dot * s3
    along1 = x_dot * c1 + y_dot * s1 + l3 * phi_dot * s23
    rates = (
        along2 / (l1 * s2),
        -rate1 - along1 / (l2 * s2),
        phi_dot - rate1 - rate2,
    )

    joint_rates = Equation(
        name="planar_arm.joint_rates",
        left=Matrix(RATES),
        right=Matrix(rates),
        where=(*SHORT, *BENDS, (rate1, rates[0]), (rate2, rates[1])),
    )

    distance = sqrt(l1**2 + l2**2 + 2 * l1 * l2 * cos(theta2))  # of the wrist from the base
    elbow_speed = -(v_out * distance / (l1 * l2 * sin(theta2)))

    elbow_rate = Equation(
        name="planar_arm.elbow_rate",
        left=rate2,
        right=Piecewise((elbow_speed, Abs(sin(theta2)) > ROUNDING), (nan, True)),
        textbook=elbow_speed,
    )

    manipulability = Equation(
        name="planar_arm.manipulability",
        left=w,
        right=sqrt(
            (l1 * l2 * s2 + l1 * l3 * s23) ** 2
            + (l1 * l3 * s23 + l2 * l3 * s3) ** 2
            + (l2 * l3 * s3) ** 2
        ),
        where=BENDS,
    )

    GRAM = (
        (G_xx, Add(*(entry**2 for entry in J[0, :]))),
        (G_yy, Add(*(entry**2 for entry in J[1, :]))),
        (G_xy, Add(*(a * b for a, b in zip(J[0, :], J[1, :], strict=True)))),
    )
    POSITION_ROWS = (*SHORT, *zip(J[:2, :], jacobian.right[:2, :], strict=True), *GRAM)
    longest = sqrt((G_xx + G_yy + sqrt((G_xx - G_yy) ** 2 + 4 * G_xy**2)) / 2)

    ellipse = Equation(
        name="planar_arm.ellipse",
        left=Matrix([large, small]),
        right=Matrix([longest, w / large]),
        where=(*POSITION_ROWS, *BENDS, (w, manipulability.right), (large, longest)),
    )

    ellipse_tilt = Equation(
        name="planar_arm.ellipse_tilt",
        left=2 * tilt,
        right=atan2(2 * G_xy, G_xx - G_yy),
        where=POSITION_ROWS,
        is_angle=True,
    )

    damped = Equation(
        name="planar_arm.damped",
        left=Symbol(r"\left(J^{\top} J + \lambda^{2} I\right) \dot{\theta}"),
        right=Matrix([x_dot * J[0, j] + y_dot * J[1, j] + phi_dot * J[2, j] for j in range(3)]),
        where=(*SHORT, *zip(J, jacobian.right, strict=True)),
    )
    damped_single = Equation(
        name="planar_arm.damped_single",
        left=u,
        right=sigma * v / (sigma**2 + damping**2),
    )

    follower_error = Equation(
        name="planar_arm.follower_error",
        left=error_next,
        right=(1 - gain * time_step) * error + drift,
    )

    command = Equation(
        name="planar_arm.command",
        left=Matrix(TWIST),
        right=Matrix(
            [
                vx_d + gain * (x_d - x),
                vy_d + gain * (y_d - y),
                omega_d + gain * (phi_d - phi_hand),
            ]
        ),
    )

    wrist = Equation(
        name="planar_arm.wrist",
        left=Matrix([x_w, y_w]),
        right=Matrix([x - l3 * cos(phi_hand), y - l3 * sin(phi_hand)]),
    )

    ELBOW = 2 * atan2(sqrt((l1 + l2 - d) * (l1 + l2 + d)), sqrt((d - l1 + l2) * (d + l1 - l2)))
    SHOULDER = atan2(y_w, x_w) - atan2(l2 * sin(theta2), l1 + l2 * cos(theta2))
    inverse = Equation(
        name="planar_arm.inverse",
        left=Matrix([theta2, theta1, theta3]),
        right=Matrix([ELBOW, SHOULDER, phi_hand - theta1 - theta2]),
        where=(
            (x_w, wrist.right[0]),
            (y_w, wrist.right[1]),
            (d, sqrt(x_w**2 + y_w**2)),
            (theta2, ELBOW),
            (theta1, SHOULDER),
        ),
        is_angle=True,
    )

# The damped rates, solved for together with y, what is missing of the twist over λ:
# J q + λ y = twist and Jᵀ y = λ q. No product of J with itself, which would cost half the digits.
damped_system = Matrix.vstack(
    Matrix.hstack(damping * eye(3), J), Matrix.hstack(J.T, -damping * eye(3))
)
damped_rates = solve(damped_system, Matrix([*TWIST, 0, 0, 0]))[3:, :]
