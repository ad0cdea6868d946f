"""Exercises on the three-joint elbow arm, and the mistakes that are made there."""

from collections.abc import Callable
from typing import Any

import numpy as np
from sympy import Matrix, atan, atan2, cos, pi, sin, sqrt

from book.basics.formulas import p_x, p_y
from book.elbow_arm import formulas
from book.elbow_arm.formulas import (
    a2,
    a3,
    apart,
    d1,
    dh_a,
    dh_d,
    dh_theta,
    high,
    out,
    p_z,
    theta1,
    theta2,
    theta3,
)
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
from robokin import elbow_arm, frames

with as_written():
    BASE_ANGLE = LocalEquation(theta1, atan2(p_y, p_x))
    level = sqrt(p_x**2 + p_y**2)
    FROM_SHOULDER = LocalEquation(
        Matrix([apart, formulas.phi3]), Matrix([sqrt(p_x**2 + p_y**2 + p_z**2), atan2(p_z, level)])
    )
    WITHOUT_X = Matrix([sqrt(p_y**2 + p_z**2), atan(p_z / p_y)])
    CUBED = formulas.cosine.right.xreplace({a3**2: a3**3})
    ALIKE = Matrix([theta1 + pi, theta2, theta3])
    ON_AXIS = LocalEquation(theta2, pi / 2 - atan2(a3 * sin(theta3), a2 + a3 * cos(theta3)))
    part = formulas.d_max / apart
    SHORTENED = LocalEquation(
        Matrix(formulas.NEAREST), Matrix([part * p_x, part * p_y, d1 + part * (p_z - d1)]), "m"
    )
    DH_ORIGIN = LocalEquation(
        Matrix([p_x, p_y, p_z]), Matrix([dh_a * cos(dh_theta), dh_a * sin(dh_theta), dh_d]), "m"
    )

swapped_xy = Mistake(
    "M1",
    feedback="with p_x and p_y exchanged in atan2",
    formula=WrongFormula(BASE_ANGLE, {p_x: p_y, p_y: p_x}),
    line="theta1 = np.arctan2(p_x, p_y)",
    why="NumPy's arctan2 takes y first, then x. Exchanged, the angle is measured from the y axis, "
    "and clockwise. In spreadsheets and in some books (Spong, Hutchinson and Vidyasagar) atan2 "
    "takes x first. There atan2(p_x, p_y) is right.",
    unnoticed="Where p_x = p_y, on the line in the middle between the two axes.",
    title="It aims at a mirror image",
    picture=(
        "The red arm reaches the mirror image of p, with x and y exchanged. Its program believes "
        "that it reaches p, like the orange one."
    ),
)
no_p_x = Mistake(
    "M2",
    feedback="when p_x is left out and the arm is taken to stand in the plane of y and z",
    formula=WrongFormula(FROM_SHOULDER, instead=WITHOUT_X),
    line="d = np.sqrt(p_y**2 + p_z**2)\ntheta3 = np.arccos((d**2 - a2**2 - a3**2) / (2 * a2 * a3))",
    why="The arm stands in the vertical plane through the target. In this plane the target is "
    "√(p_x² + p_y²) away from the base axis, not |p_y|.",
    unnoticed="Where p_x = 0 and p_y > 0: there the arm really stands in that plane, and looks "
    "along y. With p_y < 0 only d and θ_3 are right.",
    title="Its reach never changes",
    picture=(
        "Wherever p is along x, the red arm reaches equally far. Its program believes that it "
        "reaches p, like the orange one."
    ),
    document="000 Q1",
    place="step 2, the side view",
    nth=2,
    quote="r = √(p_y² + p_z²), φ_3 = arctan(p_z/p_y)",
    correction="r = √(«p_x² +» p_y² + p_z²), φ_3 = «atan2»(p_z, «√(p_x² + p_y²)»)",
    explanation="Here p is measured from the shoulder, and r is the way from there to the wrist: "
    "the chapter's d.",
)
cubed_a_3 = Mistake(
    "M3",
    feedback="with the third power of a_3 in cos θ_3, where its square belongs",
    formula=WrongFormula(formulas.cosine, instead=CUBED),
    line="A = (p_x**2 + p_y**2 + p_z**2 - a2**2 - a3**3) / (2 * a2 * a3)\ntheta3 = np.arccos(A)",
    why="The law of cosines has squares of lengths only. A cubic metre cannot be taken away from "
    "a square metre: the units show the mistake.",
    unnoticed="With a forearm of 1 m: there the square and the third power are the same number.",
    title="It reaches too far",
    picture=(
        "The red arm reaches beyond p. Its program believes it stops at p, like the orange one."
    ),
    document="001 Q1",
    place="cos θ_3",
    nth=1,
    quote="cos θ_3 = (p_x² + p_y² + p_z² − a_2² − a_3³)/(2 a_2 a_3)",
    correction="cos θ_3 = (p_x² + p_y² + p_z² − a_2² − «a_3²»)/(2 a_2 a_3)",
)
base_only = Mistake(
    "M4",
    feedback="when the base turns by half a turn and θ_2, θ_3 stay as they are",
    formula=WrongFormula(formulas.away, instead=ALIKE),
    line="away = [theta1 + np.pi, theta2, theta3]",
    why="With the base turned round, the arm reaches to the other side. It must lean over "
    "backwards: the shoulder needs π − θ_2 and the elbow −θ_3.",
    unnoticed="Where the wrist is on the base axis, if you look only at the wrist. The elbow is "
    "then on the other side.",
    title="It turns round",
    picture=(
        "The red arm leans away from p. Its program believes it reaches p, like the orange one."
    ),
    document="000 Q1",
    place="step 1, the second base angle, and the count of four solutions at the end",
    nth=1,
    quote="θ_1 + π together with the same θ_2 and θ_3",
    correction="θ_1 + π together with «π − θ_2» and «−θ_3»",
)
base_arctan = Mistake(
    "M5",
    feedback="with arctan in place of atan2, which cannot tell in front from behind",
    formula=WrongFormula(BASE_ANGLE, instead=atan(p_y / p_x)),
    line="theta1 = np.arctan(p_y / p_x)",
    why="The quotient p_y/p_x is the same for a point and for the one opposite to it. With "
    "p_x < 0, arctan gives the direction that faces away from the target.",
    unnoticed="Where p_x > 0.",
    title="It never looks behind",
    picture=(
        "The red arm looks to the front, even for a p that lies behind the base. Its program "
        "believes that it reaches p, like the orange one."
    ),
)


