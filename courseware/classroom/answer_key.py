"""The answer key: everyone's numbers and right answers, as a table to write and to read."""

import hashlib
import json
import re
import secrets
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import product
from pathlib import Path

from courseware.classroom.tables import Problems, Row, read_rows, read_text
from courseware.course import course
from courseware.errors import CourseError
from courseware.practice import variants
from courseware.practice.bank import all_exercises, find_exercise
from courseware.practice.exercises import Exercise
from courseware.practice.saving import open_table

COLUMNS = ("course", "version", "student", "exercise", "variant", "numbers", "answer")
NEEDED = ("course", "version", "student", "exercise", "numbers")
UNUSABLE = "lines of the key that cannot be used"
SECRET_LENGTH = 16

Task = tuple[str, str]  # a student, as names are compared, and an exercise

folded = lru_cache(10_000)(variants.fold_name)


def write_key(roster: Path, out: Path, only: Sequence[str], secret: str, force: bool) -> list[str]:
    """Write everyone's numbers and right answers, and return the problems of the roster."""
    problems = Problems()
    students = _read_roster(roster, problems)
    name_of_course = course().salt
    salt = name_of_course + secret
    if secret:  # answers to other numbers must not count
        name_of_course += f", secret {hashlib.sha256(secret.encode()).hexdigest()[:6]}"
        _refuse_other_secret(out, name_of_course)
    asked = product(students, choose_exercises(only))
    with open_table(out, COLUMNS, force) as write:
        for student, name in asked:
            possible = len(variants.all_variants(name, secret))
            number = variants.choose_variant(salt, name, student) % possible
            row = (student, name, number, *_deal(name, number, secret))
            write((name_of_course, variants.version(), *row))
    return problems.lines()


@cache
def _deal(name: str, number: int, secret: str) -> tuple[str, str]:
    """Return the numbers of a variant as JSON, and its right answer as text."""
    numbers = variants.all_variants(name, secret)[number].numbers
    return json.dumps(numbers, ensure_ascii=False), all_exercises()[name].format_answer(numbers)


def _read_roster(path: Path, problems: Problems) -> list[str]:
    """Return the names of a roster as they are written; note empty and repeated ones."""
    names = dict[str, tuple[int, str]]()
    for line, row in read_rows(path, problems, ("student",)):
        alike = folded(row["student"])
        if not alike:
            problems.note("lines without a student's name", path, line)
        elif alike in names:
            first, other = names[alike]
            words = f"{row['student']!r} is one name with {other!r} in line {first}: no second key"
            problems.note("students named twice", path, line, words)
        else:
            names[alike] = line, row["student"]
    if not names:
        raise CourseError("\n".join([f"{path} names no student", *problems.lines()]))
    return [written for _, written in names.values()]


def choose_exercises(only: Sequence[str]) -> dict[str, Exercise]:
    """Return the exercises with these names; all if none is named."""
    return {name: find_exercise(name) for name in only} or all_exercises()


def _refuse_other_secret(out: Path, course: str) -> None:
    rows = read_rows(out, Problems()) if out.exists() else ()
    if others := {row.get("course", "") for _, row in rows} - {course}:
        raise CourseError(
            f"{out} is a key of {', '.join(sorted(others))}, this one would be of {course}: its "
            "numbers would change; give another name, or the secret that the key was made with"
        )


def read_secret(path: Path | None, make: bool) -> str:
    """Return the secret in a file, "" without a file; `make` writes one if there is none."""
    if path is None:
        return ""
    if not path.exists():
        if not make:
            raise CourseError(f"there is no file {path}; `key --secret` makes one")
        path.write_text(secrets.token_hex(SECRET_LENGTH) + "\n", encoding="utf-8")
    secret = re.sub(variants.IGNORED, "", read_text(path)).strip()  # as editors save it
    if len(secret.split()) != 1 or len(secret) < SECRET_LENGTH:
        raise CourseError(
            f"{path} must hold one word of {SECRET_LENGTH} characters or more, which nobody "
            "guesses: give another file, `key --secret` makes it"
        )
    return secret


@dataclass
class Key:
    """A key by student and exercise, each row with its line number."""

    path: Path
    rows: dict[Task, tuple[int, Row]]

    def __post_init__(self) -> None:
        self.students = {student: row["student"] for (student, _), (_, row) in self.rows.items()}
        _, first = next(iter(self.rows.values()))
        self.course, self.version = first["course"], first["version"]


def read_key(path: Path, problems: Problems) -> Key:
    """Read the table that `write_key` wrote; note lines that cannot be used."""
    rows: dict[Task, tuple[int, Row]] = {}
    for line, row in read_rows(path, problems, NEEDED):
        task = folded(row["student"]), row["exercise"]
        if row["exercise"] not in all_exercises():
            problems.note(UNUSABLE, path, line, f"there is no exercise {row['exercise']!r}", row)
        else:
            rows[task] = (line, row)
    if not rows:
        raise CourseError(f"{path} has no line that can be used: give the table that `key` wrote")
    return Key(path, rows)
