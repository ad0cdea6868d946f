"""Predictions that the chapter on Euler angles asks for."""

import numpy as np
from sympy import asin, cos, pi, rad, sin

from book.euler.figures import GIVEN
from courseware.predictions import Buttons, Number, Prediction
from robokin import elbow_arm, euler

GAMMA = rad(GIVEN[2])
APART, SPECIAL, ALWAYS = "apart, as in step 2", "alike, for special angles", "alike, for any angles"


def ways_of_the_arm() -> str:
    """Return in how many ways the last chapter's arm reaches a place."""
    ways = elbow_arm.inverse([0.3, 0, 0.4], a2=0.4, a3=0.3)
    return {1: "one", 2: "two", 4: "four"}[len(np.unique(ways.round(6), axis=0))]


def third_quarter() -> str:
    """Return the direction of the point (−1, −1)."""
    return f"{np.degrees(np.arctan2(-1, -1)):.0f}°".replace("-", "−")


def own_or_room() -> str:
    """Return whether ZX and xz with the same angles are alike for none, some or all of many."""
    angles = np.random.default_rng(1).uniform(-3, 3, (100, 2))
    own, room = euler.to_matrix("ZX", angles), euler.to_matrix("xz", angles[:, ::-1])
    alike = np.isclose(own, room).all(axis=(1, 2))
    return ALWAYS if alike.all() else SPECIAL if alike.any() else APART


