"""Arguments of the functions of `robokin.motion`."""

from arguments import METHOD, POSE, TWIST, data, number, row, steps

ROWS = {
    "wrap_angle": row([()], angle=data(0.3)),
    "to_world": row([(3,)], theta=data(0.3), twist=data(TWIST)),
    "to_body": row([(3,)], theta=data(0.3), twist=data(TWIST)),
    "arc_step": row([(3,)], pose=data(POSE), v=data(0.5), omega=data(0.2), dt=number(0.1)),
    "move": row([(3,)], pose=data(POSE), twist=data(TWIST), dt=number(0.1)),
    "path": row(
        [(5, 3)],
        pose=data(POSE),
        v=steps([1.0, 0.5, -1.0, 2.0]),
        omega=steps([0.3, -0.2, 0.0, 1.0]),
        dt=number([0.1, 0.2, 0.1, 0.3], (4,)),
        method=METHOD,
    ),
    "icr": row([(2,)], limit_at_infinity=("omega",), pose=data(POSE), v=data(0.5), omega=data(0.2)),
}
