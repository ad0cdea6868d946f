r"""Which symbols the TeX of a chapter is made of: `\dot\varphi_L` is one letter, not five tokens.

A chapter's symbols are those that its formulas and figures declare or use. On a page a letter
stands for one of them only.
"""

import ast
import re
from collections.abc import Iterable
from functools import cache
from typing import Any

from courseware.course import course, held
from courseware.equations.core import Equation, NamedSymbol, free_symbols, look
from courseware.equations.notebook import cells, results, shown_equations
from courseware.equations.rendering import MIME
from courseware.equations.text import GREEK
from courseware.errors import CourseError

ACCENT = r"\\(?:dot|ddot|hat|bar|tilde|vec)(?![A-Za-z])\s*"
WORD = r"\\(?:mathrm|text|operatorname|begin|end|mathsf)\s*\{[^{}]*\}"
GROUP = r"\{(?:[^{}]|\{[^{}]*\})*\}"
LETTER = rf"(?:\\(?!pi(?![A-Za-z]))(?:{'|'.join(GREEK)})(?![A-Za-z])|[A-Za-z])"  # π is a number
INDEX = rf"_\s*(?:{GROUP}|{WORD}|\\[A-Za-z]+|[^\s{{}}\\])"
# a letter with its accent, index and primes; without one, what is no letter
ATOM = rf"(?P<letter>(?:{ACCENT}(?:{GROUP}|{LETTER})|{LETTER})(?:\s*{INDEX})?(?:\s*'+)?)"
REST = rf"(?P<rest>{WORD}|\\\\\s*\[\d+pt\]|\\[A-Za-z]+|\\.|.)"
TYPED = re.compile(r"\$\$(.*?)\$\$|(?<![\\$])\$([^$]+?)\$", re.DOTALL)
TOKEN = re.compile(r"\{[^{}]*\}|\\(?:mathrm|operatorname)\s*\{\w+\}|\\[A-Za-z]+|\S")


@cache
def symbols_of(chapter: str) -> dict[str, NamedSymbol]:
    """The symbols of a chapter by their pattern in TeX, the longest first."""
    found, equations = list[NamedSymbol](), [equation for equation, _ in shown_equations(chapter)]
    if formulas := course().module(chapter, "formulas"):
        found += held(formulas, NamedSymbol)
        equations += held(formulas, Equation)
    if figures := course().module(chapter, "figures"):
        found += [s for s in held(figures, NamedSymbol) if s.module == figures.__name__]
    for e in equations:
        found += in_expressions((e.left, e.right, e.textbook or 0, e.where))
    known: dict[str, NamedSymbol] = {}
    for symbol in dict.fromkeys(found):
        other = known.setdefault(pattern(symbol.latex), symbol)
        if other != symbol:
            raise CourseError(
                f"{symbol.latex} stands for two symbols in the chapter {chapter}: {other} "
                f"({other.place}) and {symbol} ({symbol.place}); give one of them another letter"
            )
    return dict(sorted(known.items(), key=lambda item: (-len(item[0]), item[0])))


def printed(chapter: str) -> list[str]:
    """All TeX that a chapter prints: typed in its text, of its equations, of its code's results."""
    found = [equation.latex(computed) for equation, computed in shown_equations(chapter)]
    for cell in cells(chapter):
        if cell["cell_type"] == "markdown":
            text = re.sub(r"```.*?```|`[^`\n]*`", "", "".join(cell["source"]), flags=re.DOTALL)
            found += [match[1] or match[2] for match in TYPED.finditer(text)]
        for data in results(cell):
            found += [] if MIME in data else ["".join(data.get("text/latex", ""))]
    return found


def printed_symbols(chapter: str) -> list[NamedSymbol]:
    """The symbols in that TeX, the chapter's own first, as declared."""
    pieces = (piece for tex in printed(chapter) for piece in scan(chapter, tex))
    found = {symbol for _, symbol, _ in pieces if symbol}
    return sorted(found, key=lambda s: (s.chapter != chapter, s.module, s.line, s.name))


def names(chapter: str) -> set[str]:
    """The names that the code of a chapter's notebook gives to something."""
    code = ["".join(cell["source"]) for cell in cells(chapter) if cell["cell_type"] == "code"]
    walked = [node for text in code for node in ast.walk(ast.parse(text))]
    arguments = {node.arg for node in walked if isinstance(node, ast.arg)}
    return arguments | {
        node.id for node in walked if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    }


def in_expressions(parts: tuple[Any, ...]) -> list[NamedSymbol]:
    """All declared symbols in expressions."""
    return [s for s in free_symbols(parts) if isinstance(s, NamedSymbol)]


def pattern(latex: str) -> str:
    r"""The regular expression of a letter: `v_L` and `v_{L}`, `\dot x` and `\dot{x}` are alike."""
    parts, after = list[str](), False
    for token in TOKEN.findall(latex):
        inner = TOKEN.findall(token[1:-1]) if token.startswith("{") else [token]
        if len(inner) == 1:
            word = re.sub(r"\\ ?\{", r"\\s*\\{", re.escape(inner[0]))
            part = word + (r"(?![A-Za-z])" if re.fullmatch(r"\\[A-Za-z]+", inner[0]) else "")
            part = rf"(?:\{{\s*{part}\s*\}}|{part})" if after else part
        else:
            part = r"\{\s*" + r"\s*".join(map(re.escape, inner)) + r"\s*\}"
        parts.append(part)
        after = token in ("_", "^") or bool(re.fullmatch(ACCENT, token))
    return r"\s*".join(parts)


@cache
def scanner(chapter: str) -> re.Pattern[str]:
    """Finds in TeX the chapter's symbols first, then other letters, then all else."""
    own = "|".join(f"(?P<s{k}>{p}(?!\\s*['_]))" for k, p in enumerate(symbols_of(chapter)))
    return re.compile(f"{own}|{ATOM}|{REST}" if own else f"{ATOM}|{REST}", re.DOTALL)


def scan(chapter: str, tex: str) -> Iterable[tuple[str, NamedSymbol | None, bool]]:
    """The pieces of TeX: each with its symbol, and whether it is a letter at all."""
    known = list(symbols_of(chapter).values())
    for match in scanner(chapter).finditer(tex):
        name = match.lastgroup or ""
        if name == "rest" or name == "letter":
            yield match[0], None, name == "letter"
        else:
            yield match[0], known[int(name[1:])], True


def marked(chapter: str, tex: str) -> str:
    """The TeX with each symbol in a `\\htmlData` that carries its key, and its look if any."""
    return "".join(
        rf"{{\htmlData{{{face(symbol, chapter)}}}{{{text}}}}}"
        if symbol
        else text  # an ordinary atom
        for text, symbol, _ in scan(chapter, tex)
    )


def face(symbol: NamedSymbol, chapter: str) -> str:
    """What KaTeX makes `data-symbol` and `data-look` of."""
    kind = look(symbol, chapter)
    return f"symbol={symbol.key}" + (f",look={kind}" if kind else "")


def unknown(chapter: str, tex: str) -> list[str]:
    """The letters that the chapter does not declare."""
    return [text for text, symbol, letter in scan(chapter, tex) if letter and not symbol]
