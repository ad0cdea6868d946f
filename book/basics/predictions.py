"""Predictions that the page before the chapters asks for."""

import numpy as np

from book.basics.figures import SPEED, TIME
from courseware.predictions import Buttons, Prediction
from robokin import motion

CIRCLE = "all on a circle around the start"
LINE = "all on a straight line across"
NEARER = "nearer to the start, the more they turn"


def arctangent() -> str:
    """Return the arctangent of the point that lies behind and to the left, in degrees."""
    x, y = -1.0, 1.0
    return f"{np.degrees(np.arctan(y / x)):.0f}°".replace("-", "−")


def turned() -> str:
    """Return where the point one metre ahead goes, turned by 30°."""
    x, y = np.cos(np.radians(30)), np.sin(np.radians(30))
    return f"({x:.2f}, {y:.2f})"


def thousand_ends() -> str:
    """Return where robots end that drive equally far, each turned more than the one before."""
    rates = np.linspace(0, np.pi / TIME, 1000)
    ends = motion.arc_step([0, 0, 0], v=SPEED, omega=rates, dt=TIME)
    away = np.diff(np.hypot(ends[:, 0], ends[:, 1]))
    return NEARER if (away < 0).all() else CIRCLE


PREDICTIONS = (
    Prediction(
        "behind-and-left",
        "The ball is 1 m behind the robot and 1 m to its left. A turn to the left counts as "
        "positive. What does the arctangent of $p_y/p_x$ say?",
        Buttons(
            ("135°", "45°", "−45°"),
            right=arctangent,
            assumptions={
                "135°": "That is the angle. The arctangent does not find it.",
                "45°": "The quotient of the two is negative here.",
            },
        ),
        explanation="The angle is 135°. The arctangent says 45° to the *right and in front*: "
        "exactly the wrong way.",
        spoilers=("exactly the wrong way", "signs are lost"),
        covers="direction",
    ),
    Prediction(
        "sine-of-90",
        "What is `np.sin(90)`?",
        Buttons(
            ("1", "0", "about 0.89"),
            right=lambda: f"about {np.sin(90):.2f}",
            assumptions={
                "1": "That is the sine of a right angle, of 90 *degrees*.",
                "0": "That is the sine of whole half turns, and 90 radians are none.",
            },
        ),
        explanation="NumPy takes the 90 for radians: that is more than "
        f"{90 // (2 * np.pi):.0f} turns. Of 90° it is 1:",
        spoilers=("for radians", "in radians"),
    ),
    Prediction(
        "turned-by-30",
        "The tip of the red arrow lies 1 m ahead, at (1, 0). Where is it when the robot has turned "
        "by 30° to the left?",
        Buttons(
            ("(0.87, 0.50)", "(0.50, 0.87)", "(0.87, −0.50)"),
            right=turned,
            assumptions={
                "(0.50, 0.87)": "That is a turn by 60°: the point stays nearer to the $x$ axis.",
                "(0.87, −0.50)": "That is a turn to the right.",
            },
        ),
        explanation="Ahead, and to the left: the cosine of 30°, and its sine.",
        spoilers=("ahead, and to the left",),
        covers="turn",
    ),
    Prediction(
        "thousand-ends",
        "A thousand robots start here. Each drives 2 m: one straight on, the others turn as they "
        "drive, each a little more than the one before, half of them to each side. Where do "
        "they end?",
        Buttons(
            (CIRCLE, LINE, NEARER),
            right=thousand_ends,
            assumptions={
                CIRCLE: "Then all would be as far from the start as they have driven.",
                LINE: "Those that turn get less far ahead.",
            },
        ),
        explanation="All have driven 2 m. But only a straight way leads 2 m away from the start.",
        spoilers=("only a straight way",),
        covers="thousand",
    ),
)
