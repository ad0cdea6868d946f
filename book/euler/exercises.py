"""Exercises on Euler rotation sequences, and the mistakes that are made there."""

from itertools import product

import numpy as np

from robokin import euler
from workshop.practice import Ask, Exercise, Mistake, angle, matrix, number_text, one_of

M6 = Mistake(
    "M6",
    says="with the matrices in the wrong order, that of turns about the axes of the fixed frame",
    line='R_y, R_z = euler.to_matrix("Y", [a]), euler.to_matrix("Z", [b])\nR_AB = R_z @ R_y',
    why="A turn about an axis of the turned frame is multiplied on the right: R_1 R_2. On the "
    "left, R_2 R_1, it would be a turn about an axis of the fixed frame A.",
    unnoticed="Where both turns are about the same axis, both are half turns, or one of the angles "
    "is zero.",
)
M7 = Mistake(
    "M7",
    says="with left-handed turns: every sine has the wrong sign",
    line="R_y = [[np.cos(a), 0, -np.sin(a)], [0, 1, 0], [np.sin(a), 0, np.cos(a)]]\n"
    "R_z = [[np.cos(b), np.sin(b), 0], [-np.sin(b), np.cos(b), 0], [0, 0, 1]]\n"
    "R_AB = np.array(R_y) @ R_z",
    why="Point the thumb of the right hand along the axis: the fingers bend the positive way. "
    "About z it leads from x to y, about y from z to x. These matrices turn the other way.",
    unnoticed="Where every turn is a half turn: its sine is zero.",
)
M8 = Mistake(
    "M8",
    says="when all three angles are read by the regular formulas, although the frame is at gimbal "
    "lock; atan2(0, 0) then gives 0",
    line="a = np.arctan2(-R[1, 2], R[2, 2])\n"
    "b = np.arctan2(R[0, 2], np.hypot(R[1, 2], R[2, 2]))\n"
    "angles = [a, b]",
    why="At gimbal lock all the entries that these formulas read for the first and the third angle "
    "are zero, and arctan2(0, 0) gives 0 without a warning. The turn that is missing stands in the "
    "other entries. Rebuild the matrix from your angles and compare.",
    unnoticed="Where the turn that remains is zero.",
)


def clean(R):
    """A matrix without the dust of rounding."""
    return R.round(12) + 0.0


def two_turns(first, second, a, b):
    """R_AB for a turn about an axis of A, then one about an axis of the turned frame."""
    return clean(euler.to_matrix((first + second).upper(), [a, b]))


def fixed_axes(first, second, a, b):
    """M6 for two turns: both about axes of A."""
    return euler.to_matrix(first + second, [a, b])


def left_handed(first, second, a, b):
    """M7 for two turns."""
    return two_turns(first, second, -a, -b)


def column(R, arrow):
    """An axis of B as seen from A."""
    return R[:, "xyz".index(arrow)]


def rest(R_AB, axis, turn):
    """What remains of R_AB after a first turn about an axis of A."""
    return euler.to_matrix(axis, [turn]).T @ R_AB


def both_ways(R):
    """Axis and angle of a rotation, and the opposite axis with the opposite angle."""
    axis, turn = euler.axis_angle(R)
    return [[*axis, turn], [*-axis, -turn]]


def yaw_pitch_roll(yaw, pitch, roll):
    """R_AB from turns about z, the new y, and the newest x."""
    return clean(euler.to_matrix("ZYX", [yaw, pitch, roll]))


def fixed_yaw_pitch_roll(yaw, pitch, roll):
    """M6: the same turns about the axes of A."""
    return euler.to_matrix("zyx", [yaw, pitch, roll])


def to_zyz(yaw, pitch, roll):
    """Both answers of the sequence ZYZ for the same rotation."""
    return euler.solutions("ZYZ", yaw_pitch_roll(yaw, pitch, roll))


def far_from_lock(seq, R):
    """Whether a sequence is far from gimbal lock, so that a rounded matrix does no harm."""
    return not euler.is_locked(seq, R, 0.2)


