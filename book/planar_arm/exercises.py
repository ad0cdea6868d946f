"""Exercises on the planar arm's velocities, and the mistakes that are made there."""

from functools import cache, partial
from itertools import combinations

import numpy as np
from sympy import (
    Abs,
    Matrix,
    MatrixSymbol,
    Max,
    Symbol,
    cos,
    pi,
    sin,
    solve,
    sqrt,
    symbols,
)

from book.planar_arm import formulas
from book.planar_arm.formulas import J, phi_dot, rate1, rate2, rate3, theta2, x, x_dot, y, y_dot
from courseware.answers import Unknown, angle
from courseware.equations import as_written, substitute
from courseware.practice import (
    Exercise,
    LocalEquation,
    Mistake,
    Solution,
    Step,
    WrongFormula,
    number_range,
    one_of,
)
from robokin import motion, planar_arm

TWIST = (Unknown("ẋ", "m/s"), Unknown("ẏ", "m/s"), Unknown("φ̇", "rad/s"))
RATES = tuple(Unknown(f"θ̇_{i}", "rad/s") for i in (1, 2, 3))

ROWS = dict(zip(formulas.TWIST, formulas.velocity.right, strict=True))
X_ROW, Y_ROW, TURN_ROW = (LocalEquation(left, right) for left, right in ROWS.items())
BOTH_ROWS = LocalEquation(Matrix(formulas.TWIST[:2]), formulas.velocity.right[:2, :])
RATES_OF, TWIST_OF = (MatrixSymbol(name, 3, 1) for name in (r"\dot\theta", r"\dot{p}"))
WHOLE_J = MatrixSymbol("J", 3, 3)
ALONE = {formulas.rate12: rate2, formulas.rate123: rate3}  # each link at its own joint's rate
COSINES, SINES = ([symbol for symbol, _ in formulas.SHORT[k::2]] for k in (0, 1))
UNDIFFERENTIATED = dict(
    zip((*COSINES, *SINES), (*SINES, *(-c for c in COSINES)), strict=True),
)

