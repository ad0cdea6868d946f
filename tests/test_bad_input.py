"""Bad input, one table for the whole package: what each public function does at its door.

The table has a row for each public function: a call that works, and for every argument what it
is. From it come all the tests below. A function without a row fails `test_no_function_is_left_out`.
"""

import importlib
import inspect
import random
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

import hypothesis.extra.numpy as hnp
import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

import robokin
from robokin.errors import RobokinError

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
    """Poses, angles, rates …: NaN and infinity make their own row NaN."""
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

    @property
    def good(self):
        return {key: arg.good for key, arg in self.args.items()}

    def having(self, *kinds):
        return [key for key, arg in self.args.items() if arg.kind in kinds]


def row(results, batches=True, nan_beside=False, **args):
    return Row(results, args, batches, nan_beside)


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
    "motion.icr": row([(2,)], pose=data(POSE), v=data(0.5), omega=data(0.2)),
    "frames.se2": row([(3, 3)], x=data(1.0), y=data(2.0), theta=data(0.3)),
    "frames.se3": row([(4, 4)], rotation=matrix(TURNED), position=data(POINT)),
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
    "differential_drive.wheel_rates": row([(2,)], v=data(0.5), omega=data(0.2), **WHEELS),
    "bicycle.equivalent_steering": row([()], alpha_left=data(0.3), alpha_right=data(0.2)),
    "bicycle.ackermann": row([(2,)], phi=data(0.3), **CAR),
    "bicycle.turning_radius": row([()], phi=data(0.3), wheelbase=length(2.5)),
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
        [(4,)], counts=tick_steps([250, 3, 7, 255, 1]), bits=bits(8), nan_beside=True
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
    "odometry.umbmark": row(
        [(), ()],
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

HERE = {label: entry for label, entry in TABLE.items() if label.split(".")[0] in MODULES}


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


def call(label, **changed):
    """Call the function of a row with its working arguments, some of them changed."""
    arguments = {**TABLE[label].good, **changed}
    if "first" in arguments:  # compose takes any number of transforms, without names
        return find(label)(*arguments.values())
    return find(label)(**arguments)


def results(label, **changed):
    """The results as a list of arrays, however many there are."""
    result = call(label, **changed)
    return [np.asarray(a) for a in (result if isinstance(result, tuple) else (result,))]


def batch(entry, n, parameters=False):
    """The working arguments, n times over; the parameters too where they broadcast."""
    kinds = DATA + (PARAMETERS if parameters and entry.batches else ())
    return {
        key: np.array(np.broadcast_to(entry.args[key].good, (n, *entry.args[key].core)))
        for key in entry.having(*kinds)
    }


def each(*kinds, wanted=lambda entry: True):
    """Every (row, argument) of these kinds, as parameters of a test."""
    pairs = [
        (label, key)
        for label, entry in HERE.items()
        for key in entry.having(*kinds)
        if wanted(entry)
    ]
    return pytest.mark.parametrize(("label", "key"), pairs, ids=[" ".join(pair) for pair in pairs])


def each_argument():
    return each(*{arg.kind for entry in HERE.values() for arg in entry.args.values()})


def each_row(wanted=lambda entry: True):
    labels = [label for label, entry in HERE.items() if wanted(entry)]
    return pytest.mark.parametrize("label", labels)


# compose numbers its transforms, a graph names poses and frames by the names of the frames
CALLED_OTHERWISE = ("first", "second", "T_ab", "a", "b")


def assert_refused(label, key=None, **changed):
    """A RobokinError with a short message that names the argument."""
    with pytest.raises(RobokinError) as error:
        call(label, **changed)
    message = str(error.value)
    assert 10 < len(message) < 400
    if key is not None and key not in CALLED_OTHERWISE:
        assert key in message
    return message


def has_answer(entry):
    return bool(entry.results and entry.having(*DATA))


# What works


def test_no_function_is_left_out():
    assert {label.split()[0] for label in HERE} == set(public_functions())


@each_row(lambda entry: entry.results)
def test_one_item_in_one_item_out(label):
    assert [a.shape for a in results(label)] == HERE[label].results
    assert all(np.isfinite(a).all() for a in results(label))


@each_row(lambda entry: entry.results)
def test_a_batch_in_a_batch_out(label):
    entry = HERE[label]
    one = results(label)
    for parameters in (False, True):
        for n in (1, 4):
            many = batch(entry, n, parameters)
            if many:
                for a, b in zip(results(label, **many), one, strict=True):
                    # NumPy's vector sines may differ from its single ones in the last digit
                    np.testing.assert_allclose(a, np.broadcast_to(b, (n, *b.shape)), atol=1e-14)


@each_row(has_answer)
def test_an_empty_batch_gives_an_empty_result(label):
    entry = HERE[label]
    wanted = [(0, *shape) for shape in entry.results]
    assert [a.shape for a in results(label, **batch(entry, 0))] == wanted
    for key in entry.having(*DATA):  # or one argument empty, the others single
        assert [a.shape for a in results(label, **{key: batch(entry, 0)[key]})] == wanted


@each_row(lambda entry: entry.results is not None)
def test_lists_tuples_and_arrays_are_the_same_and_stay_as_they_are(label):
    entry = HERE[label]
    keys = entry.having(*DATA, *PARAMETERS)
    wanted = results(label)
    arrays = {key: np.array(entry.args[key].good) for key in keys}
    for array in arrays.values():
        array.flags.writeable = False  # nothing may write into what it was given
    tuples = {key: totuple(entry.args[key].good) for key in keys}
    columns = {key: np.array(array, order="F") for key, array in arrays.items()}
    for changed in (arrays, tuples, columns):
        for a, b in zip(results(label, **changed), wanted, strict=True):
            np.testing.assert_array_equal(a, b)


def totuple(value):
    return tuple(map(totuple, value)) if isinstance(value, list) else value


@each_row(has_answer)
def test_the_result_is_one_s_own(label):
    given = batch(HERE[label], 3)
    kept = {key: array.copy() for key, array in given.items()}
    first = call(label, **given)
    for array in first if isinstance(first, tuple) else (first,):
        if isinstance(array, np.ndarray) and array.dtype == float:
            array[...] = 7.0  # can be written into, and is no view of an argument
    for key, array in given.items():
        np.testing.assert_array_equal(array, kept[key])


# What is refused: shapes


def wrong_shapes(arg):
    *outer, last = arg.core
    yield 1.0
    yield np.ones((*outer, last + 1))
    yield np.ones((5, *outer, last + 1))
    if last > 1:
        yield np.ones((*outer, last - 1))
    if outer:
        yield np.ones(last)


@each("data", "matrix")
def test_a_wrong_shape_is_refused(label, key):
    if HERE[label].args[key].core:
        for value in wrong_shapes(HERE[label].args[key]):
            assert_refused(label, key, **{key: value})


@each("length", "number")
def test_a_wrong_shape_of_a_parameter_is_refused(label, key):
    arg = HERE[label].args[key]
    if arg.core and label != "wheels.omni_robot":  # which takes any number of angles
        assert_refused(label, **{key: np.ones(arg.core[-1] + 1)})


@each_row()
def test_batches_of_different_lengths_are_refused(label):
    entry = HERE[label]
    two, three = batch(entry, 2, parameters=True), batch(entry, 3, parameters=True)
    for key in two:
        for other in three:
            if other != key:
                assert_refused(label, **{key: two[key], other: three[other]})


@each_row(lambda entry: entry.having(*STEPS))
def test_paths_of_different_lengths_are_refused(label):
    entry = HERE[label]
    keys = [key for key in entry.args if entry.args[key].core[-1:] == (4,)]
    for key in keys:
        for other in keys:
            if other != key:
                assert_refused(label, **{key: entry.args[other].good[:3]})


# What is refused: types


class Strange:
    """An object that fails at everything."""

    def __array__(self, *args, **kwargs):
        raise KeyError("no array")

    def __repr__(self):
        raise KeyError("no repr")


ITSELF = []
ITSELF.append(ITSELF)

NOT_NUMBERS = {
    "a string": "abc",
    "a number in a string": "1.0",
    "bytes": b"1.0",
    "strings": ["1", "2", "3"],
    "an object": object(),
    "objects": np.array([object()] * 3),
    "floats as objects": np.array([1.0, 2.0, 3.0], dtype=object),
    "a fraction": Fraction(1, 2),
    "a dict": {},
    "a filled dict": {"x": 1.0, "y": 2.0},
    "a set": {1.0, 2.0, 3.0},
    "a function": max,
    "a generator": (x for x in [1.0, 2.0, 3.0]),
    "Ellipsis": ...,
    "complex": 1j,
    "real complex": 1.0 + 0j,
    "complex numbers": [1j, 2.0, 3.0],
    "ragged": [[1.0], [1.0, 2.0]],
    "ragged at depth": [1.0, [2.0, 3.0], 4.0],
    "None inside": [1.0, None, 3.0],
    "a bool": True,
    "bools": [True, False, True],
    "NumPy's bool": np.bool_(True),
    "an int past 64 bits": 10**30,
    "ints past any float": [10**400, 1.0, 2.0],
    "dates": np.array(["2020-01-01"] * 3, dtype="datetime64[D]"),
    "durations": np.array([1, 2, 3], dtype="timedelta64[s]"),
    "a record": np.zeros(3, dtype=[("x", float), ("y", float)]),
    "a list of itself": ITSELF,
    "100 axes": reduce(lambda inner, _: [inner], range(100), 1.0),
    "60 axes": np.ones((1,) * 60),
}
NOT_PRINTABLE = {
    "an int too long to print": 10**5000,
    "a strange object": Strange(),
    "strange objects": [Strange(), Strange(), Strange()],
}


@each_argument()
def test_what_is_not_numbers_is_refused(label, key):
    for value in [*NOT_NUMBERS.values(), *NOT_PRINTABLE.values()]:
        if HERE[label].args[key].kind != "frame" or not isinstance(value, str):
            assert_refused(label, key, **{key: value})


@each_argument()
def test_none_is_refused_but_where_it_is_the_default(label, key):
    parameters = inspect.signature(find(label)).parameters
    if key not in parameters or parameters[key].default is not None:
        assert_refused(label, key, **{key: None})


@each("name")
def test_an_unknown_name_is_refused(label, key):
    for value in ["", "no such", "EXACT", "Raise", "xyzx", "xxy", "XyZ", "xyé", 3, ["nan"]]:
        message = assert_refused(label, key, **{key: value})
        if key != "seq":
            assert HERE[label].args[key].good in message  # says what is allowed


@each("frame")
def test_an_unknown_or_impossible_frame_is_refused(label, key):
    for value in ["", "no such", 3, ["b"]]:
        if not (label.endswith("add") and value == "no such"):
            assert_refused(label, key, **{key: value})


def test_a_chain_of_no_frames_is_refused():
    with pytest.raises(RobokinError, match="at least one"):
        find("frames.compose")()


@each("wheels")
def test_what_is_not_wheels_is_refused(label, key):
    for value in (1.0, "wheels", [1.0], [None], {}, np.ones(3), [HERE[label].args[key].good]):
        assert_refused(label, key, **{key: value})


# What is refused: values of parameters

NEVER = {
    "length": [0, 0.0, -0.0, -1, -1e-300, np.nan, np.inf, -np.inf],
    "not negative": [-1, -1e-300, np.nan, np.inf, -np.inf],
    "number": [np.nan, np.inf, -np.inf],
    "bits": [0, -1, 1.5, 64, np.nan, np.inf, -np.inf],
}


@each(*PARAMETERS)
def test_a_parameter_that_cannot_be_meant_is_refused(label, key):
    arg = HERE[label].args[key]
    for value in NEVER[arg.kind]:
        bad = np.array(arg.good, dtype=float)
        bad[(-1,) * bad.ndim] = value
        assert_refused(label, key, **{key: bad})
        assert_refused(label, key, **{key: bad.tolist()})


@each(*PARAMETERS)
def test_one_bad_element_of_a_parameter_is_refused(label, key):
    arg = HERE[label].args[key]
    if HERE[label].batches:
        for value in NEVER[arg.kind]:
            bad = np.array(np.broadcast_to(arg.good, (3, *arg.core)), dtype=float)
            bad[(1,) * bad.ndim] = value
            message = assert_refused(label, key, **{key: bad})
            assert "at index 1" in message  # and says which


@each("ticks", "tick steps")
def test_ticks_are_whole_numbers(label, key):
    arg = HERE[label].args[key]
    for value in (0.5, 1e-9, 3.0000001):
        bad = np.array(arg.good, dtype=float)
        bad[(-1,) * bad.ndim] = value
        assert_refused(label, key, **{key: bad})


# NaN, infinity and huge numbers in the data


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@each("data", "matrix", "ticks", wanted=has_answer)
def test_a_bad_value_makes_its_own_row_nan_and_touches_no_other(label, key, value):
    entry = HERE[label]
    clean = batch(entry, 5)
    wanted = results(label, **clean)
    core = entry.args[key].core
    for index in [(0,) * len(core), (-1,) * len(core)]:
        spoilt = clean[key].astype(float)
        spoilt[(2, *index)] = value
        for a, b in zip(results(label, **{**clean, key: spoilt}), wanted, strict=True):
            np.testing.assert_array_equal(np.delete(a, 2, 0), np.delete(b, 2, 0))
            assert a.dtype == bool or np.isnan(a[2]).all()
        # and where it is the only batch, so that its row meets all others of one item
        single = {key: spoilt[1:4]}
        for a in results(label, **single):
            assert a.dtype == bool or (np.isnan(a[1]).all() and np.isfinite(a[[0, 2]]).all())


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@each("steps", "tick steps")
def test_a_bad_step_makes_the_path_nan_from_there_on(label, key, value):
    entry = HERE[label]
    clean = batch(entry, 3)
    wanted = results(label, **clean)
    for k in range(entry.args[key].core[0]):
        spoilt = clean[key].astype(float)
        spoilt[1, k] = value
        for a, b in zip(results(label, **{**clean, key: spoilt}), wanted, strict=True):
            np.testing.assert_array_equal(a[[0, 2]], b[[0, 2]])
            nan = np.zeros(a.shape[1], dtype=bool)
            nan[slice(max(k - 1, 0), k + 1) if entry.nan_beside else slice(k + 1, None)] = True
            assert np.isnan(a[1, nan]).all()
            np.testing.assert_array_equal(a[1, ~nan], b[1, ~nan])


EXTREMES = [1e308, -1e308, 1e200, 5e-324, -5e-324, 1e-200, 0.0]


@each("data", "steps")
def test_the_largest_and_the_smallest_numbers_touch_no_other_row(label, key):
    entry = HERE[label]
    clean = batch(entry, 3)
    wanted = results(label, **clean)
    for value in EXTREMES:
        extreme = clean[key].astype(float)
        extreme[1] = value
        for a, b in zip(results(label, **{**clean, key: extreme}), wanted, strict=True):
            np.testing.assert_array_equal(a[[0, 2]], b[[0, 2]])


@each("matrix")
def test_one_matrix_that_is_no_rotation_is_refused(label, key):
    for value in EXTREMES:
        matrices = batch(HERE[label], 3)[key]
        matrices[1] = value
        message = assert_refused(label, key, **{key: matrices})
        assert "at index 1" in message


@each_row()
def test_the_largest_and_the_smallest_numbers_everywhere(label):
    # in all the data at once, and with each parameter: a warning would be an error here
    entry = HERE[label]
    for value in EXTREMES:
        everywhere = {
            key: np.full(entry.args[key].core, value) for key in entry.having("data", "steps")
        }
        call(label, **everywhere)
        if value > 0:
            for key in entry.having("length", "number", "not negative"):
                call(label, **{key: np.full(entry.args[key].core, value)})
                call(label, **everywhere, **{key: np.full(entry.args[key].core, value)})


# Junk

CASES = 40  # of several arguments at once, for each example
SPECIAL = [0.0, -0.0, 1.0, -1.0, 0.5, 3.0, np.pi, -np.pi, np.pi / 2, 1e-16, -1e-8, 5e-324, 1e154]
SPECIAL += [1e308, -1e308, np.nan, np.inf, -np.inf]
WORDS = [
    "",
    "xyz",
    "ZYZ",
    "XYX",
    "xzy",
    "XXY",
    "xYz",
    "zyxz",
    "exact",
    "end",
    "nan",
    "raise",
    "Nan",
]

scalars = (
    st.sampled_from([None, True, 1j, ..., b"", "", {}, (), 10**400, -(2**64), Fraction(1, 3)])
    | st.sampled_from(SPECIAL)
    | st.floats(width=64)
    | st.integers(-5, 300)
    | st.integers()
    | st.text(max_size=4)
    | st.sampled_from(WORDS)
    | st.sampled_from(sorted(NOT_NUMBERS)).map(lambda what: NOT_NUMBERS[what])
)
nested = st.recursive(scalars, lambda inner: st.lists(inner, max_size=4), max_leaves=8)
any_array = hnp.arrays(
    hnp.scalar_dtypes() | hnp.unicode_string_dtypes(max_len=3),
    hnp.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=4),
)
junk = scalars | nested | any_array | st.dictionaries(st.text(max_size=2), scalars, max_size=2)


