"""For each public function arguments that work, and what each of them is: one table for tests and
benchmarks. A function without a row fails `test_bad_input.py::test_no_function_is_left_out`.
"""

import importlib
import inspect
from dataclasses import dataclass

import numpy as np

import robokin

MODULES = [name for name in robokin.__all__ if name != "errors"]

# The kinds of argument


@dataclass(frozen=True)
class Arg:
    """An argument: its kind, a value that works, and the shape of one item."""

    kind: str
    value: object
    core: tuple = ()

    @property
    def good(self):
        return self.value() if callable(self.value) else self.value


def data(value, core=None):
    """Poses, angles, rates …: NaN and infinity go into what depends on them."""
    return Arg("data", value, np.shape(value) if core is None else core)


def steps(value):
    """Data of a path, (…, N) with any N: a NaN makes the path NaN from that step on."""
    return Arg("steps", value, np.shape(value))


def matrix(value):
    """Data that cannot be any numbers: rotations and poses."""
    return Arg("matrix", value, np.shape(value))


def ticks(value):
    """Data in whole numbers."""
    return Arg("ticks", value)


def tick_steps(value):
    """Data of a path in whole numbers."""
    return Arg("tick steps", value, np.shape(value))


def length(value, core=()):
    """A parameter that must be positive and finite."""
    return Arg("length", value, core)


def not_negative(value):
    """A parameter that may be zero."""
    return Arg("not negative", value)


def number(value, core=()):
    """A parameter that may be any finite number."""
    return Arg("number", value, core)


def bits(value):
    """A parameter that is a small whole number."""
    return Arg("bits", value)


def name(value):
    """One of a few names."""
    return Arg("name", value)


def frame(value):
    """The name of a frame in a graph: any string."""
    return Arg("frame", value)


def wheels(make):
    """A list of wheels."""
    return Arg("wheels", lambda: make(importlib.import_module("robokin.wheels")))


DATA = ("data", "steps", "matrix", "ticks", "tick steps")
STEPS = ("steps", "tick steps")
PARAMETERS = ("length", "not negative", "number", "bits")


@dataclass(frozen=True)
class Row:
    """A function: the shape of each of its results for one item, and its arguments by name."""

    results: list
    args: dict
    batches: bool = True  # do the parameters broadcast with the data?
    nan_beside: bool = False  # does a NaN step spoil the results on both sides of it only?
    limit_at_infinity: tuple = ()  # arguments whose infinity has finite results: arctan(inf)

    @property
    def good(self):
        return {key: arg.good for key, arg in self.args.items()}

    def having(self, *kinds):
        return [key for key, arg in self.args.items() if arg.kind in kinds]


def row(results, batches=True, nan_beside=False, limit_at_infinity=(), **args):
    return Row(results, args, batches, nan_beside, limit_at_infinity)


# The table

