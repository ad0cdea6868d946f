"""The live figures of the chapter on chains of frames: one room, seen by a camera and by a hand."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import pi
from typing import Any, NamedTuple

from sympy import (
    Abs,
    And,
    Gt,
    Matrix,
    Or,
    Piecewise,
    Symbol,
    atan2,
    cos,
    eye,
    nan,
    sin,
    sinc,
    sqrt,
    symbols,
    zeros,
)

from book import things
from book.frames import exercises as bank
from book.frames import formulas as frames
from book.frames.exercises import T_bc_kept, no_inverse, same_order, unturned_shift
from book.frames.formulas import (
    SOUGHT,
    alpha,
    bc_turn,
    bc_x,
    bc_y,
    beta,
    bp_x,
    bp_y,
    db_turn,
    db_x,
    db_y,
    de_turn,
    de_x,
    de_y,
    error,
    gamma,
    l_1,
    l_2,
    lever,
    missed,
    pole_x,
    pole_y,
)
from book.letters import put_back
from book.motion import formulas as motion
from book.things import meshes, space
from book.things.graph import LinearGraph
from book.things.outlines import box, disc, line
from courseware.equations import as_written, declarations, substitute
from courseware.figures import (
    POINTER,
    VIEW,
    AngleArc,
    Arrow,
    Bracket,
    Choice,
    Clock,
    Curve,
    Figure,
    Goal,
    Handle,
    Label,
    Length,
    Line,
    NamedSteps,
    Outline,
    Point,
    Readout,
    Slider,
    Sprite,
    assign,
    distance,
    ramp,
    when,
)

quantity, _ = declarations(__name__)

Pose = Any  # [x, y, theta]

LINKS = {l_1: 0.3, l_2: 0.4}  # m, as in the exercise
JAWS = 0.2  # m: from the hand's frame, at the third joint, to between its fingers
GRIP = 0.17  # m: there is the middle of a box that they hold
PLATFORM, BENDS = (1.0, 0.5, pi / 2), (pi / 2, -pi / 2, -pi / 4)  # the exercise: T_db, the joints
OBJECT = (1.5, 1.1, 3 * pi / 4)  # T_de
CAMERA = (0, 0, 0)
AXIS = 0.26  # m: how long the axes of a frame are drawn
DEGREE = pi / 180

camera_turn = quantity("camera_turn", "rad", -3.14, 3.14, "turn of the camera about its view")
camera_tilt = quantity("camera_tilt", "rad", -0.2, 0.2, "tilt of the camera about its x axis")
tilt_y = quantity("tilt_y", "rad", -0.2, 0.2, "tilt of the camera about its y axis")
hidden = quantity("hidden", "", 0, 1, "1 where a curtain hides the platform from the camera")
lifted = quantity("lifted", "", 0, 1, "how far the tracing paper is lifted")
made = quantity("made", "", 0, 2, "how many of two motions are made")
part = quantity("part", "", 0, 1, "how much of a turn is made")
guess_x = quantity("guess_x", "m", -0.5, 2, "your guess, along x of the camera")
guess_y = quantity("guess_y", "m", -0.5, 2, "your guess, along y of the camera")
guess_right = quantity("guess_right", "m", -1, 1, "your guess, to the right of the platform")
guess_ahead = quantity("guess_ahead", "m", -1.5, 1, "your guess, ahead of the platform")
start_frame = quantity("start_frame", "", 0, 5, "the frame that sees, by its number")
end_frame = quantity("end_frame", "", 0, 5, "the frame that is seen, by its number")
s = Symbol("s")


# Poses.


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


def axes(pose: Pose, name: str, long: Any = AXIS) -> tuple[Arrow, Arrow]:
    """Return the x and y axis of a frame, without a name without letters."""
    x, y = (f"{axis}_{name}" if name else "" for axis in "xy")
    return (
        Arrow("x_axis", pose, point_of(pose, long), x),
        Arrow("y_axis", pose, point_of(pose, 0, long), y),
    )


def lettered(pose: Pose, name: str, long: Any = AXIS) -> tuple[Any, ...]:
    """Return the axes of a frame with its letter beside them, which stays there."""
    return *axes(pose, "", long), Label("text", point_of(pose, -0.12, 0.12), name)


def angle_to_pointer(pose: Pose) -> Any:
    """Return the pointer's direction as an angle of a frame."""
    there = seen_from(pose, (*POINTER, 0))
    return atan2(there[1], there[0])


def nose(pose: Pose, far: float = 0.32) -> Handle:
    """Return a handle ahead of the platform, which turns it."""
    turn = angle_to_pointer((*pose[:2], 0))
    return Handle("nose of the platform", point_of(pose, far), {db_turn: turn})


def tip_of_hand(hand: Pose, link: Any) -> Handle:
    """Return a handle ahead of the hand, which turns it against the direction of its link."""
    turn = angle_to_pointer((*hand[:2], link))
    return Handle("tip of the hand's x axis", point_of(hand, AXIS), {gamma: turn})


def turned_apart(angle: Any, period: int = 1) -> Any:
    """Return the size of an angle round the circle, or round a part of it."""
    return Abs(atan2(sin(period * angle), cos(period * angle))) / period


T_db, T_de, T_bc = (db_x, db_y, db_turn), (de_x, de_y, de_turn), (bc_x, bc_y, bc_turn)
SEEN = tuple(SOUGHT[name] for name in ("x_ce", "y_ce", "theta_ce"))


# The room, seen by the camera at the left, and by something that rests at the right.

ROOM = (-0.08, 1.6, -0.08, 1.64)  # m: x_low, x_high, y_low, y_high
PANE = (-0.13, 1.65, -0.13, 1.69)  # of it the camera's picture shows so much
BESIDE = PANE[1] - PANE[0] + 0.06  # m: so far to the right is the other picture
OTHER = (PANE[0] + BESIDE, PANE[1] + BESIDE, *PANE[2:])
MIDDLE = ((OTHER[0] + OTHER[1]) / 2, 0.6, pi / 2)  # there the hand rests, its x axis up
BOTH = (PANE[0] - 0.01, OTHER[1] + 0.01, PANE[2] - 0.01, PANE[3] + 0.01)
SHEET = (-0.2, 0.95, -0.8, 0.4)  # of tracing paper, in the hand's frame
BOX = (0.13, 0.055)  # m, of the object: it fits between the fingers


class Arm(NamedTuple):
    """Poses of the arm's parts in the room, as named steps, and the hand seen from the platform."""

    elbow: Any
    hand: Any
    from_platform: Any


def arm_on(steps: NamedSteps, platform: Pose, bends: Sequence[Any]) -> Arm:
    """Add the arm's poses to the steps of a figure."""
    given = {**LINKS, **dict(zip((alpha, beta, gamma), bends, strict=True))}
    bc = steps.add("bc", frames.hand_pose.substitute(given))
    to_elbow = frames.hand_pose.substitute({**given, l_2: 0, beta: 0, gamma: 0})
    elbow = steps.add("elbow", compose(platform, to_elbow))
    return Arm(elbow, steps.add("dc", compose(platform, bc)), bc)


def robot(pose: Pose, bends: Sequence[Any], opening: Any = 1, look: str = "") -> Sprite:
    """Return the platform with its arm."""
    return things.platform(pose, bends, (*LINKS.values(), JAWS), opening, look=look)


def seen_at(frame: Pose, middle: Pose = MIDDLE) -> tuple[Any, Any, Any]:
    """Return where the room lies in a picture in which a frame rests."""
    back = seen_from(frame, (0, 0, 0))
    return (*point_of(middle, back[0], back[1]), middle[2] + back[2])


