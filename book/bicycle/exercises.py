"""Exercises on the bicycle model of a car, and the mistakes that are made there."""

import numpy as np

from robokin import bicycle, motion
from workshop.practice import Ask, Exercise, Mistake, angle, one_of, steps

M15 = Mistake(
    "M15",
    says="with the difference of the sines in both rows of the arc, where y needs the cosines",
    line="end = [R * (np.sin(turned) - np.sin(theta)),\n"
    "       -R * (np.sin(turned) - np.sin(theta)), turned]",
    why="The car moves along x with v cos θ and along y with v sin θ. Summed up over time, the "
    "first gives a difference of sines, the second one of cosines. Only y comes out wrong.",
    unnoticed="Where the heading halfway along the arc is 135° or −45°, and after a full circle.",
    document="000 Q5",
    stands="y(t + δt) = y − R (sin(θ + ωδt) − sin θ)",
    should="y(t + δt) = y − R (cos(θ + ωδt) − cos θ)",
)
M16 = Mistake(
    "M16",
    says="when the front axle's speed is put where the rear axle's speed belongs",
    line="omega = v_front * np.tan(phi) / L",
    why="The formula v tan φ/L holds for the speed v of the rear axle. The front axle is faster, "
    "v_f = v/cos φ. For its speed the formula is v_f sin φ/L.",
    unnoticed="Straight ahead. For small steering angles it is hard to see: 1.5 % at 10°.",
    document="004 Ans 1",
    stands="θ̇ = v_s sec α tan α/L",
    should="θ̇ = v_s tan α/L",
)
M17 = Mistake(
    "M17",
    says="when the front axle is sent along the heading of the car, not along its steered wheel",
    line="velocity = [v_front * np.cos(theta), v_front * np.sin(theta)]",
    why="The steered wheel rolls where it points, and that is θ + φ. Only the rear axle moves "
    "along the heading θ.",
    unnoticed="Straight ahead, where the wheel points along the heading.",
    document="004 Ans 1",
    stands="ẋ = v_O sin φ, ẏ = v_O cos φ (heading φ from the y axis, v_O at the front axle)",
    should="ẋ = v_O sin(φ − α), ẏ = v_O cos(φ − α) (steering α to the left)",
)
M18 = Mistake(
    "M18",
    says="when the two steering angles are averaged, where their cotangents must be",
    line="phi = (alpha_L + alpha_R) / 2",
    why="The three axles meet in one point. This makes the distances R − l/2, R and R + l/2 "
    "evenly spaced, and they go with the cotangents of the angles, not with the angles.",
    unnoticed="When both angles are equal. Otherwise the mean is near, but never right.",
)
M32 = Mistake(
    "M32",
    says="when a heading that is measured from the y axis, clockwise, grows in a left turn",
    line="heading = psi + v * np.tan(phi) / L * time",
    why="A heading that is measured clockwise gets smaller when the car turns to the left. It "
    "changes by −ωδt, not by +ωδt.",
    unnoticed="On a straight line, where the heading does not change.",
    document="004 Ans 1",
    stands="φ(t + Δt) = φ + φ̇Δt with φ̇ = +v tan α/L (heading φ from the y axis)",
    should="φ(t + Δt) = φ + φ̇Δt with φ̇ = −v tan α/L (steering α to the left)",
)
M33 = Mistake(
    "M33",
    says="with the same sine for ẋ and for ẏ",
    line="velocity = [v_front * np.sin(theta + phi), v_front * np.sin(theta + phi)]",
    why="One of the two needs the cosine. With the same sine in both, ẋ and ẏ are always equal: "
    "the car could move along one diagonal only.",
    unnoticed="When the motion is along that diagonal, at 45° or at −135° to the x axis.",
    document="004 Ans 1",
    stands="ẋ = 0.25 w sec α sin φ, ẏ = 0.25 w sec α sin φ",
    should="ẋ = 0.25 w sec α sin(φ − α), ẏ = 0.25 w sec α cos(φ − α)",
)


