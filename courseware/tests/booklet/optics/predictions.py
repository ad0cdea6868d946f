"""Predictions that the chapter asks for."""

from booklet.optics import formulas
from booklet.optics.formulas import d_o, f
from courseware.predictions import Number, Prediction

CANDLE = {d_o: 0.4, f: 0.1}

PREDICTIONS = (
    Prediction(
        "optics-where",
        "The focal length is 10 cm, and the candle is 40 cm in front of the lens. How far behind "
        "it is the image?",
        Number(
            "cm",
            right=formulas.image_distance.substitute(CANDLE),
            assumptions={"The image of all things is at the focus.": CANDLE[f]},
        ),
        explanation="The light of a near candle spreads, and the lens has to bend it together.",
    ),
)
