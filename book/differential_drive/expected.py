"""What the figures of the chapter on the differential drive must show."""

import numpy as np

from robokin import differential_drive, motion

DISTANCE, RADIUS = 0.1, 1.0  # m; the wheel radius cancels, and 1 leaves the digits alone
STEPS_DURATION = 6.0  # s


def twist_of(v_left, v_right):
    """Speed and turning rate of the robot in the figures."""
    rates = np.array([v_left, v_right]) / RADIUS
    twist = differential_drive.body_twist(*rates, RADIUS, DISTANCE)
    return twist[..., 0], twist[..., 2]


def start_pose(theta):
    """At the origin, with a heading: (n,) → (n, 3)."""
    return np.stack([0 * theta, 0 * theta, theta], axis=-1)


def drive_readouts(v_left, v_right, theta, t):
    """v, omega, radius, x, y, heading."""
    v, omega = twist_of(v_left, v_right)
    radius = motion.icr(start_pose(0 * theta), v, omega)[..., 1]
    return np.column_stack([v, omega, radius, motion.arc_step(start_pose(theta), v, omega, t)])


def steps_readouts(count, v_left, v_right, theta):
    """apart, x, y."""
    v, omega = twist_of(v_left, v_right)
    exact = motion.arc_step(start_pose(theta), v, omega, STEPS_DURATION)[:, :2]
    ends = np.empty_like(exact)
    for k in set(count):
        one = count == k
        drive = v[one, None], omega[one, None], np.full(int(k), STEPS_DURATION / k)
        ends[one] = motion.path(start_pose(theta[one]), *drive, method="start")[:, -1, :2]
    return np.column_stack([np.hypot(*(ends - exact).T), exact])


STRAIGHT, BACK = {"v_L": 0.07, "v_R": 0.07}, {"v_L": -0.15, "v_R": -0.15}
SPOT, STILL = {"v_L": -0.05, "v_R": 0.05}, {"v_L": 0.0, "v_R": 0.0}

READOUTS = {"wheel-speeds": drive_readouts, "steps": steps_readouts}
SPECIALS = {
    "wheel-speeds": [STRAIGHT, BACK, SPOT, STILL, {**STRAIGHT, "t": 12.0}],
    "steps": [STRAIGHT, BACK, SPOT, STILL, {**SPOT, "n": 1}],
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("wheel-speeds", {"v_L": 0.1}, "radius", "none: straight line"),
    ("wheel-speeds", {"v_L": 0.0, "v_R": 0.0}, "radius", "every point: standing still"),
]
