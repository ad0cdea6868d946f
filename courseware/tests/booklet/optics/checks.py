"""How the functions agree with the formulas."""

from booklet.optics import formulas
from booklet.optics.formulas import d_i, d_o, f, h_o
from booklet.optics.functions import focal_length, image_distance, image_height
from courseware.equations import Check

CHECKS = (
    Check(
        formulas.image_distance,
        function=image_distance,
        arguments=(d_o, f),
        tolerance=1e-14,
        reason="some roundings, made up to 20 times as large by the difference",
        specials=({d_o: 0.2, f: 0.1},),
    ),
    Check(
        formulas.image_height,
        function=image_height,
        arguments=(d_o, d_i, h_o),
        tolerance=1e-15,
        reason="a few roundings of numbers below 1",
    ),
    Check(
        formulas.focal_length,
        function=focal_length,
        arguments=(d_o, d_i),
        tolerance=1e-15,
        reason="a few roundings of numbers below 1",
    ),
)
