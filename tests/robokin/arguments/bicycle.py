"""Arguments of the functions of `robokin.bicycle`."""

from arguments import METHOD, POSE, data, length, number, row, steps

CAR = {"wheelbase": length(2.5), "track": length(1.5)}

ROWS = {
    "equivalent_steering": row([()], alpha_left=data(0.3), alpha_right=data(0.2)),
    "ackermann": row([(2,)], phi=data(0.3), **CAR),
    "turning_radius": row([()], phi=data(0.3), wheelbase=length(2.5)),
    "corner_cut": row([()], phi=data(0.3), wheelbase=length(2.5)),
    "lane_width": row([()], phi=data(0.3), **CAR),
    "ackermann_error": row([()], alpha_left=data(0.3), alpha_right=data(0.2), **CAR),
    "body_twist": row([(3,)], v=data(1.0), phi=data(0.3), wheelbase=length(2.5)),
    "steering": row(
        [()], limit_at_infinity=("v", "omega"), v=data(1.0), omega=data(0.3), wheelbase=length(2.5)
    ),
    "front_twist": row([(3,)], v=data(1.0), phi=data(0.3), wheelbase=length(2.5)),
    "path": row(
        [(5, 3)],
        pose=data(POSE),
        v=steps([1.0, 0.5, -1.0, 2.0]),
        phi=steps([0.3, -0.2, 0.0, 1.0]),
        wheelbase=length(2.5),
        dt=number([0.1, 0.2, 0.1, 0.3], (4,)),
        method=METHOD,
    ),
}
