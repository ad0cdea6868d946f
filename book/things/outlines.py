"""Paths for the outlines of things, in metres: x ahead, y to the left."""

from collections.abc import Callable, Sequence
from math import cos, dist, pi, sin

Point = tuple[float, float]


def _number(x: float) -> str:
    return f"{round(x, 5):g}"


def _at(x: float, y: float) -> str:
    return f"{_number(x)} {_number(y)}"


def disc(radius: float, x: float = 0, y: float = 0) -> str:
    """Return a circle."""
    r = _number(radius)
    arc = f"a{r} {r} 0 1 0 "
    return f"M{_at(x - radius, y)}{arc}{_number(2 * radius)} 0{arc}{_number(-2 * radius)} 0z"


def box(long: float, wide: float, x: float = 0, y: float = 0, corner: float = 0) -> str:
    """Return a rectangle round (x, y), with round corners."""
    a, b, r = long / 2 - corner, wide / 2 - corner, _number(corner)
    turn = f"a{r} {r} 0 0 1 "
    c, across, up = corner, _number(2 * a), _number(2 * b)
    if not c:
        return polygon(((x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)))
    return (
        f"M{_at(x - a, y - b - c)}h{across}{turn}{_at(c, c)}v{up}{turn}{_at(-c, c)}"
        f"h-{across}{turn}{_at(-c, -c)}v-{up}{turn}{_at(c, -c)}z"
    )


def polygon(corners: Sequence[Point]) -> str:
    """Return a closed outline with straight sides."""
    return "M" + "L".join(_at(*corner) for corner in corners) + "z"


def line(*points: Point) -> str:
    """Return straight pieces."""
    return "M" + "L".join(_at(*point) for point in points)


def sector(inner: float, outer: float, low: float, high: float) -> str:
    """Return the part of a ring between two angles."""
    (a, b), large = ((cos(t), sin(t)) for t in (low, high)), int(high - low > pi)
    start, far = (inner * a[0], inner * a[1]), (outer * a[0], outer * a[1])
    end, back = (outer * b[0], outer * b[1]), (inner * b[0], inner * b[1])
    r, s = _number(outer), _number(inner)
    return (
        f"M{_at(*start)}L{_at(*far)}A{r} {r} 0 {large} 1 {_at(*end)}"
        f"L{_at(*back)}A{s} {s} 0 {large} 0 {_at(*start)}z"
    )


def capsule(length: float, start: float, end: float) -> str:
    """Return a link: discs of two radii, at the origin and `length` ahead, and their tangents."""
    k = (start - end) / length
    s = (1 - k * k) ** 0.5
    r, q = _number(start), _number(end)
    return (
        f"M{_at(start * k, start * s)}L{_at(length + end * k, end * s)}"
        f"A{q} {q} 0 0 0 {_at(length + end * k, -end * s)}L{_at(start * k, -start * s)}"
        f"A{r} {r} 0 0 0 {_at(start * k, start * s)}z"
    )


def curves(start: Point, *pieces: Sequence[Point], side: int = 1, closed: bool = True) -> str:
    """Return an outline of pieces: to a point straight on, or by one or two control points to it.

    side: -1 mirrors it at the x axis.
    """
    marks = {1: "L", 2: "Q", 3: "C"}
    told = (marks[len(p)] + " ".join(_at(x, side * y) for x, y in p) for p in pieces)
    return f"M{_at(start[0], side * start[1])}{''.join(told)}{'z' * closed}"


def mirrored(first: Point, pieces: Sequence[Sequence[Point]]) -> str:
    """Return an outline that is alike on both sides of the x axis, from its left half.

    The half starts and ends on the axis; its pieces are those of `curves`.
    """
    ends = [first, *(piece[-1] for piece in pieces)]
    back = [
        [(x, -y) for x, y in (*piece[-2::-1], end)]
        for piece, end in zip(pieces[::-1], ends[-2::-1], strict=True)
    ]
    return curves(first, *pieces, *back)


def rounded(corners: Sequence[Point], radius: float) -> str:
    """Return a convex outline with straight sides and round corners."""
    pieces = []
    for before, corner, after in zip(
        (corners[-1], *corners[:-1]), corners, (*corners[1:], corners[0]), strict=True
    ):
        pieces += [[_towards(corner, before, radius)], [corner, _towards(corner, after, radius)]]
    return curves(pieces[0][0], *pieces[1:])


def ring(path: Callable[[float], str], count: int) -> str:
    """Return copies of an outline all round, each from its angle."""
    return "".join(path(2 * pi * k / count) for k in range(count))


def spots(radius: float, angles: Sequence[float], size: float, x: float = 0) -> str:
    """Return small discs on a circle about (x, 0)."""
    return "".join(disc(size, x + radius * cos(a), radius * sin(a)) for a in angles)


def _towards(start: Point, end: Point, way: float) -> Point:
    part = way / dist(start, end)
    return start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])
