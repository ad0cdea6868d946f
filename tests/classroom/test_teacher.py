"""For the teacher: keys, sheets, grades, and folders in which everything lies."""

import csv
import io
import json
import random
import re
import subprocess
import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from declared import EXERCISES, each, table
from support import ROOT
from test_practice import typed

from courseware.practice import Exercise, dealing, judging, notebook, tables, teacher
from courseware.practice.command import main
from courseware.script import engine

ONE = "differential-drive-1"
ONLY = ("--only", ONE, "differential-drive-2")
HEADING = "student,exercise,answer"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(*arguments):
    return main([str(a) for a in arguments])


@pytest.fixture
def keyed(folder, capsys):
    """A folder with a roster and a key for Ada and Bob."""
    (folder / "roster.csv").write_text("student\nAda\nBob\n")
    assert run("key", "roster.csv", *ONLY) == 0
    capsys.readouterr()
    return folder


def saved(student, answers, times=None, course="robokin"):
    """The file that the page saves, by the page's own writer."""
    entries = {
        name: {"answer": answer, "time": (times or {}).get(name, "2026-03-01T10:00:00.000Z")}
        for name, answer in answers.items()
    }
    head = {"course": course, "version": dealing.version()}
    return "\ufeff" + engine.call("courseware.practice.answersCsv", head, student, entries)


CELLS = [
    "=1+1",
    "-v/2",
    "-0.5",
    "+3",
    "'=1",
    "''-x",
    "'",
    "@sum",
    "\t0.5",
    "\r1",
    'a "1"; 2, 3',
    "سه",
    " 1 ",
]


@pytest.mark.parametrize("cell", CELLS)
def test_a_saved_answer_comes_back_as_it_was(folder, cell):
    """To the page and to `grade`; in the file it is nothing that a spreadsheet would run."""
    text = saved("=Ada", {ONE: cell})
    *_, (*_, in_file) = csv.reader(io.StringIO(text, newline=""))
    assert in_file[0] not in "=+-@\t\r" or in_file in ("-0.5", "+3")
    (back,) = engine.call("courseware.practice.answersOf", text)
    assert (back["student"], back["answer"]) == ("=Ada", cell)
    (folder / "answers.csv").write_text(text, encoding="utf-8", newline="")
    ((_, row),) = tables.rows(Path("answers.csv"), tables.Problems(), ["student", "answer"])
    assert (row["student"], row["answer"]) == ("=Ada", cell.strip())


def test_an_answer_in_several_lines_whose_row_looks_like_a_heading(keyed):
    """The name of its student holds that of a column."""
    (keyed / "answers.csv").write_text(f'{HEADING}\nstudent12,{ONE},"[1,\n2,\n3]"\nAda,{ONE},5\n')
    problems = tables.Problems()
    found = list(tables.rows(Path("answers.csv"), problems, HEADING.split(",")))
    assert [(row["student"], row["answer"]) for _, row in found] == [
        ("student12", "[1,\n2,\n3]"),
        ("Ada", "5"),
    ]
    assert not problems.lines()


def test_the_class_page_never_takes_the_place_of_the_grades(keyed, capsys):
    for out in ("grades.html", ".", ""):
        assert run("grade", "key.csv", "--key", "key.csv", "--out", out) == 2
        assert "give one that ends in .csv" in capsys.readouterr().err
    assert not (keyed / "grades.html").exists()


def test_a_damaged_key_makes_no_sheet_and_says_why(keyed, capsys):
    key = (keyed / "key.csv").read_text("utf-8")
    for damaged in (key.replace("{", "{,"), re.sub(r'""\w+"": ', '""none"": ', key)):
        assert damaged != key
        (keyed / "damaged.csv").write_text(damaged, "utf-8")
        assert run("sheet", "damaged.csv", "--force") == 2
        assert f"numbers of {ONE} that cannot be used" in capsys.readouterr().err


def test_a_class_list_is_no_secret(folder, capsys):
    (folder / "roster.csv").write_text("student\n" + "Ada Lovelace\n" * 9)
    assert run("key", "roster.csv", "--secret", "roster.csv") == 2
    assert "must be one word" in capsys.readouterr().err


