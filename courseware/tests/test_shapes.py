"""Shapes that hold more than their own numbers: samples of a table."""

import re

import numpy as np
import pytest
import sympy as sp
from small_figures import a, small_figure

from courseware.figures import Cloud

east, north = sp.symbols("east north")
TABLE = tuple(map(tuple, np.random.default_rng(7).normal(0, 0.2, (200, 2)).tolist()))
CLOUD = Cloud("path", (a + east, north), (east, north), TABLE)


def test_a_cloud_is_one_path_with_a_dot_for_each_row():
    """Each at its place: half a metre to the right of the table's, in a view of 2 m."""
    width = 460.0
    [path] = re.findall(
        r'd="((?:M[-\d.]+ [-\d.]+h0){200})"', small_figure(shapes=(CLOUD,)).render_svg(460)
    )
    found = np.array(re.findall(r"M([-\d.]+) ([-\d.]+)h0", path), dtype=float)
    east_of, north_of = np.array(TABLE).T
    wanted = np.column_stack([1.5 + east_of, 1 - north_of]) * width / 2
    assert found == pytest.approx(wanted, abs=0.006)  # two digits are printed
