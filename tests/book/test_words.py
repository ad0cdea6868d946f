"""The chapters' words: the field's nouns, explained and used."""

import re
from importlib import import_module

import nbformat
import pytest
from declared import course

TAUGHT = course().taught


def terms(chapter):
    """The nouns that a chapter explains: of each all its forms."""
    package = import_module(f"{course().package}.{chapter}")
    return [term.split("|") for term in getattr(package, "TERMS", ())]


def prose(chapter):
    notebook = nbformat.read(course().notebook(chapter), as_version=4)
    return "\n\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")


@pytest.mark.parametrize("chapter", TAUGHT)
def test_a_chapter_says_what_it_explains(chapter):
    package = import_module(f"{course().package}.{chapter}")
    assert hasattr(package, "TERMS"), (
        f'add to book/{chapter}/__init__.py the nouns that it explains: TERMS = ("gimbal lock", …)'
    )


@pytest.mark.parametrize(
    ("chapter", "forms"),
    [pytest.param(c, forms, id=f"{c}:{forms[0]}") for c in TAUGHT for forms in terms(c)],
)
def test_a_term_is_explained_once_then_used(chapter, forms):
    text, term = prose(chapter), rf"(?:{'|'.join(forms)})(?:e?s)?"
    explained = list(re.finditer(rf"(?<!\*)\*{{1,2}}{term}\*{{1,2}}(?!\*)", text, re.IGNORECASE))
    assert len(explained) == 1, (
        f"TERMS in book/{chapter}/__init__.py names it; mark *{forms[0]}* in the notebook once, "
        f"where it is explained: it is marked {len(explained)} times"
    )
    rest = text[explained[0].end() :]
    assert re.search(rf"\b{term}\b", rest, re.IGNORECASE), (
        f"{forms[0]} is explained in {chapter} and not used after that: use it, or take it out of "
        f"TERMS; what it is called then may follow it there, as in {'|'.join(forms)}|SHORT"
    )