def bend(A, elevation, a2, a3):
    """Return rows [theta2, theta3], elbow up and down.

    A: the cosine of the elbow; elevation: of the line from shoulder to wrist.
    """
    theta3 = np.array([-1, 1]) * np.arccos(A)
    theta2 = elevation - np.arctan2(a3 * np.sin(theta3), a2 + a3 * np.cos(theta3))
    return np.stack([theta2, theta3], axis=-1)


def cosine(distance, a2, a3):
    """Return the cosine of the elbow for the wrist so far from the shoulder."""
    return (distance**2 - a2**2 - a3**2) / (2 * a2 * a3)


def length(p_x, p_y, p_z):
    """Return how far a point is from the shoulder."""
    return np.sqrt(p_x**2 + p_y**2 + p_z**2)


def rise(p_x, p_y, p_z):
    """Return the elevation of a point, seen from the shoulder."""
    return np.arctan2(p_z, np.hypot(p_x, p_y))


def without_x(p_x, p_y, p_z, a2, a3):
    """M2: the arm in the plane of y and z."""
    distance, elevation = no_p_x.formula.evaluate(p_y=p_y, p_z=p_z).ravel()
    return bend(cosine(distance, a2, a3), elevation, a2, a3)


def without_x_by_atan2(p_x, p_y, p_z, a2, a3):
    """M2 with an elevation beyond 90° where p_y is negative."""
    bends = bend(cosine(np.hypot(p_y, p_z), a2, a3), np.arctan2(p_z, p_y), a2, a3)
    return four(p_x, p_y, p_z, a2, a3, bends=bends)


def cubed(p_x, p_y, p_z, a2, a3):
    """M3: the third power of the forearm."""
    A = cubed_a_3.formula.evaluate(p_x=p_x, p_y=p_y, high=p_z, a2=a2, a3=a3)
    return bend(A, rise(p_x, p_y, p_z), a2, a3)


