"""Exercises on the constraints of wheels and on omni robots, and the mistakes made there."""
# ruff: noqa: E741  (l is the field's own name)

from functools import partial

import numpy as np
from sympy import Add, Integer, Matrix, Symbol, atan, atan2, cos, pi, sin, symbols, tan

from book.differential_drive import formulas as drive
from book.motion import formulas as planar
from book.wheels import formulas
from courseware.answers import Unknown, angle, integer
from courseware.equations import as_written
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
from robokin import bicycle, motion, wheels

BY_PLACE = {formulas.l: "l", formulas.alpha: "alpha", formulas.beta: "beta"}
BY_ALPHA = {formulas.l: "l", formulas.alpha: "alpha"}
ROW, SPEEDS, RATES, ALPHAS = (
    symbols(names) for names in ("j_1:4", "s_1:5", r"\dot\varphi_1:5", "alpha_1:4")
)
P_X, P_Y, D_X, D_Y, S, GROUND, SLIP = symbols("p_x p_y d_x d_y s u slip")
BETA_2, RATE_2, MATRIX = Symbol("β_other"), Symbol(r"\dot\varphi_\mathrm{other}"), Symbol("J_1")


def row(alpha=formulas.alpha, beta=formulas.beta):
    """Return the rolling row of a wheel, as its formula has it."""
    return formulas.rolling_row(formulas.l, alpha, beta)


with as_written():
    ROLLS, ASIDE, TURNS = row()
    ONE_ROW = LocalEquation(Matrix(ROW), Matrix([ROLLS, ASIDE, TURNS]), ("", "", "m"))

plus_sign = Mistake(
    "M19",
    feedback="with +cos(α + β) in the rolling row, where a minus belongs",
    formula=WrongFormula(ONE_ROW, instead=Matrix([ROLLS, -ASIDE, TURNS])),
    line="J1 = np.transpose([np.sin(alpha), np.cos(alpha), [-l, -l, -l]])",
    why="The wheel rolls towards α + β − 90°. The cosine and the sine of this direction are "
    "sin(α + β) and −cos(α + β). Without the minus, the row belongs to another direction.",
    unnoticed="When the robot does not move sideways, or when cos(α + β) is 0, as for the two "
    "wheels of a differential drive.",
    title="It moves to the wrong side",
    picture=(
        "The robot moves to one side of its heading. Its program believes that it moves to the "
        "other side."
    ),
    document="002",
    place="the proof of the rolling constraint, V_2",
    nth=1,
    quote="V_2 = ẏ cos(α + β)",
    correction="V_2 = «−»ẏ cos(α + β)",
)
heading_for_beta = Mistake(
    "M20",
    feedback="with the robot's heading θ in the last entry of the rolling row, where β belongs",
    formula=WrongFormula(
        ONE_ROW, instead=Matrix([ROLLS, ASIDE, TURNS.subs(formulas.beta, planar.theta)])
    ),
    line="turning = [-l * np.cos(theta)] * 3\n"
    "J1 = np.transpose([np.sin(alpha), -np.cos(alpha), turning])",
    why="The row belongs to the robot's own frame. It depends on where the wheel is on the "
    "robot, not on where the robot looks.",
    unnoticed="With θ = β or θ = −β (here: θ = 0), or when the robot does not turn.",
    title="Its turning rate varies",
    picture="The robot has turned by another angle than its program believes.",
    document="002",
    place="the end of the same proof",
    nth=3,
    quote="[sin(α + β), −cos(α + β), −L cos θ]",
    correction="[sin(α + β), −cos(α + β), −L cos «β»]",
    explanation="θ is the robot's heading. The row belongs to the robot's own frame: it depends on "
    "where the wheel is on the robot, not on where the robot looks.",
)
turned_back = Mistake(
    "M21",
    feedback="when the velocity is turned the wrong way between the robot and the world",
    formula=WrongFormula(planar.to_world, {planar.theta: -planar.theta}),
    line="velocity = R @ np.linalg.solve(J1, r * rates)",
    why="Here R(θ) leads from the world to the robot. Back to the world it is R(θ)⁻¹, the "
    "transposed matrix. Other books use R(θ) for the other direction.",
    unnoticed="With a heading of 0 or 180°, and when the robot turns on the spot.",
    title="Its direction varies",
    picture="The robot drives in another direction than its program believes.",
)
plus_l_cos = Mistake(
    "M34",
    feedback="with +l cos β in the last entry of the rolling row, where a minus belongs",
    formula=WrongFormula(ONE_ROW, {formulas.l: -formulas.l}),
    line="J1 = np.transpose([np.sin(alpha), -np.cos(alpha), [l, l, l]])",
    why="With β = 0 the wheel rolls clockwise around the robot's centre, and a positive θ̇ is "
    "counter-clockwise. So it makes the wheel roll backwards.",
    unnoticed="When the robot does not turn, or with β = ±90°.",
    title="It turns the other way",
    picture="The robot turns to the left. Its program believes that it turns to the right.",
    document="002",
    place="the proof of the rolling constraint, V_3",
    nth=2,
    quote="V_3 = θ̇ L cos β",
    correction="V_3 = «−»θ̇ L cos β",
)
cos_alpha = Mistake(
    "M35",
    feedback="with cos α in the last entry of the rolling row, where cos β belongs",
    formula=WrongFormula(
        ONE_ROW, instead=Matrix([ROLLS, ASIDE, TURNS.subs(formulas.beta, formulas.alpha)])
    ),
    line="J1 = np.transpose([np.sin(alpha), -np.cos(alpha), -l * np.cos(alpha)])",
    why="When the robot turns, a wheel whose axle points to the centre rolls with its whole speed, "
    "wherever it is. With cos α the last column is l times the second one: J_1 is singular.",
    unnoticed="For a wheel with α = ±β, or when the robot does not turn.",
    title="It does not turn",
    picture=(
        "The robot drives straight on and does not turn. Its program believes that it turns to "
        "the right."
    ),
    document="002",
    place="the matrix J_1",
    nth=4,
    quote="J_1 = [sin α_i, −cos α_i, −L cos α_i] (i = 1, 2, 3)",
    correction="J_1 = [sin α_i, −cos α_i, «−L»] (β = 0)",
    explanation="When the robot turns, a wheel whose axle points to the centre rolls with its "
    "whole speed, wherever it is. The next line of the document has the numbers of the "
    "right matrix.",
)

