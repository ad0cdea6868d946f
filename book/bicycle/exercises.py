"""Exercises on the bicycle model of a car, and the mistakes that are made there."""

from functools import cache

import numpy as np
import sympy as sp
from sympy import Add, atan, cos, cot, sin, tan

from book.bicycle import formulas
from book.differential_drive import formulas as drive
from book.motion import formulas as planar
from courseware.answers import Unknown, angle, integer
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
from robokin import bicycle, motion

PHI, L, V_F, PSI = formulas.steering, formulas.wheelbase, formulas.v_F, formulas.y_heading
DIAMETER, TANGENT, COTANGENT = sp.symbols("d tangent cotangent")
PSI_DOT, PSI_NEXT = formulas.psi_dot, sp.Symbol("ψ'")
BY_PHI = {PHI: "phi", L: "L"}  # the letters of the formulas, the exercises' names of the numbers

with as_written():
    R, THETA, TURNED = drive.R, planar.theta, planar.theta_next
    ARC = LocalEquation(
        sp.Matrix([planar.x_next, planar.y_next]),
        sp.Matrix([R * (sin(TURNED) - sin(THETA)), -R * (cos(TURNED) - cos(THETA))]),
    )
    TURNING = LocalEquation(planar.omega, planar.v / L * tan(PHI))
    FRONT = LocalEquation(
        sp.Matrix([formulas.x_dot_F, formulas.y_dot_F]),
        sp.Matrix([V_F * cos(THETA + PHI), V_F * sin(THETA + PHI)]),
    )
    ONE_WHEEL = LocalEquation(PHI, atan(2 / (cot(formulas.alpha_L) + cot(formulas.alpha_R))))
    MEAN = (formulas.alpha_L + formulas.alpha_R) / 2
    TURN = planar.v / L * tan(PHI) * planar.dt
    CLOCKWISE, GROWING = LocalEquation(PSI_NEXT, PSI - TURN), PSI + TURN

