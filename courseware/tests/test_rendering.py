"""Exercises as a page shows them: texts with numbers in them, and the data for the browser."""

import base64
import json
import re
import zlib
from itertools import pairwise

import pytest
from declared import each

from courseware import practice
from courseware.practice import Exercise, rendering, variants
from courseware.script import engine as script

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


MOST = 128_000  # bytes of a chapter's exercises; loaded only once a student's name is known
MORE = {"planar_arm": 192_000, "frames": 192_000, "wheels": 140_000}  # eleven exercises


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
