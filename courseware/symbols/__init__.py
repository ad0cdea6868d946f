"""One symbol, one thing: the faces of a symbol on a page light up together, and a note names it.

`lexicon` finds a chapter's symbols in TeX, `page` marks them in its formulas, the script in its
code. Figures mark their own.
"""

from courseware.script.runtime import Part, register
from courseware.symbols import page

register(
    Part(
        name="symbols",
        package=__name__,
        scripts=("symbols.js",),
        styles=("symbols.css",),
        called_by="data-symbol",
        rules=page.rules,
    )
)
