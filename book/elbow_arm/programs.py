"""Programs that students write on the three-joint elbow arm."""

from dataclasses import replace
from itertools import chain

import numpy as np
from sympy import Matrix, cos, sin

from book.basics.formulas import p_x, p_y
from book.elbow_arm.exercises import (
    WAYS,
    base_only,
    four_alike,
    no_p_x,
    possible,
    without_x_by_atan2,
)
from book.elbow_arm.formulas import a2, a3, d1, forward, p_z, theta1, theta2, theta3
from book.things import space
from courseware.answers import Unknown, angle
from courseware.figures import VIEW
from courseware.programs.program import Program
from robokin import elbow_arm

PLACES = tuple(
    Unknown(f"{axis} of the {joint}", "m")
    for joint in ("base", "shoulder", "elbow", "wrist")
    for axis in "xyz"
)
ANGLES = (angle("θ_1"), angle("θ_2"), angle("θ_3"))
NEAR = dict.fromkeys((p_x, p_y, p_z), (-0.9, 0.9)) | {
    a2: (0.5, 0.9),
    a3: (0.4, 0.9),
    d1: (0.1, 0.5),
}
CORNERS = {
    "on the base axis": {p_x: 0.0, p_y: 0.0, p_z: 0.6, d1: 0.1},
    "straight behind": {p_x: -0.7, p_y: 0.0, p_z: 0.2, d1: 0.1},
    "stretched": {p_x: 0.48, p_y: 0.64, p_z: 0.1, a2: 0.5, a3: 0.3, d1: 0.1},
    "folded": {p_x: 0.32, p_y: 0.0, p_z: 0.12, a2: 0.83, a3: 0.51, d1: 0.12},
    "folded, where rounding goes below −1": {
        p_x: 0.06,
        p_y: 0.0,
        p_z: 0.08,
        a2: 0.3,
        a3: 0.2,
        d1: 0.0,
    },
    "folded back to the shoulder": {p_x: 0.0, p_y: 0.0, p_z: 0.1, a2: 0.6, a3: 0.6, d1: 0.1},
}
STRAIGHT = {
    "straight ahead": {p_x: 0.7, p_y: 0.0, p_z: 0.33},
    "straight behind": {p_x: -0.7, p_y: 0.0, p_z: 0.33},
    "straight above the shoulder": {p_x: 0.0, p_y: 0.0, p_z: 0.7},
}


def joints(theta, upper, lower, height=0):
    """Return the places of base, shoulder, elbow and wrist, of symbols."""
    arm = dict(zip((theta1, theta2, theta3), theta, strict=True)) | {d1: height}
    ends = (arm | {a2: a, a3: b} for a, b in ((0, 0), (upper, 0), (upper, lower)))
    return np.vstack([[0, 0, 0], *(np.ravel(forward.right.subs(end)) for end in ends)])


def draw_link(start, end, theta1, kind):
    """Draw a link in the vertical plane of an arm."""
    along, side = Matrix(end - start), Matrix([-sin(theta1), cos(theta1), 0])
    R = Matrix.hstack(along, side.cross(along), side * along.norm())
    edge = "accent_edge" if kind == "accent" else kind
    link = space.link(1, 0.09, 0.07)
    bare = [replace(mesh, kind=kind, edge=edge, dots={}) for mesh in link]
    return VIEW.solid(bare, R, start)


def draw_arm(places, theta1, kind):
    """Draw an arm in space by the places of its joints."""
    base, shoulder, elbow, wrist = places
    return (
        VIEW.line("text", (base, shoulder)),
        draw_link(shoulder, elbow, theta1, kind),
        draw_link(elbow, wrist, theta1, kind),
        VIEW.point("error" if kind == "error" else "body", wrist),
    )


def draw_places(right, answer, theta, *_):
    return *draw_arm(right, theta[0], "accent"), *draw_arm(answer, theta[0], "error")


def draw_reach(right, answer, p, *arm):
    kinds = (("accent", right), ("error", answer))
    arms = (draw_arm(joints(theta, *arm), theta[0], kind) for kind, theta in kinds)
    return *chain(*arms), VIEW.point("target", p)


def draw_four(right, answer, p, *links):
    """Draw all arms that are right, and those that answer."""
    arms = [
        VIEW.line(kind, joints(theta, *links))
        for kind, rows in (("path", right), ("error", answer))
        for theta in rows
    ]
    return *arms, VIEW.point("target", p)


