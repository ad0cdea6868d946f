"""The inputs of a program and all that can come of them, as the numbers that `judge` reads."""

import ast
import math
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from typing import Any
from zlib import crc32

import numpy as np
import sympy as sp
from sympy.printing.numpy import NumPyPrinter

from courseware.course import course
from courseware.equations.quantities import NamedSymbol
from courseware.errors import CourseError
from courseware.explaining import KNOWN, LEAST, SIZE, join_numbers
from courseware.judge import as_arguments
from courseware.programs.program import Function, Program

ROUND, RANDOM, EACH = 8, 150, 3  # inputs: of round numbers, random ones, of each special case
MANY = 60  # from which the simplest are taken
# inputs near a special case, twice each: how far, as parts of a range. To take for the case what is
# within a millionth of the range is right.
AWAY = (0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5) * 2
PLAIN = [float(f"{digit}e{power}") for power in range(-3, 6) for digit in (1, 2, 3, 4, 5, 6, 7, 8)]

AS_GIVEN = "These are the answers of the program as it was given: its mistake is still in it."

Numbers = dict[NamedSymbol, float]


@cache
def store(program: Program) -> dict[str, Any]:
    """Return all that the judge knows of a program: drawn by a fixed seed, the same every time."""
    cases = [*draw_cases(program)]
    given = [[_plain(x) for x in program.arguments(*n.values())] for *_, n in cases]
    rights = [_flat(program, program.right, each) for each in given]
    ordinary = [k for k, (special, *_) in enumerate(cases) if not special]
    circle = np.array([unknown.circle for unknown in program.answer])
    size = np.median(np.abs([rights[k] for k in ordinary]), axis=0)
    known = [
        *((f"{KNOWN.format(m.feedback)} {m.why}", f) for m, f in program.wrong.items()),
        *((KNOWN.format(words), f) for words, f in program.likely_slips.items()),
    ]
    entries: list[dict[str, Any]] = [
        {"feedback": words, "answers": [_flat(program, f, given[k]) for k in ordinary]}
        for words, f in known
    ]
    entries += _take_for_degrees(program, [cases[k][-1] for k in ordinary])
    if not program.is_new:  # the name would leave nothing to find
        names: dict[str, Any] = {"np": np}
        exec(program.starter, names)
        starter = names[program.definition.name]
        answers = [_flat(program, starter, given[k]) for k in ordinary]
        for entry in entries:
            if np.allclose(np.array(entry["answers"]), answers, equal_nan=True):
                entry["feedback"] = AS_GIVEN
    return {
        "name": program.name,
        "function": program.definition.name,
        "parameters": ast.unparse(program.definition.args),
        "shape": program.shape or ((len(program.answer),) if len(program.answer) > 1 else ()),
        "circle": circle.tolist(),
        "angles": [unknown.unit.startswith("rad") for unknown in program.answer],
        "tolerance": np.where(circle, SIZE, SIZE * np.maximum(size, LEAST)).tolist(),
        "compared_value": _write_compared_value(program, rights[0], given[0]),
        "library": course().library,
        "cases": [
            {"special": special, "near": near, "arguments": each, "right": right}
            for (special, near, _), each, right in zip(cases, given, rights, strict=True)
        ],
        "known": entries,
    }


def name_numbers(*parts: Any) -> list[Any]:
    """Return arrays of symbols of the shapes of these; one symbol for a number."""
    return [_name_part(f"part_{k}_", np.shape(part)) for k, part in enumerate(parts)]


def _name_part(stem: str, shape: tuple[int, ...]) -> Any:
    if not shape:
        return sp.Symbol(stem, real=True)
    return np.array(sp.symbols(f"{stem}:{np.prod(shape)}", real=True)).reshape(shape)


def _write_compared_value(program: Program, right: list[float], given: list[Any]) -> str:
    """Return what an answer does as Python: of `given`, all numbers of answer and arguments."""
    if not program.compared_value:
        return ""
    parts = name_numbers(right, *given)
    places = enumerate(join_numbers(*parts))
    code = {symbol: sp.Symbol(f"given[{k}]", real=True) for k, symbol in places}
    numbers = [sp.sympify(x).subs(code) for x in np.ravel(program.compared_value(*parts))]
    return str(NumPyPrinter().doprint(numbers))