POSE, TWIST, POINT, ANGLES = [0.3, -0.2, 0.4], [0.5, 0.1, -0.3], [0.3, 0.2, 0.1], [0.3, 0.5, -0.7]
TURNED = [[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]  # exercise 2
SE2 = [[0.6, -0.8, 2.0], [0.8, 0.6, -1.0], [0.0, 0.0, 1.0]]
SE3 = [[0.0, 0.0, 1.0, 2.0], [-1.0, 0.0, 0.0, 3.0], [0.0, -1.0, 0.0, 4.0], [0.0, 0.0, 0.0, 1.0]]
THREE = [0.4, 0.3, 0.1]
METHOD = name("exact")
RAISE_OR_NAN = name("nan")
LINKS = {"a2": length(0.4), "a3": length(0.3), "d1": number(0.1)}
WHEELS = {"wheel_radius": length(0.03), "wheel_distance": length(0.1)}
CAR = {"wheelbase": length(2.5), "track": length(1.5)}
ENCODER = {"ticks_per_turn": length(1000), **WHEELS}
TICKS = {"ticks_left": tick_steps([3, 5, -2, 4]), "ticks_right": tick_steps([4, 1, 2, 7])}
SPOKE = {"l": not_negative(0.2), "alpha": number(0.3)}
SEQ = name("ZYX")
OMNI = wheels(lambda w: w.omni_robot(0.2, 0.05))
CAR_WHEELS = wheels(
    lambda w: [
        w.fixed(0.2, np.pi / 2, 0, 0.05),
        w.fixed(0.2, -np.pi / 2, np.pi, 0.05),
        w.steered(0.3, 0, np.pi / 2, 0.05),
    ]
)

TABLE = {
    "motion.wrap_angle": row([()], angle=data(0.3)),
    "motion.to_world": row([(3,)], theta=data(0.3), twist=data(TWIST)),
    "motion.to_body": row([(3,)], theta=data(0.3), twist=data(TWIST)),
    "motion.arc_step": row([(3,)], pose=data(POSE), v=data(0.5), omega=data(0.2), dt=number(0.1)),
    "motion.move": row([(3,)], pose=data(POSE), twist=data(TWIST), dt=number(0.1)),
    "motion.path": row(
        [(5, 3)],
        pose=data(POSE),
        v=steps([1.0, 0.5, -1.0, 2.0]),
        omega=steps([0.3, -0.2, 0.0, 1.0]),
        dt=number([0.1, 0.2, 0.1, 0.3], (4,)),
        method=METHOD,
    ),
    "motion.icr": row(
        [(2,)], limit_at_infinity=("omega",), pose=data(POSE), v=data(0.5), omega=data(0.2)
    ),
    "frames.se2": row([(3, 3)], x=data(1.0), y=data(2.0), theta=data(0.3)),
    "frames.se3": row([(4, 4)], rotation=matrix(TURNED), position=data(POINT)),
    "frames.pose": row([(3,)], T=matrix(SE2)),
    "frames.dh": row([(4, 4)], theta=data(0.3), d=data(0.1), a=data(0.4), alpha=data(-0.7)),
    "frames.inverse": row([(3, 3)], T=matrix(SE2)),
    "frames.inverse in space": row([(4, 4)], T=matrix(SE3)),
    "frames.compose": row([(3, 3)], first=matrix(SE2), second=matrix(SE2)),
    "frames.compose in space": row([(4, 4)], first=matrix(SE3), second=matrix(SE3)),
    "frames.transform": row([(2,)], T=matrix(SE2), points=data([0.3, 0.4])),
    "frames.transform in space": row([(3,)], T=matrix(SE3), points=data(POINT)),
    "frames.check_rotation": row(None, False, R=matrix(TURNED), tol=length(1e-9)),
    "frames.FrameGraph.add": row(None, a=frame("d"), b=frame("e"), T_ab=matrix(SE2)),
    "frames.FrameGraph.get": row([(3, 3)], a=frame("b"), b=frame("d")),
    "frames.FrameGraph.path": row(None, a=frame("b"), b=frame("d")),
    "euler.to_matrix": row([(3, 3)], seq=SEQ, angles=data(ANGLES)),
    "euler.from_matrix": row([(3,)], seq=SEQ, R=matrix(TURNED)),
    "euler.solutions": row([(2, 3)], seq=SEQ, R=matrix(TURNED)),
    "euler.is_locked": row([()], seq=SEQ, R=matrix(TURNED), tol=length(1e-9)),
    "euler.steps": row([(4, 3, 3)], seq=SEQ, angles=data(ANGLES)),
    "euler.about": row([(3, 3)], axis=data(POINT), angle=data(0.3)),
    "euler.axis_angle": row([(3,), ()], R=matrix(TURNED)),
    "elbow_arm.forward": row([(3,)], theta=data(ANGLES), **LINKS),
    "elbow_arm.inverse": row([(4, 3)], p=data(POINT), **LINKS, unreachable=RAISE_OR_NAN),
    "elbow_arm.joint_positions": row([(4, 3)], theta=data(ANGLES), **LINKS),
    "elbow_arm.reach": row([(), ()], a2=length(0.4), a3=length(0.3)),
    "elbow_arm.nearest_reachable": row([(3,)], p=data(POINT), **LINKS),
    "elbow_arm.on_base_axis": row([()], p=data(POINT), tol=length(1e-9)),
    "differential_drive.body_twist": row(
        [(3,)], rate_left=data(1.0), rate_right=data(2.0), **WHEELS
    ),
    "differential_drive.turning_radius": row(
        [()], rate_left=data(1.0), rate_right=data(2.0), wheel_distance=length(0.1)
    ),
    "differential_drive.wheel_rates": row([(2,)], v=data(0.5), omega=data(0.2), **WHEELS),
    "bicycle.equivalent_steering": row([()], alpha_left=data(0.3), alpha_right=data(0.2)),
    "bicycle.ackermann": row([(2,)], phi=data(0.3), **CAR),
    "bicycle.turning_radius": row([()], phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.corner_cut": row([()], phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.lane_width": row([()], phi=data(0.3), **CAR),
    "bicycle.ackermann_error": row([()], alpha_left=data(0.3), alpha_right=data(0.2), **CAR),
    "bicycle.body_twist": row([(3,)], v=data(1.0), phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.front_twist": row([(3,)], v=data(1.0), phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.path": row(
        [(5, 3)],
        pose=data(POSE),
        v=steps([1.0, 0.5, -1.0, 2.0]),
        phi=steps([0.3, -0.2, 0.0, 1.0]),
        wheelbase=length(2.5),
        dt=number([0.1, 0.2, 0.1, 0.3], (4,)),
        method=METHOD,
    ),
    "wheels.fixed": row(None, False, **SPOKE, beta=number(0.1), radius=length(0.05)),
    "wheels.steered": row(None, False, **SPOKE, beta=number(0.1), radius=length(0.05)),
    "wheels.castor": row(
        None, False, **SPOKE, beta=number(0.1), radius=length(0.05), d=number(0.02)
    ),
    "wheels.swedish": row(
        None, False, **SPOKE, beta=number(0.1), radius=length(0.05), gamma=number(0.7)
    ),
    "wheels.spherical": row(None, False, **SPOKE, radius=length(0.05)),
    "wheels.omni_robot": row(
        None, False, l=not_negative(0.2), radius=length(0.05), angles=number([0.0, 2.1, 4.2], (3,))
    ),
    "wheels.rolling": row([(3, 3)], wheels=CAR_WHEELS, steering=data([1.4])),
    "wheels.rolling_rates": row([(3, 3)], wheels=OMNI),
    "wheels.sliding": row([(3, 3)], wheels=CAR_WHEELS, steering=data([1.4])),
    "wheels.forward": row(
        [(3,)], wheels=CAR_WHEELS, rates=data(ANGLES), steering=data([1.4]), theta=data(0.3)
    ),
    "wheels.slip": row([(6,)], wheels=CAR_WHEELS, rates=data(ANGLES), steering=data([1.4])),
    "wheels.inverse": row(
        [(3,)],
        wheels=CAR_WHEELS,
        twist=data([0.5, 0.0, 0.0]),
        steering=data([np.pi / 2]),
        theta=data(0.0),
        slipping=RAISE_OR_NAN,
    ),
    "wheels.mobility": row(None, wheels=OMNI),
    "odometry.travel": row(
        [()], ticks=ticks(5), ticks_per_turn=length(1000), wheel_radius=length(0.03)
    ),
    "odometry.unwrap_counter": row(
        [(4,)], counts=tick_steps([250, 3, 7, 254, 1]), bits=bits(8), nan_beside=True
    ),
    "odometry.path": row([(5, 3)], **TICKS, **ENCODER, pose=data(POSE), method=METHOD),
    "odometry.velocity": row(
        [(), ()], ticks_left=ticks(5), ticks_right=ticks(7), dt=length(0.1), **ENCODER
    ),
    "odometry.covariance": row(
        [(5, 3, 3)],
        **TICKS,
        **ENCODER,
        noise=not_negative(0.01),
        pose=data(POSE),
        start=data([[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.2]]),
    ),
    "odometry.ellipse": row(
        [(2,), (2, 2)], limit_at_infinity=("covariance",), covariance=data([[0.5, 0.3], [0.3, 0.4]])
    ),
    "odometry.umbmark": row(
        [(), ()],
        limit_at_infinity=("ends_cw", "ends_ccw"),
        ends_cw=data([[0.1, 0.2], [0.2, 0.1], [0.1, 0.3]]),
        ends_ccw=data([[0.1, -0.2], [0.2, 0.1]]),
        side=length(4.0),
        wheel_distance=length(0.1),
    ),
    "planar_arm.forward": row([(3,)], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "planar_arm.joint_positions": row([(4, 2)], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "planar_arm.jacobian": row([(3, 3)], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "planar_arm.velocity": row(
        [(3,)], theta=data(ANGLES), rates=data(TWIST), lengths=length(THREE, (3,))
    ),
    "planar_arm.joint_rates": row(
        [(3,)],
        theta=data(ANGLES),
        twist=data(TWIST),
        lengths=length(THREE, (3,)),
        damping=not_negative(0.1),
        singular=RAISE_OR_NAN,
    ),
    "planar_arm.joint_rates undamped": row(
        [(3,)],
        theta=data(ANGLES),
        twist=data(TWIST),
        lengths=length(THREE, (3,)),
        singular=RAISE_OR_NAN,
    ),
    "planar_arm.inverse": row(
        [(2, 3)], pose=data(POSE), lengths=length(THREE, (3,)), unreachable=RAISE_OR_NAN
    ),
    "planar_arm.manipulability": row([()], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "planar_arm.ellipse": row([(2,), (2, 2)], theta=data(ANGLES), lengths=length(THREE, (3,))),
}


def public_functions():
    """The labels of all functions of the package, and of the methods of its classes."""
    for module in MODULES:
        namespace = importlib.import_module(f"robokin.{module}")
        for name in namespace.__all__:
            member = getattr(namespace, name)
            if not inspect.isclass(member):
                yield f"{module}.{name}"
            elif not issubclass(member, tuple):
                for method, _ in inspect.getmembers(member, inspect.isfunction):
                    if not method.startswith("_"):
                        yield f"{module}.{name}.{method}"


def find(label):
    """The function of a row, without its remark; a method comes with a graph of two frames."""
    module, *names = label.split()[0].split(".")
    found = importlib.import_module(f"robokin.{module}")
    for name in names:
        found = getattr(found, name)
        if name == "FrameGraph":
            found = found()
            found.add("d", "b", SE2)
    return found


def bind(label, **changed):
    """The function of a row and its arguments, positional and named, some of them changed."""
    arguments = {**TABLE[label].good, **changed}
    if "first" in arguments:  # compose takes any number of transforms, without names
        return find(label), tuple(arguments.values()), {}
    return find(label), (), arguments
