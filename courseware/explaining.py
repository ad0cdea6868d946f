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
SIZE, LEAST = 1e-6, 1e-3  # a tolerance is this part of an answer's size; the least such size
KNOWN = "This is what you get {}."
ONLY_SPECIAL = (
    "On all ordinary inputs it is right: give this case a branch of its own, or find a formula "
    "that needs none."
)
NEAR_SPECIAL = (
    "On all ordinary inputs it is right. Near a special case digits get lost where almost equal "
    "numbers are subtracted, and a branch for the special case may be too wide."
)
LOST = (
    "It is nearly right on all inputs, but about seven digits are asked. Digits get lost by "
    "rounding, in short numbers (float32, 3.14), and by approximation."
)
NO_NUMBER = (
    " nan means: no number. It comes of 0/0, inf/inf, 0·inf or inf − inf (look for a division by "
    "0), of a root of a negative number, and of arccos or arcsin of a number beyond ±1. Rounding "
    "can lead there, and np.clip limits a number."
)
BORDER = "padding: .5rem .9rem; border-left: 4px solid {}"
COLORS = {True: "#2e8b57", False: "#c2344b"}  # of right and of wrong; pages may be dark
SLIPS: dict[str, Callable[[Any, Stored], Any]] = {
    "with the sign the other way round": lambda right, _: -right,
    "with twice the right value": lambda right, _: 2 * right,
    "with half the right value": lambda right, _: right / 2,
    "when the angle is returned in degrees": lambda right, stored: np.where(
        stored["angles"], np.degrees(right), right
    ),
    "with the numbers in the opposite order": lambda right, _: right[::-1],
    "with rows and columns exchanged": lambda right, stored: (
        right.reshape(stored["shape"]).T.ravel() if len(stored["shape"]) == 2 else right
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
        return bool(np.all(apart(answer, other, stored) <= factor * np.array(stored["tolerance"])))
    one, two = (compute_compared_value(each, case, stored) for each in (answer, other))
    size = max(LEAST, np.abs(two).max())
    return bool(np.allclose(one, two, rtol=0, atol=factor * SIZE * size, equal_nan=True))


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
    elif not known and has_lost_digits(answers, stored):
        lines.append(LOST)
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
    """Return what is said of the mistakes whose answers these are, on all ordinary inputs."""
    known = {each["feedback"]: [*map(np.array, each["answers"])] for each in stored["known"]}
    rights = [np.array(case["right"]) for case in ordinary(stored)]
    slips = {
        KNOWN.format(words): [slip(right, stored) for right in rights]
        for words, slip in SLIPS.items()
    }
    found: list[str] = []
    for some in (known, slips):  # a slip of any answer only where no mistake is met
        found = found or [words for words, its in some.items() if is_named(answers, its, stored)]
    return found


def is_named(answers: Sequence[Any], its: Sequence[Any], stored: Stored) -> bool:
    """Return whether answers are a mistake's own, and far from right on enough inputs."""
    cases = ordinary(stored)
    if len(answers) < len(cases):
        return False
    far = [not agrees(each, case, stored, FAR) for each, case in zip(its, cases, strict=True)]
    met = zip(answers, its, cases, strict=False)
    return sum(far) >= TELLING and all(same(a, b, case, stored) for a, b, case in met)


def has_lost_digits(answers: Sequence[Any], stored: Stored) -> bool:
    """Return whether rounding can explain answers: all are near, and not all are integers."""
    cases = ordinary(stored)
    near = (agrees(a, case, stored, NEAR) for a, case in zip(answers, cases, strict=False))
    return len(answers) >= len(cases) and all(near) and bool(np.any(np.mod(answers, 1)))


def format_argument(value: Any) -> str:
    return f"np.array({value})" if isinstance(value, list) else repr(value)


def format_answer(answer: Any, stored: Stored, digits: int) -> str:
    """Return an answer as text."""
    texts = [f"{x + 0.0:.{digits}g}" for x in answer]
    return str(np.reshape(texts, stored["shape"]).tolist()).replace("'", "")


def quote_code(text: str) -> str:
    """Return a text as HTML, what stands in `…` as code."""
    return re.sub("`([^`]+)`", r"<code>\1</code>", escape(text))
