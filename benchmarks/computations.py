"""The computations of the table: for each of them robokin and its peers on the same inputs.

Each function makes the inputs for n items and returns a `Row`. Peers get their inputs in the form
that suits them best, made before the clock starts, and may stop at their own form of the result.
A `*` marks a peer without a function for batches: it is called once for each item, and its results
are put into one array.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pinocchio as pin
import roboticstoolbox as rtb
import spatialmath
from pinocchio.rpy import matrixToRpy, rpyToMatrix
from pytransform3d.batch_rotations import active_matrices_from_intrinsic_euler_angles
from pytransform3d.rotations import euler_from_matrix
from pytransform3d.trajectories import concat_many_to_many, transforms_from_exponential_coordinates
from scipy.spatial.transform import RigidTransform, Rotation
from spatialmath.base import rpy2r, tr2rpy, trexp2

import robokin

A2, A3, D1 = 0.4, 0.3, 0.1  # the elbow arm
LINKS = (0.4, 0.3, 0.1)  # the planar arm
RADIUS, DISTANCE, WHEELBASE, TICKS, DT = 0.05, 0.3, 2.5, 1000, 0.01


class Row(NamedTuple):
    calls: dict[str, Callable[[], Any]]  # robokin first
    distance: Callable[[Any, Any], float]  # between robokin's result and a peer's
    tolerance: float = 1e-12


# How far results are apart


def largest(ours, theirs):
    return np.abs(ours - np.reshape(theirs, ours.shape)).max()


def on_the_circle(ours, theirs):
    return np.abs(np.exp(1j * ours) - np.exp(1j * theirs)).max()


def one_of_the_branches(ours, theirs):
    off = np.abs(np.exp(1j * ours) - np.exp(1j * theirs)[:, None, :])
    return off.max(axis=-1).min(axis=-1).max()


def poses(ours, theirs):
    """Poses [x, y, theta]; theirs may also be [x, y, cos, sin] or matrices."""
    if isinstance(theirs, RigidTransform):
        theirs = theirs.as_matrix()
    if theirs.ndim == 3:
        theirs = np.concatenate([theirs[:, :2, -1], theirs[:, :2, 0]], axis=-1)
    if theirs.shape[-1] == 3:
        theirs = with_direction(theirs)
    return largest(with_direction(ours), theirs)


def with_direction(pose):
    """Poses [x, y, theta] as [x, y, cos, sin]."""
    x, y, theta = pose.T
    return np.stack([x, y, np.cos(theta), np.sin(theta)], axis=-1)


# What the peers need to be told of the robots


def each(function, items, shape):
    """A peer called once for each item, its results in one array of this shape."""
    out = np.empty(shape)
    for i, item in enumerate(items):
        out[i] = function(item)
    return out


def path(start, steps, step):
    """All places on the way, each made from the one before."""
    out = np.empty((len(steps) + 1, len(start)))
    out[0] = start
    for i, item in enumerate(steps):
        out[i + 1] = step(out[i], item)
    return out


def pin_arm(joints, hand):
    """The model, its data and the hand's frame; x and z of a joint are seen from the last one."""
    model, last = pin.Model(), 0
    for joint, x, z in joints:
        place = pin.SE3(np.eye(3), np.array([x, 0.0, z]))
        last = model.addJoint(last, joint, place, f"joint{last}")
    place = pin.SE3(np.eye(3), np.array([hand, 0.0, 0.0]))
    frame = model.addFrame(pin.Frame("hand", last, 0, place, pin.FrameType.OP_FRAME))
    return model, model.createData(), frame


TURN, RAISE = pin.JointModelRZ(), pin.JointModelRevoluteUnaligned(np.array([0.0, -1.0, 0.0]))
PIN_ELBOW = pin_arm([(TURN, 0, D1), (RAISE, 0, 0), (RAISE, A2, 0)], A3)
PIN_PLANAR = pin_arm([(TURN, x, 0) for x in (0, *LINKS[:2])], LINKS[2])
PIN_PLANE = pin.Model()
PIN_PLANE.addJoint(0, pin.JointModelPlanar(), pin.SE3.Identity(), "plane")
ET = rtb.ET
RTB_ELBOW = rtb.ETS([ET.tz(D1), ET.Rz(), ET.Ry(flip=True), ET.tx(A2), ET.Ry(flip=True), ET.tx(A3)])
RTB_PLANAR = rtb.ETS([et for length in LINKS for et in (ET.Rz(), ET.tx(length))])
RTB_DRIVE = rtb.DiffSteer(W=DISTANCE)


def pin_positions(arm, theta):
    model, data, frame = arm

    def position(q):
        pin.framesForwardKinematics(model, data, q)
        return data.oMf[frame].translation

    return each(position, theta, theta.shape)


def pin_jacobians(theta):
    (model, data, frame), world = PIN_PLANAR, pin.LOCAL_WORLD_ALIGNED
    compute = pin.computeFrameJacobian
    return each(lambda q: compute(model, data, q, frame, world), theta, (len(theta), 6, 3))


def rtb_jacobians(theta):
    return each(RTB_PLANAR.jacob0, theta, (len(theta), 6, 3))


