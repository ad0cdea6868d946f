"""Robot kinematics for a course: free functions on NumPy arrays, SI units, radians.

One module a topic, named as its chapter. `import robokin` needs NumPy only; still pictures
(`robokin.draw`) need matplotlib. All functions have in common:

- An argument that is `array_like` may be a number, a list or an array. In a shape, `...` stands for
  any leading batch dimensions: all arguments broadcast, and without a batch the result has none.
- Parameters (names, lengths, radii) and all shapes are checked: a wrong one raises a
  `RobokinError`. Lengths, radii and tolerances must be positive. Docstrings list what is raised
  beyond that.
- NaN and infinity in the data (poses, angles, rates, points, ticks) go through the arithmetic into
  the results that depend on them.
- Wheels are in the order left, right.
"""

from importlib import import_module
from pkgutil import iter_modules

__version__ = "0.1.0"

# the modules are what the folder holds; those that draw are imported by their names
__all__ = [
    module.name
    for module in iter_modules(__path__)
    if not module.name.startswith("_") and module.name not in ("draw", "styles")
]
for _name in __all__:
    import_module(f"{__name__}.{_name}")