def results():
    return {(row["student"], row["exercise"]): row["result"] for row in table("grades.csv")}


# --- keys and sheets ------------------------------------------------------------------------


def test_key_sheets_and_grades(folder, capsys):
    (folder / "roster.csv").write_text("student,group\nAda,1\nسارا,2\n=1+1,3\n", encoding="utf-8")
    assert run("key", "roster.csv", "--course", "2026", *ONLY) == 0
    assert run("sheet", "key.csv") == 0
    rows = table("key.csv")
    assert [row["student"] for row in rows[::2]] == ["Ada", "سارا", "=1+1"]
    sheets = sorted((folder / "sheets").iterdir())
    assert len(sheets) == 3
    for row in rows:
        variant = dealing.variants(row["exercise"])[int(row["variant"])]
        assert json.loads(row["numbers"]) == variant.numbers
    assert not any(row["answer"].split(" ")[0] in s.read_text() for s in sheets for row in rows)

    answers = [  # right, half the wheel distance, in degrees, words, nothing
        ("Ada", ONE, rows[0]["answer"].split(" ")[0]),
        ("Ada", "differential-drive-2", "no idea"),
        ("سارا", ONE, str(wrong(rows[2], "M12"))),
        ("=1+1", ONE, str(wrong(rows[4], "unit:degrees"))),
    ]
    tables.write("answers.csv", ("student", "exercise", "answer"), answers)
    capsys.readouterr()
    assert run("grade", "answers.csv", "--key", "key.csv") == 0
    assert "half the wheel distance" in capsys.readouterr().out
    graded = table("grades.csv")
    found = [row["result"] for row in graded]
    assert found == ["right", "unread", "wrong", "missing", "partly", "missing"]
    assert [row["mistake"] for row in graded] == ["right", "", "M12", "", "unit:degrees", ""]
    totals = table("grades-students.csv")
    assert totals[2] == dict(zip(teacher.TOTALS, ["=1+1", "0", "1", "0", "0", "1"], strict=True))
    assert table("grades-problems.csv") == []


def wrong(row, name):
    """What a candidate of the student's variant answers."""
    variant = dealing.variants(row["exercise"])[int(row["variant"])]
    return next(c.rows[0][0] for c in variant.candidates if c.name == name)


def test_nothing_is_overwritten(keyed, capsys):
    for command, source, out in (("key", "roster.csv", "key.csv"), ("sheet", "key.csv", "sheets")):
        run(command, source, "--out", out, *(ONLY if command == "key" else ()))
        assert run(command, source, "--out", out) == 2
        assert "already there" in capsys.readouterr().err
        assert run(command, source, "--out", out, "--force") == 0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("name\nAda\n", "no column student; needed are student, its first line has name"),
        ("", "no column student; needed are student, its first line has nothing"),
        ("student\n\n", "names no student"),
    ],
)
def test_a_table_that_cannot_be_used_is_refused(folder, capsys, text, words):
    (folder / "roster.csv").write_text(text)
    assert run("key", "roster.csv") == 2
    assert words in capsys.readouterr().err
    assert [path.name for path in folder.iterdir()] == ["roster.csv"]


def test_what_is_read_is_not_overwritten(keyed, capsys):
    assert run("key", "roster.csv", "--out", "roster.csv", "--force") == 2
    assert "roster.csv is what is read" in capsys.readouterr().err
    assert run("sheet", "key.csv", "--out", "roster.csv") == 2
    assert "roster.csv is a file" in capsys.readouterr().err
    assert run("grade", ".", "--key", "key.csv", "--out", "key.csv", "--force") == 2
    assert "key.csv is what is read" in capsys.readouterr().err


def test_a_missing_file_is_refused(folder, capsys):
    assert run("key", "nowhere.csv") == 2
    assert "nowhere.csv cannot be read: No such file" in capsys.readouterr().err