THREE = np.radians([0, 120, 240])
FOUR = np.radians([0, 90, 180, 270])

PARALLEL = "two fixed wheels on two parallel axles"
TWO_AXLES = " The two parallel axles are not in one line; one wheel is on each."
FIXED = {
    "no fixed wheels": [],
    "one fixed wheel": [wheels.fixed(0.2, np.pi / 2, 0, 0.05)],
    "two fixed wheels on one axle line": [
        wheels.fixed(0.2, np.pi / 2, 0, 0.05),
        wheels.fixed(0.2, -np.pi / 2, np.pi, 0.05),
    ],
    PARALLEL: [
        wheels.fixed(0.2, 0, np.pi / 2, 0.05),
        wheels.fixed(0.2, np.pi, -np.pi / 2, 0.05),
    ],
    "two fixed wheels whose axle lines cross": [
        wheels.fixed(0.2, np.pi / 2, 0, 0.05),
        wheels.fixed(0.2, 0, 0, 0.05),
    ],
}
STEERED = {
    f"{word} steered wheel{'s' * (count != 1)}": [
        wheels.steered(0.3, 0.5 + k, 0, 0.05) for k in range(count)
    ]
    for count, word in enumerate(["no", "one", "two", "three"])
}
FREE = {
    "two castors": [wheels.castor(0.3, a, 0, 0.03, -0.02) for a in (2.5, -2.5)],
    "three castors": [wheels.castor(0.3, a, 0, 0.03, -0.02) for a in THREE],
    "two balls": [wheels.spherical(0.3, a, 0.03) for a in (2.5, -2.5)],
    "three balls": [wheels.spherical(0.3, a, 0.03) for a in THREE],
    "two omni wheels": wheels.omni_robot(0.3, 0.03, [2.5, -2.5]),
    "three omni wheels": wheels.omni_robot(0.3, 0.03),
}


def rows(l, alpha, beta):
    """Return the rolling rows of wheels at the angles alpha and beta, numbers or (n,): (n, 3)."""
    angles = np.atleast_1d(*np.broadcast_arrays(alpha, beta))
    return wheels.rolling([wheels.fixed(l, a, b, 1.0) for a, b in zip(*angles, strict=True)])


def wrong_rows(mistake, l, alpha, beta, theta):
    """Return the rolling rows by a mistake."""
    angles = np.atleast_1d(*np.broadcast_arrays(alpha, beta))
    gives = partial(mistake.formula.evaluate, wheel_l=l, theta=theta)
    made = [gives(wheel_alpha=a, wheel_beta=b) for a, b in zip(*angles, strict=True)]
    return np.squeeze(made, axis=2)


def ways(formula, *mistakes, **places):
    """Return formula(rows, **numbers) by each mistake in the rolling rows.

    places: alpha and beta, where the exercise does not draw them; or functions of its numbers.
    """

    def made(mistake):
        def wrong(**numbers):
            told = {name: p(**numbers) if callable(p) else p for name, p in places.items()}
            known = {"theta": 0.0, **numbers, **told}
            place = {name: known[name] for name in ("l", "alpha", "beta", "theta")}
            return formula(wrong_rows(mistake, **place), **numbers)

        return wrong

    return {mistake: made(mistake) for mistake in mistakes}


def turned_too(wrong):
    """Return formulas of mistakes in the rows as those have them who also make M21."""
    return {
        (mistake, turned_back): turned_back.formula.wrap(formula)
        for mistake, formula in wrong.items()
    }


def itself(matrix, **_):
    """Return the rows, where these are asked for."""
    return matrix


def three(first, **_):
    """Return the angles of three wheels from the first one on."""
    return first + THREE


def rates(l, r, theta, x_dot, y_dot, omega):
    """Return the rates of the three wheels for a velocity in the world."""
    return wheels.inverse(wheels.omni_robot(l, r), [x_dot, y_dot, omega], theta=theta)


def rates_by(matrix, r, theta, x_dot, y_dot, omega, **_):
    """Return the same by given rows."""
    return matrix @ motion.to_body(theta, [x_dot, y_dot, omega]) / r


def forward(l, r, theta, w_1, w_2, w_3):
    """Return the velocity in the world from the rates of the three wheels."""
    return wheels.forward(wheels.omni_robot(l, r), [w_1, w_2, w_3], theta=theta)


def forward_by(matrix, r, theta, w_1, w_2, w_3, **_):
    """Return the same by given rows."""
    return motion.to_world(theta, np.linalg.solve(matrix, r * np.array([w_1, w_2, w_3])))


def built(fixed, steered, free):
    """Return a robot from the names of its wheels."""
    return FIXED[fixed] + STEERED[steered] + FREE[free]


def degrees(delta_m, delta_s):
    """Return mobility, steerability and their sum, the manoeuvrability."""
    return [delta_m, delta_s, delta_m + delta_s]


