"""Wheels: fixed, steered, castor, with rollers, ball; and a wheel with an encoder from the side."""

from math import cos, hypot, pi, sin, tan
from typing import Any

from book.things.outlines import box, curves, disc, line, polygon, ring, sector, spots
from courseware.figures import Outline, Rim, Sprite


def wheel(
    place: Any, length: float, width: float, stripe: str = "", roll: Any = 0, height: float = 0
) -> Sprite:
    """Return a wheel from above, its treads where they are after it rolled so many metres.

    stripe: the material of a stripe on the tyre; height: for the shadow of one that stands alone.
    """
    tread = Outline(line((0, -0.43 * width), (0, 0.43 * width)), "", "tread", length / 24)
    return Sprite(
        place,
        (
            Outline(box(length, width, corner=0.3 * width), "tyre", "rim"),
            Rim(0.46 * length, 18, (tread,), 0.92 * roll),
            *_stripe(0.84 * length, 0.34 * width, stripe),
        ),
        height,
    )


def _stripe(long: float, wide: float, material: str) -> tuple[Outline, ...]:
    return (Outline(box(long, wide, corner=0.35 * wide), material),) * bool(material)


def _pivot(radius: float) -> tuple[Outline, ...]:
    return (
        Outline(disc(radius), "cover", "groove", 0.09 * radius),
        Outline(disc(0.36 * radius), "dark"),
    )


def steered_wheel(
    place: Any, steering: Any, stripe: str = "", roll: Any = 0, length: float = 0.09
) -> Sprite:
    """Return a wheel from above that turns with its fork about a pivot over its middle."""
    width = length / 3
    bridge = Outline(box(0.3 * length, 1.6 * width, corner=0.2 * width), "steel", "groove", 0.001)
    turning = (wheel((0, 0, 0), length, width, stripe, roll), bridge, *_pivot(0.3 * width))
    return Sprite(
        place,
        (
            Outline(disc(0.62 * length), "cover", "edge"),
            Outline(
                spots(0.52 * length, [pi / 4 + k * pi / 2 for k in range(4)], 0.035 * length),
                "metal_dark",
            ),
            Outline(disc(0.42 * length), "dark", "groove", 0.001),
            Sprite((0, 0, steering), turning),
        ),
    )


def castor(
    place: Any,
    swivel: Any = 0,
    trail: float = 0.05,
    stripe: str = "",
    roll: Any = 0,
    look: str = "",
) -> Sprite:
    """Return a castor from above: a plate, and under it a fork with a wheel that trails.

    swivel: the angle of the wheel against the plate; at 0 it trails behind, against x.
    """
    t = trail
    prongs = [
        curves(
            (-0.08 * t, 0.4 * t), [(-1.12 * t, 0.4 * t)],
            [(-1.25 * t, 0.34 * t), (-1.12 * t, 0.28 * t)], [(-0.24 * t, 0.27 * t)], side=side,
        )
        for side in (1, -1)
    ]  # fmt: skip
    fork = (
        wheel((-t, 0, 0), 1.28 * t, 0.46 * t, stripe, roll),
        Outline(disc(0.44 * t), "metal_dark", "groove", 0.03 * t),
        *(Outline(prong, "steel", "edge", 0.03 * t) for prong in prongs),
        Outline(box(0.1 * t, 0.94 * t, -t, corner=0.05 * t), "metal", "groove", 0.03 * t),
    )
    corners = [(0.39 * t, a) for a in (pi / 4, 3 * pi / 4, 5 * pi / 4, 7 * pi / 4)]
    return Sprite(
        place,
        (
            Sprite((0, 0, swivel), fork, 0.2 * t, silhouette=disc(0.44 * t)),
            Outline(box(1.08 * t, 1.08 * t, corner=0.16 * t), "steel", "edge"),
            Outline("".join(spots(r * 2**0.5, (a,), 0.06 * t) for r, a in corners), "metal_dark"),
            *_pivot(0.28 * t),
        ),
        height=0.2 * t,
        look=look,
    )


# ---- wheels with rollers


def _barrel(
    half: float, radius: float, bulge: float, tilt: float, y: float, part: float = 1
) -> str:
    """Return a roller from above: slimmer towards its round ends, as the wheel's rim is round."""
    side = []
    for k in range(17):
        s = sin((k / 16 - 0.5) * pi)
        cap = max(0, abs(s) - 0.8) / 0.2
        side.append((part * half * s, part * (radius - bulge * s * s) * (1 - cap * cap) ** 0.5))
    c, s = cos(tilt), sin(tilt)
    around = [*side, *((x, -r) for x, r in side[-2:0:-1])]
    return polygon([(c * a - s * b, y + s * a + c * b) for a, b in around])