def test_what_the_system_refuses_is_told_without_a_traceback(keyed, capsys, monkeypatch):
    def full(*_, **__):
        raise OSError(28, "No space left on device", "key.csv")

    monkeypatch.setattr(tables.Path, "replace", full)
    assert run("key", "roster.csv", "--force", *ONLY) == 2
    assert "key.csv: No space left on device; not finished" in capsys.readouterr().err
    assert len(table("key.csv")) == 4  # the old one is whole


@pytest.mark.parametrize(
    "cell", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@sum", "\tx", "'quoted", "−1"]
)
def test_no_cell_is_a_formula(folder, cell):
    tables.write("t.csv", ("student", "n"), [(cell, "-0.5")])
    with open("t.csv", encoding="utf-8-sig", newline="") as file:
        first, number = list(csv.reader(file))[1]
    assert first[0] not in "=+-@\t\r"
    assert number == "-0.5"
    assert table("t.csv")[0]["student"] == cell.strip()


@pytest.mark.slow
def test_a_thousand_students(folder):
    """All exercises of all; the time is in the note of the release, not tested here."""
    people = "\n".join(f"student {k}" for k in range(1000))
    (folder / "roster.csv").write_text(f"student\n{people}\n")
    assert run("key", "roster.csv") == 0
    assert len(table("key.csv")) == 1000 * len(EXERCISES)


# --- a secret -------------------------------------------------------------------------------


def test_a_secret_deals_numbers_that_are_on_no_page(keyed):
    """Also to those who are enrolled later, and the numbers of the others stay."""
    few = ("--only", ONE, "wheels-5")  # the second has few numbers
    assert run("key", "roster.csv", "--out", "exam.csv", "--secret", "secret.txt", *few) == 0
    exam = table("exam.csv")
    for row in exam:
        public = [variant.numbers for variant in dealing.variants(row["exercise"])]
        assert json.loads(row["numbers"]) not in public
    (keyed / "roster.csv").write_text("student\nEve\nAda\nBob\n")
    again = ("--secret", "secret.txt", "--force", *few)
    assert run("key", "roster.csv", "--out", "exam.csv", *again) == 0
    assert [row for row in table("exam.csv") if row["student"] != "Eve"] == exam
    (keyed / "secret.txt").unlink()
    assert run("key", "roster.csv", "--out", "other.csv", "--secret", "secret.txt", *few) == 0
    assert table("other.csv") != table("exam.csv")


@pytest.mark.slow
@each("exercise", "exercises", Exercise)
def test_a_secret_finds_numbers_for_every_exercise(exercise):
    """Whatever it draws: no mistake ends in an error, no exercise is left with a handful."""
    public = {tuple(variant.shown.values()) for variant in dealing.variants(exercise.name)}
    for secret in map(str, range(10**15, 10**15 + 5)):
        dealt = dealing.variants(exercise.name, secret)
        own = {tuple(variant.shown.values()) for variant in dealt}
        assert len(own) >= 14, (
            f"with a secret {exercise.name} has {len(own)} sets of numbers, at least 14 are "
            "needed: more options in `given`"
        )
        assert not public & own


def test_a_secret_must_be_one(keyed, capsys):
    (keyed / "secret.txt").write_text("cat")
    assert run("key", "roster.csv", "--force", "--secret", "secret.txt") == 2
    assert (
        "the secret in secret.txt has 3 characters, which can be guessed" in capsys.readouterr().err
    )
    assert run("moodle", "--secret", "nowhere.txt") == 2
    assert "`key --secret` makes one" in capsys.readouterr().err
    assert not (keyed / "nowhere.txt").exists()


def test_answers_of_the_page_are_none_to_the_numbers_of_a_secret(keyed, capsys):
    """Who practises on the page and hands in that file too loses nothing."""
    assert run("key", "roster.csv", "--out", "exam.csv", "--secret", "secret.txt", *ONLY) == 0
    mine = next(row for row in table("exam.csv") if row["student"] == "Ada")
    right = mine["answer"].split(" ")[0].replace("−", "-")
    (keyed / "sheet.csv").write_text(saved("Ada", {ONE: right}, course=mine["course"]))
    later = {ONE: "2026-04-01T10:00:00Z"}
    (keyed / "page.csv").write_text(saved("Ada", {ONE: "7"}, later))
    assert run("grade", ".", "--key", "exam.csv") == 1
    assert "answers of another course: 1" in capsys.readouterr().err
    assert results()["Ada", ONE] == "right"


