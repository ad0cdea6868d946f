"""Live figures: declared in Python, drawn and moved by one small script, with or without a kernel.

    Figure(name, title, view, shapes, controls, readouts)

shows itself in a notebook as a widget, and leaves there its name, by which a page finds it, and a
still picture. Its parts are declared with the words of `computed_parts`, `controls` and `shapes`,
and pictures in space with those of `space` and `solids`.
"""

from courseware.figures import looks
from courseware.figures.computed_parts import (
    Goal,
    NamedSteps,
    Readout,
    Recurrence,
    assign,
    distance,
    ramp,
)
from courseware.figures.controls import POINTER, Button, Choice, Clock, Handle, QuarterTurns, Slider
from courseware.figures.figure import Figure, Scene
from courseware.figures.shapes import (
    AngleArc,
    Area,
    Arrow,
    Bracket,
    Cloud,
    Curve,
    Label,
    Length,
    Line,
    Point,
    Track,
    Trail,
    when,
)
from courseware.figures.space import VIEW, bring_forward
from courseware.figures.sprites import Gradient, Ground, Materials, Outline, Rim, Sprite
from courseware.script.parts import Part, provide, register

provide("courseware/figures/constants.js", looks.collect_constants)
register(
    Part(
        name="figures",
        page="courseware/figures/page.js:startFigures",
        widget="courseware/figures/notebook.js:showFigure",
        styles=("courseware/figures/figure.css",),
        rules=looks.render_rules,
    )
)
