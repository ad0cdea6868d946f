"""The live figures of the chapter on chains of frames."""

from math import pi
from typing import Any

from sympy import Matrix, Symbol, atan2, cos, sin, sqrt, symbols, zeros

from book.frames import exercises as bank
from book.frames import formulas as frames
from book.frames.exercises import T_bc_kept, no_inverse, same_order, unturned_shift
from book.frames.formulas import (
    alpha,
    bc_turn,
    bc_x,
    bc_y,
    beta,
    db_turn,
    db_x,
    db_y,
    de_turn,
    de_x,
    de_y,
    fb_x,
    fb_y,
    fb_z,
    gamma,
    l_1,
    l_2,
)
from book.motion import formulas as motion
from courseware.equations import as_written, declarations, substitute
from courseware.figures import (
    POINTER,
    VIEW,
    Area,
    Arrow,
    Body,
    Choice,
    Curve,
    Figure,
    Handle,
    Line,
    NamedSteps,
    Point,
    Readout,
    Slider,
    distance,
)

quantity, _ = declarations(__name__)

LINKS = {l_1: 0.3, l_2: 0.4}  # m, as in the exercise
RADIUS, AXIS = 0.2, 0.22  # m, of the platform; how long the axes of a frame are drawn

Pose = Any  # [x, y, theta]

camera_turn = quantity("camera_turn", "rad", -3.14, 3.14, "turn of the camera, seen from above")
camera_high = quantity("camera_high", "m", 1, 2, "height of the camera above the arm")
object_low = quantity("object_low", "m", -0.4, 0.4, "height of the object above the arm")


def seen_from(first: Pose, second: Pose) -> Matrix:
    """Return the second pose as seen from the first, both known from one place."""
    values = dict(zip((db_x, db_y, db_turn, de_x, de_y, de_turn), (*first, *second), strict=True))
    return frames.object_seen.substitute(values)


def compose(first: Pose, second: Pose) -> Matrix:
    """Return the pose at the end of two poses in a chain."""
    values = dict(zip((db_x, db_y, db_turn, bc_x, bc_y, bc_turn), (*first, *second), strict=True))
    return frames.chained.substitute(values)


def point_of(pose: Pose, forward: Any, left: Any = 0) -> tuple[Any, Any]:
    """Return a point of a frame, so far along its axes, where the frame's pose is seen from."""
    x, y, turn = pose
    with as_written():
        return (
            x + forward * cos(turn) - left * sin(turn),
            y + forward * sin(turn) + left * cos(turn),
        )


def axes(pose: Pose, name: str) -> tuple[Arrow, Arrow]:
    """Return the x and y axis of a frame; its name stands at x."""
    return (
        Arrow("x_axis", pose, point_of(pose, AXIS), label=f"x_{name}"),
        Arrow("y_axis", pose, point_of(pose, 0, AXIS)),
    )


def angle_to_pointer(pose: Pose) -> Any:
    """Return the pointer's direction as an angle of a frame."""
    there = seen_from(pose, (*POINTER, 0))
    return atan2(there[1], there[0])


def joint_sliders() -> tuple[Slider, ...]:
    """Return the sliders of the arm; at 180° an angle would meet its other name, −180°."""
    return (
        Slider.degrees(alpha, -175, 175, start=90, step=5, label="joint angle α"),
        Slider.degrees(beta, -120, 120, start=-90, step=5, label="joint angle β"),
        Slider.degrees(gamma, -120, 120, start=-45, step=5, label="joint angle γ"),
    )


T_db, T_de = (db_x, db_y, db_turn), (de_x, de_y, de_turn)


