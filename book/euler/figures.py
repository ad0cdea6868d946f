"""The live figures of the chapter on Euler angles: dice, rings and a ball, all solid."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import permutations
from math import pi
from typing import Any

from sympy import (
    Abs,
    And,
    Matrix,
    Min,
    Not,
    Piecewise,
    Symbol,
    atan2,
    cos,
    nan,
    rad,
    sin,
    sqrt,
    symbols,
    tan,
)
from sympy import pi as exact_pi

from book.dragging import turn_handle
from book.euler import formulas as euler
from book.euler.exercises import ignored_lock, left_handed_turn, wrong_order
from book.euler.formulas import TURNS, first, middle, third, turn
from book.motion import formulas as motion
from book.things import meshes, space
from book.things.graph import Graph
from book.things.outlines import disc
from courseware.equations import Where, declarations, substitute
from courseware.figures import (
    VIEW,
    Arrow,
    Bracket,
    Choice,
    Clock,
    Curve,
    Figure,
    Goal,
    Handle,
    Label,
    Line,
    NamedSteps,
    Outline,
    Point,
    QuarterTurns,
    Readout,
    Slider,
    Sprite,
    assign,
    bring_forward,
    ramp,
    when,
)
from courseware.figures.solids import Mesh
from courseware.figures.space import AXES, ORIGIN

quantity, _ = declarations(__name__)

R_AB = Matrix([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])  # the exercise
GHOST = Matrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]])  # of the opening: three quarter turns away
UNTURNED = Matrix.eye(3)
SEQUENCES = [
    *("".join(letters) for letters in permutations("XYZ")),
    *(i + j + i for i, j in permutations("XYZ", 2)),
]
OF_A, OF_B = ("x_A", "y_A", "z_A"), ("x_B", "y_B", "z_B")
X, Y, Z = (UNTURNED[:, axis] for axis in range(3))

made = quantity("made", "", 0, 3, "how many turns of a sequence are made")
part = quantity("part", "", 0, 1, "how much of a way is made")
near = quantity("near", "", 0.2, 90, "degrees from lock")
PICKS = symbols("pick_1 pick_2", real=True)  # arrows that are chosen for columns
against = quantity("against", "rad", -3.14, 3.14, "the outer ring turned on, the inner one back")
s = Symbol("s")
WRONG = symbols("wrong:3:3", real=True)  # the entries of a wrong matrix

outer = Matrix(
    symbols("o_x o_y o_z", real=True)
)  # the axis of the turn on the left: 1 for its letter
mid = Matrix(symbols("m_x m_y m_z", real=True))
inner = Matrix(symbols("i_x i_y i_z", real=True))  # of the turn on the right
fixed = Symbol("fixed", real=True)  # 1 for extrinsic turns
about = Matrix(symbols("about_x about_y about_z", real=True))
at_once = Symbol("at_once", real=True)  # 1 for one turn about one axis, 0 for two


def name_entries(R: Matrix) -> Where:
    """Return a rotation as named steps, one for each entry of the matrix."""
    return tuple(zip(euler.r, R, strict=True))


def angle_of(R: Matrix) -> Any:
    """Return the angle of the one turn that makes a rotation."""
    return euler.turn_angle.substitute(dict(zip(euler.r, R, strict=True)))


def pick(made: Any, *turns: Any) -> Any:
    """Return what belongs to the turn that is being made."""
    parts = [(each, made <= k + 1) for k, each in enumerate(turns[:-1])]
    return Piecewise(*parts, (turns[-1], True))


def is_aligned(R: Matrix, target: Matrix) -> Any:
    """Return whether two orientations are less than a degree apart."""
    return angle_of(target.T * R) < exact_pi / 180


# Dice: 1, 2 and 3 towards x, y and z of the frame that is fixed to them.


FLOOR, HALF = -0.95, 0.75  # m: the floor's height, and half its side


ARC = 1.05  # m, from the axis of a turn to its arc
CORNER = 0.45 * Matrix([1, -1, 1])  # m, of a die; of all corners the one to be dragged


def floor(at: Sequence[Any] = ORIGIN) -> Any:
    """Return a piece of floor, on which shadows fall."""
    return space.floor(FLOOR, HALF, at)


def die_axes(R: Matrix, at: Sequence[Any], labels: Sequence[str]) -> tuple[Any, ...]:
    """Return the axes of a die, each from its face on."""
    tail, head = (
        [[at[k] + far * R[k, axis] for k in range(3)] for axis in range(3)] for far in (0.5, 1.25)
    )
    return tuple(map(VIEW.arrow, AXES, tail, head, labels))


def die(
    R: Matrix,
    at: Sequence[Any] = ORIGIN,
    labels: Sequence[str] = ("x", "y", "z"),
    kind: str = "accent",
) -> tuple[Any, ...]:
    """Return a die on its axes, above a floor."""
    edge = "accent_edge" if kind == "accent" else kind
    pip = "dark" if kind == "error" else "shell"
    body = VIEW.solid(space.die(kind, pip, edge), R, at, floor=FLOOR)
    return floor(at), body, *die_axes(R, at, labels)


def corner_of(R: Matrix, at: Sequence[Any] = ORIGIN) -> list[Any]:
    """Return the corner of a die that is at (0.45, -0.45, 0.45) of its own frame: to drag."""
    return moved(at, R * CORNER)


def ghost_die(
    R: Matrix, at: Sequence[Any], labels: Sequence[str] = ("x", "y", "z")
) -> tuple[Any, ...]:
    """Return the ghost onto which a die shall be brought, on its axes."""
    body = VIEW.solid(space.die("ghost"), R, at, floor=FLOOR, opacity=0.15)
    return floor(at), body, *die_axes(R, at, labels)


def room(at: Sequence[Any] = ORIGIN) -> tuple[Any, ...]:
    """Return the axes of frame A, which stay: along the floor and up from its corner."""
    corner = [at[0] - HALF, at[1] - HALF, FLOOR]
    return tuple(
        VIEW.arrow("text", corner, [c + 1.7 * u for c, u in zip(corner, axis, strict=True)], label)
        for axis, label in zip((X, Y, Z), OF_A, strict=True)
    )


def turn_axis(direction: Matrix, at: Sequence[Any] = ORIGIN) -> tuple[Any, ...]:
    """Return the axis of a die's turn, to both sides of it."""
    ends = [
        [a + far * u for a, u in zip(at, direction, strict=True)]
        for far in (-1.45, -0.5, 0.5, 1.45)
    ]
    return tuple(bring_forward(VIEW.line("icr", pair), -0.3) for pair in (ends[1::-1], ends[2:]))


