"""Predictions that the chapter on odometry asks for."""

import numpy as np
from sympy import Float

from book.differential_drive.figures import guess_x, guess_y, t
from book.differential_drive.formulas import r
from book.odometry import formulas
from book.odometry.figures import SAMPLE_TIME, K
from book.odometry.formulas import N_L, N_R, C
from courseware.predictions import Buttons, Ghost, Number, Prediction, nearest_option
from robokin import motion, odometry

ROBOT = (512, 0.05, 0.20)  # ticks in a turn, radius and distance of the wheels, m: the exercise's
TICKS = (384, 640)  # of its sample, left and right
ENCODER = {C: ROBOT[0], r: Float("0.05"), N_L: TICKS[0], N_R: TICKS[1]}


def place(method: str) -> tuple[float, float]:
    """Return where the exercise's sample ends by a rule, m."""
    end = odometry.path(*TICKS, *ROBOT, method=method)[-1]
    return float(end[0]), float(end[1])


def rolled(radius: float = 1.0) -> float:
    """Return how far the left wheel of the exercise rolls, if its radius is so much larger, m."""
    return float(formulas.travel.substitute({**ENCODER, r: radius * 0.05})[0])


def circle(method: str) -> float:
    """Return how far from the start eight samples of the exercise end, by a rule, m."""
    left, right = ([each] * 8 for each in TICKS)
    end = odometry.path(left, right, *ROBOT, method=method)[-1]
    return float(np.hypot(*end[:2]))


def slipped(place: int) -> float:
    """Return how far the end of a straight drive is off, if a slip is in one of its samples, m."""
    left, right = np.full(40, 80), np.full(40, 80)
    right[place] += 100
    return float(np.hypot(*(odometry.path(left, right, *ROBOT)[-1, :2] - [1.963, 0])))


def longer() -> float:
    """Return how many times as wide the ellipse is after twice the distance, straight on."""
    sizes = []
    for each in (500, 1000):
        ticks = np.full(6, each)
        uncertain = odometry.covariance(ticks, ticks, *ROBOT, K)[-1]
        sizes.append(odometry.ellipse(uncertain)[0][0])
    return float(sizes[1] / sizes[0])


def about_which() -> str:
    """Return about which point a robot turns whose left wheel stands still."""
    options = {"P": (0, 0), "the left wheel": (0, 0.1), "the right wheel": (0, -0.1)}
    return nearest_option(options, motion.icr([0, 0, 0], v=0.05, omega=0.5))


