"""For teachers: everyone's answer key, sheets to print, grades and what the class gets wrong.

The tables are documented in the chapter for teachers. All functions report bad lines and go on
with the good ones; nothing is overwritten without `force`.
"""

import json
import re
import sys
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from html import escape
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeVar

from workshop.errors import CourseError
from workshop.practice import dealing, judging, tables
from workshop.practice.bank import Exercise, exercises, mistakes
from workshop.practice.wording import paragraphs, symbols

T = TypeVar("T")
Count = tuple[str, str, int, int, str]  # a row of the mistakes

KEY = ("course", "version", "student", "exercise", "variant", "numbers", "answer")
GRADES = ("student", "exercise", "answer", "result", "mistake", "comment")
TOTALS = ("student", "right", "partly", "wrong", "unread", "missing")
COUNTS = ("exercise", "mistake", "students", "of", "comment")
COUNTED = ("wrong", "partly")
BARS = 15  # the most frequent mistakes, in the picture
TOLD = 20  # problems of one file


def key(
    roster: str | Path, out: str | Path, course: str, only: Sequence[str] = (), force: bool = False
) -> list[str]:
    """Write everyone's numbers and right answers. Gives back what is wrong with the roster."""
    table, students = _students(roster)
    _refuse_same(out, roster)
    tables.free(Path(out), force)
    exercises = chosen(only)
    rows = (
        (course, dealing.version(), student, e.name, number, *_dealt(e.name, number))
        for student in progress(students, "students")
        for e in exercises
        for number in [dealing.dealt(course, e.name, student)]
    )
    tables.write(out, KEY, rows, force)
    return table.problems


@cache
def _dealt(name: str, number: int) -> tuple[str, str]:
    """The numbers of a variant as JSON, and its right answer as text."""
    variant = dealing.variants(name)[number]
    answer = exercises()[name].answer_text(variant.numbers)
    return json.dumps(variant.numbers, ensure_ascii=False), answer


def sheets(
    roster: str | Path, out: str | Path, course: str, only: Sequence[str] = (), force: bool = False
) -> list[str]:
    """Write a page for each student, to print or to hand out, without answers."""
    table, students = _students(roster)
    folder, exercises = Path(out), chosen(only)
    if folder.is_file():
        raise CourseError(f"{folder} is a file: give the name of a folder")
    folder.mkdir(parents=True, exist_ok=True)
    for student in students:
        tables.free(folder / _file_name(student), force)
    for student in progress(students, "students"):
        page = _sheet(student, course, exercises)
        (folder / _file_name(student)).write_text(page, encoding="utf-8")
    return table.problems


def _file_name(student: str) -> str:
    """A name that every file system takes, and no two students share."""
    plain = re.sub(r"\W+", "-", student).strip("-")[:40]
    return f"{plain}-{dealing.fnv1a(student):08x}.html"


