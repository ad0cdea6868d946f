"""Exercises on Euler rotation sequences, and the mistakes that are made there."""

from functools import reduce
from itertools import product

import numpy as np
from sympy import (
    MatMul,
    Matrix,
    MatrixSymbol,
    asin,
    atan2,
    cos,
    eye,
    sin,
    sqrt,
    symbols,
)

from book.euler import formulas
from book.euler.formulas import r
from courseware.answers import Unknown, angle, matrix
from courseware.equations import as_written
from courseware.practice import (
    Exercise,
    LocalEquation,
    Mistake,
    Solution,
    Step,
    WrongFormula,
    format_number,
    one_of,
)
from robokin import euler

A, B, C = symbols("a b c")
YAW, PITCH, ROLL = symbols("yaw pitch roll")
SEEN = MatrixSymbol("p_A", 3, 1)
R_AB, REST, R_1, R_2 = (MatrixSymbol(name, 3, 3) for name in ("R_AB", "R", "R_1", "R_2"))
R_x, R_y, R_z = (MatrixSymbol(name, 3, 3) for name in ("R_x", "R_y", "R_z"))
ABOUT = {"x": formulas.turn_x, "y": formulas.turn_y, "z": formulas.turn_z}
ENTRIES = tuple(map(str, r))  # the names of the entries of a matrix, row by row
ANGLES = (A, B, C)
OTHER = symbols("a_other b_other c_other")  # the same rotation by other angles
RENAMED = dict(zip(formulas.TURNS, ANGLES, strict=True))
AT_LOCK = (  # of XYZ
    formulas.third_first.right[1].subs(formulas.gamma, 0),
    formulas.angles_at_once.right[1],
)

wrong_order = Mistake(
    "M6",
    feedback="with the matrices in the wrong order, that of turns about the axes of the fixed "
    "frame",
    formula=WrongFormula(LocalEquation(R_AB, R_1 * R_2), instead=R_2 * R_1),
    line='R_y, R_z = euler.to_matrix("Y", [a]), euler.to_matrix("Z", [b])\nR_AB = R_z @ R_y',
    why="A turn about an axis of the turned frame is multiplied on the right: R_1 R_2. On the "
    "left, R_2 R_1, it would be a turn about an axis of the fixed frame A.",
    unnoticed="Where both turns are about the same axis, both are half turns, or one of the angles "
    "is zero.",
    title="A product of two turns",
    picture="A die turned as frame B, and a red one: none of its axes points where it should.",
)
left_handed_turn = Mistake(
    "M7",
    feedback="with left-handed turns: every sine has the wrong sign",
    formula=WrongFormula(formulas.turn_y, {formulas.turn: -formulas.turn}),
    line="R_y = [[np.cos(a), 0, -np.sin(a)], [0, 1, 0], [np.sin(a), 0, np.cos(a)]]\n"
    "R_z = [[np.cos(b), np.sin(b), 0], [-np.sin(b), np.cos(b), 0], [0, 0, 1]]\n"
    "R_AB = np.array(R_y) @ R_z",
    why="Point the thumb of the right hand along the axis: the fingers bend the positive way. "
    "About z it leads from x to y, about y from z to x. These matrices turn the other way: R_y as "
    "marked above, and R_z likewise, whose minus must be in its first row.",
    unnoticed="Where every turn is zero or a half turn: its sine is zero.",
    title="Matrices typed by hand",
    picture="A die turned as frame B, and a red one: its x and z axes point backwards.",
)
ignored_lock = Mistake(
    "M8",
    formula=WrongFormula(
        LocalEquation(Matrix([formulas.first, formulas.middle]), Matrix(AT_LOCK)),
        instead=Matrix(formulas.angles_at_once.right[:2]),
    ),
    feedback="when all three angles are read by the regular formulas, although the frame is at "
    "gimbal lock; atan2(0, 0) then gives 0",
    line="a = np.arctan2(-R[1, 2], R[2, 2])\n"
    "b = np.arctan2(R[0, 2], np.hypot(R[0, 0], R[0, 1]))\n"
    "angles = [a, b]",
    why="At gimbal lock all the entries that these formulas read for the first and the third angle "
    "are zero. For exact zeros arctan2(0, 0) gives 0 without a warning; in a computed matrix they "
    "are rounding errors, and the angles are noise. The turn that is missing stands in the other "
    "entries. Rebuild the matrix from your angles and compare.",
    unnoticed="Where the turn that remains is zero.",
    title="Angles read back",
    picture="A die turned as frame B, and a red one that lacks a quarter turn about its z axis.",
)