def room_at(
    pose: Pose, pane: Sequence[float], *inside: Any, paper: Any = (), below: Any = ()
) -> tuple[Any, ...]:
    """Return the room in one of the pictures, what is in it, and shapes below that."""
    left, right, low, high = pane
    rim = Outline(box(right - left, high - low, corner=0.03), "", "edge")
    shelf = things.shelf((0.35, ROOM[3], 0), 0.6, 0.14)
    return (
        Sprite(pose, (*things.tiled_room(ROOM), *paper), silhouette="", window=tuple(pane)),
        *below,
        Sprite(pose, (shelf, *inside), 0.03, silhouette="", window=tuple(pane)),
        Sprite(((left + right) / 2, (low + high) / 2, 0), (rim,), silhouette=""),
    )


def caption(pane: Sequence[float], words: str, up: float = 0.15) -> Label:
    """Return the words in a picture, inside its wall."""
    return Label("text", ((pane[0] + pane[1]) / 2 + 0.1, pane[2] + up), words)


def two_views(hand: Pose, *inside: Any) -> tuple[Any, ...]:
    """Return the room as the camera sees it and as the hand sees it, with the hand's paper."""
    paper, inside = (things.tracing_paper(hand, SHEET),), (things.camera_above(CAMERA), *inside)
    near_edge = Gt(hand[0], PANE[1] - 0.5)  # there its letters would be in the other picture
    named = (
        *when(~near_edge, *axes(hand, "c", 0.34)),
        *when(near_edge, *axes(hand, "", 0.34)),
    )
    return (
        *room_at(CAMERA, PANE, *inside, paper=paper, below=named),
        *room_at(seen_at(hand), OTHER, *inside, paper=paper, below=axes(MIDDLE, "c", 0.34)),
        caption(PANE, "the camera sees"),
        caption(OTHER, "the hand sees"),
    )


def parcel(pose: Pose, look: str = "") -> Sprite:
    """Return the object."""
    return things.parcel(pose, *BOX, look=look)


GRIPPED = Sprite(
    (*point_of(MIDDLE, GRIP), MIDDLE[2]),
    (Outline(box(BOX[0] + 0.03, BOX[1] + 0.03), "goal", "goal_edge", opacity=0.6),),
    silhouette="",
)


def is_gripped(ce: Pose) -> Any:
    """Return whether the object lies between the fingers, one way round or the other."""
    near = And(Abs(ce[0] - GRIP) < 0.05, Abs(ce[1]) < 0.03)
    return And(near, turned_apart(ce[2], 2) < 15 * DEGREE)


def views_figure() -> Figure:
    """Draw the opening: two views of one room, platform and two joints to drag."""
    steps = NamedSteps()
    platform, bends = (db_x, db_y, pi / 2), (alpha, beta, BENDS[2])
    arm = arm_on(steps, platform, bends)
    ce = steps.add("ce", seen_from(arm.hand, OBJECT))
    gripped = is_gripped(ce)
    closed = Piecewise((0.5, gripped), (1, True))
    return Figure(
        name="two-views",
        title="One room twice: as a camera on the ceiling sees it, and as the robot's hand sees it",
        view=BOTH,
        ground="wall",
        size="laboratory",
        controls=(
            Slider(db_x, 0.3, 1.4, start=0.7, step=0.02, label="platform, to the right"),
            Slider(db_y, 0.2, 1.3, start=0.5, step=0.02, label="platform, up the page"),
            Slider.degrees(alpha, -175, 175, start=50, step=5, label="first joint α"),
            Slider.degrees(beta, -150, 150, start=-80, step=5, label="second joint β"),
        ),
        where=steps,
        shapes=(*two_views(arm.hand, robot(platform, bends, closed), parcel(OBJECT)), GRIPPED),
        handles=(
            Handle("platform", platform[:2]),
            Handle("elbow", arm.elbow[:2], {alpha: angle_to_pointer(platform)}),
            Handle("hand", arm.hand[:2], {beta: angle_to_pointer(arm.elbow)}),
        ),
        readouts=(
            Readout("off", "off by", distance(ce, (GRIP, 0)), "cm", 0),
            Readout("turned", "turned off by", turned_apart(ce[2], 2), "rad", 0),
        ),
        goal=Goal(
            gripped,
            "Bring the yellow box onto the pale one between the fingers: within 5 cm along, 3 cm "
            "across, 15°.",
        ),
    )


# The exercise, and the steps.


def plan_figure() -> Figure:
    """Draw the exercise with all its symbols, at rest."""
    steps = NamedSteps()
    given = (*zip(T_db, PLATFORM, strict=True), *zip((alpha, beta, gamma), BENDS, strict=True))
    arm = arm_on(steps, PLATFORM, BENDS)
    first, second = PLATFORM[2] + BENDS[0], PLATFORM[2] + BENDS[0] + BENDS[1]
    return Figure(
        name="chain-exercise",
        title=(
            "A room from above: the camera's frame d in a corner, a platform b whose arm reaches "
            "to the left and then up to the hand c, an object e to the right of the hand"
        ),
        view=(-0.2, 2.0, -0.36, 1.45),
        ground="tiles",
        where=(*given, *LINKS.items(), *steps),
        shapes=(
            Line("ghost", (PLATFORM, point_of(PLATFORM, 0.4))),
            Line("ghost", (arm.elbow, point_of((*arm.elbow[:2], first), 0.25))),
            Line("ghost", (arm.hand, point_of((*arm.hand[:2], second), 0.25))),
            parcel(OBJECT),
            robot(PLATFORM, BENDS),
            things.camera_above(CAMERA),
            *axes(CAMERA, "d"),
            *axes(PLATFORM, "b", 0.34),
            *axes(arm.hand, "c", 0.34),
            *axes(OBJECT, "e", 0.2),
            AngleArc(alpha, PLATFORM, PLATFORM[2], first, 0.16),
            AngleArc(beta, arm.elbow, first, second, 0.13),
            AngleArc(gamma, arm.hand, second, arm.hand[2], 0.17),
            Length(l_1, arm.elbow, PLATFORM, aside=-0.2, label="0.3 m"),
            Length(l_2, arm.elbow, arm.hand, aside=0.12, label="0.4 m"),
        ),
    )


def tracing_figure() -> Figure:
    """Draw the hand's paper with the object traced on it: lift it, turn it upright."""
    steps = NamedSteps()
    bends = (*BENDS[:2], gamma)
    arm = arm_on(steps, PLATFORM, bends)
    ce = steps.add("ce", seen_from(arm.hand, OBJECT))
    there = [here + lifted * (end - here) for here, end in zip(arm.hand, MIDDLE, strict=True)]
    traced = Outline(box(*BOX), "", "path", 0.01)
    paper = things.tracing_paper(there, SHEET, parts=(Sprite((*ce,), (traced,), silhouette=""),))
    return Figure(
        name="tracing",
        title="The room; squared paper that is pinned to the hand is lifted and turned upright",
        view=BOTH,
        ground="wall",
        controls=(
            Slider.degrees(gamma, -100, -15, start=-45, step=5, label="third joint γ"),
            Clock(lifted, 0.0, 1.0, step=0.02, rate=0.5, label="paper lifted"),
        ),
        where=(*steps, *zip(SEEN, ce, strict=True)),
        shapes=(
            *room_at(CAMERA, PANE, parcel(OBJECT), robot(PLATFORM, bends)),
            *room_at((nan, nan, nan), OTHER),
            paper,
            *axes(arm.hand, "c"),
            *when(lifted > 0.1, *axes(there, "c")),
            caption(OTHER, "the hand sees"),
        ),
        handles=(tip_of_hand(arm.hand, PLATFORM[2]),),
        readouts=(Readout(SEEN[0]), Readout(SEEN[1])),
    )


