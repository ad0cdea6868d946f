"""Expected values for the chapter on chains of frames: figures, feedback, predictions."""

from itertools import pairwise

import numpy as np

from book.frames import figures
from robokin import euler, frames, motion, planar_arm

LINKS = list(figures.LINKS.values())
DOWN = np.diag([1.0, -1.0, -1.0])
UP, FLAT = np.pi / 2, np.pi / 4


def wrist(alpha, beta):
    """Return where the hand is, as the platform sees it: (n, 2)."""
    return planar_arm.forward(np.stack([alpha, beta], axis=-1), LINKS)[:, :2]


def pose_of(T):
    """Return x, y, theta of planar matrices: (n, 3, 3) → (n, 3)."""
    return np.column_stack([T[:, 0, 2], T[:, 1, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def named(pose, *names):
    """Return the numbers of poses by the names of readouts."""
    return dict(zip(names, pose.T, strict=False))


def hand_on(platform, alpha, beta, gamma):
    """Return the hand in the room, and as the platform sees it."""
    T_bc = frames.se2(*wrist(alpha, beta).T, alpha + beta + gamma)
    return frames.compose(frames.se2(*platform), T_bc), T_bc


def chain_readouts(x_b, y_b, turn_b, alpha, beta, gamma, x_e, y_e, turn_e):
    """Return the object seen from the hand, and the hand seen from the platform."""
    graph = frames.FrameGraph()
    graph.add("d", "b", frames.se2(x_b, y_b, turn_b))
    graph.add("b", "c", frames.se2(*wrist(alpha, beta).T, alpha + beta + gamma))
    graph.add("d", "e", frames.se2(x_e, y_e, turn_e))
    found, hand = (pose_of(graph.get(*way)) for way in (("c", "e"), ("b", "c")))
    return named(found, "x", "y", "turn") | named(hand, "hand_x", "hand_y", "hand_turn")


def views_readouts(x_b, y_b, alpha, beta):
    """Return how far the object is from the middle between the fingers, and how far turned."""
    seen = chain_readouts(x_b, y_b, UP, alpha, beta, -FLAT, 1.5, 1.1, 3 * FLAT)
    turned = motion.wrap_angle(2 * seen["turn"]) / 2  # one way round or the other
    return {"off": np.hypot(seen["x"] - 0.17, seen["y"]), "turned": abs(turned)}


def tracing_readouts(gamma, lifted):
    still = 0 * gamma
    T_dc, _ = hand_on((1.0, 0.5, UP), still + UP, still - UP, gamma)
    seen = frames.transform(frames.inverse(T_dc), [1.5, 1.1])
    return {"x_ce": seen[:, 0], "y_ce": seen[:, 1]}


def directions_readouts(alpha, gamma):
    _, T_bc = hand_on((0.0, 0.0, 0.0), alpha, 0 * alpha - UP, gamma)
    found = pose_of(T_bc)
    return named(found, "bc_x", "bc_y") | {"bc_turn": alpha - UP + gamma}


def home_readouts(turn, part):
    back = frames.inverse(frames.se2(1.0 + 0 * turn, 0.5, turn))
    return {"x_bd": back[:, 0, 2], "y_bd": back[:, 1, 2]}


def domino_readouts(*numbers):
    """Return how far from the object the product of three tiles puts it."""
    product = frames.compose(*(frames.se2(*numbers[k : k + 3]) for k in (0, 6, 12)))
    there = frames.compose(frames.se2(0.7, 0.9, FLAT), product)[:, :2, 2]
    return {"off": np.hypot(*(there - [1.5, 1.1]).T)}


def about(axis, angle):
    """Return turns about an axis: (n,) → (n, 3, 3)."""
    return euler.to_matrix(axis, np.atleast_1d(angle)[:, None])


def above_readouts(turn, tilt, hidden, azimuth, elevation):
    """Return the object seen from the camera and from the hand, which a chain of frames tells."""
    eye, base, thing = [0, 0, 1.2], [-0.2, -0.3, 0.0], [0.3, 0.3, -0.2]
    graph = frames.FrameGraph()
    graph.add("r", "f", frames.se3(about("Z", turn) @ DOWN @ about("X", tilt), eye))
    graph.add("r", "b", frames.se3(about("Z", UP + 0 * turn), base))
    graph.add("r", "e", frames.se3(np.eye(3), thing))
    graph.add("b", "c", frames.se3(about("Z", 0 * turn - FLAT), [0.4, 0.3, 0.0]))
    told = frames.compose(frames.se3(DOWN, eye), graph.get("f", "e"))[:, :3, 3]  # as it was hung up
    told = np.where(hidden[:, None] > 0, told, thing)
    seen = frames.transform(graph.get("c", "r"), told)
    return {
        **named(graph.get("f", "e")[:, :3, 3], "x_e", "y_e", "z_e"),
        **named(seen, "x", "y", "z"),
        "off": np.linalg.norm(told - thing, axis=-1),
    }


def graph_readouts(start, end):
    """Return how many poses are on the way, and how many of them are walked backwards."""
    graph, names = frames.FrameGraph(), "dbcerg"
    for edge in figures.EDGES:
        graph.add(*edge, np.eye(3))
    found = []
    for pair in zip(start.astype(int), end.astype(int), strict=True):
        way = graph.path(*(names[k] for k in pair))
        steps = ["".join(step) for step in pairwise(way)]
        found.append([len(steps), sum(step not in figures.EDGES for step in steps)])
    return named(np.array(found, dtype=float), "count", "turned")


def mounted(tilt_x, tilt_y, turn):
    return DOWN @ about("X", tilt_x) @ about("Y", tilt_y) @ about("Z", turn)


def loops_readouts(tilt_x, tilt_y, turn):
    hung, told, found = mounted(*np.radians([1.5, -1.0, 3.0])), mounted(tilt_x, tilt_y, turn), {}
    for k, (x, y) in enumerate(((0.35, 0.3), (-0.45, 0.2), (0.1, -0.4)), 1):
        there = np.array([x, y, -1.4])
        seen = np.swapaxes(hung, -1, -2) @ there
        found[f"gap_{k}"] = np.linalg.norm(np.einsum("nij,j->ni", told, seen[0]) - there, axis=-1)
    return found


def mistakes_readouts(*columns):
    """Return how far off the object is taken to be, and how far turned."""
    *made, turn = columns
    still = np.zeros_like(turn)
    angles = [still + angle for angle in (-np.pi / 2, 7 * np.pi / 12, np.pi / 4)]
    T_db = frames.se2(still + 0.6, still + 0.5, turn)
    T_bc = frames.se2(*wrist(*angles[:2]).T, sum(angles))
    T_de = frames.se2(-0.3, 0.6, -np.pi / 3)
    T_bd, T_cb = frames.inverse(T_db), frames.inverse(T_bc)
    by_sign = [frames.inverse(T) for T in (T_bc, T_db)]
    for back, T in zip(by_sign, (T_bc, T_db), strict=True):
        back[:, :2, 2] = -T[:, :2, 2]
    ways = (
        T_db @ T_bc @ T_de,
        by_sign[0] @ by_sign[1] @ T_de,
        T_bd @ T_cb @ T_de,
        T_bc @ T_bd @ T_de,
    )
    T_ce = sum(one[:, None, None] * way for one, way in zip(made, ways, strict=True))
    found = pose_of(frames.compose(T_db, T_bc, T_ce)) - [-0.3, 0.6, -np.pi / 3]
    return {"apart": np.hypot(*found[:, :2].T), "off": motion.wrap_angle(found[:, 2])}


READOUTS = {
    "two-views": views_readouts,
    "tracing": tracing_readouts,
    "directions": directions_readouts,
    "turned-home": home_readouts,
    "dominoes": domino_readouts,
    "camera-above": above_readouts,
    "frame-graph": graph_readouts,
    "room-plan": chain_readouts,
    "close-loops": loops_readouts,
    "wrong-object": mistakes_readouts,
}
SPECIALS = {
    "two-views": [{"joint_alpha": 0.0, "joint_beta": 0.0}],
    "tracing": [{"lifted": 1.0}, {"joint_gamma": 0.0, "lifted": 0.5}],
    "pose-columns": [{"db_turn": 0.0}, {"db_turn": UP}],
    "lamp": [{"made": 0.5}, {"made": 2.0}],
    "directions": [{"joint_alpha": 0.0, "joint_gamma": 0.0}],
    "two-orders": [{"made": 0.5}, {"made": 1.5}, {"made": 2.0}],
    "pole": [{"db_turn": UP, "db_y": 0.3}, {"part": 0.0}],
    "way-back": [{"lifted": 0.5}, {"lifted": 1.0}],
    "turned-home": [{"db_turn": 0.0}, {"part": 1.0}],
    "differences": [{"db_turn": 0.0}],
    "three-papers": [{"camera_turn": 0.0}],
    "camera-above": [
        {"camera_turn": UP, "cloth": "spread"},
        {"azimuth": 0.0, "elevation": 0.0},
        {"azimuth": 0.0, "elevation": UP},
    ],
    "loop-miss": [{"error": 0.0}],
    "frame-graph": [{"seen_from": "e", "sought": "c"}, {"seen_from": "g", "sought": "g"}],
    "room-plan": [
        {"db_turn": 0.0},
        {"joint_alpha": 0.0, "joint_beta": 0.0, "joint_gamma": 0.0},
        {"de_x": 0.7, "de_y": 0.9},  # the object in the hand
        {"de_x": 1.0, "de_y": 0.5},  # on the platform
    ],
    "wrong-object": [{"db_turn": 2 * np.pi / 3}],  # T_db T_bc is a half turn
}
# each names the step that is wrong, and claims nothing of the picture
NAMES = "No inverse", "Inverses by hand", "Two inverses", "One inverse"
TITLES = {"wrong-object": dict.fromkeys(NAMES)}
PLACED = dict(x_b=-1.6, y_b=-1.2, theta_b=60, x_e=1.2, y_e=0.2, theta_e=110)
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "frames-1": (
        {"x_b": 1.2, "y_b": -1, "theta_b": -110},
        {"M10": [-1.2, 1, 1.9199], "nothing is turned back": [1.2, -1, -1.9199]},
    ),
    "frames-2": (
        {"alpha": 50, "beta": -30, "gamma": -30, "x": 0.8, "y": 0.7},
        {"M10": [0.0976, 0.4617], "M30": [1.4781, 0.9171]},
    ),
    "frames-3": (
        {"x_b": 1.2, "y_b": -1, "theta_b": -70, "x_e": -1.2, "y_e": -1.8, "theta_e": 60},
        {
            "M9": [-0.9019, -0.488, -0.1745],
            "M10": [0.081, -0.7433, 2.2689],
            "along the camera's axes": [-2.4, -0.8, 2.2689],
            "as the object sees": [1.8928, -1.6785, -2.2689],
        },
    ),
    "frames-4": (
        {"x_b": -1.8, "y_b": 0.2, "theta_b": -10, "x": 0.6, "y": 0.5, "theta": -90},
        {
            "M9": [-1.1223, 0.5882, -1.7453],
            "M10": [-0.4, 1.3, 1.7453],
            "an inverse is made with −p": [1.1223, -0.5882, 1.7453],
            "one of the two inverses": [0.7, 1.2, 1.7453],
            "only T_bc is inverted": [0.3, -2.4, 1.3963],
            "M11": [2.404, -0.3885, 1.7453],
            "M30": [0.7156, -1.3074, -1.3963],
        },
    ),
    "frames-5": (
        {"alpha": 0, "beta": 30, "gamma": -20, **PLACED},
        {
            "M9": [[-1, 0, -1.2275], [0, -1, 0.6558], [0, 0, 1]],
            "M10": [[0.766, -0.6428, 1.736], [0.6428, 0.766, -0.3553], [0, 0, 1]],
            "M11": [[0.766, -0.6428, 2.0286], [0.6428, 0.766, -1.3058], [0, 0, 1]],
            "M30": [[0.5, -0.866, 3.5187], [0.866, 0.5, -1.045], [0, 0, 1]],
            "inverse of the product": [
                [0.766, -0.6428, 2.0484],
                [0.6428, 0.766, -0.519],
                [0, 0, 1],
            ],
            "one of the two inverses": [
                [0.766, -0.6428, 1.7111],
                [0.6428, 0.766, -0.24],
                [0, 0, 1],
            ],
            "as the platform sees it": [
                [0.6428, -0.766, 2.6124],
                [0.766, 0.6428, -1.7249],
                [0, 0, 1],
            ],
            "as the object sees it": [[0.766, 0.6428, 0.2108], [-0.6428, 0.766, 2.7433], [0, 0, 1]],
        },
    ),
    "frames-6": (
        {"height": 2.7, "x_b": 2, "y_b": -1.8, "heading": 10, "x_e": -0.6, "y_e": 0.2, "z_e": 1.7},
        {
            "M9": [1.3744, -1.8928, 1],
            "M10": [-2.6256, 1.7072, -4.4],
            "along the camera's axes": [-2.6, 2, -1],
            "counted down": [-2.9078, -1.5181, -1],
        },
    ),
    "frames-7": (
        {"alpha": -10, "beta": 40, "gamma": 40, "x_e": -1.6, "y_e": 0.6, "theta_e": 150},
        {
            "M10": [-0.9702, 0.4072, 1.3963],
            "M30": [-2.2298, 0.7928, -2.4435],
            "as the platform sees": [0.3288, -1.532, -1.3963],
        },
    ),
    "frames-8": (
        {"x_b": 1.2, "y_b": -1, "theta_b": -70, "x_e": -1.2, "y_e": -1.8, "x": 0.8, "y": 0.3},
        {"M30": 1.8755, "axes of b are turned": 3.3838},
    ),
    "frames-9": (
        dict(x_d=1.2, y_d=-1, theta_d=-70, x_b=-1.2, y_b=-1.8, theta_b=60, x=0.8, y=0.3),
        {
            "M9": [-0.0619, -0.3315],
            "M10": [-0.663, -0.3233],
            "wrong one of the two": [1.5231, -3.8819],
            "as the room sees": [-1.0598, -0.9572],
        },
    ),
    "frames-10": (
        {"theta_b": 40, "x": 1.2, "y": -0.4},
        {
            "exchanged": [1.1764, 0.4649, 0.6621, -1.0778],
            "by the angle from a to b": [1.1764, 0.4649, 1.1764, 0.4649],
            "by minus the angle": [0.6621, -1.0778, 0.6621, -1.0778],
        },
    ),
    "frames-11": (
        {"x_b": 1.2, "y_b": -1, "psi": -70, "x_e": -1.2, "y_e": -1.8},
        {"read with y up": [-0.0691, -2.5289], "along the picture's axes": [-2.4, -0.8]},
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "columns-of-a-turn": "the turned y axis points along z",
    "two-elbows": "two",
    "which-turns": "round to the right",
    "seen-lamp": ("x 0.85 m, y 0.7 m", "1.2 m, 0.65 m", "1.15 m, 0.7 m"),
    "shift-then-turn": ("x 0 m, y 0.8 m", "0.8 m, 0 m"),
    "camera-behind": (
        "to the right −0.067 m, ahead −1.12 m",
        "0.5 m, −1 m",
        "−1 m, −0.5 m",
    ),
    "of-a-plan": "the camera's numbers, with y up",
    "a-turned-camera": "none",
    "four-more": "1 and 2",
    "round-the-loop": "a turn by 2°",
}
AHEAD = 0.7071  # of 0.3 m along the hand's x axis, at 45°


def at_box(along=0.0, across=0.0):
    """Return settings with the hand's x axis at −45°, and the box so far off its grip, in m."""
    place = {"db_x": 0.9798 - AHEAD * (along - across), "db_y": 0.9202 + AHEAD * (along + across)}
    return {"joint_alpha": 0.0, "joint_beta": -UP, **place}


TO_E = np.arctan2(0.6, 0.5)  # from the platform to the object, seen from d
HUNG = dict(zip(("camera_tilt", "tilt_y", "camera_turn"), np.radians([1.5, -1, 3]), strict=True))
TILES = {"tile_1": "T_cb", "tile_2": "T_bd", "tile_3": "T_de"}
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "two-views": [
        (
            [
                {**at_box(), "db_x": 0.98, "db_y": 0.92},  # on the sliders' steps
                *(at_box(along) for along in (0.0498, -0.0498)),
                *(at_box(0.0, across) for across in (0.0298, -0.0298)),
            ],
            [at_box(0.0502), at_box(-0.0502), at_box(0.0, 0.0302), at_box(0.0, -0.0302)],
        )
    ],
    "pole": [  # at 90° the pole goes by 0.707 of the shift
        (
            [{"db_turn": UP, "db_y": 0.356}, {"db_turn": UP, "db_y": 0.244}],
            [{"db_turn": UP, "db_y": 0.357}, {"db_turn": UP, "db_y": 0.243}],
        )
    ],
    "dominoes": [
        (
            [TILES],
            [
                {**TILES, "tile_1": "T_cb with −p"},
                {**TILES, "tile_1": "T_bc"},
                {**TILES, "tile_2": "T_db"},
            ],
        )
    ],
    "differences": [  # 0.781 m away, so 2 cm are 1.467°
        (
            [{"db_turn": TO_E + 0.0256}, {"db_turn": TO_E - 0.0256}],
            [{"db_turn": TO_E + 0.0257}, {"db_turn": TO_E - 0.0257}, {"db_turn": TO_E - np.pi}],
        )
    ],
    "room-plan": [
        (
            [
                at_box(0.0498),
                {**at_box(), "de_turn": np.radians(135 + 14.9)},
            ],
            [
                at_box(0.0502),
                {**at_box(), "de_turn": np.radians(135 + 15.1)},
            ],
        ),
        (
            [{"de_x": 0.7 + AHEAD * far, "de_y": 0.9 + AHEAD * far} for far in (0.2801, 0.3199)]
            + [{"de_x": 0.9121 - AHEAD * 0.0199, "de_y": 1.1121 + AHEAD * 0.0199}],
            [{"de_x": 0.7 + AHEAD * far, "de_y": 0.9 + AHEAD * far} for far in (0.2799, 0.3202)]
            + [{"de_x": 0.9121 - AHEAD * 0.0202, "de_y": 1.1121 + AHEAD * 0.0202}],
        ),
        (
            [
                {"de_x": 0.4299, "de_y": 0.3, "de_turn": -FLAT},
                {"de_x": 0.4, "de_y": 0.3, "de_turn": -FLAT + np.radians(4.9)},
            ],
            [
                {"de_x": 0.4301, "de_y": 0.3, "de_turn": -FLAT},
                {"de_x": 0.4, "de_y": 0.3, "de_turn": -FLAT + np.radians(5.1)},
            ],
        ),
    ],
    "close-loops": [
        (
            [
                {**HUNG, "camera_tilt": np.radians(1.66)},
                {"camera_tilt": np.radians(0.716), "tilt_y": np.radians(-0.417)},
            ],
            [{**HUNG, "camera_tilt": np.radians(1.665)}],
        ),
        (
            [HUNG, {**HUNG, "camera_tilt": np.radians(1.66)}],
            [{"camera_tilt": np.radians(0.716), "tilt_y": np.radians(-0.417)}],
        ),
    ],
    "letters-frames": [
        (
            [{"name_1": "T_db", "name_2": "T_bc", "name_3": "T_ce"}],
            [{"name_1": "T_bd", "name_2": "T_bc", "name_3": "T_ce"}, {"name_1": "T_db"}],
        )
    ],
}
