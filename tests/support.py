"""What several tests share: strategies for inputs, and numbers compared, angles on the circle."""

import os
import shutil
from pathlib import Path

import hypothesis.strategies as st
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

ROOT = Path(__file__).resolve().parents[1]
EPS = np.finfo(float).eps  # 2.2e-16: one rounding of a number near 1

METHODS = ("exact", "midpoint", "start", "end")  # of paths


def python_of(environment):
    """The interpreter of a virtual environment."""
    return environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def find_command(package, *names):
    """Return the path of a command; skip the test that lacks it, and fail it where `CI` is set."""
    if path := next(filter(None, map(shutil.which, names)), None):
        return path
    missing = f"no {' or '.join(names)}: install Debian's package `{package}`"
    if os.environ.get("CI"):
        pytest.fail(missing)
    pytest.skip(missing)


def reals(low, high):
    """Finite floats in [low, high]."""
    return st.floats(low, high, allow_nan=False, allow_subnormal=False)


def vectors(size, low, high):
    """Lists of `size` finite floats in [low, high]."""
    return st.lists(reals(low, high), min_size=size, max_size=size)


angles = reals(-2 * np.pi, 2 * np.pi)
poses = st.tuples(reals(-10, 10), reals(-10, 10), angles).map(np.array)
twists = vectors(3, -3, 3).map(np.array)
rotations = (
    vectors(4, -1, 1)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: Rotation.from_quat(q).as_matrix())
)

# near-singular values on purpose: the point itself and its neighbours
NEAR_ZERO = [sign * 10.0**-k for k in range(3, 17) for sign in (1, -1)]


def floats(matrix):
    """A matrix of mpmath as an array."""
    return np.array(matrix.tolist(), dtype=float)


def on_circle(difference):
    """The size of an angle difference, measured round the circle."""
    return np.abs((np.asarray(difference) + np.pi) % (2 * np.pi) - np.pi)


def assert_angles(actual, expected, atol):
    """Angles equal on the circle to within atol (rad)."""
    assert np.shape(actual) == np.shape(expected)
    worst = np.max(on_circle(np.asarray(actual) - expected), initial=0.0)
    assert worst <= atol, f"angles differ by {worst:.3g} rad, allowed {atol:.3g}"


def assert_close(actual, expected, atol):
    """Numbers equal to within atol; infinities and NaN must be in the same places."""
    assert np.shape(actual) == np.shape(expected)
    np.testing.assert_allclose(actual, expected, rtol=0, atol=atol, equal_nan=True)


def normals(part):
    """The middle and the outward normal (not of length 1) of each face that has an area."""
    corners = np.array(part.corners)
    for face in part.faces:
        q = corners[list(face)]
        up = sum(np.cross(a, b) for a, b in zip(q, np.roll(q, -1, axis=0), strict=True))
        yield q.mean(axis=0), up


def luminance(color):
    """Relative luminance of `#rrggbb` or `#rgb`, as WCAG 2.2 defines it."""
    digits = color.lstrip("#")
    digits = digits if len(digits) == 6 else "".join(2 * d for d in digits)
    channels = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))


def contrast(first, second):
    """Contrast of two colours, 1 to 21."""
    high, low = sorted((luminance(first), luminance(second)), reverse=True)
    return (high + 0.05) / (low + 0.05)
