"""Symbols on a page: all places of a symbol light up together, and a note names it.

`lexicon` finds a chapter's symbols in TeX, `page` marks them in its formulas, the script in its
code. Figures mark their own.
"""

from courseware.script.parts import Part, register
from courseware.symbols import lexicon

register(
    Part(
        name="symbols",
        page="courseware/symbols/symbols.js:startSymbols",
        styles=("courseware/symbols/symbols.css",),
        rules=lexicon.render_rules,
    )
)
