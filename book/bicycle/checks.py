"""How the library agrees with each formula of `formulas.py`."""

import numpy as np
from numpy.typing import ArrayLike

from book.bicycle import formulas
from book.bicycle.formulas import (
    ahead,
    alpha_L,
    alpha_R,
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
