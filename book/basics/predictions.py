"""Predictions that the page before the chapters asks for."""

import numpy as np

from courseware.predictions import Buttons, Prediction


def arctangent() -> str:
    """Return the arctangent of the point that lies behind and to the left, in degrees."""
    x, y = -1.0, 1.0
    return f"{np.degrees(np.arctan(y / x)):.0f}°".replace("-", "−")


def turned() -> str:
    """Return where the point one metre ahead goes, turned by 30°."""
    x, y = np.cos(np.radians(30)), np.sin(np.radians(30))
    return f"({x:.2f}, {y:.2f})"


PREDICTIONS = (
    Prediction(
        "behind-and-left",
        "The point is 1 m behind you and 1 m to the left. Left is $+y$, and a turn to the left "
        "counts as positive. What does the arctangent of $p_y/p_x$ say?",
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
        spoilers=("exactly the wrong way",),
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
        spoilers=("for radians",),
    ),
    Prediction(
        "turned-by-30",
        "Where does the point one metre ahead go, when you turn it by 30°?",
        Buttons(
            ("(0.87, 0.50)", "(0.50, 0.87)", "(0.87, −0.50)"),
            right=turned,
            assumptions={
                "(0.50, 0.87)": "That is a turn by 60°: the point stays nearer to the $x$ axis.",
                "(0.87, −0.50)": "That is a turn to the right.",
            },
        ),
        explanation="Ahead, and to the left.",
        spoilers=("ahead, and to the left",),
    ),
)
