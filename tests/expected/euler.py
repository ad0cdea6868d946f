"""Expected values for the chapter on Euler angles: figures, feedback, predictions."""

import numpy as np

from book.euler import figures
from robokin import euler, motion

R_AB = np.array(figures.R_AB, dtype=float)
HALF = np.pi / 2


def letters(left, mid, right, fixed):
    """Return the name of the sequence that a choice stands for."""
    one = "".join("xyz"[int(np.argmax(axis))] for axis in (left, mid, right))
    return one[::-1] if fixed else one.upper()


def sequence_readouts(*columns):
    rows = np.column_stack(columns)
    names = np.array([letters(row[:3], row[3:6], row[6:9], row[9]) for row in rows])
    out = np.empty((len(rows), 5))
    for seq in set(names):
        here = names == seq
        angles = rows[here, 10:13]
        R = euler.to_matrix(seq, angles)
        out[here, 3] = from_lock(seq, R)
        locked = out[here, 3] < 1e-9
        out[here, :3] = np.where(locked[:, None], np.nan, other(seq, angles, R))
        out[here, 4] = euler.to_axis_angle(R_AB.T @ R)[1]
    names = "other_first", "other_middle", "other_third", "lock", "apart"
    return dict(zip(names, out.T, strict=True))


def other(seq, angles, R):
    """Return the answer that is not the given one: the library's two, told by which is nearer."""
    found = motion.wrap_angle(angles + np.pi)
    proper = seq[0] == seq[2]
    found[:, 1] = -angles[:, 1] if proper else motion.wrap_angle(np.pi - angles[:, 1])
    # both make the same rotation; entries of size 1, rounded a few times
    np.testing.assert_allclose(euler.to_matrix(seq, found), R, rtol=0, atol=4e-15)
    free = ~euler.is_locked(seq, R, tol=1e-3)
    both = euler.solutions(seq, R[free])
    apart = np.abs(
        motion.wrap_angle(both[:, :, None] - np.stack([angles, found], 1)[free][:, None])
    )
    # 1e-15, over the 1e-3 from lock
    assert (apart.max(axis=-1).min(axis=1) < 1e-11).all()
    return found


def from_lock(seq, R):
    """Return the middle angle's distance from lock, from the first axis' row of the matrix."""
    M = R if seq.isupper() else np.swapaxes(R, 1, 2)
    first, _, last = ("xyz".index(letter) for letter in seq.lower())
    row = M[:, first]
    rest = np.linalg.norm(np.delete(row, last, axis=1), axis=1)
    return np.arctan2(rest, np.abs(row[:, last]))


def order_readouts(made, azimuth, elevation):
    """Return the one turn between the same turns in two orders."""
    angles = HALF * np.clip(np.stack([made, made - 1], axis=-1), 0, 1)
    left, right = euler.to_matrix("ZX", angles * [-1, 1]), euler.to_matrix("XZ", angles * [1, -1])
    return {"apart": euler.to_axis_angle(np.swapaxes(left, 1, 2) @ right)[1]}


def corner_readouts(turn, azimuth, elevation):
    """Return the one turn from the left die, turned on about a corner, to the right one."""
    left, right = euler.to_matrix("ZX", [-HALF, HALF]), euler.to_matrix("XZ", [HALF, -HALF])
    now = euler.from_axis_angle(np.full(3, 3**-0.5), turn) @ left
    return {"apart": euler.to_axis_angle(np.swapaxes(now, 1, 2) @ right)[1]}


def readings_readouts(first, middle, made, azimuth, elevation):
    """Return the one turn between a product's two readings, turn by turn."""
    one, two = np.clip(made, 0, 1), np.clip(made - 1, 0, 1)
    own = euler.to_matrix("ZX", np.stack([one * first, two * middle], axis=-1))
    room = euler.to_matrix("xz", np.stack([one * middle, two * first], axis=-1))
    return {"apart": euler.to_axis_angle(np.swapaxes(own, 1, 2) @ room)[1]}


def three_angles_readouts(first, middle, third, azimuth, elevation):
    """Return still to turn to the ghost."""
    ghost = euler.to_matrix("XYZ", np.radians(figures.GIVEN))
    now = euler.to_matrix("XYZ", np.stack([first, middle, third], axis=-1))
    return {"apart": euler.to_axis_angle(ghost.T @ now)[1]}


