"""The planar arm: links in a chain, each joint turning all that follows; velocities and limits.

Joint angles `[theta1, …, thetan]` and link lengths stand on the last axis; leading batch
dimensions broadcast. The pose is `[x, y, phi]` with phi the sum of the angles, the twist
`[x_dot, y_dot, phi_dot]`, both in the world frame. Exercise 8; Lynch & Park, Modern Robotics,
chapter 5; Siciliano, Sciavicco, Villani & Oriolo, Robotics, chapter 3.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from robokin._checks import Array, choice, finite, positive, quiet, rows
from robokin.elbow_arm import _first, _out_of_reach, _triangle
from robokin.errors import RobokinError, SingularError
from robokin.motion import wrap_angle

__all__ = [
    "ellipse",
    "forward",
    "inverse",
    "jacobian",
    "joint_positions",
    "joint_rates",
    "manipulability",
    "velocity",
]

SINGULAR = 1e-14  # a sine of theta2 so small is rounding: sin(np.pi) is 1.2e-16


@quiet
def forward(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """The pose of the hand from the joint angles.

    theta: (…, n) in rad; lengths: (…, n) in m, positive → (…, 3) `[x, y, phi]` in m, m, rad;
    phi is not wrapped. Source: exercise 8, x = l1 c1 + l2 c12 + l3 c123.

    >>> forward([np.pi / 2, -np.pi / 2, 0], lengths=[0.4, 0.3, 0.1]).round(6)
    array([0.4, 0.4, 0. ])
    """
    shape, t, lengths = _arm(theta, lengths)
    x = y = phi = np.zeros(())
    for i, (dx, dy) in enumerate(_links(t, lengths)):
        x, y, phi = x + dx, y + dy, phi + t[..., i]
    out = np.empty((*shape, 3))
    out[..., 0], out[..., 1], out[..., 2] = x, y, phi
    return out


@quiet
def joint_positions(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """Where the base, the joints and the hand are, in this order: the arm as it is drawn.

    theta: (…, n) in rad; lengths: (…, n) in m, positive → (…, n+1, 2) in m, a row for each point.
    """
    shape, t, lengths = _arm(theta, lengths)
    out = np.empty((*shape, lengths.shape[-1] + 1, 2))
    out[..., 0, :] = 0 * t[..., :1]
    for i, (dx, dy) in enumerate(_links(t, lengths)):
        out[..., i + 1, 0] = out[..., i, 0] + dx
        out[..., i + 1, 1] = out[..., i, 1] + dy
    return out


@quiet
def jacobian(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """The matrix J that takes joint rates to the hand's twist.

    theta: (…, n) in rad; lengths: (…, n) in m, positive → (…, 3, n); rows x_dot, y_dot in m,
    phi_dot: ones. Column j is the hand's motion when joint j alone turns with 1 rad/s.
    For three links det J = l1 l2 sin θ2. Source: exercise 8.
    """
    shape, t, lengths = _arm(theta, lengths)
    return _jacobian(t, lengths, shape)


@quiet
def velocity(theta: ArrayLike, rates: ArrayLike, lengths: ArrayLike) -> Array:
    """The hand's twist from the joint rates: J times the rates.

    theta: (…, n) in rad; rates: (…, n) in rad/s; lengths: (…, n) in m, positive
    → (…, 3) `[x_dot, y_dot, phi_dot]`. Each link turns with the sum of the rates up to it.
    """
    lengths = _lengths(lengths)
    core = lengths.shape[-1:]
    shape, (t, q) = rows(
        ("theta", theta, core), ("rates", rates, core), parameters=(lengths[..., 0],)
    )
    vx = vy = omega = np.zeros(())
    for i, (dx, dy) in enumerate(_links(t, lengths)):
        omega = omega + q[..., i]
        vx, vy = vx - dy * omega, vy + dx * omega
    out = np.empty((*shape, 3))
    out[..., 0], out[..., 1], out[..., 2] = vx, vy, omega
    return out


@quiet
def joint_rates(
    theta: ArrayLike,
    twist: ArrayLike,
    lengths: ArrayLike,
    damping: ArrayLike = 0.0,
    singular: str = "raise",
) -> Array:
    """The joint rates that give a wanted twist, three links: J⁻¹ times the twist.

    theta: (…, 3) in rad; twist: (…, 3) `[x_dot, y_dot, phi_dot]`; lengths: (…, 3) in m, positive;
    damping: (…) λ, not negative → (…, 3) in rad/s. Solved by hand and divided by sin θ2 itself,
    so that no digits are lost near the singular points, stretched (θ2 = 0) or folded (θ2 = π).
    There, where `|sin θ2| ≤ 1e-14`, the answer is `SingularError`, or NaN with singular="nan".
    With λ > 0 (damped least squares, Jᵀ (J Jᵀ + λ² I)⁻¹ times the twist) every pose has an
    answer, with bounded rates. Source: exercise 8; Siciliano et al., section 3.5.2.

    >>> joint_rates([0, np.pi / 2, 0], [0, 0.1, 0], lengths=[0.4, 0.3, 0.1]).round(6)
    array([ 0.25, -0.25,  0.  ])
    """
    choice("singular", singular, ("raise", "nan"))
    lengths, damping = _lengths(lengths, 3), _not_negative("damping", damping)
    shape, (t, v) = rows(
        ("theta", theta, (3,)), ("twist", twist, (3,)), parameters=(lengths[..., 0], damping)
    )
    l1, l2, l3 = lengths[..., 0], lengths[..., 1], lengths[..., 2]
    vx, vy, omega = v[..., 0], v[..., 1], v[..., 2]
    heading, s2, square = t[..., 0] + t[..., 1], np.sin(t[..., 1]), np.square(damping)
    along1 = vx * np.cos(t[..., 0]) + vy * np.sin(t[..., 0])  # the hand's velocity along link 1
    along2 = vx * np.cos(heading) + vy * np.sin(heading)
    det = l1 * l2 * s2
    rate1 = l2 * (along2 + l3 * omega * np.sin(t[..., 2]))  # of link 1, times det
    rate2 = -l1 * (along1 + l3 * omega * np.sin(t[..., 1] + t[..., 2]))  # of link 2, times det
    out = np.empty((*shape, 3))
    out[..., 0], out[..., 1], out[..., 2] = rate1, rate2 - rate1, det * omega - rate2
    if square.any():
        out = _damped(_jacobian(t, lengths, shape), v, square, det, out)
    else:
        out /= det[..., None]
    bad = np.broadcast_to((np.abs(s2) <= SINGULAR) & (square == 0), shape)
    if singular == "raise" and bad.any():
        index, where = _first(bad)
        raise SingularError(
            f"theta{where} is singular: |sin(theta2)| is "
            f"{abs(np.broadcast_to(s2, shape)[index]):.3g}, must be above {SINGULAR}; "
            "damping > 0 gives an answer there"
        )
    out[bad] = np.nan
    return out


@quiet
def inverse(pose: ArrayLike, lengths: ArrayLike, unreachable: str = "raise") -> Array:
    """Both ways for three links to bring the hand to a pose.

    pose: (…, 3) `[x, y, phi]` in m, m, rad; lengths: (…, 3) in m, positive → (…, 2, 3) in rad,
    all in (-π, π]: theta2 ≥ 0 in the first row, -theta2 in the second. Stretched or folded the
    two are one. Where l1 = l2 and the wrist is at the base, theta1 is free: 0.
    Where the wrist, l3 behind the hand, is nearer than `|l1 - l2|` or farther than l1 + l2 (by
    more than 1e-12 of l1 + l2) there is no answer: `UnreachableError`, or NaN with
    unreachable="nan".

    >>> inverse([0.4, 0.4, 0], lengths=[0.4, 0.3, 0.1])[1].round(6)
    array([ 1.570796, -1.570796,  0.      ])
    """
    choice("unreachable", unreachable, ("raise", "nan"))
    lengths = _lengths(lengths, 3)
    l1, l2, l3 = lengths[..., 0], lengths[..., 1], lengths[..., 2]
    shape, (p,) = rows(("pose", pose, (3,)), parameters=(l1,))
    phi = p[..., 2]
    x, y = p[..., 0] - l3 * np.cos(phi), p[..., 1] - l3 * np.sin(phi)
    distance = np.sqrt(x * x + y * y)
    bad = _out_of_reach("pose", distance, l1, l2, unreachable)
    lift, elbow = _triangle(distance, l1, l2)
    direction = np.arctan2(y, x)
    out = np.empty((*shape, 2, 3))
    out[..., 0, 0], out[..., 1, 0] = direction - lift, direction + lift
    out[..., 0, 1], out[..., 1, 1] = elbow, -elbow
    out[..., 2] = phi[..., None] - out[..., 0] - out[..., 1]
    out[bad] = np.nan
    return wrap_angle(out)


@quiet
def manipulability(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """How far from singular the arm is for moving the hand's point: √det(J Jᵀ), rows x, y of J.

    theta: (…, n) in rad; lengths: (…, n) in m, positive → (…) in m², 0 where all links lie on
    one line. It is the product of the half-axes of `ellipse`, for two links `l1 l2 |sin θ2|`.
    Source: Yoshikawa; Siciliano et al., section 3.9.
    """
    _, _, _, area = _position_rows(theta, lengths)
    return area


@quiet
def ellipse(theta: ArrayLike, lengths: ArrayLike) -> tuple[Array, Array]:
    """The manipulability ellipse: the hand's velocities for joint rates of length 1 in all.

    theta: (…, n) in rad; lengths: (…, n) in m, positive → half-axes (…, 2) in m (for 1 rad/s),
    the larger first, and their directions in the world as columns (…, 2, 2), the second a
    quarter turn from the first. They are the singular values and left vectors of the position
    rows of J (each direction up to its sign). Source: Siciliano et al., section 3.9.

    >>> ellipse([0, np.pi / 2], lengths=[0.4, 0.4])[0].round(6)
    array([0.647214, 0.247214])
    """
    theta1, x, y, area = _position_rows(theta, lengths)
    xx, yy, xy = (x * x).sum(axis=-1), (y * y).sum(axis=-1), (x * y).sum(axis=-1)
    large = np.sqrt(0.5 * (xx + yy + np.sqrt((xx - yy) ** 2 + 4 * xy * xy)))
    angle = theta1 + 0.5 * np.arctan2(2 * xy, xx - yy)
    axes, directions = np.empty((*area.shape, 2)), np.empty((*area.shape, 2, 2))
    axes[..., 0] = large
    axes[..., 1] = area / large
    directions[..., 0, 0] = directions[..., 1, 1] = np.cos(angle)
    directions[..., 1, 0] = np.sin(angle)
    directions[..., 0, 1] = -directions[..., 1, 0]
    return axes, directions


def _lengths(lengths: ArrayLike, links: int | None = None) -> Array:
    array = positive("lengths", lengths)
    if array.shape[-1:] in ((), (0,)) or links not in (None, array.shape[-1]):
        wanted = "n), one or more" if links is None else f"{links})"
        raise RobokinError(f"lengths must have shape (…, {wanted}, got {array.shape}")
    return array


def _arm(theta: ArrayLike, lengths: ArrayLike) -> tuple[tuple[int, ...], Array, Array]:
    """The two arguments of most functions here, checked, and their batch shape."""
    lengths = _lengths(lengths)
    shape, (t,) = rows(("theta", theta, lengths.shape[-1:]), parameters=(lengths[..., 0],))
    return shape, t, lengths


def _not_negative(name: str, value: ArrayLike) -> Array:
    array = finite(name, value)
    if (array < 0).any():
        index, where = _first(array < 0)
        raise RobokinError(f"{name} must be zero or more, got {array[index]}{where}")
    return array


def _links(theta: Array, lengths: Array) -> Iterator[tuple[Array, Array]]:
    """Each link in turn as a vector x, y."""
    heading = np.zeros(())
    for i in range(theta.shape[-1]):
        heading = heading + theta[..., i]
        yield lengths[..., i] * np.cos(heading), lengths[..., i] * np.sin(heading)


def _jacobian(theta: Array, lengths: Array, shape: tuple[int, ...]) -> Array:
    n = lengths.shape[-1]
    out = np.empty((*shape, 3, n))
    out[..., 2, :] = 1 + 0 * theta
    x = y = np.zeros(())  # from joint i to the hand
    for i, (dx, dy) in reversed(list(enumerate(_links(theta, lengths)))):
        x, y = x + dx, y + dy
        out[..., 0, i] = -y
        out[..., 1, i] = x
    return out


def _damped(J: Array, twist: Array, square: Array, det: Array, adjugate_twist: Array) -> Array:
    """Jᵀ (J Jᵀ + λ² I)⁻¹ times the twist, by Cramer's rule in powers of λ² (`square`).

    With G = J Jᵀ the determinant is λ⁶ + λ⁴ tr G + λ² (principal minors of G) + det² J. The
    terms without λ come from the caller with all their digits, so that a small λ does no harm.
    """
    G = J @ np.swapaxes(J, -1, -2)
    xx, yy = G[..., 0, 0], G[..., 1, 1]  # the third is 1 + 1 + 1
    minors = xx * yy + 3 * (xx + yy) - G[..., 0, 1] ** 2 - G[..., 0, 2] ** 2 - G[..., 1, 2] ** 2
    below = square * (square * (square + xx + yy + 3) + minors) + det * det
    rest = -G  # becomes (λ² + tr G) I - G, with a diagonal in which nothing cancels
    rest[..., 0, 0], rest[..., 1, 1] = square + yy + 3, square + xx + 3
    rest[..., 2, 2] = square + xx + yy
    above = np.swapaxes(J, -1, -2) @ (rest @ twist[..., None])
    above = square[..., None] * above[..., 0] + det[..., None] * adjugate_twist
    return above / below[..., None]


def _position_rows(theta: ArrayLike, lengths: ArrayLike) -> tuple[Array, Array, Array, Array]:
    """theta1, the rows x_dot and y_dot of J with link 1 laid along x, and √det(J Jᵀ) of them.

    In that frame all x_dot are small near a singular pose and keep their digits; √det is the
    length of one row times that of the other's part across it, with no square to cancel.
    """
    shape, t, lengths = _arm(theta, lengths)
    laid = t.copy()
    laid[..., 0] *= 0
    J = _jacobian(laid, lengths, shape)
    x, y = J[..., 0, :], J[..., 1, :]
    yy = (y * y).sum(axis=-1)
    across = x - y * ((x * y).sum(axis=-1) / yy)[..., None]
    return t[..., 0], x, y, np.sqrt(yy * (across * across).sum(axis=-1))
