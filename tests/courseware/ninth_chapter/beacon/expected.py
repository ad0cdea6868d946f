"""What the figure of the chapter on the beacon must show."""

import numpy as np
from book.beacon.functions import range_and_bearing


def beacon_readouts(b_x, b_y, theta, *guess):
    """Return distance; and the bearing before it is wrapped, as the figure tells it."""
    still = np.zeros_like(theta)
    pose = np.column_stack([still, still, still])
    seen = range_and_bearing(pose, np.column_stack([b_x, b_y]))
    return {"distance": seen[:, 0], "bearing": seen[:, 1] - theta}


def mistake_readouts(believed, theta):
    """Return how far beside the beacon it looks."""
    still = np.zeros_like(theta)
    seen = range_and_bearing(np.column_stack([still, still, still]), [0.6, 0.4])
    return {"apart": believed - (seen[:, 1] - theta)}


READOUTS = {
    "beacon": beacon_readouts,
    "beacon-guess": beacon_readouts,
    "wrong-beacon": mistake_readouts,
}
BEACON = [{"b_x": 0.0}, {"b_y": 0.0, "b_x": -1.0}]
SPECIALS = {"beacon": BEACON, "beacon-guess": BEACON, "wrong-beacon": [{"theta": 0.0}]}
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "beacon-1": ({"x": 0, "y": 0, "theta": 30, "b_x": 1, "b_y": 1}, {"M99": 0.7854}),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "beacon-turns": "to its right",
    "beacon-far": ("5 m", "7 m"),
    "beacon-place": ("x 0 m, y 0.5 m", "0.5 m, 0 m"),
}