def near_lock_readouts(near):
    """Return the rate of the inner ring for 1 rad/s about the lost direction, by the Jacobian."""
    one = np.ones_like(near)
    R = euler.to_matrix("XY", np.stack([0 * near, np.pi / 2 - np.radians(near)], axis=-1))
    axes = np.stack([one[:, None] * [1.0, 0, 0], one[:, None] * [0, 1.0, 0], R[..., 2]], axis=-1)
    return {"fast": np.linalg.solve(axes, np.array([0, 0, 1.0])[:, None])[:, 2, 0]}


PAIRS = ((2, 1), (0, 2), (1, 0))


def one_axis_readouts(x, y, z, turn, azimuth, elevation):
    """Return still to turn to frame B."""
    R = euler.from_axis_angle(np.stack([x, y, z], axis=-1), turn)
    differences = {f"difference{k}": R[..., i, j] - R[..., j, i] for k, (i, j) in enumerate(PAIRS)}
    return {"apart": euler.to_axis_angle(R_AB.T @ R)[1], **differences}


def target_readouts(*columns):
    """Return how many axes point as those of frame B, within a degree."""
    rows = np.column_stack(columns)
    one, two = (euler.from_axis_angle(rows[:, k : k + 3], rows[:, 6 + k // 3]) for k in (0, 3))
    aligned = (one @ two * R_AB).sum(axis=1) > np.cos(np.radians(1))
    return {"in_place": np.sum(aligned, axis=1)}


def both_readouts(middle, made, azimuth, elevation):
    """Return the middle angle of the other answer, and the one turn between the two dice."""
    left = np.stack([0 * middle + np.pi / 9, middle, 0 * middle + np.pi / 6], axis=-1)
    right = np.stack([left[:, 0] + np.pi, np.pi - middle, left[:, 2] + np.pi], axis=-1)
    done = np.clip(made[:, None] - np.arange(3), 0, 1)
    R, S = (euler.to_matrix("XYZ", done * angles) for angles in (left, right))
    apart = euler.to_axis_angle(np.swapaxes(R, 1, 2) @ S)[1]
    return {"other": motion.wrap_angle(np.pi - middle), "apart": apart}


def rings_readouts(middle, against, azimuth, elevation):
    """Return the one turn that the three turns make."""
    turned = euler.to_matrix("XYZ", np.stack([against, middle, -against], -1))
    return {"whole": euler.to_axis_angle(turned)[1]}


def one_turn_readouts(at_once, part, azimuth, elevation):
    """Return turned on the way, and still to turn, by one turn or by two."""
    axis, angle = euler.to_axis_angle(R_AB)
    two = np.clip(np.stack([2 * part, 2 * part - 1], axis=-1), 0, 1)
    by_two = euler.to_matrix("YZ", two * [HALF, -HALF])
    R = np.where(at_once[:, None, None] > 0, euler.from_axis_angle(axis, part * angle), by_two)
    turned = np.where(at_once > 0, part * angle, two.sum(axis=1) * HALF)
    return {"turned": turned, "left": euler.to_axis_angle(R_AB.T @ R)[1]}


def mistakes_readouts(*columns):
    """Return how far a wrong frame is from frame B."""
    R = np.stack(columns[:9], axis=-1).reshape(-1, 3, 3)
    right = euler.to_matrix("YZ", [HALF, HALF])
    return {"apart": euler.to_axis_angle(right.T @ R)[1]}


READOUTS = {
    "order": order_readouts,
    "corner": corner_readouts,
    "two-readings": readings_readouts,
    "to-b": target_readouts,
    "read-angles": three_angles_readouts,
    "both-answers": both_readouts,
    "gimbal-rings": rings_readouts,
    "inner-rate": near_lock_readouts,
    "one-axis": one_axis_readouts,
    "one-turn": one_turn_readouts,
    "euler-sequence": sequence_readouts,
    "wrong-frames": mistakes_readouts,
}
LOCKED = {"middle": HALF}
ANSWERS = {  # of the exercise, in degrees; the first three are at lock
    "XYZ": (-90, 90, 0),
    "zyx": (-90, 90, 0),
    "ZXY": (-90, -90, 0),
    "ZYX": (-90, 0, -90),
    "ZYZ": (0, 90, -90),
    "xzx": (90, 90, 180),
}
SPECIALS = {
    "die": [{"turns": turns} for turns in ("Z", "zxx", "zxX", "X-XyY-Z", "xyZ")],
    "two-frames": [{"elevation": HALF}],
    "columns": [{"axis": axis, "turn": turn} for axis in "xyz" for turn in (0.0, HALF, -HALF)],
    "order": [{"made": 1.0}, {"made": 2.0}],
    "corner": [{"turn": 2 * np.pi / 3}],
    "two-readings": [{"made": made} for made in (0.0, 1.0, 1.5, 2.0)],
    "to-b": [
        {"axes": "y, then z", "first": HALF, "middle": -HALF},
        {"axes": "x, then y", "first": -HALF},
        {"axes": "z, then y", "first": -HALF, "middle": HALF},
    ],
    "read-angles": [{"first": HALF}, {**LOCKED}],
    "both-answers": [{**LOCKED, "made": 3.0}, {"made": 1.0}, {"made": 2.0}, {"made": 3.0}],
    "rings-alone": [LOCKED, {"first": HALF}, {"third": HALF}],
    "gimbal-rings": [LOCKED, {"middle": -HALF}, {"middle": 0.0, "against": 0.0}],
    "inner-rate": [{"near": near} for near in (0.2, 1.0, 30.0, 90.0)],
    "one-axis": [{"axis": "two corners", "turn": 2 * np.pi / 3}, {"turn": 0.0}],
    "one-turn": [{"part": 0.5}, {"part": 1.0}, {"part": 1.0, "way": "one turn"}, {"part": 0.0}],
    "euler-sequence": [
        {"sequence": seq, **dict(zip(("first", "middle", "third"), np.radians(a), strict=True))}
        for seq, a in ANSWERS.items()
    ]
    + [{"first": 0.0, "middle": 0.0, "third": 0.0}, {"made": 1.0}, {"made": 2.0}],
    "rotation-recap": [{"turn": HALF}],
}
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "euler-1": (
        {"a": 60, "first": "y", "b": -45, "second": "x", "arrow": "z"},
        {
            "M6": [0.866, 0.3536, 0.3536],
            "M7": [-0.6124, -0.7071, 0.3536],
            "a row of the matrix": [-0.866, -0.3536, 0.3536],
        },
    ),
    "euler-2": (
        {"a": 90, "first": "x", "b": 60, "second": "z"},
        {
            "M6": [[0.5, 0, 0.866], [0.866, 0, -0.5], [0, 1, 0]],
            "M7": [[0.5, 0.866, 0], [0, 0, 1], [0.866, -0.5, 0]],
        },
    ),
    "euler-3": (
        {"R_AB": "[[0, −1, 0], [0, 0, 1], [−1, 0, 0]]", "axis": "x", "turn": -90},
        {
            "M6": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
            "M7": [[0, -1, 0], [-1, 0, 0], [0, 0, -1]],
            "R_1 itself": [[0, -1, 0], [-1, 0, 0], [0, 0, -1]],
        },
    ),
    "euler-4": (
        {"a": 90, "first": "y", "b": 120, "second": "z"},
        {"M6": [-0.6547, 0.378, 0.6547, 2.4189], "M7": [0.6547, -0.378, -0.6547, 2.4189]},
    ),
    "euler-5": (
        {"yaw": -90, "pitch": 60, "roll": -45},
        {
            "M6": [[-1.5708, 0.7854, 1.0472], [1.5708, 2.3562, 4.1888]],
            "M7": [[1.5708, -1.0472, 0.7854], [-1.5708, -2.0944, -2.3562]],
            "rows and columns": [[1.5708, -0.7854, -1.0472], [4.7124, 3.927, 2.0944]],
        },
    ),
    "euler-6": ({"seq": "YZX", "a": -60, "b": -90}, {"M7": [1.0472, 1.5708], "M8": [0, -1.5708]}),
    "euler-7": (
        {"yaw": 150, "pitch": 45, "roll": -45},
        {
            "M6": [0.6155, 1.0472, 1.6627],
            "M7": [1.4789, 1.0472, 2.5261],
            "wrong order in both sequences": [1.6627, 1.0472, 0.6155],
            "left-handed turns in both": [-1.4789, -1.0472, -2.5261],
            "way back": [-2.5261, 1.0472, -0.4317],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "arm-ways": "four",
    "third-quarter": "−135°",
    "first-column": "(0, 0, −1)",
    "two-orders": "120° apart",
    "own-or-room": "alike, for any angles",
    "read-gamma": ("−20°", "20°", "−17.2°", "160°"),
    "other-answer": "alike",
    "ring-against-ring": "nothing",
    "near-lock": "57° a second",
    "which-axis": "through two corners",
}


def near_b(sequence, degrees=0.0):
    """Return the setting of a sequence that reaches frame B, the first angle off by degrees."""
    first, *others = np.radians([TO_B[sequence][0] + degrees, *TO_B[sequence][1:]])
    return {
        "sequence": sequence,
        "first": first,
        **dict(zip(("middle", "third"), others, strict=True)),
    }


TO_B = {"ZXZ": (90, 90, 180), "ZYX": (-90, 0, -90), "zyx": (-90, 90, 0)}  # degrees
REST = {"middle": np.radians(30), "third": np.radians(-20)}  # of the ghost with three angles
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "die": [
        ([{"turns": "XYX"}, {"turns": "Z-ZXYX"}], [{"turns": "XY"}, {"turns": "XYXX"}]),
        ([{"turns": "XYX"}, {"turns": "-YZ-X"}], [{"turns": "XY"}, {"turns": "Z-ZXYX"}]),
    ],
    "to-b": [
        (
            [
                {"axes": "y, then z", "first": HALF, "middle": -HALF},
                {"axes": "x, then y", "first": -HALF, "middle": HALF},
                {"axes": "z, then x", "first": -HALF, "middle": np.radians(-90.9)},
            ],
            [
                {"axes": "y, then z", "first": np.radians(91.1), "middle": -HALF},
                {"axes": "x, then y", "first": HALF, "middle": HALF},
                {"axes": "z, then y", "first": -HALF, "middle": HALF},
            ],
        )
    ],
    "read-angles": [
        (
            [{"first": np.radians(first), **REST} for first in (39.1, 40.9)],
            [{"first": np.radians(first), **REST} for first in (38.9, 41.1)],
        )
    ],
    "corner": [
        (
            [{"turn": np.radians(turn)} for turn in (119.1, 120.9)],
            [{"turn": np.radians(turn)} for turn in (118.9, 121.1, -120)],
        )
    ],
    "rings-alone": [  # within 3°; at lock the outer and the inner ring undo each other
        (
            [LOCKED, {"middle": np.radians(92.9)}, {**LOCKED, "first": 1.0, "third": -1.0}],
            [{"middle": np.radians(93.1)}, {"middle": -HALF}, {"third": HALF}],
        )
    ],
    "yaw-pitch-roll": [  # within 0.02 of a half: about 1.3°
        (
            [{"middle": np.radians(-30)}, {"middle": np.radians(-31), "first": 1.0, "third": 2.0}],
            [{"middle": np.radians(30)}, {"middle": np.radians(-28.5)}],
        )
    ],
    "gimbal-rings": [
        (
            [{**LOCKED, "against": np.radians(30)}, {**LOCKED, "against": np.radians(-30)}],
            [{**LOCKED, "against": np.radians(25)}, {"middle": np.radians(85), "against": 1.0}],
        )
    ],
    "one-axis": [
        (
            [{"axis": "two corners", "turn": np.radians(turn)} for turn in (119.1, 120.9)],
            [{"axis": "two corners", "turn": np.radians(118.9)}, {"axis": "two edges"}],
        )
    ],
    "rotation-recap": [
        (
            [{"first_column": "arrow 3", "second_column": "arrow 1"}],
            [
                {"first_column": "arrow 3", "second_column": "arrow 2"},
                {"first_column": "arrow 1", "second_column": "arrow 3"},
            ],
        )
    ],
    "euler-sequence": [
        (
            [near_b(own, 0.9), near_b(own, -0.9)],
            [near_b(own, 1.1), near_b(own, -1.1), *(near_b(seq) for seq in TO_B if seq != own)],
        )
        for own in TO_B
    ],
}
