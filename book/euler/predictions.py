"""Predictions that the chapter on Euler angles asks for."""

from collections.abc import Callable
from itertools import product

from courseware.predictions import Buttons, Number, Prediction


def orders(allowed: Callable[[tuple[str, ...]], bool]) -> int:
    """Return how many sequences of three axes are allowed."""
    return sum(map(allowed, product("XYZ", repeat=3)))


PREDICTIONS = (
    Prediction(
        "how-many-turns",
        "How many quarter turns about axes of the frame does it take at least from {A} to {B}?",
        Buttons(
            ("one", "two", "three"),
            right="two",
            assumptions={
                "one": "A quarter turn about an axis of {A} leaves that axis where it is. Here all "
                "three have moved.",
                "three": "Three always do, if any angles are allowed. Here fewer are enough.",
            },
        ),
        explanation="You will find the two below, and after that one single turn that does it, "
        "too.",
        spoilers=("the two below",),
    ),
    Prediction(
        "first-column",
        "The die is turned by 90° about $y$. What is the first column, where $x$ of the die then "
        "points? Try it with your right hand, then with the figure.",
        Buttons(
            ("(0, 0, 1)", "(0, 0, −1)", "(0, 1, 0)"),
            right="(0, 0, −1)",
            assumptions={
                "(0, 0, 1)": "That turns from $x$ to $z$, the left-handed way.",
                "(0, 1, 0)": "That is a turn about $z$.",
            },
        ),
        explanation="Thumb along $y$: the fingers of the right hand curl from $z$ to $x$. So $x$ "
        "itself goes down. With any angle, about each axis:",
        spoilers=("goes down",),
    ),
    Prediction(
        "two-orders",
        "Where do the two dice end? By how much must one be turned to stand like the other?",
        Buttons(
            ("alike", "90° apart", "120° apart", "180° apart"),
            right="120° apart",
            assumptions={
                "alike": "So it is with numbers, and with turns about one and the same axis.",
                "90° apart": "That takes one of the turns for the same in both.",
                "180° apart": "Press *Play* and look at the threes.",
            },
        ),
        explanation="Not alike: a product of matrices depends on the order. One single turn, "
        "by 120°, makes them alike; how to find it is told below. Press *Play*.",
        spoilers=("depends on the order",),
    ),
    Prediction(
        "other-answer",
        "Where do the two dice end, after all three turns?",
        Buttons(
            ("alike", "a quarter turn apart", "half a turn apart"),
            right="alike",
            assumptions={
                "a quarter turn apart": "Move $\\beta$: how far apart they end is always the same.",
                "half a turn apart": "There are two half turns more, and they undo each other.",
            },
        ),
        explanation="The first half turn lays the die on its other side, $180° - \\beta$ goes on "
        "from there, the last half turn turns it back. Press *Play*. It is so for every $\\beta$: "
        "every matrix has at least two answers; textbooks take the one with a positive "
        "$\\cos\\beta$.",
        spoilers=("two answers",),
    ),
    Prediction(
        "how-many-orders",
        "How many orders are there?",
        Number(
            "orders",
            "",
            right=lambda: orders(lambda p: p[0] != p[1] != p[2]),
            assumptions={
                "That takes each axis once.": lambda: orders(lambda p: len(set(p)) == 3),
                "That allows an axis twice in a row.": lambda: orders(lambda p: True),
                "That counts each order twice, about own axes and about the room's.": lambda: (
                    2 * orders(lambda p: p[0] != p[1] != p[2])
                ),
            },
            relative=0.01,
        ),
        explanation="Three choices, then two, then two. For frame {B}, in degrees:",
        spoilers=("then two, then two",),
    ),
    Prediction(
        "ring-against-ring",
        "The middle ring stands at 90°. The outer ring is turned on by 30° and the inner ring "
        "back by 30°. What does the aeroplane do?",
        Buttons(
            ("it turns by 60°", "it turns by 30°", "nothing"),
            right="nothing",
            assumptions={
                "it turns by 60°": "That adds the two, but they turn against each other.",
                "it turns by 30°": "That forgets one of the two rings.",
            },
        ),
        explanation="The pins of the outer and the inner ring lie on one line: what one turns on, "
        "the other turns back. Try it below. The matrix of `XYZ` says the same for $\\beta$ = 90°:",
        spoilers=("lie on one line",),
    ),
    Prediction(
        "near-lock",
        "The middle ring stands at 89°, one degree from lock. The aeroplane shall turn at 1° a "
        "second about the direction that is almost lost. How fast must the inner ring turn?",
        Buttons(
            ("1° a second", "2° a second", "57° a second"),
            right="57° a second",
            assumptions={
                "1° a second": "So it is at $\\beta$ = 0°: there its axis is that direction.",
                "2° a second": "So it is at $\\beta$ = 60°: there half of its rate counts.",
            },
        ),
        explanation="The axis of the inner ring lies almost along that of the outer one. Only the "
        "part $\\cos\\beta$ of its rate counts, so the ring must race, and the outer ring takes "
        "back nearly all of it. So does the wrist of a robot near lock. For 1 rad/s about $z_A$:",
        spoilers=("must race",),
    ),
    Prediction(
        "which-axis",
        "About which axis does one single turn take the die from {A} to {B}?",
        Buttons(
            ("through two faces", "through two edges", "through two corners"),
            right="through two corners",
            assumptions={
                "through two faces": "Such a turn leaves one axis of the die where it is.",
                "through two edges": "Such a turn swaps two axes. Here all three change places.",
            },
        ),
        explanation="$x$ goes to $-y$, $-y$ to $z$, and $z$ to $x$: three axes in a circle, round "
        "a corner. In general the differences across the diagonal of $R$ point along the axis, and "
        "the sum of the diagonal tells the angle:",
        spoilers=("round a corner",),
    ),
)
