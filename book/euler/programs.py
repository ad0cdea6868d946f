"""Programs that students write on Euler angles."""

import numpy as np
from sympy import Matrix, prod

from book.euler.exercises import (
    all_wrong_way,
    clean,
    far_from_lock,
    fixed_yaw_pitch_roll,
    ignored_lock,
    left_handed_turn,
    regular,
    wrong_order,
    yaw_pitch_roll,
)
from book.euler.figures import LEFT, RIGHT, X, Y, Z, die
from book.euler.formulas import first, middle, third, turned_about
from courseware.answers import angle, matrix
from courseware.programs.program import Program
from robokin import euler

TURNS = (first, middle, third)
# Angles whose sines and cosines are short decimals, so that a matrix of them can be read
QUARTERS = np.pi / 2 * np.arange(-2, 3)
SHORT = np.sort(np.concatenate([QUARTERS, *(QUARTERS[:-1] + t for t in np.arctan([3 / 4, 4 / 3]))]))
AXES_TO_AXES = {
    "no turn": {first: 0.0, middle: 0.0, third: 0.0},
    "a quarter turn to the right": {first: -np.pi / 2, middle: 0.0, third: 0.0},
    "half a turn": {first: np.pi, middle: 0.0, third: 0.0},
    "upside down": {first: 0.0, middle: 0.0, third: np.pi},
}
QUARTERS_LEFT = {
    "only the middle turn": {first: 0.0, third: 0.0},
    "with half a turn": {first: np.pi, third: 0.0},
    "with a quarter turn back": {first: 0.0, third: -np.pi / 2},
}


def short(turn):
    """Return the angle nearest to a turn whose sine is a short decimal; a small one as it is."""
    return turn if abs(turn) < 0.1 else SHORT[np.abs(SHORT - turn).argmin()]


def readable(seq, *turns):
    """Return a rotation near that of a sequence, of short decimals."""
    return clean(euler.to_matrix(seq, [short(turn) for turn in turns]))


def is_free(*turns):
    """Return whether ZYX, and M6 in its place, are far from gimbal lock."""
    return all(far_from_lock(seq, readable("ZYX", *turns)) for seq in ("ZYX", "zyx"))


def locked_near(first, middle, third):
    """Return a rotation at gimbal lock of XYZ, of short decimals."""
    return readable("XYZ", first, np.copysign(np.pi / 2, middle), third)


def draw_dice(right, answer):
    """Draw a die as it should be turned, and as it is turned."""
    return *die(Matrix(right), LEFT), *die(Matrix(answer), RIGHT, kind="error")


def turned(axes, turns):
    """Return the matrix of turns about axes of the turned frame, of symbols."""
    return prod(map(turned_about, axes, turns))


def draw_turns(*axes):
    """Draw a die as the matrix has it, and as the angles turn it."""
    return lambda right, answer, R: draw_dice(R, turned(axes, answer))


def cut_in_half(R):
    """Return yaw, pitch and roll by arctan of quotients, which knows half of the circle."""
    return np.arctan(R[1, 0] / R[0, 0]), -np.arcsin(R[2, 0]), np.arctan(R[2, 1] / R[2, 2])


def as_at_plus(R):
    """Return the angles by r_21, whose sign is that of the sine at +90° only."""
    return [np.arctan2(R[1, 0], R[1, 1]), R[0, 2] * np.pi / 2, 0.0]


def by_entry(*turns):
    """Return the product of each entry of three matrices."""
    return np.prod([euler.to_matrix("ZYX", turns * only) for only in np.eye(3)], axis=0)


def left_handed(alpha, beta, gamma):
    """M7 in three turns."""
    return yaw_pitch_roll(**all_wrong_way(yaw=alpha, pitch=beta, roll=gamma))


YAW_PITCH_ROLL = '''\
def yaw_pitch_roll(R):
    """Return [yaw, pitch, roll] of the sequence ZYX in rad.

    R: a rotation matrix (3, 3), not at gimbal lock.
    """
    ...
'''

euler_p1 = Program(
    "euler-p1",
    title="Yaw, pitch and roll of a matrix",
    text="Read the angles of the sequence ZYX from a rotation matrix: yaw about z, then pitch "
    "about the new y axis, then roll about the newest x axis. There are two answers, and either "
    "is right. All angles must come out right.",
    starter=YAW_PITCH_ROLL,
    symbols=TURNS,
    arguments=lambda *turns: (readable("ZYX", *turns),),
    when=is_free,
    specials=AXES_TO_AXES,
    answer=(angle("yaw"), angle("pitch"), angle("roll")),
    right=lambda R: euler.from_matrix("ZYX", R),
    picture=draw_turns(Z, Y, X),
    extent=1.2,
    compared_value=lambda turns, R: turned((Z, Y, X), turns),
    wrong={wrong_order: lambda R: euler.from_matrix("zyx", R)},
    likely_slips={
        "with arctan, which knows half of the circle; arctan2 knows all of it": cut_in_half,
        "with sine and cosine exchanged in arctan2: the sine comes first": lambda R: (
            np.pi / 2 - euler.from_matrix("ZYX", R)
        ),
        "with the pitch of the other sign": lambda R: euler.from_matrix("ZYX", R) * [1, -1, 1],
        "with the formulas of the sequence XYZ": lambda R: euler.from_matrix("XYZ", R),
        "for the transposed matrix, A as seen from B": lambda R: euler.from_matrix("ZYX", R.T),
    },
    hints=(
        "Multiply the three matrices on paper: R_z R_y R_x. Which of the nine entries is the "
        "simplest?",
        "The bottom left entry is −sin(pitch). The rest of the first column holds the sine and "
        "the cosine of the yaw, the rest of the last row those of the roll. All four have "
        "the factor cos(pitch).",
        "Take cos(pitch) as positive: it is the length of the upper part of the first column, "
        "np.hypot(R[0, 0], R[1, 0]). Then every angle is an arctan2 of its sine and cosine.",
    ),
    solution="""\
def yaw_pitch_roll(R):
    yaw = np.arctan2(R[1, 0], R[0, 0])
    pitch = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    roll = np.arctan2(R[2, 1], R[2, 2])
    return np.array([yaw, pitch, roll])
""",
)

