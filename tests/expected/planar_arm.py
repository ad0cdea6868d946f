"""Expected values for the chapter on the planar arm: figures, feedback, predictions."""

import numpy as np

from book.planar_arm import figures
from book.planar_arm.figures import DURATION, SPEED_OUT
from robokin import planar_arm

LINKS, START = np.array(figures.LINKS), np.array(figures.START, dtype=float)
START_X = planar_arm.forward(START, LINKS)[0]


def hand_of(*columns):
    """Return the pose of the hand, (n, 3), from columns of joint angles."""
    return planar_arm.forward(np.column_stack(columns), LINKS)


def levers_readouts(turns1, turns2, turns3, theta2):
    start1, _, start3 = (np.full_like(theta2, angle) for angle in START)
    theta = np.column_stack([start1, theta2, start3])
    rates = np.column_stack([turns1, turns2, turns3])
    return {"length": np.hypot(*planar_arm.velocity(theta, rates, LINKS)[:, :2].T)}


def draw_readouts(theta1, theta2, theta3):
    x, y, _ = hand_of(theta1, theta2, theta3).T
    dots = {"middle": (START_X - 0.1) / 2, "end": -0.1}
    return {"off": np.abs(y - 0.5)} | {k: np.hypot(x - dot, y - 0.5) for k, dot in dots.items()}


def by_itself_readouts(t):
    start = planar_arm.forward(START, LINKS)
    x = start[0] + (-0.1 - start[0]) * t / DURATION
    theta = planar_arm.inverse(np.column_stack([x, 0 * t + 0.5, 0 * t]), LINKS)[:, 0]
    return dict(zip(("theta1", "theta2", "theta3"), theta.T, strict=True))


def flat_readouts(theta2):
    theta = np.column_stack([0 * theta2 + START[0], theta2, 0 * theta2 - np.pi / 3])
    wrist = planar_arm.joint_positions(theta, LINKS)[:, 2]
    outward = SPEED_OUT * wrist / np.linalg.norm(wrist, axis=1)[:, None]
    found = planar_arm.joint_rates(theta, np.column_stack([outward, 0 * theta2]), LINKS)
    return {"rate1": found[:, 0], "rate3": found[:, 2]}


def ellipse_readouts(theta2, theta3):
    theta = np.column_stack([np.full_like(theta2, START[0]), theta2, theta3])
    sizes, _ = planar_arm.ellipse(theta, LINKS)
    return {"round": sizes[:, 1] / sizes[:, 0]}


def joints_readouts(theta1, theta2, theta3, rate1, rate2, rate3):
    bend = np.abs(np.sin(theta2))
    return {"near": np.where(bend <= 1e-9, np.inf, np.where(bend < 0.1, np.nan, bend))}


def force_readouts(push, push_angle):
    force = push * np.array([np.cos(push_angle), np.sin(push_angle), 0 * push])
    torques = planar_arm.jacobian(START, LINKS).T @ force
    return {f"torque{k}": row for k, row in enumerate(torques, 1)}


def four_links_readouts(psi):
    wrist = planar_arm.joint_positions(np.radians([30, 60, -90, 40]), [0.4, 0.3, 0.2, 0.1])[3]
    pose = np.column_stack([0 * psi + wrist[0], 0 * psi + wrist[1], psi])
    return {"first": planar_arm.inverse(pose, LINKS)[:, 0, 0]}


