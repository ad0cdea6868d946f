"""Formula to JavaScript, on what the chapters ask of it: engine, NumPy and 50 digits agree.

Five cases, 1,000 points each and the special points: the exact arc, four arms at once, a choice
among 24 Euler sequences, a loop with state, ranks and possible motions of wheels.
"""

from itertools import permutations

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.spatial.transform import Rotation
from support import assert_angles

from book.motion import formulas as arc
from courseware.equations.equation import as_written
from courseware.equations.functions import null_projector, rank, solve
from courseware.equations.javascript import compile_javascript, run_javascript
from courseware.equations.verification import differences, evaluate_exactly
from courseware.errors import CourseError
from courseware.figures import Figure, Readout, Recurrence, Slider, Trail
from robokin import elbow_arm, euler, motion, wheels

N = 1000
ALLOWED = 1e-12  # what a figure promises; measured differences are some 1e-15


def in_engine(expressions, symbols, points, where=()):
    """Expressions of symbols, in the JavaScript engine, in one call."""
    return run_javascript(compile_javascript({"c": symbols}, expressions, where), points)


def assert_near(apart, allowed):
    """Whether the script is as near to 50 digits as a figure promises."""
    worst = np.abs(np.array(apart, dtype=float)).max()
    assert worst <= allowed, f"{worst:.2g} apart, allowed {allowed:.2g}: write it without loss"


def assert_all_agree(expressions, symbols, points, by_numpy=None, is_angle=False):
    """Engine against 50 digits, and against NumPy where a function is given."""
    in_script = in_engine(expressions, symbols, points)
    exact = evaluate_exactly(sp.Matrix(expressions), symbols, points)
    assert_near(differences(in_script, exact, is_angle), ALLOWED)
    if by_numpy is not None:
        np.testing.assert_allclose(in_script, by_numpy, rtol=0, atol=ALLOWED)
    return in_script


# 1 The exact arc


def test_exact_arc():
    symbols = [arc.x, arc.y, arc.theta, arc.v, arc.omega, arc.dt]
    random = np.random.default_rng(1)
    points = random.uniform([-2, -2, -3, -1, -6, 0], [2, 2, 3, 1, 6, 1], (N + 3, 6))
    points[:3, 4] = 0.0, 1e-16, -1e-16
    by_numpy = motion.arc_step(points[:, :3], *points[:, 3:].T)
    assert_all_agree(list(arc.arc_step.right), symbols, points, by_numpy)


# 2 The four branches of the elbow arm

px, py, pz, a2, a3 = sp.symbols("p_x p_y p_z a_2 a_3", real=True)


def four_arms():
    """[theta1, theta2, theta3] of the four branches in turn; NaN out of reach."""
    with as_written():
        r = sp.sqrt(px**2 + py**2)
        d = sp.sqrt(px**2 + py**2 + pz**2)
        outer, inner = (a2 + a3 - d) * (a2 + a3 + d), (d - (a2 - a3)) * (d + (a2 - a3))
        slack = 1e-12 * (a2 + a3) ** 2
        bend = 2 * sp.atan2(sp.sqrt(sp.Max(outer, 0)), sp.sqrt(sp.Max(inner, 0)))
        reached = sp.And(outer >= -slack, inner >= -slack)
        lift = sp.atan2(pz, r)
        arms = []
        for away, theta3 in ((0, -bend), (0, bend), (1, bend), (1, -bend)):
            reaching = sp.atan2(pz, -r) if away else lift
            theta2 = reaching - sp.atan2(a3 * sp.sin(theta3), a2 + a3 * sp.cos(theta3))
            theta1 = sp.atan2(-py, -px) if away else sp.atan2(py, px)
            arms += [sp.Piecewise((x, reached), (sp.nan, True)) for x in (theta1, theta2, theta3)]
    return arms


def test_four_arms():
    symbols = [px, py, pz, a2, a3]
    random = np.random.default_rng(2)
    points = random.uniform([-1, -1, -1, 0.3, 0.3], [1, 1, 1, 0.8, 0.8], (N, 5))
    in_script = assert_all_agree(four_arms(), symbols, points, is_angle=True).reshape(N, 4, 3)
    by_numpy = elbow_arm.inverse(points[:, :3], *points[:, 3:].T, unreachable="nan")
    assert 100 < np.isnan(by_numpy[:, 0, 0]).sum() < 900  # inside and outside reach are both met
    np.testing.assert_array_equal(np.isnan(in_script), np.isnan(by_numpy))
    reached = ~np.isnan(by_numpy[:, 0, 0])
    assert_angles(in_script[reached], by_numpy[reached], atol=ALLOWED)


