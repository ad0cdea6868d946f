"""Grades of what students handed in: each answer's result, totals, the mistakes of the class."""

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from contextlib import nullcontext
from itertools import groupby
from operator import itemgetter
from pathlib import Path

from classroom import class_page
from classroom.answer_key import UNUSABLE, Key, Task, read_key, refuse_same
from classroom.class_page import RESULTS, Count, Graded
from classroom.collecting import NEVER, Answer, Collected, collect
from classroom.tables import PROBLEMS, Problems
from courseware.errors import CourseError
from courseware.practice import dealing, judging
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.candidates import Candidate, find_candidates
from courseware.practice.saving import open_table, refuse_existing, write_table

TOTALS = ("student", *RESULTS)
ENDINGS = ("-students.csv", "-mistakes.csv", "-problems.csv", ".html")  # of files beside the grades
NOTHING = Answer("", NEVER, Path(), 0)
MISSING = judging.Verdict("missing", "", "")
MOST_FREQUENT = 15  # mistakes in the summary

Total = tuple[str | int, ...]


def check(
    answers: Sequence[Path], key: Path, out: Path | None, force: bool
) -> tuple[list[str], str]:
    """Return the problems that grading would find, and an account to print.

    Nothing is written but all problems, into the table `out` if there is one.
    """
    if out:
        refuse_same(out, key)
    with open_table(out, PROBLEMS, force) if out else nullcontext(len) as write:
        problems = Problems(write)
        found = collect(answers, read_key(key, problems), problems, leave_out=[out] if out else [])
    end = f"written: {out}" if out else "nothing was written"
    return problems.lines(), "\n".join([*_account(found), end])


def grade(answers: Sequence[Path], key: Path, out: Path, force: bool) -> tuple[list[str], str]:
    """Grade files and folders of answers; return their problems, and a summary to print.

    Beside `out` come the students' totals, the class's mistakes, all problems, and a page that
    shows the class.
    """
    if not out.name or out.suffix == ".html":
        raise CourseError(f"{out} is no name for a table: give one that ends in .csv")
    paths = [out, *(out.with_name(out.stem + ending) for ending in ENDINGS)]
    for path in paths:
        refuse_same(path, key)
        refuse_existing(path, force)
    with open_table(paths[3], PROBLEMS, force) as write:
        problems = Problems(write)
        collected = collect(answers, read_key(key, problems), problems, leave_out=paths)
        graded = _grade(collected, problems)
        write_table(paths[0], Graded._fields, graded, force)
        totals, counts = _total(graded), _count_mistakes(graded)
        write_table(paths[1], TOTALS, totals, force)
        write_table(paths[2], Count._fields, counts, force)
    course = ", ".join(sorted(collected.key.courses))
    paths[4].write_text(class_page.render(course, graded, counts), encoding="utf-8")
    lines = [*_account(collected), "", *_summarize(collected.key, totals, counts), ""]
    return problems.lines(), "\n".join([*lines, *(f"written: {path}" for path in paths)])


def _account(found: Collected) -> list[str]:
    """Say whose answers were found, in which files, of which courses and versions."""
    key, strangers = found.key, [str(path) for path, count in found.files.items() if not count]
    asked = {name for _, name in key.rows}
    lines = [
        f"the key: students: {len(key.students):,}; exercises: {len(asked)}; "
        f"course {', '.join(sorted(key.courses))}, version {', '.join(sorted(key.versions))}",
        f"answers that count: {len(found.answers):,}; students: "
        f"{len(key.students) - len(found.silent):,}; files: {len(found.files):,}",
    ]
    for what, counts in (("course", found.courses), ("version", found.versions)):
        lines += [f"  lines of {what} {name or '(none)'}: {n:,}" for name, n in counts.items()]
    for what, names in (
        ("students without an answer", found.silent),
        ("files without an answer of these students", strangers),
    ):
        lines += [f"{what}: {len(names):,}", *(f"  {name}" for name in names)] if names else []
    return lines


