"""The picture of a verdict: the right answer, and the student's as a wrong thing beside it."""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import sympy as sp

from courseware.course import course
from courseware.explaining import join_numbers
from courseware.figures import VIEW, Choice, Curve, Figure, Sprite
from courseware.figures.figure import inline_colors
from courseware.figures.solids import Solid
from courseware.programs.program import Program
from courseware.programs.storing import name_numbers, store
from courseware.script import engine

WORDS = "In full colour: what is right. Red: what your function gives. Pale: what is given."


@cache
def answer_figure(program: Program) -> Figure:
    """Return the figure of a program: its numbers are those of `Verdict.numbers`."""
    stored = store(program)
    case, shape = stored["cases"][0], stored["shape"]
    right = np.reshape(case["right"], shape)
    given = (right, right, *case["arguments"])
    parts = name_numbers(*given)
    symbols, numbers = (tuple(join_numbers(*each).tolist()) for each in (parts, given))
    scene = tuple(program.picture(*parts))
    grounds = (*course().materials.grounds, "", "")
    places = tuple(place for shape in scene for place in _places(shape, program.extent))
    return Figure(
        name=program.name,
        title=WORDS,
        sentence=WORDS,
        view=(-8, 8, -5, 5),
        shapes=scene,
        controls=(Choice("answer", WORDS, symbols, {"": numbers}),),
        contain=places,
        ground=grounds[any(isinstance(shape, Solid) for shape in scene)],
    )


def _places(shape: Any, extent: float) -> Iterator[Any]:
    """Yield the places of a shape that the picture must show."""
    if isinstance(shape, Solid | Sprite):
        at = shape.at[:2] if isinstance(shape, Sprite) else VIEW.project(shape.at)
        size = getattr(shape, "size", 1)
        yield from ([x + way * extent * size for x in at] for way in (-1, 1))
    elif isinstance(shape, Curve):
        for part in range(5):
            value = shape.low + part * (shape.high - shape.low) / 4
            yield [sp.sympify(x).subs(shape.parameter, value) for x in shape.at[:2]]
    else:
        yield from getattr(shape, "points", ())
        ends = (getattr(shape, name, None) for name in ("at", "tail", "head"))
        yield from (end[:2] for end in ends if end is not None)


def render_answer(program: Program, numbers: tuple[float, ...]) -> str:
    """Return the picture of a verdict, as HTML."""
    code = answer_figure(program).code
    return inline_colors(engine.run(f"courseware.renderAnswer({code}, {list(numbers)})"))
