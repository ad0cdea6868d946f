"""The answers to a question of Moodle, number by number.

Moodle judges each number by itself: the first answer in whose tolerance it is.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import product

from courseware.answers import Unknown
from courseware.errors import CourseError
from courseware.practice import judging, variants
from courseware.practice.candidates import RIGHT, SLIPS, distance, outcomes
from courseware.practice.exercises import Exercise, Row
from courseware.units import ROWS
from courseware.units.formatting import render_symbols

OTHER_ROW = "These numbers belong to another right answer than the one that is asked."
FACTORS = {"sign": -1.0, "twice": 2.0, "half": 0.5}  # slips that a single number shows
ENDS: dict[str, Callable[[float], float]] = {  # which of several right answers is asked: the first
    "largest": lambda x: -x,
    "smallest": lambda x: x,
    "farthest from 0": lambda x: -abs(x),
    "nearest to 0": abs,
}
APART = 10  # times what is allowed: numbers that are so far apart are compared safely
# meets every number, and is as long as a number can be in Moodle: the longest answer of a field
# makes its width, which must not tell how long the right one is
ANYTHING, ANY_TOLERANCE = "-1234567.1234567", 1e30


def choose_row(exercise: Exercise, variant: variants.Variant) -> tuple[str, Row]:
    """Return which of the right answers is asked, in words and in numbers.

    The words fit one of them only, and not the answers of somebody who makes a mistake.
    """
    rows: dict[str, list[Row]] = {}
    for candidate in variant.candidates:
        rows.setdefault(candidate.name, []).extend(candidate.rows)
    if len(rows["right"]) == 1:
        return "", rows["right"][0]
    mistakes = [rows[mistake.name] for mistake in exercise.wrong]
    found = []
    for place, end in product(range(len(exercise.unknowns)), ENDS):
        asked = _find_extreme(exercise, rows["right"], place, end)
        if len(asked) == 1:
            made = [row for each in mistakes for row in _find_extreme(exercise, each, place, end)]
            shared = max((_count_alike(exercise, row, asked[0]) for row in made), default=0)
            found.append((shared, place, end, asked[0]))
    if not found:
        raise CourseError(f"{exercise.name} has right answers that no number tells apart")
    _, place, end, row = min(found, key=lambda rule: rule[0])
    unknown = exercise.unknowns[place]
    turns = " (angles from −π to π)" if unknown.circle else ""
    words = f"the one whose {render_symbols(unknown.label)} is {end}{turns}"
    return f"<p>Here write only one of the right answers: {words}.</p>", row


def _find_extreme(exercise: Exercise, rows: Sequence[Row], place: int, end: str) -> list[Row]:
    """Return the row whose number there is at this end; all rows that may be it, if in doubt."""
    unknown = exercise.unknowns[place]
    values = [math.remainder(r[place], math.tau) if unknown.circle else r[place] for r in rows]
    margin = APART * max(map(unknown.allowed, values))
    ranks = [ENDS[end](value) for value in values]
    is_cut = unknown.circle and max(map(abs, values)) > math.pi - margin  # where −π is π
    if is_cut and "0" not in end:
        return [*rows]
    return [row for row, rank in zip(rows, ranks, strict=True) if rank < min(ranks) + margin]


def _count_alike(exercise: Exercise, one: Row, other: Row) -> int:
    triples = zip(exercise.unknowns, one, other, strict=True)
    return sum(distance(unknown, x, y) <= 2 * unknown.allowed(y) for unknown, x, y in triples)


def find_answers(
    exercise: Exercise, variant: variants.Variant, row: Row, place: int
) -> Iterator[tuple[bool, str, float, str]]:
    """Yield the answers for one number of a row: whether it is right, value, tolerance, feedback.

    Moodle takes the first that fits. Where several mistakes give one number, all are named.
    """
    unknown, right = exercise.unknowns[place], row[place]
    allowed = unknown.allowed(right)
    for turn in (0, -2 * math.pi, 2 * math.pi) if unknown.circle else (0,):
        yield True, f"{right + turn:.9f}", allowed, RIGHT
    wrong = [*_wrong_values(exercise, variant, place), *_values_in_other_units(unknown, right)]
    if len(exercise.unknowns) > 1:
        wrong += _slips(exercise, right, place, wrong)
    known = set[float]()
    for value, tolerance, _ in wrong:
        if value not in known and distance(unknown, value, right) > allowed + tolerance:
            known.add(value)
            alike = [f for x, t, f in wrong if distance(unknown, value, x) <= tolerance + t]
            words = render_symbols(" Or: ".join(dict.fromkeys(alike))).replace("&#x27;", "'")
            yield False, f"{value:.9f}", tolerance, words
    near = judging.find_constant("NEAR") * allowed
    yield False, f"{right:.9f}", near, judging.format_feedback("near", digits="")
    yield False, ANYTHING, ANY_TOLERANCE, judging.format_feedback("wrong")


def _wrong_values(
    exercise: Exercise, variant: variants.Variant, place: int
) -> Iterator[tuple[float, float, str]]:
    """Yield the results of mistakes for one number, with tolerance and feedback."""
    unknown, meanings = exercise.unknowns[place], outcomes(exercise)
    is_single = len(exercise.unknowns) == 1
    for candidate in variant.candidates:
        meaning = meanings[candidate.name]
        is_named = meaning.result == "wrong" and (is_single or not is_slip(candidate.name))
        for row in candidate.rows if is_named or meaning.result == "right" else ():
            feedback = meaning.feedback if is_named else OTHER_ROW
            yield row[place], unknown.allowed(row[place]), feedback


def _values_in_other_units(unknown: Unknown, right: float) -> Iterator[tuple[float, float, str]]:
    for unit in ROWS[unknown.unit][1:] if unknown.unit else ():
        feedback = f"The right value in {unit.name}. Asked is {unknown.unit}."
        factor = unit.from_si(1.0)
        yield right * factor, unknown.allowed(right) * factor, feedback


def _slips(
    exercise: Exercise, right: float, place: int, known: Sequence[tuple[float, float, str]]
) -> list[tuple[float, float, str]]:
    """Return the slips of one number that are not the result of a mistake."""
    unknown, meanings = exercise.unknowns[place], outcomes(exercise)
    slips = [
        (factor * right, unknown.allowed(factor * right), meanings[f"slip:{name}"].feedback)
        for name, factor in FACTORS.items()
    ]
    return [s for s in slips if all(distance(unknown, s[0], x) > s[1] + t for x, t, _ in known)]


def is_slip(name: str) -> bool:
    """Return whether a candidate is a slip that anybody may make in any exercise."""
    return name.removeprefix("slip:") in SLIPS
