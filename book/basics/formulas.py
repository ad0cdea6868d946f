"""What the course takes as known: the direction of a point, and a turn of the plane."""

from sympy import MatMul, Matrix, atan2, cos, sin

from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

p_x = quantity("p_x", "m", -2, 2, "a point, along x")
p_y = quantity("p_y", "m", -2, 2, "a point, along y")
theta = quantity("theta", "rad", -3.14, 3.14, "angle by which a point is turned")
bearing = quantity("bearing", "rad", -3.14, 3.14, "direction of a point", latex=r"\varphi")
q_x = quantity("q_x", "m", -3, 3, "the point after the step, a turn: along x", latex=r"p'_x")
q_y = quantity("q_y", "m", -3, 3, "the point after the step, a turn: along y", latex=r"p'_y")
t = quantity("t", "s", 0, 2, "time")
fastest = quantity("fastest", "rad/s", 0, 4, "turning rate of the robot that turns fastest")
x, y = (symbol(axis, f"the {axis} axis, or a place along it") for axis in "xy")

LOOKS = {p_x: "x_axis", p_y: "y_axis", bearing: "velocity", theta: "turning"}


with as_written():
    direction = Equation(
        name="basics.direction",
        left=bearing,
        right=atan2(p_y, p_x),
        is_angle=True,
    )

    rotation = Matrix([[cos(theta), -sin(theta)], [sin(theta), cos(theta)]])

    turned = Equation(
        name="basics.turned",
        left=Matrix([q_x, q_y]),
        right=Matrix([p_x * cos(theta) - p_y * sin(theta), p_x * sin(theta) + p_y * cos(theta)]),
        textbook=MatMul(rotation, Matrix([p_x, p_y])),
    )
