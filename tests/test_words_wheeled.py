"""The field's standard nouns stand in the chapters on wheels, odometry and the planar arm."""

import json

import pytest

import book  # noqa: F401  opens the course
from workshop.course import course

NOUNS = {
    "wheels": [
        "rolling constraint",
        "sliding constraint",
        "degree of mobility",
        "degree of steerability",
        "degree of manoeuvrability",
    ],
    "odometry": [
        "encoder",
        "dead reckoning",
        "covariance matrix",
        "random error",
        "systematic error",
    ],
    "planar_arm": [
        "Jacobian",
        "singularity",
        "manipulability",
        "workspace",
        "damped least squares",
        "resolved-rate control",
        "null space",
    ],
}


@pytest.mark.parametrize(("chapter", "noun"), [(c, n) for c, nouns in NOUNS.items() for n in nouns])
def test_a_noun_of_the_field_is_marked_where_it_is_explained(chapter, noun):
    cells = json.loads(course().notebook(chapter).read_text("utf-8"))["cells"]
    text = "".join("".join(c["source"]) for c in cells if c["cell_type"] == "markdown")
    assert f"*{noun}*" in text.replace("**", "*").replace("*Damped", "*damped")


CLAIMS = ["students or books", "really write", "never the arctangent", "every formula is checked"]


@pytest.mark.parametrize("chapter", NOUNS)
def test_what_cannot_be_shown_is_not_claimed(chapter):
    notebook = course().notebook(chapter)
    texts = [p.read_text("utf-8").lower() for p in (notebook, *notebook.parents[1].glob("*.md"))]
    assert not [claim for claim in CLAIMS for text in texts if claim in text]


@pytest.mark.parametrize("chapter", NOUNS)
def test_the_answer_to_a_prediction_is_folded(chapter):
    cells = json.loads(course().notebook(chapter).read_text("utf-8"))["cells"]
    asking = [k for k, c in enumerate(cells) if "**Predict" in "".join(c["source"])]
    for k in asking:
        after = ["".join(c["source"]) for c in cells[k : k + 8]]
        after[0] = after[0].split("**Predict")[-1]
        assert any("<details>" in text for text in after), after[0][:80]
        outputs = [c for c in cells[k + 1 : k + 2] if c["cell_type"] == "code" and c["outputs"]]
        folded = {"hide-output", "remove-input"}  # an output beside the question tells the answer
        assert all(folded & set(c["metadata"].get("tags", [])) for c in outputs), after[0][:80]