def clean(R):
    """Return a matrix without the dust of rounding."""
    return R.round(12) + 0.0


def one_turn(axis, angle):
    """Return the matrix of a turn about an axis."""
    return euler.to_matrix(axis, [angle])


def two_turns(first, second, a, b):
    """Return R_AB for a turn about an axis of A, then one about an axis of the turned frame."""
    return clean(euler.to_matrix((first + second).upper(), [a, b]))


def fixed_axes(first, second, a, b):
    """M6 for two turns: both about axes of A."""
    return wrong_order.formula.evaluate(R_1=one_turn(first, a), R_2=one_turn(second, b))


def left_handed(first, second, a, b):
    """M7 for two turns."""
    first, second = (left_handed_turn.formula.transfer(ABOUT[axis]) for axis in (first, second))
    return first.evaluate(turn=a) @ second.evaluate(turn=b)


def wrong_way(turned):
    """Return a turn, or several, as M7 takes them."""
    return left_handed_turn.formula.replace(turn=turned)["turn"]


def all_wrong_way(**turns):
    """Return turns as M7 takes them, by their names."""
    return {name: wrong_way(turn) for name, turn in turns.items()}


def column(R, arrow):
    """Return an axis of B as seen from A."""
    return R[:, "xyz".index(arrow)]


def rest(R_AB, axis, turn):
    """Return what remains of R_AB after a first turn about an axis of A."""
    return one_turn(axis, turn).T @ R_AB


def both_ways(R):
    """Return axis and angle of a rotation, and the opposite axis with the opposite angle."""
    axis, turn = euler.to_axis_angle(R)
    return [[*axis, turn], [*-axis, -turn]]


def yaw_pitch_roll(yaw, pitch, roll):
    """Return R_AB from turns about z, the new y, and the newest x."""
    return clean(euler.to_matrix("ZYX", [yaw, pitch, roll]))


def fixed_yaw_pitch_roll(yaw, pitch, roll):
    """M6: the same turns about the axes of A."""
    turns = (one_turn(axis, angle) for axis, angle in zip("zyx", (yaw, pitch, roll), strict=True))
    return reduce(lambda R_1, R_2: wrong_order.formula.evaluate(R_1=R_1, R_2=R_2), turns)


def to_zyz(yaw, pitch, roll):
    """Return both answers of the sequence ZYZ for the same rotation."""
    return euler.solutions("ZYZ", yaw_pitch_roll(yaw, pitch, roll))


def far_from_lock(seq, R):
    """Whether a sequence is far from gimbal lock, so that a rounded matrix does no harm."""
    return not euler.is_locked(seq, R, 0.2)


def locked(seq, a, b):
    """Return a rotation at gimbal lock, where b is a quarter turn: the third turn is left out."""
    return clean(euler.to_matrix(seq, [a, b, 0]))


def regular(seq, R):
    """M8 for XYZ, YZX or ZXY: the first two angles by the formulas that fail at lock."""
    order = list(map("XYZ".index, seq))
    return ignored_lock.formula.evaluate(**named(R[np.ix_(order, order)])).ravel()


ALL = clean(euler.to_matrix("XYZ", np.pi / 2 * np.array(list(product(range(4), repeat=3)))))
QUARTERS = {format_number(R, ""): R for R in ALL}  # the 24 rotations that lead axes to axes
AXIS = one_of("x", "y", "z")
TURN = one_of(-120, -90, -60, -45, -30, 30, 45, 60, 90, 120, unit="°")
TURNS = {"a": TURN, "first": AXIS, "b": TURN, "second": AXIS}
DIRECTION = tuple(Unknown(f"{letter} of the arrow") for letter in "xyz")


def named(R):
    """Return the entries of a matrix by their names."""
    return dict(zip(ENTRIES, np.ravel(R).tolist(), strict=True))


def some(R, *places):
    """Return some entries of a matrix, each by its row and column as a reader counts them."""
    return [R[row - 1, column - 1] for row, column in places]


