"""For each public function arguments that work, and what each of them is: for tests and benchmarks.

`TABLE` has a row by the name of each function, or of a class and its method; a remark may follow,
where a function has two rows. `test_bad_input.py` says which are missing.
"""

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from typing import Any

import numpy as np

import robokin
from robokin.frames import FrameGraph
from robokin.wheels import fixed, omni_robot, steered

MODULES = [name for name in robokin.__all__ if name != "errors"]


@dataclass(frozen=True)
class Arg:
    """An argument: its kind, and a value that works, one item of it."""

    kind: str
    value: Any

    @property
    def core(self):
        return () if self.kind in ("name", "frame", "wheels") else np.shape(self.value)


data = partial(Arg, "data")  # poses, angles, rates: NaN and infinity go into what depends on them
steps = partial(Arg, "steps")  # data of a path: a NaN makes the path NaN from that step on
matrix = partial(Arg, "matrix")  # data that cannot be any numbers: rotations and poses
ticks, tick_steps = partial(Arg, "ticks"), partial(Arg, "tick steps")  # data in whole numbers
length = partial(Arg, "length")  # a parameter that must be positive and finite
not_negative, number = partial(Arg, "not negative"), partial(Arg, "number")  # other parameters
bits, modulus = partial(Arg, "bits"), partial(Arg, "modulus")
name = partial(Arg, "name")  # one of a few names
frame = partial(Arg, "frame")  # the name of a frame in a graph: any string
wheels = partial(Arg, "wheels")

DATA = ("data", "steps", "matrix", "ticks", "tick steps")
STEPS = ("steps", "tick steps")
PARAMETERS = ("length", "not negative", "number", "bits", "modulus")


@dataclass(frozen=True)
class Row:
    """A function: the shape of each of its results for one item, and its arguments by name."""

    results: list | None
    args: dict
    batches: bool = True  # do the parameters broadcast with the data?
    nan_beside: bool = False  # does a NaN step spoil the results on both sides of it only?
    limit_at_infinity: tuple = ()  # arguments whose infinity has finite results: arctan(inf)
    bounded: bool = False  # are data refused that are too large to be true?
    positional: bool = False  # is it called without the arguments' names?
    on: Callable[[], Any] | None = None  # makes the object that a method is called on

    def having(self, *kinds):
        return [key for key, arg in self.args.items() if arg.kind in kinds]


def row(*results, batches=True, **args):
    options = {key: args.pop(key) for key in Row.__dataclass_fields__ if key in args}
    return Row([*results] if results != (None,) else None, args, batches, **options)


def graph():
    """A graph of two frames."""
    made = FrameGraph()
    made.add("d", "b", SE2)
    return made


POSE, TWIST, POINT, ANGLES = [0.3, -0.2, 0.4], [0.5, 0.1, -0.3], [0.3, 0.2, 0.1], [0.3, 0.5, -0.7]
TURNED = [[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]  # exercise 2
SE2 = [[0.6, -0.8, 2.0], [0.8, 0.6, -1.0], [0.0, 0.0, 1.0]]
SE3 = [[0.0, 0.0, 1.0, 2.0], [-1.0, 0.0, 0.0, 3.0], [0.0, -1.0, 0.0, 4.0], [0.0, 0.0, 0.0, 1.0]]
START = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.2]]
SPEEDS, TURNS = steps([1.0, 0.5, -1.0, 2.0]), steps([0.3, -0.2, 0.0, 1.0])
TIMES, METHOD = number([0.1, 0.2, 0.1, 0.3]), name("exact")
RAISE_OR_NAN, SEQ = name("nan"), name("ZYX")
ALPHAS = {"alpha_left": data(0.3), "alpha_right": data(0.2)}
CAR = {"wheelbase": length(2.5), "track": length(1.5)}
DRIVE = {"wheel_radius": length(0.03), "wheel_distance": length(0.1)}
ARM = {"a2": length(0.4), "a3": length(0.3), "d1": number(0.1)}
LENGTHS = {"lengths": length([0.4, 0.3, 0.1])}
ENCODER = {"ticks_per_turn": length(1000), **DRIVE}
TICKS = {"ticks_left": tick_steps([3, 5, -2, 4]), "ticks_right": tick_steps([4, 1, 2, 7])}
COUNTS = tick_steps([240, 3, 7, 244, 1])
SPOKE = {"l": not_negative(0.2), "alpha": number(0.3)}
OMNI = wheels(omni_robot(0.2, 0.05))
REAR = [fixed(0.2, np.pi / 2, 0, 0.05), fixed(0.2, -np.pi / 2, np.pi, 0.05)]
STEERED_CAR = {"wheels": wheels([*REAR, steered(0.3, 0, np.pi / 2, 0.05)])}

