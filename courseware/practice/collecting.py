"""What students handed in, out of files and folders in which everything may lie.

A table is known by its columns. Of several answers the newest counts, by the time that stands
with it.
"""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import lru_cache
from pathlib import Path

from courseware.errors import CourseError
from courseware.practice import dealing, tables
from courseware.practice.bank import exercises

Person = tuple[str, str]  # a student, as names are compared, and an exercise

ANSWERS = ("student", "exercise", "answer")
OURS = {"numbers", "problem", "result"}  # columns of a key, of problems and of grades
OF_A_SYSTEM = re.compile(  # what it leaves behind; a hidden table is an answer like any other
    r"\._|\.(?!.*\.(csv|tsv|txt)$)|~\$|__MACOSX$|(Thumbs\.db|desktop\.ini)$", re.IGNORECASE
)
NEVER = datetime.min.replace(tzinfo=UTC)

folded = lru_cache(10_000)(dealing.folded)


@dataclass
class Keys:
    """The key by student and exercise, each row with its line number."""

    path: Path
    rows: dict[Person, tuple[int, tables.Row]]

    def __post_init__(self) -> None:
        self.students = {student: row["student"] for (student, _), (_, row) in self.rows.items()}
        self.courses = {row["course"] for _, row in self.rows.values()}
        self.versions = {row["version"] for _, row in self.rows.values()}


def read_key(path: str | Path, problems: tables.Problems) -> Keys:
    """The key that `key` wrote; lines that cannot be used are noted."""
    path = Path(path)
    needed = ("course", "version", "student", "exercise", "numbers")
    rows: dict[Person, tuple[int, tables.Row]] = {}
    for line, row in tables.rows(path, problems, needed):
        person = folded(row["student"]), row["exercise"]
        if row["exercise"] not in exercises():
            words = f"there is no exercise {row['exercise']!r}"
            problems.note("lines of the key that cannot be used", path, line, words, row)
        elif person in rows:
            words = f"{row['student']} has {row['exercise']} in line {rows[person][0]} already"
            problems.note("lines of the key that cannot be used", path, line, words, row)
        else:
            rows[person] = (line, row)
    if not rows:
        raise CourseError(f"{path} has no line that can be used: give the table that `key` wrote")
    return Keys(path, rows)


@dataclass(frozen=True)
class Given:
    """An answer that was handed in, when and where it stands."""

    answer: str
    time: datetime
    path: Path
    line: int

    def __str__(self) -> str:
        when = "without a time" if self.time == NEVER else f"of {self.time:%Y-%m-%d %H:%M:%S}"
        return f"{self.answer!r} {when}"


