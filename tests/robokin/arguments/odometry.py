"""Arguments of the functions of `robokin.odometry`."""

from arguments import (
    METHOD,
    POSE,
    WHEELS,
    bits,
    data,
    length,
    modulus,
    not_negative,
    row,
    tick_steps,
    ticks,
)

ENCODER = {"ticks_per_turn": length(1000), **WHEELS}
TICKS = {"ticks_left": tick_steps([3, 5, -2, 4]), "ticks_right": tick_steps([4, 1, 2, 7])}
START = data([[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.2]])

ROWS = {
    "travel": row([()], ticks=ticks(5), ticks_per_turn=length(1000), wheel_radius=length(0.03)),
    "unwrap_counter": row(
        [(4,)], counts=tick_steps([250, 3, 7, 254, 1]), bits=bits(8), nan_beside=True
    ),
    "unwrap_counter of a modulus": row(
        [(4,)], counts=tick_steps([250, 3, 7, 254, 1]), modulus=modulus(300), nan_beside=True
    ),
    "path": row([(5, 3)], **TICKS, **ENCODER, pose=data(POSE), method=METHOD),
    "velocity": row(
        [(), ()], ticks_left=ticks(5), ticks_right=ticks(7), dt=not_negative(0.1), **ENCODER
    ),
    "covariance": row(
        [(5, 3, 3)],
        **TICKS,
        **ENCODER,
        noise=not_negative(0.01),
        pose=data(POSE),
        start=START,
    ),
    "ellipse": row(
        [(2,), (2, 2)], limit_at_infinity=("covariance",), covariance=data([[0.5, 0.3], [0.3, 0.4]])
    ),
    "umbmark": row(
        [(), ()],
        bounded=True,
        limit_at_infinity=("ends_cw", "ends_ccw"),
        ends_cw=data([[0.1, 0.2], [0.2, 0.1], [0.1, 0.3]]),
        ends_ccw=data([[0.1, -0.2], [0.2, 0.1]]),
        side=length(4.0),
        wheel_distance=length(0.1),
    ),
}
