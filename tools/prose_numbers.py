"""Computed numbers in the prose of notebooks.

The text of a cell is plain. Its metadata lists the phrases with computed numbers (in JupyterLab:
the gear at the right, *Cell Metadata*):

    "numbers": {"computed": ["So {100 * v:.1f} cm/s", "about {np.degrees(omega):.0f}°"]}

A phrase must occur in the text once. The expression in braces is evaluated in the chapter's kernel
after the cells above, with the reader's variables and the names of `book/prose.py`, and rounded
once. Minus signs are true ones, except in an exponent of TeX.

Phrases that follow a figure (`courseware/symbols/live_numbers.py`) get its numbers at the start.
"""

import ast
import re
from collections.abc import Mapping
from string import Formatter
from typing import Any

NUMBER = r"[−+-]?\d(?:[\d,]*\d)?(?:\.\d+)?"


class ProseError(Exception):
    """A phrase that is not in the text, or cannot be computed."""


Answers = Mapping[str, Mapping[str, Any]]


def list_fields(cell: Any) -> list[tuple[str, str]]:
    """Return (expression, format) of each computed number of a cell, in order."""
    return [field for phrase in _phrases(cell) for field in _parse_phrase(phrase)[1]]


def kernel_expressions(cell: Any, chapter: str) -> dict[str, str]:
    """Return `user_expressions` for the kernel, one for each field."""
    names = f"{{**__import__('book.prose').prose.get_names({chapter!r}), **globals()}}"
    return {
        str(k): f"format(eval({expression!r}, {names}), {form!r})"
        for k, (expression, form) in enumerate(list_fields(cell))
    }


def fill_numbers(cell: Any, where: str, answers: Answers) -> str:
    """Return the cell's text with its computed numbers. where: notebook and cell, for errors."""
    texts = []
    for k, (expression, _) in enumerate(list_fields(cell)):
        answer = answers[str(k)]
        if answer["status"] != "ok":
            raise ProseError(
                f"{where}: {expression} cannot be computed: {answer['ename']}: {answer['evalue']}"
            )
        texts.append(ast.literal_eval(answer["data"]["text/plain"]))
    source = str(cell.source)
    for phrase in _phrases(cell):
        literals, asked = _parse_phrase(phrase)
        new, pattern = literals[0], re.escape(literals[0])
        for literal in literals[1:]:
            number = texts.pop(0)
            new += (number if new.endswith("^{") else number.replace("-", "−")) + literal
            pattern += NUMBER.join(map(re.escape, re.split(NUMBER, number))) + re.escape(literal)
        if not asked:
            raise ProseError(f"{where}: {phrase!r} has no {{expression}} to compute")
        start, end = _find_phrase(phrase, pattern, source, where).span()
        source = source[:start] + new + source[end:]
    return source


def has_numbers(cell: Any) -> bool:
    """Return whether a cell of prose has computed numbers."""
    return cell.cell_type == "markdown" and bool(_phrases(cell))


def _parse_phrase(phrase: str) -> tuple[list[str], list[tuple[str, str]]]:
    """Return the words around the numbers, and (expression, format) of each number."""
    literals, asked = [""], []
    for literal, expression, form, _ in Formatter().parse(phrase):
        literals[-1] += literal
        if expression is not None:
            asked.append((expression, form or ""))
            literals.append("")
    return literals, asked


def _find_phrase(phrase: str, pattern: str, source: str, where: str) -> re.Match[str]:
    """Find a computed phrase in the text, by its pattern with any numbers."""
    found = list(re.finditer(rf"(?<![\d.]){pattern}", source))
    if len(found) != 1:
        raise ProseError(
            f"{where}: the computed phrase {phrase!r} stands in the text {len(found)} times; "
            "it must stand there once: give it more of the words around it"
        )
    return found[0]


def _phrases(cell: Any) -> list[str]:
    """Return the phrases of a cell, live ones with expressions for the numbers of their figure."""
    numbers = cell.metadata.get("numbers", {})
    live = [
        re.sub(r"{(\w+)}", rf"{{start_text('{figure}', '\1')}}", phrase)
        for figure, phrases in numbers.get("live", {}).items()
        for phrase in phrases
    ]
    return [*numbers.get("computed", []), *live]
