"""Euler angles: a rotation as turns about the axes, all 24 sequences; and its axis and angle.

`seq` is written as in SciPy: 1–3 letters, upper case for intrinsic turns (each about an axis of the
frame as turned so far), lower case for extrinsic ones (about an axis of the fixed frame): `"XYZ"`
with angles a, b, c is R_x(a) R_y(b) R_z(c), `"xyz"` is R_z(c) R_y(b) R_x(a).

One formula serves all sequences. Call the first axis i, the middle one j, the one left over k, and
take the rows and columns of the matrix in this order. Then a Cardan sequence (third axis k) looks
like R_x(a) R_y(b) R_z(c), a proper Euler sequence (third axis i) like R_x(a) R_y(b) R_x(c); if i,
j, k is left-handed, with all angles negated. An extrinsic sequence is the transpose of the
intrinsic one with all angles negated. Siciliano, Sciavicco, Villani & Oriolo, Robotics: Modelling,
Planning and Control, sections 2.4 to 2.6; Lynch & Park, Modern Robotics, appendix B.
"""

from functools import partial
from inspect import unwrap
from itertools import pairwise, product
from typing import Any, NamedTuple

import numpy as np

from robokin._arrays import Array, ArrayLike, Bools, entries, matrix, opposite, parts, vector, wrap
from robokin._rotations import A_ROTATION
from robokin._validation import Sizes, data, positive, validated
from robokin.errors import RobokinError, describe

__all__ = ["from_axis_angle", "from_matrix", "is_locked", "solutions", "steps"]
__all__ += ["to_axis_angle", "to_matrix"]

LOCK = 1e-15  # a zero as rounding leaves it in a rotation matrix
MADE = np.tri(4, 3, -1)  # row n: 1 for the first n turns


class _Axes(NamedTuple):
    i: int  # the first axis: 0, 1, 2 for x, y, z
    j: int  # the middle axis
    k: int  # the axis left over
    proper: bool  # the third axis is the first again
    sign: int  # -1 where all angles are negated
    intrinsic: bool


def _axes(letters: str, intrinsic: bool) -> _Axes:
    """Return a sequence's axes; a short one is continued as a Cardan sequence."""
    axes = ["xyz".index(letter) for letter in letters]
    i = axes[0]
    j = axes[1] if len(axes) > 1 else (i + 1) % 3
    sign = 1 if ((j - i) % 3 == 1) == intrinsic else -1
    return _Axes(i, j, 3 - i - j, axes[2:] == [i], sign, intrinsic)


LETTERS = ["".join(word) for n in (1, 2, 3) for word in product("xyz", repeat=n)]
LETTERS = [w for w in LETTERS if all(a != b for a, b in pairwise(w))]  # no axis twice in a row
SEQUENCES = {s: _axes(w, s.isupper()) for w in LETTERS for s in (w, w.upper())}


def _sequence(name: str, seq: Any, sizes: Sizes, lengths: tuple[int, ...] = (1, 2, 3)) -> str:
    """Validate a sequence: 1 to 3 letters, each of which has its angle."""
    if not isinstance(seq, str) or seq not in SEQUENCES:
        raise RobokinError(
            f"{name} must be 1 to 3 letters, all of XYZ (intrinsic) or all of xyz (extrinsic), no "
            f"axis twice in a row; got {describe(seq)}"
        )
    if len(seq) not in lengths:
        raise RobokinError(f"{name} must have three letters here, got {describe(seq)}")
    sizes["k"] = len(seq)
    return seq


_three_letters = partial(_sequence, lengths=(3,))


@validated(seq=_sequence, angles=data("k"))
def to_matrix(seq: str, angles: ArrayLike) -> Array:
    """Return the rotation that a sequence of turns makes.

    Parameters
    ----------
    seq : str
        1–3 letters: "XYZ" about the axes as they turn, "xyz" about the fixed ones.
    angles : array_like, shape (..., k)
        Angles in rad, one for each letter.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrix.

    References
    ----------
    Siciliano et al., section 2.4, for all sequences.

    Examples
    --------
    >>> to_matrix("YZ", [np.pi / 2, -np.pi / 2]).round(6) + 0.0
    array([[ 0.,  0.,  1.],
           [-1.,  0.,  0.],
           [ 0., -1.,  0.]])
    """
    i, j, k, proper, sign, intrinsic = SEQUENCES[seq]
    a, b, c, *_ = [*parts(angles), 0.0, 0.0]  # what is not turned is turned by 0
    ca, cb, cc = np.cos(a), np.cos(b), np.cos(c)
    sa, sb, sc = sign * np.sin(a), sign * np.sin(b), sign * np.sin(c)
    first_two = {i: (cb, sa * sb, -ca * sb), j: (0.0, ca, sa), k: (sb, -sa * cb, ca * cb)}
    p, q, third = (j, k, i) if proper else (i, j, k)  # the third turn mixes columns p and q
    M = {}
    for row, P, Q, kept in zip((i, j, k), *(first_two[n] for n in (p, q, third)), strict=True):
        M[row, p], M[row, q], M[row, third] = cc * P + sc * Q, cc * Q - sc * P, kept
    return matrix([[M[(m, n) if intrinsic else (n, m)] for n in range(3)] for m in range(3)])