def line_readouts(t, steps, gain, damping, line_x, line_y):
    """Follow the line by the library, in parts of a step in which the rates stay."""
    line = np.column_stack([line_x, line_y, 0 * line_x])
    begin = planar_arm.forward(START, LINKS)
    way = line - begin
    theta = np.tile(START, (len(t), 1))
    rates, worst, busiest = np.zeros_like(theta), 0 * t, 0 * t
    parts = np.ceil(60 / steps)  # of a step
    made = t * steps / DURATION  # steps
    count = np.ceil(np.maximum(0, made - 1e-6) * parts)
    for k in range(int(count.max())):
        runs = k < count
        done = np.floor((k + 1e-6) / parts)
        hand = planar_arm.forward(theta, LINKS)
        error = begin + way * (done / steps)[:, None] - hand
        twist = way / DURATION + gain[:, None] * error
        now = planar_arm.joint_rates(theta, twist, LINKS, damping, singular="nan")
        begins = runs & (k - done * parts < 0.5)
        rates = np.where(begins[:, None], now, rates)
        lasts = np.minimum(1, made * parts - k) * DURATION / (steps * parts)
        theta = np.where(runs[:, None], theta + rates * lasts[:, None], theta)
        part = np.minimum(k + 1, made * parts) / parts / steps
        off = (planar_arm.forward(theta, LINKS) - begin - way * part[:, None])[:, :2]
        worst = np.where(runs, np.maximum(worst, np.hypot(*off.T)), worst)
        busiest = np.where(runs, np.maximum(busiest, np.abs(rates).max(axis=1)), busiest)
    off = planar_arm.forward(theta, LINKS) - begin - way * (t / DURATION)[:, None]
    distance = np.hypot(line_x - LINKS[2], line_y)
    room = np.minimum(LINKS[0] + LINKS[1] - distance, distance - abs(LINKS[0] - LINKS[1]))
    reached = ~np.isnan(planar_arm.inverse(line, LINKS, unreachable="nan")[:, 0, 0])
    room = np.where(reached, room, np.nan)
    return {"off": np.hypot(*off[:, :2].T), "worst": worst, "busiest": busiest, "room": room}


def elbows_readouts(x, y, phi):
    pose = np.column_stack([x, y, phi])
    both = planar_arm.inverse(pose, LINKS, unreachable="nan")
    wrist = np.hypot(x - LINKS[2] * np.cos(phi), y - LINKS[2] * np.sin(phi))
    missed = np.maximum(0, np.maximum(wrist - LINKS[0] - LINKS[1], LINKS[0] - LINKS[1] - wrist))
    names = [f"{line}{joint}" for line in ("solid", "pale") for joint in (1, 2, 3)]
    angles = dict(zip(names, both.reshape(-1, 6).T, strict=True))
    return {**angles, "distance": wrist, "missed": missed}


def wrong_arm(*columns):
    """Return how the hand has moved from the start, and how its program believes: (n, 3) each."""
    m26, m27, m28, m29, m36, m37 = (column > 0.5 for column in columns[:6])
    phi_dot, t = columns[6:]
    theta = np.tile(np.radians([15, 90, -20]), (len(t), 1))
    twist = np.column_stack([np.full_like(t, -0.15), 0 * t, phi_dot])
    start = planar_arm.forward(theta, LINKS)
    for _ in range(24):
        J = planar_arm.jacobian(theta, LINKS)
        x, y = (LINKS * part(theta.cumsum(axis=1)) for part in (np.cos, np.sin))
        wrong = J.copy()
        wrong[m26, 2] = [0, 0, 1]
        wrong[m27, 1] = x[m27]
        wrong[m28] = planar_arm.jacobian(theta[m28], LINKS[[0, 1, 1]])
        wrong[m36, 0] += 2 * y[m36, 2:]
        wrong[m37, 0], wrong[m37, 1] = J[m37, 1], -J[m37, 0]
        rates = np.linalg.solve(wrong, twist[:, :, None])
        rates[m29] = J[m29] @ twist[m29, :, None]
        theta = theta + rates[:, :, 0] * t[:, None] / 24
    return planar_arm.forward(theta, LINKS) - start, twist * t[:, None]


def wrong_arm_readouts(*columns):
    real, believed = wrong_arm(*columns)
    off = believed - real
    return {"apart": np.hypot(off[:, 0], off[:, 1]), "turned": off[:, 2]}


def stays_but_turns(*columns):
    """Whether the hand is in its place, but turned."""
    found = wrong_arm_readouts(*columns)
    return (found["apart"] < 0.01) & (found["turned"] < np.radians(-2))


def leaves_the_line(*columns):
    """Whether the hand is off its line at the end of the drive."""
    real, believed = wrong_arm(*columns[:7], 0 * columns[7] + 2)
    return np.abs(real - believed)[:, 1] > 0.05


def too_far_clockwise(*columns):
    """Whether the hand goes too far: to the left, so x is too small."""
    real, believed = wrong_arm(*columns)
    return (columns[6] > -1e-9) | (real[:, 0] < believed[:, 0] - 0.005)


def too_short_clockwise(*columns):
    """Whether the hand does not go far enough: to the left, so x is too large."""
    real, believed = wrong_arm(*columns)
    return (columns[6] > -1e-9) | (real[:, 0] > believed[:, 0] + 0.005)


def stays_behind(*columns):
    """Whether the hand stays behind on its way to the left."""
    real, believed = wrong_arm(*columns)
    return real[:, 0] > believed[:, 0] + 0.05


