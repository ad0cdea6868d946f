"""Wheels of every kind on a robot: what each of them demands of the robot's motion.

A wheel is at the distance l and the angle alpha from the robot's centre; beta turns from that
spoke to the wheel's axle (beta = 0: the axle points along the spoke and the wheel rolls towards
alpha + beta - 90°). Below, k counts the wheels but the spherical ones, s the steered wheels, m the
fixed and the steered ones, each in the order of the list. Siegwart, Nourbakhsh & Scaramuzza,
Introduction to Autonomous Mobile Robots, sections 3.2 and 3.3; Campion, Bastin & D'Andréa-Novel
(1996).
"""
# ruff: noqa: E741  (l is the field's own name)

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from inspect import unwrap
from typing import Any, NamedTuple

import numpy as np

from robokin._arrays import Array, ArrayLike, Bools, first, parts, times, vector
from robokin._validation import data, finite, not_negative, one_of, positive, validated
from robokin.errors import RobokinError, SingularError, UnreachableError, at_index, describe
from robokin.motion import to_body, to_world

__all__ = [
    "Mobility",
    "Wheel",
    "castor",
    "fixed",
    "forward",
    "inverse",
    "mobility",
    "omni_robot",
    "rolling",
    "rolling_rates",
    "sliding",
    "slip",
    "spherical",
    "steered",
    "swedish",
]

HELD = ("fixed", "steered")  # kinds with a row in `sliding`
DRIVEN = (*HELD, "castor", "swedish")  # kinds with a row in `rolling`
KINDS = (*DRIVEN, "spherical")
NUMBERS = {"l": not_negative(), "radius": positive()}
NUMBERS |= dict.fromkeys(("alpha", "beta", "d", "gamma"), finite())
SLIPPING = one_of("raise", "nan", "ignore")
DEPENDENT = 1e-12  # rows nearer than this to depending on each other do
SLIP = 1e-6  # of the speeds that make it up: as far as poses and angles may be off elsewhere


@dataclass(frozen=True)
class Wheel:
    """One wheel: its kind, place, axle and radius; made by `fixed`, `steered`, … `spherical`.

    Parameters
    ----------
    kind : {"fixed", "steered", "castor", "swedish", "spherical"}
        Kind of wheel, named as the function that makes it.
    l : float
        Distance from the robot's centre in m, zero or more.
    alpha, beta : float
        Angle of the spoke, and from there to the axle, in rad.
    radius : float
        Radius in m.
    d : float, default 0.0
        Of a castor, see `castor`; 0 for the others.
    gamma : float, default 0.0
        Of a Swedish wheel, see `swedish`; 0 for the others.
    """

    kind: str
    l: float
    alpha: float
    beta: float
    radius: float
    d: float = 0.0
    gamma: float = 0.0

    def __post_init__(self) -> None:
        one_of(*KINDS)("kind", self.kind, {})
        for name, rule in NUMBERS.items():
            number = rule(name, getattr(self, name), {})
            if number.ndim:
                raise RobokinError(f"{name} must be one number, got {describe(number)}")
            object.__setattr__(self, name, float(number))
        if not np.isfinite(self.alpha + self.beta + self.gamma):
            raise RobokinError("alpha + beta + gamma must be finite, got inf")
        if (self.d != 0) != (self.kind == "castor"):
            raise RobokinError(f"d must not be 0 for a castor, and 0 for the others, got {self.d}")
        if (self.gamma != 0 and self.kind != "swedish") or abs(np.cos(self.gamma)) < 1e-15:
            raise RobokinError(f"gamma must be 0, of a swedish wheel not ±π/2, got {self.gamma}")


class Mobility(NamedTuple):
    """Degrees of mobility, of steerability, and their sum: of manoeuvrability.

    Attributes
    ----------
    delta_m : int
        Degree of mobility.
    delta_s : int
        Degree of steerability.
    delta_M : int
        Degree of manoeuvrability.
    """

    delta_m: int
    delta_s: int
    delta_M: int


