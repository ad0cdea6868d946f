"""Robots on wheels, from above, and where they stop: pad, dock."""

from collections.abc import Sequence
from math import cos, pi, sin
from typing import Any

from book.things.arms import arm
from book.things.outlines import box, curves, disc, line, rounded, sector, spots
from book.things.wheels import omni_wheel, wheel
from courseware.figures import Outline, Sprite

LEFT_RIGHT = ("left2", "right2")


def _sheen(heading: Any, radius: float, x: float, y: float) -> Sprite:
    """Return light from above left, which stays there however the thing below it turns."""
    return Sprite(
        (0, 0, -heading), (Outline(disc(radius, x, y), "sheen", opacity=0.5),), silhouette=""
    )


# ---- the small robot of the wheeled chapters, 13 cm across, its axle through the origin

HULL = (
    Outline(sector(0.05, 0.0705, -0.95, 0.95), "dark", "rim"),  # bumper
    Outline(disc(0.065), "side", "edge"),
    Outline(disc(0.0595), "dome", "shell_dark", 0.0007),
    *(Outline(box(0.073, 0.026, 0, y, 0.006), "well", "rim", 0.0012) for y in (0.05, -0.05)),
)
FACE = (
    Outline(sector(0.0455, 0.0575, -0.5, 0.5), "glass", "groove", 0.0008),
    Outline(sector(0.0525, 0.0555, -0.42, 0.42), "glass_lit", opacity=0.55),
    Outline(spots(0.0515, (0.27, -0.27), 0.0046), "well", "metal_mid", 0.0011),
    Outline(spots(0.0523, (0.28, -0.26), 0.002), "lamp"),
    Outline(sector(0.04, 0.0425, -0.5, 0.5), "accent"),
    Outline(disc(0.0085, -0.046), "cover", "groove", 0.0009),
    Outline(disc(0.0032, -0.046), "metal_dark"),
    Outline(disc(0.0275), "side", "shell_dark", 0.0012),
    Outline(disc(0.0235), "dome"),
    Outline(spots(0.034, (2.2, -2.2, 2.75, -2.75), 0.0016), "shell_dark"),
    Outline(line((0.006, -0.011), (0.0175, 0), (0.006, 0.011)), "", "dark", 0.0036),
    Outline(disc(0.0034), "dark"),
)


def robot(pose: Any, rolled: Any = (0, 0), look: str = "", half: float = 0.05) -> Sprite:
    """Return the robot at a pose.

    rolled: how far its left and its right wheel have rolled; half: the distance of each wheel.
    """
    sides = zip((half, -half), LEFT_RIGHT, rolled, strict=True)
    wheels = [wheel((0, y, 0), 0.06, 0.0175, stripe, roll) for y, stripe, roll in sides]
    parts = (*HULL, *wheels, *FACE, _sheen(pose[2], 0.034, -0.018, 0.021))
    return Sprite(pose, parts, height=0.012, look=look, silhouette=disc(0.069))


def pad(pose: Any) -> Sprite:
    """Return the charging pad on which the robot is to stop: its eyes and arrow say the heading."""
    return Sprite(
        pose,
        (
            Outline(disc(0.074), "goal", "target"),
            Outline(disc(0.064), "", "goal_dark", 0.0016),
            Outline(line((-0.01, -0.022), (0.012, 0), (-0.01, 0.022)), "", "goal_mark", 0.006),
            Outline(sector(0.0455, 0.0575, -0.5, 0.5), "goal_mark"),
            Outline(spots(0.0515, (0.27, -0.27), 0.004), "goal"),
        ),
    )


def pad_lights(pose: Any) -> Sprite:
    """Return the lights of the pad, for when it is reached."""
    lights = Outline(spots(0.0738, [k * pi / 5 for k in range(10)], 0.0038), "lamp", "goal_edge")
    return Sprite(pose, (lights,))


# ---- its vacuum cousin, 34 cm across

SWEEP = "".join(
    curves(
        (0, 0),
        [(0.04 * cos(a + 0.25), 0.04 * sin(a + 0.25)), (0.075 * cos(a), 0.075 * sin(a))],
        closed=False,
    )
    for a in (0, 2 * pi / 3, 4 * pi / 3)
)
BRUSH = (Outline(SWEEP, "", "metal_dark", 0.005), Outline(disc(0.013), "dark"))
LID = (
    Outline(disc(0.17), "dark", "rim"),
    Outline(sector(0.158, 0.174, -1.25, 1.25), "rubber_mid", "rim", 0.003),
    Outline(disc(0.155, -0.003), "side", "groove", 0.0025),
    Outline(disc(0.147, -0.003), "dome"),
)
BUTTONS = (
    Outline(disc(0.056, 0.045), "side", "shell_dark", 0.003),
    Outline(disc(0.045, 0.045), "dark", "groove", 0.002),
    Outline(box(0.075, 0.08, -0.0845, 0, 0.016), "shell_mid", "shell_dark", 0.002),
    Outline(disc(0.009, -0.085, 0.016), "velocity"),
    Outline(disc(0.009, -0.085, -0.016), "metal_mid", "metal_dark", 0.002),
    Outline(sector(0.118, 0.124, -0.42, 0.42), "accent"),
)
LIDAR = (
    Outline(sector(0.027, 0.041, -0.5, 0.5), "glass_lit"),
    Outline(disc(0.022), "cover", "groove", 0.002),
)


