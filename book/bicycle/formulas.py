"""Bicycle model: steering angles, motion, front axle, one step, and the lane a long car needs."""

from sympy import (
    Abs,
    Eq,
    Matrix,
    Ne,
    Piecewise,
    acos,
    atan,
    atan2,
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
kappa = quantity("kappa", "1/m", -1, 1, "curvature: one over the turning radius")
R_F = quantity("R_F", "m", 0, 14, "distance of the front axle's middle from the ICR")
slip = quantity(
    "slip", "rad", -1.6, 1.6, "slip angle: a point's direction of motion, from the heading",
    r"\beta",
)  # fmt: skip
arc_length = quantity("arc_length", "m", 0.1, 5, "length of an arc", "s")
aside = symbol("aside", "how far a manoeuvre brings the car sideways", "d", "m")
arm = quantity("arm", "m", 0.1, 0.3, "length of a steering arm", "p")
arm_angle = quantity(
    "arm_angle", "rad", 0.1, 0.6, "how far the steering arms point inwards", r"\gamma"
)
lever_L, lever_R = (
    symbol(f"lever_{side}", f"lever of P on the {name} front wheel's slide", f"g_{side}", "m")
    for side, name in (("L", "left"), ("R", "right"))
)
slide_L, slide_R = (
    quantity(
        f"slide_{side}", "", -2, 2,
        f"how far the {name} front tyre slides outwards, for each metre of P", f"e_{side}",
    )
    for side, name in (("L", "left"), ("R", "right"))
)  # fmt: skip
rod_x, rod_y = (
    symbol("rod_x", "across, from the end of an arm", "h", "m"),
    symbol("rod_y", "ahead, from the end of an arm", "k", "m"),
)

LOOKS = {
    v: "velocity",
    v_F: "velocity",
    steering: "velocity",
    alpha_L: "left",
    alpha_R: "right",
    v_L: "left",
    v_R: "right",
    slide_L: "error",
    slide_R: "error",
    omega: "turning",
    theta_dot: "turning",
    theta: "heading",
    y_heading: "heading",
    slip: "turning",
    R: "icr",
    R_F: "icr",
    wheelbase: "length",
    track: "length",
    lane_width: "length",
    corner_cut: "target",
    arm: "length",
    rod_x: "length",
    rod_y: "length",
    arm_angle: "turning",
    aside: "target",
    arc_length: "length",
    x_dot: "x_axis",
    y_dot: "y_axis",
}


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

    curvature = Equation(
        name="bicycle.curvature",
        left=kappa,
        right=tan(steering) / wheelbase,
    )

    levers = (
        (lever_L, wheelbase * cos(alpha_L) + track / 2 * sin(alpha_L)),
        (lever_R, wheelbase * cos(alpha_R) - track / 2 * sin(alpha_R)),
    )
    least_scrub = Equation(
        name="bicycle.least_scrub",
        left=kappa,
        right=(lever_L * sin(alpha_L) + lever_R * sin(alpha_R)) / (lever_L**2 + lever_R**2),
        where=levers,
    )

    scrub = Equation(
        name="bicycle.scrub",
        left=Matrix([slide_L, slide_R]),
        right=Matrix([sin(alpha_L) - kappa * lever_L, sin(alpha_R) - kappa * lever_R]),
        where=levers,
    )

    trapezoid = Equation(
        name="bicycle.trapezoid",
        left=alpha_R,
        right=arm_angle
        - atan2(rod_x, rod_y)
        + acos(
            (rod_x**2 + rod_y**2 + arm**2 - (track - 2 * arm * sin(arm_angle)) ** 2)
            / (2 * arm * sqrt(rod_x**2 + rod_y**2))
        ),
        where=(
            (rod_x, track - arm * sin(arm_angle + alpha_L)),
            (rod_y, arm * cos(arm_angle + alpha_L)),
        ),
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

    slip_angle = Equation(
        name="bicycle.slip_angle",
        left=slip,
        right=atan(ahead * tan(steering)),
    )

    front_radius = Equation(
        name="bicycle.front_radius",
        left=R_F,
        right=sqrt(R**2 + wheelbase**2),
    )

    sideways = Equation(
        name="bicycle.sideways",
        left=aside,
        right=kappa * arc_length**2 * sinc(kappa * arc_length / 2) ** 2,
        textbook=2 * (1 - cos(kappa * arc_length)) / kappa,
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
    turned = kappa * driven
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
                x + (sin(theta + turned) - sin(theta)) / kappa,
                y - (cos(theta + turned) - cos(theta)) / kappa,
                theta + turned,
            ]
        ),
        where=((kappa, tan(steering) / wheelbase),),
    )

    euler_step = Equation(
        name="bicycle.euler_step",
        left=Matrix([x_next, y_next, theta_next]),
        right=Matrix(
            [
                x + v * cos(theta) * dt,
                y + v * sin(theta) * dt,
                theta + driven * tan(steering) / wheelbase,
            ]
        ),
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