FLAT: dict[str, Any] = {"view": (-0.3, 2.1, -0.25, 1.3), "ground": "tiles"}


def pose_figure() -> Figure:
    """Draw a platform to drag and turn, and its matrix: each column in the colour of its arrow."""
    matrix = frames.matrix.right
    return Figure(
        name="pose-columns",
        title="A platform from above with its axes, and beside it the matrix of its pose",
        **FLAT,
        controls=(
            Slider(db_x, 0.1, 0.8, start=0.7, step=0.05),
            Slider(db_y, 0.2, 1.0, start=0.5, step=0.05),
            Slider.degrees(db_turn, -175, 175, start=60, step=5),
        ),
        shapes=(
            things.camera_above(CAMERA),
            things.platform(T_db),
            Arrow("path", CAMERA, T_db, ""),
            Label("path", (0.45 * db_x, 0.45 * db_y), "p"),
            *axes(CAMERA, "d"),
            *axes(T_db, "b", 0.32),
            AngleArc(db_turn, T_db, 0, db_turn, 0.13),
            Bracket(matrix, (1.6, 0.5), "T_db", ("x_axis", "y_axis", "text"), 2),
        ),
        handles=(nose(T_db), Handle("platform", T_db)),
    )


LAMP = (0.2, 0.15)  # m: the left front corner of the platform, seen from b


def lamp_figure() -> Figure:
    """Draw a frame, and a guess of where the camera sees a lamp of it: turned, then shifted."""
    now = (PLATFORM[0] * ramp(made, 1), PLATFORM[1] * ramp(made, 1), PLATFORM[2] * ramp(made, 0))
    ahead, there = point_of(PLATFORM, LAMP[0]), point_of(PLATFORM, *LAMP)
    lit = point_of(now, *LAMP)
    return Figure(
        name="lamp",
        title="The camera's frame, the frame of the platform, and your guess of where its lamp is",
        **FLAT,
        controls=(
            Slider(guess_x, 0.0, 1.8, start=0.4, step=0.05, label="x"),
            Slider(guess_y, 0.0, 1.2, start=1.0, step=0.05, label="y"),
            Clock(made, 0.0, 2.0, step=0.02, rate=0.6, label="turn, shift"),
        ),
        where=(
            (bp_x, LAMP[0]),
            (bp_y, LAMP[1]),
            *zip(T_db, PLATFORM, strict=True),
            *assign(frames.point),
        ),
        shapes=(
            *axes(CAMERA, "d"),
            *axes(PLATFORM, "b", 0.32),
            *when(
                made > 0,
                things.platform(now, look="ghost"),
                things.lamplight((*lit, 0), 0.12),
                Sprite((*lit, 0), (Outline(disc(0.03), "lamp", "goal_edge"),), 0.01),
            ),
            *when(
                made >= 2,
                Length("x_axis", PLATFORM, ahead, "0.2 m", -0.1),
                Length("y_axis", ahead, there, "0.15 m", -0.12),
            ),
            *when(made <= 0, Label("text", (1.5, 0.45), "the frame b")),
            Point("target", (guess_x, guess_y), "your guess"),
        ),
        handles=(Handle("your guess", (guess_x, guess_y)),),
    )


def bends_figure() -> Figure:
    """Draw the platform and its arm: directions add up along the links."""
    steps = NamedSteps()
    here = (0, 0, pi / 2)
    bends = (alpha, BENDS[1], gamma)
    arm = arm_on(steps, here, bends)
    first = pi / 2 + alpha
    second = first + BENDS[1]
    parts = tuple(zip((alpha, beta, gamma)[1:2], BENDS[1:2], strict=True))
    return Figure(
        name="directions",
        title="The platform from above, its arm, the angle of each joint against the link before",
        view=(-0.95, 0.75, -0.3, 0.85),
        ground="tiles",
        controls=(
            Slider.degrees(alpha, 0, 175, start=90, step=5, label="first joint α"),
            Slider.degrees(gamma, -120, 120, start=-45, step=5, label="third joint γ"),
        ),
        where=(*parts, *LINKS.items(), *steps, *zip(T_bc, arm.from_platform, strict=True)),
        shapes=(
            robot(here, bends),
            Line("ghost", (here, point_of(here, 0.4))),
            Line("ghost", (arm.elbow, point_of((*arm.elbow[:2], first), 0.2))),
            Line("ghost", (arm.hand, point_of((*arm.hand[:2], second), 0.2))),
            *axes(here, "b", 0.34),
            *axes(arm.hand, "c"),
            AngleArc(alpha, here, pi / 2, first, 0.16),
            AngleArc(beta, arm.elbow, first, second, 0.1),
            AngleArc(gamma, arm.hand, second, arm.hand[2], 0.16),
        ),
        handles=(
            Handle("elbow", arm.elbow[:2], {alpha: angle_to_pointer(here)}),
            tip_of_hand(arm.hand, second),
        ),
        readouts=(Readout(bc_x), Readout(bc_y), Readout(bc_turn)),
    )


SHIFT, QUARTER = 0.8, pi / 2  # m, rad: of the two motions


def order_figure() -> Figure:
    """Draw a shift and a turn about the camera's origin, in two orders."""
    one, two = ramp(made, 0), ramp(made, 1)
    shifted_first = (
        SHIFT * one * cos(QUARTER * two),
        SHIFT * one * sin(QUARTER * two),
        QUARTER * two,
    )
    turned_first = (SHIFT * two, 0, QUARTER * one)
    return Figure(
        name="two-orders",
        title="A platform at the camera's origin, shifted and turned in two orders, and your guess",
        view=(-0.55, 1.45, -0.3, 1.05),
        ground="tiles",
        controls=(
            Slider(guess_x, -0.4, 1.3, start=0.4, step=0.05, label="x"),
            Slider(guess_y, -0.2, 1.0, start=0.5, step=0.05, label="y"),
            Clock(made, 0.0, 2.0, step=0.02, rate=0.6, label="motions made"),
        ),
        shapes=(
            things.platform(CAMERA, look="ghost"),
            things.platform(turned_first, look="ghost"),
            things.platform(shifted_first),
            *axes(CAMERA, "d", 0.35),
            *when(
                made > 1,
                Curve("path", (SHIFT * cos(s), SHIFT * sin(s)), s, 0, QUARTER * two),
            ),
            *when(
                made >= 2,
                Label("text", (0.3, 0.95), "shift, then turn"),
                Label("text", (1.0, -0.22), "turn, then shift"),
            ),
            Point("target", (guess_x, guess_y), "your guess"),
        ),
        handles=(Handle("your guess", (guess_x, guess_y)),),
    )


PEG = (0.35, 0.65)  # m: where the pole shall be; at 90° with y = 0.3 m


