"""Bicycle model: steering angles, motion, front axle, one step, and the lane a long car needs."""

from sympy import (
    Abs,
    Eq,
    Matrix,
    Ne,
    Piecewise,
    atan,
    cos,
    cot,
    nan,
    oo,
    sin,
    sinc,
    sqrt,
    tan,
)

from book.differential_drive.formulas import R, r, v_L, v_R
from book.motion.formulas import (
    dt,
    omega,
    theta,
    theta_dot,
    theta_next,
    v,
    x,
    x_dot,
    x_icr,
    x_next,
    y,
    y_dot,
    y_icr,
    y_next,
)
from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

steering = quantity(
    "steering", "rad", -1.2, 1.2, "steering angle of the bicycle, to the left", r"\varphi", "phi"
)
alpha_L = quantity("alpha_L", "rad", -1.4, 1.4, "steering angle of the left front wheel")
alpha_R = quantity("alpha_R", "rad", -1.4, 1.4, "steering angle of the right front wheel")
wheelbase = quantity("wheelbase", "m", 1, 10, "from the rear axle to the front axle", "L", "L")
track = quantity("track", "m", 0.5, 2.5, "distance between the two wheels of an axle", latex="b")
rate_rear = quantity(
    "rate_rear",
    "rad/s",
    -20,
    20,
    "rate of the driven rear wheels, their mean",
    latex=r"\dot\varphi_\mathrm{rear}",
)
v_F = quantity("v_F", "m/s", -2, 2, "speed of the middle of the front axle")
ahead = quantity(
    "ahead", "", 0, 1, "how far ahead of the rear axle a point lies, in wheelbases", latex="a"
)
y_heading = quantity(
    "y_heading", "rad", -3.14, 3.14, "heading from the y axis, clockwise positive", r"\psi", "psi"
)
psi_dot = symbol("psi_dot", "turning rate, clockwise", r"\dot{\psi}", "rad/s")
x_dot_F, y_dot_F = (
    symbol(f"{x}_dot_F", f"speed of the front axle's middle along {x}", rf"\dot{{{x}}}_F", "m/s")
    for x in "xy"
)
x_F, y_F = (symbol(f"{x}_F", f"the middle of the front axle, along {x}", unit="m") for x in "xy")
steepest_angle = symbol(
    "phi_max", "steepest steering that both wheels can follow", r"\varphi_\mathrm{max}", "rad"
)
corner_cut = symbol("c", "by how much the rear axle cuts a corner", unit="m")
lane_width = symbol("w", "width of the lane that the car sweeps", unit="m")
alpha = symbol("alpha", "steering angle of any wheel", r"\alpha", "rad")