last_joint_only = Mistake(
    "M26",
    feedback="with [0, 0, 1] as the last row of J, as if only the last joint turned the hand",
    formula=WrongFormula(TURN_ROW, {formulas.rate123: rate3}),
    line="twist = [x_dot, y_dot, q3]",
    why="The hand's angle is the sum of all three joint angles: each joint turns all that follows "
    "it. So its rate is the sum of all three rates, and the last row of J is [1, 1, 1]. With "
    "[0, 0, 1] even the singular poses are others: det J becomes "
    "l_1 (l_2 sin θ_2 + l_3 sin(θ_2 + θ_3)).",
    unnoticed="Where the first two rates cancel, so that link 2 does not turn. In torques, as long "
    "as no moment acts on the hand.",
    title="In its place, but turned",
    picture="The hand is in its place, but turned too far to the left.",
    document="004 Ans 2",
    place="the matrices of part 2, last row",
    nth=5,
    quote="φ̇ = θ̇_3, the last row [0, 0, θ̇_3]",
    correction="φ̇ = «θ̇_1 + θ̇_2 +» θ̇_3, the last row «[1, 1, 1]»",
    explanation="The matrices write θ for the hand's angle φ. It is the sum of the three joint "
    "angles, as the document says on its first page, so its rate is the sum of the "
    "three rates.",
)
separate_rates = Mistake(
    "M27",
    feedback="when in ẏ each link turns only at the rate of its own joint",
    formula=WrongFormula(Y_ROW, ALONE),
    line="y_dot = l1 * c1 * q1 + l2 * c12 * q2 + l3 * c123 * q3\ntwist = [x_dot, y_dot, phi_dot]",
    why="The derivative of sin(θ_1 + θ_2) is cos(θ_1 + θ_2) times the rate of the whole sum, "
    "θ̇_1 + θ̇_2. A link turns with its own joint and with all joints before it.",
    unnoticed="When only the last joint turns; or where all that is missing, l_2 c_12 θ̇_1 + "
    "l_3 c_123 (θ̇_1 + θ̇_2), is 0, as with links 2 and 3 along y.",
    title="It leaves the line",
    picture=(
        "The hand sinks below its line. Its program believes that it moves along the line to the "
        "left."
    ),
    document="004 Ans 2",
    place="the first line of ẏ",
    nth=1,
    quote="ẏ = l_1 cos θ_1 θ̇_1 + l_2 cos(θ_1 + θ_2) θ̇_2 + l_3 cos(θ_1 + θ_2 + θ_3) θ̇_3",
    correction="ẏ = l_1 cos θ_1 θ̇_1 + l_2 cos(θ_1 + θ_2) «(θ̇_1 + θ̇_2)» + l_3 cos(θ_1 + θ_2 + "
    "θ_3) «(θ̇_1 + θ̇_2 + θ̇_3)»",
    explanation="The next line of the document has it right. A link turns with its own joint and "
    "with all joints before it.",
)
l_2_for_l_3 = Mistake(
    "M28",
    feedback="with l_2 where l_3 belongs, in the third term of both rows",
    formula=WrongFormula(BOTH_ROWS, {formulas.l3: formulas.l2}),
    line="x_dot = -l1 * s1 * q1 - l2 * s12 * (q1 + q2) - l2 * s123 * (q1 + q2 + q3)\n"
    "y_dot = l1 * c1 * q1 + l2 * c12 * (q1 + q2) + l2 * c123 * (q1 + q2 + q3)\n"
    "twist = [x_dot, y_dot, phi_dot]",
    why="The third term is the motion of the third link, so its length is l_3. A line that was "
    "copied and changed keeps the old index.",
    unnoticed="Where both links are equally long, or the hand does not turn. The value of "
    "det J does not show it: l_3 is not in it.",
    title="Too far if clockwise",
    picture=(
        "If the hand turns clockwise, it goes too far. Its program believes that it moves along "
        "the line to the left."
    ),
    document="004 Ans 2",
    place="part 1, the velocities as a matrix, third column",
    nth=4,
    quote="l_2 sin(θ_1 + θ_2 + θ_3) and l_2 cos(θ_1 + θ_2 + θ_3)",
    correction="«l_3» sin(θ_1 + θ_2 + θ_3), with a minus (M36), and «l_3» cos(θ_1 + θ_2 + θ_3)",
)
times_J = Mistake(
    "M29",
    feedback="when the hand's velocity is multiplied by J, not by the inverse of J",
    formula=WrongFormula(LocalEquation(RATES_OF, WHOLE_J.I * TWIST_OF), instead=WHOLE_J * TWIST_OF),
    line="rates = J @ twist",
    why="J leads from the joint rates to the hand's velocity. For the way back, multiply both "
    "sides of twist = J @ rates by the inverse of J: rates = inv(J) @ twist. The "
    "units warn: J times the velocity adds metres in a second to radians in a second.",
    unnoticed="When the hand stands still: zero either way.",
    title="It stays behind",
    picture=(
        "The hand stays behind, on the right. Its program believes that it moves along the line to "
        "the left."
    ),
    document="004 Ans 2",
    place="the last step",
    nth=6,
    quote="A = BC, multiplied by B: BA = BBC, so BA = C",
    correction="A = BC, multiplied by «B⁻¹»: «B⁻¹»A = «B⁻¹»BC, so «B⁻¹»A = C",
    explanation="A is the hand's velocity, C are the joint rates. B leads from C to A; the way "
    "back is the inverse of B.",
)
plus_sine = Mistake(
    "M36",
    feedback="with a plus before the third term of ẋ, l_3 sin(θ_1 + θ_2 + θ_3)",
    formula=WrongFormula(X_ROW, {formulas.s123: -formulas.s123}),
    line="x_dot = -l1 * s1 * q1 - l2 * s12 * (q1 + q2) + l3 * s123 * (q1 + q2 + q3)\n"
    "twist = [x_dot, y_dot, phi_dot]",
    why="The derivative of each cosine is minus the sine. One of the three minus signs got lost.",
    unnoticed="Where the hand points along the x axis, either way, or does not turn. The "
    "value of det J does not show it.",
    title="Too short if clockwise",
    picture=(
        "If the hand turns clockwise, it falls short. Its program believes that it moves along "
        "the line to the left."
    ),
    document="004 Ans 2",
    place="part 1, the velocities as a matrix, first row",
    nth=3,
    quote="l_2 sin(θ_1 + θ_2 + θ_3)(θ̇_1 + θ̇_2 + θ̇_3), with a plus",
    correction="«−»l_3 sin(θ_1 + θ_2 + θ_3)(θ̇_1 + θ̇_2 + θ̇_3)",
    explanation="The derivative of each cosine is minus the sine. One of the three minus signs got "
    "lost. (The length is the erratum M28.)",
)
not_derived = Mistake(
    "M37",
    feedback="when sines and cosines stay as they are in the position and are not differentiated",
    formula=WrongFormula(BOTH_ROWS, UNDIFFERENTIATED),
    line="x_dot = l1 * c1 * q1 + l2 * c12 * (q1 + q2) + l3 * c123 * (q1 + q2 + q3)\n"
    "y_dot = l1 * s1 * q1 + l2 * s12 * (q1 + q2) + l3 * s123 * (q1 + q2 + q3)\n"
    "twist = [x_dot, y_dot, phi_dot]",
    why="A link that turns moves its end at right angles to itself: cos becomes −sin, sin becomes "
    "cos. Without this the hand moves along the links, as if they grew longer. The whole velocity "
    "is off by a quarter turn.",
    unnoticed="Only where the hand's point stands still. Its speed is right, and det J does not "
    "show it.",
    title="It goes off at right angles",
    picture=(
        "The hand moves straight down. Its program believes that it moves along the line to the "
        "left."
    ),
    document="004 Ans 2",
    place="part 1, the velocities",
    nth=2,
    quote="l_1 cos θ_1 θ̇_1, l_2 cos(θ_1 + θ_2) θ̇_1 … in the row of ẋ, sines in that of ẏ",
    correction="«−»l_1 «sin» θ_1 θ̇_1, «−»l_2 «sin»(θ_1 + θ_2) «(θ̇_1 + θ̇_2)» … in the "
    "row of ẋ, «cosines» in that of ẏ",
    explanation="A link that turns moves its end at right angles to itself: cos becomes −sin, sin "
    "becomes cos. The document has this right further above.",
)