def chain_figure() -> Figure:
    """Draw the room from above: platform, arm and object to drag, the arrows of the chain."""
    steps = NamedSteps()
    elbow_here = frames.hand_pose.substitute({**LINKS, l_2: 0, beta: 0, gamma: 0})
    elbow_now = compose(T_db, elbow_here)
    wrist_now = compose(T_db, frames.hand_pose.substitute({**LINKS, gamma: 0}))
    bc = steps.add("bc", frames.hand_pose.substitute(LINKS))
    be = steps.add("be", seen_from(T_db, T_de))
    dc = steps.add("dc", compose(T_db, bc))
    elbow = steps.add("elbow", elbow_now)
    ce = steps.add("ce", seen_from(bc, be))
    chain = ((0, 0), T_db), (T_db, dc), ((0, 0), T_de)
    return Figure(
        name="room-plan",
        title="A room from above: a camera's frame d, a platform b with an arm, an object e",
        view=(-0.3, 2.1, -0.3, 1.5),
        size="",
        controls=(
            Slider(db_x, 0.3, 1.7, start=1.0, step=0.05, label="platform x_db"),
            Slider(db_y, 0.2, 1.2, start=0.5, step=0.05, label="platform y_db"),
            Slider.degrees(db_turn, -175, 175, start=90, step=5, label="platform θ_db"),
            *joint_sliders(),
            Slider(de_x, 0.0, 2.0, start=1.5, step=0.05, label="object x_de"),
            Slider(de_y, 0.0, 1.4, start=1.1, step=0.05, label="object y_de"),
            Slider.degrees(de_turn, -175, 175, start=135, step=5, label="object θ_de"),
        ),
        where=steps,
        shapes=(
            Body(T_db, db_turn, RADIUS),
            Line("body", (T_db, elbow, dc)),
            *(Arrow("path", *ends) for ends in chain),
            Arrow("icr", dc, T_de),
            *(*axes((0, 0, 0), "d"), *axes(T_db, "b"), *axes(dc, "c"), *axes(T_de, "e")),
            Point("body", elbow),
            *(Point("text", at) for at in ((0, 0), T_db, dc)),
            Point("target", T_de),
        ),
        handles=(
            Handle(
                "nose of the platform",
                point_of(T_db, RADIUS),
                {db_turn: angle_to_pointer((*T_db[:2], 0))},
            ),
            Handle("platform", T_db),
            Handle("second joint", elbow, {alpha: angle_to_pointer(T_db)}),
            Handle(
                "tip of the hand's x axis", point_of(dc, AXIS), {gamma: angle_to_pointer(wrist_now)}
            ),
            Handle("hand", dc, {beta: angle_to_pointer(elbow_now)}),
            Handle(
                "tip of the object's x axis",
                point_of(T_de, AXIS),
                {de_turn: angle_to_pointer((*T_de[:2], 0))},
            ),
            Handle("object", T_de),
        ),
        readouts=(
            Readout("x", "from hand c, x_ce", ce[0], "m"),
            Readout("y", "from hand c, y_ce", ce[1], "m"),
            Readout("turn", "from hand c, θ_ce", motion.wrap(ce[2]), "rad"),
            Readout("far", "distance from hand", sqrt(ce[0] ** 2 + ce[1] ** 2), "m"),
            Readout("hand_x", "from platform b, x_bc", bc[0], "m"),
            Readout("hand_y", "from platform b, y_bc", bc[1], "m"),
            Readout("hand_turn", "from platform b, θ_bc", motion.wrap(bc[2]), "rad"),
        ),
        sentence=(
            "The hand sees the object at x = {x}, y = {y}, turned by {turn}, {far} away. "
            "The platform sees its hand at x = {hand_x}, y = {hand_y}, turned by {hand_turn}."
        ),
    )


# In space. The room's frame here: its origin is below the camera, at the height of the arm.
SIZE = 0.3  # m, how long the axes of a frame are drawn
BASE, THING = (-0.2, -0.3), (0.3, 0.3)  # m, platform and object in the room
s = Symbol("s")


def upright(x: Any, y: Any, z: Any, angle: Any) -> Matrix:
    """Return the pose in the room, 4×4, of a thing that stands upright."""
    return Matrix(
        [
            [cos(angle), -sin(angle), 0, x],
            [sin(angle), cos(angle), 0, y],
            [0, 0, 1, z],
            [0, 0, 0, 1],
        ]
    )