def forearm_from_level(theta, a2, a3, d1):
    """Return the points for θ3 in place of θ2 + θ3."""
    return elbow_arm.joint_positions(theta - [0, 0, theta[1]], a2, a3, d1)


def not_leaning_back(p, a2, a3):
    """Return all four arms, those that face away with the shoulder's angle of the other sign."""
    return elbow_arm.inverse(p, a2, a3) - np.outer([0, 0, 1, 1], [0, np.pi, 0])


def from_base(formula, row=0):
    """Return a formula that gives several arms as one of the arguments of `joint_angles`."""
    return lambda p, a2, a3, d1: formula(p_x=p[0], p_y=p[1], p_z=p[2] - d1, a2=a2, a3=a3)[row]


def from_shoulder(formula):
    """Return the same for `four_arms`, with all arms."""
    return lambda p, a2, a3: formula(p_x=p[0], p_y=p[1], p_z=p[2], a2=a2, a3=a3)


PLACES_OF = '''\
def places(theta, a2, a3, d1):
    """Return where base, shoulder, elbow and wrist are: (4, 3), in m.

    theta: array [theta1, theta2, theta3] in rad; a2, a3: upper link and
    forearm, d1: height of the shoulder, in m.
    """
    ...
'''

elbow_arm_p1 = Program(
    "elbow-arm-p1",
    title="Where are the joints?",
    text="Where are the four points of the arm? Each row of the answer is a point [x, y, z]: "
    "the base at the origin, the shoulder above it, the elbow, the wrist. θ_2 is 0 where the upper "
    "link is level, θ_3 is 0 where the arm is straight; both grow upwards.",
    starter=PLACES_OF,
    symbols=(theta1, theta2, theta3, a2, a3, d1),
    arguments=lambda theta1, theta2, theta3, a2, a3, d1: ([theta1, theta2, theta3], a2, a3, d1),
    specials={
        "all angles zero": {theta1: 0.0, theta2: 0.0, theta3: 0.0},
        "the shoulder at the base": {d1: 0.0},
    },
    answer=PLACES,
    shape=(4, 3),
    right=elbow_arm.joint_positions,
    picture=draw_places,
    extent=0.05,
    likely_slips={
        "when θ_3 is measured from the level, not from the upper link": forearm_from_level,
        "without the height of the shoulder": lambda *n: elbow_arm.joint_positions(*n[:3]),
    },
    hints=(
        "Look at the arm from the side first. How far out from the base axis, and how high, is "
        "each point? The base and the shoulder are on the axis.",
        "The upper link rises by θ_2 and the forearm by θ_2 + θ_3. A link of length a that rises "
        "by an angle leads a times its cosine out and a times its sine up. Add the links.",
        "A point that is r out from the axis has x = r cos θ_1 and y = r sin θ_1. The elbow has "
        "r = a_2 cos θ_2 and z = d_1 + a_2 sin θ_2.",
    ),
    solution="""\
def places(theta, a2, a3, d1):
    theta1, theta2, theta3 = theta
    r2, z2 = a2 * np.cos(theta2), d1 + a2 * np.sin(theta2)
    r3, z3 = r2 + a3 * np.cos(theta2 + theta3), z2 + a3 * np.sin(theta2 + theta3)
    out, up = np.array([0, 0, r2, r3]), [0, d1, z2, z3]
    return np.transpose([out * np.cos(theta1), out * np.sin(theta1), up])
""",
)

JOINT_ANGLES = '''\
def joint_angles(p, a2, a3, d1):
    """Return joint angles [theta1, theta2, theta3] in rad that reach p.

    p: array [x, y, z] of the wrist, from the base; a2, a3: upper link and
    forearm, d1: height of the shoulder. All in m.
    """
    ...
'''

