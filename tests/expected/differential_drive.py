"""Expected values for the chapter on the differential drive: figures, feedback, predictions."""

import numpy as np

from book.differential_drive.figures import DISTANCE
from robokin import differential_drive, motion

UP = np.pi / 2  # the heading at the start


def twist_of(v_left, v_right):
    """Return speed and angular velocity of the robot in the figures; the wheel radius cancels."""
    twist = differential_drive.body_twist(v_left, v_right, 1.0, DISTANCE)
    return twist[..., 0], twist[..., 2]


def driven(v, omega, time, heading=UP):
    """Return the pose after driving from the origin."""
    start = np.stack([0 * (v + omega), 0 * (v + omega), heading + 0 * (v + omega)], axis=-1)
    return motion.arc_step(start, v, omega, time)


def off_and_turned(pose, mark):
    """Return how far from a mark, and turned against it."""
    off = np.hypot(*(pose - mark)[..., :2].T)
    return {"off": off, "turned": np.abs(motion.wrap_angle(pose[..., 2] - mark[2]))}


def park_readouts(v_left, v_right, t):
    mark = driven(np.float64(0.09), np.float64(0.6), 3.0)
    return off_and_turned(driven(*twist_of(v_left, v_right), 3.0), mark)


def infinity_readouts(share):
    c, s = np.cos(share), np.sin(share) * DISTANCE / 2 / 0.26  # m: how wide the map is
    return {"R": differential_drive.turning_radius(c - s, c + s, DISTANCE)}


def steps_readouts(count):
    """Return the errors of the steps by the old and by the middle heading."""
    errors = []
    for n in count.astype(int):
        drive = np.full(n, 0.075), np.full(n, 0.5), np.full(n, 6 / n)
        ends = [motion.path([0, 0, UP], *drive, method=m)[-1, :2] for m in ("start", "midpoint")]
        errors.append([np.hypot(*(end - driven(0.075, 0.5, 6.0)[:2])) for end in ends])
    return dict(zip(("error_0", "error_1"), np.transpose(errors), strict=True))


def side_readouts(aim, reach, done):
    turned = driven(0 * aim, aim, 1.0)
    there = motion.arc_step(turned, reach, 0 * aim, 1.0)
    end = motion.arc_step(there, 0 * aim, -aim, 1.0)
    return {"off": off_and_turned(end, np.array([-0.2, 0.0, UP]))["off"]}


def damage_readouts(rate, heading, t):
    v, omega = twist_of(0.12, 0.08)
    places = driven(v, omega + 0 * rate, t, np.pi / 3), driven(v, rate, t, heading)
    return {"apart": np.hypot(*(places[0] - places[1])[:, :2].T)}


def away_readouts(slowed):
    v_right = 0.1 - slowed
    return {"v_R": v_right, "R": differential_drive.turning_radius(0.05, v_right, DISTANCE)}


def drive_readouts(v_left, v_right, t):
    pose, bay = driven(*twist_of(v_left, v_right), t), driven(np.float64(0.075), -0.5, 5.0)
    return {**dict(zip(("x", "y", "heading"), pose.T, strict=True)), **off_and_turned(pose, bay)}


STRAIGHT, BACK = {"v_L": 0.07, "v_R": 0.07}, {"v_L": -0.15, "v_R": -0.15}
SPOT, STILL = {"v_L": -0.05, "v_R": 0.05}, {"v_L": 0.0, "v_R": 0.0}
DRIVES = [STRAIGHT, BACK, SPOT, STILL]