def turned_so(fixed, steered):
    """Return how the steered wheels are turned, if there are any."""
    count = len(STEERED[steered])
    if not count:
        return ""
    who, where = ("wheels are", "none of them is") if count > 1 else ("wheel is", "it is not")
    apart = f"; {where} on the axle line of a fixed wheel" if FIXED[fixed] else ""
    return f" The steered {who} turned so that the robot can always move{apart}."


def instructive(fixed, steered, free):
    """Whether a robot has a usual size, and at most one steered wheel without a choice."""
    robot = built(fixed, steered, free)
    without_choice = len(STEERED[steered]) - wheels.mobility(robot).delta_s
    return 3 <= len(robot) <= 6 and without_choice <= 1


def turn_about(p_x, p_y, omega, **_):
    """Return the velocity of a robot that turns about a point of its own frame."""
    return np.multiply(omega, [p_y, -p_x, 1])


def aimed(l, alpha, p_x, p_y, **_):
    """Return the two steering angles with which a wheel's axle points along the line to a point."""
    beta = np.arctan2(p_y - l * np.sin(alpha), p_x - l * np.cos(alpha)) - alpha
    return motion.wrap_angle([beta, beta + np.pi])


def about(l, alpha, r, **turn):
    """Return both pairs of steering angle and rate for a turn about a point."""
    twist = turn_about(**turn)
    return [
        [beta, wheels.inverse([wheels.steered(l, alpha, beta, r)], twist)[0]]
        for beta in aimed(l, alpha, **turn)
    ]


def about_by(matrix, r, **numbers):
    """Return the same by given rows."""
    return np.transpose([aimed(**numbers), matrix @ turn_about(**numbers) / r])


def four(l, r, w_1, w_2, w_3, w_4):
    """Return the best velocity of a robot with four wheels, and the slip of the first one."""
    robot, given = wheels.omni_robot(l, r, FOUR), [w_1, w_2, w_3, w_4]
    return [*wheels.forward(robot, given), wheels.slip(robot, given)[0]]


def four_by(matrix, r, w_1, w_2, w_3, w_4, **_):
    """Return the same by given rows."""
    speeds = r * np.array([w_1, w_2, w_3, w_4])
    twist = np.linalg.pinv(matrix) @ speeds
    return [*twist, (matrix @ twist - speeds)[0]]


def held_by(fixed):
    """Return how many ways to move the fixed wheels take away."""
    return 3 - wheels.mobility(FIXED[fixed]).delta_m


def sliding_rank(fixed, **_):
    """Return how many sliding rows of the fixed wheels are independent."""
    return LocalEquation(formulas.rank_fixed, Integer(held_by(fixed)))


def steered_rank(steered, **_):
    """Return the same for the steered wheels: up to three of them are turned freely."""
    return LocalEquation(formulas.rank_steered, Integer(len(STEERED[steered])))


with as_written():
    ANGLES = LocalEquation(
        Matrix(ALPHAS),
        Matrix([formulas.alpha, formulas.alpha + 2 * pi / 3, formulas.alpha + 4 * pi / 3]),
        "rad",
    )
    THREE_ROWS = LocalEquation(MATRIX, Matrix([row(alpha) for alpha in ALPHAS]))
    ROLLED = LocalEquation(Matrix(SPEEDS), Matrix([drive.r * rate for rate in RATES]), "m/s")
    THREE_RATES = LocalEquation(
        Matrix(formulas.omni_rates), Matrix([s / drive.r for s in SPEEDS[:3]])
    )
    ABOUT = LocalEquation(
        Matrix([planar.v, planar.v_y]), Matrix([planar.omega * P_Y, -planar.omega * P_X])
    )
    TO_POINT = LocalEquation(
        Matrix([D_X, D_Y]),
        Matrix(
            [
                P_X - formulas.l * cos(formulas.alpha),
                P_Y - formulas.l * sin(formulas.alpha),
            ]
        ),
        "m",
    )
    AIMED = LocalEquation(formulas.beta, atan2(D_Y, D_X) - formulas.alpha)
    ONE_RATE = LocalEquation(formulas.rate, S / drive.r)
    OTHER_ANGLE = LocalEquation(BETA_2, formulas.beta + pi, "rad")
    OTHER_RATE = LocalEquation(RATE_2, -formulas.rate, "rad/s")
    BEST = LocalEquation(
        Matrix([planar.v, planar.v_y, planar.omega]),
        Matrix(
            [
                (SPEEDS[1] - SPEEDS[3]) / 2,
                (SPEEDS[2] - SPEEDS[0]) / 2,
                -Add(*SPEEDS) / (4 * formulas.l),
            ]
        ),
        ("m/s", "m/s", "rad/s"),
    )
    SLIPPED = LocalEquation(SLIP, GROUND - SPEEDS[0], "m/s")
FOUR_ROWS = LocalEquation(MATRIX, Matrix([row(k * pi / 2, 0) for k in range(4)]))  # ones and zeros


# What several exercises say
SPOKE = (
    "at the end of a spoke, the line from the robot's centre to the wheel. The spoke is l = {l} "
    "long, at the angle α = {alpha} from the robot's x axis. "
)
AXLES = (
    "Each axle points along the spoke, the line from the centre to the wheel (β = 0). The rollers "
    "leave each wheel free to slide along its axle (γ = 0). "
)
THREE_WHEELS = (
    "An omni robot has three wheels of radius {r}, each {l} from the centre. They are at 0°, "
    "120° and 240° from the robot's x axis, counter-clockwise. " + AXLES
)
TO_THE_RIGHT = (
    "Seen from above and from the centre outwards, a positive rate rolls a wheel to the right of "
    "its spoke."
)
BY_DIRECTION = "With a positive rate φ̇ the wheel rolls in the direction α + β − 90°. "
COMPONENTS = "v is along the robot's x axis, v_y along its y axis, and ω is its turning rate"
VELOCITIES = (
    "The robot's velocity in the world is ξ̇_I = [ẋ, ẏ, θ̇]. R(θ) leads from the world to the "
    "robot: R(θ) ξ̇_I = [v, v_y, ω] is the same velocity, seen from the robot. "
    f"{COMPONENTS}. "
)


