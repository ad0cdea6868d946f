"""For each public function the few lines of NumPy that a user would write, on the same inputs.

They divide by zero and lose digits where robokin does not, and check nothing but rotations.
`OBVIOUS` has, by the name of the function, the call of robokin and what a user writes; `x` holds
inputs of n items.
"""

from types import SimpleNamespace

import numpy as np
from numpy import arctan2, cos, pi, sin, tan

from robokin import bicycle, differential_drive, elbow_arm, euler, frames, motion, odometry, wheels
from robokin import planar_arm as arm

A2, A3, D1 = 0.4, 0.3, 0.1  # the elbow arm
LINKS = np.array([0.4, 0.3, 0.1])  # the planar arm
RADIUS, DISTANCE, WHEELBASE, TRACK, TICKS, DT = 0.05, 0.3, 2.5, 1.5, 1000, 0.01
PER_TICK = 2 * pi * RADIUS / TICKS
OMNI = wheels.omni_robot(0.2, 0.05)
J1 = wheels.rolling(OMNI)
STEERED = [wheels.steered(0.4, alpha, 0.0, 0.1) for alpha in (0.7, 2.4, -0.7, -2.4)]
ALPHA = np.array([0.7, 2.4, -0.7, -2.4])


def inputs(n):
    rng = np.random.default_rng(1)
    left, right = rng.integers(1, 20, (2, n))
    q, turns = rng.uniform(0.2, 1.4, (n, 3)), rng.uniform(-1.4, 1.4, (n, 3))
    pose, C = rng.uniform(-3, 3, (n, 3)), rng.normal(size=(n, 2, 2))
    R = euler.to_matrix("ZYX", turns)
    return SimpleNamespace(
        a=rng.uniform(0.1, 0.6, n),
        b=rng.uniform(0.1, 0.6, n),
        theta=rng.uniform(-3, 3, n),
        v=rng.uniform(0.5, 2, n),
        omega=rng.uniform(0.1, 1, n),
        pose=pose,
        twist=rng.uniform(-1, 1, (n, 3)),
        q=q,
        rates=rng.uniform(-1, 1, (n, 3)),
        p=elbow_arm.forward(q, A2, A3, D1),
        hand=arm.forward(q, LINKS),
        turns=turns,
        R=R,
        T2=frames.se2(*pose.T),
        T3=frames.se3(R, pose),
        left=left,
        right=right,
        counts=np.cumsum(left) % 256,
        C=C @ C.swapaxes(-1, -2),
        ends=rng.uniform(-0.1, 0.1, (2, n, 5, 2)),
        steering=rng.uniform(-0.5, 0.5, (n, 4)),
    )


def columns(*entries):
    return np.stack(np.broadcast_arrays(*entries), axis=-1)


def matrix(*rows):
    return np.stack([columns(*row, rows[0][0])[..., :-1] for row in rows], axis=-2)


def turned(theta, x, y, omega):
    c, s = cos(theta), sin(theta)
    return columns(c * x - s * y, s * x + c * y, omega)


def arc(pose, v, omega, dt):
    x, y, theta = pose.T
    radius, end = v / omega, theta + omega * dt
    return columns(x + radius * (sin(end) - sin(theta)), y - radius * (cos(end) - cos(theta)), end)


def exponential(pose, twist, dt):
    v, v_y, w = twist.T
    s, c = sin(w * dt) / w, (1 - cos(w * dt)) / w
    return pose + turned(pose[:, 2], v * s - v_y * c, v * c + v_y * s, w * dt)


def path(length, turn):
    heading = np.append(0, np.cumsum(turn))
    middle, chord = heading[:-1] + turn / 2, length * np.sinc(turn / 2 / pi)
    x, y = np.cumsum(chord * cos(middle)), np.cumsum(chord * sin(middle))
    return columns(np.append(0, x), np.append(0, y), heading)


def icr(pose, v, omega):
    x, y, theta = pose.T
    return columns(x - v / omega * sin(theta), y + v / omega * cos(theta))


def ackermann(phi):
    radius = WHEELBASE / tan(phi)
    left, right = radius - TRACK / 2, radius + TRACK / 2
    return columns(np.arctan(WHEELBASE / left), np.arctan(WHEELBASE / right))


