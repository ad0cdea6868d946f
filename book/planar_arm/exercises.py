"""Exercises on the planar arm's velocities, and the mistakes that are made there."""

from functools import partial

import numpy as np

from robokin import motion, planar_arm
from workshop.practice import Ask, Exercise, Mistake, angle, one_of, steps

TWIST = (Ask("ẋ", "m/s"), Ask("ẏ", "m/s"), Ask("φ̇", "rad/s"))
RATES = tuple(Ask(f"θ̇_{i}", "rad/s") for i in (1, 2, 3))

M26 = Mistake(
    "M26",
    says="with [0, 0, 1] as the last row of J, as if only the last joint turned the hand",
    line="twist = [x_dot, y_dot, q3]",
    why="The hand's angle is the sum of all three joint angles: each joint turns all that follows "
    "it. So its rate is the sum of all three rates, and the last row of J is [1, 1, 1]. With "
    "[0, 0, 1] even the singular poses are others: det J becomes "
    "l_1 (l_2 sin θ_2 + l_3 sin(θ_2 + θ_3)).",
    unnoticed="Where the first two rates cancel, so that link 2 does not turn. In torques, as long "
    "as no moment acts on the hand.",
    document="004 Ans 2, the matrices of part 2",
    stands="φ̇ = θ̇_3, the last row [0, 0, θ̇_3]",
    should="φ̇ = θ̇_1 + θ̇_2 + θ̇_3, the last row of J is [1, 1, 1]",
)
M27 = Mistake(
    "M27",
    says="when in ẏ each link turns only at the rate of its own joint",
    line="y_dot = l1 * c1 * q1 + l2 * c12 * q2 + l3 * c123 * q3\ntwist = [x_dot, y_dot, phi_dot]",
    why="The derivative of sin(θ_1 + θ_2) is cos(θ_1 + θ_2) times the rate of the whole sum, "
    "θ̇_1 + θ̇_2. A link turns with its own joint and with all joints before it.",
    unnoticed="When only the last joint turns.",
    document="004 Ans 2, the first line of ẏ",
    stands="ẏ = l_1 cos θ_1 θ̇_1 + l_2 cos(θ_1 + θ_2) θ̇_2 + l_3 cos(θ_1 + θ_2 + θ_3) θ̇_3",
    should="ẏ = l_1 cos θ_1 θ̇_1 + l_2 cos(θ_1 + θ_2) (θ̇_1 + θ̇_2) "
    "+ l_3 cos(θ_1 + θ_2 + θ_3) (θ̇_1 + θ̇_2 + θ̇_3)",
)
M28 = Mistake(
    "M28",
    says="with l_2 where l_3 belongs, in the third term of both rows",
    line="x_dot = -l1 * s1 * q1 - l2 * s12 * (q1 + q2) - l2 * s123 * (q1 + q2 + q3)\n"
    "y_dot = l1 * c1 * q1 + l2 * c12 * (q1 + q2) + l2 * c123 * (q1 + q2 + q3)\n"
    "twist = [x_dot, y_dot, phi_dot]",
    why="The third term is the motion of the third link, so its length is l_3. A line that was "
    "copied and changed keeps the old index.",
    unnoticed="Where both links are equally long, or the hand does not turn. The value of "
    "det J does not show it: l_3 is not in it.",
    document="004 Ans 2, the velocity equations as a matrix",
    stands="l_2 sin(θ_1 + θ_2 + θ_3) and l_2 cos(θ_1 + θ_2 + θ_3)",
    should="l_3 sin(θ_1 + θ_2 + θ_3), with a minus (M36), and l_3 cos(θ_1 + θ_2 + θ_3)",
)
M29 = Mistake(
    "M29",
    says="when the hand's velocity is multiplied by J, not by the inverse of J",
    line="rates = J @ twist",
    why="J leads from the joint rates to the hand's velocity. For the way back, multiply both "
    "sides of twist = J @ rates by the inverse of J: rates = inv(J) @ twist. The "
    "units warn: J times the velocity adds metres in a second to radians in a second.",
    unnoticed="When the hand stands still: zero either way.",
    document="004 Ans 2, the last step",
    stands="A = BC, multiplied by B: BA = BBC, so BA = C",
    should="B⁻¹ A = B⁻¹ B C = C: the joint rates are J⁻¹ times the hand's velocity",
)
M36 = Mistake(
    "M36",
    says="with a plus before the third term of ẋ, l_3 sin(θ_1 + θ_2 + θ_3)",
    line="x_dot = -l1 * s1 * q1 - l2 * s12 * (q1 + q2) + l3 * s123 * (q1 + q2 + q3)\n"
    "twist = [x_dot, y_dot, phi_dot]",
    why="The derivative of each cosine is minus the sine. One of the three minus signs got lost.",
    unnoticed="Where the hand points along the x axis, either way, or does not turn. The "
    "value of det J does not show it.",
    document="004 Ans 2, the velocity equations as a matrix",
    stands="a plus before the third term in the row of ẋ",
    should="−l_3 sin(θ_1 + θ_2 + θ_3)(θ̇_1 + θ̇_2 + θ̇_3)",
)
M37 = Mistake(
    "M37",
    says="when sines and cosines stay as they are in the position and are not differentiated",
    line="x_dot = l1 * c1 * q1 + l2 * c12 * (q1 + q2) + l3 * c123 * (q1 + q2 + q3)\n"
    "y_dot = l1 * s1 * q1 + l2 * s12 * (q1 + q2) + l3 * s123 * (q1 + q2 + q3)\n"
    "twist = [x_dot, y_dot, phi_dot]",
    why="A link that turns moves its end at right angles to itself: cos becomes −sin, sin becomes "
    "cos. Without this the hand moves along the links, as if they grew longer. The whole velocity "
    "is off by a quarter turn.",
    unnoticed="Only where the hand's point stands still. Its speed is right, and det J does not "
    "show it.",
    document="004 Ans 2, part 1, the velocities",
    stands="l_1 cos θ_1 θ̇_1, l_2 cos(θ_1 + θ_2) θ̇_1 … in the row of ẋ, sines in that of ẏ",
    should="−l_1 sin θ_1 θ̇_1, −l_2 sin(θ_1 + θ_2)(θ̇_1 + θ̇_2) … in the row of ẋ, "
    "cosines in that of ẏ",
)


