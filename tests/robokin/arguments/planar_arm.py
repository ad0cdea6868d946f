"""Arguments of the functions of `robokin.planar_arm`."""

from arguments import ANGLES, POSE, RAISE_OR_NAN, TWIST, data, length, not_negative, row

THREE = [0.4, 0.3, 0.1]

ROWS = {
    "forward": row([(3,)], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "joint_positions": row([(4, 2)], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "jacobian": row([(3, 3)], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "velocity": row([(3,)], theta=data(ANGLES), rates=data(TWIST), lengths=length(THREE, (3,))),
    "joint_rates": row(
        [(3,)],
        theta=data(ANGLES),
        twist=data(TWIST),
        lengths=length(THREE, (3,)),
        damping=not_negative(0.1),
        singular=RAISE_OR_NAN,
    ),
    "joint_rates undamped": row(
        [(3,)],
        theta=data(ANGLES),
        twist=data(TWIST),
        lengths=length(THREE, (3,)),
        singular=RAISE_OR_NAN,
    ),
    "inverse": row(
        [(2, 3)], pose=data(POSE), lengths=length(THREE, (3,)), unreachable=RAISE_OR_NAN
    ),
    "manipulability": row([()], theta=data(ANGLES), lengths=length(THREE, (3,))),
    "ellipse": row([(2,), (2, 2)], theta=data(ANGLES), lengths=length(THREE, (3,))),
}
