"""Arguments of the functions of `robokin.euler`."""

from arguments import ANGLES, POINT, TURNED, data, length, matrix, name, row

SEQ = name("ZYX")

ROWS = {
    "to_matrix": row([(3, 3)], seq=SEQ, angles=data(ANGLES)),
    "from_matrix": row([(3,)], seq=SEQ, R=matrix(TURNED)),
    "solutions": row([(2, 3)], seq=SEQ, R=matrix(TURNED)),
    "is_locked": row([()], seq=SEQ, R=matrix(TURNED), tol=length(1e-9)),
    "steps": row([(4, 3, 3)], seq=SEQ, angles=data(ANGLES)),
    "about": row([(3, 3)], axis=data(POINT), angle=data(0.3)),
    "axis_angle": row([(3,), ()], R=matrix(TURNED)),
}
