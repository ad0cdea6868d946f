"""Expected values for the page before the chapters: figures, feedback, predictions."""

import numpy as np


def direction_readouts(x, y):
    """Return the direction by atan2, and by the arctangent, which has no answer at x = 0."""
    quotient = np.full_like(x, np.nan)
    np.divide(y, x, out=quotient, where=x != 0)
    return np.column_stack([np.arctan2(y, x), np.arctan(quotient)])


READOUTS = {"direction": direction_readouts}
SPECIALS = {
    "direction": [{"p_x": 0.0}, {"p_y": 0.0}, {"p_x": 0.0, "p_y": -0.7}, {"p_x": -1.0, "p_y": 0.0}]
}
WORDS = [("direction", {"p_x": 0.0}, "wrong", "no answer: division by zero")]
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "behind-and-left": "−45°",
    "sine-of-90": "about 0.89",
    "turned-by-30": "(0.87, 0.50)",
}
