"""What a page can ask for: all exercises, all chapters, the library, the symbols, the errata."""

import re

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workshop import equations
from workshop.course import course
from workshop.practice.bank import Mistake, exercises, mistakes, topics
from workshop.practice.wording import symbols
from workshop.site.outputs import exercise_box
from workshop.site.sources import depend


class Practice(SphinxDirective):
    """All exercises, chapter by chapter; with a topic's name, those of the topic."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """A box for each exercise, under the titles of the chapters unless one is named."""
        if not self.arguments:
            parts = (f"## {course().title(t)}\n\n```{{practice}} {t}\n```\n" for t in topics())
            return self.parse_text_to_nodes("\n".join(parts), allow_section_headings=True)
        topic = self.arguments[0]
        names = [name for name, exercise in exercises().items() if exercise.topic == topic]
        if not names:
            raise self.error(f"no exercises on {topic!r}; there are {', '.join(topics())}")
        return [exercise_box(self.env, name) for name in names]


class Library(SphinxDirective):
    """The functions of the library and those that chapters declare, module by module."""

    def run(self) -> list[nodes.Node]:
        """A section for each module, from its docstrings."""
        depend(self.env, "functions")
        text = "\n".join(
            f"## {name}\n\n```{{eval-rst}}\n.. automodule:: {name}\n   :members:\n```\n"
            for name in course().library_modules
        )
        return self.parse_text_to_nodes(text, allow_section_headings=True)


class Errata(SphinxDirective):
    """What stands wrong in the source documents."""

    def run(self) -> list[nodes.Node]:
        """What stands, what should and why, for each mistake that stands in a document."""
        depend(self.env, "exercises")
        found = sorted(
            (m for m in mistakes().values() if m.document), key=lambda m: (m.document, m.nth)
        )
        return self.parse_text_to_nodes("\n\n".join(map(erratum, found)))


def erratum(mistake: Mistake) -> str:
    """Where it stands, what stands there, what should, why, and where the course treats it."""
    asked = [each for each in exercises().values() if mistake in each.wrong]
    page = f"/{asked[0].topic}/{asked[0].topic}"
    chapter = f"[{course().title(asked[0].topic)}]({page})"
    # an exercise's place is made by its box, so that Sphinx does not know it
    links = ", ".join(f'<a href=".{page}.html#{each.name}">{each.name}</a>' for each in asked)
    should = symbols(mistake.should).replace("«", "<mark>").replace("»", "</mark>")
    return (
        f"**{mistake.document}**, {symbols(mistake.place)} ({mistake.name})\n\n"
        f"- There stands: {symbols(mistake.stands)}\n- It should be: {should}\n\n"
        f"{symbols(mistake.explained or mistake.why)} "
        f"Chapter: {chapter}. Exercises: {links}."
    )


class Notation(SphinxDirective):
    """The symbols of the formulas, chapter by chapter: name in them, unit, range, meaning."""

    def run(self) -> list[nodes.Node]:
        """A table under the title of each chapter that declares symbols."""
        depend(self.env, "formulas", "figures")
        lines: list[str] = []
        for chapter, rows in notation().items():
            has_page = course().notebook(chapter).exists()
            title = course().title(chapter) if has_page else chapter.capitalize()
            lines += ["", f"## {title}", "", "| symbol | name | unit | range | meaning |"]
            lines += ["|---|---|---|---|---|", *rows]
        return self.parse_text_to_nodes("\n".join(lines), allow_section_headings=True)


def notation() -> dict[str, list[str]]:
    """Chapter → its rows. What several chapters declare alike stands once, where it is first."""
    groups: dict[tuple[str, str, str], list[equations.core.NamedSymbol]] = {}
    for known in equations.quantities():
        if not re.match("[a-z]{3}", known.latex):  # a word, which no formula prints
            groups.setdefault((known.latex, known.unit, known.meaning), []).append(known)
    tables: dict[str, list[str]] = {}
    for (latex, unit, meaning), alike in groups.items():
        chapters = list(dict.fromkeys(known.module.split(".")[-2] for known in alike))
        spans = dict.fromkeys(f"{s.low:.3g} … {s.high:.3g}".replace("-", "\u2212") for s in alike)
        codes = dict.fromkeys(f"`{known}`" for known in alike)
        also = [course().title(c) for c in chapters[1:] if course().notebook(c).exists()]
        more = f" (also: {', '.join(also)})" if also else ""
        cells = f"${latex}$", ", ".join(codes), unit, "; ".join(spans), meaning + more
        tables.setdefault(chapters[0], []).append(f"| {' | '.join(cells)} |")
    return tables
