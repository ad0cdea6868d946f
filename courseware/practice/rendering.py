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
from courseware.equations.text import format_formula
from courseware.practice import judging, variants
from courseware.practice.bank import all_exercises, find_exercise
from courseware.practice.exercises import Exercise
from courseware.practice.saving import GUARD, OTHER_COLUMNS, UNGUARD
from courseware.script import engine

MIME = "application/vnd.courseware.exercise+json"


def constants() -> dict[str, Any]:
    """Return the constants of the script: how names are compared, exercises by chapter, …"""
    count = Counter(exercise.topic for exercise in all_exercises().values())
    chapters = {course().title(t): (t, n) for t, n in count.items() if t in course().taught}
    shared = {name: getattr(variants, name) for name in ("VARIANTS", "ALIKE", "IGNORED", "SPACES")}
    return {
        **shared,
        "GUARD": GUARD,
        "OTHER_COLUMNS": OTHER_COLUMNS,
        "UNGUARD": UNGUARD,
        "TOPICS": chapters,
    }


def _serialize_question(exercise: Exercise) -> dict[str, Any]:
    numbers = variants.all_variants(exercise.name)[0].numbers  # some formulas depend on them
    solution = exercise.fill(exercise.solution.text, numbers)
    steps = engine.call("courseware.splitSolution", solution)
    return {**judging.serialize_exercise(exercise), "steps": len(steps)}


def _serialize(exercise: Exercise, solutions: bool) -> dict[str, Any]:
    solution = exercise.solution.text if solutions else ""
    return {
        **_serialize_question(exercise),
        "solution": solution,
        "topic": exercise.topic,
        "hint": _serialize_hint(exercise),
        "variants": [
            {
                "shown": exercise.fill_placeholders(exercise.text + solution, variant.numbers),
                "candidates": judging.serialize_candidates(exercise, variant.candidates),
            }
            for variant in variants.all_variants(exercise.name)
        ],
    }


def _serialize_hint(exercise: Exercise) -> dict[str, Any]:
    """Return where to look: the chapter, and the formulas of the solution with their anchors."""
    anchors = {
        equation.name: equation_anchor(equation_label(equation.name, computed))
        for equation, computed in shown_equations(exercise.topic)
    }
    steps = exercise.solution.steps.values()
    used = dict.fromkeys(s.formula for s in steps if isinstance(s.formula, Equation))
    given = {left_side(formula): anchors.get(formula.name, "") for formula in used}
    return {"chapter": course().title(exercise.topic), "formulas": list(given.items())}


def left_side(formula: Equation) -> str:
    """Return the left side of a formula as text, without the brackets of a list."""
    text = format_formula(formula.left)
    return text.strip("[]") if text.count("[") == 1 else text


def pack(chosen: Iterable[Exercise], solutions: bool = True) -> str:
    data = {exercise.name: _serialize(exercise, solutions) for exercise in chosen}
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode("utf-8"), 9)).decode()


@cache
def render_script(topic: str, solutions: bool = True) -> str:
    """Return the file that a page loads when one of a topic's exercises is first used."""
    chosen = [exercise for exercise in all_exercises().values() if exercise.topic == topic]
    data = pack(chosen, solutions)
    return f'(window.coursewarePractice ??= {{}})["{topic}"] = "{data}";\n'


def render_box(name: str, salt: str, solutions: bool = True) -> str:
    """Render an exercise as HTML, with the numbers of somebody without a name."""
    exercise = find_exercise(name)
    texts = exercise.fill_placeholders(exercise.text, variants.find_variant(salt, name).numbers)
    question = _serialize_question(exercise)
    inner = engine.call("courseware.renderExercise", question, texts, solutions)
    version = hashlib.sha256(render_script(exercise.topic, solutions).encode()).hexdigest()[:8]
    return (
        f'<div class="rk-exercise" role="group" id="{name}" data-exercise="{name}" '
        f'data-topic="{exercise.topic}" data-version="{version}" '
        f'aria-label="{exercise.title}">{inner}</div>\n'
    )
