"""Euler angles: a rotation as turns about the axes, all 24 sequences; and its axis and angle.

`seq` is written as in SciPy: 1–3 letters, upper case for intrinsic turns (each about an axis of
the frame as turned so far), lower case for extrinsic ones (about an axis of the fixed frame):
`"XYZ"` with angles a, b, c is R_x(a) R_y(b) R_z(c), `"xyz"` is R_z(c) R_y(b) R_x(a).

One formula serves all sequences. Call the first axis i, the middle one j, the one left over k,
and take the rows and columns of the matrix in this order. Then a Cardan sequence (third axis k)
looks like R_x(a) R_y(b) R_z(c), a proper Euler sequence (third axis i) like R_x(a) R_y(b) R_x(c);
if i, j, k is left-handed, with all angles negated. An extrinsic sequence is the transpose of the
intrinsic one with all angles negated. Exercise 2; Siciliano et al., Robotics, section 2.4.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robokin._checks import Array, positive, quiet, rows, shown
from robokin.errors import RobokinError
from robokin.frames import refuse_skewed

__all__ = ["axis_angle", "from_matrix", "is_locked", "solutions", "steps", "to_matrix"]

LOCK = 1e-15  # a zero as rounding leaves it in a rotation matrix
MADE = np.tri(4, 3, -1)  # row n: 1 for the first n turns


class _Sequence(NamedTuple):
    i: int  # the first axis: 0, 1, 2 for x, y, z
    j: int  # the middle axis
    k: int  # the axis left over
    proper: bool  # the third axis is the first again
    sign: int  # -1 where all angles are negated
    intrinsic: bool


@quiet
def to_matrix(seq: str, angles: ArrayLike) -> Array:
    """The rotation that a sequence of turns makes.

    seq: 1–3 letters; angles: (…, k) in rad, one for each letter → (…, 3, 3).
    Source: exercise 2, R_AB = R_y(π/2) R_z(−π/2).

    >>> to_matrix("YZ", [np.pi / 2, -np.pi / 2]).round(6) + 0.0
    array([[ 0.,  0.,  1.],
           [-1.,  0.,  0.],
           [ 0., -1.,  0.]])
    """
    i, j, k, proper, sign, intrinsic = _read(seq)
    shape, (angles,) = rows(("angles", angles, (len(seq),)))
    turns = [angles[..., n] for n in range(len(seq))]
    turns += [0.0 * turns[0]] * (3 - len(seq))
    ca, cb, cc = map(np.cos, turns)
    sa, sb, sc = (sign * np.sin(turn) + 0.0 for turn in turns)
    columns = {  # of the first two turns together; the third mixes columns p and q
        i: (cb, sa * sb, 0.0 - ca * sb),
        j: (0.0 * ca, ca, sa),
        k: (sb, 0.0 - sa * cb, ca * cb),
    }
    p, q, third = (j, k, i) if proper else (i, j, k)
    out = np.empty((*shape, 3, 3))
    M = out if intrinsic else out.swapaxes(-1, -2)
    for row, P, Q, kept in zip((i, j, k), columns[p], columns[q], columns[third], strict=True):
        M[..., row, p] = cc * P + sc * Q
        M[..., row, q] = cc * Q - sc * P
        M[..., row, third] = kept
    return out


@quiet
def from_matrix(seq: str, R: ArrayLike) -> Array:
    """The angles of a sequence that make a rotation; of the two answers the one in SciPy's range.

    seq: three letters; R: (…, 3, 3) → (…, 3) in rad, the first and third in [−π, π], the middle
    one in [−π/2, π/2] (Cardan) or [0, π] (proper Euler). At gimbal lock, where only the sum or the
    difference of the first and third is determined, the third is 0. The third angle is computed
    first and its turn taken out of R; the others come from what is left, so no digits are lost
    near lock. A matrix that is not a rotation is refused. Source: exercise 2.

    >>> from_matrix("ZYX", [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]).round(6)
    array([-1.570796,  0.      , -1.570796])
    """
    M, (i, j, k, proper, sign, _) = _rotation(seq, R)
    w, u, h = _third(M, i, j, k, proper, sign)
    free = h > LOCK
    if not free.all():
        w, u, h = w * free, u * free + ~free, h * free
    turn, mixed = (-sign * w, k) if proper else (sign * w, i)
    sine = sign * (u * M[..., k, j] + turn * M[..., k, mixed]) + 0.0
    cosine = u * M[..., j, j] + turn * M[..., j, mixed]
    middle = (h, M[..., i, i]) if proper else (sign * M[..., i, k] + 0.0, h)
    out = np.empty((*h.shape, 3))
    out[..., 0] = np.arctan2(sine, cosine)
    out[..., 1] = np.arctan2(*middle)
    out[..., 2] = np.arctan2(w + 0.0, u + 0.0)  # + 0.0 turns -0.0 into 0.0
    return out


@quiet
def solutions(seq: str, R: ArrayLike) -> Array:
    """Both answers of a sequence: `from_matrix`, and the one with the first axis turned round.

    seq: three letters; R: (…, 3, 3) → (…, 2, 3) in rad. The second is [a ± π, π − b, c ± π]
    (Cardan) or [a ± π, −b, c ± π] (proper Euler), wrapped to (−π, π]. At gimbal lock they are two
    of infinitely many.

    >>> solutions("ZYX", [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]).round(6)
    array([[-1.570796,  0.      , -1.570796],
           [ 1.570796,  3.141593,  1.570796]])
    """
    first = from_matrix(seq, R)
    a, b, c = first[..., 0], first[..., 1], first[..., 2]
    out = np.empty((*first.shape[:-1], 2, 3))
    out[..., 0, :] = first
    second = out[..., 1, :]
    second[..., 0] = a + np.pi * (1 - 2 * (a > 0))
    second[..., 1] = 0.0 - b if _read(seq).proper else np.pi * (1 - 2 * (b < 0)) - b
    second[..., 2] = c + np.pi * (1 - 2 * (c > 0))
    second += 2 * np.pi * (second <= -np.pi)
    return out


@quiet
def is_locked(seq: str, R: ArrayLike, tol: ArrayLike = 1e-9) -> NDArray[np.bool_]:
    """Whether a rotation is at gimbal lock for a sequence, or near it as a person sees it.

    seq: three letters; R: (…, 3, 3); tol: (…), the largest sine (proper Euler) or cosine (Cardan)
    of the middle angle that counts as lock → (…) bool; False where R is NaN.

    >>> R_ab = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]
    >>> [seq for seq in ("XYZ", "ZYX", "ZXZ") if is_locked(seq, R_ab)]
    ['XYZ']
    """
    tol = positive("tol", tol)
    M, s = _rotation(seq, R, tol)
    return _third(M, *s[:5])[2] <= tol


@quiet
def steps(seq: str, angles: ArrayLike) -> Array:
    """The orientations on the way: none of the turns made, the first, the first two, all.

    seq: 1–3 letters; angles: (…, k) in rad → (…, k+1, 3, 3); the last one is `to_matrix`.
    """
    _read(seq)
    _, (angles,) = rows(("angles", angles, (len(seq),)))
    return to_matrix(seq, angles[..., None, :] * MADE[: len(seq) + 1, : len(seq)])


@quiet
def axis_angle(R: ArrayLike) -> tuple[Array, Array]:
    """The one axis and angle that make the same rotation.

    R: (…, 3, 3) → axis (…, 3), of length 1, and angle (…) in [0, π] rad. No rotation: the axis is
    z. A half turn (to within 1e-15): of the two opposite axes the one whose first non-zero
    component is positive. All digits are kept near both. A matrix that is not a rotation is
    refused. Source: the unit quaternion, from the largest of its components; Shepperd (1978).

    >>> axis, angle = axis_angle([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])
    >>> (axis * np.sqrt(3)).round(6), (np.degrees(angle)).round(6)
    (array([-1.,  1., -1.]), np.float64(120.0))
    """
    _, (R,) = rows(("R", R, (3, 3)))
    refuse_skewed("R", R)
    w, x, y, z = _quaternion(R)
    length = np.hypot(np.hypot(x, y), z)
    half = np.abs(w) <= 0.5 * LOCK * length
    first = x + (np.abs(x) <= LOCK * length) * (y + (np.abs(y) <= LOCK * length) * z)
    facing = np.copysign(length, w * ~half + first * half)
    axis = (np.array([x, y, z]) / facing).T + 0.0
    axis[(length == 0).T] = [0.0, 0.0, 1.0]
    return axis, 2.0 * np.arctan2(length, np.abs(w) * ~half).T


def _quaternion(R: Array) -> Array:
    """w, x, y, z, not yet of length 1: the row of 4 q qᵀ with the largest diagonal entry.

    (…, 3, 3) → (4, …) with the batch axes reversed.
    """
    (xx, yx, zx), (xy, yy, zy), (xz, yz, zz) = R.T
    wx, wy, wz, ww = zy - yz, xz - zx, yx - xy, 1.0 + xx + yy + zz
    xy, yz, zx = xy + yx, yz + zy, zx + xz
    xx, yy, zz = 1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz
    Q = [[ww, wx, wy, wz], [wx, xx, xy, zx], [wy, xy, yy, yz], [wz, zx, yz, zz]]
    q: Array = np.choose(np.argmax([ww, xx, yy, zz], axis=0), np.array(Q))
    return q


def _third(M: Array, i: int, j: int, k: int, proper: bool, sign: int) -> tuple[Array, Array, Array]:
    """The third angle's sine and cosine, both times h; h ≥ 0, the sine or cosine of the middle."""
    w, u = (M[..., i, j], sign * M[..., i, k]) if proper else (-sign * M[..., i, j], M[..., i, i])
    return w, u, np.sqrt(w * w + u * u)


