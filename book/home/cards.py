"""Still pictures on the cards of chapters: what each is about, drawn with the course's things.

They are small: no letters, no scale, nothing to move. All places are computed by the formulas of
their chapters.
"""

from collections.abc import Mapping, Sequence
from math import atan2, dist, pi, radians
from typing import Any

from sympy import Symbol, cos, sin

from book import things
from book.bicycle import formulas as bicycle
from book.differential_drive.formulas import b
from book.elbow_arm import formulas as elbow
from book.frames import formulas as frames
from book.frames.figures import point_of
from book.motion.formulas import omega, theta, v, v_y, x, y
from book.odometry import formulas as odometry
from book.planar_arm import formulas as planar
from book.things.outlines import box, disc, line, polygon
from book.wheels import formulas as wheels
from courseware.equations import Equation, substitute
from courseware.figures import Area, Arrow, Curve, Figure, Line, Outline, Point, Sprite

KINDS = ("left", "right", "turning")  # of three wheels or joints
HERE = (0, 0, 0)
s = Symbol("s")


def compute(equation: Equation, values: Mapping[Any, Any]) -> list[float]:
    """Return the right side of an equation in numbers."""
    known = dict(values)
    for name, step in equation.where:
        known[name] = float(substitute(step, known))
    return [float(each) for each in equation.substitute(known)]


def place(pose: Sequence[Any], forward: Any, left: Any = 0) -> tuple[float, float]:
    """Return a point of a frame in numbers."""
    ahead, up = point_of((*pose,), forward, left)
    return float(ahead), float(up)


def circle(kind: str, middle: Sequence[float], radius: float) -> Curve:
    """Return a circle."""
    at = (middle[0] + radius * cos(s), middle[1] + radius * sin(s))
    return Curve(kind, at, s, 0, 2 * pi, samples=48)


def spot(kind: str, middle: Sequence[float], radius: float, edge: str = "") -> Sprite:
    """Return a pale disc."""
    pale = Outline(disc(radius), kind, opacity=0.4 if edge else 0.12)
    return Sprite(
        (middle[0], middle[1], 0), (pale, *(Outline(disc(radius), "", edge),) * bool(edge))
    )


def spoke(
    kind: str, start: tuple[float, float], end: tuple[float, float], width: float
) -> tuple[Any, Any]:
    """Return a line with an edge of floor, so that it is seen on a robot, too."""
    edge = Sprite(HERE, (Outline(line(start, end), "", "floor", width),))
    return (edge, Line(kind, (start, end)))


def elbow_card() -> Figure:
    """Draw the two elbows where the circles of both links meet."""
    lengths, ball = (0.4, 0.3), (0.45, 0.255, 0)
    triangle = (elbow.a2, elbow.a3, elbow.out, elbow.high)
    angles = compute(elbow.first_way, dict(zip(triangle, (*lengths, *ball[:2]), strict=True)))
    return Figure(
        name="elbow-card",
        title="An arm grips a ball; its ghost does so with the other elbow where two circles meet",
        view=(-0.48, 0.88, -0.22, 0.58),
        ground="wall",
        shapes=(
            things.bench(-1, 2, -0.14, -0.3),
            *(spot(*each) for each in (("left", HERE, 0.4), ("right", ball, 0.3))),
            *(circle(*each) for each in (("left", HERE, 0.4), ("right", ball, 0.3))),
            things.arm(HERE, angles[2:], lengths, base="", look="ghost"),
            things.arm(HERE, angles[:2], lengths, base="stand", opening=0.3),
            things.ball(ball),
        ),
    )


def frames_card() -> Figure:
    """Draw the hand's grid as tracing paper over the room."""
    turns, links = (pi / 2, -pi / 2, pi / 8), (0.3, 0.4, 0.2)
    arm = dict(zip((frames.alpha, frames.beta, frames.gamma), turns, strict=True))
    wrist = compute(frames.hand_pose, {**arm, frames.l_1: links[0], frames.l_2: links[1]})
    hand = (*place(wrist, links[2]), wrist[2])
    return Figure(
        name="frames-card",
        title="A platform with an arm from above; a sheet with a grid is pinned to its hand",
        view=(-0.42, 1.44, -0.22, 0.87),
        ground="tiles",
        shapes=(
            things.shelf((-0.1, 0.86, 0), 0.6),
            things.parcel((*place(hand, 0.44, -0.13), 0.9)),
            things.tracing_paper(hand, (-0.32, 0.7, -0.42, 0.42)),
            things.platform(HERE, turns, links),
            Arrow("x_axis", hand, place(hand, 0.3)),
            Arrow("y_axis", hand, place(hand, 0, 0.3)),
        ),
    )


