"""Shapes that hold more than their own numbers: samples of a table, the line of a pen."""

import re

import numpy as np
import pytest
import sympy as sp
from small_figures import a, small_figure

from courseware.figures import Cloud, Ink

pytest_plugins = ["figure_page"]

east, north = sp.symbols("east north")
TABLE = tuple(map(tuple, np.random.default_rng(7).normal(0, 0.2, (200, 2)).tolist()))
CLOUD = Cloud("path", (a + east, north), (east, north), TABLE)
PEN = Ink("path", (a, sp.Piecewise((a**2, a < 0.75), (sp.nan, True))))


def test_a_cloud_is_one_path_with_a_dot_for_each_row():
    """Each at its place: half a metre to the right of the table's, in a view of 2 m."""
    width = 460.0
    [path] = re.findall(
        r'd="((?:M[-\d.]+ [-\d.]+h0){200})"', small_figure(scene=(CLOUD,)).render_svg(460)
    )
    found = np.array(re.findall(r"M([-\d.]+) ([-\d.]+)h0", path), dtype=float)
    east_of, north_of = np.array(TABLE).T
    wanted = np.column_stack([1.5 + east_of, 1 - north_of]) * width / 2
    assert found == pytest.approx(wanted, abs=0.006)  # two digits are printed


@pytest.mark.browser
def test_a_pen_leaves_ink_until_a_reset(alone):
    """Where it was in each frame; lifted, and put down again, it begins a new line."""
    with alone(small_figure(scene=(PEN,))) as live:

        def drawn():
            line = live.picture.locator(":is(path, polyline)[style*='--rk-path']").first
            return line.evaluate("(line) => line.getAttribute('d') ?? line.getAttribute('points')")

        for x in (0.1, 0.2, 0.2, 0.9, 0.3):
            live.put([x])
        line = drawn()
        assert re.findall("[ML]", line) == ["M", "L", "L", "M"]
        corners = np.array(re.findall(r"[ML]([-\d.]+) ([-\d.]+)", line), dtype=float)
        scale = live.picture.evaluate("(svg) => svg.viewBox.baseVal.width") / 2
        x = np.array([0.5, 0.1, 0.2, 0.3])
        assert corners == pytest.approx(np.column_stack([1 + x, 1 - x**2]) * scale, abs=0.006)
        live.root.locator(".rk-reset").click()
        live.state()
        assert len(drawn().split()) == 2
