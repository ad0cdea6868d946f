"""Is an answer right, and if not, which mistake does it look like?

Every variant has a list of candidates: the right answers, what each mistake gives, the right
answers in other units, and the common slips. They are made here, by the exercise's formulas. The
judge is `judging.js`, on the page as in Python: an answer is the first candidate that it meets
within the tolerance.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from courseware.practice.bank import Ask, Exercise
from courseware.script import engine
from courseware.units import ROWS, TABLE

Row = tuple[float, ...]

RIGHT = "This check passed."
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
    """An answer that somebody may give. rows: one, or all that must be given in any order.

    name: "right", a mistake's name, "unit:degrees" or "slip:sign".
    """

    name: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class Outcome:
    """What meeting a candidate means: right, partly (another unit) or wrong, and what is said.

    factors: for each number asked, its size in the unit of the candidate. why: a mistake is one;
    picture: in words, what a picture shows of it.
    """

    result: str
    says: str
    factors: Row
    why: str = ""
    picture: str = ""


@dataclass(frozen=True)
class Verdict:
    """The answer to an answer. result: right, partly, wrong, or unread (it counts for nothing).

    read: what was read.
    """

    result: str
    name: str
    says: str
    read: str = ""

    def __repr__(self) -> str:
        return self.says


@cache
def outcomes(exercise: Exercise) -> dict[str, Outcome]:
    """Every name that a candidate of this exercise can have, and what it means."""
    ones = (1.0,) * len(exercise.asks)
    found = {"right": Outcome("right", RIGHT, ones)}
    done = {m.name: (m.says, m.why, m.picture) for m in exercise.wrong}
    done |= {f"slip:{words}": (words, "", None) for words in exercise.also}
    for name, (words, why, picture) in done.items():
        says, shows = f"Not yet. This is what you get {words}.", picture.shows if picture else ""
        found[name] = Outcome("wrong", says, ones, why, shows)
    for name, factors in _units(exercise.asks).items():
        asked = " and ".join(dict.fromkeys(a.unit for a in exercise.asks if _slips_of(a.unit)))
        says = (
            f"The right value, but in other units ({name}). Asked is {asked}: please type it again."
        )
        found[f"unit:{name}"] = Outcome("partly", says, factors)
    for name, says in SLIPS.items():
        found[f"slip:{name}"] = Outcome("wrong", says, ones)
    return found


def _units(asks: Sequence[Ask]) -> dict[str, Row]:
    """The other units that an answer may be in: name → factor of each number asked.

    All lengths are in the same one, and all angles.
    """
    slips = [_slips_of(ask.unit) for ask in asks]
    ordered = [_slips_of(row[0].name) for row in TABLE]
    kinds = dict.fromkeys(("", *each) for each in ordered if each in slips)
    return {
        " and ".join(filter(None, names)): tuple(
            math.prod(factors.get(name, 1.0) for name in names) for factors in slips
        )
        for names in product(*kinds)
        if any(names)
    }


def _slips_of(unit: str) -> Mapping[str, float]:
    """The other units that are meant where this one is asked: name → factor of the number."""
    return {other.slip: other.from_si(1.0) for other in ROWS[unit] if other.slip}


def candidates(exercise: Exercise, numbers: Mapping[str, Any]) -> tuple[Candidate, ...]:
    """All that can be answered to an exercise with these numbers, in the order of judging."""
    right = _grouped(exercise, exercise.answers(exercise.right, numbers), "right")
    wrong = _made(exercise, {m.name: f for m, f in exercise.wrong.items()}, numbers)
    also = _made(exercise, {f"slip:{words}": f for words, f in exercise.also.items()}, numbers)
    units = [
        Candidate(f"unit:{name}", tuple(_floats(np.multiply(row, factors)) for row in c.rows))
        for name, factors in _units(exercise.asks).items()
        for c in right
    ]
    taken = [*right, *units]
    also = [a for a in also if _finite(a) and all(apart(exercise, a, other) for other in taken)]
    known = [*right, *wrong, *units, *also]
    for slip in _slips(exercise, right):
        if all(apart(exercise, slip, other) for other in known):
            known.append(slip)
    return tuple(known)


def _made(
    exercise: Exercise, ways: Mapping[str, Callable[..., ArrayLike]], numbers: Mapping[str, Any]
) -> list[Candidate]:
    """What is answered in each of these ways, by the names of the candidates."""
    return [
        candidate
        for name, formula in ways.items()
        for candidate in _grouped(exercise, exercise.answers(formula, numbers), name)
    ]


def _grouped(exercise: Exercise, rows: Any, name: str) -> list[Candidate]:
    tuples = tuple(map(_floats, rows))
    if exercise.accept == "all":
        return [Candidate(name, tuples)]
    return [Candidate(name, (row,)) for row in dict.fromkeys(tuples)]


def _slips(exercise: Exercise, right: Sequence[Candidate]) -> list[Candidate]:
    """The common slips, for answers of which one row is enough."""
    if exercise.accept == "all":
        return []
    found = []
    for row in (np.array(candidate.rows[0]) for candidate in right):
        slips = {"sign": -row, "twice": 2 * row, "half": row / 2}
        units = {ask.unit for ask in exercise.asks}
        if len(row) == 2 and len(units) == 1:
            slips["swapped"] = row[::-1]
        if len(set(exercise.shape)) == 1 and len(exercise.shape) == 2:
            slips["transposed"] = row.reshape(exercise.shape).T.ravel()
        if len(row) == 1 and units == {"rad"}:
            if exercise.asks[0].circle:
                slips["half-turn"] = row + math.pi
            else:
                slips["turn"] = row + 2 * math.pi
                found.append(Candidate("slip:turn", (_floats(row - 2 * math.pi),)))
        found += [Candidate(f"slip:{name}", (_floats(value),)) for name, value in slips.items()]
    return found


def _finite(candidate: Candidate) -> bool:
    """Whether all is a number; a huge one is what rounding made of a division by zero."""
    return all(abs(x) < 1e9 for row in candidate.rows for x in row)


def clash(exercise: Exercise, possible: Sequence[Candidate]) -> str:
    """Two candidates that an answer could both mean, as text; "" if there are none.

    Of what is no documented mistake all is said that gives a number.
    """
    possible = [one for one in possible if not one.name.startswith("slip:")]
    for place, one in enumerate(possible):
        if not _finite(one):
            return f"{one.name} is no number"
        for other in possible[:place]:
            if one.name != other.name and not apart(exercise, one, other):
                return f"{other.name} and {one.name}"
    return ""


def apart(exercise: Exercise, one: Candidate, other: Candidate) -> bool:
    """Whether no answer can meet both."""
    meant = outcomes(exercise)
    first, second = meant[one.name].factors, meant[other.name].factors
    if _meet(exercise.asks, one.rows, other.rows, first, second):
        return False
    mutual = first == second and len(one.rows) == 1
    return mutual or not _meet(exercise.asks, other.rows, one.rows, second, first)


def _meet(
    asks: Sequence[Ask], rows: Sequence[Row], wanted: Sequence[Row], own: Row, factors: Row
) -> bool:
    """Whether each row may be taken for one of the wanted ones, each of them once."""
    left = list(wanted)
    for row in rows:
        for place, other in enumerate(left):
            if all(map(_near, asks, row, other, own, factors)):
                del left[place]
                break
        else:
            return False
    return not left


def _near(ask: Ask, x: float, wanted: float, own: float, factor: float) -> bool:
    allowed = ask.allowed(x, own) + ask.allowed(wanted, factor)
    return off(ask, x, wanted, factor) <= allowed


def off(ask: Ask, x: float, wanted: float, factor: float = 1.0) -> float:
    """How far x is from what is wanted; an angle on the circle. factor: the size of its unit."""
    apart = abs(x - wanted)
    if not ask.circle:
        return apart
    turn = 2 * math.pi * abs(factor)
    return min(apart % turn, turn - apart % turn)


def asked(exercise: Exercise) -> str:
    """What an answer must look like, in words: "2 numbers: v in m/s, ω in rad/s".

    A unit that all have stands once, at the end.
    """
    asks, kind = exercise.asks, "number"
    named = [f"{a.label} in {a.unit}" if a.unit else a.label for a in asks]
    if len({a.unit for a in asks}) == 1:
        named[:-1] = [a.label for a in asks[:-1]]
    names = ", ".join(named)
    if exercise.shape:
        rows, columns = exercise.shape
        return f"a matrix: {rows} rows of {columns} numbers"
    if not any(ask.decimals for ask in asks):
        kind = "whole number"
    if max(ask.decimals for ask in asks) > 3:
        names += ", to four decimals"
    numbers = f"one {kind}: {names}" if len(asks) == 1 else f"{len(asks)} {kind}s: {names}"
    if exercise.accept == "all":
        return f"all answers, in any order, each {numbers}"
    return f"{numbers} (any of the right answers)" if exercise.accept == "any" else numbers


def _floats(row: Any) -> Row:
    return tuple(map(float, row))


def essence(exercise: Exercise) -> dict[str, Any]:
    """What the judge must know of an exercise, whatever its numbers."""
    return {
        "asked": asked(exercise),
        "asks": [vars(ask) for ask in exercise.asks],
        "decimals": max(a.decimals for a in exercise.asks),
        "shape": exercise.shape,
        "accept": exercise.accept,
        "outcomes": {name: vars(outcome) for name, outcome in outcomes(exercise).items()},
    }


def listed(exercise: Exercise, possible: Sequence[Candidate]) -> list[tuple[str, list[Row]]]:
    """Candidates as the judge gets them: to a hundredth of the tolerance, the rest is weight.

    The right answers in other units are missing: the judge makes them.
    """
    digits = [2 - math.floor(math.log10(ask.tolerance)) for ask in exercise.asks]
    return [
        (c.name, [tuple(map(_rounded, row, digits)) for row in c.rows])
        for c in possible
        if not c.name.startswith("unit:")
    ]


def _rounded(number: float, digits: int) -> float:
    return round(number, digits) + 0.0  # no -0


def says(what: str, **words: str) -> str:
    """A sentence of the page's own judge."""
    return str(_fixed(f"FEEDBACK.{what}")).format(**words)


def near() -> float:
    """How many tolerances off is "very close"."""
    return float(_fixed("NEAR"))


@cache
def _fixed(name: str) -> Any:
    """A text or number of the page's judge; asked for once, as every question takes 0.3 ms."""
    return engine.run(f"courseware.{name}")


def check(exercise: Exercise, possible: Sequence[Candidate], typed: str) -> Verdict:
    """The verdict on what was typed; "unread", with a reason, where it is no such answer."""
    return check_all(exercise, [possible], [(0, typed)])[0]


def check_all(
    exercise: Exercise,
    variants: Sequence[Sequence[Candidate]],
    answers: Sequence[tuple[int, str]],
) -> list[Verdict]:
    """The verdicts on many answers, each with the number of its variant, in one call."""
    lists = [listed(exercise, possible) for possible in variants]
    found = engine.call("courseware.judgeAnswers", essence(exercise), lists, answers)
    return [Verdict(**verdict) for verdict in found]