def locked(seq, a, b):
    """A rotation at gimbal lock, where b is a quarter turn: the third turn is left out."""
    return clean(euler.to_matrix(seq, [a, b, 0]))


def regular(seq, R):
    """M8 for XYZ, YZX or ZXY: the first two angles by the formulas that fail at lock."""
    i, j, k = map("XYZ".index, seq)
    zero, one = 0.0 - R[j, k], R[k, k]
    return [np.arctan2(zero, one), np.arctan2(R[i, k], np.hypot(zero, one))]


ALL = clean(euler.to_matrix("XYZ", np.pi / 2 * np.array(list(product(range(4), repeat=3)))))
QUARTERS = {number_text(R, ""): R for R in ALL}  # the 24 rotations that lead axes to axes
AXIS = one_of("x", "y", "z")
TURN = one_of(-120, -90, -60, -45, -30, 30, 45, 60, 90, 120, unit="°")
TURNS = {"a": TURN, "first": AXIS, "b": TURN, "second": AXIS}
DIRECTION = tuple(Ask(f"{letter} of the arrow") for letter in "xyz")


def different(first, second, **_):
    """Two turns about different axes."""
    return first != second


euler_1 = Exercise(
    "euler-1",
    level=1,
    title="Where does the arrow point?",
    text="Frame B is made from frame A by two turns: first by {a} about the {first} axis, then by "
    "{b} about the new {second} axis. An arrow of length 1 points along the {arrow} axis of B. "
    "What are its x, y and z in frame A?",
    given=TURNS | {"arrow": AXIS},
    asks=DIRECTION,
    right=lambda arrow, **turns: column(two_turns(**turns), arrow),
    wrong={
        M6: lambda arrow, **turns: column(fixed_axes(**turns), arrow),
        M7: lambda arrow, **turns: column(left_handed(**turns), arrow),
    },
    when=different,
    derive=lambda arrow, **turns: {"R": two_turns(**turns)},
    also={
        "with a row of the matrix where its column belongs": lambda arrow, **turns: column(
            two_turns(**turns).T, arrow
        ),
    },
    solution="Turns about new axes are multiplied in the order in which they are made:\n\n"
    "R_AB = R_{first}({a}) R_{second}({b}) = {R}\n\n"
    "The columns of R_AB are the axes of B as A sees them. The {arrow} axis:\n\n{right}",
)

euler_2 = Exercise(
    "euler-2",
    level=2,
    title="Two turns in one matrix",
    text="Frame B is frame A turned first by {a} about its {first} axis, and then by {b} about its "
    "new {second} axis. What is R_AB, the matrix whose columns are the axes of B as A sees them?",
    given=TURNS,
    asks=matrix("R_AB", 3, 3),
    shape=(3, 3),
    right=two_turns,
    wrong={M6: fixed_axes, M7: left_handed},
    when=different,
    solution="The second turn is about an axis of the turned frame, so its matrix stands on the "
    "right:\n\nR_AB = R_{first}({a}) R_{second}({b}) = {right}",
    example={"first": "y", "a": np.pi / 2, "second": "z", "b": -np.pi / 2},
)

euler_3 = Exercise(
    "euler-3",
    level=2,
    title="What remains to be turned?",
    text="Frame A must be brought to frame B, with R_AB = {R_AB}. A first turn is already made, "
    "by {turn} about the {axis} axis of A. Which rotation R is still needed? Give its matrix as "
    "the turned frame sees it.",
    given={
        "R_AB": one_of(*QUARTERS),
        "axis": AXIS,
        "turn": one_of(-90, 90, unit="°"),
    },
    asks=matrix("R", 3, 3),
    shape=(3, 3),
    right=lambda R_AB, axis, turn: rest(QUARTERS[R_AB], axis, turn),
    wrong={
        M6: lambda R_AB, axis, turn: QUARTERS[R_AB] @ euler.to_matrix(axis, [turn]).T,
        M7: lambda R_AB, axis, turn: rest(QUARTERS[R_AB], axis, -turn),
    },
    derive=lambda R_AB, axis, turn: {"R_1": clean(euler.to_matrix(axis, [turn]))},
    solution="With R_1 the turn already made and R the one that remains, R_AB = R_1 R: the later "
    "turn stands on the right, because it is about axes of the turned frame. Take R_1 away from "
    "the left; its inverse is its transpose:\n\n"
    "R_1 = {R_1}\n\nR = R_1ᵀ R_AB = {right}",
)

