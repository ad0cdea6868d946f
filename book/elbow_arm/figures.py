"""The live figures of the chapter on the elbow arm: its four answers, from two sides and in space.

Both find the answers by the same named steps: the side view of the target, the triangle in half
angles, and from them the joint angles of the answer that the reader has chosen.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import pi
from typing import Any

from sympy import Matrix, Max, Min, Or, Piecewise, Symbol, atan2, cos, eye, nan, sin, sqrt, symbols
from sympy import pi as exact_pi

from book.basics.formulas import p_x, p_y
from book.elbow_arm import formulas as arm
from book.elbow_arm.exercises import base_arctan, base_only, cubed_a_3, no_p_x, swapped_xy
from book.elbow_arm.formulas import a2, a3, apart, d1, high, out, p_z, theta1, theta2, theta3
from book.motion import formulas as motion
from book.things import meshes, space
from courseware.equations import Where, substitute
from courseware.figures import (
    POINTER,
    VIEW,
    AngleArc,
    Arrow,
    Choice,
    Curve,
    Figure,
    Handle,
    Line,
    Point,
    Readout,
    Slider,
    bring_forward,
)
from courseware.figures.solids import Mesh
from robokin._triangle import TOLERANCE

UPPER, SHOULDER = 0.4, 0.1  # m: a2 and d1 of the exercise
SIDE = 1.3  # m, how far to the right of the view from above the view from the side stands
FRONT = 0.22  # m, the arrow that shows which way the base looks
NONE = {"nan": "none"}
GIVEN = {a2: UPPER, d1: SHOULDER}

s = Symbol("s")
face, bend = symbols("face bend", real=True)  # 1 facing, -1 away; 1 elbow up, -1 elbow down
# out and high, distance from the shoulder, least, most, the nearest that can be done
r, z, d, least, most, done = symbols("r z d least most done", real=True)
beta, rise, lift, elbow = symbols("beta rise lift elbow", real=True)
missed = Symbol("missed", real=True)

limits = substitute(arm.reach.right, GIVEN)
angles = arm.half_angles.substitute({**GIVEN, apart: done})
STEPS: Where = (
    (r, arm.side.right[0]),
    (z, substitute(arm.side.right[1], GIVEN)),
    (d, substitute(arm.side.right[2], {out: r, high: z})),
    (least, limits[0]),
    (most, limits[1]),
    (done, Max(least, Min(d, most))),
    (beta, atan2(p_y, p_x)),
    (rise, atan2(z, r)),
    (lift, angles[0]),
    (elbow, angles[1]),
    (missed, Max(0, d - most, least - d)),
)
OUTSIDE = Or(d > most * (1 + TOLERANCE), d < least - most * TOLERANCE)
raised = rise + bend * lift  # the upper link, from the side that faces the target
other = rise - bend * lift

ARMS = Choice(
    "arm",
    "answer",
    (face, bend),
    {
        "facing the target, elbow up": (1, 1),
        "facing the target, elbow down": (1, -1),
        "facing away, elbow up": (-1, 1),
        "facing away, elbow down": (-1, -1),
    },
)
AWAY = replace(ARMS, start="facing away, elbow down")


def target_sliders() -> tuple[Slider, ...]:
    """Return sliders for the target, set as in the exercise, and for the forearm."""
    return (
        Slider(p_x, -0.7, 0.7, start=-0.18, step=0.01, label="target p_x"),
        Slider(p_y, -0.6, 0.6, start=0.24, step=0.01, label="target p_y"),
        Slider(p_z, -0.5, 0.8, start=0.5, step=0.01, label="target p_z"),
        Slider(a3, 0.15, 0.4, start=0.3, step=0.01, label="forearm a_3"),
    )


def if_within_reach(value: Any) -> Any:
    """Return a value that exists only within reach."""
    return Piecewise((nan, OUTSIDE), (value, True))


def joint_readouts() -> tuple[Readout, ...]:
    """Return the chosen answer, and the target's distances from shoulder and from the reachable."""
    away = (1 - face) / 2 * exact_pi
    turn2 = Piecewise((0, d <= 0), (motion.wrap(away + face * raised), True))
    return (
        Readout("theta1", "base θ_1", if_within_reach(motion.wrap(beta + away)), "rad", words=NONE),
        Readout("theta2", "shoulder θ_2", if_within_reach(turn2), "rad", words=NONE),
        Readout("theta3", "elbow θ_3", if_within_reach(-face * bend * elbow), "rad", words=NONE),
        Readout("d", "from shoulder to target", d, "m"),
        Readout("missed", "out of reach by", missed, "m"),
    )


