"""Arguments of the functions of `robokin.differential_drive`."""

from arguments import WHEELS, data, length, row

ROWS = {
    "body_twist": row([(3,)], rate_left=data(1.0), rate_right=data(2.0), **WHEELS),
    "turning_radius": row(
        [()], rate_left=data(1.0), rate_right=data(2.0), wheel_distance=length(0.1)
    ),
    "wheel_rates": row([(2,)], v=data(0.5), omega=data(0.2), **WHEELS),
}