def around_axis(axis: Sequence[Any], turned: Any, far: float, before: Matrix = UNTURNED) -> Matrix:
    """Return a point so far from an axis, after a turn: as the next axis goes, x to y to z to x.

    before: how the axes were before the turn.
    """
    x, y, z = axis
    pairs = zip((z, x, y), (y, z, x), strict=True)
    return before * Matrix([far * (b * cos(turned) + c * sin(turned)) for b, c in pairs])


def moved(at: Sequence[Any], by: Matrix) -> list[Any]:
    """Return a place from another one."""
    return [a + part for a, part in zip(at, by, strict=True)]


def turn_arc(
    letter: str,
    angle: Any,
    axis: Sequence[Any],
    kind: str,
    before: Matrix = UNTURNED,
    at: Sequence[Any] = ORIGIN,
) -> tuple[Any, ...]:
    """Return the angle of a turn and its letter, about an axis of those before the turn."""
    here = moved(at, around_axis(axis, s * angle, ARC, before))
    half = moved(at, around_axis(axis, angle / 2, ARC + 0.2, before))
    arc = Curve(kind, VIEW.project(here), s, 0, 1, 16, depth=VIEW.depth(here) + 0.2)
    return arc, *when(Abs(angle) > 0.2, Label(kind, VIEW.project(half), letter))


def arc_handle(
    letter: str,
    angle: Any,
    axis: Sequence[Any],
    before: Matrix = UNTURNED,
    at: Sequence[Any] = ORIGIN,
) -> Handle:
    """Return a handle at the end of a turn's arc."""
    end = moved(at, around_axis(axis, angle, ARC, before))
    return turn_handle(f"end of the arc {letter}", angle, end)


def right_of_origin(distance: Any) -> tuple[Any, Any, Any]:
    """Return the place so far to the right in the picture, from wherever one looks."""
    return -distance * sin(VIEW.azimuth), distance * cos(VIEW.azimuth), 0


LEFT, RIGHT = right_of_origin(-1.15), right_of_origin(1.15)


PRESSES = QuarterTurns()


def last_rotation(part: Any = 1) -> Matrix:
    """Return the matrix of the last quarter turn; the identity before the first."""
    x, y, z = PRESSES.axis
    c, s = cos(part * exact_pi / 2), sin(part * exact_pi / 2)
    # about a coordinate axis, or about none
    diagonal = (c + (1 - c) * (1 - u**2 - v**2) for u, v in ((y, z), (x, z), (x, y)))
    return Matrix.diag(*diagonal) + s * Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def compose(last: Matrix) -> Matrix:
    """Return the rotation with the last turn: own axes on the right, the room's on the left."""
    return PRESSES.own * (PRESSES.before * last) + (1 - PRESSES.own) * (last * PRESSES.before)


def die_figure() -> Figure:
    """Draw the opening: a die, twelve buttons, a ghost."""
    turns, steps = PRESSES, NamedSteps()
    last = steps.add("l", last_rotation(turns.part))
    now = steps.add("n", compose(last))
    own, away = turns.own, 2 * (1 - turns.part)
    beside = -2.35 + own * (1.6 + away) - (1 - own) * away  # from its own side
    tasks = {99: "Bring the die onto its ghost.", 3: "Bring it there in as few turns as you can."}
    low = -1.8
    return Figure(
        name="die",
        title="A die, and beside it the ghost of a die that is turned another way",
        view=(-3.1, 3.1, -2.85, 1.42),
        ground="wall",
        controls=(turns,),
        shapes=(
            *room(right_of_origin(-1.4)),
            *die(now, right_of_origin(-1.4)),
            *ghost_die(GHOST, right_of_origin(1.4)),
            *when(turns.count < 1, Label("text", (0, low), "no turn yet")),
            *when(
                turns.count > 0,
                Bracket(turns.before, (-0.75 - 1.6 * own, low), "before"),
                Bracket(last_rotation(), (beside, low), "the turn", columns=("icr",) * 3),
                Label("text", (0.3, low), "="),
            ),
            *when(And(turns.count > 0, turns.part >= 1), Bracket(now, (1.4, low), "now")),
        ),
        readouts=(Readout("count", "turns made", turns.count, "", digits=0),),
        sentence="{count} turns made: {turns}.",
        goal=tuple(
            Goal(And(is_aligned(now, GHOST), turns.part >= 1, turns.count <= most), words)
            for most, words in tasks.items()
        ),
        where=steps,
    )


def exercise_figure() -> Figure:
    """Draw the two frames of the exercise."""
    return Figure(
        name="two-frames",
        ground="wall",
        title="Frame A on the left; frame B on the right, turned another way",
        view=(-2.4, 2.5, -1.6, 1.5),
        shapes=(*die(UNTURNED, LEFT, OF_A), *die(R_AB, RIGHT, OF_B)),
        sentence="The x axis of B points against y of A, its y axis down, its z axis along x of A.",
    )


def legs() -> tuple[Any, ...]:
    """Return the parts of a turned axis along the two that stay in its plane: cosine and sine."""
    far, (x, y, z) = 1.25, about
    along, across = Matrix([z, x, y]), Matrix([y, z, x])
    corner = far * cos(turn) * along
    tip = corner + far * sin(turn) * across
    return (
        bring_forward(VIEW.line("text", (ORIGIN, corner)), 2),
        bring_forward(VIEW.line("text", (corner, tip)), 2),
        bring_forward(VIEW.point("text", corner / 2, "cos ϑ"), 2),
        bring_forward(VIEW.point("text", corner + (tip - corner) / 2, "sin ϑ"), 2),
    )


