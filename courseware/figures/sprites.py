"""Sprites: what a flat picture shows as it looks from outside, a robot, a wheel, a kerb.

A function of a chapter or of the course returns a `Sprite`: outlines in metres, x ahead and y to
the left, painted in the order of their declaration, and sprites in it that move::

    def robot(pose, roll=0):
        wheels = [Sprite((0, y, 0), (*TYRE, Rim(0.03, 20, (TREAD,), roll))) for y in (0.05, -0.05)]
        return Sprite(pose, (BODY, *wheels, NOSE), height=0.01)

Outlines are constant and enter the picture once; each frame sets the places of sprites only. Their
paint is a name of the course's materials, or of its looks.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from fontTools.pens.recordingPen import RecordingPen
from fontTools.svgLib.path import parse_path

from courseware.errors import CourseError
from courseware.figures.computed_parts import Expr

LOOKS = ("", "ghost", "wrong")


@dataclass(frozen=True)
class Outline:
    """An outline that is filled, or drawn as a line, or both.

    Args:
        path: as in SVG, in metres.
        fill, edge: materials; without one, nothing is painted.
        width: of the edge, in metres; 0 is as wide as outlines are in every picture.
        opacity: below 1 what lies under it shines through.
    """

    path: str
    fill: str = ""
    edge: str = ""
    width: float = 0.0
    opacity: float = 1.0


@dataclass(frozen=True)
class Rim:
    """Copies of outlines round the rim of a wheel that is seen from above; they run as it rolls.

    The wheel rolls ahead, along x.

    Args:
        radius: on which they run, m.
        count: how many there are all round, half of them out of sight.
        outlines: of the one on top; towards the sides it looks ever shorter.
        roll: how far the wheel has rolled, m.
        thickness: how thick each is, as a part of its length: so long is what is seen at the sides.
    """

    radius: float
    count: int
    outlines: tuple[Outline, ...]
    roll: Expr = 0
    thickness: float = 0.0


@dataclass(frozen=True)
class Sprite:
    """Outlines at a place: (x, y, angle) in the picture, or in the sprite that it is a part of.

    Args:
        at: its place; a place that is no number hides it.
        parts: outlines, rims and sprites in it, from below to above.
        height: its height above the ground, m: so long is its shadow; 0: without one.
        look: "ghost" is pale, "wrong" is red and hatched.
        size: how many times as large as declared.
        silhouette: the path that is its shadow and the line round a ghost; by default that of its
            first outline; "": none.
        window: what is seen of it, (x_low, x_high, y_low, y_high) in the picture; all, if empty.
    """

    at: tuple[Expr, Expr, Expr]
    parts: tuple[Any, ...]
    height: float = 0.0
    look: str = ""
    size: Expr = 1
    silhouette: str | None = None
    window: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if self.look not in LOOKS:
            raise CourseError(f"a sprite looks {self.look!r}; it can look {', '.join(LOOKS[1:])}")
        if self.silhouette is None:
            outlines = (part.path for part in self.parts if isinstance(part, Outline))
            object.__setattr__(self, "silhouette", next(outlines, ""))


def list_corners(path: str) -> list[list[float]]:
    """Return the corners of the first outline of a path, and points on its bends."""
    pen = RecordingPen()
    parse_path(path.partition("z")[0], pen)  # arcs become curves
    found: list[complex] = []
    for _, points in pen.value:
        curve = [*found[-1:], *(complex(*point) for point in points)]
        for share in (1 / 3, 2 / 3) if len(points) > 1 else ():
            parts = curve
            while len(parts) > 1:
                parts = [a + share * (b - a) for a, b in pairwise(parts)]
            found += parts
        found += curve[-1:] if points else []
    return [[round(x.real, 4), round(x.imag, 4)] for x in found]


@dataclass(frozen=True)
class Gradient:
    """A material with form: tones across it ("x"), up it ("y") or out of its middle ("r").

    stops: (part of the way, tone) or (part, tone, opacity).
    """

    way: str
    stops: tuple[tuple[Any, ...], ...]


@dataclass(frozen=True)
class Ground:
    """The ground of a picture.

    Args:
        fill: a tone or gradient.
        tone: the tone round letters and arrows.
        seam, light: the tones of the lines between its tiles and beside them; without: no tiles.
    """

    fill: str
    tone: str
    seam: str = ""
    light: str = ""


@dataclass(frozen=True)
class Materials:
    """The materials of a course.

    tones: by name, a colour on a light and one on a dark page.
    grounds: programs are pictured on the first one, in space on the second.
    """

    tones: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    gradients: Mapping[str, Gradient] = field(default_factory=dict)
    grounds: Mapping[str, Ground] = field(default_factory=dict)
