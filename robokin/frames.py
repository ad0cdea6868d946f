"""Frames: poses as matrices, chains of them, and a graph that knows the way between any two.

`T_ab` is the pose of frame b seen from frame a: `p_a = transform(T_ab, p_b)` and
`T_ac = compose(T_ab, T_bc)`. In the plane a pose is a 3×3 matrix, SE(2), in space a 4×4 matrix,
SE(3); the functions tell them apart by shape. Exercise 3; Lynch & Park, Modern Robotics,
chapter 3.
"""

from collections import deque
from functools import reduce
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, Shape, numbers, positive, quiet, rows, shown
from robokin.errors import RobokinError

__all__ = ["FrameGraph", "check_rotation", "compose", "inverse", "se2", "se3", "transform"]

TOLERANCE = 1e-6  # lets pass what was stored in single precision or typed with seven digits
KINDS: dict[tuple[int, ...], str] = {(3, 3): "SE(2)", (4, 4): "SE(3)"}
BLOCK = 4000  # matrices checked at a time: few enough to stay in the processor's cache


@quiet
def se2(x: ArrayLike, y: ArrayLike, theta: ArrayLike) -> Array:
    """The matrix of a pose in the plane.

    x, y: (…) in m; theta: (…) in rad → (…, 3, 3).

    >>> se2(1.0, 2.0, 0.0)
    array([[1., 0., 1.],
           [0., 1., 2.],
           [0., 0., 1.]])
    """
    shape, (x, y, theta) = rows(("x", x, ()), ("y", y, ()), ("theta", theta, ()))
    c, s = np.cos(theta), np.sin(theta)
    zero = x - x  # NaN in a row that has no answer
    out = np.empty((*shape, 3, 3))
    out[..., 0, 0], out[..., 0, 1], out[..., 0, 2] = c, 0.0 - s, x
    out[..., 1, 0], out[..., 1, 1], out[..., 1, 2] = s, c, y
    out[..., 2, 0], out[..., 2, 1], out[..., 2, 2] = zero, zero, zero + 1.0
    return out


@quiet
def se3(rotation: ArrayLike, position: ArrayLike) -> Array:
    """The matrix of a pose in space.

    rotation: (…, 3, 3); position: (…, 3) in m → (…, 4, 4). What is not a rotation is refused, as
    in `check_rotation`.
    """
    shape, (R, p) = rows(("rotation", rotation, (3, 3)), ("position", position, (3,)))
    refuse_skewed("rotation", R)
    zero = p - p  # NaN in a row that has no answer
    out = np.empty((*shape, 4, 4))
    out[..., :3, :3], out[..., :3, 3] = R, p
    out[..., 3, :3], out[..., 3, 3] = zero, zero[..., 0] + 1.0
    return out


@quiet
def inverse(T: ArrayLike) -> Array:
    """The same pose seen from the other end: T_ba from T_ab.

    T: (…, 3, 3) or (…, 4, 4), lengths in m → the same shape. A matrix that is not a pose (its
    rotation skewed or a mirror, another last row) is refused.
    Source: exercise 3, the closed form [Rᵀ, −Rᵀp; 0, 1].

    >>> inverse(se2(1.0, 2.0, np.pi / 2)).round(6)
    array([[ 0.,  1., -2.],
           [-1.,  0.,  1.],
           [ 0.,  0.,  1.]])
    """
    (T,) = _poses(("T", T))
    return _inverse(T)


