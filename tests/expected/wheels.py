"""Expected values for the chapter on wheel constraints: figures, feedback, predictions."""

import numpy as np

from robokin import motion, wheels

QUARTER = np.pi / 2
OMNI = wheels.omni_robot(0.2, 0.05)


def kinds_readouts(*columns):
    found = np.array([of_kind(*row) for row in zip(*columns, strict=True)])
    return {"rolled": found[:, 0], "aside": found[:, 1]}


def of_kind(fixed, castor, straight, slanted, ball, course):
    """Return the rolling of a wheel that looks along x, and the rest of its velocity, signed."""
    if ball:
        return [np.nan, np.nan]
    gamma = slanted * np.pi / 4
    place = 0.2, -QUARTER, np.pi, 0.07
    made = wheels.swedish(*place, gamma) if straight or slanted else wheels.fixed(*place)
    velocity = np.array([0.2 * np.cos(course), 0.2 * np.sin(course), 0.0])
    rolled = (wheels.rolling([made]) @ velocity / np.cos(gamma))[0]
    left = velocity[:2] - [rolled, 0]
    return [rolled, left @ [-np.sin(gamma), np.cos(gamma)]]


def laboratory_readouts(*columns):
    found = np.array([laboratory(row) for row in zip(*columns, strict=True)])
    names = "rank", "now", "mobility", "steerability", "both", "v", "v_y", "omega"
    return dict(zip(names, found.T, strict=True))


def laboratory(row):
    """Return the readouts at one setting."""
    numbers, wish, (ahead, left) = np.reshape(row[:24], (4, 6)), row[24:27], row[27:29]
    which, shift = row[29:31], row[31:34]
    robot = [
        wheel(numbers[k], which[k] * np.array(shift) if k < 2 else np.zeros(3), ahead, left)
        for k in range(4)
        if numbers[k, 3]
    ]
    rows = wheels.sliding(robot)
    _, sizes, turned = np.linalg.svd(rows) if len(rows) else (0, np.zeros(0), np.eye(3))
    rank = np.count_nonzero(sizes > 1e-9 * sizes.max(initial=0))
    free = turned[rank:]
    return [rank, 3 - rank, *wheels.mobility(robot), *(free.T @ free @ np.array(wish))]


def wheel(numbers, shift, ahead, left):
    """Return a wheel of the robot, moved and turned by `shift`."""
    x, y, rolls, _, fixed, steered = numbers
    x, y = x + shift[0], y + shift[1]
    axle = np.arctan2(left - y, ahead - x) if steered else rolls + QUARTER
    l, alpha = np.hypot(x, y), np.arctan2(y, x)  # noqa: E741
    place = l, alpha, axle + shift[2] - alpha, 0.07
    if fixed:
        return wheels.fixed(*place)
    return wheels.steered(*place) if steered else wheels.castor(*place, -0.03)


def omni_readouts(rate1, rate2, rate3, theta, t):
    rates = np.stack([rate1, rate2, rate3], axis=-1)
    twist = wheels.forward(OMNI, rates)
    start = np.stack([0 * theta, 0 * theta, theta], axis=-1)
    pose = motion.move(start, twist, t)
    world = wheels.forward(OMNI, rates, theta=pose[:, 2])
    names = "v", "v_y", "turning", "x_dot", "y_dot", "x", "y", "heading"
    return dict(zip(names, np.column_stack([twist, world[:, :2], pose]).T, strict=True))


def wrong_rates_readouts(*columns):
    real, believed = wrong_rates(*columns)
    off = believed - real
    return {"apart": np.hypot(off[:, 0], off[:, 1]), "turned": off[:, 2]}


def wrong_rates(*columns):
    """Return where the robot is, and where its program believes it to be: (n, 3) each."""
    return np.array([of_mistake(*row) for row in zip(*columns, strict=True)]).swapaxes(0, 1)


def of_mistake(m19, m20, m34, m35, m21, theta, t):
    """Return both poses, of a robot that starts at the origin."""
    wish, right = [-0.08, 0.12, -0.6], wheels.rolling(OMNI)
    minus, turning = 1 - 2 * np.array([0, m19, m34]), right[:, 2]
    column = turning * np.cos(theta) if m20 else 0.2 * right[:, 1] if m35 else turning
    wrong = np.column_stack([right[:, :2], column]) * minus
    seen = motion.to_body(-theta if m21 else theta, wish)
    twists = np.linalg.solve(right, wrong @ seen), motion.to_body(theta, wish)
    return [motion.move([0, 0, theta], twist, t) for twist in twists]


def turns(*columns):
    """Return by how much the robot turns, and by how much its program believes."""
    return [pose[:, 2] - columns[5] for pose in wrong_rates(*columns)]


def directions(*columns):
    """Return the real and the believed direction at the start: unit vectors, (n, 2)."""
    soon = [pose[:, :2] for pose in wrong_rates(*columns[:6], 0 * columns[6] + 1e-6)]
    return [way / np.linalg.norm(way, axis=1, keepdims=True) for way in soon]


def other_side(*columns):
    """Whether the robot goes to the other side of the line along which it looks."""
    across = np.column_stack([-np.sin(columns[5]), np.cos(columns[5])])
    real, believed = (np.sum(way * across, axis=1) for way in directions(*columns))
    return real * believed < 0


def depends_on_heading(numbers):
    """Whether the real numbers depend on the heading, and the believed ones do not."""
    real, believed = (np.ptp(each, axis=0).max() for each in numbers)
    return real > 0.5 and believed < 1e-5


def other_turn(*columns):
    real, believed = turns(*columns)
    return real * believed < 0


