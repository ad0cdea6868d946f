"""Furniture and tools: camera, box, ball, bench, ruler, kerb, shelf, walls."""

from collections.abc import Sequence
from math import ceil, floor
from typing import Any

from book.things.outlines import box, curves, disc, line, polygon
from courseware.figures import Outline, Sprite


def ceiling_camera(place: Any, tilt: Any = 0, size: float = 1) -> Sprite:
    """Return a camera from the side, its mount at a place of the ceiling, 13 cm above its lens.

    tilt: the angle from straight down to where it looks.
    """
    lens = curves((-0.026, -0.115), [(0, -0.131), (0.026, -0.115)])
    head = (
        Outline(box(0.12, 0.08, 0, -0.05, 0.018), "drum_pale", "edge"),
        Outline(box(0.068, 0.032, 0, -0.1, 0.006), "dark", "rim"),
        Outline(lens, "glass_lit", "groove", 0.002),
        Outline(line((-0.045, -0.055), (0.045, -0.055)), "", "shell_dark", 0.003),
        Outline(disc(0.006, 0.043, -0.028), "tail"),
    )
    return Sprite(
        place,
        (
            Outline(box(0.1, 0.018, 0, -0.009, 0.004), "drum", "edge"),
            Sprite((0, -0.045, tilt), head, 0.02),
            Outline(box(0.024, 0.05, 0, -0.035, 0.008), "drum", "groove", 0.002),
            Outline(disc(0.008, 0, -0.045), "metal_dark", "groove", 0.002),
        ),
        height=0.02,
        size=size,
    )


def camera_above(pose: Any, look: str = "") -> Sprite:
    """Return a camera from above; its x axis goes out of its lens."""
    body = Outline(box(0.16, 0.12, -0.08, 0, 0.03), "drum_pale", "edge")
    lens = Outline(box(0.05, 0.07, 0.02, 0, 0.01), "dark", "rim")
    return Sprite(pose, (body, lens), 0.03, look)


def lamplight(place: Any, radius: float) -> Sprite:
    """Return the light of a lamp on the floor of a dark room."""
    return Sprite(place, (Outline(disc(radius), "lamplight"),), silhouette="")


def parcel(pose: Any, long: float = 0.17, wide: float = 0.12, look: str = "") -> Sprite:
    """Return a box to grip, from above."""
    tape = line((-long / 2, 0), (long / 2, 0)) + line((0, -wide / 2), (0, wide / 2))
    parts = (
        Outline(box(long, wide, corner=0.1 * wide), "goal", "goal_edge"),
        Outline(tape, "", "goal_dark", 0.1 * wide),
        Outline(
            box(0.36 * long, 0.34 * wide, corner=0.03 * wide), "shell", "goal_dark", 0.02 * wide
        ),
    )
    return Sprite(pose, parts, height=0.2 * wide, look=look)


def ball(place: Any, radius: float = 0.025, look: str = "") -> Sprite:
    """Return a ball, as it looks from everywhere."""
    r = radius
    glint = Outline(disc(0.5 * r, -0.28 * r, 0.32 * r), "sheen")
    return Sprite(place, (Outline(disc(r), "ball", "goal_edge"), glint), height=0.3 * r, look=look)


def bench(left: float, right: float, top: float, bottom: float) -> Sprite:
    """Return a workbench from the side, whose top carries everything at its height."""
    wide, deep, mid = right - left, top - bottom, (left + right) / 2
    return Sprite(
        (mid, top, 0),
        (
            Outline(box(wide, deep, 0, -deep / 2), "bench"),
            Outline(_grain(wide, 0.84 * deep, -0.16 * deep), "", "wood_edge", 0.008 * deep, 0.3),
        ),
    )


def _grain(wide: float, deep: float, top: float) -> str:
    rows = [(0.2, 0.05), (0.42, -0.04), (0.61, 0.03), (0.83, -0.05)]
    return "".join(
        curves(
            (-wide / 2, top - y * deep),
            [(0, top - (y + bend * 3) * deep), (wide / 2, top - (y + bend) * deep)],
            closed=False,
        )
        for y, bend in rows
    )


def sheet(place: Any, long: float, wide: float) -> Sprite:
    """Return a sheet of paper, from above."""
    return Sprite(
        place,
        (Outline(box(long, wide, corner=0.006 * long), "paper", "edge"),),
        height=0.012 * long,
    )


