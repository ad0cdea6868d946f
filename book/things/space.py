"""The same things in space, as meshes that a chapter places with `VIEW.solid`."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from math import acos, cos, pi, sin
from typing import Any

import numpy as np
import sympy as sp

from book.things import meshes
from courseware.figures import VIEW
from courseware.figures.solids import Mesh, Solid
from courseware.figures.space import ORIGIN

N = 16  # of corners all round


def link(length: float, start: float, end: float, pale: bool = False) -> tuple[Mesh, ...]:
    """Return a tapered link along x, with covers on its joints; a pale one has a tool at its end.

    start, end: radii, as of `outlines.capsule`.
    """
    tone, edge = ("shell", "edge") if pale else ("accent", "accent_edge")
    k = acos((start - end) / length)
    near = [2 * pi - k - (2 * pi - 2 * k) * i / 8 for i in range(9)][::-1]
    far = [-k + 2 * k * i / 8 for i in range(9)]
    corners = [(start * cos(a), start * sin(a)) for a in near]
    corners += [(length + end * cos(a), end * sin(a)) for a in far]
    mesh = meshes.plate(tone, corners, 1.3 * end)
    joints = ((0, start), (length, end))[: 1 if pale else 2]
    covers = {face: _covers(mesh, face, joints) for face in (0, 1)}
    return (replace(mesh, edge=edge, dots=covers),)


def _covers(
    mesh: Mesh, face: int, joints: tuple[tuple[float, float], ...]
) -> list[tuple[object, ...]]:
    """Return the covers of joints at places on the x axis, as discs printed on a face."""
    corners = [mesh.corners[i] for i in mesh.faces[face]]
    (a, b), middle = corners[:2], [sum(c[k] for c in corners) / len(corners) for k in range(3)]
    long = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5
    ahead = ((b[0] - a[0]) / long, (b[1] - a[1]) / long)
    up = 1 if face else -1  # the lower face is seen from below
    dots: list[tuple[Any, ...]] = []
    for x, radius in joints:
        dx, dy, r = x - middle[0], -middle[1], 0.78 * radius
        u, v = dx * ahead[0] + dy * ahead[1], up * (dy * ahead[0] - dx * ahead[1])
        dots += [(u, v, r, "groove"), (u, v, 0.93 * r, "metal"), (u, v, 0.64 * r, "metal_mid")]
        dots += [(u, v, 0.59 * r, "shell"), (u, v, 0.16 * r, "dark")]
        bolts = [(u + 0.79 * r * cos(k), v + 0.79 * r * sin(k)) for k in range(6)]
        dots += [(*bolt, 0.08 * r, "metal_dark") for bolt in bolts]
    return [(*(round(x, 4) for x in place), tone) for *place, tone in dots]


def gripper(x: float, size: float = 0.026, opening: float = 1) -> tuple[Mesh, ...]:
    """Return a gripper at the end of a link, its two fingers in the arm's plane."""
    s = size / 0.026
    gap = (0.012 + 0.022 * opening) * s
    palm = meshes.box("metal_mid", (0.02 * s, 0.11 * s, 0.05 * s), (x + 0.01 * s, 0, 0))
    fingers = [
        meshes.box("metal", (0.08 * s, 0.014 * s, 0.026 * s), (x + 0.06 * s, side * gap, 0))
        for side in (1, -1)
    ]
    return tuple(replace(mesh, edge="edge") for mesh in (palm, *fingers))


def arm_places(angles: Sequence[Any], lengths: Sequence[Any], high: Any) -> list[list[Any]]:
    """Return shoulder, elbow and wrist of an arm on a turntable."""
    turn, rise, bend = angles
    places = [[0, 0, high]]
    for long, way in zip(lengths, (rise, rise + bend), strict=True):
        along = tilt(turn, way)[:, 0]
        places.append([at + long * part for at, part in zip(places[-1], along, strict=True)])
    return places


