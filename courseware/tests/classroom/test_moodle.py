"""The questions for Moodle, read back by the grammar of its importer."""

import re
from functools import cache
from html import unescape
from types import SimpleNamespace
from xml.etree import ElementTree

import numpy as np
import pytest
from commands import run
from declared import EXERCISES, OF_EACH_KIND, each

from courseware.classroom import moodle, moodle_answers
from courseware.practice import Exercise, candidates, judging, variants
from courseware.units import ROWS, UNITS
from courseware.units.formatting import render_paragraphs, render_symbols

FIELD = re.compile(r"\{1:NUMERICAL:((?:\\.|[^}])*)\}")
NUMBER = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
ANSWER = re.compile(rf"(=?)({NUMBER}):({NUMBER})#(.+)")
WHICH = re.compile(r"the one whose (.+) is (largest|smallest|farthest from 0|nearest to 0)")
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
                    float(each.find("text").text),
                    float(each.find("tolerance").text),
                    each.find("feedback/text").text,
                )
                for each in question.iter("answer")
            ]
        ]
    text = question.find("questiontext/text").text.replace(moodle.STYLE, "")
    found = []
    for field in FIELD.findall(text):
        parts = [ANSWER.fullmatch(part) for part in re.split(UNESCAPED, field)]
        found.append([(bool(p[1]), float(p[2]), float(p[3]), p[4]) for p in parts])
    assert text.count("{") == len(found)
    return found


def judged(field, value):
    """What Moodle makes of a number: the first answer that fits."""
    return next(
        (right, says)
        for right, wanted, tolerance, says in field
        if abs(wanted - value) <= tolerance
    )


def by_the_words(exercise, question, rows):
    """The rows that a student may give who follows the words of a question: mostly one."""
    rule = WHICH.search(question.find("questiontext/text").text)
    if not rule:
        return rows
    (place,) = (k for k, u in enumerate(exercise.unknowns) if render_symbols(u.label) == rule[1])
    values = np.array([row[place] for row in rows])
    if exercise.unknowns[place].circle:
        values = np.arctan2(np.sin(values), np.cos(values))
    rank = {
        "largest": -values,
        "smallest": values,
        "farthest from 0": -abs(values),
        "nearest to 0": abs(values),
    }[rule[2]]
    # 5e-3: who works with three decimals cannot tell numbers apart that are nearer
    return [row for row, order in zip(rows, rank, strict=True) if order < min(rank) + 5e-3]


def rows_of(variant, name):
    return [row for c in variant.candidates if c.name == name for row in c.rows]


def test_every_exercise_is_asked(folder, monkeypatch):
    none = SimpleNamespace(all_variants=lambda *_: [], version=lambda: "")  # how, is tested below
    monkeypatch.setattr(moodle, "variants", none)
    assert run("moodle", "--out", "all.xml") == 0
    groups = ElementTree.parse("all.xml").iterfind("question[@type='category']/category/text")
    assert [group.text.split("/")[-1] for group in groups] == list(EXERCISES)


@each_exercise
def test_an_exercise_is_asked_in_all_variants(exercise, questions):
    drawn, name = questions(exercise.name), exercise.name
    assert len(drawn) == variants.VARIANTS
    kind = "cloze" if len(exercise.unknowns) > 1 else "numerical"
    for number, (question, variant) in enumerate(
        zip(drawn, variants.all_variants(name), strict=True)
    ):
        assert question.get("type") == kind
        assert question.find("name/text").text == f"{name} {number:02}: {exercise.title}"
        assert len(question.findall("hint")) == 2  # so that there are three tries
        # how many parts are right would take the place of the mistake
        assert [len(hint) for hint in question.iter("hint")] == [1, 1]
        assert all(hint.find("text").text for hint in question.iter("hint"))
        text = question.find("questiontext/text").text  # as on the page; and how to write it
        filled = exercise.fill(exercise.text, variant.numbers)
        assert render_paragraphs(filled) in text
        assert "decimal number" in text


@each_exercise
def test_a_moodle_from_right_to_left_keeps_the_order(exercise, questions):
    for question in questions(exercise.name):
        texts = [question.find("questiontext/text"), question.find("generalfeedback/text")]
        for text in [*texts, *question.iterfind("hint/text")]:
            assert text.text.startswith('<div dir="ltr"')
        for field in answers(question):
            assert all(re.match('<(div|span) dir="ltr"', told) for *_, told in field)


