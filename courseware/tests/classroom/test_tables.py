"""Tables as CSV: nothing is lost on the way, nothing runs in a spreadsheet."""

import csv
import io
import re
from pathlib import Path

import pytest
from commands import HEADING, ONE, TABLES, run, saved
from declared import table

from courseware.classroom import tables
from courseware.practice.saving import write_table
from courseware.script import engine

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
    "0;=cmd",
    "1\t@sum",
    "[1; -2; -x]",
    "1;'=a",
    "＝1+1",
    "سه",
    " 1 ",
]


@pytest.mark.parametrize("cell", CELLS)
def test_a_saved_answer_comes_back_as_it_was(folder, cell):
    """To the page and to `grade`; in the file it is nothing that a spreadsheet would run."""
    text = saved("=Ada", {ONE: cell})
    in_file = list(csv.reader(io.StringIO(text, newline="")))[1][6]
    assert in_file[0] not in "=+-@\t\r" or in_file in ("-0.5", "+3")
    (back,) = engine.call("courseware.parseAnswers", text)
    assert (back["student"], back["answer"]) == ("=Ada", cell.strip())
    (folder / "answers.csv").write_text(text, encoding="utf-8", newline="")
    ((_, row),) = tables.read_rows(Path("answers.csv"), tables.Problems(), ["student", "answer"])
    assert (row["student"], row["answer"]) == ("=Ada", cell.strip())


@pytest.mark.parametrize(
    "cell",
    [
        "=1+1",
        "+cmd|' /C calc'!A0",
        "-2+3",
        "@sum",
        "\tx",
        "'quoted",
        "−1",
        "＝1",
        "0;=cmd",
        "0; -x",
        '0;"=cmd"',
        '0; " " @sum',
    ],
)
def test_no_cell_is_a_formula(folder, cell):
    write_table("t.csv", ("student", "n"), [(cell, "-0.5")])
    with open("t.csv", encoding="utf-8-sig", newline="") as file:
        first, number = list(csv.reader(file))[1]
    assert all(part.lstrip(' "')[0] not in "=+-@＝\t\r" for part in re.split("[;\n]", first))
    assert number == "-0.5"
    assert table("t.csv")[0]["student"] == cell.strip()


def test_an_answer_in_several_lines_whose_row_looks_like_a_heading(keyed):
    """The name of its student holds that of a column."""
    (keyed / "answers.csv").write_text(f'{HEADING}\nstudent12,{ONE},"[1,\n2,\n3]"\nAda,{ONE},5\n')
    problems = tables.Problems()
    found = list(tables.read_rows(Path("answers.csv"), problems, HEADING.split(",")))
    assert [(row["student"], row["answer"]) for _, row in found] == [
        ("student12", "[1,\n2,\n3]"),
        ("Ada", "5"),
    ]
    assert not problems.lines()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("name\nAda\n", "no column student; needed are student, its first line has name"),
        ("", "no column student; needed are student, its first line has nothing"),
        ("student\n\n", "names no student"),
        (
            "PK\3\4\0\0student",
            "is no text: unpack an archive; of a spreadsheet, save your own as CSV UTF-8",
        ),
    ],
)
def test_a_table_that_cannot_be_used_is_refused(folder, capsys, text, words):
    (folder / "roster.csv").write_text(text)
    assert run("key", "roster.csv") == 2
    assert words in capsys.readouterr().err
    assert [path.name for path in folder.iterdir()] == ["roster.csv"]


@pytest.mark.parametrize(
    "text",
    [
        "student,exercise\nAda,1\n",
        "student;exercise\nAda;1\n",
        "student,exercise,note\nAda,1\n",
        'student,exercise,address\nAda,1,"1\n2\n3\n4\n5\n6\n7"\n',
    ],
)
def test_a_table_is_read_as_spreadsheets_and_platforms_write_it(folder, text):
    for newline in ("\n", "\r\n", "\r"):
        Path("t.csv").write_text(text, newline=newline)
        ((_, row),) = tables.read_rows(Path("t.csv"), problems := tables.Problems())
        assert (row["student"], row["exercise"]) == ("Ada", "1")
        assert not problems.lines()


@pytest.mark.parametrize("content", TABLES.values(), ids=TABLES)
def test_answers_are_read_from_what_platforms_make_of_them(folder, content):
    """The page reads the same files: see `test_practice_page.py`."""
    Path("t.csv").write_bytes(content)
    problems = tables.Problems()
    rows = [row for _, row in tables.read_rows(Path("t.csv"), problems)]
    assert {(r["student"], r["exercise"], r["answer"]) for r in rows} == {
        ("Ada; Ω", ONE, "[1; 2], ½")
    }
    assert len(problems) == (2 if b"\xff;" in content else 0)
