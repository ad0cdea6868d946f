"""The arm: any number of links, with a gripper or a pen, from above or from the side."""

from collections.abc import Sequence
from itertools import pairwise
from math import pi
from typing import Any

from sympy import atan2, sqrt

from book.things.outlines import box, capsule, curves, disc, line, polygon, spots
from courseware.errors import CourseError
from courseware.figures import Outline, Sprite

THICK = 0.06  # of the first link's radius, as a part of the arm's length


def arm(
    place: Any,
    angles: Sequence[Any],
    lengths: Sequence[float],
    tool: str = "gripper",
    opening: Any = 1,
    base: str = "plate",
    look: str = "",
    shoulder: float = 0.14,
) -> Sprite:
    """Return an arm with joints at these angles, each against the link before it.

    The last length goes to the point that the tool works at: between the fingers, the pen's tip.

    Args:
        place: of the first joint.
        tool: "gripper", "pen" or "".
        opening: of the gripper, from 0 to 1.
        base: "plate" as seen from above, "stand" as seen from the side, or "".
        shoulder: how high the first joint is above the foot of the stand, m.
    """
    if len(angles) != len(lengths):
        raise CourseError(f"an arm has a length for each angle, got {angles} and {lengths}")
    thick, last = THICK * sum(lengths), len(lengths) - 1
    radii = [thick * (1 - 0.52 * k / len(lengths)) for k in range(len(lengths) + 1)]
    at_end: Sprite = TOOLS[tool](lengths[-1], radii[-1], opening)
    for k in range(last, -1, -1):
        joint = (lengths[k - 1] if k else 0, 0, angles[k])
        outlines = list(_link(at_end.at[0], radii[k], radii[k + 1], k == last and bool(tool)))
        if k == 0:
            outlines += _cover(0.8 * thick)
        if k < last:  # over both of its links
            outlines += _cover(0.8 * radii[k + 1], lengths[k])
        at_end = Sprite(joint, (at_end, *outlines), thick)
    return Sprite(place, (*BASES[base](thick, shoulder), at_end), 0.5 * thick, look, silhouette="")


def _link(long: float, start: float, end: float, pale: bool) -> tuple[Outline, ...]:
    tube, edge, slot, lit = (
        ("tube_pale", "edge", "shell_dark", "shell")
        if pale
        else ("tube", "accent_edge", "accent_dark", "accent_lit")
    )
    whole = Outline(capsule(long, start, end), tube, edge)
    low, high = 1.6 * start, long - 1.8 * end
    groove = line((low, 0), (high, 0))
    marks = (Outline(groove, "", lit, 0.8 * end, 0.9), Outline(groove, "", slot, 0.64 * end))
    return (whole, *marks * (high > low + end))


def links(places: Sequence[Any], look: str = "") -> tuple[Sprite, ...]:
    """Return an arm whose joints and hand are at these places, whatever lengths that takes."""
    found = []
    for (x, y), (to_x, to_y) in pairwise(places):
        along, up = to_x - x, to_y - y
        parts = (*_link(1, 0.1, 0.08, False), *_cover(0.075))
        at, size = (x, y, atan2(up, along)), sqrt(along**2 + up**2)
        found.append(Sprite(at, parts, 0.03, look, size))
    return tuple(found)


def _cover(r: float, x: float = 0) -> tuple[Outline, ...]:
    """Return the cover of a joint at (x, 0), with its bolts."""
    bolts = spots(0.81 * r, [0.3 + k * pi / 3 for k in range(6)], 0.09 * r, x)
    return (
        Outline(disc(r, x), "cover", "groove", 0.07 * r),
        Outline(disc(0.64 * r, x), "dome", "metal_dark", 0.04 * r),
        Outline(bolts, "metal_dark"),
        Outline(line((x + 0.3 * r, 0), (x + 0.54 * r, 0)), "", "accent", 0.14 * r),
        Outline(disc(0.15 * r, x), "dark"),
    )


# ---- tools, at the end of a link of a length and a radius there