def lane_width(phi):
    radius = WHEELBASE / tan(phi)
    return np.hypot(radius + TRACK / 2, WHEELBASE) - (radius - TRACK / 2)


def elbow_positions(q):
    theta1, theta2, theta3 = q.T
    r2, z2 = A2 * cos(theta2), D1 + A2 * sin(theta2)
    r3, z3 = r2 + A3 * cos(theta2 + theta3), z2 + A3 * sin(theta2 + theta3)
    c, s, zero = cos(theta1), sin(theta1), 0 * theta1
    points = [(zero, zero, zero), (zero, zero, D1), (r2 * c, r2 * s, z2), (r3 * c, r3 * s, z3)]
    return np.stack([columns(*point) for point in points], axis=1)


def elbow_forward(q):
    theta1, theta2, theta3 = q.T
    r = A2 * cos(theta2) + A3 * cos(theta2 + theta3)
    z = D1 + A2 * sin(theta2) + A3 * sin(theta2 + theta3)
    return columns(r * cos(theta1), r * sin(theta1), z)


def elbow_inverse(p):
    x, y, z = p.T
    r, h = np.hypot(x, y), z - D1
    bend = np.arccos((r**2 + h**2 - A2**2 - A3**2) / (2 * A2 * A3))
    lift = arctan2(A3 * sin(bend), A2 + A3 * cos(bend))
    turn, rise = arctan2(y, x), arctan2(h, r)
    facing = [columns(turn, rise + lift, -bend), columns(turn, rise - lift, bend)]
    away = [columns(turn + pi, pi - rise - lift, bend), columns(turn + pi, pi - rise + lift, -bend)]
    return np.stack(facing + away, axis=1)


def nearest(p):
    ray = p - [0, 0, D1]
    d = np.linalg.norm(ray, axis=-1, keepdims=True)
    return [0, 0, D1] + ray / d * np.clip(d, A2 - A3, A2 + A3)


def about_axis(axis, angle):
    c, s, one, zero = cos(angle), sin(angle), 1 + 0 * angle, 0 * angle
    return {
        "x": matrix([one, zero, zero], [zero, c, -s], [zero, s, c]),
        "y": matrix([c, zero, s], [zero, one, zero], [-s, zero, c]),
        "z": matrix([c, -s, zero], [s, c, zero], [zero, zero, one]),
    }[axis]


def zyx(turns):
    a, b, c = turns.T
    return about_axis("z", a) @ about_axis("y", b) @ about_axis("x", c)


def zyx_steps(turns):
    a, b, c = turns.T
    first = about_axis("z", a)
    second = first @ about_axis("y", b)
    eye = np.broadcast_to(np.eye(3), first.shape)
    return np.stack([eye, first, second, second @ about_axis("x", c)], axis=1)


def yaw_pitch_roll(R):
    yaw, roll = arctan2(R[:, 1, 0], R[:, 0, 0]), arctan2(R[:, 2, 1], R[:, 2, 2])
    return columns(yaw, np.arcsin(-R[:, 2, 0]), roll)


def both_solutions(R):
    a, b, c = yaw_pitch_roll(R).T
    return np.stack([columns(a, b, c), columns(a + pi, pi - b, c + pi)], axis=1)


def rodrigues(axis, angle):
    x, y, z = (axis / np.linalg.norm(axis, axis=-1, keepdims=True)).T
    K = matrix([0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x])
    angle = angle[:, None, None]
    return np.eye(3) + sin(angle) * K + (1 - cos(angle)) * (K @ K)


def axis_angle(R):
    angle = np.arccos((np.trace(R, axis1=1, axis2=2) - 1) / 2)
    x, y, z = R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]
    return columns(x, y, z) / (2 * sin(angle))[:, None], angle


def se2(x, y, theta):
    c, s = cos(theta), sin(theta)
    return matrix([c, -s, x], [s, c, y], [0 * x, 0 * x, 1 + 0 * x])


def se3(R, p):
    T = np.zeros((len(p), 4, 4))
    T[:, :3, :3], T[:, :3, 3], T[:, 3, 3] = R, p, 1
    return T


