"""Exercises as a page shows them: texts with numbers in them, and the data for the browser."""

import base64
import json
import re
import zlib
from html import unescape
from itertools import pairwise

import pytest
from declared import each

from courseware import practice
from courseware.practice import Exercise, rendering, variants
from courseware.script import engine as script
from courseware.units.formatting import render_paragraphs, render_symbols
from courseware.units.line_breaks import prevent_breaks

each_exercise = each("exercise", "exercises", Exercise)


@each_exercise
def test_texts_can_be_filled(exercise):
    for variant in variants.all_variants(exercise.name):
        for template in (exercise.text, exercise.solution.text):
            filled = exercise.fill(template, variant.numbers)
            assert "{" not in filled
            assert not re.search(r"\bnan\b", filled)


@each_exercise
def test_the_box_says_how_many_steps_the_ladder_opens(exercise):
    """It counts them without numbers, and the ladder with them."""
    packed = json.loads(zlib.decompress(base64.b64decode(rendering.pack([exercise]))))
    said = packed[exercise.name]["steps"]
    formula = re.compile(r"(?:\[[^=]*\]|\S+) = ")
    for variant in variants.all_variants(exercise.name):
        text = exercise.fill(exercise.solution.text, variant.numbers)
        assert len(script.call("courseware.splitSolution", text)) == said
        kinds = [formula.match(part) is not None for part in text.split("\n\n")]
        steps = 1 + sum(before and not now for before, now in pairwise(kinds))
        assert steps == said


def plain(html):
    return unescape(re.sub("<[^>]+>", "", html))


@each_exercise
def test_no_line_ends_inside_a_number_with_its_unit(exercise):
    """In the text as Python writes it and as the page does; nothing else changes in it."""
    variant = variants.all_variants(exercise.name)[0]
    text = exercise.fill(exercise.text, variant.numbers)
    for html in (render_paragraphs(text), script.call("courseware.renderParagraphs", text)):
        shown = plain(html)
        assert not re.search(r"\d (?:cm|m|s|rad|N)\b|[=] \d| = −?\d", shown)
        if "[[" not in text:  # on the page a matrix
            assert shown.replace("\u00a0", " ") == plain(render_symbols(text.replace("\n\n", "")))


def test_short_formulas_and_units_stay_together():
    said = prevent_breaks(
        "a = 3 cm and b = −0.5 m/s in rad, x = (a longer formula) in 2 ways, 5 °/s"
    )
    kept = ["a = 3 cm", "b = −0.5 m/s", "in rad", "x = (a", "5 °/s"]
    assert all(part.replace(" ", "\u00a0") in said for part in kept)
    assert "longer formula) in 2 ways" in said


MOST = 128_000  # bytes of a chapter's exercises; loaded only once a student's name is known
MORE = {"planar_arm": 192_000, "wheels": 140_000}  # eleven exercises


@pytest.mark.parametrize("topic", practice.all_topics())
def test_the_data_of_a_topic_are_light_and_not_in_clear(topic):
    text = rendering.render_script(topic)
    most = MORE.get(topic, MOST)
    assert len(text) < most, (
        f"the exercises of {topic} have {len(text)} bytes, at most {most}: shorten solutions and "
        "texts, or ask for fewer numbers"
    )
    assert "right" not in text
    assert len(rendering.render_script(topic, solutions=False)) < len(text)
