"""Live figures: declared in Python, drawn and moved by one small script, with or without a kernel.

    Figure(name, title, view, controls, scene, readouts, says)

shows itself in a notebook as a widget, and keeps its declaration and a still picture for the
page. What it can hold stands in `workshop.figures.declaration`, and for pictures in space in
`workshop.figures.space`.
"""

from workshop.figures.declaration import (
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
from workshop.figures.figure import Figure
from workshop.figures.space import VIEW, View, view_sliders

__all__ = [
    "POINTER",
    "VIEW",
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
    "View",
    "Wheel",
    "view_sliders",
]