def test_a_sheet_shows_the_numbers_of_the_key(keyed):
    """As the page shows them, for every exercise."""
    assert run("key", "roster.csv", "--force") == 0
    assert run("sheet", "key.csv") == 0
    page = next((keyed / "sheets").glob("Ada*")).read_text()
    for row in table("key.csv"):
        if row["student"] == "Ada":
            variant = dealing.variants(row["exercise"])[int(row["variant"])]
            exercise = EXERCISES[row["exercise"]]
            text = exercise.filled(exercise.text, variant.numbers, variant.shown)
            assert teacher.paragraphs(text) in page


# --- a folder in which everything lies ------------------------------------------------------


def test_bad_lines_are_told_and_the_good_ones_graded(folder, capsys):
    (folder / "roster.csv").write_bytes("student\nAda\nAda \n\nBob\n\xff\xfe\n".encode("latin-1"))
    assert run("key", "roster.csv", *ONLY) == 1
    assert capsys.readouterr().err.splitlines() == [
        "students named twice: 1",
        "  roster.csv, line 3: Ada is in line 2 already",
        "lines not in UTF-8: save the file as CSV UTF-8: 1",
        "  roster.csv, line 6",
    ]
    lines = [
        "student;exercise;answer;course;time",
        f"Ada;{ONE};0,5;robokin;",
        f"Eve;{ONE};0.5;robokin;",
        "Ada;differential-drive-9;0.5;robokin;",
        f"Bob;{ONE};;robokin;",
        f"Bob;{ONE};1",
        f"Bob;{ONE};1;last year;",
        f"Ada;{ONE};0.6;robokin;yesterday",
        f";{ONE};0.6;robokin;",
    ]
    (folder / "answers.csv").write_text("\n".join(lines), encoding="utf-16")
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    assert capsys.readouterr().err.splitlines() == [
        "answers of students who are not in the key: 1",
        "  answers.csv, line 3: 'Eve'",
        "answers to exercises that are not in the student's key: 1",
        "  answers.csv, line 4: Ada has no exercise 'differential-drive-9'",
        "empty answers: 1",
        f"  answers.csv, line 5: Bob, {ONE}",
        "lines with more or fewer cells than the heading: 1",
        "  answers.csv, line 6: 3 cells, the heading has 5",
        "answers of another course: 1",
        "  answers.csv, line 7: the course is 'last year', the key's is 'robokin'",
        "times that cannot be read: 1",
        "  answers.csv, line 8: 'yesterday'",
        "answers replaced by one read later (no time tells): 1",
        f"  answers.csv, line 2: Ada, {ONE}: '0,5' without a time, counts '0.6' without a time"
        " (answers.csv, line 8)",
        "answers without a name: 1",
        "  answers.csv, line 9",
    ]
    assert table("grades.csv")[0]["answer"] == "0.6"
    told = table("grades-problems.csv")
    assert [row["line"] for row in told] == ["3", "4", "5", "6", "7", "8", "2", "9"]
    assert told[0]["answer"] == "0.5"  # nothing is lost