TABLE = {
    "bicycle.equivalent_steering": row((), **ALPHAS),
    "bicycle.ackermann": row((2,), phi=data(0.3), **CAR),
    "bicycle.turning_radius": row((), phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.corner_cut": row((), phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.lane_width": row((), phi=data(0.3), **CAR),
    "bicycle.ackermann_error": row((), **ALPHAS, **CAR),
    "bicycle.body_twist": row((3,), v=data(1.0), phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.steering": row(
        (), limit_at_infinity=("v", "omega"), v=data(1.0), omega=data(0.3), wheelbase=length(2.5)
    ),
    "bicycle.front_twist": row((3,), v=data(1.0), phi=data(0.3), wheelbase=length(2.5)),
    "bicycle.path": row(
        (5, 3), pose=data(POSE), v=SPEEDS, phi=TURNS, wheelbase=length(2.5), dt=TIMES, method=METHOD
    ),
    "differential_drive.body_twist": row((3,), rate_left=data(1.0), rate_right=data(2.0), **DRIVE),
    "differential_drive.turning_radius": row(
        (), rate_left=data(1.0), rate_right=data(2.0), wheel_distance=length(0.1)
    ),
    "differential_drive.wheel_rates": row((2,), v=data(0.5), omega=data(0.2), **DRIVE),
    "elbow_arm.forward": row((3,), theta=data(ANGLES), **ARM),
    "elbow_arm.inverse": row((4, 3), p=data(POINT), **ARM, unreachable=RAISE_OR_NAN),
    "elbow_arm.joint_positions": row((4, 3), theta=data(ANGLES), **ARM),
    "elbow_arm.reach": row((), (), a2=length(0.4), a3=length(0.3)),
    "elbow_arm.nearest_reachable": row((3,), p=data(POINT), **ARM),
    "elbow_arm.on_base_axis": row((), p=data(POINT), tol=length(1e-9)),
    "euler.to_matrix": row((3, 3), seq=SEQ, angles=data(ANGLES)),
    "euler.from_matrix": row((3,), seq=SEQ, R=matrix(TURNED)),
    "euler.solutions": row((2, 3), seq=SEQ, R=matrix(TURNED)),
    "euler.is_locked": row((), seq=SEQ, R=matrix(TURNED), tol=length(1e-9)),
    "euler.steps": row((4, 3, 3), seq=SEQ, angles=data(ANGLES)),
    "euler.from_axis_angle": row((3, 3), axis=data(POINT), angle=data(0.3)),
    "euler.to_axis_angle": row((3,), (), R=matrix(TURNED)),
    "frames.se2": row((3, 3), x=data(1.0), y=data(2.0), theta=data(0.3)),
    "frames.se3": row((4, 4), rotation=matrix(TURNED), position=data(POINT)),
    "frames.pose": row((3,), T=matrix(SE2)),
    "frames.dh": row((4, 4), theta=data(0.3), d=data(0.1), a=data(0.4), alpha=data(-0.7)),
    "frames.inverse": row((3, 3), T=matrix(SE2)),
    "frames.inverse in space": row((4, 4), T=matrix(SE3)),
    "frames.compose": row((3, 3), positional=True, first=matrix(SE2), second=matrix(SE2)),
    "frames.compose in space": row((4, 4), positional=True, first=matrix(SE3), second=matrix(SE3)),
    "frames.transform": row((2,), T=matrix(SE2), points=data([0.3, 0.4])),
    "frames.transform in space": row((3,), T=matrix(SE3), points=data(POINT)),
    "frames.check_rotation": row(None, batches=False, R=matrix(TURNED), tol=length(1e-9)),
    "frames.FrameGraph.add": row(None, on=graph, a=frame("d"), b=frame("e"), T_ab=matrix(SE2)),
    "frames.FrameGraph.get": row((3, 3), on=graph, a=frame("b"), b=frame("d")),
    "frames.FrameGraph.path": row(None, on=graph, a=frame("b"), b=frame("d")),
    "motion.wrap_angle": row((), angle=data(0.3)),
    "motion.to_world": row((3,), theta=data(0.3), twist=data(TWIST)),
    "motion.to_body": row((3,), theta=data(0.3), twist=data(TWIST)),
    "motion.arc_step": row((3,), pose=data(POSE), v=data(0.5), omega=data(0.2), dt=number(0.1)),
    "motion.move": row((3,), pose=data(POSE), twist=data(TWIST), dt=number(0.1)),
    "motion.path": row((5, 3), pose=data(POSE), v=SPEEDS, omega=TURNS, dt=TIMES, method=METHOD),
    "motion.icr": row(
        (2,), limit_at_infinity=("omega",), pose=data(POSE), v=data(0.5), omega=data(0.2)
    ),
    "odometry.travel": row((), ticks=ticks(5), ticks_per_turn=length(1000), wheel_radius=length(1)),
    "odometry.unwrap_counter": row((4,), counts=COUNTS, bits=bits(8), nan_beside=True),
    "odometry.unwrap_counter of a modulus": row(
        (4,), counts=COUNTS, modulus=modulus(300), nan_beside=True
    ),
    "odometry.path": row((5, 3), **TICKS, **ENCODER, pose=data(POSE), method=METHOD),
    "odometry.velocity": row(
        (), (), ticks_left=ticks(5), ticks_right=ticks(7), dt=not_negative(0.1), **ENCODER
    ),
    "odometry.covariance": row(
        (5, 3, 3), **TICKS, **ENCODER, noise=not_negative(0.01), pose=data(POSE), start=data(START)
    ),
    "odometry.ellipse": row(
        (2,), (2, 2), limit_at_infinity=("covariance",), covariance=data([[0.5, 0.3], [0.3, 0.4]])
    ),
    "odometry.umbmark": row(
        (),
        (),
        bounded=True,
        limit_at_infinity=("ends_cw", "ends_ccw"),
        ends_cw=data([[0.1, 0.2], [0.2, 0.1], [0.1, 0.3]]),
        ends_ccw=data([[0.1, -0.2], [0.2, 0.1]]),
        side=length(4.0),
        wheel_distance=length(0.1),
    ),
    "planar_arm.forward": row((3,), theta=data(ANGLES), **LENGTHS),
    "planar_arm.joint_positions": row((4, 2), theta=data(ANGLES), **LENGTHS),
    "planar_arm.jacobian": row((3, 3), theta=data(ANGLES), **LENGTHS),
    "planar_arm.velocity": row((3,), theta=data(ANGLES), rates=data(TWIST), **LENGTHS),
    "planar_arm.joint_rates": row(
        (3,),
        theta=data(ANGLES),
        twist=data(TWIST),
        **LENGTHS,
        damping=not_negative(0.1),
        singular=RAISE_OR_NAN,
    ),
    "planar_arm.joint_rates undamped": row(
        (3,), theta=data(ANGLES), twist=data(TWIST), **LENGTHS, singular=RAISE_OR_NAN
    ),
    "planar_arm.inverse": row((2, 3), pose=data(POSE), **LENGTHS, unreachable=RAISE_OR_NAN),
    "planar_arm.manipulability": row((), theta=data(ANGLES), **LENGTHS),
    "planar_arm.ellipse": row((2,), (2, 2), theta=data(ANGLES), **LENGTHS),
    "wheels.fixed": row(None, batches=False, **SPOKE, beta=number(0.1), radius=length(0.05)),
    "wheels.steered": row(None, batches=False, **SPOKE, beta=number(0.1), radius=length(0.05)),
    "wheels.castor": row(
        None, batches=False, **SPOKE, beta=number(0.1), radius=length(0.05), d=number(0.02)
    ),
    "wheels.swedish": row(
        None, batches=False, **SPOKE, beta=number(0.1), radius=length(0.05), gamma=number(0.7)
    ),
    "wheels.spherical": row(None, batches=False, **SPOKE, radius=length(0.05)),
    "wheels.omni_robot": row(
        None, batches=False, l=not_negative(0.2), radius=length(0.05), angles=number([0, 2.1, 4.2])
    ),
    "wheels.rolling": row((3, 3), **STEERED_CAR, steering=data([1.4])),
    "wheels.rolling_rates": row((3, 3), wheels=OMNI),
    "wheels.sliding": row((3, 3), **STEERED_CAR, steering=data([1.4])),
    "wheels.forward": row(
        (3,), **STEERED_CAR, rates=data(ANGLES), steering=data([1.4]), theta=data(0.3)
    ),
    "wheels.slip": row((6,), **STEERED_CAR, rates=data(ANGLES), steering=data([1.4])),
    "wheels.inverse": row(
        (3,),
        **STEERED_CAR,
        twist=data([0.5, 0.0, 0.0]),
        steering=data([np.pi / 2]),
        theta=data(0.0),
        slipping=RAISE_OR_NAN,
    ),
    "wheels.mobility": row(None, wheels=OMNI),
}


def public_functions(module):
    """The names of a module's functions, and of the methods of its classes."""
    namespace = import_module(f"robokin.{module}")
    for name in namespace.__all__:
        member = getattr(namespace, name)
        if not inspect.isclass(member):
            yield f"{module}.{name}"
        elif not issubclass(member, tuple):
            for method, _ in inspect.getmembers(member, inspect.isfunction):
                if not method.startswith("_"):
                    yield f"{module}.{name}.{method}"


def bind(label, **changed):
    """The function of a row and its arguments, positional and named, some of them changed."""
    module, *_, name = label.split()[0].split(".")
    entry = TABLE[label]
    function = getattr(entry.on() if entry.on else import_module(f"robokin.{module}"), name)
    arguments = {key: arg.value for key, arg in entry.args.items()} | changed
    if entry.positional:
        return function, tuple(arguments.values()), {}
    return function, (), arguments
