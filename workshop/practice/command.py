"""The teacher's commands: key, sheet, grade, moodle."""

import argparse
import io
import sys
from collections.abc import Sequence

from workshop.course import course
from workshop.errors import CourseError
from workshop.practice import moodle, teacher
from workshop.practice.bank import default_salt


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command. 0: all fine; 1: done, but some lines were bad; 2: nothing was done."""
    options = _parser().parse_args(arguments)
    for stream in (sys.stdout, sys.stderr):  # a console that knows few letters shows "?"
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    try:
        if options.command == "grade":
            problems, words = teacher.grade(
                options.answers, options.key, options.out, options.force
            )
        elif options.command == "moodle":
            left_out = moodle.write(options.out, options.only, options.force)
            problems, words = [], f"written: {options.out}"
            if left_out:
                words += "\nseveral right answers of several numbers, left out: "
                words += ", ".join(left_out)
        else:
            write = teacher.key if options.command == "key" else teacher.sheets
            problems = write(
                options.roster, options.out, options.course, options.only, options.force
            )
            words = f"written: {options.out}"
    except CourseError as error:
        print(error, file=sys.stderr)
        return 2
    print(words)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog=f"python -m {course().package}", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, words, out in (
        ("key", "everyone's numbers and right answers", "key.csv"),
        ("sheet", "a page for each student, without answers", "sheets/"),
    ):
        command = commands.add_parser(name, help=words, description=words)
        command.add_argument("roster", help="CSV with a column student")
        command.add_argument("--out", default=out, help=f"default {out}")
        words = "the course's name, a new one a year: it takes part in picking the numbers"
        command.add_argument("--course", default=default_salt(), help=words)
        _add_only(command)
    words = "all variants as questions for Moodle, to import as Moodle XML"
    command = commands.add_parser("moodle", help=words, description=words)
    command.add_argument("--out", default="moodle.xml", help="default moodle.xml")
    _add_only(command)
    words = "right, partly, which mistake; and a summary"
    command = commands.add_parser("grade", help=words, description=words)
    command.add_argument(
        "answers", nargs="+", help="CSV with the columns student, exercise, answer; or folders"
    )
    command.add_argument("--key", required=True, help="the table that key wrote")
    command.add_argument("--out", default="grades.csv", help="default grades.csv")
    for command in commands.choices.values():
        command.add_argument("--force", action="store_true", help="overwrite what is there")
    return parser


def _add_only(command: argparse.ArgumentParser) -> None:
    command.add_argument("--only", nargs="+", default=(), help="names of exercises")
