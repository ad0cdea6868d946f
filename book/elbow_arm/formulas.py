"""The three-joint elbow arm: from joint angles to the wrist, and the ways back."""

import numpy as np
from numpy.typing import ArrayLike
from sympy import Abs, Add, Matrix, Max, Min, Symbol, acos, atan2, cos, pi, sin, sqrt

from book.basics.formulas import p_x, p_y
from robokin import elbow_arm, euler, frames
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

theta1 = quantity("theta1", "rad", -3.14, 3.14, "angle of joint 1", latex=r"\theta_1")
theta2 = quantity("theta2", "rad", -3.14, 3.14, "angle of joint 2", latex=r"\theta_2")
theta3 = quantity("theta3", "rad", -3.14, 3.14, "angle of joint 3", latex=r"\theta_3")
p_z = quantity("p_z", "m", -2, 2, "a point, along z")
a2 = quantity("a2", "m", 0.4, 0.5, "length of the upper link", latex="a_2")
a3 = quantity("a3", "m", 0.3, 0.4, "length of the forearm", latex="a_3")
d1 = quantity("d1", "m", -0.5, 0.5, "height of the shoulder above the base", latex="d_1")
out = quantity("out", "m", 0.3, 0.4, "distance of the wrist from the base axis", latex="r")
high = quantity("high", "m", -0.3, 0.3, "height of the wrist above the shoulder", latex="h")
apart = quantity("apart", "m", 0.25, 0.55, "distance from shoulder to wrist", latex="d")
dh_theta = quantity("dh_theta", "rad", -3.14, 3.14, "turn about z of a step", latex=r"\theta_i")
dh_d = quantity("dh_d", "m", -1, 1, "shift along z of a step", latex="d_i")
dh_a = quantity("dh_a", "m", -1, 1, "shift along x of a step", latex="a_i")
dh_alpha = quantity("dh_alpha", "rad", -3.14, 3.14, "turn about x of a step", latex=r"\alpha_i")

A = Symbol("A")
phi1, phi2, phi3 = (Symbol(rf"\varphi_{k}") for k in (1, 2, 3))
d_min, d_max = Symbol(r"d_\mathrm{min}"), Symbol(r"d_\mathrm{max}")
THETA = (theta1, theta2, theta3)
NEAREST = [Symbol(rf"p'_{{{axis}}}") for axis in "xyz"]
LONG = 3.0  # m, links of an arm that reaches any point that is drawn

STRETCHED = {a2: 0.5, a3: 0.25, apart: 0.75}
FOLDED = ({a2: 0.5, a3: 0.25, apart: 0.25}, {a2: 0.25, a3: 0.5, apart: 0.25})
WITHIN_REACH = {p_x: (0.25, 0.35), p_y: (0.1, 0.25)}  # whatever the height and the links


def on_side(kind: str, name: str) -> Symbol:
    """A joint angle of one of the answers: up, down, facing or away."""
    return Symbol(rf"\theta_{name}^\mathrm{{{kind}}}")


def all_four(out: Array, high: Array, a2: ArrayLike, a3: ArrayLike) -> Array:
    """The answers for a wrist ahead of the base, measured from the shoulder."""
    return elbow_arm.inverse(np.stack([out, 0 * out, high], axis=-1), a2, a3)


def base_turns(p: Array) -> Array:
    """The two turns of the base: facing the target, and away from it."""
    return elbow_arm.inverse(p, LONG, LONG)[..., [0, 2], 0]


def seen_from_the_side(p: Array, d1: Array) -> Array:
    """Out and up from the shoulder, once the base is turned back, and out if it lies level."""
    theta = elbow_arm.inverse(p, LONG, LONG, d1)[..., 0, :]
    out, _, high = np.moveaxis(elbow_arm.forward(theta * [0, 1, 1], LONG, LONG), -1, 0)
    level = theta * [0, 0, 1] - [0, 0.5, 0] * theta[..., 2:]  # links alike: the elbow in the middle
    return np.stack([out, high, elbow_arm.forward(level, LONG, LONG)[..., 0]], axis=-1)


