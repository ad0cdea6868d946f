"""Exercises on chains of frames, and the mistakes that are made there."""

import numpy as np
from sympy import Matrix, MatrixSymbol, atan2, cos, sin, sqrt, symbols

from book.frames import formulas
from book.frames.formulas import SOUGHT, sought
from book.motion.formulas import theta
from courseware.answers import Unknown, angle
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
from robokin import frames

T_db, T_de, T_bc, T_cb, T_bd, T_cd, T_ce = (
    MatrixSymbol(f"T_{way}", 3, 3) for way in ("db", "de", "bc", "cb", "bd", "cd", "ce")
)
R, p, q = MatrixSymbol("R", 2, 2), MatrixSymbol("p", 2, 1), MatrixSymbol("q", 2, 1)
FROM_HAND = LocalEquation(T_ce, T_bc.inv() * T_db.inv() * T_de)
WAY_BACK = LocalEquation(q, -R.T * p)

no_inverse = Mistake(
    "M9",
    feedback="when the poses are multiplied as they are given and none is inverted",
    formula=WrongFormula(FROM_HAND, instead=T_db * T_bc * T_de),
    line="T_ce = T_db @ T_bc @ T_de",
    why="c meets d: there the letters break; and the product starts in d, not in c. In "
    "T_ce = T_cb T_bd T_de they meet. So both poses given, T_bc and T_db, must be inverted first.",
    unnoticed="Where T_db T_bc is its own inverse, as a half turn in the plane is: in the figure "
    "with a heading of 120°.",
    title="No inverse",
    picture=(
        "The object lies on the left. With the platform at 90° the hand's program believes it "
        "further up, and turned."
    ),
)
unturned_shift = Mistake(
    "M10",
    feedback="when an inverse is made with −p in place of −Rᵀp",
    formula=WrongFormula(WAY_BACK, instead=-p),
    line="def back(T):\n"
    "    return np.block([[T[:2, :2].T, -T[:2, 2:]], [0, 0, 1]])\n"
    "T_ce = back(T_bc) @ back(T_db) @ T_de",
    why="−p is the way back measured along the axes of the first frame. The inverse is seen from "
    "the second frame, so the way back must be turned as well: −Rᵀp.",
    unnoticed="Where each of the two poses is only a shift (R is the identity), or only a turn.",
    title="Inverses by hand",
    picture=(
        "The object lies on the left. The hand's program believes it on the right of the platform."
    ),
)
same_order = Mistake(
    "M11",
    feedback="when T_db T_bc is inverted as T_db⁻¹ T_bc⁻¹, in the same order",
    formula=WrongFormula(FROM_HAND, instead=T_db.inv() * T_bc.inv() * T_de),
    line="T_ce = np.linalg.inv(T_db) @ np.linalg.inv(T_bc) @ T_de",
    why="Undo the last step first: who puts on socks, then shoes, takes off the shoes first. So "
    "the inverse of T_db T_bc is T_bc⁻¹ T_db⁻¹, in the opposite order.",
    unnoticed="Where both poses are pure shifts, or both are turns about the same point.",
    title="Two inverses",
    picture="The object lies on the left. The hand's program believes it nearer to the hand.",
)
T_bc_kept = Mistake(
    "M30",
    feedback="when T_bc is left as it is where its inverse belongs",
    formula=WrongFormula(FROM_HAND, instead=T_bc * T_db.inv() * T_de),
    line="T_ce = T_bc @ np.linalg.inv(T_db) @ T_de",
    why="The product would start in b and end in e, with c and b side by side in the middle: "
    "T_bc T_bd. From c to b leads T_cb, the inverse of T_bc.",
    unnoticed="Where T_bc is its own inverse, as a half turn is.",
    title="One inverse",
    picture=(
        "The object lies on the left. The hand's program believes it below the hand, and turned."
    ),
    document="001 Q3",
    place="the last line",
    nth=1,
    quote="T_bc¹ T_db⁻¹ T_de = T_ce",
    correction="T_bc«⁻¹» T_db⁻¹ T_de = T_ce",
    explanation="The exponent has lost its minus, perhaps only in the copy. As it stands, the "
    "product starts in b and ends in e, with c and b side by side in the middle: T_bc T_bd. From "
    "c to b leads T_cb, the inverse of T_bc.",
)

POSE = (Unknown("x", "m"), Unknown("y", "m"), angle("θ"))
UPPER, FORE = 0.3, 0.4  # the links of the arm


