"""Candidates: all answers that somebody may give to an exercise, and the meaning of each.

Every variant has a list of them: the right answers, the results of the mistakes, the right answers
in other units, and common slips. An answer is judged by the first candidate that it meets.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from courseware.answers import Unknown
from courseware.practice.exercises import Exercise, Row
from courseware.practice.mistakes import Mistake
from courseware.units import ROWS, TABLE

RIGHT = "This check passed."
NAMED = "Not yet. This is what you get {}."
SLIPS = {
    "sign": "Not yet: the size is right, the sign is not.",
    "twice": "Not yet: this is twice the right value.",
    "half": "Not yet: this is half the right value.",
    "swapped": "Not yet: the two numbers are right, but in the wrong order.",
    "transposed": "Not yet: rows and columns are swapped.",
    "half-turn": "Not yet: this direction is off by half a turn.",
    "turn": "Not yet: this is off by a whole turn, and here turns are counted.",
}


@dataclass(frozen=True)
class Candidate:
    """An answer that somebody may give: one row, or all rows that must be given in any order.

    name: "right", a mistake's name, "unit:degrees" or "slip:sign".
    """

    name: str
    rows: tuple[Row, ...]

    def is_finite(self) -> bool:
        """Return whether it has numbers only; a huge one comes from a rounded division by zero."""
        return all(abs(x) < 1e9 for row in self.rows for x in row)


@dataclass(frozen=True)
class Outcome:
    """The meaning of a candidate: right, partly (another unit) or wrong, and the feedback.

    factors: the size of each unknown in the unit of the candidate. why: a mistake is one;
    picture: in words, a picture of its consequence.
    """

    result: str
    feedback: str
    factors: Row
    why: str = ""
    picture: str = ""


@cache
def outcomes(exercise: Exercise) -> dict[str, Outcome]:
    """Return every name that a candidate of this exercise can have, with its meaning."""
    ones = (1.0,) * len(exercise.unknowns)
    found = {"right": Outcome("right", RIGHT, ones)}
    for m in exercise.wrong:
        found[m.name] = Outcome("wrong", NAMED.format(m.feedback), ones, m.why, m.picture)
    for (one, other), name in _pair_names(exercise).items():
        words = f"{one.feedback}, and also {other.feedback}"
        found[name] = Outcome("wrong", NAMED.format(words), ones, f"{one.why} {other.why}")
    for words in exercise.likely_slips:
        found[f"slip:{words}"] = Outcome("wrong", NAMED.format(words), ones)
    units = " and ".join(dict.fromkeys(u.unit for u in exercise.unknowns if _other_units(u.unit)))
    for name, factors in _factors(exercise.unknowns).items():
        feedback = f"The right value, but in other units ({name}). Asked is {units}: please type "
        found[f"unit:{name}"] = Outcome("partly", feedback + "it again.", factors)
    return found | {f"slip:{s}": Outcome("wrong", words, ones) for s, words in SLIPS.items()}


def _pair_names(exercise: Exercise) -> dict[tuple[Mistake, Mistake], str]:
    """Return the names of the candidates of two mistakes made together."""
    return {pair: f"slip:{pair[0].name} and {pair[1].name}" for pair in exercise.together}


@cache
def _factors(unknowns: tuple[Unknown, ...]) -> dict[str, Row]:
    """Return the other units that an answer may be in, with the factor of each of its numbers.

    All lengths are in the same one, and all angles.
    """
    others = [_other_units(unknown.unit) for unknown in unknowns]
    ordered = [_other_units(row[0].name) for row in TABLE]
    kinds = dict.fromkeys(("", *each) for each in ordered if each in others)
    return {
        " and ".join(filter(None, names)): tuple(
            math.prod(factors.get(name, 1.0) for name in names) for factors in others
        )
        for names in product(*kinds)
        if any(names)
    }


def _other_units(unit: str) -> Mapping[str, float]:
    """Return the units that are typed by mistake for this one, with the factor of the number."""
    return {other.slip: other.from_si(1.0) for other in ROWS[unit] if other.slip}


def find_candidates(exercise: Exercise, numbers: Mapping[str, Any]) -> tuple[Candidate, ...]:
    """Return all answers to an exercise with these numbers, in the order of judging."""

    def evaluate(formulas: Mapping[str, Callable[..., ArrayLike]]) -> list[Candidate]:
        found = {name: exercise.evaluate(formula, numbers) for name, formula in formulas.items()}
        if exercise.accept == "all":
            return [Candidate(name, rows) for name, rows in found.items()]
        return [Candidate(n, (row,)) for n, rows in found.items() for row in dict.fromkeys(rows)]

    right = evaluate({"right": exercise.right})
    wrong = evaluate({mistake.name: formula for mistake, formula in exercise.wrong.items()})
    slips = evaluate({f"slip:{words}": formula for words, formula in exercise.likely_slips.items()})
    units = [
        Candidate(f"unit:{name}", tuple(map(tuple, np.multiply(c.rows, factors).tolist())))
        for name, factors in _factors(exercise.unknowns).items()
        for c in right
    ]
    near = _round_right(exercise, right)

    def is_free(slip: Candidate, taken: Sequence[Candidate]) -> bool:
        return all(is_apart(exercise, slip, a) for a in taken) and not _is_met(exercise, slip, near)

    likely = [a for a in slips if a.is_finite() and is_free(a, [*right, *units])]
    known = [*right, *wrong, *units, *likely]
    pairs = evaluate({name: exercise.together[p] for p, name in _pair_names(exercise).items()})
    for slip in [*_slips(exercise, right), *filter(Candidate.is_finite, pairs)]:
        if is_free(slip, known):
            known.append(slip)
    return tuple(known)


def _slips(exercise: Exercise, right: Sequence[Candidate]) -> list[Candidate]:
    """Return the common slips, where one row makes an answer."""
    if exercise.accept == "all":
        return []
    found, units = [], {unknown.unit for unknown in exercise.unknowns}
    for row in (np.array(candidate.rows[0]) for candidate in right):
        slips = [("sign", -row), ("twice", 2 * row), ("half", row / 2)]
        if len(row) == 2 and len(units) == 1:
            slips.append(("swapped", row[::-1]))
        if len(exercise.shape) == 2 and len(set(exercise.shape)) == 1:
            slips.append(("transposed", row.reshape(exercise.shape).T.ravel()))
        if len(row) == 1 and exercise.unknowns[0].circle:
            slips.append(("half-turn", row + math.pi))
        elif len(row) == 1 and units == {"rad"}:
            slips += [("turn", row - 2 * math.pi), ("turn", row + 2 * math.pi)]
        found += [Candidate(f"slip:{name}", (tuple(value.tolist()),)) for name, value in slips]
    return found


def find_clash(exercise: Exercise, possible: Sequence[Candidate]) -> str:
    """Return two candidates that an answer could both mean, as text; "" if there are none.

    Slips do not count: the feedback names all that give a number. A mistake, in any unit, is no
    answer that the judge calls very close.
    """
    possible = [candidate for candidate in possible if not candidate.name.startswith("slip:")]
    near = _round_right(exercise, [c for c in possible if c.name == "right"])
    for place, one in enumerate(possible):
        if not one.is_finite():
            return f"{one.name} is no number"
        for other in possible[:place]:
            if one.name != other.name and not is_apart(exercise, one, other):
                return f"{other.name} and {one.name}"
        if outcomes(exercise)[one.name].result == "wrong" and _is_met(exercise, one, near):
            return f"right, rounded, and {one.name}"
    return ""


def _is_met(exercise: Exercise, candidate: Candidate, answers: Sequence[tuple[Row, ...]]) -> bool:
    """Return whether one of the answers may be taken for a mistake, in any unit."""
    ones = (1.0,) * len(exercise.unknowns)
    for factors in (ones, *_factors(exercise.unknowns).values()):
        wanted = np.multiply(candidate.rows, factors).tolist()
        if any(_can_meet(exercise.unknowns, rows, wanted, ones, factors) for rows in answers):
            return True
    return False


def _round_right(exercise: Exercise, right: Sequence[Candidate]) -> list[tuple[Row, ...]]:
    """Return the right answers as the judge calls them very close: rounded, in any unit."""
    decimals = max(unknown.decimals for unknown in exercise.unknowns)
    found = list[Any]()
    for rows in (np.array(c.rows) for c in right):
        found += [rows.round(digits) for digits in (2, 3) if digits < decimals]
        for factors, digits in product(_factors(exercise.unknowns).values(), (0, 1)):
            shown = rows * factors
            if decimals and (abs(shown) >= 10.0 ** (1 - digits)).all():
                found += [shown.round(digits), shown.round(digits) / factors]
    return list(dict.fromkeys(tuple(map(tuple, rows.tolist())) for rows in found))


def is_apart(exercise: Exercise, one: Candidate, other: Candidate) -> bool:
    """Return whether no answer can meet both candidates."""
    meanings = outcomes(exercise)
    first, second = meanings[one.name].factors, meanings[other.name].factors
    if _can_meet(exercise.unknowns, one.rows, other.rows, first, second):
        return False
    is_mutual = first == second and len(one.rows) == 1
    return is_mutual or not _can_meet(exercise.unknowns, other.rows, one.rows, second, first)


def _can_meet(
    unknowns: Sequence[Unknown], rows: Sequence[Row], wanted: Sequence[Row], own: Row, factors: Row
) -> bool:
    """Return whether each row may be taken for one of the wanted ones, each of them once."""
    left = list(wanted)
    for row in rows:
        for place, other in enumerate(left):
            if all(map(_is_near, unknowns, row, other, own, factors)):
                del left[place]
                break
        else:
            return False
    return not left


def _is_near(unknown: Unknown, x: float, wanted: float, own: float, factor: float) -> bool:
    allowed = unknown.allowed(x, own) + unknown.allowed(wanted, factor)
    return distance(unknown, x, wanted, factor) <= allowed


def distance(unknown: Unknown, x: float, wanted: float, factor: float = 1.0) -> float:
    """Return how far x is from the wanted value; an angle on the circle, in this unit."""
    apart = abs(x - wanted)
    if not unknown.circle:
        return apart
    turn = 2 * math.pi * abs(factor)
    return min(apart % turn, turn - apart % turn)
