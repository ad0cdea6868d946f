"""How the library agrees with each formula of `formulas.py`."""

import numpy as np
from numpy.typing import ArrayLike

from book.bicycle import formulas
from book.bicycle.formulas import (
    ahead,
    alpha_L,
    alpha_R,
    arc_length,
    arm,
    arm_angle,
    kappa,
    rate_rear,
    steering,
    track,
    v_F,
    wheelbase,
    y_heading,
)
from book.differential_drive.formulas import R, r
from book.motion.checks import QUARTERS
from book.motion.formulas import dt, theta, v, x, y
from courseware.equations import Array, Check
from robokin import bicycle, differential_drive, frames, motion

AHEAD, SLIGHT = {steering: 0.0}, ({steering: 1e-8}, {steering: -1e-8})
STEERED = {steering: (0.1, 1.2)}


def tangents_of_radius(R: Array, wheelbase: Array, track: Array) -> Array:
    """The tangents [left, right, bicycle] of the steering angles of a turn about the ICR."""
    phi = np.arctan(wheelbase / R)
    left, right = np.moveaxis(bicycle.ackermann(phi, wheelbase, track), -1, 0)
    middle = bicycle.equivalent_steering(left, right)
    return np.asarray(np.tan(np.stack([left, right, middle], axis=-1)))


def tangent_of_steering(alpha_left: ArrayLike, alpha_right: ArrayLike) -> Array:
    """The tangent of the equivalent steering angle."""
    return np.asarray(np.tan(bicycle.equivalent_steering(alpha_left, alpha_right)))


def cotangents_apart(phi: Array, wheelbase: Array, track: Array) -> Array:
    """How far the cotangents of the two Ackermann angles are apart."""
    left, right = np.moveaxis(bicycle.ackermann(phi, wheelbase, track), -1, 0)
    return bicycle.ackermann_error(left, right, wheelbase, track) + track / wheelbase


def steepest(wheelbase: Array, track: Array) -> Array:
    """The bicycle's angle when the inner wheel stands across and the ICR lies at its rear wheel."""
    return bicycle.equivalent_steering(np.pi / 2, np.arctan(wheelbase / track))


def speed_of_rate(rate: Array, r: Array) -> Array:
    """The speed of an axle whose two wheels turn alike."""
    return differential_drive.body_twist(rate, rate, r, 1.0)[..., 0]


def rear_speeds_of(v: Array, phi: Array, wheelbase: Array, track: Array) -> Array:
    """The rear wheels' speeds: those of a differential drive with the car's twist."""
    twist = bicycle.body_twist(v, phi, wheelbase)
    return differential_drive.wheel_rates(twist[..., 0], twist[..., 2], 1.0, track)


def world_motion(v: Array, theta: Array, phi: Array, wheelbase: Array) -> Array:
    """The velocity of the rear axle's middle in the world."""
    return motion.to_world(theta, bicycle.body_twist(v, phi, wheelbase))


def centre_of(x: Array, y: Array, theta: Array, phi: Array, wheelbase: Array) -> Array:
    """The ICR of a car at a pose."""
    twist = bicycle.body_twist(1.0, phi, wheelbase)
    return motion.icr(np.stack([x, y, theta], axis=-1), twist[..., 0], twist[..., 2])


def front_point_of(x: Array, y: Array, theta: Array, wheelbase: Array) -> Array:
    """The middle of the front axle in the world."""
    ahead = np.stack([wheelbase, 0 * wheelbase], axis=-1)
    return frames.transform(frames.se2(x, y, theta), ahead)


def front_motion(v: Array, theta: Array, phi: Array, wheelbase: Array) -> Array:
    """The velocity of the front axle's middle in the world."""
    return motion.to_world(theta, bicycle.front_twist(v, phi, wheelbase))[..., :2]


def front_speed_of(v: Array, phi: Array) -> Array:
    """The signed speed of the front axle."""
    twist = bicycle.front_twist(v, phi, 1.0)
    return np.asarray(np.copysign(np.hypot(twist[..., 0], twist[..., 1]), v))


def point_motion(v: Array, theta: Array, phi: Array, ahead: Array) -> Array:
    """The velocity of a point between the axles: a mean of theirs."""
    rear, front = bicycle.body_twist(v, phi, 1.0), bicycle.front_twist(v, phi, 1.0)
    mixed = rear + ahead[..., None] * (front - rear)
    return motion.to_world(theta, mixed)[..., :2]


def rate_from_front(v_F: Array, phi: Array, wheelbase: Array) -> Array:
    """The turning rate for each m/s of the front axle, times its speed."""
    twist = bicycle.front_twist(1.0, phi, wheelbase)
    return np.asarray(v_F * twist[..., 2] / np.hypot(twist[..., 0], twist[..., 1]))