sines_only = Mistake(
    "M15",
    feedback="with the difference of the sines in both rows of the arc, where y needs the cosines",
    formula=WrongFormula(ARC, instead=sp.Matrix([ARC.right[0], -ARC.right[0]])),
    line="end = [R * (np.sin(turned) - np.sin(theta)),\n"
    "       -R * (np.sin(turned) - np.sin(theta)), turned]",
    why="The car moves along x with v cos θ and along y with v sin θ. Summed up over time, the "
    "first gives a difference of sines, the second one of cosines. Only y comes out wrong.",
    unnoticed="Where the heading halfway along the arc is 135° or −45°, and after a full circle.",
    title="Off its circle",
    picture=(
        "The car drives on its circle. Its program believes that the rear axle moves along a "
        "straight line."
    ),
    document="000 Q5",
    place="the position after a step",
    nth=1,
    quote="y(t + δt) = y − R (sin(θ + ωδt) − sin θ)",
    correction="y(t + δt) = y − R («cos»(θ + ωδt) − «cos» θ)",
)
front_speed_used = Mistake(
    "M16",
    feedback="when the front axle's speed is put where the rear axle's speed belongs",
    formula=WrongFormula(TURNING, {planar.v: V_F}),
    line="omega = v_front * np.tan(phi) / L",
    why="The formula v tan φ/L holds for the speed v of the rear axle. The front axle is faster, "
    "v_F = v/cos φ. For its speed the formula is v_F sin φ/L.",
    unnoticed="Straight ahead, and at rest. For small steering angles it is hard to see: 1.5 % "
    "at 10°.",
    title="It turns too fast",
    picture="The car drives on its circle. Its program believes it on a smaller one.",
    document="004 Ans 1",
    place="the state equations of point O, third line",
    nth=2,
    quote="θ̇ = v_s sec α tan α/L",
    correction="θ̇ = «v_s» tan α/L",
    explanation="Here α is the steering angle, v_s the speed of the rear axle and v_s sec α that "
    "of the front axle. The formula with tan α/L wants the speed of the rear axle.",
)
along_heading = Mistake(
    "M17",
    feedback="when the front axle is sent along the heading of the car, not along its steered "
    "wheel",
    formula=WrongFormula(FRONT, instead=sp.Matrix([V_F * cos(THETA), V_F * sin(THETA)])),
    line="velocity = [v_front * np.cos(theta), v_front * np.sin(theta)]",
    why="The steered wheel rolls where it points, and that is θ + φ. Only the rear axle moves "
    "along the heading θ.",
    unnoticed="Straight ahead, where the wheel points along the heading.",
    title="It follows its nose",
    picture=(
        "The car drives on its circle. Its program believes that the front axle moves where the "
        "car looks."
    ),
    document="004 Ans 1",
    place="the state equations of point O",
    nth=1,
    quote="ẋ = v_so sin φ, ẏ = v_so cos φ",
    correction="ẋ = v_so sin(φ «− α»), ẏ = v_so cos(φ «− α»)",
    explanation="In this document φ is the heading, clockwise from the y axis, α is the "
    "steering angle, to the left, and v_so the speed of O. (In the chapter θ is the heading and "
    "φ the steering angle.) The point O is at the front axle. It moves where the steered wheel "
    "rolls, and that is φ − α from the y axis.",
)
mean_angle = Mistake(
    "M18",
    feedback="when the two steering angles are averaged, where their cotangents must be",
    formula=WrongFormula(ONE_WHEEL, instead=MEAN),
    line="phi = (alpha_L + alpha_R) / 2",
    why="The three axles meet in one point. This makes the distances R − b/2, R and R + b/2 "
    "evenly spaced, and they go with the cotangents of the angles, not with the angles.",
    unnoticed="Only straight ahead. In a turn without sliding the mean is near, but never right.",
    title="One wheel for two",
    picture=(
        "The car drives on its circle. Its program believes it in a turn that is a little tighter."
    ),
)
reversed_turn = Mistake(
    "M32",
    feedback="when a heading that is measured from the y axis, clockwise, grows in a left turn",
    formula=WrongFormula(CLOCKWISE, instead=GROWING),
    line="heading = psi + v * np.tan(phi) / L * time",
    why="A heading that is measured clockwise gets smaller when the car turns to the left. It "
    "changes by −ωΔt, not by +ωΔt.",
    unnoticed="On a straight line, where the heading does not change, and after half turns.",
    title="To the other side",
    picture="The car turns to the left. Its program believes that it turns to the right.",
    document="004 Ans 1",
    place="the points of the trajectory",
    nth=4,
    quote="φ(t + Δt) = φ + φ̇Δt, with φ̇ = θ̇ of the third state equation",
    correction="φ(t + Δt) = φ + φ̇Δt, with φ̇ = «−»θ̇",
    explanation="Here φ is the heading, clockwise from the y axis, and α the steering angle, to "
    "the left; θ = 90° − φ. So φ gets smaller when θ grows, in a turn to the left. (θ̇ itself is "
    "the erratum M16.)",
)
same_sine = Mistake(
    "M33",
    feedback="with the same sine for ẋ and for ẏ",
    formula=WrongFormula(FRONT, instead=sp.Matrix([FRONT.right[1], FRONT.right[1]])),
    line="velocity = [v_front * np.sin(theta + phi), v_front * np.sin(theta + phi)]",
    why="One of the two needs the cosine. With the same sine in both, ẋ and ẏ are always equal: "
    "the car could move along one diagonal only.",
    unnoticed="When the motion is along that diagonal, at 45° or at −135° to the x axis.",
    title="Only along a diagonal",
    picture=(
        "The car drives on its circle. Its program believes that the front axle goes up and down "
        "a diagonal."
    ),
    document="004 Ans 1",
    place="the state equations with numbers",
    nth=3,
    quote="ẋ = 0.25 w sec α sin φ, ẏ = 0.25 w sec α sin φ",
    correction="ẋ = 0.25 w sec α sin(φ «− α»), ẏ = 0.25 w sec α «cos»(φ «− α»)",
    explanation="Here φ is the heading, clockwise from the y axis, α the steering angle, to the "
    "left, and w the rate of the rear wheels. One of the two lines needs the cosine. "
    "(The angle φ − α is the erratum M17.)",
)


def rate(v, phi, L):
    """Return the turning rate for the rear axle's speed."""
    return bicycle.body_twist(v, phi, L)[2]


def spread(alpha_L, alpha_R):
    """Return the front wheels' distance by the wheelbase, from both steering angles."""
    return 1 / np.tan(alpha_R) - 1 / np.tan(alpha_L)


def other_track(alpha_L, phi):
    """Return the front wheels' distance by the wheelbase, from the left and the bicycle's wheel."""
    return 2 * (1 / np.tan(phi) - 1 / np.tan(alpha_L))


def compass(psi, diameter, wheel_rate, L, phi, time):
    """Return the heading after some time, measured clockwise."""
    return psi - rate(wheel_rate * diameter / 2, phi, L) * time