SAYS = (
    "The target at {p_x}, {p_y}, {p_z} is {d} from the shoulder, out of reach by {missed}. "
    "The arm, {arm}: base {theta1}, shoulder {theta2}, elbow {theta3}."
)


def bones(way: Any) -> tuple[tuple[Any, Any], ...]:
    """Return shoulder, elbow and wrist in the vertical plane, with the upper link raised so far."""
    joint = UPPER * cos(way), UPPER * sin(way)
    return (0, 0), joint, (done * cos(rise), done * sin(rise))


def from_above(at: tuple[Any, Any]) -> tuple[Any, Any]:
    """Return a point of the vertical plane in the view from above."""
    return at[0] * cos(beta), at[0] * sin(beta)


def from_the_side(at: tuple[Any, Any]) -> tuple[Any, Any]:
    """Return a point of the vertical plane in the view from the side."""
    return SIDE + at[0], at[1]


def arms(show: Callable[[tuple[Any, Any]], Any]) -> tuple[Line | Point, ...]:
    """Return the arm with its elbow at both places, the chosen one drawn out, in one view."""
    shoulder, joint, wrist = map(show, bones(raised))
    return (
        Line("ghost", tuple(map(show, bones(other)))),
        Line("approximation", (show((r, z)), wrist)),
        Line("path", (shoulder, joint, wrist)),
        Point("body", shoulder),
        Point("body", joint),
        Point("approximation", wrist),
    )


def ring(centre: Sequence[Any], radius: Any, low: float = 0, high: float = 2 * pi) -> Curve:
    """Return a limit of the reach."""
    at = centre[0] + radius * cos(s), centre[1] + radius * sin(s)
    return Curve("icr", at, s, low, high, samples=64)


def two_views_figure() -> Figure:
    """Draw the target under the hand, from above and from the side, with all answers."""
    cuts = [sqrt(Max(0, limit**2 - z**2)) for limit in (least, most)]  # at the target's height
    back = (1 - face) / 2 * exact_pi
    mid = from_the_side((0, 0))
    floor = -SHOULDER
    return Figure(
        name="four-arms",
        title="A three-joint arm and its target: left from above, right from the side",
        view=(-0.78, 2.3, -0.77, 0.85),
        size="laboratory",
        controls=(*target_sliders(), ARMS),
        shapes=(
            *(ring((0, 0), cut) for cut in cuts),
            *(ring(mid, limit, -pi / 2, pi / 2) for limit in (least, most)),
            Arrow("text", (0, 0), (0.58, 0), label="x"),
            Arrow("text", (0, 0), (0, 0.52), label="y"),
            Arrow("text", (SIDE, floor), (SIDE + 0.72, floor), label="r"),
            Arrow("text", (SIDE, floor), (SIDE, 0.54), label="z"),
            Arrow("velocity", (0, 0), from_above((FRONT * face, 0))),
            Arrow("velocity", (SIDE, floor), (SIDE + FRONT * face, floor)),
            AngleArc("left", (0, 0), 0, motion.wrap(beta + back), 0.12, label="θ_1"),
            AngleArc("left", mid, back, raised, 0.15, label="θ_2"),
            AngleArc(
                "left", from_the_side(bones(raised)[1]), raised, raised - bend * elbow, 0.1, "θ_3"
            ),
            *arms(from_above),
            *arms(from_the_side),
            Point("target", (p_x, p_y), label="p"),
            Point("target", from_the_side((r, z)), label="p"),
        ),
        handles=(
            Handle("target, from above", (p_x, p_y)),
            Handle("height of the target", (SIDE + r, z), {p_z: POINTER[1] + SHOULDER}),
        ),
        readouts=joint_readouts(),
        sentence=SAYS,
        where=STEPS,
        grid=False,
    )