def dh(theta, d, a, alpha):
    c, s, ca, sa, zero = cos(theta), sin(theta), cos(alpha), sin(alpha), 0 * theta
    first, second = [c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s]
    return matrix(first, second, [zero, sa, ca, d], [zero, zero, zero, 1 + zero])


def inverse(T):
    back, n = T.copy(), T.shape[-1] - 1
    back[:, :n, :n] = T[:, :n, :n].swapaxes(-1, -2)
    back[:, :n, n] = -(back[:, :n, :n] @ T[:, :n, n:])[..., 0]
    return back


def transform(T, p):
    return (T[:, :-1, :-1] @ p[..., None])[..., 0] + T[:, :-1, -1]


def checked(R):
    """What a user writes to be sure that these are rotations, as robokin always is."""
    assert np.allclose(R @ R.swapaxes(-1, -2), np.eye(R.shape[-1]))
    assert (np.linalg.det(R) > 0).all()
    return R


def checked_pose(T):
    checked(T[:, :-1, :-1])
    return T


def planar_pose(T):
    return columns(T[:, 0, 2], T[:, 1, 2], arctan2(T[:, 1, 0], T[:, 0, 0]))


def covariance(left, right):
    """Step by step, as in the textbook; with exact arcs it would be longer."""
    theta, sigma, out = 0.0, np.zeros((3, 3)), [np.zeros((3, 3))]
    for a, b in zip(PER_TICK * left, PER_TICK * right, strict=True):
        s, turn = (a + b) / 2, (b - a) / DISTANCE
        c, d, k = cos(theta + turn / 2), sin(theta + turn / 2), s / DISTANCE
        F = np.array([[1, 0, -s * d], [0, 1, s * c], [0, 0, 1]])
        turns = [-2 / DISTANCE, 2 / DISTANCE]
        G = np.array([[c + k * d, c - k * d], [d - k * c, d + k * c], turns])
        sigma = F @ sigma @ F.T + G / 2 @ np.diag([0.01 * a, 0.01 * b]) @ G.T / 2
        theta += turn
        out.append(sigma)
    return np.array(out)


def eigen(C):
    values, vectors = np.linalg.eigh(C)
    return np.sqrt(values[:, ::-1]), vectors[..., ::-1]


def umbmark(ends_cw, ends_ccw):
    (x_cw, y_cw), (x_ccw, y_ccw) = ends_cw.mean(axis=1).T, ends_ccw.mean(axis=1).T
    alpha, beta = (y_ccw - x_ccw - x_cw - y_cw) / 16, (x_ccw - y_ccw - x_cw - y_cw) / 16
    distance, radius = DISTANCE * pi / (pi - 2 * alpha), 1 / sin(beta / 2)
    return distance, (radius + distance / 2) / (radius - distance / 2)


def links(q):
    heading = np.cumsum(q, axis=-1)
    return LINKS * cos(heading), LINKS * sin(heading), heading


def planar_forward(q):
    x, y, heading = links(q)
    return columns(x.sum(axis=-1), y.sum(axis=-1), heading[:, -1])


def planar_positions(q):
    x, y, _ = links(q)
    points = np.cumsum(np.stack([x, y], axis=-1), axis=1)
    return np.concatenate([np.zeros((len(q), 1, 2)), points], axis=1)


def jacobian(q):
    x, y = (np.cumsum(a[:, ::-1], axis=-1)[:, ::-1] for a in links(q)[:2])
    return np.stack([-y, x, np.ones_like(x)], axis=1)


def damped(J, twist):
    JT = J.swapaxes(-1, -2)
    return (JT @ np.linalg.solve(J @ JT + 0.01 * np.eye(3), twist[..., None]))[..., 0]


def planar_inverse(pose):
    x, y, phi = pose.T
    x, y = x - 0.1 * cos(phi), y - 0.1 * sin(phi)
    bend = np.arccos((x**2 + y**2 - 0.4**2 - 0.3**2) / (2 * 0.4 * 0.3))
    bend = columns(bend, -bend)
    turn = arctan2(y, x)[:, None] - arctan2(0.3 * sin(bend), 0.4 + 0.3 * cos(bend))
    return columns(turn, bend, phi[:, None] - turn - bend)


