"""Pictures in space: what a viewer sees, and what is painted over what."""

import re

import numpy as np
import pytest
import sympy as sp
from figure_numbers import N
from small_figures import a, painted, small_figure, space_figure
from support import EPS, assert_close
from verification import evaluate_exactly

from courseware.figures import VIEW, Arrow, Line, Point
from robokin import euler


def test_a_view_is_a_rotation():
    """Right, up and towards the viewer: the axes of a frame turned about z, then its new x."""
    angles = np.random.default_rng(8).uniform([-np.pi, -np.pi / 2], [np.pi, np.pi / 2], (N, 2))
    seen = [sp.Matrix([*VIEW.project(axis), VIEW.depth(axis)]) for axis in np.eye(3, dtype=int)]
    rows = evaluate_exactly(sp.Matrix.hstack(*seen), VIEW.angles, angles).reshape(N, 3, 3)
    turns = np.stack([angles[:, 0] + np.pi / 2, np.pi / 2 - angles[:, 1]], axis=-1)
    expected = np.swapaxes(euler.to_matrix("ZX", turns), 1, 2)
    # two roundings of angles up to 5 rad, of sine and cosine, and one product
    assert_close(rows.astype(float), expected, atol=8 * EPS)


@pytest.mark.parametrize(
    ("azimuth", "elevation", "order"),
    [
        (30, 20, ["z_axis", "y_axis", "x_axis"]),
        (80, 20, ["x_axis", "z_axis", "y_axis"]),
        (30, 80, ["y_axis", "x_axis", "z_axis"]),
        (-150, 20, ["x_axis", "y_axis", "z_axis"]),
    ],
)
def test_nearer_shapes_are_painted_later(azimuth, elevation, order):
    figure = space_figure(shapes=VIEW.frame(sp.eye(3)))
    axes = painted(figure, azimuth=azimuth, elevation=elevation)
    assert list(dict.fromkeys(axes)) == order


def test_a_curve_passes_behind_and_in_front():
    axis = VIEW.line("z_axis", [(0, 0, -1), (0, 0, 1)])
    pieces = painted(space_figure(shapes=(axis, space_figure().shapes[3])), elevation=20)
    middle = pieces.index("z_axis")
    assert pieces == ["path"] * middle + ["z_axis"] + ["path"] * (len(pieces) - middle - 1)
    assert len(pieces) == 96 / 4 + 1
    assert abs(middle - 12) <= 1


def test_shapes_without_depth_keep_their_place():
    first, last = Point("left", (0, 0)), Point("right", (0, 0))
    near, far = Point("icr", (0, 0), depth=1), Point("ghost", (0, 0), depth=-1)
    assert painted(space_figure(shapes=(first, near, far, last))) == [
        "left",
        "ghost",
        "icr",
        "right",
    ]
    same = (Point("icr", (0, 0), depth=1), Point("ghost", (0, 0), depth=1))
    assert painted(space_figure(shapes=same)) == ["icr", "ghost"]


@pytest.mark.parametrize("depth", [sp.nan, sp.oo])
def test_a_shape_at_no_depth_is_not_painted(depth):
    shapes = (Point("icr", (0, 0), depth=depth), Point("left", (0, 0), depth=0))
    assert painted(space_figure(shapes=shapes)) == ["left"]


def test_what_is_in_front_leaves_a_gap():
    """A line in space is drawn on a wider one in the colour of the ground, a flat one is not.

    An arrow is, wherever it is: it must be seen on all things.
    """
    gaps = r"fill:none;stroke:var\(--rk-ground"
    assert len(re.findall(gaps, space_figure(shapes=VIEW.frame(sp.eye(3))).render_svg())) == 3
    assert (
        len(re.findall(gaps, space_figure(shapes=(space_figure().shapes[3],)).render_svg()))
        == 96 / 4
    )
    flat = small_figure(shapes=(Line("path", ((0, 0), (a, 1))),))
    assert re.findall(gaps, flat.render_svg()) == []


def test_a_frame_in_space_is_three_arrows():
    arrows = VIEW.frame(sp.eye(3), at=(0, 0, 1), size=2, labels=("x", "y", "z"))
    assert [arrow.kind for arrow in arrows] == ["x_axis", "y_axis", "z_axis"]
    assert [arrow.label for arrow in arrows] == ["x", "y", "z"]
    assert arrows[2] == Arrow(
        "z_axis", VIEW.project((0, 0, 1)), VIEW.project((0, 0, 3)), "z", VIEW.depth((0, 0, 2))
    )
