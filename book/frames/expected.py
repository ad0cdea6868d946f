"""What the figures of the chapter on chains of frames must show."""

import numpy as np

from robokin import euler, frames, motion, planar_arm

LINKS = [0.3, 0.4]  # m
BASE, THING = [-0.2, -0.3, 0.0], [0.3, 0.3]  # m, platform and object in the room
DOWN = np.diag([1.0, -1.0, -1.0])


def wrist(alpha, beta):
    """Where the hand is, as the platform sees it: (n, 2)."""
    return planar_arm.forward(np.stack([alpha, beta], axis=-1), LINKS)[:, :2]


def pose_of(T):
    """x, y, theta of planar matrices: (n, 3, 3) → (n, 3)."""
    return np.column_stack([T[:, 0, 2], T[:, 1, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def chain_readouts(x_b, y_b, turn_b, alpha, beta, gamma, x_e, y_e, turn_e):
    """The object seen from the hand, how far, and the hand seen from the platform."""
    graph = frames.FrameGraph()
    graph.add("d", "b", frames.se2(x_b, y_b, turn_b))
    graph.add("b", "c", frames.se2(*wrist(alpha, beta).T, alpha + beta + gamma))
    graph.add("d", "e", frames.se2(x_e, y_e, turn_e))
    found = pose_of(graph.get("c", "e"))
    far = np.hypot(*found[:, :2].T)
    return np.column_stack([found, far, pose_of(graph.get("b", "c"))])


def turned(angle):
    """Turns about z: (n,) → (n, 3, 3)."""
    return euler.to_matrix("Z", angle[:, None])


def above_readouts(turn, high, heading, alpha, beta, gamma, low, azimuth, elevation):
    """Platform and object seen from the camera, the object seen from the hand."""
    ground = np.zeros_like(low)
    graph = frames.FrameGraph()
    graph.add("room", "f", frames.se3(turned(turn) @ DOWN, np.stack([ground, ground, high], -1)))
    graph.add("room", "b", frames.se3(turned(heading), BASE))
    thing = np.stack([THING[0] + ground, THING[1] + ground, low], axis=-1)
    graph.add("room", "e", frames.se3(np.eye(3), thing))
    place = np.column_stack([wrist(alpha, beta), ground])
    graph.add("b", "c", frames.se3(turned(alpha + beta + gamma), place))
    ways = ("f", "b"), ("f", "e"), ("c", "e")
    return np.column_stack([graph.get(*way)[:, :3, 3] for way in ways])


def mistakes_readouts(*columns):
    """apart, off: where the object is taken to be, and how it lies there."""
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
    return np.column_stack([np.hypot(*found[:, :2].T), motion.wrap_angle(found[:, 2])])


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
WORDS = []