def pin_path(moves):
    """Exact arcs; moves are [forward, left, turn], places [x, y, cos, sin]."""
    origin = np.array([0.0, 0.0, 1.0, 0.0])
    return path(origin, moves, lambda place, move: pin.integrate(PIN_PLANE, place, move))


# The computations


def elbow_inverse(n):
    rng = np.random.default_rng(2)
    azimuth, elevation, distance = rng.uniform([[-3], [-1], [0.2]], [[3], [1], [0.65]], (3, n))
    r = distance * np.cos(elevation)  # clear of the base axis, of full stretch and of the fold
    height = D1 + distance * np.sin(elevation)
    p = np.stack([r * np.cos(azimuth), r * np.sin(azimuth), height], axis=-1)
    targets = robokin.frames.se3(np.eye(3), p)
    only_position = np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    options = {"mask": only_position, "joint_limits": False, "k": 0.1, "tol": 1e-14}
    solve = RTB_ELBOW.ik_LM
    calls = {
        "robokin": lambda: robokin.elbow_arm.inverse(p, A2, A3, D1),
        "roboticstoolbox*": lambda: each(lambda T: solve(T, **options).q, targets, (n, 3)),
    }
    return Row(calls, one_of_the_branches, tolerance=1e-4)


def elbow_forward(n):
    theta = np.random.default_rng(3).uniform(-3, 3, (n, 3))
    calls = {
        "robokin": lambda: robokin.elbow_arm.forward(theta, A2, A3, D1),
        "roboticstoolbox": lambda: RTB_ELBOW.eval(theta)[..., :3, 3],
        "pin*": lambda: pin_positions(PIN_ELBOW, theta),
    }
    return Row(calls, largest)


def angles_to_matrix(n):
    """Yaw, pitch and roll: every peer knows this sequence."""
    angles = np.random.default_rng(4).uniform(-1.5, 1.5, (n, 3))
    reverse = angles[:, ::-1].copy()
    calls = {
        "robokin": lambda: robokin.euler.to_matrix("ZYX", angles),
        "scipy": lambda: Rotation.from_euler("ZYX", angles).as_matrix(),
        "pytransform3d": lambda: active_matrices_from_intrinsic_euler_angles(2, 1, 0, angles),
        "spatialmath*": lambda: each(rpy2r, reverse, (n, 3, 3)),
        "pin*": lambda: each(rpyToMatrix, reverse, (n, 3, 3)),
    }
    return Row(calls, largest)


def matrix_to_angles(n):
    R = robokin.euler.to_matrix("ZYX", np.random.default_rng(5).uniform(-1.5, 1.5, (n, 3)))
    pytransform3d = lambda matrix: euler_from_matrix(matrix, 2, 1, 0, False)  # noqa: E731
    calls = {
        "robokin": lambda: robokin.euler.from_matrix("ZYX", R),
        "scipy": lambda: Rotation.from_matrix(R).as_euler("ZYX"),
        "scipy-unchecked": lambda: Rotation.from_matrix(R, assume_valid=True).as_euler("ZYX"),
        "pytransform3d*": lambda: each(pytransform3d, R, (n, 3)),
        "spatialmath*": lambda: each(tr2rpy, R, (n, 3))[:, ::-1],
        "pin*": lambda: each(matrixToRpy, R, (n, 3))[:, ::-1],
    }
    return Row(calls, on_the_circle, tolerance=1e-11)


def chain(n):
    rng = np.random.default_rng(6)
    rotations = robokin.euler.to_matrix("ZYX", rng.uniform(-1.5, 1.5, (3, n, 3)))
    transforms = A, B, C = robokin.frames.se3(rotations, rng.uniform(-1, 1, (3, n, 3)))
    triples = list(zip(A, B, C, strict=True))

    def product(convert, matrices):
        a, b, c = map(convert, matrices)
        return a * b * c

    to_spatialmath = partial(spatialmath.SE3, check=False)
    calls = {
        "robokin": lambda: robokin.frames.compose(A, B, C),
        "scipy": lambda: product(RigidTransform.from_matrix, transforms).as_matrix(),
        "pytransform3d": lambda: concat_many_to_many(C, concat_many_to_many(B, A)),
        "spatialmath*": lambda: product(to_spatialmath, map(list, transforms)).data,
        "pin*": lambda: each(lambda three: product(pin.SE3, three).homogeneous, triples, A.shape),
    }
    return Row(calls, largest)


def drive(n):
    left, right = np.random.default_rng(7).uniform(-10, 10, (2, n))
    speeds = RADIUS * np.stack([left, right], axis=-1)
    deriv = lambda u: RTB_DRIVE.deriv((0.0, 0.0, 0.0), u, limits=False)  # noqa: E731
    calls = {
        "robokin": lambda: robokin.differential_drive.body_twist(left, right, RADIUS, DISTANCE),
        "roboticstoolbox*": lambda: each(deriv, speeds, (n, 3)),
    }
    return Row(calls, largest)