def bent(distance, a2, a3, power=2):
    """Whether the elbow is clearly bent, by the law of cosines with this power of a3."""
    limit = 0.9 * 2 * a2 * a3 - 1e-9  # less: at the limit itself the last bits would decide
    return abs(distance**2 - a2**2 - a3**power) < limit


def possible(p_x, p_y, p_z, a2, a3, d1=0):
    """Whether neither the right way nor M2 or M3 leaves the range of arccos."""
    z = p_z - d1
    distance = length(p_x, p_y, z)
    right = bent(distance, a2, a3) and bent(distance, a2, a3, 3)
    return right and bent(np.hypot(p_y, z), a2, a3)


def away(theta1, theta2, theta3, a2, a3):
    """Return the same place of elbow and wrist with the base turned round."""
    answers = elbow_arm.inverse(elbow_arm.forward([theta1, theta2, theta3], a2, a3), a2, a3)
    return answers[2] if theta3 < 0 else answers[3]


def place(theta1, theta2, theta3, a2, a3):
    """Return where the wrist is, from the shoulder."""
    return elbow_arm.forward([theta1, theta2, theta3], a2, a3)


def four(p_x, p_y, p_z, a2, a3, theta1=None, bends=None):
    """Return all four answers in the library's order; a mistake gives its own theta1 or bends."""
    theta1 = np.arctan2(p_y, p_x) if theta1 is None else theta1
    bends = elbow_arm.inverse([p_x, p_y, p_z], a2, a3)[:2, 1:] if bends is None else bends
    behind = [np.pi, 0] - bends
    return [[theta1, *row] for row in bends] + [[theta1 + np.pi, *row] for row in behind]


def four_alike(**numbers):
    """M4 in all four answers: the second half is the first with the base turned round."""
    facing = four(**numbers)[:2]
    joints = (dict(zip(("theta1", "theta2", "theta3"), row, strict=True)) for row in facing)
    return facing + [base_only.formula.evaluate(**row).ravel() for row in joints]


WAYS: dict[Mistake, Callable[..., Any]] = {
    swapped_xy: lambda **n: four(**n, theta1=swapped_xy.formula.evaluate(**n)),
    no_p_x: lambda **n: four(**n, bends=without_x(**n)),
    cubed_a_3: lambda **n: four(**n, bends=cubed(**n)),
    base_arctan: lambda **n: four(**n, theta1=base_arctan.formula.evaluate(**n)),
}


def first(formula):
    """Return the first of four answers, for a point measured from the base."""
    return lambda p_z, d1, **numbers: formula(p_z=p_z - d1, **numbers)[0]


SIDE = one_of(*range(-60, -5, 5), *range(10, 65, 5), unit="cm")
BACK = number_range(-60, -10, 5, "cm")
LINKS = {"a2": number_range(30, 60, 5, "cm"), "a3": number_range(25, 55, 5, "cm")}
TARGET = {"p_x": BACK, "p_y": SIDE, "p_z": number_range(-30, 50, 5, "cm")}
with as_written():
    FOREARM = apart - a2
TURNED = tuple(formulas.away.left)

EXAMPLE = {"p_x": -0.3, "p_y": 0.4, "p_z": 0.2, "a2": 0.4, "a3": 0.3}

# What several exercises say
POINT = "the point with the coordinates p_x = {p_x}, p_y = {p_y}, p_z = {p_z}"
BASE = "θ_1 is counted from the x axis, counter-clockwise seen from above. "
BENDS = (
    "θ_2 is counted upwards from the level direction in which the base faces, θ_3 from the upper "
    "link, the same way round. "
)

