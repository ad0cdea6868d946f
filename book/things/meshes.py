"""Shapes of solids: boxes, cylinders, plates, rings and balls, as meshes."""

from collections.abc import Sequence
from math import cos, pi, sin

from courseware.figures.computed_parts import Kind
from courseware.figures.solids import Face, Mesh, Point3

Point2 = tuple[float, float]


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


def ball(kind: Kind, n: int = 12, rows: int = 6) -> Mesh:
    """Return a ball of radius 1 m, of n faces between each two circles of latitude."""
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