def test_four_arms_stretched_and_folded():
    """Where two branches meet the angles lose half their digits; the hand does not."""
    points = [[0.7, 0, 0, 0.4, 0.3], [0, 0.42, 0.56, 0.4, 0.3], [0.1, 0, 0, 0.4, 0.3]]
    arms = in_engine(four_arms(), [px, py, pz, a2, a3], points).reshape(3, 4, 3)
    for arm, (*p, link2, link3) in zip(arms, points, strict=True):
        assert_angles(np.abs(arm[0, 2]), np.abs(arm[1, 2]), atol=0)
        hand = elbow_arm.forward(arm, link2, link3)
        np.testing.assert_allclose(hand, np.tile(p, (4, 1)), atol=ALLOWED)


# 3 Matrix to Euler angles, the sequence as a choice

SEQUENCES = [
    case(letters)
    for letters in [
        *("".join(p) for p in permutations("XYZ")),
        *(a + b + a for a, b in permutations("XYZ", 2)),
    ]
    for case in (str.upper, str.lower)
]


def chosen(sequence):
    """What a choice gives the formula: the new axes (9), proper or not, extrinsic or not."""
    i, j = ("XYZ".index(letter) for letter in sequence.upper()[:2])
    axes = np.zeros((3, 3))
    axes[i, 0] = axes[j, 1] = 1
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    return [*axes.ravel(), float(sequence[0] == sequence[2]), float(sequence.islower())]