def bicycle_card() -> Figure:
    """Draw the circles on which the wheels of a car roll, and their spokes."""
    pose = (0, 0, pi / 2)
    given = {bicycle.wheelbase: 2.5, bicycle.track: 1.5, bicycle.steering: radians(27)}
    centre = compute(bicycle.icr, {**given, **dict(zip((x, y, theta), pose, strict=True))})
    hubs = [(kind, (k * 0.75, far)) for kind, k in (("left", -1), ("right", 1)) for far in (0, 2.5)]
    return Figure(
        name="bicycle-card",
        title="A car from above in a curve; its four wheels roll on circles about one point",
        view=(-5.85, 2.35, -1.2, 3.6),
        ground="asphalt",
        shapes=(
            *(circle(kind, centre, dist(centre, hub)) for kind, hub in hubs),
            *(Line(kind, (centre, hub)) for kind, hub in hubs if hub[1]),
            Line("icr", (centre, (0.75, 0))),
            things.car(pose, compute(bicycle.ackermann, given)),
            Point("icr", centre),
        ),
    )


def wheels_card() -> Figure:
    """Draw the lines along which three omni wheels roll, and their distances from the ICR."""
    pose, icr, far = (0, 0, pi / 2), (-0.03, -0.055), 0.18
    turning = {v: -icr[1], v_y: icr[0], omega: -1, wheels.l: far}  # so rolled: a distance
    lines, corners = [], []
    spokes: list[Any] = []
    for k, (kind, rolled) in enumerate(
        zip(KINDS, compute(wheels.omni_rolling, turning), strict=True)
    ):
        hub = (*place(pose, *place((0, 0, 2 * pi * k / 3), far)), pose[2] + 2 * pi * k / 3)
        centre = place(pose, *icr)
        lines.append(Line(kind, (place(hub, 0, 1), place(hub, 0, -1))))
        spokes += spoke(kind, centre, place((*centre, hub[2]), rolled), 0.014)
        spokes.append(Arrow(kind, hub, place(hub, 0, -0.6 * rolled)))
        corners.append(place(hub, -3 * far))
    return Figure(
        name="wheels-card",
        title="A robot on three omni wheels; the lines along which they roll are a triangle",
        view=(-0.42, 0.42, -0.25, 0.25),
        ground="tiles",
        shapes=(
            Area("icr", tuple(corners)),
            *lines,
            things.omni_robot(pose),
            *spokes,
            Point("icr", centre),
        ),
    )


TRACK, SLIP = 0.244, 0.1  # m, of the vacuum; what its right wheel counts too much
ARCS = ((0.9, 0.9), (0.9, -0.2), (1.1, -1.2))  # how far, and how much it turns


def start_arc(pose: Sequence[float], far: Any, turn: Any) -> dict[Any, Any]:
    """Return what an exact arc is computed from."""
    names = (x, y, theta, odometry.D, odometry.dtheta)
    return dict(zip(names, (*pose, far, turn), strict=True))


def drive(pose: Sequence[float], arcs: Any) -> list[Sequence[float]]:
    """Return the poses at the ends of arcs, the start too."""
    poses = [pose]
    for arc in arcs:
        poses.append(compute(odometry.exact_arc, start_arc(poses[-1], *arc)))
    return poses


def way(kind: str, pose: Sequence[float], arcs: Any, left: float = 0) -> list[Curve]:
    """Return the track of the middle of a robot, or of what is beside it."""
    pairs = zip(drive(pose, arcs), arcs, strict=False)
    paths = [
        odometry.exact_arc.substitute(start_arc(p, s * far, s * turn)) for p, (far, turn) in pairs
    ]
    return [Curve(kind, point_of(path, 0, left), s, 0, 1, samples=20) for path in paths]