def entries(name):
    """Return the nine numbers of a planar pose's matrix: only the position has a unit."""
    return tuple(
        Unknown(f"{name}[{i}, {j}]", "m" if (i < 2 and j == 2) else "")
        for i in range(3)
        for j in range(3)
    )


def numbers_of(T):
    """Return the pose [x, y, theta] of a matrix."""
    return [T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])]


def wrist(alpha, beta):
    """Return where the hand is, as the platform sees it."""
    return UPPER * np.array([np.cos(alpha), np.sin(alpha)]) + FORE * np.array(
        [np.cos(alpha + beta), np.sin(alpha + beta)]
    )


def hand(alpha, beta, gamma):
    """Return T_bc: the hand as the platform sees it."""
    return frames.se2(*wrist(alpha, beta), alpha + beta + gamma)


def shifted_back(T):
    """M10: the inverse with −p, in the plane or in space."""
    n = len(T) - 1
    out = np.eye(n + 1)
    out[:n, :n] = T[:n, :n].T
    out[:n, n] = unturned_shift.formula.evaluate(p=T[:n, n])
    return out


def planar(**given):
    """Return the poses of an exercise as matrices: T_db, T_de, and T_bc from the arm's angles."""
    found = {}
    if "x_b" in given:
        found["T_db"] = frames.se2(given["x_b"], given["y_b"], given["theta_b"])
    if "x_e" in given:
        found["T_de"] = frames.se2(given["x_e"], given["y_e"], given["theta_e"])
    if "alpha" in given:
        found["T_bc"] = hand(given["alpha"], given["beta"], given["gamma"])
    return found


def posed(formula):
    """Return a formula of matrices as one of the numbers given, for the pose [x, y, theta]."""
    return lambda **given: numbers_of(formula(**planar(**given)))


def matrices(formula):
    """Return a formula of matrices as one of the numbers given."""
    return lambda **given: formula(**planar(**given))


def from_hand(mistake):
    """Return T_ce by a mistake, as a formula of the numbers given."""
    formula = WrongFormula(
        FROM_HAND, instead=mistake.substitute({T_bc.inv(): T_cb, T_db.inv(): T_bd})
    )
    return matrices(
        lambda T_db, T_bc, T_de: formula.evaluate(
            T_db=T_db, T_bc=T_bc, T_de=T_de, T_cb=frames.inverse(T_bc), T_bd=frames.inverse(T_db)
        )
    )


def at_point(formula):
    """Return a formula of T_bc and a point, as one of the numbers given."""
    return lambda x, y, **arm: formula(hand(**arm), np.array([x, y]))


def by_hand(formula):
    """Return a formula of T_db and T_bc, where the pose of the hand is given as numbers."""
    return lambda x, y, theta, **given: formula(
        T_bc=frames.se2(x, y, theta), T_db=planar(**given)["T_db"]
    )


def looking_down(x_b, y_b, height, heading):
    """Return T_fb for a camera that looks straight down, its x axis along the room's."""
    c, s = np.cos(heading), np.sin(heading)
    return frames.se3([[c, -s, 0], [-s, -c, 0], [0, 0, -1]], [x_b, y_b, height])


def from_above(formula):
    """Return a formula of T_fb in space and a point, as one of the numbers given."""
    return lambda x_b, y_b, height, heading, x_e, y_e, z_e: formula(
        looking_down(x_b, y_b, height, heading), np.array([x_e, y_e, z_e])
    )


PLACE = number_range(-2, 2, 0.2, "m")
TURN = one_of(*range(-150, 0, 10), *range(10, 160, 10), unit="°")
ARM = {
    "alpha": number_range(-60, 60, 10, "°"),
    "beta": one_of(*range(-120, -20, 10), *range(30, 130, 10), unit="°"),
    "gamma": number_range(-60, 60, 10, "°"),
}
PLATFORM = {"x_b": PLACE, "y_b": PLACE, "theta_b": TURN}
OBJECT = {"x_e": PLACE, "y_e": PLACE, "theta_e": TURN}

