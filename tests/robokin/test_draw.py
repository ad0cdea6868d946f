"""Still figures: what is asked for is drawn, where it was asked for, in its kind's look."""

import warnings

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.patches import Circle, FancyArrowPatch, Rectangle

from robokin import draw
from robokin.errors import RobokinError
from robokin.styles import KINDS

mpl.use("agg")


@pytest.fixture
def ax():
    axes = draw.axes(x=(-1, 1), y=(-0.5, 1))
    yield axes
    plt.close(axes.figure)


def patches(ax, kind):
    return [patch for patch in ax.patches if isinstance(patch, kind)]


def test_axes_show_what_was_asked_in_equal_units(ax):
    assert ax.get_xlim() == (-1, 1)
    assert ax.get_ylim() == (-0.5, 1)
    assert ax.get_aspect() == 1
    width, height = ax.figure.get_size_inches()
    assert height / width == pytest.approx(1.5 / 2)


def test_robot_stands_at_its_pose(ax):
    draw.robot(ax, [0.3, 0.2, np.pi / 2], wheel_distance=0.4, wheel_radius=0.1)
    to_world = ax.transData.inverted()
    (body,) = patches(ax, Circle)
    centre = to_world.transform(body.get_transform().transform((0, 0)))
    np.testing.assert_allclose(centre, [0.3, 0.2], atol=1e-12)  # pixels and back: roundings
    left, right = patches(ax, Rectangle)
    for wheel, y in ((left, 0.2), (right, -0.2)):
        corners = wheel.get_transform().transform([(0, 0), (1, 1)])
        centre = to_world.transform(corners.mean(axis=0))
        np.testing.assert_allclose(centre, [0.3 - y, 0.2], atol=1e-12)
    assert to_hex(left.get_edgecolor()) == KINDS["left"].light
    assert to_hex(right.get_edgecolor()) == KINDS["right"].light


def test_wheel_stands_at_its_pose(ax):
    draw.wheel(ax, [0.3, 0.2, np.pi / 2], wheel_radius=0.1, kind="left")
    (wheel,) = patches(ax, Rectangle)
    to_world = ax.transData.inverted()
    corners = to_world.transform(wheel.get_transform().transform([(0, 0), (1, 1)]))
    np.testing.assert_allclose(corners.mean(axis=0), [0.3, 0.2], atol=1e-12)  # as above
    np.testing.assert_allclose(abs(corners[1] - corners[0]), [0.06, 0.2], atol=1e-12)
    assert to_hex(wheel.get_edgecolor()) == KINDS["left"].light


def test_arrow_point_and_path(ax):
    draw.arrow(ax, [0, 0], [0.5, 0.5], "velocity", "$v$")
    (arrow,) = patches(ax, FancyArrowPatch)
    assert to_hex(arrow.get_edgecolor()) == KINDS["velocity"].light
    assert [text.get_text() for text in ax.texts] == ["$v$"]
    draw.point(ax, [0.1, 0.2], "icr", "ICR")
    assert ax.lines[-1].get_marker() == "x"
    draw.path(ax, np.array([[0, 0, 0], [1, 2, 0.1]]), "approximation")
    np.testing.assert_array_equal(ax.lines[-1].get_xydata(), [[0, 0], [1, 2]])
    assert ax.lines[-1].get_linestyle() == "--"


def test_frame_has_two_axes(ax):
    draw.frame(ax, [0, 0, 0.3], size=0.2)
    colors = [to_hex(patch.get_edgecolor()) for patch in patches(ax, FancyArrowPatch)]
    assert colors == [KINDS["x_axis"].light, KINDS["y_axis"].light]


def test_an_unknown_kind_is_refused(ax):
    with pytest.raises(RobokinError, match=r"kind must be one of left, right, .*, got 'blue'"):
        draw.point(ax, [0, 0], "blue")


@pytest.mark.parametrize(
    "kinds",
    [
        ("left", "right"),
        ("x_axis", "y_axis", "z_axis"),
        ("old_heading", "new_heading", "middle_heading"),
        ("path", "approximation", "error"),
    ],
)
def test_kinds_that_are_compared_differ_by_more_than_colour(kinds):
    assert len({(KINDS[kind].dash, KINDS[kind].marker) for kind in kinds}) == len(kinds)


def test_drawing_warns_of_nothing(ax):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        draw.robot(ax, [0, 0, 0], 0.2, 0.05)
        ax.figure.canvas.draw()
