"""Tables as CSV: nothing is lost on the way, nothing runs in a spreadsheet."""

import csv
import io
import re
from pathlib import Path

import pytest
from commands import HEADING, ONE, TABLES, run, saved

from courseware.classroom import tables
from courseware.practice.saving import write_table
from courseware.script import engine

CELLS = [
    *("=1+1", "-v/2", "-0.5", "+3", "'=1", "''-x", "'", "@sum", "\t0.5", "\r1", 'a "1"; 2, 3'),
    *("0;=cmd", "1\t@sum", "[1; -2; -x]", "1;'=a", "＝1+1", "سه", " 1 ", "+cmd|' /C calc'!A0"),
    *("-2+3", "'quoted", "−1", "＝1", "0; -x", '0;"=cmd"', '0; " " @sum'),
]


@pytest.mark.parametrize("cell", CELLS)
def test_a_cell_comes_back_as_it_was_and_is_no_formula(folder, cell):
    """From the page and from Python, to both; numbers may begin with a sign."""
    text = saved("=Ada", {ONE: cell})
    (back,) = engine.call("courseware.parseAnswers", text)
    assert (back["student"], back["answer"]) == ("=Ada", cell.strip())
    Path("answers.csv").write_text(text, encoding="utf-8", newline="")
    write_table("t.csv", ("student", "answer"), [("=Ada", cell)])
    for name, place in (("answers.csv", 6), ("t.csv", 1)):
        ((_, row),) = tables.read_rows(Path(name), tables.Problems(), ["student", "answer"])
        assert (row["student"], row["answer"]) == ("=Ada", cell.strip())
        file = io.StringIO(Path(name).read_text("utf-8-sig"), newline="")
        for part in re.split("[;\n]", list(csv.reader(file))[1][place]):
            assert re.match(r'[ "]*([^ "=+@＝\t\r-]|[+-]?[\d.]+ *$)', part), part


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
