"""Frames: poses as matrices, chains of them, and a graph that knows the way between any two.

`T_ab` is the pose of frame b seen from frame a: `p_a = transform(T_ab, p_b)` and `T_ac =
compose(T_ab, T_bc)`. In the plane a pose is a 3×3 matrix, SE(2), in space a 4×4 matrix, SE(3), with
lengths in m; the functions tell them apart by shape. Lynch & Park, Modern Robotics, chapter 3.
"""

from functools import reduce
from itertools import pairwise

import numpy as np

from robokin._arrays import Array, ArrayLike, Shape, entries, first, matrix, times, vector, wrap
from robokin._rotations import A_PLANAR_POSE, A_POSE, A_ROTATION, TOLERANCE, square, validate
from robokin._validation import data, positive, quiet, refuse, validated
from robokin.errors import RobokinError, at_index, describe

__all__ = [
    "FrameGraph",
    "check_rotation",
    "compose",
    "dh",
    "inverse",
    "pose",
    "se2",
    "se3",
    "transform",
]

FIT = "SE(2) and SE(3) do not mix, and batches must broadcast"
FAR = 1e-3  # positions are compared by the metre, from 1 km on by the kilometre


@validated(x=data(), y=data(), theta=data())
def se2(x: ArrayLike, y: ArrayLike, theta: ArrayLike) -> Array:
    """Return the matrix of a pose in the plane.

    Parameters
    ----------
    x, y : array_like, shape (...)
        Position in m.
    theta : array_like, shape (...)
        Heading in rad.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Pose in SE(2).

    Examples
    --------
    >>> se2(1.0, 2.0, 0.0)
    array([[1., 0., 1.],
           [0., 1., 2.],
           [0., 0., 1.]])
    """
    c, s = np.cos(theta), np.sin(theta)
    return matrix([[c, -s, x], [s, c, y], [0, 0, 1]])


@validated(rotation=A_ROTATION, position=data(3))
def se3(rotation: ArrayLike, position: ArrayLike) -> Array:
    """Return the matrix of a pose in space.

    Parameters
    ----------
    rotation : array_like, shape (..., 3, 3)
        Rotation matrix.
    position : array_like, shape (..., 3)
        Position in m.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        Pose in SE(3).

    Raises
    ------
    RobokinError
        If `rotation` is not a rotation, see `check_rotation`.
    """
    batch = np.broadcast_shapes(rotation.shape[:-2], position.shape[:-1])
    T = np.zeros((*batch, 4, 4))
    T[..., :3, :3], T[..., :3, 3], T[..., 3, 3] = rotation, position + 0.0, 1.0  # no -0.0
    return T


@validated(T=A_PLANAR_POSE)
def pose(T: ArrayLike) -> Array:
    """Return position and heading of a pose in the plane: the inverse of `se2`.

    Parameters
    ----------
    T : array_like, shape (..., 3, 3)
        Pose in SE(2).

    Returns
    -------
    ndarray, shape (..., 3)
        `[x, y, theta]` in m and rad, theta in (-π, π].

    Raises
    ------
    RobokinError
        If `T` is not a pose.

    Examples
    --------
    >>> pose(se2(1.0, 2.0, 0.5))
    array([1. , 2. , 0.5])
    """
    (c, _, x), (s, _, y), _ = entries(T)
    return vector(x, y, wrap(np.arctan2(s + 0.0, c)))


@validated(theta=data(), d=data(), a=data(), alpha=data())
def dh(theta: ArrayLike, d: ArrayLike, a: ArrayLike, alpha: ArrayLike) -> Array:
    """Return a joint's frame seen from the one before, from its Denavit–Hartenberg parameters.

    The frame is turned by theta about z and shifted by d along it, then shifted by a along the new
    x and turned by alpha about it.

    Parameters
    ----------
    theta : array_like, shape (...)
        Joint angle in rad.
    d, a : array_like, shape (...)
        Link offset and link length in m, of any sign.
    alpha : array_like, shape (...)
        Link twist in rad.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        Pose in SE(3).

    References
    ----------
    Denavit & Hartenberg 1955; in this form Spong, Hutchinson & Vidyasagar, section 3.2.

    Examples
    --------
    >>> dh(0.0, 0.1, 0.4, np.pi / 2).round(6)
    array([[ 1. ,  0. ,  0. ,  0.4],
           [ 0. ,  0. , -1. ,  0. ],
           [ 0. ,  1. ,  0. ,  0.1],
           [ 0. ,  0. ,  0. ,  1. ]])
    """
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return matrix(
        [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0, sa, ca, d],
            [0, 0, 0, 1],
        ]
    )


