"""Answers from folders in which everything lies."""

from collections import Counter

import pytest
from commands import HEADING, ONE, ONLY, results, run, saved
from declared import table

from courseware.practice import variants


def test_bad_lines_are_told_and_the_good_ones_graded(folder, capsys):
    (folder / "roster.csv").write_bytes("student\nAda\nAda \n\nBob\n\xff\xfe\n".encode("latin-1"))
    assert run("key", "roster.csv", *ONLY) == 1
    assert capsys.readouterr().err.splitlines() == [
        "students named twice: 1",
        "  roster.csv, line 3: 'Ada' is one name with 'Ada' in line 2: no second key",
        "lines not in UTF-8: save your own as CSV UTF-8, ask students for the original: 1",
        "  roster.csv, line 6",
    ]
    lines = [
        "student;exercise;answer;course;time",
        f"Ada;{ONE};0,5;robokin;",
        f"Eve;{ONE};0.5;robokin;",
        "Ada;differential-drive-9;0.5;robokin;",
        f"Bob;{ONE};;robokin;",
        f"Bob;{ONE};1;;;;",
        f"Bob;{ONE};1;last year;",
        f"Ada;{ONE};0.6;robokin;yesterday",
        f";{ONE};0.6;robokin;",
    ]
    (folder / "answers.csv").write_text("\n".join(lines), encoding="utf-16")
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    assert capsys.readouterr().err.splitlines() == [
        "answers of students who are not in the key: 1",
        "  answers.csv, line 3: 'Eve'; had the numbers of Eve: add Eve to the roster and make the "
        "key again",
        "answers to exercises that do not exist: 1",
        "  answers.csv, line 4: there is no exercise 'differential-drive-9'",
        "empty answers: 1",
        f"  answers.csv, line 5: Bob, {ONE}",
        "lines with more cells than the heading: 1",
        "  answers.csv, line 6: 7 cells, the heading has 5",
        "answers of another course: 1",
        "  answers.csv, line 7: the course is 'last year', the key's is 'robokin'",
        "times that cannot be read (such an answer counts only if none has a time): 1",
        "  answers.csv, line 8: 'yesterday'",
        "answers replaced by one read later (without a time): 1",
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
    assert "tables that are no answers, left out: 6" in told
    told_of = {row["file"]: row["comment"] for row in table("second-problems.csv")}
    assert told_of["old-key.csv"].startswith("columns course, version, student, exercise")
    assert told_of.keys() >= {f"grades-{n}.csv" for n in ("problems", "students")}
    assert "answers-Bob.zip: unpack it\n" in told
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
    """Three thousand lines of last year's course are one line, and hide nothing else."""
    lines = [f"robokin-2025,Ada,{ONE},{k}" for k in range(3000)]
    lines.insert(1500, f"robokin,Eve,{ONE},5")
    lines.append(f"robokin,Bob,{ONE},6")
    (keyed / "all.csv").write_text(f"course,{HEADING}\n" + "\n".join(lines))
    assert run("grade", "all.csv", "--key", "key.csv") == 1
    told = capsys.readouterr().err.splitlines()
    assert told[0] == "answers of students who are not in the key: 1"
    assert told[2:] == [
        "answers of another course: 3,000",
        "  all.csv, line 2: the course is 'robokin-2025', the key's is 'robokin' (3,000 lines)",
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
    text = saved("Ada", {ONE: "7"}).replace(variants.version(), "0ldbank")
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
    good = f"student;exercise;answer\nBob;{ONE};7\n"
    (keyed / "answers" / "Bob" / "ANSWERS.CSV").write_text(good)
    (keyed / "answers" / "empty.csv").write_text("")
    (keyed / "answers" / "sheet.xlsx").write_bytes(b"PK")
    open_quote = f'{HEADING}\nAda,{ONE},"0.5\nAda,{ONE},"1, 2"\nAda,differential-drive-2,"1, 2"'
    (keyed / "answers" / "open.csv").write_text(open_quote)
    for force in ((), ("--force",)):  # a second time, with the first grades beside the answers
        out = keyed / "answers" / "grades.csv"
        assert run("grade", "answers", "--key", "key.csv", "--out", out, *force) == 1
        told = capsys.readouterr()
        assert "empty.csv" in told.err
        assert "sheet.xlsx: ask for the original" in told.err
        assert "a quotation mark is not closed, or does not end its cell: 1" in told.err
        assert "open.csv, line 2" in told.err
        graded = {(r["student"], r["exercise"]): r["answer"] for r in table(out)}
        assert graded["Bob", ONE] == "7"
        assert graded["Ada", ONE] == graded["Ada", "differential-drive-2"] == "1, 2"


@pytest.mark.parametrize("left", [".DS_Store", "~$answers-Ada.csv", "__MACOSX/._answers-Ada.csv"])
def test_what_a_system_leaves_in_a_folder_is_passed_over(keyed, capsys, left):
    """An unpacked archive, a file that is open in a spreadsheet: they hide no real problem."""
    (keyed / "answers" / left).parent.mkdir(parents=True)
    (keyed / "answers" / "answers-Ada.csv").write_text(saved("Ada", {ONE: "7"}))
    (keyed / "answers" / left).write_bytes(b"\0\5\x16\7\xff")
    assert run("grade", "answers", "--key", "key.csv") == 0
    assert not capsys.readouterr().err


def test_lines_that_spreadsheets_cut_short_are_whole(keyed):
    (keyed / "a.csv").write_text(f"{HEADING},course,remark\nAda,{ONE},7\nBob,{ONE},8,robokin\n")
    assert run("grade", "a.csv", "--key", "key.csv") == 0
    assert [row["answer"] for row in table("grades.csv") if row["answer"]] == ["7", "8"]


def test_a_name_that_is_not_in_the_key_counts_once_it_is(keyed, capsys):
    (keyed / "a.csv").write_text(saved("Adda", {ONE: "7"}) + saved("Zoe", {ONE: "7"}))
    assert run("grade", "a.csv", "--key", "key.csv") == 2
    told = capsys.readouterr().err
    assert "line 2: 'Adda', the key has 'Ada'; had the numbers of Adda: add Adda to the" in told
    assert "line 4: 'Zoe'; had the numbers of Zoe: add Zoe to the roster" in told
    (keyed / "roster.csv").write_text("student\nAda\nAdda\n")
    assert run("key", "roster.csv", *ONLY, "--force") == 0
    right = table("key.csv")[2]["answer"].split(" ")[0].replace("−", "-")
    (keyed / "a.csv").write_text(saved("Adda", {ONE: right}))
    assert run("grade", "a.csv", "--key", "key.csv") == 0
    assert results()["Adda", ONE] == "right"


def test_what_was_practised_besides_homework_is_one_line(keyed, capsys):
    others = {f"euler-{k}": "1" for k in range(1, 7)}
    (keyed / "a.csv").write_text(saved("Ada", {ONE: "7", **others}))
    (keyed / "b.csv").write_text(saved("Bob", others))
    assert run("grade", "a.csv", "b.csv", "--key", "key.csv") == 1
    assert capsys.readouterr().err == "answers to exercises that were not asked: 12\n"


def test_every_file_with_a_problem_is_told_and_all_lines_are_written(keyed, capsys):
    """Of many bad lines in one file none hides another file."""
    (keyed / "in").mkdir()
    (keyed / "in" / "Ada.csv").write_text(saved("Ada", {ONE: "7"}))
    lines = "\n".join(f"Bob,{ONE},é{k}" for k in range(52))
    (keyed / "in" / "old.csv").write_text(f"{HEADING}\n{lines}", encoding="cp1252")
    for name in ("a.zip", "b.zip", "c.zip", "d.zip", "e.pdf"):
        (keyed / "in" / name).write_bytes(b"PK")
    assert run("grade", "in", "--key", "key.csv") == 1
    told = capsys.readouterr().err
    assert "  in/old.csv, line 2 (52 lines)\n" in told
    assert all(f"in/{name}.zip" in told for name in "abcd")
    found = table("grades-problems.csv")
    assert Counter(row["file"] for row in found)["in/old.csv"] == 52
    assert len(found) == 57
