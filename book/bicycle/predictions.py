"""Predictions that the chapter on the bicycle model asks for."""

import numpy as np
from sympy import atan, pi

from book.bicycle import formulas
from book.bicycle.figures import (
    BEND,
    CAR,
    DURATION,
    LONG,
    PACE,
    SPEED,
    L,
    along,
)
from book.bicycle.formulas import track, wheelbase
from book.differential_drive.figures import guess_x, guess_y, t
from book.differential_drive.formulas import R
from courseware.predictions import Buttons, Ghost, Number, Prediction, nearest_option
from robokin import bicycle, motion

WHEELS = np.radians([37.57, 27.76])  # the exercise's front wheels, left and right
THIRTY = np.radians(30)
LENGTH = float(LONG[wheelbase])


def which_mean() -> str:
    """Return of what of the two wheels the bicycle has the mean."""
    means = {
        "of their angles": WHEELS.mean(),
        "of their tangents": np.arctan(np.tan(WHEELS).mean()),
        "of their cotangents": np.arctan(1 / np.mean(1 / np.tan(WHEELS))),
    }
    return nearest_option(means, bicycle.equivalent_steering(*WHEELS))


def centre_by(mean: float) -> str:
    """Return what is wrong with a bicycle whose angle has a tangent."""
    return (
        f"That would be {np.degrees(np.arctan(mean)):.2f}°. Such a bicycle turns about a point "
        f"{L / mean:.2f} m away, the car about one {1 / BEND:.2f} m away."
    )


def centre_if_alike() -> str:
    """Return where the car turns without sliding, both front wheels turned by 30°."""
    off = bicycle.ackermann_error(THIRTY, THIRTY, CAR[wheelbase], CAR[track])
    return "nowhere" if abs(off) > 1e-9 else "where one wheel of 30° puts it"


def icr_at_rest() -> str:
    """Return where a robot turns whose wheels go at 5 and 10 cm/s, 10 cm apart, from the middle."""
    place = motion.icr([0, 0, np.pi / 2], 0.075, 0.5)
    options = {
        "15 cm to the left": (-0.15, 0),
        "5 cm to the left": (-0.05, 0),
        "in the middle": (0, 0),
    }
    return nearest_option(options, place)


def front_of() -> str:
    """Return how O moves against P."""
    forward, sideways, _ = bicycle.front_twist(1.0, np.radians(32.01), L)
    options = {
        "as fast, along the heading": (1, 0),
        "as fast, where its wheel points": (np.cos(np.radians(32.01)), np.sin(np.radians(32.01))),
        "faster, where its wheel points": (1, np.tan(np.radians(32.01))),
    }
    return nearest_option(options, (forward, sideways))


def error(n: int) -> float:
    """Return how far the long vehicle's drive is off in n straight steps, m."""
    drive = PACE, THIRTY, LENGTH, np.full(n, DURATION / n)
    exact, steps = (bicycle.path([0, 0, 0], *drive, method=m)[-1] for m in ("exact", "start"))
    return float(np.hypot(*(exact - steps)[:2]))


def one_step(seconds: float) -> float:
    """Return how far a single straight step of it ends from the exact place, m."""
    drive = PACE, THIRTY, LENGTH, np.array([seconds])
    exact, straight = (bicycle.path([0, 0, 0], *drive, method=m)[-1] for m in ("exact", "start"))
    return float(np.hypot(*(exact - straight)[:2]))


def left(ratio: float) -> str:
    """Return how much of an error is left, in words."""
    return nearest_option({"all of it": 1, "a half": 1 / 2, "a quarter": 1 / 4}, ratio)


def arms_to_the_middle() -> str:
    """Return what a steering trapezoid does whose arms point at the middle of the rear axle."""
    inner = np.radians(38)
    gamma = np.arctan(CAR[track] / 2 / CAR[wheelbase])
    values = {formulas.alpha_L: inner, formulas.arm: 0.2, formulas.arm_angle: gamma, **CAR}
    rods = [(name, step.subs(values)) for name, step in formulas.trapezoid.where]
    outer = float(formulas.trapezoid.right.subs(dict(rods)).subs(values).evalf())
    wanted = np.arctan(1 / (1 / np.tan(inner) + CAR[track] / CAR[wheelbase]))
    off = abs(np.degrees(outer - wanted))
    return "yes, exactly" if off < 1e-6 else "only nearly" if off < 5 else "not at all"


def after_two_seconds(steered):
    """Return where P of the exercise is after 2 s, if it is steered so."""
    return tuple(along((0, 0, pi / 2), steered, 2 * SPEED)[:2])