SHEET = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{student}: {course}</title><style>
body {{ font: 11pt/1.5 sans-serif; max-width: 42rem; margin: 2rem auto; padding: 0 1rem; }}
section {{ break-inside: avoid; margin: 1.2rem 0; }} h2 {{ font-size: 1rem; margin: 0; }}
p {{ margin: .2rem 0; }} .answer {{ border-bottom: 1px solid; padding-top: 1.6rem; }}
</style></head><body><h1>{student}</h1><p>Course: {course}. Each exercise has your own numbers.</p>
{exercises}</body></html>
"""


def _sheet(student: str, course: str, exercises: Sequence[Exercise]) -> str:
    parts = [_question(e.name, dealing.dealt(course, e.name, student)) for e in exercises]
    return SHEET.format(student=escape(student), course=escape(course), exercises="\n".join(parts))


@cache
def _question(name: str, number: int) -> str:
    exercise, variant = exercises()[name], dealing.variants(name)[number]
    text = exercise.filled(exercise.text, variant.numbers, variant.shown)
    return (
        f"<section><h2>{name}: {escape(exercise.title)}</h2>{paragraphs(text)}"
        f'<p class="answer">Answer, {symbols(judging.asked(exercise))}:</p></section>'
    )


@dataclass(frozen=True)
class Graded:
    """One line of the grades."""

    student: str
    exercise: str
    answer: str
    result: str
    mistake: str
    comment: str


def grade(
    answers: Sequence[str | Path], key: str | Path, out: str | Path, force: bool = False
) -> tuple[list[str], str]:
    """Grade tables of answers. Gives back what is wrong with the lines, and a summary to print.

    answers: files, or folders of CSV files. Beside `out` come the students' totals, the mistakes
    the class makes, and a picture of these.
    """
    if find_spec("matplotlib") is None:  # said before anything is written
        raise CourseError("grade draws the class's mistakes: `pip install matplotlib` first")
    paths = [_beside(out, end) for end in ("", "-students.csv", "-mistakes.csv", "-mistakes.svg")]
    for path in paths:
        _refuse_same(path, key)
        tables.free(path, force)
    keys = _key(key)
    files, problems = _files(answers, leave_out=paths)
    given, typed = [], dict[tuple[str, str], str]()
    for file in files:
        try:
            given.append(tables.read(file, ("student", "exercise", "answer")))
        except CourseError as error:  # one student's file does not stop the others
            problems.append(str(error))
        else:
            _collect(given[-1], keys.rows, typed)
    if not given:
        raise CourseError("\n".join(["none of the files could be read", *problems]))
    found = _graded(keys, typed)
    tables.write(paths[0], GRADES, [tuple(vars(g).values()) for g in found], force)
    totals, counts = _totals(found), _counts(found)
    tables.write(paths[1], TOTALS, totals, force)
    tables.write(paths[2], COUNTS, counts, force)
    _picture(paths[3], counts)
    problems += [words for table in (keys.table, *given) for words in _first(table.problems)]
    return problems, _summary(keys.versions, totals, counts, paths)


@dataclass
class Keys:
    """The key by student and exercise, each row with its line number."""

    table: tables.Table
    rows: dict[tuple[str, str], tuple[int, tables.Row]]

    @property
    def versions(self) -> set[str]:
        """The versions of the bank that the key was dealt from."""
        return {row["version"] for _, row in self.rows.values()}


def _key(path: str | Path) -> Keys:
    table = tables.read(path, KEY[:-1])
    rows: dict[tuple[str, str], tuple[int, tables.Row]] = {}
    for line, row in table.rows:
        if row["exercise"] not in exercises():
            table.refuse(line, f"there is no exercise {row['exercise']!r}")
        elif _person(row) in rows:
            table.refuse(line, f"{row['student']} has {row['exercise']} already")
        else:
            rows[_person(row)] = (line, row)
    return Keys(table, rows)


def _person(row: tables.Row) -> tuple[str, str]:
    return dealing.folded(row["student"]), row["exercise"]


def _first(problems: Sequence[str]) -> list[str]:
    """The first problems of a file, and how many more there are."""
    more = len(problems) - TOLD
    return [*problems[:TOLD], *([f"… and {more:,} more of this kind"] if more > 0 else [])]


def _refuse_same(out: str | Path, read: str | Path) -> None:
    if Path(out).resolve() == Path(read).resolve():
        raise CourseError(f"{out} is what is read: give another name to write to")


def _files(paths: Sequence[str | Path], leave_out: Sequence[Path]) -> tuple[list[Path], list[str]]:
    """The files, and those in the folders and their folders; and those that are no tables."""
    found, problems = [], []
    own = {path.resolve() for path in leave_out}
    for path in map(Path, paths):
        inside = sorted(p for p in path.rglob("*") if p.is_file()) if path.is_dir() else [path]
        inside = [file for file in inside if file.resolve() not in own]
        csv = [file for file in inside if file.suffix.lower() == ".csv" or not path.is_dir()]
        problems += [f"{file}: not read, only .csv files are" for file in inside if file not in csv]
        if not csv:
            raise CourseError(f"there is no .csv file in {path}")
        found += csv
    return found, problems


def _collect(
    given: tables.Table,
    keys: Mapping[tuple[str, str], tuple[int, tables.Row]],
    typed: dict[tuple[str, str], str],
) -> None:
    """Add what each student answered last; lines that fit no line of the key are noted."""
    students = {student for student, _ in keys}
    for line, row in given.rows:
        person = _person(row)
        course = keys[person][1]["course"] if person in keys else ""
        if person[0] not in students:
            given.refuse(line, f"{row['student']!r} is not in the key")
        elif person not in keys:
            given.refuse(line, f"{row['student']} has no exercise {row['exercise']!r}")
        elif row.get("course", course) not in ("", course):
            given.refuse(line, f"answered in the course {row['course']!r}, the key is {course!r}")
        elif not row["answer"]:
            given.refuse(line, f"{row['student']} has an empty answer to {row['exercise']}")
        else:
            if person in typed:
                given.refuse(line, f"{row['student']} answers {row['exercise']} again: this counts")
            typed[person] = row["answer"]


def _graded(keys: Keys, typed: Mapping[tuple[str, str], str]) -> list[Graded]:
    """Each line of the key with what was answered; an exercise's answers are judged together."""
    rows: dict[str, list[tuple[int, tables.Row]]] = {}
    for line, row in keys.rows.values():
        rows.setdefault(row["exercise"], []).append((line, row))
    found: dict[tuple[str, str], Graded] = {}
    for name, same in progress(list(rows.items()), "exercises"):
        variants = _variants(name, same, keys.table)
        known = [row for _, row in same if row["numbers"] in variants]
        answered = [row for row in known if _person(row) in typed]
        places = {numbers: place for place, numbers in enumerate(variants)}
        answers = [(places[row["numbers"]], typed[_person(row)]) for row in answered]
        verdicts = judging.check_all(exercises()[name], list(variants.values()), answers)
        for row in known:
            found[_person(row)] = Graded(row["student"], name, "", "missing", "", "")
        for row, (_, text), v in zip(answered, answers, verdicts, strict=True):
            found[_person(row)] = Graded(row["student"], name, text, v.result, v.name, v.says)
    return [found[person] for person in keys.rows if person in found]