def in_space(at: tuple[Any, Any]) -> tuple[Any, Any, Any]:
    """Return a point of the vertical plane, in space."""
    return at[0] * cos(beta), at[0] * sin(beta), SHOULDER + at[1]


def hinge(at: Sequence[Any], label: str) -> Arrow:
    """Return the axis of a joint of the vertical plane: to the right of the base's front."""
    axis = face * sin(beta), -face * cos(beta), 0
    tip = [a + 0.25 * b for a, b in zip(at, axis, strict=True)]
    return VIEW.arrow("z_axis", at, tip, label)


def space_figure() -> Figure:
    """Draw the arm in space, from any side."""
    foot, shade, target = (0, 0, 0), (p_x, p_y, 0), (p_x, p_y, p_z)
    shoulder, joint, wrist = map(in_space, bones(raised))
    front = FRONT * face * cos(beta), FRONT * face * sin(beta), 0
    return Figure(
        name="arm-in-space",
        title="The three-joint arm in space, with its target and the axes of its joints",
        view=(-1.0, 1.0, -0.67, 0.85),
        size="",
        controls=(*target_sliders(), AWAY),
        shapes=(
            *(ring(VIEW.project(shoulder), limit) for limit in (least, most)),
            *VIEW.frame(eye(3), size=0.3, labels=("x", "y", "z")),
            bring_forward(VIEW.line("ghost", (foot, shade)), -0.3),
            bring_forward(VIEW.line("ghost", (shade, target)), -0.3),
            VIEW.line("body", (foot, shoulder)),
            VIEW.arrow("velocity", foot, front),
            *(
                bring_forward(VIEW.line("ghost", pair), -0.3)
                for pair in pieces(map(in_space, bones(other)))
            ),
            *(VIEW.line("path", pair) for pair in pieces((shoulder, joint, wrist))),
            hinge(shoulder, "z_1"),
            hinge(joint, "z_2"),
            VIEW.line("approximation", (target, wrist)),
            bring_forward(VIEW.point("body", shoulder), 0.1),
            bring_forward(VIEW.point("body", joint), 0.1),
            bring_forward(VIEW.point("approximation", wrist), 0.1),
            bring_forward(VIEW.point("target", target, label="p"), 0.1),
        ),
        readouts=joint_readouts(),
        sentence=SAYS,
        where=STEPS,
        seen_from=(-2 * pi / 3, pi / 8),
    )


def pieces(points: Any) -> list[tuple[Any, Any]]:
    """Return a chain piece by piece: each has its own depth."""
    return list(pairwise(points))


MISTAKES = symbols("mistake:5", real=True)  # 1 for the one that is made, else 0
JOINTS = (theta1, theta2, theta3)
ARM = {a2: 0.3, a3: 0.4, d1: 0.3}  # m, of the mistakes
PLACE = {p_y: 0.2, p_z: 0.5}  # m, of the target


def joint_angles_by(base: Any, cosine: Any, elevation: Any) -> Matrix:
    """Return the three joint angles, elbow up, from three numbers that may be wrong."""
    turn = arm.elbow.right[1].xreplace({arm.A: cosine})
    there = ARM[a2] + ARM[a3] * cos(turn), ARM[a3] * sin(turn)
    return Matrix([base, elevation - atan2(there[1], there[0]), turn])


def joint_angles() -> tuple[Matrix, dict[str, Matrix]]:
    """Return the right joint angles, and those by each mistake."""
    level = PLACE[p_z] - ARM[d1]
    given = {**ARM, **PLACE, high: level}
    base, cosine = arm.base.substitute(given)[0], arm.cosine.substitute(given)
    elevation = atan2(level, arm.side.substitute(given)[0])
    right = joint_angles_by(base, cosine, elevation)
    short, steep = no_p_x.substitute({p_y: PLACE[p_y], p_z: level})
    return right, {
        swapped_xy.title: joint_angles_by(swapped_xy.substitute(given), cosine, elevation),
        base_arctan.title: joint_angles_by(base_arctan.substitute(given), cosine, elevation),
        no_p_x.title: joint_angles_by(
            base, arm.cosine.substitute({**ARM, p_x: short, p_y: 0, high: 0}), steep
        ),
        cubed_a_3.title: joint_angles_by(base, cubed_a_3.substitute(given), elevation),
        base_only.title: base_only.substitute(dict(zip(JOINTS, right, strict=True))),
    }


