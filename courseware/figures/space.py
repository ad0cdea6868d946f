"""Pictures in space: points as seen from far away, by a viewer who can walk round.

`VIEW` is two angles, so whatever it shows is an ordinary expression of them. A figure with such
shapes gets the two angles as its last sliders, and is turned by hand, too. Nearer shapes are
painted later: those with a depth change places among themselves, and a `Curve` whose depth runs
along it is sorted piece by piece.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import pi
from typing import Any, TypeVar

import sympy as sp

from courseware.equations.quantities import quantity
from courseware.figures import solids
from courseware.figures.declaration import Arrow, Expr, Line, Place, Point, Slider

Triple = Sequence[Any]

azimuth = quantity("azimuth", "rad", -3.14, 3.14, "where a viewer stands: about z, from x")
elevation = quantity("elevation", "rad", -1.57, 1.57, "where a viewer stands: above the x, y plane")

AXES = ("x_axis", "y_axis", "z_axis")  # kinds
ORIGIN = (0, 0, 0)
IDENTITY = sp.eye(3)


Shape = TypeVar("Shape", Line, Point)


def bring_forward(shape: Shape, by: float) -> Shape:
    """The same shape, painted as if it were so far nearer to the viewer, in m; below 0 behind."""
    return replace(shape, depth=shape.depth + by)


@dataclass(frozen=True)
class View:
    """What a viewer at an azimuth and an elevation sees of things in space, without perspective."""

    azimuth: Expr
    elevation: Expr

    @property
    def angles(self) -> tuple[Expr, Expr]:
        """The two angles."""
        return self.azimuth, self.elevation

    def project(self, point: Triple) -> Place:
        """Where the picture shows a point: to the right and up, in its unit."""
        x, y, z = point
        away = x * sp.cos(self.azimuth) + y * sp.sin(self.azimuth)
        right = y * sp.cos(self.azimuth) - x * sp.sin(self.azimuth)
        return right, z * sp.cos(self.elevation) - away * sp.sin(self.elevation)

    def depth(self, point: Triple) -> Expr:
        """How far a point lies towards the viewer: larger is nearer."""
        x, y, z = point
        away = x * sp.cos(self.azimuth) + y * sp.sin(self.azimuth)
        return away * sp.cos(self.elevation) + z * sp.sin(self.elevation)

    def point(self, kind: str, at: Triple, label: str = "") -> Point:
        """A marker in space."""
        return Point(kind, self.project(at), label, depth=self.depth(at))

    def line(self, kind: str, points: Sequence[Triple]) -> Line:
        """Straight pieces in space, as deep as the mean of their points."""
        middle = [sum(column) / sp.Integer(len(points)) for column in zip(*points, strict=True)]
        return Line(kind, tuple(map(self.project, points)), depth=self.depth(middle))

    def arrow(self, kind: str, tail: Triple, head: Triple, label: str = "") -> Arrow:
        """An arrow in space, as deep as its middle."""
        middle = [(a + b) / sp.Integer(2) for a, b in zip(tail, head, strict=True)]
        ends = self.project(tail), self.project(head)
        return Arrow(kind, *ends, label, depth=self.depth(middle))

    def solid(
        self, parts: Sequence[solids.Mesh], R: Any, at: Triple = ORIGIN, **more: Any
    ) -> solids.Solid:
        """A body of parts at a pose; `floor`, `opacity` and `behind` as `Solid` says."""
        return solids.Solid(tuple(parts), R, at, self.angles, **more)

    def floor(self, height: float, half: float, at: Triple = ORIGIN) -> solids.Solid:
        """A floor of square tiles, for shadows to fall on; it is not seen from below."""
        return self.solid([solids.tiles(height, half)], IDENTITY, at, opacity=0.5, behind=200.0)

    def right_of_origin(self, distance: Expr) -> Triple:
        """The place so far to the right in the picture, from wherever one looks."""
        return -distance * sp.sin(self.azimuth), distance * sp.cos(self.azimuth), 0

    def frame(
        self, R: Any, at: Triple = ORIGIN, size: Expr = 1, labels: Sequence[str] = ("", "", "")
    ) -> tuple[Arrow, ...]:
        """The axes of a frame: the columns of R (3, 3), drawn from `at`."""
        R = sp.Matrix(R)
        heads = [[at[k] + size * R[k, axis] for k in range(3)] for axis in range(3)]
        return tuple(self.arrow(*each) for each in zip(AXES, [at] * 3, heads, labels, strict=True))


VIEW = View(azimuth, elevation)


def view_sliders(azimuth_start: float, elevation_start: float) -> tuple[Slider, ...]:
    """The two angles of `VIEW` under the hand: all round, and from straight below to above."""
    return (
        Slider(azimuth, -pi, pi, start=azimuth_start, step=pi / 180, label="view: from which side"),
        Slider(
            elevation, -pi / 2, pi / 2, start=elevation_start, step=pi / 180, label="view: how high"
        ),
    )