L, R = number_range(10, 40, 5, "cm"), number_range(3, 8, 1, "cm")
THETA = number_range(20, 160, 10, "°")
RATE = one_of(*(n for n in range(-12, 13) if n), unit="rad/s")
SPEED = one_of(*(n / 10 for n in range(-6, 7) if n), unit="m/s")
TURN = one_of(*(n / 4 for n in range(-6, 7) if n), unit="rad/s")

wheels_1 = Exercise(
    "wheels-1",
    title="The rolling row of a wheel",
    text="A fixed wheel is "
    + SPOKE
    + "From the spoke to the wheel's axle the angle is β = {beta}. "
    + BY_DIRECTION
    + "The robot's heading θ is {theta}.\n\n"
    + VELOCITIES
    + "The rolling constraint says: a row of three numbers times R(θ) ξ̇_I is r φ̇, the speed at "
    "which the wheel rolls. Which three numbers are in this row?",
    given={
        "l": L,
        "alpha": number_range(-150, 165, 15, "°"),
        "beta": number_range(-75, 75, 15, "°"),
        "theta": THETA,
    },
    unknowns=(Unknown("number for v"), Unknown("number for v_y"), Unknown("number for ω", "m")),
    right=lambda l, alpha, beta, theta: rows(l, alpha, beta),
    wrong=ways(itself, plus_sign, heading_for_beta, plus_l_cos, cos_alpha),
    likely_slips={
        "for the sliding row": lambda l, alpha, beta, theta: wheels.sliding(
            [wheels.fixed(l, alpha, beta, 1.0)]
        ),
    },
    solution=Solution(
        "The axle points in the direction α + β, seen from the robot, and the wheel rolls at right "
        "angles to it. The first two numbers are this rolling direction. The third is how far a "
        "turn of the robot moves the wheel along it. The heading θ is not in the row, it is in "
        "R(θ). So the row [j_1, j_2, j_3] is\n\n{row}",
        row=Step(ONE_ROW, BY_PLACE),
    ),
)

wheels_2 = Exercise(
    "wheels-2",
    title="The matrix of an omni robot",
    text="An omni robot has three wheels, each {l} from the centre. The first is at "
    "α = {first} from the robot's x axis, the others 120° and 240° further, counter-clockwise. "
    + AXLES
    + TO_THE_RIGHT
    + " The robot's heading θ is {theta}.\n\n"
    + VELOCITIES
    + "J_1 times R(θ) ξ̇_I gives the speeds r φ̇ of the three wheels. What is the matrix J_1?",
    given={"l": L, "first": number_range(-90, 105, 15, "°"), "theta": THETA},
    unknowns=tuple(
        Unknown(f"J1[{i}, {j}]", "m" if j == 2 else "") for i in range(3) for j in range(3)
    ),
    shape=(3, 3),
    right=lambda l, first, theta: wheels.rolling(wheels.omni_robot(l, 1.0, three(first))),
    wrong=ways(itself, plus_sign, heading_for_beta, plus_l_cos, cos_alpha, alpha=three, beta=0.0),
    derive=lambda l, first, theta: {"alpha": three(first)},
    solution=Solution(
        "The wheels are at\n\n{angles}\n\nIn degrees this is {angles.value:deg}. Each wheel has "
        "a row of its own. As the axles point along the spokes and the rollers lie across, only α "
        "and l are in it. The robot's heading is in R(θ) only:\n\n{matrix.formula}\n\n"
        "With the numbers this is\n\n{matrix.value}",
        angles=Step(ANGLES, {formulas.alpha: "first"}),
        matrix=Step(THREE_ROWS, {formulas.l: "l", formulas.beta: 0}),
    ),
    example={"l": 0.2, "first": 0.0, "theta": np.pi / 6},
)

wheels_3 = Exercise(
    "wheels-3",
    title="How fast must the wheels turn?",
    text=THREE_WHEELS
    + TO_THE_RIGHT
    + " The robot's heading θ is {theta}. In the world it must move at {x_dot} along x and {y_dot} "
    "along y, and turn at {omega} (counter-clockwise positive). At which rates must the three "
    "wheels turn?",
    given={"l": L, "r": R, "theta": THETA, "x_dot": SPEED, "y_dot": SPEED, "omega": TURN},
    unknowns=(Unknown("φ̇_1", "rad/s"), Unknown("φ̇_2", "rad/s"), Unknown("φ̇_3", "rad/s")),
    right=rates,
    wrong={
        **ways(rates_by, plus_sign, heading_for_beta, plus_l_cos, cos_alpha, alpha=THREE, beta=0.0),
        turned_back: turned_back.formula.wrap(rates),
    },
    together=turned_too(
        ways(rates_by, plus_sign, heading_for_beta, plus_l_cos, cos_alpha, alpha=THREE, beta=0.0)
    ),
    likely_slips={
        "for the speeds of the wheels; the division by r is missing": lambda **numbers: (
            numbers["r"] * rates(**numbers)
        ),
        "when the heading is left out": lambda theta, **numbers: rates(theta=0.0, **numbers),
    },
    solution=Solution(
        "First see the wanted velocity from the robot:\n\n{body}\n\n"
        "The turning rate is the same, seen from both. The row of each wheel times this velocity "
        "is the speed s at which the wheel must roll:\n\n{speeds}\n\n"
        "Divide by the radius:\n\n{rates}",
        body=Step(planar.to_body, part=(0, 1)),
        speeds=Step(formulas.omni_rolling, {formulas.l: "l"}, values=SPEEDS[:3], unit="m/s"),
        rates=Step(THREE_RATES),
    ),
)

