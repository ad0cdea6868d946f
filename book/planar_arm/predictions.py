"""Predictions that the chapter on the planar arm asks for."""

import numpy as np

from courseware.predictions import Buttons, Prediction
from robokin import planar_arm

LENGTHS = (0.4, 0.3, 0.2)  # m, of the exercise
THETA = np.radians([30, 60, -90])
LEFT = np.array([-0.65, 0, 0])  # m, m, rad: the way along the straight line
DURATION = 4.0  # s


def distance() -> float:
    """Return the hand's distance from joint 1, m: its speed in m/s if this turns at 1 rad/s."""
    return float(np.hypot(*planar_arm.forward(THETA, LENGTHS)[:2]))


def elbow_rate(degrees: float) -> float:
    """Return how fast joint 2 turns where the wrist moves outward at 0.1 m/s, rad/s."""
    bent = np.radians([0, degrees, 0])
    wrist = planar_arm.joint_positions(bent, LENGTHS)[2]
    return float(planar_arm.joint_rates(bent, [*0.1 * wrist / np.hypot(*wrist), 0], LENGTHS)[1])


def times_faster() -> str:
    """Return how many times, from 1° to 0.1°."""
    return f"{elbow_rate(0.1) / elbow_rate(1):.0f} times"


def ways(third: float) -> int:
    """Return in how many directions P moves, the elbow stretched, joint 3 at an angle."""
    rows = planar_arm.jacobian(np.radians([30, 0, third]), LENGTHS)[:2]
    return int(np.linalg.matrix_rank(rows))


def where_both() -> str:
    """Say when P can move in every direction although the elbow is stretched."""
    bent, straight = ways(40) == 2, ways(0) == 2
    return "always" if straight else "while link 3 is bent" if bent else "never"


def off(steps: int, gain: float = 0.0) -> float:
    """Return how far from its goal the hand ends on the straight line, m."""
    start, angles = planar_arm.forward(THETA, LENGTHS), THETA
    for k in range(steps):
        error = start + LEFT * k / steps - planar_arm.forward(angles, LENGTHS)
        rates = planar_arm.joint_rates(angles, LEFT / DURATION + gain * error, LENGTHS)
        angles = angles + rates * DURATION / steps
    return float(np.hypot(*(start + LEFT - planar_arm.forward(angles, LENGTHS))[:2]))


def too_much() -> str:
    """Return the gain of those offered that makes the end worse than no feedback does."""
    worse = [gain for gain in ("2", "4", "6") if off(10, float(gain)) > off(10)]
    return worse[0] if len(worse) == 1 else "none of them"


PREDICTIONS = (
    Prediction(
        "one-joint",
        "Joint 1 alone turns, at 1 rad/s; the others are locked. How fast does the hand P move?",
        Buttons(
            ("0.40 m/s", "0.74 m/s", "0.90 m/s"),
            right=lambda: f"{distance():.2f} m/s",
            assumptions={
                "0.40 m/s": "So fast does joint 2 move, at the end of link 1.",
                "0.90 m/s": "That adds the links up. So it is when all of them are stretched.",
            },
        ),
        explanation=f"P is {distance():.2f} m from joint 1, and *One joint turns* says why only "
        "this counts. The hand turns too, at 1 rad/s.",
        spoilers=("from joint 1",),
    ),
    Prediction(
        "ever-nearer",
        "The wrist must move straight away from the base, at 10 cm/s. The elbow stands at 1°, "
        "then at 0.1°. How many times faster must joint 2 turn?",
        Buttons(
            ("3 times", "10 times", "100 times"),
            right=times_faster,
            assumptions={
                "3 times": "So it is if the rate goes with one over a root.",
                "100 times": "So it is if it goes with one over a square.",
            },
        ),
        explanation="Ten times nearer, ten times faster: more than 50 turns a second at a tenth of "
        "a degree. At 0° no rate does it. The reason is the denominator in the formula; "
        "$v_\\mathrm{out}$ is the wrist's speed.",
        spoilers=("ten times faster",),
    ),
    Prediction(
        "a-free-hand",
        "And if the hand may turn as it likes? Then only the first two rows of $J$ count. Their "
        "*rank* is the number of independent directions of motion. The elbow is stretched: when "
        "can P move in every direction?",
        Buttons(
            ("always", "while link 3 is bent", "never"),
            right=where_both,
            assumptions={
                "always": "On one straight line of links all levers lie along it, and P moves "
                "only across.",
                "never": "That is so for the wrist. But P has one more joint.",
            },
        ),
        explanation="Link 3 turns, and pushes P along the arm. Only with all links on one line do "
        "the two rows have rank 1, and P loses a direction.",
        spoilers=("pushes P", "rank 1"),
    ),
    Prediction(
        "without-a-look",
        "The hand must go 0.65 m to the left in 10 steps, undamped. How far from its goal does it "
        "end?",
        Buttons(
            ("on it", "5 cm off", "50 cm off"),
            right=lambda: f"{100 * off(10):.0f} cm off",
            assumptions={
                "on it": "The rates of a step are right at its beginning only.",
                "50 cm off": "That is nearly the whole way. Each step goes nearly where it should.",
            },
        ),
        explanation="It drifts: at constant joint rates the hand runs on a curve, and nothing "
        "brings it back. Twice the steps, half the drift.",
        spoilers=("runs on a curve, and", "half the drift"),
    ),
    Prediction(
        "too-much-feedback",
        "In 10 steps of 0.4 s: which $K$ makes the end worse than no feedback at all?",
        Buttons(
            ("2", "4", "6", "none of them"),
            right=too_much,
            assumptions={
                "2": "In one step this takes back 0.8 of the error.",
                "4": "In one step this takes back 1.6 times the error: too much, yet less is left.",
                "none of them": "Feedback can take back more than twice the error.",
            },
        ),
        explanation="An error now shrinks by itself, and the drift no longer adds up. But when $K$ "
        "times the step exceeds 2, as 6 times 0.4 does, each step makes the error larger. With a "
        "$K$ of 5 it is just 2: the error changes its sign at each step, and hardly shrinks.",
        spoilers=("exceeds 2",),
    ),
)
