"""Directives of the book's first page: proofs with a small picture, and counts."""

import re
from string import Template

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.equations.declared_checks import SAMPLES, declared_checks
from courseware.figures import Figure
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.variants import VARIANTS
from courseware.site.home_page import find_picture
from courseware.site.verification_page import format_power

BESIDE = 132  # pixels, beside a proof


class Still(SphinxDirective):
    """A small picture that says nothing new, of a figure or of a `cards.py`."""

    required_arguments = 1

    def run(self):
        drawn = re.sub("<defs>.*</defs>", "", find_picture(self.arguments[0]).render_svg(BESIDE))
        html = f'<div aria-hidden="true">{drawn}</div>'
        return [nodes.raw("", html, format="html", still=self.arguments)]


class Facts(SphinxDirective):
    """Text with counts of what the course declares: `$formulas`, `$mistakes`, `$figures`, …"""

    has_content = True

    def run(self):
        checks = declared_checks().values()
        figures = course().find_all("figures", Figure).values()
        counts = {
            "formulas": len(checks),
            "points": SAMPLES,
            "gap": format_power(max(check.tolerance for check in checks)),
            "mistakes": len(all_mistakes()),
            "exercises": len(all_exercises()),
            "variants": VARIANTS,
            "figures": sum(bool(figure.controls) for figure in figures),
        }
        return self.parse_text_to_nodes(Template("\n".join(self.content)).substitute(counts))


def setup(app):
    """Register the directives with Sphinx."""
    app.add_directive("still", Still)
    app.add_directive("facts", Facts)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