euler_4 = Exercise(
    "euler-4",
    level=2,
    title="One turn in place of two",
    text="A camera is turned first by {a} about its {first} axis, and then by {b} about its new "
    "{second} axis. One single turn can do the same. About which axis e (a vector of length 1, as "
    "seen before the turns), and by what angle φ? The opposite axis with the opposite angle is as "
    "good.",
    given=TURNS,
    asks=(Ask("e_x"), Ask("e_y"), Ask("e_z"), angle("φ")),
    accept="any",
    right=lambda **turns: both_ways(two_turns(**turns)),
    wrong={
        M6: lambda **turns: both_ways(fixed_axes(**turns)),
        M7: lambda **turns: both_ways(left_handed(**turns)),
    },
    when=different,
    derive=lambda **turns: {
        "R": two_turns(**turns),
        "trace": np.trace(two_turns(**turns)),
        "phi": euler.axis_angle(two_turns(**turns))[1],
        "sine": 2 * np.sin(euler.axis_angle(two_turns(**turns))[1]),
    },
    solution="Both turns in one matrix, multiplied in the order in which they are made:\n\n"
    "R = R_{first}({a}) R_{second}({b}) = {R}\n\n"
    "The sum of its diagonal is 1 + 2 cos φ = {trace}, so φ = {phi} rad ({phi:deg}). The axis is "
    "[R_zy − R_yz, R_xz − R_zx, R_yx − R_xy]/(2 sin φ), with 2 sin φ = {sine}. Axis and angle:"
    "\n\n{right}",
)

euler_5 = Exercise(
    "euler-5",
    level=2,
    title="Yaw, pitch and roll",
    text="A drone was turned from frame A: first by a (yaw) about its z axis, then by b (pitch) "
    "about its new y axis, then by c (roll) about its newest x axis. The result is "
    "R_AB = {R}. Which a, b, c can it have been? There are two answers: give both.",
    given={
        "yaw": one_of(*range(-150, 0, 30), *range(30, 180, 30), -45, 45, 135, unit="°"),
        "pitch": one_of(-60, -45, -30, 30, 45, 60, unit="°"),
        "roll": one_of(-120, -60, -45, -30, 30, 45, 60, 120, unit="°"),
    },
    asks=(angle("a"), angle("b"), angle("c")),
    accept="all",
    right=lambda **turns: euler.solutions("ZYX", yaw_pitch_roll(**turns)),
    wrong={
        M6: lambda **turns: euler.solutions("zyx", yaw_pitch_roll(**turns)),
        M7: lambda **turns: -euler.solutions("ZYX", yaw_pitch_roll(**turns)),
    },
    when=lambda **turns: far_from_lock("zyx", yaw_pitch_roll(**turns)),
    derive=lambda **turns: {
        "R": yaw_pitch_roll(**turns),
        "first": euler.solutions("ZYX", yaw_pitch_roll(**turns))[0],
    },
    also={
        "for the matrix with rows and columns swapped": lambda **angles: euler.solutions(
            "ZYX", yaw_pitch_roll(**angles).T
        ),
    },
    solution="Multiplied out, R_z(a) R_y(b) R_x(c) has −sin b at the lower left, "
    "[cos a cos b, sin a cos b] above it, and [cos b sin c, cos b cos c] to the right of it. With "
    "cos b > 0:\n\n"
    "a = atan2(R_yx, R_xx), c = atan2(R_zy, R_zz), "
    "b = atan2(−R_zx, √(R_xx² + R_yx²))\n\n[a, b, c] = {first}\n\n"
    "The other answer has cos b < 0: [a + π, π − b, c + π]. Both:\n\n{right}",
)