def columns_figure() -> Figure:
    """Draw a turn about one of the axes, and the three columns of its matrix."""
    R, turned = euler.r, euler.turned_about(about, turn)
    return Figure(
        name="columns",
        ground="wall",
        title="A die turned about one axis of the room, and the matrix of the turn",
        view=(-1.5, 3.1, -1.6, 1.5),
        controls=(
            Choice.one_hot("axis", about, "xyz", label="turn about", start="z"),
            Slider.degrees(turn, start=60, step=15),
        ),
        handles=(turn_handle("a corner of the die", turn, corner_of(turned)),),
        shapes=(
            *room(),
            *die(R),
            *turn_arc("ϑ", turn, about, "icr"),
            *legs(),
            Bracket(R, (2.2, 0.1), digits=2),
        ),
        sentence="A turn of {turn} about the {axis} axis.",
        where=name_entries(turned),
    )


def in_both_orders(first_part: Any, second_part: Any) -> tuple[Matrix, Matrix]:
    """Return −90° about z and 90° about x, parts of them, about own axes: z first, and x first."""
    a, b = (part * exact_pi / 2 for part in (first_part, second_part))
    one = euler.turned_about(Z, -a) * euler.turned_about(X, b)
    return one, euler.turned_about(X, a) * euler.turned_about(Z, -b)


def order_figure() -> Figure:
    """Draw the same two quarter turns in two orders."""
    steps = NamedSteps()
    both = zip("pq", in_both_orders(ramp(made, 0), ramp(made, 1)), strict=True)
    left, right = (steps.add(name, R) for name, R in both)
    return Figure(
        name="order",
        ground="wall",
        title="Two dice: the left one turned about z, then x, the right one about x, then z",
        view=(-2.4, 2.5, -1.6, 1.5),
        controls=(Clock(made, 0.0, 2.0, label="quarter turns made", rate=0.5),),
        shapes=(*room(LEFT), *room(RIGHT), *die(left, LEFT), *die(right, RIGHT)),
        readouts=(Readout("apart", "angle between the dice", angle_of(left.T * right), "rad"),),
        sentence="{made} turns made of each; the dice are one turn of {apart} apart.",
        where=steps,
    )


def corner_figure() -> Figure:
    """Draw the left of these dice at its end, and the turn about a corner that leads to the right.

    The two ends differ by a turn about (1, 1, 1), which is in sight.
    """
    steps = NamedSteps()
    left, right = in_both_orders(1, 1)
    corner = Matrix([1, 1, 1]) / sqrt(3)
    turned = euler.turned_about(corner, turn) * left
    now = steps.add("n", turned)
    front = moved(LEFT, 0.45 * turned * Matrix([1, 1, 1]))
    return Figure(
        name="corner",
        ground="wall",
        title="The two dice after both turns; the left one turns about the line through a corner",
        view=(-2.4, 2.5, -1.6, 1.5),
        controls=(Slider.degrees(turn, step=15),),
        handles=(turn_handle("a corner of the left die", turn, front),),
        shapes=(
            *turn_axis(corner, LEFT),
            *die(now, LEFT),
            bring_forward(VIEW.point("icr", [k + 0.47 for k in LEFT]), 1),
            *die(right, RIGHT),
        ),
        readouts=(Readout("apart", "angle between the dice", angle_of(now.T * right), "rad"),),
        sentence="The left die is turned on by {turn} about a corner: {apart} apart.",
        goal=Goal(is_aligned(now, right), "Turn the left die onto the right one."),
        where=steps,
    )


def readings_figure() -> Figure:
    """Draw one product, read from the left about own axes, from the right about the room's."""
    steps = NamedSteps()
    one, two = ramp(made, 0), ramp(made, 1)
    left = steps.add("p", euler.turned_about(Z, one * first) * euler.turned_about(X, two * middle))
    right = steps.add("q", euler.turned_about(Z, two * first) * euler.turned_about(X, one * middle))
    own = steps.add("u", Matrix([pick(made, p, q) for p, q in zip(Z, left[:, 0], strict=True)]))
    of_room = steps.add("v", Matrix([pick(made, p, q) for p, q in zip(X, Z, strict=True)]))
    return Figure(
        name="two-readings",
        title="Two dice: one turned about its own axes, one about the axes of the room",
        view=(-2.4, 2.5, -1.8, 1.5),
        ground="wall",
        controls=(
            Slider.degrees(first, start=60, step=15, label="α, about z", kind="z_axis"),
            Slider.degrees(middle, start=45, step=15, label="β, about x", kind="x_axis"),
            Clock(made, 0.0, 2.0, label="turns made", rate=0.5, loops=True),
        ),
        shapes=(
            *room(LEFT),
            *room(RIGHT),
            *turn_axis(own, LEFT),
            *turn_axis(of_room, RIGHT),
            *die(left, LEFT),
            *die(right, RIGHT),
            Label("text", (-1.15, -1.62), "own axes: z, then x"),
            Label("text", (1.15, -1.62), "the room’s: x, then z"),
        ),
        readouts=(Readout("apart", "angle between the dice", angle_of(left.T * right), "rad"),),
        sentence="{made} turns made, by {first} about z and {middle} about x: {apart} apart.",
        where=steps,
    )


