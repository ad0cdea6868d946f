"""Arrays taken apart into x, y, theta and put together again; angles brought into (-π, π]."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Bools: TypeAlias = NDArray[np.bool_]
Shape: TypeAlias = tuple[int, ...]
ArrayLike: TypeAlias = Array | Any  # a caller may give anything; validated, it is an array


def parts(array: Array) -> list[Array]:
    """Return the numbers along the last axis: x, y, theta = parts(pose)."""
    return [array[..., i][()] for i in range(array.shape[-1])]


def entries(matrix: Array) -> list[list[Array]]:
    """Return the numbers of a matrix, row by row."""
    rows, columns = map(range, matrix.shape[-2:])
    return [[matrix[..., i, j][()] for j in columns] for i in rows]


def vector(*numbers: ArrayLike) -> Array:
    """Return (…, k) from k numbers, each (…) or one for all; none of them comes out as -0.0."""
    out = np.empty((*np.broadcast(*numbers).shape, len(numbers)))
    for i, number in enumerate(numbers):
        out[..., i] = number
    return out + 0.0


def matrix(rows: Sequence[Sequence[ArrayLike]]) -> Array:
    """Return (…, m, n) from m rows of n numbers, as `vector`."""
    flat = vector(*(number for row in rows for number in row))
    return flat.reshape(*flat.shape[:-1], len(rows), len(rows[0]))


def times(matrix: Array, vector: Array) -> Array:
    """Return (…, m, n) times (…, n): (…, m)."""
    return np.vecdot(matrix, vector[..., None, :])


def first(bad: Bools) -> Shape:
    """Return the index of the first bad element."""
    return tuple(map(int, np.argwhere(bad)[0]))


def wrap(angle: Array) -> Array:
    """Bring an angle in (-3π, π] into (-π, π]."""
    return angle + 2 * np.pi * (angle <= -np.pi)


def opposite(angle: Array) -> Array:
    """Return the opposite direction of an angle in (-2π, 2π), in (-π, π]."""
    return wrap(angle - np.copysign(np.pi, angle))