@quiet
def compose(*transforms: ArrayLike) -> Array:
    """The pose at the end of a chain: T_ad = compose(T_ab, T_bc, T_cd).

    transforms: one or more, all (…, 3, 3) or all (…, 4, 4), lengths in m → the same; leading
    dimensions broadcast. What is not a pose is refused, and so is SE(2) mixed with SE(3).
    Source: exercise 3, T_ce = T_bc⁻¹ T_db⁻¹ T_de.

    >>> T_db, T_bc, T_de = se2(1, 0, 0), se2(0, 2, np.pi / 2), se2(1, 5, np.pi / 2)
    >>> compose(inverse(T_bc), inverse(T_db), T_de).round(6)
    array([[1., 0., 3.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    if not transforms:
        raise RobokinError("compose needs at least one transform, got none")
    return _product(_poses(*((f"transforms[{n}]", T) for n, T in enumerate(transforms))))


@quiet
def transform(T: ArrayLike, points: ArrayLike) -> Array:
    """Points of frame b as seen from frame a: p_a from T_ab and p_b.

    T: (…, 3, 3) with points (…, 2), or (…, 4, 4) with points (…, 3), all in m → (…, 2) or
    (…, 3). Leading dimensions broadcast: one T and many points, or one of each.

    >>> transform(se2(1.0, 2.0, np.pi / 2), [[0.0, 0.0], [1.0, 0.0]]).round(6)
    array([[1., 2.],
           [1., 3.]])
    """
    (T,) = _poses(("T", T))
    n = T.shape[-1] - 1
    shape, (T, p) = rows(("T", T, (n + 1, n + 1)), ("points", points, (n,)))
    out = np.empty((*shape, n))
    for i in range(n):
        out[..., i] = np.vecdot(T[..., i, :n], p) + T[..., i, n]
    return out


class FrameGraph:
    """Frames and the poses known between them; any other follows along a path of known ones.

    Poses are all SE(2) or all SE(3), single or in batches that broadcast. Source: exercise 3,
    the general case: from the camera's T_db and T_de and the arm's T_bc to T_ce.

    >>> graph = FrameGraph()
    >>> graph.add("d", "b", se2(1, 0, 0))
    >>> graph.add("b", "c", se2(0, 2, np.pi / 2))
    >>> graph.add("d", "e", se2(1, 5, np.pi / 2))
    >>> graph.path("c", "e")
    ['c', 'b', 'd', 'e']
    >>> graph.get("c", "e").round(6)
    array([[1., 0., 3.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """

    def __init__(self) -> None:
        self._known: dict[str, dict[str, Array]] = {}  # a → its neighbours b → T_ab
        self._shape: Shape = ()  # of all poses together, batch and matrix

    @property
    def frames(self) -> list[str]:
        """The names of the frames, in the order in which they came."""
        return list(self._known)

    @quiet
    def add(self, a: str, b: str, T_ab: ArrayLike) -> None:
        """Make known the pose of b seen from a, and with it that of a seen from b.

        T_ab: (…, 3, 3) or (…, 4, 4), lengths in m. It must agree with what is known between the
        two already, directly or along a path, to 1e-6 (of its largest entry, where that is over
        1); then the direct way becomes known too.
        """
        if not (isinstance(a, str) and isinstance(b, str) and a and b and a != b):
            raise RobokinError(f"a pair needs two different names, got {shown(a)} and {shown(b)}")
        name = f"T_{a}{b}"
        (T,) = _poses((name, T_ab))
        try:
            shape = np.broadcast_shapes(self._shape, T.shape)
        except ValueError as error:
            raise RobokinError(
                f"{name} has shape {T.shape}, the poses of the known frames "
                f"({', '.join(self.frames)}) have {self._shape}: SE(2) and SE(3) do not mix, and "
                "batches must broadcast"
            ) from error
        way = self._ways(a).get(b) if a in self._known else None
        if way:
            self._refuse_contradiction(name, T, way)
        self._shape = shape
        self._known.setdefault(a, {}).setdefault(b, T.copy())
        self._known.setdefault(b, {}).setdefault(a, _inverse(T))

    @quiet
    def get(self, a: str, b: str) -> Array:
        """The pose of b seen from a, T_ab: the product of the poses along `path(a, b)`."""
        return self._along(self.path(a, b))

    def path(self, a: str, b: str) -> list[str]:
        """The frames on the shortest known way from a to b, both included.

        Unknown frames, or no way between them, are refused.
        """
        for frame in (a, b):
            if not isinstance(frame, str) or frame not in self._known:
                known = ", ".join(self.frames) or "none yet"
                raise RobokinError(f"unknown frame {shown(frame)}; known frames: {known}")
        ways = self._ways(a)
        if b not in ways:
            raise RobokinError(
                f"no path from {a!r} to {b!r}: {a!r} is connected with "
                f"{', '.join(ways)}; {b!r} with {', '.join(self._ways(b))}"
            )
        return ways[b]

    def _ways(self, a: str) -> dict[str, list[str]]:
        """For every frame connected with a, itself included, the shortest way to it."""
        ways, queue = {a: [a]}, deque([a])
        while queue:
            here = queue.popleft()
            for there in self._known[here]:
                if there not in ways:
                    ways[there] = [*ways[here], there]
                    queue.append(there)
        return ways

    def _along(self, path: list[str]) -> Array:
        chain = [self._known[here][there] for here, there in pairwise(path)]
        return _product(chain or [np.eye(self._shape[-1])])

    def _refuse_contradiction(self, name: str, T: Array, path: list[str]) -> None:
        off = np.abs(T - self._along(path)).max(axis=(-2, -1))
        off = off / np.abs(T).max(axis=(-2, -1))  # 1 or more: the last row ends in 1
        if (off > TOLERANCE).any():
            index = tuple(np.argwhere(off > TOLERANCE)[0])
            raise RobokinError(
                f"{name} contradicts what is known along {' → '.join(path)}: off by "
                f"{off[index]:.3g}{_at(index)}, allowed {TOLERANCE:.3g}"
            )


@quiet
def check_rotation(R: ArrayLike, tol: float = TOLERANCE) -> None:
    """Refuse what is not a rotation: columns of length 1, at right angles, right-handed.

    R: (…, 3, 3), or (…, 2, 2) in the plane. With x, y, z the columns, tol is the largest allowed
    error of x·x = 1, y·y = 1, x·y = 0 and of each entry of z = x × y (in the plane, of y being x
    turned left). The error says which matrix, how far off, and whether it is a mirror
    (determinant −1). A matrix with NaN or infinity is not judged: wherever a rotation is taken
    in, it gives NaN.

    >>> check_rotation([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])
    """
    limit = positive("tol", tol)
    if limit.ndim:
        raise RobokinError(f"tol must be one number, got {shown(tol)}")
    n = 2 if numbers("R", R).shape[-2:] == (2, 2) else 3
    _, (R,) = rows(("R", R, (n, n)))
    refuse_skewed("R", R, n, float(limit))


def _product(poses: list[Array]) -> Array:
    return reduce(np.matmul, poses) if len(poses) > 1 else poses[0].copy()


def _inverse(T: Array) -> Array:
    n = T.shape[-1] - 1
    Rt = T[..., :n, :n].swapaxes(-1, -2)
    out = np.empty(T.shape)
    out[..., :n, :n] = Rt
    np.einsum("...ij,...j->...i", Rt, 0.0 - T[..., :n, n], out=out[..., :n, n])
    out[..., n, :] = T[..., n, :]
    return out


def _poses(*items: tuple[str, ArrayLike]) -> list[Array]:
    """The transforms as arrays, each a pose and all of the same kind."""
    shapes = [numbers(name, value).shape for name, value in items]
    core = shapes[0][-2:]
    for (name, _), shape in zip(items, shapes, strict=True):
        if shape[-2:] not in KINDS:
            raise RobokinError(f"{name} must have shape (…, 3, 3) or (…, 4, 4), got {shape}")
        if shape[-2:] != core:
            kinds = f"{items[0][0]} is {KINDS[core]}, {name} is {KINDS[shape[-2:]]}"
            raise RobokinError(f"SE(2) and SE(3) do not mix: {kinds}")
    _, poses = rows(*((name, value, core) for name, value in items))
    for (name, _), T in zip(items, poses, strict=True):
        refuse_skewed(name, T, core[0] - 1)
    return poses


def refuse_skewed(name: str, matrices: Array, n: int = 3, tol: float = TOLERANCE) -> None:
    """Refuse the first matrix that `_errors` finds wrong by more than tol."""
    for start in range(0, len(matrices), BLOCK) if matrices.ndim > 2 else [0]:
        block = matrices[start : start + BLOCK]
        errors = _errors(block, n)
        if (errors > tol).any():
            index = tuple(np.argwhere((errors > tol).any(axis=0).T)[0])
            what = _what(block[index], errors.T[index], n, tol)
            if index:
                index = (start + index[0], *index[1:])
            raise RobokinError(f"{name}{_at(index)} {what}")


def _what(matrix: Array, errors: Array, n: int, tol: float) -> str:
    if len(matrix) > n and (errors[-len(matrix) :] > tol).any():
        return f"must have 0, …, 0, 1 as its last row, got {matrix[n]}"
    mirror = " (a mirror: determinant < 0)" if np.linalg.det(matrix[:n, :n]) < 0 else ""
    return (
        f"is not a rotation{mirror}: off by {np.nanmax(errors):.3g} from columns of length 1, "
        f"at right angles and right-handed; allowed {tol:.3g}"
    )


def _at(index: tuple[int, ...]) -> str:
    return f" at index {', '.join(map(str, index))}" if index else ""


def _errors(matrices: Array, n: int) -> Array:
    """What is 0 if the first n rows and columns are a rotation, and the row below is 0, …, 0, 1.

    (…, m, m) → (k, …) with the batch axes reversed; the numbers of the rotation come first.
    """
    columns = np.ascontiguousarray(matrices.T)  # the values of an entry side by side: fast
    x, y, *rest = columns
    extra = len(columns) - n  # 1 for a pose, 0 for a rotation
    out = np.empty((3 * (n - 1) + extra * (n + 1), *columns.shape[2:]))
    if n == 2:
        out[0] = x[0] * x[0] + x[1] * x[1] - 1.0
        out[1] = y[0] + x[1]
        out[2] = y[1] - x[0]
    else:
        z = rest[0]
        out[0] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0
        out[1] = y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - 1.0
        out[2] = x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
        out[3] = x[1] * y[2] - x[2] * y[1] - z[0]
        out[4] = x[2] * y[0] - x[0] * y[2] - z[1]
        out[5] = x[0] * y[1] - x[1] * y[0] - z[2]
    if extra:
        out[-n - 1 : -1] = columns[:n, n]
        out[-1] = columns[n, n] - 1.0
    return np.abs(out, out=out)
