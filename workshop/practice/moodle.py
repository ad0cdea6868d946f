"""The exercises as questions of Moodle, its type "embedded answers", in one XML file.

Each exercise becomes a category with a question for each variant, so that a quiz can draw one at
random. Moodle judges number by number: of a vector, each number has a field of its own.
"""

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from workshop.practice import dealing, judging, tables
from workshop.practice.bank import Ask, Exercise, default_salt
from workshop.practice.teacher import chosen, progress
from workshop.practice.wording import paragraphs, symbols


def write(out: str | Path, only: Sequence[str] = (), force: bool = False) -> list[str]:
    """Write the questions. Gives back the names of the exercises that Moodle cannot judge."""
    tables.free(Path(out), force)
    exercises = chosen(only)
    # with several right answers it would not do to judge the numbers one by one
    fit = [exercise for exercise in exercises if exercise.accept == "one"]
    quiz = Element("quiz")
    for exercise in progress(fit, "exercises"):
        category = SubElement(quiz, "question", type="category")
        _text(
            category, "category", f"$course$/top/{default_salt()}/{exercise.topic}/{exercise.name}"
        )
        for number, variant in enumerate(dealing.variants(exercise.name)):
            quiz.append(_question(exercise, number, variant))
    ElementTree.ElementTree(quiz).write(out, encoding="utf-8", xml_declaration=True)
    return [exercise.name for exercise in exercises if exercise not in fit]


def _question(exercise: Exercise, number: int, variant: dealing.Variant) -> Element:
    question = Element("question", type="cloze")
    _text(question, "name", f"{exercise.name} {number:02}: {exercise.title}")
    fields = [
        f"<p>{symbols(ask.label)}: {field} {ask.unit}</p>"
        for ask, field in zip(exercise.asks, _fields(exercise, variant), strict=True)
    ]
    text = exercise.filled(exercise.text, variant.numbers, variant.shown)
    _text(question, "questiontext", paragraphs(text) + "".join(fields), format="html")
    solution = exercise.filled(exercise.solution_text, variant.numbers, variant.shown)
    _text(question, "generalfeedback", paragraphs(solution), format="html")
    return question


def _text(parent: Element, tag: str, text: str, **attributes: str) -> None:
    SubElement(SubElement(parent, tag, attributes), "text").text = text


def _fields(exercise: Exercise, variant: dealing.Variant) -> Iterator[str]:
    """A field for each number: what is right, and which mistake gives what else."""
    outcomes = judging.outcomes(exercise)
    wrong = [c for c in variant.candidates if outcomes[c.name].result == "wrong"]
    for place, ask in enumerate(exercise.asks):
        right = variant.candidates[0].rows[0][place]
        turns = (0, -2 * math.pi, 2 * math.pi) if ask.circle else (0,)
        answers = [f"={_number(right + turn, ask)}" for turn in turns]
        values = [candidate.rows[0][place] for candidate in wrong]
        for candidate, value in zip(wrong, values, strict=True):
            close = [x for x in (right, *values) if judging.off(ask, value, x) <= 2 * ask.tolerance]
            if len(close) == 1:  # itself: an answer that could mean another is not named
                answers.append(f"{_number(value, ask)}#{outcomes[candidate.name].says}")
        yield "{1:NUMERICAL:" + "~".join(answers) + "}"


def _number(value: float, ask: Ask) -> str:
    return f"{value:.9f}:{ask.tolerance:g}"
