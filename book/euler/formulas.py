"""Euler angles: turns about axes, the angles of a matrix, one axis and one angle.

Entries of a rotation matrix are named r_11 … r_33, the parts of a unit vector n_x, n_y, n_z. What
is written in them is checked where three angles, or two for the vector, make them.
"""

from typing import Any

from sympy import Add, MatMul, Matrix, Symbol, atan2, cos, pi, sin, sqrt

from courseware.equations import Equation, as_written, declarations

quantity, symbol = declarations(__name__)

first = quantity("first", "rad", -3.14, 3.14, "first turn of a sequence", r"\alpha", "alpha")
middle = quantity("middle", "rad", -3.14, 3.14, "middle turn of a sequence", r"\beta", "beta")
third = quantity("third", "rad", -3.14, 3.14, "third turn of a sequence", r"\gamma", "gamma")
turn = quantity("turn", "rad", -3.14, 3.14, "a turn about one axis", latex=r"\vartheta")

TURNS = (first, middle, third)
RATES = rate_first, rate_middle, rate_third = tuple(
    quantity(f"rate_{which}", "rad/s", -1, 1, f"rate of the {which} turn", rf"\dot\{name}")
    for which, name in {"first": "alpha", "middle": "beta", "third": "gamma"}.items()
)
omega = symbol(
    "omega", "angular velocity, written in {A}: an arrow along the axis", r"\omega_A", "rad/s"
)
J = symbol("J", "Jacobian: its columns are the axes of the turns")
det_J = symbol("det_J", "determinant of the Jacobian", r"\det J")

LOOKS = {turn: "icr", omega: "velocity"}

ENTRY = "entry of the rotation matrix: row, column"
r = Matrix(3, 3, lambda i, j: symbol(f"r_{i + 1}{j + 1}", ENTRY, f"r_{{{i + 1}{j + 1}}}"))
n = n_x, n_y, n_z = tuple(symbol(f"n_{x}", f"axis of the one turn, along {x}") for x in "xyz")
gamma = Symbol(r"\gamma")  # the third angle, once it is known
OTHERS = [
    symbol(f"{name}_other", f"{turn} turn of the other answer", rf"\{name}_\mathrm{{other}}", "rad")
    for name, turn in {"alpha": "first", "beta": "middle", "gamma": "third"}.items()
]
w = symbol("w", "the quaternion's first number")
Q = [symbol(f"q_{x}", f"the quaternion's part along {x}") for x in "xyz"]
R = symbol("R", "a rotation matrix")
R_turn = {x: symbol(f"R_{x}", f"matrix of a turn about {x}", f"R_{x}") for x in "xyz"}
whole_n = symbol("n", "axis of the one turn, an arrow of length 1")
whole_q = symbol("q", "a quaternion")
identity = symbol("I", "the identity matrix")
c_a, c_b, c_c, s_a, s_b, s_c = SHORT = [
    symbol(f"{of}_{name}", f"{what} of the {which} turn", rf"{of}_\{name}")
    for of, what in {"c": "cosine", "s": "sine"}.items()
    for name, which in {"alpha": "first", "beta": "middle", "gamma": "third"}.items()
]
AXES = [symbol(x, f"the {x} axis") for x in "xyz"]
AXES += [symbol(f"{x}_{a}", f"the {x} axis of frame {a}") for a in "AB" for x in "xyz"]
R_made = [symbol(f"R_{k}", f"matrix of turn {k}") for k in (1, 2)]


def turned_about(axis: Any, angle: Any) -> Matrix:
    """The matrix of a turn about a unit vector, as Rodrigues writes it."""
    x, y, z = axis
    c, s = cos(angle), sin(angle)
    rest = 1 - c
    return Matrix(
        [
            [c + rest * x * x, rest * x * y - s * z, rest * x * z + s * y],
            [rest * y * x + s * z, c + rest * y * y, rest * y * z - s * x],
            [rest * z * x - s * y, rest * z * y + s * x, c + rest * z * z],
        ]
    )


