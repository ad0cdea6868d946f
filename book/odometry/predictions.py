"""Predictions that the chapter on encoder odometry asks for."""

import numpy as np

from courseware.predictions import Buttons, Prediction
from robokin import odometry

ROBOT = (512, 0.05, 0.20)  # ticks in a turn, radius and distance of the wheels, m: the exercise's
TICKS = (384, 640)  # of its sample, left and right
NOISE = 0.008**2  # m, of a wheel, for each metre


def circle(method: str) -> float:
    """Return how far from the start eight samples of the exercise end, by a rule, m."""
    left, right = ([each] * 8 for each in TICKS)
    end = odometry.path(left, right, *ROBOT, method=method)[-1]
    return float(np.hypot(*end[:2]))


def longer() -> float:
    """Return how many times as long the ellipse is after twice the distance, straight on."""
    sizes = []
    for each in (500, 1000):
        ticks = np.full(6, each)
        uncertain = odometry.covariance(ticks, ticks, *ROBOT, NOISE)[-1]
        sizes.append(odometry.ellipse(uncertain)[0][0])
    return float(sizes[1] / sizes[0])


def standard_deviations() -> float:
    """Return how many of them the odometry is off in y after the slip."""
    left, right = np.full(40, 80), np.full(40, 80)
    right[4] += 100
    off = odometry.path(left, right, *ROBOT)[-1, 1]
    return float(off / np.sqrt(odometry.covariance(left, right, *ROBOT, NOISE)[-1, 1, 1]))


PREDICTIONS = (
    Prediction(
        "how-much-turned",
        "By how much did the robot turn?",
        Buttons(
            ("23°", "45°", "90°"),
            right=lambda: f"{np.degrees(odometry.path(*TICKS, *ROBOT)[-1, 2]):.0f}°",
            assumptions={
                "23°": "That takes the robot for twice as wide.",
                "90°": "That takes the robot for half as wide: $b$ is the whole distance.",
            },
        ),
        explanation=f"And it is {100 * odometry.path(*TICKS, *ROBOT)[-1, 1]:.0f} cm to the left of "
        "the line that it looked along.",
        spoilers=("to the left of the line",),
    ),
    Prediction(
        "straight-on",
        "The robot drives straight on. Which of the two formulas fails then, that of $\\rho$ or "
        "that of the angle?",
        Buttons(
            ("both", "that of ρ", "neither"),
            right="that of ρ",
            assumptions={
                "both": "The angle is divided by $b$ only, and $b$ is not zero.",
                "neither": "On a straight line no point is at rest.",
            },
        ),
        explanation="There is no circle then, and $\\rho$ is a division by zero.",
        spoilers=("no circle",),
    ),
    Prediction(
        "whole-circle",
        "How far from the start does the rule with the old heading end?",
        Buttons(
            ("at the start", "about 3 cm off", "about 30 cm off"),
            right=lambda: "at the start" if circle("start") < 1e-9 else "about 3 cm off",
            assumptions={
                "about 3 cm off": "That adds up small errors that all point one way.",
                "about 30 cm off": "So far it is off on the way, half-way round.",
            },
        ),
        explanation="All of them close! The first three draw eight sides of one length, each "
        "turned by 45° from the one before: a regular octagon. So do not compare rules at the end "
        "of a full circle.",
        spoilers=("octagon", "all of them close"),
    ),
    Prediction(
        "wraps-round",
        "The counter shows 65,530 and, a few milliseconds later, 4. How many ticks has the wheel "
        "turned?",
        Buttons(
            ("10", "−65,526", "it can be any number"),
            right=lambda: f"{odometry.unwrap_counter([65530, 4], bits=16)[0]:.0f}",
            assumptions={
                "−65,526": "That is the difference of the two numbers: a leap of 40 m back.",
                "it can be any number": "So it is if more than half a round can pass between two "
                "readings. Then read more often.",
            },
        ),
        explanation="The counter could have gone either way round, and we take the *shorter* way.",
        spoilers=("shorter way", "shorter* way"),
    ),
    Prediction(
        "twice-as-far",
        "The robot drives straight on, twice as far. How many times as long is the ellipse then, "
        "measured across the drive?",
        Buttons(
            ("1.4 times", "2 times", "2.8 times"),
            right=lambda: f"{longer():.1f} times",
            assumptions={
                "1.4 times": "So random errors grow: like the root of the distance. But an error "
                "of the heading has a lever.",
                "2 times": "So the lever grows. But the error of the heading grows, too.",
            },
        ),
        explanation="The figure has six samples, and an ellipse after every second one.",
        spoilers=("every second one",),
    ),
    Prediction(
        "two-errors",
        "Which of the two turns both squares the same way?",
        Buttons(
            ("short corners", "swinging sides"),
            right="swinging sides",
            assumptions={
                "short corners": "Such a robot turns too little to the left in one square and too "
                "little to the right in the other: the two are mirrored.",
            },
        ),
        explanation="Swinging sides turn to the left in both squares. Short corners mirror them: "
        "too little to the left in one, too little to the right in the other.",
        spoilers=("to the left in both",),
    ),
    Prediction(
        "a-slip",
        "By how many of its standard deviations is the odometry wrong in $y$ at the end?",
        Buttons(
            ("less than 1", "about 2", "about 6"),
            right=lambda: f"about {standard_deviations():.0f}",
            assumptions={
                "less than 1": "A hundred ticks are 6 cm for one wheel. But the heading is wrong "
                "from there on.",
                "about 2": "The lever is longer: the slip comes early.",
            },
        ),
        explanation="The model knows small errors that average out, not one slip.",
        spoilers=("not one slip",),
    ),
)