@validated(seq=_three_letters, R=A_ROTATION)
def from_matrix(seq: str, R: ArrayLike) -> Array:
    """Return the angles of a sequence that make a rotation, in SciPy's range.

    At gimbal lock only the sum or the difference of the first and third angle is determined; the
    third is then 0. The third angle is computed first and its turn taken out of R; the others come
    from what is left, so no digits are lost near lock.

    Parameters
    ----------
    seq : str
        Three letters.
    R : array_like, shape (..., 3, 3)
        Rotation matrix.

    Returns
    -------
    ndarray, shape (..., 3)
        Angles in rad, the first and third in [−π, π], the middle one in [−π/2, π/2] (Cardan) or [0,
        π] (proper Euler).

    Raises
    ------
    RobokinError
        If `R` is not a rotation.

    References
    ----------
    Siciliano et al., section 2.4, for all sequences.

    Examples
    --------
    >>> from_matrix("ZYX", [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]).round(6)
    array([-1.570796,  0.      , -1.570796])
    """
    i, j, k, proper, sign, intrinsic = SEQUENCES[seq]
    M = entries(R if intrinsic else R.swapaxes(-1, -2))
    w, u, h = _third(M, seq)
    free = h > LOCK
    w, u, h = w * free, u * free + ~free, h * free
    turn, mixed = (-sign * w, k) if proper else (sign * w, i)
    sine = sign * (u * M[k][j] + turn * M[k][mixed])
    cosine = u * M[j][j] + turn * M[j][mixed]
    middle = (h, M[i][i]) if proper else (sign * M[i][k], h)
    # + 0.0 turns -0.0 into 0.0, so that a half turn is π; the middle angle is never one from -0.0
    return vector(np.arctan2(sine + 0.0, cosine), np.arctan2(*middle), np.arctan2(w + 0.0, u))


@validated(seq=_three_letters, R=A_ROTATION)
def solutions(seq: str, R: ArrayLike) -> Array:
    """Return both answers of a sequence: `from_matrix`, and that with the first axis turned round.

    The second is [a ± π, π − b, c ± π] (Cardan) or [a ± π, −b, c ± π] (proper Euler), wrapped to
    (−π, π]. At gimbal lock they are two of infinitely many.

    Parameters
    ----------
    seq : str
        Three letters.
    R : array_like, shape (..., 3, 3)
        Rotation matrix.

    Returns
    -------
    ndarray, shape (..., 2, 3)
        Angles in rad, a row for each answer.

    Raises
    ------
    RobokinError
        If `R` is not a rotation.

    Examples
    --------
    >>> solutions("ZYX", [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]).round(6)
    array([[-1.570796,  0.      , -1.570796],
           [ 1.570796,  3.141593,  1.570796]])
    """
    a, b, c = parts(unwrap(from_matrix)(seq, R))  # R is validated
    middle = wrap(-b) if SEQUENCES[seq].proper else opposite(-b)
    return matrix([[a, b, c], [opposite(a), middle, opposite(c)]])


@validated(seq=_three_letters, R=A_ROTATION, tol=positive())
def is_locked(seq: str, R: ArrayLike, tol: ArrayLike = 1e-9) -> Bools:
    """Return whether a rotation is at gimbal lock for a sequence, or near it to the eye.

    Parameters
    ----------
    seq : str
        Three letters.
    R : array_like, shape (..., 3, 3)
        Rotation matrix.
    tol : array_like, shape (...), default 1e-9
        Largest sine (proper Euler) or cosine (Cardan) of the middle angle that counts as lock.

    Returns
    -------
    ndarray of bool, shape (...)
        Whether it is locked; False where `R` is NaN.

    Raises
    ------
    RobokinError
        If `R` is not a rotation.

    Examples
    --------
    >>> R_ab = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]
    >>> [seq for seq in ("XYZ", "ZYX", "ZXZ") if is_locked(seq, R_ab)]
    ['XYZ']
    """
    M = entries(R if SEQUENCES[seq].intrinsic else R.swapaxes(-1, -2))
    return _third(M, seq)[2] <= tol