def arm(l1, l2, l3, theta1, theta2, theta3, **_):
    """The joint angles and the lengths, as the functions of `planar_arm` take them."""
    return {"theta": np.array([theta1, theta2, theta3]), "lengths": np.array([l1, l2, l3])}


def jacobian(made, **numbers):
    """J as somebody has it who made a mistake; with None the right one."""
    theta, lengths = arm(**numbers).values()
    if made is M28:
        lengths = lengths[[0, 1, 1]]
    J = planar_arm.jacobian(theta, lengths)
    x, y = lengths * np.cos(theta.cumsum()), lengths * np.sin(theta.cumsum())
    if made is M26:
        J[2] = [0, 0, 1]
    elif made is M27:
        J[1] = x
    elif made is M36:
        J[0] += 2 * y[2]
    elif made is M37:
        J[:2] = [J[1], -J[0]]
    return J


def made_in(formula, *mistakes):
    """The formula as those have it who make a mistake: its first argument."""
    return {mistake: partial(formula, mistake) for mistake in mistakes}


def hand_velocity(made, q1, q2=0.0, q3=0.0, **numbers):
    """The hand's twist."""
    return jacobian(made, **numbers) @ [q1, q2, q3]


def joint_rates(made, v_x, v_y, omega, **numbers):
    """The joint rates for a twist."""
    J, twist = jacobian(made, **numbers), [v_x, v_y, omega]
    if made is None:
        return planar_arm.joint_rates(twist=twist, **arm(**numbers))
    return J @ twist if made is M29 else np.linalg.solve(J, twist)


def torques(made, f_x, f_y, m, **numbers):
    """The joint torques with which the hand pushes and twists."""
    return jacobian(made, **numbers).T @ [f_x, f_y, m]


def top_speed(made, towards, limit, **numbers):
    """How fast the hand can go in a direction without turning, with all rates limited."""
    rates = joint_rates(made, np.cos(towards), np.sin(towards), 0.0, **numbers)
    return limit / np.abs(rates).max()


def manipulability(made, **numbers):
    """√det(J Jᵀ) of the position rows."""
    J = jacobian(made, **numbers)[:2]
    return np.sqrt(np.linalg.det(J @ J.T))


def stretched_or_folded(theta1, phi, **_):
    """[theta2, theta3] of both singular poses in which the hand points at phi."""
    theta2 = np.array([0, np.pi])
    return np.stack([theta2, motion.wrap_angle(phi - theta1 - theta2)], axis=-1)


