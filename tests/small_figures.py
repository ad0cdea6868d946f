"""Small figures of no chapter, for tests of the framework."""

import json
import re

import sympy as sp

from book.motion import formulas as motion_formulas
from courseware.figures import VIEW, Curve, Figure, Point, Readout, Recurrence, Slider
from courseware.script import engine as script

a = motion_formulas.x  # some quantity in m
loose = sp.Symbol("loose")


LOOP = Recurrence((sp.Symbol("k"),), (0,), (loose,), 3, 3, (sp.Symbol("last"),))


def small_figure(**parts):
    """Return a small figure that is right, but for `parts`."""
    right = {
        "name": "small",
        "title": "A point on a line",
        "view": (-1, 1, -1, 1),
        "controls": (Slider(a, 0.0, 1.0, start=0.5, step=0.1),),
        "shapes": (Point("target", (a, 0)),),
        "readouts": (Readout("twice", "twice a", 2 * a, "m"),),
        "sentence": "x is {x}, twice that {twice}.",
    }
    return Figure(**{**right, **parts})


turn = sp.Symbol("turn")
ring = (sp.cos(turn), sp.sin(turn), 0)


def space_figure(**parts):
    """Return a figure in space, but for `parts`: a frame, a ring about its z axis, a point."""
    right = {
        "name": "space",
        "view": (-1.6, 1.6, -1.3, 1.3),
        "controls": (),
        "shapes": (
            *VIEW.frame(sp.eye(3), labels=("x", "y", "z")),
            Curve("path", VIEW.project(ring), turn, 0, 6.2831, depth=VIEW.depth(ring)),
            VIEW.point("target", (2, 0, 0)),
        ),
        "readouts": (Readout("near", "how near x is", VIEW.depth((1, 0, 0)), ""),),
        "sentence": "Seen from {azimuth}, {elevation}.",
    }
    return small_figure(**{**right, **parts})


def painted(figure, **shown):
    """Return the kinds in a picture at a setting (in the units shown), in order of painting."""
    state = [shown.get(c.key, c.start) for c in figure.controls]
    text = script.run(f"courseware.renderPicture({figure.code}, {json.dumps(state)})")
    kinds = re.findall(r"--rk-(\w+),", re.sub(r"<text.*?</text>", "", text))
    return [kind for kind in kinds if kind != "ground"]