def _wheels(name: str, wheels: Any, sizes: dict[Any, int]) -> tuple[Wheel, ...]:
    """Validate a list of wheels; count the driven and the steered ones."""
    if not isinstance(wheels, (list, tuple)):
        raise RobokinError(f"{name} must be a list of Wheel, got {describe(wheels)}")
    for index, wheel in enumerate(wheels):
        if not isinstance(wheel, Wheel):
            raise RobokinError(f"{name} must be Wheel, got {describe(wheel)}{at_index((index,))}")
    sizes["k"] = len(wheels) - [wheel.kind for wheel in wheels].count("spherical")
    sizes["s"] = [wheel.kind for wheel in wheels].count("steered")
    return tuple(wheels)


def fixed(l: float, alpha: float, beta: float, radius: float) -> Wheel:
    """Make a wheel with an axle fixed to the robot: it rolls, and must not slide along it.

    Parameters
    ----------
    l : float
        Distance from the robot's centre in m.
    alpha, beta : float
        Angle of the spoke, and from there to the axle, in rad.
    radius : float
        Radius in m.

    Returns
    -------
    Wheel
        Fixed wheel.
    """
    return Wheel("fixed", l, alpha, beta, radius)


def steered(l: float, alpha: float, beta: float, radius: float) -> Wheel:
    """Make a wheel that turns about the vertical through its contact point.

    Parameters
    ----------
    l : float
        Distance from the robot's centre in m.
    alpha : float
        Angle of the spoke in rad.
    beta : float
        Angle from there to the axle now, in rad.
    radius : float
        Radius in m.

    Returns
    -------
    Wheel
        Steered wheel.
    """
    return Wheel("steered", l, alpha, beta, radius)


def castor(l: float, alpha: float, beta: float, radius: float, d: float) -> Wheel:
    """Make a wheel that trails freely about a pivot at (l, alpha): it hinders nothing.

    Parameters
    ----------
    l : float
        Distance of the pivot from the robot's centre in m.
    alpha : float
        Angle of the spoke in rad.
    beta : float
        Angle from there to the axle now, in rad; it is taken as given and does not trail.
    radius : float
        Radius in m.
    d : float
        From the pivot to the contact point along the positive rolling direction, in m, not 0;
        negative for a trailing castor.

    Returns
    -------
    Wheel
        Castor wheel.
    """
    return Wheel("castor", l, alpha, beta, radius, d=d)


def swedish(l: float, alpha: float, beta: float, radius: float, gamma: float) -> Wheel:
    """Make a wheel with free rollers on its rim (Mecanum).

    Parameters
    ----------
    l : float
        Distance from the robot's centre in m.
    alpha, beta : float
        Angle of the spoke, and from there to the axle, in rad.
    radius : float
        Radius in m.
    gamma : float
        Angle from where it rolls to the axes of its rollers, in rad, not ±π/2.

    Returns
    -------
    Wheel
        Swedish wheel.
    """
    return Wheel("swedish", l, alpha, beta, radius, gamma=gamma)


def spherical(l: float, alpha: float, radius: float) -> Wheel:
    """Make a ball that rolls in any direction: it demands nothing.

    Parameters
    ----------
    l : float
        Distance from the robot's centre in m.
    alpha : float
        Angle of the spoke in rad.
    radius : float
        Radius in m.

    Returns
    -------
    Wheel
        Spherical wheel.
    """
    return Wheel("spherical", l, alpha, 0.0, radius)


