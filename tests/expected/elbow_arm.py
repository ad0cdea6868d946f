"""Expected values for the chapter on the elbow arm: figures, feedback, predictions."""

import numpy as np

from book.elbow_arm.figures import (
    ARM,
    BALL,
    BOARD,
    ELBOW,
    FOREARM,
    LIMITS,
    MARK,
    PLACE,
    SHELF,
    SHOULDER,
    UPPER,
)
from robokin import elbow_arm, motion

LINKS, BEYOND = (UPPER, FOREARM), "nan"
ROWS = {(1, 1): 0, (1, -1): 1, (-1, 1): 2, (-1, -1): 3}  # of the answers of `inverse`
EXERCISE = np.array([-0.18, 0.24, 0.5])  # m


def in_plane(lifted, bent):
    """Return the wrist, ahead of the shoulder and above it."""
    at = elbow_arm.forward(np.stack([0 * lifted, lifted, bent], axis=-1), *LINKS)
    return {"out": at[..., 0], "high": at[..., 2]}


def grip_readouts(turn, lifted, bent, *_):
    theta = np.stack([turn, lifted, bent], axis=-1)
    return {"off": np.linalg.norm(elbow_arm.forward(theta, *LINKS, SHOULDER) - BALL, axis=-1)}


def both(out, high):
    """Return elbow up and elbow down for a ball in the plane of the arm."""
    p = np.stack([out, 0 * out, high], axis=-1)
    return elbow_arm.inverse(p, *LINKS, unreachable=BEYOND)[..., :2, :]


def base_readouts(p_x, p_y, face):
    p = np.stack([p_x, p_y, 0.5 + 0 * p_x], axis=-1)
    turn = elbow_arm.inverse(p, *LINKS, SHOULDER)[..., 0, 0]
    return {"turn": np.where(face > 0, turn, turn + np.pi)}  # from −180° to 360°


def triangle_readouts(out, high):
    up, down = np.moveaxis(both(out, high), -2, 0)
    half = (up[..., 1] - down[..., 1]) / 2
    middle = np.where(np.isnan(half), np.nan, np.arctan2(high, out))
    return {"phi1": half % np.pi, "phi2": np.pi - down[..., 2], "phi3": middle}


def cosine_readouts(lifted, bent):
    """The upper link sees the wrist as one with an upright base sees it."""
    seen = in_plane(0 * lifted, bent)
    found = {"ahead": seen["out"], "beside": seen["high"]}
    return {**found, "lead": np.arctan2(seen["high"], seen["out"])}


def turn_round_readouts(done, *_view):
    _, facing, _, away = elbow_arm.inverse(EXERCISE, *LINKS, SHOULDER)
    away[0] -= 2 * np.pi * (away[0] > facing[0])
    first, second = np.clip(done, 0, 1), np.clip(done - 1, 0, 1)
    parts = (first, second, second)
    ways = (a + part * (b - a) for a, b, part in zip(facing, away, parts, strict=True))
    return dict(zip(("theta1", "theta2", "theta3"), ways, strict=True))


def det_j(lifted, bent):
    """Twice the area of shoulder, elbow, wrist, times the distance from the axis, and the sign."""
    theta = np.stack([0 * lifted, lifted, bent], axis=-1)
    _, shoulder, elbow, wrist = np.moveaxis(elbow_arm.joint_positions(theta, *LINKS), -2, 0)
    (a, _, b), (c, _, d) = (np.moveaxis(at - shoulder, -1, 0) for at in (elbow, wrist))
    return {"det_J": -(a * d - b * c) * c}


def spike_readouts(aside, share):
    """The rate of the base by the velocity across the line to the axis."""
    half = np.sqrt(0.36 - aside**2)
    along = share * half
    ends = np.arctan2(half, aside) - np.arctan2(-half, aside)
    return {"rate1": 0.1 * aside / np.hypot(aside, along) ** 2, "turned": ends}


def nearest_readouts(out, high):
    p = np.stack([out, 0 * out, high], axis=-1)
    return {"missed": np.linalg.norm(p - elbow_arm.nearest_reachable(p, *LINKS), axis=-1)}


