"""For the teacher: keys, sheets, grades, and folders in which everything lies."""

import csv
import json

import pytest
from declared import EXERCISES

from workshop.practice import dealing, notebook, tables, teacher
from workshop.practice.command import main


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(*arguments):
    return main([str(a) for a in arguments])


ONLY = ("--only", "differential-drive-1", "differential-drive-2")


def test_key_sheets_and_grades(folder, capsys):
    (folder / "roster.csv").write_text("student,group\nAda,1\nسارا,2\n=1+1,3\n", encoding="utf-8")
    assert run("key", "roster.csv", "--course", "2026", *ONLY) == 0
    assert run("sheet", "roster.csv", "--course", "2026", *ONLY) == 0
    rows = [row for _, row in tables.read("key.csv", teacher.KEY).rows]
    assert [row["student"] for row in rows[::2]] == ["Ada", "سارا", "=1+1"]
    sheets = sorted((folder / "sheets").iterdir())
    assert len(sheets) == 3
    for row in rows:
        variant = dealing.variants(row["exercise"])[int(row["variant"])]
        assert json.loads(row["numbers"]) == variant.numbers
    assert not any(row["answer"].split(" ")[0] in s.read_text() for s in sheets for row in rows)

    answers = [  # right, half the wheel distance, in degrees, words, nothing
        ("Ada", "differential-drive-1", rows[0]["answer"].split(" ")[0]),
        ("Ada", "differential-drive-2", "no idea"),
        ("سارا", "differential-drive-1", str(wrong(rows[2], "M12"))),
        ("=1+1", "differential-drive-1", str(wrong(rows[4], "unit:degrees"))),
    ]
    tables.write("answers.csv", ("student", "exercise", "answer"), answers)
    capsys.readouterr()
    assert run("grade", "answers.csv", "--key", "key.csv") == 0
    assert "half the wheel distance" in capsys.readouterr().out
    graded = [row for _, row in tables.read("grades.csv", teacher.GRADES).rows]
    results = [row["result"] for row in graded]
    assert results == ["right", "unread", "wrong", "missing", "partly", "missing"]
    assert [row["mistake"] for row in graded] == ["right", "", "M12", "", "unit:degrees", ""]
    totals = tables.read("grades-students.csv", teacher.TOTALS).rows
    assert totals[2][1] == dict(zip(teacher.TOTALS, ["=1+1", "0", "1", "0", "0", "1"], strict=True))
    assert (folder / "grades-mistakes.svg").read_text().startswith("<?xml")


def wrong(row, name):
    """What a candidate of the student's variant answers."""
    variant = dealing.variants(row["exercise"])[int(row["variant"])]
    return next(c.rows[0][0] for c in variant.candidates if c.name == name)


def test_bad_lines_are_reported_and_the_good_ones_graded(folder, capsys):
    (folder / "roster.csv").write_bytes("student\nAda\nAda \n\nBob\n\xff\xfe\n".encode("latin-1"))
    assert run("key", "roster.csv", *ONLY) == 1
    told = capsys.readouterr().err.splitlines()
    assert told == [
        "roster.csv, line 6: not in UTF-8: save the file as CSV UTF-8",
        "roster.csv, line 3: Ada is in line 2 already",
    ]
    lines = [
        "student;exercise;answer;course",
        "Ada;differential-drive-1;0,5;robokin",
        "Eve;differential-drive-1;0.5;robokin",
        "Ada;differential-drive-9;0.5;robokin",
        "Bob;differential-drive-1;;robokin",
        "Bob;differential-drive-1;1",
        "Bob;differential-drive-1;1;last year",
        "Ada;differential-drive-1;0.6;robokin",
    ]
    (folder / "answers.csv").write_text("\n".join(lines), encoding="utf-16")
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    told = [line.split(", line ")[1] for line in capsys.readouterr().err.splitlines()]
    assert told == [
        "6: 3 cells, the header has 4",
        "3: 'Eve' is not in the key",
        "4: Ada has no exercise 'differential-drive-9'",
        "5: Bob has an empty answer to differential-drive-1",
        "7: answered in the course 'last year', the key is 'robokin'",
        "8: Ada answers differential-drive-1 again: this counts",
    ]
    graded = [row for _, row in tables.read("grades.csv", teacher.GRADES).rows]
    assert graded[0]["answer"] == "0.6"


def test_nothing_is_overwritten(folder, capsys):
    (folder / "roster.csv").write_text("student\nAda\n")
    for command, out in (("key", "key.csv"), ("sheet", "sheets")):
        assert run(command, "roster.csv", "--out", out, *ONLY) == 0
        assert run(command, "roster.csv", "--out", out, *ONLY) == 2
        assert "already there" in capsys.readouterr().err
        assert run(command, "roster.csv", "--out", out, "--force", *ONLY) == 0


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
    assert not (folder / "key.csv").exists()


