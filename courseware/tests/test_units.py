"""The table of units, and all that takes its units from there: declarations, answers, printing."""

import itertools
import json
import re
from dataclasses import replace

import hypothesis.strategies as st
import numpy as np
import pytest
from declared import EXERCISES
from hypothesis import given, settings
from scipy import constants
from sympy import symbols

from courseware.answers import Unknown
from courseware.equations.quantities import declarations
from courseware.errors import CourseError
from courseware.figures import Readout, Slider
from courseware.practice import LocalEquation, Step, judging, number_range, one_of
from courseware.practice.candidates import Candidate
from courseware.predictions import Number
from courseware.script import engine
from courseware.units import TABLE, UNITS
from courseware.units.formatting import append_unit

quantity, symbol = declarations(__name__)

SI = [row[0] for row in TABLE]
SIZES = {  # of the words in names; SciPy's
    **{"cm": constants.centi, "mm": constants.milli, "km": constants.kilo},
    **{"ms": constants.milli, "min": constants.minute, "h": constants.hour},
    **{"°": constants.degree, "turns": 2 * constants.pi, "%": constants.centi},
}
BETWEEN = {
    **{"/": ["/", " / ", "÷", " per "], "·": ["·", "*", " ", ""], " ": [" ", "*"]},
    **{"²": ["²", "^2", "**2", "2"], "1": [" 1", ""]},
}


def size(name):
    """The size of a unit, from those of its words."""
    whole = 1.0
    for k, side in enumerate(name.split("/")):
        for word in re.split("[· ]", side):
            whole *= SIZES.get(word.rstrip("²"), 1) ** ((-1) ** k * (2 if "²" in word else 1))
    return whole


def ways(unit):
    """All that may be typed for a unit."""
    known = {unit.name: unit.words for unit in UNITS.values()}
    for word in unit.words:
        pieces = filter(None, re.split("([/· ²1])", word))
        typed = (
            BETWEEN.get(piece) or ([piece] if piece in unit.words else known.get(piece, [piece]))
            for piece in pieces
        )
        yield from map("".join, itertools.product(*typed))


WAYS = [
    (unit, row[0].name, way) for row in TABLE for unit in row if unit.name for way in ways(unit)
]


def parse_first(rows):
    """What is read of texts, each with the units of the numbers that are asked for."""
    named = [(text, [{"label": unit, "unit": unit} for unit in units]) for text, units in rows]
    read = "((rows) => rows.map(([text, asks]) => courseware.parseTyped(text, asks)[0]))"
    return engine.call(read, named)


def judge_one(typed, unit, right):
    """The verdict on what is typed where one number in this unit is asked."""
    exercise = replace(EXERCISES["differential-drive-1"], unknowns=(Unknown("x", unit),))
    return judging.judge(exercise, [Candidate("right", ((right,),))], typed)


# The table


def test_each_unit_has_one_row_and_the_size_that_its_name_says():
    assert len(UNITS) == sum(map(len, TABLE))
    for unit in UNITS.values():
        assert np.isclose(unit.factor, size(unit.name), rtol=1e-15), (
            f"{unit.name} is {unit.factor} of its SI unit in the table, but {size(unit.name)} by "
            "the words in its name: correct it, or put a new word into SIZES here"
        )
    assert {unit.factor for unit in SI} == {1}


def test_one_spelling_is_one_unit_of_a_size():
    """Whatever its capitals are; of two sizes it may be: 1/s are radians in a second, too."""
    typed = [(si, way.lower()) for _, si, way in WAYS]
    assert len(typed) == len(set(typed))


def test_three_decimals_are_enough_and_one_of_an_angle_in_degrees():
    for unit in SI:
        assert 5e-4 < unit.tolerance < 1e-3
        assert "rad" not in unit.name.split("/") or np.radians(0.05) < unit.tolerance


# Declarations

KNOWN = r"known are %, m, cm, .*write one of these, or add yours .*courseware/units/table\.py"
a, b = symbols("a b")
DECLARED = {  # who declares a unit, and how the message calls it
    "a quantity": (lambda unit: quantity("v", unit, 0, 1, "speed"), "the symbol v"),
    "a symbol": (lambda unit: symbol("N", "a number", unit=unit), "the symbol N"),
    "a slider": (lambda unit: Slider(quantity("v", unit, 0, 1, "speed"), 0, 1, 0, 0.1), "symbol v"),
    "an answer": (lambda unit: Unknown("v", unit), "the answer v"),
    "a line": (lambda unit: LocalEquation(a, b, unit), "the equation with a"),
    "a line of several": (lambda unit: LocalEquation(a, b, ("m", unit)), "the equation with a"),
    "a step": (lambda unit: Step(LocalEquation(a, b), unit=unit), "the step of a solution"),
}
SHOWN = {  # the same of a unit that only the reader sees
    "a readout": (lambda unit: Readout("error", "error", a, unit), "the readout error"),
    "a given number": (lambda unit: one_of(1, 2, unit=unit), r"number drawn from \(1, 2\)"),
    "given numbers": (lambda unit: number_range(1, 2, 1, unit), r"the number drawn from \(1, 2\)"),
    "a guess": (lambda unit: Number(unit, 1.0), "a guess"),
}