def rate(v, phi, L):
    """The turning rate for the rear axle's speed."""
    return bicycle.body_twist(v, phi, L)[2]


def spread(alpha_L, alpha_R):
    """What two steering angles mean for the car: the front wheels' distance by the wheelbase."""
    return 1 / np.tan(alpha_R) - 1 / np.tan(alpha_L)


def other_track(alpha_L, phi):
    """The front wheels' distance by the wheelbase, from the left wheel and the bicycle's wheel."""
    return 2 * (1 / np.tan(phi) - 1 / np.tan(alpha_L))


def compass(psi, diameter, wheel_rate, L, phi, time):
    """The heading after some time, measured clockwise."""
    return psi - rate(wheel_rate * diameter / 2, phi, L) * time


def arc_end(theta, v, phi, L, time):
    """The pose after an arc from the origin."""
    return bicycle.path([0, 0, theta], v, phi, L, time)[-1]


def same_sines(theta, v, phi, L, time):
    """M15: the sines' difference in y too."""
    x, _, turned = arc_end(theta, v, phi, L, time)
    return [x, -x, turned]


def front_as_rear(theta, v, phi, L, time):
    """M16: the front axle's speed turns the car."""
    return motion.arc_step([0, 0, theta], v, rate(v / np.cos(phi), phi, L), time)


def looped(direction, speed, omega, dt, n, method="start"):
    """Where a point is after n straight steps: speed, direction at the start, its turning rate."""
    return motion.path([0, 0, direction], speed, omega, np.full(int(n), dt), method)[-1, :2]


def front_looped(psi, v, phi, L, dt, n, method="start"):
    """Where the loop takes the front axle, with a heading that is measured clockwise."""
    return looped(np.pi / 2 - psi + phi, v / np.cos(phi), rate(v, phi, L), dt, n, method)


NEAR_MEAN = "four decimals are asked for: the mean of the two angles can be as near as 0.001"
CAR = steps(2.4, 3, 0.1, "m")
STEERING = one_of(*(sign * size for sign in (1, -1) for size in (15, 20, 25, 30, 35, 40)), unit="°")


bicycle_1 = Exercise(
    "bicycle-1",
    level=1,
    title="A speedometer on the front wheel",
    text="The wheels of a bicycle touch the floor {L} from each other. The front wheel is turned "
    "by {phi} to the left. A speedometer on the front wheel shows {v_front}. How fast does the "
    "bicycle turn?",
    given={
        "L": steps(0.9, 1.2, 0.05, "m"),
        "phi": steps(15, 45, 5, "°"),
        "v_front": steps(1, 5, 0.5, "m/s"),
    },
    asks=(Ask("ω", "rad/s"),),
    right=lambda L, phi, v_front: rate(v_front * np.cos(phi), phi, L),
    wrong={M16: lambda L, phi, v_front: v_front * np.tan(phi) / L},
    derive=lambda L, phi, v_front: {"v": v_front * np.cos(phi)},
    also={
        "with the cosine where the sine belongs": lambda v_front, phi, L: v_front * np.cos(phi) / L,
    },
    solution="The front wheel moves at v_f = {v_front}, along the bicycle and sideways at once. "
    "The part along the bicycle is the speed of the rear wheel, v = v_f cos φ = {v} m/s. The "
    "part sideways, v_f sin φ, turns the bicycle about its rear wheel, {L} behind:\n\n"
    "ω = v_f sin φ/L = v tan φ/L = {right}",
    example={"L": 7.0, "phi": np.pi / 6, "v_front": 1.0},
)

