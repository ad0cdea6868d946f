"""Vehicles from above: the car and its long sister, a bicycle's wheel, rods, a shopping trolley."""

from collections.abc import Callable, Sequence
from typing import Any

from book.things.outlines import Point, box, capsule, curves, line, mirrored
from book.things.wheels import castor, wheel
from courseware.figures import Outline, Sprite

LINE = 0.025  # m, of lines on a car


def _both(draw: Callable[[int], str]) -> str:
    return draw(1) + draw(-1)


def _wheels(
    wheelbase: float, track: float, size: Point, steering: Sequence[Any], rolled: Any
) -> tuple[Sprite, ...]:
    """Return wheels at the rear axle, which is at the origin, and those at the front, steered."""
    sides = (("left2", track / 2, steering[0]), ("right2", -track / 2, steering[1]))
    rear = [wheel((0, y, 0), *size, stripe, rolled) for stripe, y, _ in sides]
    front = [wheel((wheelbase, y, angle), *size, stripe, rolled) for stripe, y, angle in sides]
    return (*rear, *front)


def _arch(x: float, outside: float, inside: float, half: float) -> str:
    """Return the openings for the wheels of an axle."""
    curve = [(x - 0.95 * half, inside), (x + 0.95 * half, inside), (x + half, outside)]
    return _both(lambda side: curves((x - half, outside), curve, side=side))


# ---- the car: 1.7 m wide, 4.1 m long on axles 2.5 m apart; its rear axle at the origin

BODY: Any = (
    (3.3, 0), [(3.3, 0.3), (3.24, 0.56), (3.06, 0.68)], [(2.92, 0.78), (2.7, 0.83), (2.5, 0.83)],
    [(2.2, 0.83), (2, 0.77), (1.6, 0.77)], [(1.1, 0.77), (0.7, 0.78), (0.45, 0.81)],
    [(0.2, 0.85), (-0.15, 0.86), (-0.35, 0.82)], [(-0.62, 0.77), (-0.76, 0.6), (-0.78, 0.34)],
    [(-0.79, 0.2), (-0.79, 0.1), (-0.79, 0)],
)  # fmt: skip
CABIN: Any = (
    (2.02, 0), [(2.02, 0.3), (1.95, 0.5), (1.86, 0.6)], [(1.6, 0.67), (1, 0.68), (0.6, 0.66)],
    [(0.3, 0.65), (0.1, 0.6), (0, 0.52)], [(-0.06, 0.35), (-0.08, 0.2), (-0.08, 0)],
)  # fmt: skip
ROOF: Any = (
    (1.4, 0), [(1.4, 0.25), (1.37, 0.42), (1.33, 0.5)], [(1.1, 0.545), (0.8, 0.545), (0.5, 0.53)],
    [(0.42, 0.4), (0.38, 0.2), (0.38, 0)],
)  # fmt: skip
MIRROR: Any = (
    (1.84, 0.74),
    [(1.88, 0.9)],
    [(1.86, 0.97), (1.78, 0.97)],
    [(1.72, 0.94)],
    [(1.74, 0.74)],
)
LAMP: Any = (
    (3.235, 0.3), [(3.23, 0.5), (3.1, 0.64)], [(2.9, 0.69)], [(3.02, 0.5), (3.06, 0.32)],
)  # fmt: skip
TAIL: Any = (
    (-0.755, 0.28), [(-0.7, 0.3)], [(-0.68, 0.5), (-0.6, 0.66)], [(-0.68, 0.69)],
    [(-0.75, 0.55), (-0.755, 0.28)],
)  # fmt: skip
PILLARS = [((1.9, 0.6), (1.33, 0.5)), ((0.04, 0.54), (0.5, 0.52)), ((0.92, 0.67), (0.92, 0.53))]
DOORS = [((1.62, 0.655), (1.62, 0.77)), ((0.92, 0.67), (0.92, 0.775)), ((0.3, 0.66), (0.38, 0.81))]


