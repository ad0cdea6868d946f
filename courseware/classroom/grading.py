"""Grades of what students handed in: each answer's result, and totals."""

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

from courseware.classroom.answer_key import UNUSABLE, Key, Task, read_key
from courseware.classroom.collecting import NEVER, Answer, Collected, collect
from courseware.classroom.tables import Problem, Problems
from courseware.practice import judging, variants
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.candidates import Candidate, find_candidates
from courseware.practice.saving import refuse_existing, write_table

RESULTS = ("right", "partly", "wrong", "unread", "missing")
TOTALS = ("student", *RESULTS)
ENDINGS = ("-students.csv", "-problems.csv")  # of files beside the grades
MOST_SHOWN = 12  # mistakes
NOTHING = Answer("", NEVER, Path(), 0)


class Graded(NamedTuple):
    """One line of the grades."""

    student: str
    exercise: str
    answer: str
    result: str
    mistake: str
    comment: str
    tries: str
    help: str


def grade(answers: Sequence[Path], key: Path, out: Path, force: bool) -> tuple[list[str], str]:
    """Grade files and folders of answers; return their problems, and a summary to print.

    Beside `out` come the students' totals, and all problems.
    """
    paths = [out, *(out.with_name(out.stem + ending) for ending in ENDINGS)]
    for path in paths:
        refuse_existing(path, force)
    problems = Problems()
    collected = collect(answers, read_key(key, problems), problems, leave_out=paths)
    graded = _grade(collected, problems)
    write_table(paths[0], Graded._fields, graded, force)
    write_table(paths[1], TOTALS, _total(graded), force)
    write_table(paths[2], Problem._fields, problems, force)
    lines = [*_account(collected), "", *_summarize(collected.key, graded), ""]
    return problems.lines(), "\n".join([*lines, *(f"written: {path}" for path in paths)])


def _account(found: Collected) -> list[str]:
    """Say whose answers were found, and whose were not."""
    key, asked = found.key, {name for _, name in found.key.rows}
    heard = {student for student, _ in found.answers}
    lines = [
        f"the key: students: {len(key.students):,}; exercises: {len(asked)}; "
        f"course {key.course}, version {key.version}",
        f"answers that count: {len(found.answers):,}; students: "
        f"{len(heard):,}; files: {len(found.files):,}",
    ]
    silent = [f"  {name}" for student, name in key.students.items() if student not in heard]
    return lines + ([f"students without an answer: {len(silent):,}", *silent] if silent else [])


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
    verdicts = dict.fromkeys(rows, judging.Verdict("missing", "", "")) | dict(
        zip(answers, judged, strict=True)
    )
    found = {}
    for task, v in verdicts.items():
        a, student = answers.get(task, NOTHING), rows[task]["student"]
        judgement = v.result, "" if v.result == "right" else v.name, v.feedback
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


def _total(graded: Iterable[Graded]) -> Iterator[tuple[str | int, ...]]:
    """Yield each student's name and counts of results."""
    counts = Counter((each.student, each.result) for each in graded)
    for student in dict.fromkeys(student for student, _ in counts):
        yield student, *(counts[student, result] for result in RESULTS)


def _summarize(key: Key, graded: Sequence[Graded]) -> list[str]:
    """Return the counts of results, frequent mistakes, unread answers, another version."""
    counts = Counter(each.result for each in graded)
    lines = [", ".join(f"{counts[result]:,} {result}" for result in RESULTS)]
    answered = Counter(each.exercise for each in graded if each.result != "missing")
    made = Counter((each.exercise, each.mistake, each.comment) for each in graded if each.mistake)
    for (exercise, mistake, comment), count in made.most_common(MOST_SHOWN):
        name = f"{mistake}. " if mistake in all_mistakes() else ""  # a slip has none
        lines.append(f"{count} of {answered[exercise]}, {exercise}: {name}{comment}")
    unread = groupby((g for g in graded if g.result == "unread"), itemgetter(0))
    listed = [f"  {student}: {', '.join(g.exercise for g in theirs)}" for student, theirs in unread]
    lines += [f"students with unread answers: {len(listed):,}", *listed] if listed else []
    if key.version != variants.version():
        lines.append(
            f"The key is of version {key.version} of the exercises, this is {variants.version()}. "
            "The students' numbers are the key's, the answers are this version's."
        )
    return lines
