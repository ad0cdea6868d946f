"""The chapters' words: the field's nouns, explained and used; questions come before answers."""

import re

import nbformat
import pytest
from declared import MISTAKES
from support import ROOT

# The field's nouns that a chapter explains once, where it stands in italics, and then uses.
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
}
SHORT = {"instantaneous centre of rotation": "ICR"}  # what it is called from then on
PLURALS = {"degree of freedom": "degrees of freedom", "singularity": "singularities"}
ASKING_FIRST = ("basics", *NOUNS)  # chapters whose predictions have their answers folded
NUMBERS = ("none", "one", "two", "three", "four", "five", "six")
PREDICTION = re.compile(r"\b(?:Predict|Guess)\b")
FOLDED = {"hide-output", "hide-cell"}  # hide-cell where the code tells the answer
DRAWN = re.compile(r"figures\.\w+_figure\(\)")


def cells(chapter):
    return nbformat.read(ROOT / "book" / chapter / f"{chapter}.ipynb", as_version=4).cells


def prose(chapter):
    return "\n\n".join(cell.source for cell in cells(chapter) if cell.cell_type == "markdown")


@pytest.mark.parametrize(("chapter", "noun"), [(c, n) for c, nouns in NOUNS.items() for n in nouns])
def test_a_noun_is_explained_once_then_used(chapter, noun):
    text = prose(chapter)
    one_or_many = rf"(?:{noun}|{PLURALS.get(noun, f'{noun}e?s')})"
    explained = list(re.finditer(rf"(?<!\*)\*{one_or_many}\*(?!\*)", text, re.IGNORECASE))
    assert len(explained) == 1, f"{noun} stands in italics {len(explained)} times"
    used = rf"\b(?:{one_or_many}|{SHORT.get(noun, noun)})\b"
    assert re.search(used, text[explained[0].end() :], re.IGNORECASE), f"{noun} is not used"


def steps(chapter):
    """Paragraphs of prose and cells of code, in order."""
    for cell in cells(chapter):
        if cell.cell_type == "code":
            yield cell
        else:
            yield from re.split(r"\n{2,}", cell.source)


def given_away(steps):
    """Predictions whose answer is not folded or stands open just below."""
    steps = list(steps)
    for k, step in enumerate(steps):
        if not isinstance(step, str) or not PREDICTION.search(step):
            continue
        after = steps[k + 1 :]
        words = next((s for s in after if isinstance(s, str)), "")
        if words.startswith("#"):
            continue  # a derivation gives the answer
        code = next((s for s in after if not isinstance(s, str)), None)
        open_output = code is not None and not (
            DRAWN.search(code.source) or FOLDED & set(code.metadata.get("tags", []))
        )
        if open_output or not words.startswith(("<details>", "1. ")):
            yield step


@pytest.mark.parametrize("chapter", ASKING_FIRST)
def test_predictions_do_not_meet_their_answer(chapter):
    assert not list(given_away(steps(chapter)))


def test_an_open_answer_is_seen():
    def shown(*tags):
        return nbformat.v4.new_code_cell("1 + 1", metadata={"tags": list(tags)})

    folded = "<details>\n<summary>Answer</summary>"
    assert not list(given_away(["**Predict** this.", shown("hide-output"), folded]))
    assert not list(given_away(["**Predict** this.", folded, shown("hide-output")]))
    assert list(given_away(["**Predict** this.", shown(), folded]))
    assert list(given_away(["**Guess:** 3 or 4?", shown("hide-output"), "Four."]))
    assert not list(given_away(["**Guess first.** 3 or 4?", "## By hand", shown()]))


@pytest.mark.parametrize("chapter", NOUNS)
def test_sources_of_mistakes_are_told_as_they_are(chapter):
    """How many of the chapter's mistakes stand in a source document; the rest are likely ones."""
    text = prose(chapter)
    assert not re.search(r"(students|books)[^.]* really write", text)
    shown = re.findall(
        r'practice\.mistake\("(M\d+)"\)',
        "\n".join(cell.source for cell in cells(chapter) if cell.cell_type == "code"),
    )
    written = sum(bool(MISTAKES[name].document) for name in shown)
    intro = text[text.index("## Find the mistake") :].split("\n\n")[1].lower()
    assert intro.startswith(f"{NUMBERS[len(shown)]} mistakes")
    assert f"{NUMBERS[written]} stand" in intro
    assert f"{NUMBERS[len(shown) - written]} " in intro.split(" stand")[1]