elbow_arm_p2 = Program(
    "elbow-arm-p2",
    title="One arm that reaches the point",
    text="Write the way back: which joint angles bring the wrist to p? There are several answers, "
    "and each of them is right. The angles are those of Where are the joints? Every p is within "
    "reach. A stretched arm, a folded arm and a point "
    "on the base axis must work, too. On the way, rounding can make a cosine of "
    "1.0000000000000002, which no angle has.",
    starter=JOINT_ANGLES,
    symbols=(p_x, p_y, p_z, a2, a3, d1),
    ranges=NEAR,
    arguments=lambda p_x, p_y, p_z, a2, a3, d1: ([p_x, p_y, p_z], a2, a3, d1),
    when=lambda *n: possible(*n) and possible(*n[:5]),
    specials=CORNERS,
    answer=ANGLES,
    right=lambda p, a2, a3, d1: elbow_arm.inverse(p, a2, a3, d1)[0],
    picture=draw_reach,
    extent=0.05,
    compared_value=lambda theta, p, *arm: joints(theta, *arm)[-1],
    wrong={mistake: from_base(formula) for mistake, formula in WAYS.items()},
    likely_slips={
        f"{no_p_x.feedback}, although with atan2": from_base(without_x_by_atan2),
        "when p_z is taken as measured from the shoulder": lambda *n: elbow_arm.inverse(*n[:3])[0],
    },
    hints=(
        "Turn the base first, so that the arm faces the point. Then look from the side: the "
        "shoulder, the elbow and the wrist make a triangle.",
        "From the side the wrist is r = √(p_x² + p_y²) out from the shoulder, and h = p_z − d_1 "
        "above it. The law of cosines gives "
        "cos θ_3 = (r² + h² − a_2² − a_3²)/(2 a_2 a_3). Keep it between −1 and 1 with np.clip.",
        "θ_2 is the elevation of the wrist, atan2(h, r), less the angle between the upper link and "
        "the line to the wrist, atan2(a_3 sin θ_3, a_2 + a_3 cos θ_3).",
    ),
    solution="""\
def joint_angles(p, a2, a3, d1):
    x, y, z = p
    r, h = np.hypot(x, y), z - d1
    A = (r**2 + h**2 - a2**2 - a3**2) / (2 * a2 * a3)
    theta3 = np.arccos(np.clip(A, -1, 1))
    lead = np.arctan2(a3 * np.sin(theta3), a2 + a3 * np.cos(theta3))
    theta2 = np.arctan2(h, r) - lead
    return np.array([np.arctan2(y, x), theta2, theta3])
""",
)

FOUR_ARMS = '''\
def four_arms(p, a2, a3):
    """Return the joint angles of all four arms that reach p: (4, 3), in rad.

    Rows: facing p, elbow up and elbow down; facing away, elbow up and down.
    p: array [x, y, z] of the wrist, from the shoulder; a2, a3: links. In m.
    """
    (x, y, z), facing, away = p, [], []
    r, theta1 = np.hypot(x, y), np.arctan2(y, x)
    bend = np.arccos((r**2 + z**2 - a2**2 - a3**2) / (2 * a2 * a3))
    for theta3 in [-bend, bend]:
        lead = np.arctan2(a3 * np.sin(theta3), a2 + a3 * np.cos(theta3))
        theta2 = np.arctan2(z, r) - lead
        facing.append([theta1, theta2, theta3])
        away.append([theta1 + np.pi, theta2, theta3])
    return np.array(facing + away)
'''

elbow_arm_p3 = Program(
    "elbow-arm-p3",
    title="Mend it: all four arms",
    text="This function is to return the angles of all four arms whose wrist is at p. It is wrong. "
    "Find the mistake and mend it.",
    starter=FOUR_ARMS,
    symbols=(p_x, p_y, p_z, a2, a3),
    ranges=NEAR,
    arguments=lambda p_x, p_y, p_z, a2, a3: ([p_x, p_y, p_z], a2, a3),
    when=possible,
    specials=STRAIGHT,
    answer=ANGLES * 4,
    shape=(4, 3),
    right=elbow_arm.inverse,
    picture=draw_four,
    extent=0.05,
    wrong={m: from_shoulder(formula) for m, formula in WAYS.items()}
    | {base_only: from_shoulder(four_alike)},
    likely_slips={"with −θ_2 where the arm faces away, not π − θ_2": not_leaning_back},
    hints=(
        "Which rows are wrong? Put each row into the formulas of the way forward, and look where "
        "the wrist is.",
        "With the base turned round, the arm must lean over backwards to reach the same point.",
        "Where the arm faces away, its elbow and wrist are at the same places as before, but seen "
        "from the other side. What rises by θ_2 from in front, by which angle does it rise from "
        "behind? And to which side does the elbow bend then?",
    ),
    solution=FOUR_ARMS.replace(
        "theta1 + np.pi, theta2, theta3", "theta1 + np.pi, np.pi - theta2, -theta3"
    ),
)