def arc_end(theta, v, phi, L, time):
    """Return the pose after an arc from the origin."""
    return bicycle.path([0, 0, theta], v, phi, L, time)[-1]


def same_sines(theta, v, phi, L, time):
    """M15: the sines' difference in y too."""
    turned = arc_end(theta, v, phi, L, time)[2]
    R = bicycle.turning_radius(phi, L)
    return [*sines_only.formula.evaluate(R=R, theta=theta, theta_next=turned).ravel(), turned]


def too_fast(v, phi, L):
    """M16: the front axle's speed turns the car."""
    return front_speed_used.formula.evaluate(v_F=v / np.cos(phi), steering=phi, wheelbase=L)


def front_as_rear(theta, v, phi, L, time):
    """M16 in an arc."""
    return motion.arc_step([0, 0, theta], v, too_fast(v, phi, L), time)


def front_on_circle(theta, v, phi, L, time):
    """M16 in the turning rate alone: the radius is the right one."""
    return motion.arc_step([0, 0, theta], v / np.cos(phi), too_fast(v, phi, L), time)


def at_front(mistake):
    """Return the front axle's velocity by M17 or M33."""
    return lambda theta, v, phi: mistake.formula.evaluate(
        theta=theta, v_F=v / np.cos(phi), steering=phi
    )


def looped(direction, speed, omega, dt, n, method="start"):
    """Return a point after n straight steps: speed, direction at the start, its turning rate."""
    return motion.path([0, 0, direction], speed, omega, np.full(int(n), dt), method)[-1, :2]


def front_looped(psi, v, phi, L, dt, n, method="start"):
    """Return where the loop takes the front axle, with a heading that is measured clockwise."""
    return looped(np.pi / 2 - psi + phi, v / np.cos(phi), rate(v, phi, L), dt, n, method)


@cache
def loop(n):
    """Return the loop's n steps: the angle of each from the y axis, and the sum of their ways."""
    angles = sp.symbols(f"delta_1:{n + 1}")
    with as_written():
        directions = [PSI + k * PSI_DOT * planar.dt - PHI for k in range(n)]
        ends = [V_F * planar.dt * Add(*map(part, angles)) for part in (sin, cos)]
    return (
        LocalEquation(sp.Matrix(angles), sp.Matrix(directions), "rad"),
        LocalEquation(sp.Matrix([formulas.x_F, formulas.y_F]), sp.Matrix(ends), "m"),
    )


FINE = 1e-4  # rad, for four decimals: the mean of the two angles can be as near as 0.001
CAR = number_range(2.4, 3, 0.1, "m")
STEERING = one_of(*(sign * size for sign in (1, -1) for size in (15, 20, 25, 30, 35, 40)), unit="°")


with as_written():
    OUTER_WHEEL = LocalEquation(cot(formulas.alpha_R), 2 * cot(PHI) - cot(formulas.alpha_L))
    NEXT_HEADING = LocalEquation(PSI_NEXT, PSI + PSI_DOT * planar.dt, "rad")


# What several exercises say
MIDDLE = "The two wheels of the bicycle are in the middle of the car's axles. "
COMPASS = "the heading ψ as a compass does: clockwise, from the y axis. "

bicycle_1 = Exercise(
    "bicycle-1",
    title="A speedometer on the front wheel",
    text="The wheelbase of a bicycle is {L}: so far apart its wheels touch the floor. The front "
    "wheel is turned by {phi} to the left. A speedometer on the front wheel shows {v_front}. How "
    "fast does the bicycle turn? To the left is positive.",
    given={
        "L": number_range(0.9, 1.2, 0.05, "m"),
        "phi": number_range(15, 45, 5, "°"),
        "v_front": number_range(1, 5, 0.5, "m/s"),
    },
    when=lambda L, phi, v_front: v_front**2 * np.cos(phi) * np.sin(phi) / L < 4,  # m/s² sideways
    unknowns=(Unknown("ω", "rad/s"),),
    right=lambda L, phi, v_front: rate(v_front * np.cos(phi), phi, L),
    wrong={front_speed_used: lambda L, phi, v_front: too_fast(v_front * np.cos(phi), phi, L)},
    likely_slips={
        "with the cosine where the sine belongs": lambda v_front, phi, L: v_front * np.cos(phi) / L,
    },
    solution=Solution(
        "The front wheel moves where it points: along the bicycle and sideways at once. The part "
        "sideways, with the sine, turns the bicycle about its rear wheel, {L} behind:\n\n{front}"
        "\n\nThere is a second way. The part along the bicycle, with the cosine, is the speed of "
        "the rear wheel:\n\n{rear}\n\nFor this speed the formula has the tangent, and it "
        "gives the same:\n\n{turning}",
        answer=("front", "turning"),
        front=Step(formulas.front_rate, {V_F: "v_front"} | BY_PHI),
        rear=Step(LocalEquation(planar.v, V_F * cos(PHI)), {V_F: "v_front"} | BY_PHI),
        turning=Step(formulas.world, BY_PHI, part=(2,), values=(planar.omega,)),
    ),
    example={"L": 7.0, "phi": np.pi / 6, "v_front": 1.0},
)

