"""What the site does to a chapter's page: its formulas carry the keys of their symbols."""

import re
from functools import cache

from docutils import nodes
from sphinx.application import Sphinx

from courseware.course import course
from courseware.equations.quantities import NamedSymbol, find_kind
from courseware.equations.text import symbol_text
from courseware.symbols import lexicon

# "the x axis", "looks along y": the letter names an axis, not a number
AXIS = re.compile(r"[+-]?[xyz]")
AXIS_BEHIND, AXIS_BEFORE = re.compile(r"\s+(axis|axes|direction)\b"), re.compile(r"\balong\s+$")


def mark_formulas(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Give each formula of a chapter the TeX in which its symbols are marked."""
    chapter = docname.partition("/")[0]
    if chapter not in course().taught:
        return
    for node in doctree.findall(lambda n: isinstance(n, nodes.math | nodes.math_block)):
        if "marked" not in node and not names_an_axis(node):
            node["marked"] = lexicon.mark_symbols(chapter, node.astext())


def names_an_axis(node: nodes.Element) -> bool:
    """Whether an inline formula is the name of an axis."""
    if not AXIS.fullmatch(node.astext()):
        return False
    siblings = node.parent.children
    place = siblings.index(node)
    before = siblings[place - 1].astext() if place else ""
    behind = node.get("after", "") + "".join(n.astext() for n in siblings[place + 1 : place + 2])
    return bool(AXIS_BEHIND.match(behind) or AXIS_BEFORE.search(before))


def symbols_told(page: str) -> dict[str, list[str]]:
    """What a chapter's page says of its symbols, by key."""
    chapter = page.partition("/")[0]
    if chapter not in course().taught:
        return {}
    return {symbol.key: facts(symbol, chapter) for symbol in lexicon.symbols_of(chapter).values()}


@cache
def by_name(chapter: str) -> dict[str, NamedSymbol]:
    """The symbols whose names stand in the code of a chapter's notebook, each name for one only."""
    found: dict[str, list[NamedSymbol]] = {}
    for symbol in lexicon.printed_symbols(chapter):
        found.setdefault(symbol.code, []).append(symbol)
    names = lexicon.assigned_names(chapter)
    return {name: alike[0] for name, alike in found.items() if name in names and len(alike) == 1}


def facts(symbol: NamedSymbol, chapter: str) -> list[str]:
    """What the script knows of a symbol: letter, meaning, unit, look, name in highlighted code.

    What a figure alone knows has a word for a letter, which no reader has seen.
    """
    letter, names = symbol_text(symbol), by_name(chapter)
    shown = "" if letter == symbol.name and re.match("[a-z]{3}", letter) else letter
    code = symbol.code if names.get(symbol.code) == symbol else ""
    return [shown, symbol.meaning, symbol.unit, find_kind(symbol, chapter), code]


def rules() -> str:
    """Letters in the colour of their quantity."""
    return "".join(
        f'html[data-theme] :is(.katex, .highlight, .rk-named) [data-look="{kind}"] '
        f"{{ color: color-mix(in srgb, var(--rk-{kind}) 85%, currentcolor); }}\n"
        for kind in course().looks
    )
