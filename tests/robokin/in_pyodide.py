"""What `test_in_pyodide.py` has run by the Python of a browser: pytest, there."""

import os
import sys
from importlib.machinery import ModuleSpec
from types import ModuleType


class Absent(ModuleType):
    """In place of a package that is not to be had: a test is skipped that uses it."""

    __path__ = ()

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Absent(f"{self.__name__}.{name}")

    def __call__(self, *args, **named):
        import pytest

        pytest.skip(f"needs {self.__name__.partition('.')[0]}")


class AbsentPackages:
    """Finds these packages, and what is in them."""

    def __init__(self, names):
        self.names = names

    def find_spec(self, name, path=None, target=None):
        return ModuleSpec(name, self) if f"{name}.".startswith(self.names) else None

    def create_module(self, spec):
        return Absent(spec.name)

    def exec_module(self, module):
        pass


def run(root, paths, absent, tests):
    """The tests, with the project's settings of pytest; how it ended."""
    sys.path[:0] = paths
    sys.meta_path.insert(0, AbsentPackages(tuple(f"{name}." for name in absent)))
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
    os.chdir(root)
    import numpy
    import pytest

    import robokin

    assert robokin.__file__.startswith(paths[0])
    assert numpy.dtype(int).itemsize == 4, "integers have 32 bits in this Python"
    quiet = ["-q", "-rs", "-p", "no:cacheprovider", "--import-mode=importlib", "--tb=short"]
    return int(pytest.main(["-o", "addopts=", "-m", "not slow", *quiet, *tests]))