PREDICTIONS = (
    Prediction(
        "where-it-turned",
        "From the last chapter: the left wheel of a robot moves at 5 cm/s, the right one at "
        "10 cm/s, and they are 10 cm apart. Where is its ICR, the point that it turns about, seen "
        "from the middle of the axle?",
        Buttons(
            ("in the middle", "5 cm to the left", "15 cm to the left"),
            right=icr_at_rest,
            assumptions={
                "in the middle": "So it is when the wheels go at opposite speeds.",
                "5 cm to the left": "There is the left wheel, and it moves.",
            },
        ),
        explanation="Speed grows with the distance from the ICR. The right wheel is twice as "
        "fast as the left one, so it is twice as far away: 20 cm, and the left one 10 cm.",
        spoilers=("20 cm, and the left one 10 cm",),
    ),
    Prediction(
        "undo-a-move",
        "From chapter 3: a robot goes 1 m ahead, then turns to the left by 90°. What brings it "
        "back to its pose at the start?",
        Buttons(
            ("first go back, then turn back", "first turn back, then go back", "both are the same"),
            right="first turn back, then go back",
            assumptions={
                "first go back, then turn back": "The robot now points to the left. It would go "
                "back in that direction.",
                "both are the same": "A turn and a move cannot change places.",
            },
        ),
        explanation="Undo the last move first: the inverses, in the opposite order.",
        spoilers=("in the opposite order",),
    ),
    Prediction(
        "which-mean",
        "One front wheel in the middle does the work of the two. It is turned by a mean of the "
        "two, but which?",
        Buttons(
            ("of their angles", "of their tangents", "of their cotangents"),
            right=which_mean,
            assumptions={
                "of their angles": centre_by(np.tan(WHEELS.mean())),
                "of their tangents": centre_by(np.tan(WHEELS).mean()),
            },
        ),
        explanation=f"It is {np.degrees(bicycle.equivalent_steering(*WHEELS)):.2f}°. Step 2 shows "
        "why, without a line of algebra.",
        spoilers=("32.01°", "its cotangent"),
    ),
    Prediction(
        "turned-alike",
        "Both front wheels are turned by the *same* 30°. Where is the point about which the car "
        "can turn *without sliding*?",
        Buttons(
            ("where one wheel of 30° puts it", "infinitely far away", "nowhere"),
            right=centre_if_alike,
            assumptions={
                "where one wheel of 30° puts it": "Each wheel puts it at another place: they "
                "are 1.5 m apart.",
                "infinitely far away": "The axles of the front wheels are parallel. But that of "
                "the rear wheels is not.",
            },
        ),
        explanation="Two parallel lines do not meet. The car turns all the same, and its "
        "tyres slide.",
        spoilers=("parallel lines", "tyres slide"),
    ),
    Prediction(
        "another-track",
        "Another car is wider. Its ICR, too, lies at 1.6 wheelbases. Slid into the middle, the "
        "left wheel's line hits the ruler at 1.2. Where does the right wheel's line hit it?",
        Number(
            "",
            right=lambda: 2 * 1.6 - 1.2,
            assumptions={
                "That is this car's line: the other one is wider.": lambda: 1.9,
                "The bicycle's line does not move, and the others lie evenly about it.": (
                    lambda: 1.6
                ),
            },
            relative=0.01,
        ),
        explanation="At 2.0: as far to the one side of 1.6 as the left one is to the other.",
        spoilers=("at 2.0", "the mean of the two"),
    ),
    Prediction(
        "the-front-axle",
        "P moves at 2 m/s along the heading. And O, the middle of the front axle?",
        Buttons(
            (
                "as fast, along the heading",
                "as fast, where its wheel points",
                "faster, where its wheel points",
            ),
            right=front_of,
            assumptions={
                "as fast, along the heading": "Then the car would not turn.",
                "as fast, where its wheel points": "The direction is right. But O is farther from "
                "the ICR than P.",
            },
        ),
        explanation="O is farther from the ICR than P, so it is faster.",
        spoilers=("farther from the ICR than P",),
    ),
    Prediction(
        "rule-of-thumb",
        "A rule of thumb: let both arms point at the middle of the rear axle. Then the tie rod "
        "gives the outer wheel Ackermann's angle. Is that so?",
        Buttons(
            ("yes, exactly", "only nearly", "not at all"),
            right=arms_to_the_middle,
            assumptions={
                "yes, exactly": "In small turns the two angles differ little. But even "
                "there the rod makes only about half of the difference that is needed.",
                "not at all": "The outer wheel turns less than the inner one, and that is right.",
            },
        ),
        explanation="Up to 40° the outer wheel is off by about two degrees, with arms of 20 cm.",
        spoilers=("about two degrees",),
        covers="trapezoid",
    ),
    Prediction(
        "where-after-arc",
        "The car of the exercise drives on for 2 s. Drag *your guess* to where P will be.",
        Ghost(
            "guess-arc",
            places=(guess_x, guess_y),
            right=after_two_seconds(atan(L * BEND)),
            then={t: 2.0},
            tolerance=0.3,
            assumptions={
                "That is straight on, as if it did not turn.": after_two_seconds(0),
                "That is where O was at the start.": (0, L),
            },
        ),
        explanation="P has gone 4 m along its circle, and the radius is 4 m, too: the car has "
        "turned by one radian.",
        spoilers=("by one radian",),
    ),
    Prediction(
        "twice-the-steps",
        "A program computes the drive in straight steps. With twice as many steps, how much of "
        "the error at the end is left?",
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
        explanation="The error is proportional to the step: a method of *order* 1.",
        spoilers=("proportional to the step",),
    ),
    Prediction(
        "how-wide",
        "The long vehicle's wheels are 1.5 m apart. How wide is the lane that they need, steered "
        "by 30°?",
        Number(
            "m",
            right=formulas.lane.substitute({**LONG, R: bicycle.turning_radius(THIRTY, LENGTH)}),
            assumptions={
                "So far the rear axle runs inside the front one. But the vehicle is wide, too.": (
                    lambda: bicycle.corner_cut(THIRTY, LENGTH)
                ),
                "That is the vehicle alone, straight ahead. In a turn the rear wheels run inside "
                "the front ones.": track.subs(LONG),
            },
            relative=0.1,
        ),
        explanation="More than twice as wide as the vehicle: 1.5 m between its wheels, and 1.8 m "
        "by which the outer rear wheel runs inside the outer front one.",
        spoilers=("more than twice",),
    ),
)
