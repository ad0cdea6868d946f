"""Arrays and their parts: (…, 3) taken apart into x, y, theta, and put together again."""

from collections.abc import Sequence

import numpy as np

from robokin._checks import MANY, Array, ArrayLike


def parts(array: Array) -> Sequence[Array]:
    """The numbers along the last axis: x, y, theta = parts(pose)."""
    return list(array) if array.ndim == 1 else [array[..., i] for i in range(array.shape[-1])]


def entries(matrix: Array) -> list[list[Array]]:
    """The numbers of a matrix, row by row."""
    if matrix.ndim == 2:
        return list(map(list, matrix))
    rows, columns = map(range, matrix.shape[-2:])
    return [[matrix[..., i, j] for j in columns] for i in rows]


def vector(*numbers: ArrayLike) -> Array:
    """(…, k) from k numbers, each (…) or the same for all; none of them comes out as -0.0."""
    out = np.empty((*np.broadcast(*numbers).shape, len(numbers)))
    if out.size > MANY:
        for i, number in enumerate(numbers):
            np.add(number, 0.0, out=out[..., i])
        return out
    for i, number in enumerate(numbers):
        out[..., i] = number
    out += 0.0
    return out


def matrix(rows: Sequence[Sequence[ArrayLike]]) -> Array:
    """(…, m, n) from m rows of n numbers, as `vector`."""
    flat = vector(*(number for row in rows for number in row))
    return flat.reshape(*flat.shape[:-1], len(rows), len(rows[0]))


def rows(*vectors: ArrayLike) -> Array:
    """(…, m, n) from m rows, each (…, n) or one number all along, as `vector`."""
    return vector(*vectors).swapaxes(-1, -2)


def running_sums(array: Array) -> Array:
    """cumsum along the last axis, faster where this is short."""
    out = array.copy()
    for i in range(1, array.shape[-1]):
        out[..., i] += out[..., i - 1]
    return out


def times(matrix: Array, vector: Array) -> Array:
    """(…, m, n) times (…, n): (…, m)."""
    product: Array = np.vecdot(matrix, vector[..., None, :])
    return product
