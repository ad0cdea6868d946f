"""The planar arm with three links: pose, velocity, singular poses, limits, and the way back."""

import numpy as np
from numpy.typing import ArrayLike
from sympy import Abs, Add, Matrix, Piecewise, Symbol, atan2, cos, eye, nan, sin, sqrt

from book.motion.formulas import x, x_dot, y, y_dot
from robokin import planar_arm
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity
from workshop.equations.functions import solve

l1 = quantity("l1", "m", 0.1, 1, "length of the first link", latex="l_1")
l2 = quantity("l2", "m", 0.1, 1, "length of the second link", latex="l_2")
l3 = quantity("l3", "m", 0.1, 1, "length of the third link", latex="l_3")
theta1 = quantity("theta1", "rad", -3.14, 3.14, "angle of joint 1", latex=r"\theta_1")
theta2 = quantity("theta2", "rad", -3.14, 3.14, "angle of joint 2", latex=r"\theta_2")
theta3 = quantity("theta3", "rad", -3.14, 3.14, "angle of joint 3", latex=r"\theta_3")
rate1 = quantity("rate1", "rad/s", -3, 3, "rate of joint 1", latex=r"\dot\theta_1")
rate2 = quantity("rate2", "rad/s", -3, 3, "rate of joint 2", latex=r"\dot\theta_2")
rate3 = quantity("rate3", "rad/s", -3, 3, "rate of joint 3", latex=r"\dot\theta_3")
phi_hand = quantity("phi_hand", "rad", -3.14, 3.14, "where the hand points", latex=r"\phi")
phi_dot = quantity("phi_dot", "rad/s", -3, 3, "turning rate of the hand", latex=r"\dot\phi")
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
gain = quantity("gain", "1/s", 0, 4, "how much of an error is taken back in a second", latex="K")
x_d = quantity("x_d", "m", -1, 1, "wanted position of the hand")
y_d = quantity("y_d", "m", -1, 1, "wanted position of the hand")
phi_d = quantity("phi_d", "rad", -3.14, 3.14, "wanted direction of the hand", latex=r"\phi_d")
vx_d = quantity("vx_d", "m/s", -1, 1, "wanted velocity of the hand", latex=r"\dot{x}_d")
vy_d = quantity("vy_d", "m/s", -1, 1, "wanted velocity of the hand", latex=r"\dot{y}_d")
omega_d = quantity("omega_d", "rad/s", -3, 3, "wanted turning rate of the hand", r"\dot{\phi}_d")

LENGTHS, ANGLES, RATES = (l1, l2, l3), (theta1, theta2, theta3), (rate1, rate2, rate3)
POSE, TWIST = (x, y, phi_hand), (x_dot, y_dot, phi_dot)

# The short names of every book: c_12 is the cosine of θ1 + θ2.
c1, c12, c123 = Symbol("c_1"), Symbol("c_12"), Symbol("c_123")
s1, s12, s123 = Symbol("s_1"), Symbol("s_12"), Symbol("s_123")
s2, s3, s23 = Symbol("s_2"), Symbol("s_3"), Symbol("s_23")
J = Matrix(3, 3, [Symbol(f"J_{i}{j}") for i in (1, 2, 3) for j in (1, 2, 3)])
G_xx, G_yy, G_xy = Symbol("G_xx"), Symbol("G_yy"), Symbol("G_xy")
x_w, y_w, d = Symbol("x_w"), Symbol("y_w"), Symbol("d")
w, large, small, tilt = Symbol("w"), Symbol(r"\sigma_1"), Symbol(r"\sigma_2"), Symbol(r"\alpha")

STRETCHED, FOLDED = {theta2: 0.0}, {theta2: np.pi}
ON_A_LINE = {theta2: 0.0, theta3: 0.0}
BENT_BACK = {theta2: np.pi, theta3: np.pi}
ROUND = {theta1: np.pi / 6, theta2: np.pi / 3, theta3: -np.pi / 2}
SINGULAR = (STRETCHED, FOLDED, ON_A_LINE, BENT_BACK)
REGULAR = {theta2: (0.2, 2.9)}


