"""Arguments of the functions of `robokin.wheels`."""

import numpy as np

from arguments import ANGLES, RAISE_OR_NAN, data, length, not_negative, number, row, wheels
from robokin.wheels import fixed, omni_robot, steered

SPOKE = {"l": not_negative(0.2), "alpha": number(0.3)}
OMNI = wheels(lambda: omni_robot(0.2, 0.05))
CAR_WHEELS = wheels(
    lambda: [
        fixed(0.2, np.pi / 2, 0, 0.05),
        fixed(0.2, -np.pi / 2, np.pi, 0.05),
        steered(0.3, 0, np.pi / 2, 0.05),
    ]
)

ROWS = {
    "fixed": row(None, False, **SPOKE, beta=number(0.1), radius=length(0.05)),
    "steered": row(None, False, **SPOKE, beta=number(0.1), radius=length(0.05)),
    "castor": row(None, False, **SPOKE, beta=number(0.1), radius=length(0.05), d=number(0.02)),
    "swedish": row(None, False, **SPOKE, beta=number(0.1), radius=length(0.05), gamma=number(0.7)),
    "spherical": row(None, False, **SPOKE, radius=length(0.05)),
    "omni_robot": row(
        None, False, l=not_negative(0.2), radius=length(0.05), angles=number([0.0, 2.1, 4.2], (3,))
    ),
    "rolling": row([(3, 3)], wheels=CAR_WHEELS, steering=data([1.4])),
    "rolling_rates": row([(3, 3)], wheels=OMNI),
    "sliding": row([(3, 3)], wheels=CAR_WHEELS, steering=data([1.4])),
    "forward": row(
        [(3,)], wheels=CAR_WHEELS, rates=data(ANGLES), steering=data([1.4]), theta=data(0.3)
    ),
    "slip": row([(6,)], wheels=CAR_WHEELS, rates=data(ANGLES), steering=data([1.4])),
    "inverse": row(
        [(3,)],
        wheels=CAR_WHEELS,
        twist=data([0.5, 0.0, 0.0]),
        steering=data([np.pi / 2]),
        theta=data(0.0),
        slipping=RAISE_OR_NAN,
    ),
    "mobility": row(None, wheels=OMNI),
}
