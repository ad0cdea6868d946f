"""A number and its unit stay on one line: the blank between them is one that does not break."""

import re

from docutils import nodes

UNIT = r"(?:(?:[cmk]?m|m?s|rad|kg|kB|N|Hz|%|ticks)(?:/s²?|/m|²)?)(?![\w/])"
BETWEEN = re.compile(rf"(?<=[\d°]) (?={UNIT})")
BEHIND_FORMULA = re.compile(rf"^ (?={UNIT})")
ENDS_IN_NUMBER = re.compile(r"\d\W*$")
AS_TYPED = (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.raw)


def kept(text):
    """The text, its numbers tied to their units."""
    return BETWEEN.sub("\N{NO-BREAK SPACE}", text)


def keep_units(app, doctree, docname):
    """Tie the numbers of all running text, and of inline formulas such as 10⁻³, to their units."""
    for node in list(doctree.findall(nodes.Text)):
        if isinstance(node.parent, AS_TYPED):
            continue
        text = kept(node)
        place = node.parent.index(node)
        before = node.parent[place - 1] if place else None
        if isinstance(before, nodes.math) and ENDS_IN_NUMBER.search(before.astext()):
            text = BEHIND_FORMULA.sub("\N{NO-BREAK SPACE}", text)
        if text != node:
            node.parent.replace(node, nodes.Text(text))


def setup(app):
    """Called by Sphinx; before the punctuation behind formulas is moved."""
    app.connect("doctree-resolved", keep_units, priority=400)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
