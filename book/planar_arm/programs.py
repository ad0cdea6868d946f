"""Programs that students write on the planar arm with three links."""

import numpy as np
from sympy import cos, sin

from book import things
from book.planar_arm.exercises import (
    OWN,
    OWN_IN_X,
    OWN_RATES,
    OWN_RATES_IN_X,
    RATES,
    TWIST,
    hand_velocity,
    jacobian,
    joint_rates,
    l_2_for_l_3,
    last_joint_only,
    not_derived,
    plus_sine,
    separate_rates,
    times_J,
)
from book.planar_arm.formulas import (
    ANGLES,
    LENGTHS,
    forward,
    l1,
    l2,
    l3,
    phi_dot,
    phi_hand,
    rate1,
    rate2,
    rate3,
    theta1,
    theta2,
    theta3,
    x,
    x_dot,
    y,
    y_dot,
)
from book.things.arms import links
from courseware.answers import angle
from courseware.equations import substitute
from courseware.figures import Arrow, Point
from courseware.programs.program import Program
from robokin import planar_arm

HAND = substitute(forward.right, dict(forward.where))
SHOWN = 0.2  # s, of a motion in a picture
RELATIVE = (
    "(θ_1 is the angle from the x axis to the first link, θ_2 and θ_3 are angles from one link to "
    "the next, φ from the x axis to the last link, all counter-clockwise.)"
)


def joints(theta, lengths):
    """Return the places of the joints and of the hand, of symbols."""
    angles = dict(zip(ANGLES, theta, strict=True))
    arms = (dict(zip(LENGTHS, [*lengths[:k], 0, 0, 0], strict=False)) for k in range(4))
    return np.array([[*HAND.subs(angles | arm)[:2]] for arm in arms])


def draw_arms(right, answer, lengths):
    """Draw the arm with angles as they should be, and as they are."""
    return *links(joints(right, lengths)), *links(joints(answer, lengths), "wrong")


def draw_rates(right, answer, theta, twist, lengths):
    start = joints(theta, lengths)
    hand = start[-1]
    return (
        *links(start, "ghost"),
        *draw_arms(theta + SHOWN * right, theta + SHOWN * answer, lengths),
        Arrow("velocity", hand, hand + SHOWN * twist[:2]),
    )


def draw_pose(right, answer, pose, lengths):
    ahead = 0.15 * np.array([cos(pose[2]), sin(pose[2])])
    wanted = Arrow("target", pose[:2] - ahead, pose[:2])
    return *draw_arms(right, answer, lengths), wanted, Point("target", pose[:2])


def draw_hand(right, answer, theta, rates, lengths):
    """Draw how the hand moves, and on as it turns."""
    places = joints(theta, lengths)
    start = np.array([*places[-1], sum(theta)])
    moved = {"": start + SHOWN * right, "wrong": start + SHOWN * answer}
    hands = (things.arm(at, (0,), (0.12,), base="", look=look) for look, at in moved.items())
    kinds = zip(("velocity", "error"), moved.values(), strict=True)
    arrows = (Arrow(kind, places[-1], at[:2]) for kind, at in kinds)
    return *links(places, "ghost"), *hands, *arrows


IN_VELOCITY = (last_joint_only, separate_rates, l_2_for_l_3, plus_sine, not_derived)
IN_ROWS = {OWN_RATES: OWN, OWN_RATES_IN_X: OWN_IN_X}
AT_LIMITS = {
    "stretched": {x: 0.9, y: 0.0, phi_hand: 0.0, l1: 0.5, l2: 0.3, l3: 0.1},
    "folded": {x: 0.5, y: 0.0, phi_hand: 0.0, l1: 0.8, l2: 0.5, l3: 0.2},
    "the wrist at the base": {x: 0.2, y: 0.0, phi_hand: 0.0, l1: 0.5, l2: 0.5, l3: 0.2},
    "straight behind": {x: -0.7, y: 0.0, phi_hand: np.pi, l1: 0.5, l2: 0.4, l3: 0.2},
}


def named(theta, lengths):
    """Return joint angles and lengths by the names of the exercises' formulas."""
    return dict(
        zip(("theta1", "theta2", "theta3", "l1", "l2", "l3"), [*theta, *lengths], strict=True)
    )


def rates_by(made):
    """Return the joint rates by a mistake, as a function of the arguments of `rates_for`."""
    return lambda theta, twist, lengths: joint_rates(made, *twist, **named(theta, lengths))


def velocity_by(made):
    """Return the hand's velocity by a mistake, likewise for `hand_velocity`."""
    return lambda theta, rates, lengths: hand_velocity(made, *rates, **named(theta, lengths))


def in_parts(*numbers):
    """Return the symbols' numbers as arrays of three."""
    return numbers[:3], numbers[3:6], numbers[6:]


def is_bent(*numbers):
    """Return whether neither the right J nor that of a mistake is nearly singular."""
    given = named(numbers[:3], numbers[6:])
    made = [None, *(mistake.formula for mistake in IN_VELOCITY), *IN_ROWS.values()]
    return all(abs(np.linalg.det(jacobian(each, **given))) > 0.02 for each in made)


