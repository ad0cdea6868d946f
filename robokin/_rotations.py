"""Rotations and poses as matrices: whether a matrix is one, and its parts."""

from functools import reduce
from typing import Any

import numpy as np

from robokin._arrays import Array, entries, first
from robokin._validation import Rule, Sizes, real_numbers
from robokin.errors import RobokinError, at_index

TOLERANCE = 1e-6  # lets pass what was stored in single precision or typed with seven digits
EXACT = 1e-12  # more than rounding leaves: such a matrix is taken for the rotation next to it
NEAREST = ". With U, _, Vh = np.linalg.svd(R), the rotation nearest to R is U @ Vh"
BLOCK = 4000  # matrices judged together, which fit the processor's cache: twice as fast


def square(*sides: int) -> Rule:
    """Return the rule for square matrices of one or two sizes."""

    def check(name: str, value: Any, sizes: Sizes) -> Array:
        matrices = real_numbers(name, value)
        if matrices.shape[-2:] not in [(n, n) for n in sides]:
            allowed = " or ".join(f"(…, {n}, {n})" for n in sides)
            raise RobokinError(f"{name} must have shape {allowed}, got {matrices.shape}")
        return matrices

    return check


def rigid(*sides: int, below: int) -> Rule:
    """Return the rule for rotations or, with a row 0, …, 0, 1 below, for poses."""

    def check(name: str, value: Any, sizes: Sizes) -> Array:
        matrices = square(*sides)(name, value, sizes)
        n = sizes["n"] = matrices.shape[-1] - below  # of the plane 2, of space 3
        return validate(name, matrices, n)

    return check


A_ROTATION, A_PLANAR_POSE, A_POSE = rigid(3, below=0), rigid(3, below=1), rigid(3, 4, below=1)


def validate(name: str, matrices: Array, n: int, tol: float = TOLERANCE) -> Array:
    """Refuse the first matrix whose n × n rotation, or the row below it, is wrong by over tol.

    One that is off by less is mended, so that products of what was accepted are accepted, too. A
    matrix with a NaN or infinite entry is not judged: it comes back with NaN in all entries.
    """
    blocks = (matrices[i : i + BLOCK] for i in range(0, len(matrices), BLOCK))
    exact = min(tol, EXACT)
    if all((_error(T, n) <= exact).all() for T in blocks) and np.isfinite(matrices).all():
        return matrices
    known = np.all(np.isfinite(matrices), axis=(-2, -1))
    error = _error(matrices, n)
    bad = known & ~(error <= tol)
    if bad.any():
        index = first(bad)
        matrix, off = matrices[index], np.abs(_errors(matrices[index], n))
        if (off[-n - 1 :] > tol).any() and len(matrix) > n:
            raise RobokinError(
                f"{name}{at_index(index)} must have 0, …, 0, 1 as its last row, got {matrix[n]}"
            )
        mirror = np.linalg.det(matrix[:n, :n]) < 0
        kind, remedy = (" (a mirror: determinant < 0)", "") if mirror else ("", NEAREST)
        raise RobokinError(
            f"{name}{at_index(index)} is not a rotation{kind}: off by {np.nanmax(off):.3g} from "
            f"columns of length 1, at right angles and right-handed; allowed {tol:.3g}{remedy}"
        )
    mended, R = matrices.copy(), matrices[..., :n, :n]
    mended[..., :n, :n] = 1.5 * R - 0.5 * R @ R.swapaxes(-1, -2) @ R  # one step of Newton's method
    mended[..., n:, :] = np.eye(matrices.shape[-1])[n:]
    mended = np.where((error > exact)[..., None, None], mended, matrices)
    return np.where(known[..., None, None], mended, np.nan)


def _error(matrices: Array, n: int) -> Array:
    """Return the largest of the errors of each matrix."""
    return reduce(np.maximum, map(abs, _errors(matrices, n)))


def _errors(matrices: Array, n: int) -> list[Array]:
    """Return what is 0 in a rotation: x·x - 1, y·y - 1, x·y, x × y - z; then below it."""
    rows = entries(matrices)
    below = [entry - (j == n) for row in rows[n:] for j, entry in enumerate(row)]
    if n == 2:
        (x0, y0, *_), (x1, y1, *_), *_ = rows
        return [x0 * x0 + x1 * x1 - 1, y0 + x1, y1 - x0, *below]
    (x0, y0, z0, *_), (x1, y1, z1, *_), (x2, y2, z2, *_), *_ = rows
    return [
        x0 * x0 + x1 * x1 + x2 * x2 - 1,
        y0 * y0 + y1 * y1 + y2 * y2 - 1,
        x0 * y0 + x1 * y1 + x2 * y2,
        x1 * y2 - x2 * y1 - z0,
        x2 * y0 - x0 * y2 - z1,
        x0 * y1 - x1 * y0 - z2,
        *below,
    ]
