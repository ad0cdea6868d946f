"""Robot kinematics for a course: free functions on NumPy arrays, SI units, radians.

One module a topic, named as its chapter. `import robokin` needs NumPy only; still pictures
(`robokin.draw`) need matplotlib.
"""

from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

__version__ = "0.1.0"
_DRAWING = ("draw", "styles")

# the modules are what the folder holds; those that draw are imported by their names
__all__ = [
    module.name
    for module in iter_modules(__path__)
    if not module.name.startswith("_") and module.name not in _DRAWING
]


def __getattr__(name: str) -> ModuleType:
    """Import a module when it is first used."""
    if name in __all__:
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