def sine_by_m26(l2, l3, theta1, phi, **_):
    """sin θ2 where M26's determinant is zero."""
    return -l3 * np.sin(phi - theta1) / l2


def singular_by_m26(theta1, phi, **numbers):
    """[theta2, theta3] of both poses that M26 takes for singular."""
    theta2 = np.arcsin(sine_by_m26(theta1=theta1, phi=phi, **numbers))
    theta2 = np.array([theta2, np.pi - theta2])
    return np.stack([theta2, phi - theta1 - theta2], axis=-1)


def pose_parts(**numbers):
    """What stands in the formulas: where the links point, their sines and cosines, J."""
    theta, lengths = arm(**numbers).values()
    names = ("1", "12", "123")
    turned = dict(zip(names, theta.cumsum(), strict=True))
    x, y, _ = planar_arm.forward(theta, lengths)
    return {
        **{f"s{name}": np.sin(turned[name]) for name in names},
        **{f"c{name}": np.cos(turned[name]) for name in names},
        **{"phi12": turned["12"], "phi123": turned["123"]},
        **{"x": x, "y": y, "J": planar_arm.jacobian(theta, lengths)},
    }


def top_speed_parts(towards, **numbers):
    """The same, and the joint rates for 1 m/s in a direction."""
    rates = joint_rates(None, np.cos(towards), np.sin(towards), 0.0, **numbers)
    return {**pose_parts(**numbers), "rates": rates, "fastest": np.abs(rates).max()}


def velocity_parts(q1, q2, q3, **numbers):
    """The same, and the hand's velocity in parts."""
    x_dot, y_dot, phi_dot = planar_arm.velocity(rates=[q1, q2, q3], **arm(**numbers))
    rates = {"x_dot": x_dot, "y_dot": y_dot, "phi_dot": phi_dot, "q12": q1 + q2}
    return {**pose_parts(**numbers), **rates}


LINKS = {
    "l1": steps(30, 60, 5, "cm"),
    "l2": steps(20, 50, 5, "cm"),
    "l3": steps(10, 25, 5, "cm"),
}
POSE = LINKS | {
    "theta1": steps(-60, 120, 10, "°"),
    "theta2": steps(30, 150, 10, "°"),
    "theta3": steps(-90, 90, 10, "°"),
}
ARM = (
    "A planar arm has three links of {l1}, {l2} and {l3}. Its joint angles are θ_1 = {theta1}, "
    "θ_2 = {theta2} and θ_3 = {theta3}; θ_2 and θ_3 are measured from the link before. "
)
POINTING = (
    "The links point at the angles θ_1 = {theta1}, θ_1 + θ_2 = {phi12:deg} and "
    "θ_1 + θ_2 + θ_3 = {phi123:deg}. "
)
SLOW = one_of(*(n / 10 for n in range(-10, 11) if abs(n) > 1), unit="rad/s")
SPEED = one_of(*(n / 20 for n in range(-8, 9) if n), unit="m/s")
FORCE = one_of(*(n for n in range(-40, 41, 5) if n), unit="N")

EXAMPLE = {
    **{"l1": 0.4, "l2": 0.3, "l3": 0.1},
    **{"theta1": np.pi / 6, "theta2": np.pi / 2, "theta3": -np.pi / 3},
}


planar_arm_1 = Exercise(
    "planar-arm-1",
    level=1,
    title="Only the first joint turns",
    text=ARM + "Only the first joint turns, at {q1}. How fast does the hand move along x and y, "
    "and how fast does it turn?",
    given=POSE | {"q1": SLOW},
    asks=TWIST,
    right=lambda q1, **pose: planar_arm.velocity(rates=[q1, 0, 0], **arm(**pose)),
    wrong=made_in(hand_velocity, M26, M27, M28, M36, M37),
    derive=lambda q1, **pose: pose_parts(**pose),
    solution="The whole arm turns about its base like one stiff body. " + POINTING + "So the hand "
    "is at\n\nx = l_1 cos θ_1 + l_2 cos(θ_1 + θ_2) + l_3 cos(θ_1 + θ_2 + θ_3) = {x} m\n\n"
    "y, the same with sines, = {y} m\n\nIt moves at right angles to the line from the base to the "
    "hand, and turns as fast as the joint:\n\n[−y θ̇_1, x θ̇_1, θ̇_1] = {right}",
)

