"""The questions for Moodle, read back by the grammar of its importer."""

import re
from functools import cache
from types import SimpleNamespace
from xml.etree import ElementTree

import numpy as np
import pytest
from commands import run
from declared import EXERCISES, OF_EACH_KIND, each

from classroom import moodle
from courseware.practice import Exercise, candidates, dealing, judging
from courseware.practice.formatting import render_paragraphs, render_symbols

FIELD = re.compile(r"\{1:NUMERICAL:((?:\\.|[^}])*)\}")
NUMBER = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
ANSWER = re.compile(rf"(=?)(\*|({NUMBER}):({NUMBER}))#(.+)")
UNESCAPED = r"(?<!\\)~"  # between the answers of a field
TOLD = 0.95  # of the mistakes, at least


def marks(name):
    """One exercise of each kind always, all in the slow suite."""
    return [] if name in OF_EACH_KIND else [pytest.mark.slow]


each_exercise = each("exercise", "exercises", Exercise, marks)


@pytest.fixture(scope="module")
def questions(tmp_path_factory):
    """A function: an exercise's questions as Moodle's importer sees them, for each variant."""

    @cache
    def export(name):
        path = tmp_path_factory.mktemp("moodle") / "quiz.xml"
        assert run("moodle", "--only", name, "--out", path) == 0
        return ElementTree.parse(path).findall("question[name]")

    return export


def answers(question):
    """The fields of a question: for each, (right, value, tolerance, feedback) in their order."""
    if question.get("type") == "numerical":
        return [
            [
                (
                    each.get("fraction") == "100",
                    each.find("text").text,
                    float(each.find("tolerance").text),
                    each.find("feedback/text").text,
                )
                for each in question.iter("answer")
            ]
        ]
    text = question.find("questiontext/text").text
    found = []
    for field in FIELD.findall(text):
        parts = [ANSWER.fullmatch(part) for part in re.split(UNESCAPED, field)]
        found.append([(bool(p[1]), p[3] or "*", float(p[4] or 0), p[5]) for p in parts])
    assert text.count("{") == len(found)
    return found


def judged(field, value):
    """What Moodle makes of a number: the first answer that fits."""
    return next(
        (right, says)
        for right, wanted, tolerance, says in field
        if wanted == "*" or abs(float(wanted) - value) <= tolerance
    )


def test_every_exercise_is_asked(folder, monkeypatch):
    none = SimpleNamespace(variants=lambda *_: [], version=lambda: "")  # how, is tested below
    monkeypatch.setattr(moodle, "dealing", none)
    assert run("moodle", "--out", "all.xml") == 0
    groups = ElementTree.parse("all.xml").iterfind("question[@type='category']/category/text")
    assert [group.text.split("/")[-1] for group in groups] == list(EXERCISES)


@each_exercise
def test_an_exercise_is_asked_in_all_variants(exercise, questions):
    drawn, name = questions(exercise.name), exercise.name
    assert len(drawn) == dealing.VARIANTS
    several = "cloze" if len(exercise.unknowns) > 1 else "numerical"
    kind = several if exercise.accept == "one" else "multichoice"
    for number, (question, variant) in enumerate(zip(drawn, dealing.variants(name), strict=True)):
        assert question.get("type") == kind
        assert question.find("name/text").text == f"{name} {number:02}: {exercise.title}"
        assert question.find("idnumber").text == f"{name}-{number:02}"
        assert question.find("tags/tag/text").text == f"robokin {dealing.version()}"
        assert len(question.findall("hint")) == 2  # so that there are three tries
        assert all(hint.find("text").text for hint in question.iter("hint"))
        text = question.find("questiontext/text").text  # as on the page; and how to write it
        filled = exercise.fill(exercise.text, variant.numbers)
        assert text.startswith(render_paragraphs(filled))
        assert ("decimal number" in text) == (kind != "multichoice")


