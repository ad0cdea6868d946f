"""How the chapter's function agrees with each formula of `formulas.py`."""

from book.beacon import formulas
from book.beacon.formulas import b_x, b_y
from book.beacon.functions import range_and_bearing

from book.motion.formulas import theta, x, y
from courseware.equations import Check

ARGUMENTS = ((x, y, theta), (b_x, b_y))

CHECKS = (
    Check(
        formulas.distance,
        function=range_and_bearing,
        component=0,
        arguments=ARGUMENTS,
        tolerance=5e-15,
        reason="a few roundings of numbers up to 6",
        specials=({b_x: 1.0, x: 1.0}, {b_y: 0.5, y: 0.5}),
    ),
    Check(
        formulas.direction,
        function=range_and_bearing,
        component=1,
        arguments=ARGUMENTS,
        tolerance=2e-15,
        reason="roundings of angles up to two turns",
        specials=({b_x: 1.0, x: 1.0}, {b_y: 0.5, y: 0.5}),
    ),
)