planar_arm_2 = Exercise(
    "planar-arm-2",
    level=2,
    title="How fast does the hand move?",
    text=ARM + "The joints turn at θ̇_1 = {q1}, θ̇_2 = {q2} and θ̇_3 = {q3}. How fast does the hand "
    "move along x and y, and how fast does it turn?",
    given=POSE | {"q1": SLOW, "q2": SLOW, "q3": SLOW},
    asks=TWIST,
    right=lambda q1, q2, q3, **pose: planar_arm.velocity(rates=[q1, q2, q3], **arm(**pose)),
    wrong=made_in(hand_velocity, M26, M27, M28, M36, M37),
    derive=velocity_parts,
    solution=POINTING + "They turn at θ̇_1 = {q1:} rad/s, θ̇_1 + θ̇_2 = {q12} rad/s and "
    "θ̇_1 + θ̇_2 + θ̇_3 = {phi_dot} rad/s. Differentiate the position, link by link:\n\n"
    "ẋ = −l_1 sin θ_1 θ̇_1 − l_2 sin(θ_1 + θ_2)(θ̇_1 + θ̇_2) "
    "− l_3 sin(θ_1 + θ_2 + θ_3)(θ̇_1 + θ̇_2 + θ̇_3) = {x_dot} m/s\n\n"
    "ẏ = l_1 cos θ_1 θ̇_1 + l_2 cos(θ_1 + θ_2)(θ̇_1 + θ̇_2) "
    "+ l_3 cos(θ_1 + θ_2 + θ_3)(θ̇_1 + θ̇_2 + θ̇_3) = {y_dot} m/s\n\n"
    "The hand turns like the last link:\n\n[ẋ, ẏ, φ̇] = {right}",
    example=EXAMPLE | {"q1": 0.5, "q2": 0.2, "q3": 0.4},
)

planar_arm_3 = Exercise(
    "planar-arm-3",
    level=2,
    title="Where the arm gets stuck",
    text="A planar arm has three links of {l1}, {l2} and {l3}. Its first joint is at "
    "θ_1 = {theta1}, and the hand must point at the angle φ = {phi} from the x axis. There are "
    "two such poses in which the arm is singular: the 3×3 matrix J has no inverse. Find θ_2 and "
    "θ_3 of both.",
    given=LINKS | {"theta1": steps(-60, 120, 10, "°"), "phi": steps(-90, 90, 10, "°")},
    asks=(angle("θ_2"), angle("θ_3")),
    accept="all",
    right=stretched_or_folded,
    wrong={M26: singular_by_m26},
    when=lambda **pose: 0.1 < abs(sine_by_m26(**pose)) < 0.9,
    derive=lambda theta1, phi, **_: {
        "stretched": motion.wrap_angle(phi - theta1),
        "folded": motion.wrap_angle(phi - theta1 - np.pi),
    },
    solution="det J = l_1 l_2 sin θ_2: only the second joint counts. It is zero for θ_2 = 0, where "
    "the first two links are stretched, and for θ_2 = π, where the second is folded back over the "
    "first. The hand's angle is φ = θ_1 + θ_2 + θ_3, so θ_3 = φ − θ_1 − θ_2:\n\n"
    "stretched: θ_3 = φ − θ_1 = {stretched:deg}\n\n"
    "folded: θ_3 = φ − θ_1 − 180° = {folded:deg}, up to whole turns\n\n"
    "In radians, [θ_2, θ_3]: {right}",
)

planar_arm_4 = Exercise(
    "planar-arm-4",
    level=2,
    title="Pushing and twisting",
    text=ARM + "The hand pushes on a workpiece with the force f_x = {f_x}, f_y = {f_y} and twists "
    "it with the moment m = {m}. Nothing moves, and the arm lies flat on a table, so that its "
    "weight does not matter. Which torques must the three joints give?",
    given=POSE | {"f_x": FORCE, "f_y": FORCE, "m": one_of(-4, -3, -2, 2, 3, 4, unit="N·m")},
    asks=tuple(Ask(f"τ_{i}", "N·m") for i in (1, 2, 3)),
    right=partial(torques, None),
    wrong=made_in(torques, M26, M27, M28, M36, M37),
    derive=lambda f_x, f_y, m, **pose: pose_parts(**pose),
    also={
        "with J where its transpose belongs": lambda f_x, f_y, m, **numbers: (
            jacobian(None, **numbers) @ [f_x, f_y, m]
        ),
    },
    solution="In a small motion the joints must put in as much work as the hand gives out: "
    "τ · θ̇ = f · ẋ for all joint rates, and ẋ = J θ̇. Hence τ = Jᵀ f, where f has the entries f_x, "
    "f_y and m. " + POINTING + "Column j of J is the motion of the hand when joint j alone turns:"
    "\n\nJ = {J}\n\nJᵀ [{f_x:}, {f_y:}, {m:}] = {right}",
)