@validated(T=A_POSE)
def inverse(T: ArrayLike) -> Array:
    """Return the same pose seen from the other end: T_ba from T_ab.

    Parameters
    ----------
    T : array_like, shape (..., 3, 3) or (..., 4, 4)
        Pose in SE(2) or SE(3).

    Returns
    -------
    ndarray, shape (..., 3, 3) or (..., 4, 4)
        Pose T_ba.

    Raises
    ------
    RobokinError
        If `T` is not a pose: its rotation is skewed or a mirror, or its last row is not 0, …, 0, 1.

    References
    ----------
    Lynch & Park, section 3.3.1, the closed form [Rᵀ, −Rᵀp; 0, 1].

    Examples
    --------
    >>> inverse(se2(1.0, 2.0, np.pi / 2)).round(6)
    array([[ 0.,  1., -2.],
           [-1.,  0.,  1.],
           [ 0.,  0.,  1.]])
    """
    R, p = _parts_of(T)
    R_back = R.swapaxes(-1, -2)
    T_back = T.copy()
    T_back[..., :-1, :-1], T_back[..., :-1, -1] = R_back, 0.0 - times(R_back, p)
    return T_back


@quiet
def compose(*transforms: ArrayLike) -> Array:
    """Return the pose at the end of a chain: T_ad = compose(T_ab, T_bc, T_cd).

    Parameters
    ----------
    *transforms : array_like, shape (..., 3, 3) or (..., 4, 4)
        One or more poses, all in SE(2) or all in SE(3).

    Returns
    -------
    ndarray, shape (..., 3, 3) or (..., 4, 4)
        Pose of the last frame seen from the first.

    Raises
    ------
    RobokinError
        If there is no transform, one is not a pose, or SE(2) is mixed with SE(3).

    References
    ----------
    Lynch & Park, section 3.3.1.

    Examples
    --------
    >>> T_db, T_bc, T_de = se2(1, 0, 0), se2(0, 2, np.pi / 2), se2(1, 5, np.pi / 2)
    >>> compose(inverse(T_bc), inverse(T_db), T_de).round(6)
    array([[1., 0., 3.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    if not transforms:
        raise RobokinError("compose needs at least one transform, got none")
    first_pose, *others = (A_POSE(f"transforms[{n}]", T, {}) for n, T in enumerate(transforms))
    try:
        return reduce(np.matmul, others, first_pose.copy())
    except ValueError as error:
        raise RobokinError(f"shapes {[*map(np.shape, transforms)]}: {FIT}") from error


@validated(T=A_POSE, points=data("n"))
def transform(T: ArrayLike, points: ArrayLike) -> Array:
    """Return points of frame b as seen from frame a: p_a from T_ab and p_b.

    Parameters
    ----------
    T : array_like, shape (..., 3, 3) or (..., 4, 4)
        Pose in SE(2) or SE(3): one for many points, or one for each.
    points : array_like, shape (..., 2) or (..., 3)
        Points in m, with two coordinates in the plane and three in space.

    Returns
    -------
    ndarray, shape (..., 2) or (..., 3)
        Points in m.

    Raises
    ------
    RobokinError
        If `T` is not a pose.

    Examples
    --------
    >>> transform(se2(1.0, 2.0, np.pi / 2), [[0.0, 0.0], [1.0, 0.0]]).round(6)
    array([[1., 2.],
           [1., 3.]])
    """
    R, p = _parts_of(T)
    return times(R, points) + p


class FrameGraph:
    """Frames and the poses known between them; any other follows along a path of known ones.

    Poses are all SE(2) or all SE(3), single or in batches that broadcast. One thread may add while
    others ask.

    Examples
    --------
    A camera d sees the base b of an arm and a workpiece e; the arm knows its hand c. Where is e,
    seen from c?

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
        """Names of the frames, in the order in which they came."""
        return list(self._known)

    @quiet
    def add(self, a: str, b: str, T_ab: ArrayLike) -> None:
        """Make known the pose of b seen from a, and with it that of a seen from b.

        Where a path between the two is known already, the new pose must agree with it, and the
        direct way becomes known too.

        Parameters
        ----------
        a, b : str
            Names of two different frames.
        T_ab : array_like, shape (..., 3, 3) or (..., 4, 4)
            Pose in SE(2) or SE(3), without NaN.

        Raises
        ------
        RobokinError
            If the names are not two different strings; if `T_ab` is not a pose, is not finite, does
            not broadcast with the known poses, or contradicts what is known: its rotation by more
            than 1e-6, its position by more than 1e-6 m (1e-9 of its largest coordinate, where that
            is over 1 km).
        """
        if not (isinstance(a, str) and isinstance(b, str) and a and b and a != b):
            raise RobokinError(
                f"a pair needs two different names (strings), got {describe(a)} and {describe(b)}"
            )
        name = f"T_{a}{b}"
        T = A_POSE(name, T_ab, {})
        refuse(name, T, np.isfinite(T), "finite")
        try:
            shape = np.broadcast_shapes(self._shape, T.shape)
        except ValueError as error:
            raise RobokinError(
                f"{name} has shape {T.shape}, the poses of the known frames "
                f"({', '.join(self.frames)}) have {self._shape}: {FIT}"
            ) from error
        before = self._before(a) if {a, b} <= self._known.keys() else {}
        if b in before:
            self._refuse_contradiction(name, T, _trace(before, b))
        self._shape = shape
        ahead, back = self._known.get(a, {}), self._known.get(b, {})
        ahead, back = ahead | {b: ahead.get(b, T.copy())}, back | {a: back.get(a, inverse(T))}
        self._known = self._known | {a: ahead, b: back}  # another thread may be reading the old one

    @quiet
    def get(self, a: str, b: str) -> Array:
        """Return the pose of b seen from a: the product of the poses along `path(a, b)`.

        Parameters
        ----------
        a, b : str
            Names of known frames.

        Returns
        -------
        ndarray, shape (..., 3, 3) or (..., 4, 4)
            Pose T_ab.

        Raises
        ------
        RobokinError
            If a frame is unknown, or no path leads from a to b.
        """
        return self._along(self.path(a, b))

    def path(self, a: str, b: str) -> list[str]:
        """Return the frames on the shortest known way from a to b, both included.

        Parameters
        ----------
        a, b : str
            Names of known frames.

        Returns
        -------
        list of str
            Names of the frames.

        Raises
        ------
        RobokinError
            If a frame is unknown, or no path leads from a to b.
        """
        for frame in (a, b):
            if not isinstance(frame, str) or frame not in self._known:
                known = ", ".join(self.frames) or "none yet"
                raise RobokinError(f"unknown frame {describe(frame)}; known frames: {known}")
        before = self._before(a)
        if b not in before:
            raise RobokinError(
                f"no path from {a!r} to {b!r}: {a!r} is connected with "
                f"{', '.join(before)}; {b!r} with {', '.join(self._before(b))}"
            )
        return _trace(before, b)

    def _before(self, a: str) -> dict[str, str]:
        """Return for each frame connected with a the one before it on the shortest way; a for a."""
        known, before, queue = self._known, {a: a}, [a]
        for here in queue:  # which grows meanwhile
            for there in known[here]:
                if there not in before:
                    before[there] = here
                    queue.append(there)
        return before

    def _along(self, path: list[str]) -> Array:
        chain = [self._known[here][there] for here, there in pairwise(path)]
        return reduce(np.matmul, chain, np.eye(self._shape[-1]))

    def _refuse_contradiction(self, name: str, T: Array, path: list[str]) -> None:
        off = np.abs(T - self._along(path))
        off[..., :-1, -1] /= np.maximum(1.0, FAR * np.abs(T[..., :-1, -1]).max(axis=-1))[..., None]
        off = off.max(axis=(-2, -1))
        if (off > TOLERANCE).any():
            index = first(off > TOLERANCE)
            raise RobokinError(
                f"{name} contradicts what is known along {' → '.join(path)}: off by "
                f"{off[index]:.3g}{at_index(index)}, allowed {TOLERANCE:.3g}"
            )


