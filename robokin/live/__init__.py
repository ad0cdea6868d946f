"""Live figures: declared in Python, drawn and moved by one small script, with or without a kernel.

    Figure(name, title, view, controls, scene, readouts, says)

shows itself in a notebook as a widget, and keeps its declaration and a still picture for the
page. What it can hold stands in `robokin.live.declaration`.
"""

from robokin.live.declaration import (
    POINTER,
    AngleArc,
    Arrow,
    Body,
    Choice,
    Clock,
    Curve,
    Handle,
    Line,
    Point,
    Readout,
    Recurrence,
    Slider,
    Trail,
    Wheel,
)
from robokin.live.figure import Figure

__all__ = [
    "POINTER",
    "AngleArc",
    "Arrow",
    "Body",
    "Choice",
    "Clock",
    "Curve",
    "Figure",
    "Handle",
    "Line",
    "Point",
    "Readout",
    "Recurrence",
    "Slider",
    "Trail",
    "Wheel",
]