with as_written():
    ca, cb, cc = map(cos, TURNS)
    sa, sb, sc = map(sin, TURNS)

    entries = Matrix(
        [
            [cb * cc, -cb * sc, sb],
            [ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb],
            [sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb],
        ]
    )
    MADE = tuple(zip(r, entries, strict=True))
    DIRECTION = ((n_x, cb * ca), (n_y, cb * sa), (n_z, sb))

    turn_x, turn_y, turn_z = (
        Equation(
            name=f"euler.turn_{letter}",
            left=Symbol(rf"{{R_{letter}}}(\vartheta)"),
            right=Matrix(rows),
        )
        for letter, rows in {
            "x": [[1, 0, 0], [0, cos(turn), -sin(turn)], [0, sin(turn), cos(turn)]],
            "y": [[cos(turn), 0, sin(turn)], [0, 1, 0], [-sin(turn), 0, cos(turn)]],
            "z": [[cos(turn), -sin(turn), 0], [sin(turn), cos(turn), 0], [0, 0, 1]],
        }.items()
    )

    steps = tuple(zip(SHORT, (ca, cb, cc, sa, sb, sc), strict=True))

    xyz = Equation(
        name="euler.xyz",
        left=R,
        right=Matrix(
            [
                [c_b * c_c, -c_b * s_c, s_b],
                [c_a * s_c + s_a * s_b * c_c, c_a * c_c - s_a * s_b * s_c, -s_a * c_b],
                [s_a * s_c - c_a * s_b * c_c, s_a * c_c + c_a * s_b * s_c, c_a * c_b],
            ]
        ),
        where=steps,
    )

    zyx = Equation(
        name="euler.zyx",
        left=R,
        right=Matrix(
            [
                [c_a * c_b, c_a * s_b * s_c - s_a * c_c, c_a * s_b * c_c + s_a * s_c],
                [s_a * c_b, s_a * s_b * s_c + c_a * c_c, s_a * s_b * c_c - c_a * s_c],
                [-s_b, c_b * s_c, c_b * c_c],
            ]
        ),
        where=steps,
    )

    axes = Matrix([[1, 0, s_b], [0, c_a, -s_a * c_b], [0, s_a, c_a * c_b]])  # of XYZ

    rates = Equation(
        name="euler.rates",
        left=omega,
        right=Matrix(
            [
                rate_first + s_b * rate_third,
                c_a * rate_middle - s_a * c_b * rate_third,
                s_a * rate_middle + c_a * c_b * rate_third,
            ]
        ),
        textbook=MatMul(axes, Matrix(RATES)),
        where=steps,
    )

    determinant = Equation(
        name="euler.determinant",
        left=det_J,
        right=cb,
    )

    angles_at_once = Equation(
        name="euler.angles_at_once",
        left=Matrix(TURNS),
        right=Matrix(
            [
                atan2(-r[1, 2], r[2, 2]),
                atan2(r[0, 2], sqrt(r[0, 0] ** 2 + r[0, 1] ** 2)),
                atan2(-r[0, 1], r[0, 0]),
            ]
        ),
        where=MADE,
        is_angle=True,
    )

    third_first = Equation(
        name="euler.third_first",
        left=Matrix([third, first, middle]),
        right=Matrix(
            [
                atan2(-r[0, 1], r[0, 0]),
                atan2(
                    sin(gamma) * r[2, 0] + cos(gamma) * r[2, 1],
                    sin(gamma) * r[1, 0] + cos(gamma) * r[1, 1],
                ),
                atan2(r[0, 2], sqrt(r[0, 0] ** 2 + r[0, 1] ** 2)),
            ]
        ),
        where=(*MADE, (gamma, atan2(-r[0, 1], r[0, 0]))),
        is_angle=True,
    )

    other_cardan = Equation(
        name="euler.other_cardan",
        left=Matrix(OTHERS),
        right=Matrix([first + pi, pi - middle, third + pi]),
        is_angle=True,
    )

    other_proper = Equation(
        name="euler.other_proper",
        left=other_cardan.left,
        right=Matrix([first + pi, -middle, third + pi]),
        is_angle=True,
    )

    rodrigues = Equation(
        name="euler.rodrigues",
        left=r,
        right=turned_about(n, turn),
        where=DIRECTION,
    )

    turn_vector = Equation(
        name="euler.turn_vector",
        left=Matrix([2 * sin(turn) * part for part in n]),
        right=Matrix([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]),
        where=MADE,
    )

    diagonal = r[0, 0] + r[1, 1] + r[2, 2] - 1

    turn_cosine = Equation(
        name="euler.turn_cosine",
        left=2 * cos(turn),
        right=diagonal,
        where=MADE,
    )

    turn_angle = Equation(
        name="euler.turn_angle",
        left=turn,
        right=atan2(
            sqrt(Add(*(difference**2 for difference in turn_vector.right))),
            diagonal,
        ),
        where=MADE,
    )

    unit_quaternion = Equation(
        name="euler.quaternion",
        left=Matrix([w, *Q]),
        right=Matrix([cos(turn / 2), *(part * sin(turn / 2) for part in n)]),
        where=DIRECTION,
    )
