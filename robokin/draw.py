"""Still figures of robots with matplotlib, in the colours of `robokin.styles`; computes nothing.

`kind` is one of `styles.KINDS`, which gives colour, line and marker; a function that is given
another raises a `RobokinError`. `ax` is what `axes` returns. Points and poses have no
batch dimensions.

Examples
--------
>>> ax = axes(x=(-0.2, 0.2), y=(-0.1, 0.3))
>>> robot(ax, pose=[0, 0, 1.57], wheel_distance=0.1, wheel_radius=0.03)
>>> arrow(ax, tail=[0, 0], head=[0, 0.1], kind="velocity", label="$v$")
"""

from collections.abc import Sequence
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, FancyArrowPatch, Rectangle
from matplotlib.patheffects import withStroke
from matplotlib.transforms import Affine2D, Transform
from numpy.typing import NDArray

from robokin.errors import RobokinError
from robokin.styles import KINDS, Style

__all__ = ["arrow", "axes", "frame", "path", "point", "robot", "wheel"]

Vector = Sequence[float] | NDArray[np.float64]
READABLE = 12  # points: a digit is 8 px high where a phone shows five inches as 358 px
MARKERS = {"dot": "o", "ring": "o", "cross": "x", "square": "s", "diamond": "D"}


def style(kind: str) -> Style:
    """Return the style of a kind."""
    if kind not in KINDS:
        raise RobokinError(f"kind must be one of {', '.join(KINDS)}, got {kind!r}")
    return KINDS[kind]


def axes(x: Sequence[float], y: Sequence[float], width: float = 5.0) -> Axes:
    """Make empty axes in metres, one unit as long upwards as sideways.

    Parameters
    ----------
    x, y : sequence of float, shape (2,)
        Lowest and highest value shown, in m.
    width : float, default 5.0
        Width of the picture in inches.

    Returns
    -------
    matplotlib.axes.Axes
        Axes of a new figure.
    """
    height = width * (y[1] - y[0]) / (x[1] - x[0])
    _, ax = plt.subplots(figsize=(width, height), dpi=200, layout="constrained")
    ax.set(xlim=x, ylim=y, aspect="equal")
    ax.set_xlabel("$x$ [m]", fontsize=READABLE)
    ax.set_ylabel("$y$ [m]", fontsize=READABLE)
    ax.tick_params(labelsize=READABLE)
    ax.grid(color=style("grid").light)
    ax.set_axisbelow(True)
    return ax


def arrow(ax: Axes, tail: Vector, head: Vector, kind: str, label: str = "") -> None:
    """Draw an arrow with a label at its head.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    tail, head : array_like, shape (2,)
        Ends in m.
    kind : str
        Kind of the arrow.
    label : str, default ""
        Text.
    """
    _arrow(ax, (tail[0], tail[1]), (head[0], head[1]), kind, 14)
    _label(ax, head, label, style(kind))


def point(ax: Axes, at: Vector, kind: str, label: str = "") -> None:
    """Draw a marker at a point.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    at : array_like, shape (2,)
        Point in m.
    kind : str
        Kind of the point.
    label : str, default ""
        Text.
    """
    look = style(kind)
    face = "none" if look.marker == "ring" else look.light
    x, y = at
    ax.plot(x, y, MARKERS[look.marker], color=look.light, markerfacecolor=face, markersize=8, mew=2)
    _label(ax, at, label, look)


def path(ax: Axes, points: Sequence[Vector] | NDArray[np.float64], kind: str = "path") -> None:
    """Draw a line through points.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    points : array_like, shape (n, 2) or more columns
        Points in m: x and y are the first two columns.
    kind : str, default "path"
        Kind of the line.
    """
    look = style(kind)
    dash: Any = (0, look.dash) if look.dash else "-"
    columns = np.asarray(points).T
    ax.plot(columns[0], columns[1], color=look.light, linestyle=dash)


def frame(ax: Axes, pose: Vector, size: float) -> None:
    """Draw the x and y axes of a frame.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    pose : array_like, shape (3,)
        `[x, y, theta]` in m and rad.
    size : float
        Length of the axes in m.
    """
    place = _placed(ax, pose)
    for kind, x, y in (("x_axis", size, 0), ("y_axis", 0, size)):
        _arrow(ax, (0, 0), (x, y), kind, 12, transform=place)


def robot(
    ax: Axes, pose: Vector, wheel_distance: float, wheel_radius: float, kind: str = "body"
) -> None:
    """Draw a differential-drive robot from above: body, nose, left and right wheel.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    pose : array_like, shape (3,)
        `[x, y, theta]` in m and rad.
    wheel_distance, wheel_radius : float
        Sizes in m.
    kind : str, default "body"
        Kind of the body.
    """
    place, look = _placed(ax, pose), style(kind)
    body: Any = {"edgecolor": look.light, "facecolor": look.light + "18", "linewidth": 1.5}
    ax.add_patch(Circle((0, 0), 0.65 * wheel_distance, transform=place, **body))
    nose = [0.4 * wheel_distance, 0.58 * wheel_distance, 0.4 * wheel_distance]
    side = [-0.2 * wheel_distance, 0, 0.2 * wheel_distance]
    ax.plot(nose, side, color=look.light, linewidth=1.5, transform=place)
    for wheel, y in (("left", wheel_distance / 2), ("right", -wheel_distance / 2)):
        _wheel(ax, place, (2 * wheel_radius, 0.14 * wheel_distance), y, wheel)


def wheel(ax: Axes, pose: Vector, wheel_radius: float, kind: str = "body") -> None:
    """Draw a wheel from above that rolls along its pose's heading.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    pose : array_like, shape (3,)
        `[x, y, theta]` in m and rad.
    wheel_radius : float
        Radius in m.
    kind : str, default "body"
        Kind of the wheel.
    """
    _wheel(ax, _placed(ax, pose), (2 * wheel_radius, 0.6 * wheel_radius), 0.0, kind)


def _arrow(ax: Axes, tail: Any, head: Any, kind: str, head_size: float, **transform: Any) -> None:
    shape: Any = {"arrowstyle": "-|>", "mutation_scale": head_size, "shrinkA": 0, "shrinkB": 0}
    shape |= {"color": style(kind).light, "linewidth": 2}
    ax.add_patch(FancyArrowPatch(tail, head, **shape, **transform))


def _wheel(ax: Axes, place: Transform, size: tuple[float, float], y: float, kind: str) -> None:
    color, (length, width) = style(kind).light, size
    paint: Any = {"edgecolor": color, "facecolor": color + "66", "linewidth": 1.5}
    corner = (-length / 2, y - width / 2)
    ax.add_patch(Rectangle(corner, length, width, transform=place, **paint))


def _placed(ax: Axes, pose: Vector) -> Transform:
    """Coordinates of a body at a pose, as matplotlib turns and moves them."""
    x, y, theta = pose
    return Affine2D().rotate(float(theta)).translate(float(x), float(y)) + ax.transData


def _label(ax: Axes, at: Vector, text: str, look: Style) -> None:
    x, y, *_ = at
    halo = withStroke(linewidth=3, foreground="white")  # lines behind it do not strike it through
    ax.annotate(
        text, (x, y), xytext=(6, 4), textcoords="offset points",
        color=look.light, fontsize=13, path_effects=[halo],
    )  # fmt: skip
