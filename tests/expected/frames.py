"""Expected values for the chapter on chains of frames: figures, feedback, predictions."""

import numpy as np

from book.frames import figures
from book.frames.figures import THING
from robokin import euler, frames, motion, planar_arm

LINKS, BASE = list(figures.LINKS.values()), [*figures.BASE, 0.0]
DOWN = np.diag([1.0, -1.0, -1.0])


def wrist(alpha, beta):
    """Return where the hand is, as the platform sees it: (n, 2)."""
    return planar_arm.forward(np.stack([alpha, beta], axis=-1), LINKS)[:, :2]


def pose_of(T):
    """Return x, y, theta of planar matrices: (n, 3, 3) → (n, 3)."""
    return np.column_stack([T[:, 0, 2], T[:, 1, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def chain_readouts(x_b, y_b, turn_b, alpha, beta, gamma, x_e, y_e, turn_e):
    """Return the object seen from the hand, how far, and the hand seen from the platform."""
    graph = frames.FrameGraph()
    graph.add("d", "b", frames.se2(x_b, y_b, turn_b))
    graph.add("b", "c", frames.se2(*wrist(alpha, beta).T, alpha + beta + gamma))
    graph.add("d", "e", frames.se2(x_e, y_e, turn_e))
    found = pose_of(graph.get("c", "e"))
    names = "x", "y", "turn", "hand_x", "hand_y", "hand_turn"
    poses = np.hstack([found, pose_of(graph.get("b", "c"))])
    return {**dict(zip(names, poses.T, strict=True)), "far": np.hypot(*found[:, :2].T)}


def turned(angle):
    """Return turns about z: (n,) → (n, 3, 3)."""
    return euler.to_matrix("Z", angle[:, None])


def above_readouts(turn, high, heading, alpha, beta, gamma, low, azimuth, elevation):
    """Return platform and object seen from the camera, the object seen from the hand."""
    ground = np.zeros_like(low)
    graph = frames.FrameGraph()
    graph.add("room", "f", frames.se3(turned(turn) @ DOWN, np.stack([ground, ground, high], -1)))
    graph.add("room", "b", frames.se3(turned(heading), BASE))
    thing = np.stack([THING[0] + ground, THING[1] + ground, low], axis=-1)
    graph.add("room", "e", frames.se3(np.eye(3), thing))
    place = np.column_stack([wrist(alpha, beta), ground])
    graph.add("b", "c", frames.se3(turned(alpha + beta + gamma), place))
    ways = {"_b": ("f", "b"), "_e": ("f", "e"), "": ("c", "e")}
    places = {of: graph.get(*way)[:, :3, 3] for of, way in ways.items()}
    found = {axis + of: at[:, k] for of, at in places.items() for k, axis in enumerate("xyz")}
    del found["z_b"]  # the camera's height, as it is set
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
    "room-plan": chain_readouts,
    "camera-above": above_readouts,
    "wrong-object": mistakes_readouts,
}
SPECIALS = {
    "room-plan": [
        {"db_turn": 0.0},
        {"joint_alpha": 0.0, "joint_beta": 0.0, "joint_gamma": 0.0},
        {"de_x": 0.7, "de_y": 0.9},  # the object in the hand
        {"de_x": 1.0, "de_y": 0.5},  # on the platform
    ],
    "camera-above": [
        {"camera_turn": np.pi / 2},
        {"azimuth": 0.0, "elevation": 0.0},
        {"azimuth": 0.0, "elevation": np.pi / 2},
        {"joint_beta": 0.0, "object_low": 0.0},
    ],
    "wrong-object": [{"db_turn": 2 * np.pi / 3}],  # T_db T_bc is a half turn
}
# each names the step that is wrong, and claims nothing of the picture
NAMES = "No inverse", "Inverses by hand", "Two inverses", "One inverse"
TITLES = {"wrong-object": dict.fromkeys(NAMES)}
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
        {
            "alpha": 0,
            "beta": 30,
            "gamma": -20,
            "x_b": -1.6,
            "y_b": -1.2,
            "theta_b": 60,
            "x_e": 1.2,
            "y_e": 0.2,
            "theta_e": 110,
        },
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
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "from-the-hand": "in front, on the right",
    "of-a-plan": "−1",
    "a-turned-camera": "none",
    "four-more": "1 and 2",
    "round-the-loop": "a turn by 2°",
}
