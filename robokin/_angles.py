"""Angles that are solved for, brought into (-π, π] without a digit lost."""

import numpy as np

from robokin._checks import Array

__all__ = ["opposite", "wrapped"]


def wrapped(angle: Array) -> Array:
    """An angle in (-3π, 3π] brought into (-π, π]."""
    down: Array = angle - 2 * np.pi * (angle > np.pi)
    return down + 2 * np.pi * (down <= -np.pi)


def opposite(angle: Array) -> Array:
    """The opposite direction of an angle in (-2π, 2π), in (-π, π]."""
    return wrapped(angle - np.copysign(np.pi, angle))
