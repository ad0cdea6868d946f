"""What the figures of the chapter on the elbow arm must show."""

import numpy as np

from robokin import elbow_arm

UPPER, SHOULDER = 0.4, 0.1  # m: a2 and d1
ROWS = {(1, 1): 0, (1, -1): 1, (-1, 1): 2, (-1, -1): 3}  # of the answers of `inverse`


def readouts(p_x, p_y, p_z, a3, face, bend, *_view):
    """theta1, theta2, theta3, d, missed."""
    p = np.stack([p_x, p_y, p_z], axis=-1)
    answers = elbow_arm.inverse(p, UPPER, a3, SHOULDER, unreachable="nan")
    which = [ROWS[pair] for pair in zip(face.astype(int), bend.astype(int), strict=True)]
    chosen = answers[np.arange(len(p)), which]
    distance = np.linalg.norm(p - [0, 0, SHOULDER], axis=-1)
    best = elbow_arm.nearest_reachable(p, UPPER, a3, SHOULDER)
    return np.column_stack([chosen, distance, np.linalg.norm(p - best, axis=-1)])


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

READOUTS = {"four-arms": readouts, "arm-in-space": readouts}
SPECIALS = {"four-arms": SETTINGS, "arm-in-space": SETTINGS}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("four-arms", {"p_x": 0.7}, "theta2", "none"),
    ("arm-in-space", {"p_x": 0.0, "p_y": 0.0, "p_z": 0.1}, "theta1", "none"),
]
