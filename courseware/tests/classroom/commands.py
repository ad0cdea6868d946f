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