PLAN = (
    "A plan shows a room from above. On it a camera d is a frame like all others: an origin with "
    "an x and a y axis. It sees "
)
TURNED = (
    "“Turned by” is the angle from the x axis of the frame that sees to the x axis of the frame "
    "that is seen, counter-clockwise positive."
)
PLATFORM_SEEN = "the platform b at x = {x_b}, y = {y_b}, turned by {theta_b}"
OBJECT_SEEN = "the object e at x = {x_e}, y = {y_e}, turned by {theta_e}"
ARM_STANDS = (
    "The arm on a platform b has links of 30 cm and 40 cm; its first joint is at the origin of b. "
    "The joint angles are α = {alpha}, β = {beta}, γ = {gamma}, counter-clockwise positive, each "
    "counted from the link before (α from the platform's x axis). The hand frame c lies at the end "
    "of the second link, turned by γ from this link."
)
ARM_FOUND = (
    "The hand as the platform sees it, link by link; each angle adds to those before:\n\n{hand}\n\n"
)

# The formulas of the chapter speak of the poses db, de and bc; here is what each is given.
UNITS = ("m", "m", "rad")
DB = (formulas.db_x, formulas.db_y, formulas.db_turn)
DE = (formulas.de_x, formulas.de_y, formulas.de_turn)
BC = (formulas.bc_x, formulas.bc_y, formulas.bc_turn)
PLATFORM_IS = dict(zip(DB, PLATFORM, strict=True))
OBJECT_IS = dict(zip(DE, OBJECT, strict=True))
HAND = Step(
    formulas.hand_pose,
    {formulas.alpha: "alpha", formulas.beta: "beta", formulas.gamma: "gamma"}
    | {formulas.l_1: UPPER, formulas.l_2: FORE},
    unit=UNITS,
)
R_fb, P, P_b = MatrixSymbol("R_fb", 3, 3), MatrixSymbol("p", 3, 1), MatrixSymbol("p_b", 3, 1)
t = Matrix(3, 3, symbols("t_{11} t_{12} t_{13} t_{21} t_{22} t_{23} t_{31} t_{32} t_{33}"))
FB, FE = (formulas.fb_x, formulas.fb_y, formulas.fb_z), symbols("x_{fe} y_{fe} z_{fe}")
PLATFORM_BELOW = dict(zip(FB, ("x_b", "y_b", "height"), strict=True))
OBJECT_BELOW = dict(zip(FE, ("x_e", "y_e", "z_e"), strict=True))

with as_written():
    AWAY = LocalEquation(P, Matrix([there - here for here, there in zip(FB, FE, strict=True)]), "m")
    POSE_OF = LocalEquation(sought("db"), Matrix([t[0, 2], t[1, 2], atan2(t[1, 0], t[0, 0])]))


def called(pose, way):
    """Return the letters of a pose in a formula, and those of another pose in their place."""
    return dict(zip(pose, sought(way), strict=True))


def matrix_of(way, names=()):
    """Return the step that makes a planar pose a matrix. names: what its numbers are given as."""
    given = called(DB, way) | dict(zip(sought(way), names, strict=False))
    return Step(formulas.matrix, given, values=(MatrixSymbol(f"T_{way}", 3, 3),))


def both_inverses(T_db, T_bc):
    """M10 for T_cd: both poses inverted in the wrong way, or their product."""
    back = shifted_back(T_bc) @ shifted_back(T_db), shifted_back(T_db @ T_bc)
    return [numbers_of(T) for T in back]


def one_wrong_inverse(T_db, T_bc):
    """M10 in one of the two inverses: T_cb and T_bd, of which the one or the other is wrong."""
    return [
        (shifted_back(T_bc), frames.inverse(T_db)),
        (frames.inverse(T_bc), shifted_back(T_db)),
    ]


GAP, BOX_X, BOX_Y = symbols("gap x_box y_box")
APART = sqrt((SOUGHT["x_dp"] - BOX_X) ** 2 + (SOUGHT["y_dp"] - BOX_Y) ** 2)


def gap_of(there, x, y):
    """Return the distance of a place from another one."""
    return np.hypot(there[0] - x, there[1] - y)


def in_graph(formula):
    """Return a formula of T_rd, T_rb and a point, as one of the numbers given."""
    return lambda x_d, y_d, theta_d, x_b, y_b, theta_b, x, y: formula(
        frames.se2(x_d, y_d, theta_d), frames.se2(x_b, y_b, theta_b), np.array([x, y])
    )


AS_SEEN, AS_TURNED = symbols("x_b y_b"), symbols("x_a y_a")
TURNED_BY, POINT_X, POINT_Y = symbols("theta x y")
TURN_GIVEN = {TURNED_BY: "theta_b", POINT_X: "x", POINT_Y: "y"}


