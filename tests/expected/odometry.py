"""Expected values for the chapter on encoder odometry: figures, feedback, predictions."""

import numpy as np

from book.odometry.figures import BASE, CIRCLE, LEFT, RADIUS, RIGHT, TABLE, TICKS
from robokin import motion, odometry

FINER = 2.0**40  # the figures count parts of ticks: ticks of a finer encoder
ROBOT = TICKS * FINER, RADIUS, BASE
A_METRE = TICKS * FINER / (2 * np.pi * RADIUS)  # ticks
DEGREE = np.pi / 180


def dark_readouts(v_left, v_right, time, near, dock_x, dock_y, dock_heading, part):
    """Return both counters, the belief to the dock, and the robot to its belief, at the dock."""
    told = np.stack([v_left, v_right], axis=-1) * time[:, None]
    pieces = np.repeat(told[:, None] / 16, 16, axis=1)
    numbers = TABLE[17:20].swapaxes(0, 1).reshape(2, 18)[:, :16].T
    real = pieces + np.sqrt(1.6e-3 * np.abs(pieces)) * numbers
    start = np.array([0, 0, np.pi / 2])
    ends = []
    for ways in (pieces, real):
        v, turn = ways.mean(axis=-1), (ways[..., 1] - ways[..., 0]) / BASE
        ends.append(motion.path(start, v, turn, 1.0)[:, -1, :2])
    gap = np.linalg.norm(ends[1] - ends[0], axis=-1)
    away = np.hypot(ends[0][:, 0] - dock_x, ends[0][:, 1] - dock_y)
    counted = told * np.minimum(part / time, 1)[:, None] * TICKS / (2 * np.pi * RADIUS)
    lit = np.where(away < near, gap, np.nan)
    return {"left": counted[:, 0], "right": counted[:, 1], "away": away, "gap": lit}


def tick_readouts(way):
    return {"counted": np.floor(way * 12 / (2 * np.pi * RADIUS) + 7 / 8)}


def bent_readouts(turned, bend):
    """Return both strips of 1.2 m, by the paths of the wheels, and their difference."""
    halves = [(turned + sign * bend) / 2 for sign in (1, -1)]
    left, right = (sum(0.6 + side * BASE / 2 * turn for turn in halves) for side in (-1, 1))
    return {"D_L": left, "D_R": right, "difference": right - left}


def sample_readouts(way, turn):
    """Return how far three rules are off after one sample."""
    left, right = (np.rint((way + s * BASE / 2 * turn) * A_METRE)[:, None] for s in (-1, 1))
    exact = odometry.path(left, right, *ROBOT)[:, -1]
    found = {}
    for name, method in (("old", "start"), ("new", "end"), ("middle", "midpoint")):
        off = odometry.path(left, right, *ROBOT, method=method)[:, -1] - exact
        found[f"off_{name}"] = np.hypot(off[:, 0], off[:, 1])
    return found


def on_s(part):
    """Return poses on the S-shaped way: 1 m to the left by 1.4 rad, then 1 m to the right."""
    start = [0, 0, -0.35]
    first = motion.arc_step(start, 1.0, 1.4, 2 * np.minimum(part, 0.5))
    return motion.arc_step(first, 1.0, -1.4, 2 * np.maximum(part - 0.5, 0))


def door_readouts(part, slip):
    """Return the lever from the left wheel's contact to the end, and the shift."""
    here, end = on_s(part), on_s(np.array(1.0))
    hinge = here[:, :2] + BASE / 2 * np.stack([-np.sin(here[:, 2]), np.cos(here[:, 2])], axis=-1)
    lever = np.linalg.norm(end[:2] - hinge, axis=-1)
    return {"lever": lever, "shift": slip / BASE * lever}


def ten_readouts(count):
    """Return both standard deviations: the ten terms, each by a tiny piece of its own."""
    total, found = np.zeros((3, 3)), np.zeros((11, 2))
    end = on_s(np.array(1.0))
    for k in range(10):
        pose = on_s(np.array((k + 0.5) / 10))
        ways = np.array([0.2 - 0.2 * s * 1.4 * BASE / 2 for s in (1, -1)])
        ways = ways if k < 5 else ways[::-1]
        tiny = np.rint(ways * 2.0**50)[:, None]
        piece = odometry.covariance(*tiny, 2.0**90, 0.5 / np.pi, BASE, 1e-4 * 2.0**40, pose)[-1]
        away = end[:2] - pose[:2]
        lever = np.array([[1, 0, -away[1]], [0, 1, away[0]], [0, 0, 1]])
        total = total + lever @ piece @ lever.T
        found[k + 1] = np.sqrt(np.diag(total)[:2])
    now = found[np.ceil(count - 0.5).astype(int)]
    return {"sigma_x": now[:, 0], "sigma_y_end": now[:, 1]}


