"""What the figures of the chapter on encoder odometry must show."""

import numpy as np

from robokin import motion, odometry

TICKS, RADIUS, DISTANCE = 512, 0.05, 0.2  # ticks a turn, wheel radius, wheel distance [m]
LEFT, RIGHT, CIRCLE = 3072, 5120, 0.4  # ticks on a whole circle, and its radius [m]
FINER = 2.0**40  # the figures count parts of ticks: ticks of a finer encoder
ROBOT = TICKS * FINER, RADIUS, DISTANCE
A_METRE = TICKS * FINER / (2 * np.pi * RADIUS)  # ticks


def rules_readouts(count, turned):
    """Largest errors of exact, old, new, middle heading; errors at the end of old and middle."""
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
    return found


def ellipse_readouts(wheel_error, drive, turned):
    """Half the length and the width of the 95 % ellipse, standard deviation of the heading."""
    half = DISTANCE * turned / 2
    left, right = (np.rint((drive + s * half) / 6 * A_METRE) for s in (-1, 1))
    ticks = [np.repeat(wheel[:, None], 6, axis=1) for wheel in (left, right)]
    last = odometry.covariance(*ticks, *ROBOT, wheel_error**2)[:, -1]
    short, long = np.sqrt(np.linalg.eigvalsh(last[:, :2, :2])).T
    holds_95 = np.sqrt(-2 * np.log(0.05))
    return np.column_stack([holds_95 * long, holds_95 * short, np.sqrt(last[:, 2, 2])])


def square_end(b_true, ratio, turns):
    """Where a square run really ends: four sides of 1 m in one piece each, four corners."""
    right = 2 * ratio / (1 + ratio)
    left = 2 - right
    corner = turns * np.pi / 4 * DISTANCE
    pose = np.zeros((len(ratio), 3))
    for told_left, told_right in [(1.0, 1.0), (-corner, corner)] * 4:
        v = (left * told_left + right * told_right) / 2
        omega = (right * told_right - left * told_left) / b_true
        pose = motion.arc_step(pose, v, omega, 1.0)
    return pose[:, :2]


def square_readouts(b_true, ratio):
    """Ends of the clockwise and of the counter-clockwise run, and what the calibration finds."""
    cw, ccw = (square_end(b_true, ratio, turns) for turns in (-1, 1))
    found = odometry.umbmark(cw[:, None], ccw[:, None], 1.0, DISTANCE)
    return np.column_stack([cw, ccw, *found])


def wrong_poses_readouts(*columns):
    """apart, turned."""
    return np.array([of_mistake(*row) for row in zip(*columns, strict=True)])


def of_mistake(m22, m23, m24, m25, samples, start):
    """How far the pose that a program believes in is from the real one, and its heading."""
    ticks = np.tile([80, 120], (int(samples), 1))
    right = odometry.travel(ticks, TICKS, RADIUS)
    if m25:
        ticks[8:9] -= 1024  # the sample in which both counters wrap
    travel = odometry.travel(ticks, TICKS, RADIUS) / (2 * np.pi if m24 else 1)
    real, told = np.array([0.0, 0.0, start]), np.array([0.0, 0.0, start])
    for (left, now), way in zip(right, travel, strict=True):
        real = motion.arc_step(real, (left + now) / 2, (now - left) / DISTANCE, 1.0)
        v, turn = way.mean(), (way[1] - way[0]) / DISTANCE
        if m22 or m23:
            heading = turn if m22 else np.arctan(np.tan(told[2] + turn))
            place = motion.arc_step([*told[:2], heading], v, 0.0, 1.0)[:2]
            told = np.array([*place, told[2] + turn if m22 else heading])
        else:
            told = motion.arc_step(told, v, turn, 1.0)
    return [np.hypot(*(told - real)[:2]), (told - real)[2]]


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
    "wrong-poses": [{"mistake": "It leaps back", "samples": n} for n in (8, 9, 16)],
}
WORDS = []  # every readout has a number
