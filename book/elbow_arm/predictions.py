"""Predictions that the chapter on the elbow arm asks for."""

from typing import Any

import numpy as np
from sympy import Float, Rational, pi, rad

from book.elbow_arm import formulas
from book.elbow_arm.figures import (
    BENDS,
    FOREARM,
    GIVEN,
    LIFTS,
    LINKS,
    REACH,
    SHOULDER,
    TARGET,
    UPPER,
    borders,
    guess_h,
    guess_r,
    t,
)
from book.elbow_arm.formulas import theta2, theta3
from courseware.predictions import Buttons, Ghost, Number, Prediction, nearest_option
from robokin import elbow_arm

ARM = (*LINKS, SHOULDER)
FACING_UP, FACING_DOWN, AWAY_UP, AWAY_DOWN = elbow_arm.inverse(TARGET, *ARM)


def wrist(lifted: float, bent: float) -> tuple[float, float]:
    """Return where the wrist is, ahead of the shoulder and above it, for two angles in degrees."""
    return tuple(formulas.plane.substitute({**GIVEN, theta2: rad(lifted), theta3: rad(bent)}))


def bend() -> float:
    """Return how far the elbow is from straight with the wrist 61 cm from the shoulder, rad."""
    return float(abs(elbow_arm.inverse([0.61, 0, 0], *LINKS)[0, 2]))


IN_PROPORTION = pi / 2 * Rational(70 - 61, 70 - 50)  # rad: a guess for that


def reach(bent: Any) -> float:
    """Return how far from the shoulder the wrist is when the elbow is bent by so much, m."""
    bent = float(bent)
    return float(np.hypot(UPPER + FOREARM * np.cos(bent), FOREARM * np.sin(bent)))


def seen_from_above() -> str:
    """Return how many turns of the base there are for the target of the exercise."""
    turns = np.exp(1j * elbow_arm.inverse(TARGET, *ARM)[:, 0])
    return {1: "one", 2: "two"}[len(np.unique(turns.round(9)))]


def elbows() -> str:
    """Return how many elbows there are at four distances of the ball."""
    numbers = []
    for d in (0.70, 0.75, 0.10, 0.05):
        ways = np.exp(1j * elbow_arm.inverse([d, 0, SHOULDER], *ARM, unreachable="nan")[:2])
        ways = ways[np.isfinite(ways).all(axis=1)]
        numbers.append(str(len(np.unique(ways.round(6), axis=0))))
    return ", ".join(numbers)


def degrees(angles: np.ndarray) -> str:
    """Return two angles as an option shows them."""
    return " and ".join(f"{np.degrees(x):.0f}°".replace("-", "−") for x in angles)


def swept(passes: float) -> float:
    """Return by how much the base turns in all on a line that passes the axis, degrees."""
    return float(np.degrees(2 * np.arccos(passes / REACH)))


def twice_as_near() -> str:
    """Return what becomes of that angle at half the distance."""
    options = {"twice as large": 2, "a little larger": 1.15, "the same": 1}
    return nearest_option(options, swept(0.1) / swept(0.2))