@pytest.mark.parametrize("unit", ["furlong", "M", None])
@pytest.mark.parametrize(("declare", "who"), [*DECLARED.values(), *SHOWN.values()])
def test_an_unknown_unit_is_refused_with_those_that_are_known(declare, who, unit):
    got = re.escape(repr(unit))
    with pytest.raises(CourseError, match=rf"{who} has the unit {got}; {KNOWN}"):
        declare(unit)


@pytest.mark.parametrize(("declare", "who"), DECLARED.values(), ids=DECLARED)
def test_what_formulas_compute_is_declared_in_si(declare, who):
    with pytest.raises(CourseError, match=rf"{who} has the unit 'km/h', but .*: write 'm/s'"):
        declare("km/h")
    for unit in SI:
        declare(unit.name)


@pytest.mark.parametrize(("declare", "who"), SHOWN.values(), ids=SHOWN)
def test_what_only_the_reader_sees_may_be_in_any_unit(declare, who):
    for unit in UNITS:
        declare(unit)


def test_a_given_number_has_its_size():
    assert one_of(18, unit="km/h").to_si(18) == 5
    assert one_of(18, unit="km/h").format(5) == "18 km/h"


# Answers


@settings(max_examples=20)
@given(st.decimals(-1000, 1000, places=3), st.booleans())
def test_every_spelling_is_read_as_its_size_says(number, in_capitals):
    """In the browser's engine the very same number as in Python."""
    rows = [(f"{number} {way.upper() if in_capitals else way}", [si]) for _, si, way in WAYS]
    for (unit, si, _), (text, _), found in zip(WAYS, rows, parse_first(rows), strict=True):
        if (unit.name, si) == ("°", "rad"):  # read in its place, in calculations, too
            assert np.isclose(found["value"], np.radians(float(number)), rtol=1e-15), text
        else:
            assert found["value"] == unit.to_si(float(number)) + 0, (text, si, found)


@given(st.data())
def test_a_list_may_have_a_unit_for_each_number_or_one_for_all(data):
    row = data.draw(st.sampled_from([row for row in TABLE if row[0].name != "rad"]))
    names = data.draw(
        st.lists(st.sampled_from([u.name for u in row if u.name] or ["%"]), min_size=2)
    )
    numbers = data.draw(st.lists(st.integers(-99, 99), min_size=len(names), max_size=len(names)))
    asks = [row[0].name] * len(names)
    every = ", ".join(f"{x} {name}" for x, name in zip(numbers, names, strict=True))
    for_all = f"[{', '.join(map(str, numbers))}] {names[0]}"
    one, other = parse_first([(every, asks), (for_all, asks)])
    assert one["value"] == [UNITS[u].to_si(x) + 0 for u, x in zip(names, numbers, strict=True)]
    assert other["value"] == [UNITS[names[0]].to_si(x) + 0 for x in numbers]


def test_a_unit_of_another_size_is_not_read():
    fits = {(si, way) for _, si, way in WAYS}
    rows = [
        (f"5 {unit}", [si.name])
        for si in SI
        for unit in UNITS
        if unit and (si.name, unit) not in fits and (si.name, f" {unit}") not in fits
    ]
    for (text, (si,)), found in zip(rows, parse_first(rows), strict=True):
        assert (found["problem"], found["about"]) == ("unit", text[2:]), (text, si)


@pytest.mark.parametrize(
    ("typed", "result"),
    [
        *[("5 m/s", "right"), ("18 km/h", "right"), ("500 cm per second", "right"), ("5", "right")],
        *[("5 km/h", "wrong"), ("500", "partly"), ("5 furlong", "unread"), ("5 m/s²", "unread")],
        *[("5 s", "unread"), ("5°", "unread"), ("0.5 rad", "unread"), ("5 m s", "unread")],
    ],
)
def test_a_speed_is_graded_in_the_unit_that_is_typed(typed, result):
    verdict = judge_one(typed, "m/s", 5)
    assert verdict.result == result, verdict
    if result == "unread":
        assert "a unit that fits: m/s, cm/s, mm/s, km/h" in verdict.feedback


# Printing


def test_python_and_the_script_print_a_unit_alike():
    shown = engine.run(f"{json.dumps(list(UNITS))}.map((unit) => courseware.withUnit('5', unit))")
    assert shown == [append_unit("5", unit) for unit in UNITS]
    assert [append_unit("5", unit) for unit in ("", "°", "%", "°/s")] == ["5", "5°", "5%", "5 °/s"]
