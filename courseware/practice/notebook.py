"""Exercises and mistakes in a notebook: a box to answer in, and the same check from code."""

import ast
import json
import re
from datetime import UTC, datetime
from functools import cached_property
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from courseware.course import course
from courseware.equations.notebook import Output
from courseware.errors import CourseError, describe
from courseware.line_breaks import prevent_breaks
from courseware.practice import dealing, judging, page
from courseware.practice.bank import (
    Exercise,
    Mistake,
    default_salt,
    exercises,
)
from courseware.practice.saving import ANSWERS, write_table
from courseware.practice.wording import highlighted, symbols
from courseware.script.widget import Widget, widget

WIDTH = 42  # of a line of code, for phones
MOST = 100  # numbers in an answer
MISTAKE = "application/vnd.courseware.mistake+json"

_session = {"student": "", "course": ""}  # without a course of one's own: the book's
# course, student (folded), exercise → the answer that counts, its verdict, when, and the name
_answers: dict[tuple[str, str, str], tuple[str, str, str, str]] = {}


def student(name: str | int, course: str = "") -> None:
    """Say once, at the top of a notebook, who works here and in which course."""
    _session.update(student=_name("the name", name), course=_name("the course", course))


def _name(what: str, value: Any) -> str:
    """A name as text; a student number may be a number."""
    if isinstance(value, str) or (isinstance(value, int) and not isinstance(value, bool)):
        return str(value)
    raise CourseError(f"{what} must be text or a number, got {describe(value)}")


class Box:
    """An exercise with somebody's numbers. Shown in a notebook, it is a box to answer in."""

    def __init__(self, exercise: Exercise, name: str, course: str) -> None:
        self.exercise, self.student, self.course = exercise, name, course

    @property
    def variant(self) -> dealing.Variant:
        """The numbers that the student has."""
        number = dealing.dealt(self.course, self.exercise.name, self.student)
        return dealing.variants(self.exercise.name)[number]

    @property
    def text(self) -> str:
        """The question, with the numbers in it."""
        return self._filled(self.exercise.text)

    @property
    def solution(self) -> str:
        """The worked solution, with the same numbers."""
        return self._filled(self.exercise.solution_text)

    def _filled(self, template: str) -> str:
        return self.exercise.filled(template, self.variant.numbers, self.variant.shown)

    def check(self, answer: Any) -> judging.Verdict:
        """The verdict on an answer: a number, a list, an array, or text as it would be typed."""
        if not isinstance(answer, str):
            try:
                answer = _typed(answer)
            except CourseError as error:
                return judging.Verdict("unread", "", f"{error}.")
        verdict = judging.check(self.exercise, self.variant.candidates, answer)
        if verdict.result != "unread":
            self._keep(answer, verdict.result)
        return verdict

    def _keep(self, answer: str, result: str) -> None:
        """Keep an answer; a further try takes nothing away from one that was right."""
        key = self.course, dealing.folded(self.student), self.exercise.name
        if result == "right" or _answers.get(key, ("", "", "", ""))[1] != "right":
            now = datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
            _answers[key] = answer, result, now, self.student

    @cached_property
    def widget(self) -> Widget:
        """What a notebook shows; in its state are the student and the answer that counts."""
        data = {"name": self.exercise.name, "course": self.course}
        data["packed"] = page.packed([self.exercise])
        state = {"student": self.student, "answer": "", "result": ""}
        made = widget("practice", json.dumps(data), state)
        made.observe(lambda change: self._answered(**change["new"]), "state")
        return made

    def _answered(self, answer: str, result: str, **_: str) -> None:
        """The box has judged an answer, or it is typed and not checked."""
        if answer:
            self._keep(answer, result)

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        plain = f"{self.exercise.title}\n\n{self.text}\n\nAsked: {judging.asked(self.exercise)}"
        return self.widget.output({"text/plain": plain, page.MIME: {"name": self.exercise.name}})


def exercise(name: str, student: str | int | None = None, course: str | None = None) -> Box:
    """An exercise of the bank with the student's numbers; see `student` for the defaults.

    >>> exercise("differential-drive-1", student="Ada").check("1/3 m/s").result
    'unread'
    """
    who = _session["student"] if student is None else _name("student", student)
    where = _session["course"] if course is None else _name("course", course)
    return Box(dealing.find(name), who, where or default_salt())


def answers() -> list[tuple[str, str, str, str]]:
    """The answers of this session that count, the right one or the last: course, student, …"""
    return [
        (course, student, exercise, answer)
        for (course, _, exercise), (answer, _, _, student) in _answers.items()
    ]


def export(path: str | Path = "answers.csv", force: bool = False) -> Path:
    """Write the answers given in this session as the table that a teacher's `grade` reads."""
    if not _answers:
        raise CourseError("there are no answers yet: check an answer of an exercise first")
    if not all(student for _, student, _ in _answers):
        raise CourseError('say who you are first: practice.student("…") picks your numbers')
    rows = [
        ("answers", course, dealing.version(), time, student, exercise, answer)
        for (course, _, exercise), (answer, _, time, student) in _answers.items()
    ]
    return write_table(path, ANSWERS, rows, force)