def triangle_of(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """The angle at the shoulder, at the elbow, and the rise of the line to the wrist."""
    up, down = np.moveaxis(all_four(out, high, a2, a3)[..., :2, :], -2, 0)
    lift, rise = (up[..., 1] - down[..., 1]) / 2, (up[..., 1] + down[..., 1]) / 2
    return np.stack([lift, np.pi - down[..., 2], rise], axis=-1)


def bends(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta2, theta3 with the elbow up, then down."""
    return all_four(out, high, a2, a3)[..., :2, 1:].reshape(*out.shape, 4)


def cosine_of_elbow(p: Array, a2: Array, a3: Array) -> Array:
    """The cosine of theta3, the same in all four answers."""
    return np.cos(elbow_arm.inverse(p, a2, a3)[..., 0, 2])


def elbows(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta3, the positive one first."""
    return all_four(out, high, a2, a3)[..., [1, 0], 2]


def shoulders(out: Array, high: Array, a2: Array, a3: Array) -> Array:
    """theta2 for a positive theta3, facing and away."""
    return all_four(out, high, a2, a3)[..., [1, 2], 1]


def lift_and_elbow(apart: Array, a2: Array, a3: Array) -> Array:
    """The angle at the shoulder and theta3, both positive or zero."""
    level = all_four(apart, 0 * apart, a2, a3)
    return np.stack([level[..., 0, 1], level[..., 1, 2]], axis=-1)


def turned_round(theta: Array, a2: Array, a3: Array) -> Array:
    """The answer that faces away, from one that faces the target with its elbow down."""
    return elbow_arm.inverse(elbow_arm.forward(theta, a2, a3), a2, a3)[..., 3, :]


def limits(a2: Array, a3: Array) -> Array:
    """The smallest and the largest distance from shoulder to wrist."""
    return np.stack(elbow_arm.reach(a2, a3), axis=-1)


def joint_frame(theta: Array, d: Array, a: Array, alpha: Array) -> Array:
    """A step of four numbers, by the poses of `robokin.frames`."""
    zero = 0 * theta
    first = frames.se3(euler.to_matrix("Z", theta[..., None]), np.stack([zero, zero, d], -1))
    second = frames.se3(euler.to_matrix("X", alpha[..., None]), np.stack([a, zero, zero], -1))
    return frames.compose(first, second)


def wrist_frame(theta: Array, a2: Array, a3: Array, d1: Array) -> Array:
    """The wrist's pose: turned as by three Euler angles, placed as `forward` says."""
    quarter = np.full_like(theta[..., 0], np.pi / 2)
    turns = np.stack([theta[..., 0], quarter, theta[..., 1] + theta[..., 2]], axis=-1)
    return frames.se3(euler.to_matrix("ZXZ", turns), elbow_arm.forward(theta, a2, a3, d1))


with as_written():
    raised = theta2 + theta3
    forward = Equation(
        name="elbow_arm.forward",
        left=Matrix([p_x, p_y, p_z]),
        right=Matrix(
            [
                (a2 * cos(theta2) + a3 * cos(raised)) * cos(theta1),
                (a2 * cos(theta2) + a3 * cos(raised)) * sin(theta1),
                Add(d1, a2 * sin(theta2), a3 * sin(raised)),
            ]
        ),
        source="exercise 1",
        function=elbow_arm.forward,
        arguments=(THETA, a2, a3, d1),
        tolerance=1e-15,
        reason="a rounding of the angles' sum (up to 6 rad) and some of lengths up to 1.4 m",
        specials=({theta2: 0.0, theta3: 0.0}, {theta1: np.pi / 2, theta3: np.pi}),
    )

    base = Equation(
        name="elbow_arm.base",
        left=Matrix([on_side("facing", "1"), on_side("away", "1")]),
        right=Matrix([atan2(p_y, p_x), atan2(p_y, p_x) + pi]),
        source="exercise 1",
        function=base_turns,
        arguments=((p_x, p_y, p_z),),
        tolerance=1e-15,
        reason="two roundings of numbers up to 2 pi",
        specials=({p_x: 0.0, p_y: 0.0}, {p_x: -1.0, p_y: 0.0}, {p_x: -1.0, p_y: -1.0}),
        is_angle=True,
    )

    side = Equation(
        name="elbow_arm.side",
        left=Matrix([out, high, apart]),
        right=Matrix([sqrt(p_x**2 + p_y**2), p_z - d1, sqrt(out**2 + high**2)]),
        where=((out, sqrt(p_x**2 + p_y**2)), (high, p_z - d1)),
        source="exercise 1",
        function=seen_from_the_side,
        arguments=((p_x, p_y, p_z), d1),
        tolerance=2e-14,
        reason="through joint angles up to pi and back, of an arm of 6 m",
        specials=({p_x: 0.0, p_y: 0.0}, {p_x: -1.0, p_y: 0.0}),
    )

    square = out**2 + high**2
    TRIANGLE = (
        (phi1, acos(Add(a2**2, apart**2, -(a3**2)) / (2 * a2 * apart))),
        (phi2, acos(Add(a2**2, a3**2, -(apart**2)) / (2 * a2 * a3))),
        (phi3, atan2(high, out)),
    )
    triangle = Equation(
        name="elbow_arm.triangle",
        left=Matrix([phi1, phi2, phi3]),
        right=Matrix([angle for _, angle in TRIANGLE]),
        where=((apart, sqrt(square)),),
        source="exercise 1 (seed 000)",
        function=triangle_of,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="roundings of angles up to pi, and of d (5e-17 m) times at most 1/0.1 m",
        specials=({high: 0.0},),
    )

    first_way = Equation(
        name="elbow_arm.first_way",
        left=Matrix(
            [
                on_side("up", "2"),
                on_side("up", "3"),
                on_side("down", "2"),
                on_side("down", "3"),
            ]
        ),
        right=Matrix([phi3 + phi1, phi2 - pi, phi3 - phi1, pi - phi2]),
        where=((apart, sqrt(square)), *TRIANGLE),
        source="exercise 1 (seed 000)",
        function=bends,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="as triangle",
        specials=({high: 0.0},),
    )

    cosine = Equation(
        name="elbow_arm.cosine",
        left=A,
        right=Add(p_x**2, p_y**2, high**2, -(a2**2), -(a3**2)) / (2 * a2 * a3),
        source="exercise 1 (seed 001)",
        function=cosine_of_elbow,
        arguments=((p_x, p_y, high), a2, a3),
        ranges=WITHIN_REACH,
        tolerance=2e-15,
        reason="as triangle, and a cosine",
        specials=({high: 0.0},),
    )

    COSINE = (A, (square - a2**2 - a3**2) / (2 * a2 * a3))
    elbow = Equation(
        name="elbow_arm.elbow",
        left=Matrix([Symbol(r"\theta_3^{+}"), Symbol(r"\theta_3^{-}")]),
        right=Matrix([atan2(sqrt(1 - A**2), A), atan2(-sqrt(1 - A**2), A)]),
        where=(COSINE,),
        source="exercise 1 (seed 001)",
        function=elbows,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="as triangle",
        specials=({high: 0.0},),
    )

    shoulder = Equation(
        name="elbow_arm.shoulder",
        left=Matrix([on_side("facing", "2"), on_side("away", "2")]),
        right=Matrix(
            [
                atan2(high, out) - atan2(a3 * sin(theta3), a2 + a3 * cos(theta3)),
                atan2(high, -out) - atan2(a3 * sin(theta3), a2 + a3 * cos(theta3)),
            ]
        ),
        where=(COSINE, (theta3, atan2(sqrt(1 - A**2), A))),
        source="exercise 1 (seed 001)",
        function=shoulders,
        arguments=(out, high, a2, a3),
        tolerance=2e-15,
        reason="as triangle",
        specials=({high: 0.0},),
        is_angle=True,
    )

    room, span = Add(a2, a3, -apart), Add(a2, a3, apart)  # four sums and differences of three sides
    near, far = apart - (a2 - a3), apart + (a2 - a3)
    half_angles = Equation(
        name="elbow_arm.half_angles",
        left=Matrix([phi1, theta3]),
        right=Matrix(
            [
                2 * atan2(sqrt(room * near), sqrt(span * far)),
                2 * atan2(sqrt(room * span), sqrt(near * far)),
            ]
        ),
        source="exercise 1",
        function=lift_and_elbow,
        arguments=(apart, a2, a3),
        tolerance=5e-15,
        reason="roundings of angles up to pi and of the four lengths, at least 0.05 m",
        specials=(STRETCHED, *FOLDED),
    )

    away = Equation(
        name="elbow_arm.away",
        left=Matrix([on_side("away", str(k)) for k in (1, 2, 3)]),
        right=Matrix([theta1 + pi, pi - theta2, -theta3]),
        source="exercise 1",
        function=turned_round,
        arguments=(THETA, a2, a3),
        ranges={theta2: (-0.5, 0.5), theta3: (0.1, 1.5)},
        tolerance=1e-14,
        reason="there and back; where the arm is nearly stretched (0.1 rad) ten times a rounding",
        specials=({theta1: 0.0}, {theta1: np.pi}),
        is_angle=True,
    )

    reach = Equation(
        name="elbow_arm.reach",
        left=Matrix([d_min, d_max]),
        right=Matrix([Abs(a2 - a3), a2 + a3]),
        source="exercise 1",
        function=limits,
        arguments=(a2, a3),
        tolerance=2e-16,
        reason="one rounding of a number up to 1",
        specials=({a2: 0.4, a3: 0.4},),
    )

    D = Symbol(r"\hat{d}")  # the distance nearest to d that the arm can do
    nearest = Equation(
        name="elbow_arm.nearest",
        left=Matrix(NEAREST),
        right=Matrix([D / apart * p_x, D / apart * p_y, d1 + D / apart * (p_z - d1)]),
        where=(
            (apart, sqrt(p_x**2 + p_y**2 + (p_z - d1) ** 2)),
            (D, Max(Abs(a2 - a3), Min(apart, a2 + a3))),
        ),
        source="exercise 1",
        function=elbow_arm.nearest_reachable,
        arguments=((p_x, p_y, p_z), a2, a3, d1),
        tolerance=2e-15,
        reason="a few roundings of lengths up to 3 m",
        specials=({p_x: 0.0, p_y: 0.0}, {p_x: 0.01, p_y: 0.01, p_z: 0.25, d1: 0.25}),
    )

    dh_step = Equation(
        name="elbow_arm.dh_step",
        left=Symbol("T_{i-1,i}"),
        right=Matrix(
            [
                [
                    cos(dh_theta),
                    -sin(dh_theta) * cos(dh_alpha),
                    sin(dh_theta) * sin(dh_alpha),
                    dh_a * cos(dh_theta),
                ],
                [
                    sin(dh_theta),
                    cos(dh_theta) * cos(dh_alpha),
                    -cos(dh_theta) * sin(dh_alpha),
                    dh_a * sin(dh_theta),
                ],
                [0, sin(dh_alpha), cos(dh_alpha), dh_d],
                [0, 0, 0, 1],
            ]
        ),
        source="exercise 1 (seed 000 names it)",
        function=joint_frame,
        arguments=(dh_theta, dh_d, dh_a, dh_alpha),
        tolerance=1e-15,
        reason="sines, cosines and products of sizes up to 1",
        specials=({dh_alpha: np.pi / 2}, {dh_alpha: 0.0}),
    )

    dh_wrist = Equation(
        name="elbow_arm.dh_wrist",
        left=Symbol("T_{03}"),
        right=Matrix(
            [
                [cos(theta1) * cos(raised), -cos(theta1) * sin(raised), sin(theta1), p_x],
                [sin(theta1) * cos(raised), -sin(theta1) * sin(raised), -cos(theta1), p_y],
                [sin(raised), cos(raised), 0, p_z],
                [0, 0, 0, 1],
            ]
        ),
        where=tuple(zip((p_x, p_y, p_z), forward.right, strict=True)),
        source="exercise 1",
        function=wrist_frame,
        arguments=(THETA, a2, a3, d1),
        tolerance=2e-15,
        reason="as forward; the sum of two angles, rounded",
        specials=({theta1: 0.0, theta2: 0.0, theta3: 0.0},),
    )
