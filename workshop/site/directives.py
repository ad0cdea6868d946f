"""What a page can ask for: all exercises, all chapters, the library, the symbols, the errata."""

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workshop import equations
from workshop.course import course
from workshop.practice.bank import exercises, mistakes, topics
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


class Chapters(SphinxDirective):
    """A table of the chapters: each with the question that its package's docstring asks."""

    def run(self) -> list[nodes.Node]:
        """A row for each chapter that has a notebook."""
        depend(self.env, "__init__")
        rows = [
            f"| [{course().title(chapter)}](/{chapter}/{chapter}) | {course().question(chapter)} |"
            for chapter in course().chapters
            if course().notebook(chapter).exists()
        ]
        return self.parse_text_to_nodes(
            "\n".join(["| chapter | the question |", "|---|---|", *rows])
        )


class Errata(SphinxDirective):
    """What stands wrong in the source documents."""

    def run(self) -> list[nodes.Node]:
        """What stands, what should and why, for each mistake that stands in a document."""
        depend(self.env, "exercises")
        found = sorted(
            (m for m in mistakes().values() if m.document), key=lambda m: int(m.name[1:])
        )
        entries = [
            f"**{m.document}** ({m.name})\n\n- There stands: {symbols(m.stands)}\n"
            f"- It should be: {symbols(m.should)}\n\n{symbols(m.why)}"
            for m in found
        ]
        return self.parse_text_to_nodes("\n\n".join(entries))


class Notation(SphinxDirective):
    """A table of every symbol: unit, range, meaning."""

    def run(self) -> list[nodes.Node]:
        """One row a symbol that formulas use."""
        depend(self.env, "formulas", "figures")
        lines = ["| symbol | in code | unit | range | meaning |", "|---|---|---|---|---|"]
        for known in equations.quantities():
            span = f"{known.low:g} … {known.high:g}".replace("-", "\u2212")
            lines.append(
                f"| ${known.latex}$ | `{known}` | {known.unit} | {span} | {known.meaning} |"
            )
        return self.parse_text_to_nodes("\n".join(lines))