def names_used(code: str) -> set[str]:
    """The names that code takes a value of before it gives them one."""
    used, made = set[str](), set[str]()
    for statement in ast.parse(code).body:
        names = [node for node in ast.walk(statement) if isinstance(node, ast.Name)]
        used |= {name.id for name in names if isinstance(name.ctx, ast.Load)} - made
        made |= {name.id for name in names if isinstance(name.ctx, ast.Store)}
    return used


def assignments(names: dict[str, Any]) -> list[str]:
    """Lines of code that give names their numbers; short ones share a line."""
    lines: list[str] = []
    for name, value in names.items():
        text = f"{name} = {code_text(value)}"
        if lines and "[" not in lines[-1] + text and len(lines[-1]) + len(text) < WIDTH:
            lines[-1] += f"; {text}"
        else:
            lines.append(text)
    return lines


def code_text(value: Any) -> str:
    """A number, name or array as one would type it, to four decimals; a matrix row by row."""
    if isinstance(value, str):
        return repr(value)
    rounded = np.round(np.asarray(value, dtype=float), 4)
    if rounded.ndim < 2:
        return f"np.array({rounded.tolist()})" if rounded.ndim else str(rounded.tolist())
    rows = "".join(f"    {row},\n" for row in rounded.tolist())
    return f"np.array([\n{rows}])"


def example(name: str) -> Output:
    """The question of an exercise in the numbers that its mistakes are shown with."""
    e = dealing.find(name)
    if not e.example:
        raise CourseError(f"{name} has no example")
    texts = {name: given.shown(given.option(e.example[name])) for name, given in e.given.items()}
    question = symbols(prevent_breaks(e.filled(e.text, e.example, texts)))
    used = set().union(*(names_used(m.line) for m in e.wrong if shown_in(m) is e))
    known = {**e.example, **e.derive(**e.example)}
    code = "\n".join(assignments({name: known[name] for name in known if name in used}))
    return Output(
        {
            "text/markdown": f"**{e.title}**\n\n{question}\n\nIn code, in SI units:\n\n"
            f"```python\n{code}\n```",
            "text/plain": f"{e.title} ({e.name}, in the numbers of its example)",
        }
    )


def shown_in(mistake: Mistake) -> Exercise:
    """The exercise in whose example a mistake is shown."""
    return next(e for e in exercises().values() if mistake in e.wrong and e.example)


def in_rows(answer: str) -> str:
    """An answer as HTML, with a line for each row of a matrix and each of several answers."""
    rows = re.split(r"(?<=\],) |(?<=\];) ", answer)
    return "".join(f"<br>{escape(row)}" for row in rows) if len(rows) > 1 else escape(answer)


class MistakeView:
    """A wrong line to judge: what it gives in the exercise's own numbers, the answer folded.

    The heading above it, in the chapter, is its title.
    """

    def __init__(self, mistake: Mistake) -> None:
        self.mistake, self.exercise = mistake, shown_in(mistake)

    @property
    def gives(self) -> str:
        """The wrong value in the numbers of the example."""
        e = self.exercise
        return e.answer_text(e.example, e.wrong[self.mistake])

    @property
    def answer(self) -> str:
        """What stands behind the fold, as HTML."""
        m, right = self.mistake, self.exercise.answer_text(self.exercise.example)
        lines = zip(m.wrong.lines, ("Right", "Here"), strict=True)
        formulas = "".join(f"<p>{word}: {highlighted(line)}</p>" for line, word in lines)
        return (
            f"<p>It gives {in_rows(self.gives)}.</p><details><summary>What is wrong?</summary>"
            f"{formulas}<p>Right is {in_rows(right)}.</p><p>{symbols(m.why)}</p>"
            f"<p><em>Where nobody notices.</em> {symbols(m.unnoticed)}</p></details>"
        )

    def _repr_mimebundle_(self, **_: Any) -> dict[str, Any]:
        return {
            "text/html": f"<pre>{escape(self.mistake.line)}</pre>{self.answer}",
            "text/plain": f"{self.mistake.line}\nIt gives {self.gives}.",
            MISTAKE: {"name": self.mistake.name},
        }


def mistake(name: str) -> MistakeView:
    """A mistake of the bank, as the chapters show it: "find the mistake"."""
    return MistakeView(course().find("exercises", Mistake, name))


def _typed(answer: Any) -> str:
    """A number, list or array as the text that says the same; a column counts as a list."""
    try:
        array = np.asarray(answer)
    except Exception as error:  # whatever a ragged list or a strange object does in there
        raise CourseError(
            f"the answer must be numbers in a regular list, got {describe(answer)}"
        ) from error
    if np.ma.is_masked(answer):
        raise CourseError(
            f"the answer must have all its numbers, some are masked: {describe(answer)}"
        )
    if array.dtype.kind not in "iuf":
        raise CourseError(
            f"the answer must be real numbers, got {array.dtype} in {describe(answer)}"
        )
    if array.size > MOST:
        raise CourseError(f"the answer has {array.size:,} numbers, far more than asked")
    if array.ndim > 1 and array.shape[-1] == 1:
        array = array[..., 0]
    return repr(array.tolist())