def omni_robot(
    l: float, radius: float, angles: ArrayLike = (0, 2 * np.pi / 3, 4 * np.pi / 3)
) -> list[Wheel]:
    """Make a robot of Swedish wheels with rollers across: beta = gamma = 0.

    Parameters
    ----------
    l : float
        Distance of the wheels from the robot's centre in m.
    radius : float
        Radius in m.
    angles : array_like, shape (n,), default (0, 2π/3, 4π/3)
        Angles of the spokes in rad.

    Returns
    -------
    list of Wheel
        The n wheels.

    Examples
    --------
    >>> rolling(omni_robot(0.2, 0.05)).round(3)
    array([[ 0.   , -1.   , -0.2  ],
           [ 0.866,  0.5  , -0.2  ],
           [-0.866,  0.5  , -0.2  ]])
    """
    array = finite()("angles", angles, {})
    if array.ndim != 1:
        raise RobokinError(f"angles must have shape (n,), got {array.shape}")
    return [swedish(l, angle, 0.0, radius, 0.0) for angle in array]


@validated(wheels=_wheels, steering=data("s"))
def rolling(wheels: Sequence[Wheel], steering: ArrayLike | None = None) -> Array:
    """Return J1: the speed at which each wheel must roll is its row times the robot's twist.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.
    steering : array_like, shape (..., s), optional
        Angles in rad in place of the steered wheels' beta.

    Returns
    -------
    ndarray, shape (..., k, 3)
        Rows in the body frame, without unit and in m.

    References
    ----------
    Siegwart et al., section 3.2.3, [sin(α+β+γ), −cos(α+β+γ), −l cos(β+γ)] R(θ) ξ̇_I − r φ̇ cos γ =
    0.
    """
    w = _layout(wheels, DRIVEN)
    beta = _turned(w, steering) + w.gamma
    return vector(np.sin(w.alpha + beta), -np.cos(w.alpha + beta), -w.l * np.cos(beta))


@validated(wheels=_wheels)
def rolling_rates(wheels: Sequence[Wheel]) -> Array:
    """Return J2 = diag(r cos γ), from wheel rates to the speeds in the rows of J1.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.

    Returns
    -------
    ndarray, shape (k, k)
        Diagonal matrix in m.
    """
    return np.diag(_layout(wheels, DRIVEN).per_radian)


@validated(wheels=_wheels, steering=data("s"))
def sliding(wheels: Sequence[Wheel], steering: ArrayLike | None = None) -> Array:
    """Return C1: the speed of each wheel along its axle is its row times the robot's twist.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.
    steering : array_like, shape (..., s), optional
        Angles in rad in place of the steered wheels' beta.

    Returns
    -------
    ndarray, shape (..., m, 3)
        Rows in the body frame, without unit and in m.

    References
    ----------
    Siegwart et al., section 3.2.3, [cos(α+β), sin(α+β), l sin β] R(θ) ξ̇_I = 0.
    """
    w = _layout(wheels, HELD)
    beta = _turned(w, steering)
    return vector(np.cos(w.alpha + beta), np.sin(w.alpha + beta), w.l * np.sin(beta))


@validated(wheels=_wheels, rates=data("k"), steering=data("s"), theta=data())
def forward(
    wheels: Sequence[Wheel],
    rates: ArrayLike,
    steering: ArrayLike | None = None,
    theta: ArrayLike = 0.0,
) -> Array:
    """Return the robot's velocity in the world from the rates of its wheels.

    It is that of least squares over the rolling and the sliding rows together; what they cannot
    agree on is `slip`.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.
    rates : array_like, shape (..., k)
        Wheel rates in rad/s.
    steering : array_like, shape (..., s), optional
        Angles in rad in place of the steered wheels' beta.
    theta : array_like, shape (...), default 0.0
        Heading in rad.

    Returns
    -------
    ndarray, shape (..., 3)
        `[x_dot, y_dot, omega]` in m/s and rad/s.

    Raises
    ------
    SingularError
        If the wheels do not determine the motion, at any steering.

    References
    ----------
    Siegwart et al., section 3.2.5, ξ̇_I = R(θ)⁻¹ J1⁻¹ J2 φ̇.

    Examples
    --------
    >>> forward(omni_robot(0.2, 0.05), [1, 1, 1]).round(6) + 0.0
    array([ 0.  ,  0.  , -0.25])
    """
    return unwrap(to_world)(theta, _body_twist(wheels, rates, steering))  # all is validated