elbow_arm_1 = Exercise(
    "elbow-arm-1",
    title="Which way must the base turn?",
    text="The base of an arm is at the origin and turns by θ_1 about the vertical z axis. "
    + BASE
    + "With θ_1 = 0 the arm reaches forward along x. The wrist must come to a point with the "
    "coordinates p_x = {p_x}, p_y = {p_y}. What is θ_1 if the arm faces this point? (It does not "
    "face away and reach back over its base.)",
    given={"p_x": BACK, "p_y": SIDE},
    unknowns=(angle("θ_1"),),
    right=lambda p_x, p_y: elbow_arm.inverse([p_x, p_y, 0], 0.6, 0.5)[0, 0],
    wrong={swapped_xy: swapped_xy.formula.evaluate, base_arctan: base_arctan.formula.evaluate},
    when=lambda p_x, p_y: np.hypot(p_x, p_y) > 0.15,
    solution=Solution(
        "Seen from above, the arm must point from the base to the target. The direction of a "
        "vector is atan2, with y first; the signs of both numbers say in which quarter it lies. "
        "Here p_x is negative, so the point lies behind the arm:\n\n{base}",
        base=Step(formulas.base, part=(0,), values=(theta1,)),
    ),
    example={"p_x": -0.3, "p_y": 0.4},
)

elbow_arm_2 = Exercise(
    "elbow-arm-2",
    title="How far must the elbow bend?",
    text="An arm has an upper link of a_2 = {a2} and a forearm of a_3 = {a3}. The wrist must come "
    f"to {POINT}, measured from the shoulder. With θ_3 = 0 the arm is stretched. By which angle "
    "θ_3 must the elbow bend? Take the case with the elbow below the line from shoulder to wrist: "
    "there θ_3 is positive.",
    given=TARGET | LINKS,
    unknowns=(angle("θ_3"),),
    right=lambda p_x, p_y, p_z, a2, a3: elbow_arm.inverse([p_x, p_y, p_z], a2, a3)[1, 2],
    wrong={
        no_p_x: lambda **numbers: without_x(**numbers)[1, 1],
        cubed_a_3: lambda **numbers: cubed(**numbers)[1, 1],
    },
    when=possible,
    likely_slips={
        "for the angle inside the triangle, between the links": lambda p_x, p_y, p_z, **links: (
            np.pi - elbow_arm.inverse([p_x, p_y, p_z], **links)[1, 2]
        ),
        "for the cosine of the angle; the arccosine is missing": lambda p_x, p_y, p_z, **links: (
            np.cos(elbow_arm.inverse([p_x, p_y, p_z], **links)[1, 2])
        ),
    },
    solution=Solution(
        "Shoulder, elbow and wrist form a triangle. Two of its sides are the links, the third is "
        "the distance from shoulder to wrist. The law of cosines gives the cosine of the bend. It "
        "is written for θ_3, not for the angle inside the triangle; both together make half a "
        "turn. Here A is short for cos θ_3:\n\n{cosine}\n\n"
        "The sine is then a square root. Below the line θ_3 is positive, so the root has a plus:"
        "\n\n{elbow}",
        cosine=Step(formulas.cosine, {high: p_z}),
        elbow=Step(formulas.elbow, part=(0,), values=(theta3,)),
    ),
    example=EXAMPLE,
)

elbow_arm_3 = Exercise(
    "elbow-arm-3",
    title="The same place from behind",
    text="An arm with the links a_2 = {a2} and a_3 = {a3} faces its target. Its joint angles are "
    "θ_1 = {theta1}, θ_2 = {theta2}, θ_3 = {theta3}. "
    + BASE
    + BENDS
    + "Now the base makes half a turn. Then the elbow and the wrist must be where they were "
    "before. What are the three joint angles now?",
    given={
        "theta1": one_of(*range(-160, 0, 10), *range(10, 170, 10), unit="°"),
        "theta2": number_range(-40, 80, 10, "°"),
        "theta3": one_of(*range(-110, -20, 10), *range(30, 120, 10), unit="°"),
    }
    | LINKS,
    unknowns=(angle("θ_1"), angle("θ_2"), angle("θ_3")),
    right=away,
    wrong={base_only: base_only.formula.evaluate},
    when=lambda theta2, theta3, a2, a3, **_: (
        a2 * np.cos(theta2) + a3 * np.cos(theta2 + theta3) > 0.1
    ),
    likely_slips={
        "when both angles only change their sign": lambda theta1, theta2, theta3, a2, a3: [
            theta1 + np.pi,
            -theta2,
            -theta3,
        ],
        "when the shoulder stays as it is": lambda theta1, theta2, theta3, a2, a3: [
            theta1 + np.pi,
            theta2,
            -theta3,
        ],
        "when the elbow stays as it is": (
            lambda theta1, theta2, theta3, a2, a3: [theta1 + np.pi, np.pi - theta2, theta3]
        ),
    },
    solution=Solution(
        "From the side: after half a turn of the base, forward is where backward "
        "was. To point in the old direction the upper link must lean over backwards, as far from "
        "the horizontal as before. The elbow then bends to the other side. The new angles, "
        "with the base facing away, up to whole turns:\n\n{away}\n\n"
        "Check: the place of the wrist, from the shoulder. With the old angles:\n\n{old}\n\n"
        "With the new angles it is {new.value}, the same place.",
        answer=("away",),
        away=Step(formulas.away, values=TURNED, unit="rad"),
        old=Step(formulas.forward, {d1: 0}, expected=place),
        new=Step(
            formulas.forward,
            {theta1: TURNED[0], theta2: TURNED[1], theta3: TURNED[2], d1: 0},
            expected=place,
        ),
    ),
    example={
        "theta1": np.pi / 6,
        "theta2": np.pi / 3,
        "theta3": -np.pi / 3,
        "a2": 0.4,
        "a3": 0.3,
    },
)

