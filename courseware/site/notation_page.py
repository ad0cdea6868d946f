"""The page of notation: a table of the symbols that a chapter prints."""

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.equations.quantities import NamedSymbol
from courseware.symbols import lexicon
from courseware.units.formatting import render_symbols


class Notation(SphinxDirective):
    """A table of the symbols that a chapter prints, under the title of each chapter."""

    def run(self) -> list[nodes.Node]:
        head = "| symbol | meaning | unit | range | in code |\n|---|---|---|---|---|"
        tables = {c: "\n".join([head, *notation_rows(c)]) for c in course().taught}
        parts = (
            f"## {course().title(chapter)}\n\n::::{{container}} notation\n{table}\n::::"
            for chapter, table in tables.items()
            if table != head
        )
        return self.parse_text_to_nodes("\n\n".join(parts), allow_section_headings=True)


def notation_rows(chapter: str) -> list[str]:
    """Return a row for all symbols of one meaning, such as the entries of a matrix."""
    names, groups = lexicon.assigned_names(chapter), dict[tuple[str, ...], list[NamedSymbol]]()
    for symbol in lexicon.printed_symbols(chapter):
        span = f"{symbol.low:.7g} … {symbol.high:.7g}" if symbol.has_range else ""
        key = (symbol.meaning, symbol.unit, span.replace("-", "−"))
        groups.setdefault(key, []).append(symbol)
    rows = []
    for (meaning, unit, span), group in groups.items():
        letters = [f"${symbol.latex}$" for symbol in group]
        if len(letters) > 4:
            letters[1:-1] = ["…"]
        codes = ", ".join(f"`{symbol.code}`" for symbol in group if symbol.code in names)
        row = (", ".join(letters), render_symbols(meaning), unit, span, codes)
        rows.append(f"| {' | '.join(row)} |")
    return rows