def for_sequence(formula, seq):
    """Return a formula of the sequence XYZ for another order of the axes, such as YZX."""
    order = ["XYZ".index(letter) for letter in seq]
    return formula.xreplace({r[i, j]: r[order[i], order[j]] for i in range(3) for j in range(3)})


def different(first, second, **_):
    """Whether two turns are about different axes."""
    return first != second


FIRST = Step(lambda first, **_: ABOUT[first], {formulas.turn: A}, values=(R_1,))
SECOND = Step(lambda second, **_: ABOUT[second], {formulas.turn: B}, values=(R_2,))
MADE = (
    "The first turn, by a = {a} about {first}, has the matrix\n\n{R_1}\n\n"
    "The second, by b = {b} about the new {second}, has\n\n{R_2}\n\n"
)

with as_written():
    BOTH = Step(LocalEquation(R_AB, R_1 * R_2), values=ENTRIES)
    MADE_ZYX = LocalEquation(R_AB, MatMul(R_z, R_y, R_x))
    AXIS_FOUND = LocalEquation(
        Matrix(formulas.n),
        Matrix([part / (2 * sin(formulas.turn)) for part in formulas.turn_vector.right]),
    )
    READ_ZYX = LocalEquation(
        Matrix(ANGLES),
        Matrix(
            [
                atan2(r[1, 0], r[0, 0]),
                atan2(-r[2, 0], sqrt(r[0, 0] ** 2 + r[1, 0] ** 2)),
                atan2(r[2, 1], r[2, 2]),
            ]
        ),
        "rad",
    )
    READ_ZYZ = LocalEquation(
        Matrix(ANGLES),
        Matrix(
            [
                atan2(r[1, 2], r[0, 2]),
                atan2(sqrt(r[0, 2] ** 2 + r[1, 2] ** 2), r[2, 2]),
                atan2(r[2, 1], -r[2, 0]),
            ]
        ),
        "rad",
    )
    LOCKED = ((1, 3), (2, 2), (3, 2))  # of XYZ, with 0 for the third angle
    ZYX = ((1, 1), (2, 1), (3, 1), (3, 2), (3, 3))  # entries with one or two angles in them
    OF_ZYX = LocalEquation(
        Matrix(some(r, *ZYX)),
        Matrix([cos(A) * cos(B), sin(A) * cos(B), -sin(B), cos(B) * sin(C), cos(B) * cos(C)]),
    )
    ZYZ = ((1, 3), (2, 3), (3, 3), (3, 1), (3, 2))
    OF_ZYZ = LocalEquation(
        Matrix(some(r, *ZYZ)),
        Matrix([cos(A) * sin(B), sin(A) * sin(B), cos(B), -sin(B) * cos(C), sin(B) * sin(C)]),
    )

euler_1 = Exercise(
    "euler-1",
    title="Where does the arrow point?",
    text="Frame B is made from frame A by two turns: first by {a} about the {first} axis, then by "
    "{b} about the new {second} axis. An arrow of length 1 points along the {arrow} axis of B. "
    "What are its x, y and z in frame A?",
    given=TURNS | {"arrow": AXIS},
    unknowns=DIRECTION,
    right=lambda arrow, **turns: column(two_turns(**turns), arrow),
    wrong={
        wrong_order: lambda arrow, **turns: column(fixed_axes(**turns), arrow),
        left_handed_turn: lambda arrow, **turns: column(left_handed(**turns), arrow),
    },
    when=different,
    likely_slips={
        "with a row of the matrix where its column belongs": lambda arrow, **turns: column(
            two_turns(**turns).T, arrow
        ),
    },
    solution=Solution(
        MADE + "Turns about new axes are multiplied in the order in which they are made:\n\n{R_AB}"
        "\n\nIts columns are the axes of B as A sees them. Times the {arrow} axis as B sees it, it "
        "gives the one that is asked for:\n\n{p_A}",
        R_1=FIRST,
        R_2=SECOND,
        R_AB=BOTH,
        p_A=Step(lambda arrow, **_: LocalEquation(SEEN, R_AB * eye(3)[:, "xyz".index(arrow)])),
    ),
)