def car(
    pose: Any,
    steering: Sequence[Any] = (0, 0),
    rolled: Any = 0,
    look: str = "",
    wheelbase: float = 2.5,
    track: float = 1.5,
) -> Sprite:
    """Return the car, the middle of its rear axle at a pose.

    steering: the angles of its left and its right front wheel; rolled: how far all its wheels have.
    """

    def at(point: Point) -> Point:
        """Stretch the car between its axles, and across."""
        x, y = point
        return x + max(0, min(x / 2.5, 1)) * (wheelbase - 2.5), y * track / 1.5

    def piece(points: Sequence[Point]) -> list[Point]:
        return [at(point) for point in points]

    def whole(first: Point, *pieces: Sequence[Point]) -> str:
        return mirrored(at(first), [piece(each) for each in pieces])

    def pair(first: Point, *pieces: Sequence[Point], closed: bool = True) -> str:
        told = [piece(each) for each in pieces]
        return _both(lambda side: curves(at(first), *told, side=side, closed=closed))

    def pairs(lines: Sequence[Sequence[Point]]) -> str:
        return "".join(pair(a, [b], closed=False) for a, b in lines)

    crease = pair((3.1, 0.3), [(2.8, 0.33), (2.4, 0.36), (2.06, 0.44)], closed=False)
    arches = _arch(0, 0.8 * track / 1.5, 0.56 * track / 1.5, 0.43)
    arches += _arch(wheelbase, 0.8 * track / 1.5, 0.47 * track / 1.5, 0.43)
    body = whole(*BODY)
    parts = (
        Outline(pair(*MIRROR), "accent", "accent_edge"),
        Outline(body, "paintwork", "accent_edge"),
        Outline(crease, "", "accent_dark", 0.03),
        Outline(line(*piece([(3.02, -0.55), (3.12, 0), (3.02, 0.55)])), "", "accent_dark", LINE),
        Outline(whole(*CABIN), "glaze", "accent_groove", LINE),
        Outline(pairs(PILLARS), "", "accent", 0.07),
        Outline(whole(*ROOF), "roof", "accent_dark", LINE),
        Outline(pairs(DOORS), "", "accent_groove", 0.018, 0.7),
        Outline(pairs([((1.18, 0.715), (1.34, 0.715))]), "", "accent_groove", 0.035, 0.8),
        Outline(
            line(*piece([(1.9, -0.1), (1.55, 0.32)])) + line(*piece([(1.9, 0.34), (1.52, 0.47)])),
            "",
            "well",
            0.022,
        ),
        Outline(pair(*LAMP), "lamp", "accent_groove", 0.02),
        Outline(pair(*TAIL), "tail", "accent_groove", 0.02),
        Outline(arches, "well", "accent_groove", LINE),
        *_wheels(wheelbase, track, (0.66, 0.24), steering, rolled),
    )
    return Sprite(pose, parts, height=0.14, look=look, silhouette=body)


def bus(
    pose: Any,
    steering: Sequence[Any] = (0, 0),
    rolled: Any = 0,
    look: str = "",
    wheelbase: float = 7.0,
    track: float = 1.5,
) -> Sprite:
    """Return the car's long sister, on wheels of 50 cm; what moves is that of `car`."""
    L, w = wheelbase, track / 2 + 0.13
    front, rear = L + 0.95, -1.15
    body = mirrored(
        (front, 0),
        [
            [(front, 0.55 * w), (front - 0.03, 0.8 * w), (front - 0.14, 0.92 * w)],
            [(front - 0.22, w), (front - 0.5, w)],
            [(rear + 0.25, w)],
            [(rear, w), (rear, w - 0.25)],
            [(rear, 0)],
        ],
    )
    screen = mirrored(
        (front - 0.07, 0),
        [
            [(front - 0.07, 0.5 * w), (front - 0.13, 0.78 * w), (front - 0.22, 0.86 * w)],
            [(front - 0.5, 0.84 * w)],
            [(front - 0.4, 0.5 * w), (front - 0.38, 0)],
        ],
    )
    inner, panes, start = 0.84 * w, max(2, round(L)), rear + 0.35
    pane = (front - 0.75 - start) / panes
    windows = _both(
        lambda side: "".join(
            box(0.84 * pane, 0.09, start + (k + 0.5) * pane, side * (w - 0.085), 0.02)
            for k in range(panes)
        )
    )
    hatches = "".join(box(0.75, 0.62, x * L, 0, 0.1) for x in (0.12, 0.82))
    mirror = (
        (front - 0.16, w - 0.08),
        [(front + 0.02, w + 0.2)],
        [(front - 0.14, w + 0.26)],
        [(front - 0.3, w - 0.05)],
    )
    lamps = _both(lambda side: box(0.05, 0.3, front - 0.035, side * 0.62 * w, 0.02))
    tails = _both(lambda side: box(0.05, 0.24, rear + 0.035, side * 0.72 * w, 0.02))
    arches = _arch(0, w - 0.02, w - 0.36, 0.36) + _arch(L, w - 0.02, w - 0.44, 0.38)
    seams = "".join(line((x, -inner), (x, inner)) for x in (0.3 * L, 0.65 * L))
    parts = (
        Outline(_both(lambda side: curves(*mirror, side=side)), "dark", "rim"),
        Outline(body, "paintwork", "accent_edge"),
        Outline(
            box(front - rear - 0.9, 2 * inner - 0.12, (front + rear) / 2 - 0.2, 0, 0.2),
            "tube_pale",
            "shell_dark",
            LINE,
        ),
        Outline(seams, "", "shell_dark", LINE),
        Outline(hatches, "shell_mid", "shell_dark", LINE),
        Outline(box(1.5, 0.9, 0.47 * L, 0, 0.08), "metal_mid", "metal_dark", LINE),
        Outline(
            "".join(
                line((0.47 * L - 0.6 + 0.2 * k, -0.36), (0.47 * L - 0.6 + 0.2 * k, 0.36))
                for k in range(7)
            ),
            "",
            "metal_dark",
            LINE,
        ),
        Outline(windows, "glass", "accent_groove", 0.015),
        Outline(screen, "glaze", "accent_groove", LINE),
        Outline(lamps, "lamp", "accent_groove", 0.015),
        Outline(tails, "tail", "accent_groove", 0.015),
        Outline(arches, "well", "accent_groove", LINE),
        *_wheels(L, track, (0.5, 0.22), steering, rolled),
    )
    return Sprite(pose, parts, height=0.25, look=look, silhouette=body)


