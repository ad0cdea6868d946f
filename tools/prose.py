"""Numbers in the prose of notebooks: computed where they stand, or marked as typed for a reason.

The text of a cell is plain. What its numbers are stands in the cell's metadata (in JupyterLab: the
gear at the right, *Cell Metadata*):

    "numbers": {
      "computed": ["So {100 * v:.1f} cm/s", "about {np.degrees(omega):.0f}°"],
      "given": {"a setting to try": ["b at 0.2 m"]}
    }

A computed phrase must stand in the text once; the number in the braces' place is computed in the
chapter's kernel after the cells above, with the reader's variables and what `book/prose.py` holds,
and rounded once. Minus signs are true ones, except in an exponent of TeX. A given phrase stands
there as it is.
"""

import ast
import re
from collections.abc import Iterator, Mapping
from math import isclose
from string import Formatter
from typing import Any

NUMBER = r"[−+-]?\d(?:[\d,]*\d)?(?:\.\d+)?"
UNIT = r"°|\s?%|\s?(?:[cmk]?m|rad|s|N|kB|MB)(?:/s)?(?:²|³)?\b|\s(?:degree|metre|second)s?\b"
# several numbers may share one unit: 7.5, 3.7 and 1.9 cm
SHARED = r"(?:, | and | or | to |, then )"
POWER = re.compile(r"(?:\d\s?\\cdot\s?)?10\^\{-?\d+\}")
WORDS_OF_CODE = re.compile(r"`+[^`]*`+|\]\([^)]*\)|<[^>]*>|https?://\S+")
FORMULA = re.compile(r"\$\$.*?\$\$", re.DOTALL)
RIGHT_ANGLES = {"0", "90", "180", "270", "360"}


class ProseError(Exception):
    """A phrase that does not stand in the text, or cannot be computed."""


# Computed phrases.

Answers = Mapping[str, Mapping[str, Any]]


def fields(cell: Any) -> list[tuple[str, str]]:
    """What a cell's computed phrases ask for: (expression, format), in order."""
    return [field for phrase in _marks(cell, "computed") for field in _parsed(phrase)[1]]


def questions(cell: Any, chapter: str) -> dict[str, str]:
    """`user_expressions` for the kernel that answer `fields`."""
    names = f"{{**__import__('book.prose').prose.names({chapter!r}), **globals()}}"
    return {
        str(k): f"format(eval({expression!r}, {names}), {form!r})"
        for k, (expression, form) in enumerate(fields(cell))
    }


def filled(cell: Any, where: str, answers: Answers) -> str:
    """The cell's text with its computed numbers put in. where: notebook and cell, for errors."""
    texts = []
    for k, (expression, _) in enumerate(fields(cell)):
        answer = answers[str(k)]
        if answer["status"] != "ok":
            raise ProseError(
                f"{where}: {expression} cannot be computed: {answer['ename']}: {answer['evalue']}"
            )
        texts.append(ast.literal_eval(answer["data"]["text/plain"]))
    source = str(cell.source)
    for phrase in _marks(cell, "computed"):
        literals, asked = _parsed(phrase)
        new = literals[0]
        for literal in literals[1:]:
            number = texts.pop(0)
            new += (number if new.endswith("^{") else number.replace("-", "−")) + literal
        if not asked:
            raise ProseError(f"{where}: {phrase!r} has no {{expression}} to compute")
        start, end = _place(phrase, source, where).span()
        source = source[:start] + new + source[end:]
    return source


def asks(cell: Any) -> bool:
    """Whether a cell of prose has computed numbers."""
    return cell.cell_type == "markdown" and bool(_marks(cell, "computed"))


def _parsed(phrase: str) -> tuple[list[str], list[tuple[str, str]]]:
    """The words around the numbers (one more than numbers), and (expression, format) of each."""
    literals, asked = [""], []
    for literal, expression, form, _ in Formatter().parse(phrase):
        literals[-1] += literal
        if expression is not None:
            asked.append((expression, form or ""))
            literals.append("")
    return literals, asked


def _place(phrase: str, source: str, where: str) -> re.Match[str]:
    """Where a computed phrase stands, whatever its numbers; each number is a group."""
    pattern = f"({NUMBER})".join(map(re.escape, _parsed(phrase)[0]))
    found = list(re.finditer(rf"(?<![\d.]){pattern}", source))
    if len(found) != 1:
        raise ProseError(
            f"{where}: the computed phrase {phrase!r} stands in the text {len(found)} times; "
            "it must stand there once: give it more of the words around it"
        )
    return found[0]