elbow_arm_4 = Exercise(
    "elbow-arm-4",
    title="How long must the forearm be?",
    text="You design an arm. Its shoulder is {d1} above the floor, and its upper link is "
    "{a2} long. The wrist must reach "
    f"{POINT}, measured from the floor straight below the shoulder. "
    "How long must the forearm be at least?",
    given={
        "d1": number_range(20, 50, 10, "cm"),
        "a2": number_range(30, 50, 5, "cm"),
        "p_x": one_of(*range(-60, -10, 10), *range(20, 70, 10), unit="cm"),
        "p_y": one_of(*range(-60, -10, 10), *range(20, 70, 10), unit="cm"),
        "p_z": number_range(0, 90, 10, "cm"),
    },
    unknowns=(Unknown("a_3", "m"),),
    right=lambda d1, a2, **p: length(**p | {"p_z": p["p_z"] - d1}) - a2,
    wrong={no_p_x: lambda d1, a2, p_x, p_y, p_z: np.hypot(p_y, p_z - d1) - a2},
    when=lambda d1, a2, p_x, p_y, p_z: np.hypot(p_y, p_z - d1) - a2 > 0.05,
    likely_slips={
        "for the distance alone; the upper link is not taken away": lambda d1, a2, p_z, **p: length(
            p_z=p_z - d1, **p
        ),
        "when p_z is taken as measured from the shoulder": lambda d1, a2, **p: length(**p) - a2,
        "for the longest forearm with which it works, folded": lambda d1, a2, p_z, **p: (
            length(p_z=p_z - d1, **p) + a2
        ),
    },
    solution=Solution(
        "With the shortest forearm that reaches the point, the arm is stretched: both links lie "
        "on the straight line from shoulder to point. Seen from the side, the point is r ahead of "
        "the shoulder and h above it (below, where h is negative):\n\n{side}\n\n"
        "The distance from shoulder to point:\n\n{distance}\n\n"
        "The upper link makes up a part of it, the forearm the rest:\n\n{forearm}",
        side=Step(formulas.side, part=(0, 1)),
        distance=Step(formulas.side, part=(2,)),
        forearm=Step(LocalEquation(a3, FOREARM, "m")),
    ),
)

