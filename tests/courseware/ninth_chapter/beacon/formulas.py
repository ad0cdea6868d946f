"""A beacon: its distance and its bearing."""

from sympy import atan2, sqrt

from book.motion.formulas import theta, x, y
from courseware.equations import Equation, as_written, quantity, symbol

b_x = quantity("b_x", "m", -2, 2, "a beacon, along x")
b_y = quantity("b_y", "m", -2, 2, "a beacon, along y")
d = quantity("d", "m", 0, 6, "distance of the beacon")
bearing = quantity("bearing", "rad", -3.14, 3.14, "direction in which the robot sees it", r"\beta")
alpha = symbol("alpha", "direction of the beacon in the world", r"\alpha", "rad")

with as_written():
    distance = Equation(
        name="beacon.distance",
        left=d,
        right=sqrt((b_x - x) ** 2 + (b_y - y) ** 2),
    )
    direction = Equation(
        name="beacon.direction",
        left=bearing,
        right=atan2(b_y - y, b_x - x) - theta,
        is_angle=True,
    )