def arc(n):
    rng = np.random.default_rng(8)
    start, (v, omega) = rng.uniform(-3, 3, (n, 3)), rng.uniform(-1, 1, (2, n))
    zero = np.zeros(n)
    moves = np.stack([v, zero, omega], axis=-1)
    screws = np.stack([zero, zero, omega, v, zero, zero], axis=-1)
    starts, plane = with_direction(start), robokin.frames.se2(*start.T)
    turned = robokin.euler.from_axis_angle([0, 0, 1], start[:, 2])
    T = robokin.frames.se3(turned, np.stack([start[:, 0], start[:, 1], zero], axis=-1))
    transforms = RigidTransform.from_matrix(T)
    pairs = list(zip(starts, moves, strict=True))
    calls = {
        "robokin": lambda: robokin.motion.arc_step(start, v, omega, 1.0),
        "scipy": lambda: transforms * RigidTransform.from_exp_coords(screws),
        "pytransform3d": lambda: concat_many_to_many(
            transforms_from_exponential_coordinates(screws), T
        ),
        "spatialmath*": lambda: plane @ each(trexp2, moves, plane.shape),
        "pin*": lambda: each(lambda pair: pin.integrate(PIN_PLANE, *pair), pairs, starts.shape),
    }
    return Row(calls, poses, tolerance=1e-11)


def path_row(ours, method, moves, steps, step):
    """Exact arcs beside Pinocchio's, steps with the old heading beside the robotics toolbox's."""
    if method == "exact":
        peers = {"pin*": lambda: pin_path(moves)}
    else:
        peers = {"roboticstoolbox*": lambda: path(np.zeros(3), steps, step)}
    return Row({"robokin": ours, **peers}, poses, tolerance=1e-8)


def bicycle_path(n, method):
    rng = np.random.default_rng(9)
    v, phi = rng.uniform(0, 2, n), rng.uniform(-0.5, 0.5, n)
    controls = np.stack([v, phi], axis=-1)
    moves = DT * np.stack([v, 0 * v, v * np.tan(phi) / WHEELBASE], axis=-1)
    speed = rtb.Bicycle(L=WHEELBASE).deriv
    ours = partial(robokin.bicycle.path, [0, 0, 0], v, phi, WHEELBASE, DT, method)
    return path_row(ours, method, moves, controls, lambda x, u: x + DT * speed(x, u, limits=False))


def odometry_path(n, method):
    left, right = np.random.default_rng(10).integers(-5, 20, (2, n))
    per_tick = 2 * np.pi * RADIUS / TICKS
    length, turn = 0.5 * per_tick * (right + left), per_tick / DISTANCE * (right - left)
    moves = np.stack([length, 0 * length, turn], axis=-1)
    steps = list(zip(length, turn, strict=True))
    ours = partial(robokin.odometry.path, left, right, TICKS, RADIUS, DISTANCE, method=method)
    return path_row(ours, method, moves, steps, RTB_DRIVE.f)


def planar_forward(n):
    theta = np.random.default_rng(11).uniform(-3, 3, (n, 3))
    calls = {
        "robokin": lambda: robokin.planar_arm.forward(theta, LINKS),
        "roboticstoolbox": lambda: RTB_PLANAR.eval(theta)[..., :2, 3],
        "pin*": lambda: pin_positions(PIN_PLANAR, theta)[:, :2],
    }
    return Row(calls, lambda ours, theirs: largest(ours[:, :2], theirs))


def jacobian(n):
    theta = np.random.default_rng(12).uniform(-3, 3, (n, 3))
    calls = {
        "robokin": lambda: robokin.planar_arm.jacobian(theta, LINKS),
        "roboticstoolbox*": lambda: rtb_jacobians(theta),
        "pin*": lambda: pin_jacobians(theta),
    }
    return Row(calls, lambda ours, theirs: largest(ours, theirs[:, [0, 1, 5]]))


def joint_rates(n):
    rng = np.random.default_rng(13)
    theta, twist = rng.uniform(-3, 3, (n, 3)), rng.uniform(-1, 1, (n, 3))
    theta[:, 1] = rng.uniform(0.3, 2.8, n)

    def solved(jacobians):
        return np.linalg.solve(jacobians[:, [0, 1, 5]], twist[..., None])[..., 0]

    calls = {
        "robokin": lambda: robokin.planar_arm.joint_rates(theta, twist, LINKS),
        "roboticstoolbox*": lambda: solved(rtb_jacobians(theta)),
        "pin*": lambda: solved(pin_jacobians(theta)),
    }
    return Row(calls, largest, tolerance=1e-10)


COMPUTATIONS = {
    "IK, four branches": elbow_inverse,
    "FK, three-joint arm": elbow_forward,
    "angles → matrix": angles_to_matrix,
    "matrix → angles": matrix_to_angles,
    "chain of three, SE(3)": chain,
    "differential drive": drive,
    "exact arc": arc,
    "bicycle path, exact arcs": partial(bicycle_path, method="exact"),
    "bicycle path, old heading": partial(bicycle_path, method="start"),
    "odometry path, exact arcs": partial(odometry_path, method="exact"),
    "odometry path, old heading": partial(odometry_path, method="start"),
    "FK, three links": planar_forward,
    "Jacobian, three links": jacobian,
    "joint rates, three links": joint_rates,
}