def draw_cases(program: Program) -> Iterator[tuple[str, bool, Numbers]]:
    """Yield (special case or "", whether it is only near, the symbols' numbers).

    The ordinary inputs come first, so that the name of a special case means no other mistake; of
    these the simplest, and of the special ones those that are met.
    """
    draw = np.random.default_rng(crc32(program.name.encode()))
    rounds = [_draw(program, draw, "", True) for _ in range(MANY)]
    short = sorted(rounds, key=lambda n: len(str([abs(x) for x in n.values()])))[:ROUND]
    for numbers in sorted(short, key=lambda numbers: sum(x < 0 for x in numbers.values())):
        yield "", False, numbers
    for _ in range(RANDOM):
        yield "", False, _draw(program, draw, "", False)
    for special in program.specials:
        for _ in range(EACH):
            yield special, False, _draw(program, draw, special, True)
    for special in program.specials:
        for part in AWAY:
            for numbers in _draw_near(program, draw, special, part):
                yield special, True, numbers


def _draw_near(program: Program, draw: Any, special: str, part: float) -> Iterator[Numbers]:
    """Yield an input that is a part of the range away from a special case, if there is one."""
    for _ in range(100):
        numbers = _draw(program, draw, special, False)
        allowed = program.when(*numbers.values())
        for symbol, value in program.specials[special].items():
            low, high = program.ranges.get(symbol, (symbol.low, symbol.high))
            sign = 1 if value <= low else -1 if value >= high else draw.choice((-1, 1))
            away = sign * part * draw.uniform(0.3, 1) * (high - low)
            numbers[symbol] = value + float(f"{away:.2g}")
        given = [_plain(x) for x in program.arguments(*numbers.values())]
        with suppress(ValueError):  # outside of what the library takes
            finite = np.isfinite(_flat(program, program.right, given)).all()
            if finite and (program.when(*numbers.values()) or not allowed):
                yield numbers
                return


def _draw(program: Program, draw: Any, special: str, simple: bool) -> Numbers:
    """Return an input; of a special case one that may be drawn, if 20 tries find one."""
    fixed = program.specials.get(special, {})
    for tries in range(1000):
        numbers = {
            symbol: fixed.get(symbol, _draw_number(program, symbol, draw, simple))
            for symbol in program.symbols
        }
        free = [abs(x) for s, x in numbers.items() if s not in fixed]
        if simple and len(set(free)) < len(free):
            continue
        if program.when(*numbers.values()) or (special and tries >= 20):
            return numbers
    raise CourseError(f"{program.name}: no input is found {special}; widen its ranges")


def _draw_number(program: Program, symbol: NamedSymbol, draw: Any, simple: bool) -> float:
    low, high = program.ranges.get(symbol, (symbol.low, symbol.high))
    if simple and (plain := list_plain(low, high)):
        return plain[int(draw.integers(len(plain)))]
    return float(f"{draw.uniform(low, high):.4g}")


@cache
def list_plain(low: float, high: float) -> list[float]:
    """Return the plain numbers in a range, of these the ones that are not small there."""
    plain = [s * x for x in PLAIN for s in (1, -1) if low <= s * x <= high]
    return [x for x in plain if abs(x) >= 0.05 * max(abs(low), abs(high))] or plain


def _plain(value: Any) -> Any:
    """Return an argument as JSON has it."""
    if isinstance(value, int | float):
        return value
    return np.asarray(value, dtype=float).tolist()


def _flat(program: Program, function: Function, given: list[Any]) -> list[float]:
    """Return the answer of a function as a list of numbers."""
    with np.errstate(all="ignore"):
        answer = np.asarray(function(*as_arguments(given)), dtype=float).ravel()
    if answer.shape != (len(program.answer),):
        raise CourseError(f"{program.name}: {answer.size} numbers, asked are {len(program.answer)}")
    return [float(f"{x:.13g}") for x in answer]


def _take_for_degrees(program: Program, cases: list[Numbers]) -> Iterator[dict[str, Any]]:
    """Yield what somebody gets who takes an angle that is given, or all of them, for degrees."""
    angles = [symbol for symbol in program.symbols if symbol.unit == "rad"]
    which = {f"when {symbol.code or symbol} is taken for degrees": [symbol] for symbol in angles}
    if len(angles) > 1:
        which["when all angles are taken for degrees"] = angles
    for words, some in which.items():
        scaled = [[math.radians(x) if s in some else x for s, x in n.items()] for n in cases]
        given = [[_plain(x) for x in program.arguments(*each)] for each in scaled]
        if any(np.ndim(x) > 1 for x in given[0]):
            return  # a matrix has no angles that could be taken for anything
        try:
            answers = [_flat(program, program.right, each) for each in given]
        except ValueError:
            continue  # outside of what the library takes
        yield {"feedback": KNOWN.format(words), "answers": answers}
