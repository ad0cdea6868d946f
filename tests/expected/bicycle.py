"""Expected values for the chapter on the bicycle model: figures, feedback, predictions."""

import numpy as np

from book.bicycle.figures import (
    ALONGSIDE,
    DURATION,
    EACH,
    FRONT,
    LENGTH,
    NARROW,
    NOSE,
    PLACE,
    REAR,
    SIDE,
    WIDTH,
)
from robokin import bicycle, motion

L, B, V = 2.5, 1.5, 2.0  # the car of the exercise
UP = np.pi / 2


def two_arcs(first, first_way, second, second_way):
    """Return the poses after the first and after the second arc backwards: (n, 3) each."""
    start = np.broadcast_to(np.array(ALONGSIDE, dtype=float), (len(first), 3))
    steering = np.stack([first, second], axis=-1)
    ways = np.stack([first_way, second_way], axis=-1)
    path = bicycle.path(start, -1.0, steering, L, ways)
    return path[:, 1], path[:, 2]


def park_readouts(first, first_way, second, second_way, done):
    end = two_arcs(first, first_way, second, second_way)[1]
    off = np.hypot(*(end[:, :2] - PLACE[:2]).T)
    return {"off": off, "turned": np.abs(motion.wrap_angle(end[:, 2]))}


CORNERS = np.array([[a, side * WIDTH / 2] for a in (REAR, FRONT) for side in (1, -1)])


def inside_out(places, pose):
    """Return the distances of places (…, 4, 2) from the outline of a car, negative inside of it."""
    along, left = (directions(pose[..., 2] + turn)[..., None, :] for turn in (0, UP))
    off = places - pose[..., None, :2]
    own = np.stack([np.sum(off * along, axis=-1), np.sum(off * left, axis=-1)], axis=-1)
    beyond = np.abs(own - [(FRONT + REAR) / 2, 0]) - [(FRONT - REAR) / 2, WIDTH / 2]
    return np.hypot(*np.moveaxis(beyond.clip(0), -1, 0)) + np.minimum(beyond.max(axis=-1), 0)


def corners_of(pose):
    along, left = (directions(pose[..., 2] + turn)[..., None, :] for turn in (0, UP))
    return pose[..., None, :2] + CORNERS[:, :1] * along + CORNERS[:, 1:] * left


def apart(one, other):
    """Return how far two cars are apart, (…), as two outlines; negative where they overlap."""
    one, other = np.broadcast_arrays(one, other)
    pairs = inside_out(corners_of(one), other), inside_out(corners_of(other), one)
    return np.concatenate(pairs, axis=-1).min(axis=-1)


def gap_readouts(first, first_way, second, second_way, done):
    middle, end = two_arcs(first, first_way, second, second_way)
    parts = np.arange(EACH + 1) / EACH
    start = np.broadcast_to(np.array(ALONGSIDE, dtype=float), (len(first), 3))
    arcs = ((start, first, first_way), (middle, second, second_way))
    way = np.concatenate(
        [
            np.stack(
                [
                    bicycle.path(pose, -1.0, phi[:, None], L, (far * k)[:, None])[:, -1]
                    for k in parts
                ],
                1,
            )
            for pose, phi, far in arcs
        ],
        axis=1,
    )
    places = {"front": NARROW[1] - REAR, "behind": NARROW[0] - FRONT}
    near = {
        name: apart(way, np.array([x, PLACE[1], 0])).min(axis=1) for name, x in places.items()
    } | {"kerb": corners_of(way)[..., 1].min(axis=(1, 2))}
    clear = {name: np.where(far > 0, far, np.nan) for name, far in near.items()}
    return clear | {"turned": np.abs(motion.wrap_angle(end[:, 2]))}


def axles_readouts(left, right):
    alpha = np.stack([left, right], axis=-1)
    outwards = np.sin(alpha)
    turning = np.cos(alpha) * L + np.sin(alpha) * [B / 2, -B / 2]
    with np.errstate(divide="ignore"):
        return {"R": np.sum(turning**2, axis=-1) / np.sum(outwards * turning, axis=-1)}