def _variants(
    name: str, rows: Iterable[tuple[int, tables.Row]], keys: tables.Table
) -> dict[str, tuple[judging.Candidate, ...]]:
    """What can be answered with the numbers of each row; rows with strange numbers are noted."""
    found: dict[str, tuple[judging.Candidate, ...]] = {}
    for line, row in rows:
        numbers = row["numbers"]
        if numbers in found:
            continue
        try:
            found[numbers] = judging.candidates(exercises()[name], json.loads(numbers))
        except Exception as error:  # whatever a formula makes of numbers that are not its own
            keys.refuse(line, f"{name} cannot be computed from {numbers}: {error}")
    return found


def _totals(graded: Iterable[Graded]) -> list[tuple[object, ...]]:
    results: dict[str, Counter[str]] = {}
    for g in graded:
        results.setdefault(g.student, Counter())[g.result] += 1
    return [(student, *(count[r] for r in TOTALS[1:])) for student, count in results.items()]


def _counts(graded: Sequence[Graded]) -> list[Count]:
    """How many students made which mistake in which exercise, the most frequent first."""
    answered = Counter(g.exercise for g in graded if g.result != "missing")
    made = Counter((g.exercise, g.mistake) for g in graded if g.result in COUNTED)
    comments = {(g.exercise, g.mistake): g.comment for g in graded if g.result in COUNTED}
    return [
        (exercise, mistake or "none known", count, answered[exercise], comments[exercise, mistake])
        for (exercise, mistake), count in made.most_common()
    ]


def _picture(path: Path, counts: Sequence[Count]) -> None:
    """Bars: the most frequent mistakes of the class."""
    from matplotlib.figure import Figure  # heavy, and nothing else of a teacher's needs it

    shown = counts[:BARS][::-1]
    figure = Figure(figsize=(8, 1 + 0.35 * max(1, len(shown))), layout="constrained")
    axes = figure.subplots()
    names = [f"{exercise}: {mistake}" for exercise, mistake, *_ in shown]
    bars = axes.barh(range(len(shown)), [row[2] for row in shown], color="#0072b2")
    axes.set_yticks(range(len(shown)), names)
    axes.bar_label(bars, padding=3)
    axes.set_xlabel("students")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path)


def _summary(
    versions: set[str],
    totals: Sequence[tuple[Any, ...]],
    counts: Sequence[Count],
    paths: Sequence[Path],
) -> str:
    sums = [f"{sum(row[k] for row in totals)} {TOTALS[k]}" for k in range(1, len(TOTALS))]
    lines = [f"{len(totals)} students: {', '.join(sums)}", ""]
    if versions - {dealing.version()}:
        lines += [
            f"The key was dealt from version {', '.join(sorted(versions))} of the bank; this is "
            f"{dealing.version()}. The students' numbers are the key's, the answers this bank's.",
            "",
        ]
    for exercise, name, count, of, comment in counts[:BARS]:
        known = mistakes()[name].says if name in mistakes() else comment
        lines.append(f"{count:5} of {of:5}  {exercise:24} {name:14} {known}")
    return "\n".join([*lines, "", *(f"written: {path}" for path in paths)])


def _beside(out: str | Path, end: str) -> Path:
    path = Path(out)
    return path.with_name(path.stem + end) if end else path


def _students(roster: str | Path) -> tuple[tables.Table, list[str]]:
    """The names of a roster; empty and repeated ones are noted."""
    table = tables.read(roster, ("student",))
    names: dict[str, int] = {}
    for line, row in table.rows:
        name = dealing.folded(row["student"])
        if not name:
            table.refuse(line, "no student's name")
        elif name in names:
            table.refuse(line, f"{name} is in line {names[name]} already")
        else:
            names[name] = line
    if not names:
        raise CourseError(f"{table.path} names no student")
    return table, list(names)


def chosen(only: Sequence[str]) -> list[Exercise]:
    """The exercises with these names; all if none is named."""
    named = [dealing.find(name) for name in dict.fromkeys(only)]
    return named or list(exercises().values())


def progress(items: Sequence[T], what: str) -> Iterator[T]:
    """The items one by one, with a line on the screen that says how far it is."""
    shown, told = sys.stderr.isatty(), 0.0
    for number, item in enumerate(items, start=1):
        yield item
        if shown and (time.monotonic() - told > 0.1 or number == len(items)):
            told = time.monotonic()
            done = "█" * (30 * number // len(items))
            print(f"\r{done:30} {number:,} of {len(items):,} {what}", end="", file=sys.stderr)
    if shown:
        print(file=sys.stderr)