def pole_figure() -> Figure:
    """Draw a pose as one turn about a point, which stays where it is."""
    half, pole = db_turn / 2, (pole_x, pole_y)
    share = s * sinc(s * half) / sinc(half)
    way = (
        share * (db_x * cos((s - 1) * half) - db_y * sin((s - 1) * half)),
        share * (db_x * sin((s - 1) * half) + db_y * cos((s - 1) * half)),
    )
    now = [substitute(each, {s: part}) for each in way]
    peg = Outline(disc(0.045), "goal", "goal_edge")
    return Figure(
        name="pole",
        title="A platform before and after a shift and a turn, and the point that both leave alone",
        view=(-0.9, 1.6, -0.35, 1.25),
        ground="tiles",
        controls=(
            Slider.degrees(db_turn, 10, 170, start=40, step=5),
            Slider(db_y, 0.0, 1.0, start=0.6, step=0.05),
            Clock(part, 0.0, 1.0, start=1.0, step=0.02, rate=0.4, label="part of the turn"),
        ),
        where=((db_x, 1.0), *assign(frames.pole)),
        shapes=(
            Sprite((*PEG, 0), (peg,), 0.02),
            things.platform(CAMERA, look="ghost"),
            Curve("path", way, s, 0, part),
            things.platform((*now, part * db_turn)),
            *axes(CAMERA, "d", 0.33),
            *axes((*now, part * db_turn), "b", 0.33),
            Line("icr", (CAMERA, pole, now)),
            *when(
                part > 0.3,
                AngleArc(
                    "icr",
                    pole,
                    atan2(-pole_y, -pole_x),
                    atan2(-pole_y, -pole_x) + part * db_turn,
                    0.13,
                    "",
                ),
            ),
            Point("icr", pole, "pole"),
        ),
        readouts=(Readout(pole_x), Readout(pole_y)),
        goal=Goal(distance(pole, PEG) < 0.04, "Bring the pole to the peg: within 4 cm."),
    )


# The way back.

SLANT = (*PLATFORM[:2], pi / 6)  # a platform that looks another way than in the exercise
MAP = (-0.91, 0.91, -1.5, 0.5)  # the map of something that rests at the origin
ASIDE = (-2.73, -1.26, 0)  # where the camera is in its own picture, which lies left of that map
ITS_PANE = tuple(
    edge + off for edge, off in zip(PANE, (ASIDE[0],) * 2 + (ASIDE[1],) * 2, strict=True)
)
UP = (0, 0, pi / 2)


def back_figure() -> Figure:
    """Draw the camera's picture, and beside it the platform's map: where is the camera in it?"""
    there = compose(ASIDE, SLANT)
    paper = [here + lifted * (end - here) for here, end in zip(there, UP, strict=True)]
    eye_seen = seen_from(SLANT, CAMERA)
    camera = (*point_of(UP, *eye_seen[:2]), UP[2] + eye_seen[2])
    traced = Outline(box(0.16, 0.12, -0.08, 0, 0.03), "", "path", 0.012)
    sheet = (-1.3, 0.35, -0.4, 0.4)
    return Figure(
        name="way-back",
        title="The camera's picture with a platform; beside it the platform's own map, still empty",
        view=(ITS_PANE[0] - 0.01, MAP[1] + 0.01, MAP[2] - 0.01, MAP[3] + 0.01),
        ground="wall",
        controls=(
            Slider(guess_right, -0.85, 0.85, start=0.4, step=0.05, label="to the right"),
            Slider(guess_ahead, -1.25, 0.5, start=0.3, step=0.05, label="ahead"),
            Clock(lifted, 0.0, 1.0, step=0.02, rate=0.5, label="paper lifted"),
        ),
        shapes=(
            *room_at(ASIDE, ITS_PANE, things.camera_above(CAMERA), things.platform(SLANT)),
            *room_at((nan, nan, nan), MAP),
            *when(
                lifted > 0,
                things.tracing_paper(
                    paper, sheet, parts=(Sprite((*eye_seen,), (traced,), silhouette=""),)
                ),
            ),
            things.platform(UP),
            *axes(ASIDE, ""),
            Label("text", point_of(ASIDE, 0.13, 0.15), "d"),
            *axes(there, "b", 0.33),
            *axes(UP, "b", 0.33),
            *when(lifted >= 1, things.camera_above(camera), *axes(camera, "d")),
            caption(ITS_PANE, "the camera sees"),
            caption(MAP, "the platform sees", 0.08),
            Point("target", (guess_right, guess_ahead), "your guess"),
        ),
        handles=(Handle("your guess", (guess_right, guess_ahead)),),
    )


def home_figure() -> Figure:
    """Draw −p along the axes of the platform: it is long enough, and must be turned."""
    placed = dict(zip((db_x, db_y), PLATFORM[:2], strict=True))
    back = [each.subs(placed) for each in frames.turned_round.right]
    turned = -part * db_turn
    wrong = (-PLATFORM[0], -PLATFORM[1])
    now = (
        wrong[0] * cos(turned) - wrong[1] * sin(turned),
        wrong[0] * sin(turned) + wrong[1] * cos(turned),
    )
    camera = (*point_of(UP, *back[:2]), UP[2] + back[2])
    seen = [SOUGHT[name] for name in ("x_bd", "y_bd", "theta_bd")]
    return Figure(
        name="turned-home",
        title="The platform's map: the camera, and the arrow −p, which does not lead there",
        view=(-1.75, 1.75, -1.37, 1.2),
        ground="tiles",
        controls=(
            Slider.degrees(db_turn, -175, 175, start=30, step=5),
            Clock(part, 0.0, 1.0, step=0.02, rate=0.5, label="turned back"),
        ),
        where=(*placed.items(), *zip(seen, back, strict=True)),
        shapes=(
            Curve(
                "ghost",
                point_of(
                    UP, wrong[0] * cos(s) - wrong[1] * sin(s), wrong[0] * sin(s) + wrong[1] * cos(s)
                ),
                s,
                0,
                2 * pi,
            ),
            things.platform(UP),
            things.camera_above(camera),
            *axes(camera, "d", 0.3),
            *axes(UP, "b", 0.33),
            Arrow("approximation", UP, point_of(UP, *wrong), "−p"),
            *when(part > 0, Arrow("path", UP, point_of(UP, *now), "−Rᵀp")),
            *when(
                And(part > 0.2, Abs(db_turn) > 0.2),
                AngleArc(
                    db_turn,
                    UP,
                    UP[2] + atan2(wrong[1], wrong[0]),
                    UP[2] + atan2(wrong[1], wrong[0]) + turned,
                    0.5,
                    "−θ_db",
                ),
            ),
        ),
        handles=(
            Handle(
                "the camera",
                camera[:2],
                {db_turn: motion.wrap(atan2(wrong[1], wrong[0]) - angle_to_pointer(UP))},
            ),
        ),
        readouts=(Readout(seen[0]), Readout(seen[1])),
    )


# Dominoes.

NAMES = "bcde"
SLOTS = tuple(
    symbols(f"x_{k} y_{k} turn_{k} from_{k} to_{k} bad_{k}", real=True) for k in (1, 2, 3)
)
HAND = tuple(
    float(number)
    for number in frames.hand_pose.substitute(
        {**LINKS, **dict(zip((alpha, beta, gamma), BENDS, strict=True))}
    )
)
IN_ROOM = tuple(float(number) for number in compose(PLATFORM, HAND))


def tiles() -> dict[str, tuple[float, ...]]:
    """Return the tiles: pose and letters of each known one, also flipped, well and badly."""
    known = {("d", "b"): PLATFORM, ("b", "c"): HAND, ("d", "e"): OBJECT}
    found = {}
    for (a, b), pose in known.items():
        ends = NAMES.index(a), NAMES.index(b)
        found[f"T_{a}{b}"] = (*pose, *ends, 0)
        found[f"T_{b}{a}"] = (*map(float, seen_from(pose, (0, 0, 0))), *ends[::-1], 0)
    for a, b in (("d", "b"), ("b", "c")):
        pose = known[a, b]
        bad = (-pose[0], -pose[1], -pose[2])
        found[f"T_{b}{a} with −p"] = (*bad, NAMES.index(b), NAMES.index(a), 1)
    return found