def about(angle):
    """Return a point that is turned by an angle, as an expression."""
    with as_written():
        return Matrix(
            [
                POINT_X * cos(angle) - POINT_Y * sin(angle),
                POINT_X * sin(angle) + POINT_Y * cos(angle),
            ]
        )


def turned_both_ways(formula):
    """Return a formula of a point seen from b and of one turned, as one of the numbers given."""
    return lambda theta_b, x, y: formula(
        *(frames.transform(frames.se2(0, 0, turn), [x, y]) for turn in (-theta_b, theta_b))
    )


IN_PICTURE = symbols("ahead left")
PSI, *PLACES = symbols("psi x_b y_b x_e y_e")
PICTURE_GIVEN = {PSI: "psi"} | {each: str(each) for each in PLACES}
with as_written():
    _dx, _dy = PLACES[2] - PLACES[0], PLACES[3] - PLACES[1]
    PICTURE = Matrix([_dx * cos(PSI) + _dy * sin(PSI), _dx * sin(PSI) - _dy * cos(PSI)])


def in_picture(formula):
    """Return a formula of what the platform sees, from places in a picture with y down."""
    return lambda x_b, y_b, psi, x_e, y_e: formula(
        *frames.transform(frames.inverse(frames.se2(x_b, -y_b, -psi)), [x_e, -y_e])
    )


ONE_BACK = "with −p in place of −Rᵀp in one of the two inverses"
ONLY_HAND = "when only T_bc is inverted, and T_db stays as it is"

frames_1 = Exercise(
    "frames-1",
    title="Seen from the other end",
    text=f"{PLAN}{PLATFORM_SEEN}. {TURNED} How does the platform see the camera: at what x and y, "
    "and turned by what angle?",
    given=PLATFORM,
    unknowns=POSE,
    right=posed(lambda T_db: frames.inverse(T_db)),
    wrong={unturned_shift: posed(lambda T_db: shifted_back(T_db))},
    likely_slips={
        "for the platform as the camera sees it: nothing is turned back": posed(lambda T_db: T_db),
    },
    solution=Solution(
        "Seen from the other end, the turn goes the other way. The position is the way back, from "
        "the platform to the camera. It is known along the axes of the camera; the transposed "
        "rotation turns it to the axes of the platform.\n\n{back}",
        back=Step(formulas.turned_round, PLATFORM_IS, unit=UNITS),
    ),
)

frames_2 = Exercise(
    "frames-2",
    title="What the hand sees",
    text=f"{ARM_STANDS} The platform sees an object at x = {{x}}, y = {{y}}. Where does the hand "
    "see it, along the x and y axes of c?",
    given=ARM | {"x": number_range(0.2, 1, 0.1, "m"), "y": number_range(-0.8, 0.8, 0.1, "m")},
    unknowns=(Unknown("x", "m"), Unknown("y", "m")),
    right=at_point(lambda T_bc, p: frames.transform(frames.inverse(T_bc), p)),
    wrong={
        unturned_shift: at_point(lambda T_bc, p: frames.transform(shifted_back(T_bc), p)),
        T_bc_kept: at_point(lambda T_bc, p: frames.transform(T_bc, p)),
    },
    solution=Solution(
        ARM_FOUND + "From the hand to the object leads the difference of the two positions, still "
        "along the axes of b. The transposed rotation of the hand turns it to the axes of c:"
        "\n\n{seen}",
        hand=HAND,
        seen=Step(
            formulas.object_seen,
            called(DB, "bc") | called(DE, "be") | dict(zip(sought("be"), "xy", strict=False)),
            values=tuple(sought("ce")[:2]),
            unit="m",
            part=(0, 1),
        ),
    ),
)

frames_3 = Exercise(
    "frames-3",
    title="What the platform sees",
    text=f"{PLAN}{PLATFORM_SEEN}, and {OBJECT_SEEN}. {TURNED} How does the platform see the "
    "object: at what x and y, and turned by what angle?",
    given=PLATFORM | OBJECT,
    unknowns=POSE,
    right=posed(lambda T_db, T_de: frames.compose(frames.inverse(T_db), T_de)),
    wrong={
        no_inverse: posed(lambda T_db, T_de: T_db @ T_de),
        unturned_shift: posed(lambda T_db, T_de: shifted_back(T_db) @ T_de),
    },
    likely_slips={
        "along the camera's axes; asked are the platform's": lambda x_b, y_b, x_e, y_e, **turns: [
            x_e - x_b,
            y_e - y_b,
            turns["theta_e"] - turns["theta_b"],
        ],
        "for the platform as the object sees it": posed(
            lambda T_db, T_de: frames.compose(frames.inverse(T_de), T_db)
        ),
    },
    solution=Solution(
        "From b to e the way leads over d, so the pose of b must be seen from the other end. "
        "From the platform to the object leads the difference of the two positions, along the "
        "camera's axes; the transposed rotation turns it to the axes of the platform. The object "
        "is turned relative to the platform by the difference of the two angles.\n\n{seen}\n\n"
        "With the angle between −π and π, that is {right}.",
        seen=Step(formulas.object_seen, PLATFORM_IS | OBJECT_IS, unit=UNITS),
    ),
)

