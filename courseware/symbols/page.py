"""Symbols on a chapter's page: formulas marked with keys, facts for the script."""

import re
from functools import cache

from docutils import nodes
from sphinx.application import Sphinx

from courseware.course import course
from courseware.equations.quantities import NamedSymbol, find_kind
from courseware.equations.text import format_symbol
from courseware.symbols import lexicon

# "the x axis", "looks along y": the letter names an axis, not a number
AXIS = re.compile(r"[+-]?[xyz]")
AXIS_BEHIND, AXIS_BEFORE = re.compile(r"\s+(axis|axes|direction)\b"), re.compile(r"\balong\s+$")


def mark_formulas(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Add TeX with marked symbols to each formula of a chapter."""
    chapter = docname.partition("/")[0]
    if chapter not in course().taught:
        return
    for node in doctree.findall(lambda n: isinstance(n, nodes.math | nodes.math_block)):
        if "marked" not in node and not is_axis_name(node):
            node["marked"] = lexicon.mark_symbols(chapter, node.astext())


def is_axis_name(node: nodes.Element) -> bool:
    """Return whether an inline formula is the name of an axis."""
    if not AXIS.fullmatch(node.astext()):
        return False
    siblings = node.parent.children
    place = siblings.index(node)
    before = siblings[place - 1].astext() if place else ""
    behind = node.get("after", "") + "".join(n.astext() for n in siblings[place + 1 : place + 2])
    return bool(AXIS_BEHIND.match(behind) or AXIS_BEFORE.search(before))


def symbol_facts(page: str) -> dict[str, list[str]]:
    """Return the facts of a chapter's symbols by key, {} for another page."""
    chapter = page.partition("/")[0]
    if chapter not in course().taught:
        return {}
    return {s.key: describe_symbol(s, chapter) for s in lexicon.symbols_of(chapter).values()}


@cache
def symbols_by_code(chapter: str) -> dict[str, NamedSymbol]:
    """Return symbols by their names in the code of a chapter's notebook, if that is unique."""
    found: dict[str, list[NamedSymbol]] = {}
    for symbol in lexicon.printed_symbols(chapter):
        found.setdefault(symbol.code, []).append(symbol)
    names = lexicon.assigned_names(chapter)
    return {name: alike[0] for name, alike in found.items() if name in names and len(alike) == 1}


def describe_symbol(symbol: NamedSymbol, chapter: str) -> list[str]:
    """Return letter, meaning, unit, kind of look, and name in highlighted code.

    A symbol of a figure alone has a word for a letter, which no reader has seen.
    """
    letter, names = format_symbol(symbol), symbols_by_code(chapter)
    printed = "" if letter == symbol.name and re.match("[a-z]{3}", letter) else letter
    code = symbol.code if names.get(symbol.code) == symbol else ""
    return [printed, symbol.meaning, symbol.unit, find_kind(symbol, chapter), code]
