"""For teachers: everyone's answer key, sheets to print, grades and what the class gets wrong.

The tables are documented in the chapter for teachers. All functions note bad lines and go on with
the good ones; nothing is overwritten without `force`.
"""

import json
import re
import secrets
import sys
from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cache
from html import escape
from pathlib import Path

from courseware.errors import CourseError
from courseware.practice import class_page, dealing, judging, tables
from courseware.practice.bank import Exercise, exercises, mistakes
from courseware.practice.class_page import RESULTS, Count, Graded
from courseware.practice.collecting import Collected, Keys, collect, folded, read_key
from courseware.practice.wording import paragraphs, symbols

KEY = ("kind", "course", "version", "student", "exercise", "variant", "numbers", "answer")
GRADES = ("student", "exercise", "answer", "result", "mistake", "comment")
TOTALS = ("student", *RESULTS)
COUNTS = ("exercise", "mistake", "students", "of", "comment")
COUNTED = ("wrong", "partly")
MOST = 15  # the most frequent mistakes, in the summary
SECRET = 16  # characters at least


def key(
    roster: str | Path,
    out: str | Path,
    course: str,
    only: Sequence[str] = (),
    secret: str = "",
    force: bool = False,
) -> list[str]:
    """Write everyone's numbers and right answers. Gives back what is wrong with the roster."""
    problems = tables.Problems(shown=sys.maxsize)
    students = _students(roster, problems)
    _refuse_same(out, roster)
    salt = course + secret
    course += ", secret" if secret else ""  # answers to the page's numbers are none to these
    with tables.writing(out, KEY, force) as write:
        for student in students:
            for e in chosen(only):
                number = dealing.dealt(salt, e.name, student)
                number %= len(dealing.variants(e.name, secret))
                row = (student, e.name, number, *_dealt(e.name, number, secret))
                write(("key", course, dealing.version(), *row))
    return problems.lines()


@cache
def _dealt(name: str, number: int, secret: str) -> tuple[str, str]:
    """The numbers of a variant as JSON, and its right answer as text."""
    variant = dealing.variants(name, secret)[number]
    answer = exercises()[name].answer_text(variant.numbers)
    return json.dumps(variant.numbers, ensure_ascii=False), answer


def secret_of(path: str | Path | None, make: bool = False) -> str:
    """The secret in a file; `make` writes a new one where there is none. "" without a file."""
    if path is None:
        return ""
    path = Path(path)
    if make and not path.exists():
        path.write_text(secrets.token_hex(SECRET) + "\n", encoding="utf-8")
    try:
        secret = path.read_text(encoding="utf-8").strip()
    except (OSError, UnicodeDecodeError) as error:
        raise CourseError(f"{path} cannot be read: {error}; `key --secret` makes one") from error
    if len(secret.split()) > 1:
        raise CourseError(f"the secret in {path} must be one word: `key --secret` makes one")
    if len(secret) < SECRET:
        raise CourseError(
            f"the secret in {path} has {len(secret)} characters, which can be guessed: "
            f"{SECRET} are the least; delete the file, and `key --secret` makes another"
        )
    return secret


def sheets(key: str | Path, out: str | Path, force: bool = False) -> list[str]:
    """Write a page for each student of the key, to print or to hand out, without answers."""
    problems = tables.Problems(shown=sys.maxsize)
    students: dict[str, list[tables.Row]] = {}
    for _, row in read_key(key, problems).rows.values():
        students.setdefault(row["student"], []).append(row)
    folder = Path(out)
    if folder.is_file():
        raise CourseError(f"{folder} is a file: give the name of a folder")
    folder.mkdir(parents=True, exist_ok=True)
    for student in students:
        tables.free(folder / _file_name(student), force)
    for student, rows in students.items():
        page = _sheet(student, rows)
        (folder / _file_name(student)).write_text(page, encoding="utf-8")
    return problems.lines()


def _file_name(student: str) -> str:
    """A name that every file system takes, and no two students share."""
    plain = re.sub(r"\W+", "-", student).strip("-")[:40]
    return f"{plain}-{dealing.fnv1a(student):08x}.html"


SHEET = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{student}: {course}</title>
<meta name="viewport" content="width=device-width"><style>
:root {{ color-scheme: light dark; }}
body {{ font: 11pt/1.5 sans-serif; max-width: 42rem; margin: 2rem auto; padding: 0 1rem; }}
section {{ break-inside: avoid; margin: 1.2rem 0; }} h2 {{ font-size: 1rem; margin: 0; }}
p {{ margin: .2rem 0; }} input {{ font: inherit; width: 100%; box-sizing: border-box; }}
@media print {{ .screen {{ display: none; }}
  input {{ border: 0; border-bottom: 1px solid; height: 2.4rem; }} }}