def _grade(collected: Collected, problems: Problems) -> list[Graded]:
    """Grade each line of the key, all answers to an exercise together."""
    rows, exercise = collected.key.rows, itemgetter(1)
    found: dict[Task, Graded] = {}
    for name, tasks in groupby(sorted(rows, key=exercise), exercise):
        found |= _grade_exercise(name, list(tasks), collected, problems)
    return [found[task] for task in rows if task in found]


def _grade_exercise(
    name: str, tasks: Sequence[Task], collected: Collected, problems: Problems
) -> dict[Task, Graded]:
    key = collected.key
    variants = _candidates(name, tasks, key, problems)
    places = {numbers: place for place, numbers in enumerate(variants)}
    rows = {p: row for p in tasks if (row := key.rows[p][1])["numbers"] in places}
    answers = {p: collected.answers[p] for p in rows if p in collected.answers}
    typed = [(places[rows[task]["numbers"]], each.answer) for task, each in answers.items()]
    judged = judging.judge_all(all_exercises()[name], list(variants.values()), typed)
    verdicts = dict.fromkeys(rows, MISSING) | dict(zip(answers, judged, strict=True))
    found = {}
    for task, v in verdicts.items():
        a, student = answers.get(task, NOTHING), rows[task]["student"]
        judgement = v.result, v.name, v.feedback
        found[task] = Graded(student, name, a.answer, *judgement, a.tries, a.help)
    return found


def _candidates(
    name: str, tasks: Iterable[Task], key: Key, problems: Problems
) -> dict[str, tuple[Candidate, ...]]:
    """Return the candidates for each set of numbers; note rows with strange numbers."""
    found: dict[str, tuple[Candidate, ...]] = {}
    for line, row in map(key.rows.__getitem__, tasks):
        numbers = row["numbers"]
        try:
            if numbers not in found:
                found[numbers] = find_candidates(all_exercises()[name], json.loads(numbers))
        except Exception as error:  # a formula may raise anything on numbers that are not its own
            words = f"{name} cannot be computed from {numbers}: {type(error).__name__}: {error}"
            problems.note(UNUSABLE, key.path, line, words, row)
    return found


def _total(graded: Iterable[Graded]) -> list[Total]:
    results: dict[str, Counter[str]] = {}
    for each in graded:
        results.setdefault(each.student, Counter())[each.result] += 1
    return [(student, *(count[r] for r in RESULTS)) for student, count in results.items()]


def _count_mistakes(graded: Iterable[Graded]) -> list[Count]:
    """Count the students who made each mistake in each exercise, the most frequent first."""
    answered, made, comments = Counter[str](), Counter[tuple[str, str]](), {}
    for each in graded:
        answered[each.exercise] += each.result != "missing"
        if each.result in ("wrong", "partly"):
            made[each.exercise, each.mistake] += 1
            comments[each.exercise, each.mistake] = each.comment
    return [
        Count(name, mistake or "none known", count, answered[name], comments[name, mistake])
        for (name, mistake), count in made.most_common()
    ]


def _summarize(key: Key, totals: Sequence[Total], counts: Sequence[Count]) -> list[str]:
    sums = [f"{sum(int(row[k]) for row in totals):,} {TOTALS[k]}" for k in range(1, len(TOTALS))]
    lines = [", ".join(sums), ""]
    if key.versions - {dealing.version()}:
        lines += [
            f"The key is of version {', '.join(sorted(key.versions))} of the exercises, this is "
            f"{dealing.version()}. The students' numbers are the key's, the answers are this "
            "version's.",
            "",
        ]
    for exercise, name, count, of, comment in counts[:MOST_FREQUENT]:
        known = all_mistakes()[name].feedback if name in all_mistakes() else comment
        lines.append(f"{count:5} of {of:5}  {exercise:24} {name:14} {known}")
    return lines
