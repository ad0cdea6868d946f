"""A page that shows a class, as one HTML file: exercises, mistakes, a line for each student.

It needs no server and no script, loads nothing, and holds nothing but the class's results.
"""

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from html import escape
from itertools import groupby
from typing import NamedTuple

from courseware.course import course
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.declaration import Exercise
from courseware.units.formatting import render_symbols

MOST_SHOWN = 25  # mistakes
RESULTS = ("right", "partly", "wrong", "unread", "missing")
SIGNS = dict(zip(RESULTS, "✓≈✗?·", strict=True))


class Graded(NamedTuple):
    """One line of the grades."""

    student: str
    exercise: str
    answer: str
    result: str
    mistake: str
    comment: str
    tries: str
    help: str


class Count(NamedTuple):
    """How many students made a mistake, of those who answered the exercise."""

    exercise: str
    mistake: str
    students: int
    of: int
    comment: str


PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{course}: the class</title>
<meta name="viewport" content="width=device-width"><style>
:root {{ color-scheme: light dark; }}
body {{ font: 1rem/1.5 sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }}
th, td {{ padding-right: .7rem; text-align: left; vertical-align: top; font-weight: normal; }}
.n {{ text-align: right; }} .signs {{ font-family: monospace; white-space: nowrap; }}
.words {{ min-width: 16rem; }} div {{ overflow-x: auto; }}
.right {{ color: #1b7340; }} .wrong {{ color: #a3322e; }}
@media screen and (prefers-color-scheme: dark) {{
  .right {{ color: #74c995; }} .wrong {{ color: #f28b9b; }} }}
@media print {{ body {{ font-size: 8pt; margin: 0; }} tr {{ break-inside: avoid; }} }}
</style></head><body>
<h1>{course}: the class</h1>
<p>{students:,} students, {asked} exercises: {totals}.</p>
<h2>Exercises</h2><div><table><thead><tr><th>exercise{heads}<th>right</thead><tbody>
{exercises}
</tbody></table></div>
<h2>Mistakes</h2><p>The most frequent, {most} at most, as a share of those who answered.</p>
<div><table><thead><tr><th class="n">students<th class="n">of<th><th>exercise<th>mistake</thead>
<tbody>
{mistakes}
</tbody></table></div>
<h2>Students</h2><p>A sign for each exercise, by chapter, in the order of the table above.</p>
<div><table><thead><tr><th>student<th class="n">right<th class="n">answered{topics}</thead><tbody>
{lines}
</tbody></table></div></body></html>
"""


def render(course_name: str, graded: Sequence[Graded]) -> str:
    """Render the page as HTML."""
    students: dict[str, dict[str, Graded]] = {}
    results: dict[str, Counter[str]] = {}
    for each in graded:
        students.setdefault(each.student, {})[each.exercise] = each
        results.setdefault(each.exercise, Counter())[each.result] += 1
    known = [exercise for name, exercise in all_exercises().items() if name in results]
    topics = {t: [e.name for e in group] for t, group in groupby(known, lambda e: e.topic)}
    totals = sum(results.values(), Counter())
    heads = (f'<th class="n"><b class="{r}">{SIGNS[r]}</b> {r}' for r in RESULTS)
    titles = (f"<th>{escape(course().title(topic))}" for topic in topics)
    return PAGE.format(
        course=escape(course_name),
        students=len(students),
        asked=len(results),
        totals=", ".join(f"{totals[result]:,} {result}" for result in RESULTS),
        heads="".join(heads),
        exercises="\n".join(_exercise(e, results[e.name]) for e in known),
        most=MOST_SHOWN,
        mistakes="\n".join(map(_mistake, _count_mistakes(graded)[:MOST_SHOWN])),
        topics="".join(titles),
        lines="\n".join(_student(name, found, topics.values()) for name, found in students.items()),
    )


def _count_mistakes(graded: Iterable[Graded]) -> list[Count]:
    """Count the students who made each mistake in each exercise, the most frequent first."""
    answered, made, comments = Counter[str](), Counter[tuple[str, str]](), {}
    for each in graded:
        answered[each.exercise] += each.result != "missing"
        if each.result in ("wrong", "partly"):
            made[each.exercise, each.mistake] += 1
            comments[each.exercise, each.mistake] = each.comment
    return [
        Count(name, mistake or "none known", count, answered[name], comments[name, mistake])
        for (name, mistake), count in made.most_common()
    ]


def _exercise(exercise: Exercise, count: Counter[str]) -> str:
    cells = "".join(f'<td class="n">{count[result]}' for result in RESULTS)
    bar = f'<td><meter value="{count["right"] / count.total():.3f}"></meter>'
    return f"<tr><th>{exercise.name}: {escape(exercise.title)}{cells}{bar}"


def _mistake(count: Count) -> str:
    words = re.sub("^Not yet(. This is what you get|:) ", "", count.comment)
    known = f"{count.mistake}: " if count.mistake in all_mistakes() else ""
    bar = f'<td><meter value="{count.students / count.of:.3f}"></meter>'
    return (
        f'<tr><td class="n">{count.students}<td class="n">{count.of}{bar}<td>{count.exercise}'
        f'<td class="words">{known}{render_symbols(words)}'
    )


def _student(name: str, found: dict[str, Graded], topics: Iterable[Sequence[str]]) -> str:
    count = Counter(g.result for g in found.values())
    cells = "".join(
        f'<td class="signs">{"".join(_sign(found.get(exercise)) for exercise in names)}'
        for names in topics
    )
    answered = count.total() - count["missing"]
    counts = f'<td class="n">{count["right"]}<td class="n">{answered}'
    return f'<tr class="line"><th>{escape(name)}{counts}{cells}'


def _sign(graded: Graded | None) -> str:
    """Return the sign of a result, with the exercise and the mistake under the mouse."""
    if graded is None:
        return " "
    words = " ".join(filter(None, (f"{graded.exercise}: {graded.result}", graded.mistake)))
    return f'<b class="{graded.result}" title="{escape(words)}">{SIGNS[graded.result]}</b>'