def goes_across(*columns):
    """Whether the hand goes at right angles to its way."""
    real, believed = wrong_arm(*columns)
    along = np.sum(real[:, :2] * believed[:, :2], axis=1)
    return np.abs(along) < 0.05 * np.sum(believed[:, :2] ** 2, axis=1)


RATES = ("rate1", "rate2", "rate3")


def on_line(x, *offs):
    """Return angles of arms whose pens are so far from a point of the line."""
    poses = [[x + dx, 0.5 + dy, 0] for dx, dy in offs]
    theta = planar_arm.inverse(poses, LINKS)[:, 0]
    return [dict(zip(("theta1", "theta2", "theta3"), each, strict=True)) for each in theta]


def turning_about(x, y):
    """Return rates that turn the hand about a point, at 0.3 rad/s."""
    hand = planar_arm.forward(START, LINKS)
    found = planar_arm.joint_rates(START, 0.3 * np.array([y - hand[1], hand[0] - x, 1]), LINKS)
    return [dict(zip(RATES, found, strict=True))]


AT_END = {"t": DURATION}
STRETCHED, FOLDED = {"theta2": 0.0}, {"theta2": np.pi}
OUT = {**AT_END, "line_x": 0.85, "line_y": 0.7, "damping": 0.05}
BACK = {**AT_END, "line_x": -0.4, "line_y": 0.0, "damping": 0.05}
IN_THE_HOLE = {"line_x": 0.2, "line_y": 0.0}
BENT = {"theta1": 0.0, "theta2": 0.7, "theta3": -2.01, "rate2": 0.1, "rate3": 0.0}
CLOSED_LOOP = {**AT_END, "gain": 2.0, "n": 30, "damping": 0.05}