frames_4 = Exercise(
    "frames-4",
    title="The camera as the hand sees it",
    text=f"{PLAN}{PLATFORM_SEEN}. The platform sees the hand c of its arm at x = {{x}}, y = {{y}}, "
    f"turned by {{theta}}. {TURNED} How does the hand see the camera: at what x and y, and turned "
    "by what angle?",
    given=PLATFORM
    | {
        "x": number_range(0.1, 0.7, 0.1, "m"),
        "y": number_range(-0.5, 0.5, 0.1, "m"),
        "theta": TURN,
    },
    unknowns=POSE,
    right=by_hand(lambda T_db, T_bc: numbers_of(frames.inverse(frames.compose(T_db, T_bc)))),
    wrong={
        no_inverse: by_hand(lambda T_db, T_bc: numbers_of(T_db @ T_bc)),
        unturned_shift: by_hand(both_inverses),
        same_order: by_hand(
            lambda T_db, T_bc: numbers_of(frames.inverse(T_db) @ frames.inverse(T_bc))
        ),
        T_bc_kept: by_hand(lambda T_db, T_bc: numbers_of(T_bc @ frames.inverse(T_db))),
    },
    likely_slips={
        ONE_BACK: by_hand(
            lambda T_db, T_bc: [numbers_of(back @ to) for back, to in one_wrong_inverse(T_db, T_bc)]
        ),
        ONLY_HAND: by_hand(lambda T_db, T_bc: numbers_of(frames.inverse(T_bc) @ T_db)),
    },
    derive=by_hand(lambda T_db, T_bc: {"T_db": T_db, "T_bc": T_bc}),
    solution=Solution(
        "First from the camera to the hand: the platform's pose, then the hand's, in this order."
        "\n\n{there}\n\nThen from the other end: the turn goes the other way, and the position is "
        "the way back, measured along the axes of the hand:\n\n{back}\n\nWith the angle between −π "
        "and π, that is {right}.\n\nIt is the same to see both poses from the other end first and "
        "to join them then. But the order is the other one: from the hand to the platform, then "
        "from the platform to the camera.\n\n{matrix.formula}",
        answer=("back",),
        there=Step(
            formulas.chained,
            PLATFORM_IS | dict(zip(BC, ("x", "y", "theta"), strict=True)),
            unit=UNITS,
        ),
        back=Step(formulas.turned_round, called(DB, "dc"), values=tuple(sought("cd")), unit=UNITS),
        matrix=Step(
            LocalEquation(T_cd, T_bc.inv() * T_db.inv()),
            expected=by_hand(lambda T_db, T_bc: frames.inverse(frames.compose(T_db, T_bc))),
        ),
    ),
)

