"""The planar arm: links in a chain, each joint turning all that follows; velocities and limits.

Joint angles are `[theta1, …, thetan]`, n as many as link lengths. The pose is `[x, y, phi]` with
phi the sum of the angles. The hand's velocity along the world's axes is `[x_dot, y_dot, phi_dot]`;
arguments call it `twist`. Lynch & Park, Modern Robotics, chapters 4 and 5; Siciliano, Sciavicco,
Villani & Oriolo, Robotics: Modelling, Planning and Control, chapters 2 and 3.
"""

import numpy as np

from robokin._arrays import Array, ArrayLike, first, matrix, parts, vector
from robokin._triangle import out_of_reach, triangle
from robokin._validation import data, not_negative, one_of, positive, validated
from robokin.errors import SingularError, at_index
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

LINKS = {"lengths": positive("n"), "theta": data("n")}
THREE_LINKS = {"lengths": positive(3), "theta": data(3)}
SINGULAR = 1e-14  # a sine of theta2 so small is rounding: sin(np.pi) is 1.2e-16


@validated(**LINKS)
def forward(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """Return the pose of the hand from the joint angles.

    Parameters
    ----------
    theta : array_like, shape (..., n)
        Joint angles in rad.
    lengths : array_like, shape (..., n)
        Lengths of the links in m.

    Returns
    -------
    ndarray, shape (..., 3)
        `[x, y, phi]` in m and rad; phi is not wrapped.

    References
    ----------
    Lynch & Park, chapter 4, x = l1 c1 + l2 c12 + l3 c123.

    Examples
    --------
    >>> forward([np.pi / 2, -np.pi / 2, 0], lengths=[0.4, 0.3, 0.1]).round(6)
    array([0.4, 0.4, 0. ])
    """
    heading = theta.cumsum(axis=-1)
    x, y = np.vecdot(lengths, np.cos(heading)), np.vecdot(lengths, np.sin(heading))
    return vector(x, y, heading[..., -1])


@validated(**LINKS)
def joint_positions(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """Return where base, joints and hand are: the arm as it is drawn.

    Parameters
    ----------
    theta : array_like, shape (..., n)
        Joint angles in rad.
    lengths : array_like, shape (..., n)
        Lengths of the links in m.

    Returns
    -------
    ndarray, shape (..., n+1, 2)
        Points in m, in this order.
    """
    heading = theta.cumsum(axis=-1)
    links = vector(lengths * np.cos(heading), lengths * np.sin(heading))
    out = np.zeros((*links.shape[:-2], links.shape[-2] + 1, 2))
    np.cumsum(links, axis=-2, out=out[..., 1:, :])
    return out


@validated(**LINKS)
def jacobian(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """Return the matrix J that takes joint rates to the hand's velocity.

    Column j is the hand's motion when joint j alone turns with 1 rad/s. For three links det J = l1
    l2 sin θ2.

    Parameters
    ----------
    theta : array_like, shape (..., n)
        Joint angles in rad.
    lengths : array_like, shape (..., n)
        Lengths of the links in m.

    Returns
    -------
    ndarray, shape (..., 3, n)
        Rows for x_dot and y_dot in m, for phi_dot ones.

    References
    ----------
    Siciliano et al., section 3.2.1.
    """
    x, y = _levers(theta, lengths)
    return vector(-y, x, 1).swapaxes(-1, -2)


@validated(**LINKS, rates=data("n"))
def velocity(theta: ArrayLike, rates: ArrayLike, lengths: ArrayLike) -> Array:
    """Return the hand's velocity from the joint rates: J times the rates.

    Each link turns with the sum of the rates up to it.

    Parameters
    ----------
    theta : array_like, shape (..., n)
        Joint angles in rad.
    rates : array_like, shape (..., n)
        Joint rates in rad/s.
    lengths : array_like, shape (..., n)
        Lengths of the links in m.

    Returns
    -------
    ndarray, shape (..., 3)
        `[x_dot, y_dot, phi_dot]` in m/s and rad/s.
    """
    heading, omega = theta.cumsum(axis=-1), rates.cumsum(axis=-1)
    x_dot = -np.vecdot(lengths * np.sin(heading), omega)
    y_dot = np.vecdot(lengths * np.cos(heading), omega)
    return vector(x_dot, y_dot, omega[..., -1])


@validated(**THREE_LINKS, twist=data(3), damping=not_negative(), singular=one_of("raise", "nan"))
def joint_rates(
    theta: ArrayLike,
    twist: ArrayLike,
    lengths: ArrayLike,
    damping: ArrayLike = 0.0,
    singular: str = "raise",
) -> Array:
    """Return the joint rates for a wanted velocity of the hand, three links: J⁻¹ times it.

    Solved by hand and divided by sin θ2 itself, so that no digits are lost near the singular
    points, stretched (θ2 = 0) or folded (θ2 = π). With λ > 0 (damped least squares, Jᵀ (J Jᵀ + λ²
    I)⁻¹ times the twist) every pose has an answer, with bounded rates.

    Parameters
    ----------
    theta : array_like, shape (..., 3)
        Joint angles in rad.
    twist : array_like, shape (..., 3)
        `[x_dot, y_dot, phi_dot]` in m/s and rad/s.
    lengths : array_like, shape (..., 3)
        Lengths of the links in m.
    damping : array_like, shape (...), default 0.0
        λ, not negative.
    singular : {"raise", "nan"}, default "raise"
        Whether a singular point without damping raises or gives NaN.

    Returns
    -------
    ndarray, shape (..., 3)
        Joint rates in rad/s.

    Raises
    ------
    SingularError
        If `|sin θ2| ≤ 1e-14` and λ = 0.

    References
    ----------
    Siciliano et al., section 3.5.2.

    Examples
    --------
    >>> joint_rates([0, np.pi / 2, 0], [0, 0.1, 0], lengths=[0.4, 0.3, 0.1]).round(6)
    array([ 0.25, -0.25,  0.  ])
    """
    l1, l2, l3 = parts(lengths)
    theta1, theta2, theta3 = parts(theta)
    x_dot, y_dot, phi_dot = parts(twist)
    heading, s2, tip = theta1 + theta2, np.sin(theta2), l3 * phi_dot
    along1 = x_dot * np.cos(theta1) + y_dot * np.sin(theta1) + tip * np.sin(theta2 + theta3)
    along2 = x_dot * np.cos(heading) + y_dot * np.sin(heading) + tip * np.sin(theta3)
    det, square = l1 * l2 * s2, damping * damping
    rate1, rate12 = l2 * along2, -l1 * along1  # of links 1 and 2 in the world, times det
    rates = vector(rate1, rate12 - rate1, det * phi_dot - rate12)
    if (square > 0).any():
        rates = _damped(theta, twist, lengths, square, det, rates)
    else:
        rates = rates / det[..., None]
    bad = (np.abs(s2) <= SINGULAR) & (square == 0)
    if singular == "raise" and bad.any():
        index = first(bad)
        sine = np.broadcast_to(np.abs(s2), bad.shape)[index]
        raise SingularError(
            f"theta{at_index(index)} is singular: |sin(theta2)| is {sine:.3g}, must be above "
            f"{SINGULAR}; damping > 0 gives an answer there"
        )
    return np.where(bad[..., None], np.nan, rates)


@validated(lengths=positive(3), pose=data(3), unreachable=one_of("raise", "nan"))
def inverse(pose: ArrayLike, lengths: ArrayLike, unreachable: str = "raise") -> Array:
    """Return both ways for three links to bring the hand to a pose.

    Parameters
    ----------
    pose : array_like, shape (..., 3)
        `[x, y, phi]` in m and rad.
    lengths : array_like, shape (..., 3)
        Lengths of the links in m.
    unreachable : {"raise", "nan"}, default "raise"
        Whether a pose out of reach raises or gives NaN.

    Returns
    -------
    ndarray, shape (..., 2, 3)
        Joint angles in (-π, π] rad: theta2 ≥ 0 in the first row, -theta2 in the second. Stretched
        or folded the two are one. Where l1 = l2 and the wrist is at the base, theta1 is free: 0.

    Raises
    ------
    UnreachableError
        If the wrist, l3 behind the hand, is nearer than `|l1 - l2|` or farther than l1 + l2, by
        more than 1e-12 of l1 + l2.

    References
    ----------
    Siciliano et al., section 2.12.1.

    Examples
    --------
    >>> inverse([0.4, 0.4, 0], lengths=[0.4, 0.3, 0.1])[1].round(6)
    array([ 1.570796, -1.570796,  0.      ])
    """
    l1, l2, l3 = parts(lengths)
    x, y, phi = parts(pose)
    x_w, y_w = x - l3 * np.cos(phi), y - l3 * np.sin(phi)  # the wrist
    d = np.sqrt(x_w * x_w + y_w * y_w)
    outside = out_of_reach("pose", pose, d, l1, l2, unreachable)
    lift, theta2 = triangle(d, l1, l2)
    low, high = np.arctan2(y_w, x_w) - lift, np.arctan2(y_w, x_w) + lift
    both = matrix([[low, theta2, phi - low - theta2], [high, -theta2, phi - high + theta2]])
    both[outside] = np.nan
    return wrap_angle(both)


@validated(**LINKS)
def manipulability(theta: ArrayLike, lengths: ArrayLike) -> Array:
    """Return how far from singular the arm is for moving the hand: √det(J Jᵀ), rows x, y of J.

    It is the product of the half-axes of `ellipse`, for two links `l1 l2 |sin θ2|`.

    Parameters
    ----------
    theta : array_like, shape (..., n)
        Joint angles in rad.
    lengths : array_like, shape (..., n)
        Lengths of the links in m.

    Returns
    -------
    ndarray, shape (...)
        Manipulability in m², 0 where all links lie on one line.

    References
    ----------
    Yoshikawa (1985); Siciliano et al., section 3.9.
    """
    return _area(*_position_rows(theta, lengths))


@validated(**LINKS)
def ellipse(theta: ArrayLike, lengths: ArrayLike) -> tuple[Array, Array]:
    """Return the manipulability ellipse: the hand's velocities for joint rates of length 1.

    The half-axes and directions are the singular values and left vectors of the position rows of J.

    Parameters
    ----------
    theta : array_like, shape (..., n)
        Joint angles in rad.
    lengths : array_like, shape (..., n)
        Lengths of the links in m.

    Returns
    -------
    half_axes : ndarray, shape (..., 2)
        Half-axes in m (for 1 rad/s), the larger first.
    directions : ndarray, shape (..., 2, 2)
        Their directions in the world as columns, each up to its sign, the second a quarter turn
        from the first.

    References
    ----------
    Siciliano et al., section 3.9.

    Examples
    --------
    >>> ellipse([0, np.pi / 2], lengths=[0.4, 0.4])[0].round(6)
    array([0.647214, 0.247214])
    """
    x, y = _position_rows(theta, lengths)
    xx, yy, xy = np.vecdot(x, x), np.vecdot(y, y), np.vecdot(x, y)
    large = np.sqrt((xx + yy + np.sqrt((xx - yy) ** 2 + 4 * xy * xy)) / 2)
    angle = theta[..., 0] + np.arctan2(2 * xy, xx - yy) / 2
    c, s = np.cos(angle), np.sin(angle)
    return vector(large, _area(x, y) / large), matrix([[c, -s], [s, c]])


def _levers(theta: Array, lengths: Array) -> tuple[Array, Array]:
    """Return x (…, n) and y (…, n) from each joint to the hand."""
    heading = theta.cumsum(axis=-1)
    x, y = lengths * np.cos(heading), lengths * np.sin(heading)
    for i in reversed(range(x.shape[-1] - 1)):  # cumsum makes the Jacobian 1.5 times slower
        x[..., i] += x[..., i + 1]
        y[..., i] += y[..., i + 1]
    return x, y


def _damped(
    theta: Array, twist: Array, lengths: Array, square: Array, det: Array, undamped: Array
) -> Array:
    """Return Jᵀ (J Jᵀ + λ² I)⁻¹ times the twist, by Cramer's rule in powers of λ² (`square`).

    With G = J Jᵀ the determinant is λ⁶ + λ⁴ tr G + λ² (principal minors of G) + det² J. The
    terms without λ come from the caller, times det, so that a small λ does no harm.
    """
    x, y = _levers(theta, lengths)  # the rows of J are -y, x and 1
    v_x, v_y, omega = parts(twist)
    xx, yy, xy = np.vecdot(y, y), np.vecdot(x, x), -np.vecdot(x, y)  # G, with 3 in its corner
    xz, yz = -y.sum(axis=-1), x.sum(axis=-1)
    minors = xx * yy + 3 * (xx + yy) - xy * xy - xz * xz - yz * yz
    below = square * (square * (square + xx + yy + 3) + minors) + det * det
    # (λ² + tr G) I - G times the twist, with a diagonal in which nothing cancels
    a = (square + yy + 3) * v_x - xy * v_y - xz * omega
    b = (square + xx + 3) * v_y - xy * v_x - yz * omega
    c = (square + xx + yy) * omega - xz * v_x - yz * v_y
    above = x * b[..., None] - y * a[..., None] + c[..., None]
    return (square[..., None] * above + det[..., None] * undamped) / below[..., None]


def _position_rows(theta: Array, lengths: Array) -> tuple[Array, Array]:
    """Return the rows x_dot and y_dot of J, (…, n), with link 1 laid along x.

    In that frame all x_dot are small near a singular pose and keep their digits.
    """
    laid = theta.copy()
    laid[..., 0] = 0.0
    x, y = _levers(laid, lengths)
    return -y, x


def _area(x: Array, y: Array) -> Array:
    """Return √det of the products of two rows: one's length times the other's part across."""
    yy = np.vecdot(y, y)
    across = x - y * (np.vecdot(x, y) / yy)[..., None]
    return np.sqrt(yy * np.vecdot(across, across))
