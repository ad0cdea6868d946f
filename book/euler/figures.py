"""The live figures of the chapter on Euler angles, in space."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import permutations
from math import pi
from typing import Any

from sympy import (
    Abs,
    Matrix,
    Max,
    Min,
    Piecewise,
    Symbol,
    atan2,
    cos,
    sin,
    sqrt,
    symbols,
)
from sympy import pi as half_turn

from book.euler import formulas as euler
from book.euler.formulas import TURNS, middle
from book.motion import formulas as motion
from book.motion.formulas import angle
from workshop.equations.core import Where, put_in, quantity
from workshop.figures import VIEW, Choice, Clock, Curve, Figure, Readout, Slider, view_sliders

R_AB = Matrix([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])  # the exercise
SEQUENCES = [
    *("".join(letters) for letters in permutations("XYZ")),
    *(i + j + i for i, j in permutations("XYZ", 2)),
]
ORIGIN = (0, 0, 0)
NAMES_A = ("x_A", "y_A", "z_A")

made = quantity("made", "", 0, 3, "how many turns of a sequence are made")
part = quantity("part", "", 0, 1, "how much of one turn is made")
s = Symbol("s")

outer = Matrix(
    symbols("o_x o_y o_z", real=True)
)  # the axis of the turn on the left: 1 for its letter
mid = Matrix(symbols("m_x m_y m_z", real=True))
inner = Matrix(symbols("i_x i_y i_z", real=True))  # of the turn on the right
AXES = (outer, mid, inner)
fixed = Symbol("fixed", real=True)  # 1 for extrinsic turns


def sequences() -> Choice:
    """All 24: what each gives the axes, and whether these are fixed."""

    def numbers(seq: str) -> tuple[int, ...]:
        left_to_right = seq if seq.isupper() else seq[::-1]
        axes = [int(one == axis) for one in left_to_right.upper() for axis in "XYZ"]
        return (*axes, int(seq.islower()))

    names = [*SEQUENCES, *map(str.lower, SEQUENCES)]
    label = "sequence (XYZ: own axes, xyz: fixed axes)"
    return Choice(
        "sequence",
        label,
        (*outer, *mid, *inner, fixed),
        {name: numbers(name) for name in names},
        start="YZX",
    )


def angle_sliders(labels: Sequence[str], starts: Sequence[float], kinds: Any) -> tuple[Slider, ...]:
    """The three angles of a sequence under the hand."""
    return tuple(
        Slider(symbol, -pi, pi, start=start, step=pi / 36, label=label, kind=kind)
        for symbol, start, label, kind in zip(TURNS, starts, labels, kinds, strict=True)
    )


def turned_by(turns: Any) -> list[Any]:
    """The angles reached, when so many turns are made."""
    return [Max(0, Min(1, turns - k)) * each for k, each in enumerate(TURNS)]


def current(three: Sequence[Any]) -> Any:
    """Of three things the one of the turn that is being made."""
    return Piecewise((three[0], made <= 1), (three[1], made <= 2), (three[2], True))


def named(name: str, matrix: Matrix) -> tuple[Matrix, Where]:
    """A matrix whose entries are symbols, and what they stand for."""
    rows, cols = matrix.shape
    entries = symbols(f"{name}:{rows}:{cols}", real=True)
    return Matrix(rows, cols, entries), tuple(zip(entries, matrix, strict=True))


def factors_of(name: str, angles: Sequence[Any]) -> tuple[list[Matrix], Where]:
    """The three factors of a sequence's matrix, from left to right, entry by entry."""
    a, b, c = angles
    places = Matrix([(1 - fixed) * a + fixed * c, b, (1 - fixed) * c + fixed * a])
    (left, between, right), where = named(f"{name}a", places)
    found = []
    for letter, axis, each in zip("pqr", AXES, (left, between, right), strict=True):
        entries, steps = named(name + letter, euler.turned_about(axis, each))
        found.append(entries)
        where = (*where, *steps)
    return found, where


def angle_of(R: Matrix) -> Any:
    """The angle of the one turn that a rotation is."""
    entries = dict(zip(euler.r, R, strict=True))
    vector = zip(euler.k, put_in(euler.turn_vector.right, entries), strict=True)
    return put_in(euler.turn_angle.right, {**entries, **dict(vector)})


def wrapped(value: Any) -> Any:
    """An angle in (−180°, 180°]."""
    return motion.wrap_angle.at({angle: value})


def tips(kind_of: Any, R: Matrix, low: Any, high: Any, samples: int = 48) -> tuple[Curve, ...]:
    """The ways of the tips of a frame's axes on the unit sphere, with R an expression of s."""
    return tuple(
        Curve(kind, VIEW.project(R[:, k]), s, low, high, samples=samples, depth=VIEW.depth(R[:, k]))
        for k, kind in enumerate(kind_of)
    )