def arm(l1, l2, l3, theta1, theta2, theta3, **_):
    """Return the joint angles and the lengths, as the functions of `planar_arm` take them."""
    return {"theta": np.array([theta1, theta2, theta3]), "lengths": np.array([l1, l2, l3])}


OWN_RATES = "when in ẋ and in ẏ each link turns only at the rate of its own joint"
OWN_RATES_IN_X = "when in ẋ each link turns only at the rate of its own joint"
OWN = WrongFormula(BOTH_ROWS, ALONE)
OWN_IN_X = WrongFormula(X_ROW, ALONE)


@cache
def wrong_jacobian(*made):
    """Return J in letters, as somebody has it who made mistakes in the hand's velocity."""
    rows = dict(ROWS)
    for wrong in made:
        for left in Matrix([wrong.of.left]):
            rows[left] = substitute(rows[left], wrong.replaced)
    return Matrix(list(rows.values())).jacobian(formulas.RATES)


def jacobian(made, **numbers):
    """Return J as somebody has it who made a mistake, or several; with None the right one."""
    if made is None:
        return planar_arm.jacobian(**arm(**numbers))
    found = wrong_jacobian(*made) if isinstance(made, tuple) else wrong_jacobian(made)
    directions = arm(**numbers)["theta"].cumsum()
    for c, s, turned in zip(COSINES, SINES, directions, strict=True):
        numbers |= {str(c): np.cos(turned), str(s): np.sin(turned)}
    return WrongFormula(formulas.jacobian, instead=found).evaluate(**numbers)


def made_in(formula, *mistakes):
    """Return the formula as those have it who make a mistake: its first argument."""
    return {mistake: partial(formula, mistake.formula) for mistake in mistakes}


def own_rates(formula):
    """Return the same for M27 in both rows, and in the other row alone."""
    return {OWN_RATES: partial(formula, OWN), OWN_RATES_IN_X: partial(formula, OWN_IN_X)}


def made_together(formula, *mistakes):
    """Return the same for those who make two mistakes."""
    return {(a, b): partial(formula, (a.formula, b.formula)) for a, b in combinations(mistakes, 2)}


def hand_velocity(made, q1, q2=0.0, q3=0.0, **numbers):
    """Return the hand's twist."""
    return jacobian(made, **numbers) @ [q1, q2, q3]


def joint_rates(made, v_x, v_y, omega, **numbers):
    """Return the joint rates for a twist."""
    twist = [v_x, v_y, omega]
    if made is None:
        return planar_arm.joint_rates(twist=twist, **arm(**numbers))
    if made is times_J.formula:
        return made.evaluate(**{"J": jacobian(None, **numbers), str(TWIST_OF): np.array(twist)})
    return np.linalg.solve(jacobian(made, **numbers), twist)


def torques(made, f_x, f_y, m, **numbers):
    """Return the joint torques with which the hand pushes and twists."""
    return jacobian(made, **numbers).T @ [f_x, f_y, m]


def straight_rates(towards, made=None, **numbers):
    """Return the joint rates for 1 m/s in a direction, the hand not turning."""
    return joint_rates(made, np.cos(towards), np.sin(towards), 0.0, **numbers)


def top_speed(made, towards, limit, **numbers):
    """Return how fast the hand can go in a direction without turning, with all rates limited."""
    return limit / np.abs(straight_rates(towards, made, **numbers)).max()


def manipulability(made, **numbers):
    """Return √det(J Jᵀ) of the position rows."""
    J = jacobian(made, **numbers)[:2]
    return np.sqrt(np.linalg.det(J @ J.T))


def stretched_or_folded(theta1, phi, **_):
    """Return [theta2, theta3] of both singular poses in which the hand points at phi."""
    theta2 = np.array([0, np.pi])
    return np.stack([theta2, motion.wrap_angle(phi - theta1 - theta2)], axis=-1)


