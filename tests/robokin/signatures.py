"""The public names of `robokin` with the arguments of each, as stored in `signatures.txt`.

`python tests/robokin/signatures.py` writes that file anew.
"""

import importlib
import inspect
from pathlib import Path

import robokin

STORED = Path(__file__).with_name("signatures.txt")


def signatures(module):
    """A line for each public name of a module: a function with its arguments, a class without."""
    namespace = importlib.import_module(f"robokin.{module}")
    for name in sorted(getattr(namespace, "__all__", ())):  # which test_api.py asks for
        member = getattr(namespace, name)
        label = f"{module}.{name}"
        yield label if inspect.isclass(member) else f"{label}({arguments(member)})"


def arguments(function):
    """The arguments in order with their defaults, without annotations."""
    parameters = inspect.signature(function).parameters.values()
    return ", ".join(str(p.replace(annotation=inspect.Parameter.empty)) for p in parameters)


if __name__ == "__main__":
    lines = [line for module in robokin.__all__ for line in signatures(module)]
    STORED.write_text("\n".join([*lines, ""]), encoding="utf-8")