planar_arm_5 = Exercise(
    "planar-arm-5",
    level=3,
    title="Which joint rates?",
    text=ARM + "Now the hand must move at ẋ = {v_x}, ẏ = {v_y} and turn at φ̇ = {omega}. How fast "
    "must the three joints turn?",
    given=POSE | {"v_x": SPEED, "v_y": SPEED, "omega": SLOW},
    asks=RATES,
    right=partial(joint_rates, None),
    wrong=made_in(joint_rates, M26, M27, M28, M29, M36, M37),
    derive=lambda v_x, v_y, omega, **pose: {
        **pose_parts(**pose),
        "twist": np.array([v_x, v_y, omega]),
        "det": np.linalg.det(planar_arm.jacobian(**arm(**pose))),
    },
    also={
        "with the transpose where the inverse belongs": lambda v_x, v_y, omega, **numbers: (
            jacobian(None, **numbers).T @ [v_x, v_y, omega]
        ),
    },
    solution=POINTING + "Column j of J is the motion of the hand when joint j alone turns:\n\n"
    "J = {J}\n\ndet J = l_1 l_2 sin θ_2 = {det} m² is not zero, so J has an inverse. Solve "
    "J θ̇ = {twist} for the joint rates, with np.linalg.solve or by hand:\n\n"
    "θ̇ = J⁻¹ {twist} = {right}",
    example=EXAMPLE | {"v_x": 0.1, "v_y": 0.2, "omega": 0.3},
)

planar_arm_6 = Exercise(
    "planar-arm-6",
    level=3,
    title="How fast at most?",
    text=ARM + "No joint can turn faster than {limit}. The hand must move straight in the "
    "direction {towards} from the x axis and must not turn. How fast can it move in this pose?",
    given=POSE
    | {"towards": steps(0, 350, 10, "°"), "limit": one_of(0.5, 1, 1.5, 2, 2.5, 3, unit="rad/s")},
    asks=(Ask("v", "m/s"),),
    right=partial(top_speed, None),
    wrong=made_in(top_speed, M26, M27, M29, M37),
    derive=lambda towards, limit, **pose: top_speed_parts(towards, **pose),
    also={
        "when the rates together, as a vector, reach the limit": lambda limit, **numbers: (
            limit / np.linalg.norm(top_speed_parts(**numbers)["rates"])
        ),
        "when the slowest joint reaches the limit": lambda limit, **numbers: (
            limit / np.abs(top_speed_parts(**numbers)["rates"]).min()
        ),
    },
    solution="The rates grow in proportion to the speed. So find the rates for 1 m/s first. "
    + POINTING
    + "Column j of J is the motion of the hand when joint j alone turns:\n\nJ = {J}\n\n"
    "J⁻¹ [cos {towards}, sin {towards}, 0] = {rates}\n\n"
    "At 1 m/s the fastest joint would turn at {fastest} rad/s. It may turn at {limit}, so\n\n"
    "v = {limit:}/{fastest} = {right}",
)

planar_arm_7 = Exercise(
    "planar-arm-7",
    level=3,
    title="How well can the hand move?",
    text=ARM + "The manipulability √det(J Jᵀ) says how well the hand's point can move in all "
    "directions; for this J has only the two rows of ẋ and ẏ. How large is it?",
    given=POSE,
    asks=(Ask("w", "m²"),),
    right=lambda **pose: planar_arm.manipulability(**arm(**pose)),
    wrong=made_in(manipulability, M27, M28, M36),
    derive=lambda **pose: {
        **pose_parts(**pose),
        "rows": planar_arm.jacobian(**arm(**pose))[:2],
        "square": (lambda J: J @ J.T)(planar_arm.jacobian(**arm(**pose))[:2]),
    },
    also={
        "without the root": lambda **numbers: manipulability(None, **numbers) ** 2,
        "with all three rows of J": lambda **numbers: abs(np.linalg.det(jacobian(None, **numbers))),
    },
    solution=POINTING + "The two rows of J, a column for each joint:\n\nJ = {rows}\n\n"
    "J Jᵀ = {square}\n\nThe square root of det(J Jᵀ):\n\nw = {right}",
)
