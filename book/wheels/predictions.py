"""Predictions that the chapter on wheels asks for."""

from math import atan2, cos, pi, radians, tan

import numpy as np
from sympy import Float

from book.differential_drive.figures import t
from book.wheels.figures import HIGH, RADIUS, SIZE, pin
from courseware.predictions import Buttons, Ghost, Number, Prediction
from robokin import wheels

LENGTH, HALF = 2.5, 0.75  # m, of the car: from axle to axle, and half between its wheels
COUNTS = ("none", "one", "two", "three")


def alike() -> str:
    """Say what the robot does with three equal positive rates."""
    x, y, turn = wheels.forward(wheels.omni_robot(SIZE, RADIUS), [1.0, 1.0, 1.0])
    moves = np.hypot(x, y) > 1e-9
    return "it drives" if moves else "it turns on the spot" if abs(turn) > 1e-9 else "it stays"


def independent(degrees: float) -> int:
    """Return how many rates are independent when all wheels are turned away from their spokes."""
    beta, thirds = np.radians(degrees), np.radians([0, 120, 240])
    robot = [wheels.swedish(SIZE, angle, beta, RADIUS, 0) for angle in thirds]
    return int(np.linalg.matrix_rank(wheels.rolling(robot), tol=1e-9))


def lost() -> str:
    """Return where the rates no longer determine the motion."""
    offered = {"30° and −30°": 30, "45° and −45°": 45, "90° and −90°": 90}
    return next(name for name, degrees in offered.items() if independent(degrees) < 3)


def front_wheel(y: float) -> wheels.Wheel:
    """Return a steered wheel of the car, straight ahead, at some distance to the left."""
    angle = np.arctan2(y, LENGTH)
    return wheels.steered(np.hypot(LENGTH, y), angle, np.pi / 2 - angle, RADIUS)


def ways(degrees: float) -> str:
    """Return in how many ways the car moves whose front wheels are both turned by so much."""
    fixed = [
        wheels.fixed(HALF, side * np.pi / 2, 0 if side > 0 else np.pi, RADIUS) for side in (1, -1)
    ]
    front = [front_wheel(side * HALF) for side in (1, -1)]
    steering = np.radians(degrees) + np.array([wheel.beta for wheel in front])
    rows = wheels.sliding([*fixed, *front], steering)
    return COUNTS[3 - np.linalg.matrix_rank(rows, tol=1e-9)]


def rate_about(x: float, y: float) -> float:
    """Return the rate of the plate's wheel in a turn at 0.5 rad/s about a point."""
    made = wheels.fixed(SIZE, np.radians(120), 0, RADIUS)
    return float(wheels.inverse([made], [0.5 * y, -0.5 * x, 0.5], slipping="ignore")[0])


def along_the_line() -> str:
    """Say what the rate does while Q moves along a parallel to the push line."""
    near, far = (rate_about(s * np.cos(pi / 6), 0.4 + s * np.sin(pi / 6)) for s in (0.1, 0.2))
    return "it stays" if abs(near - far) < 1e-9 else "it grows" if far > near else "it falls"


def three_ways() -> str:
    """Return in how many ways a plate can move whose three axle lines cross in three points."""
    places = ((0.2, 90, 0), (0.2, 0, 0), (0.198, -135, 25))
    made = [wheels.fixed(far, radians(a), radians(b), RADIUS) for far, a, b in places]
    return COUNTS[3 - np.linalg.matrix_rank(wheels.sliding(made), tol=1e-9)]


def resting() -> str:
    """Return the push at which a wheel with rollers at 45° does not turn."""
    made = [wheels.swedish(0.0, 0.0, pi / 2, RADIUS, pi / 4)]  # it rolls along x
    rates = {
        f"{push}°": wheels.inverse(made, [np.cos(radians(push)), np.sin(radians(push)), 0])[0]
        for push in (0, 45, 90, 135)
    }
    return min(rates, key=lambda push: abs(rates[push]))


def slipping() -> str:
    """Return how many wheels of the Mecanum robot slip when one of them is faster."""
    robot = []
    for x, y, side in ((0.2, 0.15, -1), (0.2, -0.15, 1), (-0.2, 0.15, 1), (-0.2, -0.15, -1)):
        spoke = atan2(y, x)
        made = (np.hypot(x, y), spoke, pi / 2 - spoke, RADIUS, side * pi / 4)
        robot.append(wheels.swedish(*made))
    count = int(np.count_nonzero(np.abs(wheels.slip(robot, [6, 2, 2, 2])) > 1e-6))
    return {1: "that one", 2: "two of them", 4: "all four"}[count]