def tile(slot: Sequence[Any], at: tuple[float, float]) -> tuple[Any, ...]:
    """Return a tile with its two letters at a place, marked if it was flipped badly."""
    edges = Outline(line((0, -0.11), (0, 0.11)), "", "edge")
    good, bad = (
        (Outline(box(0.52, 0.3, corner=0.03), "paper", edge, wide), edges)
        for edge, wide in (("edge", 0), ("error", 0.02))
    )
    letters = [
        shape
        for end, aside in ((slot[3], -0.13), (slot[4], 0.13))
        for k, letter in enumerate(NAMES)
        for shape in when(Abs(end - k) < 0.5, Label("text", (at[0] + aside, at[1]), letter))
    ]
    mark = when(
        slot[5] > 0.5,
        Sprite((*at, 0), bad, silhouette=""),
        Label("text", (at[0], at[1] - 0.22), "with −p"),
    )
    return Sprite((*at, 0), good, silhouette=""), *mark, *letters


def domino_figure() -> Figure:
    """Draw three tiles to choose, whether their letters meet, and the object where they put it."""
    steps = NamedSteps()
    two = steps.add("two", compose(SLOTS[0][:3], SLOTS[1][:3]))
    laid = steps.add("laid", compose(two, SLOTS[2][:3]))
    ghost = steps.add("ghost", compose(IN_ROOM, laid))
    places = [(0.1 + 0.66 * k, 1.72) for k in range(3)]
    meets = [Abs(one[4] - two[3]) < 0.5 for one, two in pairwise(SLOTS)]
    right_ends = And(Abs(SLOTS[0][3] - 1) < 0.5, Abs(SLOTS[2][4] - 3) < 0.5)
    off = distance(ghost, OBJECT)
    strip = Outline(box(2.7, 0.56), "wall_top", "edge")
    between = [
        shape
        for meet, (x, y) in zip(meets, places, strict=False)
        for shape in (
            *when(meet, Line("velocity", ((x + 0.2, y), (x + 0.46, y)))),
            *when(~meet, Point("error", (x + 0.33, y))),
        )
    ]
    return Figure(
        name="dominoes",
        title="Three dominoes with letters in a row; the room, and where they put the object",
        view=(-0.35, 2.15, -0.3, 1.96),
        ground="tiles",
        size="laboratory",
        controls=tuple(
            Choice(f"tile_{k + 1}", f"tile {k + 1}", slot, tiles(), start=start)
            for k, (slot, start) in enumerate(zip(SLOTS, ("T_db", "T_cb", "T_de"), strict=True))
        ),
        where=steps,
        shapes=(
            things.camera_above(CAMERA),
            parcel(OBJECT),
            robot(PLATFORM, BENDS),
            *lettered(CAMERA, "d"),
            *lettered(PLATFORM, "b", 0.3),
            *lettered(IN_ROOM, "c", 0.3),
            Label("text", (OBJECT[0] + 0.14, OBJECT[1]), "e"),
            Line("error", (OBJECT, ghost)),
            parcel(ghost, "wrong"),
            Sprite((0.9, places[0][1], 0), (strip,), silhouette=""),
            *[shape for slot, at in zip(SLOTS, places, strict=True) for shape in tile(slot, at)],
            *between,
        ),
        readouts=(Readout("off", "red box off by", off, "m"),),
        goal=Goal(
            And(*meets, right_ends, off < 0.01),
            "Lay tiles from c to e, so that the red box meets the yellow one within 1 cm.",
        ),
    )


def difference_figure() -> Figure:
    """Draw the difference of two places, along the camera's axes and along the platform's."""
    given = {
        **dict(zip(T_db[:2], PLATFORM[:2], strict=True)),
        **dict(zip(T_de, OBJECT, strict=True)),
    }
    be = [SOUGHT[name] for name in ("x_be", "y_be", "theta_be")]
    here, beside = (*PLATFORM[:2], db_turn), (OBJECT[0], PLATFORM[1])
    corner = point_of(here, be[0])
    return Figure(
        name="differences",
        title="Platform and object: the way between them along the axes of camera and platform",
        view=(0.05, 2.15, -0.05, 1.4),
        ground="tiles",
        controls=(Slider.degrees(db_turn, -176, 176, start=90, step=2),),
        where=(*given.items(), *assign(frames.object_seen)),
        shapes=(
            things.platform(here),
            parcel(OBJECT),
            Line("ghost", (PLATFORM, beside, OBJECT)),
            Label("text", ((PLATFORM[0] + 3 * OBJECT[0]) / 4, PLATFORM[1] - 0.07), "x_de − x_db"),
            Label("text", (OBJECT[0] + 0.2, (PLATFORM[1] + OBJECT[1]) / 2), "y_de − y_db"),
            Line("x_axis", (PLATFORM, corner)),
            Line("y_axis", (corner, OBJECT)),
            *when(Abs(be[0]) > 0.15, Label("x_axis", point_of(here, be[0] / 2), "x_be")),
            *when(Abs(be[1]) > 0.15, Label("y_axis", point_of(here, be[0], be[1] / 2), "y_be")),
            Arrow("x_axis", PLATFORM, point_of(here, 0.32), ""),
            AngleArc(db_turn, PLATFORM, 0, db_turn, 0.13),
        ),
        handles=(nose(here),),
        readouts=(Readout(be[0]), Readout(be[1])),
        goal=Goal(
            And(Abs(be[1]) < 0.02, be[0] > 0),
            "Turn the platform until the object is straight ahead: within 2 cm.",
        ),
    )


# The camera looks down, in the plane and in space.

LETTER = ((-0.2, -0.3), (-0.2, 0.3), (0.08, 0.3), (0.17, 0.25), (0.2, 0.16), (0.17, 0.07),
          (0.08, 0.02), (-0.2, 0.02), (-0.02, 0.02), (0.2, -0.3))  # fmt: skip


def papers_figure() -> Figure:
    """Draw a letter on the floor, in the camera's picture, and its numbers with y up."""
    c, z = cos(camera_turn), sin(camera_turn)
    numbers = [(c * x + z * y, z * x - c * y) for x, y in LETTER]  # along x and y of the camera
    sheet = Outline(box(1.12, 1.12, corner=0.01), "paper", "edge")
    papers = (
        (-1.15, "floor", LETTER, (c, z), (z, -c)),
        (0, "y down", [(x, -y) for x, y in numbers], (1, 0), (0, -1)),
        (1.15, "y up", numbers, (1, 0), (0, 1)),
    )
    tip = (papers[0][0] + 0.27 * c, 0.27 * z)
    return Figure(
        name="three-papers",
        title="Three papers: the floor with a letter R, the camera's picture, its numbers plotted",
        view=(-1.75, 1.75, -0.6, 0.82),
        ground="wall",
        controls=(
            Slider.degrees(camera_turn, -90, 90, start=20, step=5, label="camera turned by"),
        ),
        shapes=tuple(
            shape
            for x, words, letter, along, aside in papers
            for shape in (
                Sprite((x, 0, 0), (sheet,), silhouette=""),
                Line("path", tuple((x + u, v) for u, v in letter)),
                Arrow("x_axis", (x, 0), (x + 0.27 * along[0], 0.27 * along[1]), "x_f"),
                Arrow("y_axis", (x, 0), (x + 0.27 * aside[0], 0.27 * aside[1]), "y_f"),
                Label("text", (x, 0.66), words),
            )
        ),
        handles=(
            Handle(
                "tip of the camera's x axis",
                tip,
                {camera_turn: atan2(POINTER[1], POINTER[0] - papers[0][0])},
            ),
        ),
    )


# In space the room's origin is below the camera, at the height of the arm.

BASE, THING = (-0.2, -0.3), (0.3, 0.3)  # m: platform and object, 0.2 m lower than the arm
HIGH, LOW, FLOOR = 1.2, -0.2, -0.3  # m: of the camera, the object, the floor
DOWN = Matrix([[1, 0, 0], [0, -1, 0], [0, 0, -1]])


