"""Frames: a pose as a matrix, its inverse, poses in a chain, a camera that looks down."""

from sympy import Abs, MatMul, Matrix, cos, cot, sin

from book.motion.formulas import theta
from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

TURN = (-3.14, 3.14)

alpha = quantity("joint_alpha", "rad", *TURN, "first joint angle of the arm", r"\alpha", "alpha")
beta = quantity("joint_beta", "rad", *TURN, "second joint angle of the arm", r"\beta", "beta")
gamma = quantity("joint_gamma", "rad", *TURN, "third joint angle of the arm", r"\gamma", "gamma")
l_1 = quantity("link_1", "m", 0.1, 1, "first link of the arm on the platform", "l_1", "l1")
l_2 = quantity("link_2", "m", 0.1, 1, "second link of the arm on the platform", "l_2", "l2")

db_x = quantity("db_x", "m", -2, 2, "platform b seen from camera d", latex="x_{db}")
db_y = quantity("db_y", "m", -2, 2, "platform b seen from camera d", latex="y_{db}")
db_turn = quantity("db_turn", "rad", *TURN, "heading of b seen from d", latex=r"\theta_{db}")
de_x = quantity("de_x", "m", -2, 2, "object e seen from camera d", latex="x_{de}")
de_y = quantity("de_y", "m", -2, 2, "object e seen from camera d", latex="y_{de}")
de_turn = quantity("de_turn", "rad", *TURN, "heading of e seen from d", latex=r"\theta_{de}")
fb_x = quantity("fb_x", "m", -2, 2, "platform b seen from camera f above", latex="x_{fb}")
fb_y = quantity("fb_y", "m", -2, 2, "platform b seen from camera f above", latex="y_{fb}")
fb_z = quantity("fb_z", "m", 1, 3, "platform b seen from camera f above", latex="z_{fb}")
bc_x = quantity("bc_x", "m", -2, 2, "hand c seen from platform b", "x_{bc}", "x_bc")
bc_y = quantity("bc_y", "m", -2, 2, "hand c seen from platform b", "y_{bc}", "y_bc")
bc_turn = quantity("bc_turn", "rad", *TURN, "heading of c seen from b", latex=r"\theta_{bc}")

bp_x = quantity("bp_x", "m", -1, 1, "a point of the platform seen from b", latex="x_{bp}")
bp_y = quantity("bp_y", "m", -1, 1, "a point of the platform seen from b", latex="y_{bp}")
pole_x = quantity("pole_x", "m", -9, 9, "the point that a pose leaves alone, along x", "x_k")
pole_y = quantity("pole_y", "m", -9, 9, "the point that a pose leaves alone, along y", "y_k")

roll = quantity("roll", "rad", *TURN, "turn about x, by which any rotation begins")
pitch = quantity("pitch", "rad", *TURN, "turn about y, the second of any rotation")
yaw = quantity("yaw", "rad", *TURN, "turn about z, the third of any rotation")
ENTRY = "entry of the rotation matrix: row, column"
r = Matrix(3, 3, lambda i, j: symbol(f"r_{i + 1}{j + 1}", ENTRY, f"r_{{{i + 1}{j + 1}}}"))

lever = quantity("lever", "m", 0, 5, "distance of a point from its axis of turning", latex=r"\ell")
error = quantity("error", "rad", -0.5, 0.5, "error of an angle", r"\delta", "delta")
missed = quantity("missed", "m", 0, 3, "by how much a point is missed", r"\Delta", "miss")


PAIRS = ["ab", "ac", "bc", "bd", "be", "cb", "ce", "cf"]
PAIRS += ["db", "de", "fb", "fd", "fe", "rb", "rf"]
T = {of: symbol(f"T_{of}", f"pose of {of[1]} as seen from {of[0]}", f"T_{{{of}}}") for of in PAIRS}
PARTS = {"x": ("x", "place", "m"), "y": ("y", "place", "m"), "z": ("z", "place", "m")}
PARTS["theta"] = (r"\theta", "heading", "rad")
SOUGHT = {
    f"{part}_{of}": symbol(
        f"{part}_{of}", f"{what} of {of[1]} as seen from {of[0]}", f"{latex}_{{{of}}}", unit
    )
    for of in ("bd", "be", "bf", "cd", "ce", "dc")
    for part, (latex, what, unit) in PARTS.items()
}
SOUGHT |= {"x_db": db_x, "y_db": db_y, "theta_db": db_turn}
SOUGHT |= {"x_de": de_x, "y_de": de_y, "theta_de": de_turn}
SOUGHT |= {"x_bc": bc_x, "y_bc": bc_y, "theta_bc": bc_turn}
SOUGHT["x_dp"] = symbol("x_dp", "a point p as seen from d", "x_{dp}", "m")
SOUGHT["y_dp"] = symbol("y_dp", "a point p as seen from d", "y_{dp}", "m")
R = symbol("R", "the turn in a pose, a rotation matrix")
p = symbol("p", "the position in a pose")
Q = symbol("Q", "the turn in the inverse of a pose")
q = symbol("q", "the position in the inverse of a pose")
identity = symbol("I", "the identity matrix")
pole_place = symbol("k", "the pole of a pose: the point that stays where it is", unit="m")
wrong_turn = symbol("D", "the error of a pose, a pose itself")
AXES = [symbol(f"{u}_{of}", f"{u} axis of frame {of}") for of in "bc" for u in "xy"]
POINTS = [symbol(f"q_{of}", f"a point as seen from {of}", unit="m") for of in "abc"]
TURNS = [symbol(f"R_{of}", f"the turn in T_{of}", f"R_{{{of}}}") for of in ("ab", "bc")]
PLACES = [symbol(f"p_{of}", f"the position in T_{of}", f"p_{{{of}}}", "m") for of in ("ab", "bc")]