def circles_readouts(kappa):
    left, right = bicycle.ackermann(np.arctan(L * kappa), L, B).T
    with np.errstate(divide="ignore"):
        return {"alpha_L": left, "alpha_R": right, "R": 1 / kappa}


def slide_readouts(together):
    angles = bicycle.ackermann(np.arctan(L / 4), L, B)
    crossings = [L / np.tan(a) for a in (angles[0], np.arctan(L / 4), angles[1])]
    places = [side * B / 2 * (1 - together) for side in (1, 0, -1)]
    return {f"at_{k}": (c + p) / L for k, (c, p) in enumerate(zip(crossings, places, strict=True))}


def point_readouts(x, y):
    rear, front = (
        twist(V, np.arctan(L / 4), L) for twist in (bicycle.body_twist, bicycle.front_twist)
    )
    forward, aside = rear[0] + rear[2] * x, front[1] * y / L
    return {"speed": np.hypot(forward, aside), "slip": np.arctan2(aside, forward)}


def trapezoid_readouts(inner, gamma):
    p, out = 0.2, np.empty_like(inner)
    low, high = np.full_like(inner, -1.0), np.full_like(inner, 1.0)
    for _ in range(80):  # bisect the outer wheel's angle until the rod has its length
        out = (low + high) / 2
        one = p * np.stack([np.sin(inner + gamma), -np.cos(inner + gamma)]) - [[B / 2], [0]]
        two = p * np.stack([np.sin(out - gamma), -np.cos(out - gamma)]) + [[B / 2], [0]]
        long = np.hypot(*(two - one)) > B - 2 * p * np.sin(gamma)
        low, high = np.where(long, low, out), np.where(long, out, high)
    with np.errstate(divide="ignore"):
        wanted = np.arctan(1 / (1 / np.tan(inner) + B / L))
    return {"wanted": wanted, "off": out - wanted}


def steps_readouts(count):
    """Return the errors of one straight step of O, and of all."""
    found, phi = [], np.pi / 6
    for n in count.astype(int):
        step = np.full(n, DURATION / n)
        rear = bicycle.path([0, 0, UP], V, phi, LENGTH, step)
        exact = (rear[:, :2] + LENGTH * directions(rear[:, 2]))[1:]
        steps = V / np.cos(phi) * step[:, None] * directions(rear[:-1, 2] + phi)
        found.append(
            [np.hypot(*off) for off in (steps.cumsum(0) + np.array([0, LENGTH]) - exact)[[0, -1]]]
        )
    return dict(zip(("one", "apart"), np.transpose(found), strict=True))


def conventions_readouts(rear, front, t):
    start = np.array([0, -LENGTH, UP]) + 0 * t[:, None]  # O is at the origin then
    pose = bicycle.path(start, V, np.pi / 6, LENGTH, t[:, None])[:, -1]
    O = pose[:, :2] + LENGTH * directions(pose[:, 2])  # noqa: E741
    x, y = (np.where(rear > 0, pose[:, k], O[:, k]) for k in (0, 1))
    return {"x": x, "y": y, "heading": np.where(rear > 0, pose[:, 2], UP - pose[:, 2])}


def lab_readouts(is_long, phi, way):
    long = np.where(is_long > 0, LENGTH, L)
    radius = bicycle.turning_radius(phi, long)
    return {
        "R": radius,
        "street": np.abs(radius) + B / 2 + np.hypot(np.abs(radius) + B / 2, long),
        "w": bicycle.lane_width(phi, long, B),
        "heading": way * bicycle.body_twist(1.0, phi, long)[:, 2],
    }


def corner_readouts(before, phi, parts):
    radius = bicycle.turning_radius(phi, LENGTH)
    cut = np.hypot(radius - 3.5, before) - (radius - SIDE)
    over = np.hypot(radius + SIDE, NOSE) - before - 7
    return {"cut": np.maximum(cut, 0), "over": np.maximum(over, 0)}


