"""Try all that a chapter declares, in a Python of its own: `declared_right.py PACKAGE CHAPTER`."""

import sys
from importlib import import_module

import numpy as np
from verification import verify

from courseware import judge, practice
from courseware.course import course
from courseware.equations import Check
from courseware.figures import Figure
from courseware.practice import Exercise
from courseware.predictions import Prediction
from courseware.programs.program import Program
from courseware.programs.storing import store

package, chapter = sys.argv[1:]
import_module(package)  # opens the course


def own(part, kind):
    """Return what the chapter declares of a kind; there is something of each."""
    homes = course().chapters_of(part, kind)
    found = [x for name, x in course().find_all(part, kind).items() if homes[name] == chapter]
    assert found, f"{chapter} has no {kind.__name__}"
    return found


def judge_code(program, code):
    """Return the verdict on the function in some code."""
    names = {"np": np}
    exec(code, names)
    return judge.check(names[program.definition.name], store(program))


assert all(verify(check, samples=20).agrees for check in own("checks", Check))
assert all(figure.code for figure in own("figures", Figure))
assert all(prediction.answers.format_answer() for prediction in own("predictions", Prediction))
for exercise in own("exercises", Exercise):
    box = practice.exercise(exercise.name, student="Ada")
    said = {each.name: box.check(float(each.rows[0][0])) for each in box.variant.candidates}
    assert said["right"].result == "right"
    assert all(mistake.feedback in said[mistake.name].feedback for mistake in exercise.wrong)
for program in own("programs", Program):
    assert judge_code(program, program.solution).right
    assert not judge_code(program, program.starter).right
