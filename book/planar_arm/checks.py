"""How the library agrees with each formula of `formulas.py`."""

import numpy as np
from numpy.typing import ArrayLike

from book.planar_arm import formulas
from book.planar_arm.formulas import (
    ANGLES,
    LENGTHS,
    POSE,
    RATES,
    TWIST,
    damping,
    gain,
    l1,
    l2,
    l3,
    omega_d,
    phi_d,
    phi_hand,
    theta1,
    theta2,
    theta3,
    v_out,
    vx_d,
    vy_d,
    x,
    x_d,
    y,
    y_d,
)
from courseware.equations import Array, Check
from robokin import planar_arm

STRETCHED, FOLDED = {theta2: 0.0}, {theta2: np.pi}
ON_A_LINE = {theta2: 0.0, theta3: 0.0}
BENT_BACK = {theta2: np.pi, theta3: np.pi}
ROUND = {theta1: np.pi / 6, theta2: np.pi / 3, theta3: -np.pi / 2}
SINGULAR = (STRETCHED, FOLDED, ON_A_LINE, BENT_BACK)
NEARLY_SINGULAR = ({theta2: 0.9e-14}, {theta2: 1.1e-14, v_out: 0.0})  # there NaN, there not yet
REGULAR = {theta2: (0.2, 2.9)}
ELBOW_BENT = {x: (0.4, 0.5), y: (0.1, 0.3), l1: (0.35, 0.5), l2: (0.35, 0.5), l3: (0.05, 0.1)}


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


def command_of(wanted: Array, gain: Array, place: Array, pose: Array) -> Array:
    """The wanted twist, and what is missing of the pose times the gain, by NumPy."""
    return wanted + gain[..., None] * (place - pose)


def wrist_of(pose: ArrayLike, lengths: Array) -> Array:
    """The wrist of an arm whose hand is at a pose."""
    theta = planar_arm.inverse(pose, lengths)[..., 0, :]
    return planar_arm.joint_positions(theta, lengths)[..., 2, :]


def elbow_first(pose: ArrayLike, lengths: ArrayLike) -> Array:
    """The joint angles with θ2 ≥ 0, in the order in which they are found: θ2, θ1, θ3."""
    return planar_arm.inverse(pose, lengths)[..., 0, [1, 0, 2]]


CHECKS = (
    Check(
        formulas.forward,
        function=planar_arm.forward,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-15,
        reason="headings up to 9 rad rounded twice, times links of 3 m in all",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.velocity,
        function=planar_arm.velocity,
        arguments=(ANGLES, RATES, LENGTHS),
        tolerance=2e-14,
        reason="as forward, times rates of up to 9 rad/s",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.jacobian,
        function=planar_arm.jacobian,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-15,
        reason="as forward",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.det,
        function=determinant,
        arguments=(ANGLES, LENGTHS),
        tolerance=4e-15,
        reason="an elimination with products of up to 3 m x 3 m",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.joint_rates,
        function=planar_arm.joint_rates,
        arguments=(ANGLES, TWIST, LENGTHS),
        ranges=REGULAR,
        tolerance=2e-13,
        reason="roundings of 5 m/s over 0.1 m x 0.2 (the least sine) = 250 rad/s, some twice",
        specials=(ROUND, {theta2: -np.pi / 2}),
    ),
    Check(
        formulas.elbow_rate,
        function=elbow_rate_outward,
        arguments=(ANGLES, v_out, LENGTHS),
        ranges=REGULAR,
        tolerance=1e-13,
        reason="as joint_rates: 2 m/s over 0.1 m x 0.2 = 100 rad/s, from two quotients",
        specials=(ROUND, *SINGULAR, *NEARLY_SINGULAR, {theta2: -np.pi / 2}),
    ),
    Check(
        formulas.manipulability,
        function=planar_arm.manipulability,
        arguments=(ANGLES, LENGTHS),
        tolerance=4e-15,
        reason="products of up to 3 m x 3 m, each rounded a few times",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.ellipse,
        function=ellipse_sizes,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-15,
        reason="as manipulability, over a half-axis of 0.1 m or more",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.ellipse_tilt,
        function=twice_the_tilt,
        arguments=(ANGLES, LENGTHS),
        tolerance=5e-14,
        reason="roundings of 20 m2 over the difference of two squared half-axes, 0.1 m2 or more",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.damped,
        function=normal_equations,
        arguments=(ANGLES, TWIST, LENGTHS, damping),
        tolerance=1e-13,
        reason="3 m x 1 m/s a term; the damped rates, up to 30 rad/s, come back times up to 9 m2",
        specials=(ROUND, *SINGULAR, {damping: 1e-3}),
    ),
    Check(
        formulas.command,
        function=command_of,
        arguments=((vx_d, vy_d, omega_d), gain, (x_d, y_d, phi_d), POSE),
        tolerance=1e-14,
        reason="three roundings of numbers up to 4/s x 6.3 rad + 3 rad/s = 28 rad/s",
    ),
    Check(
        formulas.wrist,
        function=wrist_of,
        arguments=(POSE, LENGTHS),
        ranges=ELBOW_BENT,
        tolerance=2e-15,
        reason="roundings of numbers up to 1 m, there and back",
        specials=({phi_hand: 0.0}, {phi_hand: np.pi}),
    ),
    Check(
        formulas.inverse,
        function=elbow_first,
        arguments=(POSE, LENGTHS),
        ranges=ELBOW_BENT,
        tolerance=1e-14,
        reason="a rounding of d over the sine of θ2, which is 0.3 or more here",
        specials=({phi_hand: 0.0}, {phi_hand: np.pi / 2}),
    ),
)