</style></head><body data-course="{course}" data-version="{version}" data-student="{student}">
<h1>{student}</h1><p>Course: {course}. The numbers in this sheet are yours alone. Give four
decimals. Where rad is asked, degrees with their sign are right too: 30°. Whole turns more or less
do not matter in an angle.</p>
<p class="screen">Answers can be 0.5, 1/3, pi/3, 30°, a list: [1, 2], or a matrix:
[[1, 2], [3, 4]]. Nothing is checked here: what you type stays in this browser. Save it and hand in
the file.</p>
{exercises}<p class="screen"><button type="button">Save my answers (CSV)</button></p>
<script>{script}</script></body></html>
"""


def _sheet(student: str, rows: Sequence[tables.Row]) -> str:
    folder, scripts = Path(__file__).parent, ("storage.js", "saving.js", "sheet.js")
    return SHEET.format(
        student=escape(student),
        course=escape(rows[0]["course"]),
        version=escape(rows[0]["version"]),
        exercises="\n".join(_question(row["exercise"], row["numbers"]) for row in rows),
        script="const part = {};\n" + "".join((folder / n).read_text("utf-8") for n in scripts),
    )


@cache
def _question(name: str, numbers: str) -> str:
    exercise = exercises()[name]
    try:
        drawn = json.loads(numbers)
        shown = {each: how.shown(how.option(drawn[each])) for each, how in exercise.given.items()}
    except (ValueError, KeyError, TypeError) as error:
        raise CourseError(
            f"the key has numbers of {name} that cannot be used, {numbers}: make it again"
        ) from error
    return (
        f"<section><h2>{name}: {escape(exercise.title)}</h2>"
        f"{paragraphs(exercise.filled(exercise.text, drawn, shown))}<p><label>Answer, "
        f'{symbols(judging.asked(exercise))}: <input name="{name}" autocomplete="off" '
        f'autocapitalize="off" spellcheck="false"></label></p></section>'
    )


def check(answers: Sequence[str | Path], key: str | Path) -> tuple[list[str], str]:
    """What grading would find: problems, and an account to print. Nothing is written."""
    problems = tables.Problems()
    keys = read_key(key, problems)
    found = collect(answers, keys, problems, leave_out=())
    return problems.lines(), "\n".join([*_account(found), "nothing was written"])


def _account(found: Collected) -> list[str]:
    """Whose answers were found, in what files, of which courses and versions."""
    keys, strangers = found.keys, [str(path) for path, count in found.files.items() if not count]
    asked = {exercise for _, exercise in keys.rows}
    lines = [
        f"the key: {len(keys.students):,} students, {len(asked)} exercises, course "
        f"{', '.join(sorted(keys.courses))}, version {', '.join(sorted(keys.versions))}",
        f"answers that count: {len(found.typed):,}, of "
        f"{len(keys.students) - len(found.silent):,} students, in {len(found.files):,} files",
    ]
    for what, counts in (("course", found.courses), ("version", found.versions)):
        lines += [f"  {what} {name or '(not said)'}: {n:,} lines" for name, n in counts.items()]
    for what, names in (
        ("students of whom nothing came", found.silent),
        ("files without an answer of anybody in the key", strangers),
    ):
        lines += [f"{what}: {len(names):,}", *(f"  {name}" for name in names)] if names else []
    return lines


def grade(
    answers: Sequence[str | Path], key: str | Path, out: str | Path, force: bool = False
) -> tuple[list[str], str]:
    """Grade what was handed in. Gives back what was left out or replaced, and a summary to print.

    answers: files, or folders in which also the key, rosters and old grades may lie. Beside `out`
    come the students' totals, the class's mistakes, all problems, and a page that shows the class.
    """
    out = Path(out)
    if not out.name or out.suffix == ".html":
        raise CourseError(f"{out} is no name for a table: give one that ends in .csv")
    ends = ("-students.csv", "-mistakes.csv", "-problems.csv", ".html")
    paths = [out, *(out.with_name(out.stem + end) for end in ends)]
    for path in paths:
        _refuse_same(path, key)
        tables.free(path, force)
    with tables.writing(paths[3], tables.PROBLEMS, force) as write:
        problems = tables.Problems(write)
        keys = read_key(key, problems)
        collected = collect(answers, keys, problems, leave_out=paths)
        found = _graded(keys, collected, problems)
        tables.write(paths[0], GRADES, (tuple(vars(g).values()) for g in found), force)
        totals, counts = _totals(found), _counts(found)
        tables.write(paths[1], TOTALS, totals, force)
        tables.write(paths[2], COUNTS, counts, force)
    course = ", ".join(sorted(keys.courses))
    paths[4].write_text(class_page.page(course, found, counts), encoding="utf-8")
    lines = [*_account(collected), "", *_summary(keys, totals, counts), ""]
    return problems.lines(), "\n".join([*lines, *(f"written: {path}" for path in paths)])


def _refuse_same(out: str | Path, read: str | Path) -> None:
    if Path(out).resolve() == Path(read).resolve():
        raise CourseError(f"{out} is what is read: give another name to write to")


def _graded(keys: Keys, collected: Collected, problems: tables.Problems) -> list[Graded]:
    """Each line of the key with what was answered; an exercise's answers are judged together."""
    typed = {person: given.answer for person, given in collected.typed.items()}
    rows: dict[str, list[tuple[int, tables.Row]]] = {}
    for line, row in keys.rows.values():
        rows.setdefault(row["exercise"], []).append((line, row))
    found: dict[tuple[str, str], Graded] = {}
    for name, same in rows.items():
        variants = _variants(name, same, keys, problems)
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
    name: str, rows: Iterable[tuple[int, tables.Row]], keys: Keys, problems: tables.Problems
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
            words = f"{name} cannot be computed from {numbers}: {type(error).__name__}: {error}"
            problems.note("lines of the key that cannot be used", keys.path, line, words, row)
    return found