elbow_arm_5 = Exercise(
    "elbow-arm-5",
    title="Straight above the shoulder",
    text="An arm has the links a_2 = {a2} and a_3 = {a3}. Its wrist must come to a point straight "
    "above the shoulder, {p_z} higher (p_x = p_y = 0). Then θ_1 can be any angle. "
    + BENDS
    + "What are θ_2 and θ_3? There are two answers; either of them is enough.",
    given=LINKS | {"p_z": number_range(20, 90, 5, "cm")},
    unknowns=(angle("θ_2"), angle("θ_3")),
    accept="any",
    right=lambda p_z, a2, a3: elbow_arm.inverse([0, 0, p_z], a2, a3)[:2, 1:],
    wrong={cubed_a_3: lambda p_z, a2, a3: cubed(0, 0, p_z, a2, a3)},
    when=lambda p_z, a2, a3: bent(p_z, a2, a3) and bent(p_z, a2, a3, 3),
    likely_slips={
        "for the angle inside the triangle, between the links": lambda p_z, a2, a3: [
            [theta2, theta3 - np.copysign(np.pi, theta3)]
            for theta2, theta3 in elbow_arm.inverse([0, 0, p_z], a2, a3)[:2, 1:]
        ],
    },
    solution=Solution(
        "On the base axis the target has no direction seen from above, so θ_1 is free. The "
        "triangle of shoulder, elbow and wrist is there as always, with the side p_z from "
        "shoulder to wrist. The law of cosines gives its angle φ_1 at the shoulder and φ_2 at the "
        "elbow; the line to the wrist points straight up, at φ_3:\n\n{triangle}\n\n"
        "The upper link can lie on either side of this line, and the bend of the elbow is what φ_2 "
        "lacks of half a turn. With the elbow on the one side:\n\n{up}\n\n"
        "With the elbow on the other side:\n\n{down}",
        answer=("up", "down"),
        triangle=Step(formulas.triangle, {out: 0, high: p_z, apart: p_z}, unit="rad"),
        up=Step(formulas.first_way, part=(0, 1), values=(theta2, theta3)),
        down=Step(formulas.first_way, part=(2, 3), values=(theta2, theta3)),
    ),
)

elbow_arm_6 = Exercise(
    "elbow-arm-6",
    title="All three joints",
    text="The base of an arm is at the origin, and its shoulder is {d1} straight above. The links "
    "are a_2 = {a2} and a_3 = {a3}. "
    f"The wrist must come to {POINT}, measured from the base. "
    + BASE
    + BENDS
    + "The arm faces the point, and the elbow is above the line from shoulder to wrist. What are "
    "the three joint angles?",
    given={
        **TARGET,
        "p_z": number_range(0, 80, 5, "cm"),
        "d1": number_range(10, 40, 5, "cm"),
        **LINKS,
    },
    unknowns=(angle("θ_1"), angle("θ_2"), angle("θ_3")),
    right=lambda p_x, p_y, p_z, a2, a3, d1: elbow_arm.inverse([p_x, p_y, p_z], a2, a3, d1)[0],
    wrong={mistake: first(formula) for mistake, formula in WAYS.items()},
    when=possible,
    likely_slips={
        f"{no_p_x.feedback}, although with atan2": first(without_x_by_atan2),
        "with the elbow below": lambda p_x, p_y, p_z, d1, **links: elbow_arm.inverse(
            [p_x, p_y, p_z], **links, d1=d1
        )[1],
        "when p_z is taken as measured from the shoulder": lambda p_x, p_y, p_z, d1, **links: (
            elbow_arm.inverse([p_x, p_y, p_z], **links, unreachable="nan")[0]
        ),
    },
    solution=Solution(
        "Seen from above, the arm faces the point:\n\n{base}\n\n"
        "Seen from the side, in the vertical plane through the target, the point is r ahead of the "
        "shoulder and h above it (below, where h is negative):\n\n{side}\n\n"
        "The law of cosines gives A, the cosine of θ_3. With the elbow above the line the forearm "
        "bends down again, so the sine of θ_3 is negative:\n\n{cosine}\n\n{elbow}\n\n"
        "The shoulder: the elevation of the target, less the angle between upper link and "
        "target:\n\n{shoulder}",
        answer=(("base", "shoulder", "elbow"),),
        base=Step(formulas.base, part=(0,), values=(theta1,)),
        side=Step(formulas.side, part=(0, 1)),
        cosine=Step(formulas.cosine),
        elbow=Step(formulas.elbow, part=(1,), values=(theta3,)),
        shoulder=Step(formulas.shoulder, values=(theta2,)),
    ),
)

