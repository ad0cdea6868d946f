"""Predictions that the chapter on the elbow arm asks for."""

import numpy as np
from mpmath import acos, mpf, workdps
from sympy import pi

from book.elbow_arm.figures import SHOULDER, UPPER
from courseware.predictions import Buttons, Number, Prediction, nearest_option
from robokin import elbow_arm

FOREARM = 0.3  # m
TARGET = (-0.18, 0.24, 0.50)  # m, of the exercise
LINKS = UPPER, FOREARM, SHOULDER


def answers(target: tuple[float, float, float]) -> np.ndarray:
    """Return the four answers for a target: (4, 3), in rad."""
    return elbow_arm.inverse(target, *LINKS)


def bend() -> float:
    """Return how far the elbow is from straight at the target of the exercise, rad."""
    return float(np.abs(answers(TARGET)[:, 2]).max())


def reach(bent: float) -> float:
    """Return how far from the shoulder the wrist is when the elbow is bent by so much, m."""
    return float(np.hypot(UPPER + FOREARM * np.cos(bent), FOREARM * np.sin(bent)))


def turned_round() -> str:
    """Return the change of the elbow's angle when the base turns away and the elbow stays."""
    facing, away = answers(TARGET)[[0, 2], 2]
    options = {"no change": facing, "the other sign": -facing, "180° minus it": np.pi - facing}
    return nearest_option(options, away)


def digits() -> str:
    """Return how many digits the elbow's arccosine has, 1e-15 m short of full stretch."""
    d, upper, forearm = 0.75 - 1e-15, 0.5, 0.25
    squares, twice = upper**2 + forearm**2, 2 * upper * forearm
    with workdps(50):
        exact = acos((mpf(d) ** 2 - squares) / twice)
        wrong = float(abs(np.arccos((d**2 - squares) / twice) / exact - 1))
    return f"{-np.log10(wrong):.0f}"


def different() -> str:
    """Return how many answers a stretched arm has, and a folded one, beside the base axis."""
    reaches = UPPER + FOREARM, UPPER - FOREARM
    numbers = set()
    for reach in reaches:
        on_circle = np.exp(1j * answers((reach, 0, SHOULDER)))  # 180° is -180°
        numbers.add(len(np.unique(on_circle.round(9), axis=0)))
    (number,) = numbers  # the same for both, as the prediction says
    return ("one", "two", "three", "four")[number - 1]


PREDICTIONS = (
    Prediction(
        "how-bent",
        "By how many degrees must the elbow bend away from straight?",
        Number(
            "°",
            right=bend,
            assumptions={
                "That folds the forearm back onto the upper link.": pi,
                "Then the arm reaches too far: the wrist would be "
                f"{100 * reach(bend() / 2):.0f} cm from the shoulder, and the target is "
                f"{100 * reach(bend()):.0f} cm away.": lambda: bend() / 2,
            },
            relative=0.15,
        ),
        explanation="There are four ways to do it.",
        spoilers=("four ways",),
    ),
    Prediction(
        "faces-away",
        "The base faces away, and the elbow stays at the same place in the room. What becomes of "
        "$\\theta_3$?",
        Buttons(
            ("no change", "the other sign", "180° minus it"),
            right=turned_round,
            assumptions={
                "no change": "The bend is as large as before. But seen from behind, it is on the "
                "other side.",
                "180° minus it": "That is what becomes of $\\theta_2$: the upper link leans over "
                "backwards.",
            },
        ),
        explanation="The arm leans over backwards, as far from the horizontal as before: "
        "$\\theta_2$ becomes 180° minus $\\theta_2$. The elbow bends to the other side: "
        "$\\theta_3$ changes "
        'its sign. The turned arm sees everything mirrored: "elbow up" has a *negative* '
        "$\\theta_3$ if the arm faces the target, a *positive* one if it faces away.",
        spoilers=("mirrored", "changes its sign"),
    ),
    Prediction(
        "how-many-digits",
        "An arm of 50 cm and 25 cm is $10^{-15}$ m short of full stretch. The arccosine gives its "
        "elbow angle: how many of the 16 digits are right? (These lengths are exact in binary; "
        "only the formula can be to blame.)",
        Buttons(
            ("16", "8", "2"),
            right=digits,
            assumptions={
                "16": "The arccosine itself is as good as that. But the number that it is given "
                "has been rounded.",
                "8": "So many decimals are right. But the angle is small: its first digit is the "
                "seventh decimal.",
            },
        ),
        explanation="An angle near zero hides in the last digits of its cosine:",
        spoilers=("two digits", "last digits of its cosine"),
    ),
    Prediction(
        "answers-when-stretched",
        "The arm is stretched, but not straight up or down. How many different answers are left?",
        Buttons(
            ("one", "two", "four"),
            right=different,
            assumptions={
                "one": "The base can still face the target or face away.",
                "four": "The library gives four rows. Compare them.",
            },
        ),
        explanation="Up and down melt into one. It is the same for a folded arm, if its links "
        "differ in length and it does not point straight up or down.",
        spoilers=("melt into one",),
    ),
    Prediction(
        "answers-on-the-axis",
        "The target lies on the base axis, right above the shoulder. How many answers are there?",
        Buttons(
            ("two", "four", "infinitely many"),
            right="infinitely many",
            assumptions={
                "two": "Elbow up and down are two. But which way must the base look?",
                "four": "So many it has beside the axis, where only one turn of the base leads "
                "to the target, and one away from it.",
            },
        ),
        explanation="Every $\\theta_1$ is right. The library takes 0 (and 180° for away). The line "
        "to the wrist is upright, so no elbow is *above* it; the rows keep their order.",
        spoilers=("every $\\theta_1$",),
    ),
)
