"""Expected values for the chapter on encoder odometry: figures, feedback, predictions."""

import numpy as np

from book.odometry.figures import BASE, CIRCLE, LEFT, RADIUS, RIGHT, TICKS
from robokin import motion, odometry

FINER = 2.0**40  # the figures count parts of ticks: ticks of a finer encoder
ROBOT = TICKS * FINER, RADIUS, BASE
A_METRE = TICKS * FINER / (2 * np.pi * RADIUS)  # ticks


def rules_readouts(count, turned):
    """Return the largest errors of exact, old, new, middle heading; old and middle at the end."""
    found = np.empty((len(count), 6))
    for row, n, angle in zip(found, count.astype(int), turned, strict=True):
        part = angle / (2 * np.pi) / n * FINER
        ticks = [np.full(n, np.rint(wheel * part)) for wheel in (LEFT, RIGHT)]
        angles = angle * np.arange(n + 1) / n
        true = motion.arc_step([0, 0, 0], CIRCLE * angles, angles, 1.0)
        errors = []
        for method in ("exact", "start", "end", "midpoint"):
            drive = odometry.path(*ticks, *ROBOT, method=method)
            errors.append(np.hypot(*(drive - true)[:, :2].T))
        row[:] = [*np.max(errors, axis=1), errors[1][-1], errors[3][-1]]
    names = "exact", "old", "new", "middle", "old_end", "middle_end"
    return dict(zip(names, found.T, strict=True))


def ellipse_readouts(wheel_error, drive, turned):
    """Return half the 95 % ellipse, length and width, and the standard deviation of the heading."""
    half = BASE * turned / 2
    left, right = (np.rint((drive + s * half) / 6 * A_METRE) for s in (-1, 1))
    ticks = [np.repeat(wheel[:, None], 6, axis=1) for wheel in (left, right)]
    last = odometry.covariance(*ticks, *ROBOT, wheel_error**2)[:, -1]
    short, long = np.sqrt(np.linalg.eigvalsh(last[:, :2, :2])).T
    holds_95 = np.sqrt(-2 * np.log(0.05))
    heading = np.sqrt(last[:, 2, 2])
    return {"long_axis": holds_95 * long, "short_axis": holds_95 * short, "heading": heading}


def square_end(b_true, ratio, turns):
    """Return where a square run really ends: four sides of 1 m in one piece each, four corners."""
    right = 2 * ratio / (1 + ratio)
    left = 2 - right
    corner = turns * np.pi / 4 * BASE
    pose = np.zeros((len(ratio), 3))
    for told_left, told_right in [(1.0, 1.0), (-corner, corner)] * 4:
        v = (left * told_left + right * told_right) / 2
        omega = (right * told_right - left * told_left) / b_true
        pose = motion.arc_step(pose, v, omega, 1.0)
    return pose[:, :2]


def square_readouts(b_true, ratio):
    """Return the ends of the clockwise and the counter-clockwise run, and the calibration."""
    cw, ccw = (square_end(b_true, ratio, turns) for turns in (-1, 1))
    found = odometry.umbmark(cw[:, None], ccw[:, None], 1.0, BASE)
    names = "x_cw", "y_cw", "x_ccw", "y_ccw", "found_b", "found_ratio"
    return dict(zip(names, (*cw.T, *ccw.T, *found), strict=True))


def wrong_poses_readouts(*columns):
    real, told = wrong_poses(*columns)
    off = told - real
    return {"apart": np.hypot(off[:, 0], off[:, 1]), "turned": off[:, 2]}


def wrong_poses(*columns):
    """Return where the robot is, and where its program believes it to be: (n, 3) each."""
    return np.array([of_mistake(*row) for row in zip(*columns, strict=True)]).swapaxes(0, 1)


def of_mistake(m22, m23, m24, m25, samples, start):
    """Return both poses."""
    ticks = np.tile([80, 120], (int(samples), 1))
    right = odometry.travel(ticks, TICKS, RADIUS)
    if m25:
        ticks[8:9] -= 1024  # the sample in which both counters wrap
    travel = odometry.travel(ticks, TICKS, RADIUS) / (2 * np.pi if m24 else 1)
    real, told = np.array([0.0, 0.0, start]), np.array([0.0, 0.0, start])
    for (left, now), way in zip(right, travel, strict=True):
        real = motion.arc_step(real, (left + now) / 2, (now - left) / BASE, 1.0)
        v, turn = way.mean(), (way[1] - way[0]) / BASE
        if m22 or m23:
            heading = turn if m22 else np.arctan(np.tan(told[2] + turn))
            place = motion.arc_step([*told[:2], heading], v, 0.0, 1.0)[:2]
            told = np.array([*place, told[2] + turn if m22 else heading])
        else:
            told = motion.arc_step(told, v, turn, 1.0)
    return [real, told]


