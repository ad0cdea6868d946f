"""The questions for Moodle, read back by its grammar."""

import re
from collections import Counter
from xml.etree import ElementTree

import numpy as np
import pytest
from declared import EXERCISES

from workshop.practice import dealing, judging
from workshop.practice.command import main

FIELD = re.compile(r"\{1:NUMERICAL:([^}]*)\}")
NUMBER = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
ANSWER = re.compile(rf"(=?)({NUMBER}):({NUMBER})(?:#([^~#}}]+))?")


def fields(question):
    """The fields of one of Moodle's questions: for each number, what is right, and what is told."""
    text = question.find("questiontext/text").text
    found = [[ANSWER.fullmatch(part) for part in field.split("~")] for field in FIELD.findall(text)]
    assert text.count("{") == len(found)
    return found


def test_moodle_asks_the_same_and_names_the_same_mistakes(folder):
    """The grammar of its embedded answers, read back, against the bank."""
    assert run("moodle", "--out", "quiz.xml") == 0
    quiz = ElementTree.parse("quiz.xml").getroot()
    asked = Counter()
    for question in quiz.iter("question"):
        if question.get("type") == "category":
            exercise = EXERCISES[question.find("category/text").text.split("/")[-1]]
            continue
        number = asked[exercise.name]
        asked[exercise.name] += 1
        candidates = dealing.variants(exercise.name)[number].candidates
        told = {c.name: c.rows[0] for c in candidates}
        said = {judging.outcomes(exercise)[name].says: name for name in told}
        assert question.find("name/text").text.startswith(f"{exercise.name} {number:02}")
        for place, answers in enumerate(fields(question)):
            for right, value, tolerance, says in (answer.groups() for answer in answers):
                assert float(tolerance) == exercise.asks[place].tolerance
                name = "right" if right else said[says]
                values = [c.rows[0][place] for c in candidates if c.name == name]
                off = min(abs(float(value) - x) for x in values)
                turn = 2 * np.pi if right and exercise.asks[place].circle else np.inf
                assert min(off, abs(off - turn)) < 1e-8
    fit = {name for name, exercise in EXERCISES.items() if exercise.accept == "one"}
    assert asked == Counter(dict.fromkeys(fit, dealing.VARIANTS))


def test_moodle_names_a_mistake_only_where_it_is_the_only_one(folder):
    """A number that two mistakes give is told to be wrong, not why."""
    assert run("moodle", "--out", "quiz.xml", "--only", "planar-arm-2") == 0
    exercise = EXERCISES["planar-arm-2"]
    questions = ElementTree.parse("quiz.xml").getroot().findall("question[@type='cloze']")
    for question, variant in zip(questions, dealing.variants(exercise.name), strict=True):
        for place, (ask, answers) in enumerate(zip(exercise.asks, fields(question), strict=True)):
            named = [float(answer[2]) for answer in answers]
            apart = np.abs(np.subtract.outer(named, named)) + np.eye(len(named))
            assert apart.min() > 2 * ask.tolerance
            wrong = {round(c.rows[0][place], 6) for c in variant.candidates}
            assert len(named) <= len(wrong)


def test_moodle_overwrites_nothing_and_tells_what_is_left_out(folder, capsys):
    assert run("moodle", "--only", "differential-drive-1", "elbow-arm-7") == 0
    assert "left out: elbow-arm-7" in capsys.readouterr().out
    assert run("moodle", "--only", "differential-drive-1") == 2
    assert "already there" in capsys.readouterr().err
    assert run("moodle", "--only", "differential-drive-1", "--force") == 0
