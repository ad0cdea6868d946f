"""Exercises and mistakes in a notebook: a box to answer in, and the same check from code."""

import ast
import json
import re
from datetime import UTC, datetime
from functools import cached_property
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from courseware.course import course as opened
from courseware.equations.notebook import Output
from courseware.errors import CourseError
from courseware.practice import judging, rendering, variants
from courseware.practice.bank import all_exercises, find_exercise, find_mistake
from courseware.practice.exercises import Exercise
from courseware.practice.mistakes import Mistake
from courseware.practice.saving import ANSWER_COLUMNS, write_table
from courseware.script.widget import Widget, create_widget
from courseware.units.formatting import render_marked, render_symbols
from courseware.units.line_breaks import prevent_breaks

WIDTH = 42  # of a line of code, for phones
MISTAKE = "application/vnd.courseware.mistake+json"


class _Kept(NamedTuple):
    """The answer to an exercise that counts: the right one, or the last."""

    answer: str
    result: str
    time: str
    student: str
    tries: int
    help: int


_session = {"student": "", "course": ""}  # without a course of one's own: the book's
_answers: dict[tuple[str, str, str], _Kept] = {}  # by course, student (folded), exercise


def student(name: str | int, course: str = "") -> None:
    """Say once, at the top of a notebook, who works here and in which course."""
    _session.update(student=str(name), course=str(course))


class Box:
    """An exercise with somebody's numbers. Shown in a notebook, it is a box to answer in."""

    def __init__(self, exercise: Exercise, student: str, course: str) -> None:
        self.exercise, self.student, self.course = exercise, student, course

    @property
    def variant(self) -> variants.Variant:
        """The numbers that the student has."""
        return variants.find_variant(self.course, self.exercise.name, self.student)

    @property
    def text(self) -> str:
        """The question, with the numbers in it."""
        return self.exercise.fill(self.exercise.text, self.variant.numbers)

    def check(self, answer: Any) -> judging.Verdict:
        """Judge an answer: a number, a list, an array, or text as it would be typed."""
        typed = answer if isinstance(answer, str) else _type_answer(answer)
        verdict = judging.judge(self.exercise, self.variant.candidates, typed)
        if verdict.result != "unread":
            kept = _answers.get(self._key)
            tries, opened = (kept.tries, kept.help) if kept else (0, 0)
            self._keep(typed, verdict.result, tries + 1, opened)
        return verdict

    @property
    def _key(self) -> tuple[str, str, str]:
        return self.course, variants.fold_name(self.student), self.exercise.name

    def _keep(self, answer: str, result: str, tries: int = 0, help: int = 0, **_: Any) -> None:
        """Keep an answer, judged or only typed; a right one is replaced by right ones only."""
        was_right = self._key in _answers and _answers[self._key].result == "right"
        if answer and (result == "right" or not was_right):
            now = datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
            _answers[self._key] = _Kept(answer, result, now, self.student, tries, help)

    @cached_property
    def widget(self) -> Widget:
        """The widget, whose state has the student and the answer that counts."""
        data = {"name": self.exercise.name, "course": self.course}
        data["packed"] = rendering.pack([self.exercise])
        state = {"student": self.student, "answer": "", "result": "", "kept": {}}
        made = create_widget("practice", json.dumps(data), state)
        made.observe(lambda change: self._keep(**change["new"]), "state")
        return made

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        e = self.exercise
        plain = f"{e.title}\n\n{self.text}\n\nAsked: {judging.format_prompt(e)}"
        return self.widget.render_output({"text/plain": plain, rendering.MIME: {"name": e.name}})


def exercise(name: str, student: str | int | None = None, course: str | None = None) -> Box:
    """Show an exercise with the student's numbers; see `student` for the defaults.

    >>> exercise("differential-drive-1", student="Ada").check("1/3 m/s").result
    'unread'
    """
    who = _session["student"] if student is None else str(student)
    where = _session["course"] if course is None else str(course)
    return Box(find_exercise(name), who, where or opened().salt)


def export(path: str | Path = "", force: bool = False) -> Path:
    """Write this session's answers as the table that a teacher grades, a new file each time."""
    if not _answers:
        raise CourseError("there are no answers yet: check an answer of an exercise first")
    if not all(student for _, student, _ in _answers):
        raise CourseError('say who you are first: practice.student("…") picks your numbers')
    rows = [
        ("answers", course, variants.version(), k.time, k.student, name, k.answer, k.tries, k.help)
        for (course, _, name), k in _answers.items()
    ]
    path = path or f"answers-{datetime.now():%Y-%m-%d-%H%M%S}.csv"
    return write_table(path, ANSWER_COLUMNS, rows, force)


