"""Numbers stay on one line with their units in all running text, as in exercises."""

import re

from docutils import nodes

from courseware.units.line_breaks import prevent_breaks

ENDS_IN_NUMBER = re.compile(r"\d\W*$")
AS_TYPED = (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.raw)


def prevent_unit_breaks(app, doctree, docname):
    """Tie units to numbers, also to inline formulas as 10⁻³, by no-break spaces."""
    for node in list(doctree.findall(nodes.Text)):
        if isinstance(node.parent, AS_TYPED):
            continue
        place = node.parent.index(node)
        before = node.parent[place - 1] if place else None
        number = isinstance(before, nodes.math) and ENDS_IN_NUMBER.search(before.astext())
        text = prevent_breaks(f"0{node}")[1:] if number else prevent_breaks(node)
        if text != node:
            node.parent.replace(node, nodes.Text(text))


def setup(app):
    """Register with Sphinx, before the punctuation behind formulas is moved."""
    app.connect("doctree-resolved", prevent_unit_breaks, priority=400)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