def rules_readouts(count, turned):
    """Return the largest errors of old, new and middle heading."""
    found = np.empty((len(count), 3))
    for row, n, angle in zip(found, count.astype(int), turned, strict=True):
        part = angle / (2 * np.pi) / n * FINER
        ticks = [np.full(n, np.rint(wheel * part)) for wheel in (LEFT, RIGHT)]
        angles = angle * np.arange(n + 1) / n
        true = motion.arc_step([0, 0, 0], CIRCLE * angles, angles, 1.0)
        for place, method in enumerate(("start", "end", "midpoint")):
            drive = odometry.path(*ticks, *ROBOT, method=method)
            row[place] = np.hypot(*(drive - true)[:, :2].T).max()
    return dict(zip(("old", "new", "middle"), found.T, strict=True))


def ellipse_readouts(wheel_error, drive, turned, _):
    """Return the half axes of the 95 % ellipse, and the standard deviation of the heading."""
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
    found_b, found_ratio = odometry.umbmark(cw[:, None], ccw[:, None], 1.0, BASE)
    alpha = np.pi / 2 * (1 - BASE / found_b)
    beta = 2 * np.arcsin((found_ratio - 1) / (found_ratio + 1) / found_b)
    names = "x_cw", "y_cw", "x_ccw", "y_ccw", "short_turn", "side_swing"
    return dict(zip(names, (*cw.T, *ccw.T, alpha, beta), strict=True))


def ice_readouts(slip):
    """Return where the odometry ends beside the line, and in standard deviations."""
    ticks = [np.rint(way * A_METRE) for way in (0.2, 1.96 - 0.2)]
    slips = np.rint(slip * A_METRE)
    left = np.stack([np.full_like(slip, ticks[0]), 0 * slip, np.full_like(slip, ticks[1])], axis=-1)
    right = left + np.stack([0 * slip, slips, 0 * slip], axis=-1)
    aside = odometry.path(left, right, *ROBOT)[:, -1, 1]
    spread = np.sqrt(2 * 1e-4 * 1.96**3 / 3) / BASE
    return {"aside": aside, "many": aside / spread}


