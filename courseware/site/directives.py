"""Directives for exercises, the library and errata."""

from typing import Any

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.practice.bank import all_exercises, all_mistakes, all_topics
from courseware.practice.mistakes import Mistake
from courseware.site.outputs import render_desk, render_exercise
from courseware.units.formatting import render_marked, render_symbols


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
    """The field for a student's name, above the first exercise."""

    def run(self) -> list[nodes.Node]:
        return [nodes.raw("", render_desk(self.env), format="html")]


class Library(SphinxDirective):
    """A section for each module of the library and for the functions of chapters."""

    def run(self) -> list[nodes.Node]:
        text = "\n".join(
            f"## {name}\n\n```{{eval-rst}}\n.. automodule:: {name}\n   :members:\n```\n"
            for name in course().library_modules
        )
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def skip_fields(app: Any, what: str, name: str, member: Any, *_: Any) -> bool | None:
    """Leave out the fields of a named tuple, which are listed in its docstring."""
    return True if str(member.__doc__).startswith("Alias for field number") else None


class Errata(SphinxDirective):
    """The mistakes of the source documents."""

    def run(self) -> list[nodes.Node]:
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