def _gripper(length: float, radius: float, opening: Any) -> Sprite:
    s = min(radius / 0.026, 0.5 * length / 0.09)  # the drawing is of a radius of 26 mm
    wrist = length - 0.085 * s
    fingers = []
    for side in (1, -1):
        points = (
            ((0.02, 0.018), (0.05, 0.02)),
            ((0.075, 0.018), (0.1, 0.008)),
            ((0.1, 0), (0.06, 0)),
        )
        (a, b), (c, d), (e, f) = ([(x * s, y * s) for x, y in pair] for pair in points)
        finger = curves((0.02 * s, 0), [a], [b], [c, d], [e], [f], side=side)
        pad = box(0.036 * s, 0.006 * s, 0.081 * s, side * -0.002 * s, 0.002 * s)
        parts = (Outline(finger, "steel", "edge"), Outline(pad, "rubber_mid", "groove", 0.001 * s))
        fingers.append(Sprite((0, side * s * (0.004 + 0.024 * opening), 0), parts, 0.02))
    hand = (
        Outline(box(0.03 * s, 0.052 * s, 0, 0, 0.006 * s), "dark", "rim"),
        *fingers,
        Outline(box(0.016 * s, 0.11 * s, 0.02 * s, 0, 0.005 * s), "steel", "edge"),
    )
    return Sprite(
        (wrist, 0, 0), hand, 0.02, silhouette=box(0.016 * s, 0.11 * s, 0.02 * s, 0, 0.005 * s)
    )


def _pen(length: float, radius: float, _: Any) -> Sprite:
    s = min(radius / 0.026, 0.6 * length / 0.12)
    tip = ((0.095 * s, -0.009 * s), (0.12 * s, 0), (0.095 * s, 0.009 * s))
    parts = (
        Outline(box(0.06 * s, 0.03 * s, 0.015 * s, 0, 0.006 * s), "dark", "rim"),
        Outline(box(0.055 * s, 0.022 * s, 0.07 * s, 0, 0.004 * s), "steel", "edge"),
        Outline(polygon(tip), "accent", "accent_edge"),
    )
    return Sprite((length - 0.12 * s, 0, 0), parts, 0.02)


TOOLS = {"gripper": _gripper, "pen": _pen, "": lambda length, *_: Sprite((length, 0, 0), ())}


# ---- bases, of an arm whose first link has that radius


def _plate(t: float, _: float) -> tuple[Sprite, ...]:
    bolts = spots(1.32 * t, [pi / 4 + k * pi / 2 for k in range(4)], 0.12 * t)
    parts = (
        Outline(disc(1.55 * t), "drum", "edge"),
        Outline(bolts, "metal_dark", "groove", 0.02 * t),
        Outline(disc(1.15 * t), "dark", "groove", 0.03 * t),
    )
    return (Sprite((0, 0, 0), parts, t),)


def _stand(t: float, high: float) -> tuple[Sprite, ...]:
    low = -high
    column = (
        (-1.7 * t, low + 0.35 * t),
        (-1.4 * t, -0.95 * t),
        (1.4 * t, -0.95 * t),
        (1.7 * t, low + 0.35 * t),
    )
    neck = curves(
        (-1.18 * t, -0.8 * t),
        [(-0.9 * t, 0.5 * t)],
        [(0, 1.05 * t), (0.9 * t, 0.5 * t)],
        [(1.18 * t, -0.8 * t)],
    )
    bolts = "".join(box(0.42 * t, 0.22 * t, x * t, low + 0.44 * t, 0.05 * t) for x in (-2.15, 2.15))
    foot = box(5.2 * t, 0.36 * t, 0, low + 0.18 * t, 0.07 * t)
    parts = (
        Outline(foot, "drum", "edge"),
        Outline(bolts, "metal_dark", "groove", 0.03 * t),
        Outline(polygon(column), "drum_pale", "edge"),
        Outline(neck, "drum_pale", "edge"),
        Outline(box(3.1 * t, 0.25 * t, 0, -0.98 * t, 0.08 * t), "dark", "rim"),
        Outline(box(2.7 * t, 0.18 * t, 0, -0.8 * t, 0.05 * t), "accent", "accent_edge", 0.02 * t),
    )
    return (Sprite((0, 0, 0), parts, silhouette=foot + polygon(column)),)


BASES = {"plate": _plate, "stand": _stand, "": lambda *_: ()}