CAR, TWO = {"robot": "car"}, {"robot": "two steered wheels, castors"}
DRIVE = {"robot": "differential drive, castor"}
TURNING = "Its turning rate varies"
RATES = ("omni_rate1", "omni_rate2", "omni_rate3")

READOUTS = {
    "wheel-kinds": kinds_readouts,
    "wheel-laboratory": laboratory_readouts,
    "omni": omni_readouts,
    "wrong-rates": wrong_rates_readouts,
}
SPECIALS = {
    "wheel-kinds": [{"kind": kind, "course": QUARTER} for kind in ("fixed", "Swedish, 45°")],
    "wheel-laboratory": [
        {**CAR, "centre_y": 0.0},
        {**CAR, "centre_x": 0.15},
        {**CAR, "shift_angle": np.pi / 36},
        {**CAR, "which": "wheel 2", "shift_x": 0.05},
        {**CAR, "which": "wheel 2", "shift_angle": -np.pi / 4},
        {**TWO, "centre_x": 0.4, "centre_y": -0.45},
        {**TWO, "centre_y": 0.0},
        {**DRIVE, "shift_x": 0.1},
        {**DRIVE, "shift_y": 0.2},
        {**DRIVE, "shift_angle": np.pi / 6},
        {"robot": "bicycle", "wish": "all three at once", "centre_y": -0.5},
        {"robot": "three Swedish wheels", "wish": "all three at once", "t": 6.0},
    ],
    "omni": [
        dict(zip(RATES, rates, strict=True))
        for rates in ([2.0, 2.0, 2.0], [-4.0, 2.0, 2.0], [0.0, 3.0, -3.0], [0.0, 0.0, 0.0])
    ],
    "wrong-rates": [{"theta": 0.0}, {"mistake": TURNING, "theta": QUARTER}],
}
TITLES = {
    "wrong-rates": {
        "It moves to the wrong side": other_side,
        TURNING: lambda *columns: depends_on_heading(turns(*columns)),
        "It turns the other way": other_turn,
        "It does not turn": lambda *columns: np.abs(turns(*columns)[0]) < 1e-9,
        "Its direction varies": lambda *columns: depends_on_heading(directions(*columns)),
    }
}
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "wheels-1": (
        {"l": 40, "alpha": -150, "beta": 75, "theta": 90},
        {
            "M19": [-0.9659, 0.2588, -0.1035],
            "M20": [-0.9659, -0.2588, 0],
            "M34": [-0.9659, -0.2588, 0.1035],
            "M35": [-0.9659, -0.2588, 0.3464],
            "sliding row": [0.2588, -0.9659, 0.3864],
        },
    ),
    "wheels-2": (
        {"l": 30, "first": 30, "theta": 140},
        {
            "M19": [[0.5, 0.866, -0.3], [0.5, -0.866, -0.3], [-1, 0, -0.3]],
            "M20": [[0.5, -0.866, 0.2298], [0.5, 0.866, 0.2298], [-1, 0, 0.2298]],
            "M34": [[0.5, -0.866, 0.3], [0.5, 0.866, 0.3], [-1, 0, 0.3]],
            "M35": [[0.5, -0.866, -0.2598], [0.5, 0.866, 0.2598], [-1, 0, 0]],
        },
    ),
    "wheels-3": (
        {"l": 35, "r": 3, "theta": 110, "x_dot": 0.4, "y_dot": 0.6, "omega": 0.5},
        {
            "M19": [-25.203, 16.1781, -8.4752],
            "M20": [21.3648, 4.6369, -20.0163],
            "M34": [25.203, 8.4752, -16.1781],
            "M35": [13.5363, 5.5585, -19.0948],
            "M21": [-11.5222, -23.2142, 17.2363],
            "division by r": [0.4061, -0.0957, -0.8353],
            "heading is left out": [-25.8333, 15.7137, -7.3803],
        },
    ),
    "wheels-4": (
        {"l": 25, "r": 6, "theta": 60, "w_1": 4, "w_2": -6, "w_3": 9},
        {
            "M19": [-0.3464, -0.4, -0.56],
            "M20": [-0.1732, -0.5, -1.12],
            "M34": [-0.1732, -0.5, 0.56],
            "M21": [-0.3464, 0.4, -0.56],
            "radius of the wheels": [-2.8868, -8.3333, -9.3333],
            "as the robot sees": [-0.5196, -0.1, -0.56],
        },
    ),
    "wheels-5": (
        {"fixed": "one fixed wheel", "steered": "two steered wheels", "free": "three balls"},
        {
            "forbid nothing": [2, 1, 3],
            "every steered wheel counts": [1, 2, 3],
            "without the steering": [1, 1, 1],
        },
    ),
    "wheels-6": (
        {"r": 5, "l": 20, "alpha": 90, "omega": 1.5, "p_x": -0.75, "p_y": 0},
        {"M19": [-4.4518, -20.1943], "M34": [-4.4518, 20.1943], "M35": [-4.4518, 21.7403]},
    ),
    "wheels-7": (
        {"r": 4, "l": 10, "w_1": 1, "w_2": -6, "w_3": -6, "w_4": -1},
        {
            "M19": [-0.1, 0.14, 1.2, -0.02],
            "M34": [-0.1, -0.14, -1.2, -0.02],
            "M35": [-0.1, -0.1386, -0.0139, 0.1],
            "slip has the other sign": [-0.1, -0.14, 1.2, 0.02],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "equal-rates": "it turns on the spot",
    "turned-wheels": "90° and −90°",
    "both-by-20": "none",
}