def sine_by_m26(l2, l3, theta1, phi, **_):
    """Return sin θ2 where M26's determinant is zero."""
    return -l3 * np.sin(phi - theta1) / l2


def singular_by_m26(theta1, phi, **numbers):
    """Return [theta2, theta3] of both poses that M26 takes for singular."""
    theta2 = np.arcsin(sine_by_m26(theta1=theta1, phi=phi, **numbers))
    theta2 = np.array([theta2, np.pi - theta2])
    return np.stack([theta2, phi - theta1 - theta2], axis=-1)


def short_names(**numbers):
    """Return what the books shorten: the sines and cosines of the links' directions."""
    headings = arm(**numbers)["theta"].cumsum()
    names = ("1", "12", "123")
    return {
        **{f"s{name}": np.sin(turned) for name, turned in zip(names, headings, strict=True)},
        **{f"c{name}": np.cos(turned) for name, turned in zip(names, headings, strict=True)},
    }


def velocity_parts(q1, q2, q3, **numbers):
    """Return the same, and the hand's velocity in parts."""
    twist = planar_arm.velocity(rates=[q1, q2, q3], **arm(**numbers))
    return short_names(**numbers) | dict(zip(("x_dot", "y_dot", "phi_dot"), twist, strict=True))


LINKS = {
    "l1": number_range(30, 60, 5, "cm"),
    "l2": number_range(20, 50, 5, "cm"),
    "l3": number_range(10, 25, 5, "cm"),
}
POSE = LINKS | {
    "theta1": number_range(-60, 120, 10, "°"),
    "theta2": number_range(30, 150, 10, "°"),
    "theta3": number_range(-90, 90, 10, "°"),
}
HAND = (
    "A planar arm has three links of {l1}, {l2} and {l3}. The hand is the end of the third link, "
    "and φ is the angle of this link from the x axis. "
)
MEASURED = (
    "Angles are counted counter-clockwise, θ_1 from the x axis, θ_2 and θ_3 from the link before. "
)
ARM = HAND + "The joint angles are θ_1 = {theta1}, θ_2 = {theta2} and θ_3 = {theta3}. " + MEASURED
SLOW = one_of(*(n / 10 for n in range(-10, 11) if abs(n) > 1), unit="rad/s")
SPEED = one_of(*(n / 20 for n in range(-8, 9) if n), unit="m/s")
FORCE = one_of(*(n for n in range(-40, 41, 5) if n), unit="N")

# What the solutions share
WRITTEN_OUT = dict((*formulas.SHORT, *formulas.BENDS))  # sines and cosines, not their short names
STRETCHED, FOLDED = solve(formulas.det.right, theta2)
TOWARDS, LIMIT = Symbol("alpha"), Symbol(r"\dot\theta_\mathrm{max}")
f_x, f_y, m = symbols("f_x f_y m")
U, BY_TWIST = Symbol("u"), {x_dot: "v_x", y_dot: "v_y", phi_dot: "omega"}
with as_written():
    LEVER = Matrix([-(y * rate1), x * rate1, rate1])
    ROOT = sqrt(formulas.G_xx * formulas.G_yy - formulas.G_xy**2)
    # a joint's column of J, times what the hand gives out
    WORK = [f_x * J[0, k] + f_y * J[1, k] + m * J[2, k] for k in range(3)]


def column(steps):
    """Return a column of formulas, from symbols and what they stand for."""
    return LocalEquation(*(Matrix(side) for side in zip(*steps, strict=True)))


SHORT = Step(column(formulas.SHORT))
JACOBIAN = Step(
    formulas.jacobian,
    values=tuple(map(str, J)),
    expected=lambda **numbers: planar_arm.jacobian(**arm(**numbers)),
)


def rate_steps(twist, check=None):
    """Return the joint rates for a twist, one after the other. check: gives all three."""
    return {
        name: Step(
            formulas.joint_rates,
            WRITTEN_OUT | twist,
            part=(k,),
            expected=check and (lambda k=k, **numbers: check(**numbers)[k]),
        )
        for k, name in enumerate(("first", "second", "third"))
    }


SHORT_TEXT = (
    "Each link points where all joint angles up to it add up to. The short names, such as c_12 for "
    "the cosine of the first two angles together:\n\n{short}\n\n"
)
COLUMNS = "Each column of J is the motion of the hand when that joint alone turns:\n\n{J}\n\n"


EXAMPLE = {
    **{"l1": 0.4, "l2": 0.3, "l3": 0.1},
    **{"theta1": np.pi / 6, "theta2": np.pi / 2, "theta3": -np.pi / 3},
}