euler_2 = Exercise(
    "euler-2",
    title="Two turns in one matrix",
    text="Frame B is frame A turned first by {a} about its {first} axis, and then by {b} about its "
    "new {second} axis. What is R_AB, the matrix whose columns are the axes of B as A sees them?",
    given=TURNS,
    unknowns=matrix("R_AB", 3, 3),
    shape=(3, 3),
    right=two_turns,
    wrong={wrong_order: fixed_axes, left_handed_turn: left_handed},
    when=different,
    solution=Solution(
        MADE + "The second turn is about an axis of the turned frame, so its matrix stands on the "
        "right:\n\n{R_AB}",
        R_1=FIRST,
        R_2=SECOND,
        R_AB=BOTH,
    ),
    example={"first": "y", "a": np.pi / 2, "second": "z", "b": np.pi / 2},
)

euler_3 = Exercise(
    "euler-3",
    title="What remains to be turned?",
    text="Frame A must be brought to frame B, with R_AB = {R_AB}. A first turn is already made, "
    "by {turn} about the {axis} axis of A. Which rotation is still needed? Give its matrix in "
    "the turned frame: its columns are the axes of B as the turned frame sees them.",
    given={
        "R_AB": one_of(*QUARTERS),
        "axis": AXIS,
        "turn": one_of(-90, 90, unit="°"),
    },
    unknowns=matrix("R", 3, 3),
    shape=(3, 3),
    right=lambda R_AB, axis, turn: rest(QUARTERS[R_AB], axis, turn),
    wrong={
        wrong_order: lambda R_AB, axis, turn: wrong_order.formula.evaluate(
            R_1=one_turn(axis, turn).T, R_2=QUARTERS[R_AB]
        ),
        left_handed_turn: lambda R_AB, axis, turn: rest(QUARTERS[R_AB], axis, wrong_way(turn)),
    },
    together={
        (wrong_order, left_handed_turn): lambda R_AB, axis, turn: wrong_order.formula.evaluate(
            R_1=one_turn(axis, wrong_way(turn)).T, R_2=QUARTERS[R_AB]
        ),
    },
    likely_slips={
        "when R_1 itself stands where its transpose belongs": lambda R_AB, axis, turn: (
            one_turn(axis, turn) @ QUARTERS[R_AB]
        ),
    },
    derive=lambda R_AB, axis, turn: {"entries": QUARTERS[R_AB]},
    solution=Solution(
        "The turn already made, by ϑ = {turn} about {axis}, has the matrix\n\n{R_1}\n\n"
        "The one that remains is about axes of the turned frame, so it must stand on the right of "
        "that:\n\n{whole.formula}\n\nTake R_1 away from the left; its inverse is its transpose:"
        "\n\n{R}",
        answer=("R",),
        R_1=Step(lambda axis, **_: ABOUT[axis], values=(R_1,)),
        R=Step(LocalEquation(REST, R_1.T * R_AB), {R_AB: "entries"}),
        whole=Step(LocalEquation(R_AB, R_1 * REST), expected=lambda R_AB, **_: QUARTERS[R_AB]),
    ),
)

euler_4 = Exercise(
    "euler-4",
    title="One turn in place of two",
    text="A camera is turned first by {a} about its {first} axis, and then by {b} about its new "
    "{second} axis. One single turn can do the same. About which axis n (a vector of length 1, as "
    "seen before the turns), and by what angle ϑ? The opposite axis with the opposite angle is "
    "also right.",
    given=TURNS,
    unknowns=(Unknown("n_x"), Unknown("n_y"), Unknown("n_z"), angle("ϑ")),
    accept="any",
    right=lambda **turns: both_ways(two_turns(**turns)),
    wrong={
        wrong_order: lambda **turns: both_ways(fixed_axes(**turns)),
        left_handed_turn: lambda **turns: both_ways(left_handed(**turns)),
    },
    together={
        (wrong_order, left_handed_turn): lambda first, second, a, b: both_ways(
            fixed_axes(first, second, wrong_way(a), wrong_way(b))
        ),
    },
    when=different,
    solution=Solution(
        MADE + "Both turns in one matrix, multiplied in the order in which they are made:\n\n{R_AB}"
        "\n\nSubtract the entries on the two sides of its diagonal (r_32 is the entry in row 3 and "
        "column 2). This gives a vector along the axis, as long as twice the sine of the angle. "
        "The sum of the diagonal, less 1, is twice the cosine:\n\n{turn}\n\n"
        "That is {turn.value:deg}. Divide the vector by its length to have the axis:\n\n{n}\n\n"
        "The opposite axis with the opposite angle is the other answer. So axis and angle are\n\n"
        "{right}",
        answer=(("n", "turn"),),
        R_1=FIRST,
        R_2=SECOND,
        R_AB=BOTH,
        turn=Step(formulas.turn_angle, values=(formulas.turn,), unit="rad"),
        n=Step(AXIS_FOUND),
    ),
)

