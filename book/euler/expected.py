"""What the figures of the chapter on Euler angles must show."""

import numpy as np

from robokin import euler, motion

R_AB = np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]])
HALF = np.pi / 2
AXIS = np.array([-1.0, 1, -1]) / np.sqrt(3)


def letters(left, mid, right, fixed):
    """The name of the sequence that a choice stands for."""
    one = "".join("xyz"[int(np.argmax(axis))] for axis in (left, mid, right))
    return one[::-1] if fixed else one.upper()


def sequence_readouts(*columns):
    """The other answer's three angles, distance from lock, whole turn, distance from R_AB."""
    rows = np.column_stack(columns)
    names = np.array([letters(row[:3], row[3:6], row[6:9], row[9]) for row in rows])
    out = np.empty((len(rows), 6))
    for seq in set(names):
        here = names == seq
        angles = rows[here, 10:13]
        R = euler.to_matrix(seq, angles)
        out[here, :3] = other(seq, angles, R)
        out[here, 3] = from_lock(seq, R)
        out[here, 4] = euler.axis_angle(R)[1]
        out[here, 5] = euler.axis_angle(R_AB.T @ R)[1]
    return out


def other(seq, angles, R):
    """The answer that is not the given one: the library's two, told by which is nearer."""
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
    """The middle angle's distance from lock, from the first axis' row of the matrix."""
    M = R if seq.isupper() else np.swapaxes(R, 1, 2)
    first, _, last = ("xyz".index(letter) for letter in seq.lower())
    row = M[:, first]
    rest = np.linalg.norm(np.delete(row, last, axis=1), axis=1)
    return np.arctan2(rest, np.abs(row[:, last]))


def rings_readouts(first, middle, third, azimuth, elevation):
    """Angle of the outer and the inner axis, volume of the three axes, whole turn."""
    zero = 0 * first
    outer = np.stack([zero + 1, zero, zero], axis=-1)
    mid = euler.to_matrix("X", first[:, None])[..., 1]
    inner = euler.to_matrix("XY", np.stack([first, middle], axis=-1))[..., 2]
    between = np.arctan2(
        np.linalg.norm(np.cross(outer, inner), axis=1), np.sum(outer * inner, axis=1)
    )
    volume = np.abs(np.linalg.det(np.stack([outer, mid, inner], axis=-1)))
    whole = euler.axis_angle(euler.to_matrix("XYZ", np.stack([first, middle, third], -1)))[1]
    return np.column_stack([between, volume, whole])


def one_turn_readouts(part, azimuth, elevation):
    """Turned so far, still to turn, and still to turn with both angles growing together."""
    then = euler.to_matrix("YZ", np.stack([part * HALF, -part * HALF], axis=-1))
    total = euler.axis_angle(R_AB)[1]
    detour = euler.axis_angle(R_AB.T @ then)[1]
    return np.column_stack([part * total, total - part * total, detour])


READOUTS = {
    "euler-sequence": sequence_readouts,
    "gimbal-rings": rings_readouts,
    "one-turn": one_turn_readouts,
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
    "euler-sequence": [
        {"sequence": seq, **dict(zip(("first", "middle", "third"), np.radians(a), strict=True))}
        for seq, a in ANSWERS.items()
    ]
    + [{"first": 0.0, "middle": 0.0, "third": 0.0}, {"made": 1.0}, {"made": 2.0}],
    "gimbal-rings": [LOCKED, {"middle": -HALF}, {"first": 0.0, "middle": 0.0, "third": 0.0}],
    "one-turn": [{"elevation": HALF}],
}
WORDS = []