def behind(shape: Any) -> Any:
    """A little further away, so that what lies along it is painted over it."""
    return replace(shape, depth=shape.depth - 0.3)


def thin_frame() -> tuple[Any, ...]:
    """The frame {A}, which stays."""
    heads = [[1.5 * (k == axis) for k in range(3)] for axis in range(3)]
    pairs = zip(heads, NAMES_A, strict=True)
    return tuple(behind(VIEW.arrow("text", ORIGIN, *pair)) for pair in pairs)


def turn_axis(direction: Matrix) -> tuple[Any, ...]:
    """What a frame turns about, to both sides."""
    return tuple(behind(VIEW.line("icr", [ORIGIN, end * direction])) for end in (-1.3, 1.3))


def sequence_figure() -> Figure:
    """Any of the 24 sequences, turn by turn, with its other answer and how near lock is."""
    angles, steps_angles = named("a", Matrix(turned_by(made)))
    factors, steps_factors = factors_of("l", angles)
    two, steps_two = named("t", factors[0] * factors[1])
    now, steps_now = named("n", two * factors[2])
    whole, steps_whole = factors_of("w", TURNS)
    first_two, steps_first = named("f", whole[0] * whole[1])
    end, steps_end = named("e", first_two * whole[2])

    axes = (
        (1 - fixed) * outer + fixed * inner,
        (1 - fixed) * factors[0] * mid + fixed * mid,
        (1 - fixed) * two * inner + fixed * outer,
    )
    u, steps_u = named("u", Matrix([current(three) for three in zip(*axes, strict=True)]))
    turning, steps_turning = named("v", Matrix([current(angles)]))
    back = euler.turned_about(u, -s * turning[0]) * now  # 0 … 1: from here to this turn's beginning

    proper = outer.dot(inner)
    cosine, sine = Abs(cos(middle)), Abs(sin(middle))
    near = proper * sine + (1 - proper) * cosine
    far = proper * cosine + (1 - proper) * sine
    other = {
        name: equation.right
        for name, equation in (("cardan", euler.other_cardan), ("proper", euler.other_proper))
    }
    return Figure(
        name="euler-sequence",
        title="A frame turned about three axes, one after the other; sequence and angles are yours",
        view=(-1.8, 1.8, -1.4, 1.85),
        controls=(
            sequences(),
            *angle_sliders(
                ("first α", "middle β", "third γ"), (pi / 2, -pi / 2, 0.0), ("", "", "")
            ),
            Clock(made, 0.0, 3.0, start=1.5, step=0.05, label="turns made", rate=0.5),
            *view_sliders(),
        ),
        scene=(
            *thin_frame(),
            *(behind(VIEW.arrow("ghost", ORIGIN, end[:, k])) for k in range(3)),
            *turn_axis(u),
            *tips(("x_axis", "y_axis", "z_axis"), back, 0, 1),
            *VIEW.frame(now, labels=("x", "y", "z")),
        ),
        readouts=(
            Readout(
                "other_first", "other answer: first", wrapped(other["cardan"][0]), "rad", digits=1
            ),
            Readout(
                "other_middle",
                "other answer: middle",
                proper * other["proper"][1] + (1 - proper) * wrapped(other["cardan"][1]),
                "rad",
                digits=1,
            ),
            Readout(
                "other_third", "other answer: third", wrapped(other["cardan"][2]), "rad", digits=1
            ),
            Readout("lock", "middle angle to gimbal lock", atan2(near, far), "rad", digits=1),
            Readout("whole", "the whole as one turn", angle_of(end), "rad", digits=1),
            Readout("apart", "from there to frame B", angle_of(R_AB.T * end), "rad", digits=1),
        ),
        says=(
            "Sequence {sequence} with the angles {first}, {middle}, {third}, {made} turns made. "
            "The other answer is {other_first}, {other_middle}, {other_third}. The middle angle "
            "is {lock} from gimbal lock. The whole is one turn of {whole} and ends {apart} from "
            "frame B."
        ),
        where=(
            *(*steps_angles, *steps_factors, *steps_two, *steps_now, *steps_whole),
            *(*steps_first, *steps_end, *steps_u, *steps_turning),
        ),
        turns=VIEW.angles,
        grid=False,
    )


RINGS = (1.3, 1.1, 0.9)  # m


