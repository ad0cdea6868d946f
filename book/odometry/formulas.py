"""Odometry: from the ticks of two wheel encoders to the robot's pose, and how sure that is."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from sympy import Abs, Add, Matrix, Mod, Mul, Piecewise, Symbol, cos, pi, sin, sinc, sqrt, symbols

from book.differential_drive.formulas import b, r
from book.motion.formulas import dt, omega, theta, theta_next, v, x, x_next, y, y_next
from robokin import odometry
from robokin._checks import Array
from workshop.equations.core import Equation, as_written, quantity

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
count_now = quantity("count_now", "ticks", 0, 60000, "its next reading", latex="c'")
counter_span = quantity(
    "counter_span", "ticks", 4, 1e6, "numbers that a counter of k bits can show", latex="2^k"
)

noise = quantity("noise", "m", 0, 0.01, "variance of a wheel's travel per metre", latex="k")
p_xx = quantity("p_xx", "m²", 0, 0.1, "variance of x", latex="p_{xx}")
p_xy = quantity("p_xy", "m²", -0.1, 0.1, "covariance of x and y", latex="p_{xy}")
p_xt = quantity("p_xt", "m rad", -0.1, 0.1, "covariance of x and heading", latex=r"p_{x\theta}")
p_yy = quantity("p_yy", "m²", 0, 0.1, "variance of y", latex="p_{yy}")
p_yt = quantity("p_yt", "m rad", -0.1, 0.1, "covariance of y and heading", latex=r"p_{y\theta}")
p_tt = quantity("p_tt", "rad²", 0, 0.1, "variance of the heading", latex=r"p_{\theta\theta}")

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
    "short_turn", "rad", -0.2, 0.2, "angle by which a corner is too short", latex=r"\alpha"
)
side_swing = quantity(
    "side_swing", "rad", -0.2, 0.2, "angle by which a side swings to the left", latex=r"\beta"
)
b_true = quantity("b_true", "m", 0.05, 1, "wheel distance after calibration", latex="b'")
ratio = quantity("ratio", "", 0.9, 1.1, "diameter of the right wheel by the left", latex="E_d")

long_axis, short_axis = symbols(r"\sigma_1 \sigma_2")
dN = Symbol(r"\Delta N")
covariance_entries = (p_xx, p_xy, p_xt, p_yy, p_yt, p_tt)
p_next = [Symbol(f"{name}'") for name in ("p_{xx}", "p_{xy}", r"p_{x\theta}")]
p_next += [Symbol(f"{name}'") for name in ("p_{yy}", r"p_{y\theta}", r"p_{\theta\theta}")]

STRAIGHT = ({dtheta: 0.0}, {dtheta: 1e-16}, {dtheta: -1e-16}, {dtheta: 1e-8})
EXAMPLE = {N_L: 384.0, N_R: 640.0, C: 512.0, r: 0.05}
SAME, OPPOSITE = {D_L: 0.25, D_R: 0.25}, {D_L: -0.25, D_R: 0.25}
STILL = {D_L: 0.0, D_R: 0.0}

# The library takes whole ticks; a formula holds between them too. So a tick of the formula is
# 2**40 ticks of a finer encoder, and a metre 2**50 ticks: rounding to whole ones is 1e-15 m.
FINER = 2.0**40
TICKS_A_METRE = 2.0**50


def whole(ticks: ArrayLike) -> Array:
    """The nearest whole numbers of ticks."""
    return np.rint(ticks)


def travel_of_ticks(ticks: Array, C: Array, r: Array) -> Array:
    """What each of two wheels has rolled, from ticks (…, 2) that need not be whole."""
    return odometry.travel(whole(ticks * FINER), C[..., None] * FINER, r[..., None])


def velocity_of_travel(D_L: Array, D_R: Array, b: Array, dt: ArrayLike) -> Array:
    """Mean speed and turning rate from what the wheels have rolled."""
    ticks = whole(D_L * TICKS_A_METRE), whole(D_R * TICKS_A_METRE)
    found = odometry.velocity(*ticks, dt, TICKS_A_METRE, 0.5 / np.pi, b)
    return np.stack(found, axis=-1)


def distance_of_travel(D_L: Array, D_R: Array) -> Array:
    """How far the middle of the axle moves: its mean speed over one second."""
    return velocity_of_travel(D_L, D_R, np.ones_like(D_L), 1.0)[..., 0]


def turn_of_travel(D_L: Array, D_R: Array, b: Array) -> Array:
    """How much the robot turns, by the path of one sample."""
    ticks = whole(D_L * TICKS_A_METRE)[..., None], whole(D_R * TICKS_A_METRE)[..., None]
    return odometry.path(*ticks, TICKS_A_METRE, 0.5 / np.pi, b)[..., 1, 2]


def one_step(pose: Array, D: Array, dtheta: Array, method: str) -> Array:
    """The pose after one sample in which the robot moves by D and turns by dtheta."""
    left, right = (whole((D + s * dtheta / 2) * TICKS_A_METRE)[..., None] for s in (-1, 1))
    return odometry.path(left, right, TICKS_A_METRE, 0.5 / np.pi, 1.0, pose, method)[..., 1, :]


def by_old_heading(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample, all of it along the heading before."""
    return one_step(pose, D, dtheta, "start")