frames_5 = Exercise(
    "frames-5",
    title="All the way to the object",
    text=f"{ARM_STANDS}\n\n{PLAN}{PLATFORM_SEEN}, and {OBJECT_SEEN}. {TURNED} What is T_ce, "
    "the pose of the object as the hand sees it, as a 3×3 matrix?",
    given=ARM | PLATFORM | OBJECT,
    unknowns=entries("T_ce"),
    shape=(3, 3),
    right=matrices(
        lambda T_db, T_bc, T_de: frames.compose(frames.inverse(T_bc), frames.inverse(T_db), T_de)
    ),
    wrong={
        no_inverse: from_hand(no_inverse),
        unturned_shift: matrices(
            lambda T_db, T_bc, T_de: shifted_back(T_bc) @ shifted_back(T_db) @ T_de
        ),
        same_order: from_hand(same_order),
        T_bc_kept: from_hand(T_bc_kept),
    },
    derive=planar,
    likely_slips={
        "with −p for −Rᵀp in the inverse of the product T_db T_bc": matrices(
            lambda T_db, T_bc, T_de: shifted_back(T_db @ T_bc) @ T_de
        ),
        ONE_BACK: matrices(
            lambda T_db, T_bc, T_de: [
                back @ to @ T_de for back, to in one_wrong_inverse(T_db, T_bc)
            ]
        ),
        "for the object as the platform sees it": matrices(
            lambda T_db, T_bc, T_de: frames.compose(frames.inverse(T_db), T_de)
        ),
        "for the hand as the object sees it": matrices(
            lambda T_db, T_bc, T_de: frames.compose(frames.inverse(T_de), T_db, T_bc)
        ),
    },
    solution=Solution(
        ARM_FOUND + "The three poses that are known, as matrices:\n\n{T_bc}\n\n{T_db}\n\n{T_de}\n\n"
        "From c to e the way leads via b and d, so that equal letters meet. The first two steps "
        "of it are known from the other end: turned back by the transposed rotation, at the way "
        "back, measured along the axes of c and of b.\n\n{T_cb}\n\n{T_bd}\n\n{T_ce}",
        hand=HAND,
        T_bc=matrix_of("bc"),
        T_db=matrix_of("db", PLATFORM),
        T_de=matrix_of("de", OBJECT),
        T_cb=Step(LocalEquation(T_cb, T_bc.inv())),
        T_bd=Step(LocalEquation(T_bd, T_db.inv())),
        T_ce=Step(LocalEquation(T_ce, T_cb * T_bd * T_de)),
    ),
    example={
        **{"alpha": np.pi / 6, "beta": np.pi / 3, "gamma": -np.pi / 6},
        **{"x_b": 2.0, "y_b": 1.0, "theta_b": np.pi / 2},
        **{"x_e": 1.0, "y_e": 2.0, "theta_e": np.pi / 4},
    },
)

frames_6 = Exercise(
    "frames-6",
    title="A camera that looks down",
    text="A camera f hangs {height} above the floor and looks straight down. Its x axis is that of "
    "the room, its z axis points to the floor, so its y axis is opposite to the room's y axis. It "
    "sees a platform b on the floor at x = {x_b}, y = {y_b}, z = {height}, and an object on a "
    "table at x = {x_e}, y = {y_e}, z = {z_e}. The platform's z axis points up, and its heading θ "
    "in the room is {heading} (counter-clockwise, seen from above). Where does the platform see "
    "the object?",
    given={
        "height": number_range(2.4, 3.2, 0.1, "m"),
        "x_b": PLACE,
        "y_b": PLACE,
        "heading": TURN,
        "x_e": PLACE,
        "y_e": PLACE,
        "z_e": number_range(1.4, 2.6, 0.1, "m"),
    },
    when=lambda height, z_e, **_: 0.55 < height - z_e < 1.05,  # a table
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), Unknown("z", "m")),
    right=from_above(lambda T_fb, p: frames.transform(frames.inverse(T_fb), p)),
    wrong={
        no_inverse: from_above(lambda T_fb, p: frames.transform(T_fb, p)),
        unturned_shift: from_above(lambda T_fb, p: frames.transform(shifted_back(T_fb), p)),
    },
    likely_slips={
        "along the camera's axes; asked are the platform's": from_above(
            lambda T_fb, p: p - T_fb[:3, 3]
        ),
        "when z is still counted down, as the camera counts it": from_above(
            lambda T_fb, p: frames.transform(frames.inverse(T_fb), p) * [1, 1, -1]
        ),
    },
    solution=Solution(
        "With the heading θ, the columns of R_fb are the platform's axes as the camera sees them: "
        "forward, left and up. The sine in forward has a minus, because the camera's y axis is "
        "opposite to the room's; up is opposite to the camera's z axis.\n\n{R_fb}\n\n"
        "From the platform to the object leads, along the camera's axes,\n\n{p}\n\n"
        "The transpose, here the same matrix, turns this to the platform's axes:\n\n{seen}",
        R_fb=Step(LocalEquation(R_fb, formulas.looking_down.right[:3, :3]), {theta: "heading"}),
        p=Step(AWAY, PLATFORM_BELOW | OBJECT_BELOW),
        seen=Step(LocalEquation(P_b, R_fb.T * P, "m")),
    ),
)

