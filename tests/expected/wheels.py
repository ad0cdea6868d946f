"""Expected values for the chapter on wheel constraints: figures, feedback, predictions."""

import numpy as np

from robokin import bicycle, motion, wheels

QUARTER = np.pi / 2
OMNI = wheels.omni_robot(0.2, 0.05)


def kinds_readouts(*columns):
    found = np.array([of_kind(*row) for row in zip(*columns, strict=True)])
    return {"rolled": found[:, 0], "aside": found[:, 1]}


def of_kind(slanted, straight, castor, ball, fixed, course):
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


def after_push(pose, push, locked):
    """Return the trolley's pose after a push: its centre is found from axle line and hand."""
    x, y, theta = pose
    if not locked:
        return np.array([x + push[0], y + push[1], theta])
    there, ahead = complex(x, y), np.exp(1j * theta)
    rear, hand = there - 0.42 * ahead, there - 0.54 * ahead
    moved, aside = hand + complex(*push), 1j * ahead
    across = (np.conj(aside) * complex(*push)).real
    if abs(across) <= 1e-4:
        there = there + (np.conj(ahead) * complex(*push)).real * ahead
        return np.array([there.real, there.imag, theta])
    # as far from the hand before as after: on the line across the middle of its way
    middle, way = (hand + moved) / 2, moved - hand
    far = (np.conj(way) * (middle - rear)).real / (np.conj(way) * aside).real
    centre = rear + far * aside
    turn = np.angle((moved - centre) / (hand - centre))
    there = centre + (there - centre) * np.exp(1j * turn)
    return np.array([there.real, there.imag, theta + turn])


def trolley_readouts(*columns):
    found = []
    for locked, *pushes in zip(*columns, strict=True):
        pose = after_push((0.0, 0.0, 0.0), pushes[2:4] if locked else pushes[:2], locked)
        x, y, theta = after_push(pose, pushes[4:], locked) if locked else pose
        found.append([np.hypot(x - 0.7, y - 0.85), theta])
    return dict(zip(("off", "turned"), np.transpose(found), strict=True))


def place_readouts(alpha, beta):
    return {"rolls": alpha + beta - QUARTER}


def lines_readouts(*columns):
    ranks = []
    for *numbers, turned in zip(*columns, strict=True):
        made = []
        for x, y, axle, there, own in np.reshape(numbers, (3, 5)):
            spoke = np.arctan2(y, x)
            if there:
                turn = axle + own * turned - spoke
                made.append(wheels.fixed(np.hypot(x, y), spoke, turn, 0.05))
        ranks.append(np.linalg.matrix_rank(wheels.sliding(made), tol=1e-9))
    return {"rank": np.array(ranks), "ways": 3 - np.array(ranks)}


def front_readouts(left, right):
    centres = [
        bicycle.turning_radius(angle, 2.5) + side * 0.75 for side, angle in ((1, left), (-1, right))
    ]
    return {"gap": np.abs(centres[0] - centres[1])}


def castor_readouts(beta):
    """Return how fast the castor swivels: its contact point must not move along the axle."""
    found = []
    for angle in beta:
        contact = -0.2 - 0.05j * np.exp(1j * (np.pi + angle)) * -1
        spoke = np.angle(contact)
        made = [wheels.fixed(abs(contact), spoke, np.pi + angle - spoke, 0.05)]
        found.append((wheels.sliding(made) @ [0.2, 0.0, 0.5])[0] / 0.05)
    return {"beta_dot": np.array(found)}


def triangle_readouts(x, y):
    twist = np.stack([-0.25 * y, 0.25 * x, -0.25 + 0 * x], axis=-1)
    return dict(zip(RATES, wheels.inverse(OMNI, twist).T, strict=True))


def mecanum_robot():
    """Return the robot of the figure."""
    made = []
    for x, y, side in ((0.2, 0.15, -1), (0.2, -0.15, 1), (-0.2, 0.15, 1), (-0.2, -0.15, -1)):
        spoke = np.arctan2(y, x)
        place = np.hypot(x, y), spoke, QUARTER - spoke
        made.append(wheels.swedish(*place, 0.05, side * np.pi / 4))
    return made


def mecanum_readouts(*columns):
    rates = 2 + np.transpose(columns[:4]) * columns[4][:, None]
    return {"slip": wheels.slip(mecanum_robot(), rates)[:, 0]}


def laboratory_readouts(*columns):
    found = np.array([laboratory(row) for row in zip(*columns, strict=True)])
    names = "now", "mobility", "steerability", "both", "v", "v_y", "omega"
    return dict(zip(names, found.T, strict=True))