def _rotation(seq: str, R: ArrayLike, *parameters: Array) -> tuple[Array, _Sequence]:
    """R, transposed for an extrinsic sequence, and the sequence, of three letters."""
    s = _read(seq)
    if len(seq) != 3:
        raise RobokinError(f"seq must have three letters here, got {shown(seq)}")
    _, (R,) = rows(("R", R, (3, 3)), parameters=parameters)
    refuse_skewed("R", R)
    return (R if s.intrinsic else R.swapaxes(-1, -2)), s


def _read(seq: str) -> _Sequence:
    """A sequence's axes; one shorter than three letters is continued as a Cardan sequence."""
    letters = seq if isinstance(seq, str) and 1 <= len(seq) <= 3 else "?"
    axes = ["xyz".find(letter) for letter in letters.lower()]
    twice = any(axis == following for axis, following in pairwise(axes))
    if min(axes) < 0 or twice or letters not in (letters.upper(), letters.lower()):
        raise RobokinError(
            "seq must be 1 to 3 letters, all of XYZ (intrinsic) or all of xyz (extrinsic), no axis "
            f"twice in a row; got {shown(seq)}"
        )
    i = axes[0]
    j = axes[1] if len(axes) > 1 else (i + 1) % 3
    intrinsic = letters.isupper()
    sign = 1 if ((j - i) % 3 == 1) == intrinsic else -1
    return _Sequence(i, j, 3 - i - j, axes[2:] == [i], sign, intrinsic)