def target_figure() -> Figure:
    """Draw the exercise: two axes and two angles to bring the die to frame B."""
    steps = NamedSteps()
    one = steps.add("p", euler.turned_about(outer, first))
    now = steps.add("n", one * euler.turned_about(mid, middle))
    pairs = {
        f"{a}, then {b}": tuple(int(each == letter) for each in (a, b) for letter in "xyz")
        for a, b in permutations("xyz", 2)
    }
    alike = (R_AB[:, axis].dot(now[:, axis]) > cos(exact_pi / 180) for axis in range(3))
    in_place = sum(Piecewise((1, each), (0, True)) for each in alike)
    return Figure(
        name="to-b",
        ground="wall",
        title="A die turned about two of its own axes; the ghost is frame B",
        size="laboratory",
        view=(-2.5, 2.6, -1.6, 1.5),
        controls=(
            Choice("axes", "its own axes", (*outer, *mid), pairs, start="y, then x"),
            Slider.degrees(first, step=15, label="α, first turn"),
            Slider.degrees(middle, step=15, label="β, second turn"),
        ),
        handles=(arc_handle("α", first, outer, at=LEFT), arc_handle("β", middle, mid, one, LEFT)),
        shapes=(
            *room(LEFT),
            *die(now, LEFT),
            *turn_arc("α", first, outer, "icr", at=LEFT),
            *turn_arc("β", middle, mid, "icr", one, LEFT),
            *ghost_die(R_AB, right_of_origin(1.45), OF_B),
        ),
        readouts=(Readout("in_place", "axes that point as in B", in_place, "", digits=0),),
        sentence="Turned about {axes} by {first} and {middle}: {in_place} axes as in frame B.",
        goal=Goal(is_aligned(now, R_AB), "Bring the die onto frame B."),
        where=steps,
    )


GIVEN = (40, 30, -20)  # degrees: the angles of the ghost


def three_angles_figure() -> Figure:
    """Draw three turns, x, y and z, and a ghost whose angles stand in its matrix."""
    steps = NamedSteps()
    ghost = Matrix(euler.entries.subs(dict(zip(TURNS, map(rad, GIVEN), strict=True))).evalf(17))
    one = steps.add("o", euler.turned_about(X, first))
    two = steps.add("t", one * euler.turned_about(Y, middle))
    now = steps.add("n", two * euler.turned_about(Z, third))
    return Figure(
        name="read-angles",
        title="A die turned about x, y and z, one after the other; a ghost, and its matrix",
        view=(-2.6, 2.7, -2.75, 1.5),
        ground="wall",
        size="laboratory",
        controls=(
            Slider.degrees(first, step=10, label="first α, about x", kind="x_axis"),
            Slider.degrees(
                middle, -90, 90, step=10, label="middle β, about the new y", kind="y_axis"
            ),
            Slider.degrees(third, step=10, label="third γ, about the newest z", kind="z_axis"),
        ),
        handles=(
            arc_handle("α", first, X, at=LEFT),
            arc_handle("β", middle, Y, one, LEFT),
            arc_handle("γ", third, Z, two, LEFT),
        ),
        shapes=(
            *room(LEFT),
            *die(now, LEFT),
            *turn_arc("α", first, X, "x_axis", at=LEFT),
            *turn_arc("β", middle, Y, "y_axis", one, LEFT),
            *turn_arc("γ", third, Z, "z_axis", two, LEFT),
            *ghost_die(ghost, right_of_origin(1.35)),
            Bracket(now, (-1.15, -1.9), "the die", digits=2),
            Bracket(ghost, (1.35, -1.9), "the ghost", digits=2),
        ),
        readouts=(Readout("apart", "angle to the ghost", angle_of(ghost.T * now), "rad"),),
        sentence="Turned by {first}, {middle} and {third}, {apart} from the ghost.",
        goal=Goal(is_aligned(now, ghost), "Bring the die onto the ghost."),
        where=steps,
    )


def both_figure() -> Figure:
    """Draw both answers of XYZ, turn by turn."""
    steps = NamedSteps(((first, exact_pi / 9), (third, exact_pi / 6), *assign(euler.other_cardan)))

    def turned(name: str, angles: Sequence[Any]) -> Any:
        a, b, c = (ramp(made, k) * each for k, each in enumerate(angles))
        two = steps.add(f"{name}t", euler.turned_about(X, a) * euler.turned_about(Y, b))
        return steps.add(name, two * euler.turned_about(Z, c))

    left, right = turned("p", TURNS), turned("q", euler.OTHERS)
    return Figure(
        name="both-answers",
        ground="wall",
        title="Two dice turned about x, y and z by different angles",
        view=(-2.4, 2.5, -1.6, 1.5),
        controls=(
            Slider.degrees(middle, start=30, step=15, kind="y_axis"),
            Clock(made, 0.0, 3.0, label="turns made", rate=0.75),
        ),
        shapes=(*die(left, LEFT), *die(right, RIGHT)),
        readouts=(
            Readout("other", "β of the right die", motion.wrap(euler.OTHERS[1]), "rad", digits=0),
            Readout("apart", "angle between the dice", angle_of(left.T * right), "rad"),
        ),
        sentence=(
            "The left die is turned by 20°, {middle}, 30°, the right one by 200°, {other}, 210°; "
            "{made} turns made, they are {apart} apart."
        ),
        where=steps,
    )


# Rings, one inside the other: an XYZ sequence as a machine.

AEROPLANE = space.aeroplane()
STAND = tuple(
    replace(meshes.box("metal_mid", size, at), edge="edge")
    for size, at in (
        ((0.12, 0.26, 1.45), (1.45, 0, -0.62)),
        ((0.12, 0.26, 1.45), (-1.45, 0, -0.62)),
        ((3.04, 0.6, 0.1), (0, 0, -1.4)),
    )
)


def ring(kind: str, flat: str, radius: float, along: str, end: float) -> tuple[Mesh, ...]:
    """Return a ring, flat towards one axis, with two pins along another that hold the next one."""
    rim = radius + 0.14
    pins = (meshes.cylinder(kind, (0.06, 0.06), x, along, n=6) for x in ((rim, end), (-end, -rim)))
    return meshes.ring(kind, radius, rim, 0.1, flat), *pins


def rings(
    steps: NamedSteps, first: Any, middle: Any, third: Any
) -> tuple[tuple[Matrix, Matrix, Matrix], tuple[Any, ...]]:
    """Return how three rings stand after their turns, and what is drawn: stand, rings, plane."""
    low = -1.46
    one = steps.add("a", euler.turned_about(X, first))
    two = steps.add("b", one * euler.turned_about(Y, middle))
    three = steps.add("c", two * euler.turned_about(Z, third))
    return (one, two, three), (
        space.floor(low, 1.45),
        VIEW.solid(STAND, UNTURNED, floor=low),
        VIEW.solid(ring("x_axis", "z", 1.16, "x", 1.46), one, floor=low),
        VIEW.solid(ring("y_axis", "x", 0.94, "y", 1.16), two),
        VIEW.solid(ring("z_axis", "y", 0.72, "z", 0.94), three),
        VIEW.solid(AEROPLANE, three),
    )


