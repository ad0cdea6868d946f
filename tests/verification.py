"""Comparison of formulas with functions: at generated and special points, in 50 digits."""

from dataclasses import dataclass
from functools import lru_cache
from math import inf, isfinite
from zlib import crc32

import mpmath
import numpy as np
import sympy as sp

from courseware.equations import Check
from courseware.equations.declared_checks import SAMPLES

DIGITS = 50
RANK_TOLERANCE = 1e-9  # relative to the largest singular value, as in the script


@dataclass(frozen=True)
class Result:
    """The largest difference between a formula and its function, and the point where it is."""

    check: Check
    samples: int
    difference: float
    worst: dict[str, float]

    @property
    def agrees(self):
        return self.difference <= self.check.tolerance

    def __str__(self):
        point = ", ".join(f"{name} = {value:.6g}" for name, value in self.worst.items())
        return (
            f"{self.check.name} and its function are {self.difference:.1g} apart, "
            f"allowed {self.check.tolerance:.1g}, at {point}"
        )


def verify(check, samples=SAMPLES):
    """Return the largest difference between a formula's right side and its function."""
    equation, points = check.equation, draw_points(check, samples)
    exact = evaluate_exactly(equation.right, check.symbols, points, equation.where)
    computed = call_function(check, points)
    assert computed.shape == exact.shape, (
        f"{check.name} has {exact.shape[1]} components, its function {computed.shape[1]}"
    )
    apart = differences(computed, exact, equation.is_angle).max(axis=1, initial=0.0)
    worst = int(apart.argmax())
    where = {str(s): float(v) for s, v in zip(check.symbols, points[worst], strict=True)}
    return Result(check, len(points), float(apart[worst]), where)


def draw_points(check, samples):
    """Return points (n, symbols): the special ones, then random ones, the same every time."""
    symbols = check.symbols
    low, high = np.array([check.ranges.get(s, (s.low, s.high)) for s in symbols]).T
    random = np.random.default_rng(crc32(check.name.encode()))
    points = random.uniform(low, high, (len(check.specials) + samples, len(symbols)))
    whole = [symbols.index(symbol) for symbol in check.integers]
    points[:, whole] = np.rint(points[:, whole])
    for row, special in zip(points, check.specials, strict=False):
        for symbol, value in special.items():
            row[symbols.index(symbol)] = value
    return points


def call_function(check, points):
    """Call the function at the points: (n, components)."""
    columns = dict(zip(check.symbols, points.T, strict=True))
    arguments = [_argument(argument, columns, len(points)) for argument in check.arguments]
    found = np.asarray(check.function(*arguments), dtype=float)
    if check.component is not None:
        found = found[..., check.component]
    return found.reshape(len(points), -1)


def _argument(argument, columns, n):
    if isinstance(argument, tuple):
        return np.stack([_argument(part, columns, n) for part in argument], axis=-1)
    function = sp.lambdify(list(columns), argument, modules="numpy")
    return np.broadcast_to(np.asarray(function(*columns.values()), dtype=float), (n,))


def evaluate_exactly(expression, symbols, points, where=(), cse=False):
    """Evaluate an expression or matrix at points in 50-digit arithmetic: (n, components).

    cse: compute what occurs often once, and then branches that are not taken, too.
    """
    flat = tuple(expression) if isinstance(expression, sp.MatrixBase) else (expression,)
    known = (*symbols, *(symbol for symbol, _ in where))
    parts = (*(step for _, step in where), flat)
    *steps, function = (_in_mpmath(known[: len(symbols) + k], p, cse) for k, p in enumerate(parts))
    rows = []
    with mpmath.workdps(DIGITS):
        for point in points.tolist():
            values = [mpmath.mpf(x) for x in point]
            for step in steps:
                values.append(step(*values))
            try:
                rows.append([_real(x) for x in function(*values)])
            except ZeroDivisionError as error:
                place = ", ".join(f"{s} = {x:.6g}" for s, x in zip(symbols, point, strict=True))
                raise AssertionError(
                    f"{expression} divides by zero at {place}: "
                    "give that case a branch (Piecewise), or narrow the ranges"
                ) from error
    return np.array(rows, dtype=object).reshape(len(points), len(flat))


@lru_cache(maxsize=1024)  # a loop asks for its step many times
def _in_mpmath(symbols, expression, cse):
    return sp.lambdify(symbols, expression, modules=[MPMATH, "mpmath"], cse=cse, docstring_limit=0)


def _real(value):
    assert not isinstance(value, mpmath.mpc), f"an equation is not real in its range: {value}"
    return value if isinstance(value, mpmath.mpf) else mpmath.mpf(value)


def differences(computed, exact, is_angle=False):
    """Return the distance of each element; infinite where infinities or NaN do not match."""
    pairs = zip(computed.ravel().tolist(), exact.flat, strict=True)
    with mpmath.workdps(DIGITS):
        return np.array([_apart(c, e, is_angle) for c, e in pairs]).reshape(computed.shape)


def _apart(computed, exact, is_angle):
    if not (isfinite(computed) and mpmath.isfinite(exact)):
        return 0.0 if str(computed) == str(float(exact)) else inf
    difference = abs(computed - exact)
    if is_angle:
        turns = mpmath.nint(difference / (2 * mpmath.pi))
        difference = abs(difference - 2 * mpmath.pi * turns)
    return float(difference)


# --- The functions beyond SymPy's own, as `lambdify` calls them -----------------------------------


def _matrix(rows, cols, entries):
    return mpmath.matrix([[entries[cols * i + j] for j in range(cols)] for i in range(rows)])


@lru_cache(maxsize=8)  # one matrix is asked for its rank and for each entry of its projector
def _null_vectors(rows, cols, *entries):
    """Return the right singular vectors of singular value zero: eigenvectors of Cᵀ C."""
    m = _matrix(rows, cols, entries)
    values, vectors = mpmath.eigsy(m.T * m)
    small = RANK_TOLERANCE**2 * max(values)
    return [vectors[:, i] for i in range(cols) if values[i] <= small]


def _rank(rows, cols, *entries):
    return mpmath.mpf(int(cols) - len(_null_vectors(int(rows), int(cols), *entries)))


def _null_projector(index, rows, cols, *entries):
    i, j = divmod(int(index), int(cols))
    free = _null_vectors(int(rows), int(cols), *entries)
    return mpmath.fsum(v[i] * v[j] for v in free)


@lru_cache(maxsize=1)  # the components of one solution are asked for one after the other
def _solution(n, entries):
    matrix = _matrix(n, n, entries[: n * n])
    try:
        return list(mpmath.lu_solve(matrix, mpmath.matrix(entries[n * n :])))
    except ZeroDivisionError:
        return [mpmath.nan] * n


MPMATH = {
    "rank": _rank,
    "null_projector": _null_projector,
    "solve": lambda index, rows, _, *entries: _solution(int(rows), entries)[int(index)],
    "sinc": mpmath.sinc,
}