def laboratory(row):
    """Return the readouts at one setting."""
    bases, kinds, shifts = np.reshape(row[1:17], (4, 4)), row[18:22], np.reshape(row[22:30], (4, 2))
    turns, wish = row[30:34], np.array(row[34:37])
    robot = []
    for base, other, shift, turn in zip(bases, kinds, shifts, turns, strict=True):
        kind = base[3] if other < 0 else other
        if kind in (1, 2):
            robot.append(held_wheel(base, kind == 2, shift, turn, wish))
    rows = wheels.sliding(robot)
    _, sizes, turned = np.linalg.svd(rows) if len(rows) else (0, np.zeros(0), np.eye(3))
    rank = np.count_nonzero(sizes > 1e-9 * sizes.max(initial=0))
    free = turned[rank:]
    return [3 - rank, *wheels.mobility(robot), *(free.T @ free @ wish)]


def held_wheel(base, is_steered, shift, turn, wish):
    """Return a fixed wheel as it was turned, or a steered one across the wish."""
    x, y = base[:2] + shift
    rolls = base[2] + turn
    if is_steered:
        rolls = np.arctan2(wish[1] + wish[2] * x, wish[0] - wish[2] * y)
    l, alpha = np.hypot(x, y), np.arctan2(y, x)  # noqa: E741
    return (wheels.steered if is_steered else wheels.fixed)(l, alpha, rolls + QUARTER - alpha, 0.07)


def omni_readouts(rate1, rate2, rate3, theta, t):
    rates = np.stack([rate1, rate2, rate3], axis=-1)
    twist = wheels.forward(OMNI, rates)
    start = np.stack([0 * theta, 0 * theta, theta], axis=-1)
    pose = motion.move(start, twist, t)
    return dict(zip(("x", "y", "heading"), pose.T, strict=True))


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


TURNING = "Its turning rate varies"
RATES = ("omni_rate1", "omni_rate2", "omni_rate3")

