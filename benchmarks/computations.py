"""The rows of the table: for each computation robokin, its peers and the limit.

Each function makes the inputs for n items and returns a `Row`. Peers get their inputs in the form
that suits them best, made before the clock starts, and may stop at their own form of the result.
A `*` marks a peer without a function for batches: it is called once for each item, and its results
are put into one array.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np

from robokin import (
    bicycle,
    differential_drive,
    elbow_arm,
    euler,
    frames,
    motion,
    odometry,
    planar_arm,
)

Array = np.ndarray
Call = Callable[[], Any]


class Missing:
    """Stands for a library that cannot be imported: says so when it is used."""

    def __init__(self, error: ImportError) -> None:
        self.error = error

    def __getattr__(self, name: str) -> Any:
        raise ImportError(str(self.error))


def library(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError as error:
        return Missing(error)


pin, pin_rpy = library("pinocchio"), library("pinocchio.rpy")
rtb = library("roboticstoolbox")
scipy_transform = library("scipy.spatial.transform")
spatialmath, spatialmath_base = library("spatialmath"), library("spatialmath.base")
pt3d_batch = library("pytransform3d.batch_rotations")
pt3d_rotations = library("pytransform3d.rotations")
pt3d_trajectories = library("pytransform3d.trajectories")

A2, A3, D1 = 0.4, 0.3, 0.1  # the elbow arm
LINKS = (0.4, 0.3, 0.1)  # the planar arm
RADIUS, DISTANCE, WHEELBASE, TICKS, DT = 0.05, 0.3, 2.5, 1000, 0.01


@dataclass
class Row:
    ours: Call
    peers: dict[str, Call]
    agree: Callable[[Any, Any], float]  # how far a peer's result is from ours
    tolerance: float = 1e-12


@dataclass(frozen=True)
class Computation:
    """A name, how to make its row, and its goals at the largest number of items."""

    name: str
    row: Callable[[int], Row]
    peer_goal: float
    bare: dict[str, int] = field(default_factory=dict)  # trigonometric calls, n numbers each
    stores: int = 0  # numbers stored for each item
    copies: tuple[int, int] | None = None  # instead: so many arrays of so many numbers an item
    limit_goal: float = 2.0

    def limit(self, n: int) -> Call:
        """What a bare NumPy program must do at least, on inputs that lie side by side."""
        rng = np.random.default_rng(1)
        if self.copies:
            arrays = [rng.normal(size=(n, self.copies[1])) for _ in range(self.copies[0])]
            return lambda: [array.copy() for array in arrays]
        x, y = rng.uniform(-3, 3, (2, n))
        functions = [getattr(np, f) for f, count in self.bare.items() for _ in range(count)]
        arguments = [(y, x) if f is np.arctan2 else (x,) for f in functions]

        def bare() -> Array:
            out = np.empty((n, self.stores))
            values = [f(*a) for f, a in zip(functions, arguments, strict=True)] or [x]
            for i in range(self.stores):
                out[:, i] = values[i % len(values)]
            return out

        return bare


# How far results are apart


def largest(ours: Array, theirs: Any) -> float:
    return float(np.abs(ours - np.asarray(theirs)).max())


def on_the_circle(ours: Array, theirs: Any) -> float:
    return float(np.abs(np.exp(1j * ours) - np.exp(1j * np.asarray(theirs))).max())


def poses(ours: Array, theirs: Any) -> float:
    """Poses [x, y, theta] with theirs as such, as [x, y, cos, sin] or as matrices."""
    if hasattr(theirs, "as_matrix"):
        theirs = theirs.as_matrix()
    theirs = np.asarray(theirs)
    if theirs.ndim == 3:
        theirs = np.stack([*theirs[:, :2, -1].T, *theirs[:, :2, 0].T], axis=-1)
    if theirs.shape[-1] == 3:
        theirs = np.stack([*theirs[:, :2].T, np.cos(theirs[:, 2]), np.sin(theirs[:, 2])], axis=-1)
    same = [*ours[:, :2].T, np.cos(ours[:, 2]), np.sin(ours[:, 2])]
    return largest(np.stack(same, axis=-1), theirs)


def one_of_the_branches(ours: Array, theirs: Any) -> float:
    off = np.abs(np.exp(1j * ours) - np.exp(1j * np.asarray(theirs))[:, None, :])
    return float(off.max(axis=-1).min(axis=-1).max())


# What the peers need to be told of the robots


def each(items: Iterable[Any], shape: tuple[int, ...], function: Callable[[Any], Any]) -> Array:
    """A peer called once for each item, its results in one array of this shape."""
    out = np.empty(shape)
    for i, item in enumerate(items):
        out[i] = function(item)
    return out


@cache
def rtb_elbow() -> Any:
    ET = rtb.ET
    raised, bent = ET.Ry(flip=True), ET.Ry(flip=True)
    return rtb.ETS([ET.tz(D1), ET.Rz(), raised, ET.tx(A2), bent, ET.tx(A3)])


@cache
def rtb_planar() -> Any:
    return rtb.ETS([et for length in LINKS for et in (rtb.ET.Rz(), rtb.ET.tx(length))])


@cache
def pin_arm(kind: str) -> tuple[Any, Any, int]:
    def shift(*xyz: float) -> Any:
        return pin.SE3(np.eye(3), np.array(xyz, dtype=float))

    turn, raised = pin.JointModelRZ(), pin.JointModelRevoluteUnaligned(np.array([0.0, -1.0, 0.0]))
    if kind == "elbow":
        joints, hand = [(turn, shift(0, 0, D1)), (raised, shift(0, 0, 0))], A3
        joints.append((raised, shift(A2, 0, 0)))
    else:
        joints, hand = [(turn, shift(length, 0, 0)) for length in (0, *LINKS[:2])], LINKS[2]
    model, last = pin.Model(), 0
    for joint, place in joints:
        last = model.addJoint(last, joint, place, f"joint{last}")
    frame = model.addFrame(pin.Frame("hand", last, 0, shift(hand, 0, 0), pin.FrameType.OP_FRAME))
    return model, model.createData(), frame


def pin_positions(kind: str, theta: Array) -> Array:
    model, data, frame = pin_arm(kind)

    def position(q: Array) -> Array:
        pin.framesForwardKinematics(model, data, q)
        return data.oMf[frame].translation

    return each(theta, theta.shape, position)


def pin_jacobians(theta: Array) -> Array:
    (model, data, frame), world = pin_arm("planar"), pin.LOCAL_WORLD_ALIGNED
    compute = pin.computeFrameJacobian
    return each(theta, (len(theta), 6, 3), lambda q: compute(model, data, q, frame, world))


def rtb_jacobians(theta: Array) -> Array:
    return each(theta, (len(theta), 6, 3), rtb_planar().jacob0)


@cache
def pin_plane() -> Any:
    model = pin.Model()
    model.addJoint(0, pin.JointModelPlanar(), pin.SE3.Identity(), "plane")
    return model


def pin_moves(starts: Array, moves: Array) -> Array:
    """Exact arcs: starts as [x, y, cos, sin], moves as [forward, left, turn]."""
    plane, pairs = pin_plane(), zip(starts, moves, strict=True)
    return each(pairs, starts.shape, lambda pair: pin.integrate(plane, *pair))


def path(start: Array, steps: Iterable[Any], step: Callable[[Array, Any], Array]) -> Array:
    """All places on the way, each made from the one before."""
    steps = list(steps)
    out = np.empty((len(steps) + 1, len(start)))
    out[0] = start
    for i, item in enumerate(steps):
        out[i + 1] = step(out[i], item)
    return out


def pin_path(moves: Array) -> Array:
    plane = pin_plane()
    origin = np.array([0.0, 0.0, 1.0, 0.0])
    return path(origin, moves, lambda place, move: pin.integrate(plane, place, move))


# Elbow arm


def elbow_inverse(n: int) -> Row:
    rng = np.random.default_rng(2)
    azimuth, elevation, distance = rng.uniform([[-3], [-1], [0.2]], [[3], [1], [0.65]], (3, n))
    r = distance * np.cos(elevation)  # clear of the base axis, of full stretch and of the fold
    height = D1 + distance * np.sin(elevation)
    p = np.stack([r * np.cos(azimuth), r * np.sin(azimuth), height], axis=-1)
    targets = np.tile(np.eye(4), (n, 1, 1))
    targets[:, :3, 3] = p
    only_position = np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])

    def loop() -> Array:
        solve = rtb_elbow().ik_LM
        options = {"mask": only_position, "joint_limits": False, "k": 0.1, "tol": 1e-14}
        return each(targets, (n, 3), lambda target: solve(target, **options).q)

    ours = lambda: elbow_arm.inverse(p, A2, A3, D1)  # noqa: E731
    return Row(ours, {"roboticstoolbox*": loop}, one_of_the_branches, tolerance=1e-4)


def elbow_forward(n: int) -> Row:
    theta = np.random.default_rng(3).uniform(-3, 3, (n, 3))
    return Row(
        lambda: elbow_arm.forward(theta, A2, A3, D1),
        {
            "roboticstoolbox": lambda: rtb_elbow().eval(theta)[..., :3, 3],
            "pin*": lambda: pin_positions("elbow", theta),
        },
        lambda ours, theirs: largest(ours, np.reshape(theirs, (-1, 3))),
    )


# Euler angles: yaw, pitch and roll, which every peer knows


def angles_to_matrix(n: int) -> Row:
    angles = np.random.default_rng(4).uniform(-1.5, 1.5, (n, 3))
    reverse = angles[:, ::-1].copy()

    def scipy() -> Array:
        return scipy_transform.Rotation.from_euler("ZYX", angles).as_matrix()

    def pytransform3d() -> Array:
        return pt3d_batch.active_matrices_from_intrinsic_euler_angles(2, 1, 0, angles)

    peers = {
        "scipy": scipy,
        "pytransform3d": pytransform3d,
        "spatialmath*": lambda: each(reverse, (n, 3, 3), spatialmath_base.rpy2r),
        "pin*": lambda: each(reverse, (n, 3, 3), pin_rpy.rpyToMatrix),
    }
    return Row(lambda: euler.to_matrix("ZYX", angles), peers, largest)


def matrix_to_angles(n: int) -> Row:
    R = euler.to_matrix("ZYX", np.random.default_rng(5).uniform(-1.5, 1.5, (n, 3)))

    def scipy(unchecked: bool = False) -> Array:
        rotation = scipy_transform.Rotation.from_matrix(R, assume_valid=unchecked)
        return rotation.as_euler("ZYX")

    def pytransform3d() -> Array:
        angles = pt3d_rotations.euler_from_matrix
        return each(R, (n, 3), lambda matrix: angles(matrix, 2, 1, 0, False))

    peers = {
        "scipy": scipy,
        "scipy-unchecked": lambda: scipy(unchecked=True),
        "pytransform3d*": pytransform3d,
        "spatialmath*": lambda: each(R, (n, 3), spatialmath_base.tr2rpy)[:, ::-1],
        "pin*": lambda: each(R, (n, 3), pin_rpy.matrixToRpy)[:, ::-1],
    }
    return Row(lambda: euler.from_matrix("ZYX", R), peers, on_the_circle, tolerance=1e-11)


# Frames


def chain(n: int) -> Row:
    rng = np.random.default_rng(6)
    rotations = euler.to_matrix("ZYX", rng.uniform(-1.5, 1.5, (3, n, 3)))
    A, B, C = frames.se3(rotations, rng.uniform(-1, 1, (3, n, 3)))

    def scipy() -> Array:
        a, b, c = (scipy_transform.RigidTransform.from_matrix(T) for T in (A, B, C))
        return (a * b * c).as_matrix()

    def pytransform3d() -> Array:
        concat = pt3d_trajectories.concat_many_to_many
        return concat(C, concat(B, A))

    def in_spatialmath() -> list[Array]:
        a, b, c = (spatialmath.SE3(list(T), check=False) for T in (A, B, C))
        return (a * b * c).data

    def in_pin() -> Array:
        SE3 = pin.SE3
        product = lambda abc: (SE3(abc[0]) * SE3(abc[1]) * SE3(abc[2])).homogeneous  # noqa: E731
        return each(zip(A, B, C, strict=True), A.shape, product)

    peers = {
        "scipy": scipy,
        "pytransform3d": pytransform3d,
        "spatialmath*": in_spatialmath,
        "pin*": in_pin,
    }
    return Row(lambda: frames.compose(A, B, C), peers, largest)


# Driving


def drive(n: int) -> Row:
    left, right = np.random.default_rng(7).uniform(-10, 10, (2, n))
    speeds = RADIUS * np.stack([left, right], axis=-1)

    def loop() -> Array:
        robot, at_origin = rtb.DiffSteer(W=DISTANCE), (0.0, 0.0, 0.0)
        return each(speeds, (n, 3), lambda u: robot.deriv(at_origin, u, limits=False))

    ours = lambda: differential_drive.body_twist(left, right, RADIUS, DISTANCE)  # noqa: E731
    return Row(ours, {"roboticstoolbox*": loop}, largest)


def arc(n: int) -> Row:
    rng = np.random.default_rng(8)
    start, (v, omega) = rng.uniform(-3, 3, (n, 3)), rng.uniform(-1, 1, (2, n))
    zero = np.zeros(n)
    c, s = np.cos(start[:, 2]), np.sin(start[:, 2])
    starts = np.stack([start[:, 0], start[:, 1], c, s], axis=-1)
    T = np.tile(np.eye(4), (n, 1, 1))
    T[:, 0, 0], T[:, 0, 1], T[:, 1, 0], T[:, 1, 1] = c, -s, s, c
    T[:, :2, 3] = start[:, :2]
    moves = np.stack([v, zero, omega], axis=-1)
    screws = np.stack([zero, zero, omega, v, zero, zero], axis=-1)
    plane = T[:, [0, 1, 3]][:, :, [0, 1, 3]]

    @cache
    def scipy_starts() -> Any:
        return scipy_transform.RigidTransform.from_matrix(T)

    def scipy() -> Any:
        return scipy_starts() * scipy_transform.RigidTransform.from_exp_coords(screws)

    def pytransform3d() -> Array:
        made = pt3d_trajectories.transforms_from_exponential_coordinates(screws)
        return pt3d_trajectories.concat_many_to_many(made, T)

    def in_spatialmath() -> Array:
        return plane @ each(moves, plane.shape, spatialmath_base.trexp2)

    peers = {
        "scipy": scipy,
        "pytransform3d": pytransform3d,
        "spatialmath*": in_spatialmath,
        "pin*": lambda: pin_moves(starts, moves),
    }
    return Row(lambda: motion.arc_step(start, v, omega, 1.0), peers, poses, tolerance=1e-11)


def bicycle_path(n: int, method: str) -> Row:
    rng = np.random.default_rng(9)
    v, phi = rng.uniform(0, 2, n), rng.uniform(-0.5, 0.5, n)
    controls = np.stack([v, phi], axis=-1)
    moves = DT * np.stack([v, 0 * v, v * np.tan(phi) / WHEELBASE], axis=-1)

    def loop() -> Array:
        speed = rtb.Bicycle(L=WHEELBASE).deriv
        return path(np.zeros(3), controls, lambda x, u: x + DT * speed(x, u, limits=False))

    return Row(
        lambda: bicycle.path([0, 0, 0], v, phi, WHEELBASE, DT, method),
        {"pin*": lambda: pin_path(moves)} if method == "exact" else {"roboticstoolbox*": loop},
        poses,
        tolerance=1e-8,
    )


def odometry_path(n: int, method: str) -> Row:
    left, right = np.random.default_rng(10).integers(-5, 20, (2, n))
    per_tick = 2 * np.pi * RADIUS / TICKS
    length, turn = 0.5 * per_tick * (right + left), per_tick / DISTANCE * (right - left)
    moves = np.stack([length, 0 * length, turn], axis=-1)

    def loop() -> Array:
        return path(np.zeros(3), zip(length, turn, strict=True), rtb.DiffSteer(W=DISTANCE).f)

    return Row(
        lambda: odometry.path(left, right, TICKS, RADIUS, DISTANCE, method=method),
        {"pin*": lambda: pin_path(moves)} if method == "exact" else {"roboticstoolbox*": loop},
        poses,
        tolerance=1e-8,
    )


# Planar arm


def planar_forward(n: int) -> Row:
    theta = np.random.default_rng(11).uniform(-3, 3, (n, 3))
    return Row(
        lambda: planar_arm.forward(theta, LINKS),
        {
            "roboticstoolbox": lambda: rtb_planar().eval(theta)[..., :2, 3],
            "pin*": lambda: pin_positions("planar", theta)[:, :2],
        },
        lambda ours, theirs: largest(ours[:, :2], np.reshape(theirs, (-1, 2))),
    )


def jacobian(n: int) -> Row:
    theta = np.random.default_rng(12).uniform(-3, 3, (n, 3))
    return Row(
        lambda: planar_arm.jacobian(theta, LINKS),
        {
            "roboticstoolbox*": lambda: rtb_jacobians(theta),
            "pin*": lambda: pin_jacobians(theta),
        },
        lambda ours, theirs: largest(ours, theirs[:, [0, 1, 5]]),
    )


def joint_rates(n: int) -> Row:
    rng = np.random.default_rng(13)
    theta, twist = rng.uniform(-3, 3, (n, 3)), rng.uniform(-1, 1, (n, 3))
    theta[:, 1] = rng.uniform(0.3, 2.8, n)

    def solved(jacobians: Array) -> Array:
        return np.linalg.solve(jacobians[:, [0, 1, 5]], twist[..., None])[..., 0]

    return Row(
        lambda: planar_arm.joint_rates(theta, twist, LINKS),
        {
            "roboticstoolbox*": lambda: solved(rtb_jacobians(theta)),
            "pin*": lambda: solved(pin_jacobians(theta)),
        },
        largest,
        tolerance=1e-10,
    )


CIRCLE = {"cos": 3, "sin": 3}
COMPUTATIONS = [
    Computation("IK, four branches", elbow_inverse, 0.01, {"arctan2": 4}, stores=12),
    Computation("FK, three-joint arm", elbow_forward, 0.25, CIRCLE, stores=3),
    Computation("angles → matrix", angles_to_matrix, 0.25, CIRCLE, stores=9, limit_goal=2.2),
    Computation("matrix → angles", matrix_to_angles, 0.8, {"arctan2": 3}, 3, limit_goal=2.2),
    Computation("chain of three, SE(3)", chain, 0.5, copies=(4, 16), limit_goal=8.0),
    Computation("differential drive", drive, 0.01, stores=3),
    Computation("exact arc", arc, 0.2, {"cos": 1, "sin": 2}, stores=3),
    Computation(
        "bicycle path, exact arcs",
        lambda n: bicycle_path(n, "exact"),
        0.05,
        {"tan": 1, "cos": 1, "sin": 2},
        stores=3,
    ),
    Computation(
        "bicycle path, old heading",
        lambda n: bicycle_path(n, "start"),
        0.05,
        {"tan": 1, "cos": 1, "sin": 1},
        stores=3,
    ),
    Computation(
        "odometry path, exact arcs",
        lambda n: odometry_path(n, "exact"),
        0.05,
        {"cos": 1, "sin": 2},
        stores=3,
    ),
    Computation(
        "odometry path, old heading",
        lambda n: odometry_path(n, "start"),
        0.05,
        {"cos": 1, "sin": 1},
        stores=3,
    ),
    Computation("FK, three links", planar_forward, 0.25, CIRCLE, stores=3),
    Computation("Jacobian, three links", jacobian, 0.25, CIRCLE, stores=9),
    Computation("joint rates, three links", joint_rates, 0.02, {"cos": 2, "sin": 5}, stores=3),
]
