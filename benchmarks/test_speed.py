"""Time robokin beside other libraries, one call of each public function, and the import."""

import subprocess
import sys
from functools import lru_cache
from resource import RUSAGE_CHILDREN, getrusage

import numpy as np
import pytest
from arguments import TABLE, bind
from computations import COMPUTATIONS
from obvious import OBVIOUS, inputs

SIZES = (1, 1_000, 100_000)
NAMES = ("computation", "items", "library")


@lru_cache(maxsize=1)  # a computation's libraries follow one another, on the same inputs
def make_row(computation, items):
    return COMPUTATIONS[computation](items)


@pytest.mark.parametrize(
    NAMES,
    [
        (computation, items, library)
        for computation in COMPUTATIONS
        for items in SIZES
        for library in make_row(computation, 1).calls
    ],
)
def test_computation(benchmark, computation, items, library):
    calls, distance, tolerance = make_row(computation, items)
    if library != "robokin":
        assert distance(calls["robokin"](), calls[library]()) <= tolerance
    benchmark(calls[library])


def apart(ours, theirs):
    """The largest difference, angles round the circle; axes and directions have two signs."""
    if isinstance(ours, tuple):
        return max(apart(abs(a), abs(b)) for a, b in zip(ours, theirs, strict=True))
    return np.abs(np.exp(1j * ours) - np.exp(1j * theirs)).max()


make_inputs = lru_cache(inputs)


@pytest.mark.parametrize(
    NAMES, [(name, 100_000, library) for name in OBVIOUS for library in ("robokin", "numpy")]
)
def test_obvious(benchmark, computation, items, library):
    """Beside what a user would write, which should be at least half as slow."""
    x = make_inputs(items)
    ours, theirs = OBVIOUS[computation]
    if library == "numpy" and (result := ours(x)) is not None:
        # steps of the textbook's covariance are straight: that is 1e-5 of it
        assert apart(result, theirs(x)) <= (1e-4 if "covariance" in computation else 1e-8)
    benchmark({"robokin": ours, "numpy": theirs}[library], x)


@pytest.mark.parametrize(NAMES, [(label, 1, "robokin") for label in TABLE])
def test_single_call(benchmark, computation, items, library):
    args = TABLE[computation].args.items()
    arrays = {name: np.array(arg.value) for name, arg in args if arg.core}
    function, positional, named = bind(computation, **arrays)
    benchmark(function, *positional, **named)


def children_seconds():
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@pytest.mark.benchmark(timer=children_seconds)
@pytest.mark.parametrize(NAMES, [("import", 1, "robokin"), ("import", 1, "numpy")])
def test_import(benchmark, computation, items, library):
    """Start Python and import robokin, which imports NumPy, or NumPy alone."""
    command = [sys.executable, "-c", f"import {library}"]
    benchmark.pedantic(subprocess.run, [command], {"check": True}, rounds=21)