def roller_wheel(
    place: Any, gamma: float, stripe: str = "", roll: Any = 0, length: float = 0.1, look: str = ""
) -> Sprite:
    """Return a wheel from above with rollers whose axes are at an angle to its rolling direction.

    The rollers lie as those that touch the floor do, as if one looked through the wheel from above.
    gamma: 0 makes two rows that take turns; any other number, as π/4, one row across the wheel.
    """
    R, width = length / 2, 0.46 * length
    rho, count = 0.73 * R, 9 if gamma else 6
    half = 0.48 * width / abs(sin(gamma)) if gamma else 0.86 * rho * tan(pi / count)
    radius = R - rho if gamma else 0.24 * width
    bulge = hypot(rho, half * cos(gamma)) - rho
    rows: tuple[tuple[float, float], ...] = ((0, 0),) if gamma else ((0.25, 0), (-0.25, 0.5))
    parts: list[Any] = [Outline(box(1.2 * R, 0.9 * width, corner=0.06 * width), "drum", "edge")]
    for y, ahead in rows:
        whole, core = (_barrel(half, radius, bulge, gamma, y * width, part) for part in (1, 0.66))
        glint = [(s * half * cos(gamma), y * width + s * half * sin(gamma)) for s in (-0.45, 0.45)]
        outlines = (
            Outline(whole, "rubber" if gamma else "roller", "rim", 0.012 * length),
            *(Outline(core, "rubber_mid"),) * bool(gamma),
            Outline(line(*glint), "", "rubber_lit", 0.05 * R, 0.8),
        )
        phase = roll * rho / R + ahead * 2 * pi * rho / count
        parts.append(Rim(rho, count, outlines, phase, radius / (half * cos(gamma) + radius)))
    around = box(length, width, corner=0.1 * width)
    parts += _stripe(0.68 * length, 0.12 * width, stripe)
    return Sprite(place, tuple(parts), 0.06 * length, look, silhouette=around)


def omni_wheel(place: Any, stripe: str = "", roll: Any = 0, length: float = 0.1) -> Sprite:
    """Return a wheel from above that slides freely along its axle."""
    return roller_wheel(place, 0, stripe, roll, length)


def mecanum_wheel(
    place: Any, stripe: str = "", roll: Any = 0, length: float = 0.1, gamma: float = pi / 4
) -> Sprite:
    """Return a wheel from above with rollers across; those of its neighbours are at -gamma."""
    return roller_wheel(place, gamma, stripe, roll, length)


def ball_wheel(place: Any, radius: float = 0.03) -> Sprite:
    """Return a ball in its holder, from above: it rolls everywhere."""
    r = radius
    return Sprite(
        place,
        (
            Outline(disc(1.5 * r), "cover", "edge"),
            Outline(spots(1.28 * r, [k * pi / 3 for k in range(6)], 0.1 * r), "metal_dark"),
            Outline(disc(1.08 * r), "well", "groove", 0.04 * r),
            Outline(disc(r), "steel_ball", "groove", 0.03 * r),
            Outline(disc(0.3 * r, -0.3 * r, 0.32 * r), "sheen"),
        ),
    )


# ---- a wheel with an encoder, from the side


def _block(radius: float, angle: float, long: float, wide: float) -> str:
    c, s = cos(angle), sin(angle)
    ends = [(radius + u * long / 2, v * wide / 2) for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return polygon([(c * x - s * y, s * x + c * y) for x, y in ends])


def encoder_wheel(
    place: Any, roll: Any = 0, radius: float = 0.05, slots: int = 24, stripe: str = "left2"
) -> Sprite:
    """Return a wheel from the side with a slotted disc, that rolled so many metres to the right.

    stripe: the material of its mark.
    """
    R, half = radius, pi / slots / 2
    turning = (
        Outline(ring(lambda a: _block(0.955 * R, a, 0.05 * R, 0.07 * R), 40), "tread"),
        Outline(ring(lambda a: sector(0.58 * R, 0.74 * R, a - half, a + half), slots), "well"),
        Outline(
            ring(lambda a: sector(0.2 * R, 0.44 * R, a - 0.41, a + 0.41), 5),
            "well",
            "metal_dark",
            0.012 * R,
        ),
        Outline(disc(0.13 * R), "dark", "metal_dark", 0.012 * R),
        Outline(disc(0.05 * R), "metal"),
        Outline(line((0.77 * R, 0), (0.97 * R, 0)), "", stripe, 0.12 * R),
    )
    return Sprite(
        place,
        (
            Outline(disc(R), "rubber", "rim"),
            Outline(disc(0.86 * R), "rubber_mid"),
            Outline(disc(0.82 * R), "cover", "groove", 0.016 * R),
            Sprite((0, 0, -roll / radius), turning, silhouette=disc(0.86 * R)),
        ),
        height=0.12 * R,
    )


def light_gate(place: Any, radius: float = 0.05, slots: int = 24) -> Sprite:
    """Return the two light gates of a wheel of that radius, a quarter slot apart, on their holder.

    place: the middle of the wheel.
    """
    R = radius
    apart = (
        0.66 * R * 2 * pi / slots / 4 + 0.66 * R * 2 * pi / slots
    )  # and a whole one: room for two
    lamps = ((-apart / 2, "lamp"), (apart / 2, "tail"))
    windows = "".join(box(0.09 * R, 0.26 * R, x, 0.7 * R, 0.03 * R) for x, _ in lamps)
    return Sprite(
        place,
        (
            Outline(box(0.62 * R, 0.86 * R, 0, 0.98 * R, 0.07 * R), "dark", "rim"),
            Outline(box(0.48 * R, 0.22 * R, 0, 1.24 * R, 0.03 * R), "rubber_mid"),
            Outline(windows, "well", "metal_dark", 0.014 * R),
            *(Outline(disc(0.05 * R, x, 0.66 * R), tone) for x, tone in lamps),
        ),
        height=0.12 * R,
    )


def counter(place: Any, long: float = 0.06, wide: float = 0.024) -> Sprite:
    """Return a box with a pale display; its number is a label of the figure."""
    return Sprite(
        place,
        (
            Outline(box(long, wide, corner=0.15 * wide), "dark", "rim"),
            Outline(
                box(0.86 * long, 0.72 * wide, corner=0.06 * wide), "shell", "groove", 0.02 * wide
            ),
        ),
        height=0.2 * wide,
    )
