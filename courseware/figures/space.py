"""Pictures in space: points as seen from far away, by a viewer who can walk round.

`VIEW` is two angles, so whatever it shows is an ordinary expression of them. A figure with its
shapes gets the two angles as its last sliders, and is turned by dragging, too. Nearer shapes are
painted later: those with a depth change places among themselves, and a `Curve` whose depth runs
along it is sorted piece by piece.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import pi
from typing import Any, TypeVar

import sympy as sp

from courseware.equations.quantities import declarations
from courseware.figures import solids
from courseware.figures.computed_parts import Expr, Place
from courseware.figures.controls import Slider
from courseware.figures.shapes import Arrow, Line, Point

Triple = Sequence[Any]

quantity, _ = declarations(__name__)

azimuth = quantity("azimuth", "rad", -3.14, 3.14, "direction of the view: about z, from x")
elevation = quantity("elevation", "rad", -1.57, 1.57, "direction of the view: above x, y")

AXES = ("x_axis", "y_axis", "z_axis")  # kinds
ORIGIN = (0, 0, 0)

Shape = TypeVar("Shape", Line, Point)


def bring_forward(shape: Shape, by: float) -> Shape:
    """Return a shape that is painted as if it were nearer to the viewer by so many metres."""
    return replace(shape, depth=shape.depth + by)


@dataclass(frozen=True)
class View:
    """The view of a viewer at an azimuth and an elevation, without perspective."""

    azimuth: Expr
    elevation: Expr

    @property
    def angles(self) -> tuple[Expr, Expr]:
        """The two angles."""
        return self.azimuth, self.elevation

    def project(self, point: Triple) -> Place:
        """Return where the picture shows a point: to the right and up, in its unit."""
        x, y, z = point
        right = y * sp.cos(self.azimuth) - x * sp.sin(self.azimuth)
        return right, z * sp.cos(self.elevation) - self._ahead(point) * sp.sin(self.elevation)

    def depth(self, point: Triple) -> Expr:
        """Return how far a point lies towards the viewer: larger is nearer."""
        return self._ahead(point) * sp.cos(self.elevation) + point[2] * sp.sin(self.elevation)

    def _ahead(self, point: Triple) -> Expr:
        return point[0] * sp.cos(self.azimuth) + point[1] * sp.sin(self.azimuth)

    def point(self, kind: str, at: Triple, label: str = "") -> Point:
        """Return a marker in space."""
        return Point(kind, self.project(at), label, depth=self.depth(at))

    def line(self, kind: str, points: Sequence[Triple]) -> Line:
        """Return straight pieces in space, as deep as the mean of their points."""
        return Line(kind, tuple(map(self.project, points)), depth=self.depth(_mean(*points)))

    def arrow(self, kind: str, tail: Triple, head: Triple, label: str = "") -> Arrow:
        """Return an arrow in space, as deep as its middle."""
        ends = self.project(tail), self.project(head)
        return Arrow(kind, *ends, label, depth=self.depth(_mean(tail, head)))

    def solid(
        self, meshes: Sequence[solids.Mesh], R: Any, at: Triple = ORIGIN, **more: Any
    ) -> solids.Solid:
        """Return a body at a pose, with `floor`, `opacity` and `behind` as in `Solid`."""
        return solids.Solid(tuple(meshes), R, at, self.angles, **more)

    def frame(
        self, R: Any, at: Triple = ORIGIN, size: Expr = 1, labels: Sequence[str] = ("", "", "")
    ) -> tuple[Arrow, ...]:
        """Return the axes of a frame at a place: the columns of R (3, 3)."""
        R = sp.Matrix(R)
        heads = [[at[k] + size * R[k, axis] for k in range(3)] for axis in range(3)]
        return tuple(self.arrow(*each) for each in zip(AXES, [at] * 3, heads, labels, strict=True))


def _mean(*points: Triple) -> Triple:
    return [sum(column) / sp.Integer(len(points)) for column in zip(*points, strict=True)]


VIEW = View(azimuth, elevation)


def view_sliders(azimuth_start: float, elevation_start: float) -> tuple[Slider, ...]:
    """Return sliders of `VIEW`: all round, and from straight below to straight above."""
    step = pi / 180
    return (
        Slider(azimuth, -pi, pi, azimuth_start, step, "view: from which side"),
        Slider(elevation, -pi / 2, pi / 2, elevation_start, step, "view: how high"),
    )