def link(kind: str, length: float, thick: float) -> list[Mesh]:
    """Return a link along its x axis, with its joint."""
    bar = meshes.box(kind, (length, thick, thick), (length / 2, 0, 0))
    return [bar, meshes.cylinder(kind, (0.05, 0.05), (-0.05, 0.05), n=12)]


def solid_arm(kind: str, joints: Any) -> tuple[Any, ...]:
    """Return two links with a gripper, in space, on a column that shows the base's direction."""
    one, two, three = joints
    R, T = (
        arm.dh_wrist.right.xreplace({theta1: one, theta2: way, theta3: 0}).doit()[:3, :3]
        for way in (two, two + three)
    )
    shoulder = (0, 0, ARM[d1])
    elbow = [at + ARM[a2] * R[k, 0] for k, at in enumerate(shoulder)]
    wrist = [at + ARM[a3] * T[k, 0] for k, at in enumerate(elbow)]
    hand = [meshes.box(kind, (0.08, 0.05, 0.015), (ARM[a3], 0, z)) for z in (-0.03, 0.03)]
    front = (FRONT * cos(one), FRONT * sin(one), 0)
    return (
        VIEW.solid(link(kind, ARM[a2], 0.06), R, shoulder, floor=0),
        VIEW.solid([*link(kind, ARM[a3] - 0.04, 0.045), *hand], T, elbow, floor=0),
        VIEW.arrow(kind, (0, 0, 0), front),
    ), wrist


def mistakes_figure() -> Figure:
    """Draw the arm at its target, and in red where a mistake sends it."""
    right, ways = joint_angles()
    away = arm.away.substitute(dict(zip(JOINTS, right, strict=True)))
    true_arm = right + MISTAKES[4] * (away - right)  # where the red base turns round, it does too
    wrong = Matrix.hstack(*ways.values()) * Matrix(MISTAKES)
    here, there = symbols("right:3", real=True), symbols("wrong:3", real=True)
    (true, _), (false, missed) = solid_arm("body", here), solid_arm("error", there)
    target = (p_x, PLACE[p_y], PLACE[p_z])

    def far(first: Sequence[Any], second: Sequence[Any]) -> Any:
        return sqrt(sum((a - b) ** 2 for a, b in zip(first, second, strict=True)))

    return Figure(
        name="wrong-reach",
        title="An arm with its wrist at the target, and a red one that a mistake sends elsewhere",
        view=(-0.86, 0.86, -0.45, 0.84),
        controls=(
            Choice.one_hot("mistake", MISTAKES, ways, start=swapped_xy.title),
            Slider(p_x, -0.5, 0.5, start=-0.45, step=0.05, label="target p_x"),
        ),
        where=(*zip(here, true_arm, strict=True), *zip(there, wrong, strict=True)),
        shapes=(
            space.floor(0, 0.7),
            VIEW.solid([meshes.cylinder("body", (0.08, 0.05), (0, 0.27))], eye(3), floor=0),
            VIEW.arrow("text", (0, 0, 0), (0.7, 0, 0), "x"),
            VIEW.arrow("text", (0, 0, 0), (0, 0.7, 0), "y"),
            *true,
            *false,
            VIEW.line("error", (missed, target)),
            bring_forward(VIEW.point("target", target, "p"), 0.1),
        ),
        readouts=(
            Readout("d", "shoulder to p", far(target, (0, 0, ARM[d1])), "m"),
            Readout("reach", "shoulder to wrist", far(missed, (0, 0, ARM[d1])), "m"),
            Readout("off", "off by", far(missed, target), "m"),
        ),
        seen_from=(-5 * pi / 9, pi / 7),
    )


FIGURES = (two_views_figure(), space_figure(), mistakes_figure())
