"""Angles that are solved for, brought into (-π, π] without a digit lost."""

import numpy as np

from robokin._arrays import Array


def from_minus_pi(angle: Array) -> Array:
    """Bring an angle in (-3π, π] into (-π, π]."""
    up: Array = angle + 2 * np.pi * (angle <= -np.pi)
    return up


def opposite(angle: Array) -> Array:
    """Return the opposite direction of an angle in (-2π, 2π), in (-π, π]."""
    return from_minus_pi(angle - np.copysign(np.pi, angle))