wheels_4 = Exercise(
    "wheels-4",
    title="Where does the omni robot go?",
    text=THREE_WHEELS
    + TO_THE_RIGHT
    + " The robot's heading θ is {theta}. The wheels turn at {w_1}, {w_2} and {w_3}. What is the "
    "robot's velocity in the world: along x, along y, and its turning rate?",
    given={"l": L, "r": R, "theta": THETA, "w_1": RATE, "w_2": RATE, "w_3": RATE},
    unknowns=(Unknown("ẋ", "m/s"), Unknown("ẏ", "m/s"), Unknown("θ̇", "rad/s")),
    right=forward,
    wrong={
        **ways(forward_by, plus_sign, heading_for_beta, plus_l_cos, alpha=THREE, beta=0.0),
        turned_back: turned_back.formula.wrap(forward),
    },
    together=turned_too(
        ways(forward_by, plus_sign, heading_for_beta, plus_l_cos, alpha=THREE, beta=0.0)
    ),
    when=lambda theta, w_1, w_2, w_3, **_: abs(np.cos(theta)) > 0.1 and w_1 + w_2 + w_3 != 0,
    derive=lambda l, r, theta, w_1, w_2, w_3: {
        "rates": np.array([w_1, w_2, w_3]),
        "J1": wheels.rolling(wheels.omni_robot(l, r)),
        "R": np.array(
            [[np.cos(theta), np.sin(theta), 0], [-np.sin(theta), np.cos(theta), 0], [0, 0, 1]]
        ),
    },
    likely_slips={
        "without the radius of the wheels": lambda r, **numbers: forward(r=1.0, **numbers),
        "as the robot sees it; asked is the world": lambda theta, **numbers: forward(
            theta=0.0, **numbers
        ),
    },
    solution=Solution(
        "The rolling rows of the three wheels say how fast each wheel rolls when the robot moves. "
        "Solved for the robot's own velocity, they say how it moves when the wheels roll:\n\n"
        "{body}\n\nFrom the robot to the world it is a turn by the heading:\n\n{world}",
        body=Step(
            formulas.omni_twist,
            {formulas.l: "l"} | {rate: f"w_{k}" for k, rate in enumerate(formulas.omni_rates, 1)},
        ),
        world=Step(planar.to_world),
    ),
    example={"l": 0.2, "r": 0.05, "theta": np.pi / 6, "w_1": 2.0, "w_2": 4.0, "w_3": -3.0},
)

wheels_5 = Exercise(
    "wheels-5",
    title="In how many ways can it move?",
    text="A robot has {fixed}, {steered} and {free}.{axles}{turned} What are the robot's "
    "degrees of mobility δ_m, of steerability δ_s and of manoeuvrability δ_M?",
    given={"fixed": one_of(*FIXED), "steered": one_of(*STEERED), "free": one_of(*FREE)},
    unknowns=(integer("δ_m"), integer("δ_s"), integer("δ_M")),
    right=lambda fixed, steered, free: wheels.mobility(built(fixed, steered, free)),
    wrong={},
    when=instructive,
    derive=lambda fixed, steered, free: {
        "axles": TWO_AXLES if fixed == PARALLEL else "",
        "turned": turned_so(fixed, steered),
    },
    likely_slips={
        "when the steered wheels forbid nothing": lambda fixed, steered, free: degrees(
            3 - held_by(fixed),
            wheels.mobility(built(fixed, steered, free)).delta_s,
        ),
        "when every steered wheel counts, also one without a choice": lambda **names: degrees(
            wheels.mobility(built(**names)).delta_m, len(STEERED[names["steered"]])
        ),
        "when δ_M is the number of motions at once, without the steering": lambda **names: [
            *wheels.mobility(built(**names))[:2],
            wheels.mobility(built(**names)).delta_m,
        ],
    },
    solution=Solution(
        "Only fixed and steered wheels hold the robot back; castors, balls and omni wheels do not. "
        "The sliding rows of the fixed wheels have the rank {fixed_rank.value}: wheels on one axle "
        "line count once. The robot has {steered}, so the rank of their rows, turned as one likes, "
        "is {steered_rank.value}.\n\n"
        "The axle lines of all fixed and steered wheels must meet in one point (parallel lines: "
        "infinitely far away). Two lines determine this point. The fixed wheels give some of these "
        "lines already. A steered wheel can be turned freely for each line that is left; any "
        "others must follow:\n\n{delta_s}\n\nEach independent row of the fixed wheels and each "
        "free choice takes away one of the three ways to move:\n\n{delta_m}\n\n"
        "The third number is the sum of both:\n\n{delta_M}",
        answer=(("delta_m", "delta_s", "delta_M"),),
        fixed_rank=Step(sliding_rank),
        steered_rank=Step(steered_rank),
        delta_s=Step(formulas.mobility, part=(0,)),
        delta_m=Step(formulas.mobility, part=(1,)),
        delta_M=Step(formulas.mobility, part=(2,)),
    ),
)

