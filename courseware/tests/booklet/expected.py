"""What the chapter must come to, worked out a second time."""

from booklet.optics.functions import image_height


def mistakes_readouts(nearer, larger):
    """Return the height for a candle of 5 cm, 30 cm in front of a lens of 10 cm."""
    return {"height": nearer * image_height(0.3, 0.075, 0.05) + larger * -0.1}


READOUTS = {"optics-mistakes": mistakes_readouts}
SPECIALS = {"optics-screen": [{"d_o": 0.2, "f": 0.1}]}
FEEDBACK = {"optics-1": ({"d_o": 90, "f": 30, "h_o": 60}, {"M1": -0.15, "M2": -1.2})}
PREDICTED = {"optics-where": ("13.3 cm", "10 cm")}
GOALS = {"optics-screen": [([{"d_o": 0.1953}], [{"d_o": 0.1951}])]}  # 20.49 and 20.52 cm