READOUTS = {
    "park": park_readouts,
    "away": away_readouts,
    "infinity": infinity_readouts,
    "digits": lambda power: {"after": np.sin(1 + 2 * 10.0**-power)},
    "steps": steps_readouts,
    "side": side_readouts,
    "damage": damage_readouts,
    "wheel-speeds": drive_readouts,
}
SPECIALS = {
    "park": [*DRIVES, {"v_L": 0.06, "v_R": 0.12}],
    "axle": DRIVES,
    "still": [{"pin_x": -0.15, "pin_y": 0.0, "t": 1.5}],
    "tips": DRIVES,
    "away": [{"slowed": 0.05}, {"slowed": 0.06}, {"slowed": 0.07}],
    "infinity": [{"share": 0.0}],
    "icr": [{"theta": 0.0}, {"theta": UP}, {"theta": -UP}],
    "world": [{"theta": 0.0}, {"theta": UP}],
    "rates": [{"omega": 0.0}, {"v": 0.0}, {"v": 0.0, "omega": 0.0}],
    "added": [{"omega": 0.0}, {"v": 0.0, "omega": 0.5}],
    "guess": [{"t": 2.0}],
    "spokes": [{"dt": 0.0}, {"theta": UP}],
    "arc": [{"omega": 0.0}, {"omega": 1e-12}],
    "digits": [{"power": 8.0}],
    "steps": [{"n": 6}, {"n": 12}],
    "sideways": [{"wish_y": 0.0}, {"wish_x": 0.0}],
    "side": [{"aim": UP, "reach": 0.2, "done": 3.0}, {"done": 0.5}, {"done": 1.5}, {"done": 2.5}],
    "damage": [{"t": 0.0}, {"mistake": "Down instead of up", "t": 2.0}],
    "wheel-speeds": [*DRIVES, {**STRAIGHT, "t": 12.0}],
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("wheel-speeds", {"v_L": 0.1}, "R", "at infinity"),
    ("away", {"slowed": 0.05}, "R", "∞"),
    ("tips", {"v_L": 0.0, "v_R": 0.0}, "R", "…"),
]
# numbers that are shown to lose their digits, by the symbols that they come from
LOST = {"digits": ("x_lost", "y_lost")}
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "differential-drive-1": (
        {"b": 60, "v_L": 0.8, "v_R": 0.75},
        {"M12": -0.1667, "M31": -0.0417, "distance is forgotten": -0.05},
    ),
    "differential-drive-2": (
        {"theta": 90, "v_L": 0.55, "v_R": 0.3},
        {"M13": [-0.1904, 0.3799], "M14": [0, -0.425], "with the difference": [0, -0.25]},
    ),
    "differential-drive-3": (
        {"x": 4, "y": 2, "theta": 160, "b": 45, "v_L": 0.7, "v_R": 0.2},
        {
            "M12": [4.0693, 2.1903],
            "M31": [4.277, 2.7612],
            "M13": [4.0889, 2.3951],
            "M14": [3.8615, 2.3806],
            "as the robot sees": [0, -0.405],
            "own place is not added": [0.1385, 0.3806],
            "to the wrong side": [3.8615, 1.6194],
            "ahead of the robot": [4.3806, 1.8615],
            "sine and cosine exchanged": [3.6194, 1.8615],
        },
    ),
    "differential-drive-4": (
        {"r": 4, "b": 40, "radius": 0.8, "time": 20},
        {
            "M12": [5.4978, 7.0686],
            "M31": [3.1416, 9.4248],
            "division by r is missing": [0.1885, 0.3142],
        },
    ),
    "differential-drive-5": (
        {"b": 20, "v_L": 0.7, "v_R": 0.2, "time": 1},
        {
            "M12": [-0.0863, -0.0645, -5],
            "M31": [0.3416, -0.2465, -1.25],
            "degrees are handed": [-0.1721, -0.1273, -2.5],
            "exchanged": [0.1077, 0.3242, 2.5],
            "straight on and only then": [0.45, 0, -2.5],
            "turns first": [-0.3605, -0.2693, -2.5],
            "middle heading": [0.1419, -0.427, -2.5],
        },
    ),
    "differential-drive-6": (
        {"worn": 2.5, "b": 40, "distance": 3},
        {
            "M12": [2.8936, 0.549],
            "M31": [2.9582, 0.1388],
            "to the wrong side": [2.9452, -0.2769],
            "mean of both wheels": [2.9625, 0],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "how-fast": ("7.5 cm/s", "15 cm/s", "5 cm/s"),
    "seen-from-the-robot": "at its right",
    "behind-on-the-left": "135°",
    "where-still": ("pin: x −0.15 m, pin: y 0 m", "0 m, 0 m", "−0.05 m, 0 m"),
    "where-next": "farther away, then in from the other side",
    "wheel-rate": ("3.33 rad/s", "1.67 rad/s", "0.003 rad/s", "30 rad/s", "0.3 rad/s"),
    "where-after": ("x −0.069 m, y 0.126 m", "0 m, 0.15 m", "0.069 m, 0.126 m"),
    "ever-straighter": "it gets worse",
    "at-rest": "nowhere: no answer",
    "at-its-side": "yes, exactly",
}
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "park": [  # 0.09 m/s and 0.6 rad/s for 3 s, within 0.02 m and 5° (0.0873)
        (
            [{"v_L": 0.0614, "v_R": 0.1186}, {"v_L": 0.066, "v_R": 0.126}],
            [{"v_L": 0.0616, "v_R": 0.1184}, {"v_L": 0.0685, "v_R": 0.1285}],
        )
    ],
    "tips": [
        (
            [{"v_L": 0.0, "v_R": 0.05}, {"v_L": -0.002, "v_R": -0.021}],
            [{"v_L": 0.004, "v_R": 0.05}, {"v_L": 0.0, "v_R": 0.019}],
        ),
        (
            [{"v_L": -0.05, "v_R": 0.055}, {"v_L": 0.03, "v_R": -0.03}],
            [{"v_L": -0.05, "v_R": 0.057}, {"v_L": -0.01, "v_R": 0.01}],
        ),
        (
            [{"v_L": 0.07, "v_R": 0.072}, {"v_L": -0.05, "v_R": -0.05}],
            [{"v_L": 0.07, "v_R": 0.074}, {"v_L": 0.01, "v_R": 0.01}],
        ),
    ],
    "away": [  # 5 (5 + v) / (v - 5) cm is -25 cm at 10/3 cm/s
        (
            [{"slowed": 0.0675}, {"slowed": 0.066}],
            [{"slowed": 0.068}, {"slowed": 0.065}, {"slowed": 0.025}],
        )
    ],
    "steps": [([{"n": 4}], [{"n": 3}, {"n": 5}]), ([{"n": 45}], [{"n": 44}, {"n": 46}])],
    "letters": [
        (
            [{"name_1": "R", "name_2": "ωb", "name_3": "c"}],
            [{"name_1": "ωb", "name_2": "R", "name_3": "c"}, {"name_1": "R", "name_2": "ωb"}],
        )
    ],
    "sideways": [
        (
            [{"wish_y": 0.005}, {"wish_y": -0.005}, {"wish_y": 0.0, "wish_x": -0.021}],
            [{"wish_y": 0.007}, {"wish_y": -0.007}, {"wish_y": 0.0, "wish_x": 0.019}],
        )
    ],
    "side": [
        (
            [{"aim": UP, "reach": reach} for reach in (0.181, 0.219)],
            [{"aim": UP, "reach": reach} for reach in (0.179, 0.221)],
        )
    ],
    "wheel-speeds": [
        (
            [{"v_L": 0.0, "v_R": -0.011}, {"v_L": 0.0004, "v_R": 0.05}],
            [{"v_L": 0.0, "v_R": 0.009}, {"v_L": 0.0006, "v_R": 0.05}, {"v_L": 0.05, "v_R": 0.0}],
        ),
        (
            [{"v_L": 0.03, "v_R": 0.0915}, {"v_L": 0.03, "v_R": -0.0885}],
            [
                {"v_L": 0.03, "v_R": 0.0925},
                {"v_L": 0.009, "v_R": 0.027},
                {"v_L": 0.09, "v_R": 0.03},
            ],
        ),
        (  # 0.075 m/s and -0.5 rad/s for 5 s
            [{"v_L": 0.1, "v_R": 0.05, "t": 5.17}, {"v_L": 0.1052, "v_R": 0.0552, "t": 5.0}],
            [{"v_L": 0.1, "v_R": 0.05, "t": 5.18}, {"v_L": 0.1054, "v_R": 0.0554, "t": 5.0}],
        ),
    ],
}