def _person(row: tables.Row) -> tuple[str, str]:
    return folded(row["student"]), row["exercise"]


def _totals(graded: Iterable[Graded]) -> list[tuple[str | int, ...]]:
    results: dict[str, Counter[str]] = {}
    for g in graded:
        results.setdefault(g.student, Counter())[g.result] += 1
    return [(student, *(count[r] for r in RESULTS)) for student, count in results.items()]


def _counts(graded: Sequence[Graded]) -> list[Count]:
    """How many students made which mistake in which exercise, the most frequent first."""
    answered = Counter(g.exercise for g in graded if g.result != "missing")
    made = Counter((g.exercise, g.mistake) for g in graded if g.result in COUNTED)
    comments = {(g.exercise, g.mistake): g.comment for g in graded if g.result in COUNTED}
    return [
        (exercise, mistake or "none known", count, answered[exercise], comments[exercise, mistake])
        for (exercise, mistake), count in made.most_common()
    ]


def _summary(
    keys: Keys, totals: Sequence[tuple[str | int, ...]], counts: Sequence[Count]
) -> list[str]:
    sums = [f"{sum(int(row[k]) for row in totals):,} {TOTALS[k]}" for k in range(1, len(TOTALS))]
    lines = [", ".join(sums), ""]
    if keys.versions - {dealing.version()}:
        lines += [
            f"The key is of version {', '.join(sorted(keys.versions))} of the bank, this is "
            f"{dealing.version()}. The students' numbers are the key's, the answers this bank's.",
            "",
        ]
    for exercise, name, count, of, comment in counts[:MOST]:
        known = mistakes()[name].says if name in mistakes() else comment
        lines.append(f"{count:5} of {of:5}  {exercise:24} {name:14} {known}")
    return lines


def _students(roster: str | Path, problems: tables.Problems) -> list[str]:
    """The names of a roster as they are written; empty and repeated ones are noted."""
    path, names = Path(roster), dict[str, tuple[int, str]]()
    for line, row in tables.rows(path, problems, ("student",)):
        alike = folded(row["student"])
        if not alike:
            problems.note("lines without a student's name", path, line)
        elif alike in names:
            words = f"{row['student']} is in line {names[alike][0]} already"
            problems.note("students named twice", path, line, words)
        else:
            names[alike] = line, row["student"]
    if not names:
        raise CourseError("\n".join([f"{path} names no student", *problems.lines()]))
    return [written for _, written in names.values()]


def chosen(only: Sequence[str]) -> list[Exercise]:
    """The exercises with these names; all if none is named."""
    named = [dealing.find(name) for name in dict.fromkeys(only)]
    return named or list(exercises().values())