euler_6 = Exercise(
    "euler-6",
    level=3,
    title="At gimbal lock",
    text="Frame A is brought to frame B by three turns in the sequence {seq}, each about an axis "
    "of the frame as turned so far. The result is R_AB = {R}. Here the sequence is at gimbal lock: "
    "many triples of angles make the same rotation. Choose 0 for the third angle. What are the "
    "first and the second?",
    given={
        "seq": one_of("XYZ", "YZX", "ZXY"),
        "a": one_of(*range(-165, 0, 15), *range(15, 180, 15), unit="°"),
        "b": one_of(-90, 90, unit="°"),
    },
    asks=(angle("first"), angle("second")),
    right=lambda seq, a, b: euler.from_matrix(seq, locked(seq, a, b))[:2],
    wrong={
        M7: lambda seq, a, b: -euler.from_matrix(seq, locked(seq, a, b))[:2],
        M8: lambda seq, a, b: regular(seq, locked(seq, a, b)),
    },
    derive=lambda seq, a, b: {
        "R": locked(seq, a, b),
        "one": seq[0].lower(),
        "two": seq[1].lower(),
        "three": seq[2].lower(),
        "sine": locked(seq, a, b)["XYZ".index(seq[2]), "XYZ".index(seq[1])],
        "cosine": locked(seq, a, b)["XYZ".index(seq[1]), "XYZ".index(seq[1])],
    },
    solution="The entry R_{one}{three} is the sine of the second angle. It is 1 or −1, so the "
    "second angle is π/2 or −π/2. Its cosine is zero, and with it all entries from which the first "
    "and the third angle are read otherwise.\n\n"
    "With the third angle 0, R_AB is a turn a about {one}, then one about {two}. The second turn "
    "leaves the {two} axis where the first one took it: R_{two}{two} = cos a = {cosine} and "
    "R_{three}{two} = sin a = {sine}. Hence a = atan2(sin a, cos a):\n\n{right}",
    example={"seq": "XYZ", "a": -np.pi / 2, "b": np.pi / 2},
)

euler_7 = Exercise(
    "euler-7",
    level=3,
    title="From one sequence to another",
    text="A drone's program says how its camera is turned by yaw {yaw}, pitch {pitch} and roll "
    "{roll}: about z, the new y, and the newest x. The camera's stand wants angles for the "
    "sequence ZYZ: about z, the new y, and the newest z. Which angles make the same rotation? "
    "There are two answers; either of them is enough.",
    given={
        "yaw": one_of(*range(-150, 0, 30), *range(30, 180, 30), unit="°"),
        "pitch": one_of(-60, -45, -30, 30, 45, 60, unit="°"),
        "roll": one_of(-120, -90, -60, -45, -30, 30, 45, 60, 90, 120, unit="°"),
    },
    asks=(angle("first"), angle("second"), angle("third")),
    accept="any",
    right=to_zyz,
    wrong={
        M6: lambda **turns: euler.solutions("ZYZ", fixed_yaw_pitch_roll(**turns)),
        M7: lambda yaw, pitch, roll: to_zyz(-yaw, -pitch, -roll),
    },
    when=lambda **turns: (
        far_from_lock("ZYZ", yaw_pitch_roll(**turns))
        and far_from_lock("ZYZ", fixed_yaw_pitch_roll(**turns))
    ),
    derive=lambda **turns: {"R": yaw_pitch_roll(**turns)},
    also={
        "for the way back, from B to A": lambda **angles: euler.solutions(
            "ZYZ", yaw_pitch_roll(**angles).T
        ),
    },
    solution="The rotation is the same, so both sequences have the same matrix. First make it:\n\n"
    "R = R_z({yaw}) R_y({pitch}) R_x({roll}) = {R}\n\n"
    "Then read the other angles from it. In R_z(a) R_y(b) R_z(c) the last column is "
    "[cos a sin b, sin a sin b, cos b], and the last row starts with −sin b cos c, sin b sin c. "
    "With sin b > 0:\n\n"
    "a = atan2(R_yz, R_xz), b = atan2(√(R_xz² + R_yz²), R_zz), c = atan2(R_zy, −R_zx)\n\n"
    "The other answer is [a + π, −b, c + π]. Both:\n\n{right}",
)
