"""The public face of the package: its names, its docstrings, and what importing it loads."""

import doctest
import importlib
import inspect
import re
import subprocess
import sys

import pytest
import signatures

import robokin

MODULES = robokin.__all__
STORED = signatures.STORED.read_text(encoding="utf-8").splitlines()
FUNCTIONS = [line.partition("(")[0] for line in STORED if line.endswith(")")]
# they take single numbers and wheels, and return wheels or whole numbers
WITHOUT_ARRAYS = ("fixed", "steered", "castor", "swedish", "spherical", "omni_robot", "mobility")


def load(module):
    return importlib.import_module(f"robokin.{module}")


def find(label):
    module, name = label.split(".")
    return getattr(load(module), name)


def test_the_public_names_and_their_arguments_are_the_stored_ones():
    """What chapters and other people's code rely on: a change here is a change for them."""
    assert signatures.signatures() == STORED, (
        "if this change of the public names is meant, store it: "
        ".venv/bin/python tests/signatures.py"
    )


@pytest.mark.parametrize("module", MODULES)
def test_the_public_names_of_a_module_are_its_own(module):
    namespace = load(module)
    for name in namespace.__all__:  # defined here, not passed on from elsewhere
        assert getattr(namespace, name).__module__ == f"robokin.{module}"


@pytest.mark.parametrize("label", FUNCTIONS)
def test_a_docstring_says_what_goes_in_and_comes_out(label):
    text = inspect.getdoc(find(label))
    assert text.split("\n\n")[0].endswith(".")  # begins with a sentence
    if label.removeprefix("wheels.") not in WITHOUT_ARRAYS:
        assert re.search(r"\(…|\(k, k\)", text), "no shapes"
        assert label == "frames.check_rotation" or "→" in text, "no result"


@pytest.mark.parametrize("module", MODULES)
def test_the_examples_in_the_docstrings(module):
    outcome = doctest.testmod(load(module))
    assert outcome.failed == 0
    assert outcome.attempted > 0 or module == "errors"


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
    code = f"import sys, robokin; print([name for name in {heavy} if name in sys.modules])"
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "[]"


def test_importing_the_package_imports_its_modules():
    code = "import robokin; print([hasattr(robokin, name) for name in robokin.__all__])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == str([True] * len(robokin.__all__))
