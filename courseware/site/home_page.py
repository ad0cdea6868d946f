"""What the first page shows: a live figure, the chapters as cards, what is promised in numbers."""

from html import escape
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.figures import Figure
from courseware.figures.figure import find_figure
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.dealing import VARIANTS
from courseware.site.checks_page import checked, power
from courseware.site.outputs import figure_on_page
from courseware.site.sources import depend


class Live(SphinxDirective):
    """A chapter's figure, live, on another page: its name."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        depend(self.env, "figures")
        return [figure_on_page(self.arguments[0])]


class Chapters(SphinxDirective):
    """The chapters as cards: a picture of its first figure, the title, and the question."""

    def run(self) -> list[nodes.Node]:
        """A card for each chapter that has a notebook."""
        depend(self.env, "__init__", "figures")
        pictures: dict[str, str] = {}
        for name, chapter in course().homes("figures", Figure).items():
            pictures.setdefault(chapter, name)
        cards = [
            self._card(chapter, pictures[chapter])
            for chapter in course().taught
            if chapter in pictures
        ]
        text = f'<p class="site-so-far"></p><div class="site-cards">{"".join(cards)}</div>'
        return [nodes.raw("", text, format="html")]

    def _card(self, chapter: str, figure: str) -> str:
        page = self.env.app.builder.get_relative_uri(self.env.docname, f"{chapter}/{chapter}")
        picture = find_figure(figure).render_svg(CARD).replace("<svg ", f"<svg {FILLED} ", 1)
        return (
            f'<a class="site-card" href="{page}"><span aria-hidden="true">{picture}</span>'
            f"<strong>{escape(course().title(chapter))}</strong>"
            f"<em>{escape(course().question(chapter))}</em></a>"
        )


CARD = 358  # pixels, as on a phone, for which every figure is made
FILLED = 'preserveAspectRatio="xMidYMid slice"'


class Promise(SphinxDirective):
    """What the course says of itself, in numbers that this build has found."""

    def run(self) -> list[nodes.Node]:
        depend(self.env, "formulas", "checks", "figures", "exercises")
        found = checked(Path(self.env.app.outdir).parent)
        lines = (
            f"**{found.formulas}** formulas, each computed at {found.samples:,} points or more: "
            f"they and the code are at most {power(found.largest)} apart ([how](checks)).",
            f"**{len(course().declared('figures', Figure))}** figures that you can move.",
            f"**{len(all_exercises())}** exercises, each with {VARIANTS} sets of numbers, "
            f"and **{len(all_mistakes())}** mistakes that they know by name "
            "([practice](practice)).",
        )
        return self.parse_text_to_nodes("\n".join(f"- {line}" for line in lines))