def ring_handles(first: Any, middle: Any, third: Any) -> tuple[Handle, ...]:
    """Return a handle on each ring, away from its axis."""
    one = euler.turned_about(X, first)
    two = one * euler.turned_about(Y, middle)
    three = two * euler.turned_about(Z, third)
    return (
        turn_handle("outer ring", first, one * Matrix([0, -1.23, 0])),
        turn_handle("middle ring", middle, two * Matrix([0, 0, 1.01])),
        turn_handle("inner ring", third, three * Matrix([0.79, 0, 0])),
    )


def rings_alone_figure() -> Figure:
    """Draw the rings, each turned alone, and the axis of each."""
    steps = NamedSteps()
    (one, two, three), things = rings(steps, *TURNS)
    axes = (
        ("x_axis", X, 1.8, "α"),
        ("y_axis", one[:, 1], 1.3, "β"),
        ("z_axis", two[:, 2], 1.3, "γ"),
    )
    return Figure(
        name="rings-alone",
        ground="wall",
        title="Three rings on a stand, the axis of each, and an aeroplane in the innermost",
        size="laboratory",
        view=(-2.9, 2.9, -2.15, 1.5),
        seen_from=(-pi / 4, pi / 8),
        controls=(
            Slider.degrees(first, step=15, label="α, outer ring", kind="x_axis"),
            Slider.degrees(middle, step=15, label="β, middle ring", kind="y_axis"),
            Slider.degrees(third, step=15, label="γ, inner ring", kind="z_axis"),
        ),
        handles=ring_handles(*TURNS),
        shapes=(
            *things,
            *(
                shape
                for kind, axis, far, letter in axes
                for shape in (
                    VIEW.line(kind, (-far * axis, -0.5 * axis)),
                    VIEW.line(kind, (0.5 * axis, far * axis)),
                    Label(kind, VIEW.project(1.15 * far * axis), letter),
                )
            ),
        ),
        sentence="Outer ring {first}, middle ring {middle}, inner ring {third}.",
        goal=Goal(three[2, 0] < -cos(exact_pi / 60), "Point the aeroplane's nose straight down."),
        where=steps,
    )


def rings_figure() -> Figure:
    """Draw a stand, three rings, an aeroplane, and the turns that it can make at this moment."""
    steps = NamedSteps()
    (_, _, three), things = rings(steps, against, middle, -against)
    J = substitute(substitute(euler.axes, dict(euler.steps)), {first: against})
    J[0, 0] = Piecewise((1, cos(middle) > 0), (-1, True))  # the body of -x is the same
    is_locked = Abs(cos(middle)) < 0.02
    across = Matrix([0, -sin(against), cos(against)])  # to the axes of the outer and middle ring
    body = right_of_origin(2.75)
    axes = [J[:, k] for k in range(3)]
    rates = (axes[0] + axes[1] + axes[2]) / sqrt(3)  # all rings at one rate

    def beside(arrow: Matrix) -> list[Any]:
        return [a + part for a, part in zip(body, arrow, strict=True)]

    return Figure(
        name="gimbal-rings",
        ground="wall",
        title="Three rings on a stand, one inside the other, and an aeroplane in the innermost",
        view=(-2.3, 3.9, -2.25, 2.05),
        seen_from=(-pi / 4, pi / 8),
        controls=(
            Slider.degrees(middle, start=30, step=15, label="β, middle ring", kind="y_axis"),
            Slider.degrees(against, step=15, label="outer ring +, inner ring −"),
        ),
        handles=ring_handles(against, middle, third)[:2],
        shapes=(
            *things,
            *when(is_locked, VIEW.arrow("error", 0.4 * across, 1.6 * across, "lost")),
            VIEW.solid((meshes.ball("velocity"),), 0.6 * J, body, opacity=0.5),
            *(
                VIEW.arrow(kind, beside(0.55 * axis), beside(1.05 * axis), letter)
                for kind, axis, letter in zip(AXES, axes, "αβγ", strict=True)
            ),
            replace(VIEW.arrow(euler.omega, body, beside(0.6 * rates)), depth=9, label=None),
        ),
        readouts=(
            Readout(euler.det_J, "det J (0: the green body is flat)", euler.determinant.right),
            Readout("whole", "angle of the aeroplane", angle_of(three), "rad"),
        ),
        sentence=(
            "Middle ring {middle}, outer ring forward and inner ring back by {against}: the "
            "aeroplane is turned by {whole} in all, det J is {det_J}."
        ),
        goal=Goal(
            And(is_locked, Abs(against) > exact_pi / 7),
            "Put the middle ring at 90°; then turn the outer ring by 30° or more.",
        ),
        where=steps,
    )


def yaw_figure() -> Figure:
    """Draw an aeroplane that yaws, pitches and rolls: ZYX."""
    steps = NamedSteps()
    one = steps.add("o", euler.turned_about(Z, first))
    two = steps.add("t", one * euler.turned_about(Y, middle))
    now = steps.add("n", two * euler.turned_about(X, third))
    pitched = euler.turned_about(Z, first) * euler.turned_about(Y, middle)
    turned = pitched * euler.turned_about(X, third)
    return Figure(
        name="yaw-pitch-roll",
        title="An aeroplane that is turned to its side, then its nose up or down, then about it",
        view=(-1.5, 3.1, -1.6, 1.5),
        seen_from=(-pi / 4, pi / 8),
        ground="wall",
        controls=(
            Slider.degrees(first, start=30, step=10, label="yaw α, about z", kind="z_axis"),
            Slider.degrees(
                middle, -90, 90, step=10, label="pitch β, about the new y", kind="y_axis"
            ),
            Slider.degrees(third, step=10, label="roll γ, about the newest x", kind="x_axis"),
        ),
        handles=(
            turn_handle("tail", first, turned * Matrix([-0.75, 0, 0])),
            turn_handle("nose", middle, turned * Matrix([1.1, 0, 0])),
            turn_handle("left wing", third, turned * Matrix([0, 1, 0])),
        ),
        shapes=(
            *room(),
            floor(),
            VIEW.solid(AEROPLANE, 1.4 * now, floor=FLOOR),
            *VIEW.frame(now, ORIGIN, 1.25, ("x", "y", "z")),
            Bracket(now, (2.2, 0.1), digits=2),
        ),
        sentence="Yaw {first}, pitch {middle}, roll {third}.",
        goal=Goal(Abs(now[2, 0] - sin(exact_pi / 6)) < 0.02, "Point its nose 30° up."),
        where=steps,
    )