elbow_arm_7 = Exercise(
    "elbow-arm-7",
    title="All four arms",
    text="An arm has the links a_2 = {a2} and a_3 = {a3}. "
    f"The wrist must come to {POINT}, measured from the shoulder. "
    + BASE
    + BENDS
    + "There are four ways: the base faces the point or faces away from it, and the elbow is above "
    "or below the line from shoulder to wrist. Give the angles θ_1, θ_2, θ_3 of all four.",
    given=TARGET | LINKS,
    unknowns=(angle("θ_1"), angle("θ_2"), angle("θ_3")),
    accept="all",
    right=lambda p_x, p_y, p_z, a2, a3: elbow_arm.inverse([p_x, p_y, p_z], a2, a3),
    wrong=WAYS | {base_only: four_alike},
    when=possible,
    solution=Solution(
        "The base faces the point at\n\n{base}\n\n"
        "Seen from the side, the point is r ahead of the shoulder. The law of cosines gives A, the "
        "cosine of θ_3:\n\n{ahead}\n\n{cosine}\n\n"
        "The sine of θ_3 can have both signs. With the elbow up it is negative:"
        "\n\n{bend_up}\n\n{lift_up}\n\n"
        "With the base turned round, the arm leans over backwards to the same places of elbow and "
        "wrist. These angles are:\n\n{behind_up}\n\n"
        "With the elbow down the sine of θ_3 is positive:\n\n{bend_down}\n\n{lift_down}\n\n"
        "Again with the base turned round:\n\n{behind_down}\n\n"
        "All four, as [θ_1, θ_2, θ_3] and without whole turns:\n\n{right}",
        answer=(
            ("base", "lift_up", "bend_up"),
            ("base", "lift_down", "bend_down"),
            "behind_up",
            "behind_down",
        ),
        base=Step(formulas.base, part=(0,), values=(theta1,)),
        ahead=Step(formulas.side, part=(0,)),
        cosine=Step(formulas.cosine, {high: p_z}),
        bend_up=Step(formulas.elbow, part=(1,), values=(theta3,)),
        lift_up=Step(formulas.shoulder, {high: p_z}, values=(theta2,)),
        behind_up=Step(formulas.away, values=TURNED, unit="rad"),
        bend_down=Step(formulas.elbow, part=(0,), values=(theta3,)),
        lift_down=Step(formulas.shoulder, {high: p_z}, values=(theta2,)),
        behind_down=Step(formulas.away, values=TURNED, unit="rad"),
    ),
)


def nearest(p_x, p_y, p_z, d1, a2, a3):
    """Return the nearest point within reach."""
    return elbow_arm.nearest_reachable([p_x, p_y, p_z], a2, a3, d1)


def along_the_ray(start, far):
    """Return the point so far from a start towards a target."""
    return lambda p_x, p_y, p_z, **arm: (
        np.array([0, 0, start(**arm)])
        + (ray := np.array([p_x, p_y, p_z - start(**arm)])) * far(**arm) / np.linalg.norm(ray)
    )


elbow_arm_8 = Exercise(
    "elbow-arm-8",
    title="As near as it can",
    text="The shoulder of an arm is {d1} straight above its base, its links are a_2 = {a2} and "
    f"a_3 = {{a3}}. A ball is at {POINT}, measured from the base. That is out of reach. Which "
    "point within reach is nearest to it?",
    given={
        "p_x": one_of(*range(-120, -40, 10), *range(50, 130, 10), unit="cm"),
        "p_y": one_of(*range(-120, -40, 10), *range(50, 130, 10), unit="cm"),
        "p_z": number_range(0, 120, 10, "cm"),
        "d1": number_range(20, 50, 10, "cm"),
        **LINKS,
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), Unknown("z", "m")),
    right=nearest,
    wrong={},
    when=lambda p_x, p_y, p_z, d1, a2, a3: length(p_x, p_y, p_z - d1) > a2 + a3 + 0.1,
    likely_slips={
        "on the ray from the base, where it is the one from the shoulder": along_the_ray(
            lambda **_: 0, lambda a2, a3, d1: a2 + a3
        ),
        "for the folded arm, at the inner edge of the workspace": along_the_ray(
            lambda d1, **_: d1, lambda a2, a3, d1: abs(a2 - a3)
        ),
        "as seen from the shoulder; its height is not added": lambda p_z, d1, **rest: (
            nearest(p_z=p_z, d1=d1, **rest) - [0, 0, d1]
        ),
    },
    solution=Solution(
        "The workspace is a shell around the shoulder. The nearest point of it lies on the ray "
        "from the shoulder to the ball. First how far the ball is ahead of the shoulder, and above "
        "it:\n\n{side}\n\nIts distance from the shoulder:\n\n{distance}\n\n"
        "The arm reaches as far as both links together:\n\n{reach}\n\n"
        "So the ray is shortened to that:\n\n{near}",
        answer=("near",),
        side=Step(formulas.side, part=(0, 1)),
        distance=Step(formulas.side, part=(2,)),
        reach=Step(formulas.reach, part=(1,)),
        near=Step(SHORTENED),
    ),
)

