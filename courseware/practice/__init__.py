"""Exercises with numbers of their own for every student, and a check that names the mistake.

In a notebook: `practice.exercise("differential-drive-1")`. For teachers: `python -m
courseware.classroom`.
"""

from courseware.practice import rendering
from courseware.practice.bank import all_exercises, all_mistakes, all_topics
from courseware.practice.exercises import Exercise, number_range, one_of
from courseware.practice.mistakes import Mistake
from courseware.practice.notebook import example, exercise, export, mistake, student
from courseware.practice.solution_steps import LocalEquation, Step
from courseware.practice.solutions import Solution
from courseware.practice.wrong_formula import WrongFormula
from courseware.script.parts import Part, provide, register
from courseware.units.formatting import format_number

provide("courseware/practice/constants.js", rendering.constants)
register(
    Part(
        name="practice",
        page="courseware/practice/page.js:startDesk",
        widget="courseware/practice/notebook.js:showExercise",
        styles=("courseware/practice/practice.css",),
    )
)