with as_written():
    tangents = Equation(
        name="bicycle.tangents",
        left=Matrix([tan(alpha_L), tan(alpha_R), tan(steering)]),
        right=Matrix([wheelbase / (R - track / 2), wheelbase / (R + track / 2), wheelbase / R]),
    )

    together = sin(alpha_L + alpha_R)
    equivalent_steering = Equation(
        name="bicycle.equivalent_steering",
        left=tan(steering),
        right=Piecewise(
            (2 * sin(alpha_L) * sin(alpha_R) / together, Ne(together, 0)),
            (0, Eq(alpha_L, 0)),
            (nan, True),
        ),
        textbook=2 / (cot(alpha_L) + cot(alpha_R)),
    )

    equivalent_by_tangents = Equation(
        name="bicycle.equivalent_by_tangents",
        left=tan(steering),
        right=2 * tan(alpha_L) * tan(alpha_R) / (tan(alpha_L) + tan(alpha_R)),
    )

    across, forth = wheelbase * sin(steering), wheelbase * cos(steering)
    half = track / 2
    ackermann = Equation(
        name="bicycle.ackermann",
        left=Matrix([alpha_L, alpha_R]),
        right=Matrix(
            [
                atan(across / (forth - half * sin(steering))),
                atan(across / (forth + half * sin(steering))),
            ]
        ),
    )

    ackermann_condition = Equation(
        name="bicycle.ackermann_condition",
        left=cot(alpha_R) - cot(alpha_L),
        right=track / wheelbase,
    )

    steepest_steering = Equation(
        name="bicycle.steepest_steering",
        left=steepest_angle,
        right=atan(2 * wheelbase / track),
    )

    turning_radius = Equation(
        name="bicycle.turning_radius",
        left=R,
        right=Piecewise((wheelbase / tan(steering), Ne(steering, 0)), (oo, True)),
        textbook=wheelbase / tan(steering),
    )

    rear_speed = Equation(
        name="bicycle.rear_speed",
        left=v,
        right=r * rate_rear,
    )

    world = Equation(
        name="bicycle.world",
        left=Matrix([x_dot, y_dot, theta_dot]),
        right=Matrix([v * cos(theta), v * sin(theta), v / wheelbase * tan(steering)]),
    )

    icr = Equation(
        name="bicycle.icr",
        left=Matrix([x_icr, y_icr]),
        right=Matrix(
            [
                Piecewise(
                    (x - wheelbase / tan(steering) * sin(theta), Ne(steering, 0)), (oo, True)
                ),
                Piecewise(
                    (y + wheelbase / tan(steering) * cos(theta), Ne(steering, 0)), (oo, True)
                ),
            ]
        ),
        textbook=Matrix(
            [
                x - wheelbase / tan(steering) * sin(theta),
                y + wheelbase / tan(steering) * cos(theta),
            ]
        ),
    )

    rear_speeds = Equation(
        name="bicycle.rear_speeds",
        left=Matrix([v_L, v_R]),
        right=Matrix(
            [
                v * (1 - track * tan(steering) / (2 * wheelbase)),
                v * (1 + track * tan(steering) / (2 * wheelbase)),
            ]
        ),
    )

    front_point = Equation(
        name="bicycle.front_point",
        left=Matrix([x_F, y_F]),
        right=Matrix([x + wheelbase * cos(theta), y + wheelbase * sin(theta)]),
    )

    front_speed = Equation(
        name="bicycle.front_speed",
        left=v_F,
        right=v / cos(steering),
    )

    front_world = Equation(
        name="bicycle.front_world",
        left=Matrix([x_dot_F, y_dot_F]),
        right=Matrix(
            [
                v * cos(theta) - v * tan(steering) * sin(theta),
                v * sin(theta) + v * tan(steering) * cos(theta),
            ]
        ),
        textbook=Matrix(
            [
                v / cos(steering) * cos(theta + steering),
                v / cos(steering) * sin(theta + steering),
            ]
        ),
    )

    point_world = Equation(
        name="bicycle.point_world",
        left=Matrix([x_dot, y_dot]),
        right=Matrix(
            [
                v * (cos(theta) - ahead * tan(steering) * sin(theta)),
                v * (sin(theta) + ahead * tan(steering) * cos(theta)),
            ]
        ),
    )

    front_rate = Equation(
        name="bicycle.front_rate",
        left=omega,
        right=v_F * sin(steering) / wheelbase,
    )

    y_axis = Equation(
        name="bicycle.y_axis",
        left=Matrix([x_dot, y_dot, x_dot_F, y_dot_F, psi_dot]),
        right=Matrix(
            [
                v * sin(y_heading),
                v * cos(y_heading),
                v / cos(steering) * sin(y_heading - steering),
                v / cos(steering) * cos(y_heading - steering),
                -(v / wheelbase) * tan(steering),
            ]
        ),
    )

    driven = v * dt
    turned = v * dt * tan(steering) / wheelbase
    arc_step = Equation(
        name="bicycle.arc_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix(
            [
                x + driven * sinc(turned / 2) * cos(theta + turned / 2),
                y + driven * sinc(turned / 2) * sin(theta + turned / 2),
                theta + turned,
            ]
        ),
        textbook=Matrix(
            [
                x + wheelbase / tan(steering) * (sin(theta + turned) - sin(theta)),
                y - wheelbase / tan(steering) * (cos(theta + turned) - cos(theta)),
                theta + turned,
            ]
        ),
    )

    euler_step = Equation(
        name="bicycle.euler_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix([x + v * cos(theta) * dt, y + v * sin(theta) * dt, theta + turned]),
    )

    cut = Equation(
        name="bicycle.corner_cut",
        left=corner_cut,
        right=wheelbase * tan(Abs(steering) / 2),
    )

    outer = Abs(R) + track / 2
    reach = sqrt(outer**2 + wheelbase**2)
    lane = Equation(
        name="bicycle.lane",
        left=lane_width,
        right=Piecewise(
            (track + wheelbase**2 / (reach + outer), Abs(R) >= track / 2),
            (nan, True),  # the ICR lies under the car: no lane
        ),
        textbook=reach - (Abs(R) - track / 2),
    )
