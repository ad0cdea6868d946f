"""What the chapter's text tells of its figures, beyond a single readout."""

import numpy as np

from book.prose import read_figure
from robokin import bicycle

WHEELBASE, RADIUS, DURATION = 2.5, 0.25, 10.0  # m, m, s


def worst_mean(track: float) -> tuple[int, float]:
    """At which whole degree up to 70 the mean of both angles is most wrong, and by how much."""
    steering = np.radians(np.arange(71))
    wrong = bicycle.ackermann(steering, WHEELBASE, track).mean(axis=-1) - steering
    return int(wrong.argmax()), float(np.degrees(wrong.max()))


def degrees_for_lane(lane: float, wheelbase: float) -> int:
    """The whole degree of steering whose lane is nearest to the wanted one."""
    off = [
        abs(
            read_figure("swept-lane", "lane", wheelbase=wheelbase, steering=np.radians(degrees))
            - lane
        )
        for degrees in range(61)
    ]
    return int(np.argmin(off))


def half_way_error(n: int, rate: float, steering: float, wheelbase: float) -> float:
    """How far n straight steps of the rear axle are off after half of them, m."""
    drive = RADIUS * rate, steering, wheelbase, np.full(n, DURATION / n)
    exact, steps = (bicycle.path([0, 0, 0], *drive, method=m)[n // 2] for m in ("exact", "start"))
    return float(np.hypot(*(exact - steps)[:2]))