euler_5 = Exercise(
    "euler-5",
    title="Yaw, pitch and roll",
    text="A drone was turned from frame A: first by a (yaw) about its z axis, then by b (pitch) "
    "about its new y axis, then by c (roll) about the x axis after both turns. The result, "
    "rounded to four decimals, is R_AB = {R}. Which a, b, c can it have been? There are two "
    "answers: give both.",
    given={
        "yaw": one_of(*range(-150, 0, 30), *range(30, 180, 30), -45, 45, 135, unit="°"),
        "pitch": one_of(-60, -45, -30, 30, 45, 60, unit="°"),
        "roll": one_of(-120, -60, -45, -30, 30, 45, 60, 120, unit="°"),
    },
    unknowns=(angle("a"), angle("b"), angle("c")),
    accept="all",
    right=lambda **turns: euler.solutions("ZYX", yaw_pitch_roll(**turns)),
    wrong={
        wrong_order: lambda **turns: euler.solutions("zyx", yaw_pitch_roll(**turns)),
        left_handed_turn: lambda **turns: wrong_way(
            euler.solutions("ZYX", yaw_pitch_roll(**turns))
        ),
    },
    when=lambda **turns: far_from_lock("zyx", yaw_pitch_roll(**turns)),
    derive=lambda **turns: {
        "R": yaw_pitch_roll(**turns),
        **named(yaw_pitch_roll(**turns)),
    },
    likely_slips={
        "for the matrix with rows and columns swapped": lambda **angles: euler.solutions(
            "ZYX", yaw_pitch_roll(**angles).T
        ),
    },
    solution=Solution(
        "r_21 is the entry in row 2 and column 1, and so on. Multiplied out, the three turns make "
        "these entries:\n\n{made.formula}\n\nTwo entries with the sine and the cosine of the same "
        "angle, both times the same positive number, give that angle. With cos b > 0, which is the "
        "root of the sum of the first two squares:\n\n{angles}\n\nWith cos b < 0 both numbers "
        "change their signs for a and for c: these angles are half a turn away. For b only the "
        "second number does:\n\n{other}\n\nBoth answers, with angles between −π and π:\n\n"
        "{right}",
        answer=("angles", "other"),
        angles=Step(READ_ZYX),
        other=Step(formulas.other_cardan, RENAMED, values=OTHER, unit="rad"),
        made=Step(OF_ZYX, expected=lambda **turns: some(yaw_pitch_roll(**turns), *ZYX)),
    ),
)

euler_6 = Exercise(
    "euler-6",
    title="At gimbal lock",
    text="Frame A is brought to frame B by three turns in the sequence {seq}, each about an axis "
    "of the frame as turned so far. The result, rounded to four decimals, is R_AB = {R}. Here "
    "the sequence is at gimbal lock: many triples of angles make the same rotation. Choose 0 for "
    "the third angle. What are the first and the second?",
    given={
        "seq": one_of("XYZ", "YZX", "ZXY"),
        "a": one_of(*range(-165, 0, 15), *range(15, 180, 15), unit="°"),
        "b": one_of(-90, 90, unit="°"),
    },
    unknowns=(angle("first"), angle("second")),
    right=lambda seq, a, b: euler.from_matrix(seq, locked(seq, a, b))[:2],
    wrong={
        left_handed_turn: lambda seq, a, b: wrong_way(
            euler.from_matrix(seq, locked(seq, a, b))[:2]
        ),
        ignored_lock: lambda seq, a, b: regular(seq, locked(seq, a, b)),
    },
    derive=lambda seq, a, b: {"R": locked(seq, a, b), **named(locked(seq, a, b))},
    solution=Solution(
        "r_21 is the entry in row 2 and column 1, and so on. With 0 for the third angle, turns by "
        "α and β make these entries:\n\n{made.formula}\n\nThe sine of β is 1 or −1 here, so the "
        "cosine of β is zero, and with it all entries from which the first and the third angle are "
        "read otherwise. But the second turn leaves its own axis where the first one took it: in "
        "that column stand the sine and the cosine of α.\n\n{angles}",
        answer=("angles",),
        angles=Step(
            lambda seq, **_: LocalEquation(
                Matrix([formulas.first, formulas.middle]),
                for_sequence(Matrix([formulas.third_first.right[1], asin(r[0, 2])]), seq),
                "rad",
            ),
            {formulas.gamma: 0},
        ),
        made=Step(
            lambda seq, **_: LocalEquation(
                for_sequence(Matrix(some(r, *LOCKED)), seq),
                Matrix([sin(formulas.middle), cos(formulas.first), sin(formulas.first)]),
            ),
            expected=lambda seq, a, b: [
                locked(seq, a, b)["XYZ".index(seq[i - 1]), "XYZ".index(seq[j - 1])]
                for i, j in LOCKED
            ],
        ),
    ),
    example={"seq": "XYZ", "a": np.pi / 2, "b": np.pi / 2},
)

