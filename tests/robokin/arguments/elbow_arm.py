"""Arguments of the functions of `robokin.elbow_arm`."""

from arguments import ANGLES, POINT, RAISE_OR_NAN, data, length, number, row

LINKS = {"a2": length(0.4), "a3": length(0.3), "d1": number(0.1)}

ROWS = {
    "forward": row([(3,)], theta=data(ANGLES), **LINKS),
    "inverse": row([(4, 3)], p=data(POINT), **LINKS, unreachable=RAISE_OR_NAN),
    "joint_positions": row([(4, 3)], theta=data(ANGLES), **LINKS),
    "reach": row([(), ()], a2=length(0.4), a3=length(0.3)),
    "nearest_reachable": row([(3,)], p=data(POINT), **LINKS),
    "on_base_axis": row([()], p=data(POINT), tol=length(1e-9)),
}
