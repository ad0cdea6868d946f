r"""The symbols in the TeX of a chapter, where `\dot\varphi_L` is one letter and not five tokens.

A chapter's symbols are those that its formulas and figures declare or use. Each of its letters
means one symbol only.
"""

import ast
import re
from collections.abc import Iterable
from functools import cache
from typing import Any

from courseware.course import course, get_members
from courseware.equations.equation import Equation, free_symbols
from courseware.equations.notebook import MIME, read_cells, read_outputs, shown_equations
from courseware.equations.quantities import NamedSymbol, find_kind
from courseware.equations.text import GREEK
from courseware.errors import CourseError

ACCENT = r"\\(?:dot|ddot|hat|bar|tilde|vec)(?![A-Za-z])\s*"
WORD = r"\\(?:mathrm|text|operatorname|begin|end|mathsf)\s*\{[^{}]*\}"
GROUP = r"\{(?:[^{}]|\{[^{}]*\})*\}"
LETTER = rf"(?:\\(?!pi(?![A-Za-z]))(?:{'|'.join(GREEK)})(?![A-Za-z])|[A-Za-z])"  # π is a number
INDEX = rf"_\s*(?:{GROUP}|{WORD}|\\[A-Za-z]+|[^\s{{}}\\])"
# a letter with its accent, index and primes
ATOM = rf"(?P<letter>(?:{ACCENT}(?:{GROUP}|{LETTER})|{LETTER})(?:\s*{INDEX})?(?:\s*'+)?)"
REST = rf"(?P<rest>{WORD}|\\\\\s*\[\d+pt\]|\\[A-Za-z]+|\\.|.)"
TYPED = re.compile(r"\$\$(.*?)\$\$|(?<![\\$])\$([^$]+?)\$", re.DOTALL)
TOKEN = re.compile(r"\{[^{}]*\}|\\(?:mathrm|operatorname)\s*\{\w+\}|\\[A-Za-z]+|\S")


@cache
def symbols_of(chapter: str) -> dict[str, NamedSymbol]:
    """Return the symbols of a chapter by their patterns in TeX, the longest first."""
    known: dict[str, NamedSymbol] = {}
    for symbol in dict.fromkeys(_find_symbols(chapter)):
        other = known.setdefault(letter_pattern(symbol.latex), symbol)
        if other != symbol:
            raise CourseError(
                f"{symbol.latex} stands for two symbols in the chapter {chapter}: "
                f"{other} ({other.module}) and {symbol} ({symbol.module}); "
                "give one of them another letter"
            )
    return dict(sorted(known.items(), key=lambda item: (-len(item[0]), item[0])))


def _find_symbols(chapter: str) -> list[NamedSymbol]:
    found, equations = list[NamedSymbol](), [equation for equation, _ in shown_equations(chapter)]
    if formulas := course().module(chapter, "formulas"):
        found += get_members(formulas, NamedSymbol)
        equations += get_members(formulas, Equation)
    if figures := course().module(chapter, "figures"):
        found += [s for s in get_members(figures, NamedSymbol) if s.module == figures.__name__]
    for e in equations:
        found += symbols_in((e.left, e.right, e.textbook or 0, e.where))
    return found


def printed_tex(chapter: str) -> list[str]:
    """Return all TeX on a chapter's page: of its text, its equations, the results of its code."""
    found = [equation.latex(computed) for equation, computed in shown_equations(chapter)]
    for cell in read_cells(chapter):
        if cell["cell_type"] == "markdown":
            text = re.sub(r"```.*?```|`[^`\n]*`", "", "".join(cell["source"]), flags=re.DOTALL)
            found += [match[1] or match[2] for match in TYPED.finditer(text)]
        outputs = (data for data in read_outputs(cell) if MIME not in data)
        found += ["".join(data.get("text/latex", "")) for data in outputs]
    return found


def printed_symbols(chapter: str) -> list[NamedSymbol]:
    """Return the symbols in that TeX, the chapter's own first, as declared."""
    pieces = (piece for tex in printed_tex(chapter) for piece in scan_tex(chapter, tex))
    found = {symbol for _, symbol, _ in pieces if symbol}
    return sorted(found, key=lambda s: (s.chapter != chapter, s.module, s.place, s.name))


def assigned_names(chapter: str) -> set[str]:
    """Return the names that the code of a chapter's notebook assigns, and those of parameters."""
    code = ["".join(c["source"]) for c in read_cells(chapter) if c["cell_type"] == "code"]
    visited = [node for text in code for node in ast.walk(ast.parse(text))]
    parameters = {node.arg for node in visited if isinstance(node, ast.arg)}
    names = (node for node in visited if isinstance(node, ast.Name))
    return parameters | {node.id for node in names if isinstance(node.ctx, ast.Store)}


def symbols_in(parts: tuple[Any, ...]) -> list[NamedSymbol]:
    return [s for s in free_symbols(parts) if isinstance(s, NamedSymbol)]


def letter_pattern(latex: str) -> str:
    r"""Return the pattern of a letter, equal for `v_L` and `v_{L}`, `\dot x` and `\dot{x}`."""
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
def _scanner(chapter: str) -> re.Pattern[str]:
    """Return a pattern of a chapter's symbols, of other letters, and of all else, in this order."""
    own = [f"(?P<s{k}>{p}(?!\\s*['_]))" for k, p in enumerate(symbols_of(chapter))]
    return re.compile("|".join([*own, ATOM, REST]), re.DOTALL)


def scan_tex(chapter: str, tex: str) -> Iterable[tuple[str, NamedSymbol | None, bool]]:
    """Yield the pieces of TeX, each with its symbol if any, and whether it is a letter."""
    known = list(symbols_of(chapter).values())
    for match in _scanner(chapter).finditer(tex):
        name = match.lastgroup or ""
        if name in ("rest", "letter"):
            yield match[0], None, name == "letter"
        else:
            yield match[0], known[int(name[1:])], True


def mark_symbols(chapter: str, tex: str) -> str:
    """Put each symbol of TeX into a `\\htmlData` with its key, and its look if any."""
    return "".join(
        rf"{{\htmlData{{{symbol_data(symbol, chapter)}}}{{{text}}}}}" if symbol else text
        for text, symbol, _ in scan_tex(chapter, tex)
    )


def symbol_data(symbol: NamedSymbol, chapter: str) -> str:
    """Return the argument from which KaTeX makes `data-symbol` and `data-look`."""
    kind = find_kind(symbol, chapter)
    return f"symbol={symbol.key}" + (f",look={kind}" if kind else "")


def render_rules() -> str:
    """Return CSS that colours letters as their quantities."""
    return "".join(
        f'html[data-theme] :is(.katex, .highlight, .rk-named, p) [data-look="{kind}"] '
        f"{{ color: color-mix(in srgb, var(--rk-{kind}) 85%, currentcolor); }}\n"
        for kind in course().looks
    )