bicycle_2 = Exercise(
    "bicycle-2",
    level=1,
    title="One wheel in place of two",
    text="A car turns to the left. Its left front wheel is turned by {alpha_L}, its right front "
    "wheel by {alpha_R}. By which angle φ is the front wheel of a bicycle turned that drives the "
    "same curve? Give four decimals.",
    given={"alpha_L": steps(18, 42, 1, "°"), "alpha_R": steps(14, 36, 1, "°")},
    asks=(Ask("φ", "rad", circle=True, tolerance=1e-4, reason=NEAR_MEAN),),
    right=lambda alpha_L, alpha_R: bicycle.equivalent_steering(alpha_L, alpha_R),
    wrong={M18: lambda alpha_L, alpha_R: (alpha_L + alpha_R) / 2},
    when=lambda alpha_L, alpha_R: 0.3 < spread(alpha_L, alpha_R) < 0.9,
    derive=lambda alpha_L, alpha_R: {
        "cot_L": 1 / np.tan(alpha_L),
        "cot_R": 1 / np.tan(alpha_R),
        "cot": (1 / np.tan(alpha_L) + 1 / np.tan(alpha_R)) / 2,
    },
    also={
        "with the mean of the tangents, not of the cotangents": lambda alpha_L, alpha_R: np.arctan(
            (np.tan(alpha_L) + np.tan(alpha_R)) / 2
        ),
    },
    solution="All axles meet in one point, R to the left of the middle of the rear axle. With "
    "the wheelbase L, and the front wheels l apart:\n\n"
    "L cot α_L = R − l/2, L cot α_R = R + l/2, L cot φ = R\n\n"
    "R is the mean of the other two, so the cotangents are averaged, not the angles:\n\n"
    "cot φ = ({cot_L} + {cot_R})/2 = {cot}, so φ = {right}",
    example={"alpha_L": np.radians(35), "alpha_R": np.radians(29)},
)

bicycle_3 = Exercise(
    "bicycle-3",
    level=2,
    title="Where does the front axle go?",
    text="A car has the heading {theta}. The middle of its rear axle moves forward at {v}. The "
    "steering angle of its bicycle model is {phi} (positive: to the left). What is the velocity "
    "of the middle of its front axle in the world, along x and y?",
    given={"theta": steps(10, 170, 10, "°"), "v": steps(0.5, 5, 0.5, "m/s"), "phi": STEERING},
    asks=(Ask("ẋ", "m/s"), Ask("ẏ", "m/s")),
    right=lambda theta, v, phi: motion.to_world(theta, bicycle.front_twist(v, phi, 1.0))[:2],
    wrong={
        M17: lambda theta, v, phi: np.multiply(v / np.cos(phi), [np.cos(theta), np.sin(theta)]),
        M33: lambda theta, v, phi: np.full(2, v / np.cos(phi) * np.sin(theta + phi)),
    },
    derive=lambda theta, v, phi: {"v_front": v / np.cos(phi), "direction": theta + phi},
    also={
        "with the speed of the rear axle": lambda theta, v, phi: [
            v * np.cos(theta + phi),
            v * np.sin(theta + phi),
        ],
        "as the car sees it; asked is the world": lambda theta, v, phi: [v, v * np.tan(phi)],
    },
    solution="The front wheel rolls where it points, in the direction θ + φ = {direction:deg}. "
    "Car and wheel share the part of the speed that is along the car: v = v_f cos φ, so "
    "v_f = v/cos φ = {v_front} m/s. Hence\n\n"
    "[v_f cos(θ + φ), v_f sin(θ + φ)] = {right}",
    example={"theta": np.pi / 2, "v": 1.0, "phi": np.pi / 6},
)