def _trace(before: dict[str, str], b: str) -> list[str]:
    """Return the way to b, from the frame that is before itself."""
    way = [b]
    while before[way[-1]] != way[-1]:
        way.append(before[way[-1]])
    return way[::-1]


@validated(R=square(2, 3), tol=positive())
def check_rotation(R: ArrayLike, tol: float = TOLERANCE) -> None:
    """Raise if a matrix is not a rotation: columns of length 1, at right angles, right-handed.

    Wherever a rotation is taken in, one that is off by less than the tolerance counts as the
    rotation nearest to it. A matrix with NaN or infinity is not judged: there it gives NaN.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3) or (..., 2, 2)
        Matrix in space or in the plane.
    tol : float, default 1e-6
        Largest allowed error of x·x = 1, y·y = 1, x·y = 0 and of each entry of z = x × y, with x,
        y, z the columns (in the plane, of y being x turned left).

    Raises
    ------
    RobokinError
        If a matrix is not a rotation. The message says which one, how far off it is, and whether it
        is a mirror (determinant −1).

    Examples
    --------
    >>> check_rotation([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])
    """
    if np.ndim(tol):
        raise RobokinError(f"tol must be one number, got {describe(tol)}")
    validate("R", R, R.shape[-1], tol)


def _parts_of(T: Array) -> tuple[Array, Array]:
    """Return rotation and position of a pose."""
    return T[..., :-1, :-1], T[..., :-1, -1]