def without_turn(theta, twist, lengths):
    """Return the joint rates for a hand that does not turn."""
    return planar_arm.joint_rates(theta, twist * [1, 1, 0], lengths)


def turned_last(theta, twist, lengths):
    """Return the same, with the turning rate added to the last joint's."""
    return without_turn(theta, twist, lengths) + twist * [0, 0, 1]


def both_arms(pose, lengths):
    """Return both answers, or NaN for degrees taken for radians out of reach."""
    return planar_arm.inverse(pose, lengths, unreachable="nan")


def hand_as_wrist(pose, lengths, share=1):
    """Return both answers for a hand that is moved ahead by a share of its link."""
    ahead = share * lengths[2] * np.array([np.cos(pose[2]), np.sin(pose[2]), 0])
    return both_arms(pose + ahead, lengths)


def not_taken_away(pose, lengths):
    """Return both answers with φ itself for θ3."""
    return both_arms(pose, lengths) * [1, 1, 0] + [0, 0, pose[2]]


STILL = {
    "for a hand that does not turn": without_turn,
    "when the first two rates are those for a hand that does not turn": turned_last,
}
ASTRAY = {
    "when the hand's point is taken for the wrist": hand_as_wrist,
    "when the wrist is taken to be ahead of the hand": lambda pose, lengths: hand_as_wrist(
        pose, lengths, 2
    ),
    "with φ itself for θ_3": not_taken_away,
}


def row(formula, number):
    """Return one of both answers of a formula."""
    return lambda pose, lengths: formula(pose, lengths)[number]


def within_reach(x, y, phi, l1, l2, l3):
    """Return whether the wrist is well within reach, also for those who go astray."""
    ways = [(-1, phi), (0, phi), (1, phi), (1, np.radians(phi))]
    wrists = [np.hypot(x - k * l3 * np.cos(to), y - k * l3 * np.sin(to)) for k, to in ways]
    return all(abs(l1 - l2) + 0.02 < d < l1 + l2 - 0.02 for d in wrists)


RATES_FOR = '''\
def rates_for(theta, twist, lengths):
    """Return the joint rates [rate1, rate2, rate3] in rad/s.

    theta: joint angles in rad; twist: the hand's [x_dot, y_dot, phi_dot] in
    m/s, m/s and rad/s; lengths: of the links in m. Arrays of three numbers.
    """
    ...
'''

planar_arm_p1 = Program(
    "planar-arm-p1",
    title="Joint rates for any motion of the hand",
    text="Which joint rates move the hand as the twist says? This time the hand turns, too. No arm "
    "is stretched or folded. You may solve the equations on paper, or set up J and let NumPy "
    f"solve them. {RELATIVE}",
    starter=RATES_FOR,
    symbols=(*ANGLES, x_dot, y_dot, phi_dot, *LENGTHS),
    arguments=in_parts,
    when=is_bent,
    specials={
        "the hand does not turn": {phi_dot: 0.0},
        "the hand only turns": {x_dot: 0.0, y_dot: 0.0},
        "almost stretched": {theta2: 0.01},
    },
    answer=RATES,
    right=planar_arm.joint_rates,
    picture=draw_rates,
    extent=0.1,
    wrong={m: rates_by(m.formula) for m in (*IN_VELOCITY, times_J)},
    likely_slips={words: rates_by(made) for words, made in IN_ROWS.items()} | STILL,
    hints=(
        "The hand's velocity is J times the rates. You know the velocity and want the rates. "
        "What must be done with J?",
        "The entries of J are sums over links: the first column has all three links in it, the "
        "last only l_3. The row of ẋ has −sin, the row of ẏ has cos, of the links' directions "
        "θ_1, θ_1 + θ_2 and θ_1 + θ_2 + θ_3. The last row is [1, 1, 1].",
        "With J as an array: np.linalg.solve(J, twist). On paper: the first rate is "
        "(ẋ c_12 + ẏ s_12 + l_3 φ̇ s_3)/(l_1 s_2).",
    ),
    solution="""\
def rates_for(theta, twist, lengths):
    l1, l2, l3 = lengths
    x_dot, y_dot, phi_dot = twist
    one, theta2, theta3 = theta
    two = one + theta2  # links 1 and 2 point in these directions
    s2 = np.sin(theta2)
    along_1 = x_dot * np.cos(one) + y_dot * np.sin(one) + l3 * phi_dot * np.sin(theta2 + theta3)
    along_2 = x_dot * np.cos(two) + y_dot * np.sin(two) + l3 * phi_dot * np.sin(theta3)
    rate1 = along_2 / (l1 * s2)
    rate2 = -rate1 - along_1 / (l2 * s2)
    return np.array([rate1, rate2, phi_dot - rate1 - rate2])
""",
)

