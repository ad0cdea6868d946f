"""The chapters' words: the field's nouns, explained and used."""

import re

import nbformat
import pytest
from declared import course

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


def prose(chapter):
    notebook = nbformat.read(course().notebook(chapter), as_version=4)
    return "\n\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")


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
