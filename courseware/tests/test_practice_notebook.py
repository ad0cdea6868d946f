"""Exercises in a notebook: a box with the student's numbers, checks from code, the export."""

from datetime import UTC, datetime

import numpy as np
import pytest
from declared import COURSE, table, typed

from courseware import practice
from courseware.errors import CourseError
from courseware.practice import candidates, notebook, variants


@pytest.fixture
def nobody(monkeypatch):
    """No answers yet, no name given."""
    monkeypatch.setattr(notebook, "_answers", {})
    monkeypatch.setattr(notebook, "_session", {"student": "", "course": ""})


def test_a_box_has_the_student_s_numbers(nobody):
    box = practice.exercise("differential-drive-1", student="Ada")
    number = variants.choose_variant(COURSE, "differential-drive-1", "Ada")
    assert box.variant is variants.all_variants("differential-drive-1")[number]
    assert box.exercise.format_given(box.variant.numbers)["b"] in box.text
    assert repr(box.check(box.variant.candidates[0].rows[0][0])) == candidates.RIGHT
    practice.student(" Ada ")
    assert practice.exercise("differential-drive-1").variant is box.variant


def test_a_mistake_is_named(nobody):
    box = practice.exercise("differential-drive-1", student="Ada")
    b, v_L, v_R = (box.variant.numbers[name] for name in ("b", "v_L", "v_R"))
    verdict = box.check((v_R - v_L) / (b / 2))
    assert (verdict.result, verdict.name) == ("wrong", "M12")
    assert "half the wheel distance" in repr(verdict)
    assert box.check(np.degrees((v_R - v_L) / b)).result == "partly"
    assert box.check("0.5 m/s").result == "unread"
    assert box.check([1, 2]).result == "unread"
    assert box.check(np.array([(v_R - v_L) / b])).result == "right"


def test_answers_are_exported_as_grade_reads_them(nobody, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(CourseError, match="no answers yet"):
        practice.export()
    box = practice.exercise("differential-drive-1", student="=Ada, 1")
    box.check("nonsense")
    box.check("7")
    box.check("-1/3")
    path = practice.export()
    [row] = table(path)
    wanted = {"student": "=Ada, 1", "exercise": "differential-drive-1", "answer": "-1/3"}
    wanted |= {"tries": "2", "help": "0"}
    assert datetime.fromisoformat(row.pop("time")).tzinfo == UTC
    assert row == {"kind": "answers", "course": "robokin", "version": variants.version(), **wanted}
    with pytest.raises(CourseError, match="already there"):
        practice.export(path)


@pytest.mark.parametrize(
    "answer",
    [None, 1j, [[1, 2], [3]], ["a"], 10**400, np.nan, []],
    ids=str,
)
def test_what_is_no_answer_is_unread(nobody, answer):
    verdict = practice.exercise("differential-drive-1", student="Ada").check(answer)
    assert verdict.result == "unread"
    assert verdict.feedback
    assert not notebook._answers


def test_a_further_try_takes_nothing_away(nobody):
    box = practice.exercise("differential-drive-1", student="Ada")
    right = typed(box.variant.candidates[0].rows, box.exercise)
    for tried in ("12345", right, "12345"):
        box.check(tried)
    assert [kept.answer for kept in notebook._answers.values()] == [right]


def test_a_column_counts_as_a_list(nobody):
    box = practice.exercise("differential-drive-2", student=4711)
    assert box.check(np.reshape(box.variant.candidates[0].rows[0], (2, 1))).result == "right"


def test_answers_of_nobody_are_not_exported(nobody, tmp_path):
    practice.exercise("differential-drive-1").check(1)
    with pytest.raises(CourseError, match="say who you are first"):
        practice.export(tmp_path / "answers.csv")


def test_unknown_names_are_refused():
    with pytest.raises(CourseError, match=r"no exercise 'drive-1'; there are .*drive-1"):
        practice.exercise("drive-1")
    with pytest.raises(CourseError, match=r"no mistake 'M99'; there are .*M12"):
        practice.mistake("M99")