def about_x(angle: Any) -> Matrix:
    """Return a turn about x."""
    return Matrix([[1, 0, 0], [0, cos(angle), -sin(angle)], [0, sin(angle), cos(angle)]])


def about_y(angle: Any) -> Matrix:
    """Return a turn about y."""
    return Matrix([[cos(angle), 0, sin(angle)], [0, 1, 0], [-sin(angle), 0, cos(angle)]])


def about_z(angle: Any) -> Matrix:
    """Return a turn about z."""
    return Matrix([[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]])


WHEEL = replace(meshes.cylinder("dark", (0.06, 0.06), (-0.02, 0.02), "y", 12), edge="rim")


def platform_in_space(hand_turns: Sequence[Any]) -> tuple[Any, ...]:
    """Return the platform with its arm, whose links have these directions, and the arm's joints."""
    low = FLOOR + 0.1
    body = replace(meshes.box("shell", (0.4, 0.26, 0.1), (0, 0, 0)), edge="edge")
    wheels = [
        (VIEW.solid((WHEEL,), about_z(hand_turns[3]), (BASE[0] - y, BASE[1] + x, FLOOR + 0.06)))
        for x in (-0.13, 0.13)
        for y in (-0.15, 0.15)
    ]
    places, parts = [Matrix([*BASE, 0])], []
    for turn, long in zip(hand_turns, LINKS.values(), strict=False):
        parts.append(VIEW.solid(space.link(long, 0.045, 0.04), about_z(turn), tuple(places[-1])))
        places.append(places[-1] + about_z(turn) * Matrix([long, 0, 0]))
    hand = about_z(hand_turns[2])
    grip = (*space.link(0.1, 0.036, 0.03, pale=True), *space.gripper(0.1, 0.03))
    return (
        *wheels,
        VIEW.solid((body,), about_z(hand_turns[3]), (*BASE, low + 0.02), floor=FLOOR),
        VIEW.solid(space.column(0.13, 0.06), eye(3), (*BASE, low + 0.05)),
        *parts,
        VIEW.solid(grip, hand, tuple(places[-1])),
    )


def flying_figure() -> Figure:
    """Draw a camera that looks down, to turn and tilt; what the hand sees does not change."""
    steps = NamedSteps()
    R = steps.add("r", about_z(camera_turn) * DOWN * about_x(camera_tilt))
    heading = PLATFORM[2]
    at, base, thing = (0, 0, HIGH), Matrix([*BASE, 0]), Matrix([*THING, LOW])
    p_fb = steps.add("fb", R.T * (base - Matrix(at)))
    p_fe = steps.add("fe", R.T * (thing - Matrix(at)))
    R_fb = R.T * about_z(heading)
    through_camera = R_fb.T * (p_fe - p_fb)  # both seen: the camera drops out
    through_room = about_z(-heading) * (DOWN * p_fe + Matrix(at) - base)  # as it was hung up
    p_be = steps.add("be", hidden * through_room + (1 - hidden) * through_camera)
    told = steps.add("told", about_z(heading) * p_be + base)
    ce = seen_from(HAND, (p_be[0], p_be[1], 0))
    off = sqrt(sum((a - b) ** 2 for a, b in zip(told, thing, strict=True)))
    turns = (heading + BENDS[0], heading + BENDS[0] + BENDS[1], heading + HAND[2], heading)
    hand = tuple(base + about_z(heading) * Matrix([*HAND[:2], 0]))
    corners = [
        tuple(Matrix(at) + R * Matrix([x, y, HIGH - FLOOR]))
        for x, y in ((-0.5, -0.45), (0.5, -0.45), (0.5, 0.45), (-0.5, 0.45))
    ]
    letter = [(0.6 * x - 0.4, 0.6 * y + 0.35, FLOOR) for x, y in LETTER]
    cloth = meshes.box("accent", (0.42, 0.5, 0.012))
    missed_box = tuple(replace(m, kind="error", edge="error") for m in space.parcel((*BOX, 0.1)))
    shown = [Piecewise((x, hidden > 0), (nan, True)) for x in (*BASE, 0.12)]
    wrong = [Piecewise((x, hidden > 0), (nan, True)) for x in told]
    return Figure(
        name="camera-above",
        title="In space: a camera f that looks down on a platform b, its hand c and an object e",
        view=(-0.95, 0.95, -0.57, 1.29),
        ground="wall",
        size="laboratory",
        controls=(
            Slider.degrees(camera_turn, -180, 180, step=5, label="camera turned by"),
            Slider.degrees(camera_tilt, -8, 8, step=0.5, label="camera tilted by"),
            Choice("cloth", "cloth over the platform", (hidden,), {"away": (0,), "spread": (1,)}),
        ),
        where=steps,
        shapes=(
            space.floor(FLOOR, 0.85),
            VIEW.line("path", letter),
            *(VIEW.line("ghost", (at, corner)) for corner in corners),
            VIEW.line("ghost", (*corners, corners[0])),
            *platform_in_space(turns),
            VIEW.solid(space.parcel((*BOX, 0.1)), about_z(OBJECT[2]), tuple(thing), floor=FLOOR),
            VIEW.solid(missed_box, about_z(OBJECT[2]), wrong, opacity=0.6),
            VIEW.line("error", (tuple(thing), wrong)),
            VIEW.solid((cloth,), eye(3), shown, opacity=0.45),
            VIEW.solid(space.camera(1.3), R, at),
            VIEW.arrow("path", at, tuple(thing)),
            *when(hidden < 1, VIEW.arrow("path", at, tuple(base))),
            VIEW.arrow("icr", hand, tuple(told)),
            *VIEW.frame(R, at, 0.3, ("x_f", "y_f", "z_f")),
            *VIEW.frame(about_z(heading + HAND[2]), hand, 0.24, ("x_c", "y_c", "z_c")),
        ),
        readouts=(
            Readout("x_e", "from camera f, x_fe", p_fe[0], "m"),
            Readout("y_e", "from camera f, y_fe", p_fe[1], "m"),
            Readout("z_e", "from camera f, z_fe", p_fe[2], "m"),
            Readout("x", "from hand c, x_ce", ce[0], "m"),
            Readout("y", "from hand c, y_ce", ce[1], "m"),
            Readout("z", "from hand c, z_ce", p_be[2], "m"),
            Readout("off", "off the object", off, "m"),
        ),
        sentence=(
            "The camera sees the object at x = {x_e}, y = {y_e}, z = {z_e}; "
            "the hand takes it to be at x = {x}, y = {y}, z = {z}: {off} off."
        ),
        seen_from=(-pi / 3, 5 * pi / 36),
    )


# Where it fails.

LONG, SHORT = 1.432, 0.424  # m: the object's distance from the tilt's axis, and from the view's