frames_7 = Exercise(
    "frames-7",
    title="Where must the platform stand?",
    text=f"{ARM_STANDS}\n\n{PLAN}{OBJECT_SEEN}. {TURNED} The arm's joints do not move. Where must "
    "the platform stand so that the frames c and e coincide: at what x and y, and turned by what "
    "angle, must the camera see it?",
    given=ARM | OBJECT,
    unknowns=POSE,
    right=posed(lambda T_de, T_bc: frames.compose(T_de, frames.inverse(T_bc))),
    wrong={
        unturned_shift: posed(lambda T_de, T_bc: T_de @ shifted_back(T_bc)),
        T_bc_kept: posed(lambda T_de, T_bc: T_de @ T_bc),
    },
    likely_slips={
        "for the camera as the platform sees it": posed(
            lambda T_de, T_bc: frames.compose(T_bc, frames.inverse(T_de))
        ),
    },
    solution=Solution(
        ARM_FOUND + "That pose and the object's, as matrices:\n\n{T_bc}\n\n{T_de}\n\n"
        "The hand lies on the object, turned as it is, when the platform's pose, then the hand's, "
        "make the object's:\n\n{lies.formula}\n\nMultiply by the inverse of T_bc from the right:"
        "\n\n{T_db}\n\nIts last column holds the position, its first the cosine and the sine of "
        "the angle:\n\n{pose}",
        answer=("pose",),
        hand=HAND,
        T_bc=matrix_of("bc"),
        T_de=matrix_of("de", OBJECT),
        T_db=Step(LocalEquation(T_db, T_de * T_bc.inv()), values=tuple(map(str, t))),
        pose=Step(POSE_OF, unit=UNITS),
        lies=Step(LocalEquation(T_de, T_db * T_bc), expected=matrices(lambda T_de, T_bc: T_de)),
    ),
)

frames_8 = Exercise(
    "frames-8",
    title="Is it the same box?",
    text=f"{PLAN}{PLATFORM_SEEN}, and a box at x = {{x_e}}, y = {{y_e}}. {TURNED} A camera on the "
    "platform sees a box, too, at x = {x}, y = {y} along the platform's axes. If it is the same "
    "box, the loop d–b–box–d must close. How far apart are the two places?",
    given=PLATFORM
    | {"x_e": PLACE, "y_e": PLACE}
    | {"x": number_range(0.3, 1.2, 0.1, "m"), "y": number_range(-0.8, 0.8, 0.1, "m")},
    unknowns=(Unknown("gap", "m"),),
    right=lambda x_e, y_e, x, y, **platform: [
        gap_of(frames.transform(planar(**platform)["T_db"], [x, y]), x_e, y_e)
    ],
    wrong={
        T_bc_kept: lambda x_e, y_e, x, y, **platform: [
            gap_of(frames.transform(frames.inverse(planar(**platform)["T_db"]), [x, y]), x_e, y_e)
        ],
    },
    likely_slips={
        "when x and y are added although the axes of b are turned": (
            lambda x_e, y_e, x, y, x_b, y_b, theta_b: [gap_of([x_b + x, y_b + y], x_e, y_e)]
        ),
    },
    solution=Solution(
        "By the way over the platform the box is, seen from d, at\n\n{there}\n\nThe camera d sees "
        "it elsewhere. The two places are apart by\n\n{gap}",
        there=Step(
            formulas.point, PLATFORM_IS | {formulas.bp_x: "x", formulas.bp_y: "y"}, unit=("m", "m")
        ),
        gap=Step(LocalEquation(GAP, APART, "m"), {BOX_X: "x_e", BOX_Y: "y_e"}),
    ),
)