PREDICTIONS = (
    Prediction(
        "arm-ways",
        "The wrist of the arm must go to one place, beside the axis of the base and far from the "
        "limits of its reach. In how many ways can its three joints stand?",
        Buttons(
            ("one", "two", "four"),
            right=ways_of_the_arm,
            assumptions={
                "one": "The elbow can be up or down, and the wrist stays.",
                "two": "That is elbow up and down. The base can also face away from the place, and "
                "the arm lean back to it.",
            },
        ),
        explanation="Two directions of the base, each with the elbow up or down. They are the "
        "*branches* of the inverse kinematics.",
        spoilers=("two directions of the base",),
    ),
    Prediction(
        "third-quarter",
        "A point lies at $x$ = −1 m, $y$ = −1 m. In which direction is that, measured from the $x$ "
        "axis?",
        Buttons(
            ("45°", "−45°", "−135°"),
            right=third_quarter,
            assumptions={
                "45°": "The arctangent of $y/x$ gives 45°: in the quotient both signs are lost.",
                "−45°": "At −45° $y$ is negative, too, but $x$ is positive.",
            },
        ),
        explanation="Below and to the left: `arctan2(y, x)` keeps both signs. It will find most "
        "angles of this chapter.",
        spoilers=("keeps both signs",),
    ),
    Prediction(
        "first-column",
        "Now the die is turned by 90° about $y$ instead. What is the first column, where $x$ of "
        "the die points then? Try it with your right hand.",
        Buttons(
            ("(0, 0, 1)", "(0, 0, −1)", "(0, 1, 0)"),
            right="(0, 0, −1)",
            assumptions={
                "(0, 0, 1)": "That turns from $x$ to $z$, the left-handed way.",
                "(0, 1, 0)": "That is a turn about $z$.",
            },
        ),
        explanation="Thumb along $y$: the fingers of the right hand curl from $z$ to $x$. So $x$ "
        "itself goes down. Turn the die, and see. With any angle, about each axis:",
        spoilers=("goes down",),
        covers="columns",
    ),
    Prediction(
        "two-orders",
        "Where do the two dice end? By how much must one be turned to stand like the other?",
        Buttons(
            ("alike", "90° apart", "120° apart", "180° apart"),
            right="120° apart",
            assumptions={
                "alike": "So it is with numbers, and with turns about one and the same axis. Here "
                "the first turn takes the axis of the second one along.",
                "90° apart": "A quarter turn about an axis of the die leaves that axis where it "
                "is. Look at the faces with 1, 2 and 3 dots: none shows the same way on both dice.",
                "180° apart": "A half turn that takes a die to a die leaves one of its axes on "
                "its line. Look at 1, 2 and 3: none of their axes lies on one line in both.",
            },
        ),
        explanation="Not alike: a product of matrices depends on the order. Press *Play* to see it "
        "again.",
        spoilers=("depends on the order",),
        covers="order",
    ),
    Prediction(
        "own-or-room",
        "Where do the two dice end?",
        Buttons(
            (APART, SPECIAL, ALWAYS),
            right=own_or_room,
            assumptions={
                APART: "There both dice turned about their own axes. Here only one of them does.",
                SPECIAL: "Change both sliders: they still end alike.",
            },
        ),
        explanation="Alike, whatever the angles are. Why?",
        spoilers=("two readings", "whatever the angles"),
        covers="two-readings",
    ),
    Prediction(
        "read-gamma",
        "Read the three angles, tens of degrees, from the ghost's matrix, and bring the die onto "
        "the ghost. One entry holds only $\\beta$: begin there. How large is $\\gamma$?",
        Number(
            "°",
            right=GAMMA,
            assumptions={
                "That forgets a minus: $r_{12}$ is $-\\sin\\gamma\\cos\\beta$.": -GAMMA,
                "That forgets $\\cos\\beta$: $-r_{12}$ is $\\sin\\gamma\\cos\\beta$.": asin(
                    cos(rad(GIVEN[1])) * sin(GAMMA)
                ),
                "Then $\\cos\\beta$ would be negative.": GAMMA + pi,
            },
        ),
        explanation="$r_{11}$ = 0.81 is $\\cos\\gamma\\cos\\beta$, and $-r_{12}$ = −0.30 is "
        "$\\sin\\gamma\\cos\\beta$. Draw an arrow with these two as $x$ and $y$: it points to the "
        "right and down, and its direction is $\\gamma$.",
        spoilers=("to the right and down",),
    ),
    Prediction(
        "other-answer",
        "Where do the two dice end, after all three turns?",
        Buttons(
            ("alike", "a quarter turn apart", "half a turn apart"),
            right="alike",
            assumptions={
                "a quarter turn apart": "No angle differs by a quarter turn: the outer two differ "
                "by 180°, the middle one by 120°. What counts is all three together.",
                "half a turn apart": "The right die makes two half turns more, the first and the "
                "last. Between them it lies upside down, so the last one undoes the first.",
            },
        ),
        explanation="The first half turn puts the die upside down, $180° - \\beta$ continues "
        "from there, the last half turn turns it back. It is so for every $\\beta$: "
        "every matrix has at least two answers; textbooks take the one with a positive "
        "$\\cos\\beta$. The other one:",
        spoilers=("two answers",),
        covers="both-answers",
    ),
    Prediction(
        "ring-against-ring",
        "Let the middle ring stand at 90°. The outer ring is turned forward by 30° and the inner "
        "ring back by 30°. What does the aeroplane do?",
        Buttons(
            ("it turns by 60°", "it turns by 30°", "nothing"),
            right="nothing",
            assumptions={
                "it turns by 60°": "That adds the two, but they turn against each other.",
                "it turns by 30°": "That forgets one of the two rings.",
            },
        ),
        explanation="The pins of the outer and the inner ring lie on one line: what one turns "
        "forward, the other turns back. Try it above. The matrix of `XYZ` says the same "
        "for $\\beta$ = 90°:",
        spoilers=("lie on one line",),
        covers="gimbal-rings",
    ),
    Prediction(
        "near-lock",
        "The outer ring stands at 0°, the middle one at 89°. The aeroplane must turn at 1° a "
        "second about $z_A$, straight up. How fast must the inner ring turn?",
        Buttons(
            ("1° a second", "2° a second", "57° a second"),
            right="57° a second",
            assumptions={
                "1° a second": "That is right for $\\beta$ = 0°: there its axis is $z_A$.",
                "2° a second": "That is right for $\\beta$ = 60°: there half of its rate counts.",
            },
        ),
        explanation="The axis of the inner ring lies almost along that of the outer one. Only the "
        "part $\\cos\\beta$ of its rate counts, so the ring must race, and the outer ring takes "
        "back nearly all of it. The wrist of a robot near lock does the same. For 1 rad/s about "
        "$z_A$:",
        spoilers=("must race",),
    ),
    Prediction(
        "which-axis",
        "About which axis does one single turn take the die from {A} to {B}?",
        Buttons(
            ("through two faces", "through two edges", "through two corners"),
            right="through two corners",
            assumptions={
                "through two faces": "Such a turn leaves one axis of the die where it is. Here all "
                "three have moved.",
                "through two edges": "Such a turn swaps two axes, and the third stays on its line. "
                "Here all three lie on other lines.",
            },
        ),
        explanation="$x$ goes to $-y$, $-y$ to $z$, and $z$ to $x$: three axes in a circle, round "
        "a corner. In general the differences across the diagonal of $R$ point along the axis, and "
        "the sum of the diagonal tells the angle:",
        spoilers=("round a corner",),
    ),
)
