"""All that the course declares, as parameters of tests; their ids start with the chapter.

So `pytest -k bicycle` runs what is said of the bicycle's formulas, figures and exercises.
"""

import json
from pathlib import Path

import numpy as np
import pytest

import book  # noqa: F401  (opens the course)
from courseware.classroom import tables
from courseware.course import course
from courseware.equations import Check, Equation
from courseware.figures import Figure
from courseware.practice import Exercise, Mistake, variants
from courseware.predictions import Prediction

EQUATIONS = course().find_all("formulas", Equation)
CHECKS = course().find_all("checks", Check)
FIGURES = course().find_all("figures", Figure)
EXERCISES = course().find_all("exercises", Exercise)
MISTAKES = course().find_all("exercises", Mistake)
PREDICTIONS = course().find_all("predictions", Prediction)
COURSE = course().name
# the first exercise of each kind of answer: one number or more, a matrix, several answers
OF_EACH_KIND = list(
    {
        (e.shape, len(e.unknowns) > 1, e.accept): name for name, e in reversed(EXERCISES.items())
    }.values()
)


def each(argument, part, kind, marks=lambda name: [], only=lambda thing: True):
    """Parametrize a test over the things of a kind; marks: those of a thing, by its name."""
    homes = course().chapters_of(part, kind)
    return pytest.mark.parametrize(
        argument,
        [
            pytest.param(thing, marks=marks(name), id=f"{homes[name]}:{name}")
            for name, thing in course().find_all(part, kind).items()
            if only(thing)
        ],
    )


def table(path):
    """Return the rows of a table."""
    return [row for _, row in tables.read_rows(Path(path), tables.Problems())]


def typed(rows, exercise):
    """Rows as a student would type them."""
    shaped = np.reshape(rows, (-1, *(exercise.shape or (len(exercise.unknowns),))))
    if exercise.accept != "all":
        shaped = shaped[0]
    return json.dumps(shaped.tolist()[0] if shaped.shape == (1,) else shaped.tolist())


def judge_all():
    """A program for another Python: it has a right answer to each exercise judged."""
    deals = {name: variants.find_variant(COURSE, name, "Ada") for name in EXERCISES}
    answers = {name: typed(v.candidates[0].rows, EXERCISES[name]) for name, v in deals.items()}
    return f"""
import json, book
from courseware import practice
verdicts = {{n: practice.exercise(n, "Ada").check(a) for n, a in {answers}.items()}}
print(json.dumps({{n: verdict.result for n, verdict in verdicts.items()}}))
"""