wheels_6 = Exercise(
    "wheels-6",
    title="Turn about that point",
    text="A steered wheel of radius {r} is "
    + SPOKE
    + "Its steering angle β is the angle from the spoke to its axle. "
    + BY_DIRECTION
    + "The robot must turn at {omega} (counter-clockwise positive) about the point x = {p_x}, "
    "y = {p_y} of the robot's frame. What must β be, and at which rate φ̇ must the wheel turn? "
    "There are two answers; give one of them.",
    given={
        "r": R,
        "l": L,
        "alpha": number_range(-150, 180, 15, "°"),
        "omega": TURN,
        "p_x": number_range(-1, 1, 0.25, "m"),
        "p_y": number_range(-1, 1, 0.25, "m"),
    },
    unknowns=(angle("β"), Unknown("φ̇", "rad/s")),
    accept="any",
    right=about,
    wrong=ways(about_by, plus_sign, plus_l_cos, cos_alpha, beta=aimed),
    when=lambda p_x, p_y, **_: np.hypot(p_x, p_y) > 0.6,
    solution=Solution(
        "The axle must point to the centre of rotation. From the wheel to that point it is\n\n"
        "{to_point}\n\nThe axle has the direction α + β, so the steering angle is\n\n{beta}\n\n"
        "The robot's centre moves around the same point:\n\n{centre}\n\nThe rolling row of the "
        "wheel times the robot's velocity is the speed at which it rolls:\n\n{speed}\n\n{rate}"
        "\n\nOr the axle points the other way, half a turn more, and the wheel rolls backward:"
        "\n\n{beta_2}\n\n{rate_2}\n\nWhole turns more or less are the same angle. So [β, φ̇] is "
        "{right}.",
        answer=(("beta", "rate"), ("beta_2", "rate_2")),
        to_point=Step(TO_POINT, BY_PLACE),
        beta=Step(AIMED, BY_ALPHA),
        centre=Step(ABOUT),
        speed=Step(formulas.rolling, BY_ALPHA, values=(S,), unit="m/s"),
        rate=Step(ONE_RATE),
        beta_2=Step(OTHER_ANGLE),
        rate_2=Step(OTHER_RATE),
    ),
)

wheels_7 = Exercise(
    "wheels-7",
    title="One wheel too many",
    text="An omni robot has four wheels of radius {r}, each {l} from the centre. They are at 0°, "
    "90°, 180° and 270° from the robot's x axis, counter-clockwise. "
    + AXLES
    + TO_THE_RIGHT
    + " The wheels turn at {w_1}, {w_2}, {w_3} and {w_4}, and no motion of the robot fits all four "
    "rates. Which velocity [v, v_y, ω], seen from the robot, fits best (least squares)? "
    f"{COMPONENTS}.\n\n"
    "And what is then the slip of the first wheel? The slip is the wheel's rolling row times "
    "[v, v_y, ω], minus r φ̇_1: the speed at which the ground passes under the wheel, minus the "
    "speed at which the wheel rolls.",
    given={"r": R, "l": L, "w_1": RATE, "w_2": RATE, "w_3": RATE, "w_4": RATE},
    unknowns=(
        Unknown("v", "m/s"),
        Unknown("v_y", "m/s"),
        Unknown("ω", "rad/s"),
        Unknown("slip", "m/s"),
    ),
    right=four,
    wrong=ways(four_by, plus_sign, plus_l_cos, cos_alpha, alpha=FOUR, beta=0.0),
    when=lambda w_1, w_2, w_3, w_4, **_: (
        w_1 + w_3 != w_2 + w_4 and w_1 + w_2 + w_3 + w_4 != 0 and w_1 != w_3 and w_2 != w_4
    ),
    likely_slips={
        "when the slip has the other sign": lambda **numbers: np.multiply(
            four(**numbers), [1, 1, 1, -1]
        ),
    },
    solution=Solution(
        "The wheels roll at these speeds:\n\n{rolled}\n\nThe rows of J_1 are {rows.value}. Its "
        "columns are at right angles to each other, so least squares is a mean for each of them:"
        "\n\n{best}\n\nThe row of the first wheel says how fast the ground passes under it:"
        "\n\n{ground}\n\nThe difference to the speed at which it rolls is the slip:\n\n{slip}",
        answer=(("best", "slip"),),
        rolled=Step(ROLLED, {rate: f"w_{k}" for k, rate in enumerate(RATES, 1)}),
        rows=Step(
            FOUR_ROWS,
            {formulas.l: "l"},
            expected=lambda l, **_: wheels.rolling(wheels.omni_robot(l, 1.0, FOUR)),
        ),
        best=Step(BEST, {formulas.l: "l"}),
        ground=Step(
            formulas.rolling,
            {formulas.l: "l", formulas.alpha: 0, formulas.beta: 0},
            values=(GROUND,),
            unit="m/s",
        ),
        slip=Step(SLIPPED),
    ),
)


def castor_rate(l, alpha, beta, behind, v, v_y, omega):
    """Return how fast a castor swivels that trails so far behind its pivot."""
    contact = l * np.exp(1j * alpha) + 1j * behind * np.exp(1j * (alpha + beta))
    spoke = np.angle(contact)
    as_fixed = wheels.fixed(abs(contact), spoke, alpha + beta - spoke, 1.0)
    return (wheels.sliding([as_fixed]) @ [v, v_y, omega])[0] / behind


def resting_rollers(l, alpha, beta, p_x, p_y, axis=None):
    """Return the roller angle whose line through the hub leads to a point, from some axis."""
    to_point = np.arctan2(p_y - l * np.sin(alpha), p_x - l * np.cos(alpha))
    line = to_point - (alpha + beta - np.pi / 2 if axis is None else axis)
    return (line + np.pi / 2) % np.pi - np.pi / 2