def seen_from_y(v: Array, psi: Array, phi: Array, wheelbase: Array) -> Array:
    """Rear and front axle's velocities and the turning rate clockwise, heading from the y axis."""
    theta = np.pi / 2 - psi
    rear, front = world_motion(v, theta, phi, wheelbase), front_motion(v, theta, phi, wheelbase)
    return np.concatenate([rear[..., :2], front, -rear[..., 2:]], axis=-1)


def curvature_of(phi: Array, wheelbase: Array) -> Array:
    """The turning rate for each m/s of the rear axle."""
    return np.asarray(bicycle.body_twist(1.0, phi, wheelbase)[..., 2])


def slides(alpha_L: Array, alpha_R: Array, wheelbase: Array, track: Array) -> tuple[Array, Array]:
    """Return how the front wheels' sideways speeds grow with v and with ω: (n, 2) each."""
    alpha = np.stack([alpha_L, alpha_R], axis=-1)
    beside = track[:, None] / 2 * np.array([1, -1])
    turning = np.stack([-beside, wheelbase[:, None] + 0 * alpha], axis=-1)  # of a wheel's place
    by_turning = motion.to_body(alpha, np.concatenate([turning, 0 * turning[..., :1]], axis=-1))
    return motion.to_body(alpha, np.array([1.0, 0.0, 0.0]))[..., 1], by_turning[..., 1]


def least_squares(alpha_L: Array, alpha_R: Array, wheelbase: Array, track: Array) -> Array:
    """The turning rate for which the squares of the front wheels' slides are least."""
    ahead, turning = slides(alpha_L, alpha_R, wheelbase, track)
    return np.array(
        [np.linalg.lstsq(t[:, None], -a)[0][0] for a, t in zip(ahead, turning, strict=True)]
    )


def slides_at(
    alpha_L: Array, alpha_R: Array, wheelbase: Array, track: Array, kappa: Array
) -> Array:
    """The front wheels' slides outwards, to the right, at a curvature."""
    ahead, turning = slides(alpha_L, alpha_R, wheelbase, track)
    return -(ahead + kappa[:, None] * turning)


def closed_rod(alpha_L: Array, track: Array, arm: Array, arm_angle: Array) -> Array:
    """The right wheel's angle at which the rod has its length, by bisection."""

    def off(alpha_R: Array) -> Array:
        one = arm[:, None] * turn(alpha_L + arm_angle) - track[:, None] / 2 * np.array([1, 0])
        other = arm[:, None] * turn(alpha_R - arm_angle) + track[:, None] / 2 * np.array([1, 0])
        return np.asarray(np.hypot(*(other - one).T) - (track - 2 * arm * np.sin(arm_angle)))

    def turn(angle: Array) -> Array:
        return np.stack([np.sin(angle), -np.cos(angle)], axis=-1)

    low, high = np.full_like(alpha_L, -1.0), np.full_like(alpha_L, 1.0)
    for _ in range(60):
        middle = (low + high) / 2
        too_long = off(middle) > 0
        low, high = np.where(too_long, low, middle), np.where(too_long, middle, high)
    return low


def direction_of(phi: Array, ahead: Array) -> Array:
    """The direction of a point between the axles, seen from the car."""
    velocity = point_motion(np.ones_like(phi), np.zeros_like(phi), phi, ahead)
    return np.arctan2(velocity[..., 1], velocity[..., 0])


def front_distance(R: Array, wheelbase: Array) -> Array:
    """The front axle's speed by the turning rate."""
    twist = bicycle.front_twist(1.0, np.arctan(wheelbase / R), wheelbase)
    return np.asarray(np.hypot(twist[..., 0], twist[..., 1]) / np.abs(twist[..., 2]))


def two_arcs_and_back(kappa: Array, arc_length: Array) -> Array:
    """Where two arcs, to the left and to the right, and a straight way back end, sideways."""
    phi = np.stack([np.arctan(kappa), -np.arctan(kappa)], axis=-1)
    return bicycle.path([0.0, 0.0, 0.0], 1.0, phi, 1.0, arc_length[:, None])[..., -1, 1]


def exact_step(pose: Array, v: Array, phi: Array, wheelbase: Array, dt: Array) -> Array:
    """The first step of an exact path."""
    return bicycle.path(pose, v[:, None], phi[:, None], wheelbase, dt[:, None])[..., 1, :]


def one_euler_step(pose: Array, v: Array, phi: Array, wheelbase: Array, dt: Array) -> Array:
    """The first step of a path that keeps the old heading."""
    given = v[:, None], phi[:, None], wheelbase, dt[:, None]
    return bicycle.path(pose, *given, method="start")[..., 1, :]


