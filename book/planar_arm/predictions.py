"""Predictions that the chapter on the planar arm asks for."""

import numpy as np
from sympy import Float

from book.planar_arm import formulas
from book.planar_arm.figures import guess_x, guess_y, laid, turned
from book.planar_arm.formulas import damping, sigma, v
from courseware.predictions import Buttons, Ghost, Number, Prediction, nearest_option
from robokin import differential_drive, planar_arm

LENGTHS = (0.4, 0.3, 0.2)  # m, of the exercise
THETA = np.radians([30, 60, -90])
RATES = (0.2, -0.5, 0.4)  # rad/s, of the exercise
LEFT = np.array([-0.65, 0, 0])  # m, m, rad: the way along the straight line
DURATION = 4.0  # s


def far_apart():
    """Say where the ICR is when both wheels are equally fast."""
    twist = differential_drive.body_twist(3.0, 3.0, 0.03, 0.1)
    radius = differential_drive.turning_radius(0.1, 0.1, 0.1)
    return "at infinity" if twist[2] == 0 and np.isinf(radius) else "on one wheel"


def hand_after(joint, degrees):
    """Return where P is when one joint has turned by so much."""
    turns = np.radians([degrees * (k == joint) for k in (1, 2, 3)])
    return tuple(Float(float(each)) for each in planar_arm.forward(THETA + turns, LENGTHS)[:2])


def joint_place(number):
    """Return where a joint is."""
    return tuple(
        Float(float(each)) for each in planar_arm.joint_positions(THETA, LENGTHS)[number - 1]
    )


def at_rest():
    """Return the point of the hand's plane that rests when all joints turn alike."""
    places = planar_arm.joint_positions(THETA, LENGTHS)[:3]
    return tuple(Float(float(each)) for each in places.mean(axis=0))


def resting_joint():
    """Say which joint rests while the hand turns about the middle between base and wrist."""
    pose = planar_arm.forward(THETA, LENGTHS)
    off = pose[:2] - planar_arm.joint_positions(THETA, LENGTHS)[2] / 2
    rates = planar_arm.joint_rates(THETA, [-off[1], off[0], 1], LENGTHS)
    return f"joint {int(np.argmin(np.abs(rates))) + 1}"


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
    return "always" if straight else "while joint 3 is bent" if bent else "never"


