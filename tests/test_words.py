"""The chapters' words: the field's nouns, explained and used; nothing is claimed in vain."""

import re

import nbformat
import pytest
from declared import MISTAKES
from support import ROOT

from workshop.course import course

# The field's nouns that a chapter explains once, marked where it stands, and then uses.
NOUNS = {
    "elbow_arm": (
        "forward kinematics",
        "inverse kinematics",
        "degree of freedom",
        "end effector",
        "workspace",
        "branch",
        "singularity",
    ),
    "euler": ("rotation matrix", "intrinsic", "extrinsic", "gimbal lock"),
    "frames": ("frame", "homogeneous transform", "inverse", "loop closure"),
    "differential_drive": (
        "angular velocity",
        "instantaneous centre of rotation",
        "twist",
        "nonholonomic",
    ),
    "bicycle": (
        "instantaneous centre of rotation",
        "angular velocity",
        "twist",
        "nonholonomic",
    ),
    "wheels": (
        "rolling constraint",
        "sliding constraint",
        "degree of mobility",
        "degree of steerability",
        "degree of manoeuvrability",
    ),
    "odometry": (
        "encoder",
        "dead reckoning",
        "covariance matrix",
        "random error",
        "systematic error",
    ),
    "planar_arm": (
        "Jacobian",
        "singularity",
        "manipulability",
        "workspace",
        "damped least squares",
        "resolved-rate control",
        "null space",
    ),
}
SHORT = {  # what it is called from then on
    "instantaneous centre of rotation": "ICR",
    "covariance matrix": "covariance",
    "damped least squares": "damp",
    "degree of steerability": "steerability",
    "rolling constraint": "rolling row",
    "sliding constraint": "sliding row",
}
PLURALS = {"degree of freedom": "degrees of freedom", "singularity": "singularities"}
NUMBERS = ("none", "one", "two", "three", "four", "five", "six")


def cells(chapter):
    return nbformat.read(ROOT / "book" / chapter / f"{chapter}.ipynb", as_version=4).cells


def prose(chapter):
    return "\n\n".join(cell.source for cell in cells(chapter) if cell.cell_type == "markdown")


@pytest.mark.parametrize(("chapter", "noun"), [(c, n) for c, nouns in NOUNS.items() for n in nouns])
def test_a_noun_is_explained_once_then_used(chapter, noun):
    text = prose(chapter)
    one_or_many = rf"(?:{noun}|{PLURALS.get(noun, f'{noun}e?s')})"
    explained = list(
        re.finditer(rf"(?<!\*)\*{{1,2}}{one_or_many}\*{{1,2}}(?!\*)", text, re.IGNORECASE)
    )
    assert len(explained) == 1, f"{noun} is marked {len(explained)} times"
    used = rf"\b(?:{one_or_many}|{SHORT.get(noun, noun)})\b"
    assert re.search(used, text[explained[0].end() :], re.IGNORECASE), f"{noun} is not used"


def test_no_chapter_is_left_out():
    assert {*NOUNS, "basics"} == set(course().taught)


@pytest.mark.parametrize("chapter", NOUNS)
def test_sources_of_mistakes_are_told_as_they_are(chapter):
    """How many of the chapter's mistakes stand in a source document; the rest are likely ones."""
    text = prose(chapter)
    shown = re.findall(
        r'practice\.mistake\("(M\d+)"\)',
        "\n".join(cell.source for cell in cells(chapter) if cell.cell_type == "code"),
    )
    written = sum(bool(MISTAKES[name].document) for name in shown)
    intro = text[text.index("## Find the mistake") :].split("\n\n")[1].lower()
    assert intro.startswith(f"{NUMBERS[len(shown)]} mistakes")
    assert f"**recognise** {NUMBERS[len(shown)]} mistakes" in text
    if not written:
        assert f"all {NUMBERS[len(shown)]} are likely" in intro
        return
    assert f"{NUMBERS[written]} stand" in intro
    if written < len(shown):
        assert f"{NUMBERS[len(shown) - written]} " in intro.split(" stand")[1]


CLAIMS = ("students or books", "really write", "never the arctangent", "every formula is checked")


@pytest.mark.parametrize("chapter", NOUNS)
def test_what_cannot_be_shown_is_not_claimed(chapter):
    assert not [claim for claim in CLAIMS if claim in prose(chapter).lower()]


@pytest.mark.parametrize("page", sorted((ROOT / "book").glob("*.md")), ids=lambda page: page.stem)
def test_pages_do_not_claim_it_either(page):
    assert not [claim for claim in CLAIMS if claim in page.read_text("utf-8").lower()]
