"""The few functions beyond SymPy's own that an expression may call.

`functions.js` computes them, and `tests/verification.py` in 50-digit arithmetic.
"""

from typing import Any

import sympy as sp

from courseware.equations.equation import as_written

IN_SCRIPT = ("rank", "null_projector", "solve", "sinc")


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