bicycle_2 = Exercise(
    "bicycle-2",
    title="One wheel in place of two",
    text="A car turns to the left. Its left front wheel is turned by {alpha_L}, its right front "
    "wheel by {alpha_R}. A bicycle drives the same curve. "
    + MIDDLE
    + "By which angle φ is its front wheel turned?",
    given={"alpha_L": number_range(18, 42, 1, "°"), "alpha_R": number_range(14, 36, 1, "°")},
    unknowns=(Unknown("φ", "rad", circle=True, tolerance=FINE),),
    right=lambda alpha_L, alpha_R: bicycle.equivalent_steering(alpha_L, alpha_R),
    wrong={mean_angle: mean_angle.formula.evaluate},
    when=lambda alpha_L, alpha_R: 0.3 < spread(alpha_L, alpha_R) < 0.9,
    likely_slips={
        "with the mean of the tangents, not of the cotangents": lambda alpha_L, alpha_R: np.arctan(
            (np.tan(alpha_L) + np.tan(alpha_R)) / 2
        ),
    },
    solution=Solution(
        "All axles meet in one point, to the left of the car on the line of its rear axle. The "
        "wheelbase times the cotangent of a wheel's angle says how far to the left of this wheel "
        "the point lies. The bicycle's wheel is in the middle between the two others. So its "
        "cotangent, not its angle, is the mean of theirs. The tangent is one over this mean:\n\n"
        "{tangent}\n\n"
        "The angle with this tangent is φ = {phi.value}, or {phi.value:deg}.",
        tangent=Step(formulas.equivalent_steering, textbook=True, values=("tangent",)),
        phi=Step(LocalEquation(PHI, atan(TANGENT))),
    ),
    example={"alpha_L": np.radians(35), "alpha_R": np.radians(29)},
)

bicycle_3 = Exercise(
    "bicycle-3",
    title="Where does the front axle go?",
    text="A car has the heading {theta}. The middle of its rear axle moves forward at {v}. The "
    "steering angle of its bicycle model is {phi} (positive: to the left). What is the velocity "
    "of the middle of its front axle in the world, along x and y?",
    given={
        "theta": number_range(10, 170, 10, "°"),
        "v": number_range(0.5, 5, 0.5, "m/s"),
        "phi": STEERING,
    },
    unknowns=(Unknown("ẋ", "m/s"), Unknown("ẏ", "m/s")),
    right=lambda theta, v, phi: motion.to_world(theta, bicycle.front_twist(v, phi, 1.0))[:2],
    wrong={mistake: at_front(mistake) for mistake in (along_heading, same_sine)},
    derive=lambda theta, v, phi: {"v_front": v / np.cos(phi)},
    likely_slips={
        "with the speed of the rear axle": lambda theta, v, phi: [
            v * np.cos(theta + phi),
            v * np.sin(theta + phi),
        ],
        "as the car sees it; asked is the world": lambda theta, v, phi: [v, v * np.tan(phi)],
    },
    solution=Solution(
        "The front wheel rolls where it points, in the direction θ + φ. Car and wheel share the "
        "part of the speed that is along the car. So the wheel is faster than the rear axle:\n\n"
        "{speed}\n\nThis speed in the direction θ + φ is, in the world:\n\n{world}",
        speed=Step(
            formulas.front_speed,
            BY_PHI,
            expected=lambda theta, v, phi: np.hypot(*bicycle.front_twist(v, phi, 1.0)[:2]),
        ),
        world=Step(formulas.front_world, BY_PHI, textbook=True, unit="m/s"),
    ),
    example={"theta": np.pi / 2, "v": 1.0, "phi": np.pi / 6},
)