frames_9 = Exercise(
    "frames-9",
    title="A graph of four frames",
    text="A graph knows three poses in the plane. Seen from the room r, the camera d is at "
    "x = {x_d}, y = {y_d}, turned by {theta_d}, and the platform b at x = {x_b}, y = {y_b}, turned "
    f"by {{theta_b}}. The platform sees a box e at x = {{x}}, y = {{y}}. {TURNED} Where does the "
    "camera see the box?",
    given={"x_d": PLACE, "y_d": PLACE, "theta_d": TURN}
    | PLATFORM
    | {"x": number_range(0.3, 1.2, 0.1, "m"), "y": number_range(-0.8, 0.8, 0.1, "m")},
    unknowns=(Unknown("x", "m"), Unknown("y", "m")),
    right=in_graph(lambda T_rd, T_rb, p: frames.transform(frames.inverse(T_rd) @ T_rb, p)),
    wrong={
        no_inverse: in_graph(lambda T_rd, T_rb, p: frames.transform(T_rd @ T_rb, p)),
        unturned_shift: in_graph(
            lambda T_rd, T_rb, p: frames.transform(shifted_back(T_rd) @ T_rb, p)
        ),
    },
    likely_slips={
        "when the wrong one of the two poses is inverted": in_graph(
            lambda T_rd, T_rb, p: frames.transform(T_rd @ frames.inverse(T_rb), p)
        ),
        "for the box as the room sees it": in_graph(
            lambda T_rd, T_rb, p: frames.transform(T_rb, p)
        ),
    },
    solution=Solution(
        "The way from d to e leads via r and b. The first pose on it is known from the other end. "
        "Seen from the room, the box is at\n\n{there}\n\nFrom the camera to it leads a difference, "
        "which is turned to the axes of d:\n\n{seen}",
        there=Step(
            formulas.point, PLATFORM_IS | {formulas.bp_x: "x", formulas.bp_y: "y"}, unit=("m", "m")
        ),
        seen=Step(
            formulas.object_seen,
            dict(zip(DB, ("x_d", "y_d", "theta_d"), strict=True))
            | {formulas.de_x: "x_dp", formulas.de_y: "y_dp", formulas.de_turn: 0},
            values=tuple(sought("de")[:2]),
            unit="m",
            part=(0, 1),
        ),
    ),
)

frames_10 = Exercise(
    "frames-10",
    title="Moved, or named anew",
    text="Two frames a and b have the same origin; b is turned by {theta_b} against a "
    "(counter-clockwise positive). Seen from a, a point lies at x = {x}, y = {y}. First, passive: "
    "where does b see this point? Then, active: the point is turned by the angle from a to b. "
    "Where does a see it now?",
    given={
        "theta_b": TURN,
        "x": number_range(0.2, 1.6, 0.2, "m"),
        "y": number_range(-1.6, 1.6, 0.2, "m"),
    },
    unknowns=tuple(
        Unknown(f"{axis} {what}", "m") for what in ("seen from b", "turned") for axis in "xy"
    ),
    right=turned_both_ways(lambda passive, active: [*passive, *active]),
    wrong={},
    likely_slips={
        "with active and passive exchanged": turned_both_ways(
            lambda passive, active: [*active, *passive]
        ),
        "when both are turned by the angle from a to b": turned_both_ways(
            lambda passive, active: [*active, *active]
        ),
        "when both are turned by minus the angle from a to b": turned_both_ways(
            lambda passive, active: [*passive, *passive]
        ),
    },
    solution=Solution(
        "The axes of b are turned. Seen from them, the point goes the other way: the inverse turn."
        "\n\n{passive}\n\nActive, the point itself goes with the turn:\n\n{active}",
        passive=Step(LocalEquation(Matrix(AS_SEEN), about(-TURNED_BY), "m"), TURN_GIVEN),
        answer=(("passive", "active"),),
        active=Step(LocalEquation(Matrix(AS_TURNED), about(TURNED_BY), "m"), TURN_GIVEN),
    ),
)

frames_11 = Exercise(
    "frames-11",
    title="A picture with y down",
    text="A camera looks straight down. In its picture x goes to the right and y goes down, both "
    "already in metres on the floor. It sees a platform at x = {x_b}, y = {y_b}. The platform's "
    "front points at {psi} from x towards y (90° is down). An object is at x = {x_e}, y = {y_e}. "
    "How far ahead of the platform is it, and how far to its left?",
    given={"x_b": PLACE, "y_b": PLACE, "psi": TURN, "x_e": PLACE, "y_e": PLACE},
    when=lambda x_b, y_b, x_e, y_e, **_: abs(x_e - x_b) > 0.3 and abs(y_e - y_b) > 0.3,
    unknowns=(Unknown("ahead", "m"), Unknown("to the left", "m")),
    right=in_picture(lambda ahead, left: [ahead, left]),
    wrong={},
    likely_slips={
        "when the picture is read with y up: left and right change places": in_picture(
            lambda ahead, left: [ahead, -left]
        ),
        "along the picture's axes; asked are the platform's": (
            lambda x_b, y_b, psi, x_e, y_e: [x_e - x_b, y_e - y_b]
        ),
    },
    solution=Solution(
        "Flip y, and the picture is a plan again: all y and the angle change their sign. Then the "
        "difference is turned to the axes of the platform, as always.\n\n{seen}",
        seen=Step(LocalEquation(Matrix(IN_PICTURE), PICTURE, "m"), PICTURE_GIVEN),
    ),
)