def axes_in_space(T: Matrix, name: str) -> tuple[Any, ...]:
    """Return the three axes of a frame; its name stands at x and z."""
    labels = (f"x_{name}", "", f"z_{name}")
    return VIEW.frame(T[:3, :3], at=tuple(T[:3, 3]), size=SIZE, labels=labels)


def above_figure() -> Figure:
    """Draw a camera above the same room, in space: turn it, and the hand sees no change."""
    steps = NamedSteps()
    heading, high, low = db_turn, camera_high, object_low
    camera_sees = frames.looking_down.substitute(
        {motion.theta: -camera_turn, fb_x: 0, fb_y: 0, fb_z: high}
    )
    p_fb = steps.add("fb", camera_sees * Matrix([*BASE, 0, 1]))
    p_fe = steps.add("fe", camera_sees * Matrix([*THING, low, 1]))
    seen = {motion.theta: heading - camera_turn, fb_x: p_fb[0], fb_y: p_fb[1], fb_z: p_fb[2]}
    T_fb = frames.looking_down.substitute(seen)
    rotation = dict(zip(frames.r, T_fb[:3, :3], strict=True))
    p_bf = steps.add("bf", substitute(frames.inverse_in_space.right, {**rotation, **seen}))
    p_be = steps.add("be", T_fb[:3, :3].T * Matrix(p_fe[:3]) + p_bf)
    bc = steps.add("bc", frames.hand_pose.substitute(LINKS))
    ce = steps.add("ce", seen_from(bc, (p_be[0], p_be[1], 0)))

    # what is drawn, seen from the room: T_room_f is its own inverse, so camera_sees serves, too
    b = (*BASE, heading)
    c = steps.add("c", compose(b, bc))
    elbow = steps.add("k", compose(b, frames.hand_pose.substitute({**LINKS, l_2: 0})))
    eye, thing = (0, 0, high), (*THING, low)
    base, hand, middle = (*BASE, 0), (c[0], c[1], 0), (elbow[0], elbow[1], 0)
    rim = (BASE[0] + RADIUS * cos(s), BASE[1] + RADIUS * sin(s), 0)
    return Figure(
        name="camera-above",
        title="In space: a camera f that looks down on a platform b, its hand c and an object e",
        view=(-0.9, 0.9, -0.5, 1.3),
        size="",
        controls=(
            Slider.degrees(camera_turn, step=5, label="camera turned by"),
            Slider(high, 1.0, 1.4, start=1.2, step=0.05, label="height of the camera"),
            Slider.degrees(heading, start=90, step=5, label="heading of the platform"),
            *joint_sliders(),
            Slider(low, -0.4, 0.4, start=-0.2, step=0.05, label="height of the object"),
        ),
        where=steps,
        shapes=(
            VIEW.line("ghost", [thing, (*THING, 0)]),
            Curve("body", VIEW.project(rim), s, 0, 2 * pi, depth=VIEW.depth(rim)),
            VIEW.line("body", [base, middle]),
            VIEW.line("body", [middle, hand]),
            VIEW.arrow("path", eye, base),
            VIEW.arrow("path", eye, thing),
            VIEW.arrow("icr", hand, thing),
            *axes_in_space(camera_sees, "f"),
            *axes_in_space(upright(*base, heading), "b"),
            *axes_in_space(upright(*hand, c[2]), "c"),
            *axes_in_space(upright(*thing, 3 * pi / 4), "e"),
        ),
        readouts=(
            Readout("x_b", "from camera f, x_fb", p_fb[0], "m"),
            Readout("y_b", "from camera f, y_fb", p_fb[1], "m"),
            Readout("z_b", "from camera f, z_fb", p_fb[2], "m"),
            Readout("x_e", "from camera f, x_fe", p_fe[0], "m"),
            Readout("y_e", "from camera f, y_fe", p_fe[1], "m"),
            Readout("z_e", "from camera f, z_fe", p_fe[2], "m"),
            Readout("x", "from hand c, x_ce", ce[0], "m"),
            Readout("y", "from hand c, y_ce", ce[1], "m"),
            Readout("z", "from hand c, z_ce", p_be[2], "m"),
        ),
        sentence=(
            "The camera sees the object at x = {x_e}, y = {y_e}, z = {z_e}; "
            "the hand sees it at x = {x}, y = {y}, z = {z}."
        ),
        seen_from=(-pi / 3, 5 * pi / 36),
    )