def vacuum(pose: Any, rolled: Any = (0, 0), look: str = "", half: float = 0.122) -> Sprite:
    """Return the vacuum robot at a pose; half: the distance of each wheel from the middle."""
    sides = list(zip((half, -half), LEFT_RIGHT, rolled, strict=True))
    wells = [Outline(box(0.124, 0.05, 0, y, 0.012), "well", "shell_dark", 0.002) for y, *_ in sides]
    wheels = [wheel((0, y, 0), 0.11, 0.034, stripe, roll) for y, stripe, roll in sides]
    brush = Sprite((0.115, -0.125, 0), BRUSH, silhouette="")
    lidar = Sprite((0.045, 0, 0), LIDAR, silhouette="")
    parts = (brush, *LID, *wells, *wheels, *BUTTONS, lidar, _sheen(pose[2], 0.085, -0.05, 0.06))
    return Sprite(pose, parts, height=0.02, look=look, silhouette=disc(0.172))


def dock(pose: Any) -> Sprite:
    """Return the vacuum's dock, its back to a wall: the robot comes from ahead of it, along x."""
    contacts = "".join(box(0.055, 0.028, 0.0775, y, 0.006) for y in (0.05, -0.05))
    bolt = (
        (0.07, 0.018),
        (0.058, -0.002),
        (0.07, -0.002),
        (0.068, -0.02),
        (0.081, 0.002),
        (0.069, 0.002),
    )
    return Sprite(
        pose,
        (
            Outline(box(0.1, 0.27, 0.08, 0, 0.012), "dark", "rim"),
            Outline(contacts, "metal", "metal_dark", 0.003),
            Outline(box(0.075, 0.3, 0.0175, 0, 0.03), "dark", "rim"),
            Outline(box(0.03, 0.27, 0.005, 0, 0.014), "rubber_mid"),
            Outline(disc(0.011, 0.038, 0.08), "velocity2"),
            Outline(
                line(*[(x + 0.045, y) for x, y in bolt], (bolt[0][0] + 0.045, bolt[0][1])), "lamp"
            ),
        ),
        height=0.03,
        silhouette=box(0.075, 0.3, 0.0175, 0, 0.03),
    )


# ---- robots with more ways to move


def omni_robot(
    pose: Any,
    rolled: Any = (0, 0, 0),
    look: str = "",
    distance: float = 0.18,
    beta: Any = 0,
    stripes: Sequence[str] = ("left2", "right2", "turning2"),
) -> Sprite:
    """Return the robot on three omni wheels, at 0°, 120° and 240°.

    distance: of the wheels from its middle; beta: from each spoke to the axle.
    """
    long, wheels = distance, []
    for k, (stripe, roll) in enumerate(zip(stripes, rolled, strict=True)):
        a = 2 * pi * k / 3
        mount = Outline(box(0.64 * long, 0.34 * long, corner=0.05 * long), "metal_mid", "edge")
        turned = (mount, omni_wheel((0, 0, 0), stripe, roll, 0.56 * long))
        wheels.append(Sprite((long * cos(a), long * sin(a), a + beta - pi / 2), turned, 0.03))

    def deck(size: float, corner: float) -> str:
        corners = [2 * pi * k / 3 + e for k in range(3) for e in (-0.46, 0.46)]
        return rounded(
            [(size * long * cos(a), size * long * sin(a)) for a in corners], corner * long
        )

    parts = (
        Outline(deck(0.98, 0.16), "side", "edge"),
        Outline(deck(0.9, 0.13), "dome", "shell_dark", 0.006 * long),
        *wheels,
        Outline(disc(0.34 * long), "side", "shell_dark", 0.01 * long),
        Outline(disc(0.29 * long), "dome"),
        Outline(
            line((0.07 * long, -0.11 * long), (0.18 * long, 0), (0.07 * long, 0.11 * long)),
            "",
            "dark",
            0.036 * long,
        ),
        Outline(disc(0.026 * long), "dark"),
    )
    return Sprite(pose, parts, height=0.03, look=look)


def platform(
    pose: Any,
    angles: Sequence[Any] = (),
    lengths: Sequence[float] = (0.3, 0.4, 0.2),
    opening: Any = 1,
    look: str = "",
) -> Sprite:
    """Return a platform of 40 by 30 cm on four wheels, and with angles an arm on it."""
    wheels = [wheel((x, y, 0), 0.13, 0.045, "") for x in (-0.12, 0.12) for y in (-0.152, 0.152)]
    on_top = (arm((0, 0, 0), angles, lengths, opening=opening),) if len(angles) else ()
    bolts = "".join(disc(0.008, x, y) for x in (-0.16, 0.16) for y in (-0.1, 0.1))
    parts = (
        *wheels,
        Outline(box(0.4, 0.29, corner=0.05), "side", "edge"),
        Outline(box(0.37, 0.26, corner=0.04), "dome", "shell_dark", 0.003),
        Outline(line((0.135, -0.05), (0.165, 0), (0.135, 0.05)), "", "dark", 0.014),
        Outline(bolts, "metal_dark"),
        Outline(box(0.03, 0.2, -0.155, 0, 0.01), "accent"),
        *on_top,
    )
    return Sprite(pose, parts, height=0.04, look=look)
