"""The exercises of the chapter, and the mistakes that are made there."""

from booklet.optics import formulas
from booklet.optics.formulas import d_i, d_o, f, h_o
from booklet.optics.functions import image_distance, image_height
from courseware.answers import Unknown
from courseware.practice import (
    Exercise,
    Mistake,
    Solution,
    Step,
    WrongFormula,
    number_range,
)

added = Mistake(
    "M1",
    feedback="with 1/f and 1/d_o added, not subtracted",
    formula=WrongFormula(formulas.image_distance, instead=f * d_o / (d_o + f)),
    line="d_i = f * d_o / (d_o + f)\nh_i = -h_o * d_i / d_o",
    why="1/f is the sum of 1/d_o and 1/d_i. So 1/d_i is the difference of the two others.",
    unnoticed="Far from the lens: both images are near the focus.",
    title="Before the focus",
    picture="The image is nearer than the focus.",
)
upside_down = Mistake(
    "M2",
    feedback="with the ratio of the distances upside down",
    formula=WrongFormula(formulas.image_height, instead=-h_o * d_o / d_i),
    line="d_i = f * d_o / (d_o - f)\nh_i = -h_o * d_o / d_i",
    why="The ray through the middle of the lens goes straight on. So what is nearer is smaller.",
    unnoticed="Where both distances are twice the focal length.",
    title="Nearer but larger",
    picture="The image is larger than the candle.",
)

candle_height = Exercise(
    "optics-1",
    title="How tall is the image?",
    text=(
        "A statue of height {h_o} is {d_o} in front of a lens of focal length {f}. How tall is its "
        "image? A negative height is upside down."
    ),
    given={
        "d_o": number_range(60, 120, 10, "cm"),
        "f": number_range(20, 40, 5, "cm"),
        "h_o": number_range(40, 80, 10, "cm"),
    },
    unknowns=(Unknown("h_i", "m"),),
    right=lambda d_o, f, h_o: image_height(d_o, image_distance(d_o, f), h_o),
    wrong={
        added: lambda d_o, f, h_o: image_height(d_o, added.formula.evaluate(d_o=d_o, f=f), h_o),
        upside_down: lambda d_o, f, h_o: upside_down.formula.evaluate(
            d_o=d_o, d_i=image_distance(d_o, f), h_o=h_o
        ),
    },
    solution=Solution(
        "First the distance of the image:\n\n{distance}\n\n"
        "The ray through the middle of the lens goes straight on. So the heights are as the "
        "distances:\n\n{height}",
        distance=Step(formulas.image_distance),
        height=Step(formulas.image_height),
    ),
    example={"d_o": 0.9, "f": 0.3, "h_o": 0.6},
)
