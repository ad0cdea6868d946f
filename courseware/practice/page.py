"""An exercise for the browser: its data, packed, and its box as HTML.

The data are JSON, compressed (zlib) and in base64: small, and not readable at a glance. A student
who unpacks them finds the answers, so the boxes are for checking oneself.
"""

import base64
import hashlib
import json
import zlib
from collections import Counter
from collections.abc import Iterable
from functools import cache
from typing import Any

from courseware.course import course
from courseware.equations.equation import Equation
from courseware.equations.notebook import equation_anchor, equation_label, shown_equations
from courseware.equations.text import formula_text
from courseware.practice import dealing, judging
from courseware.practice.bank import Exercise, exercises
from courseware.script import engine

MIME = "application/vnd.courseware.exercise+json"


def constants() -> dict[str, Any]:
    """What the script needs of Python: how many variants there are, the name of its store, and how
    many exercises each chapter has."""
    count = Counter(exercise.topic for exercise in exercises().values())
    chapters = {course().title(t): (t, n) for t, n in count.items() if t in course().taught}
    return {"VARIANTS": dealing.VARIANTS, "STORE": course().name, "TOPICS": chapters}


def contents(exercise: Exercise, solutions: bool = True) -> dict[str, Any]:
    """All that the browser knows of an exercise."""
    solution = exercise.solution_text if solutions else ""
    return {
        **question(exercise),
        "solution": solution,
        "topic": exercise.topic,
        "look": look(exercise),
        **judging.essence(exercise),
        "variants": [
            {
                "shown": shown(exercise, variant, exercise.text + solution),
                "candidates": judging.listed(exercise, variant.candidates),
            }
            for variant in dealing.variants(exercise.name)
        ],
    }


def look(exercise: Exercise) -> dict[str, Any]:
    """Where to look who does not know how to begin: the chapter, and the formulas that the solution
    uses, each as what it gives and where the chapter prints it."""
    places = {
        equation.name: equation_anchor(equation_label(equation.name, computed))
        for equation, computed in shown_equations(exercise.topic)
    }
    steps = exercise.solution.steps.values()
    used = dict.fromkeys(s.formula for s in steps if isinstance(s.formula, Equation))
    return {
        "chapter": course().title(exercise.topic),
        "formulas": [[gives(formula), places.get(formula.name, "")] for formula in used],
    }


def gives(formula: Equation) -> str:
    """The left side of a formula, without the brackets of a list."""
    text = formula_text(formula.left)
    return text.strip("[]") if text.count("[") == 1 else text


def question(exercise: Exercise) -> dict[str, Any]:
    """The part of an exercise that the waiting page shows."""
    return {
        "name": exercise.name,
        "title": exercise.title,
        "level": exercise.level,
        "text": exercise.text,
        "asked": judging.asked(exercise),
        "shape": exercise.shape,
    }


def shown(exercise: Exercise, variant: dealing.Variant, template: str) -> dict[str, str]:
    """What stands for each placeholder of a text."""
    return exercise.placeholders(template, variant.numbers, variant.shown)


def _nobody(exercise: Exercise, salt: str, template: str) -> dict[str, str]:
    """What stands for each placeholder of a text for somebody without a name."""
    variant = dealing.variants(exercise.name)[dealing.dealt(salt, exercise.name, "")]
    return shown(exercise, variant, template)


def packed(chosen: Iterable[Exercise], solutions: bool = True) -> str:
    """Exercises as the browser unpacks them."""
    data = {exercise.name: contents(exercise, solutions) for exercise in chosen}
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode("utf-8"), 9)).decode()


@cache
def script(topic: str, solutions: bool = True) -> str:
    """The file that a page loads when one of a topic's exercises is first used."""
    chosen = [exercise for exercise in exercises().values() if exercise.topic == topic]
    data = packed(chosen, solutions)
    return f'(window.coursewarePractice ??= {{}})["{topic}"] = "{data}";\n'


def box(name: str, salt: str, solutions: bool = True) -> str:
    """The HTML of an exercise with the numbers of somebody without a name."""
    exercise = dealing.find(name)
    arguments = (question(exercise), _nobody(exercise, salt, exercise.text), solutions)
    inner = engine.call("courseware.renderExercise", *arguments)
    version = hashlib.sha256(script(exercise.topic, solutions).encode()).hexdigest()[:8]
    return (
        f'<div class="rk-exercise" role="group" id="{name}" data-exercise="{name}" '
        f'data-topic="{exercise.topic}" data-version="{version}" '
        f'aria-label="{exercise.title}">{inner}</div>\n'
    )


def solution(name: str, salt: str) -> str:
    """The worked solution of what `box` asks, as HTML."""
    exercise = dealing.find(name)
    text = exercise.solution_text
    return str(engine.call("courseware.renderSolution", text, _nobody(exercise, salt, text)))
