"""A page for each student of a key, to print or to type into, without answers."""

import json
import re
from collections.abc import Sequence
from functools import cache
from html import escape
from pathlib import Path

from courseware.classroom.answer_key import read_key
from courseware.classroom.tables import Problems, Row
from courseware.practice import judging, variants
from courseware.practice.bank import all_exercises
from courseware.practice.saving import refuse_existing
from courseware.script import engine, parts
from courseware.units.formatting import render_symbols

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{student}: {course}</title>
<meta name="viewport" content="width=device-width"><style>
:root {{ color-scheme: light dark; }}
body {{ font: 11pt/1.5 sans-serif; max-width: 42rem; margin: 2rem auto; padding: 0 1rem; }}
section {{ break-inside: avoid; margin: 1.2rem 0; }} h2 {{ font-size: 1rem; margin: 0; }}
p {{ margin: .2rem 0; }} input {{ font: inherit; width: 100%; box-sizing: border-box; }}
@media screen {{ body:not(.live) :is(.live, input), .live .still {{ display: none; }} }}
@media print {{ .screen {{ display: none; }} label {{ display: block; margin-top: 4cm; }}
  input {{ border: 0; border-bottom: 1px solid; height: 2.4rem; }} }}
</style></head><body data-course="{course}" data-version="{version}" data-student="{student}">
<h1>{student}</h1><p>Course: {course}. The numbers in this sheet were drawn for you. Give four
decimals. Where rad is asked, degrees with their sign are right too: 30°. Whole turns more or less
do not matter in an angle.</p>
<p class="screen still">Here this sheet can be read and printed; to type your answers and save them,
open the file in Chrome or Edge 111, Firefox 121, Safari 16.4 or a newer one.</p>
<p class="screen live">Answers can be 0.5, 1/3, pi/3, 30°, a list: [1, 2], or a matrix: [[1, 2],
[3, 4]]. Nothing is checked: what you type stays in this browser. Save it and hand in the file.</p>
{exercises}<p class="screen live"><button>Save my answers (CSV)</button> <output></output></p>
<script>{script}</script></body></html>
"""


def write_sheets(key: Path, folder: Path, force: bool) -> list[str]:
    """Write a page for each student into a folder, and return the problems of the key."""
    problems = Problems()
    students: dict[str, list[Row]] = {}
    for _, row in read_key(key, problems).rows.values():
        students.setdefault(row["student"], []).append(row)
    folder.mkdir(parents=True, exist_ok=True)
    paths = {student: folder / _file_name(student) for student in students}
    for path in paths.values():
        refuse_existing(path, force)
    for student, rows in students.items():
        paths[student].write_text(_render_sheet(student, rows), encoding="utf-8")
    return problems.lines()


def _file_name(student: str) -> str:
    """Return a name that every file system takes, and no two students share."""
    plain = re.sub(r"\W+", "-", student).strip("-")[:40]
    return f"{plain}-{variants.fnv1a(student):08x}.html"


def _render_sheet(student: str, rows: Sequence[Row]) -> str:
    return PAGE.format(
        student=escape(student),
        course=escape(rows[0]["course"]),
        version=escape(rows[0]["version"]),
        exercises="\n".join(_render_question(row["exercise"], row["numbers"]) for row in rows),
        script=parts.bundle("courseware/classroom/sheet.js"),
    )


@cache
def _render_question(name: str, numbers: str) -> str:
    exercise = all_exercises()[name]
    text = exercise.fill(exercise.text, json.loads(numbers))
    prompt = render_symbols(judging.format_prompt(exercise))
    return (
        f"<section><h2>{name}: {escape(exercise.title)}</h2>"
        f"{engine.call('courseware.renderParagraphs', text)}<p><label>Answer, "
        f'{prompt}: <input name="{name}" autocomplete="off" '
        f'autocapitalize="off" spellcheck="false"></label></p></section>'
    )