def miss_figure() -> Figure:
    """Draw a camera that is tilted by an error, from the side, and by how much it misses."""
    at, thing = (0, 1.4), (0.3, 0)
    start = atan2(thing[1] - at[1], thing[0])
    told = (at[0] + LONG * cos(start + error), at[1] + LONG * sin(start + error))
    graph = LinearGraph((1.05, 1.95, 0.3, 1.2), (0, 4), (0, 100))

    def line_of(far: float) -> Any:
        return graph.place((s, 1000 * frames.miss.right.subs({lever: far, error: s * DEGREE})))

    now = graph.place((Abs(error) / DEGREE, 1000 * missed))
    return Figure(
        name="loop-miss",
        title="A tilted camera from the side, an object, where it seems to be; the miss as a graph",
        view=(-0.75, 2.15, -0.25, 1.55),
        ground="wall",
        controls=(Slider.degrees(error, -4, 4, start=2, step=0.5, label="error of the tilt δ"),),
        where=((lever, LONG), *assign(frames.miss)),
        shapes=(
            things.bench(-0.7, 0.9, -0.035, -0.25),
            things.ceiling_camera((*at, 0), error, 2),
            Line("ghost", (at, thing)),
            Line("approximation", (at, told)),
            AngleArc(error, at, start, start + error, 0.7),
            Length(lever, at, thing, aside=0.28),
            things.parcel((*thing, 0), 0.17, 0.07),
            things.parcel((*told, 0), 0.17, 0.07, "wrong"),
            Line("error", (thing, told)),
            Label("error", ((thing[0] + told[0]) / 2, 0.1), "{missed}"),
            Label("text", (-0.35, 1.3), "here 0 mm"),
            *graph.shapes(
                "error in degrees",
                "miss in mm",
                {2: "2", 4: "4"},
                {50: "50", 100: "100"},
            ),
            Curve("path", line_of(LONG), s, 0, 4),
            Curve("ghost", line_of(SHORT), s, 0, 4),
            Label("text", graph.place((2.9, 88)), "tilted"),
            Label("text", graph.place((3.2, 38)), "turned"),
            Point("error", now),
        ),
        readouts=(Readout("missed", "miss Δ", missed, "mm", 0),),
    )


NODES = {
    "d": (1.0, 1.15),
    "b": (0.5, 0.5),
    "c": (-0.05, 1.0),
    "e": (1.35, 0.4),
    "r": (1.75, 1.1),
    "g": (2.25, 0.5),
}
LETTERED = {"b": -0.28, "c": -0.1, "g": 0.27}  # m: so far beside a node, which is large, its letter
EDGES = ("db", "bc", "de", "rd", "rg")


def beyond(edge: str) -> list[int]:
    """Return the numbers of the frames behind an edge, on the side of its second letter."""
    found, rest = {edge[1]}, [set(other) for other in EDGES if other != edge]
    while fresh := [pair for pair in rest if len(pair & found) == 1]:
        for pair in fresh:
            found |= pair
    return [k for k, name in enumerate(NODES) if name in found]


def graph_figure() -> Figure:
    """Draw the frames and the known poses between them; the way that is found lights up."""
    shapes: list[Any] = []
    steps, turned = [], []
    for edge in EDGES:
        ends = [NODES[name] for name in edge]
        tail, head = (
            tuple(a + share * (b - a) for a, b in zip(*ends, strict=True)) for share in (0.2, 0.8)
        )
        behind = beyond(edge)
        is_start, is_end = (
            Or(*(Abs(symbol - k) < 0.5 for k in behind)) for symbol in (start_frame, end_frame)
        )
        ahead, back = And(is_end, ~is_start), And(is_start, ~is_end)
        middle = tuple((a + b) / 2 for a, b in zip(tail, head, strict=True))
        shapes += [
            Arrow("length", tail, head, ""),
            *when(ahead, Arrow("velocity", tail, head, ""), Label("velocity", middle, f"T_{edge}")),
            *when(
                back,
                Arrow("turning", head, tail, ""),
                Label("turning", middle, f"T_{edge}⁻¹"),
            ),
        ]
        steps.append(Piecewise((1, Or(ahead, back)), (0, True)))
        turned.append(Piecewise((1, back), (0, True)))
    things_there = (
        things.camera_above((*NODES["d"], -pi / 2)),
        things.platform((*NODES["b"], pi / 2)),
        things.arm((*NODES["c"], pi / 4), (0,), (0.25,), base=""),
        parcel((*NODES["e"], 3 * pi / 4)),
        *axes((*NODES["r"], 0), "", 0.16),
        things.vacuum((*NODES["g"], pi / 2)),
    )
    names = {name: (k,) for k, name in enumerate(NODES)}
    return Figure(
        name="frame-graph",
        title="Six frames as a graph: an arrow for each known pose, the way between two lit up",
        view=(-0.4, 2.6, 0.1, 1.5),
        ground="wall",
        controls=(
            Choice("seen_from", "seen from", (start_frame,), names, start="c"),
            Choice("sought", "sought", (end_frame,), names, start="e"),
        ),
        shapes=(
            *things_there,
            *shapes,
            *(
                Label("text", (x + LETTERED.get(name, 0.16), y + 0.1), name)
                for name, (x, y) in NODES.items()
            ),
        ),
        readouts=(
            Readout("count", "poses on the way", sum(steps), "", digits=0),
            Readout("turned", "of them inverted", sum(turned), "", digits=0),
        ),
    )


# The laboratory.


def joint_sliders() -> tuple[Slider, ...]:
    """Return the sliders of the arm; at 180° an angle would meet its other name, −180°."""
    return (
        Slider.degrees(alpha, -175, 175, start=90, step=5, label="joint angle α"),
        Slider.degrees(beta, -120, 120, start=-90, step=5, label="joint angle β"),
        Slider.degrees(gamma, -120, 120, start=-45, step=5, label="joint angle γ"),
    )


def chain_figure() -> Figure:
    """Draw both views with all that moves: platform, arm and object to drag."""
    steps = NamedSteps()
    bends = (alpha, beta, gamma)
    arm = arm_on(steps, T_db, bends)
    ce = steps.add("ce", seen_from(arm.hand, T_de))
    closed = Piecewise((0.5, is_gripped(ce)), (1, True))
    seen = point_of(MIDDLE, *ce[:2])
    inside = (OTHER[0] < seen[0], seen[0] < OTHER[1], OTHER[2] < seen[1], seen[1] < OTHER[3])
    second = T_db[2] + alpha + beta
    alike = And(
        distance(T_de, arm.from_platform) < 0.03,
        turned_apart(de_turn - arm.from_platform[2]) < 5 * DEGREE,
    )
    return Figure(
        name="room-plan",
        title="A room as a camera sees it, and as a hand sees it: platform, arm, object to drag",
        view=BOTH,
        ground="wall",
        size="laboratory",
        controls=(
            Slider(db_x, 0.3, 1.4, start=1.0, step=0.02, label="platform x_db"),
            Slider(db_y, 0.2, 1.3, start=0.5, step=0.02, label="platform y_db"),
            Slider.degrees(db_turn, -175, 175, start=90, step=5, label="platform θ_db"),
            *joint_sliders(),
            Slider(de_x, 0.0, 1.56, start=1.5, step=0.02, label="object x_de"),
            Slider(de_y, 0.0, 1.56, start=1.1, step=0.02, label="object y_de"),
            Slider.degrees(de_turn, -175, 175, start=135, step=5, label="object θ_de"),
        ),
        where=(*steps, *LINKS.items(), *zip(T_bc, arm.from_platform, strict=True)),
        shapes=(
            *two_views(arm.hand, robot(T_db, bends, closed), parcel(T_de)),
            GRIPPED,
            Arrow("icr", arm.hand, T_de, ""),
            *when(And(*inside), Arrow("icr", MIDDLE, seen, "")),
        ),
        handles=(
            nose(T_db, 0.2),
            Handle("platform", T_db),
            Handle("second joint", arm.elbow[:2], {alpha: angle_to_pointer(T_db)}),
            tip_of_hand(arm.hand, second),
            Handle("hand", arm.hand[:2], {beta: angle_to_pointer(arm.elbow)}),
            Handle("object", (de_x, de_y - 0.14), {de_x: POINTER[0], de_y: POINTER[1] + 0.14}),
        ),
        readouts=(
            Readout("x", "from hand c, x_ce", ce[0], "m"),
            Readout("y", "from hand c, y_ce", ce[1], "m"),
            Readout("turn", "from hand c, θ_ce", motion.wrap(ce[2]), "rad"),
            Readout("hand_x", "from platform b, x_bc", arm.from_platform[0], "m"),
            Readout("hand_y", "from platform b, y_bc", arm.from_platform[1], "m"),
            Readout("hand_turn", "from platform b, θ_bc", motion.wrap(arm.from_platform[2]), "rad"),
        ),
        sentence=(
            "The hand sees the object at x = {x}, y = {y}, turned by {turn}. "
            "The platform sees its hand at x = {hand_x}, y = {hand_y}, turned by {hand_turn}."
        ),
        goal=(
            Goal(is_gripped(ce), "Grip the box: within 5 cm along, 3 cm across, 15°."),
            Goal(
                And(Abs(ce[0] - 0.3) < 0.02, Abs(ce[1]) < 0.02),
                "Let the hand see the box 0.3 m straight ahead: within 2 cm each way.",
            ),
            Goal(
                alike,
                "Put the box where the camera sees it as the platform sees the hand: "
                "within 3 cm and 5°.",
            ),
        ),
    )


