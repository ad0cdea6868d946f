"""Solids: the bodies of a picture in space, turned, shaded and sorted by the script.

A `Mesh` is data: corners in metres and the faces between them. A `Solid` is a body of meshes at a
pose, `VIEW.solid(meshes, R, at)`; only the pose's twelve numbers are computed with the figure's
symbols, so the entries of R get names: `R = steps.add("r", …)`. Faces that look away are not
drawn, the others from far to near. So meshes are convex, or so thin that it does not show.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import cos, pi, sin
from typing import Any

from courseware.figures.declaration import Expr, Kind

Point2 = tuple[float, float]
Point3 = tuple[float, float, float]
Face = tuple[int, ...]


@dataclass(frozen=True)
class Mesh:
    """Corners, and faces as places of corners, counter-clockwise for one who looks from outside.

    Lines are drawn where a face meets one that looks away, or quite another way.

    Args:
        kind: the tone of a material, or a look.
        dots: discs printed on a face, by its place, each (along the first edge, to the left of
            that, radius) in metres from the middle, or with a tone after them.
        edge: the tone of its lines, by default its kind's.
    """

    kind: Kind
    corners: tuple[Point3, ...]
    faces: tuple[Face, ...]
    dots: Mapping[int, Sequence[tuple[Any, ...]]] = field(default_factory=dict)
    edge: str = ""


@dataclass(frozen=True)
class Solid:
    """A body at a pose: R (3, 3) turns it, or stretches it, too; `at` is where its origin is.

    view: of the picture. floor: at which height its shadow falls, if it has one. opacity: below 1
    it is a ghost, of one colour. behind: how far it is put back, as a floor is.
    """

    meshes: tuple[Mesh, ...]
    R: Any
    at: Sequence[Expr]
    view: tuple[Expr, Expr]
    floor: float | None = None
    opacity: float = 1.0
    behind: float = 0.0

    @property
    def numbers(self) -> list[Expr]:
        """The numbers that are computed for it: the view's two angles, R row by row, the place."""
        return [*self.view, *self.R, *self.at]

    @property
    def data(self) -> list[dict[str, Any]]:
        """The meshes as the script reads them."""
        return [
            vars(mesh) | {"corners": [[round(x, 3) for x in corner] for corner in mesh.corners]}
            for mesh in self.meshes
        ]


def loft(kind: Kind, low: Sequence[Point3], high: Sequence[Point3], along: str = "z") -> Mesh:
    """Return the solid between two outlines of n corners, both counter-clockwise from above.

    Its faces: the lower one, the upper one, then the sides.
    """
    n = len(low)
    ends = tuple(range(n))[::-1], tuple(range(n, 2 * n))
    return Mesh(kind, _turn((*low, *high), along), (*ends, *_band(n, 0, 1)))


def box(kind: Kind, size: Point3, at: Point3 = (0, 0, 0)) -> Mesh:
    """Return a box around a place. Faces: −z, +z, −y, +x, +y, −x."""
    (x, X), (y, Y), ends = ((c - side / 2, c + side / 2) for c, side in zip(at, size, strict=True))
    low, high = ([(x, y, end), (X, y, end), (X, Y, end), (x, Y, end)] for end in ends)
    return loft(kind, low, high)


def cylinder(kind: Kind, radii: Point2, ends: Point2, along: str = "z", n: int = 24) -> Mesh:
    """Return a cylinder from one end to the other; of two radii, a piece of a cone."""
    low, high = (_circle(n, r, end) for r, end in zip(radii, ends, strict=True))
    return loft(kind, low, high, along)


def plate(kind: Kind, outline: Sequence[Point2], thick: float, along: str = "z") -> Mesh:
    """Return a flat piece with any convex outline, counter-clockwise."""
    low, high = ([(*corner, end) for corner in outline] for end in (-thick / 2, thick / 2))
    return loft(kind, low, high, along)


def ring(kind: Kind, inner: float, outer: float, width: float, along: str) -> Mesh:
    """Return a flat ring about an axis."""
    n, half = 16, width / 2
    rims = (inner, -half), (outer, -half), (outer, half), (inner, half)
    corners = _turn([corner for rim in rims for corner in _circle(n, *rim)], along)
    low, outside, high, inside = (_band(n, rim, (rim + 1) % 4) for rim in range(4))
    flat = [  # two at a time, each from a corner of its own on
        (f[3], f[0], f[1], g[1], g[2], f[2])
        for side in (low, high)
        for f, g in zip(side[::2], side[1::2], strict=True)
    ]
    return Mesh(kind, corners, (*flat, *outside, *inside))  # the first of two draws their line


def ball(kind: Kind) -> Mesh:
    """Return a ball of radius 1 m, of faces between circles of latitude."""
    n, rows = 12, 6
    angles = [pi * k / rows for k in range(rows + 1)]
    corners = [corner for a in angles for corner in _circle(n, sin(a), cos(a))]
    # each from its upper left corner on
    faces = [f[-1:] + f[:-1] for row in range(rows) for f in _band(n, row + 1, row)]
    return Mesh(kind, tuple(corners), tuple(faces))


def _turn(corners: Sequence[Point3], along: str) -> tuple[Point3, ...]:
    """Lay the third axis of corners along x, y or z."""
    i, j, k = {"x": (2, 0, 1), "y": (1, 2, 0), "z": (0, 1, 2)}[along]
    return tuple((c[i], c[j], c[k]) for c in corners)


def _circle(n: int, radius: float, height: float) -> list[Point3]:
    angles = [2 * pi * k / n for k in range(n)]
    return [(radius * cos(a), radius * sin(a), height) for a in angles]


def _band(n: int, a: int, b: int) -> list[Face]:
    """Return the faces between two of several circles of n corners each."""
    pairs = ((k, (k + 1) % n) for k in range(n))
    return [(n * a + k, n * a + next_, n * b + next_, n * b + k) for k, next_ in pairs]
