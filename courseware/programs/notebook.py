"""Programs in a notebook: what is asked, hints and a solution, and the check."""

import json
from dataclasses import replace
from html import escape
from typing import Any

from courseware import judge
from courseware.programs.picture import render_answer
from courseware.programs.program import Program, find_program
from courseware.programs.storing import store
from courseware.units.formatting import render_paragraphs

MIME = "application/vnd.courseware.program+json"


class ProgramBox:
    """A program exercise. Shown in a notebook, it says what is asked."""

    def __init__(self, name: str) -> None:
        self.program = find_program(name)

    def check(self, function: Any) -> judge.Verdict:
        """Judge a function, with the simplest input on which it is wrong."""
        verdict = judge.check(function, store(self.program))
        if verdict.numbers:
            verdict = replace(verdict, picture=render_answer(self.program, verdict.numbers))
        return verdict

    def _repr_mimebundle_(self, **_: Any) -> dict[str, Any]:
        p = self.program
        return {
            "text/plain": f"{p.title}\n\n{p.text}",
            "text/html": render(p),
            MIME: {"name": p.name},
        }


def render(program: Program, solution: bool = True) -> str:
    """Render what is asked, with its hints."""
    return (
        f'<div class="rk-program" id="{program.name}">'
        f"<p><strong>{escape(program.title)}</strong></p>"
        f"{render_paragraphs(program.text)}{render_hints(program, solution)}</div>"
    )


def render_hints(program: Program, solution: bool) -> str:
    """Render the hints; each opens the way to the next, the last one to a solution."""
    code = escape(program.solution.strip())
    fold = f"<details><summary>A solution</summary><pre>{code}</pre></details>" if solution else ""
    for k, hint in reversed([*enumerate(program.hints, 1)]):
        fold = f"<details><summary>Hint {k}</summary>{render_paragraphs(hint)}{fold}</details>"
    return fold


def serialize(program: Program) -> str:
    """Return what the judge knows of a program, as JSON."""
    return json.dumps(store(program), ensure_ascii=False, separators=(",", ":"))
