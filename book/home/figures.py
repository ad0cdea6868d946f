"""The live figure of the first page: the robot of chapter 4 and its charger, on a wide floor."""

from sympy import pi

from book import things
from book.differential_drive.figures import (
    DISTANCE,
    OFF,
    START,
    TIME,
    TURNED,
    VELOCITY,
    angle_size,
    arrows,
    drive_for,
    is_parked,
    robot,
    speed_sliders,
    t,
    tip_handles,
    way,
)
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, v, x, y
from courseware.figures import Clock, Figure, Goal, Label, Readout, distance

CHARGER = tuple(
    motion.arc_step.substitute({x: 0, y: 0, theta: pi / 2, v: 0.09, omega: -0.6, dt: TIME}).evalf(
        17
    )
)


def hero_figure() -> Figure:
    """Draw a robot with two wheel speeds to set, at the right of a floor with room for a title."""
    end = drive_for(TIME)
    off, turned = distance(end, CHARGER), angle_size(end[2] - CHARGER[2])
    return Figure(
        name="hero",
        title="A robot seen from above, its two wheels under your hand, and its charger",
        view=(-0.62, 0.4, -0.11, 0.32),
        ground="tiles",
        controls=(*speed_sliders(0.08, 0.05), Clock(t, 0.0, TIME, loops=True, label="time")),
        where=VELOCITY,
        shapes=(
            things.pad(CHARGER),
            way("left", 0, TIME, left=DISTANCE / 2),
            way("right", 0, TIME, left=-DISTANCE / 2),
            robot(end, look="ghost"),
            robot(drive_for(t), time=t),
            *arrows(START, middle=False),
            Label(
                "text", (CHARGER[0] + 0.04, CHARGER[1] - 0.11), "{off} cm off, turned by {turned}"
            ),
        ),
        handles=tip_handles(),
        readouts=(
            Readout("off", "cm from the charger", 100 * off, "", 0),
            Readout("turned", "turned wrongly by", turned, "rad", 0),
        ),
        sentence="The robot ends {off} cm from its charger, turned by {turned}.",
        goal=Goal(
            is_parked(end, CHARGER),
            f"Park the robot on its charger: within {OFF} cm and {TURNED}°.",
        ),
        size="",
    )


FIGURES = (hero_figure(),)