def shaped(arg):
    """Arrays that fit, or nearly, full of numbers that are often the special ones."""
    shapes = st.lists(st.integers(0, 3), max_size=2).map(lambda outer: (*outer, *arg.core))
    elements = st.sampled_from(SPECIAL) | st.floats(-10, 10) | st.integers(-9, 9).map(float)
    return hnp.arrays(float, shapes, elements=elements)


def damaged(arg):
    """The working value with a few of its numbers replaced, or turned or scaled as a whole."""
    good = arg.good
    if arg.kind in ("name", "frame"):
        return st.sampled_from(WORDS)
    if arg.kind == "wheels":
        return st.lists(st.sampled_from(good), max_size=4)
    good = np.asarray(good, dtype=float)
    where = st.lists(st.tuples(*(st.integers(0, n - 1) for n in good.shape)), max_size=2)
    return st.builds(
        lambda where, value, scale: spoil(np.array(good * scale), where, value),
        where,
        st.sampled_from(SPECIAL),
        st.sampled_from([1.0, 1.0, -1.0, 0.0, 1 + 1e-15, 1 + 1e-7, 1e300]),
    )


def spoil(array, where, value):
    for index in where:
        array[index] = value
    return array


def throw_junk(label, examples):
    """Call a function with junk in place of each argument alone, and of several at once.

    Returns the number of calls: CASES + 4 for each argument, for every example.
    """
    replacements = {
        key: st.lists(junk | shaped(arg) | damaged(arg), min_size=4, max_size=4)
        for key, arg in TABLE[label].args.items()
    }
    count = longest = 0

    @settings(max_examples=examples, database=None, suppress_health_check=list(HealthCheck))
    @given(st.fixed_dictionaries(replacements), st.integers(0, 2**32))
    def catch(drawn, seed):
        nonlocal count, longest
        chance = random.Random(seed)
        changes = [{key: value} for key, values in drawn.items() for value in values]
        for case in range(CASES):
            share = (0.3, 0.5, 0.7, 1.0)[case % 4]
            some = [key for key in drawn if chance.random() < share]
            changes.append({key: chance.choice(drawn[key]) for key in some})
        for changed in changes:
            count += 1
            try:
                call(label, **changed)
            except RobokinError as error:
                longest = max(longest, len(str(error)))

    catch()
    assert longest < 1000  # a message, not a page
    return count


# hypothesis, when it draws again, wants to print the strategy, and warns that it is long
quiet = pytest.mark.filterwarnings("ignore:Generating overly large repr")


@quiet
@each_row()
def test_junk_finds_nothing_but_robokin_errors(label):
    throw_junk(label, examples=10)


@quiet
@pytest.mark.long
def test_a_million_cases_of_junk_find_nothing_but_robokin_errors(capsys):
    total = 0
    for label, entry in HERE.items():
        cases = CASES + 4 * len(entry.args)
        total += throw_junk(label, examples=1_000_000 // (len(HERE) * cases) + 1)
    with capsys.disabled():
        print(f"\n{total} cases of junk in {len(HERE)} rows: nothing but RobokinError")
    assert total >= 1_000_000
