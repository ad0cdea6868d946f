"""Formula to JavaScript: the functions beyond SymPy's own, and what has no JavaScript.

Whatever else figures compute is compared with 50 digits in `test_compiler.py`.
"""

import declared  # noqa: F401  (opens the course, whose packages register their parts)
import numpy as np
import pytest
import sympy as sp
from verification import differences, evaluate_exactly

from courseware.equations.functions import null_projector, rank, solve
from courseware.equations.javascript import compile_javascript, run_javascript
from courseware.errors import CourseError

N = 100
ALLOWED = 1e-12  # what a figure promises; measured differences are some 1e-15


def in_engine(expressions, symbols, points):
    """Expressions of symbols, in the JavaScript engine, in one call."""
    return run_javascript(compile_javascript({"c": symbols}, expressions), points)


def assert_all_agree(expressions, symbols, points, by_numpy):
    """Engine against 50 digits and against NumPy."""
    in_script = in_engine(expressions, symbols, points)
    exact = evaluate_exactly(sp.Matrix(expressions), symbols, points)
    assert differences(in_script, exact).max() <= ALLOWED
    np.testing.assert_allclose(in_script, by_numpy, rtol=0, atol=ALLOWED)


@pytest.mark.parametrize("independent", [0, 1, 2, 3])
def test_rank_and_null_space(independent):
    """Of 4 × 3 matrices, whose rows depend on each other up to rounding."""
    entries = sp.symbols("m:12", real=True)
    matrix = sp.Matrix(4, 3, entries)
    random = np.random.default_rng(independent)
    rows = random.uniform(-1, 1, (N, 4, independent)) @ random.uniform(-1, 1, (N, independent, 3))
    _, sizes, turned = np.linalg.svd(rows)
    clear = sizes[:, :independent].min(axis=1, initial=1) > 1e-3  # else digits get lost
    free = turned[clear, independent:]
    by_numpy = np.column_stack([np.full(clear.sum(), independent), (free.mT @ free).reshape(-1, 9)])
    expressions = [rank(matrix), *null_projector(matrix)]
    assert_all_agree(expressions, entries, rows[clear].reshape(-1, 12), by_numpy)


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
    points = np.array([[1, 2, 2, 4, 1, 1]])
    assert np.isnan(in_engine(expressions, entries, points)).all()
    assert np.isnan(evaluate_exactly(sp.Matrix(expressions), entries, points).astype(float)).all()


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