JOINT_ANGLES = '''\
def joint_angles(pose, lengths):
    """Return joint angles [theta1, theta2, theta3] in rad for a pose.

    pose: array [x, y, phi] of the hand in m, m and rad; lengths: of the
    three links in m.
    """
    ...
'''

planar_arm_p2 = Program(
    "planar-arm-p2",
    title="Joint angles for a pose of the hand",
    text="The hand is to be at x and y and to point at φ. Find three joint angles. There are two "
    "answers, and either is right. Every pose is within reach. A stretched arm, a folded arm and a "
    "wrist at the base must work, too. On the way, rounding can make a cosine of "
    f"1.0000000000000002, which no angle has. {RELATIVE}",
    starter=JOINT_ANGLES,
    symbols=(x, y, phi_hand, *LENGTHS),
    ranges={x: (-1.2, 1.2), y: (-1.2, 1.2), l3: (0.05, 0.3)},
    arguments=lambda *numbers: (numbers[:3], numbers[3:]),
    when=within_reach,
    specials=AT_LIMITS,
    answer=(angle("θ_1"), angle("θ_2"), angle("θ_3")),
    right=row(both_arms, 0),
    picture=draw_pose,
    extent=0.1,
    compared_value=lambda theta, pose, lengths: [
        *joints(theta, lengths)[-1],
        cos(sum(theta)),
        sin(sum(theta)),
    ],
    likely_slips={words: row(formula, 0) for words, formula in ASTRAY.items()},
    hints=(
        "The pose tells where the hand is and where it points. So where is the wrist, at the other "
        "end of the third link?",
        "The wrist is at x − l_3 cos φ and y − l_3 sin φ. From there on it is the elbow arm seen "
        "from the side: the law of cosines gives θ_2. Keep its cosine between −1 and 1 with "
        "np.clip.",
        "cos θ_2 = (d² − l_1² − l_2²)/(2 l_1 l_2), with d from the base to the wrist. θ_1 is the "
        "direction of the wrist less atan2(l_2 sin θ_2, l_1 + l_2 cos θ_2). And θ_3 is what φ "
        "lacks.",
    ),
    solution="""\
def joint_angles(pose, lengths):
    x, y, phi = pose
    l1, l2, l3 = lengths
    x_w, y_w = x - l3 * np.cos(phi), y - l3 * np.sin(phi)  # the wrist
    A = (x_w**2 + y_w**2 - l1**2 - l2**2) / (2 * l1 * l2)
    theta2 = np.arccos(np.clip(A, -1, 1))
    lead = np.arctan2(l2 * np.sin(theta2), l1 + l2 * np.cos(theta2))
    theta1 = np.arctan2(y_w, x_w) - lead
    return np.array([theta1, theta2, phi - theta1 - theta2])
""",
)

VELOCITY = '''\
def hand_velocity(theta, rates, lengths):
    """Return the hand's [x_dot, y_dot, phi_dot] in m/s, m/s and rad/s.

    theta: joint angles in rad; rates: of the joints in rad/s; lengths: of
    the links in m. Arrays of three numbers.
    """
    a1, a2, a3 = np.cumsum(theta)  # directions of the links
    w1, w2, w3 = np.cumsum(rates)  # how fast they turn
    x_dot = -lengths[0] * w1 * np.sin(a1)
    y_dot = lengths[0] * w1 * np.cos(a1)
    x_dot -= lengths[1] * w2 * np.sin(a2)
    y_dot += lengths[1] * w2 * np.cos(a2)
    x_dot -= lengths[1] * w3 * np.sin(a3)
    y_dot += lengths[1] * w3 * np.cos(a3)
    return np.array([x_dot, y_dot, w3])
'''

planar_arm_p3 = Program(
    "planar-arm-p3",
    title="Mend it: the velocity of the hand",
    text="This function is to return the velocity of the hand and its turning rate, link by link. "
    f"It is wrong. Find the mistake and mend it. {RELATIVE}",
    starter=VELOCITY,
    symbols=(*ANGLES, rate1, rate2, rate3, *LENGTHS),
    arguments=in_parts,
    specials={
        "only the last joint turns": {rate1: 0.0, rate2: 0.0},
        "stretched along x": {theta1: 0.0, theta2: 0.0, theta3: 0.0},
        "at rest": {rate1: 0.0, rate2: 0.0, rate3: 0.0},
    },
    answer=TWIST,
    right=planar_arm.velocity,
    picture=draw_hand,
    extent=0.1,
    wrong={m: velocity_by(m.formula) for m in IN_VELOCITY},
    likely_slips={words: velocity_by(made) for words, made in IN_ROWS.items()},
    hints=(
        "Test it with simple arms: let one joint turn, or make one link very short. With which "
        "links does the answer change?",
        "Each pair of lines is the motion of one link. The three pairs should differ only in "
        "their numbers 1, 2 and 3.",
        "The links are lengths[0], lengths[1] and lengths[2] long. Is each of the three used?",
    ),
    solution=VELOCITY.replace("lengths[1] * w3", "lengths[2] * w3"),
)