def test_a_folder_of_answers(folder, capsys):
    """Each student's own file, as the page saves it; a folder without any is refused."""
    (folder / "roster.csv").write_text("student\nAda\nBob\n")
    (folder / "answers").mkdir()
    assert run("key", "roster.csv", *ONLY) == 0
    assert run("grade", "answers", "--key", "key.csv") == 2
    assert "no .csv file in answers" in capsys.readouterr().err
    for name in ("Ada", "Bob"):
        row = ("robokin", name, "differential-drive-1", "7")
        tables.write(folder / "answers" / f"{name}.csv", notebook.COLUMNS, [row])
    assert run("grade", "answers", "--key", "key.csv") == 0
    assert "2 wrong" in capsys.readouterr().out


def test_one_bad_file_does_not_stop_the_others(folder, capsys):
    (folder / "roster.csv").write_text("student\nAda\nBob\n")
    assert run("key", "roster.csv", *ONLY) == 0
    (folder / "answers" / "Bob").mkdir(parents=True)
    good = "sep=;\nstudent;exercise;answer\nBob;differential-drive-1;7\n"
    (folder / "answers" / "Bob" / "ANSWERS.CSV").write_text(good)
    (folder / "answers" / "empty.csv").write_text("")
    (folder / "answers" / "sheet.xlsx").write_bytes(b"PK")
    open_quote = (
        'student,exercise,answer\nAda,differential-drive-1,"0.5\nAda,differential-drive-2,1'
    )
    (folder / "answers" / "open.csv").write_text(open_quote)
    for force in ((), ("--force",)):  # a second time, with the first grades beside the answers
        out = folder / "answers" / "grades.csv"
        assert run("grade", "answers", "--key", "key.csv", "--out", out, *force) == 1
        told = capsys.readouterr()
        assert "1 wrong" in told.out
        assert "empty.csv has no column student" in told.err
        assert "sheet.xlsx: not read" in told.err
        assert "open.csv, line 2: not read, to line 3: unexpected end of data" in told.err


def test_what_is_read_is_not_overwritten(folder, capsys):
    (folder / "roster.csv").write_text("student\nAda\n")
    assert run("key", "roster.csv", "--out", "roster.csv", "--force") == 2
    assert "roster.csv is what is read" in capsys.readouterr().err
    assert run("sheet", "roster.csv", "--out", "roster.csv") == 2
    assert "roster.csv is a file" in capsys.readouterr().err


def test_a_missing_file_is_refused(folder, capsys):
    assert run("key", "nowhere.csv") == 2
    assert "nowhere.csv cannot be read: No such file" in capsys.readouterr().err


def test_a_key_of_an_older_bank_is_regraded_on_its_own_numbers(folder, capsys):
    """A corrected exercise: the students keep their numbers, the answers are the new ones."""
    numbers = json.dumps({"b": 0.123, "v_L": 0.1, "v_R": 0.2})
    row = ("c", "0ldbank", "Ada", "differential-drive-1", 7, numbers, "wrong in the old bank")
    other = ("c", "0ldbank", "Bob", "differential-drive-1", 7, '{"gone": 1}', "")
    tables.write("key.csv", teacher.KEY, [row, other])
    answer = ("Ada", "differential-drive-1", 0.1 / 0.123)
    tables.write("answers.csv", ("student", "exercise", "answer"), [answer])
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert "version 0ldbank of the bank" in told.out
    assert "key.csv, line 3: differential-drive-1 cannot be computed from" in told.err
    graded = tables.read("grades.csv", teacher.GRADES).rows
    assert [row["result"] for _, row in graded] == ["right"]


@pytest.mark.parametrize(
    "cell", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@sum", "\tx", "'quoted", "−1"]
)
def test_no_cell_is_a_formula(folder, cell):
    tables.write("t.csv", ("student", "n"), [(cell, "-0.5")])
    with open("t.csv", encoding="utf-8-sig", newline="") as file:
        first, number = list(csv.reader(file))[1]
    assert first[0] not in "=+-@\t\r"
    assert number == "-0.5"
    assert tables.read("t.csv", ("student",)).rows[0][1]["student"] == cell.strip()


def test_grades_say_at_once_that_they_cannot_be_drawn(folder, capsys, monkeypatch):
    monkeypatch.setattr(teacher, "find_spec", lambda name: None)
    assert run("grade", "answers.csv", "--key", "key.csv") == 2
    assert "pip install matplotlib" in capsys.readouterr().err
    assert not list(folder.iterdir())


def test_a_thousand_students(folder):
    """All exercises of all; the time is in the note of the release, not tested here."""
    people = "\n".join(f"student {k}" for k in range(1000))
    (folder / "roster.csv").write_text(f"student\n{people}\n")
    assert run("key", "roster.csv") == 0
    assert len(tables.read("key.csv", teacher.KEY).rows) == 1000 * len(EXERCISES)