def tracing_paper(
    pose: Any,
    area: tuple[float, float, float, float],
    unit: float = 0.25,
    parts: Sequence[Any] = (),
) -> Sprite:
    """Return squared paper, pinned at a pose: its area in that frame, and what is traced on it."""
    x, X, y, Y = area
    grid = [line((k * unit, y), (k * unit, Y)) for k in range(ceil(x / unit), floor(X / unit) + 1)]
    grid += [line((x, k * unit), (X, k * unit)) for k in range(ceil(y / unit), floor(Y / unit) + 1)]
    sheet = (
        Outline(box(X - x, Y - y, (x + X) / 2, (y + Y) / 2), "paper", "turning", opacity=0.62),
        Outline("".join(grid), "", "turning", 0.006, 0.7),
    )
    return Sprite(pose, (*sheet, *parts), silhouette="")


def ruler(place: Any, unit: float, count: int, parts: int = 10) -> Sprite:
    """Return a ruler along x, from above, with `count` units, its zero at a place."""
    high, rest = 0.2 * unit, 0.12 * unit
    marks = []
    for k in range(count * parts + 1):
        long = 0.5 if k % parts == 0 else 0.34 if 2 * k % parts == 0 else 0.2
        marks.append(line((k * unit / parts, -0.06 * high), (k * unit / parts, -long * high)))
    thick = "".join(marks[::parts])
    whole = box(count * unit + 2 * rest, high, count * unit / 2, -high / 2, 0.08 * high)
    outlines = (
        Outline(whole, "plank_lit", "wood_edge"),
        Outline("".join(marks), "", "text", 0.004 * unit),
        Outline(thick, "", "text", 0.009 * unit),
    )
    return Sprite(place, outlines, height=0.03 * unit)


def kerb(
    place: Any, long: float, stone: float = 1.0, wide: float = 0.15, pavement: float = 2.0
) -> Sprite:
    """Return a kerb from above, along x, its edge at a place; the pavement is to its right."""
    count = max(1, round(long / stone))
    stones = "".join(
        box(0.985 * long / count, wide, (k + 0.5) * long / count, -wide / 2, 0.02)
        for k in range(count)
    )
    parts = (
        Outline(box(long, pavement, long / 2, -wide - pavement / 2), "seam"),
        Outline(stones, "kerb", "kerb_edge"),
    )
    return Sprite(place, parts, height=0.08, silhouette=box(long, wide, long / 2, -wide / 2))


BOOKS = ("glass_lit", "accent", "shell_mid", "dark", "metal_mid", "wood_lit", "accent_dark")


def shelf(place: Any, long: float = 0.8, wide: float = 0.17) -> Sprite:
    """Return a shelf with books, from above, its back along x through a place."""
    books, x, k = [], -long / 2 + 0.03, 0
    while x < long / 2 - 0.08:
        thick, deep = 0.045 + 0.035 * (5 * k % 7) / 7, wide - 0.05 - 0.02 * (3 * k % 4)
        books.append(
            Outline(
                box(thick, deep, x + thick / 2, -wide / 2, 0.005), BOOKS[3 * k % 7], "groove", 0.003
            )
        )
        x, k = x + thick + 0.005, k + 1
    parts = (
        Outline(box(long, wide, 0, -wide / 2, 0.01), "wood", "wood_edge"),
        Outline(box(long - 0.04, wide - 0.03, 0, -wide / 2, 0.005), "wood_dark"),
        *books,
    )
    return Sprite(place, parts, height=0.03)


def tiled_room(room: tuple[float, float, float, float], tile: float = 0.25) -> tuple[Outline, ...]:
    """Return floor, tiles and walls of a room (x_low, x_high, y_low, y_high), from above."""
    x, X, y, Y = room
    seams = [line((k * tile, y), (k * tile, Y)) for k in range(ceil(x / tile), floor(X / tile) + 1)]
    seams += [
        line((x, k * tile), (X, k * tile)) for k in range(ceil(y / tile), floor(Y / tile) + 1)
    ]
    return (
        Outline(box(X - x, Y - y, (x + X) / 2, (y + Y) / 2), "floor"),
        Outline("".join(seams), "", "seam", 0.01),
        *walls(room).parts[:1],
    )


def walls(room: tuple[float, float, float, float]) -> Sprite:
    """Return the walls round a room (x_low, x_high, y_low, y_high), from above."""
    x, X, y, Y = room
    inside = polygon(((x, y), (x, Y), (X, Y), (X, y)))
    t = 0.12
    whole = polygon(((x - t, y - t), (X + t, y - t), (X + t, Y + t), (x - t, Y + t))) + inside
    return Sprite((0, 0, 0), (Outline(whole, "wall_top", "edge"),), height=0.05)