HUNG = (1.5 * DEGREE, -1.0 * DEGREE, 3.0 * DEGREE)  # how the camera really hangs askew
SEEN_OBJECTS = ((0.35, 0.3), (-0.45, 0.2), (0.1, -0.4))  # m: where they are, below the camera


def mounting(turns: Sequence[Any]) -> Matrix:
    """Return how a camera hangs that is tilted about its x and y axis and turned about its view."""
    return DOWN * about_x(turns[0]) * about_y(turns[1]) * about_z(turns[2])


def loops_figure() -> Figure:
    """Draw objects where a hand finds them and where an askew camera does: close the loops."""
    steps, hung = NamedSteps(), mounting(HUNG)
    guess = steps.add("m", mounting((camera_tilt, tilt_y, camera_turn)))
    shapes, gaps, places = [], [], []
    for k, (x, y) in enumerate(SEEN_OBJECTS, 1):
        there = Matrix([x, y, -1.4])
        seen = (hung.T * there).evalf(17)
        told = steps.add("told" + "abc"[k - 1], guess * seen)
        places.append(told[:2])
        gaps.append(sqrt(sum((a - b) ** 2 for a, b in zip(told, there, strict=True))))
        shapes += [
            parcel((x, y, 0.3 * k)),
            parcel((told[0], told[1], 0.3 * k), "wrong"),
            Line("error", ((x, y), (told[0], told[1]))),
            Label("text", (x, y + 0.11), str(k)),
        ]
    return Figure(
        name="close-loops",
        title="Three objects from above: where the hand finds them, and where the camera does",
        view=(-0.75, 0.75, -0.58, 0.5),
        ground="tiles",
        size="laboratory",
        controls=(
            Slider.degrees(camera_tilt, -4, 4, step=0.1, label="tilt about x_f"),
            Slider.degrees(tilt_y, -4, 4, step=0.1, label="tilt about y_f"),
            Slider.degrees(camera_turn, -6, 6, step=0.2, label="turn about z_f"),
        ),
        where=steps,
        shapes=(
            things.camera_above((0, 0, -pi / 2)),
            Line("path", ((0, 0), SEEN_OBJECTS[0])),
            Line("approximation", ((0, 0), places[0])),
            Arrow("x_axis", (0, 0), tuple(0.2 * guess[:2, 0]), "x_f"),
            Arrow("y_axis", (0, 0), tuple(0.2 * guess[:2, 1]), "y_f"),
            *shapes,
        ),
        readouts=tuple(
            Readout(f"gap_{k}", f"gap of loop {k}", gap, "mm", 1) for k, gap in enumerate(gaps, 1)
        ),
        goal=(
            Goal(gaps[0] < 0.004, "Close the first loop: a gap below 4 mm."),
            Goal(
                And(gaps[0] < 0.004, gaps[1] < 0.004),
                "Close the first two loops. The third one must close by itself.",
            ),
        ),
    )


# Find the mistake.

MISTAKES = symbols("mistake:4", real=True)  # 1 for the one that is made, else 0


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


def mistakes_figure() -> Figure:
    """Draw the room from above, and where a program with a mistake believes the object to be."""
    steps = NamedSteps()
    db, de, bends = (0.6, 0.5, db_turn), (-0.3, 0.6, -pi / 3), (-pi / 2, 7 * pi / 12, pi / 4)
    arm = {**LINKS, **dict(zip((alpha, beta, gamma), bends, strict=True))}
    hand = [float(number) for number in frames.hand_pose.substitute(arm)]
    c = steps.add("c", compose(db, hand))
    ways = object_by_mistake(db, hand, de)
    T = sum((one * way for one, way in zip(MISTAKES, ways.values(), strict=True)), zeros(3))
    ce = steps.add("ce", Matrix([T[0, 2], T[1, 2], atan2(T[1, 0], T[0, 0])]))
    e = steps.add("e", compose(c, ce))
    return Figure(
        name="wrong-object",
        title="A platform with an arm, an object, and where a program with a mistake believes it",
        view=(-0.6, 1.7, -0.2, 1.45),
        ground="tiles",
        controls=(
            Choice.one_hot("mistake", MISTAKES, ways, start=no_inverse.title),
            Slider.degrees(db_turn, 60, 150, start=90, step=5, label="platform θ_db"),
        ),
        where=steps,
        shapes=(
            things.camera_above(CAMERA),
            robot(db, bends),
            Line("error", (de, e)),
            things.parcel(de),
            things.parcel(e, look="wrong"),
            *axes(CAMERA, "d"),
            *axes(c, "c"),
            *axes(de, "e", 0.2),
        ),
        readouts=(
            Readout("apart", "apart", distance(e, de), "m"),
            Readout("off", "turned off by", motion.wrap(e[2] - de[2]), "rad", digits=0),
        ),
    )


def letters_figure() -> Figure:
    """Draw both views at rest, with three poses whose letters are to be put back."""
    seen = [float(number) for number in seen_from(IN_ROOM, OBJECT)]
    at_object = point_of(MIDDLE, *seen[:2])
    places = (
        (0.5, 0.32),
        (0.75, 0.66),
        ((MIDDLE[0] + float(at_object[0])) / 2, (MIDDLE[1] + float(at_object[1])) / 2),
    )
    answers = dict(zip(("T_db", "T_bc", "T_ce"), places, strict=True))
    letters = put_back(quantity, ("T_bc", "T_bd", "T_ce", "T_db"), answers)
    return Figure(
        name="letters-frames",
        title="One room as the camera and as the hand sees it, with three arrows between frames",
        view=BOTH,
        ground="wall",
        controls=letters.controls,
        shapes=(
            *two_views(IN_ROOM, parcel(OBJECT), robot(PLATFORM, BENDS)),
            *axes(CAMERA, "d"),
            Arrow("path", CAMERA, PLATFORM, ""),
            Arrow("path", PLATFORM, IN_ROOM, ""),
            Arrow("icr", MIDDLE, at_object, ""),
            *letters.shapes,
        ),
        goal=letters.goal,
    )


FIGURES = (
    views_figure(),
    plan_figure(),
    tracing_figure(),
    pose_figure(),
    lamp_figure(),
    bends_figure(),
    order_figure(),
    pole_figure(),
    back_figure(),
    home_figure(),
    domino_figure(),
    difference_figure(),
    papers_figure(),
    flying_figure(),
    miss_figure(),
    graph_figure(),
    chain_figure(),
    loops_figure(),
    mistakes_figure(),
    letters_figure(),
)
