"""The three-joint elbow arm: from joint angles to the wrist, and the ways back."""

from sympy import Abs, Matrix, Max, Min, acos, atan2, cos, pi, sin, sqrt

from book.basics.formulas import p_x, p_y
from book.motion.formulas import v
from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

theta1 = quantity("theta1", "rad", -3.14, 3.14, "angle of joint 1", latex=r"\theta_1")
theta2 = quantity("theta2", "rad", -3.14, 3.14, "angle of joint 2", latex=r"\theta_2")
theta3 = quantity("theta3", "rad", -3.14, 3.14, "angle of joint 3", latex=r"\theta_3")
p_z = quantity("p_z", "m", -2, 2, "a point, along z")
a2 = quantity("a2", "m", 0.4, 0.5, "length of the upper link", latex="a_2")
a3 = quantity("a3", "m", 0.3, 0.4, "length of the forearm", latex="a_3")
d1 = quantity("d1", "m", -0.5, 0.5, "height of the shoulder above the base", latex="d_1")
out = quantity("out", "m", 0.3, 0.4, "how far ahead of the base axis the wrist is", "r", "r")
high = quantity("high", "m", -0.3, 0.3, "height of the wrist above the shoulder", "h", "h")
apart = quantity("apart", "m", 0.25, 0.55, "distance from shoulder to wrist", "d", "d")
aside = quantity(
    "aside", "m", 0.02, 0.3, "distance at which a line passes the base axis", r"\delta"
)
along = quantity("along", "m", -0.6, 0.6, "how far along this line the wrist is", "s")
dh_theta = quantity("dh_theta", "rad", -3.14, 3.14, "turn about z of a step", latex=r"\theta_i")
dh_d = quantity("dh_d", "m", -1, 1, "shift along z of a step", latex="d_i")
dh_a = quantity("dh_a", "m", -1, 1, "shift along x of a step", latex="a_i")
dh_alpha = quantity("dh_alpha", "rad", -3.14, 3.14, "turn about x of a step", latex=r"\alpha_i")

det_J = symbol("det_J", "determinant of the Jacobian", r"\det J", "m³")
rate1 = symbol("rate1", "rate of joint 1", r"\dot\theta_1", "rad/s")
J = symbol("J", "Jacobian: how the wrist moves with each joint, a column each")
A = symbol("A", "cosine of the elbow's angle")
phi1 = symbol("phi1", "angle of the triangle at the shoulder", r"\varphi_1", "rad")
phi2 = symbol("phi2", "angle of the triangle at the elbow", r"\varphi_2", "rad")
phi3 = symbol("phi3", "how steeply the wrist is seen from the shoulder", r"\varphi_3", "rad")
d_min = symbol("d_min", "least distance that the arm can do", r"d_\mathrm{min}", "m")
d_max = symbol("d_max", "largest distance that the arm can do", r"d_\mathrm{max}", "m")
D = symbol("d_hat", "the distance nearest to d that the arm can do", r"\hat{d}", "m")
NEAREST = [
    symbol(f"near_{x}", f"the nearest point in reach, along {x}", rf"\hat{{p}}_{x}", "m")
    for x in "xyz"
]
ELBOW_BOTH = [
    symbol(
        "theta3_plus",
        "the elbow's angle, elbow down if the arm faces the target",
        r"\theta_3^{+}",
        "rad",
    ),
    symbol(
        "theta3_minus",
        "the elbow's angle, elbow up if the arm faces the target",
        r"\theta_3^{-}",
        "rad",
    ),
]
SIDES = {
    f"{side}{k}": symbol(
        f"theta{k}_{side}", f"angle of joint {k}, {side}", rf"\theta_{k}^\mathrm{{{side}}}", "rad"
    )
    for side, joints in {"facing": (1, 2), "away": (1, 2, 3), "up": (2, 3), "down": (2, 3)}.items()
    for k in joints
}
p = symbol("p", "the point where the wrist is to be")
x, y, z = (symbol(f"{axis}_axis", f"the {axis} axis", axis) for axis in "xyz")
joint = symbol("joint", "number of a joint", "i")
Z_AXES = [
    symbol(f"z_{k}", f"axis of joint {j}", f"z_{{{k}}}")
    for k, j in zip(("0", "1", "2", "i-1"), "123i", strict=True)
]
a1 = symbol("a1", "length of the first step of the DH table: zero", "a_1", "m")
T_03 = symbol("T_03", "pose of the wrist's frame as seen from the base", "T_{03}")
T_step = symbol(
    "T_step", "pose of a frame of the DH table as seen from the one before", "T_{i-1,i}"
)

LOOKS = {
    theta1: "turning",
    theta2: "velocity",
    theta3: "z_axis",
    a2: "left",
    a3: "right",
    apart: "heading",
    out: "length",
    high: "length",
    d1: "length",
    phi1: "approximation",
    phi2: "new_heading",
    phi3: "middle_heading",
    aside: "length",
    rate1: "turning",
    p_x: "x_axis",
    p_y: "y_axis",
    p_z: "z_axis",
    SIDES["facing1"]: "turning",
    SIDES["away1"]: "turning",
}