planar_arm_1 = Exercise(
    "planar-arm-1",
    title="Only the first joint turns",
    text=ARM + "Only the first joint turns, at {q1}. How fast does the hand move along x and y, "
    "and how fast does it turn?",
    given=POSE | {"q1": SLOW},
    unknowns=TWIST,
    right=lambda q1, **pose: planar_arm.velocity(rates=[q1, 0, 0], **arm(**pose)),
    wrong=made_in(
        hand_velocity, last_joint_only, separate_rates, l_2_for_l_3, plus_sine, not_derived
    ),
    likely_slips=own_rates(hand_velocity),
    solution=Solution(
        "The whole arm turns about its base like one stiff body. So find first where the hand is. "
        "Each link points where all joint angles up to it add up to:\n\n{hand}\n\n"
        "The hand moves at right angles to the line from the base to it, and turns as fast as the "
        "joint:\n\n{twist}",
        hand=Step(formulas.forward, WRITTEN_OUT, part=(0, 1)),
        twist=Step(LocalEquation(Matrix(formulas.TWIST), LEVER), {rate1: "q1"}),
    ),
)

planar_arm_2 = Exercise(
    "planar-arm-2",
    title="How fast does the hand move?",
    text=ARM + "The joints turn at θ̇_1 = {q1}, θ̇_2 = {q2} and θ̇_3 = {q3}. How fast does the hand "
    "move along x and y, and how fast does it turn?",
    given=POSE | {"q1": SLOW, "q2": SLOW, "q3": SLOW},
    unknowns=TWIST,
    right=lambda q1, q2, q3, **pose: planar_arm.velocity(rates=[q1, q2, q3], **arm(**pose)),
    wrong=made_in(
        hand_velocity, last_joint_only, separate_rates, l_2_for_l_3, plus_sine, not_derived
    ),
    together=made_together(hand_velocity, last_joint_only, separate_rates, l_2_for_l_3, plus_sine),
    likely_slips=own_rates(hand_velocity),
    derive=velocity_parts,
    solution=Solution(
        SHORT_TEXT + "Differentiate the hand's place, link by link. Each link turns with its own "
        "joint and with all joints before it, and the hand turns like the last link:\n\n{twist}",
        short=SHORT,
        twist=Step(formulas.velocity, {rate1: "q1", rate2: "q2", rate3: "q3"}),
    ),
    example=EXAMPLE | {"q1": 0.5, "q2": 0.2, "q3": 0.4},
)

planar_arm_3 = Exercise(
    "planar-arm-3",
    title="Where the arm gets stuck",
    text=HAND
    + "The first joint is at θ_1 = {theta1}, and φ must be {phi}. "
    + MEASURED
    + "There are two such poses in which the arm is singular: the 3×3 matrix J with the rows of ẋ, "
    "ẏ and φ̇ has no inverse. Find θ_2 and θ_3 of both.",
    given=LINKS
    | {"theta1": number_range(-60, 120, 10, "°"), "phi": number_range(-90, 90, 10, "°")},
    unknowns=(angle("θ_2"), angle("θ_3")),
    accept="all",
    right=stretched_or_folded,
    wrong={last_joint_only: singular_by_m26},
    when=lambda **pose: 0.1 < abs(sine_by_m26(**pose)) < 0.9,
    solution=Solution(
        "J has no inverse where its determinant is zero. Of the joint angles only θ_2 is in it, in "
        "a sine. With the second joint at a right angle it is as large as it can be:\n\n{det}\n\n"
        "It is zero where the sine is zero: where the first two links are stretched, or where the "
        "second is folded back over the first by half a turn. The hand's angle is the sum of all "
        "three joint angles, so θ_3 makes up what is missing. Stretched:\n\n{stretched}"
        "\n\nFolded, up to whole turns:\n\n{folded}\n\nBoth, as [θ_2, θ_3]: {right}",
        answer=((STRETCHED, "stretched"), (FOLDED, "folded")),
        det=Step(
            formulas.det,
            {theta2: pi / 2},
            unit="m²",
            expected=lambda l1, l2, l3, **_: np.linalg.det(
                planar_arm.jacobian([0, np.pi / 2, 0], [l1, l2, l3])
            ),
        ),
        stretched=Step(
            formulas.inverse, {formulas.phi_hand: "phi"} | {theta2: STRETCHED}, part=(2,)
        ),
        folded=Step(formulas.inverse, {formulas.phi_hand: "phi"} | {theta2: FOLDED}, part=(2,)),
    ),
)