def directions(heading):
    """Return unit vectors: (…) → (…, 2)."""
    return np.stack([np.cos(heading), np.sin(heading)], axis=-1)


def moved(*columns):
    """Return the real and the believed way of an axle: the rear one, or the front one where the
    mistake is made in its way."""
    *made, phi, t = columns
    L, b, v = 2.5, 2.0, 2.0
    start = np.broadcast_to([0, 0, np.pi / 2], (len(t), 3))
    rate = bicycle.body_twist(v, phi, L)[:, 2]
    alone = bicycle.body_twist(v, bicycle.ackermann(phi, L, b).mean(axis=-1), L)[:, 2]
    rates = rate, rate / np.cos(phi), alone, -rate
    rear, fast, mean, right = (motion.arc_step(start, v, each, t) for each in rates)
    x, turned = rear[:, 0], rear[:, 2]
    front = rear + np.column_stack([L * (directions(turned) - [0, 1]), 0 * t])  # from its start
    straight, diagonal = np.stack([x, -x, turned], axis=-1), front[:, [1, 1, 2]]
    nose = rear / np.stack([np.cos(phi), np.cos(phi), 1 + 0 * t], axis=-1)
    ends = straight, fast, nose, diagonal, mean, right
    pairs = zip(made, ends, (rear, rear, front, front, rear, rear), strict=True)
    chosen = [(one[:, None] * true, one[:, None] * end) for one, end, true in pairs]
    return [sum(each) for each in zip(*chosen, strict=True)]


def mistakes_readouts(*columns):
    real, believed = moved(*columns)
    off = believed - real
    return {"apart": np.hypot(*off[:, :2].T), "off": motion.wrap_angle(off[:, 2])}


def goes_straight(*columns):
    way = moved(*columns)[1]
    return np.abs(way[:, 0] + way[:, 1]) < 1e-9


def turns_too_fast(*columns):
    """Whether the program believes in a sharper turn, to the left."""
    real, believed = moved(*columns)
    return believed[:, 2] > real[:, 2] + 0.01


def follows_its_nose(*columns):
    """Whether it is an arc along the heading at the start, whose chord has the middle heading."""
    way = moved(*columns)[1]
    along = directions((np.pi / 2 + way[:, 2]) / 2)
    return np.abs(way[:, 0] * along[:, 1] - way[:, 1] * along[:, 0]) < 1e-9


def only_diagonal(*columns):
    way = moved(*columns)[1]
    return np.abs(way[:, 0] - way[:, 1]) < 1e-9


def other_side(*columns):
    real, believed = moved(*columns)
    return real[:, 0] * believed[:, 0] < 0