AT_LOCK = '''\
def angles_at_lock(R):
    """Return angles [alpha, beta, gamma] in rad whose sequence XYZ makes R.

    R: a rotation matrix (3, 3) at gimbal lock, R[0, 2] is 1 or -1.
    """
    ...
'''

euler_p2 = Program(
    "euler-p2",
    title="Angles at gimbal lock",
    text="Each R of this exercise is at gimbal lock of the sequence XYZ: its middle turn β is +90° "
    "or −90°. Find three angles that make R: any of the infinitely many.",
    starter=AT_LOCK,
    symbols=TURNS,
    arguments=lambda *turns: (locked_near(*turns),),
    specials=QUARTERS_LEFT,
    answer=(angle("α"), angle("β"), angle("γ")),
    right=lambda R: euler.from_matrix("XYZ", R),
    picture=draw_turns(X, Y, Z),
    extent=1.2,
    compared_value=lambda turns, R: turned((X, Y, Z), turns),
    wrong={ignored_lock: lambda R: [*regular("XYZ", R), 0.0]},
    likely_slips={
        "with r_21 as sin α: its sign is right at +90° only": as_at_plus,
        "when β is +90° every time": lambda R: [euler.from_matrix("XYZ", R)[0], np.pi / 2, 0.0],
        "when β is −90° every time": lambda R: [euler.from_matrix("XYZ", R)[0], -np.pi / 2, 0.0],
    },
    hints=(
        "At gimbal lock the axes of the first and the last turn lie on one line. So one of the "
        "two angles can be anything: take γ = 0. What is left to find?",
        "With γ = 0 the second column is [0, cos α, sin α]. And β is +90° or −90°, as R[0, 2] "
        "says.",
    ),
    solution="""\
def angles_at_lock(R):
    alpha = np.arctan2(R[2, 1], R[1, 1])
    beta = R[0, 2] * np.pi / 2
    return np.array([alpha, beta, 0])
""",
)

TURNED_DOC = '''\
    """Return the rotation matrix R_AB of the sequence ZYX, (3, 3).

    B is turned by alpha about z, then by beta about its new y axis, then by
    gamma about its newest x axis. Angles in rad.
    """
'''
TURNED = f"""\
def turned(alpha, beta, gamma):
{TURNED_DOC}    ca, cb, cc = np.cos([alpha, beta, gamma])
    sa, sb, sc = np.sin([alpha, beta, gamma])
    R_z = np.array([[ca, -sa, 0], [sa, ca, 0], [0, 0, 1]])
    R_y = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    R_x = np.array([[1, 0, 0], [0, cc, -sc], [0, sc, cc]])
    R_AB = np.eye(3)
    for R in [R_z, R_y, R_x]:
        R_AB = R @ R_AB
    return R_AB
"""

euler_p3 = Program(
    "euler-p3",
    title="Mend it: three turns in one matrix",
    text="This function is to return the matrix R_AB of three turns, each about an axis of the "
    "frame as it is turned so far. It is wrong: mend it.",
    starter=TURNED,
    symbols=TURNS,
    specials={
        "only the first turn": {middle: 0.0, third: 0.0},
        "without the middle turn": {middle: 0.0},
        "at gimbal lock": {middle: np.pi / 2},
    },
    answer=matrix("R_AB", 3, 3),
    shape=(3, 3),
    right=lambda *turns: euler.to_matrix("ZYX", turns),
    picture=lambda right, answer, *turns: draw_dice(right, answer),
    extent=1.2,
    wrong={wrong_order: fixed_yaw_pitch_roll, left_handed_turn: left_handed},
    likely_slips={
        "with the first turn about x and the last about z": lambda *turns: euler.to_matrix(
            "XYZ", turns
        ),
        "when matrices are multiplied entry by entry: * does that, @ is their product": by_entry,
    },
    hints=(
        "Try it with one angle that is not zero, then with two.",
        "The three matrices are right, each by itself. In which order are they multiplied? Print "
        "what comes after two turns.",
        "A turn about an axis of the turned frame is multiplied on the right of what is there.",
    ),
    solution=TURNED.replace(TURNED_DOC, "").replace("R @ R_AB", "R_AB @ R"),
)
