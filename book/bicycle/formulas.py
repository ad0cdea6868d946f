"""Bicycle model: steering angles, motion, front axle, one step, and the lane a long car needs."""

import numpy as np
from numpy.typing import ArrayLike
from sympy import (
    Abs,
    Eq,
    Matrix,
    Ne,
    Piecewise,
    Symbol,
    atan,
    cos,
    cot,
    nan,
    oo,
    sin,
    sinc,
    sqrt,
    tan,
)

from book.differential_drive.formulas import R, r, v_L, v_R
from book.motion.formulas import (
    dt,
    omega,
    theta,
    theta_dot,
    theta_next,
    v,
    x,
    x_dot,
    x_icr,
    x_next,
    y,
    y_dot,
    y_icr,
    y_next,
)
from robokin import bicycle, differential_drive, frames, motion
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

steering = quantity(
    "steering", "rad", -1.2, 1.2, "steering angle of the bicycle, to the left", latex=r"\phi"
)
alpha_L = quantity("alpha_L", "rad", -1.4, 1.4, "steering angle of the left front wheel")
alpha_R = quantity("alpha_R", "rad", -1.4, 1.4, "steering angle of the right front wheel")
wheelbase = quantity("wheelbase", "m", 1, 10, "from the rear axle to the front axle", latex="L")
track = quantity("track", "m", 0.5, 2.5, "distance between the two wheels of an axle", latex="l")
rate_rear = quantity(
    "rate_rear", "rad/s", -20, 20, "rate of the driven rear wheels, their mean", latex=r"\Omega"
)
v_F = quantity("v_F", "m/s", -2, 2, "speed of the middle of the front axle")
ahead = quantity(
    "ahead", "", 0, 1, "how far ahead of the rear axle a point lies, in wheelbases", latex="a"
)
y_heading = quantity(
    "y_heading", "rad", -3.14, 3.14, "heading from the y axis, clockwise positive", latex=r"\psi"
)
psi_dot = Symbol(r"\dot{\psi}")
x_dot_F, y_dot_F = Symbol(r"\dot{x}_F"), Symbol(r"\dot{y}_F")
x_F, y_F = Symbol("x_F"), Symbol("y_F")
steepest_angle = Symbol(r"\phi_\mathrm{max}")
corner_cut, lane_width = Symbol("c"), Symbol("w")

AHEAD, SLIGHT = {steering: 0.0}, ({steering: 1e-8}, {steering: -1e-8})
QUARTERS = tuple({theta: quarter * np.pi / 2} for quarter in (-2, -1, 0, 1, 2))
STEERED = {steering: (0.1, 1.2)}


def tangents_of_radius(R: Array, wheelbase: Array, track: Array) -> Array:
    """The tangents [left, right, bicycle] of the steering angles of a turn about the ICR."""
    phi = np.arctan(wheelbase / R)
    left, right = np.moveaxis(bicycle.ackermann(phi, wheelbase, track), -1, 0)
    return np.asarray(np.tan(np.stack([left, right, phi], axis=-1)))


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
    """The velocity of the front axle's middle in the world, (…, 2)."""
    return motion.to_world(theta, bicycle.front_twist(v, phi, wheelbase))[..., :2]


def front_speed_of(v: Array, phi: Array) -> Array:
    """The signed speed of the front axle."""
    twist = bicycle.front_twist(v, phi, 1.0)
    return np.asarray(np.copysign(np.hypot(twist[..., 0], twist[..., 1]), v))


def point_motion(v: Array, theta: Array, phi: Array, ahead: Array) -> Array:
    """The velocity of a point between the axles, (…, 2): a mean of theirs."""
    rear, front = bicycle.body_twist(v, phi, 1.0), bicycle.front_twist(v, phi, 1.0)
    mixed = rear + ahead[..., None] * (front - rear)
    return motion.to_world(theta, mixed)[..., :2]


def rate_from_front(v_F: Array, phi: Array, wheelbase: Array) -> Array:
    """The turning rate of a car whose front axle moves at a speed."""
    return bicycle.body_twist(v_F * np.cos(phi), phi, wheelbase)[..., 2]


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