planar_arm_4 = Exercise(
    "planar-arm-4",
    title="Pushing and twisting",
    text=ARM + "The hand pushes on a workpiece with the force f_x = {f_x}, f_y = {f_y} and twists "
    "it with the moment m = {m}. Nothing moves, and the arm lies flat on a table, so that its "
    "weight does not matter. Which torques must the three joints give? (How a force goes to the "
    "joints: *A glance further*, at the end of the chapter.)",
    given=POSE | {"f_x": FORCE, "f_y": FORCE, "m": one_of(-4, -3, -2, 2, 3, 4, unit="N·m")},
    unknowns=tuple(Unknown(f"τ_{i}", "N·m") for i in (1, 2, 3)),
    right=partial(torques, None),
    wrong=made_in(torques, last_joint_only, separate_rates, l_2_for_l_3, plus_sine, not_derived),
    likely_slips={
        "with J where its transpose belongs": lambda f_x, f_y, m, **numbers: (
            jacobian(None, **numbers) @ [f_x, f_y, m]
        ),
    },
    solution=Solution(
        "In a small motion the joints must put in as much power as the hand gives out, whichever "
        "joint turns. So the torque of a joint is the power of the hand when this joint alone "
        "turns, at 1 rad/s.\n\n" + SHORT_TEXT + COLUMNS + "Power is force times motion along x "
        "and y, and moment times turning. Column by column this is the transpose of J times the "
        "force and the moment:\n\n{torques}",
        short=SHORT,
        J=JACOBIAN,
        torques=Step(LocalEquation(Matrix(symbols("tau_1:4")), Matrix(WORK), "N·m")),
    ),
)

planar_arm_5 = Exercise(
    "planar-arm-5",
    title="Which joint rates?",
    text=ARM + "Now the hand must move at ẋ = {v_x}, ẏ = {v_y} and turn at φ̇ = {omega}. How fast "
    "must the three joints turn?",
    given=POSE | {"v_x": SPEED, "v_y": SPEED, "omega": SLOW},
    unknowns=RATES,
    right=partial(joint_rates, None),
    wrong=made_in(
        joint_rates, last_joint_only, separate_rates, l_2_for_l_3, times_J, plus_sine, not_derived
    ),
    derive=lambda v_x, v_y, omega, **pose: {
        "J": jacobian(None, **pose),
        "twist": np.array([v_x, v_y, omega]),
    },
    likely_slips={
        "with the transpose where the inverse belongs": lambda v_x, v_y, omega, **numbers: (
            jacobian(None, **numbers).T @ [v_x, v_y, omega]
        ),
    },
    solution=Solution(
        "The determinant of J:\n\n{det}\n\nIt is not zero, so J has an inverse. The joint rates "
        "are this inverse times the hand's velocity; np.linalg.solve finds them.\n\n"
        "By hand, look along link 2. The wrist moves as the hand does, but for the turning of the "
        "last link. So its speed u along link 2 is:\n\n{along}\n\nLink 2 moves the wrist only "
        "across itself. So the elbow must have the same speed along link 2. The first joint alone "
        "moves the elbow, at l_1 θ̇_1 across link 1; the sine of θ_2 gives its part along link 2. "
        "So l_1 θ̇_1 sin θ_2 is u:\n\n{first}\n\nAlong link 1 the wrist is moved by link 2 alone, "
        "which turns with the first two joints:\n\n{second}\n\n"
        "The hand turns with all three joints, so the last one gives what is missing:\n\n{third}",
        answer=(("first", "second", "third"),),
        det=Step(formulas.det, unit="m²", expected=lambda **n: np.linalg.det(jacobian(None, **n))),
        along=Step(LocalEquation(U, formulas.along2, "m/s"), WRITTEN_OUT | BY_TWIST),
        **rate_steps(BY_TWIST)
        | {"first": Step(LocalEquation(rate1, U / (formulas.l1 * sin(theta2))))},
    ),
    example=EXAMPLE | {"v_x": 0.1, "v_y": 0.2, "omega": 0.3},
)

planar_arm_6 = Exercise(
    "planar-arm-6",
    title="How fast at most?",
    text=ARM + "No joint can turn faster than {limit}. The hand must move straight in the "
    "direction {towards} from the x axis and must not turn. How fast can it move in this pose?",
    given=POSE
    | {
        "towards": number_range(0, 350, 10, "°"),
        "limit": one_of(0.5, 1, 1.5, 2, 2.5, 3, unit="rad/s"),
    },
    unknowns=(Unknown("v", "m/s"),),
    right=partial(top_speed, None),
    wrong=made_in(top_speed, last_joint_only, separate_rates, times_J, not_derived),
    likely_slips={
        "when the rates together, as a vector, reach the limit": lambda limit, **numbers: (
            limit / np.linalg.norm(straight_rates(**numbers))
        ),
        "when the slowest joint reaches the limit": lambda limit, **numbers: (
            limit / np.abs(straight_rates(**numbers)).min()
        ),
    },
    solution=Solution(
        "The rates grow in proportion to the speed. So find the rates for 1 m/s first, in the "
        "direction α and without a turn of the hand. Along link 2 the wrist is moved by the first "
        "joint alone, along link 1 by the turning of link 2, and the third joint makes up for "
        "both:\n\n{first}\n\n{second}\n\n{third}\n\n"
        "The fastest of them may be {limit}, and the speed of the hand changes by the same factor:"
        "\n\n{v}",
        **rate_steps(
            {x_dot: cos(TOWARDS), y_dot: sin(TOWARDS), phi_dot: 0, TOWARDS: "towards"},
            check=lambda limit, **numbers: straight_rates(**numbers),
        ),
        v=Step(
            LocalEquation(Symbol("v"), LIMIT / Max(Abs(rate1), Abs(rate2), Abs(rate3)), "m/s"),
            {LIMIT: "limit"},
        ),
    ),
)