bicycle_4 = Exercise(
    "bicycle-4",
    level=2,
    title="The outer wheel",
    text="You design the steering of a car. When its left front wheel is turned by {alpha_L} to "
    "the left, the car must turn like a bicycle whose front wheel is turned by {phi} to the "
    "left. By which angle must the right front wheel be turned, so that no wheel slips? Give four "
    "decimals.",
    given={"alpha_L": steps(18, 42, 1, "°"), "phi": steps(16, 39, 1, "°")},
    asks=(Ask("α_R", "rad", circle=True, tolerance=1e-4, reason=NEAR_MEAN),),
    right=lambda alpha_L, phi: bicycle.ackermann(phi, 1.0, other_track(alpha_L, phi))[1],
    wrong={M18: lambda alpha_L, phi: 2 * phi - alpha_L},
    when=lambda alpha_L, phi: phi < alpha_L and 0.3 < other_track(alpha_L, phi) < 0.9,
    derive=lambda alpha_L, phi: {
        "cot_L": 1 / np.tan(alpha_L),
        "cot": 1 / np.tan(phi),
        "cot_R": 2 / np.tan(phi) - 1 / np.tan(alpha_L),
    },
    also={
        "with the mean of the tangents, not of the cotangents": lambda alpha_L, phi: np.arctan(
            2 * np.tan(phi) - np.tan(alpha_L)
        ),
    },
    solution="The cotangent of the bicycle's angle is the mean of the cotangents of the two "
    "wheels, because the centre of the turn is at the distances R − l/2, R and R + l/2. Solve for "
    "the right one:\n\n"
    "cot α_R = 2 cot φ − cot α_L = 2 · {cot} − {cot_L} = {cot_R}, so α_R = {right}",
)

bicycle_5 = Exercise(
    "bicycle-5",
    level=2,
    title="A heading as on a compass",
    text="A truck measures its heading ψ as a compass does: clockwise, from the y axis. With "
    "ψ = 90° it looks along x. Now ψ is {psi}. The rear wheels have a diameter of {diameter} and "
    "turn at {wheel_rate}. The wheelbase is {L}, and the steering angle of the bicycle model is "
    "{phi} (positive: to the left). What is ψ after {time}?",
    given={
        "psi": steps(20, 160, 10, "°"),
        "diameter": steps(40, 100, 10, "cm"),
        "wheel_rate": steps(2, 6, 0.5, "rad/s"),
        "L": steps(4, 7, 0.5, "m"),
        "phi": STEERING,
        "time": steps(2, 6, 0.5, "s"),
    },
    asks=(angle("ψ"),),
    right=compass,
    wrong={
        M32: lambda psi, **numbers: 2 * psi - compass(psi, **numbers),
        M16: lambda psi, phi, **numbers: (
            psi + (compass(psi, phi=phi, **numbers) - psi) / np.cos(phi)
        ),
    },
    when=lambda diameter, wheel_rate, L, phi, time, **_: (
        abs(rate(wheel_rate * diameter / 2, phi, L) * time) < 2
    ),
    derive=lambda psi, diameter, wheel_rate, L, phi, time: {
        "v": wheel_rate * diameter / 2,
        "omega": rate(wheel_rate * diameter / 2, phi, L),
    },
    also={
        "with the diameter where the radius belongs": lambda diameter, **drive: compass(
            diameter=2 * diameter, **drive
        ),
        "with φ where tan φ belongs": lambda phi, **drive: compass(phi=np.arctan(phi), **drive),
    },
    solution="The rear wheels drive the truck at v = rate times radius = {v} m/s. It turns at "
    "ω = v tan φ/L = {omega} rad/s; a positive ω is counter-clockwise, to the left. A heading "
    "that is measured clockwise changes the other way:\n\nψ − ω · {time:} s = {right}",
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
    level=3,
    title="Along the arc",
    text="A car with a wheelbase of {L} starts with the middle of its rear axle at the origin and "
    "with the heading {theta}. For {time} its rear axle drives at {v}, with a steering angle of "
    "{phi} (positive: to the left). Where is the middle of the rear axle then, and what is the "
    "heading?",
    given={
        "L": CAR,
        "theta": steps(-60, 150, 10, "°"),
        "time": steps(1, 3, 0.5, "s"),
        "v": steps(1, 4, 0.5, "m/s"),
        "phi": STEERING,
    },
    asks=(Ask("x", "m"), Ask("y", "m"), angle("θ")),
    right=arc_end,
    wrong={
        M15: same_sines,
        M16: front_as_rear,
        M33: lambda **numbers: arc_end(**numbers)[[1, 1, 2]],
    },
    derive=lambda theta, v, phi, L, time: {
        "R": bicycle.turning_radius(phi, L),
        "omega": rate(v, phi, L),
        "turned": theta + rate(v, phi, L) * time,
    },
    also={
        "with φ where tan φ belongs": lambda phi, **drive: arc_end(phi=np.arctan(phi), **drive),
        "when the heading at the start is forgotten": lambda theta, **drive: arc_end(0, **drive),
        "when the car drives straight on and only then turns": lambda theta, v, phi, L, time: (
            motion.path([0, 0, theta], v, rate(v, phi, L), time, "start")[-1]
        ),
    },
    solution="The car turns about a point R = L/tan φ = {R} m to its left; a negative R is to the "
    "right. It turns at ω = v/R = {omega} rad/s, so its heading ends at θ' = θ + ω · {time:} = "
    "{turned} rad ({turned:deg}). It moves along a circle around that point:\n\n"
    "[R (sin θ' − sin θ), −R (cos θ' − cos θ), θ'] = {right}",
    example={"theta": np.pi / 6, "v": 2.0, "phi": np.pi / 6, "L": 2.5, "time": 2.0},
)

