"""Exercises with numbers of their own for every student, and a check that names the mistake.

In a notebook: `practice.exercise("differential-drive-1")`. For teachers: `python -m classroom`.
"""

from courseware.line_breaks import UNBROKEN
from courseware.practice import page
from courseware.practice.bank import (
    Ask,
    Exercise,
    Mistake,
    Picture,
    angle,
    exercises,
    matrix,
    mistakes,
    one_of,
    steps,
    topics,
    whole,
)
from courseware.practice.notebook import answers, example, exercise, export, mistake, student
from courseware.practice.solutions import Line, Solution, Step
from courseware.practice.wording import number_text
from courseware.practice.wrong import Wrong
from courseware.script.parts import Part, register
from courseware.units import typed_units

register(
    Part(
        name="practice",
        page="courseware/practice/page.js:startDesk",
        called_by="rk-exercise",
        widget="courseware/practice/notebook.js:showExercise",
        styles=("courseware/practice/practice.css",),
        constants={
            "courseware/practice/constants.js": page.constants,
            "courseware/practice/units.js": lambda: {"UNBROKEN": UNBROKEN, **typed_units()},
        },
    )
)
register(
    Part(
        name="progress",
        page="courseware/practice/progress.js:startProgress",
        called_by="",  # every page has a menu
    )
)

__all__ = [
    "Ask",
    "Exercise",
    "Line",
    "Mistake",
    "Picture",
    "Solution",
    "Step",
    "Wrong",
    "angle",
    "answers",
    "example",
    "exercise",
    "exercises",
    "export",
    "matrix",
    "mistake",
    "mistakes",
    "number_text",
    "one_of",
    "steps",
    "student",
    "topics",
    "whole",
]