planar_arm_7 = Exercise(
    "planar-arm-7",
    title="How well can the hand move?",
    text=ARM + "The manipulability w = √det(J Jᵀ) says how well the hand can move in all "
    "directions. Use the 2×3 matrix J of ẋ and ẏ. How large is w?",
    given=POSE,
    unknowns=(Unknown("w", "m²"),),
    right=lambda **pose: planar_arm.manipulability(**arm(**pose)),
    wrong=made_in(manipulability, separate_rates, l_2_for_l_3, plus_sine),
    likely_slips={
        "without the root": lambda **numbers: manipulability(None, **numbers) ** 2,
        "with all three rows of J": lambda **numbers: abs(np.linalg.det(jacobian(None, **numbers))),
    },
    solution=Solution(
        SHORT_TEXT
        + COLUMNS
        + "Only its first two rows count here. The entries of J Jᵀ are each row times itself, and "
        "one row times the other:\n\n{gram}\n\nThe square root of its determinant:\n\n{root}\n\n"
        "The determinant of J Jᵀ is also the sum of three squares, of the determinants that two "
        "columns of J make. So the same comes out without J:\n\n{shorter}",
        answer=("root",),
        short=SHORT,
        J=JACOBIAN,
        gram=Step(column(formulas.GRAM)),
        root=Step(LocalEquation(formulas.w, ROOT, "m²")),
        shorter=Step(
            formulas.manipulability,
            WRITTEN_OUT,
            unit="m²",
            expected=lambda **pose: planar_arm.manipulability(**arm(**pose)),
        ),
    ),
)


def centre(q1, q2, q3, weights=None, first=0, total=None, **numbers):
    """Return the hand's centre of rotation; the options are slips."""
    places = planar_arm.joint_positions(**arm(**numbers))[first : first + 3]
    rates = np.array([q1, q2, q3]) if weights is None else weights([q1, q2, q3])
    return rates @ places / (rates.sum() if total is None else total)


def singular_values(made, **numbers):
    """Return the half axes of the ellipse: the singular values of the position rows."""
    return np.linalg.svd(jacobian(made, **numbers)[:2], compute_uv=False)


def idle_rates(made, q1, **numbers):
    """Return the rates of joints 2 and 3 that keep P where it is while joint 1 turns."""
    J = jacobian(made, **numbers)[:2]
    return np.linalg.solve(J[:, 1:], -q1 * J[:, 0])


def damped_rate(sigma, lam, v, power=2):
    """Return the damped rate of a single direction."""
    return sigma * v / (sigma**2 + lam**power)


Q_BY = {rate1: "q1", rate2: "q2", rate3: "q3"}
LAMBDA = {formulas.sigma: "sigma", formulas.damping: "lam", formulas.v: "v"}

planar_arm_8 = Exercise(
    "planar-arm-8",
    title="Where does the hand turn?",
    text=ARM + "The joints turn at θ̇_1 = {q1}, θ̇_2 = {q2} and θ̇_3 = {q3}. About which point does "
    "the hand turn at this moment?",
    given=POSE | {"q1": SLOW, "q2": SLOW, "q3": SLOW},
    unknowns=(Unknown("x_c", "m"), Unknown("y_c", "m")),
    right=centre,
    wrong={},
    likely_slips={
        "with the sizes of the rates, without their signs": partial(centre, weights=np.abs),
        "when each weight is at the far end of its link, not at its joint": partial(
            centre, first=1
        ),
        "when the weighted places are added up and not divided by the sum of the rates": partial(
            centre, total=1
        ),
    },
    when=lambda q1, q2, q3, **_: abs(q1 + q2 + q3) > 0.25,
    solution=Solution(
        "Lay each rate as a weight on its joint. The first joint is the origin. The two others "
        "are:\n\n{joints}\n\nThe sum of the weights is how fast the hand turns:\n\n{turn}\n\n"
        "The balance point is the mean of the three places, weighted by the rates:\n\n{centre}",
        answer=("centre",),
        joints=Step(column(formulas.JOINTS), WRITTEN_OUT),
        turn=Step(LocalEquation(phi_dot, formulas.rate123, "rad/s"), Q_BY),
        centre=Step(formulas.hand_centre, Q_BY),
    ),
)

