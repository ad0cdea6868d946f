"""Robot kinematics for a course: free functions on NumPy arrays, SI units, radians.

One module a topic, named as its chapter. `import robokin` needs NumPy only; the formulas
(`robokin.equations`), live figures (`robokin.live`) and drawing (`robokin.draw`) are extras.
"""

from robokin import differential_drive, errors, motion

__all__ = ["differential_drive", "errors", "motion"]
__version__ = "0.1.0"
