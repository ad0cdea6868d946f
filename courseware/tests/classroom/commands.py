"""Commands of a teacher, and files that students hand in."""

from declared import table

from courseware.classroom.__main__ import main
from courseware.practice import variants
from courseware.script import engine

ONE = "differential-drive-1"
ONLY = ("--only", ONE, "differential-drive-2")
HEADING = "student,exercise,answer"


def run(*arguments):
    return main([str(a) for a in arguments])


def saved(student, answers, times=None, course="robokin"):
    """The file that the page saves, by the page's own writer."""
    entries = {
        name: {"answer": answer, "time": (times or {}).get(name, "2026-03-01T10:00:00.000Z")}
        for name, answer in answers.items()
    }
    head = {"course": course, "version": variants.version()}
    return "\ufeff" + engine.call("courseware.serializeAnswers", head, student, entries)


def results():
    return {(row["student"], row["exercise"]): row["result"] for row in table("grades.csv")}


def _one_answer(separator):
    heading = ("student", "exercise", "time", "answer", "course")
    rows = heading, ('"Ada; Ω"', ONE, "", '"[1; 2], ½"', "")
    return "".join(separator.join(row) + "\n" for row in rows)


# Files as spreadsheets and platforms write them: Ada; Ω has answered "[1; 2], ½"
TABLES = {
    "commas": _one_answer(",").encode(),
    "semicolons": _one_answer(";").encode("utf-8-sig"),
    "tabs in UTF-16": ("\ufeff" + _one_answer("\t")).encode("utf-16-le"),
    "big end first": f"\ufeff{_one_answer(';')}".encode("utf-16-be"),
    "its separator said": f"sep=|\n{_one_answer('|')}".encode("utf-8-sig"),
    "said in UTF-16": f"\ufeffsep=;\r\n{_one_answer(';')}".encode("utf-16-le"),
    "old line ends": _one_answer(";").replace("\n", "\r").encode(),
    "empty lines, capitals": f"\n \n{_one_answer(',').replace('s', 'S', 1)}".encode(),
    "no empty cells at the end": _one_answer(";").replace(";\n", "\n").encode(),
    "joined, with bad lines": (
        f'{_one_answer(";")}x;"1" 2;;3\n\ufeff{_one_answer(";")}'.encode() + b"\xff;1;1;1\n"
    ),
}
