"""The few functions beyond SymPy's own that an expression may call.

Each is written twice: in 50-digit arithmetic here, in JavaScript in `functions.js`.
`tests/courseware/test_javascript.py` compares both with NumPy.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from courseware.equations.equation import as_written

RANK_TOLERANCE = 1e-9  # relative to the largest singular value: a reader's idea of "dependent"


def rank(matrix: sp.Matrix) -> sp.Expr:
    """Return the rank of a matrix as an expression."""
    return _call("rank", *_flat(matrix))


def null_projector(matrix: sp.Matrix) -> sp.Matrix:
    """Return the orthogonal projector onto the null space, which is unique, unlike a basis."""
    n = matrix.cols
    return _matrix("null_projector", (n, n), _flat(matrix))


def solve(matrix: sp.Matrix, right: sp.Matrix) -> sp.Matrix:
    """Solve `matrix` x = `right` for a square matrix; NaN where that is singular."""
    return _matrix("solve", (matrix.rows, 1), [*_flat(matrix), *right])


def _flat(matrix: sp.Matrix) -> list[Any]:
    return [matrix.rows, matrix.cols, *matrix]


def _call(name: str, *arguments: Any) -> sp.Expr:
    with as_written():
        return sp.Function(name, real=True)(*arguments)


def _matrix(name: str, shape: tuple[int, int], arguments: list[Any]) -> sp.Matrix:
    with as_written():
        return sp.Matrix(*shape, lambda i, j: _call(name, shape[1] * i + j, *arguments))


# The same functions in 50-digit arithmetic, as `lambdify` calls them.


def _mp_matrix(rows: int, cols: int, entries: tuple[Any, ...]) -> Any:
    return mpmath.matrix([[entries[cols * i + j] for j in range(cols)] for i in range(rows)])


@lru_cache(maxsize=8)  # one matrix is asked for its rank and for each entry of its projector
def _mp_null(digits: int, rows: int, cols: int, *entries: Any) -> list[Any]:
    """Return the right singular vectors of singular value zero: eigenvectors of Cᵀ C."""
    m = _mp_matrix(rows, cols, entries)
    values, vectors = mpmath.eigsy(m.T * m)
    largest = max(values)
    small = RANK_TOLERANCE**2 * largest
    return [vectors[:, i] for i in range(cols) if values[i] <= small]


def _mp_rank(rows: int, cols: int, *entries: Any) -> Any:
    return mpmath.mpf(int(cols) - len(_mp_null(mpmath.mp.dps, int(rows), int(cols), *entries)))


def _mp_null_projector(index: int, rows: int, cols: int, *entries: Any) -> Any:
    i, j = divmod(int(index), int(cols))
    free = _mp_null(mpmath.mp.dps, int(rows), int(cols), *entries)
    return mpmath.fsum(v[i] * v[j] for v in free)


def _mp_solve(index: int, rows: int, cols: int, *entries: Any) -> Any:
    return _mp_solution(mpmath.mp.dps, int(rows), entries)[int(index)]


@lru_cache(maxsize=1)  # the components of one solution are asked for one after the other
def _mp_solution(digits: int, n: int, entries: tuple[Any, ...]) -> list[Any]:
    matrix = _mp_matrix(n, n, entries[: n * n])
    try:
        return list(mpmath.lu_solve(matrix, mpmath.matrix(entries[n * n :])))
    except ZeroDivisionError:
        return [mpmath.nan] * n


MPMATH: dict[str, Callable[..., Any]] = {
    "rank": _mp_rank,
    "null_projector": _mp_null_projector,
    "solve": _mp_solve,
    "sinc": mpmath.sinc,
}