def other_wheel(L, b, left):
    """Return the angle of the right front wheel that goes with that of the left one."""
    middle = np.arctan(1 / (1 / np.tan(left) + b / (2 * L)))
    return bicycle.ackermann(middle, L, b)[1]


DRAWN = {  # the places of the fixed wheels, and of the steered ones
    "fixed wheels at A and B, and a steered wheel at C": ("AB", "C"),
    "fixed wheels at A and E, and balls at B and D": ("AE", ""),
    "a fixed wheel at A, and steered wheels at C and D": ("A", "CD"),
    "a fixed wheel at A, and castors at B, C and D": ("A", ""),
    "steered wheels at C and D, and balls at A and B": ("", "CD"),
    "a steered wheel at C, and castors at A, B and D": ("", "C"),
    "fixed wheels at A and B, and castors at C and D": ("AB", ""),
    "steered wheels at A, B and C": ("", "ABC"),
}
PLACES = {"A": (0, 1), "B": (0, -1), "C": (1, 0), "D": (-1, 0), "E": (1, 1)}


def drawn_wheels(drawn, x, y):
    """Return the fixed and the steered wheels of a drawn robot; all roll along x."""
    made = []
    for make, letters in zip((wheels.fixed, wheels.steered), DRAWN[drawn], strict=True):
        for ahead, left in (np.multiply(PLACES[letter], (x, y)) for letter in letters):
            spoke = np.arctan2(left, ahead)
            made.append(make(np.hypot(ahead, left), spoke, np.pi / 2 - spoke, 0.05))
    return made


def drawn_mobility(**robot):
    """Return the three degrees of a drawn robot."""
    return wheels.mobility(drawn_wheels(**robot))


def each_counted(drawn, **_):
    """Return the degrees as one has them who lets every fixed wheel take a way of its own."""
    fixed, steered = map(len, DRAWN[drawn])
    choices = max(0, min(steered, 2 - fixed))
    return degrees(max(0, 3 - fixed - choices), choices)


def drawn_ranks(**robot):
    """Return the ranks of the rows of the fixed wheels and of the steered ones."""
    made = drawn_wheels(**robot)
    fixed = [wheel for wheel in made if wheel.kind == "fixed"]
    ranks = 3 - wheels.mobility(fixed).delta_m, len(made) - len(fixed)
    return LocalEquation(Matrix([formulas.rank_fixed, formulas.rank_steered]), Matrix(ranks))


with as_written():
    LINE, HALF_TURNS, LEFT, RIGHT, LONG, TRACK = symbols(r"\lambda n delta_L delta_R L b")
    TO_ROLLERS = LocalEquation(LINE, atan2(D_Y, D_X), "rad")
    ROLLERS = LocalEquation(
        formulas.gamma, LINE - (formulas.alpha + formulas.beta - pi / 2) + HALF_TURNS, "rad"
    )
    OTHER_WHEEL = LocalEquation(RIGHT, atan(1 / (1 / tan(LEFT) + TRACK / LONG)))
    SWIVELS = LocalEquation(formulas.beta_dot, S / -formulas.d, "rad/s")

wheels_8 = Exercise(
    "wheels-8",
    title="How fast does the castor swivel?",
    text="The pivot of a castor is "
    + SPOKE
    + "From the spoke to the castor's axle the angle is β = {beta}. Its wheel touches the floor "
    "{behind} behind the pivot, against the direction α + β − 90°. The robot moves at v = {v}, "
    "v_y = {v_y} and ω = {omega}. " + COMPONENTS + ". How fast does the castor swivel on the "
    "robot, counter-clockwise positive, so that its wheel does not slide along its axle?",
    given={
        "l": L,
        "alpha": number_range(-150, 165, 15, "°"),
        "beta": number_range(-75, 75, 15, "°"),
        "behind": number_range(3, 6, 1, "cm"),
        "v": SPEED,
        "v_y": SPEED,
        "omega": TURN,
    },
    unknowns=(Unknown("β̇", "rad/s"),),
    right=castor_rate,
    wrong={},
    derive=lambda behind, **_: {"d": -behind},
    likely_slips={
        "when d is missing in the last entry of the sliding row": lambda omega, **numbers: (
            castor_rate(omega=omega, **numbers) + omega
        ),
        "with d positive, as of a wheel ahead of its pivot": lambda behind, **numbers: castor_rate(
            behind=-behind, **numbers
        ),
        "when the turn of the robot moves its centre only: l sin β is missing": lambda **numbers: (
            castor_rate(**{**numbers, "l": 0.0})
        ),
    },
    solution=Solution(
        "The wheel is behind its pivot, so d = {d:.2f} m. The right side of the castor's sliding "
        "row says how fast the contact point would be moved along the axle, if the castor did not "
        "swivel:\n\n{row}\n\nThe swivelling must undo this. It moves the contact point along the "
        "axle at d times its rate:\n\n{rate}",
        row=Step(formulas.castor, BY_PLACE | {formulas.d: "d"}, values=(S,), unit="m/s"),
        rate=Step(SWIVELS, {formulas.d: "d"}),
    ),
)