def arm(
    angles: Sequence[Any],
    lengths: tuple[float, float],
    high: float,
    opening: Any = 1,
    kind: str = "",
    opacity: float = 1.0,
) -> tuple[Solid, ...]:
    """Return what moves of an arm on a turntable: turntable, upper link, forearm, two fingers.

    A nose shows where the turntable faces, a cable runs along the back of both links.

    Args:
        angles: of turntable, shoulder and elbow.
        lengths: of the two links; the second ends between the fingers.
        high: of the shoulder, over a `column` of 0.55 of that.
        opening: of the gripper, from 0 to 1; closed it holds a ball of 25 mm.
        kind: of all parts, such as "error"; by default each has its own.
        opacity: below 1 it is a ghost.
    """
    turn, rise, bend = angles
    shoulder, elbow, _ = arm_places(angles, lengths, high)
    upper, fore = tilt(turn, rise), tilt(turn, rise + bend)
    base = sp.Matrix.hstack(tilt(turn, 0)[:, 0], -tilt(turn, 0)[:, 2], sp.Matrix([0, 0, 1]))
    short = lengths[1] - 0.085
    palm, finger, _ = gripper(short)
    cables = (_cable(0.08, lengths[0] - 0.06, 0.05), _cable(0.04, short - 0.03, 0.036))
    parts: list[tuple[Sequence[Mesh], Any, Sequence[Any]]] = [
        (_turntable(high), base, ORIGIN),
        ((*link(lengths[0], 0.05, 0.042), cables[0]), upper, shoulder),
        ((*link(short, 0.04, 0.03, pale=True), cables[1], palm), fore, elbow),
    ]
    beside = sum(corner[1] for corner in finger.corners) / len(finger.corners)
    for side in (1, -1):
        off = side * (0.032 + 0.022 * opening) - beside
        at = [elbow[k] + off * fore[k, 1] for k in range(3)]
        parts.append(((finger,), fore, at))
    return tuple(
        VIEW.solid(_paint(body, kind), R, at, floor=None if opacity < 1 else 0, opacity=opacity)
        for body, R, at in parts
    )


def tilt(turn: Any, rise: Any) -> sp.Matrix:
    """Return the frame of a link: along it, across it in the arm's plane, its joint's axis."""
    ct, st, cr, sr = sp.cos(turn), sp.sin(turn), sp.cos(rise), sp.sin(rise)
    return sp.Matrix([[ct * cr, -ct * sr, st], [st * cr, -st * sr, -ct], [sr, cr, 0]])


def _turntable(high: float) -> tuple[Mesh, ...]:
    """Return what turns on a column: two cheeks that hold the shoulder, and a nose."""
    low = 0.5 * high
    cheeks = [
        meshes.box("metal_mid", (0.08, 0.018, high - low), (0, side * 0.045, (high + low) / 2))
        for side in (1, -1)
    ]
    ring = meshes.cylinder("accent", (0.1, 0.1), (low - 0.015, low), n=N)
    nose = meshes.plate("accent", ((0.09, -0.045), (0.2, 0), (0.09, 0.045)), 0.015)
    nose = replace(nose, corners=tuple((x, y, z + low - 0.008) for x, y, z in nose.corners))
    return (*(replace(c, edge="edge") for c in cheeks), *_paint((ring, nose), "", "accent_edge"))


def _cable(start: float, end: float, aside: float) -> Mesh:
    """Return a cable that runs along the back of a link."""
    middle = ((start + end) / 2, aside, 0)
    return replace(meshes.box("dark", (end - start, 0.012, 0.014), middle), edge="rim")


def _paint(body: Sequence[Mesh], kind: str, edge: str = "") -> list[Mesh]:
    """Return meshes all of one kind, or with one edge."""
    if kind:
        return [replace(mesh, kind=kind, edge=kind, dots={}) for mesh in body]
    return [replace(mesh, edge=edge or mesh.edge) for mesh in body]


def column(high: float, radius: float = 0.09) -> tuple[Mesh, ...]:
    """Return the base of an arm, along z: a plate, a drum and a ring that turns with the arm."""
    r, ring = radius, min(0.15 * high, 0.02)
    rings = (
        ("metal_mid", (1.6 * r, 1.6 * r), (0, 0.024)),
        ("shell", (1.05 * r, r), (0.024, high - 2 * ring)),
        ("dark", (1.06 * r, 1.06 * r), (high - 2 * ring, high - ring)),
        ("accent", (0.94 * r, 0.94 * r), (high - ring, high)),
    )
    edges = {"accent": "accent_edge", "dark": "rim"}
    return tuple(
        replace(meshes.cylinder(tone, radii, ends, n=N), edge=edges.get(tone, "edge"))
        for tone, radii, ends in rings
    )


def camera(size: float = 1) -> tuple[Mesh, ...]:
    """Return a camera at its lens that looks along z."""
    s = size
    body = meshes.box("shell", (0.12 * s, 0.09 * s, 0.08 * s), (0, 0, -0.075 * s))
    lens = meshes.cylinder("dark", (0.034 * s, 0.036 * s), (-0.035 * s, 0), n=N)
    return replace(body, edge="edge"), replace(lens, edge="rim")


def parcel(size: tuple[float, float, float] = (0.17, 0.12, 0.1)) -> tuple[Mesh, ...]:
    """Return a box to grip, its middle at the origin."""
    return (replace(meshes.box("goal", size), edge="goal_edge"),)