def forgets_heading(*columns):
    """Whether the heading at the start makes no difference to the believed place."""
    told, from_zero = (
        wrong_poses(*columns[:5], start)[1] for start in (columns[5], 0 * columns[5])
    )
    return np.hypot(*(told - from_zero)[:, :2].T) < 1e-9


def never_backward(*columns):
    return np.abs(wrong_poses(*columns)[1][:, 2]) <= np.pi / 2


def hardly_moves(*columns):
    """Whether it believes in less than a fifth of the way."""
    way = columns[4] * odometry.travel([80, 120], TICKS, RADIUS).mean()
    return np.hypot(*wrong_poses(*columns)[1][:, :2].T) < way / 5


def leaps_in_sample_9(*columns):
    apart = wrong_poses_readouts(*columns)["apart"]
    return np.where(columns[4] < 9, apart < 1e-9, apart > 0.3)


LEAP = "It leaps back in sample 9"

READOUTS = {
    "four-rules": rules_readouts,
    "error-ellipse": ellipse_readouts,
    "square-path": square_readouts,
    "wrong-poses": wrong_poses_readouts,
}
SPECIALS = {
    "four-rules": [{"turned": 2 * np.pi}, {"turned": 2 * np.pi, "samples": 3}, {"samples": 32}],
    "error-ellipse": [
        {"turned": 2 * np.pi},
        {"turned": 0.0},
        {"turned": 0.0, "drive": 3.0},
        {"turned": 1e-9},
    ],
    "square-path": [{"ratio": 1.0}, {"b_true": 0.2}, {"ratio": 1.0, "b_true": 0.2}],
    "wrong-poses": [{"mistake": LEAP, "samples": n} for n in (8, 9, 16)],
}
TITLES = {
    "wrong-poses": {
        "It forgets its heading": forgets_heading,
        "It never looks backward": never_backward,
        "It hardly moves": hardly_moves,
        LEAP: leaps_in_sample_9,
    }
}
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "odometry-1": (
        {"C": 512, "r": 7.5, "N": 450},
        {"M24": 0.0659, "diameter where": 0.8283, "ticks a turn are exchanged": 0.5362},
    ),
    "odometry-2": (
        {"before": 65240, "after": 625, "C": 512, "r": 3},
        {"M24": 0.054, "M25": -23.7884, "65535 numbers": 0.3387},
    ),
    "odometry-3": (
        {"x": 3.5, "y": 1.5, "theta": 110, "D_L": 5, "D_R": 32.5, "b": 55},
        {
            "M22": [3.6645, 1.5899, 2.4199],
            "M23": [3.6407, 1.3761, -0.7217],
            "old heading": [3.4359, 1.6762, 2.4199],
            "rule of the middle": [3.3943, 1.6548, 2.4199],
            "exact arc": [3.3954, 1.6532, 2.4199],
            "half the wheel distance": [3.3171, 1.5412, 2.9199],
            "degrees are handed": [3.6714, 1.5761, 2.4199],
            "only the heading": [3.3593, 1.6239, -0.7217],
            "left and right": [3.5282, 1.6854, 1.4199],
        },
    ),
    "odometry-4": (
        {"r": 2, "C": 500, "n": 5, "N_R": 13500},
        {"M24": 0.0344, "one full turn": 1.08, "one wheel only": 0.108},
    ),
    "odometry-5": (
        {"r": 5.5, "b": 40, "period": 20, "limit": 2},
        {"M24": 197, "rounded down": 1237},
    ),
    "odometry-6": ({"D": 40, "turn": 55, "theta": 40}, {"M22": 0.0868, "middle heading": 0.0152}),
    "odometry-7": (
        {
            "theta": 140,
            "r": 6,
            "b": 35,
            "C": 512,
            "left_before": 65250,
            "left_after": 140,
            "right_before": 2000,
            "right_after": 2700,
        },
        {
            "M22": [0.3476, 0.2259, 3.0199],
            "M23": [-0.375, 0.1629, -0.1217],
            "M24": [-0.0524, 0.04, 2.5352],
            "M25": [0.0309, -0.0207, 140.8909],
            "old heading": [-0.3176, 0.2665, 3.0199],
            "new heading": [-0.4115, 0.0503, 3.0199],
            "middle heading": [-0.3802, 0.1652, 3.0199],
            "starts with heading 0": [0.392, 0.1162, 3.0199],
            "at the start is forgotten": [0.392, 0.1162, 0.5764],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "how-much-turned": "45°",
    "straight-on": "that of ρ",
    "whole-circle": "at the start",
    "wraps-round": "10",
    "twice-as-far": "2.8 times",
    "two-errors": "swinging sides",
    "a-slip": "about 6",
}
