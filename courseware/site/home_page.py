"""Directives of the first page: a live figure, cards of chapters, the course in numbers."""

from html import escape
from pathlib import Path

from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.errors import CourseError
from courseware.figures import Figure
from courseware.figures.figure import find_figure
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.dealing import VARIANTS
from courseware.site.outputs import render_figure
from courseware.site.sources import note_sources
from courseware.site.verification_page import format_power, verify_course

CARD = 358  # pixels, as on a phone, for which every figure is made
FILLED = 'preserveAspectRatio="xMidYMid slice"'


class Live(SphinxDirective):
    """A live figure of a chapter, by its name."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        note_sources(self.env, "figures")
        try:
            return [render_figure(self.arguments[0])]
        except CourseError as error:
            raise ExtensionError(str(error)) from error


class Chapters(SphinxDirective):
    """The chapters as cards: picture of the first figure, title, question."""

    def run(self) -> list[nodes.Node]:
        note_sources(self.env, "__init__", "figures")
        chapters = course().chapters_of("figures", Figure)
        first = {chapter: name for name, chapter in reversed(chapters.items())}
        cards = "".join(self._card(c, first[c]) for c in course().taught if c in first)
        text = f'<p class="site-so-far"></p><div class="site-cards">{cards}</div>'
        return [nodes.raw("", text, format="html")]

    def _card(self, chapter: str, figure: str) -> str:
        page = self.env.app.builder.get_relative_uri(self.env.docname, f"{chapter}/{chapter}")
        picture = find_figure(figure).render_svg(CARD).replace("<svg ", f"<svg {FILLED} ", 1)
        return (
            f'<a class="site-card" href="{page}"><span aria-hidden="true">{picture}</span>'
            f"<strong>{escape(course().title(chapter))}</strong>"
            f"<em>{escape(course().question(chapter))}</em></a>"
        )


class Promise(SphinxDirective):
    """The size of the course and its largest difference, as found by this build."""

    def run(self) -> list[nodes.Node]:
        note_sources(self.env, "formulas", "checks", "figures", "exercises")
        found = verify_course(Path(self.env.app.outdir).parent)
        lines = (
            f"**{found.formulas}** formulas, each computed at {found.samples:,} points or more: "
            f"they and the code are at most {format_power(found.largest)} apart ([how](checks)).",
            f"**{len(course().find_all('figures', Figure))}** figures that you can move.",
            f"**{len(all_exercises())}** exercises, each with {VARIANTS} sets of numbers, "
            f"and **{len(all_mistakes())}** mistakes that they know by name "
            "([practice](practice)).",
        )
        return self.parse_text_to_nodes("\n".join(f"- {line}" for line in lines))
