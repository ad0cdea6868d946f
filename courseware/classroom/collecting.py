"""Answers that students handed in, out of files and folders in which anything may lie.

A table is known by its columns. Of several answers the newest counts, by the time in its row.
"""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from difflib import get_close_matches
from pathlib import Path

from courseware.classroom import tables
from courseware.classroom.answer_key import Key, Task, folded
from courseware.classroom.tables import Problems, Row, read_rows
from courseware.errors import CourseError
from courseware.practice.bank import all_exercises
from courseware.practice.saving import OTHER_COLUMNS

NEEDED = {"student", "exercise", "answer"}
OF_ANOTHER_VERSION = "answers to another version of the exercises (they count)"
NO_TIME = "times that cannot be read (such an answer counts only if none has a time)"
SYSTEM_FILES = re.compile(  # left behind; any other hidden file may be an answer
    r"\._|~\$|(__MACOSX|\.DS_Store|\.git|\.ipynb_checkpoints|Thumbs\.db|desktop\.ini)$",
    re.IGNORECASE,
)
ADVICE = {  # by the end of a file's name
    (".zip", ".7z", ".rar", ".gz"): "unpack it",
    (".ipynb",): "ask for the file that practice.export() writes in it",
    (".xlsx", ".xls", ".ods", ".numbers"): "ask for the original, a spreadsheet changes answers",
    ("",): "rename it to .csv if it is the table that the page saves, or ask for that",
}
NEAR = 0.8  # of 1: how much alike names are that one person may have written
NEVER = datetime.min.replace(tzinfo=UTC)


@dataclass(frozen=True)
class Answer:
    """An answer that was handed in, with its time and place."""

    answer: str
    time: datetime
    path: Path
    line: int
    tries: str = ""
    help: str = ""

    def __str__(self) -> str:
        when = "without a time" if self.time == NEVER else f"of {self.time:%Y-%m-%d %H:%M:%S}"
        return f"{self.answer!r} {when}"


@dataclass
class Collected:
    """The answers that count, and the files in which there are answers."""

    key: Key
    problems: Problems
    answers: dict[Task, Answer] = field(default_factory=dict)
    files: set[Path] = field(default_factory=set)

    def read(self, path: Path) -> None:
        """Take the answers of a file; one that cannot be read does not stop the others."""
        others, before = Counter[str](), len(self.problems)
        try:
            for line, row in read_rows(path, self.problems):
                if row.keys() >= NEEDED and not row.keys() & {*OTHER_COLUMNS}:
                    self._take(path, line, row)
                else:
                    others[", ".join(row)] += 1
        except CourseError as error:
            self.problems.note("files that cannot be read", path, comment=str(error))
        for columns, count in others.items():
            words = f"columns {columns}, {count:,} lines"
            self.problems.note("tables that are no answers, left out", path, comment=words)
        if path not in self.files and len(self.problems) == before:
            self.problems.note("files without an answer", path)

    def _take(self, path: Path, line: int, row: Row) -> None:
        """Take an answer that fits a line of the key; note another."""
        self.files.add(path)
        problem, comment = self._find_problem(row)
        if problem:
            self.problems.note(problem, path, line, comment, row)
            return
        version = row.get("version", "")
        if version not in ("", self.key.version):
            words = f"version {version}, the key's is {self.key.version}"
            self.problems.note(OF_ANOTHER_VERSION, path, line, words, row)
        counts = row.get("tries", ""), row.get("help", "")
        answer = Answer(row["answer"], self._read_time(path, line, row), path, line, *counts)
        self._keep(answer, row)

    def _find_problem(self, row: Row) -> tuple[str, str]:
        """Return why an answer fits no line of the key, as kind and comment; "" if it fits one."""
        student, name, exercise = folded(row["student"]), row["student"], row["exercise"]
        if not student:
            return "answers without a name", ""
        if folded(row.get("course", "")) not in ("", folded(self.key.course)):
            words = f"the course is {row['course']!r}, the key's is {self.key.course!r}"
            return "answers of another course", words
        if student not in self.key.students:
            words = repr(name)
            for near in get_close_matches(student, self.key.students, 1, NEAR):
                words += f", the key has {self.key.students[near]!r}"
            words += f"; had the numbers of {name}: add {name} to the roster and make the key again"
            return tables.UNKNOWN_STUDENT, words
        if exercise not in all_exercises():
            return tables.UNKNOWN_EXERCISE, f"there is no exercise {exercise!r}"
        if (student, exercise) not in self.key.rows:
            return tables.NOT_ASKED, ""
        if not row["answer"]:
            return "empty answers", f"{name}, {exercise}"
        return "", ""

    def _keep(self, answer: Answer, row: Row) -> None:
        """Keep the newer of two answers; of two without a time, or of one, the later read."""
        name, exercise = row["student"], row["exercise"]
        task = folded(name), exercise
        new, old = answer, self.answers.get(task)
        if old and new.time < old.time:
            new, old = old, new
        self.answers[task] = new
        if old and old.answer != new.answer:
            why = "a newer one" if new.time > old.time else "one read later (without a time)"
            words = f"{name}, {exercise}: {old}, counts {new} ({new.path}, line {new.line})"
            replaced = {**row, "answer": old.answer}
            self.problems.note(f"answers replaced by {why}", old.path, old.line, words, replaced)

    def _read_time(self, path: Path, line: int, row: Row) -> datetime:
        text = row.get("time", "")
        try:
            time = datetime.fromisoformat(text) if text else NEVER
        except ValueError:
            self.problems.note(NO_TIME, path, line, repr(text), row)
            return NEVER
        return time if time.tzinfo else time.replace(tzinfo=UTC)


def collect(
    paths: Sequence[Path], key: Key, problems: Problems, leave_out: Sequence[Path] = ()
) -> Collected:
    """Collect the answers in these files, and in the files of these folders and their folders."""
    found = Collected(key, problems)
    seen = {path.resolve() for path in (key.path, *leave_out)}
    for file in [file for path in paths for file in _find_tables(path, problems)]:
        if file.resolve() not in seen:
            seen.add(file.resolve())
            found.read(file)
    if not found.answers:
        raise CourseError("\n".join(["no answer fits the key", *problems.lines()]))
    return found


def _find_tables(path: Path, problems: Problems) -> Iterator[Path]:
    """Yield a file, or the tables of a folder; note the other files of a folder."""
    if not path.is_dir():
        yield path
        return
    for file in sorted(path.rglob("*")):
        if any(map(SYSTEM_FILES.match, file.relative_to(path).parts)):
            continue
        if file.is_file() and file.suffix.lower() in (".csv", ".tsv", ".txt"):
            yield file
        elif not file.is_dir():
            words = next(ADVICE[ends] for ends in ADVICE if file.name.lower().endswith(ends))
            problems.note("files that are no table (.csv)", file, comment=words)