bicycle_4 = Exercise(
    "bicycle-4",
    title="The outer wheel",
    text="You design the steering of a car. When its left front wheel is turned by {alpha_L} to "
    "the left, the car must turn like a bicycle whose front wheel is turned by {phi} to the "
    "left. "
    + MIDDLE
    + "By which angle α_R must the right front wheel of the car then be turned to the left, so "
    "that no wheel slips?",
    given={"alpha_L": number_range(18, 48, 1, "°"), "phi": number_range(16, 44, 1, "°")},
    unknowns=(Unknown("α_R", "rad", circle=True, tolerance=FINE),),
    right=lambda alpha_L, phi: bicycle.ackermann(phi, 1.0, other_track(alpha_L, phi))[1],
    wrong={mean_angle: lambda alpha_L, phi: 2 * phi - alpha_L},
    when=lambda alpha_L, phi: phi < alpha_L and 0.3 < other_track(alpha_L, phi) < 0.9,
    likely_slips={
        "with the mean of the tangents, not of the cotangents": lambda alpha_L, phi: np.arctan(
            2 * np.tan(phi) - np.tan(alpha_L)
        ),
    },
    solution=Solution(
        "All axles meet in one point on the line of the rear axle. The wheelbase times the "
        "cotangent of a wheel's angle says how far to the left of this wheel the point lies. The "
        "bicycle's wheel is in the middle between the two others. So its cotangent, not its "
        "angle, is the mean of theirs. Solve this for the right wheel:\n\n{cotangent}\n\n"
        "The angle with this cotangent is α_R = {alpha_R.value}, or {alpha_R.value:deg}.",
        cotangent=Step(OUTER_WHEEL, BY_PHI, values=("cotangent",)),
        alpha_R=Step(LocalEquation(formulas.alpha_R, atan(1 / COTANGENT))),
    ),
)

bicycle_5 = Exercise(
    "bicycle-5",
    title="A heading as on a compass",
    text="A truck measures "
    + COMPASS
    + "With ψ = 90° it looks along x. Now ψ is {psi}. The rear wheels have a diameter of "
    "{diameter}. In a curve the two turn at different rates; the mean of both is {wheel_rate}. The "
    "middle of the rear axle moves at the speed of a wheel with this rate: its radius times the "
    "rate. The wheelbase is {L}, and the steering "
    "angle of the bicycle model is {phi} (positive: to the left). Speed and steering angle stay "
    "constant. What is ψ after {time}?",
    given={
        "psi": number_range(20, 160, 10, "°"),
        "diameter": number_range(70, 110, 5, "cm"),
        "wheel_rate": number_range(2, 6, 0.5, "rad/s"),
        "L": number_range(4, 7, 0.5, "m"),
        "phi": STEERING,
        "time": number_range(2, 6, 0.5, "s"),
    },
    unknowns=(angle("ψ"),),
    right=compass,
    wrong={
        reversed_turn: lambda psi, diameter, wheel_rate, L, phi, time: (
            reversed_turn.formula.evaluate(
                y_heading=psi, v=wheel_rate * diameter / 2, wheelbase=L, steering=phi, dt=time
            )
        ),
        front_speed_used: lambda psi, diameter, wheel_rate, L, phi, time: (
            psi - too_fast(wheel_rate * diameter / 2, phi, L) * time
        ),
    },
    together={
        (reversed_turn, front_speed_used): lambda psi, diameter, wheel_rate, L, phi, time: (
            psi + too_fast(wheel_rate * diameter / 2, phi, L) * time
        ),
    },
    when=lambda diameter, wheel_rate, L, phi, time, **_: (
        abs(rate(wheel_rate * diameter / 2, phi, L) * time) < 2
    ),
    derive=lambda psi, diameter, wheel_rate, L, phi, time: {
        "v": wheel_rate * diameter / 2,
    },
    likely_slips={
        "with the diameter where the radius belongs": lambda diameter, **drive: compass(
            diameter=2 * diameter, **drive
        ),
        "with φ where tan φ belongs": lambda phi, **drive: compass(phi=np.arctan(phi), **drive),
    },
    solution=Solution(
        "The rear wheels drive the truck. The radius is half the diameter d:\n\n{speed}\n\n"
        "A truck that turns to the left turns counter-clockwise. A heading that is measured "
        "clockwise gets smaller then, so the turning rate has a minus here:\n\n{turning}\n\n"
        "After {time} the heading is:\n\n{heading}\n\nThis is {heading.value:deg}.",
        speed=Step(
            formulas.rear_speed,
            {drive.r: DIAMETER / 2, DIAMETER: "diameter", formulas.rate_rear: "wheel_rate"},
        ),
        turning=Step(formulas.y_axis, BY_PHI, part=(4,), unit="rad/s"),
        heading=Step(NEXT_HEADING, {PSI: "psi", planar.dt: "time"}),
    ),
    example={
        "psi": np.pi / 3,
        "diameter": 0.5,
        "wheel_rate": 4.0,
        "L": 7.0,
        "phi": np.pi / 6,
        "time": 7.0,
    },
)

