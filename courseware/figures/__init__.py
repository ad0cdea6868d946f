"""Live figures: declared in Python, drawn and moved by one small script, with or without a kernel.

    Figure(name, title, view, scene, controls, readouts)

shows itself in a notebook as a widget, and leaves there its name, by which a page finds it, and a
still picture. What it can hold stands in `courseware.figures.declaration`, and for pictures in
space in `courseware.figures.space`.
"""

from courseware.figures import kinds
from courseware.figures.declaration import (
    POINTER,
    AngleArc,
    Area,
    Arrow,
    Body,
    Choice,
    Clock,
    Curve,
    Disc,
    Goal,
    Handle,
    Label,
    Length,
    Line,
    NamedSteps,
    Point,
    Readout,
    Recurrence,
    Slider,
    Trail,
    Wheel,
    assign,
    distance,
    ramp,
)
from courseware.figures.figure import Figure
from courseware.figures.graph import Graph
from courseware.figures.space import VIEW, bring_forward
from courseware.figures.turning import Bracket, QuarterTurns
from courseware.script.parts import Part, register

register(
    Part(
        name="figures",
        page="courseware/figures/page.js:startFigures",
        called_by="rk-figure",
        widget="courseware/figures/notebook.js:showFigure",
        styles=("courseware/figures/figure.css",),
        constants={"courseware/figures/constants.js": kinds.constants},
        rules=kinds.rules,
    )
)

__all__ = [
    "POINTER",
    "VIEW",
    "AngleArc",
    "Area",
    "Arrow",
    "Body",
    "Bracket",
    "Choice",
    "Clock",
    "Curve",
    "Disc",
    "Figure",
    "Goal",
    "Graph",
    "Handle",
    "Label",
    "Length",
    "Line",
    "NamedSteps",
    "Point",
    "QuarterTurns",
    "Readout",
    "Recurrence",
    "Slider",
    "Trail",
    "Wheel",
    "assign",
    "bring_forward",
    "distance",
    "ramp",
]