def bicycle_wheel(place: Any, steering: Any = 0, stripe: str = "velocity2") -> Sprite:
    """Return the one front wheel that replaces two, in its fork, from above."""
    sides = [line((0, 0.13 * side), (0.24, 0.13 * side), (0.36, 0.07 * side)) for side in (1, -1)]
    axle, crown = box(0.07, 0.36, corner=0.03), box(0.09, 0.2, 0.37, 0, 0.04)
    fork = (
        wheel((0, 0, 0), 0.66, 0.18, stripe, 0, 0.08),
        *(Outline(side, "", tone, width) for side in sides for tone, width in LIMB),
        Outline(axle, "steel", "edge"),
        Outline(crown, "steel", "edge"),
    )
    turning = Sprite((0, 0, steering), fork, 0.08, silhouette=axle + crown)
    return Sprite(place, (turning,), 0.08, silhouette="")


def rod(place: Any, long: float, thick: float = 0.05) -> Sprite:
    """Return an arm or a rod of a steering from above, from a place along x."""
    shape = capsule(long, thick / 2, thick / 2.2)
    return Sprite(place, (Outline(shape, "steel", "edge"),), height=0.02)


LIMB = (("edge", 0.06), ("metal_mid", 0.034))  # a tube's two lines


# ---- the shopping trolley, 1 m long, its handle behind

RIM: Any = (
    (-0.42, -0.3), [(0.46, -0.21)], [(0.5, -0.2), (0.5, -0.15)], [(0.5, 0.15)],
    [(0.5, 0.2), (0.46, 0.21)], [(-0.42, 0.3)],
)  # fmt: skip
CASTORS = ((-0.33, 0.25), (-0.33, -0.25), (0.36, 0.17), (0.36, -0.17))  # left and right, rear first


def trolley(
    pose: Any,
    swivels: Sequence[Any] = (0, 0, 0, 0),
    rolled: Sequence[Any] = (0, 0, 0, 0),
    look: str = "",
) -> Sprite:
    """Return the trolley at a pose, with the angles of its castors in the order of `CASTORS`."""
    castors = [
        castor((x, y, 0), swivel, 0.09, "", roll)
        for (x, y), swivel, roll in zip(CASTORS, swivels, rolled, strict=True)
    ]
    across = "".join(
        line(
            (-0.42 + 0.92 * k / 12, -0.3 + 0.1 * k / 12),
            (-0.42 + 0.92 * k / 12, 0.3 - 0.1 * k / 12),
        )
        for k in range(1, 12)
    )
    along = "".join(line((-0.42, 0.06 * k), (0.5, 0.038 * k)) for k in range(-4, 5))
    basket = curves(*RIM)
    handle = line((-0.42, 0.28), (-0.53, 0.285)) + line((-0.42, -0.28), (-0.53, -0.285))
    parts = (
        *castors,
        Outline(basket, "shell_mid", opacity=0.28),
        Outline(across + along, "", "wire", 0.0065),
        Outline(basket, "", "edge", 0.021),
        Outline(basket, "", "metal", 0.011),
        Outline(handle, "", "edge", 0.026),
        Outline(box(0.05, 0.62, -0.54, 0, 0.024), "drum", "edge"),
        Outline(box(0.06, 0.4, -0.54, 0, 0.026), "tail", "groove", 0.006),
        Outline(box(0.014, 0.36, -0.552, 0, 0.007), "light", opacity=0.4),
    )
    bar = box(0.05, 0.62, -0.54, 0, 0.024)
    return Sprite(pose, parts, height=0.035, look=look, silhouette=basket + bar)