with as_written():
    raised = theta2 + theta3
    plane = Equation(
        name="elbow_arm.plane",
        left=Matrix([out, high]),
        right=Matrix([a2 * cos(theta2) + a3 * cos(raised), a2 * sin(theta2) + a3 * sin(raised)]),
    )

    forward = Equation(
        name="elbow_arm.forward",
        left=Matrix([p_x, p_y, p_z]),
        right=Matrix(
            [
                (a2 * cos(theta2) + a3 * cos(raised)) * cos(theta1),
                (a2 * cos(theta2) + a3 * cos(raised)) * sin(theta1),
                d1 + a2 * sin(theta2) + a3 * sin(raised),
            ]
        ),
    )

    base = Equation(
        name="elbow_arm.base",
        left=Matrix([SIDES["facing1"], SIDES["away1"]]),
        right=Matrix([atan2(p_y, p_x), atan2(p_y, p_x) + pi]),
        is_angle=True,
    )

    side = Equation(
        name="elbow_arm.side",
        left=Matrix([out, high, apart]),
        right=Matrix([sqrt(p_x**2 + p_y**2), p_z - d1, sqrt(out**2 + high**2)]),
        where=((out, sqrt(p_x**2 + p_y**2)), (high, p_z - d1)),
    )

    square = out**2 + high**2
    TRIANGLE = (
        (phi1, acos((a2**2 + apart**2 - a3**2) / (2 * a2 * apart))),
        (phi2, acos((a2**2 + a3**2 - apart**2) / (2 * a2 * a3))),
        (phi3, atan2(high, out)),
    )
    triangle = Equation(
        name="elbow_arm.triangle",
        left=Matrix([phi1, phi2, phi3]),
        right=Matrix([angle for _, angle in TRIANGLE]),
        where=((apart, sqrt(square)),),
    )

    first_way = Equation(
        name="elbow_arm.first_way",
        left=Matrix(
            [
                SIDES["up2"],
                SIDES["up3"],
                SIDES["down2"],
                SIDES["down3"],
            ]
        ),
        right=Matrix([phi3 + phi1, phi2 - pi, phi3 - phi1, pi - phi2]),
        where=((apart, sqrt(square)), *TRIANGLE),
    )

    cosine = Equation(
        name="elbow_arm.cosine",
        left=A,
        right=(p_x**2 + p_y**2 + high**2 - a2**2 - a3**2) / (2 * a2 * a3),
    )

    COSINE = (A, (square - a2**2 - a3**2) / (2 * a2 * a3))
    elbow = Equation(
        name="elbow_arm.elbow",
        left=Matrix(ELBOW_BOTH),
        right=Matrix([atan2(sqrt(1 - A**2), A), atan2(-sqrt(1 - A**2), A)]),
        where=(COSINE,),
    )

    shoulder = Equation(
        name="elbow_arm.shoulder",
        left=SIDES["facing2"],
        right=atan2(high, out) - atan2(a3 * sin(theta3), a2 + a3 * cos(theta3)),
        where=(COSINE, (theta3, atan2(sqrt(1 - A**2), A))),
        is_angle=True,
    )

    shoulder_away = Equation(
        name="elbow_arm.shoulder_away",
        left=SIDES["away2"],
        right=atan2(high, -out) - atan2(a3 * sin(theta3), a2 + a3 * cos(theta3)),
        where=(COSINE, (theta3, atan2(sqrt(1 - A**2), A))),
        is_angle=True,
    )

    room, span = a2 + a3 - apart, a2 + a3 + apart  # four sums and differences of three sides
    near, far = apart - (a2 - a3), apart + (a2 - a3)
    half_angles = Equation(
        name="elbow_arm.half_angles",
        left=Matrix([phi1, theta3]),
        right=Matrix(
            [
                2 * atan2(sqrt(room * near), sqrt(span * far)),
                2 * atan2(sqrt(room * span), sqrt(near * far)),
            ]
        ),
    )

    away = Equation(
        name="elbow_arm.away",
        left=Matrix([SIDES[f"away{k}"] for k in (1, 2, 3)]),
        right=Matrix([theta1 + pi, pi - theta2, -theta3]),
        is_angle=True,
    )

    reach = Equation(
        name="elbow_arm.reach",
        left=Matrix([d_min, d_max]),
        right=Matrix([Abs(a2 - a3), a2 + a3]),
    )

    determinant = Equation(
        name="elbow_arm.determinant",
        left=det_J,
        right=-a2 * a3 * out * sin(theta3),
        where=((out, a2 * cos(theta2) + a3 * cos(raised)),),
    )

    base_rate = Equation(
        name="elbow_arm.base_rate",
        left=rate1,
        right=v * aside / (aside**2 + along**2),
    )

    nearest = Equation(
        name="elbow_arm.nearest",
        left=Matrix(NEAREST),
        right=Matrix([D / apart * p_x, D / apart * p_y, d1 + D / apart * (p_z - d1)]),
        where=(
            (apart, sqrt(p_x**2 + p_y**2 + (p_z - d1) ** 2)),
            (D, Max(Abs(a2 - a3), Min(apart, a2 + a3))),
        ),
    )

    dh_step = Equation(
        name="elbow_arm.dh_step",
        left=T_step,
        right=Matrix(
            [
                [
                    cos(dh_theta),
                    -sin(dh_theta) * cos(dh_alpha),
                    sin(dh_theta) * sin(dh_alpha),
                    dh_a * cos(dh_theta),
                ],
                [
                    sin(dh_theta),
                    cos(dh_theta) * cos(dh_alpha),
                    -cos(dh_theta) * sin(dh_alpha),
                    dh_a * sin(dh_theta),
                ],
                [0, sin(dh_alpha), cos(dh_alpha), dh_d],
                [0, 0, 0, 1],
            ]
        ),
    )

    dh_wrist = Equation(
        name="elbow_arm.dh_wrist",
        left=T_03,
        right=Matrix(
            [
                [cos(theta1) * cos(raised), -cos(theta1) * sin(raised), sin(theta1), p_x],
                [sin(theta1) * cos(raised), -sin(theta1) * sin(raised), -cos(theta1), p_y],
                [sin(raised), cos(raised), 0, p_z],
                [0, 0, 0, 1],
            ]
        ),
        where=tuple(zip((p_x, p_y, p_z), forward.right, strict=True)),
    )
