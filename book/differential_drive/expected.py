"""What the figures of the chapter on the differential drive must show."""

import numpy as np

from robokin import differential_drive, motion, wheels

DISTANCE, RADIUS = 0.1, 0.03  # m
UP = np.pi / 2  # the heading at the start


def twist_of(v_left, v_right):
    """Speed and angular velocity of the robot in the figures; the wheel radius cancels."""
    twist = differential_drive.body_twist(v_left, v_right, 1.0, DISTANCE)
    return twist[..., 0], twist[..., 2]


def driven(v, omega, time, heading=UP):
    """The pose after driving from the origin."""
    start = np.stack([0 * (v + omega), 0 * (v + omega), heading + 0 * (v + omega)], axis=-1)
    return motion.arc_step(start, v, omega, time)


def off_and_turned(pose, mark):
    """How far from a mark, and turned against it."""
    off = np.hypot(*(pose - mark)[..., :2].T)
    return np.column_stack([off, np.abs(motion.wrap_angle(pose[..., 2] - mark[2]))])


def park_readouts(v_left, v_right, t):
    """off, turned."""
    mark = driven(np.float64(0.09), np.float64(0.6), 3.0)
    return off_and_turned(driven(*twist_of(v_left, v_right), 3.0), mark)


def tips_readouts(v_left, v_right):
    """v, omega, R."""
    radius = differential_drive.turning_radius(v_left, v_right, DISTANCE)
    return np.column_stack([*twist_of(v_left, v_right), radius])


def infinity_readouts(share):
    """v_L, v_R, R."""
    c, s = np.cos(share), np.sin(share) * DISTANCE / 2 / 0.12  # m: how wide the map is
    speeds = 0.07 * (c - s), 0.07 * (c + s)
    return np.column_stack([*speeds, differential_drive.turning_radius(*speeds, DISTANCE)])


def world_readouts(theta):
    """x_dot, y_dot."""
    return motion.to_world(theta, [0.075, 0, 0.5])[:, :2]


def rates_readouts(v, omega, t):
    """rate_L, rate_R."""
    return differential_drive.wheel_rates(v, omega, RADIUS, DISTANCE)


def arc_readouts(omega, dt):
    """x_next, y_next, theta_next."""
    return driven(0.075, omega, dt)


def digits_readouts(power):
    """omega, and the error, which is what is lost."""
    return np.column_stack([10.0**-power, np.nan * power])


def steps_readouts(count):
    """The errors of the steps by the old and by the middle heading."""
    errors = []
    for n in count.astype(int):
        drive = np.full(n, 0.075), np.full(n, 0.5), np.full(n, 6 / n)
        ends = [motion.path([0, 0, UP], *drive, method=m)[-1, :2] for m in ("start", "midpoint")]
        errors.append([np.hypot(*(end - driven(0.075, 0.5, 6.0)[:2])) for end in ends])
    return np.array(errors)


def sideways_readouts(ahead, left):
    """v, lost: along and across a wheel that neither slips nor slides."""
    wheel = [wheels.fixed(DISTANCE / 2, np.pi / 2, 0.0, RADIUS)]
    wish = np.stack([ahead, left, 0 * ahead])
    return np.vstack([wheels.rolling(wheel) @ wish, wheels.sliding(wheel) @ wish]).T


def side_readouts(aim, reach, done):
    """off."""
    turned = driven(0 * aim, aim, 1.0)
    there = motion.arc_step(turned, reach, 0 * aim, 1.0)
    end = motion.arc_step(there, 0 * aim, -aim, 1.0)
    return off_and_turned(end, np.array([-0.2, 0.0, UP]))[:, :1]


def damage_readouts(rate, heading, t):
    """apart."""
    v, omega = twist_of(0.12, 0.08)
    places = driven(v, omega + 0 * rate, t, np.pi / 3), driven(v, rate, t, heading)
    return np.hypot(*(places[0] - places[1])[:, :2].T)[:, None]


def drive_readouts(v_left, v_right, t):
    """v, omega, R, x, y, heading."""
    return np.column_stack([tips_readouts(v_left, v_right), driven(*twist_of(v_left, v_right), t)])


STRAIGHT, BACK = {"v_L": 0.07, "v_R": 0.07}, {"v_L": -0.15, "v_R": -0.15}
SPOT, STILL = {"v_L": -0.05, "v_R": 0.05}, {"v_L": 0.0, "v_R": 0.0}
DRIVES = [STRAIGHT, BACK, SPOT, STILL]

READOUTS = {
    "park": park_readouts,
    "tips": tips_readouts,
    "infinity": infinity_readouts,
    "world": world_readouts,
    "rates": rates_readouts,
    "arc": arc_readouts,
    "digits": digits_readouts,
    "steps": steps_readouts,
    "sideways": sideways_readouts,
    "side": side_readouts,
    "damage": damage_readouts,
    "wheel-speeds": drive_readouts,
}
SPECIALS = {
    "park": [*DRIVES, {"v_L": 0.06, "v_R": 0.12}],
    "exercise": [],
    "tips": DRIVES,
    "infinity": [{"share": 0.0}],
    "world": [{"theta": 0.0}, {"theta": UP}],
    "rates": [{"omega": 0.0}, {"v": 0.0}, {"v": 0.0, "omega": 0.0}],
    "guess": [{"t": 2.0}],
    "arc": [{"omega": 0.0}, {"omega": 1e-12}],
    "digits": [{"power": 8.0}],
    "steps": [{"n": 6}, {"n": 12}],
    "sideways": [{"wish_y": 0.0}, {"wish_x": 0.0}],
    "side": [{"aim": UP, "reach": 0.2, "done": 3.0}, {"done": 0.5}, {"done": 1.5}, {"done": 2.5}],
    "damage": [{"t": 0.0}, {"mistake": "Down instead of up", "t": 2.0}],
    "wheel-speeds": [*DRIVES, {**STRAIGHT, "t": 12.0}],
    "summary": [],
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("wheel-speeds", {"v_L": 0.1}, "R", "none: straight"),
    ("tips", {"v_L": 0.0, "v_R": 0.0}, "R", "nowhere: at rest"),
]
# numbers that are shown to lose their digits, by the symbols that they come from
LOST = {"digits": ("x_lost", "y_lost")}