def euler_angles():
    """The three angles, the third one first, for any sequence: symbols, steps, expressions."""
    r = sp.Matrix(3, 3, sp.symbols("r:3:3", real=True))
    p = sp.Matrix(3, 3, sp.symbols("p:3:3", real=True))
    m = sp.Matrix(3, 3, sp.symbols("m:3:3", real=True))  # in the sequence's own axes
    proper, extrinsic, sign, side, above, ahead, third, c, s = sp.symbols(
        "proper extrinsic sign side above ahead third c s", real=True
    )
    turned = p.T * (r.T * extrinsic + r * (1 - extrinsic)) * p
    cardan = 1 - proper
    where = [
        (sign, 1 - 2 * extrinsic),
        (side, cardan + proper * sign),  # the range of the middle angle of proper sequences
        *zip(m, turned, strict=True),
        (above, side * (proper * m[0, 1] - cardan * m[0, 1])),
        (ahead, side * (proper * m[0, 2] + cardan * m[0, 0])),
        (third, sp.Piecewise((0, above**2 + ahead**2 < 1e-30), (sp.atan2(above, ahead), True))),
        (c, sp.cos(third)),
        (s, sp.sin(third)),
    ]
    # the matrix with the third rotation taken out, about z or about x
    m00 = cardan * (c * m[0, 0] - s * m[0, 1]) + proper * m[0, 0]
    m02 = cardan * m[0, 2] + proper * (s * m[0, 1] + c * m[0, 2])
    m11, m21 = (
        cardan * (s * m[k, 0] + c * m[k, 1]) + proper * (c * m[k, 1] - s * m[k, 2]) for k in (1, 2)
    )
    handed = proper + cardan * (p[0, 2] + p[1, 2] + p[2, 2])  # against its letter: turns backwards
    angles = [sign * sp.atan2(m21, m11), sign * sp.atan2(m02, m00), sign * handed * third]
    return [*r, *p, proper, extrinsic], where, angles


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_euler_angles(sequence):
    symbols, where, angles = euler_angles()
    random = np.random.default_rng(3)
    generated = random.uniform(-np.pi, np.pi, (N // len(SEQUENCES) + 1, 3))
    lock = 0.0 if sequence[0] == sequence[2] else np.pi / 2
    locked = [[0.4, lock + near, -1.1] for near in (0, 1e-16, 1e-12, 1e-8, 1e-3)]
    given = Rotation.from_euler(sequence, np.vstack([generated, locked])).as_matrix()
    points = [[*matrix.ravel(), *chosen(sequence)] for matrix in given]
    in_script = in_engine(angles, symbols, points, where)
    rebuilt = Rotation.from_euler(sequence, in_script).as_matrix()
    np.testing.assert_allclose(rebuilt, given, rtol=0, atol=ALLOWED)
    n = len(generated)
    assert_angles(in_script[:n], euler.from_matrix(sequence, given[:n]), atol=1e-10)
    exact = evaluate_exactly(sp.Matrix(angles), symbols, np.array(points[:n]), where)
    assert_near(differences(in_script[:n], exact, is_angle=True), 1e-10)


# 4 A loop of 200 steps with state


def test_loop_with_state():
    state, end = sp.symbols("x_k y_k theta_k"), sp.symbols("x_n y_n theta_n")
    values = dict(zip((arc.x, arc.y, arc.theta), state, strict=True))
    step = arc.euler_step.substitute({**values, arc.dt: sp.Float("0.02")})
    loop = Recurrence(state, (0, 0, arc.theta), tuple(step), count=200, most=200, ends=end)
    sliders = tuple(Slider(s, -6, 6, 0, 0.1) for s in (arc.theta, arc.v, arc.omega))
    readouts = tuple(Readout(str(s), str(s), s, "m") for s in end)
    figure = Figure("loop", "", (-1, 1, -1, 1), (Trail("path", state, loop),), sliders, readouts)
    points = np.random.default_rng(4).uniform([-3, -1, -6], [3, 1, 6], (N, 3))
    points[:2, 2] = 0.0, 1e-16
    in_script = figure.compute(points)
    start = np.zeros((N, 3))
    start[:, 2] = points[:, 0]
    v, omega = points[:, 1:2], points[:, 2:]
    ends = motion.path(start, v, omega, np.full(200, 0.02), method="start")[:, -1]
    np.testing.assert_allclose(in_script, ends, rtol=0, atol=ALLOWED)
    with mpmath.workdps(50):
        for point, found in zip(points[:20], in_script, strict=False):
            x, y, (theta, v, omega) = mpmath.mpf(0), mpmath.mpf(0), map(mpmath.mpf, point)
            for _ in range(200):
                x += v * mpmath.cos(theta) * mpmath.mpf(0.02)
                y += v * mpmath.sin(theta) * mpmath.mpf(0.02)
                theta += omega * mpmath.mpf(0.02)
            assert_near([x - found[0], y - found[1], theta - found[2]], ALLOWED)


# 5 Degree of mobility and possible motions of two to four movable wheels


def wheel_rows(count):
    """The sliding rows of `count` wheels of four, the others' rows zero; their symbols."""
    symbols, rows = [], []
    for k in range(4):
        length, alpha, beta = sp.symbols(f"l_{k} alpha_{k} beta_{k}", real=True)
        symbols += [length, alpha, beta]
        there = 1 if k < count else 0
        rows.append(
            [
                there * sp.cos(alpha + beta),
                there * sp.sin(alpha + beta),
                there * length * sp.sin(beta),
            ]
        )
    return symbols, sp.Matrix(rows)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_mobility(count):
    symbols, rows = wheel_rows(count)
    random = np.random.default_rng(count)
    low, high = [0.1, -np.pi, -np.pi] * 4, [0.5, np.pi, np.pi] * 4
    points = random.uniform(low, high, (N // 3 + 1, 12))
    points[:100, 2::3] = 0.0  # every axle along its spoke: all meet in the robot's centre
    points[100:200, 1::3] = np.where(np.arange(4) % 2, np.pi, 0) + np.pi / 2
    points[100:200, 2::3] = 0.0  # all axles parallel, on one line: differential drive
    expressions = [rank(rows), *null_projector(rows)]
    in_script = assert_all_agree(expressions, symbols, points)
    for point, found in zip(points, in_script, strict=True):
        made = [wheels.fixed(*point[3 * k : 3 * k + 3], 0.1) for k in range(count)]
        matrix = wheels.sliding(made)
        assert found[0] == np.linalg.matrix_rank(matrix, tol=1e-9)
        assert found[0] == 3 - wheels.mobility(made).delta_m
        _, sizes, turned = np.linalg.svd(matrix, full_matrices=True)
        free = turned[np.count_nonzero(sizes > 1e-9 * sizes[0]) :]
        np.testing.assert_allclose(found[1:].reshape(3, 3), free.T @ free, rtol=0, atol=ALLOWED)
    assert set(in_script[:, 0]) == ({1, 2} if count == 2 else {1, 2, 3})


# What expressions may call besides


def test_solve():
    entries = sp.symbols("m:12", real=True)
    matrix, right = sp.Matrix(3, 3, entries[:9]), sp.Matrix(entries[9:])
    points = np.random.default_rng(6).uniform(-1, 1, (N, 12))
    points[:, [0, 4, 8]] += 3.0  # far from singular, so that 1e-12 is a fair demand
    by_numpy = np.linalg.solve(points[:, :9].reshape(-1, 3, 3), points[:, 9:, None])[..., 0]
    assert_all_agree(list(solve(matrix, right)), entries, points, by_numpy)


def test_solve_singular_is_nan():
    entries = sp.symbols("m:6", real=True)
    expressions = list(solve(sp.Matrix(2, 2, entries[:4]), sp.Matrix(entries[4:])))
    points = [[1, 2, 2, 4, 1, 1]]
    assert np.isnan(in_engine(expressions, entries, points)).all()
    assert np.isnan(
        evaluate_exactly(sp.Matrix(expressions), entries, np.array(points)).astype(float)
    ).all()


def test_unknown_function_is_refused():
    x = sp.Symbol("x")
    with pytest.raises(CourseError, match="no JavaScript for zeta"):
        compile_javascript({"c": [x]}, [sp.zeta(x)])


def test_nan_and_infinities_cross_over():
    x = sp.Symbol("x")
    expressions = [sp.nan, sp.oo, -sp.oo, x]
    np.testing.assert_array_equal(
        in_engine(expressions, [x], [[1.5]]), [[np.nan, np.inf, -np.inf, 1.5]]
    )
