"""Every formula of the course, once: printed in the chapters, checked here, drawn from.

One module a topic, named as the module of `robokin` that computes it.
"""

from robokin.equations import (
    basics,
    bicycle,
    differential_drive,
    elbow_arm,
    euler,
    frames,
    motion,
    odometry,
    planar_arm,
    wheels,
)
from robokin.equations.checking import Result, check
from robokin.equations.core import QUANTITIES, REGISTRY, Equation, find
from robokin.equations.printing import show

__all__ = [
    "QUANTITIES",
    "REGISTRY",
    "Equation",
    "Result",
    "basics",
    "bicycle",
    "check",
    "differential_drive",
    "elbow_arm",
    "euler",
    "find",
    "frames",
    "motion",
    "odometry",
    "planar_arm",
    "show",
    "wheels",
]