def damped_at_singular() -> str:
    """Say how large the damped rate is where σ is 0."""
    found = formulas.damped_single.substitute({sigma: 0, v: 0.1, damping: 0.05})
    return nearest_option({"huge": 300.0, "v/(2λ)": 1.0, "0": 0.0}, float(found))


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
        "both-wheels-alike",
        "From chapter 4: a robot turns about its *instantaneous centre of rotation*, the ICR. Both "
        "wheels are equally fast. Where is it?",
        Buttons(
            ("on one wheel", "at infinity", "between the wheels"),
            right=far_apart,
            assumptions={
                "on one wheel": "Then this wheel would be at rest.",
                "between the wheels": "There it is when the wheels turn against each other.",
            },
        ),
        explanation="Straight on is a turn about a point at infinity.",
        spoilers=("a turn about a point",),
    ),
    Prediction(
        "where-the-pen-goes",
        "Joint 2 alone turns, by a quarter turn counter-clockwise. Drag *your guess* to where "
        "P, the tip of the pen, will be.",
        Ghost(
            "hand-guess",
            places=(guess_x, guess_y),
            right=hand_after(2, 90),
            then={turned: Float(1)},
            tolerance=0.05,
            assumptions={
                "That is a turn about joint 1, the base.": hand_after(1, 90),
                "That is the other way round: clockwise.": hand_after(2, -90),
                "That turns joint 3.": hand_after(3, 90),
            },
        ),
        explanation="Link 2 and the pen turn like one stiff body, about joint 2.",
        spoilers=("like one stiff body",),
    ),
    Prediction(
        "how-fast-turned",
        "The joints turn at 0.2, −0.5 and 0.4 rad/s. How fast does the *hand* turn?",
        Number(
            "rad/s",
            right=lambda: float(planar_arm.velocity(THETA, RATES, LENGTHS)[2]),
            assumptions={
                "So fast does joint 3 turn against link 2. But link 2 turns, too.": Float(RATES[2]),
                "That adds up the sizes. Joint 2 turns the other way.": Float(sum(map(abs, RATES))),
                "That is the mean of the three.": Float(sum(RATES) / 3),
            },
        ),
        explanation="Each joint turns all that comes after it, so the rates add up.",
        spoilers=("rates add up",),
        covers="tip-to-tail",
    ),
    Prediction(
        "where-the-sheet-rests",
        "Think of a large sheet of paper that is glued to the hand. All three joints turn at the "
        "same rate. At this moment one point of the sheet is at rest. Drag *your pin* there.",
        Ghost(
            "balance-guess",
            places=(guess_x, guess_y),
            right=at_rest(),
            then={laid: Float(1)},
            tolerance=0.05,
            assumptions={
                "That is joint 1. It rests, but the sheet over it is turned by joints 2 and 3.": (
                    joint_place(1)
                ),
                "That is joint 2. So it is if joint 2 alone turns.": joint_place(2),
                "That is joint 3. So it is if joint 3 alone turns.": joint_place(3),
            },
        ),
        explanation="Where three equal weights on the joints would balance.",
        spoilers=("equal weights", "would balance"),
    ),
    Prediction(
        "who-rests",
        "Now backwards. The hand must turn about the point halfway between joint 1 and joint 3. "
        "Which joint rests?",
        Buttons(
            ("joint 1", "joint 2", "joint 3", "none"),
            right=resting_joint,
            assumptions={
                "joint 1": "Then only weights on joints 2 and 3 are left. They balance on link 2.",
                "joint 3": "Then only weights on joints 1 and 2 are left. They balance on link 1.",
                "none": "A weight on joint 2 would pull the balance point off that line.",
            },
        ),
        explanation="Equal weights on joints 1 and 3 balance there: joint 2, the elbow, is "
        "free of any weight.",
        spoilers=("free of any weight",),
        covers="areas",
    ),
    Prediction(
        "ever-nearer",
        "The wrist, joint 3, must move straight away from the base, at 10 cm/s. The elbow is at "
        "1°, then at 0.1°. How many times faster must joint 2 turn?",
        Buttons(
            ("3 times", "10 times", "100 times"),
            right=times_faster,
            assumptions={
                "3 times": "That would be one over the square root of the angle.",
                "100 times": "That would be one over the square of the angle.",
            },
        ),
        explanation="Ten times nearer, ten times faster: at 0.1° more than 50 turns a second. At "
        "0° no rate is fast enough. The reason is the formula's denominator.",
        spoilers=("ten times faster",),
    ),
    Prediction(
        "a-free-hand",
        "And if the hand may turn as it likes? Then only the first two rows of $J$ count. Their "
        "*rank* is the number of independent directions of motion. The elbow is stretched: when "
        "can P move in every direction?",
        Buttons(
            ("always", "while joint 3 is bent", "never"),
            right=where_both,
            assumptions={
                "always": "On one straight line of links all levers lie along it, and P moves "
                "only across.",
                "never": "That is so for the wrist. But P has one more joint.",
            },
        ),
        explanation="Link 3 turns, and pushes P along the arm. Only with all links on one line do "
        "the two rows have rank 1.",
        spoilers=("pushes P", "rank 1"),
        covers="ellipse",
    ),
    Prediction(
        "damped-to-the-end",
        "The rate that makes a sum of squares least is a compromise: the velocity shall be nearly "
        "right, the rate not too large. How large is it in the singular pose itself, where "
        "$\\sigma$ is 0?",
        Buttons(
            ("huge", "v/(2λ)", "0"),
            right=damped_at_singular,
            assumptions={
                "huge": "So it is without damping.",
                "v/(2λ)": "That is the largest rate. It is needed a little before.",
            },
        ),
        explanation="There a rate moves nothing, it only costs. So the best rate is 0.",
        spoilers=("moves nothing",),
    ),
    Prediction(
        "without-a-look",
        "The hand must go 0.65 m to the left in 10 steps, undamped. Within a step the joint rates "
        "stay as they are. How far from its goal does it end?",
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
        "A step lasts 0.4 s, so it takes back 0.4 times $K$ of the error. Which $K$ makes the end "
        "of 10 steps worse than no feedback at all?",
        Buttons(
            ("2", "4", "6", "none of them"),
            right=too_much,
            assumptions={
                "2": "In one step this takes back 0.8 of the error.",
                "4": "In one step this takes back 1.6 times the error: too much, yet less is left.",
                "none of them": "Feedback can take back more than twice the error.",
            },
        ),
        explanation="An error shrinks now. But when $K$ times the step "
        "exceeds 2, as 6 times 0.4 does, each step makes the error larger. At 5 it is just "
        "2: the error swings back and forth, and does not shrink.",
        spoilers=("exceeds 2",),
    ),
)