@validated(wheels=_wheels, rates=data("k"), steering=data("s"))
def slip(wheels: Sequence[Wheel], rates: ArrayLike, steering: ArrayLike | None = None) -> Array:
    """Return how far the wheels are from agreeing: what `forward` leaves over in each row.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.
    rates : array_like, shape (..., k)
        Wheel rates in rad/s.
    steering : array_like, shape (..., s), optional
        Angles in rad in place of the steered wheels' beta.

    Returns
    -------
    ndarray, shape (..., k+m)
        Speeds in m/s: how much faster each wheel is moved than it drives, in the direction that it
        drives (for a Swedish wheel: along the axis of the roller on the ground), in the order of
        `rolling`; then how fast each fixed and steered wheel slides along its axle, in the order of
        `sliding`.

    Raises
    ------
    SingularError
        If the wheels do not determine the motion, at any steering.
    """
    twist = _body_twist(wheels, rates, steering)
    rolled = times(rolling(wheels, steering), twist)
    slid = times(sliding(wheels, steering), twist)
    return np.concatenate([rolled - rates * _layout(wheels, DRIVEN).per_radian, slid], axis=-1)


@validated(wheels=_wheels, twist=data(3), steering=data("s"), theta=data(), slipping=SLIPPING)
def inverse(
    wheels: Sequence[Wheel],
    twist: ArrayLike,
    steering: ArrayLike | None = None,
    theta: ArrayLike = 0.0,
    slipping: str = "raise",
) -> Array:
    """Return the rates at which the wheels roll when the robot moves as wanted.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.
    twist : array_like, shape (..., 3)
        `[x_dot, y_dot, omega]` along the world's axes, in m/s and rad/s.
    steering : array_like, shape (..., s), optional
        Angles in rad in place of the steered wheels' beta.
    theta : array_like, shape (...), default 0.0
        Heading in rad.
    slipping : {"raise", "nan", "ignore"}, default "raise"
        Whether a wheel that would slip raises, gives NaN, or rolls all the same.

    Returns
    -------
    ndarray, shape (..., k)
        Wheel rates in rad/s.

    Raises
    ------
    UnreachableError
        If a fixed or steered wheel would slip along its axle, by more than 1e-6 of the speeds that
        move it.

    Examples
    --------
    >>> inverse(omni_robot(0.2, 0.05), [0, 0, -0.25])
    array([1., 1., 1.])
    """
    body = unwrap(to_body)(theta, twist)  # both are validated
    slid = times(sliding(wheels, steering), body)
    rates = times(rolling(wheels, steering), body) / _layout(wheels, DRIVEN).per_radian
    held = _layout(wheels, HELD)
    v_x, v_y, omega = parts(np.abs(body)[..., None, :])
    slips = np.abs(slid) > SLIP * (v_x + v_y + held.l * omega)
    if slipping == "raise" and slips.any():
        *batch, row = index = first(slips)
        wheel = [i for i, w in enumerate(wheels) if w.kind in HELD][row]
        raise UnreachableError(
            f"wheel {wheel} ({wheels[wheel].kind}) would slip sideways at "
            f"{abs(slid[index]):.3g} m/s{at_index(tuple(batch))}; slipping='ignore' gives rates"
        )
    if slipping == "ignore":
        return rates
    return np.where((slips | np.isnan(slid)).any(axis=-1, keepdims=True), np.nan, rates)