def lane_of(R: Array, wheelbase: Array, track: Array) -> Array:
    """From the radius; nan where the ICR lies under the car, which sweeps a disc and no lane."""
    lane = bicycle.lane_width(np.arctan(wheelbase / R), wheelbase, track)
    return np.where(np.abs(R) < track / 2, np.nan, lane)


CHECKS = (
    Check(
        formulas.tangents,
        function=tangents_of_radius,
        arguments=(R, wheelbase, track),
        ranges={R: (2, 10)},
        tolerance=3e-14,
        reason="angles rounded once, times the slope of the tangent, 1 + 13²: up to 180",
        specials=({R: -5.0}, {R: float("inf")}, {R: 1e9}),
    ),
    Check(
        formulas.equivalent_steering,
        function=tangent_of_steering,
        arguments=(alpha_L, alpha_R),
        ranges={alpha_L: (0.05, 1.4), alpha_R: (0.05, 1.4)},
        tolerance=2e-14,
        reason="an angle rounded once, times the slope of the tangent, 1 + 5.8²: up to 35",
        specials=(
            {alpha_L: 0.0, alpha_R: 0.0},
            {alpha_L: 0.0},
            {alpha_R: 0.0},
            {alpha_L: 1e-9, alpha_R: 1e-9},
            {alpha_L: -0.6, alpha_R: -0.7},
        ),
    ),
    Check(
        formulas.equivalent_by_tangents,
        function=tangent_of_steering,
        arguments=(alpha_L, alpha_R),
        ranges={alpha_L: (0.05, 1.4), alpha_R: (0.05, 1.4)},
        tolerance=2e-14,
        reason="as equivalent_steering",
        specials=({alpha_L: 0.0}, {alpha_R: 0.0}, {alpha_L: -0.6, alpha_R: -0.7}),
    ),
    Check(
        formulas.ackermann,
        function=bicycle.ackermann,
        arguments=(steering, wheelbase, track),
        tolerance=2e-15,
        reason="a few roundings of a quotient, of an angle up to π/2",
        specials=(AHEAD, *SLIGHT, {steering: 1.4, wheelbase: 2.5, track: 1.5}),
    ),
    Check(
        formulas.ackermann_condition,
        function=cotangents_apart,
        arguments=(steering, wheelbase, track),
        ranges=STEERED,
        tolerance=5e-14,
        reason="angles rounded once, times the slope of the cotangent, 1 + 10²: up to 100",
        specials=({steering: -0.5},),
    ),
    Check(
        formulas.steepest_steering,
        function=steepest,
        arguments=(wheelbase, track),
        tolerance=1e-15,
        reason="a few roundings of an angle up to π/2",
    ),
    Check(
        formulas.turning_radius,
        function=bicycle.turning_radius,
        arguments=(steering, wheelbase),
        ranges=STEERED,
        tolerance=5e-14,
        reason="three roundings of a radius up to 100 m",
        specials=(AHEAD, {steering: -0.5}, {steering: np.pi / 4}),
    ),
    Check(
        formulas.curvature,
        function=curvature_of,
        arguments=(steering, wheelbase),
        tolerance=2e-15,
        reason="three roundings of numbers up to 2.6",
        specials=(AHEAD, *SLIGHT),
    ),
    Check(
        formulas.least_scrub,
        function=least_squares,
        arguments=(alpha_L, alpha_R, wheelbase, track),
        ranges={alpha_L: (-0.8, 0.8), alpha_R: (-0.8, 0.8)},
        tolerance=2e-14,
        reason="roundings of a quotient up to 4, by a sum of squares that is above 0.3",
        specials=({alpha_L: 0.0, alpha_R: 0.0}, {alpha_L: 0.5, alpha_R: 0.5}),
    ),
    Check(
        formulas.scrub,
        function=slides_at,
        arguments=(alpha_L, alpha_R, wheelbase, track, kappa),
        tolerance=1e-14,
        reason="a few roundings of numbers up to 11",
        specials=({alpha_L: 0.0, alpha_R: 0.0, kappa: 0.0},),
    ),
    Check(
        formulas.trapezoid,
        function=closed_rod,
        arguments=(alpha_L, track, arm, arm_angle),
        ranges={alpha_L: (0.0, 0.7), track: (1.0, 2.0)},
        tolerance=1e-13,
        reason="an arccosine near its middle, and a rod of up to 2 m by an arm of at least 0.1 m",
        specials=({alpha_L: 0.0},),
    ),
    Check(
        formulas.slip_angle,
        function=direction_of,
        arguments=(steering, ahead),
        tolerance=1e-15,
        reason="a few roundings of an angle up to 1.2",
        specials=(AHEAD, {ahead: 0.0}, {ahead: 1.0}),
    ),
    Check(
        formulas.front_radius,
        function=front_distance,
        arguments=(R, wheelbase),
        ranges={R: (1, 10)},
        tolerance=3e-14,
        reason="a few roundings of numbers up to 14 m, with a tangent of up to 10",
        specials=({R: -5.0},),
    ),
    Check(
        formulas.sideways,
        function=two_arcs_and_back,
        arguments=(kappa, arc_length),
        tolerance=5e-15,
        reason="a few roundings of places up to 10 m",
        specials=({kappa: 0.0}, {kappa: 1e-9}),
    ),
    Check(
        formulas.rear_speed,
        function=speed_of_rate,
        arguments=(rate_rear, r),
        tolerance=4e-15,
        reason="two roundings of a speed up to 10 m/s",
        specials=({rate_rear: 0.0},),
    ),
    Check(
        formulas.world,
        function=world_motion,
        arguments=(v, theta, steering, wheelbase),
        tolerance=3e-15,
        reason="three roundings of numbers up to 2.6",
        specials=(AHEAD, *QUARTERS, {v: 0.0}, {steering: np.pi / 4}),
    ),
    Check(
        formulas.icr,
        function=centre_of,
        arguments=(x, y, theta, steering, wheelbase),
        ranges=STEERED,
        tolerance=1e-13,
        reason="a few roundings of numbers up to 100 m",
        specials=(AHEAD, {steering: -0.5}, *QUARTERS),
    ),
    Check(
        formulas.rear_speeds,
        function=rear_speeds_of,
        arguments=(v, steering, wheelbase, track),
        tolerance=5e-15,
        reason="a few roundings of numbers up to 4 m/s",
        specials=(AHEAD, {v: 0.0}),
    ),
    Check(
        formulas.front_point,
        function=front_point_of,
        arguments=(x, y, theta, wheelbase),
        tolerance=4e-15,
        reason="three roundings of numbers up to 12 m",
        specials=QUARTERS,
    ),
    Check(
        formulas.front_speed,
        function=front_speed_of,
        arguments=(v, steering),
        tolerance=3e-15,
        reason="a few roundings of a speed up to 2.8 m/s",
        specials=(AHEAD, {v: 0.0}),
    ),
    Check(
        formulas.front_world,
        function=front_motion,
        arguments=(v, theta, steering, wheelbase),
        tolerance=3e-15,
        reason="a few roundings of numbers up to 2.8",
        specials=(AHEAD, *QUARTERS, {v: 0.0}),
    ),
    Check(
        formulas.point_world,
        function=point_motion,
        arguments=(v, theta, steering, ahead),
        tolerance=3e-15,
        reason="a few roundings of numbers up to 2.8",
        specials=({ahead: 0.0}, {ahead: 1.0}, AHEAD),
    ),
    Check(
        formulas.front_rate,
        function=rate_from_front,
        arguments=(v_F, steering, wheelbase),
        tolerance=3e-15,
        reason="a few roundings of numbers up to 2 rad/s",
        specials=(AHEAD, {v_F: 0.0}),
    ),
    Check(
        formulas.y_axis,
        function=seen_from_y,
        arguments=(v, y_heading, steering, wheelbase),
        tolerance=4e-15,
        reason="a heading rounded once, and a few roundings of numbers up to 2.8",
        specials=(AHEAD, {y_heading: 0.0}, {y_heading: np.pi / 2}),
    ),
    Check(
        formulas.arc_step,
        function=exact_step,
        arguments=((x, y, theta), v, steering, wheelbase, dt),
        tolerance=3e-15,
        reason="a rounding of the heading (up to 6 rad), times a chord of at most 1 m",
        specials=(AHEAD, *SLIGHT, *QUARTERS, {dt: 0.0}, {v: 0.0}),
    ),
    Check(
        formulas.euler_step,
        function=one_euler_step,
        arguments=((x, y, theta), v, steering, wheelbase, dt),
        tolerance=2e-15,
        reason="a few roundings of numbers up to 6",
        specials=(AHEAD, *SLIGHT, {dt: 0.0}),
    ),
    Check(
        formulas.cut,
        function=bicycle.corner_cut,
        arguments=(steering, wheelbase),
        ranges=STEERED,
        tolerance=5e-15,
        reason="a few roundings of numbers up to 10 m",
        specials=(AHEAD, {steering: -0.5}),
    ),
    Check(
        formulas.lane,
        function=lane_of,
        arguments=(R, wheelbase, track),
        tolerance=1e-14,
        reason="a few roundings of radii up to 16 m",
        specials=({R: 5.0}, {R: -5.0}, {R: float("inf")}, {R: 0.1}, {R: -0.2}),
    ),
)
