"""The teacher's commands: key, sheet, check, grade, moodle. The author's: new."""

import argparse
import io
import sys
from collections.abc import Sequence

from courseware import new_chapter
from courseware.course import course
from courseware.errors import CourseError
from courseware.practice import moodle, teacher
from courseware.practice.bank import default_salt


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command. 0: all fine; 1: done, but some lines were bad; 2: not finished."""
    for stream in (sys.stdout, sys.stderr):  # a console that knows few letters shows "?"
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    try:
        problems, words = _run(_parser().parse_args(arguments))
    except CourseError as error:
        print(error, file=sys.stderr)
        return 2
    except OSError as error:  # a full disk, a folder that may not be written
        print(f"{error.filename}: {error.strerror}; not finished", file=sys.stderr)
        return 2
    print(words)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


def _run(options: argparse.Namespace) -> tuple[list[str], str]:
    """Do what is asked. Gives back problems, and what to print."""
    written = f"written: {options.out}" if "out" in options else ""
    if options.command == "new":
        return [], new_chapter.write(options.name)
    if options.command == "grade":
        return teacher.grade(options.answers, options.key, options.out, options.force)
    if options.command == "check":
        return teacher.check(options.answers, options.key)
    if options.command == "sheet":
        return teacher.sheets(options.key, options.out, options.force), written
    secret = teacher.secret_of(options.secret, make=options.command == "key")
    if options.command == "moodle":
        moodle.write(options.out, options.only, secret, options.force)
        return [], written
    arguments = options.course, options.only, secret, options.force
    return teacher.key(options.roster, options.out, *arguments), written


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog=f"python -m {course().package}", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)

    def command(name: str, words: str, out: str = "") -> argparse.ArgumentParser:
        made = commands.add_parser(name, help=words, description=words)
        if out:
            made.add_argument("--out", default=out, help=f"default {out}")
            made.add_argument("--force", action="store_true", help="overwrite what is there")
        return made

    new = command("new", "the skeleton of a new chapter")
    new.add_argument("name", help="of its folder, such as gear_train")
    key = command("key", "everyone's numbers and right answers", "key.csv")
    key.add_argument("roster", help="CSV with a column student")
    words = "the course's name, which takes part in picking the numbers; default: that of the site"
    key.add_argument("--course", default=default_salt(), help=words)
    sheet = command("sheet", "a page for each student, without answers", "sheets/")
    sheet.add_argument("key", help="the table that key wrote")
    to_moodle = command(
        "moodle", "all variants as questions, to import as Moodle XML", "moodle.xml"
    )
    for each in (key, to_moodle):
        each.add_argument("--only", nargs="+", default=(), help="names of exercises")
        words = "a file with a secret that draws other numbers than the page's; key makes it"
        each.add_argument("--secret", metavar="FILE", help=words)
    check = command("check", "what grade would find; changes nothing")
    grade = command("grade", "right, partly, which mistake; and a look at the class", "grades.csv")
    for each in (check, grade):
        words = (
            "CSV with the columns student, exercise, answer; or folders, with other files in them"
        )
        each.add_argument("answers", nargs="+", help=words)
        each.add_argument("--key", required=True, help="the table that key wrote")
    return parser
