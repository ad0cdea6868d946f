"""Predictions: questions that take an answer before they open what the answer is.

Declared in a chapter's `predictions.py`, in the tuple `PREDICTIONS`:

    Prediction(
        "faster-right",
        "The right wheel is the faster one. To which side does the robot turn?",
        Buttons(("to the left", "to the right"), right="to the left",
                assumes={"to the right": "That takes the faster wheel for the inner one."}),
        opens="The faster wheel runs on the outer circle.",
    )

A cell `predictions.ask("faster-right")` shows it; the cells after it with the tag
`after-faster-right` are folded with what it opens.
"""

from workshop.practice.page import constants
from workshop.predictions.declaration import Buttons, Ghost, Number, Prediction
from workshop.predictions.notebook import ask
from workshop.script.runtime import Part, register

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