@validated(seq=_sequence, angles=data("k"))
def steps(seq: str, angles: ArrayLike) -> Array:
    """Return the orientations on the way: no turn made, the first, the first two, all.

    Parameters
    ----------
    seq : str
        1–3 letters.
    angles : array_like, shape (..., k)
        Angles in rad, one for each letter.

    Returns
    -------
    ndarray, shape (..., k+1, 3, 3)
        Rotation matrices, the last one that of `to_matrix`.
    """
    return to_matrix(seq, angles[..., None, :] * MADE[: len(seq) + 1, : len(seq)])


@validated(axis=data(3), angle=data())
def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Array:
    """Return the rotation about an axis by an angle: the inverse of `to_axis_angle`.

    Parameters
    ----------
    axis : array_like, shape (..., 3)
        Axis of any length but 0.
    angle : array_like, shape (...)
        Angle in rad.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrix; NaN for an axis of length 0.

    References
    ----------
    Siciliano et al., section 2.5 (Rodrigues), cos ϑ I + (1 − cos ϑ) n nᵀ + sin ϑ [n]×.

    Examples
    --------
    >>> from_axis_angle([1, 1, 1], 2 * np.pi / 3).round(6) + 0.0
    array([[0., 0., 1.],
           [1., 0., 0.],
           [0., 1., 0.]])
    """
    n = axis / np.abs(axis).max(axis=-1, keepdims=True)  # so that no square overflows or vanishes
    x, y, z = parts(n / np.sqrt(np.vecdot(n, n))[..., None])
    c, s, rest = np.cos(angle), np.sin(angle), 2 * np.sin(angle / 2) ** 2  # 1 - c, with its digits
    return matrix(
        [
            [c + rest * x * x, rest * x * y - s * z, rest * x * z + s * y],
            [rest * y * x + s * z, c + rest * y * y, rest * y * z - s * x],
            [rest * z * x - s * y, rest * z * y + s * x, c + rest * z * z],
        ]
    )


@validated(R=A_ROTATION)
def to_axis_angle(R: ArrayLike) -> tuple[Array, Array]:
    """Return the one axis and angle that make the same rotation.

    All digits are kept near no rotation and near a half turn.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3)
        Rotation matrix.

    Returns
    -------
    axis : ndarray, shape (..., 3)
        Axis of length 1: z where there is no rotation. Of the two opposite axes of a half turn (to
        within 1e-15) it is the one whose first non-zero component is positive.
    angle : ndarray, shape (...)
        Angle in [0, π] rad.

    Raises
    ------
    RobokinError
        If `R` is not a rotation.

    References
    ----------
    The unit quaternion, from the largest of its components: Shepperd (1978).

    Examples
    --------
    >>> axis, angle = to_axis_angle([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])
    >>> (axis * np.sqrt(3)).round(6), (np.degrees(angle)).round(6)
    (array([-1.,  1., -1.]), np.float64(120.0))
    """
    w, x, y, z = _quaternion(R)
    length = np.hypot(np.hypot(x, y), z)
    half = np.abs(w) <= 0.5 * LOCK * length
    first = x + (np.abs(x) <= LOCK * length) * (y + (np.abs(y) <= LOCK * length) * z)
    facing = np.copysign(length, np.where(half, first, w))
    still = (length == 0)[..., None]
    axis = np.where(still, [0.0, 0.0, 1.0], vector(x / facing, y / facing, z / facing))
    return axis, 2 * np.arctan2(length, np.where(half, 0.0, np.abs(w)))


def _quaternion(R: Array) -> list[Array]:
    """Return w, x, y, z, not yet of length 1: the row of 4 q qᵀ with the largest diagonal."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = entries(R)
    wx, wy, wz, ww = zy - yz, xz - zx, yx - xy, 1.0 + xx + yy + zz
    xy, yz, zx = xy + yx, yz + zy, zx + xz
    xx, yy, zz = 1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz
    largest = np.maximum(np.maximum(ww, xx), np.maximum(yy, zz))
    columns = (ww, wx, wy, wz), (wx, xx, xy, zx), (wy, xy, yy, yz), (wz, zx, yz, zz)
    return [
        np.where(ww == largest, a, np.where(xx == largest, b, np.where(yy == largest, c, d)))
        for a, b, c, d in columns
    ]


def _third(M: list[list[Array]], seq: str) -> tuple[Array, Array, Array]:
    """Return sine and cosine of the third angle, times h ≥ 0, the middle one's sine or cosine."""
    i, j, k, proper, sign, _ = SEQUENCES[seq]
    w, u = (M[i][j], sign * M[i][k]) if proper else (-sign * M[i][j], M[i][i])
    return w, u, np.sqrt(w * w + u * u)
