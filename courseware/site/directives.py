"""Directives for exercises, the library, symbols and errata."""

from typing import Any

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.equations.quantities import NamedSymbol
from courseware.practice.bank import all_exercises, all_mistakes, all_topics
from courseware.practice.formatting import render_marked, render_symbols
from courseware.practice.mistakes import Mistake
from courseware.site.outputs import render_desk, render_exercise
from courseware.site.sources import note_sources
from courseware.symbols import lexicon


class Practice(SphinxDirective):
    """All exercises, chapter by chapter; with a topic's name, those of the topic."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return a box for each exercise, under the titles of chapters unless one is named."""
        if not self.arguments:
            parts = (f"## {course().title(t)}\n\n```{{practice}} {t}\n```\n" for t in all_topics())
            return self.parse_text_to_nodes("\n".join(parts), allow_section_headings=True)
        topic = self.arguments[0]
        names = [name for name, exercise in all_exercises().items() if exercise.topic == topic]
        if not names:
            raise self.error(f"no exercises on {topic!r}; there are {', '.join(all_topics())}")
        return [render_exercise(self.env, name) for name in names]


class Desk(SphinxDirective):
    """The field for a student's name, where it stands higher than the first exercise."""

    def run(self) -> list[nodes.Node]:
        return [nodes.raw("", render_desk(self.env), format="html")]


class Library(SphinxDirective):
    """A section for each module of the library and for the functions of chapters."""

    def run(self) -> list[nodes.Node]:
        note_sources(self.env, "functions")
        text = "\n".join(
            f"## {name}\n\n```{{eval-rst}}\n.. automodule:: {name}\n   :members:\n```\n"
            for name in course().library_modules
        )
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def keep_quotes(app: Any, domain: str, objtype: str, content: nodes.Element) -> None:
    """Leave the quotes in the type of a parameter straight: `{"raise", "nan"}` is Python."""
    for kind in content.findall(nodes.emphasis):
        kind["support_smartquotes"] = False


def skip_fields(app: Any, what: str, name: str, member: Any, *_: Any) -> bool | None:
    """Leave out the fields of a named tuple, which are listed in its docstring."""
    return True if str(member.__doc__).startswith("Alias for field number") else None


class Errata(SphinxDirective):
    """The mistakes that stand in the source documents."""

    def run(self) -> list[nodes.Node]:
        note_sources(self.env, "exercises")
        found = sorted(
            (m for m in all_mistakes().values() if m.document), key=lambda m: (m.document, m.nth)
        )
        return self.parse_text_to_nodes("\n\n".join(map(describe_erratum, found)))


def describe_erratum(mistake: Mistake) -> str:
    """Return place, wrong and right version, reason, and the exercises about it, as Markdown."""
    about = [each for each in all_exercises().values() if mistake in each.wrong]
    topic = about[0].topic
    page = f"/{topic}/{topic}"
    chapter = f"[{course().title(topic)}]({page})"
    # HTML, because Sphinx does not know the anchor in an exercise's box
    links = ", ".join(f'<a href=".{page}.html#{each.name}">{each.name}</a>' for each in about)
    should = render_marked(mistake.correction)
    return (
        f"**{mistake.document}**, {render_symbols(mistake.place)} ({mistake.name})\n\n"
        f"- The document says: {render_symbols(mistake.quote)}\n- It should be: {should}\n\n"
        f"{render_symbols(mistake.explanation or mistake.why)} "
        f"Chapter: {chapter}. Exercises: {links}."
    )


class Notation(SphinxDirective):
    """A table of the symbols that a chapter prints, under the title of each chapter."""

    def run(self) -> list[nodes.Node]:
        note_sources(self.env, "formulas", "figures")
        for chapter in course().chapters:
            self.env.note_dependency(str(course().notebook(chapter)))
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
