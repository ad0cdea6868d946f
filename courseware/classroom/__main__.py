"""The teacher's commands: key, sheet, grade, moodle, assignment."""

import argparse
import io
import sys
from collections.abc import Sequence
from pathlib import Path

from courseware.classroom import moodle
from courseware.classroom.answer_key import read_secret, write_key
from courseware.classroom.assignments import write_assignment
from courseware.classroom.grading import grade
from courseware.classroom.sheets import write_sheets
from courseware.errors import CourseError


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command. Return 0 if all is fine, 1 if some lines were bad, 2 if not finished."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a console that knows few letters shows "?"
    try:
        problems, words = _run(_parser().parse_args(arguments))
    except CourseError as error:
        print(error, file=sys.stderr)
        return 2
    except OSError as error:  # a full disk, a folder that may not be written
        print(f"{error.filename}: {error.strerror}; not finished", file=sys.stderr)
        return 2
    for problem in problems:
        print(problem, file=sys.stderr)
    print(words)
    return 1 if problems else 0


def _run(options: argparse.Namespace) -> tuple[list[str], str]:
    """Run a command; return problems, and what to print."""
    if options.command != "assignment":
        print(f"{options.command}: takes up to a minute …", flush=True)
    if options.command == "grade":
        return grade(options.answers, options.key, options.out, options.force)
    written = f"written: {options.out}"
    if options.command == "assignment":
        out = options.out or Path(options.chapter)
        files = write_assignment(options.chapter, options.grader, out, options.force)
        return [], "written: " + ", ".join(map(str, files))
    if options.command == "sheet":
        return write_sheets(options.key, options.out, options.force), written
    secret = read_secret(options.secret, make=options.command == "key")
    arguments = options.only, secret, options.force
    if options.command == "key":
        return write_key(options.roster, options.out, *arguments), written
    moodle.write(options.out, *arguments)
    return [], written


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m courseware.classroom", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)

    def add(name: str, words: str, out: str | None) -> argparse.ArgumentParser:
        command = commands.add_parser(name, help=words, description=words)
        command.add_argument("--out", type=Path, default=out, help=f"default {out or 'CHAPTER/'}")
        command.add_argument("--force", action="store_true", help="overwrite what is there")
        return command

    key = add("key", "everyone's numbers and right answers", "key.csv")
    key.add_argument("roster", type=Path, help="CSV with a column student")
    sheet = add("sheet", "a page for each student, without answers", "sheets/")
    sheet.add_argument("key", type=Path, help="the table that key wrote")
    questions = add("moodle", "all variants as questions, to import as Moodle XML", "moodle.xml")
    programs = add("assignment", "the programs of a chapter for a grader of code", None)
    programs.add_argument("chapter", help="its folder: differential_drive")
    words = "who grades: nbgrader, otter (and Gradescope), or github (its Classroom)"
    programs.add_argument(
        "--for", dest="grader", choices=("nbgrader", "otter", "github"), required=True, help=words
    )
    for command in (key, questions):
        command.add_argument("--only", nargs="+", default=(), help="names of exercises")
        words = "a file with a secret that draws other numbers than the page's; key makes it"
        command.add_argument("--secret", type=Path, metavar="FILE", help=words)
    graded = add("grade", "right, partly, which mistake; and the class in numbers", "grades.csv")
    words = "CSV with the columns student, exercise, answer; or folders, with any other files"
    graded.add_argument("answers", type=Path, nargs="+", help=words)
    graded.add_argument("--key", type=Path, required=True, help="the table that key wrote")
    return parser


if __name__ == "__main__":
    sys.exit(main())
