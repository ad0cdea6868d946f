"""Time robokin beside other libraries, one call of each public function, and the import."""

import subprocess
import sys
from functools import lru_cache
from resource import RUSAGE_CHILDREN, getrusage

import numpy as np
import pytest
from arguments import TABLE, bind
from computations import COMPUTATIONS

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


@pytest.mark.parametrize(NAMES, [(label, 1, "robokin") for label in TABLE])
def test_single_call(benchmark, computation, items, library):
    args = TABLE[computation].args.items()
    arrays = {name: np.array(arg.value) for name, arg in args if isinstance(arg.value, list)}
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