@each("exercise", "exercises", Exercise, marks, lambda exercise: exercise.accept == "one")
def test_right_answers_pass_and_mistakes_do_not_and_are_named(exercise, questions):
    """As Moodle judges, field by field: in one field at least the mistake is named."""
    named, made, meant = 0, 0, candidates.outcomes(exercise)
    for question, variant in zip(
        questions(exercise.name), dealing.variants(exercise.name), strict=True
    ):
        fields = answers(question)
        for candidate in variant.candidates:
            found = list(map(judged, fields, candidate.rows[0]))
            passed = all(right for right, _ in found)
            assert passed == (candidate.name == "right"), (variant.numbers, candidate)
            if candidate.name in {m.name for m in exercise.wrong}:
                made += 1
                says = render_symbols(meant[candidate.name].feedback).replace("&#x27;", "'")
                named += any(not right and says in told for right, told in found)
    assert named >= TOLD * made, (
        f"of {made} answers with a mistake {named} are named in Moodle, at least {TOLD:.0%} must "
        "be: in the others another answer stands too near in every field"
    )
    assert made or not exercise.wrong


def test_an_angle_may_be_off_by_a_turn_and_be_in_degrees(questions):
    first = questions("elbow-arm-1")[0]
    (field,) = answers(first)
    right = float(field[0][1])
    for turns in (-1, 0, 1):
        assert judged(field, right + 2 * np.pi * turns) == (True, candidates.RIGHT)
    assert "The right value in °" in judged(field, np.degrees(right))[1]
    assert judged(field, right + 5e-3) == (False, judging.format_feedback("near", digits=""))
    assert judged(field, 1e6) == (False, judging.format_feedback("wrong"))
    units = first.find("units")
    found = {u.find("unit_name").text: float(u.find("multiplier").text) for u in units}
    turns = pytest.approx(1 / (2 * np.pi))
    assert found == {"rad": 1, "°": pytest.approx(180 / np.pi), "turns": turns}


@each("exercise", "exercises", Exercise, only=lambda exercise: exercise.accept != "one")
def test_several_right_answers_are_a_choice(exercise, questions):
    few, most = 1 + moodle.FEWEST_CHOICES, 1 + moodle.MOST_CHOICES
    for question, variant in zip(
        questions(exercise.name), dealing.variants(exercise.name), strict=True
    ):
        found = {
            answer.find("text").text: answer.get("fraction")
            for answer in question.findall("answer")
        }
        right = exercise.format_rows(variant.candidates[0].rows)
        assert [text for text, part in found.items() if part == "100"] == [right]
        assert few <= len(found) <= most, (
            f"{exercise.name} offers {len(found)} answers for {variant.numbers}, allowed {few} to "
            f"{most}: add mistakes or `also`"
        )
        assert set(found.values()) == {"100", "0"}


def test_blanks_are_kept_and_nothing_is_overwritten(folder, capsys):
    assert run("moodle", "--only", "differential-drive-1", "elbow-arm-5") == 0
    text = (folder / "moodle.xml").read_text()
    assert "<text><![CDATA[<p>The wheels" in text
    assert text.count("<question type=") == 2 + 2 * dealing.VARIANTS
    assert run("moodle", "--only", "differential-drive-1") == 2
    assert "already there" in capsys.readouterr().err
    assert run("moodle", "--only", "differential-drive-1", "--force") == 0


def test_a_secret_draws_other_questions(folder):
    (folder / "roster.csv").write_text("student\nAda\n")
    assert run("key", "roster.csv", "--secret", "secret.txt", "--only", "wheels-5") == 0
    for secret in ((), ("--secret", "secret.txt")):
        assert run("moodle", "--only", "wheels-5", "--out", f"{len(secret)}.xml", *secret) == 0
    public, own = (
        {text.text for text in ElementTree.parse(f"{n}.xml").iterfind("question/questiontext/text")}
        for n in (0, 2)
    )
    assert not public & own
    assert " secret/wheels/wheels-5]]" in (folder / "2.xml").read_text()