MISTAKES = symbols("mistake:4", real=True)  # 1 for the one that is made, else 0
BOX = 0.09  # m, half a side of the object


def pose_matrix(pose: Pose) -> Matrix:
    """Return a pose in the plane as a matrix."""
    return frames.matrix.substitute(dict(zip(T_db, pose, strict=True)))


def object_by_mistake(db: Pose, bc: Pose, de: Pose) -> dict[str, Matrix]:
    """Return the object as the hand sees it, T_ce, by each mistake."""
    turned = {bank.T_db: db, bank.T_bc: bc}
    given = {T: pose_matrix(pose) for T, pose in {**turned, bank.T_de: de}.items()}
    given |= {T.inv(): pose_matrix(seen_from(pose, (0, 0, 0))) for T, pose in turned.items()}
    by_sign = {
        T.inv(): pose_matrix(
            (*unturned_shift.substitute({bank.p: Matrix(pose[:2])}).doit(), -pose[2])
        )
        for T, pose in turned.items()
    }
    found = {
        no_inverse.title: no_inverse.substitute(given),
        unturned_shift.title: substitute(bank.FROM_HAND.right, {**given, **by_sign}),
        same_order.title: same_order.substitute(given),
        T_bc_kept.title: T_bc_kept.substitute(given),
    }
    return {name: T_ce.doit() for name, T_ce in found.items()}


def box(kind: str, pose: Pose, name: str = "") -> tuple[Any, ...]:
    """Return the object from above, and its x axis."""
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))
    rim = tuple(point_of(pose, BOX * a, BOX * b) for a, b in corners)
    return Area(kind, rim), Line(kind, rim), Arrow(kind, pose, point_of(pose, AXIS), name)


def mistakes_figure() -> Figure:
    """Draw the room from above, and where a program with a mistake believes the object to be."""
    steps = NamedSteps()
    db, de, bends = (0.6, 0.5, db_turn), (-0.3, 0.6, -pi / 3), (-pi / 2, 7 * pi / 12, pi / 4)
    arm = {**LINKS, **dict(zip((alpha, beta, gamma), bends, strict=True))}
    hand = [float(number) for number in frames.hand_pose.substitute(arm)]
    elbow = compose(db, frames.hand_pose.substitute({**arm, l_2: 0}))
    c = steps.add("c", compose(db, hand))
    ways = object_by_mistake(db, hand, de)
    T = sum((one * way for one, way in zip(MISTAKES, ways.values(), strict=True)), zeros(3))
    ce = steps.add("ce", Matrix([T[0, 2], T[1, 2], atan2(T[1, 0], T[0, 0])]))
    e = steps.add("e", compose(c, ce))
    return Figure(
        name="wrong-object",
        title="A platform with an arm, an object, and where a program with a mistake believes it",
        view=(-0.6, 1.6, -0.2, 1.45),
        controls=(
            Choice.one_hot("mistake", MISTAKES, ways, start=no_inverse.title),
            Slider.degrees(db_turn, 60, 150, start=90, step=5, label="platform θ_db"),
        ),
        where=steps,
        shapes=(
            Line("error", (de, e)),
            Body(db, db_turn, RADIUS),
            Line("body", (db, elbow, c)),
            Point("body", elbow),
            *(*axes((0, 0, 0), "d"), *axes(db, "b"), *axes(c, "c")),
            *box("target", de, "x_e"),
            *box("approximation", e),
        ),
        readouts=(
            Readout("apart", "apart", distance(e, de), "m"),
            Readout("off", "turned off by", motion.wrap(e[2] - de[2]), "rad", digits=0),
        ),
    )


FIGURES = (chain_figure(), above_figure(), mistakes_figure())