@dataclass
class Collected:
    """The answers that count, and what was met on the way."""

    keys: Keys
    problems: tables.Problems
    typed: dict[Person, Given] = field(default_factory=dict)
    files: Counter[Path] = field(default_factory=Counter)  # how many answers each gave
    courses: Counter[str] = field(default_factory=Counter)
    versions: Counter[str] = field(default_factory=Counter)

    @property
    def silent(self) -> list[str]:
        """The students of the key of whom nothing was handed in."""
        heard = {student for student, _ in self.typed}
        return [name for student, name in self.keys.students.items() if student not in heard]

    def __post_init__(self) -> None:
        self._courses = {"", *map(folded, self.keys.courses)}
        self._versions = {"", *self.keys.versions}

    def read(self, path: Path) -> None:
        """Take what a file has; a file that cannot be read does not stop the others."""
        others, before = Counter[str](), self.problems.counts.total()
        try:
            for line, row in tables.rows(path, self.problems):
                if row.keys() >= set(ANSWERS) and not row.keys() & OURS:
                    self._take(path, line, row)
                else:
                    others[", ".join(row)] += 1
        except CourseError as error:
            self.problems.note("files that cannot be read", path, comment=str(error))
        for columns, count in others.items():
            words = f"columns {columns}, {count:,} lines"
            self.problems.note("tables that are no answers, left out", path, comment=words)
        if path not in self.files and self.problems.counts.total() == before:
            self.problems.note("files without an answer", path)

    def _take(self, path: Path, line: int, row: tables.Row) -> None:
        """Take an answer that fits a line of the key; another is noted."""
        self.files[path] += 0  # it has answers, if perhaps none that fits
        self.courses[row.get("course", "")] += 1
        problem, comment = self._problem(row)
        if problem:
            self.problems.note(problem, path, line, comment, row)
            return
        self.files[path] += 1
        version = row.get("version", "")
        self.versions[version] += 1
        if version not in self._versions:
            words = f"version {version}, the key's is {_listed(self.keys.versions)}"
            kind = "answers to another version of the exercises (they count)"
            self.problems.note(kind, path, line, words, row)
        given = Given(row["answer"], self._time(path, line, row), path, line)
        self._keep((folded(row["student"]), row["exercise"]), given, row["student"])

    def _problem(self, row: tables.Row) -> tuple[str, str]:
        """Why an answer fits no line of the key, as a kind and a comment; "" if it fits one."""
        student, name, exercise = folded(row["student"]), row["student"], row["exercise"]
        if not student:
            return "answers without a name", ""
        if folded(row.get("course", "")) not in self._courses:
            words = f"the course is {row['course']!r}, the key's is {_listed(self.keys.courses)}"
            return "answers of another course", words
        if student not in self.keys.students:
            return "answers of students who are not in the key", repr(name)
        if (student, exercise) not in self.keys.rows:
            words = f"{name} has no exercise {exercise!r}"
            return "answers to exercises that are not in the student's key", words
        if not row["answer"]:
            return "empty answers", f"{name}, {exercise}"
        return "", ""

    def _keep(self, person: Person, given: Given, name: str) -> None:
        """The newer of two answers counts; of two without a time, or of one, the later read."""
        before = self.typed.get(person)
        new, old = (given, before) if not before or given.time >= before.time else (before, given)
        self.typed[person] = new
        if old and old.answer != new.answer:
            why = "a newer one" if new.time > old.time else "one read later (no time tells)"
            kind = f"answers replaced by {why}"
            words = f"{name}, {person[1]}: {old}, counts {new} ({new.path}, line {new.line})"
            row = {"student": name, "exercise": person[1], "answer": old.answer}
            self.problems.note(kind, old.path, old.line, words, row)

    def _time(self, path: Path, line: int, row: tables.Row) -> datetime:
        text = row.get("time", "")
        try:
            time = datetime.fromisoformat(text) if text else NEVER
        except ValueError:
            self.problems.note("times that cannot be read", path, line, repr(text), row)
            return NEVER
        return time if time.tzinfo else time.replace(tzinfo=UTC)


def _listed(names: set[str]) -> str:
    return ", ".join(map(repr, sorted(names)))


def collect(
    paths: Sequence[str | Path], keys: Keys, problems: tables.Problems, leave_out: Sequence[Path]
) -> Collected:
    """What counts of these files, and of those in these folders and their folders."""
    found = Collected(keys, problems)
    own = {path.resolve() for path in (keys.path, *leave_out)}
    files = [file for path in map(Path, paths) for file in _inside(path, problems)]
    seen = set[Path]()
    for file in files:
        if file.resolve() not in own | seen:
            seen.add(file.resolve())
            found.read(file)
    if not found.typed:
        raise CourseError("\n".join(["no answer fits the key", *problems.lines()]))
    return found


def _inside(path: Path, problems: tables.Problems) -> Iterator[Path]:
    """A file, or the tables of a folder; of others it is noted that they are not read."""
    if not path.is_dir():
        yield path
        return
    for file in sorted(file for file in path.rglob("*") if file.is_file()):
        if any(map(OF_A_SYSTEM.match, file.relative_to(path).parts)):
            continue
        if file.suffix.lower() in (".csv", ".tsv", ".txt"):
            yield file
        elif file.suffix.lower() != ".part":
            words = f"{file.suffix or 'no suffix'}: unpack archives, save spreadsheets as CSV"
            problems.note("files that are no table (.csv)", file, comment=words)