PREDICTIONS = (
    Prediction(
        "straight-behind",
        "From *Before you start*: which direction does `arctan2(0, -2)` give?",
        Buttons(
            ("0°", "180°", "none"),
            right=lambda: f"{np.degrees(np.arctan2(0, -2)):.0f}°",
            assumptions={
                "0°": "The arctangent of the quotient 0/(−2) gives it, and loses the sign.",
                "none": "Only the point 0, 0 has no direction.",
            },
        ),
        explanation="`arctan2` takes $y$ first: the point is on the negative $x$ axis.",
        spoilers=("on the negative $x$ axis",),
    ),
    Prediction(
        "where-is-the-wrist",
        f"First the shoulder lifts the arm by {LIFTS}°, then the elbow bends by −100°: it turns "
        "the forearm downwards. Drag *your guess* to where the wrist will be.",
        Ghost(
            "wrist-guess",
            places=(guess_r, guess_h),
            right=wrist(LIFTS, BENDS),
            then={t: Float(2)},
            tolerance=0.04,
            assumptions={
                "That hangs the forearm almost straight down, as if its angle were measured from "
                "the level.": wrist(LIFTS, BENDS - LIFTS),
                "That bends the forearm upwards.": wrist(LIFTS, -BENDS),
            },
        ),
        explanation="The elbow's angle is measured from the upper link. So the forearm makes "
        "60° − 100° = −40° with the level: it points downwards.",
        spoilers=("= −40°",),
    ),
    Prediction(
        "how-many-directions",
        "From above the arm is a straight stick through the base axis. In how many directions can "
        "the base face, so that the ball lies on the line of the stick?",
        Buttons(
            ("one", "two", "infinitely many"),
            right=seen_from_above,
            assumptions={
                "one": "Towards the ball is one. A line goes on at the other side of the axis.",
                "infinitely many": "So it is if the ball is on the base axis itself. Beside it, a "
                "line through both is fixed.",
            },
        ),
        explanation="Towards the ball and exactly away from it: then the arm must reach back over "
        "its base.",
        spoilers=("exactly away from it",),
        covers="base-views",
    ),
    Prediction(
        "how-many-elbows",
        "The elbow is 40 cm from the shoulder, and 30 cm from the wrist. The wrist is to be at a "
        "ball at the distance $d$ from the shoulder: at 70 cm, then at 75, 10 and 5 cm. How many "
        "places are there for the elbow, in the plane of the arm?",
        Buttons(
            ("2, 1, 2, 2", "1, 0, 2, 2", "1, 0, 1, 0", "2, 0, 2, 0"),
            right=elbows,
            assumptions={
                "2, 1, 2, 2": "Stretched, the arm is 40 + 30 = 70 cm long.",
                "1, 0, 2, 2": "Think of the forearm folded back: how near to the shoulder can the "
                "wrist come?",
                "2, 0, 2, 0": "Two places are two bends. How many ways are there to be straight?",
            },
        ),
        explanation="All points at 40 cm from the shoulder are a circle, and so are those at 30 cm "
        "from the ball. The elbow must be on both.",
        spoilers=("must be on both",),
        covers="circles",
    ),
    Prediction(
        "how-bent",
        "The links are 40 and 30 cm. With the ball 50 cm from the shoulder the elbow is bent by "
        "90°: 3, 4, 5 make a right angle. At 70 cm it is straight, 0°. By how many degrees is it "
        "bent at 61 cm? Guess.",
        Number(
            "°",
            right=bend,
            assumptions={
                "That takes equal angles for equal distances. With that bend the wrist is "
                f"{100 * reach(IN_PROPORTION):.0f} cm from the shoulder.": IN_PROPORTION,
                "That is the angle inside the triangle, between the links.": lambda: pi - bend(),
            },
            relative=0.12,
        ),
        explanation="Near full stretch a little distance takes much angle. You can draw the "
        "triangle of 40, 30 and 61 cm, and measure it. To compute it:",
        spoilers=("takes much angle",),
        covers="triangle",
    ),
    Prediction(
        "faces-away",
        "The arm faces the ball with its elbow down: $\\theta_2$ is 16°, $\\theta_3$ is 90°. Now "
        "the base makes half a turn. Which $\\theta_2$ and $\\theta_3$ bring both links back to "
        "where they were?",
        Buttons(
            ("16° and 90°", "−16° and −90°", "164° and −90°", "164° and 90°"),
            right=lambda: degrees(AWAY_DOWN[1:]),
            assumptions={
                "16° and 90°": "Then the arm reaches to the other side, away from the ball.",
                "−16° and −90°": "Then the upper link points down, on the other side. It must lean "
                "over backwards.",
                "164° and 90°": "The upper link is right. But seen from behind, the elbow bends to "
                "the other side.",
            },
        ),
        explanation="The arm leans over its back: the upper link rises as steeply as before, "
        "measured from the other side. And the turned arm sees everything mirrored, so the elbow "
        "bends the other way round.",
        spoilers=("mirrored",),
        covers="turn-round",
    ),
    Prediction(
        "the-other-elbow",
        "The dot on the square is the arm: its $\\theta_2$ to the right, its $\\theta_3$ upwards. "
        "Take the gripper away from the ball. Bring it back there with the elbow *down*, and "
        "press *Here*. The dot draws a line behind it.",
        Ghost(
            "four-countries",
            places=(theta2, theta3),
            right=tuple(Float(x) for x in FACING_DOWN[1:]),
            then={borders: Float(1)},
            free=(theta2, theta3),
            tolerance=4,
            assumptions={
                "That is the elbow that you started with.": tuple(Float(x) for x in FACING_UP[1:])
            },
        ),
        explanation="On the way the elbow was straight for a moment, or folded. There is no other "
        "way. The borders are drawn now: your line crosses one of the black ones.",
        spoilers=("straight for a moment",),
    ),
    Prediction(
        "which-borders",
        "The arm holds its ball: facing, elbow up. In the end it should hold the ball *away, up*. "
        "Both links lie as before then. Find both dots on the map. What must happen to the "
        "arm on the way?",
        Buttons(
            (
                "only the base turns",
                "its wrist crosses the base axis",
                "it stretches or folds",
                "it does both",
            ),
            right="it does both",
            assumptions={
                "only the base turns": "The map does not show the base. But $\\theta_2$ and "
                "$\\theta_3$ are different at the end.",
                "its wrist crosses the base axis": "Over the curve you come to *away, down*.",
                "it stretches or folds": "Over the straight line you come to *facing, down*.",
            },
        ),
        explanation="The two regions have no border in common (with equal links they have: folding "
        "does both). They only meet in corners. So at least once the arm must be straight, or "
        "folded, and at least once its wrist must cross the axis.",
        spoilers=("no border in common",),
    ),
    Prediction(
        "answers-on-the-axis",
        "The ball is on the base axis, right above the shoulder. How many ways are there to grip "
        "it?",
        Buttons(
            ("two", "four", "infinitely many"),
            right="infinitely many",
            assumptions={
                "two": "Elbow up and down are two. But which way must the base face?",
                "four": "So many there are beside the axis.",
            },
        ),
        explanation="Every $\\theta_1$ is right. Turn the base, and the gripper stays.",
        spoilers=("every $\\theta_1$",),
        covers="on-the-axis",
    ),
    Prediction(
        "twice-as-near",
        "The wrist moves along a straight line that passes the base axis at 20 cm. Its speed stays "
        "the same. Both ends of the line are 60 cm from the axis. On a line at 10 cm the base must "
        "turn twice as fast at the nearest point. And the whole angle by which it turns, from end "
        "to end?",
        Buttons(
            ("twice as large", "a little larger", "the same"),
            right=twice_as_near,
            assumptions={
                "twice as large": "Twice as fast, but only for half as long. At 20 cm the whole "
                "angle is 141°: twice that would be most of a full turn.",
                "the same": "The ends of the line are seen from the axis under a larger angle, as "
                "the line comes nearer.",
            },
        ),
        explanation="It is the angle between the two ends of the line, seen from the axis: never "
        "more than 180°. Only the spike gets higher and thinner.",
        spoilers=("never more than 180°",),
        covers="spike",
    ),
)