euler_7 = Exercise(
    "euler-7",
    title="From one sequence to another",
    text="A drone's program says how its camera is turned by yaw {yaw}, pitch {pitch} and roll "
    "{roll}: about z, the new y, and the x axis after both turns. The camera's stand wants "
    "angles for the sequence ZYZ: about z, the new y, and the z axis after both turns. Which "
    "angles make the same rotation? There are two answers; either of them is enough.",
    given={
        "yaw": one_of(*range(-150, 0, 30), *range(30, 180, 30), unit="°"),
        "pitch": one_of(-60, -45, -30, 30, 45, 60, unit="°"),
        "roll": one_of(-120, -90, -60, -45, -30, 30, 45, 60, 90, 120, unit="°"),
    },
    unknowns=(angle("first"), angle("second"), angle("third")),
    accept="any",
    right=to_zyz,
    wrong={
        wrong_order: lambda **turns: euler.solutions("ZYZ", fixed_yaw_pitch_roll(**turns)),
        left_handed_turn: lambda **turns: to_zyz(**all_wrong_way(**turns)),
    },
    when=lambda **turns: (
        far_from_lock("ZYZ", yaw_pitch_roll(**turns))
        and far_from_lock("ZYZ", fixed_yaw_pitch_roll(**turns))
    ),
    likely_slips={
        "with the matrices in the wrong order in both sequences": lambda **turns: euler.solutions(
            "zyz", fixed_yaw_pitch_roll(**turns)
        ),
        "with left-handed turns in both sequences": lambda **turns: wrong_way(
            to_zyz(**all_wrong_way(**turns))
        ),
        "for the way back, from B to A": lambda **angles: euler.solutions(
            "ZYZ", yaw_pitch_roll(**angles).T
        ),
    },
    solution=Solution(
        "The rotation is the same, so both sequences have the same matrix. First make it:\n\n"
        "{R_z}\n\n{R_y}\n\n{R_x}\n\n{R_AB}\n\nThen read the other angles from it. Turns by a, b, c "
        "about z, the new y and the z axis after both turns make these entries (r_13 is in row 1 "
        "and column 3):\n\n{made.formula}\n\nTwo entries with the sine and the cosine of the same "
        "angle, both times the same positive number, give that angle. With sin b > 0, which is the "
        "root of the sum of the first two squares:\n\n{angles}\n\nWith sin b < 0 both numbers "
        "change their signs for a and for c: these angles are half a turn away. For b only the "
        "first number does:\n\n{other}\n\nEither of them, with angles between −π and π:"
        "\n\n{right}",
        answer=("angles", "other"),
        R_z=Step(formulas.turn_z, {formulas.turn: YAW}, values=(R_z,)),
        R_y=Step(formulas.turn_y, {formulas.turn: PITCH}, values=(R_y,)),
        R_x=Step(formulas.turn_x, {formulas.turn: ROLL}, values=(R_x,)),
        R_AB=Step(MADE_ZYX, values=ENTRIES, expected=yaw_pitch_roll),
        angles=Step(READ_ZYZ),
        other=Step(formulas.other_proper, RENAMED, values=OTHER, unit="rad"),
        made=Step(OF_ZYZ, expected=lambda **turns: some(yaw_pitch_roll(**turns), *ZYZ)),
    ),
)