def near_lock_figure() -> Figure:
    """Draw how fast the inner ring must turn near lock, and why: long arrows make a short one."""
    graph = Graph(
        (0, 3.6, 0, 2.3),
        x=(0.1, 100),
        y=(1, 1000),
        titles=("degrees from lock", "inner / wanted rate"),
    )
    angle = rad(near)
    fast, on_curve = (1 / sin(each * exact_pi / 180) for each in (near, 10**s))
    here = graph.place((near, fast))
    left, low = 1.9, 1.35  # of the wanted rate's arrow; near lock all arrows are drawn smaller
    high = Min(0.5, 1.65 * tan(angle))
    tip = (left + high / tan(angle), low + high)
    return Figure(
        name="inner-rate",
        title="The nearer to lock, the faster the inner ring must turn: a graph, and the rates",
        view=(-0.75, 4.4, -0.95, 2.75),
        ground="paper",
        controls=(Slider(near, 0.2, 90.0, start=30.0, step=0.2, label="degrees from lock"),),
        shapes=(
            *graph.shapes(),
            Curve("z_axis", graph.place((10**s, on_curve)), s, -1, 1.95, 48),
            Line("ghost", (graph.place((near, 1)), here, graph.place((0.1, fast)))),
            Point("target", graph.place((1, 1 / sin(exact_pi / 180))), "1°: 57.3"),
            Point("z_axis", here),
            Arrow("z_axis", (left, low), tip),
            Arrow("x_axis", tip, (left, low + high)),
            Arrow("velocity", (left, low), (left, low + high)),
            Label("z_axis", (left + 1.1, low), "inner ring"),
            Label("x_axis", (left + 1.1, low + high + 0.2), "outer ring"),
            Label("velocity", (left + 0.15, low - 0.2), "wanted"),
        ),
        readouts=(Readout("fast", "inner rate / wanted rate", fast, "", 1),),
        sentence="{near} degrees from lock the inner ring turns {fast} times as fast.",
        grid=False,
    )


# One turn: a rotation is a point in a ball, towards its axis, as far out as its angle.

AXIS = Matrix([-1, 1, -1]) / sqrt(3)  # of R_AB
ANGLE = 2 * pi / 3
BALL, LIFTED = 1.1, 0.2  # m: the radius of the ball, half a turn; how high its middle is


def one_turn_figure() -> Figure:
    """Draw the way from A to B by one turn and by two, as a die and in the ball of all turns."""

    def by_two(turns: Any) -> tuple[Any, Any]:
        return ramp(turns, 0) * exact_pi / 2, -ramp(turns, 1) * exact_pi / 2

    def in_ball(turns: Any) -> Matrix:
        a, b = (each / 2 for each in by_two(turns))
        vector = Matrix([sin(a) * sin(b), sin(a) * cos(b), cos(a) * sin(b)])
        long = sqrt(vector.dot(vector))
        return vector * 2 * atan2(long, cos(a) * cos(b)) / (long + 1e-300) / exact_pi

    (a, b), once = by_two(2 * part), part * 2 * exact_pi / 3
    two = euler.turned_about(Y, a) * euler.turned_about(Z, b)
    turned = at_once * once + (1 - at_once) * (a - b)
    x, y, _ = right_of_origin(1.35)
    middle_of = (x, y, LIFTED)
    low = (x, y, 0)

    def put(vector: Any) -> list[Any]:
        return [BALL * each + at for each, at in zip(vector, middle_of, strict=True)]

    def way(kind: str, vector: Any, high: Any, samples: int) -> Curve:
        at = put(vector)
        return Curve(kind, VIEW.project(at), s, 0, high, samples, depth=VIEW.depth(at) + 0.2)

    spoke = AXIS * 2 / 3  # of half a turn
    circles = ((cos(s), sin(s), 0), (0, cos(s), sin(s)), (sin(s), 0, cos(s)))
    here = at_once * spoke * part + (1 - at_once) * in_ball(2 * part)
    glass = Outline(disc(BALL), "bubble", "glass_lit")
    light = Outline(disc(0.32, -0.45, 0.5), "sheen", opacity=0.6)
    stand = replace(meshes.cylinder("metal_mid", (0.5, 0.32), (-0.95, -0.86), n=24), edge="edge")
    seen = VIEW.project(middle_of)
    return Figure(
        name="one-turn",
        title="A die on its way to frame B, and its way in the ball of all rotations",
        view=(-2.6, 2.85, -1.5, 1.85),
        ground="wall",
        controls=(
            Choice("way", "way", (at_once,), {"one turn": (1,), "two": (0,)}, start="two"),
            Clock(part, 0.0, 1.0, step=0.01, label="part of the way", rate=0.25),
        ),
        shapes=(
            *(Curve("ghost", VIEW.project(put(c)), s, 0, 2 * exact_pi, 36) for c in circles),
            *die(euler.r, right_of_origin(-1.3)),
            floor(low),
            VIEW.solid((stand,), UNTURNED, low, floor=FLOOR),
            *(
                VIEW.arrow(kind, put(0 * axis), put(1.3 * axis), label)
                for kind, axis, label in zip(AXES, (X, Y, Z), OF_A, strict=True)
            ),
            way("icr", s * spoke, 1, 6),
            way("approximation", in_ball(2 * s), 1, 24),
            bring_forward(VIEW.point("target", put(spoke), "B"), 9),
            bring_forward(VIEW.point("body", put(here)), 9),
            Sprite((*seen, 0), (glass, light)),
        ),
        readouts=(
            Readout("turned", "turned on the way", turned, "rad", digits=0),
            Readout("left", "angle to B", angle_of(R_AB.T * euler.r), "rad"),
        ),
        sentence="By {way}, {part} of the way: turned by {turned} in all, {left} left to frame B.",
        where=name_entries(at_once * euler.turned_about(AXIS, once) + (1 - at_once) * two),
    )