elbow_arm_9 = Exercise(
    "elbow-arm-9",
    title="Onto a border of the map",
    text="An arm with the links a_2 = {a2} and a_3 = {a3} has its elbow at θ_3 = {theta3}. "
    + BENDS
    + "At which θ_2 is its wrist straight above the shoulder, on the base axis? There θ_1 is free: "
    "the arm is on the border between the ways that face a target and those that face away.",
    given={"theta3": one_of(*range(-130, -20, 10), *range(30, 140, 10), unit="°")} | LINKS,
    unknowns=(angle("θ_2"),),
    right=lambda theta3, a2, a3: elbow_arm.inverse(
        [0, 0, np.sqrt(a2**2 + a3**2 + 2 * a2 * a3 * np.cos(theta3))], a2, a3
    )[0 if theta3 < 0 else 1, 1],
    wrong={},
    likely_slips={
        "for the forearm alone; the upper link is missing": lambda theta3, a2, a3: (
            np.pi / 2 - theta3
        ),
        "on the wrong side: the angle between is added, not taken away": lambda theta3, a2, a3: (
            np.pi / 2 + np.arctan2(a3 * np.sin(theta3), a2 + a3 * np.cos(theta3))
        ),
        "for the angle between the upper link and the line to the wrist": lambda theta3, a2, a3: (
            np.arctan2(a3 * np.sin(theta3), a2 + a3 * np.cos(theta3))
        ),
    },
    solution=Solution(
        "Seen along the upper link, the wrist is a_2 + a_3 cos θ_3 ahead and a_3 sin θ_3 aside. "
        "The line to the wrist goes straight up, and the upper link rises by what is left:"
        "\n\n{border}",
        border=Step(ON_AXIS),
    ),
)

elbow_arm_10 = Exercise(
    "elbow-arm-10",
    title="One row of a DH table",
    text="A row of a DH table has θ = {dh_theta}, d = {dh_d}, a = {dh_a}, α = {dh_alpha}: turn by "
    "θ about z, go d along z, go a along the new x, turn by α about it. Where is the origin of the "
    "new frame, as seen from the old one?",
    given={
        "dh_theta": one_of(*range(-160, -10, 10), *range(20, 170, 10), unit="°"),
        "dh_d": number_range(10, 60, 5, "cm"),
        "dh_a": number_range(15, 60, 5, "cm"),
        "dh_alpha": one_of(-90, -60, -30, 30, 60, 90, unit="°"),
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), Unknown("z", "m")),
    right=lambda dh_theta, dh_d, dh_a, dh_alpha: frames.dh(dh_theta, dh_d, dh_a, dh_alpha)[:3, 3],
    wrong={},
    when=lambda dh_d, dh_a, dh_theta, dh_alpha: (
        abs(dh_d - dh_a) > 0.01 and abs(dh_theta - dh_alpha) > 0.1
    ),
    likely_slips={
        "when a is taken along the old x axis, which is not yet turned": (
            lambda dh_theta, dh_d, dh_a, dh_alpha: [dh_a, 0, dh_d]
        ),
        "when d and a are exchanged": lambda dh_theta, dh_d, dh_a, dh_alpha: [
            dh_d * np.cos(dh_theta),
            dh_d * np.sin(dh_theta),
            dh_a,
        ],
        "with α in place of θ; it turns the frame only after both shifts": (
            lambda dh_theta, dh_d, dh_a, dh_alpha: [
                dh_a * np.cos(dh_alpha),
                dh_a * np.sin(dh_alpha),
                dh_d,
            ]
        ),
    },
    solution=Solution(
        "The turn by θ takes the x axis to (cos θ, sin θ, 0). The origin goes d along z and a "
        "along that axis; the turn by α comes last, about the new origin, and moves it no "
        "more:\n\n{origin}",
        origin=Step(DH_ORIGIN),
    ),
)
