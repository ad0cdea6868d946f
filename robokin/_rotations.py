"""Whether a matrix is a rotation, or a pose: looked at wherever one is taken in."""

from collections.abc import Mapping, Sequence
from functools import reduce
from typing import Any

import numpy as np

from robokin._checks import Array, ArrayLike, Shape, at, first, is_finite, numbers
from robokin._door import Rule, Sizes, admit
from robokin.errors import RobokinError

TOLERANCE = 1e-6  # lets pass what was stored in single precision or typed with seven digits
KINDS: dict[Shape, str] = {(3, 3): "SE(2)", (4, 4): "SE(3)"}
BLOCK = 4000  # matrices taken together: few enough to stay in the processor's cache


class Square(Rule):
    """Matrices of one of two sizes."""

    def fit(self, name: str, shape: Shape, sizes: Sizes) -> None:
        small, large = self.core
        if shape[-2:] not in ((small, small), (large, large)):
            allowed = f"(…, {small}, {small}) or (…, {large}, {large})"
            raise RobokinError(f"{name} must have shape {allowed}, got {shape}")
        sizes["n"] = shape[-1] - 1  # of what a pose of this size is taken times


def refuse_skewed(name: str, matrices: Array, n: int = 3, tol: float = TOLERANCE) -> None:
    """Refuse the first matrix whose rotation, n × n, or last row, of a pose, is wrong by over tol.

    A matrix with NaN is not judged.
    """
    for start in range(0, len(matrices), BLOCK):
        block = matrices[start : start + BLOCK]
        errors = _errors(block, n)
        if errors.max(initial=0.0) <= tol:
            continue
        bad = (errors > tol).any(axis=0).T
        if bad.any():
            index = first(bad)
            what = _what(block[index], errors.T[index], n, tol)
            there = (start + index[0], *index[1:]) if index else index
            raise RobokinError(f"{name}{at(there)} {what}")


def _errors(matrices: Array, n: int) -> Array:
    """What is 0 if the first n rows and columns are a rotation, and the row below is 0, …, 0, 1.

    (…, m, m) → (k, …) with the batch axes reversed; the numbers of the rotation come first.
    """
    columns = np.ascontiguousarray(matrices[..., :n].T)  # an entry's values side by side: fast
    out = np.empty((3 * (n - 1) + (n + 1) * (matrices.shape[-1] > n), *columns.shape[2:]))
    if n == 2:
        (x0, x1), (y0, y1) = columns[:, :n]
        out[0] = x0 * x0 + x1 * x1 - 1.0
        out[1] = y0 + x1
        out[2] = y1 - x0
    else:
        (x0, x1, x2), (y0, y1, y2), (z0, z1, z2) = columns[:, :n]
        out[0] = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
        out[1] = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
        out[2] = x0 * y0 + x1 * y1 + x2 * y2
        out[3] = x1 * y2 - x2 * y1 - z0
        out[4] = x2 * y0 - x0 * y2 - z1
        out[5] = x0 * y1 - x1 * y0 - z2
    if matrices.shape[-1] > n:
        out[-n - 1 : -1] = columns[:, n]
        out[-1] = matrices[..., n, n].T - 1.0
    return np.abs(out, out=out)


def _what(matrix: Array, errors: Array, n: int, tol: float) -> str:
    if len(matrix) > n and (errors[-len(matrix) :] > tol).any():
        return f"must have 0, …, 0, 1 as its last row, got {matrix[n]}"
    mirror = " (a mirror: determinant < 0)" if np.linalg.det(matrix[:n, :n]) < 0 else ""
    return (
        f"is not a rotation{mirror}: off by {np.nanmax(errors):.3g} from columns of length 1, "
        f"at right angles and right-handed; allowed {tol:.3g}"
    )


def _refuse_no_pose(name: str, T: Array) -> None:
    refuse_skewed(name, T, T.shape[-1] - 1)


# what an argument is, for `door`: rotations in space, poses in the plane or in space
A_ROTATION = Rule((3, 3), good=is_finite, rows_ok=refuse_skewed)
A_POSE = Square((3, 4), good=is_finite, rows_ok=_refuse_no_pose)
A_PLANAR_POSE = Rule((3, 3), good=is_finite, rows_ok=_refuse_no_pose)


def poses(transforms: Mapping[str, ArrayLike]) -> list[Array]:
    """Any number of poses, by name: all in the plane or all in space."""
    given: dict[str, Any] = {name: numbers(name, T) for name, T in transforms.items()}
    kinds = {name: KINDS.get(T.shape[-2:]) for name, T in given.items()}
    (a, kind), *others = kinds.items()
    for b, other in others:
        if kind and other and kind != other:
            raise RobokinError(f"SE(2) and SE(3) do not mix: {a} is {kind}, {b} is {other}")
    admit(given, dict.fromkeys(given, A_POSE))
    return list(given.values())


def product(chain: Sequence[Array]) -> Array:
    """The pose at the end of a chain, in an array of its own."""
    chain = np.broadcast_arrays(*chain)
    out = np.empty(chain[0].shape)
    for start in range(0, len(out), BLOCK):
        block = slice(start, start + BLOCK)
        out[block] = reduce(np.matmul, [T[block] for T in chain])
    return out


def parts_of(T: Array) -> tuple[Array, Array]:
    """Rotation and position of a pose."""
    return T[..., :-1, :-1], T[..., :-1, -1]


def pose_of(R: Array, p: Array) -> Array:
    """The pose of a rotation and a position."""
    n = p.shape[-1]
    out = np.zeros((*np.broadcast_shapes(R.shape[:-2], p.shape[:-1]), n + 1, n + 1))
    out[..., :n, :n], out[..., :n, n], out[..., n, n] = R, p + 0.0, 1.0  # + 0.0: no -0.0
    return out
