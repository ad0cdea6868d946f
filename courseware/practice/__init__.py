"""Exercises with numbers of their own for every student, and a check that names the mistake.

In a notebook: `practice.exercise("differential-drive-1")`. For teachers: `python -m classroom`.
"""

from typing import Any

from courseware.line_breaks import UNBROKEN
from courseware.practice import rendering
from courseware.practice.bank import all_exercises, all_mistakes, all_topics
from courseware.practice.declaration import (
    Exercise,
    Unknown,
    angle,
    matrix,
    number_range,
    one_of,
    whole,
)
from courseware.practice.formatting import format_number
from courseware.practice.mistakes import Mistake, Picture
from courseware.practice.notebook import example, exercise, export, mistake, student
from courseware.practice.solution_steps import LocalEquation, Step
from courseware.practice.solutions import Solution
from courseware.practice.wrong_formula import WrongFormula
from courseware.script.parts import Part, register
from courseware.units import unit_constants


def program(name: str) -> Any:
    """Show a program exercise: `program("bicycle-p1")`; `.check(step)` judges your function."""
    from courseware.programs.notebook import ProgramBox  # it needs this package

    return ProgramBox(name)


register(
    Part(
        name="practice",
        page="courseware/practice/page.js:startDesk",
        marker="rk-exercise",
        widget="courseware/practice/notebook.js:showExercise",
        styles=("courseware/practice/practice.css",),
        constants={
            "courseware/practice/constants.js": rendering.constants,
            "courseware/practice/units.js": lambda: {"UNBROKEN": UNBROKEN, **unit_constants()},
        },
    )
)
register(
    Part(
        name="progress",
        page="courseware/practice/progress.js:startProgress",
        marker="",  # every page has a menu
    )
)

__all__ = [
    "Exercise",
    "LocalEquation",
    "Mistake",
    "Picture",
    "Solution",
    "Step",
    "Unknown",
    "WrongFormula",
    "all_exercises",
    "all_mistakes",
    "all_topics",
    "angle",
    "example",
    "exercise",
    "export",
    "format_number",
    "matrix",
    "mistake",
    "number_range",
    "one_of",
    "program",
    "student",
    "whole",
]
