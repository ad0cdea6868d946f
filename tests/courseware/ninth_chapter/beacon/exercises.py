"""An exercise on the beacon, and the mistake that is made there."""

import numpy as np
from book.beacon import formulas
from book.beacon.functions import range_and_bearing

from book.motion.formulas import theta
from courseware.practice import (
    Exercise,
    Mistake,
    Picture,
    Solution,
    Step,
    WrongFormula,
    angle,
    number_range,
)

M99 = Mistake(
    "M99",
    feedback="when the robot's own heading is not taken off",
    formula=WrongFormula(formulas.direction, {theta: 0}),
    line="bearing = np.arctan2(b_y - y, b_x - x)",
    why="This is the direction in the world. The robot sees it from its own heading.",
    unnoticed="With a heading of 0.",
    picture=Picture(
        "wrong-beacon",
        "It forgets how it stands",
        "A robot that looks past the beacon, by as much as it has turned.",
    ),
)

beacon_1 = Exercise(
    "beacon-1",
    title="Where does it see the beacon?",
    text="A robot stands at x = {x}, y = {y} with the heading {theta}. A beacon stands at "
    "x = {b_x}, y = {b_y}. In which direction, counted from straight ahead, does it see it?",
    given={
        "x": number_range(-2, 2, 0.5, "m"),
        "y": number_range(-2, 2, 0.5, "m"),
        "theta": number_range(20, 160, 10, "°"),
        "b_x": number_range(-2, 2, 0.5, "m"),
        "b_y": number_range(-2, 2, 0.5, "m"),
    },
    unknowns=(angle("β"),),
    right=lambda x, y, theta, b_x, b_y: range_and_bearing([x, y, theta], [b_x, b_y])[1],
    wrong={M99: M99.formula.evaluate},
    when=lambda x, y, b_x, b_y, **_: (x, y) != (b_x, b_y),
    solution=Solution(
        "The direction in the world, less the heading:\n\n{bearing}",
        bearing=Step(formulas.direction),
    ),
    example={"x": 0.0, "y": 0.0, "theta": np.pi / 2, "b_x": 1.0, "b_y": 1.0},
)