planar_arm_9 = Exercise(
    "planar-arm-9",
    title="A damped rate",
    text="Near a singular pose an arm makes a joint rate u in one direction into a velocity σu, "
    "with σ = {sigma}. The velocity v = {v} is wanted. Damped least squares with λ = {lam} (in m, "
    "as σ) makes (σu − v)² + λ²u² least. Which rate u does it choose?",
    given={
        "sigma": one_of(*(n / 100 for n in range(1, 21)), unit="m"),
        "lam": one_of(0.04, 0.05, 0.06, 0.08, 0.1, 0.12, unit="m"),
        "v": SPEED,
    },
    unknowns=(Unknown("u", "rad/s"),),
    right=damped_rate,
    wrong={},
    likely_slips={
        "without damping": lambda sigma, lam, v: v / sigma,
        "with λ where λ² belongs": partial(damped_rate, power=1),
        "with σ + λ below the line": lambda sigma, lam, v: v / (sigma + lam),
        "with the largest rate that any σ needs": lambda sigma, lam, v: v / (2 * lam),
    },
    when=lambda sigma, lam, v: abs(sigma - lam) > 0.005,
    solution=Solution(
        "Where the sum is least, its derivative by u, 2σ(σu − v) + 2λ²u, is zero:\n\n{u}",
        u=Step(formulas.damped_single, LAMBDA, unit="rad/s"),
    ),
)

planar_arm_10 = Exercise(
    "planar-arm-10",
    title="Fastest and slowest",
    text=ARM + "Take all joint rates whose squares add up to 1 (rad/s)². How fast is the hand's "
    "point at most in its best direction (σ_1), and how fast at most in its worst (σ_2)?",
    given=POSE,
    unknowns=(Unknown("σ_1", "m/s"), Unknown("σ_2", "m/s")),
    right=partial(singular_values, None),
    wrong=made_in(singular_values, separate_rates, l_2_for_l_3, plus_sine),
    likely_slips={
        "when the root of the eigenvalues is forgotten": lambda **numbers: (
            singular_values(None, **numbers) ** 2
        ),
        "with the lengths of the rows of J": lambda **numbers: np.sort(
            np.linalg.norm(jacobian(None, **numbers)[:2], axis=1)
        )[::-1],
    },
    solution=Solution(
        SHORT_TEXT
        + COLUMNS
        + "Only the first two rows count. The squares of the half axes are the eigenvalues of "
        "J Jᵀ, whose entries are:\n\n{gram}\n\nThe larger half axis:\n\n{large}\n\nThe product of "
        "both is the manipulability:\n\n{w}\n\nSo the smaller one is:\n\n{small}",
        answer=(("large", "small"),),
        short=SHORT,
        J=JACOBIAN,
        gram=Step(column(formulas.GRAM)),
        large=Step(formulas.ellipse, part=(0,)),
        w=Step(
            formulas.manipulability,
            WRITTEN_OUT,
            unit="m²",
            expected=lambda **pose: planar_arm.manipulability(**arm(**pose)),
        ),
        small=Step(formulas.ellipse, part=(1,)),
    ),
)

planar_arm_11 = Exercise(
    "planar-arm-11",
    title="Move, but stay",
    text=ARM + "The hand's point must stay where it is; the hand may turn. Joint 1 turns at "
    "θ̇_1 = {q1}. How fast must joints 2 and 3 turn?",
    given=POSE | {"q1": SLOW},
    unknowns=RATES[1:],
    right=partial(idle_rates, None),
    wrong=made_in(idle_rates, separate_rates, l_2_for_l_3, plus_sine),
    likely_slips={
        "with the sign of joint 1 turned round": lambda q1, **numbers: (
            -idle_rates(None, q1, **numbers)
        ),
    },
    when=lambda theta3, **_: abs(np.sin(theta3)) > 0.3,
    solution=Solution(
        "Two rows and three rates leave one combination that moves nothing: the null space of the "
        "two rows. Look along link 3: joint 3 moves the point only across it. So there the two "
        "others must undo each other:\n\n{second}\n\nLook along the lever of joint 2, from the "
        "elbow to the point: there joints 1 and 3 must undo each other:\n\n{third}",
        answer=(("second", "third"),),
        second=Step(
            LocalEquation(
                rate2,
                -rate1
                * (formulas.l1 * formulas.s23 + formulas.l2 * formulas.s3)
                / (formulas.l2 * formulas.s3),
            ),
            WRITTEN_OUT | {rate1: "q1"},
        ),
        third=Step(
            LocalEquation(
                rate3,
                rate1
                * formulas.l1
                * (formulas.l2 * formulas.s2 + formulas.l3 * formulas.s23)
                / (formulas.l2 * formulas.l3 * formulas.s3),
            ),
            WRITTEN_OUT | {rate1: "q1"},
        ),
    ),
)