def example(name: str) -> Output:
    """Show the question of an exercise in the numbers that its mistakes are shown with."""
    e = find_exercise(name)
    if not e.example:
        raise CourseError(f"{name} has no example")
    question = render_symbols(prevent_breaks(e.fill(e.text, e.example)))
    used = set().union(*(_names_used(m.line) for m in e.wrong if exercise_of(m) is e))
    known = {**e.example, **e.derive(**e.example)}
    code = "\n".join(_assignments({name: known[name] for name in known if name in used}))
    return Output(
        {
            "text/markdown": f"**{e.title}**\n\n{question}\n\nIn code, in SI units:\n\n"
            f"```python\n{code}\n```",
            "text/plain": f"{e.title} ({e.name}, in the numbers of its example)",
        }
    )


def _names_used(code: str) -> set[str]:
    """Return the names that code reads before it assigns them."""
    used, assigned = set[str](), set[str]()
    for statement in ast.parse(code).body:
        names = [node for node in ast.walk(statement) if isinstance(node, ast.Name)]
        used |= {name.id for name in names if isinstance(name.ctx, ast.Load)} - assigned
        assigned |= {name.id for name in names if isinstance(name.ctx, ast.Store)}
    return used


def _assignments(names: dict[str, Any]) -> list[str]:
    """Return lines of code that give names their numbers; short ones share a line."""
    lines: list[str] = []
    for name, value in names.items():
        text = f"{name} = {_code(value)}"
        if lines and "[" not in lines[-1] + text and len(lines[-1]) + len(text) < WIDTH:
            lines[-1] += f"; {text}"
        else:
            lines.append(text)
    return lines


def _code(value: Any) -> str:
    """Return a number, name or array as one would type it, to four decimals."""
    if isinstance(value, str):
        return repr(value)
    rounded = np.round(np.asarray(value, dtype=float), 4)
    if rounded.ndim < 2:
        return f"np.array({rounded.tolist()})" if rounded.ndim else str(rounded.tolist())
    rows = "".join(f"    {row},\n" for row in rounded.tolist())
    return f"np.array([\n{rows}])"


def exercise_of(mistake: Mistake) -> Exercise:
    """Return the exercise in whose example a mistake is shown."""
    return next(e for e in all_exercises().values() if mistake in e.wrong and e.example)


def format_wrong_answer(mistake: Mistake) -> str:
    """Return the wrong value in the numbers of the example."""
    e = exercise_of(mistake)
    return e.format_rows(e.evaluate(e.wrong[mistake], e.example))


def mistake(name: str) -> Output:
    """Show a wrong line to judge, its result, and what is wrong behind a fold."""
    m = find_mistake(name)
    return Output(
        {
            "text/html": f"<pre>{escape(m.line)}</pre>{render_judgement(m)}",
            "text/plain": f"{m.line}\nIt gives {format_wrong_answer(m)}.",
            MISTAKE: {"name": m.name},
        }
    )


def render_judgement(mistake: Mistake) -> str:
    """Render what a mistake gives, and the fold, as HTML."""
    e = exercise_of(mistake)
    lines = zip(mistake.formula.lines, ("Right", "Here"), strict=True)
    formulas = "".join(f"<p>{word}: {render_marked(line)}</p>" for line, word in lines)
    return (
        f"<p>It gives {_render_rows(format_wrong_answer(mistake))}.</p>"
        f"<details><summary>What is wrong?</summary>{formulas}"
        f"<p>Right is {_render_rows(e.format_answer(e.example))}.</p>"
        f"<p>{render_symbols(mistake.why)}</p>"
        f"<p><em>Where nobody notices.</em> {render_symbols(mistake.unnoticed)}</p></details>"
    )


def _render_rows(answer: str) -> str:
    """Render an answer, with a line for each row of a matrix and each of several answers."""
    rows = re.split(r"(?<=\],) |(?<=\];) ", answer)
    return "".join(f"<br>{escape(row)}" for row in rows) if len(rows) > 1 else escape(answer)


def _type_answer(answer: Any) -> str:
    """Return a number, list or array as text; a column counts as a list."""
    array = np.array(answer, dtype=object)  # a list may be ragged
    if array.ndim > 1 and array.shape[-1] == 1:
        array = array[..., 0]
    return str(array.tolist())