@each_exercise
def test_right_answers_pass_and_mistakes_do_not_and_are_named(exercise, questions):
    """As Moodle judges, field by field: in one field at least the mistake is named."""
    named, made, meant = 0, 0, candidates.outcomes(exercise)
    for question, variant in zip(
        questions(exercise.name), variants.all_variants(exercise.name), strict=True
    ):
        fields, rights = answers(question), rows_of(variant, "right")
        (asked,) = by_the_words(exercise, question, rights)
        for row in rights:
            right = all(right for right, _ in map(judged, fields, row))
            assert right == (row == asked), variant.numbers
        for name in {c.name for c in variant.candidates} - {"right"}:
            for row in by_the_words(exercise, question, rows_of(variant, name)):
                found = list(map(judged, fields, row))
                assert not all(right for right, _ in found), (variant.numbers, name)
                if name in {m.name for m in exercise.wrong}:
                    made += 1
                    says = render_symbols(meant[name].feedback).replace("&#x27;", "'")
                    named += any(not right and says in told for right, told in found)
    assert named >= TOLD * made, (
        f"of {made} answers with a mistake {named} are named in Moodle, at least {TOLD:.0%} must "
        "be: in the others another answer is too near in every field"
    )
    assert made or not exercise.wrong


@each(
    "exercise", "exercises", Exercise, marks, lambda e: len(e.unknowns) == 1 and e.unknowns[0].unit
)
def test_a_unit_is_demanded_and_read_as_on_the_page(exercise, questions):
    """Moodle ignores a unit that it does not know, unless units count: then it gives no marks."""
    variant = variants.all_variants(exercise.name)[0]
    first, right = questions(exercise.name)[0], variant.candidates[0].rows[0][0]
    form = {name: first.find(name).text for name in ("unitgradingtype", "unitpenalty", "showunits")}
    assert form == {"unitgradingtype": "1", "unitpenalty": "1", "showunits": "0"}
    sizes = {u.find("unit_name").text: float(u.find("multiplier").text) for u in first.iter("unit")}
    assert next(iter(sizes)) == exercise.unknowns[0].unit
    assert not any(re.match(r"[\d.,+-]|e\d", unit) for unit in sizes)  # it would join the number
    for unit, size in sizes.items():
        verdict = judging.judge(exercise, variant.candidates, f"{right * size:.9f} {unit}")
        assert verdict.result == "right", unit
    text = unescape(re.sub("<.*?>", "", first.find("questiontext/text").text))
    assert f"The unit is {exercise.unknowns[0].unit}" in text
    assert "Without it there are no marks" in text


@pytest.mark.parametrize("name", [name for name in UNITS if name])
def test_every_unit_can_be_typed_on_every_keyboard(name):
    row = ROWS[name]
    sizes = moodle.unit_sizes(SimpleNamespace(unit=row[0].name))
    same = [word for word, size in sizes.items() if size == UNITS[name].from_si(1.0)]
    assert any(map(str.isascii, same))


def test_an_angle_may_be_off_by_a_turn_and_in_another_unit(questions):
    first = questions("elbow-arm-1")[0]
    (field,) = answers(first)
    right = field[0][1]
    for turns in (-1, 0, 1):
        assert moodle.NUMBER_RIGHT in judged(field, right + 2 * np.pi * turns)[1]
    assert "The right value in °" in judged(field, np.degrees(right))[1]
    assert judging.format_feedback("near", digits="") in judged(field, right + 5e-3)[1]
    assert judging.format_feedback("wrong") in judged(field, 1e6)[1]
    sizes = {u.find("unit_name").text: float(u.find("multiplier").text) for u in first.iter("unit")}
    assert sizes["deg"] == sizes["°"] == pytest.approx(180 / np.pi)
    assert sizes["turns"] == pytest.approx(1 / (2 * np.pi))


@each("exercise", "exercises", Exercise, marks, lambda exercise: len(exercise.unknowns) > 1)
def test_fields_tell_nothing_and_mistakes_are_told_without_pointing(exercise, questions):
    meant = candidates.outcomes(exercise)
    for question in questions(exercise.name):
        for field in answers(question):
            # a field is as wide as the longest of its answers, written by PHP with 14 digits
            longest = max(field, key=lambda answer: len(f"{answer[1]:.14g}"))
            assert longest == field[-1]
            assert judging.format_feedback("wrong") in longest[3]
        told = question.find("generalfeedback/text").text
        for mistake in exercise.wrong:
            assert render_symbols(meant[mistake.name].feedback.partition("Not yet. ")[2]) in told


def test_a_slip_in_a_field_is_named(questions):
    """v = 0 takes no slip; of 0.5 the half is told, and the sign."""
    question = questions("differential-drive-2")[0]
    for field in answers(question):
        right = field[0][1]
        for name, factor in moodle_answers.FACTORS.items():
            known, told = judged(field, factor * right)
            assert known == (right == 0)
            assert right == 0 or candidates.SLIPS[name] in told or "This is what you get" in told


def test_blanks_are_kept_and_nothing_is_overwritten(folder, capsys):
    assert run("moodle", "--only", "differential-drive-1", "elbow-arm-5") == 0
    text = (folder / "moodle.xml").read_text()
    assert 'left"><p>The wheels' in text
    assert text.count("<question type=") == 2 + 2 * variants.VARIANTS
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
