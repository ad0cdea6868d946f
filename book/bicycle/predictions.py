"""Predictions that the chapter on the bicycle model asks for."""

import numpy as np
from sympy import atan

from book.bicycle import formulas
from book.bicycle.figures import DURATION, LENGTH, RADIUS, TRACK
from book.bicycle.formulas import track, wheelbase
from book.differential_drive.formulas import R
from courseware.predictions import Buttons, Number, Prediction
from robokin import bicycle

WHEELS = np.radians([37.57, 27.76])  # the exercise's front wheels, left and right
CAR = {wheelbase: 2.5, track: TRACK}  # m
LONG = {wheelbase: LENGTH, track: TRACK}


def beside_the_mean() -> str:
    """Return where the bicycle's angle lies."""
    less = WHEELS.mean() - bicycle.equivalent_steering(*WHEELS)
    return "a little less" if less > 1e-9 else "a little more" if less < -1e-9 else "the mean"


def error(n: int) -> float:
    """Return how far the long car's drive is off in n straight steps, m."""
    drive = 8.0 * RADIUS, np.radians(30), LENGTH, np.full(n, DURATION / n)
    exact, steps = (bicycle.path([0, 0, 0], *drive, method=m)[-1] for m in ("exact", "start"))
    return float(np.hypot(*(exact - steps)[:2]))


def one_step(seconds: float) -> float:
    """Return how far a single straight step of the long car ends from the exact place, m."""
    drive = 8.0 * RADIUS, np.radians(30), LENGTH, np.array([seconds])
    exact, straight = (bicycle.path([0, 0, 0], *drive, method=m)[-1] for m in ("exact", "start"))
    return float(np.hypot(*(exact - straight)[:2]))


def left(ratio: float) -> str:
    """Return how much of an error is left, in words."""
    words = {"all of it": 1, "a half": 1 / 2, "a quarter": 1 / 4}
    return min(words, key=lambda answer: abs(words[answer] - ratio))


def centre_if_alike(angle: float) -> str:
    """Return where the car turns without sliding, both front wheels turned by the same angle."""
    off = bicycle.ackermann_error(angle, angle, CAR[wheelbase], CAR[track])
    return "nowhere" if abs(off) > 1e-9 else "where one wheel of 30° puts it"


PREDICTIONS = (
    Prediction(
        "which-mean",
        f"The mean of the two angles is {np.degrees(WHEELS.mean()):.2f}°. Is $\\varphi$ the mean, "
        "a little more, or a little less?",
        Buttons(
            ("the mean", "a little more", "a little less"),
            right=beside_the_mean,
            assumptions={
                "the mean": "The bicycle's wheel stands half-way between the two, but its angle "
                "is not half-way: a tangent lies between place and angle.",
                "a little more": "That leans to the inner wheel, which is turned more. It is the "
                "other way round.",
            },
        ),
        explanation=f"It is {np.degrees(bicycle.equivalent_steering(*WHEELS)):.2f}°. And why do "
        "the two wheels differ? The inner wheel is nearer to the point that the car turns about, "
        "so it is turned more.",
        spoilers=("32.01°", "nearer to the point"),
    ),
    Prediction(
        "turned-alike",
        "Now both front wheels are turned by the *same* 30°. Where is the point about which the "
        "car can turn *without sliding*?",
        Buttons(
            ("where one wheel of 30° puts it", "without end far away", "nowhere"),
            right=lambda: centre_if_alike(np.radians(30)),
            assumptions={
                "where one wheel of 30° puts it": "So it is for a bicycle. The two wheels of the "
                "car stand in two places.",
                "without end far away": "So it is straight ahead: then all axles are parallel.",
            },
        ),
        explanation="The axles of the two wheels are parallel and never meet. Their cotangents "
        f"differ by 0, which is {TRACK / CAR[wheelbase]:.1f} less than $b$ over $L$. A car that is "
        "driven like this still turns about some point, but its tyres slide.",
        spoilers=("never meet", "tyres slide"),
    ),
    Prediction(
        "how-far",
        "The more the car steers, the nearer comes the ICR. At which $\\varphi$ does it reach the "
        "inner rear wheel?",
        Number(
            "°",
            right=formulas.steepest_steering.substitute(CAR),
            assumptions={
                "That brings it to P, in the middle of the axle.": lambda: np.arctan2(np.inf, 1),
                "That takes the whole track: from one rear wheel to the other.": atan(
                    wheelbase / track
                ).subs(CAR),
            },
            relative=0.02,
        ),
        explanation="There $|R|$ is $b/2$, and the inner front wheel stands at 90°.",
        spoilers=("73.3",),
    ),
    Prediction(
        "twice-the-steps",
        "The loop takes twice as many steps. How much of its error is left?",
        Buttons(
            ("all of it", "a half", "a quarter"),
            right=lambda: left(error(20) / error(10)),
            assumptions={
                "all of it": "So it would be if a step of half the length had half the error. It "
                f"has {left(one_step(0.5) / one_step(1.0))} of it.",
                "a quarter": "That is right for a single step. But there are twice as "
                "many of them.",
            },
        ),
        explanation="The error is proportional to the step (*order* 1).",
        spoilers=("proportional to the step",),
    ),
    Prediction(
        "how-wide",
        "Our vehicle is 1.5 m wide. How wide is its lane at a steering of 30°?",
        Number(
            "m",
            right=formulas.lane.substitute({**LONG, R: bicycle.turning_radius(np.pi / 6, LENGTH)}),
            assumptions={
                "That is the car alone: so it is straight ahead.": track.subs(LONG),
            },
            relative=0.1,
        ),
        explanation="More than twice the car. Steer to 30° and look. Each dot draws the line of "
        "its colour: rear axle, centre, front axle. The lane's edges are blue and orange.",
        spoilers=("twice the car",),
    ),
)