def cut_by(phi: Array, wheelbase: Array) -> Array:
    """How far the circle of the rear axle lies inside that of the front axle: speeds over rate."""
    rear = bicycle.body_twist(1.0, phi, wheelbase)
    front = bicycle.front_twist(1.0, phi, wheelbase)
    ahead = rear[..., 2] == 0
    rate = np.where(ahead, np.inf, np.abs(rear[..., 2]))
    return (np.hypot(front[..., 0], front[..., 1]) - rear[..., 0]) / rate


def lane_of(R: Array, wheelbase: Array, track: Array) -> Array:
    """Between the circles of the inner rear and the outer front wheel; straight: the track."""
    phi = np.arctan(wheelbase / R)
    radius = np.abs(bicycle.turning_radius(phi, wheelbase))
    with np.errstate(invalid="ignore"):
        lane = np.hypot(radius + track / 2, wheelbase) - (radius - track / 2)
    return np.asarray(np.where(np.isinf(radius), track, lane))


with as_written():
    tangents = Equation(
        name="bicycle.tangents",
        left=Matrix([tan(alpha_L), tan(alpha_R), tan(steering)]),
        right=Matrix([wheelbase / (R - track / 2), wheelbase / (R + track / 2), wheelbase / R]),
        source="exercise 5",
        function=tangents_of_radius,
        arguments=(R, wheelbase, track),
        ranges={R: (2, 10)},
        tolerance=3e-14,
        reason="angles rounded once, times the slope of the tangent, 1 + 13²: up to 180",
        specials=({R: -5.0}, {R: float("inf")}, {R: 1e9}),
    )

    together = sin(alpha_L + alpha_R)
    equivalent_steering = Equation(
        name="bicycle.equivalent_steering",
        left=tan(steering),
        right=Piecewise(
            (2 * sin(alpha_L) * sin(alpha_R) / together, Ne(together, 0)),
            (0, Eq(alpha_L, 0)),
            (nan, True),
        ),
        textbook=2 / (cot(alpha_L) + cot(alpha_R)),
        source="exercise 5",
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
    )

    equivalent_by_tangents = Equation(
        name="bicycle.equivalent_by_tangents",
        left=tan(steering),
        right=2 * tan(alpha_L) * tan(alpha_R) / (tan(alpha_L) + tan(alpha_R)),
        source="exercise 5",
        function=tangent_of_steering,
        arguments=(alpha_L, alpha_R),
        ranges={alpha_L: (0.05, 1.4), alpha_R: (0.05, 1.4)},
        tolerance=2e-14,
        reason="as equivalent_steering",
        specials=({alpha_L: 0.0}, {alpha_R: 0.0}, {alpha_L: -0.6, alpha_R: -0.7}),
    )

    across, forth = wheelbase * sin(steering), wheelbase * cos(steering)
    half = track / 2
    ackermann = Equation(
        name="bicycle.ackermann",
        left=Matrix([alpha_L, alpha_R]),
        right=Matrix(
            [
                atan(across / (forth - half * sin(steering))),
                atan(across / (forth + half * sin(steering))),
            ]
        ),
        source="exercise 5",
        function=bicycle.ackermann,
        arguments=(steering, wheelbase, track),
        tolerance=2e-15,
        reason="a few roundings of a quotient, of an angle up to π/2",
        specials=(AHEAD, *SLIGHT, {steering: 1.4, wheelbase: 2.5, track: 1.5}),
    )

    ackermann_condition = Equation(
        name="bicycle.ackermann_condition",
        left=cot(alpha_R) - cot(alpha_L),
        right=track / wheelbase,
        source="exercise 5",
        function=cotangents_apart,
        arguments=(steering, wheelbase, track),
        ranges=STEERED,
        tolerance=5e-14,
        reason="angles rounded once, times the slope of the cotangent, 1 + 10²: up to 100",
        specials=({steering: -0.5},),
    )

    steepest_steering = Equation(
        name="bicycle.steepest_steering",
        left=steepest_angle,
        right=atan(2 * wheelbase / track),
        source="exercise 5, |R| > l/2",
        function=steepest,
        arguments=(wheelbase, track),
        tolerance=1e-15,
        reason="a few roundings of an angle up to π/2",
    )

    turning_radius = Equation(
        name="bicycle.turning_radius",
        left=R,
        right=Piecewise((wheelbase / tan(steering), Ne(steering, 0)), (oo, True)),
        textbook=wheelbase / tan(steering),
        source="exercise 5",
        function=bicycle.turning_radius,
        arguments=(steering, wheelbase),
        ranges=STEERED,
        tolerance=5e-14,
        reason="three roundings of a radius up to 100 m",
        specials=(AHEAD, {steering: -0.5}, {steering: np.pi / 4}),
    )

    rear_speed = Equation(
        name="bicycle.rear_speed",
        left=v,
        right=r * rate_rear,
        source="exercise 5 (seed 004)",
        function=speed_of_rate,
        arguments=(rate_rear, r),
        tolerance=4e-15,
        reason="two roundings of a speed up to 10 m/s",
        specials=({rate_rear: 0.0},),
    )

    world = Equation(
        name="bicycle.world",
        left=Matrix([x_dot, y_dot, theta_dot]),
        right=Matrix([v * cos(theta), v * sin(theta), v / wheelbase * tan(steering)]),
        source="exercise 5",
        function=world_motion,
        arguments=(v, theta, steering, wheelbase),
        tolerance=3e-15,
        reason="three roundings of numbers up to 2.6",
        specials=(AHEAD, *QUARTERS, {v: 0.0}, {steering: np.pi / 4}),
    )

    icr = Equation(
        name="bicycle.icr",
        left=Matrix([x_icr, y_icr]),
        right=Matrix(
            [
                Piecewise(
                    (x - wheelbase / tan(steering) * sin(theta), Ne(steering, 0)), (oo, True)
                ),
                Piecewise(
                    (y + wheelbase / tan(steering) * cos(theta), Ne(steering, 0)), (oo, True)
                ),
            ]
        ),
        textbook=Matrix(
            [
                x - wheelbase / tan(steering) * sin(theta),
                y + wheelbase / tan(steering) * cos(theta),
            ]
        ),
        source="exercise 5",
        function=centre_of,
        arguments=(x, y, theta, steering, wheelbase),
        ranges=STEERED,
        tolerance=1e-13,
        reason="a few roundings of numbers up to 100 m",
        specials=(AHEAD, {steering: -0.5}, *QUARTERS),
    )

    rear_speeds = Equation(
        name="bicycle.rear_speeds",
        left=Matrix([v_L, v_R]),
        right=Matrix(
            [
                v * (1 - track * tan(steering) / (2 * wheelbase)),
                v * (1 + track * tan(steering) / (2 * wheelbase)),
            ]
        ),
        source="exercise 5 (seed 004)",
        function=rear_speeds_of,
        arguments=(v, steering, wheelbase, track),
        tolerance=5e-15,
        reason="a few roundings of numbers up to 4 m/s",
        specials=(AHEAD, {v: 0.0}),
    )

    front_point = Equation(
        name="bicycle.front_point",
        left=Matrix([x_F, y_F]),
        right=Matrix([x + wheelbase * cos(theta), y + wheelbase * sin(theta)]),
        source="exercise 5 (seed 004)",
        function=front_point_of,
        arguments=(x, y, theta, wheelbase),
        tolerance=4e-15,
        reason="three roundings of numbers up to 12 m",
        specials=QUARTERS,
    )

    front_speed = Equation(
        name="bicycle.front_speed",
        left=v_F,
        right=v / cos(steering),
        source="exercise 5",
        function=front_speed_of,
        arguments=(v, steering),
        tolerance=3e-15,
        reason="a few roundings of a speed up to 2.8 m/s",
        specials=(AHEAD, {v: 0.0}),
    )

    front_world = Equation(
        name="bicycle.front_world",
        left=Matrix([x_dot_F, y_dot_F]),
        right=Matrix(
            [
                v * cos(theta) - v * tan(steering) * sin(theta),
                v * sin(theta) + v * tan(steering) * cos(theta),
            ]
        ),
        textbook=Matrix(
            [
                v / cos(steering) * cos(theta + steering),
                v / cos(steering) * sin(theta + steering),
            ]
        ),
        source="exercise 5",
        function=front_motion,
        arguments=(v, theta, steering, wheelbase),
        tolerance=3e-15,
        reason="a few roundings of numbers up to 2.8",
        specials=(AHEAD, *QUARTERS, {v: 0.0}),
    )

    point_world = Equation(
        name="bicycle.point_world",
        left=Matrix([x_dot, y_dot]),
        right=Matrix(
            [
                v * (cos(theta) - ahead * tan(steering) * sin(theta)),
                v * (sin(theta) + ahead * tan(steering) * cos(theta)),
            ]
        ),
        source="exercise 5",
        function=point_motion,
        arguments=(v, theta, steering, ahead),
        tolerance=3e-15,
        reason="a few roundings of numbers up to 2.8",
        specials=({ahead: 0.0}, {ahead: 1.0}, AHEAD),
    )

    front_rate = Equation(
        name="bicycle.front_rate",
        left=omega,
        right=v_F * sin(steering) / wheelbase,
        source="exercise 5",
        function=rate_from_front,
        arguments=(v_F, steering, wheelbase),
        tolerance=3e-15,
        reason="a few roundings of numbers up to 2 rad/s",
        specials=(AHEAD, {v_F: 0.0}),
    )

    y_axis = Equation(
        name="bicycle.y_axis",
        left=Matrix([x_dot, y_dot, x_dot_F, y_dot_F, psi_dot]),
        right=Matrix(
            [
                v * sin(y_heading),
                v * cos(y_heading),
                v / cos(steering) * sin(y_heading - steering),
                v / cos(steering) * cos(y_heading - steering),
                -(v / wheelbase) * tan(steering),
            ]
        ),
        source="exercise 5 (seed 004), corrected",
        function=seen_from_y,
        arguments=(v, y_heading, steering, wheelbase),
        tolerance=4e-15,
        reason="a heading rounded once, and a few roundings of numbers up to 2.8",
        specials=(AHEAD, {y_heading: 0.0}, {y_heading: np.pi / 2}),
    )

    driven = v * dt
    turned = v * dt * tan(steering) / wheelbase
    arc_step = Equation(
        name="bicycle.arc_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix(
            [
                x + driven * sinc(turned / 2) * cos(theta + turned / 2),
                y + driven * sinc(turned / 2) * sin(theta + turned / 2),
                theta + turned,
            ]
        ),
        textbook=Matrix(
            [
                x + wheelbase / tan(steering) * (sin(theta + turned) - sin(theta)),
                y - wheelbase / tan(steering) * (cos(theta + turned) - cos(theta)),
                theta + turned,
            ]
        ),
        source="exercise 5",
        function=exact_step,
        arguments=((x, y, theta), v, steering, wheelbase, dt),
        tolerance=3e-15,
        reason="a rounding of the heading (up to 6 rad), times a chord of at most 1 m",
        specials=(AHEAD, *SLIGHT, *QUARTERS, {dt: 0.0}, {v: 0.0}),
    )

    euler_step = Equation(
        name="bicycle.euler_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix([x + v * cos(theta) * dt, y + v * sin(theta) * dt, theta + turned]),
        source="exercise 5 (seed 004)",
        function=one_euler_step,
        arguments=((x, y, theta), v, steering, wheelbase, dt),
        tolerance=2e-15,
        reason="a few roundings of numbers up to 6",
        specials=(AHEAD, *SLIGHT, {dt: 0.0}),
    )

    cut = Equation(
        name="bicycle.corner_cut",
        left=corner_cut,
        right=wheelbase * tan(Abs(steering) / 2),
        source="exercise 5, what follows from it",
        function=cut_by,
        arguments=(steering, wheelbase),
        ranges=STEERED,
        tolerance=1e-13,
        reason="two radii of up to 100 m, each rounded twice",
        specials=(AHEAD, {steering: -0.5}),
    )

    outer = Abs(R) + track / 2
    reach = sqrt(outer**2 + wheelbase**2)
    lane = Equation(
        name="bicycle.lane",
        left=lane_width,
        right=track + wheelbase**2 / (reach + outer),
        textbook=reach - (Abs(R) - track / 2),
        source="exercise 5, what follows from it",
        function=lane_of,
        arguments=(R, wheelbase, track),
        tolerance=1e-14,
        reason="a few roundings of radii up to 16 m",
        specials=({R: 5.0}, {R: -5.0}, {R: float("inf")}),
    )
