"""Predictions: questions that take an answer before they open what the answer is.

`Prediction` says how one is declared and shown.
"""

import courseware.answers  # its scripts read and keep guesses
from courseware.predictions.notebook import ask
from courseware.predictions.prediction import Buttons, Ghost, Number, Prediction, nearest_option
from courseware.script.parts import Part, register

register(
    Part(
        name="predictions",
        page="courseware/predictions/predictions.js:startPredictions",
        styles=("courseware/predictions/predictions.css",),
    )
)
