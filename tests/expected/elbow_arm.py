"""Expected values for the chapter on the elbow arm: figures, feedback, predictions."""

import numpy as np

from book.elbow_arm.figures import ARM, PLACE, SHOULDER, UPPER
from robokin import elbow_arm

ROWS = {(1, 1): 0, (1, -1): 1, (-1, 1): 2, (-1, -1): 3}  # of the answers of `inverse`


def readouts(p_x, p_y, p_z, a3, face, bend, *_view):
    p = np.stack([p_x, p_y, p_z], axis=-1)
    answers = elbow_arm.inverse(p, UPPER, a3, SHOULDER, unreachable="nan")
    which = [ROWS[pair] for pair in zip(face.astype(int), bend.astype(int), strict=True)]
    chosen = answers[np.arange(len(p)), which]
    distance = np.linalg.norm(p - [0, 0, SHOULDER], axis=-1)
    best = elbow_arm.nearest_reachable(p, UPPER, a3, SHOULDER)
    angles = dict(zip(("theta1", "theta2", "theta3"), chosen.T, strict=True))
    return {**angles, "d": distance, "missed": np.linalg.norm(p - best, axis=-1)}


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


CHOICES = (
    "facing the target, elbow up",
    "facing the target, elbow down",
    "facing away, elbow up",
    "facing away, elbow down",
)
ON_THE_AXIS = {"p_x": 0.0, "p_y": 0.0}
AT_THE_SHOULDER = {**ON_THE_AXIS, "p_z": 0.1}
SETTINGS = [
    *({"arm": arm, "p_x": 0.3, "p_y": -0.2} for arm in CHOICES),
    *({"arm": arm, **ON_THE_AXIS} for arm in CHOICES),
    *({"arm": arm, **AT_THE_SHOULDER, "a3": 0.4} for arm in CHOICES),
    AT_THE_SHOULDER,
    {"p_x": -0.5, "p_y": 0.0, "arm": CHOICES[2]},
    {"p_x": 0.01, "p_y": 0.0, "p_z": 0.15},
    {"p_x": 0.7, "p_y": 0.6},
]

READOUTS = {"four-arms": readouts, "arm-in-space": readouts, "wrong-reach": mistakes_readouts}
NOT_NOTICED = [
    {"mistake": "It aims at a mirror image", "p_x": 0.2},
    {"mistake": "It never looks behind", "p_x": 0.3},
    {
        "mistake": "Its reach never changes",
        "p_x": 1e-9,
    },  # at 0 the quotient p_y/p_x has no digits
]
SPECIALS = {"four-arms": SETTINGS, "arm-in-space": SETTINGS, "wrong-reach": NOT_NOTICED}
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
    ("four-arms", {"p_x": 0.7}, "theta2", "none"),
    ("arm-in-space", {"p_x": 0.0, "p_y": 0.0, "p_z": 0.1}, "theta1", "none"),
]
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
            "M1": [
                [-2.4088, 1.2904, -1.5299],
                [-2.4088, -0.3309, 1.5299],
                [0.7328, 1.8512, 1.5299],
                [0.7328, 3.4724, -1.5299],
            ],
            "M2": [
                [-2.3036, 0.4082, -1.9042],
                [-2.3036, -1.6296, 1.9042],
                [0.838, 2.7334, 1.9042],
                [0.838, 4.7712, -1.9042],
            ],
            "M3": [
                [-2.3036, 1.1543, -1.2782],
                [-2.3036, -0.1947, 1.2782],
                [0.838, 1.9873, 1.2782],
                [0.838, 3.3363, -1.2782],
            ],
            "M5": [
                [0.838, 1.2904, -1.5299],
                [0.838, -0.3309, 1.5299],
                [3.9796, 1.8512, 1.5299],
                [3.9796, 3.4724, -1.5299],
            ],
            "M4": [
                [-2.3036, 1.2904, -1.5299],
                [-2.3036, -0.3309, 1.5299],
                [0.838, 1.2904, -1.5299],
                [0.838, -0.3309, 1.5299],
            ],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "how-bent": ("90°", "180°", "45°"),
    "faces-away": "the other sign",
    "how-many-digits": "2",
    "answers-when-stretched": "two",
    "answers-on-the-axis": "infinitely many",
}