@validated(wheels=_wheels)
def mobility(wheels: Sequence[Wheel]) -> Mobility:
    """Return in how many ways the robot can move at once, be steered, and both together.

    The steered wheels are taken to be turned together, so that a centre of rotation exists.

    Parameters
    ----------
    wheels : list of Wheel
        Wheels of the robot.

    Returns
    -------
    Mobility
        The three degrees.

    References
    ----------
    Siegwart et al., section 3.3, δ_m = 3 − rank C1 and δ_s = rank C1s.

    Examples
    --------
    >>> mobility([fixed(0.1, np.pi / 2, 0, 0.03), fixed(0.1, -np.pi / 2, np.pi, 0.03)])
    Mobility(delta_m=2, delta_s=0, delta_M=2)
    """
    units = _units(wheels)
    held = tuple(w for w in wheels if w.kind == "fixed")
    turned = tuple(w for w in wheels if w.kind == "steered")
    generic = np.array([2.4 * (i + 1) for i in range(len(turned))])  # golden angles: no two in line
    rank_fixed = np.linalg.matrix_rank(sliding(held) / units, tol=DEPENDENT)
    rank_steered = np.linalg.matrix_rank(sliding(turned, generic) / units, tol=DEPENDENT)
    delta_s = max(0, min(int(rank_steered), 2 - int(rank_fixed)))
    delta_m = 3 - int(rank_fixed) - delta_s
    return Mobility(delta_m, delta_s, delta_m + delta_s)


class _Layout(NamedTuple):
    """The numbers of the wheels of some kinds, in order, as arrays."""

    l: Array
    alpha: Array
    beta: Array
    gamma: Array
    per_radian: Array  # metres rolled for each radian, r cos γ
    steered: Bools


@lru_cache  # a robot keeps its wheels
def _layout(wheels: Sequence[Wheel], kinds: tuple[str, ...]) -> _Layout:
    chosen = [w for w in wheels if w.kind in kinds]
    table = np.array([(w.l, w.alpha, w.beta, w.gamma, w.radius) for w in chosen]).reshape(-1, 5)
    l, alpha, beta, gamma, radius = table.T
    steered = np.array([w.kind == "steered" for w in chosen], dtype=bool)
    return _Layout(l, alpha, beta, gamma, radius * np.cos(gamma), steered)


def _turned(w: _Layout, steering: Array | None) -> Array:
    """Return beta of the wheels, (…, n), the steered ones turned."""
    if steering is None:
        return w.beta
    beta = np.broadcast_to(w.beta, (*steering.shape[:-1], len(w.beta))).copy()
    beta[..., w.steered] = steering
    return beta


def _body_twist(wheels: Sequence[Wheel], rates: Array, steering: Array | None) -> Array:
    """Return `forward` in the body frame.

    A steered wheel's two rows are those at beta = 0 turned by beta. So one inverse, that at
    beta = 0, serves every steering; each wheel's speed is split over its two rows instead.
    """
    driven, held = _layout(wheels, DRIVEN), _layout(wheels, HELD)
    k, m = len(driven.l), len(held.l)
    steering = _layout(wheels, ("steered",)).beta if steering is None else steering
    speeds = np.zeros((*np.broadcast_shapes(rates.shape[:-1], steering.shape[:-1]), k + m))
    along, across = speeds[..., :k], speeds[..., k:]
    along[...] = rates * driven.per_radian
    across[..., held.steered] = along[..., driven.steered] * np.sin(steering)
    along[..., driven.steered] *= np.cos(steering)
    return np.asarray(speeds @ _left_inverse(wheels).T)


@lru_cache
def _left_inverse(wheels: Sequence[Wheel]) -> Array:
    """Return the matrix (3, k + m) from the speeds of all rows at beta = 0 to the twist."""
    ahead = np.zeros(len(_layout(wheels, ("steered",)).l))
    matrix = np.concatenate([rows(wheels, ahead) for rows in (rolling, sliding)])
    units = _units(wheels)
    rank = np.linalg.matrix_rank(matrix / units, tol=DEPENDENT)
    if rank < 3:
        raise SingularError(f"the wheels determine {rank} of the 3 parts of the motion only")
    return np.linalg.pinv(matrix / units) / units[:, None]


def _units(wheels: Sequence[Wheel]) -> Array:
    """Return what to divide a row by: the largest l makes its third entry comparable."""
    return np.array([1.0, 1.0, max((w.l for w in wheels), default=0.0) or 1.0])