def rings_figure() -> Figure:
    """Three rings, each turning in the one around it: an XYZ sequence as a machine."""
    x_turn, y_turn, z_turn = (
        equation.right.xreplace({euler.turn: value})
        for equation, value in zip((euler.turn_x, euler.turn_y, euler.turn_z), TURNS, strict=True)
    )
    one, steps_one = named("a", Matrix(x_turn))
    two, steps_two = named("b", one * Matrix(y_turn))
    three, steps_three = named("c", two * Matrix(z_turn))
    big, medium, small = RINGS

    def ring(kind: str, R: Matrix, p: int, q: int, radius: float) -> Curve:
        point = radius * (cos(s) * R[:, p] + sin(s) * R[:, q])
        return Curve(kind, VIEW.project(point), s, 0, 2 * pi, samples=64, depth=VIEW.depth(point))

    def pivots(kind: str, along: Matrix, low: float, high: float) -> tuple[Any, ...]:
        return tuple(VIEW.line(kind, [side * low * along, side * high * along]) for side in (-1, 1))

    nose, left, right = (0.7, 0, 0), (-0.35, 0.3, 0), (-0.35, -0.3, 0)
    tail, fin = (-0.35, 0, 0), (-0.35, 0, 0.25)
    outlines = ((nose, left), (left, right), (right, nose), (nose, fin), (fin, tail))
    along_x = Matrix([1, 0, 0])
    return Figure(
        name="gimbal-rings",
        title="Three rings, one inside the other, and an aeroplane in the innermost",
        view=(-1.75, 1.75, -1.45, 1.45),
        controls=(
            *angle_sliders(
                ("outer ring α", "middle ring β", "inner ring γ"),
                (pi / 9, pi / 4, pi / 9),
                ("x_axis", "y_axis", "z_axis"),
            ),
            *view_sliders(-pi / 9, pi / 6),
        ),
        scene=(
            ring("x_axis", one, 0, 1, big),
            ring("y_axis", two, 1, 2, medium),
            ring("z_axis", three, 2, 0, small),
            *pivots("x_axis", along_x, big, 1.55),
            *pivots("y_axis", one[:, 1], medium, big),
            *pivots("z_axis", two[:, 2], small, medium),
            VIEW.point("x_axis", 1.55 * along_x, label="α"),
            VIEW.point("y_axis", big * one[:, 1], label="β"),
            VIEW.point("z_axis", medium * two[:, 2], label="γ"),
            *(VIEW.line("body", [three * Matrix(p) for p in ends]) for ends in outlines),
        ),
        readouts=(
            Readout(
                "between",
                "angle between the outer and the inner axis",
                atan2(Abs(cos(middle)), sin(middle)),
                "rad",
                digits=1,
            ),
            Readout("room", "freedom: 1 best, 0 locked", Abs(cos(middle)), ""),
            Readout("whole", "the aeroplane's whole turn", angle_of(three), "rad", digits=1),
        ),
        says=(
            "Outer ring {first}, middle ring {middle}, inner ring {third}. The axes of the outer "
            "and the inner ring are {between} apart; the freedom of the three axes is {room}. The "
            "aeroplane is turned by {whole} in all."
        ),
        where=(*steps_one, *steps_two, *steps_three),
        turns=VIEW.angles,
        grid=False,
    )


AXIS = Matrix([-1, 1, -1]) / sqrt(3)  # of R_AB
ANGLE = 2 * half_turn / 3


def one_turn_figure() -> Figure:
    """The exercise's rotation as one turn, beside both of its angles growing together."""

    def at_once(share: Any) -> Matrix:
        return euler.turned_about(AXIS, share * ANGLE)

    def by_angles(share: Any) -> Matrix:
        y_axis, z_axis = Matrix([0, 1, 0]), Matrix([0, 0, 1])
        quarter = share * half_turn / 2
        return euler.turned_about(y_axis, quarter) * euler.turned_about(z_axis, -quarter)

    now, steps_now = named("n", at_once(part))
    then, steps_then = named("t", by_angles(part))
    return Figure(
        name="one-turn",
        title="Frame A taken to frame B by one turn about a slanted axis",
        view=(-1.8, 1.8, -1.4, 1.85),
        controls=(
            Clock(part, 0.0, 1.0, start=0.5, step=0.01, label="part of the way", rate=0.25),
            *view_sliders(),
        ),
        scene=(
            *thin_frame(),
            *turn_axis(AXIS),
            *tips(["approximation"] * 3, by_angles(s), 0, 1, samples=32),
            *tips(("x_axis", "y_axis", "z_axis"), at_once(s), 0, part, samples=32),
            *(VIEW.point("approximation", then[:, k]) for k in range(3)),
            *VIEW.frame(now, labels=("x", "y", "z")),
        ),
        readouts=(
            Readout("turned", "turned so far", angle_of(now), "rad", digits=1),
            Readout("left", "still to B", angle_of(R_AB.T * now), "rad", digits=1),
            Readout(
                "detour",
                "still to B, both angles together",
                angle_of(R_AB.T * then),
                "rad",
                digits=1,
            ),
        ),
        says=(
            "After {part} of the way the frame is turned by {turned} about the slanted axis; "
            "{left} are left to frame B. With both Euler angles growing together {detour} would "
            "be left."
        ),
        where=(*steps_now, *steps_then),
        turns=VIEW.angles,
        grid=False,
    )


FIGURES = (sequence_figure(), rings_figure(), one_turn_figure())
