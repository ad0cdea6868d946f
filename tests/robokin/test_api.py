"""The public face of the package: its names, its docstrings, and what importing it loads."""

import doctest
import importlib
import inspect
import re
import subprocess
import sys
from operator import attrgetter

import pytest
from arguments import public_functions

import robokin

MODULES = robokin.__all__


def load(module):
    return importlib.import_module(f"robokin.{module}")


@pytest.mark.parametrize("module", MODULES)
def test_the_public_names_of_a_module_are_its_own(module):
    namespace = load(module)
    for name in namespace.__all__:
        assert getattr(namespace, name).__module__ == f"robokin.{module}"


FUNCTIONS = [label for module in [*MODULES, "draw"] for label in public_functions(module)]


@pytest.mark.parametrize("label", FUNCTIONS)
def test_a_docstring_names_the_arguments_and_their_shapes(label):
    module, _, name = label.partition(".")
    function = attrgetter(name)(load(module))
    first, *rest = re.split(r"\n\n(\w+)\n-+\n", inspect.getdoc(function) or "")
    sections = dict(zip(rest[::2], rest[1::2], strict=True))
    assert re.match(r".+\.(\n\n|$)", first), f"begin the docstring of {label} with one line"
    signature = inspect.signature(function)
    names = re.findall(r"^(\S.*) : ", sections.get("Parameters", ""), re.MULTILINE)
    documented = [each.strip("*") for each in ", ".join(names).split(", ")]
    assert documented == [each for each in signature.parameters if each != "self"]
    bare = re.search(r"array_like(?!, shape \()", sections["Parameters"])
    assert not bare, f"an array_like in the docstring of {label} has no shape, as `shape (..., 3)`"
    assert ("Returns" in sections) == (signature.return_annotation is not None)


@pytest.mark.parametrize("module", MODULES)
def test_the_examples_in_the_docstrings(module):
    assert doctest.testmod(load(module)).failed == 0, "see what it printed"


def test_every_error_is_one_family():
    errors = load("errors")
    for name in errors.__all__:
        assert issubclass(getattr(errors, name), errors.RobokinError)
    assert issubclass(errors.RobokinError, ValueError)


def test_importing_the_package_gives_its_modules_and_loads_numpy_alone():
    code = (
        "import sys, robokin; print(all(getattr(robokin, m).__all__ for m in robokin.__all__),"
        "{'sympy', 'matplotlib', 'scipy', 'ipywidgets', 'IPython', 'numpy.ma'} & {*sys.modules})"
    )
    command = [sys.executable, "-W", "error", "-c", code]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["True", "set()"]