READOUTS = {
    "draw-line": draw_readouts,
    "by-itself": by_itself_readouts,
    "arm-levers": levers_readouts,
    "flat": flat_readouts,
    "ellipse": ellipse_readouts,
    "force-line": force_readouts,
    "four-links": four_links_readouts,
    "arm-joints": joints_readouts,
    "arm-line": line_readouts,
    "arm-elbows": elbows_readouts,
    "wrong-arm": wrong_arm_readouts,
}
SPECIALS = {
    "arm-levers": [{"joint": "joint 3"}, {"joint": "joint 1", "theta2": 0.0}],
    "arm-joints": [
        STRETCHED,
        FOLDED,
        {**STRETCHED, "theta3": 0.0},
        {**FOLDED, "theta3": np.pi},
        {"theta2": np.radians(2)},
        {"theta2": np.radians(-2)},
    ],
    "arm-line": [
        IN_THE_HOLE,
        {**IN_THE_HOLE, **AT_END, "damping": 0.05},
        OUT,
        BACK,
        {**OUT, **CLOSED_LOOP},
        {**BACK, **CLOSED_LOOP},
        {**CLOSED_LOOP, "damping": 0.3},
        AT_END,
        {"t": 1.4},
        {**AT_END, "n": 5},
        {**AT_END, "n": 100},
    ],
    "arm-elbows": [
        {"x": 0.2, "y": 0.0},  # the wrist at the base
        {"x": 0.301, "y": 0.0},  # nearly folded, and nearly stretched: closer a double's rounding
        {"x": 0.899, "y": 0.0},  # of d decides
        {"x": 0.9, "y": 0.9},
        {"phi_hand": np.pi / 2},
    ],
    "wrong-arm": [{"phi_dot": 0.0}, {"mistake": "It stays behind", "phi_dot": 0.6}],
}
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "draw-line": [
        (on_line(0.2232, (0, 0), (0, 0.018)), on_line(0.2232, (0, 0.023))),
        (on_line(-0.1, (0, 0), (0.018, 0), (0, 0.018)), on_line(-0.1, (0.023, 0))),
    ],
    "balance": [
        (
            [{"rate1": 0.2, "rate2": -0.3, "rate3": 0.119}],
            [{"rate1": 0.2, "rate2": -0.3, "rate3": 0.121}, dict.fromkeys(RATES, 0.0)],
        ),
        (
            [{"rate1": 0.2, "rate2": 0.2, "rate3": 0.015}],
            [
                {"rate1": 0.2, "rate2": 0.2, "rate3": 0.03},
                {"rate1": 0.2, "rate2": 0.25, "rate3": 0.0},
            ],
        ),
    ],
    "areas": [
        (
            [{"x_c": 0.3464, "y_c": 0.219}, {"x_c": 0.327, "y_c": 0.2}],
            [{"x_c": 0.3464, "y_c": 0.221}, {"x_c": 0.326, "y_c": 0.2}],
        ),
        (
            [{"x_c": 0.1732, "y_c": 0.25}, {"x_c": 0.184, "y_c": 0.25}],
            [{"x_c": 0.187, "y_c": 0.25}, {"x_c": 0.3464, "y_c": 0.5}],
        ),
    ],
    "ellipse": [
        (
            [{"theta2": np.radians(96), "theta3": np.radians(101)}],
            [{"theta2": np.radians(90), "theta3": np.radians(101)}],
        )
    ],
    "arm-line": [
        (
            [{**AT_END, "gain": 2.0, "n": 100}, {**AT_END, "gain": 6.0, "n": 30}],
            [{**AT_END, "gain": 2.0, "n": 50}, {"t": 3.9, "gain": 2.0, "n": 100}],
        ),
        (
            [{**AT_END, "gain": 6.0, "n": 50, "damping": 0.05}],
            [
                {**AT_END, "gain": 6.0, "n": 50, "damping": 0.02},
                {**AT_END, "gain": 4.0, "n": 50, "damping": 0.1},
            ],
        ),
    ],
    "arm-joints": [
        (
            [{**BENT, "rate1": 0.014}],
            [{**BENT, "rate1": 0.0, "theta3": -1.72}, {**BENT, "rate1": 0.016}],
        ),
        (turning_about(0.1, 0.365), turning_about(0.1, 0.375)),
        (
            [{"theta2": 3.1226, "theta3": 1.94}],
            [{"theta2": 3.12, "theta3": 1.94}, {"theta2": 0.0, "theta3": -2.18}],
        ),
    ],
    "weight-letters": [
        (
            [{"name_1": "ICR", "name_2": "½ det J"}],
            [{"name_1": "½ det J", "name_2": "ICR"}, {"name_1": "ICR", "name_2": "w"}],
        )
    ],
}
TITLES = {
    "wrong-arm": {
        "In its place, but turned": stays_but_turns,
        "It leaves the line": leaves_the_line,
        "Too far if clockwise": too_far_clockwise,
        "It stays behind": stays_behind,
        "Too short if clockwise": too_short_clockwise,
        "It goes off at right angles": goes_across,
    }
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("arm-joints", STRETCHED, "near", "0: singular"),
    ("arm-joints", STRETCHED, "elbow", "no rate does it"),
    ("arm-joints", FOLDED, "near", "0: singular"),
    ("arm-joints", {"theta2": np.radians(4)}, "near", "below 0.1: nearly singular"),
    ("arm-line", {"line_x": 0.85, "line_y": 0.6}, "room", "no: outside"),
    ("arm-line", IN_THE_HOLE, "room", "no: outside"),
    ("arm-elbows", {"x": 0.9, "y": 0.9}, "solid1", "out of reach"),
    ("arm-elbows", {"x": 0.2, "y": 0.0}, "pale3", "out of reach"),
]
POSE = {"l1": 45, "l2": 35, "l3": 20, "theta1": 70, "theta2": 110, "theta3": -30}
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "planar-arm-1": (
        {"l1": 45, "l2": 45, "l3": 20, "theta1": -30, "theta2": 100, "theta3": -30, "q1": -1.0},
        {
            "M26": [0.3264, -0.6968, 0],
            "M27": [0.3264, -0.3897, -1],
            "M28": [0.4871, -0.8883, -1],
            "M36": [0.0693, -0.6968, -1],
            "M37": [-0.6968, -0.3264, -1],
            "in ẋ and in ẏ each": [-0.225, -0.3897, -1],
            "when in ẋ each": [-0.225, -0.6968, -1],
        },
    ),
    "planar-arm-2": (
        dict(l1=30, l2=30, l3=10, theta1=110, theta2=50, theta3=-10, q1=-0.8, q2=0.2, q3=-0.8),
        {
            "M26": [0.3571, 0.3725, -0.8],
            "M27": [0.3571, 0.095, -1.4],
            "M28": [0.4971, 0.615, -1.4],
            "M36": [0.2171, 0.3725, -1.4],
            "M37": [0.3725, -0.3571, -1.4],
            "in ẋ and in ẏ each": [0.245, 0.095, -1.4],
            "when in ẋ each": [0.245, 0.3725, -1.4],
            "M28 and M36": [0.0771, 0.615, -1.4],
        },
    ),
    "planar-arm-3": (
        {"l1": 55, "l2": 35, "l3": 20, "theta1": 20, "phi": -70},
        {"M26": [[0.6082, -2.179], [2.5333, -4.1041]]},
    ),
    "planar-arm-4": (
        dict(l1=55, l2=45, l3=25, theta1=100, theta2=30, theta3=-80, f_x=35, f_y=5, m=-2),
        {
            "M26": [-38.846, -19.4109, -7.8994],
            "M27": [-40.2032, -22.2144, -7.8994],
            "M28": [-45.5655, -26.1304, -12.6189],
            "M36": [-27.4402, -8.0051, 5.5064],
            "M37": [-4.4529, -3.8184, 4.5819],
            "where its transpose": [-40.0238, -8.8064, 38],
        },
    ),
    "planar-arm-5": (
        dict(
            l1=40, l2=35, l3=20, theta1=70, theta2=110, theta3=-30, v_x=-0.1, v_y=0.25, omega=-0.4
        ),
        {
            "M26": [0.4342, -0.666, -0.4],
            "M27": [0.3725, -0.3691, -0.4034],
            "M28": [0.4523, -0.6434, -0.2089],
            "M36": [0.1596, -0.6136, 0.0539],
            "M37": [0.7715, 0.0137, -1.1852],
            "M29": [0.0626, -0.0229, -0.25],
            "the transpose": [-0.449, -0.5208, -0.4333],
        },
    ),
    "planar-arm-6": (
        dict(l1=45, l2=50, l3=15, theta1=120, theta2=120, theta3=-40, towards=340, limit=1.5),
        {
            "M26": 0.7173,
            "M27": 0.4327,
            "M37": 0.5936,
            "M29": 2.5097,
            "as a vector": 0.5228,
            "slowest joint": 3.3664,
        },
    ),
    "planar-arm-7": (
        {"l1": 50, "l2": 45, "l3": 20, "theta1": 100, "theta2": 150, "theta3": 70},
        {
            "M27": 0.1131,
            "M28": 0.1983,
            "M36": 0.0665,
            "without the root": 0.0099,
            "all three rows": 0.1125,
        },
    ),
    "planar-arm-8": (
        {**POSE, "q1": -0.8, "q2": 0.5, "q3": -0.6},
        {
            "without their signs": [-0.0214, 0.2448],
            "far end of its link": [-0.0004, 0.4895],
            "not divided": [0.1946, -0.0423],
        },
    ),
    "planar-arm-9": (
        {"sigma": 0.03, "lam": 0.05, "v": 0.2},
        {
            "without damping": 6.6667,
            "where λ² belongs": 0.1179,
            "σ + λ below": 2.5,
            "largest rate that any": 2.0,
        },
    ),
    "planar-arm-10": (
        POSE,
        {
            "M27": [0.5475, 0.412],
            "M28": [1.0443, 0.3095],
            "M36": [0.6691, 0.3415],
            "root of the eigenvalues": [0.6395, 0.094],
            "lengths of the rows": [0.6634, 0.5416],
        },
    ),
    "planar-arm-11": (
        {**POSE, "q1": 0.6},
        {
            "M27": [3.5958, -6.733],
            "M28": [0.9194, -2.9692],
            "M36": [-1.5917, 3.5289],
            "sign of joint 1": [-0.9194, 4.0566],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "both-wheels-alike": "at infinity",
    "where-the-pen-goes": (
        "x 0.0464 m, y 0.4 m",
        "−0.5 m, 0.546 m",
        "0.646 m, 0 m",
        "0.346 m, 0.7 m",
    ),
    "how-fast-turned": ("0.1 rad/s", "0.4 rad/s", "1.1 rad/s", "0.0333 rad/s"),
    "where-the-sheet-rests": (
        "x 0.231 m, y 0.233 m",
        "0 m, 0 m",
        "0.346 m, 0.2 m",
        "0.346 m, 0.5 m",
    ),
    "who-rests": "joint 2",
    "ever-nearer": "10 times",
    "a-free-hand": "while joint 3 is bent",
    "damped-to-the-end": "0",
    "without-a-look": "5 cm off",
    "too-much-feedback": "6",
}
