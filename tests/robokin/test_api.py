"""The public face of the package: its names, its docstrings, and what importing it loads."""

import doctest
import importlib
import inspect
import os
import re
import shutil
import subprocess
import sys
from operator import attrgetter

import pytest
import signatures
from arguments import public_functions
from support import ROOT

import robokin

MODULES = robokin.__all__


def load(module):
    return importlib.import_module(f"robokin.{module}")


@pytest.mark.parametrize("module", MODULES)
def test_the_public_names_and_their_arguments_are_the_stored_ones(module):
    """What chapters and other people's code rely on: a change here is a change for them."""
    now = set(signatures.signatures(module))
    lines = signatures.STORED.read_text(encoding="utf-8").splitlines()
    before = {line for line in lines if line.startswith(f"{module}.")}
    assert now == before, (
        f"new: {sorted(now - before)}; gone: {sorted(before - now)}. If this is meant, store it: "
        ".venv/bin/python tests/robokin/signatures.py"
    )


def test_no_module_is_gone():
    lines = signatures.STORED.read_text(encoding="utf-8").splitlines()
    gone = {line.partition(".")[0] for line in lines} - set(MODULES)
    assert not gone, f"gone: {gone}. If this is meant: .venv/bin/python tests/robokin/signatures.py"


@pytest.mark.parametrize("module", MODULES)
def test_the_public_names_of_a_module_are_its_own(module):
    namespace = load(module)
    where = f"robokin/{module}.py"
    assert hasattr(namespace, "__all__"), f"{where} has no __all__: list its public names there"
    for name in namespace.__all__:
        home = getattr(namespace, name).__module__
        assert home == f"robokin.{module}", (
            f"{name} in __all__ of {where} comes from {home}: name it there only"
        )


@pytest.mark.parametrize("module", MODULES)
def test_a_module_has_tests_of_its_own(module):
    name = f"test_{module}.py"
    found = (ROOT / "tests" / "robokin" / name).exists()
    assert found or module in ("errors", "styles"), (
        f"robokin.{module} has no tests: write tests/robokin/{name}"
    )


SECTIONS = ["Parameters", "Returns", "Raises", "References", "Examples"]
FUNCTIONS = [f"{module}.{n}" for module in [*MODULES, "draw"] for n in public_functions(module)]


@pytest.mark.parametrize("label", FUNCTIONS)
def test_a_docstring_says_what_goes_in_and_comes_out(label):
    module, _, name = label.partition(".")
    function = attrgetter(name)(load(module))
    first, *rest = re.split(r"\n\n(\w+)\n-+\n", inspect.getdoc(function) or "")
    sections = dict(zip(rest[::2], rest[1::2], strict=True))
    assert re.match(r".+\.(\n\n|$)", first), f"begin the docstring of {label} with one line"
    assert list(sections) == [section for section in SECTIONS if section in sections], (
        f"the docstring of {label} has sections {list(sections)}: write them as in {SECTIONS}"
    )

    signature = inspect.signature(function)
    names = re.findall(r"^(\S.*) : ", sections.get("Parameters", ""), re.MULTILINE)
    documented = [each.strip("*") for each in ", ".join(names).split(", ")]
    arguments = [each for each in signature.parameters if each != "self"]
    assert documented == arguments, (
        f"Parameters in the docstring of {label} names {documented}, it takes {arguments}"
    )
    bare = re.search(r"array_like(?!, shape \()", sections["Parameters"])
    assert not bare, f"an array_like in the docstring of {label} has no shape, as `shape (..., 3)`"

    given = str(signature.return_annotation)
    shapes = re.findall(r"^\S.*shape \(", sections.get("Returns", ""), re.MULTILINE)
    assert len(shapes) >= given.count("ndarray"), (
        f"Returns in the docstring of {label} names {len(shapes)} shapes, as `ndarray, shape "
        f"(..., 3)`: it needs one for each array of {given}"
    )
    assert ("Returns" in sections) == (signature.return_annotation is not None), (
        f"Returns in the docstring of {label} must say what it returns, if it returns anything"
    )


@pytest.mark.parametrize("module", MODULES)
def test_the_examples_in_the_docstrings(module):
    outcome = doctest.testmod(load(module))
    assert outcome.failed == 0, "see what it printed"
    examples = outcome.attempted > 0 or module == "errors"
    assert examples, f"no docstring of robokin/{module}.py has an example that runs (`>>> …`)"


def test_every_error_is_one_family():
    errors = load("errors")
    for name in errors.__all__:
        assert issubclass(getattr(errors, name), errors.RobokinError)
    assert issubclass(errors.RobokinError, ValueError)


def test_importing_the_package_loads_numpy_alone():
    heavy = [
        "sympy",
        "mpmath",
        "matplotlib",
        "scipy",
        "anywidget",
        "ipywidgets",
        "IPython",
        "traitlets",
    ]
    code = f"import sys; from robokin import *; print([m for m in {heavy} if m in sys.modules])"
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "[]", (
        f"a module of robokin needs {run.stdout.strip()}: compute with NumPy; one that draws is "
        "named in _DRAWING of robokin/__init__.py"
    )


def test_importing_the_package_gives_its_modules():
    """Each is imported when it is first used; no other name is a module."""
    code = (
        "import robokin; print(all(getattr(robokin, m).__all__ for m in robokin.__all__), "
        "{*robokin.__all__} < {*dir(robokin)}, hasattr(robokin, 'nothing'))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["True", "True", "False"]


NEW = """
__all__ = ["ratio"]

def ratio(teeth_in, teeth_out):
    return teeth_out / teeth_in
"""


def test_a_new_module_is_found_and_what_it_lacks_is_named(tmp_path):
    """One file in the folder, and nothing else: each sentence says where to write what."""
    shutil.copytree(ROOT / "robokin", tmp_path / "robokin")
    (tmp_path / "robokin" / "gear_train.py").write_text(NEW, "utf-8")
    command = [sys.executable, "-P", "-m", "pytest", "-q", "-p", "no:cacheprovider"]
    command += ["-k", "gear_train", "tests/robokin/test_api.py", "tests/robokin/test_bad_input.py"]
    env = {**os.environ, "PYTHONPATH": str(tmp_path)}
    told = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, text=True).stdout
    for sentence in (
        'add "ratio": row(…) to ROWS of tests/robokin/arguments/gear_train.py',
        "new: ['gear_train.ratio(teeth_in, teeth_out)']; gone: []. If this is meant, store it: ",
        "begin the docstring of gear_train.ratio with one line",
        "no docstring of robokin/gear_train.py has an example that runs",
        "robokin.gear_train has no tests: write tests/robokin/test_gear_train.py",
    ):
        assert sentence in told, told