def test_key_roster_and_old_grades_are_no_answers(keyed, capsys):
    """All in one folder: what Bob did not hand in is missing, and an old grade counts nothing."""
    (keyed / "answers-Ada.csv").write_text(saved("Ada", {ONE: "7"}))
    assert run("grade", ".", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert (
        "tables that are no answers, left out: 1\n  roster.csv: columns student, 2 lines"
        in told.err
    )
    assert set(results().values()) == {"wrong", "missing"}
    for old in ("grades.csv", "key.csv"):
        (keyed / f"old-{old}").write_bytes((keyed / old).read_bytes())
    assert run("sheet", "key.csv") == 0
    (keyed / "answers-Bob.zip").write_bytes(b"PK")
    assert run("grade", ".", "--key", "key.csv", "--out", "second.csv") == 1
    told = capsys.readouterr().err
    assert "tables that are no answers, left out: 7" in told
    told_of = {row["file"]: row["comment"] for row in table("second-problems.csv")}
    assert told_of["old-key.csv"].startswith("columns kind, course, version, student, exercise")
    assert told_of.keys() >= {f"grades-{n}.csv" for n in ("mistakes", "problems", "students")}
    assert "unpack archives" in told
    assert (keyed / "second.csv").read_bytes() == (keyed / "grades.csv").read_bytes()


def test_the_newest_answer_counts_whatever_its_file_is_called(keyed, capsys):
    first, second = {ONE: "2026-03-01T10:00:00.000Z"}, {ONE: "2026-03-01T10:00:01.000Z"}
    (keyed / "answers-Ada (1).csv").write_text(saved("Ada", {ONE: "2"}, second))
    (keyed / "answers-Ada.csv").write_text(saved("Ada", {ONE: "1"}, first))
    (keyed / "notes.csv").write_text(f"{HEADING}\nAda,{ONE},3\n")  # without a time: never newer
    (keyed / "zone.csv").write_text(f"{HEADING},time\nAda,{ONE},4,2026-03-01T10:59:00+01:00\n")
    assert run("grade", ".", "--key", "key.csv") == 1
    assert table("grades.csv")[0]["answer"] == "2"
    told = capsys.readouterr().err
    assert "answers replaced by a newer one: 3" in told
    assert (
        f"answers-Ada.csv, line 2: Ada, {ONE}: '1' of 2026-03-01 10:00:00, "
        "counts '2' of 2026-03-01 10:00:01 (answers-Ada (1).csv, line 2)"
    ) in told


def test_the_same_answer_twice_is_no_problem(keyed, capsys):
    for name in ("one.csv", "two.csv"):
        (keyed / name).write_text(saved("Ada", {ONE: "7"}))
    assert run("grade", "one.csv", "two.csv", "--key", "key.csv") == 0
    assert not capsys.readouterr().err


def test_problems_are_grouped_and_all_of_them_written(keyed, capsys):
    """Three thousand lines of last year's course are one group, and hide nothing else."""
    lines = [f"robokin-2025,Ada,{ONE},{k}" for k in range(3000)]
    lines.insert(1500, f"robokin,Eve,{ONE},5")
    lines.append(f"robokin,Bob,{ONE},6")
    (keyed / "all.csv").write_text(f"course,{HEADING}\n" + "\n".join(lines))
    assert run("grade", "all.csv", "--key", "key.csv") == 1
    assert capsys.readouterr().err.splitlines() == [
        "answers of another course: 3,000",
        "  all.csv, line 2: the course is 'robokin-2025', the key's is 'robokin'",
        "  … and 2,999 more",
        "answers of students who are not in the key: 1",
        "  all.csv, line 1502: 'Eve'",
    ]
    assert Counter(row["problem"] for row in table("grades-problems.csv")).total() == 3001


def test_the_wrong_course_alone_is_refused(keyed, capsys):
    (keyed / "answers.csv").write_text(saved("Ada", {ONE: "7"}, course="robokin-2025"))
    assert run("grade", "answers.csv", "--key", "key.csv") == 2
    told = capsys.readouterr().err
    assert told.startswith("no answer fits the key\nanswers of another course: 1\n")
    assert sorted(path.name for path in keyed.iterdir()) == [
        "answers.csv", "key.csv", "roster.csv",
    ]  # fmt: skip


def test_answers_to_another_version_are_told_and_count(keyed, capsys):
    text = saved("Ada", {ONE: "7"}).replace(dealing.version(), "0ldbank")
    (keyed / "answers.csv").write_text(text)
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    assert "another version of the exercises (they count): 1" in capsys.readouterr().err
    assert results()["Ada", ONE] == "wrong"


@pytest.mark.parametrize("files", [{}, {"a.csv": ""}, {"a.csv": HEADING}, {"a.pdf": "%PDF"}])
def test_nothing_handed_in_is_refused(keyed, capsys, files):
    (keyed / "answers").mkdir()
    for name, text in files.items():
        (keyed / "answers" / name).write_text(text)
    assert run("grade", "answers", "--key", "key.csv") == 2
    told = capsys.readouterr().err
    assert told.startswith("no answer fits the key")
    assert all(name in told for name in files)


def test_one_bad_file_does_not_stop_the_others(keyed, capsys):
    (keyed / "answers" / "Bob").mkdir(parents=True)
    good = f"sep=;\nstudent;exercise;answer\nBob;{ONE};7\n"
    (keyed / "answers" / "Bob" / "ANSWERS.CSV").write_text(good)
    (keyed / "answers" / "empty.csv").write_text("")
    (keyed / "answers" / "sheet.xlsx").write_bytes(b"PK")
    (keyed / "answers" / "odd.csv").write_bytes(b"\xff" * 3_000_000 + b"\n\0")
    open_quote = f'{HEADING}\nAda,{ONE},"0.5\nAda,{ONE},"1, 2"\nAda,differential-drive-2,"1, 2"'
    (keyed / "answers" / "open.csv").write_text(open_quote)
    for force in ((), ("--force",)):  # a second time, with the first grades beside the answers
        out = keyed / "answers" / "grades.csv"
        assert run("grade", "answers", "--key", "key.csv", "--out", out, *force) == 1
        told = capsys.readouterr()
        assert "empty.csv" in told.err
        assert "sheet.xlsx: .xlsx: unpack archives, save spreadsheets as CSV" in told.err
        assert "open.csv, line 2: a quotation mark is not closed" in told.err
        assert "read on after line 3" in told.err
        graded = {(r["student"], r["exercise"]): r["answer"] for r in table(out)}
        assert graded["Bob", ONE] == "7"
        assert graded["Ada", "differential-drive-2"] == "1, 2"


@pytest.mark.parametrize(
    "left", [".DS_Store", "~$answers-Ada.csv", "__MACOSX/._answers-Ada.csv", "Thumbs.db"]
)
def test_what_a_system_leaves_in_a_folder_is_passed_over(keyed, capsys, left):
    """An unpacked archive, a file that is open in a spreadsheet: they hide no real problem."""
    (keyed / "answers" / left).parent.mkdir(parents=True)
    (keyed / "answers" / "answers-Ada.csv").write_text(saved("Ada", {ONE: "7"}))
    (keyed / "answers" / left).write_bytes(b"\0\5\x16\7\xff")
    assert run("grade", "answers", "--key", "key.csv") == 0
    assert not capsys.readouterr().err


def test_a_hidden_table_is_read_like_any_other(keyed):
    (keyed / "answers").mkdir()
    (keyed / "answers" / ".answers-Ada.CSV").write_text(saved("Ada", {ONE: "7"}))
    assert run("grade", "answers", "--key", "key.csv") == 0
    assert {(r["student"], r["answer"]) for r in table("grades.csv")} >= {("Ada", "7")}


def test_a_class_without_a_mistake_is_told_so(folder):
    (folder / "roster.csv").write_text("student\nAda\n")
    assert run("key", "roster.csv", "--only", ONE) == 0
    right = table("key.csv")[0]["answer"].split(" ")[0]
    (folder / "answers.csv").write_text(saved("Ada", {ONE: right}))
    assert run("grade", "answers.csv", "--key", "key.csv") == 0
    assert "No answer was wrong." in (folder / "grades.html").read_text()


def test_a_key_of_an_older_bank_is_regraded_on_its_own_numbers(folder, capsys):
    """A corrected exercise: the students keep their numbers, the answers are the new ones."""
    numbers = json.dumps({"b": 0.123, "v_L": 0.1, "v_R": 0.2})
    row = ("c", "0ldbank", "Ada", ONE, 7, numbers, "wrong in the old bank")
    other = ("c", "0ldbank", "Bob", ONE, 7, '{"gone": 1}', "")
    tables.write("key.csv", teacher.KEY[1:], [row, other])  # an old key does not say its kind
    tables.write("answers.csv", ("student", "exercise", "answer"), [("Ada", ONE, 0.1 / 0.123)])
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert "The key is of version 0ldbank of the bank" in told.out
    assert f"key.csv, line 3: {ONE} cannot be computed from" in told.err
    assert [row["result"] for row in table("grades.csv")] == ["right"]


def test_check_tells_what_grade_would_find_and_changes_nothing(keyed, capsys):
    (keyed / "Ada.csv").write_text(saved("Ada", {ONE: "7"}))
    (keyed / "Eve.csv").write_text(saved("Eve", {ONE: "7"}))
    (keyed / "old.csv").write_text(saved("Bob", {ONE: "7"}, course="robokin-2025"))
    before = {path: path.stat().st_mtime_ns for path in keyed.iterdir()}
    assert run("check", ".", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert told.out.splitlines() == [
        f"the key: 2 students, 2 exercises, course robokin, version {dealing.version()}",
        "answers that count: 1, of 1 students, in 3 files",
        "  course robokin: 2 lines",
        "  course robokin-2025: 1 lines",
        f"  version {dealing.version()}: 1 lines",
        "students of whom nothing came: 1",
        "  Bob",
        "files without an answer of anybody in the key: 2",
        "  Eve.csv",
        "  old.csv",
        "nothing was written",
    ]
    assert "answers of students who are not in the key: 1" in told.err
    assert {path: path.stat().st_mtime_ns for path in keyed.iterdir()} == before


def test_the_commands_of_the_page_on_one_s_own_course(folder, capsys):
    """From the roster that it shows to the files that it names."""
    page = (ROOT / "book" / "own_course.md").read_text("utf-8")
    blocks = re.findall(r"^```\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    roster = next(block for block in blocks if block.startswith("student\n"))
    (folder / "roster.csv").write_text(roster)
    (folder / "answers").mkdir()
    (folder / "answers" / "answers-s0471.csv").write_text(saved("s0471", {ONE: "1"}))
    commands = [block.split(" -m book ")[1].split() for block in blocks if " -m book " in block]
    assert [command[0] for command in commands] == ["key", "check", "grade"]
    assert [run(*command) for command in commands] == [0, 0, 0]
    assert "students of whom nothing came: 2\n  s0472\n  s0473\n" in capsys.readouterr().out
    for name in re.findall(r"`(grades[\w.-]*)`", page):
        assert (folder / name).exists()


# --- a class --------------------------------------------------------------------------------

NAMES = ("s{:04}", "Åsa Öberg {}", "سارا محمدی {}", "=1+{}", 'O"Neil, {}', "  José   {} ")


@cache
def known_by_one_name(exercise, number):
    """What can be answered in a variant, without what gives the number of something before."""
    found = []
    for candidate in dealing.variants(exercise.name)[number].candidates:
        if all(judging.apart(exercise, candidate, other) for other in found):
            found.append(candidate)
    return found


def built_class(count):
    """A class: name → exercise → answer; and (name, exercise) → the grade that was built in.

    Where mistakes give the same, several names will do; which one, other tests hold.
    """
    draw, answers, wanted = random.Random(500), {}, {}
    for k in range(count):
        name = NAMES[k % len(NAMES)].format(k)
        mine = answers[name] = {}
        for exercise in EXERCISES.values():
            number = dealing.dealt("2026", exercise.name, name)
            candidates = known_by_one_name(exercise, number)
            chosen = draw.choice((candidates[0], draw.choice(candidates), None, "no idea"))
            grades = {("missing", "")}
            if chosen == "no idea":
                mine[exercise.name], grades = chosen, {("unread", "")}
            elif chosen:
                mine[exercise.name] = typed(chosen.rows, exercise)
                alike = (c for c in candidates if not judging.apart(exercise, c, chosen))
                meant = judging.outcomes(exercise)
                grades = {(meant[c.name].result, c.name) for c in alike}
            wanted[dealing.folded(name), exercise.name] = grades
    return answers, wanted


@pytest.mark.parametrize("size", [40, pytest.param(500, marks=pytest.mark.slow)])
def test_a_class(size, folder, capsys):
    """Mistakes, names typed late, two downloads, joined files, other files: all grades as built."""
    answers, wanted = built_class(size)
    names = list(answers)
    for part in (names[:-20], names):  # twenty are enrolled later
        tables.write("roster.csv", ("student",), [(name,) for name in part], force=True)
        assert run("key", "roster.csv", "--course", "2026", "--force") == 0
    (folder / "joined").mkdir()
    joined = b""
    early, late = ({name: f"2026-03-0{day}T09:00:00Z" for name in EXERCISES} for day in (1, 2))
    for k, name in enumerate(names):
        text = saved(name, answers[name], late, "2026")
        if k % 7 == 0:  # an older file, with a name that sorts before or after
            older = dict.fromkeys(answers[name], "0.123")
            (folder / f"{k} {'ab'[k % 2]}.csv").write_text(saved(name, older, early, "2026"))
        if k % 11 == 0:  # at first without a name, and once in another course
            (folder / f"{k}-nameless.csv").write_text(saved("", answers[name], late, "2026"))
            (folder / f"{k}-old.csv").write_text(saved(name, answers[name], late, "2025"))
        if k % 5 == 0:
            joined += text.encode()
        elif k % 13 == 0:  # by a spreadsheet
            rows = csv.reader(text.lstrip("\ufeff").splitlines())
            lines = (
                "\t".join(f'"{cell.replace(chr(34), chr(34) * 2)}"' for cell in r) for r in rows
            )
            (folder / f"{k}.csv").write_text("\n".join(lines), encoding="utf-16")
        else:
            (folder / f"{k} ab.csv").write_text(text)
    (folder / "joined" / "all.csv").write_bytes(joined)
    capsys.readouterr()
    assert run("grade", ".", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert f"of {size} students" in told.out
    graded = {
        (dealing.folded(row["student"]), row["exercise"]): (row["result"], row["mistake"])
        for row in table("grades.csv")
    }
    assert graded.keys() == wanted.keys()
    assert [person for person in wanted if graded[person] not in wanted[person]] == []
    counts = Counter(row["problem"] for row in table("grades-problems.csv"))
    replaced = sum(len(answers[name]) for name in names[::7])
    elevenths = sum(len(answers[name]) for name in names[::11])
    assert counts["answers replaced by a newer one"] == replaced
    assert counts["answers without a name"] == counts["answers of another course"] == elevenths
    page = (folder / "grades.html").read_text()
    assert page.count('<tr class="line">') == size
    assert "http" not in page
    assert "<script" not in page


@pytest.mark.slow
def test_a_hundred_megabytes_are_graded_in_three_hundred(folder):
    (folder / "roster.csv").write_text("student\n" + "\n".join(f"s{k}" for k in range(500)))
    assert run("key", "roster.csv") == 0
    with (folder / "all.csv").open("w") as file:
        file.write(",".join(notebook.COLUMNS) + "\n")
        rows = "".join(
            f"answers,robokin,{dealing.version()},2026-03-01T10:00:00.000Z,s{k},{name},0.12345\n"
            for k in range(500)
            for name in EXERCISES
        )
        while file.tell() < 100e6:
            file.write(rows.replace("0.12345", f"{file.tell()}"))
    peak = "print(open('/proc/self/status').read().split('VmHWM:')[1].split()[0], file=sys.stderr)"
    code = (
        "import sys, book; from courseware.practice.command import main; main(sys.argv[1:]); "
        f"{peak}"
    )
    grade = ["grade", "all.csv", "--key", "key.csv"]
    ran = subprocess.run([sys.executable, "-c", code, *grade], capture_output=True, text=True)
    used = int(ran.stderr.splitlines()[-1]) / 1000
    assert used < 300, f"{used:.0f} MB are used, allowed 300: read the file line by line"
