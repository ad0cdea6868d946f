"""Predictions that the chapter on the beacon asks for."""

from math import pi

from book.beacon import formulas
from book.beacon.figures import guess_x, guess_y
from book.beacon.formulas import b_x, b_y

from book.motion.formulas import omega, theta, to_world, v, v_y, x, y
from courseware.predictions import Buttons, Ghost, Number, Prediction

HERE = {x: 0, y: 0, theta: 0}


def in_world(ahead, left):
    """A point that the robot sees, as the world does."""
    return tuple(to_world.substitute({v: ahead, v_y: left, omega: 0, theta: 0})[:2])


PREDICTIONS = (
    Prediction(
        "beacon-turns",
        "The robot turns to the left. To which side does the beacon move, as the robot sees it?",
        Buttons(
            ("to its left", "to its right", "not at all"),
            right="to its right",
            assumptions={"to its left": "That is how the *robot* moves as the beacon sees it."},
        ),
        explanation="The bearing is counted from straight ahead, so $\\theta$ is taken off.",
        spoilers=("taken off",),
    ),
    Prediction(
        "beacon-far",
        "The beacon stands at $x = 3$, $y = 4$. How far away is it?",
        Number(
            "d",
            "m",
            right=formulas.distance.substitute(HERE | {b_x: 3, b_y: 4}),
            assumptions={"It goes along the walls.": (b_x + b_y).subs({b_x: 3, b_y: 4})},
        ),
        explanation="By Pythagoras.",
    ),
    Prediction(
        "beacon-place",
        "The beacon is 0.5 m away, straight to the left. Where is it?",
        Ghost(
            "beacon-guess",
            places=(guess_x, guess_y),
            right=in_world(0, 0.5),
            then={b_x: 0, b_y: 0.5, theta: pi / 6},
            tolerance=0.05,
            assumptions={"It takes ahead for left.": in_world(0.5, 0)},
        ),
        explanation="Left is along $y$.",
        spoilers=("Left is along",),
    ),
)
