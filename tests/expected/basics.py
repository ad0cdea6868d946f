"""Expected values for the page before the chapters: figures, feedback, predictions."""

import numpy as np

from robokin import motion


def direction_readouts(x, y):
    """Return the direction by the arctangent, which has no answer at x = 0."""
    quotient = np.full_like(x, np.nan)
    np.divide(y, x, out=quotient, where=x != 0)
    return {"wrong": np.arctan(quotient)}


def thousand_readouts(fastest, t):
    """Return how far from the start the straight one and the fastest-turning one are."""
    rates = np.stack([np.zeros_like(fastest), fastest])
    ends = motion.arc_step([0, 0, 0], v=1.0, omega=rates, dt=t)
    return dict(zip(("straight", "outer"), np.hypot(ends[..., 0], ends[..., 1]), strict=True))


READOUTS = {"direction": direction_readouts, "thousand": thousand_readouts}
SPECIALS = {
    "arrow": [{"p_x": 0.0, "p_y": 0.0}, {"p_x": -1.0, "p_y": -0.6}],
    "direction": [{"p_x": 0.0}, {"p_y": 0.0}, {"p_x": 0.0, "p_y": -0.6}, {"p_x": -1.0, "p_y": 0.0}],
    "turn": [{"theta": np.pi}, {"theta": -np.pi / 2}],
    "thousand": [{"t": 0.0}, {"fastest": 3.1, "t": 2.0}],
}
WORDS = [("direction", {"p_x": 0.0}, "wrong", "no answer: division by zero")]
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "behind-and-left": "−45°",
    "sine-of-90": "about 0.89",
    "turned-by-30": "(0.87, 0.50)",
    "thousand-ends": "nearer to the start, the more they turn",
}
GOALS = {  # figure → for each goal: settings that just reach it, and that just miss it
    "arrow": [  # within 0.05 m of (−0.8, 0.5)
        (
            [{"p_x": -0.751, "p_y": 0.5}, {"p_x": -0.83, "p_y": 0.539}],
            [{"p_x": -0.749, "p_y": 0.5}, {"p_x": -0.83, "p_y": 0.541}],
        )
    ],
    "turn": [  # within 2° (0.0349) of −90° (−1.5708)
        ([{"theta": -1.536}, {"theta": -1.605}], [{"theta": -1.535}, {"theta": -1.606}])
    ],
    "thousand": [  # 2 s: a full turn at 3.14 rad/s; 2 |sin ω| / ω below 0.05 m
        (
            [{"fastest": 3.07, "t": 2.0}, {"fastest": 3.22, "t": 2.0}],
            [{"fastest": 3.06, "t": 2.0}, {"fastest": 3.23, "t": 2.0}, {"t": 0.04}],
        )
    ],
}
