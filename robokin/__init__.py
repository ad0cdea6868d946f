"""Robot kinematics for a course: free functions on NumPy arrays, SI units, radians.

One module a topic, named as its chapter. `import robokin` needs NumPy only; still pictures
(`robokin.draw`) need matplotlib.
"""

from robokin import (
    bicycle,
    differential_drive,
    elbow_arm,
    errors,
    euler,
    frames,
    motion,
    odometry,
    planar_arm,
    wheels,
)

__all__ = [
    "bicycle",
    "differential_drive",
    "elbow_arm",
    "errors",
    "euler",
    "frames",
    "motion",
    "odometry",
    "planar_arm",
    "wheels",
]
__version__ = "0.1.0"
