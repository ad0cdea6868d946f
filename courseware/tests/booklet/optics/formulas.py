"""The formulas of the chapter, each declared once."""

from courseware.equations import Equation, as_written, declarations

quantity, _ = declarations(__name__)

d_o = quantity("d_o", "m", 0.2, 0.5, "object distance: from the object to the lens")
d_i = quantity("d_i", "m", 0.05, 0.6, "image distance: from the lens to the image")
f = quantity("f", "m", 0.05, 0.15, "focal length")
h_o = quantity("h_o", "m", 0.02, 0.1, "height of the object")
h_i = quantity("h_i", "m", -0.3, 0, "height of the image, negative if upside down")

LOOKS = {d_o: "length", d_i: "target"}

with as_written():
    image_distance = Equation(name="optics.image_distance", left=d_i, right=f * d_o / (d_o - f))
    image_height = Equation(name="optics.image_height", left=h_i, right=-h_o * d_i / d_o)
    focal_length = Equation(name="optics.focal_length", left=f, right=d_o * d_i / (d_o + d_i))
