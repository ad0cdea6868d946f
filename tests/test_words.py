"""The chapters' words: the field's nouns, explained and used; questions come before answers."""

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
# the other chapters declare their predictions: test_predictions.py
TYPED = [chapter for chapter in course().taught if not course().module(chapter, "predictions")]
NUMBERS = ("none", "one", "two", "three", "four", "five", "six")
PREDICTION = re.compile(r"\b(?:Predict|Guess)\b")
FOLD = re.compile(r"(.*?)(?:<details>(.*?)</details>|\Z)", re.DOTALL)
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
    explained = list(
        re.finditer(rf"(?<!\*)\*{{1,2}}{one_or_many}\*{{1,2}}(?!\*)", text, re.IGNORECASE)
    )
    assert len(explained) == 1, f"{noun} is marked {len(explained)} times"
    used = rf"\b(?:{one_or_many}|{SHORT.get(noun, noun)})\b"
    assert re.search(used, text[explained[0].end() :], re.IGNORECASE), f"{noun} is not used"


def steps(cells):
    """What a reader meets, in order: (kind, text): prose, a fold, or an output, hidden or not."""
    for cell in cells:
        if cell.cell_type == "code":
            folded = DRAWN.search(cell.source) or FOLDED & set(cell.metadata.get("tags", []))
            yield "hidden" if folded else "open", "".join(map(output_text, cell.outputs))
            continue
        for outside, inside in FOLD.findall(cell.source):
            yield from (("prose", part) for part in re.split(r"\n{2,}", outside.strip()) if part)
            if inside:
                yield "fold", inside


def output_text(output):
    """What an output says in words and numbers; a formula or an exercise says nothing here."""
    shown = output.get("data", {})
    if any("workshop" in kind for kind in shown):
        return ""
    return output.get("text", "") + shown.get("text/plain", "")


def numbers(text):
    """The numbers that could give an answer away: of two digits or more."""
    return {n for n in re.findall(r"\d+(?:\.\d+)?", text) if len(n) > 1} - {"90", "180", "360"}


def given_away(cells):
    """Predictions without a fold, after an open output, or with its numbers in their section."""
    met = list(steps(cells))
    headings = [k for k, (_, text) in enumerate(met) if text.startswith("#")] + [len(met)]
    for k, (kind, question) in enumerate(met):
        if kind != "prose" or not PREDICTION.search(question):
            continue
        begin = max((h for h in headings if h < k), default=0)
        end = min(h for h in headings if h > k)
        fold = next((j for j in range(k + 1, end) if met[j][0] == "fold"), None)
        if fold is None or any(kind == "open" for kind, _ in met[k + 1 : fold]):
            yield question
            continue
        told = numbers(met[fold][1]) - numbers(question)
        around = [text for kind, text in met[begin:end] if kind in ("prose", "open")]
        if any(told & numbers(text) for text in around):
            yield question


def test_no_chapter_is_left_out():
    assert {*NOUNS, "basics"} == set(course().taught)


@pytest.mark.parametrize("chapter", TYPED)
def test_predictions_do_not_meet_their_answer(chapter):
    assert PREDICTION.search(prose(chapter))
    assert not list(given_away(cells(chapter)))


def test_an_open_answer_is_seen():
    def text(source):
        return nbformat.v4.new_markdown_cell(source)

    def shown(number, *tags):
        output = nbformat.v4.new_output("stream", text=number)
        return nbformat.v4.new_code_cell("x", metadata={"tags": list(tags)}, outputs=[output])

    ask, fold = text("## Why\n\n**Predict** this."), text("<details>\n\nIt is 42.\n\n</details>")
    assert not list(given_away([ask, shown("42", "hide-output"), fold]))
    assert not list(given_away([ask, fold, shown("7"), text("## Next\n\nIt was 42.")]))
    assert list(given_away([ask, shown("7"), fold]))
    assert list(given_away([ask, fold, text("So it is 42.")]))
    assert list(given_away([text("We shall find 42.\n\n**Guess** it."), fold]))
    assert list(given_away([ask, shown("42"), text("It is 42.")]))
    assert list(given_away([ask, text("## Next"), fold]))


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
