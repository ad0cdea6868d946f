"""Directives of the first page: figures, cards of chapters."""

import re
from dataclasses import replace
from html import escape

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.figures import Figure
from courseware.figures.figure import find_figure
from courseware.site.outputs import render_figure

CARD = 358  # pixels, as on a phone, for which every figure is made
ASPECT = 1.7  # of the picture on a card


class Live(SphinxDirective):
    """A live figure of a chapter, by its name."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        return [render_figure(self.arguments[0])]


class Chapters(SphinxDirective):
    """Cards of all chapters, in the order of `_toc.yml`."""

    def run(self) -> list[nodes.Node]:
        chapters = course().chapters_of("figures", Figure)
        first = {chapter: name for name, chapter in reversed(chapters.items())}
        shown = {c: course().card(c) or first[c] for c in course().taught if c in first}
        cards = "".join(self._card(chapter, figure) for chapter, figure in shown.items())
        html = f'<p class="site-so-far"></p><div class="site-cards">{cards}</div>'
        return [nodes.raw("", html, format="html", still=list(shown.values()))]

    def _card(self, chapter: str, figure: str) -> str:
        page = self.env.app.builder.get_relative_uri(self.env.docname, f"{chapter}/{chapter}")
        shown = find_picture(figure)
        shown = replace(shown, view=widen(shown.view))
        picture = re.sub("<defs>.*</defs>", "", shown.render_svg(CARD))
        return (
            f'<a class="site-card" href="{page}"><span aria-hidden="true">{picture}</span>'
            f"<small>{course().taught.index(chapter):02}</small>"
            f"<strong>{escape(course().title(chapter))}</strong>"
            f"<em>{escape(course().question(chapter))}</em>"
            f"<small>{course().minutes(chapter)} min</small></a>"
        )


def find_picture(name: str) -> Figure:
    """Return a picture for this page alone, from a `cards.py`, or else a chapter's figure."""
    return course().find_all("cards", Figure).get(name) or find_figure(name)


def widen(view: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    """Return the window on the world that shows all of this one, and is as wide as a card's."""
    left, right, low, high = view
    wide, tall = right - left, high - low
    across, up = max(0, ASPECT * tall - wide) / 2, max(0, wide / ASPECT - tall) / 2
    return left - across, right + across, low - up, high + up