def one_axis_figure() -> Figure:
    """Draw a die that one turn about a chosen axis shall bring to frame B."""
    R, high, n = euler.r, 0.5**0.5, Matrix(euler.n)
    turned = euler.turned_about(euler.n, turn)
    across = Matrix([-n[1], n[0], 0]) / sqrt(n[0] ** 2 + n[1] ** 2)

    def around(angle: Any, far: float) -> list[Any]:
        """Return a place near the tip of n, so far turned about it."""
        arrow = 1.15 * n + far * (cos(angle) * across + sin(angle) * n.cross(across))
        return [a + part for a, part in zip(LEFT, arrow, strict=True)]

    arc = around(s * turn, 0.3)
    tail, head = ([a + far * u for a, u in zip(LEFT, n, strict=True)] for far in (0.5, 1.5))
    differences = (("32", "23", (2, 1)), ("13", "31", (0, 2)), ("21", "12", (1, 0)))
    ways = {
        "two faces": (1, 0, 0),
        "two edges": (high, -high, 0),
        "two corners": tuple(map(float, AXIS)),
    }
    return Figure(
        name="one-axis",
        title="A die turned about an axis through its middle; the ghost is frame B",
        view=(-2.5, 2.6, -2.6, 1.75),
        ground="wall",
        controls=(
            Choice("axis", "axis through", euler.n, ways),
            Slider.degrees(turn, start=30, step=15),
        ),
        handles=(turn_handle("a corner of the die", turn, corner_of(turned, LEFT)),),
        shapes=(
            *room(LEFT),
            *turn_axis(n, LEFT)[:1],
            VIEW.arrow("icr", tail, head, "n"),
            Curve("icr", VIEW.project(arc), s, 0, 1, 16, depth=VIEW.depth(arc) + 0.2),
            *when(turn > 0.2, Label("icr", VIEW.project(around(turn / 2, 0.5)), "ϑ")),
            *die(R, LEFT),
            *ghost_die(R_AB, right_of_origin(1.45), OF_B),
            Bracket(R, (-1.15, -2.1), digits=2, columns=("text",) * 3),
            Label("text", (-2.4, -2.1), "R ="),
        ),
        readouts=(
            *(
                Readout(f"difference{k}", f"r_{a} − r_{b}", R[i, j] - R[j, i], digits=2)
                for k, (a, b, (i, j)) in enumerate(differences)
            ),
            Readout("apart", "angle to B", angle_of(R_AB.T * R), "rad"),
        ),
        sentence="Turned by {turn} about an axis through {axis}, {apart} from frame B.",
        goal=Goal(is_aligned(R, R_AB), "Bring the die onto frame B by one turn."),
        where=name_entries(turned),
    )


def recap_figure() -> Figure:
    """Draw all in one: columns, axes of A, the one turn; and arrows that want their letters."""
    R, numbers = euler.r, (3, 1, 2)  # of the arrows x, y, z
    ends = [[[far * R[k, axis] for k in range(3)] for axis in range(3)] for far in (0.5, 1.25)]
    right = [Abs(pick - number) < 0.5 for pick, number in zip(PICKS, numbers, strict=False)]
    right.append(And(*right))  # then the third is left

    def arrow(axis: int, kind: str, label: str) -> Arrow:
        return VIEW.arrow(kind, ends[0][axis], ends[1][axis], label)

    options = {"?": (0,), "arrow 1": (1,), "arrow 2": (2,), "arrow 3": (3,)}
    places = zip(("first", "second"), PICKS, strict=True)
    return Figure(
        name="rotation-recap",
        title="A die on its way from frame A to frame B, its matrix, and the axis of the one turn",
        view=(-1.5, 3.1, -1.7, 1.6),
        ground="wall",
        controls=(
            *(Choice(f"{n}_column", f"{n} column is", (pick,), options) for n, pick in places),
            Clock(turn, 0.0, ANGLE, start=ANGLE, step=pi / 180, rate=0.8),
        ),
        shapes=(
            *room(),
            *turn_axis(AXIS),
            *die(R, labels=())[:2],
            *(
                shape
                for k, named in enumerate(right)
                for shape in (
                    *when(named, arrow(k, AXES[k], "xyz"[k])),
                    *when(Not(named), arrow(k, "text", str(numbers[k]))),
                )
            ),
            Bracket(R, (2.2, 0.1), digits=2, columns=("text",) * 3),
            *(
                label
                for k, (name, choice) in enumerate(zip(("first", "second"), PICKS, strict=True))
                for number in (1, 2, 3)
                if number != numbers[k]
                for label in when(
                    Abs(choice - number) < 0.5,
                    Label("error", (2.2, -0.9 - 0.32 * k), f"{name} column: not arrow {number}"),
                )
            ),
        ),
        sentence=(
            "Turned by {turn} about the slanted axis. You say that the first column is "
            "{first_column}, the second {second_column}."
        ),
        goal=Goal(And(*right), "Say which arrows the first and the second column are."),
        where=name_entries(euler.turned_about(AXIS, turn)),
    )


