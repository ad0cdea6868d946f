"""The questions for Moodle, read back by the grammar of its importer."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from declared import EXERCISES
from test_teacher import folder, run  # noqa: F401

from workshop.practice import dealing, judging, moodle

FIELD = re.compile(r"\{1:NUMERICAL:((?:\\.|[^}])*)\}")
NUMBER = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
ANSWER = re.compile(rf"(=?)(\*|({NUMBER}):({NUMBER}))#(.+)")
UNESCAPED = r"(?<!\\)~"  # between the answers of a field
TOLD = 0.95  # of the mistakes, at least


@pytest.fixture(scope="module")
def quiz(tmp_path_factory):
    """All questions as Moodle's importer sees them, by exercise."""
    path = tmp_path_factory.mktemp("moodle") / "quiz.xml"
    assert run("moodle", "--out", path) == 0
    found, name = {}, ""
    for question in ElementTree.parse(path).getroot():
        if question.get("type") == "category":
            name = question.find("category/text").text.split("/")[-1]
        else:
            found.setdefault(name, []).append(question)
    return found


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


def test_every_exercise_is_asked_in_all_variants(quiz):
    assert quiz.keys() == EXERCISES.keys()
    for name, questions in quiz.items():
        assert len(questions) == dealing.VARIANTS
        kinds = {question.get("type") for question in questions}
        exercise = EXERCISES[name]
        several = "cloze" if len(exercise.asks) > 1 else "numerical"
        assert kinds == {several if exercise.accept == "one" else "multichoice"}
        for number, question in enumerate(questions):
            assert question.find("name/text").text == f"{name} {number:02}: {exercise.title}"
            assert question.find("idnumber").text == f"{name}-{number:02}"
            assert question.find("tags/tag/text").text == f"robokin {dealing.version()}"
            assert len(question.findall("hint")) == 2  # so that there are three tries
            assert all(hint.find("text").text for hint in question.iter("hint"))


def test_the_text_is_that_of_the_page_and_says_how_to_write(quiz):
    for name, questions in quiz.items():
        exercise = EXERCISES[name]
        for question, variant in zip(questions, dealing.variants(name), strict=True):
            text = question.find("questiontext/text").text
            filled = exercise.filled(exercise.text, variant.numbers, variant.shown)
            assert text.startswith(moodle.paragraphs(filled))
            assert ("decimal number" in text) == (question.get("type") != "multichoice")


def test_right_answers_pass_and_mistakes_do_not_and_are_named(quiz):
    """As Moodle judges, field by field: in one field at least the mistake is named."""
    named, made = 0, 0
    for name, questions in quiz.items():
        exercise = EXERCISES[name]
        meant = judging.outcomes(exercise)
        for question, variant in zip(questions, dealing.variants(name), strict=True):
            if exercise.accept != "one":
                continue
            fields = answers(question)
            for candidate in variant.candidates:
                found = list(map(judged, fields, candidate.rows[0]))
                passed = all(right for right, _ in found)
                assert passed == (candidate.name == "right"), (name, candidate)
                if candidate.name in {m.name for m in exercise.wrong}:
                    made += 1
                    says = moodle.symbols(meant[candidate.name].says).replace("&#x27;", "'")
                    named += any(not right and says in told for right, told in found)
    assert named >= TOLD * made > 0


def test_an_angle_may_be_off_by_a_turn_and_be_in_degrees(quiz):
    (field,) = answers(quiz["elbow-arm-1"][0])
    right = float(field[0][1])
    for turns in (-1, 0, 1):
        assert judged(field, right + 2 * np.pi * turns) == (True, judging.RIGHT)
    assert "The right value in °" in judged(field, np.degrees(right))[1]
    assert judged(field, right + 5e-3) == (False, judging.says("near", digits=""))
    assert judged(field, 1e6) == (False, judging.says("wrong"))
    units = quiz["elbow-arm-1"][0].find("units")
    found = {u.find("unit_name").text: float(u.find("multiplier").text) for u in units}
    assert found == {"rad": 1, "°": pytest.approx(180 / np.pi)}


def test_several_right_answers_are_a_choice(quiz):
    for name, questions in quiz.items():
        exercise = EXERCISES[name]
        if exercise.accept == "one":
            continue
        for question, variant in zip(questions, dealing.variants(name), strict=True):
            found = {
                answer.find("text").text: answer.get("fraction")
                for answer in question.findall("answer")
            }
            right = variant.candidates[0].rows
            assert [text for text, part in found.items() if part == "100"] == [
                exercise.rows_text(right)
            ]
            assert 1 + moodle.FEW <= len(found) <= 1 + moodle.CHOICES
            assert set(found.values()) == {"100", "0"}


def test_blanks_are_kept_and_nothing_is_overwritten(folder, capsys):  # noqa: F811
    assert run("moodle", "--only", "differential-drive-1", "elbow-arm-5") == 0
    text = (folder / "moodle.xml").read_text()
    assert "<text><![CDATA[<p>The wheels" in text
    assert text.count("<question type=") == 2 + 2 * dealing.VARIANTS
    assert run("moodle", "--only", "differential-drive-1") == 2
    assert "already there" in capsys.readouterr().err
    assert run("moodle", "--only", "differential-drive-1", "--force") == 0


def test_a_secret_draws_other_questions(folder):  # noqa: F811
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