def sought(of: str, parts: tuple[str, ...] = ("x", "y", "theta")) -> Matrix:
    """The pose on the left of a formula."""
    return Matrix([SOUGHT[f"{part}_{of}"] for part in parts])


with as_written():
    matrix = Equation(
        name="frames.matrix",
        left=T["db"],
        right=Matrix(
            [
                [cos(db_turn), -sin(db_turn), db_x],
                [sin(db_turn), cos(db_turn), db_y],
                [0, 0, 1],
            ]
        ),
    )

    point = Equation(
        name="frames.point",
        left=sought("dp", ("x", "y")),
        right=Matrix(
            [
                db_x + bp_x * cos(db_turn) - bp_y * sin(db_turn),
                db_y + bp_x * sin(db_turn) + bp_y * cos(db_turn),
            ]
        ),
    )

    pole = Equation(
        name="frames.pole",
        left=Matrix([pole_x, pole_y]),
        right=Matrix(
            [
                (db_x - db_y * cos(db_turn / 2) / sin(db_turn / 2)) / 2,
                (db_y + db_x * cos(db_turn / 2) / sin(db_turn / 2)) / 2,
            ]
        ),
        textbook=Matrix(
            [(db_x - db_y * cot(db_turn / 2)) / 2, (db_y + db_x * cot(db_turn / 2)) / 2]
        ),
    )

    hand_pose = Equation(
        name="frames.hand",
        left=sought("bc"),
        right=Matrix(
            [
                l_1 * cos(alpha) + l_2 * cos(alpha + beta),
                l_1 * sin(alpha) + l_2 * sin(alpha + beta),
                alpha + beta + gamma,
            ]
        ),
    )

    turned_round = Equation(
        name="frames.inverse",
        left=sought("bd"),
        right=Matrix(
            [
                -(db_x * cos(db_turn) + db_y * sin(db_turn)),
                db_x * sin(db_turn) - db_y * cos(db_turn),
                -db_turn,
            ]
        ),
        is_angle=True,
    )

    inverse_in_space = Equation(
        name="frames.inverse_in_space",
        left=sought("bf", ("x", "y", "z")),
        right=Matrix([-(r[0, k] * fb_x + r[1, k] * fb_y + r[2, k] * fb_z) for k in range(3)]),
        textbook=MatMul(-1, r.T, Matrix([fb_x, fb_y, fb_z])),
        where=(
            (r[0, 0], cos(yaw) * cos(pitch)),
            (r[0, 1], cos(yaw) * sin(pitch) * sin(roll) - sin(yaw) * cos(roll)),
            (r[0, 2], cos(yaw) * sin(pitch) * cos(roll) + sin(yaw) * sin(roll)),
            (r[1, 0], sin(yaw) * cos(pitch)),
            (r[1, 1], sin(yaw) * sin(pitch) * sin(roll) + cos(yaw) * cos(roll)),
            (r[1, 2], sin(yaw) * sin(pitch) * cos(roll) - cos(yaw) * sin(roll)),
            (r[2, 0], -sin(pitch)),
            (r[2, 1], cos(pitch) * sin(roll)),
            (r[2, 2], cos(pitch) * cos(roll)),
        ),
    )

    object_seen = Equation(
        name="frames.seen_from",
        left=sought("be"),
        right=Matrix(
            [
                (de_x - db_x) * cos(db_turn) + (de_y - db_y) * sin(db_turn),
                (de_y - db_y) * cos(db_turn) - (de_x - db_x) * sin(db_turn),
                de_turn - db_turn,
            ]
        ),
        is_angle=True,
    )

    chained = Equation(
        name="frames.joined",
        left=sought("dc"),
        right=Matrix(
            [
                db_x + bc_x * cos(db_turn) - bc_y * sin(db_turn),
                db_y + bc_x * sin(db_turn) + bc_y * cos(db_turn),
                db_turn + bc_turn,
            ]
        ),
        is_angle=True,
    )

    looking_down = Equation(
        name="frames.looking_down",
        left=T["fb"],
        right=Matrix(
            [
                [cos(theta), -sin(theta), 0, fb_x],
                [-sin(theta), -cos(theta), 0, fb_y],
                [0, 0, -1, fb_z],
                [0, 0, 0, 1],
            ]
        ),
    )

    miss = Equation(
        name="frames.miss",
        left=missed,
        right=2 * lever * Abs(sin(error / 2)),
    )


LOOKS = {
    alpha: "left",
    beta: "right",
    gamma: "turning",
    l_1: "length",
    l_2: "length",
    db_x: "x_axis",
    db_y: "y_axis",
    db_turn: "heading",
    pole_x: "icr",
    pole_y: "icr",
    error: "error",
    missed: "error",
    lever: "length",
}
LOOKS |= {SOUGHT[f"x_{of}"]: "x_axis" for of in ("bd", "be", "ce", "dp")}
LOOKS |= {SOUGHT[f"y_{of}"]: "y_axis" for of in ("bd", "be", "ce", "dp")}
