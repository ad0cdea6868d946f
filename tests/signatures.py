"""The public names of `robokin` with the arguments of each, as stored in `signatures.txt`.

`python tests/signatures.py` writes that file anew.
"""

import importlib
import inspect
from pathlib import Path

import robokin

STORED = Path(__file__).with_name("signatures.txt")


def signatures():
    """A line for each public name: a function with its arguments, a class without."""
    lines = []
    for module in robokin.__all__:
        namespace = importlib.import_module(f"robokin.{module}")
        for name in namespace.__all__:
            member = getattr(namespace, name)
            label = f"{module}.{name}"
            lines.append(label if inspect.isclass(member) else f"{label}({arguments(member)})")
    return sorted(lines)


def arguments(function):
    """The arguments in order with their defaults, without annotations."""
    parameters = inspect.signature(function).parameters.values()
    return ", ".join(str(p.replace(annotation=inspect.Parameter.empty)) for p in parameters)


if __name__ == "__main__":
    STORED.write_text("\n".join([*signatures(), ""]), encoding="utf-8")
