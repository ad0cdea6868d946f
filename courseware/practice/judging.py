"""The verdict on an answer: is it right, and if not, which mistake does it look like?

The judge is `judging.js`, on the page as in Python: an answer is the first candidate that it meets
within the tolerance.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from courseware.practice.candidates import Candidate, outcomes
from courseware.practice.exercises import Exercise, Row
from courseware.script import engine


@dataclass(frozen=True)
class Verdict:
    """The judgement of an answer: right, partly, wrong, or unread (it counts for nothing).

    name: of the candidate that it met. read: the answer as it was read.
    """

    result: str
    name: str
    feedback: str
    read: str = ""

    def __repr__(self) -> str:
        return self.feedback


def format_prompt(exercise: Exercise) -> str:
    """Say in words what is asked: "2 numbers: v in m/s, ω in rad/s".

    A unit that all have is shown once, at the end.
    """
    unknowns = exercise.unknowns
    if exercise.shape:
        rows, columns = exercise.shape
        return f"a matrix: {rows} rows of {columns} numbers"
    names = [f"{u.label} in {u.unit}" if u.unit else u.label for u in unknowns]
    if len({u.unit for u in unknowns}) == 1:
        names[:-1] = [u.label for u in unknowns[:-1]]
    decimals = max(u.decimals for u in unknowns)
    kind = "number" if decimals else "whole number"
    count = f"one {kind}" if len(unknowns) == 1 else f"{len(unknowns)} {kind}s"
    prompt = f"{count}: {', '.join(names)}" + ", to four decimals" * (decimals > 3)
    if exercise.accept == "all":
        return f"all answers, in any order, each {prompt}"
    return prompt + " (any of the right answers)" * (exercise.accept == "any")


def serialize_exercise(exercise: Exercise) -> dict[str, Any]:
    """Return what a waiting page and the judge know of an exercise, whatever its numbers."""
    return {
        "name": exercise.name,
        "title": exercise.title,
        "text": exercise.text,
        "prompt": format_prompt(exercise),
        "unknowns": [vars(unknown) for unknown in exercise.unknowns],
        "decimals": max(unknown.decimals for unknown in exercise.unknowns),
        "shape": exercise.shape,
        "accept": exercise.accept,
        "outcomes": {name: vars(outcome) for name, outcome in outcomes(exercise).items()},
    }


def serialize_candidates(
    exercise: Exercise, possible: Sequence[Candidate]
) -> list[tuple[str, list[Row]]]:
    """Return candidates for the judge, rounded to a hundredth of the tolerance to be small.

    The right answers in other units are missing: the judge makes them.
    """
    digits = [2 - math.ceil(math.log10(unknown.tolerance)) for unknown in exercise.unknowns]
    return [
        (c.name, [tuple(map(_round, row, digits)) for row in c.rows])
        for c in possible
        if not c.name.startswith("unit:")
    ]


def _round(number: float, digits: int) -> float:
    return round(number, digits) + 0.0  # no -0


def format_feedback(kind: str, **words: str) -> str:
    """Return a sentence of the page's own judge."""
    return str(find_constant(f"FEEDBACK.{kind}")).format(**words)


@cache
def find_constant(name: str) -> Any:
    """Return a text or number of the page's judge, asked for once: a question takes 0.3 ms."""
    return engine.run(f"courseware.{name}")


def judge(exercise: Exercise, possible: Sequence[Candidate], typed: str) -> Verdict:
    """Judge a typed answer; "unread", with a reason, if it does not answer the exercise."""
    return judge_all(exercise, [possible], [(0, typed)])[0]


def judge_all(
    exercise: Exercise,
    variants: Sequence[Sequence[Candidate]],
    answers: Sequence[tuple[int, str]],
) -> list[Verdict]:
    """Judge many answers in one call, each with the number of its variant."""
    lists = [serialize_candidates(exercise, possible) for possible in variants]
    found = engine.call("courseware.judgeAnswers", serialize_exercise(exercise), lists, answers)
    return [Verdict(**verdict) for verdict in found]