def odometry_card() -> Figure:
    """Draw a slip as a door: all that follows turns about the other wheel."""
    slip = {odometry.D_L: 0, odometry.D_R: SLIP, b: TRACK}
    swing = [float(each.substitute(slip)) for each in (odometry.distance, odometry.turn)]
    start, slipped, *_, end = drive((0, 0, -0.1), ARCS)
    _, swung, *_, wrong = drive(slipped, (swing, *ARCS[1:]))
    hinge = place(slipped, 0, TRACK / 2)
    leaves = []
    for other in (end, wrong):
        far, angle = dist(hinge, other[:2]), atan2(other[1] - hinge[1], other[0] - hinge[0])
        leaf = Outline(box(far, 0.06, far / 2, 0, 0.02), "plank_lit", "wood_edge", opacity=0.8)
        leaves.append(Sprite((*hinge, angle), (leaf,)))
    return Figure(
        name="odometry-card",
        title="The way of a robot vacuum, and the way by its counters: it swings like a door",
        view=(-0.4, 3.1, -0.25, 1.8),
        ground="tiles",
        shapes=(
            *way("left", start, ARCS, TRACK / 2),
            *way("right", start, ARCS, -TRACK / 2),
            *leaves,
            *way("error", swung, ARCS[1:]),
            things.vacuum(start),
            things.vacuum(end),
            things.vacuum(wrong, look="wrong"),
            Point("icr", hinge),
        ),
    )


def planar_card() -> Figure:
    """Draw the rates of three joints as weights, and where they balance."""
    lengths, angles, rates = (0.5, 0.42, 0.25), [radians(a) for a in (50, -75, 40)], (0.5, 0.3, 0.6)
    names = (*planar.LENGTHS, *planar.ANGLES, *planar.RATES)
    given = dict(zip(names, (*lengths, *angles, *rates), strict=True))
    hand, (x_dot, y_dot, phi_dot) = compute(planar.forward, given), compute(planar.velocity, given)
    icr = (hand[0] - y_dot / phi_dot, hand[1] + x_dot / phi_dot)
    joint = place((0, 0, angles[0]), lengths[0])
    joints = ((0, 0), joint, place((*joint, angles[0] + angles[1]), lengths[1]))
    weights = list(zip(KINDS, joints, rates, strict=True))
    wedge = polygon(((0, -0.015), (-0.035, -0.08), (0.035, -0.08)))
    return Figure(
        name="planar-card",
        title="An arm from above with a weight on each joint; its hand turns about their balance",
        view=(-0.22, 1.16, -0.17, 0.64),
        ground="tiles",
        shapes=(
            Area("icr", joints),
            things.arm(HERE, angles, lengths),
            *(spot(kind, at, 0.15 * rate**0.5, kind) for kind, at, rate in weights),
            *(part for kind, at, _ in weights for part in spoke(kind, icr, at, 0.02)),
            *spoke("length", icr, (hand[0], hand[1]), 0.012),
            Arrow("velocity", hand, (hand[0] + 0.4 * x_dot, hand[1] + 0.4 * y_dot)),
            Sprite((*icr, 0), (Outline(wedge, "steel", "edge"),), 0.01),
            Point("icr", icr),
        ),
    )


CARDS = (
    elbow_card(),
    frames_card(),
    bicycle_card(),
    wheels_card(),
    odometry_card(),
    planar_card(),
)
POINTER = polygon(
    ((0, 0), (0, -17), (4, -13.5), (6.8, -19.5), (9.5, -18.3), (6.8, -12.4), (12, -12))
)
ROBOTS = (
    things.robot((0.08, 0.08, pi / 2)),
    things.pad((0.23, 0.08, 0)),
    things.robot((0.38, 0.08, pi / 3), look="wrong"),
)
ARROWS = (
    Arrow("right", (30, 8), (116, 8)),
    Arrow("left", (30, 8), (84, 36)),
    Sprite((84, 36, 0), (Outline(POINTER, "shell", "edge"),), 1.5),
)
WAVE = (6 + 120 * s, 23 + 15 * sin(2 * pi * s))
SAMPLES = tuple(Point("velocity", tuple(each.subs(s, k / 12) for each in WAVE)) for k in range(13))
PROOFS = (
    Figure(
        name="samples",
        title="A curve, and points on it",
        view=(0, 132, 0, 46),
        shapes=(Curve("path", WAVE, s, 0, 1), *SAMPLES),
        grid=False,
    ),
    Figure("robots", "A robot, a charger, a wrong robot", (0, 0.46, 0, 0.16), ROBOTS, grid=False),
    Figure("pointer", "A pointer at the tip of an arrow", (0, 132, 0, 46), ARROWS, grid=False),
)