def is_free(points, angles, limited):
    """Whether an arm misses shelf and floor, and is within its limits where they count."""
    free = points[:, 2, 2] > ELBOW
    for start, end in ((points[:, 1], points[:, 2]), (points[:, 2], points[:, 3])):
        rises = end[:, 2] - start[:, 2]
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (SHELF - start[:, 2]) / rises
            x, y = (start + part[:, None] * (end - start))[:, :2].T
        x_low, x_high, y_low, y_high = BOARD
        on_board = (x_low < x) & (x < x_high) & (y_low < y) & (y < y_high)
        free &= ~((part > 0) & (part < 1) & on_board)
    for angle, (low, high) in zip(angles.T, LIMITS.values(), strict=True):
        free &= ~limited | ((np.radians(low) < angle) & (angle < np.radians(high)))
    return free


def laboratory_readouts(p_x, p_y, p_z, face, bend, limits, *_view):
    p = np.stack([p_x, p_y, p_z], axis=-1)
    answers = elbow_arm.inverse(p, *LINKS, SHOULDER, unreachable=BEYOND)
    rise, far = (
        np.arctan2(p_z - SHOULDER, np.hypot(p_x, p_y)),
        np.linalg.norm(p - [0, 0, SHOULDER], axis=-1),
    )
    flat, turn = np.where(far > 0.5, 0, np.pi), np.arctan2(p_y, p_x)  # stretched, or folded
    facing, away = (turn, rise), (turn + np.pi, np.pi - rise)
    rows = [(*facing, -flat), (*facing, flat), (*away, flat), (*away, -flat)]
    straight = np.moveaxis(np.array(rows), -1, 0)
    straight[..., :2] = motion.wrap_angle(straight[..., :2])
    answers = np.where(np.isnan(answers), straight, answers)
    within = np.isfinite(elbow_arm.inverse(p, *LINKS, SHOULDER, unreachable=BEYOND)[:, 0, 0])
    points = elbow_arm.joint_positions(answers, *LINKS, SHOULDER)
    free = [is_free(points[:, k], answers[:, k, 1:], limits > 0.5) & within for k in range(4)]
    which = [ROWS[pair] for pair in zip(face.astype(int), bend.astype(int), strict=True)]
    chosen = answers[np.arange(len(p)), which]
    angles = dict(zip(("theta1", "theta2", "theta3"), chosen.T, strict=True))
    return {**angles, "off": np.linalg.norm(p - MARK, axis=-1), "left": np.sum(free, axis=0)}


def target_and_wrist(*columns):
    """Return the target, and the wrist by each mistake, which needs no angles."""
    *made, p_x, _azimuth, _elevation = columns
    (a2, a3, d1), (p_y, p_z) = ARM.values(), (at + 0 * p_x for at in PLACE.values())
    level, h = np.hypot(p_x, p_y), p_z - d1
    cosine = (level**2 + h**2 - a2**2 - a3**3) / (2 * a2 * a3)
    elbow = -np.arccos(cosine)
    shoulder = np.arctan2(h, level) - np.arctan2(a3 * np.sin(elbow), a2 + a3 * np.cos(elbow))
    far = elbow_arm.forward(np.stack([np.arctan2(p_y, p_x), shoulder, elbow], axis=-1), a2, a3, d1)
    wrists = (
        np.stack([p_y, p_x, p_z], axis=-1),  # the axes exchanged
        np.stack([np.abs(p_x), np.where(p_x < 0, -p_y, p_y), p_z], axis=-1),  # always in front
        np.stack([p_x * p_y / level, p_y * p_y / level, p_z], axis=-1),  # only p_y away
        far,
        np.stack([-p_x, -p_y, p_z], axis=-1),  # opposite
    )
    wrist = sum(one[:, None] * at for one, at in zip(made, wrists, strict=True))
    return np.stack([p_x, p_y, p_z], axis=-1), wrist


