"""Predictions: questions that take an answer before they open what the answer is.

`Prediction` says how one is declared and shown.
"""

from courseware.practice.page import constants
from courseware.predictions.declaration import Buttons, Ghost, Number, Prediction
from courseware.predictions.notebook import ask
from courseware.script.runtime import Part, register

register(
    Part(
        name="predictions",
        package=__name__,
        scripts=("predictions.js",),
        styles=("predictions.css",),
        called_by="rk-prediction",
        needs=("practice",),  # reads answers, keeps them
        constants=lambda: {"STORE": constants()["STORE"]},
    )
)

__all__ = ["Buttons", "Ghost", "Number", "Prediction", "ask"]