PREDICTIONS = (
    Prediction(
        "part-along",
        "A point moves at 0.2 m/s along $x$. How fast does it move along "
        "a line that is turned by 60° from $x$?",
        Number(
            "m/s",
            right=Float(0.2 * cos(pi / 3)),
            assumptions={
                "That is the sine: the part *across* the line.": Float(0.2 * cos(pi / 6)),
                "That divides by the cosine; a part is never longer than the whole.": Float(
                    0.2 / cos(pi / 3)
                ),
            },
        ),
        explanation="The dot product with the unit vector of the line: 0.2 m/s times cos 60°.",
        spoilers=("times cos 60°",),
    ),
    Prediction(
        "how-far-the-icr",
        "From chapter 5: a bicycle's wheels are 1 m apart, and its front wheel is turned by 30° to "
        "the left. How far to the left of the rear wheel is the ICR?",
        Number(
            "m",
            right=Float(1 / tan(pi / 6)),
            assumptions={
                "That multiplies by the tangent: with a straighter wheel the ICR is farther.": (
                    Float(tan(pi / 6))
                ),
                "So far is the ICR from the *front* wheel.": Float(2),
            },
        ),
        explanation="Both axle lines meet there: the wheelbase over tan 30°, 1.73 m.",
        spoilers=("over tan 30°", "1.73"),
    ),
    Prediction(
        "no-skid",
        "The plate is to swing about your pin, and its wheel must not skid. Where on the dashed "
        "line must the pin be? *Play* swings it.",
        Ghost(
            "pin",
            places=(pin,),
            right=(Float(-HIGH / tan(pi / 3)),),
            then={t: Float(1.5)},
            free=(t,),
            tolerance=0.015,
            assumptions={
                "That is on the line along which the wheel rolls. There it only skids: its hub "
                "moves straight along the axle.": (
                    Float((HIGH - 0.1 * 3**0.5) / tan(pi / 6) - 0.1),
                ),
                "That is beside the hub, along $y$. But the wheel does not look along $x$.": (
                    Float(-0.1),
                ),
            },
        ),
        explanation="The pin is on the line of the wheel's axle: then the hub moves across the "
        "axle, just as the wheel rolls.",
        spoilers=("line of the wheel's axle", "axle line"),
    ),
    Prediction(
        "same-line",
        "The plate turns at 0.5 rad/s about Q. Now Q moves parallel to the direction in which the "
        "wheel rolls, away from the wheel. What does the wheel's rate do?",
        Buttons(
            ("it grows", "it stays", "it falls"),
            right=along_the_line,
            assumptions={
                "it grows": "The hub is faster then. But it also moves more and more across the "
                "wheel: all that is added is sliding.",
                "it falls": "The hub's velocity turns away from the wheel, but it also grows.",
            },
        ),
        explanation="It stays. Only the distance of Q from the line along which the wheel rolls "
        "counts.",
        spoilers=("only the distance", "push line"),
        covers="rolling",
    ),
    Prediction(
        "three-lines",
        "A plate has three fixed wheels. Their axle lines cross in three different points. In how "
        "many ways can the plate move without a skid?",
        Buttons(
            ("none", "one", "three"),
            right=three_ways,
            assumptions={
                "one": "It would need one point that is on all three lines.",
                "three": "About each crossing two wheels roll. The third one skids.",
            },
        ),
        explanation="It is blocked: no point is on all three lines.",
        spoilers=("it is blocked",),
        covers="axle-lines",
    ),
    Prediction(
        "both-by-20",
        "Both front wheels of a car are turned by 20°. In how many ways can the car move without "
        "sliding?",
        Buttons(
            ("none", "one", "two"),
            right=lambda: ways(20),
            assumptions={
                "one": "So it is at 0°, where all axles are parallel.",
                "two": "That counts the two wheels. But an axle line takes a way away.",
            },
        ),
        explanation="The front axles are parallel, but not to the rear axle: no common point, and "
        "not all parallel either. The car can neither turn nor drive straight.",
        spoilers=("no common point, and not",),
        covers="front-wheels",
    ),
    Prediction(
        "no-roll",
        "This wheel has rollers at 45°, drawn as they are on the floor. It is pushed in some "
        "direction, counted from the rolling direction to the left. At which one does it not turn "
        "at all?",
        Buttons(
            ("45°", "90°", "135°"),
            right=resting,
            assumptions={
                "45°": "That is along the axis of the roller on the ground. This way a roller does "
                "not give in, so the wheel must turn.",
                "90°": "So it is with an omni wheel. Here the roller turns, but moves the hub at "
                "135° only; the wheel must do the rest.",
            },
        ),
        explanation="At 135°, and at −45°: at right angles to the axis of the roller on the "
        "ground. The roller alone turns.",
        spoilers=("the roller alone",),
        covers="wheel-kinds",
    ),
    Prediction(
        "equal-rates",
        "Now all three rates of the omni robot are equal and positive. What does the robot do?",
        Buttons(
            ("it stays", "it drives", "it turns on the spot"),
            right=alike,
            assumptions={
                "it stays": "The three pushes cancel. But each of them has a lever, too.",
                "it drives": "The three spokes are alike, so no direction is better than another.",
            },
        ),
        explanation="It turns *clockwise*: a positive rate rolls each wheel to the right of its "
        "spoke.",
        spoilers=("clockwise",),
        covers="push-lines",
    ),
    Prediction(
        "which-turn-fails",
        "For which $\\beta$ do the rates no longer determine the motion?",
        Buttons(
            ("30° and −30°", "45° and −45°", "90° and −90°"),
            right=lost,
            assumptions={
                "30° and −30°": "Then each wheel still has a lever, and the three are independent.",
                "45° and −45°": "A part of each push still goes round the centre: a turn of the "
                "robot still turns the wheels.",
            },
        ),
        explanation="At ±90° every wheel rolls straight away from the centre or towards it. The "
        "robot may spin freely while all three rates are zero.",
        spoilers=("spin freely", "±90°"),
        covers="turned-wheels",
    ),
    Prediction(
        "one-faster",
        "Four Mecanum wheels turn at 2 rad/s each, and the robot drives ahead. Now the motor of "
        "wheel 1 turns faster, and the robot takes the motion that fits all four rates best (least "
        "squares). Which wheels slip?",
        Buttons(
            ("that one", "two of them", "all four"),
            right=slipping,
            assumptions={
                "that one": "It pushes the robot to the side and round; the others must give way.",
                "two of them": "Those on its diagonal? The robot also turns: this moves all four.",
            },
        ),
        explanation="All four slip, and equally fast.",
        spoilers=("equally fast", "by the same amount"),
        covers="mecanum",
    ),
)
