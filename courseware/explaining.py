"""What is wrong with the answers of a student's function, in words for the student.

It needs nothing but NumPy, and goes to graders beside `judge.py`. Answers are flat arrays of
numbers, one for each input that is stored, the ordinary inputs first.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from html import escape
from types import CodeType
from typing import Any

import numpy as np

Stored = Mapping[str, Any]
TELLING = 20  # inputs on which a mistake must be far from right, before it is named
FAR = 10  # tolerances
NEAR = 1000  # tolerances: digits are missing, the formula is right
MANY = 0.9  # of the ordinary inputs
SIZE, LEAST = 3e-6, 1e-3  # a tolerance is this part of an answer's size; the least such size
KNOWN = "This is what you get {}."
ONLY_SPECIAL = (
    "On all ordinary inputs it is right: give this case a branch of its own, or find a formula "
    "that needs none; or does a branch take it in that should not?"
)
NEAR_SPECIAL = (
    "On all ordinary inputs it is right. Near a special case digits get lost where almost equal "
    "numbers are subtracted, and a branch for the special case may be too wide."
)
LOST = (
    "It is nearly right on all inputs, but about six digits are asked. Digits get lost by "
    "rounding, in short numbers (float32, 3.14), by approximation, and in a branch for small "
    "numbers that is too wide."
)
NO_NUMBER = (
    " nan means: no number. It comes of 0/0, inf/inf, 0·inf or inf − inf (look for a division by "
    "0), of a root of a negative number, and of arccos or arcsin of a number beyond ±1. Rounding "
    "can lead there, and np.clip limits a number."
)
BORDER = "padding: .5rem .9rem; border-left: 4px solid {}"
COLORS = {True: "#2e8b57", False: "#c2344b"}  # of right and of wrong; pages may be dark
# slips of any answer: how each is undone
SLIPS: dict[str, Callable[[Any, Stored], Any]] = {
    "with the sign the other way round": lambda answer, _: -answer,
    "with twice the right value": lambda answer, _: answer / 2,
    "with half the right value": lambda answer, _: 2 * answer,
    "when angles are returned in degrees": lambda answer, stored: np.where(
        stored["angles"], np.radians(answer), answer
    ),
    "with the numbers in the opposite order": lambda answer, _: answer[::-1],
    "with rows and columns exchanged": lambda answer, stored: (
        answer.reshape(stored["shape"]).T.ravel() if len(stored["shape"]) == 2 else answer
    ),
}


@dataclass(frozen=True)
class Verdict:
    """The judgement of a program. Its text is for the student.

    lines: of the text; those that begin with a blank are code. numbers: of the picture that shows
    what is wrong: the right answer, the student's answer, the input; none where one is no number.
    picture: of these, as HTML, where there is something that draws.
    """

    right: bool
    lines: tuple[str, ...]
    numbers: tuple[float, ...] = ()
    picture: str = ""

    def __str__(self) -> str:
        return "\n".join(self.lines)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        parts = (
            f"<pre>{escape(line.strip())}</pre>" if line[0] == " " else f"<p>{quote_code(line)}</p>"
            for line in self.lines
        )
        kind, style = "right" if self.right else "wrong", BORDER.format(COLORS[self.right])
        head = f'<div class="rk-judged rk-{kind}" role="status" style="{style}">'
        return f"{head}{''.join(parts)}</div>{self.picture}"


# --- comparing -------------------------------------------------------------------------------


def agrees(answer: Any, case: Stored, stored: Stored, factor: float = 1.0) -> bool:
    """Return whether an answer is right, within a number of tolerances."""
    return same(answer, np.array(case["right"]), case, stored, factor)


def same(answer: Any, other: Any, case: Stored, stored: Stored, factor: float = 1.0) -> bool:
    """Return whether two answers to an input are the same, within a number of tolerances.

    Where several answers are right, what they do is compared.
    """
    if not stored["compared_value"]:
        allowed = np.maximum(stored["tolerance"], SIZE * abs(other))
        return bool((apart(answer, other, stored) <= factor * allowed).all())
    one, two = (compute_compared_value(each, case, stored) for each in (answer, other))
    near = abs(one - two) <= factor * SIZE * max(LEAST, abs(two).max())
    return bool((near | (np.isnan(one) & np.isnan(two))).all())


def apart(answer: Any, right: Any, stored: Stored) -> Any:
    """Return how far two answers are apart, number by number; NaN meets NaN."""
    difference = answer - right
    turned = np.remainder(difference + np.pi, 2 * np.pi) - np.pi
    size = np.abs(np.where(stored["circle"], turned, difference))
    alike = (answer == right) | (np.isnan(answer) & np.isnan(right))
    return np.where(alike, 0.0, np.nan_to_num(size, nan=np.inf))


def compute_compared_value(answer: Any, case: Stored, stored: Stored) -> Any:
    """Return what an answer does, by the formulas that are stored for it."""
    names = {"numpy": np, "given": join_numbers(answer, *case["arguments"])}
    return np.array(eval(read_formulas(stored["compared_value"]), names))


def join_numbers(*parts: Any) -> Any:
    """Return all numbers of these numbers and arrays in a row."""
    return np.hstack([np.ravel(part) for part in parts])


@cache
def read_formulas(text: str) -> CodeType:
    return compile(text, "<formulas>", "eval")


# --- what is wrong ---------------------------------------------------------------------------


def describe_input(case: Stored, stored: Stored) -> tuple[str, str]:
    """Say which input it is, and how the function is called with it."""
    special = f" ({'near: ' * case['near']}{case['special']})" if case["special"] else ""
    shown = ", ".join(format_argument(x) for x in case["arguments"])
    first = f"Not yet. This is the simplest input on which it is wrong{special}:"
    return first, f" {stored['function']}({shown})"


def explain(answers: Sequence[Any], place: int, stored: Stored, hints: Sequence[str]) -> list[str]:
    """Return the lines about a wrong answer: by how much, and why. hints: about the code."""
    case, answer = stored["cases"][place], answers[place]
    is_near = agrees(answer, case, stored, NEAR)
    digits = 13 if is_near else 7
    right = turn_towards(answer, np.array(case["right"]), stored)
    example = ", for example," if stored["compared_value"] else ""
    nan = NO_NUMBER if np.isnan(answer).any() and not np.isnan(right).any() else ""
    lines = [
        f"It gives {format_answer(answer, stored, digits)}.{nan}",
        f"Right is{example} {format_answer(right, stored, digits)}."
        + describe_rows(answer, right, stored),
    ]
    known = find_known(answers, stored)
    lines += known or hints
    if case["special"]:  # the ordinary inputs come first: on them it is right
        lines.append(NEAR_SPECIAL if is_near or case["near"] else ONLY_SPECIAL)
    elif not known:
        lines += describe_pattern(answers, stored)
    return lines


def turn_towards(answer: Any, right: Any, stored: Stored) -> Any:
    """Return the right answer, its angles on the same turn as those of an answer."""
    turns = np.nan_to_num(np.rint((answer - right) / (2 * np.pi)), posinf=0, neginf=0)
    return right + np.where(stored["circle"], 2 * np.pi * turns, 0)


def describe_rows(answer: Any, right: Any, stored: Stored) -> str:
    """Say which rows of a matrix are wrong, unless all are, or another answer could be right."""
    if len(stored["shape"]) < 2 or stored["compared_value"]:
        return ""
    far = apart(answer, right, stored) > stored["tolerance"]
    wrong = np.flatnonzero(far.reshape(stored["shape"]).any(axis=1))
    if len(wrong) == stored["shape"][0]:
        return ""
    return f" Wrong: row{'s' * (len(wrong) > 1)} {', '.join(map(str, wrong))}, counted from 0."


def ordinary(stored: Stored) -> list[Stored]:
    return [case for case in stored["cases"] if not case["special"]]


def find_known(answers: Sequence[Any], stored: Stored) -> list[str]:
    """Return what is said of the mistakes whose answers these are, on all ordinary inputs.

    They must be far from right on enough inputs; a slip is named only where no mistake is met.
    """
    cases = ordinary(stored)
    met = [*zip(answers, cases, strict=False)]
    far = sum(not agrees(answer, case, stored, FAR) for answer, case in met)
    if len(met) < len(cases) or far < TELLING:
        return []
    found = [
        known["feedback"]
        for known in stored["known"]
        if all(
            same(answer, np.array(its), case, stored)
            for (answer, case), its in zip(met, known["answers"], strict=True)
        )
    ]
    return [*dict.fromkeys(found)] or [
        KNOWN.format(words)
        for words, undo in SLIPS.items()
        if all(agrees(undo(answer, stored), case, stored) for answer, case in met)
    ]


def describe_pattern(answers: Sequence[Any], stored: Stored) -> list[str]:
    """Say what may be wrong where answers are wrong by a little, or on few inputs."""
    met = [*zip(answers, ordinary(stored), strict=False)]
    if len(met) < len(ordinary(stored)):
        return []
    near = all(agrees(answer, case, stored, NEAR) for answer, case in met)
    if near and np.mod(answers, 1).any():  # integers are not rounded
        return [LOST]
    right = sum(agrees(answer, case, stored) for answer, case in met)
    if right < MANY * len(met):
        return []
    words = f"On {right} of {len(met)} ordinary inputs it is right"
    return [f"{words}: is a branch (`if`) missing, or too wide?"]


def format_argument(value: Any) -> str:
    return f"np.array({value})" if isinstance(value, list) else repr(value)


def format_answer(answer: Any, stored: Stored, digits: int) -> str:
    """Return an answer as text."""
    texts = [f"{x + 0.0:.{digits}g}" for x in answer]
    return str(np.reshape(texts, stored["shape"]).tolist()).replace("'", "")


def quote_code(text: str) -> str:
    """Return a text as HTML, with the parts in `…` as code."""
    return re.sub("`([^`]+)`", r"<code>\1</code>", escape(text))