bicycle_7 = Exercise(
    "bicycle-7",
    level=3,
    title="What the loop says",
    text="A program follows O, the middle of a car's front axle. It measures the heading ψ as a "
    "compass does: clockwise, from the y axis. At the start O is at the origin, and ψ is {psi}. "
    "The wheelbase is {L}. All the time the rear axle moves at {v}, and the steering angle is "
    "{phi} to the left.\n\n"
    "The program takes {n} steps of {dt}. In each step it moves O straight on with the velocity "
    "that O has at the start of the step, and then it changes ψ. Where is O after the last step, "
    "as the program says?",
    given={
        "psi": steps(20, 160, 10, "°"),
        "L": CAR,
        "v": steps(1, 4, 0.5, "m/s"),
        "phi": steps(15, 40, 5, "°"),
        "n": one_of(2, 3),
        "dt": one_of(0.2, 0.25, 0.4, 0.5, unit="s"),
    },
    asks=(Ask("x", "m"), Ask("y", "m")),
    right=front_looped,
    wrong={
        M16: lambda psi, v, phi, L, dt, n: looped(
            np.pi / 2 - psi + phi, v / np.cos(phi), rate(v / np.cos(phi), phi, L), dt, n
        ),
        M17: lambda psi, v, phi, L, dt, n: looped(
            np.pi / 2 - psi, v / np.cos(phi), rate(v, phi, L), dt, n
        ),
        M32: lambda psi, v, phi, L, dt, n: looped(
            np.pi / 2 - psi + phi, v / np.cos(phi), -rate(v, phi, L), dt, n
        ),
        M33: lambda **numbers: np.full(2, front_looped(**numbers)[0]),
    },
    derive=lambda psi, v, phi, L, dt, n: {
        "v_O": v / np.cos(phi),
        "change": -rate(v, phi, L) * dt,
        "first": psi - phi,
        "directions": "; ".join(
            f"{np.degrees(psi - phi - k * rate(v, phi, L) * dt):.1f}°".replace("-", "−")
            for k in range(int(n))
        ),
    },
    also={
        "for the real place of O, on its arc; asked is what the loop says": lambda **drive: (
            front_looped(method="exact", **drive)
        ),
        "when each step first changes ψ and then moves O": lambda **drive: front_looped(
            method="end", **drive
        ),
    },
    solution="O moves where the front wheel points. The wheel is turned to the left, and ψ is "
    "measured to the right, so this is the direction ψ − φ = {first:deg} from the y axis. O is "
    "faster than the rear axle: v_O = v/cos φ = {v_O} m/s. In each step ψ changes by −v tan φ/L · "
    "{dt:} = {change} rad ({change:deg}). So the steps go in the directions {directions}.\n\n"
    "Each step adds [v_O sin(ψ − φ), v_O cos(ψ − φ)] times {dt:}; from the y axis, x has the "
    "sine. After {n} steps: {right}",
)
