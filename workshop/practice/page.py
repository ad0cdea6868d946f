"""An exercise for the browser: its data, packed, and its box as HTML.

The data are JSON, compressed (zlib) and in base64: small, and not readable at a glance. A student
who unpacks them finds the answers, so the boxes are for checking oneself.
"""

import base64
import json
import math
import zlib
from collections.abc import Iterable
from typing import Any

from workshop.practice import dealing, judging
from workshop.practice.bank import Exercise, exercises

MIME = "application/vnd.workshop.exercise+json"
LEVELS = {1: "one step", 2: "several steps", 3: "hard"}
NOTE = (
    "For checking yourself. Your name picks your numbers; it and your answers stay in this "
    "browser, nothing is sent. Give three decimals. Answers can be 0.5, 1/3, pi/3, sqrt(3)/2, "
    "30°, or a list: [1, 2]."
)
NAMELESS = "Type your name first: it picks your numbers."
TRAINING = "Numbers for training: they are not yours and do not count."


def constants() -> dict[str, Any]:
    """What the script of the page shares with Python, by name."""
    from workshop.practice.reading import PROBLEMS

    return {
        "VARIANTS": dealing.VARIANTS,
        "NEAR": judging.NEAR,
        "SAYS": judging.SAYS,
        "PROBLEMS": PROBLEMS,
        "LEVELS": LEVELS,
        "NOTE": NOTE,
        "NAMELESS": NAMELESS,
        "TRAINING": TRAINING,
    }


def contents(exercise: Exercise, solutions: bool = True) -> dict[str, Any]:
    """All that the browser knows of an exercise."""
    solution = exercise.solution_text if solutions else ""
    return {
        **question(exercise),
        "solution": solution,
        "shape": list(exercise.shape),
        "accept": exercise.accept,
        "asks": [
            {"label": a.label, "circle": a.circle, "tolerance": a.tolerance} for a in exercise.asks
        ],
        "outcomes": {
            name: {"result": o.result, "says": o.says, "factors": o.factors}
            for name, o in judging.outcomes(exercise).items()
        },
        "variants": [
            {
                "shown": shown(exercise, variant, exercise.text + solution),
                "candidates": [
                    (c.name, _rounded(exercise, c.rows))
                    for c in variant.candidates
                    if not c.name.startswith("unit:")  # the browser makes them from the right ones
                ],
            }
            for variant in dealing.variants(exercise.name)
        ],
    }


def question(exercise: Exercise) -> dict[str, Any]:
    """The part of an exercise that the waiting page shows."""
    return {
        "name": exercise.name,
        "title": exercise.title,
        "level": exercise.level,
        "text": exercise.text,
        "asked": judging.asked(exercise),
    }


def shown(exercise: Exercise, variant: dealing.Variant, template: str) -> dict[str, str]:
    """What stands for each placeholder of a text."""
    return exercise.placeholders(template, variant.numbers, variant.shown)


def packed(chosen: Iterable[Exercise], solutions: bool = True) -> str:
    """Exercises as the browser unpacks them."""
    data = {exercise.name: contents(exercise, solutions) for exercise in chosen}
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode("utf-8"), 9)).decode()


def script(topic: str, solutions: bool = True) -> str:
    """The file that a page loads when one of a topic's exercises is first used."""
    chosen = [exercise for exercise in exercises().values() if exercise.topic == topic]
    data = packed(chosen, solutions)
    return f'(window.robokinPractice ??= {{}})["{topic}"] = "{data}";\n'


def box(name: str, course: str, solutions: bool = True) -> str:
    """The HTML of an exercise with the numbers of somebody without a name."""
    from workshop.script import engine

    exercise = dealing.find(name)
    variant = dealing.variants(name)[dealing.dealt(course, name, "")]
    arguments = (question(exercise), shown(exercise, variant, exercise.text), solutions)
    inner = engine.run(f"robokin.exerciseHtml({', '.join(map(json.dumps, arguments))})")
    return (
        f'<div class="rk-exercise" role="group" id="{name}" data-exercise="{name}" '
        f'data-topic="{exercise.topic}" data-version="{dealing.version()}" '
        f'aria-label="{exercise.title}">{inner}</div>\n'
    )


def _rounded(exercise: Exercise, rows: tuple[judging.Row, ...]) -> list[list[float]]:
    """Answers to a hundredth of their tolerance: the rest is weight."""
    digits = [2 - math.floor(math.log10(ask.tolerance)) for ask in exercise.asks]
    return [[round(x, d) + 0.0 for x, d in zip(row, digits, strict=True)] for row in rows]