def lab_readouts(heading, drive, turned, slip):
    """Return the ellipse by twelve samples, and where a slipped drive ends against the dock."""
    pose = np.stack([0 * heading, 0 * heading, heading], axis=-1)
    half = BASE * turned / 2
    ticks = [np.rint((drive + s * half) / 12 * A_METRE)[:, None] for s in (-1, 1)]
    ticks = [np.repeat(each, 12, axis=1) for each in ticks]
    last = odometry.covariance(*ticks, *ROBOT, 1e-4, pose)[:, -1, :2, :2]
    short, long = np.sqrt(-2 * np.log(0.05) * np.linalg.eigvalsh(last)).T
    place = motion.arc_step(pose, 0.2, 0.2 / drive * turned, 1.0)
    # the left wheel stands still, the right one rolls back what was counted too much
    place = motion.arc_step(place, -slip / 2, -slip / BASE, 1.0)
    end = motion.arc_step(place, drive - 0.2, (drive - 0.2) / drive * turned, 1.0)
    away = np.hypot(end[:, 0] - 0.92, end[:, 1] - 0.5)
    return {"lab_long": long, "lab_short": short, "to_dock": away}


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
    "dark-room": dark_readouts,
    "tick": tick_readouts,
    "bent": bent_readouts,
    "rules-step": sample_readouts,
    "four-rules": rules_readouts,
    "door": door_readouts,
    "ten-doors": ten_readouts,
    "error-ellipse": ellipse_readouts,
    "square-path": square_readouts,
    "counter-clock": lambda before, now: {"naive": now - before},
    "ice": ice_readouts,
    "half-seen": lambda heading: {"seen": np.arctan(np.tan(heading))},
    "odometry-lab": lab_readouts,
    "wrong-poses": wrong_poses_readouts,
}
SHORT, LONG = {"v_L": 0.12, "v_R": 0.16}, {"v_L": 0.085, "v_R": 0.145}
SPECIALS = {
    "dark-room": [SHORT, {"drive_home": "16 s", **LONG}],
    "four-rules": [{"turned": 2 * np.pi}, {"turned": 2 * np.pi, "samples": 3}, {"samples": 32}],
    "error-ellipse": [
        {"turned": 2 * np.pi},
        {"turned": 0.0},
        {"turned": 0.0, "drive": 3.0},
        {"turned": 1e-9},
    ],
    "square-path": [{"ratio": 1.0}, {"b_true": 0.2}, {"ratio": 1.0, "b_true": 0.2}],
    "odometry-lab": [{"turned": 0.0}, {"turned": 0.0, "slip": 0.06}],
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
COUNTED = dict(left_before=65250, left_after=140, right_before=2000, right_after=2700)
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
        {"theta": 140, "r": 6, "b": 35, "C": 512, **COUNTED},
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
    "odometry-8": (
        {"slip": 3, "b": 40, "lever": 2},
        {"half the wheel distance": [0.15, 0.3], "without the lever": [0.075, 0.03]},
    ),
    "odometry-9": (
        {"error": 5, "b": 40, "drive": 3},
        {"one wheel": [0.0217, 0.0375], "third is missing": [0.0306, 0.0919]},
    ),
    "odometry-10": (
        {"x_cw": -10, "y_cw": -12, "x_ccw": -4, "y_ccw": 5, "side": 2, "b": 40},
        {
            "two ways are exchanged": [0.3995, 1.0001],
            "x and y": [0.4021, 1.0039],
        },
    ),
    "odometry-11": (
        {"span": 1024, "most": 30},
        {"whole counter": 33, "g lost readings": 17},
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "held-wheel": "the left wheel",
    "quarter-turn": "(−1, 2)",
    "ticks-to-metres": ("23.6 cm", "3.75 cm", "47.1 cm", "31.4 cm"),
    "how-much-turned": "45°",
    "where-is-it": ("x 0.283 m, y 0.117 m", "0.314 m, 0 m", "0.222 m, 0.222 m"),
    "whole-circle": "at the start",
    "early-or-late": "if it slips early",
    "twice-as-far": "2.8 times",
    "two-errors": "swinging sides",
    "wraps-round": "10",
}
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "dark-room": [
        ([SHORT], [{**SHORT, "v_R": 0.17}, LONG]),
        ([{"drive_home": "16 s", **LONG}], [{"drive_home": "16 s", **SHORT}]),
    ],
    "tick": [([{"way": 0.161}, {"way": 0.186}], [{"way": 0.16}, {"way": 0.187}])],
    "strips": [
        ([{"D_L": 0.0, "D_R": 0.31}], [{"D_L": 0.0, "D_R": 0.3}, {"D_L": 0.01, "D_R": 0.32}]),
        ([{"D_L": -0.06, "D_R": 0.06}], [{"D_L": -0.06, "D_R": 0.08}, {"D_L": 0.0, "D_R": 0.0}]),
    ],
    "bent": [
        (
            [{"turned": 60 * DEGREE, "bend": -120 * DEGREE}],
            [{"turned": 60 * DEGREE, "bend": -125 * DEGREE}, {"turned": 0.0, "bend": 0.0}],
        )
    ],
    "rules-step": [([{"D": 0.3, "dtheta": 10 * DEGREE}], [{"D": 0.35, "dtheta": 10 * DEGREE}])],
    "four-rules": [
        (
            [{"samples": 26, "turned": 2 * np.pi}],
            [{"samples": 25, "turned": 2 * np.pi}, {"samples": 26, "turned": 350 * DEGREE}],
        )
    ],
    "door": [
        (
            [{"slip": 0.06, "part": 0.45}, {"slip": 0.06, "part": 0.53}],
            [{"slip": 0.06, "part": 0.44}, {"slip": 0.06, "part": 0.54}, {"part": 0.5}],
        )
    ],
    "square-path": [
        ([{"b_true": 0.205, "ratio": 1.008}], [{"b_true": 0.2, "ratio": 1.0}]),
        ([{"b_true": 0.2, "ratio": 1.0}], [{"b_true": 0.201, "ratio": 1.0}]),
    ],
    "counter-clock": [
        (
            [{"count_before": 5000, "count_now": 60000}],
            [
                {"count_before": 20000, "count_now": 50000},
                {"count_before": 60000, "count_now": 5000},
            ],
        )
    ],
    "ice": [([{"slip": 0.038}, {"slip": -0.038}], [{"slip": 0.036}, {"slip": 0.04}])],
    "half-seen": [
        ([{"set_off": 150 * DEGREE}], [{"set_off": 145 * DEGREE}, {"set_off": -30 * DEGREE}])
    ],
    "odometry-lab": [
        (
            [{"set_off": 28 * DEGREE, "drive": 1.04, "turned": 0.0}],
            [
                {"set_off": 28 * DEGREE, "drive": 1.1, "turned": 0.0},
                {"set_off": -60 * DEGREE, "drive": 1.85, "turned": 180 * DEGREE},
            ],
        ),
        (
            [{"drive": 2.5, "turned": 280 * DEGREE}],
            [{"drive": 2.5, "turned": 270 * DEGREE}, {"drive": 2.49, "turned": 280 * DEGREE}],
        ),
        (
            [{"set_off": 42 * DEGREE, "drive": 1.08, "turned": 0.0, "slip": 0.06}],
            [
                {"set_off": 28 * DEGREE, "drive": 1.04, "turned": 0.0, "slip": 0.06},
                {"set_off": 28 * DEGREE, "drive": 1.04, "turned": 0.0},
            ],
        ),
    ],
    "two-secrets": [
        (
            [{"guess_b": 0.2065, "guess_ratio": 1.006}],
            [{"guess_b": 0.2075, "guess_ratio": 1.006}, {"guess_b": 0.2065, "guess_ratio": 1.004}],
        )
    ],
    "odometry-letters": [
        ([{"name_1": "ℓ", "name_2": "εℓ/b", "name_3": "ε/b"}], [{"name_1": "ℓ", "name_2": "ε/b"}])
    ],
}
