"""Predictions that the chapter on wheels asks for."""

import numpy as np

from courseware.predictions import Buttons, Prediction
from robokin import wheels

SPOKE, RADIUS = 0.20, 0.05  # m, of the exercise's robot
LENGTH, HALF = 0.5, 0.2  # m, of the car of the table: from axle to axle, and half between wheels


def alike() -> str:
    """Say what the robot does with three equal positive rates."""
    x, y, turn = wheels.forward(wheels.omni_robot(SPOKE, RADIUS), [1.0, 1.0, 1.0])
    moves = np.hypot(x, y) > 1e-9
    return "it drives" if moves else "it turns on the spot" if abs(turn) > 1e-9 else "it stands"


def independent(degrees: float) -> int:
    """Return how many rates are independent when all wheels are turned away from their spokes."""
    beta, thirds = np.radians(degrees), np.radians([0, 120, 240])
    robot = [wheels.swedish(SPOKE, angle, beta, RADIUS, 0) for angle in thirds]
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
    return ("none", "one", "two", "three")[3 - np.linalg.matrix_rank(rows, tol=1e-9)]


PREDICTIONS = (
    Prediction(
        "equal-rates",
        "Now all three rates are equal and positive. What does the robot do?",
        Buttons(
            ("it stands", "it drives", "it turns on the spot"),
            right=alike,
            assumptions={
                "it stands": "The three pushes cancel. But each of them has a lever, too.",
                "it drives": "The three spokes are alike, so no direction is better than another.",
            },
        ),
        explanation="It turns *clockwise*: a positive rate rolls each wheel to the right of its "
        "spoke.",
        spoilers=("clockwise",),
    ),
    Prediction(
        "turned-wheels",
        "For which $\\beta$ do the rates no longer determine the motion?",
        Buttons(
            ("30° and −30°", "45° and −45°", "90° and −90°"),
            right=lost,
            assumptions={
                "30° and −30°": "Then each wheel still has a lever, and the three are independent.",
                "45° and −45°": "As much of each push goes round as goes outward or inward: the "
                "robot can still be turned.",
            },
        ),
        explanation="At ±90° every wheel rolls straight away from the centre or towards it. The "
        "third column is zero: the robot may spin freely, and no rate tells. And only two rows are "
        "independent, so the rates can contradict each other.",
        spoilers=("spin freely", "±90°"),
    ),
    Prediction(
        "both-by-20",
        "Both front wheels are turned by 20°. In how many ways can the car move without sliding?",
        Buttons(
            ("none", "one", "two"),
            right=lambda: ways(20),
            assumptions={
                "one": "So it is at 0°, and with the angles that the next cell takes last.",
                "two": "That counts the two wheels. But an axle line takes a way away.",
            },
        ),
        explanation="The front axles are parallel, but not to the rear axle: no common point, and "
        "not all parallel either. The car can neither turn nor drive straight.",
        spoilers=("no common point, and not",),
    ),
)
