"""For each public function arguments that work, and what each of them is: for tests and benchmarks.

The rows of `robokin/<topic>.py` stand here in `<topic>.py`: `ROWS`, by the name of the function, or
of the class and its method; a remark may follow, where a function has two rows. What is missing is
named by `test_bad_input.py::test_each_function_has_a_row`.
"""

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from typing import Any

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


def modulus(value):
    """A parameter that is a whole number from 2."""
    return Arg("modulus", value)


def name(value):
    """One of a few names."""
    return Arg("name", value)


def frame(value):
    """The name of a frame in a graph: any string."""
    return Arg("frame", value)


def wheels(make):
    """A list of wheels, made anew for each call."""
    return Arg("wheels", make)


DATA = ("data", "steps", "matrix", "ticks", "tick steps")
STEPS = ("steps", "tick steps")
PARAMETERS = ("length", "not negative", "number", "bits", "modulus")


@dataclass(frozen=True)
class Row:
    """A function: the shape of each of its results for one item, and its arguments by name."""

    results: list
    args: dict
    batches: bool = True  # do the parameters broadcast with the data?
    nan_beside: bool = False  # does a NaN step spoil the results on both sides of it only?
    limit_at_infinity: tuple = ()  # arguments whose infinity has finite results: arctan(inf)
    bounded: bool = False  # are data refused that are too large to be true?
    positional: bool = False  # is it called without the arguments' names?
    on: Callable[[], Any] | None = None  # makes the object that a method is called on

    @property
    def good(self):
        return {key: arg.good for key, arg in self.args.items()}

    def having(self, *kinds):
        return [key for key, arg in self.args.items() if arg.kind in kinds]


def row(
    results,
    batches=True,
    nan_beside=False,
    limit_at_infinity=(),
    bounded=False,
    positional=False,
    on=None,
    **args,
):
    return Row(results, args, batches, nan_beside, limit_at_infinity, bounded, positional, on)


# What several modules have rows of

POSE, TWIST, POINT, ANGLES = [0.3, -0.2, 0.4], [0.5, 0.1, -0.3], [0.3, 0.2, 0.1], [0.3, 0.5, -0.7]
TURNED = [[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]  # exercise 2
METHOD = name("exact")
RAISE_OR_NAN = name("nan")
WHEELS = {"wheel_radius": length(0.03), "wheel_distance": length(0.1)}


# The rows


def rows(module):
    """The rows of a module of the library; it has none as long as nobody has written them."""
    place = f"arguments.{module}"
    return import_module(place).ROWS if find_spec(place) else {}


def public_functions(module):
    """The names of a module's functions, and of the methods of its classes."""
    namespace = import_module(f"robokin.{module}")
    for name in getattr(namespace, "__all__", ()):  # which test_api.py asks for
        member = getattr(namespace, name)
        if not inspect.isclass(member):
            yield name
        elif not issubclass(member, tuple):
            for method, _ in inspect.getmembers(member, inspect.isfunction):
                if not method.startswith("_"):
                    yield f"{name}.{method}"


# by labels: `motion.arc_step`, `frames.inverse in space`
TABLE = {f"{module}.{name}": row for module in MODULES for name, row in rows(module).items()}


def bind(label, **changed):
    """The function of a row and its arguments, positional and named, some of them changed."""
    module, *_, name = label.split()[0].split(".")
    entry = TABLE[label]
    function = getattr(entry.on() if entry.on else import_module(f"robokin.{module}"), name)
    arguments = {**entry.good, **changed}
    if entry.positional:
        return function, tuple(arguments.values()), {}
    return function, (), arguments