def mistakes_figure() -> Figure:
    """Draw another frame B, of two quarter turns, and the frames that three mistakes make of it."""
    quarter = {turn: exact_pi / 2}
    y_turn, z_turn = euler.turn_y.substitute(quarter), euler.turn_z.substitute(quarter)
    by_hand = left_handed_turn.formula.transfer(euler.turn_z)
    wrong = {
        wrong_order.title: z_turn * y_turn,
        left_handed_turn.title: left_handed_turn.formula.substitute(quarter)
        * by_hand.substitute(quarter),
        ignored_lock.title: y_turn,  # both angles that are zero or noise taken for zero
    }
    right = (y_turn * z_turn).doit()
    R, options = Matrix(3, 3, WRONG), {n: tuple(map(int, M.doit())) for n, M in wrong.items()}
    return Figure(
        name="wrong-frames",
        ground="wall",
        title="Frame B, and beside it in red the frame that a mistake makes of it",
        view=(-2.4, 2.5, -1.6, 1.5),
        controls=(Choice("mistake", "mistake", WRONG, options),),
        shapes=(*die(right, LEFT, OF_B), *die(R, RIGHT, kind="error")),
        readouts=(Readout("apart", "error angle", angle_of(right.T * R), "rad", digits=0),),
        sentence="{mistake}: the wrong frame is one turn of {apart} from frame B.",
    )


# The laboratory: any of the 24 sequences.


def sequences() -> Choice:
    """Return the choice of all 24: the axes of each, and whether these are fixed."""

    def numbers(seq: str) -> tuple[int, ...]:
        left_to_right = seq if seq.isupper() else seq[::-1]
        axes = [int(one == axis) for one in left_to_right.upper() for axis in "XYZ"]
        return (*axes, int(seq.islower()))

    options = {name: numbers(name) for name in (*SEQUENCES, *map(str.lower, SEQUENCES))}
    label = "sequence (XYZ: own axes, xyz: the room's)"
    return Choice("sequence", label, (*outer, *mid, *inner, fixed), options, start="ZXZ")


def factors_of(steps: NamedSteps, name: str, angles: Sequence[Any]) -> list[Matrix]:
    """Return the three factors of a sequence's matrix, from left to right, entry by entry."""
    a, b, c = angles
    places = Matrix([(1 - fixed) * a + fixed * c, b, (1 - fixed) * c + fixed * a])
    turns = zip("pqr", (outer, mid, inner), steps.add(f"{name}a", places), strict=True)
    return [
        steps.add(name + letter, euler.turned_about(axis, each)) for letter, axis, each in turns
    ]


def sequence_figure() -> Figure:
    """Draw any of the 24 sequences, turn by turn, with its other answer and how near lock is."""
    steps = NamedSteps()
    angles = steps.add("a", Matrix([ramp(made, k) * e for k, e in enumerate(TURNS)]))
    factors = factors_of(steps, "l", angles)
    two = steps.add("t", factors[0] * factors[1])
    now = steps.add("n", two * factors[2])
    whole = factors_of(steps, "w", TURNS)
    first_two = steps.add("f", whole[0] * whole[1])
    end = steps.add("e", first_two * whole[2])
    axes = (
        (1 - fixed) * outer + fixed * inner,
        (1 - fixed) * factors[0] * mid + fixed * mid,
        (1 - fixed) * two * inner + fixed * outer,
    )
    u = steps.add("u", Matrix([pick(made, *three) for three in zip(*axes, strict=True)]))
    proper = outer.dot(inner)
    cosine, sine = Abs(cos(middle)), Abs(sin(middle))
    near = proper * sine + (1 - proper) * cosine
    far = proper * cosine + (1 - proper) * sine
    cardan, euler_ = euler.other_cardan.right, euler.other_proper.right
    other_middle = proper * euler_[1] + (1 - proper) * motion.wrap(cardan[1])
    return Figure(
        name="euler-sequence",
        ground="wall",
        title="A die turned about three axes, one after the other; the ghost is frame B",
        view=(-3.2, 3.2, -1.6, 1.5),
        size="laboratory",
        controls=(
            sequences(),
            Slider.degrees(first, start=30, step=15, label="first α"),
            Slider.degrees(middle, start=45, step=15, label="middle β"),
            Slider.degrees(third, start=-60, step=15, label="third γ"),
            Clock(made, 0.0, 3.0, start=3.0, label="turns made", rate=0.75),
        ),
        shapes=(
            *room(LEFT),
            *turn_axis(u, LEFT),
            *die(now, LEFT),
            *ghost_die(R_AB, right_of_origin(1.45), OF_B),
        ),
        readouts=(
            *(
                Readout(
                    f"other_{name}",
                    f"other answer: {letter}",
                    Piecewise((angle, near > 1e-9), (nan, True)),
                    "rad",
                    words={"nan": "infinitely many"},
                )
                for name, letter, angle in (
                    ("first", "α", motion.wrap(cardan[0])),
                    ("middle", "β", other_middle),
                    ("third", "γ", motion.wrap(cardan[2])),
                )
            ),
            Readout("lock", "β from gimbal lock", atan2(near, far), "rad"),
            Readout("apart", "angle to frame B", angle_of(R_AB.T * end), "rad"),
        ),
        sentence=(
            "Sequence {sequence} with the angles {first}, {middle}, {third}, {made} turns made. "
            "The other answer is {other_first}, {other_middle}, {other_third}. The middle angle "
            "is {lock} from gimbal lock. The die ends {apart} from frame B."
        ),
        goal=tuple(
            Goal(And(is_aligned(end, R_AB), chosen > 0), f"Reach frame B with {name}.")
            for name, chosen in (
                ("ZXZ", outer[2] * mid[0] * inner[2] * (1 - fixed)),
                ("ZYX", outer[2] * mid[1] * inner[0] * (1 - fixed)),
                ("zyx", outer[0] * mid[1] * inner[2] * fixed),
            )
        ),
        where=steps,
    )


FIGURES = (
    die_figure(),
    exercise_figure(),
    columns_figure(),
    order_figure(),
    corner_figure(),
    readings_figure(),
    target_figure(),
    three_angles_figure(),
    both_figure(),
    yaw_figure(),
    rings_alone_figure(),
    rings_figure(),
    near_lock_figure(),
    one_axis_figure(),
    one_turn_figure(),
    sequence_figure(),
    mistakes_figure(),
    recap_figure(),
)
