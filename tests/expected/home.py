"""Expected values for the first page's figure."""

import numpy as np
from expected.differential_drive import driven, off_and_turned, twist_of

CHARGER = driven(np.float64(0.09), np.float64(-0.6), 3.0)


def hero_readouts(v_left, v_right, t):
    """Return how far from the charger the robot ends, in cm, and how far turned."""
    found = off_and_turned(driven(*twist_of(v_left, v_right), 3.0), CHARGER)
    return {**found, "off": 100 * found["off"]}


READOUTS = {"hero": hero_readouts}
SPECIALS = {"hero": [{"v_L": 0.0, "v_R": 0.0}, {"v_L": 0.12, "v_R": 0.06}]}
GOALS = {  # 0.09 m/s and −0.6 rad/s for 3 s, within 0.02 m and 5°
    "hero": [
        (
            [{"v_L": 0.1186, "v_R": 0.0614}, {"v_L": 0.126, "v_R": 0.066}],
            [{"v_L": 0.1184, "v_R": 0.0616}, {"v_L": 0.1285, "v_R": 0.0685}],
        )
    ]
}