DEGREE = np.pi / 180
AHEAD = {"steering": 0.0}
READOUTS = {
    "park-car": park_readouts,
    "axles": axles_readouts,
    "wheel-circles": circles_readouts,
    "one-wheel": slide_readouts,
    "every-point": point_readouts,
    "trapezoid": trapezoid_readouts,
    "bicycle-steps": steps_readouts,
    "conventions": conventions_readouts,
    "car-laboratory": lab_readouts,
    "street-corner": corner_readouts,
    "narrow-gap": gap_readouts,
    "wrong-car": mistakes_readouts,
}
SPECIALS = {
    "park-car": [{"steering_1": 0.0, "steering_2": 0.0}],
    "axles": [{"alpha_L": 0.0, "alpha_R": 0.0}],
    "car-world": [AHEAD],
    "ackermann-steering": [AHEAD],
    "trapezoid": [{"alpha_L": 0.0}],
    "bicycle-steps": [{"n": 1}],
    "centre-under": [AHEAD, {"steering": 80 * DEGREE}, {"steering": -80 * DEGREE}],
    "car-laboratory": [AHEAD, {**AHEAD, "vehicle": "long, L 7 m"}],
    "narrow-gap": [{"steering_1": -0.5, "steering_2": 0.5}],
    "wrong-car": [{"t": 0.0}, {"mistake": "Only along a diagonal", "t": 1.0}],
}
TITLES = {
    "wrong-car": {
        "Off its circle": goes_straight,
        "It turns too fast": turns_too_fast,
        "It follows its nose": follows_its_nose,
        "Only along a diagonal": only_diagonal,
        "One wheel for two": None,
        "To the other side": other_side,
    }
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("axles", {"alpha_L": 0.0, "alpha_R": 0.0}, "R", "∞"),
    ("ackermann-steering", AHEAD, "R", "∞"),
    ("centre-under", {"steering": 80 * DEGREE}, "w", "no lane"),
    ("car-laboratory", AHEAD, "R", "none: straight ahead"),
    ("narrow-gap", {"way_2": 5.0}, "behind", "touches"),
]
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "bicycle-1": (
        {"L": 1, "phi": 15, "v_front": 3},
        {"M16": 0.8038, "cosine where the sine": 2.8978},
    ),
    "bicycle-2": ({"alpha_L": 37, "alpha_R": 28}, {"M18": 0.5672, "mean of the tangents": 0.5712}),
    "bicycle-3": (
        {"theta": 130, "v": 3.5, "phi": 40},
        {
            "M17": [-2.9368, 3.5],
            "M33": [0.7934, 0.7934],
            "speed of the rear axle": [-3.4468, 0.6078],
            "as the car sees it": [3.5, 2.9368],
        },
    ),
    "bicycle-4": ({"alpha_L": 35, "phi": 30}, {"M18": 0.4363, "mean of the tangents": 0.4266}),
    "bicycle-5": (
        {"psi": 60, "diameter": 75, "wheel_rate": 5.5, "L": 5, "phi": 25, "time": 4.5},
        {
            "M32": 1.9128,
            "M16": 0.0921,
            "diameter where the radius": -0.684,
            "φ where tan φ": 0.2373,
        },
    ),
    "bicycle-6": (
        {"L": 2.5, "theta": -60, "time": 2, "v": 2, "phi": -25},
        {
            "M15": [0.5861, -0.5861, -1.7933],
            "M16": [0.4345, -3.8636, -1.8704],
            "M33": [-3.8637, -3.8637, -1.7933],
            "φ where tan φ": [0.6806, -3.8597, -1.7453],
            "on the circle of the right R": [0.4794, -4.2631, -1.8704],
            "heading at the start": [3.6391, -1.4242, -0.7461],
            "only then turns": [2, -3.4641, -1.7933],
        },
    ),
    "bicycle-8": (
        {"L": 1.5, "b": 1.0, "alpha": 35},
        {"bicycle with a wheel": 2.1422, "left wheel alone": 2.6422},
    ),
    "bicycle-9": (
        {"L": 5, "b": 2, "phi": 35},
        {
            "radius of the circle": [9.5536, 3.4129],
            "outer rear wheel": [16.2815, 2],
            "middle of the front axle": [17.4345, 2.5765],
        },
    ),
    "bicycle-10": ({"n": 20, "error": 50, "wanted": 2}, {"single step": 100}),
    "bicycle-11": (
        {"ahead": 1.2, "L": 2.5, "phi": 35},
        {"divided like the length": 0.2932, "front axle": 0.6109},
    ),
    "bicycle-7": (
        {"psi": 130, "L": 2.5, "v": 1.5, "phi": 35, "n": 3, "dt": 0.4},
        {
            "M16": [2.1516, 0.2548],
            "M17": [1.878, -1.1006],
            "M32": [2.1062, -0.5497],
            "M33": [2.1697, 2.1697],
            "real place of O": [2.1447, 0.3567],
            "first changes ψ": [2.1097, 0.5361],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "where-it-turned": "15 cm to the left",
    "undo-a-move": "first turn back, then go back",
    "which-mean": "of their cotangents",
    "turned-alike": "nowhere",
    "another-track": ("2", "1.9", "1.6"),
    "the-front-axle": "faster, where its wheel points",
    "rule-of-thumb": "only nearly",
    "where-after-arc": ("x −1.84 m, y 3.37 m", "0 m, 4 m", "0 m, 2.5 m"),
    "twice-the-steps": "a half",
    "how-wide": ("3.28 m", "1.88 m", "1.5 m"),
}
PARKED = {"steering_1": -32 * DEGREE, "way_1": 2.9, "steering_2": 32 * DEGREE, "way_2": 2.9}
SQUEEZED = {"steering_1": -34 * DEGREE, "way_1": 2.8, "steering_2": 35 * DEGREE, "way_2": 2.75}
ROUND = {"steering": 35 * DEGREE, "way_driven": 11.2}
LANE = {"vehicle": "long, L 7 m", "steering": 25 * DEGREE, "way_driven": 23.6}
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "park-car": [
        (
            [PARKED, PARKED | {"way_2": 2.95}],
            [
                PARKED | {"way_2": 3.05},
                PARKED | {"way_1": 3.1},
                PARKED | {"steering_2": 30 * DEGREE},
            ],
        )
    ],
    "axles": [
        (
            [{"alpha_L": 38 * DEGREE, "alpha_R": 28 * DEGREE}],
            [{"alpha_L": 38 * DEGREE, "alpha_R": 30 * DEGREE}, {"alpha_L": 0.0, "alpha_R": 0.0}],
        )
    ],
    "wheel-circles": [
        ([{"kappa": 1 / 3.21}, {"kappa": 1 / 3.29}], [{"kappa": 0.3}, {"kappa": 0.32}])
    ],
    "every-point": [
        (
            [{"place_x": -0.86, "place_y": 0.0}, {"place_x": -0.84, "place_y": 0.4}],
            [{"place_x": -0.7, "place_y": 0.0}, {"place_x": -0.86, "place_y": 0.7}],
        )
    ],
    "trapezoid": [
        (
            [{"arm_angle": 22 * DEGREE}, {"arm_angle": 21.5 * DEGREE}],
            [{"arm_angle": 20.5 * DEGREE}, {"arm_angle": 23 * DEGREE}],
        )
    ],
    "swept-lane": [
        (
            [{"steering": 25 * DEGREE}, {"steering": 25.5 * DEGREE}],
            [{"steering": 24 * DEGREE}, {"steering": 27 * DEGREE}],
        )
    ],
    "centre-under": [
        (
            [{"steering": 73.3 * DEGREE}, {"steering": 73.0 * DEGREE}],
            [{"steering": 72 * DEGREE}, {"steering": 74.5 * DEGREE}],
        )
    ],
    "car-laboratory": [
        (
            [ROUND, ROUND | {"way_driven": 11.4}],
            [
                ROUND | {"way_driven": 11.6},
                ROUND | {"steering": 34 * DEGREE, "way_driven": 11.6},
                ROUND | {"steering": -35 * DEGREE},
            ],
        ),
        (
            [LANE, LANE | {"way_driven": 24.0}],
            [
                LANE | {"way_driven": 22.0},
                LANE | {"steering": 26 * DEGREE, "way_driven": 22.5},
                LANE | {"vehicle": "car, L 2.5 m"},
            ],
        ),
    ],
    "street-corner": [
        (
            [{"before": 5.2, "steering": 40 * DEGREE}, {"before": 5.6, "steering": 40 * DEGREE}],
            [{"before": 4.8, "steering": 40 * DEGREE}, {"before": 6.2, "steering": 40 * DEGREE}],
        )
    ],
    "narrow-gap": [
        (
            [SQUEEZED, SQUEEZED | {"way_2": 2.7}],
            [SQUEEZED | {"way_2": 2.8}, SQUEEZED | {"steering_1": -30 * DEGREE}],
        )
    ],
    "car-letters": [
        (
            [{"name_1": "R", "name_2": "φ"}],
            [{"name_1": "φ", "name_2": "R"}, {"name_1": "R", "name_2": "L"}],
        )
    ],
}