def determinant(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """The determinant of the Jacobian, by NumPy."""
    return np.asarray(np.linalg.det(planar_arm.jacobian(theta, lengths)))


def elbow_rate_outward(theta: Array, speed: Array, lengths: Array) -> Array:
    """The rate of joint 2 that moves the wrist away from the base, the hand not turning."""
    wrist = planar_arm.joint_positions(theta, lengths)[..., 2, :]
    away = speed[..., None] * wrist / np.linalg.norm(wrist, axis=-1)[..., None]
    twist = np.concatenate([away, 0 * speed[..., None]], axis=-1)
    return planar_arm.joint_rates(theta, twist, lengths, singular="nan")[..., 1]


def ellipse_sizes(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """The half-axes of the ellipse, the larger first."""
    return planar_arm.ellipse(theta, lengths)[0]


def twice_the_tilt(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """Twice the angle of the ellipse's long axis: the same for both directions of the axis."""
    directions = planar_arm.ellipse(theta, lengths)[1]
    return 2 * np.arctan2(directions[..., 1, 0], directions[..., 0, 0])


def normal_equations(theta: Array, twist: Array, lengths: Array, damping: Array) -> Array:
    """What the damped rates of the library give back: (JᵀJ + λ² I) times the rates."""
    J = planar_arm.jacobian(theta, lengths)
    rates = planar_arm.joint_rates(theta, twist, lengths, damping)[..., None]
    normal = np.swapaxes(J, -1, -2) @ (J @ rates) + damping[..., None, None] ** 2 * rates
    return np.asarray(normal[..., 0])


def wrist_of(pose: ArrayLike, lengths: Array) -> Array:
    """The wrist of an arm whose hand is at a pose."""
    theta = planar_arm.inverse(pose, lengths)[..., 0, :]
    return planar_arm.joint_positions(theta, lengths)[..., 2, :]


def elbow_first(pose: ArrayLike, lengths: ArrayLike) -> Array:
    """The joint angles with θ2 ≥ 0, in the order in which they are found: θ2, θ1, θ3."""
    return planar_arm.inverse(pose, lengths)[..., 0, [1, 0, 2]]


with as_written():
    sum12, sum123 = theta1 + theta2, Add(theta1, theta2, theta3)
    SHORT = (
        (c1, cos(theta1)),
        (s1, sin(theta1)),
        (c12, cos(sum12)),
        (s12, sin(sum12)),
        (c123, cos(sum123)),
        (s123, sin(sum123)),
    )
    BENDS = ((s2, sin(theta2)), (s3, sin(theta3)), (s23, sin(theta2 + theta3)))

    ahead = Add(l1 * c1, l2 * c12, l3 * c123)  # three terms, without brackets
    above = Add(l1 * s1, l2 * s12, l3 * s123)
    rate12, rate123 = rate1 + rate2, Add(rate1, rate2, rate3)

    forward = Equation(
        name="planar_arm.forward",
        left=Matrix(POSE),
        right=Matrix([ahead, above, sum123]),
        where=SHORT,
        source="exercise 8 (seed 004)",
        function=planar_arm.forward,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-15,
        reason="headings up to 9 rad rounded twice, times links of 3 m in all",
        specials=(ROUND, *SINGULAR),
    )

    velocity = Equation(
        name="planar_arm.velocity",
        left=Matrix(TWIST),
        right=Matrix(
            [
                Add(-(l1 * s1 * rate1), -(l2 * s12 * rate12), -(l3 * s123 * rate123)),
                Add(l1 * c1 * rate1, l2 * c12 * rate12, l3 * c123 * rate123),
                rate123,
            ]
        ),
        where=SHORT,
        source="exercise 8 (seed 004)",
        function=planar_arm.velocity,
        arguments=(ANGLES, RATES, LENGTHS),
        tolerance=2e-14,
        reason="as forward, times rates of up to 9 rad/s",
        specials=(ROUND, *SINGULAR),
    )

    jacobian = Equation(
        name="planar_arm.jacobian",
        left=Symbol("J"),
        right=Matrix(
            [
                [Add(-(l1 * s1), -(l2 * s12), -(l3 * s123)), -l2 * s12 - l3 * s123, -l3 * s123],
                [ahead, l2 * c12 + l3 * c123, l3 * c123],
                [1, 1, 1],
            ]
        ),
        where=SHORT,
        source="exercise 8 (seed 004)",
        function=planar_arm.jacobian,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-15,
        reason="as forward",
        specials=(ROUND, *SINGULAR),
    )

    det = Equation(
        name="planar_arm.determinant",
        left=Symbol(r"\det J"),
        right=l1 * l2 * sin(theta2),
        source="exercise 8",
        function=determinant,
        arguments=(ANGLES, LENGTHS),
        tolerance=4e-15,
        reason="an elimination with products of up to 3 m x 3 m",
        specials=(ROUND, *SINGULAR),
    )

    along2 = Add(x_dot * c12, y_dot * s12, l3 * phi_dot * s3)
    along1 = Add(x_dot * c1, y_dot * s1, l3 * phi_dot * s23)
    rates = (
        along2 / (l1 * s2),
        -rate1 - along1 / (l2 * s2),
        Add(phi_dot, -rate1, -rate2),
    )

    joint_rates = Equation(
        name="planar_arm.joint_rates",
        left=Matrix(RATES),
        right=Matrix(rates),
        where=(*SHORT, *BENDS, (rate1, rates[0]), (rate2, rates[1])),
        source="exercise 8",
        function=planar_arm.joint_rates,
        arguments=(ANGLES, TWIST, LENGTHS),
        ranges=REGULAR,
        tolerance=2e-13,
        reason="roundings of 5 m/s over 0.1 m x 0.2 (the least sine) = 250 rad/s, some twice",
        specials=(ROUND, {theta2: -np.pi / 2}),
    )

    distance = sqrt(Add(l1**2, l2**2, 2 * l1 * l2 * cos(theta2)))  # of the wrist from the base
    elbow_speed = -(v_out * distance / (l1 * l2 * sin(theta2)))

    elbow_rate = Equation(
        name="planar_arm.elbow_rate",
        left=rate2,
        right=Piecewise((elbow_speed, Abs(sin(theta2)) > planar_arm.SINGULAR), (nan, True)),
        textbook=elbow_speed,
        source="exercise 8",
        function=elbow_rate_outward,
        arguments=(ANGLES, v_out, LENGTHS),
        ranges=REGULAR,
        tolerance=1e-13,
        reason="as joint_rates: 2 m/s over 0.1 m x 0.2 = 100 rad/s, from two quotients",
        specials=(ROUND, *SINGULAR, {theta2: -np.pi / 2}),
    )

    manipulability = Equation(
        name="planar_arm.manipulability",
        left=w,
        right=sqrt(
            Add(
                (l1 * l2 * s2 + l1 * l3 * s23) ** 2,
                (l1 * l3 * s23 + l2 * l3 * s3) ** 2,
                (l2 * l3 * s3) ** 2,
            )
        ),
        where=BENDS,
        source="exercise 8; Siciliano et al., section 3.9",
        function=planar_arm.manipulability,
        arguments=(ANGLES, LENGTHS),
        tolerance=4e-15,
        reason="products of up to 3 m x 3 m, each rounded a few times",
        specials=(ROUND, *SINGULAR),
    )

    GRAM = (
        (G_xx, Add(*(entry**2 for entry in J[0, :]))),
        (G_yy, Add(*(entry**2 for entry in J[1, :]))),
        (G_xy, Add(*(a * b for a, b in zip(J[0, :], J[1, :], strict=True)))),
    )
    POSITION_ROWS = (*SHORT, *zip(J[:2, :], jacobian.right[:2, :], strict=True), *GRAM)
    longest = sqrt(Add(G_xx, G_yy, sqrt((G_xx - G_yy) ** 2 + 4 * G_xy**2)) / 2)

    ellipse = Equation(
        name="planar_arm.ellipse",
        left=Matrix([large, small]),
        right=Matrix([longest, w / large]),
        where=(*POSITION_ROWS, *BENDS, (w, manipulability.right), (large, longest)),
        source="exercise 8; Siciliano et al., section 3.9",
        function=ellipse_sizes,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-15,
        reason="as manipulability, over a half-axis of 0.1 m or more",
        specials=(ROUND, *SINGULAR),
    )

    ellipse_tilt = Equation(
        name="planar_arm.ellipse_tilt",
        left=2 * tilt,
        right=atan2(2 * G_xy, G_xx - G_yy),
        where=POSITION_ROWS,
        source="exercise 8",
        function=twice_the_tilt,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-14,
        reason="roundings of 20 m2 over the difference of two squared half-axes, 0.1 m2 or more",
        is_angle=True,
        specials=(ROUND, *SINGULAR),
    )

    damped = Equation(
        name="planar_arm.damped",
        left=Symbol(r"\left(J^{\top} J + \lambda^{2} I\right) \dot{\theta}"),
        right=Matrix([Add(x_dot * J[0, j], y_dot * J[1, j], phi_dot * J[2, j]) for j in range(3)]),
        where=(*SHORT, *zip(J, jacobian.right, strict=True)),
        source="exercise 8; Siciliano et al., section 3.5.2",
        function=normal_equations,
        arguments=(ANGLES, TWIST, LENGTHS, damping),
        tolerance=1e-13,
        reason="3 m x 1 m/s a term; the damped rates, up to 30 rad/s, come back times up to 9 m2",
        specials=(ROUND, *SINGULAR, {damping: 1e-3}),
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
        source="exercise 8; Siciliano et al., section 3.7",
        checked_by="test_planar_arm.py::test_the_command_takes_the_error_back",
        tolerance=1e-15,
        reason="an identity: the error shrinks by the factor 1 - K dt in a step",
    )

    wrist = Equation(
        name="planar_arm.wrist",
        left=Matrix([x_w, y_w]),
        right=Matrix([x - l3 * cos(phi_hand), y - l3 * sin(phi_hand)]),
        source="exercise 8",
        function=wrist_of,
        arguments=(POSE, LENGTHS),
        ranges={x: (0.4, 0.5), y: (0.1, 0.3), l1: (0.35, 0.5), l2: (0.35, 0.5), l3: (0.05, 0.1)},
        tolerance=2e-15,
        reason="roundings of numbers up to 1 m, there and back",
        specials=({phi_hand: 0.0}, {phi_hand: np.pi}),
    )

    ELBOW = 2 * atan2(
        sqrt(Add(l1, l2, -d) * Add(l1, l2, d)), sqrt(Add(d, -l1, l2) * Add(d, l1, -l2))
    )
    SHOULDER = atan2(y_w, x_w) - atan2(l2 * sin(theta2), l1 + l2 * cos(theta2))
    inverse = Equation(
        name="planar_arm.inverse",
        left=Matrix([theta2, theta1, theta3]),
        right=Matrix([ELBOW, SHOULDER, Add(phi_hand, -theta1, -theta2)]),
        where=(
            (x_w, wrist.right[0]),
            (y_w, wrist.right[1]),
            (d, sqrt(x_w**2 + y_w**2)),
            (theta2, ELBOW),
            (theta1, SHOULDER),
        ),
        source="exercise 8",
        function=elbow_first,
        arguments=(POSE, LENGTHS),
        ranges=wrist.ranges,
        tolerance=1e-14,
        reason="a rounding of d over the sine of θ2, which is 0.3 or more here",
        is_angle=True,
        specials=({phi_hand: 0.0}, {phi_hand: np.pi / 2}),
    )

# The damped rates, solved for together with y, what is missing of the twist over λ:
# J q + λ y = twist and Jᵀ y = λ q. No product of J with itself, which would cost half the digits.
damped_system = Matrix.vstack(
    Matrix.hstack(damping * eye(3), J), Matrix.hstack(J.T, -damping * eye(3))
)
damped_rates = solve(damped_system, Matrix([*TWIST, 0, 0, 0]))[3:, :]