def manipulability(q):
    J = jacobian(q)[:, :2]
    return np.sqrt(np.linalg.det(J @ J.swapaxes(-1, -2)))


def rolling(steering):
    return columns(sin(ALPHA + steering), -cos(ALPHA + steering), -0.4 * cos(steering))


def sliding(steering):
    return columns(cos(ALPHA + steering), sin(ALPHA + steering), 0.4 * sin(steering))


def slip(rates, steering):
    J = np.concatenate([rolling(steering), sliding(steering)], axis=1)
    wanted = np.concatenate([0.1 * rates, 0 * rates], axis=1)
    return (J @ (np.linalg.pinv(J) @ wanted[..., None]))[..., 0] - wanted


CAR, ROBOT, LINK = (WHEELBASE, TRACK), (RADIUS, DISTANCE), (A2, A3, D1)
OBVIOUS = {
    "motion.wrap_angle": (
        lambda x: motion.wrap_angle(9 * x.theta),
        lambda x: pi - (pi - 9 * x.theta) % (2 * pi),
    ),
    "motion.to_world": (
        lambda x: motion.to_world(x.theta, x.twist),
        lambda x: turned(x.theta, *x.twist.T),
    ),
    "motion.to_body": (
        lambda x: motion.to_body(x.theta, x.twist),
        lambda x: turned(-x.theta, *x.twist.T),
    ),
    "motion.arc_step": (
        lambda x: motion.arc_step(x.pose, x.v, x.omega, DT),
        lambda x: arc(x.pose, x.v, x.omega, DT),
    ),
    "motion.move": (
        lambda x: motion.move(x.pose, x.twist, DT),
        lambda x: exponential(x.pose, x.twist, DT),
    ),
    "motion.path": (
        lambda x: motion.path([0, 0, 0], x.v, x.omega, DT),
        lambda x: path(x.v * DT, x.omega * DT),
    ),
    "motion.icr": (lambda x: motion.icr(x.pose, x.v, x.omega), lambda x: icr(x.pose, x.v, x.omega)),
    "differential_drive.body_twist": (
        lambda x: differential_drive.body_twist(x.v, x.omega, *ROBOT),
        lambda x: columns(RADIUS * (x.v + x.omega) / 2, 0, RADIUS * (x.omega - x.v) / DISTANCE),
    ),
    "differential_drive.wheel_rates": (
        lambda x: differential_drive.wheel_rates(x.v, x.omega, *ROBOT),
        lambda x: columns(x.v - x.omega * DISTANCE / 2, x.v + x.omega * DISTANCE / 2) / RADIUS,
    ),
    "differential_drive.turning_radius": (
        lambda x: differential_drive.turning_radius(x.v, x.omega, DISTANCE),
        lambda x: DISTANCE / 2 * (x.omega + x.v) / (x.omega - x.v),
    ),
    "bicycle.equivalent_steering": (
        lambda x: bicycle.equivalent_steering(x.a, x.b),
        lambda x: np.arctan(2 / (1 / tan(x.a) + 1 / tan(x.b))),
    ),
    "bicycle.ackermann": (lambda x: bicycle.ackermann(x.a, *CAR), lambda x: ackermann(x.a)),
    "bicycle.ackermann_error": (
        lambda x: bicycle.ackermann_error(x.a, x.b, *CAR),
        lambda x: 1 / tan(x.b) - 1 / tan(x.a) - TRACK / WHEELBASE,
    ),
    "bicycle.turning_radius": (
        lambda x: bicycle.turning_radius(x.a, WHEELBASE),
        lambda x: WHEELBASE / tan(x.a),
    ),
    "bicycle.corner_cut": (
        lambda x: bicycle.corner_cut(x.a, WHEELBASE),
        lambda x: WHEELBASE * tan(np.abs(x.a) / 2),
    ),
    "bicycle.lane_width": (lambda x: bicycle.lane_width(x.a, *CAR), lambda x: lane_width(x.a)),
    "bicycle.body_twist": (
        lambda x: bicycle.body_twist(x.v, x.a, WHEELBASE),
        lambda x: columns(x.v, 0, x.v * tan(x.a) / WHEELBASE),
    ),
    "bicycle.front_twist": (
        lambda x: bicycle.front_twist(x.v, x.a, WHEELBASE),
        lambda x: columns(x.v, x.v * tan(x.a), x.v * tan(x.a) / WHEELBASE),
    ),
    "bicycle.steering": (
        lambda x: bicycle.steering(x.v, x.omega, WHEELBASE),
        lambda x: np.arctan(WHEELBASE * x.omega / x.v),
    ),
    "bicycle.path": (
        lambda x: bicycle.path([0, 0, 0], x.v, x.a, WHEELBASE, DT),
        lambda x: path(x.v * DT, x.v * tan(x.a) / WHEELBASE * DT),
    ),
    "elbow_arm.forward": (lambda x: elbow_arm.forward(x.q, *LINK), lambda x: elbow_forward(x.q)),
    "elbow_arm.inverse": (lambda x: elbow_arm.inverse(x.p, *LINK), lambda x: elbow_inverse(x.p)),
    "elbow_arm.joint_positions": (
        lambda x: elbow_arm.joint_positions(x.q, *LINK),
        lambda x: elbow_positions(x.q),
    ),
    "elbow_arm.reach": (
        lambda x: elbow_arm.reach(x.a, x.b),
        lambda x: (np.abs(x.a - x.b), x.a + x.b),
    ),
    "elbow_arm.nearest_reachable": (
        lambda x: elbow_arm.nearest_reachable(x.pose, *LINK),
        lambda x: nearest(x.pose),
    ),
    "elbow_arm.on_base_axis": (
        lambda x: elbow_arm.on_base_axis(x.p),
        lambda x: np.hypot(x.p[:, 0], x.p[:, 1]) <= 1e-9,
    ),
    "euler.to_matrix": (lambda x: euler.to_matrix("ZYX", x.turns), lambda x: zyx(x.turns)),
    "euler.from_matrix": (
        lambda x: euler.from_matrix("ZYX", x.R),
        lambda x: yaw_pitch_roll(checked(x.R)),
    ),
    "euler.solutions": (
        lambda x: euler.solutions("ZYX", x.R),
        lambda x: both_solutions(checked(x.R)),
    ),
    "euler.is_locked": (
        lambda x: euler.is_locked("ZYX", x.R),
        lambda x: np.hypot(checked(x.R)[:, 0, 0], x.R[:, 1, 0]) <= 1e-9,
    ),
    "euler.steps": (lambda x: euler.steps("ZYX", x.turns), lambda x: zyx_steps(x.turns)),
    "euler.from_axis_angle": (
        lambda x: euler.from_axis_angle(x.pose, x.theta),
        lambda x: rodrigues(x.pose, x.theta),
    ),
    "euler.to_axis_angle": (lambda x: euler.to_axis_angle(x.R), lambda x: axis_angle(checked(x.R))),
    "frames.se2": (
        lambda x: frames.se2(x.v, x.omega, x.theta),
        lambda x: se2(x.v, x.omega, x.theta),
    ),
    "frames.se3": (lambda x: frames.se3(x.R, x.pose), lambda x: se3(checked(x.R), x.pose)),
    "frames.pose": (lambda x: frames.pose(x.T2), lambda x: planar_pose(checked_pose(x.T2))),
    "frames.dh": (
        lambda x: frames.dh(x.theta, x.a, x.b, x.omega),
        lambda x: dh(x.theta, x.a, x.b, x.omega),
    ),
    "frames.inverse in space": (
        lambda x: frames.inverse(x.T3),
        lambda x: inverse(checked_pose(x.T3)),
    ),
    "frames.inverse": (
        lambda x: frames.inverse(x.T2),
        lambda x: inverse(checked_pose(x.T2)),
    ),
    "frames.compose in space": (
        lambda x: frames.compose(x.T3, x.T3),
        lambda x: checked_pose(x.T3) @ checked_pose(x.T3),
    ),
    "frames.compose": (
        lambda x: frames.compose(x.T2, x.T2),
        lambda x: checked_pose(x.T2) @ checked_pose(x.T2),
    ),
    "frames.transform in space": (
        lambda x: frames.transform(x.T3, x.pose),
        lambda x: transform(checked_pose(x.T3), x.pose),
    ),
    "frames.transform": (
        lambda x: frames.transform(x.T2, x.pose[:, :2]),
        lambda x: transform(checked_pose(x.T2), x.pose[:, :2]),
    ),
    "frames.check_rotation": (lambda x: frames.check_rotation(x.R), lambda x: checked(x.R)),
    "odometry.travel": (
        lambda x: odometry.travel(x.left, TICKS, RADIUS),
        lambda x: PER_TICK * x.left,
    ),
    "odometry.unwrap_counter": (
        lambda x: odometry.unwrap_counter(x.counts, 8),
        lambda x: (np.diff(x.counts) + 128) % 256 - 128,
    ),
    "odometry.path": (
        lambda x: odometry.path(x.left, x.right, TICKS, *ROBOT),
        lambda x: path(PER_TICK * (x.left + x.right) / 2, PER_TICK * (x.right - x.left) / DISTANCE),
    ),
    "odometry.velocity": (
        lambda x: odometry.velocity(x.left, x.right, DT, TICKS, *ROBOT),
        lambda x: (
            PER_TICK * (x.left + x.right) / 2 / DT,
            PER_TICK * (x.right - x.left) / DISTANCE / DT,
        ),
    ),
    "odometry.covariance": (
        lambda x: odometry.covariance(x.left[:1000], x.right[:1000], TICKS, *ROBOT, 0.01),
        lambda x: covariance(x.left[:1000], x.right[:1000]),
    ),
    "odometry.ellipse": (lambda x: odometry.ellipse(x.C), lambda x: eigen(x.C)),
    "odometry.umbmark": (
        lambda x: odometry.umbmark(*x.ends, 2.0, DISTANCE),
        lambda x: umbmark(*x.ends),
    ),
    "planar_arm.forward": (lambda x: arm.forward(x.q, LINKS), lambda x: planar_forward(x.q)),
    "planar_arm.joint_positions": (
        lambda x: arm.joint_positions(x.q, LINKS),
        lambda x: planar_positions(x.q),
    ),
    "planar_arm.jacobian": (lambda x: arm.jacobian(x.q, LINKS), lambda x: jacobian(x.q)),
    "planar_arm.velocity": (
        lambda x: arm.velocity(x.q, x.rates, LINKS),
        lambda x: (jacobian(x.q) @ x.rates[..., None])[..., 0],
    ),
    "planar_arm.joint_rates undamped": (
        lambda x: arm.joint_rates(x.q, x.twist, LINKS),
        lambda x: np.linalg.solve(jacobian(x.q), x.twist[..., None])[..., 0],
    ),
    "planar_arm.joint_rates": (
        lambda x: arm.joint_rates(x.q, x.twist, LINKS, 0.1),
        lambda x: damped(jacobian(x.q), x.twist),
    ),
    "planar_arm.inverse": (lambda x: arm.inverse(x.hand, LINKS), lambda x: planar_inverse(x.hand)),
    "planar_arm.manipulability": (
        lambda x: arm.manipulability(x.q, LINKS),
        lambda x: manipulability(x.q),
    ),
    "planar_arm.ellipse": (
        lambda x: arm.ellipse(x.q, LINKS),
        lambda x: np.linalg.svd(jacobian(x.q)[:, :2], full_matrices=False)[1::-1],
    ),
    "wheels.rolling": (
        lambda x: wheels.rolling(STEERED, x.steering),
        lambda x: rolling(x.steering),
    ),
    "wheels.sliding": (
        lambda x: wheels.sliding(STEERED, x.steering),
        lambda x: sliding(x.steering),
    ),
    "wheels.forward": (
        lambda x: wheels.forward(OMNI, x.rates, theta=x.theta),
        lambda x: turned(x.theta, *(0.05 * x.rates @ np.linalg.inv(J1).T).T),
    ),
    "wheels.inverse": (
        lambda x: wheels.inverse(OMNI, x.twist, theta=x.theta),
        lambda x: turned(-x.theta, *x.twist.T) @ J1.T / 0.05,
    ),
    "wheels.slip": (
        lambda x: wheels.slip(STEERED, x.steering, x.steering),
        lambda x: slip(x.steering, x.steering),
    ),
}