def by_new_heading(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample, all of it along the heading after."""
    return one_step(pose, D, dtheta, "end")


def by_middle_heading(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample, all of it along the heading half way."""
    return one_step(pose, D, dtheta, "midpoint")


def by_exact_arc(pose: Array, D: Array, dtheta: Array) -> Array:
    """One sample along the arc that the robot really drives."""
    return one_step(pose, D, dtheta, "exact")


def counter_difference(before: Array, now: Array, span: Array) -> Array:
    """Ticks between two readings of a counter that wraps round, by the same finer encoder."""
    finer = 2.0**52 / span
    counts = whole(np.stack([before, now], axis=-1) * finer[..., None])
    return odometry.unwrap_counter(counts, 52)[..., 0] / finer


def covariance_of_step(
    theta: Array, D_L: Array, D_R: Array, b: Array, noise: Array, start: Array
) -> Array:
    """The six different entries of a pose's covariance after one sample, from those before."""
    ticks = whole(D_L * TICKS_A_METRE)[..., None], whole(D_R * TICKS_A_METRE)[..., None]
    xx, xy, xt, yy, yt, tt = np.moveaxis(start, -1, 0)
    before = np.stack([xx, xy, xt, xy, yy, yt, xt, yt, tt], axis=-1).reshape(*xx.shape, 3, 3)
    pose = np.stack([0 * theta, 0 * theta, theta], axis=-1)
    robot = TICKS_A_METRE, 0.5 / np.pi, b
    after = odometry.covariance(*ticks, *robot, noise, pose, before)[..., 1, :, :]
    return after[..., [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]


def half_axes(xx: Array, xy: Array, yy: Array) -> Array:
    """The standard deviations along the two axes of an error ellipse, larger first."""
    matrix = np.stack([xx, xy, xy, yy], axis=-1).reshape(*xx.shape, 2, 2)
    axes: Array = np.sqrt(np.linalg.eigvalsh(matrix)[..., ::-1])
    return axes


def ends_of_runs(alpha: Array, beta: Array, side: Array) -> tuple[Array, Array]:
    """Where square runs end, to first order: clockwise and counter-clockwise, (…, 1, 2) each."""
    cw, ccw = -2 * side * (alpha + beta), -2 * side * (alpha - beta)
    ends = np.stack([cw, cw], axis=-1), np.stack([ccw, -ccw], axis=-1)
    return ends[0][..., None, :], ends[1][..., None, :]


def angles_of_ends(cw: Array, ccw: Array, side: Array) -> Array:
    """The two angles that the calibration finds on its way, from what it answers."""
    corrected, ratio = odometry.umbmark(cw[..., None, :], ccw[..., None, :], side, 1.0)
    swing = 2 * np.arcsin(side / corrected * (ratio - 1) / (ratio + 1))
    return np.stack([np.pi / 2 * (1 - 1 / corrected), swing], axis=-1)


def calibration_of_angles(alpha: Array, beta: Array, b: Array, side: Array) -> Array:
    """The corrected wheel distance and the ratio of diameters of runs with these two angles."""
    return np.stack(odometry.umbmark(*ends_of_runs(alpha, beta, side), side, b), axis=-1)


def one_sample(name: str, heading: Any, function: Any) -> Equation:
    """The rule that lays all of a sample's travel along one heading."""
    return Equation(
        name=f"odometry.{name}",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix([x + D * cos(heading), y + D * sin(heading), theta + dtheta]),
        source="exercise 7 (seed 003)",
        function=function,
        arguments=((x, y, theta), D, dtheta),
        tolerance=5e-15,
        reason="a rounding of headings up to 6 rad, and of travel to whole ticks of 1e-15 m",
        specials=(*STRAIGHT, {D: 0.0}),
    )


with as_written():
    travel = Equation(
        name="odometry.travel",
        left=Matrix([D_L, D_R]),
        right=Matrix([2 * pi * r * N_L / C, 2 * pi * r * N_R / C]),
        source="exercise 7 (seed 003)",
        function=travel_of_ticks,
        arguments=((N_L, N_R), C, r),
        tolerance=5e-14,
        reason="five roundings of numbers up to 2π 0.5 m x 1000 / 100 = 31 m",
        specials=(EXAMPLE, {N_L: 0.0, N_R: 0.0}),
    )

    distance = Equation(
        name="odometry.distance",
        left=D,
        right=(D_R + D_L) / 2,
        source="exercise 7 (seed 003)",
        function=distance_of_travel,
        arguments=(D_L, D_R),
        tolerance=2e-15,
        reason="a few roundings of numbers up to 1 m, and whole ticks of 1e-15 m",
        specials=(SAME, OPPOSITE, STILL),
    )

    turn = Equation(
        name="odometry.turn",
        left=dtheta,
        right=(D_R - D_L) / b,
        source="exercise 7 (seed 003)",
        function=turn_of_travel,
        arguments=(D_L, D_R, b),
        tolerance=5e-14,
        reason="roundings of 1e-15 m, divided by 0.05 m",
        specials=(SAME, OPPOSITE, STILL),
    )

    velocity = Equation(
        name="odometry.velocity",
        left=Matrix([v, omega]),
        right=Matrix([(D_R + D_L) / (2 * dt), (D_R - D_L) / (b * dt)]),
        source="exercise 7 (seed 003)",
        function=velocity_of_travel,
        arguments=(D_L, D_R, b, dt),
        ranges={dt: (0.05, 1)},
        tolerance=1e-12,
        reason="roundings of 1e-15 m, divided by 0.05 m x 0.05 s",
        specials=(SAME, OPPOSITE, STILL),
    )

    old_heading = one_sample("old_heading", theta, by_old_heading)
    new_heading = one_sample("new_heading", theta + dtheta, by_new_heading)
    middle_heading = one_sample("middle_heading", theta + dtheta / 2, by_middle_heading)

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
        source="exercise 7, exercise 5",
        function=by_exact_arc,
        arguments=((x, y, theta), D, dtheta),
        tolerance=5e-15,
        reason="a rounding of headings up to 6 rad, and of travel to whole ticks of 1e-15 m",
        specials=(*STRAIGHT, {D: 0.0}),
    )

    counter_step = Equation(
        name="odometry.counter_step",
        left=dN,
        right=Mod(Add(count_now, -count_before, counter_span / 2), counter_span) - counter_span / 2,
        source="exercise 7",
        function=counter_difference,
        arguments=(count_before, count_now, counter_span),
        ranges={counter_span: (65536, 65536)},
        tolerance=1e-10,
        reason="readings between whole numbers, rounded to 2**-36 of a tick",
        specials=({count_before: 65530.0, count_now: 4.0}, {count_before: 3.0, count_now: 65533.0}),
    )

    u, chord, x_step, y_step = symbols(r"u s \Delta{x} \Delta{y}", real=True)
    slope, w, a_L, a_R = symbols(r"\operatorname{sinc}'(u) w a_L a_R", real=True)
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
                Add(
                    p_xx, Mul(-2, y_step, p_xt), y_step**2 * p_tt,
                    q_L * x_by_L**2, q_R * x_by_R**2,
                ),
                Add(
                    p_xy, x_step * p_xt, Mul(-1, y_step, p_yt), Mul(-1, x_step, y_step, p_tt),
                    q_L * x_by_L * y_by_L, q_R * x_by_R * y_by_R,
                ),
                Add(p_xt, Mul(-1, y_step, p_tt), (q_R * x_by_R - q_L * x_by_L) / b),
                Add(
                    p_yy, 2 * x_step * p_yt, x_step**2 * p_tt,
                    q_L * y_by_L**2, q_R * y_by_R**2,
                ),
                Add(p_yt, x_step * p_tt, (q_R * y_by_R - q_L * y_by_L) / b),
                p_tt + (q_L + q_R) / b**2,
            ]
        ),
        where=(*of_the_wheels, *of_the_heading),
        source="exercise 7; Siegwart et al., section 5.2.4",
        function=covariance_of_step,
        arguments=(theta, D_L, D_R, b, noise, covariance_entries),
        tolerance=2e-14,
        reason="some fifty roundings of numbers up to 1; s: the chord, g: what a metre more of a "
        "wheel adds to the pose, q: the variances of the wheels' travel",
        specials=(SAME, OPPOSITE, STILL, {**SAME, noise: 0.0}),
    )  # fmt: skip

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
        source="eigenvalues of a symmetric 2 by 2 matrix",
        function=half_axes,
        arguments=(p_xx, p_xy, p_yy),
        ranges={p_xx: (0.05, 0.1), p_yy: (0.05, 0.1), p_xy: (-0.04, 0.04)},
        tolerance=2e-15,
        reason="a few roundings; m: half the sum of the variances, d: what the axes differ by",
        specials=({p_xx: 0.1, p_xy: 0.0, p_yy: 0.1}, {p_xx: 0.05, p_xy: 0.0, p_yy: 0.1}),
    )

    calibration_angles = Equation(
        name="odometry.calibration_angles",
        left=Matrix([short_turn, side_swing]),
        right=Matrix(
            [
                Add(y_ccw, -x_ccw, -x_cw, -y_cw) / (8 * side),
                Add(x_ccw, -y_ccw, -x_cw, -y_cw) / (8 * side),
            ]
        ),
        source="Borenstein & Feng 1996",
        function=angles_of_ends,
        arguments=((x_cw, y_cw), (x_ccw, y_ccw), side),
        tolerance=2e-14,
        reason="the swing is found back from a ratio near 1, times side / wheel distance = 5",
        specials=({x_cw: 0.0, y_cw: 0.0, x_ccw: 0.0, y_ccw: 0.0},),
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
        source="Borenstein & Feng 1996",
        function=calibration_of_angles,
        arguments=(short_turn, side_swing, b, side),
        tolerance=2e-15,
        reason="a few roundings of numbers up to 1.15",
        specials=({short_turn: 0.0, side_swing: 0.0}, {short_turn: 0.0}, {side_swing: 0.0}),
    )