def ball() -> tuple[Mesh, ...]:
    """Return a ball of radius 1 m; R scales it."""
    return (replace(meshes.ball("goal", n=8, rows=4), edge="goal_edge"),)


def stand(high: float) -> tuple[Mesh, ...]:
    """Return the stand of a ball, its foot at the origin."""
    foot = meshes.cylinder("metal_mid", (0.06, 0.06), (0, 0.02), n=N)
    post = meshes.cylinder("metal_mid", (0.008, 0.008), (0.02, high), n=8)
    return replace(foot, edge="edge"), replace(post, edge="edge")


def slab(height: float, half: float) -> tuple[Mesh, ...]:
    """Return a square slab, its upper side at a height."""
    thick = 0.07
    box = meshes.box("floor", (2 * half, 2 * half, thick), (0, 0, height - thick / 2))
    return (replace(box, edge="seam"),)


def floor(height: float, half: float, at: Sequence[Any] = ORIGIN) -> Solid:
    """Return a slab behind all else, on which shadows fall."""
    return VIEW.solid(slab(height, half), sp.eye(3), at, behind=200.0)


def aeroplane() -> tuple[Mesh, ...]:
    """Return an aeroplane that flies along x, its wings along y; about 1 m long."""
    body = (
        meshes.cylinder("shell_mid", (0.04, 0.1), (-0.47, -0.1), along="x", n=8),
        meshes.cylinder("shell_mid", (0.1, 0.09), (-0.1, 0.34), along="x", n=8),
        meshes.cylinder("accent", (0.09, 0.02), (0.34, 0.52), along="x", n=8),
    )
    wings = [
        [(0.0, 0.09), (0.22, 0.09), (0.0, 0.58), (-0.12, 0.58)],
        [(-0.45, 0.05), (-0.29, 0.06), (-0.38, 0.26), (-0.46, 0.26)],
    ]
    flat = [meshes.plate("accent", wing, 0.035) for wing in wings]
    flat += [meshes.plate("accent", [(x, -y) for x, y in wing[::-1]], 0.035) for wing in wings]
    tail = [(0.09, -0.45), (0.28, -0.46), (0.28, -0.37), (0.09, -0.25)]
    plates = (*flat, meshes.plate("accent", tail, 0.03, "y"))
    cabin = meshes.box("glass", (0.16, 0.1, 0.06), at=(0.22, 0, 0.09))
    return (
        *(replace(mesh, edge="edge") for mesh in body),
        *(replace(mesh, edge="accent_edge") for mesh in plates),
        replace(cabin, edge="glass_lit"),
    )


PIPS: dict[int, tuple[tuple[float, float], ...]] = {
    1: ((0, 0),),
    2: ((-1, -1), (1, 1)),
    3: ((-1, -1), (0, 0), (1, 1)),
    4: ((-1, -1), (-1, 1), (1, -1), (1, 1)),
    5: ((-1, -1), (-1, 1), (0, 0), (1, -1), (1, 1)),
    6: ((-1, -1), (-1, 0), (-1, 1), (1, -1), (1, 0), (1, 1)),
}
SIDES = ((0, 0, -1), (0, 0, 1), (0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0))
FACE_NUMBERS = (4, 3, 5, 1, 2, 6)  # on these sides: opposite faces add up to seven


def die(tone: str, pip: str = "", edge: str = "") -> tuple[Mesh, ...]:
    """Return a die of side 1 m with 1, 2 and 3 towards x, y and z; pip: the tone of its dots."""
    half, bevel = 0.5, 0.06
    corners = np.array(
        [
            [sign * (half - bevel * (k != side)) for k, sign in enumerate(signs)]
            for side in range(3)
            for signs in product((-1, 1), repeat=3)
        ]
    )
    bevels = (way for way in product((-1, 0, 1), repeat=3) if np.abs(way).sum() > 1)
    dots = {
        face: [(0.25 * a, 0.25 * b, 0.095, *([pip] if pip else [])) for a, b in PIPS[number]]
        for face, number in enumerate(FACE_NUMBERS)
    }
    faces = tuple(_outermost(corners, np.array(way)) for way in (*SIDES, *bevels))
    return (Mesh(tone, tuple(map(tuple, corners.tolist())), faces, dots, edge),)


def _outermost(corners: np.ndarray, way: np.ndarray) -> tuple[int, ...]:
    """Return the corners that lie farthest out one way, counter-clockwise for who looks at it."""
    out = corners @ way
    found = np.flatnonzero(out > out.max() - 1e-9)
    arms = corners[found] - corners[found].mean(axis=0)
    angles = np.arctan2(arms @ np.cross(way, arms[0]), arms @ arms[0]).round(9) % (2 * pi)
    return tuple(found[np.argsort(angles)].tolist())
