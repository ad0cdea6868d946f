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
    drift,
    error,
    g,
    gain,
    h,
    l1,
    l2,
    l3,
    omega_d,
    phi_d,
    phi_dot,
    phi_hand,
    rate,
    rate1,
    rate2,
    rate3,
    sigma,
    theta1,
    theta2,
    theta3,
    time_step,
    v,
    v_out,
    vx_d,
    vy_d,
    x,
    x_c,
    x_d,
    y,
    y_c,
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


def turn_by_one_joint(lever: Array, rate: Array) -> Array:
    """The velocity of an arm of one link, whose lever is the link."""
    angle, length = np.arctan2(lever[..., 1], lever[..., 0]), np.linalg.norm(lever, axis=-1)
    return planar_arm.velocity(angle[..., None], rate[..., None], length[..., None])


def centre_of_hand(theta: Array, rates: Array, lengths: Array) -> Array:
    """The point that has no velocity, from the hand's velocity."""
    x, y, _ = np.moveaxis(planar_arm.forward(theta, lengths), -1, 0)
    x_dot, y_dot, phi_dot = np.moveaxis(planar_arm.velocity(theta, rates, lengths), -1, 0)
    return np.stack([x - y_dot / phi_dot, y + x_dot / phi_dot], axis=-1)


def rates_about(theta: Array, centre: Array, phi_dot: Array, lengths: Array) -> Array:
    """The joint rates that turn the hand about a point."""
    lever = planar_arm.forward(theta, lengths)[..., :2] - centre
    twist = phi_dot[..., None] * np.stack([-lever[..., 1], lever[..., 0], 0 * phi_dot + 1], axis=-1)
    return planar_arm.joint_rates(theta, twist, lengths)


def least_sum(sigma: Array, v: Array, damping: Array) -> Array:
    """The rate whose sum of squares is least, by NumPy's least squares."""
    rows = np.stack([np.broadcast_to(sigma, v.shape), damping + 0 * v], axis=-1)
    found = [
        np.linalg.lstsq(row[:, None], [speed, 0.0])[0] for row, speed in zip(rows, v, strict=True)
    ]
    return np.asarray(found)[..., 0]


def error_after(error: Array, gain: Array, time_step: Array, drift: Array) -> Array:
    """The error after a step that takes back its rate times the time, by NumPy."""
    return error - gain * error * time_step + drift


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
        formulas.lever,
        function=turn_by_one_joint,
        arguments=((g, h), rate),
        tolerance=1e-14,
        reason="roundings of 3 m x 3 rad/s, through an angle and a length",
        specials=({g: 0.0}, {h: 0.0}),
    ),
    Check(
        formulas.hand_centre,
        function=centre_of_hand,
        arguments=(ANGLES, RATES, LENGTHS),
        ranges={rate1: (0.5, 3), rate2: (0.5, 3), rate3: (-0.4, 3)},
        tolerance=1e-13,
        reason="roundings of 27 m/s over 0.6 rad/s or more",
        specials=(ROUND, *SINGULAR),
    ),
    Check(
        formulas.areas,
        function=rates_about,
        arguments=(ANGLES, (x_c, y_c), phi_dot, LENGTHS),
        ranges=REGULAR,
        tolerance=1e-11,
        reason="roundings of 15 m/s over 0.01 m2 x 0.2, the least area",
        specials=(ROUND, {theta2: -np.pi / 2}, {x_c: 0.0, y_c: 0.0}),
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
        formulas.damped_single,
        function=least_sum,
        arguments=(sigma, v, damping),
        tolerance=1e-13,
        reason="rates of up to 10 rad/s, from an orthogonal decomposition",
        specials=({sigma: 0.0}, {sigma: 0.05, damping: 0.05}),
    ),
    Check(
        formulas.follower_error,
        function=error_after,
        arguments=(error, gain, time_step, drift),
        tolerance=3e-15,
        reason="four roundings of numbers up to 6 m",
        specials=({gain: 0.0},),
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
