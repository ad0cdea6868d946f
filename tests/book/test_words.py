"""The chapters' words: the field's nouns, explained and used."""

import re
from importlib import import_module

import nbformat
import pytest
from declared import course

from courseware.symbols import lexicon

TAUGHT = course().taught
# words of the field that a reader looks up, whether or not a chapter uses them
LOOKED_UP = {
    "elbow_arm": "configuration, singularity, spherical wrist, reachable workspace",
    "euler": "orientation, SO(3), Tait–Bryan angles, representation singularity",
    "frames": "translation, active and passive",
    "bicycle": "kinematic bicycle model, off-tracking, swept path, slip angle, turning circle",
    "wheels": "holonomic, nonholonomic, omni wheel, Mecanum wheel, hub of a wheel",
    "odometry": "quadrature, random walk, UMBmark, type A and type B",
    "planar_arm": "end effector, forward kinematics, inverse kinematics, redundant, "
    "singular value, joint space and task space, virtual work",
}


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


def test_the_glossary_has_the_words_of_the_field():
    text = (course().folder / "glossary.md").read_text(encoding="utf-8")
    heads = re.findall(r"^(\w.*)\n  <span", text, re.MULTILINE)
    known = {word for head in heads for word in head.split(", ")}
    assert len(known) > len(heads) > 60  # some heads have several words
    words = {word for each in LOOKED_UP.values() for word in each.split(", ")}
    assert not words - known
    assert heads == sorted(heads, key=str.casefold)


def declared_symbols():
    return {s for chapter in TAUGHT for s in lexicon.symbols_of(chapter).values()}


def test_a_prime_means_after_the_step():
    primed = {symbol for symbol in declared_symbols() if "'" in symbol.latex}
    assert primed
    other = {symbol.latex: symbol.meaning for symbol in primed}
    assert not {k: v for k, v in other.items() if "after the step" not in v}


def test_the_rate_of_a_wheel_has_one_letter():
    rates = {s for s in declared_symbols() if s.unit == "rad/s" and "wheel" in s.meaning}
    letters = {s.latex for s in rates if "rate" in s.meaning}
    assert len(letters) > 3
    assert not {letter for letter in letters if r"\dot\varphi" not in letter}