def mistakes_readouts(*columns):
    p, wrist = target_and_wrist(*columns)
    ways = {"d": p - [0, 0, 0.3], "reach": wrist - [0, 0, 0.3], "off": wrist - p}
    return {name: np.linalg.norm(way, axis=-1) for name, way in ways.items()}


def mirrored(*columns):
    """Whether the wrist is mirrored in the line between the x and the y axis."""
    p, wrist = target_and_wrist(*columns)
    return np.linalg.norm(wrist - p[:, [1, 0, 2]], axis=1) < 1e-9


def never_behind(*columns):
    return target_and_wrist(*columns)[1][:, 0] > -1e-9


def same_reach(*columns):
    return np.ptp(mistakes_readouts(*columns)["reach"]) < 1e-9


def too_far(*columns):
    found = mistakes_readouts(*columns)
    return found["reach"] > found["d"] + 0.01


def opposite(*columns):
    p, wrist = target_and_wrist(*columns)
    return np.linalg.norm(wrist[:, :2] + p[:, :2], axis=1) < 1e-9


READOUTS = {
    "grip": grip_readouts,
    "forward": in_plane,
    "base-views": base_readouts,
    "triangle": triangle_readouts,
    "one-cosine": cosine_readouts,
    "turn-round": turn_round_readouts,
    "four-countries": lambda lifted, bent, *_: {
        "out": in_plane(lifted, bent)["out"],
        **det_j(lifted, bent),
    },
    "det-j": det_j,
    "spike": spike_readouts,
    "nearest": nearest_readouts,
    "arm-laboratory": laboratory_readouts,
    "wrong-reach": mistakes_readouts,
}
WAYS = ("facing, up", "facing, down", "away, up", "away, down")
NOT_NOTICED = [
    {"mistake": "It aims at a mirror image", "p_x": 0.2},
    {"mistake": "It never looks behind", "p_x": 0.3},
    {"mistake": "Its reach never changes", "p_x": 1e-9},  # at 0 the quotient p_y/p_x has no digits
]
STRAIGHT, FOLDED = {"theta2": 0.5, "theta3": 0.0}, {"theta2": 0.5, "theta3": np.pi}
UNDER = {"p_x": 0.2, "p_y": 0.0, "p_z": 0.3}  # the shelf
SPECIALS = {
    "grip": [{"shown": float(k)} for k in range(9)],
    "forward": [STRAIGHT, FOLDED],
    "base-views": [{"facing": "away"}, {"p_x": 0.3, "p_y": 0.0}],
    "circles": [{"out": 0.42, "high": 0.56}, {"out": 0.06, "high": 0.08}, {"out": 0.8}],
    "triangle": [{"out": 0.0}, {"out": 0.8}],
    "four-countries": [{**STRAIGHT, "borders": 1}, {**FOLDED, "borders": 1}],
    "det-j": [STRAIGHT, FOLDED],
    "nearest": [{"out": 0.0, "high": 0.05}, {"out": 0.3, "high": 0.4}],
    "spike": [{"share": 0.1, "aside": 0.03}],
    "arm-laboratory": [
        *({**UNDER, "way": way, "joint_limits": on} for way in WAYS for on in ("off", "on")),
        {"p_x": 0.4, "p_y": -0.3},
    ],
    "wrong-reach": NOT_NOTICED,
}
TITLES = {
    "wrong-reach": {
        "It aims at a mirror image": mirrored,
        "It never looks behind": never_behind,
        "Its reach never changes": same_reach,
        "It reaches too far": too_far,
        "It turns round": opposite,
    }
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("triangle", {"out": 0.8}, "phi2", "none")
]


def four(turn, up, down, elbow):
    """Return all four ways of the arm by one: away, it is the same arm seen from behind."""
    facing = [[turn, up, elbow], [turn, down, -elbow]]
    return facing + [[turn + np.pi, np.pi - shoulder, -bend] for _, shoulder, bend in facing]


FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "elbow-arm-1": ({"p_x": -25, "p_y": 35}, {"M1": -0.6202, "M5": -0.9505}),
    "elbow-arm-2": (
        {"p_x": -30, "p_y": -10, "p_z": 30, "a2": 60, "a3": 40},
        {"M2": 2.6362, "M3": 2.08, "inside the triangle": 0.8128, "arccosine is missing": -0.6875},
    ),
    "elbow-arm-3": (
        {"theta1": 20, "theta2": -10, "theta3": -90, "a2": 50, "a3": 45},
        {
            "M4": [3.4907, -0.1745, -1.5708],
            "only change their sign": [3.4907, 0.1745, 1.5708],
            "shoulder stays": [3.4907, -0.1745, 1.5708],
            "elbow stays": [3.4907, 3.3161, -1.5708],
        },
    ),
    "elbow-arm-4": (
        {"d1": 30, "a2": 45, "p_x": -50, "p_y": -60, "p_z": 60},
        {
            "M2": 0.2208,
            "distance alone": 0.8367,
            "measured from the shoulder": 0.5349,
            "longest forearm": 1.2867,
        },
    ),
    "elbow-arm-5": (
        {"a2": 35, "a3": 45, "p_z": 40},
        {"M3": [2.5891, -1.7419], "inside the triangle": [2.8518, 1.0195]},
    ),
    "elbow-arm-6": (
        {"p_x": -15, "p_y": -30, "p_z": 60, "d1": 15, "a2": 60, "a3": 45},
        {
            "M1": [-2.6779, 1.7235, -2.0469],
            "M2": [-2.0344, -0.1782, -2.0944],
            "M3": [-2.0344, 1.6603, -1.8256],
            "M5": [1.1071, 1.7235, -2.0469],
            "although with atan2": [-2.0344, 2.9634, -2.0944],
            "elbow below": [-2.0344, 0.1371, 2.0469],
            "measured from the shoulder": [-2.0344, 1.7627, -1.7382],
        },
    ),
    "elbow-arm-7": (
        {"p_x": -45, "p_y": -50, "p_z": 35, "a2": 50, "a3": 55},
        {
            "M1": four(-2.4088, 1.2904, -0.3309, -1.5299),
            "M2": four(-2.3036, 0.4082, -1.6296, -1.9042),
            "M3": four(-2.3036, 1.1543, -0.1947, -1.2782),
            "M5": four(0.838, 1.2904, -0.3309, -1.5299),
            "M4": [
                [-2.3036, 1.2904, -1.5299],
                [-2.3036, -0.3309, 1.5299],
                [0.838, 1.2904, -1.5299],
                [0.838, -0.3309, 1.5299],
            ],
        },
    ),
    "elbow-arm-8": (
        {"p_x": -60, "p_y": 80, "p_z": 30, "d1": 30, "a2": 45, "a3": 35},
        {
            "ray from the base": [-0.4597, 0.613, 0.2299],
            "folded arm": [-0.06, 0.08, 0.3],
            "height is not added": [-0.48, 0.64, 0],
        },
    ),
    "elbow-arm-9": (
        {"theta3": 60, "a2": 40, "a3": 30},
        {"forearm alone": 0.5236, "wrong side": 2.0121, "between the upper link": 0.4413},
    ),
    "elbow-arm-10": (
        {"dh_theta": 120, "dh_d": 20, "dh_a": 40, "dh_alpha": -60},
        {
            "old x axis": [0.4, 0, 0.2],
            "exchanged": [-0.1, 0.1732, 0.4],
            "α in place of θ": [0.2, -0.3464, 0.2],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "straight-behind": "180°",
    "where-is-the-wrist": (
        "ahead 0.43 m, up from the shoulder 0.154 m",
        "0.148 m, 0.051 m",
        "−0.0819 m, 0.449 m",
    ),
    "how-many-directions": "two",
    "how-many-elbows": "1, 0, 1, 0",
    "how-bent": ("59.4°", "40.5°", "121°"),
    "faces-away": "164° and −90°",
    "the-other-elbow": ("shoulder θ_2 16.3°, elbow θ_3 90°", "90°, −90°"),
    "which-borders": "it does both",
    "answers-on-the-axis": "infinitely many",
    "twice-as-near": "a little larger",
}


def gripped(turned=0.0):
    """Return settings that grip the ball of the opening, with the base turned on by an angle."""
    theta1, theta2, theta3 = elbow_arm.inverse(BALL, *LINKS, SHOULDER)[0]
    return {"theta1": theta1 + turned, "theta2": theta2, "theta3": theta3}


UP, DOWN = {"way": "facing, up"}, {"way": "facing, down"}
DEGREE = np.pi / 180
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "grip": [  # 1° of the base is 7 mm
        (
            [gripped(0.03)],
            [
                gripped(0.051),
                {**gripped(), "shown": 1.0},
            ],
        ),
        ([{"shown": 5.0}], [{"shown": 4.0}]),
    ],
    "circles": [
        ([{"out": 0.707, "high": 0.0}], [{"out": 0.709, "high": 0.0}]),
        ([{"out": 0.107, "high": 0.0}], [{"out": 0.109, "high": 0.0}]),
        ([{"out": 0.091, "high": 0.0}], [{"out": 0.093, "high": 0.0}]),
    ],
    "four-dots": [
        (
            [{"out": 0.42, "high": 0.553}],
            [{"out": 0.42, "high": 0.549}, {"out": 0.09, "high": 0.7}],
        ),
        (
            [{"out": 0.06, "high": 0.087}],
            [{"out": 0.06, "high": 0.09}, {"out": 0.02, "high": 0.098}],
        ),
        ([{"out": 0.009, "high": 0.5}], [{"out": 0.011, "high": 0.5}, {"out": 0.0, "high": 0.7}]),
    ],
    "det-j": [
        ([{"theta3": 1.1 * DEGREE}], [{"theta3": 1.2 * DEGREE}, {"theta3": 179 * DEGREE}]),
        ([{"theta3": 178.9 * DEGREE}], [{"theta3": 178.8 * DEGREE}, {"theta3": 0.0}]),
        (  # r = 0.4 cos 53.13° − 0.24 = 0 at θ_2 = 126.87°, where the forearm lies at 36.87°
            [{"theta2": 2.2143 + 0.009, "theta3": -np.pi / 2}],
            [
                {"theta2": 2.2143 + 0.012, "theta3": -np.pi / 2},
                {"theta2": np.pi / 2, "theta3": 0.1},
            ],
        ),
    ],
    "nearest": [
        ([{"out": 0.805, "high": 0.0}], [{"out": 0.807, "high": 0.0}, {"out": 0.7, "high": 0.0}]),
        ([{"out": 0.079, "high": 0.0}], [{"out": 0.081, "high": 0.0}]),
    ],
    "arm-laboratory": [
        (
            [{**UNDER, **DOWN}, {**UNDER, "p_x": 0.229, **DOWN}],
            [{**UNDER, **UP}, {**UNDER, "p_x": 0.231, **DOWN}],
        ),
        (
            [{**UNDER, **DOWN, "joint_limits": "on"}],
            [{**UNDER, "way": "away, down", "joint_limits": "on"}, {**UNDER, **DOWN}],
        ),
        (  # folded by more than 150°: nearer than 0.205 m
            [{"p_x": -0.2, "p_y": 0.0, "p_z": 0.1, "joint_limits": "on"}],
            [
                {"p_x": -0.21, "p_y": 0.0, "p_z": 0.1, "joint_limits": "on"},
                {"p_x": -0.05, "p_y": 0.0, "p_z": 0.1, "joint_limits": "on"},
            ],
        ),
        ([{"p_x": -0.42, "p_y": 0.0, "p_z": 0.653}], [{"p_x": -0.42, "p_y": 0.0, "p_z": 0.645}]),
    ],
    "arm-letters": [
        (
            [{"name_1": "a_3", "name_2": "d"}],
            [{"name_1": "d", "name_2": "a_3"}, {"name_1": "a_3", "name_2": "r"}],
        )
    ],
}