PREDICTIONS = (
    Prediction(
        "held-wheel",
        "From chapter 4: a robot holds its left wheel still, and its right wheel rolls forward. "
        "About which point does it turn?",
        Buttons(
            ("P", "the left wheel", "the right wheel"),
            right=about_which,
            assumptions={
                "P": "P rolls forward, half as fast as the right wheel.",
                "the right wheel": "That one moves. The centre is at rest.",
            },
        ),
        explanation="The point at rest is where the held wheel touches the floor.",
        spoilers=("held wheel touches",),
    ),
    Prediction(
        "quarter-turn",
        "From *Before you start*: the arrow (2, 1) is turned by 90° to the left. Which arrow is it "
        "then?",
        Buttons(
            ("(1, −2)", "(−1, 2)", "(−2, −1)"),
            right=lambda: nearest_option(
                {"(1, −2)": (1, -2), "(−1, 2)": (-1, 2), "(−2, −1)": (-2, -1)},
                motion.to_world(np.pi / 2, [2.0, 1.0, 0.0])[:2],
            ),
            assumptions={
                "(1, −2)": "That is a quarter turn to the right.",
                "(−2, −1)": "That is half a turn.",
            },
        ),
        explanation="The two numbers change places, and the first one changes its sign.",
        spoilers=("change places",),
    ),
    Prediction(
        "ticks-to-metres",
        "The left encoder counts 384 ticks of the 512 in a turn. How far has its wheel rolled?",
        Number(
            "cm",
            right=rolled(),
            assumptions={
                "That takes the radius for the distance of a turn: 2π is missing.": rolled()
                / (2 * np.pi),
                "That takes the diameter for the radius.": rolled(2),
                "That is a whole turn.": rolled() * ROBOT[0] / TICKS[0],
            },
        ),
        explanation="Three quarters of a turn, so three quarters of the circumference $2\\pi r$.",
        spoilers=("three quarters of the",),
    ),
    Prediction(
        "how-much-turned",
        "The wheels of the exercise roll as far as you computed in step 1; they are 20 cm apart. "
        "By how much does the robot turn?",
        Buttons(
            ("23°", "45°", "90°"),
            right=lambda: f"{np.degrees(odometry.path(*TICKS, *ROBOT)[-1, 2]):.0f}°",
            assumptions={
                "23°": "That takes the robot for twice as wide.",
                "90°": "That takes the robot for half as wide: $b$ is the whole distance.",
            },
        ),
        explanation="15.7 cm more on the right, over a robot 20 cm wide: 0.785 rad.",
        spoilers=("0.785",),
        covers="strips",
    ),
    Prediction(
        "where-is-it",
        "The exercise's robot turns and moves as you computed in step 2. Drag *your guess* to "
        "where P is then.",
        Ghost(
            "rule-guess",
            places=(guess_x, guess_y),
            right=lambda: place("exact"),
            then={t: Float(SAMPLE_TIME)},
            tolerance=0.015,
            assumptions={
                "That is straight on, as if it turned only at the end.": lambda: place("start"),
                "That is as if it had turned before it drove.": lambda: place("end"),
            },
        ),
        explanation="P follows an arc that touches the old heading at its start and the new "
        "heading at its end.",
        spoilers=("touches the old",),
    ),
    Prediction(
        "whole-circle",
        "Eight samples of the exercise bring the robot once round a circle of radius 40 cm. How "
        "far from the start does the rule with the old heading end?",
        Buttons(
            ("at the start", "about 3 cm off", "about 30 cm off"),
            right=lambda: "at the start" if circle("start") < 1e-9 else "about 3 cm off",
            assumptions={
                "about 3 cm off": "That adds up small errors that all point one way.",
                "about 30 cm off": "So far it is off on the way, half-way round.",
            },
        ),
        explanation="All of them close! Eight equal sides, each turned by 45° from the one before, "
        "are a regular octagon. So do not compare rules there.",
        spoilers=("octagon", "all of them close"),
    ),
    Prediction(
        "early-or-late",
        "A right wheel slips once by 6 cm: it counts what the robot does not drive. On a way "
        "like this one, when is the end further off?",
        Buttons(
            ("if it slips early", "if it slips late", "it is the same"),
            right=lambda: "if it slips early" if slipped(4) > slipped(35) else "if it slips late",
            assumptions={
                "if it slips late": "Near the end little is left that can be wrong.",
                "it is the same": "The slip is. But it turns the robot, and all that follows.",
            },
        ),
        explanation="The slip turns the robot a little, and everything that follows turns with it.",
        spoilers=("everything that follows turns",),
        covers="door",
    ),
    Prediction(
        "twice-as-far",
        "The robot drives 2 m straight on, in place of 1 m. How many times as wide is the cloud "
        "then, measured across the drive?",
        Buttons(
            ("1.4 times", "2 times", "2.8 times"),
            right=lambda: f"{longer():.1f} times",
            assumptions={
                "1.4 times": "So random errors grow: like the root of the distance. But an error "
                "of the heading has a lever.",
                "2 times": "So the levers grow. But there are twice as many slips, too.",
            },
        ),
        explanation="The levers are twice as long, and √2 is there because there are twice as many "
        "slips.",
        spoilers=("√2 is there",),
        covers="error-ellipse",
    ),
    Prediction(
        "two-errors",
        "Every corner turns too little, or every side swings to the left. Which of the two turns "
        "both squares the same way?",
        Buttons(
            ("corners", "swinging sides"),
            right="swinging sides",
            assumptions={
                "corners": "Such a robot turns too little to the left in one square and too "
                "little to the right in the other: the two are mirrored.",
            },
        ),
        explanation="Swinging sides turn to the left in both squares. Corners are mirrored.",
        spoilers=("to the left in both",),
        covers="square-path",
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
        spoilers=("we take the shorter",),
        covers="counter-clock",
    ),
)