def _marks(cell: Any, kind: str) -> Any:
    return cell.metadata.get("numbers", {}).get(kind, [])


# Typed numbers.


def typed(notebook: Any, name: str) -> Iterator[str]:
    """Numbers with a decimal point or a unit that nothing accounts for, each with its place.

    Accounted for is what is computed or given, a multiple of a right angle, and a number that the
    code sets: in an assignment or a loop of the cells above, or of the next cell. A code cell's
    prose is the text alternative of its picture.
    """
    code = [k for k, cell in enumerate(notebook.cells) if cell.cell_type == "code"]
    for k, cell in enumerate(notebook.cells):
        said = cell.source if cell.cell_type == "markdown" else alternative(cell)
        near = [j for j in code if j <= k] + [j for j in code if j > k][:1]
        values = {v for j in near for v in set_in(notebook.cells[j].source)}
        where = f"{name}, cell {k}"
        spans = list(_accounted(cell, where))
        for start, end, text, unit in numbers(said):
            # a computed exponent lies within its power of ten
            if any((a <= start and end <= b) or (start <= a and b <= end) for a, b in spans):
                continue
            if _known(text, unit, values):
                continue
            around = said[max(0, start - 25) : end + 15].replace("\n", " ")
            yield f"{where}: {text}{unit} in “{around}”"


def alternative(cell: Any) -> str:
    """The text alternative of a code cell's picture, if it has one."""
    return str(cell.metadata.get("mystnb", {}).get("image", {}).get("alt", ""))


def numbers(source: str) -> Iterator[tuple[int, int, str, str]]:
    """Numbers with a decimal point, a unit or a power of ten: (start, end, number, unit)."""
    bare = WORDS_OF_CODE.sub(lambda match: "\0" * len(match[0]), source)
    for match in POWER.finditer(bare):
        yield *match.span(), match[0], ""
    bare = re.sub(
        r"\\begin\{.*?\\end\{\w+\}|\$\$.*?\$\$", lambda m: "\0" * len(m[0]), bare, flags=re.S
    )
    for match in re.finditer(rf"(?<![\w.^{{\\,]){NUMBER}(?![\d}}])", bare):
        unit = _unit_after(bare[match.end() :])
        if unit or "." in match[0]:
            yield *match.span(), match[0], unit


def _unit_after(rest: str) -> str:
    """The unit of the number before, also where numbers of a list share one."""
    found = re.match(rf"(?:{SHARED}{NUMBER})*({UNIT})", rest)
    return found[1].strip() if found else ""


def set_in(code: str) -> set[float]:
    """The numbers that code sets, in assignments and in what loops run over: no index, no
    argument of a function but NumPy's."""
    found = set()
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Assign):
            found |= set(_constants(node.value))
        elif isinstance(node, ast.For | ast.comprehension):
            found |= set(_constants(node.iter))
    return found


def _constants(node: ast.AST) -> Iterator[float]:
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        yield float(node.value)
    elif isinstance(node, ast.Subscript):
        yield from _constants(node.value)
    elif not isinstance(node, ast.Call) or ast.unparse(node.func).startswith("np."):
        for part in ast.iter_child_nodes(node):
            yield from _constants(part)


def _known(text: str, unit: str, values: set[float]) -> bool:
    size = text.lstrip("−+-").replace(",", "")
    if unit == "°" and size in RIGHT_ANGLES:
        return True
    if power := re.fullmatch(r"(?:(\d)\\cdot)?10\^\{(-?\d+)\}", size):
        size = f"{power[1] or 1}e{power[2]}"
    scale = {"cm": 0.01, "mm": 0.001, "%": 0.01}.get(re.split(r"[/²³]", unit)[0], 1.0)
    return any(isclose(float(size) * s, v) for s in {scale, 1.0} for v in values)


def _accounted(cell: Any, where: str) -> Iterator[tuple[int, int]]:
    for phrase in _marks(cell, "computed"):
        match = _place(phrase, cell.source, where)
        yield from (match.span(k) for k in range(1, match.re.groups + 1))
    for reason, phrases in dict(_marks(cell, "given")).items():
        if not reason.strip():
            raise ProseError(f"{where}: {phrases} are given without a reason")
        for phrase in phrases:
            if phrase not in cell.source:
                raise ProseError(f"{where}: the given phrase {phrase!r} is not in the text")
            yield from (m.span() for m in re.finditer(re.escape(phrase), cell.source))