bicycle_6 = Exercise(
    "bicycle-6",
    title="Along the arc",
    text="A car with a wheelbase of {L} starts with the middle of its rear axle at the origin and "
    "with the heading {theta}. For {time} this point drives at {v}, with a steering angle of {phi} "
    "(positive: to the left). Where is the middle of the rear axle then, and what is the heading?",
    given={
        "L": CAR,
        "theta": number_range(-60, 150, 10, "°"),
        "time": number_range(1, 3, 0.5, "s"),
        "v": number_range(1, 4, 0.5, "m/s"),
        "phi": STEERING,
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m"), angle("θ")),
    right=arc_end,
    wrong={
        sines_only: same_sines,
        front_speed_used: front_as_rear,
        same_sine: lambda **numbers: arc_end(**numbers)[[1, 1, 2]],
    },
    derive=lambda theta, v, phi, L, time: {
        "R": bicycle.turning_radius(phi, L),
        "turned": theta + rate(v, phi, L) * time,
    },
    likely_slips={
        "with φ where tan φ belongs": lambda phi, **drive: arc_end(phi=np.arctan(phi), **drive),
        "when the front axle's speed turns the car, on the circle of the right R": front_on_circle,
        "when the heading at the start is forgotten": lambda theta, **drive: arc_end(0, **drive),
        "when the car drives straight on and only then turns": lambda theta, v, phi, L, time: (
            motion.path([0, 0, theta], v, rate(v, phi, L), time, "start")[-1]
        ),
    },
    solution=Solution(
        "The car turns about a point R to its left; a negative R is to its right:\n\n{radius}\n\n"
        "Its turning rate is:\n\n{turning}\n\n"
        "It starts at the origin and moves along a circle around that point. The radius v/ω of the "
        "circle is R again:\n\n{arc}",
        radius=Step(
            formulas.turning_radius,
            BY_PHI,
            textbook=True,
            expected=lambda L, phi, **_: bicycle.turning_radius(phi, L),
        ),
        turning=Step(formulas.world, BY_PHI, part=(2,), values=(planar.omega,)),
        arc=Step(
            planar.arc_step,
            {planar.x: 0, planar.y: 0, planar.dt: "time"},
            textbook=True,
            unit=("m", "m", "rad"),
        ),
    ),
    example={"theta": np.pi / 6, "v": 2.0, "phi": np.pi / 6, "L": 2.5, "time": 2.0},
)

bicycle_7 = Exercise(
    "bicycle-7",
    title="The position that a program computes",
    text="A program computes the position of O, the middle of a car's front axle. It measures "
    + COMPASS
    + "At the start O is at the origin, and ψ is {psi}. The wheelbase is {L}. All the time the "
    "middle of the rear axle moves at {v}, and the steering angle of the bicycle model is {phi} to "
    "the left.\n\n"
    "The program takes {n} steps of {dt}. In each step it first moves O in a straight line, with "
    "the velocity that O has now. Then it changes ψ. Which position of O does it compute after the "
    "last step?",
    given={
        "psi": number_range(20, 160, 10, "°"),
        "L": CAR,
        "v": number_range(1, 4, 0.5, "m/s"),
        "phi": number_range(15, 40, 5, "°"),
        "n": one_of(2, 3),
        "dt": one_of(0.2, 0.25, 0.4, 0.5, unit="s"),
    },
    unknowns=(Unknown("x", "m"), Unknown("y", "m")),
    right=front_looped,
    wrong={
        front_speed_used: lambda psi, v, phi, L, dt, n: looped(
            np.pi / 2 - psi + phi, v / np.cos(phi), too_fast(v, phi, L), dt, n
        ),
        along_heading: lambda psi, v, phi, L, dt, n: looped(
            np.pi / 2 - psi, v / np.cos(phi), rate(v, phi, L), dt, n
        ),
        reversed_turn: lambda psi, v, phi, L, dt, n: looped(
            np.pi / 2 - psi + phi, v / np.cos(phi), -rate(v, phi, L), dt, n
        ),
        same_sine: lambda **numbers: np.full(2, front_looped(**numbers)[0]),
    },
    likely_slips={
        "for the real place of O, on its arc; asked is what the program computes": lambda **drive: (
            front_looped(method="exact", **drive)
        ),
        "when each step first changes ψ and then moves O": lambda **drive: front_looped(
            method="end", **drive
        ),
    },
    solution=Solution(
        "O moves where the front wheel points. The wheel is turned to the left, and ψ is measured "
        "to the right, so this is the direction ψ − φ from the y axis. O is faster than the rear "
        "axle:\n\n{speed}\n\nThe heading changes at the rate\n\n{turning}\n\n"
        "In each step O keeps the direction of the step's start. So the steps go in the "
        "directions\n\n{directions}\n\nIn degrees these are {directions.value:deg}. Each step "
        "has the length v_F Δt. From the y axis, x has the sine and y the cosine:\n\n{end}",
        speed=Step(formulas.front_speed, BY_PHI),
        turning=Step(formulas.y_axis, BY_PHI, part=(4,), unit="rad/s"),
        directions=Step(lambda n, **_: loop(int(n))[0], BY_PHI | {PSI: "psi"}),
        end=Step(lambda n, **_: loop(int(n))[1]),
    ),
)


def least_radius(alpha, L, b):
    """Return how far to the left of P a car turns whose front wheels are turned alike."""
    left, right = (L * np.cos(alpha) + side * b / 2 * np.sin(alpha) for side in (1, -1))
    return (left**2 + right**2) / ((left + right) * np.sin(alpha))


def circle_and_lane(L, b, phi):
    """Return the turning circle of the outer front wheel, and the width of the lane."""
    outer = np.hypot(bicycle.turning_radius(phi, L) + b / 2, L)
    return [2 * outer, bicycle.lane_width(phi, L, b)]


with as_written():
    B, ALIKE = formulas.track, dict.fromkeys((formulas.alpha_L, formulas.alpha_R), "alpha")
    LEVERS = LocalEquation(
        sp.Matrix([lever for lever, _ in formulas.levers]),
        sp.Matrix([length for _, length in formulas.levers]),
        "m",
    )
    LEAST_RADIUS = LocalEquation(R, 1 / formulas.kappa, "m")
    OUTER, CIRCLE, STEPS, ERROR, WANTED, AHEAD = sp.symbols("R_outer D N e w l")
    OUTER_CIRCLE = LocalEquation(OUTER, sp.sqrt((R + B / 2) ** 2 + L**2), "m")
    CIRCLE_AND_LANE = LocalEquation(
        sp.Matrix([CIRCLE, formulas.lane_width]), sp.Matrix([2 * OUTER, OUTER - (R - B / 2)]), "m"
    )
    MORE_STEPS = LocalEquation(STEPS, sp.Symbol("n") * ERROR / WANTED)
    DIRECTION = LocalEquation(formulas.slip, atan(AHEAD * tan(PHI) / L))

bicycle_8 = Exercise(
    "bicycle-8",
    title="The centre of least scrub",
    text="A cart has the wheelbase {L} and the track {b}. A simple steering turns both its front "
    "wheels by the same angle, {alpha} to the left. The rear wheels do not slide, but the front "
    "tyres must. The cart turns about the point for which the squares of their two slides, for "
    "each metre of the rear axle, have the least sum. How far to the left of the middle of the "
    "rear axle is this point?",
    given={
        "L": number_range(1, 2, 0.1, "m"),
        "b": number_range(0.8, 1.4, 0.1, "m"),
        "alpha": number_range(25, 45, 1, "°"),
    },
    unknowns=(Unknown("R", "m"),),
    right=least_radius,
    wrong={},
    likely_slips={
        "for a bicycle with a wheel of this angle, which is no point of least sum": (
            lambda alpha, L, b: L / np.tan(alpha)
        ),
        "for the left wheel alone": lambda alpha, L, b: L / np.tan(alpha) + b / 2,
    },
    solution=Solution(
        "As in step 1: for each metre of the rear axle the cart turns by κ, and a front tyre "
        "slides by the sine of its angle, less its lever times κ. The levers are\n\n{levers}\n\n"
        "The sum of the squares is a parabola in κ. It is least at\n\n{least}\n\n"
        "The point is one over κ away:\n\n{radius}",
        levers=Step(LEVERS, {**ALIKE, L: "L", B: "b"}),
        least=Step(formulas.least_scrub, ALIKE),
        radius=Step(LEAST_RADIUS),
    ),
)

bicycle_9 = Exercise(
    "bicycle-9",
    title="Lane and turning circle",
    text="A lorry has the wheelbase {L} and the track {b}. It is steered as far as it can be: the "
    "bicycle in it by {phi}. What is the diameter D of its turning circle, which the outer front "
    "wheel draws? And how wide is the lane w of its four wheels?",
    given={
        "L": number_range(3.5, 6, 0.1, "m"),
        "b": number_range(1.8, 2.2, 0.1, "m"),
        "phi": number_range(28, 42, 1, "°"),
    },
    unknowns=(Unknown("D", "m"), Unknown("w", "m")),
    right=circle_and_lane,
    wrong={},
    likely_slips={
        "with the radius of the circle, where its diameter is asked": lambda **lorry: [
            circle_and_lane(**lorry)[0] / 2,
            circle_and_lane(**lorry)[1],
        ],
        "with the outer rear wheel, where the front one is outside": lambda L, b, phi: [
            2 * bicycle.turning_radius(phi, L) + b,
            b,
        ],
        "with the middle of the front axle, not its outer wheel": lambda L, b, phi: [
            2 * np.hypot(bicycle.turning_radius(phi, L), L),
            np.hypot(bicycle.turning_radius(phi, L), L) - bicycle.turning_radius(phi, L) + b / 2,
        ],
    },
    solution=Solution(
        "The middle of the rear axle runs at the distance\n\n{radius}\n\nThe outer front wheel is "
        "half a track farther out, and a wheelbase ahead: a right triangle.\n\n{outer}\n\nThe "
        "turning circle is twice as wide. The inner rear wheel runs half a track inside the "
        "middle, and the lane is between the two:\n\n{both}",
        radius=Step(formulas.turning_radius, BY_PHI, textbook=True),
        outer=Step(OUTER_CIRCLE, {L: "L", B: "b"}),
        both=Step(CIRCLE_AND_LANE, {B: "b"}),
    ),
)

bicycle_10 = Exercise(
    "bicycle-10",
    title="How many steps?",
    text="A program computes a drive in equal straight steps, each along the heading at its start. "
    "With {n} steps the end of the drive is off by {error}. In how many steps must it go so that "
    "the end is off by {wanted}? Assume that the error is in proportion to the step.",
    given={
        "n": one_of(*range(10, 65, 5)),
        "error": one_of(9, 16, 18, 25, 27, 32, 36, 48, 49, 50, 64, 72, 75, unit="cm"),
        "wanted": one_of(1, 2, 3, unit="cm"),
    },
    when=lambda n, error, wanted: np.isclose(np.sqrt(error / wanted) % 1, 0, atol=1e-9),
    unknowns=(integer("N"),),
    right=lambda n, error, wanted: np.round(n * error / wanted),
    wrong={},
    likely_slips={
        "with the square: so falls the error of a single step": lambda n, error, wanted: np.round(
            n * np.sqrt(error / wanted)
        ),
    },
    solution=Solution(
        "A step of half the length has a quarter of the error. But there are twice as many, so "
        "half of the error at the end is left: it is proportional to the step, and the step is "
        "one over the number of steps. So the number grows as the error shrinks:\n\n{steps}",
        steps=Step(MORE_STEPS, {sp.Symbol("n"): "n", ERROR: "error", WANTED: "wanted"}),
    ),
)

bicycle_11 = Exercise(
    "bicycle-11",
    title="The slip angle of the middle",
    text="A program describes a car by a point M on its axis, {ahead} ahead of the middle of the "
    "rear axle. The wheelbase is {L}. The steering angle of the bicycle model is {phi} (positive: "
    "to the left). By which angle β does the direction in which M moves differ from the heading? "
    "To the left is positive.",
    given={
        "ahead": number_range(1, 1.6, 0.1, "m"),
        "L": CAR,
        "phi": STEERING,
    },
    unknowns=(Unknown("β", "rad", circle=True, tolerance=FINE),),
    right=lambda ahead, L, phi: np.arctan(ahead * np.tan(phi) / L),
    wrong={},
    likely_slips={
        "with the angle φ divided like the length; its tangent is": lambda ahead, L, phi: (
            ahead * phi / L
        ),
        "for the front axle: there it is φ": lambda ahead, L, phi: phi,
    },
    solution=Solution(
        "All points on the axis share the speed along the car. The speed sideways grows evenly, "
        "from zero at the rear axle. At the front axle the two have the ratio tan φ. So at M it "
        "is as much smaller as M is nearer to the rear axle:\n\n{direction}\n\nThis is "
        "{direction.value:deg}.",
        direction=Step(DIRECTION, {AHEAD: "ahead", PHI: "phi", L: "L"}),
    ),
)