READOUTS = {
    "trolley": trolley_readouts,
    "wheel-place": place_readouts,
    "axle-lines": lines_readouts,
    "front-wheels": front_readouts,
    "wheel-kinds": kinds_readouts,
    "castor": castor_readouts,
    "push-lines": triangle_readouts,
    "omni": omni_readouts,
    "mecanum": mecanum_readouts,
    "wheel-laboratory": laboratory_readouts,
    "wrong-rates": wrong_rates_readouts,
}
DEGREE = np.pi / 180
LOCKED = {"rear": "locked"}
BUILT = {"robot": "nothing yet", "kind1": "fixed"}
PUSHES = ("push1_x", "push1_y", "push2_x", "push2_y")
SWINGS = dict(zip(PUSHES, (0.46, 0.26, 0.24, 0.58), strict=True))
SPECIALS = {
    "trolley": [LOCKED, {**LOCKED, "push1_x": 0.4}, {**LOCKED, **SWINGS}, {"push0_y": 0.3}],
    "axle-lines": [
        {"wheels": kind, "turned": turned}
        for kind in ("one", "two on one line", "two in a row", "three")
        for turned in (0.0, QUARTER)
    ],
    "wheel-kinds": [{"kind": kind, "course": QUARTER} for kind in ("fixed", "Mecanum, 45°")],
    "wheel-laboratory": [
        {"robot": robot, "wish_vy": left, "wish_omega": turn}
        for robot in ("car", "bicycle", "two steered wheels", "omni robot", "nothing yet")
        for left, turn in ((0.0, 0.0), (0.0, 0.5), (0.1, 0.5))
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
    "wheels-8": (
        {"l": 20, "alpha": 60, "beta": 30, "behind": 4, "v": 0.4, "v_y": -0.2, "omega": 0.5},
        {"d is missing": [-3.75], "d positive": [3.25], "l sin β is missing": [-5.5]},
    ),
    "wheels-9": (
        {"l": 20, "alpha": 60, "beta": 15, "p_x": 0.75, "p_y": -0.5},
        {"from the axle": [1.0297], "x axis": [-0.8029], "other sign": [0.5411]},
    ),
    "wheels-10": (
        {"L": 2.5, "b": 1.5, "left": 30},
        {"parallel front wheels": [0.5236], "turned more": [0.7235], "bicycle": [0.4573]},
    ),
    "wheels-11": (
        {"drawn": "fixed wheels at A and B, and a steered wheel at C", "x": 40, "y": 20},
        {
            "every fixed wheel": [1, 0, 1],
            "forbid nothing": [2, 1, 3],
            "without the steering": [1, 1, 1],
        },
    ),
}
GOALS = {
    "trolley": [
        (
            [{"push0_x": 0.7, "push0_y": 0.84}, {"push0_x": 0.7, "push0_y": 0.76}],
            [{"push0_x": 0.7, "push0_y": 0.74}, {**LOCKED, **SWINGS, "push2_y": 0.62}],
        ),
        ([{**LOCKED, **SWINGS}], [SWINGS, {**LOCKED, **SWINGS, "push2_y": 0.62}]),
    ],
    "wheel-place": [
        (
            [{"wheel_alpha": QUARTER, "wheel_beta": 1.9 * DEGREE}],
            [
                {"wheel_alpha": QUARTER, "wheel_beta": 2.1 * DEGREE},
                {"wheel_alpha": 120 * DEGREE, "wheel_beta": -30 * DEGREE},
            ],
        )
    ],
    "sliding": [
        ([{"x_Q": -0.2, "y_Q": 0.36}], [{"x_Q": -0.2, "y_Q": 0.37}, {"x_Q": -0.12, "y_Q": 0.21}]),
        ([{"x_Q": 0.1, "y_Q": -0.17}], [{"x_Q": 0.1, "y_Q": -0.19}, {"x_Q": -0.2, "y_Q": 0.36}]),
    ],
    "rolling": [  # 2 rad/s are 0.2 m from the line, 0.06 rad/s 6 mm
        ([{"x_Q": -0.1, "y_Q": 0.173}], [{"x_Q": -0.1, "y_Q": 0.181}]),
        ([{"x_Q": 0.01, "y_Q": 0.0}], [{"x_Q": 0.02, "y_Q": 0.0}]),
    ],
    "axle-lines": [
        ([{"turned": 0.0}], [{"turned": DEGREE}, {"wheels": "one", "turned": 0.0}]),
        (
            [{"wheels": "two on one line", "turned": 0.0}],
            [{"wheels": "two on one line", "turned": DEGREE}, {"wheels": "one", "turned": 0.0}],
        ),
    ],
    "front-wheels": [([{"steer_R": 16.5 * DEGREE}], [{"steer_R": 17 * DEGREE}])],
    "castor": [  # 0.1 sin β − 0.2 cos β is 0.025 at −123.0° and, with the wheel ahead, at 69.8°
        (
            [{"wheel_beta": -122 * DEGREE}, {"wheel_beta": -124 * DEGREE}],
            [{"wheel_beta": -121 * DEGREE}, {"wheel_beta": 70 * DEGREE}],
        )
    ],
    "rollers": [
        (
            [{"rollers": "45°", "x_Q": -0.04}, {"rollers": "−45°", "x_Q": 0.2, "y_Q": 0.09}],
            [{"rollers": "45°", "x_Q": -0.045}, {"rollers": "0°", "x_Q": 0.1, "y_Q": 0.288}],
        )
    ],
    "push-lines": [
        ([{"x_Q": 0.01, "y_Q": 0.0}], [{"x_Q": 0.02, "y_Q": 0.0}]),
        ([{"x_Q": 0.21, "y_Q": 0.2}], [{"x_Q": 0.22, "y_Q": 0.2}, {"x_Q": 0.2, "y_Q": 0.1}]),
        ([{"x_Q": 0.61, "y_Q": -0.35}], [{"x_Q": 0.63, "y_Q": -0.35}]),
    ],
    "omni": [
        (
            [dict(zip(RATES, (0.1, 3.0, -3.0), strict=True))],
            [dict(zip(RATES, (0.3, 3.0, -3.0), strict=True))],
        ),
        (
            [dict(zip(RATES, (0.0, 2.0, -2.0), strict=True)) | {"theta": 55 * DEGREE, "t": 9.0}],
            [dict(zip(RATES, (0.0, 2.0, -2.0), strict=True)) | {"theta": 55 * DEGREE, "t": 8.0}],
        ),
    ],
    "turned-wheels": [([{"wheel_beta": 89.6 * DEGREE}], [{"wheel_beta": 89 * DEGREE}])],
    "wheel-laboratory": [
        (
            [{**BUILT, "wish_vy": 0.1, "wish_omega": 0.3}],
            [{**BUILT, "wish_omega": 0.3}, {"robot": "nothing yet", "wish_vy": 0.1}],
        ),
        (
            [{"robot": "differential drive", "kind3": "steered"}],
            [{"robot": "differential drive"}, {"robot": "bicycle"}],
        ),
        ([{"kind1": "castor", "kind2": "castor"}], [{"kind1": "castor"}]),
        ([{"shift_axle3": 5 * DEGREE}], [{"wish_vy": 0.1}]),
        (
            [{"robot": "omni robot", "wish_v": 0.0, "wish_vy": 0.15, "t": 3.2}],
            [
                {"robot": "omni robot", "wish_v": 0.0, "wish_vy": 0.15, "t": 3.5},
                dict(robot="omni robot", wish_v=0.0, wish_vy=0.15, wish_omega=0.05, t=3.0),
            ],
        ),
    ],
    "wheel-letters": [([{"name_1": "a", "name_2": "p"}], [{"name_1": "p", "name_2": "a"}])],
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "part-along": ("0.1 m/s", "0.173 m/s", "0.4 m/s"),
    "how-far-the-icr": ("1.73 m", "0.577 m", "2 m"),
    "no-skid": ("pin: x −0.173 m", "0.12 m", "−0.1 m"),
    "same-line": "it stays",
    "three-lines": "none",
    "both-by-20": "none",
    "no-roll": "135°",
    "equal-rates": "it turns on the spot",
    "which-turn-fails": "90° and −90°",
    "one-faster": "all four",
}