wheels_9 = Exercise(
    "wheels-9",
    title="Rollers that let the wheel rest",
    text="A wheel with rollers is "
    + SPOKE
    + "From the spoke to its axle the angle is β = {beta}; it rolls in the direction α + β − 90°. "
    "The robot turns about the point x = {p_x}, y = {p_y} of its own frame, and the wheel's motor "
    "is to rest meanwhile. At which roller angle γ does it? γ is counted from the rolling "
    "direction to the axis of the roller on the ground, between −90° and 90°.",
    given={
        "l": L,
        "alpha": number_range(-150, 180, 15, "°"),
        "beta": number_range(-45, 45, 15, "°"),
        "p_x": number_range(-1, 1, 0.25, "m"),
        "p_y": number_range(-1, 1, 0.25, "m"),
    },
    unknowns=(Unknown("γ", "rad", circle=True),),
    right=resting_rollers,
    wrong={},
    when=lambda p_x, p_y, **place: (
        np.hypot(p_x, p_y) > 0.6 and abs(resting_rollers(p_x=p_x, p_y=p_y, **place)) < 1.3
    ),
    derive=lambda l, alpha, beta, p_x, p_y: {
        "half_turns": -np.pi
        * np.round(
            (
                np.arctan2(p_y - l * np.sin(alpha), p_x - l * np.cos(alpha))
                - alpha
                - beta
                + np.pi / 2
            )
            / np.pi
        )
    },
    likely_slips={
        "counted from the axle, not from where the wheel rolls": lambda alpha, beta, **numbers: (
            resting_rollers(alpha=alpha, beta=beta, axis=alpha + beta, **numbers)
        ),
        "counted from the robot's x axis": lambda **numbers: resting_rollers(axis=0.0, **numbers),
        "with the other sign": lambda **numbers: -resting_rollers(**numbers),
    },
    solution=Solution(
        "The motor rests if the point is on the push line. So this line leads from the hub to the "
        "point:\n\n{to_point}\n\nIts direction, from the robot's x axis, is\n\n{line}\n\nThe "
        "roller angle is counted from the rolling direction; half a turn more or less is the same "
        "line:\n\n{gamma}",
        to_point=Step(TO_POINT, BY_PLACE),
        line=Step(TO_ROLLERS),
        gamma=Step(ROLLERS, BY_PLACE | {HALF_TURNS: "half_turns"}),
    ),
)

wheels_10 = Exercise(
    "wheels-10",
    title="Two front wheels that agree",
    text="The two front wheels of a car are steered one by one. The car has the wheelbase {L} and "
    "the track {b}. Its left front wheel is turned by {left} to the left. By which angle must the "
    "right one be turned, so that the car is not blocked?",
    given={
        "L": number_range(2, 3, 0.1, "m"),
        "b": number_range(1.3, 1.8, 0.1, "m"),
        "left": number_range(20, 40, 1, "°"),
    },
    unknowns=(Unknown("δ_R", "rad", circle=True, tolerance=1e-3),),
    right=other_wheel,
    wrong={},
    likely_slips={
        "for parallel front wheels: their axle lines never meet, and the car is blocked": (
            lambda L, b, left: left
        ),
        "with the outer wheel turned more; it is the inner one": lambda L, b, left: np.arctan(
            1 / (1 / np.tan(left) - b / L)
        ),
        "for the wheel of the bicycle, in the middle": lambda L, b, left: np.arctan(
            1 / (1 / np.tan(left) + b / (2 * L))
        ),
    },
    solution=Solution(
        "All axle lines must meet in one point. On the line of the rear axle, the front axle line "
        "of each wheel meets it L cot δ to the left of that wheel's side. The sides are b apart:"
        "\n\n{right_wheel}\n\nThis is {right_wheel.value:deg}.",
        right_wheel=Step(OTHER_WHEEL, {LEFT: "left", TRACK: "b", LONG: "L"}),
    ),
)

wheels_11 = Exercise(
    "wheels-11",
    title="Three numbers of a drawn robot",
    text="Draw these places on squared paper, x ahead and y to the left: A at (0, {y}), B at "
    "(0, −{y}), C at ({x}, 0), D at (−{x}, 0), E at ({x}, {y}). A robot has {drawn}. The axle of "
    "a fixed wheel is parallel to y; steered wheels are turned so that it can always move. "
    "What are its degrees of mobility δ_m, of steerability δ_s and of manoeuvrability δ_M?",
    given={
        "drawn": one_of(*DRAWN),
        "x": number_range(20, 50, 10, "cm"),
        "y": number_range(10, 25, 5, "cm"),
    },
    unknowns=(integer("δ_m"), integer("δ_s"), integer("δ_M")),
    right=drawn_mobility,
    wrong={},
    likely_slips={
        "when every fixed wheel takes a way, also on the axle line of another": each_counted,
        "when the steered wheels forbid nothing": lambda **robot: degrees(
            drawn_mobility(**robot).delta_M, drawn_mobility(**robot).delta_s
        ),
        "when δ_M is the number of motions at once, without the steering": lambda **robot: [
            *drawn_mobility(**robot)[:2],
            drawn_mobility(**robot).delta_m,
        ],
    },
    solution=Solution(
        "Balls and castors forbid nothing. Fixed wheels on one axle line have one row between "
        "them, and any steered wheels are independent when turned as one likes:\n\n{ranks}\n\n"
        "Two lines determine the centre of the turn. A steered wheel has a free choice for each "
        "line that the fixed wheels leave:\n\n{delta_s}\n\nEach independent row of the fixed "
        "wheels and each free choice takes a way to move:\n\n{delta_m}\n\nThe sum is\n\n{delta_M}",
        answer=(("delta_m", "delta_s", "delta_M"),),
        ranks=Step(drawn_ranks),
        delta_s=Step(formulas.mobility, part=(0,)),
        delta_m=Step(formulas.mobility, part=(1,)),
        delta_M=Step(formulas.mobility, part=(2,)),
    ),
)
