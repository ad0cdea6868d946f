"""Every formula of the course, once: printed in the chapters, checked here, drawn from.

One module a topic, named as the module of `robokin` that computes it.
"""

from robokin.equations import differential_drive, motion
from robokin.equations.checking import Result, check
from robokin.equations.core import QUANTITIES, REGISTRY, Equation, find
from robokin.equations.printing import show

__all__ = [
    "QUANTITIES",
    "REGISTRY",
    "Equation",
    "Result",
    "check",
    "differential_drive",
    "find",
    "motion",
    "show",
]
