"""Solids: what a picture in space is built of, turned, shaded and sorted by the script.

A `Mesh` is data: corners in metres and the faces between them. A `Solid` is a body of parts at a
pose, `VIEW.solid(parts, R, at)`; only the pose's twelve numbers are computed with the figure's
symbols, so the entries of R get names: `R = steps.add("r", …)`. Faces that look away are not
drawn, the others from far to near. So parts are convex, or so thin that it does not show.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import cos, pi, sin
from typing import Any

from courseware.figures.declaration import Expr, Kind

Point3 = tuple[float, float, float]
Point2 = tuple[float, float]
Dot = tuple[float, float, float]

AXIS = "xyz"


@dataclass(frozen=True)
class Mesh:
    """Corners, and faces as places of corners, counter-clockwise for one who looks from outside.

    dots: what is printed on a face, by its place: discs, each (along the first edge, to the left
    of that, radius) in metres from the middle. smooth: without lines between the faces.
    """

    kind: Kind
    corners: tuple[Point3, ...]
    faces: tuple[tuple[int, ...], ...]
    dots: Mapping[int, Sequence[Dot]] = field(default_factory=dict)
    smooth: bool = False


@dataclass(frozen=True)
class Solid:
    """A body at a pose: R (3, 3) turns it, or stretches it, too; `at` is where its origin is.

    view: of the picture. floor: at which height its shadow falls, if it has one. opacity: below 1
    it is a ghost, of one colour. behind: how far it is put back, as a floor is.
    """

    parts: tuple[Mesh, ...]
    R: Any
    at: Sequence[Expr]
    view: tuple[Expr, Expr]
    floor: float | None = None
    opacity: float = 1.0
    behind: float = 0.0

    @property
    def kind(self) -> Kind:
        """The look of its first part."""
        return self.parts[0].kind

    @property
    def numbers(self) -> list[Expr]:
        """What is computed for it: the view's two angles, R row by row, the place."""
        return [*self.view, *self.R, *self.at]

    @property
    def data(self) -> list[dict[str, Any]]:
        """The parts as the script reads them."""
        return [
            {
                "kind": part.kind,
                "corners": [[round(x, 3) for x in corner] for corner in part.corners],
                "faces": [list(face) for face in part.faces],
                "dots": {str(k): [list(disc) for disc in d] for k, d in part.dots.items()},
                "smooth": part.smooth,
            }
            for part in self.parts
        ]


def place_corner(corner: Point3, along: str, at: Point3) -> Point3:
    """A corner with its third axis laid along x, y or z, and moved."""
    shift = AXIS.index(along) + 1
    x, y, z = corner[-shift:] + corner[:-shift]
    return x + at[0], y + at[1], z + at[2]


def loft(
    kind: Kind,
    low: Sequence[Point3],
    high: Sequence[Point3],
    along: str = "z",
    at: Point3 = (0, 0, 0),
    dots: Mapping[int, Sequence[Dot]] | None = None,
) -> Mesh:
    """The solid between two outlines of as many corners each, both counter-clockwise from above.

    Its faces: the lower one, the upper one, then the sides.
    """
    n = len(low)
    sides = [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
    corners = tuple(place_corner(corner, along, at) for corner in (*low, *high))
    return Mesh(kind, corners, (tuple(range(n))[::-1], tuple(range(n, 2 * n)), *sides), dots or {})


def box(
    kind: Kind,
    size: Point3,
    at: Point3 = (0, 0, 0),
    dots: Mapping[int, Sequence[Dot]] | None = None,
) -> Mesh:
    """A box around its middle. Faces: −z, +z, −y, +x, +y, −x."""
    x, y, z = (side / 2 for side in size)
    outline = ((-x, -y), (x, -y), (x, y), (-x, y))
    low, high = ([(*corner, end) for corner in outline] for end in (-z, z))
    return loft(kind, low, high, "z", at, dots)


def circle(n: int, radius: float, height: float) -> list[Point3]:
    """An outline of n corners on a circle."""
    angles = [2 * pi * k / n for k in range(n)]
    return [(radius * cos(a), radius * sin(a), height) for a in angles]


def cylinder(kind: Kind, radii: Point2, ends: Point2, along: str = "z", n: int = 16) -> Mesh:
    """A cylinder, or with two different radii a piece of a cone, from one end to the other."""
    low, high = (circle(n, r, end) for r, end in zip(radii, ends, strict=True))
    return loft(kind, low, high, along)


def plate(kind: Kind, outline: Sequence[Point2], thick: float, along: str = "z") -> Mesh:
    """A flat piece with any convex outline, counter-clockwise."""
    low, high = ([(*corner, end) for corner in outline] for end in (-thick / 2, thick / 2))
    return loft(kind, low, high, along)


def ring(kind: Kind, inner: float, outer: float, width: float, along: str) -> Mesh:
    """A flat ring about an axis."""
    n = 24
    rims = [(inner, -width / 2), (outer, -width / 2), (outer, width / 2), (inner, width / 2)]
    corners = [place_corner(corner, along, (0, 0, 0)) for rim in rims for corner in circle(n, *rim)]
    faces = [
        (n * a + k, n * a + (k + 1) % n, n * b + (k + 1) % n, n * b + k)
        for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))
        for k in range(n)
    ]
    return Mesh(kind, tuple(corners), tuple(faces), smooth=True)


def ball(kind: Kind) -> Mesh:
    """A ball of radius 1 m, of faces between circles of latitude."""
    n, rows = 16, 8
    heights = [(cos(pi * k / rows), sin(pi * k / rows)) for k in range(rows + 1)]
    corners = [c for z, r in heights for c in circle(n, r, z)]
    faces = [
        (n * row + k, n * (row + 1) + k, n * (row + 1) + (k + 1) % n, n * row + (k + 1) % n)
        for row in range(rows)
        for k in range(n)
    ]
    return Mesh(kind, tuple(corners), tuple(faces), smooth=True)


def tiles(height: float, half: float) -> Mesh:
    """A square of 4 × 4 tiles that look up."""
    n = 4
    ends = [half * (2 * k / n - 1) for k in range(n + 1)]
    corners = tuple((x, y, height) for y in ends for x in ends)
    faces = tuple(
        (k, k + 1, k + n + 2, k + n + 1)
        for j in range(n)
        for k in range(j * (n + 1), j * (n + 1) + n)
    )
    return Mesh("grid", corners, faces)


PIPS: dict[int, tuple[Point2, ...]] = {
    1: ((0, 0),),
    2: ((-1, -1), (1, 1)),
    3: ((-1, -1), (0, 0), (1, 1)),
    4: ((-1, -1), (-1, 1), (1, -1), (1, 1)),
    5: ((-1, -1), (-1, 1), (0, 0), (1, -1), (1, 1)),
    6: ((-1, -1), (-1, 0), (-1, 1), (1, -1), (1, 0), (1, 1)),
}
FACE_NUMBERS = (4, 3, 5, 1, 2, 6)  # on −z, +z, −y, +x, +y, −x: opposite faces add up to seven


def die(kind: Kind, side: float = 1.0) -> tuple[Mesh, ...]:
    """A die with 1, 2 and 3 towards x, y and z."""
    dots = {
        place: [(0.27 * side * a, 0.27 * side * b, 0.1 * side) for a, b in PIPS[number]]
        for place, number in enumerate(FACE_NUMBERS)
    }
    return (box(kind, (side, side, side), dots=dots),)
