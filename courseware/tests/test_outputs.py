"""What a cell becomes on a page: a figure's name and the headings around it."""

from types import SimpleNamespace

import pytest
from declared import FIGURES
from docutils.core import publish_doctree
from sphinx.errors import ExtensionError

from courseware.site.outputs import refuse_names_of_headings, render_figure

CHAPTER = SimpleNamespace(env=SimpleNamespace(docname="chapter"))


def page(heading):
    """A page with a heading, and below it the figure `digits`."""
    doctree = publish_doctree(f"Start\n=====\n\n{heading}\n{'=' * len(heading)}\n\nText.\n")
    doctree[-1] += render_figure(FIGURES["digits"].name)
    return doctree


def test_a_figure_with_the_name_of_a_heading_is_refused():
    with pytest.raises(ExtensionError, match=r"chapter: the figure 'digits' .* “Digits” .* words"):
        refuse_names_of_headings(CHAPTER, page("Digits"))


def test_a_figure_may_have_a_name_of_its_own():
    refuse_names_of_headings(CHAPTER, page("Lost digits"))
