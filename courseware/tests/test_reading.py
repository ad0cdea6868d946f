"""The reader of typed answers, held to a table, and to texts whose value is known otherwise."""

import json
import math
import random
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import pytest
from declared import EXERCISES, each
from hypothesis import given, settings

from courseware.practice import Exercise, judging, variants
from courseware.practice.candidates import Candidate
from courseware.script import engine, parts

GROUPS = json.loads(Path(__file__).with_name("answers.json").read_text(encoding="utf-8"))
ROWS = [row for rows in GROUPS.values() for row in rows]
RTOL = 1e-15  # a few roundings of numbers, fractions and roots
PROBLEMS = engine.run("courseware.PROBLEMS")

many = settings(max_examples=40)  # each makes 100 texts, or 50, from a seed: drawing is slow
seeds = st.integers(0, 2**32)


@dataclass(frozen=True)
class Reading:
    """What was read: values, or the code of a problem and the piece of text it is about."""

    values: list[Any]
    problem: str = ""
    about: str = ""


def floats(value):
    """JSON writes whole numbers without a point."""
    if isinstance(value, list):
        return [floats(part) for part in value]
    return value if value is None else float(value)


def numbers(value):
    """All numbers of a value, however nested."""
    return [x for part in value for x in numbers(part)] if isinstance(value, list) else [value]


def shape(value):
    return [shape(part) for part in value] if isinstance(value, list) else 0


def is_same(found, expected):
    return shape(found) == shape(expected) and all(
        math.isclose(x, y, rel_tol=RTOL)
        for x, y in zip(numbers(found), numbers(expected), strict=True)
    )


def assert_read(reading, expected, text):
    assert any(is_same(value, expected) for value in reading.values), f"{text!r}: {reading}"


def distinct(values):
    """Values in their order, without one that is another in one more pair of brackets."""
    found = []
    for value in values:
        inner = value[0] if isinstance(value, list) and len(value) == 1 else value
        if value not in found and inner not in found:
            found.append(value)
    return found


def read(texts):
    """The readings of texts, in one call, after the checks that hold for every text."""
    found = engine.call("((texts) => texts.map(courseware.parseAnswer))", texts)
    return [checked(text, one) for text, one in zip(texts, found, strict=True)]


def checked(text, found):
    problems = {(one["problem"], one["about"]) for one in found}
    assert len(problems) == 1, text
    [(problem, about)] = problems
    values = [] if problem else [floats(one["value"]) for one in found]
    assert (problem in PROBLEMS) == (not values), text
    assert len(about) <= (20 if problem else 0), text
    assert all(type(x) is float and math.isfinite(x) for x in numbers(values)), text
    assert "-0.0" not in map(repr, numbers(values)), text
    return Reading(distinct(values), problem, about)


# The table


def test_the_table_has_every_problem_and_no_duplicates():
    assert len({text for text, _ in ROWS}) == len(ROWS)
    refused = {
        result["problem"] for _, result in ROWS if isinstance(result, dict) and "problem" in result
    }
    assert refused == set(PROBLEMS) - {"units"}  # of what is asked, below


@pytest.mark.parametrize("group", GROUPS)
def test_the_reader_gives_the_results_of_the_table(group):
    rows = GROUPS[group]
    for (text, result), found in zip(rows, read([text for text, _ in rows]), strict=True):
        if isinstance(result, dict) and "values" in result:
            assert found.values == floats(result["values"]), f"{text!r}: {found}"
        elif isinstance(result, dict):
            assert found.problem == result["problem"], f"{text!r}: {found}"
        else:
            assert_read(found, result, text)


ABOUT = [
    ("  v = 0.5", "v ="),
    ("0.5 m/s, 1", "m/s"),
    ("[1, 2 \u00a0kg\u200b²]", "kg²"),
    ("[1, (2, 3]", "]"),
    ("[1,  2  3]", "2  3"),
    ("1.2.3", "1.2.3"),
    ("1 " + "ab" * 20, "ab" * 10),
]


def test_a_problem_names_the_piece_as_it_was_typed():
    for (text, about), found in zip(ABOUT, read([text for text, _ in ABOUT]), strict=True):
        assert found.about == about, text


def test_a_message_names_what_it_is_about():
    for code, message in PROBLEMS.items():
        assert message.count("{about}") == (code != "empty"), code
        shown = message.format(about="{1, 2} $&", units="")
        assert "{1, 2} $&" in shown or code == "empty"


def test_nothing_typed_is_run():
    code = parts.bundle_pages()
    assert "parseAnswer" in code
    assert not re.search(r"\b(eval|Function)\b", code)


# Every character, and 4,000 calculations


def test_every_character_of_the_basic_plane():
    characters = [chr(code) for code in range(0x10000)]
    points = {c for c, found in _each(characters) if 1.2 in found.values}
    assert points == set(".٫．,，")
    separators = set(";؛；،、,，\n\r\x85\u2028\u2029")
    assert {c for c, found in _each(characters) if found.values[:1] == [[1, 2]]} >= separators


@cache
def _each_of(characters):
    return read([f"1{c}2" for c in characters])


def _each(characters):
    return zip(characters, _each_of(tuple(characters)), strict=True)


BLANKS = ["", "", " ", "  ", "\u00a0", "\u200b", "\u2009"]
SCRIPTS = ["0123456789", "۰۱۲۳۴۵۶۷۸۹", "٠١٢٣٤٥٦٧٨٩", "０１２３４５６７８９"]
SIGNS = {"+": "+➕", "-": "-−–—\u2010", "*": "*×·∙⋅", "/": "/÷∕⁄"}
NAMES = {"pi": math.pi, "PI": math.pi, "π": math.pi, "np.pi": math.pi, "½": 0.5, "⅓": 1 / 3}


def in_digits(text, digits):
    return text.translate({ord("0") + k: digit for k, digit in enumerate(digits)})


def apply(sign, left, right):
    """One step of a calculation; NaN where there is no value."""
    if sign == "/":
        return left / right if right else math.nan
    return left + right if sign == "+" else left - right if sign == "-" else left * right


def root(x):
    return math.sqrt(x) if x >= 0 else math.nan


def literal(r):
    """A number as it may be typed, and its value."""
    kind = r.randrange(4)
    if kind == 0:
        return r.choice(sorted(NAMES.items()))
    if kind == 1:
        text = f"{r.randrange(100)}e-3"
        return text, float(text)
    text = str(r.randrange(10000)) + r.choice(["", ".", ".5", ".125"])
    return in_digits(text, r.choice(SCRIPTS)), float(text)


def factor(r, depth):
    """The text of a factor, its value, and whether it must be in parentheses behind a sign."""
    text, value = literal(r)
    kind, blank = r.randrange(8 if depth else 5), r.choice(BLANKS)
    if kind == 1:
        text, value = f"√{blank}{text}", root(value)
    elif kind == 2:
        return text + blank + r.choice(["°", "º", " deg"]), value * (math.pi / 180), True
    elif kind == 3:
        count = r.randrange(2, 100)
        return f"{count}{blank}π", count * math.pi, True
    elif kind == 4:
        return r.choice(SIGNS["-"]) + blank + text, -value, False
    elif kind > 4:
        inner, other = calculation(r, depth - 1)
        if kind == 7:
            return f"({text}){blank}({inner})", value * other, True
        name, value = ("", other) if kind == 5 else ("sqrt", root(other))
        text = f"{name}({blank}{inner}{blank})"
    return text, value, False


def product(r, depth):
    text, value, _ = factor(r, depth)
    for _ in range(r.randrange(3)):
        more, right, joined = factor(r, depth)
        sign, blank = r.choice("*/"), r.choice(BLANKS)
        text += blank + r.choice(SIGNS[sign]) + blank + (f"({more})" if joined else more)
        value = apply(sign, value, right)
    return text, value


def calculation(r, depth):
    """The text of a calculation, and its value: from the parts, not from the text."""
    text, value = product(r, depth)
    for _ in range(r.randrange(3)):
        more, right = product(r, depth)
        sign, blank = r.choice("+-"), r.choice(BLANKS)
        text += blank + r.choice(SIGNS[sign]) + blank + more
        value = apply(sign, value, right)
    return text, value


@many
@given(seeds)
def test_calculations(seed):
    r = random.Random(seed)
    made = [calculation(r, 2) for _ in range(100)]
    for (text, value), found in zip(made, read([text for text, _ in made]), strict=True):
        if len(text) > 1000:
            assert found.problem == "long"
        elif math.isnan(value):
            assert found.problem in ("zero", "root"), f"{text!r}: {found}"
        else:
            assert_read(found, value, text)


SOME = (
    "0|1|000|5|.5|0,5|1e3|1e308|½|π|2π|۵|+|-|−|*|/|^|²|=|°|deg|√|sqrt(|array(|np.|nan|sin|m|e|'|_"
)
SOME += "|,|, |;|،|؛|.|٫|(|)|[|]|{|}| |\n|\u200b"
PIECES = st.lists(st.sampled_from(SOME.split("|"))).map("".join)


@given(st.lists(PIECES | st.text(), max_size=20))
def test_any_text_is_read_or_refused(texts):
    read(texts)


def test_blanks_round_a_text_do_not_make_it_long():
    """A table of answers loses them, so that `grade` reads the text without."""
    padded, long = read([" \n" + "0.5" + 3000 * " ", 600 * "0 "])
    assert_read(padded, 0.5, "0.5")
    assert long.problem == "long"


# --- an answer with more than was asked -----------------------------------------------------------

RATE = [("ω", "rad/s")]
TWIST = [("v", "m/s"), ("ω", "rad/s")]
POINT = [("x", "m"), ("y", "m")]
WIDTH = [("w", "m")]
POSE = [*POINT, ("θ", "rad")]


@pytest.mark.parametrize(
    ("text", "asks", "value"),
    [
        ("2.191.", RATE, 2.191),
        ("0.5 rad/s", RATE, 0.5),
        ("3 m²", [("w", "m²")], 3),
        ("ω = 0.5", RATE, 0.5),
        ("omega≈0.5 rad/s", RATE, 0.5),
        ("0.1 m/s, 0.2 rad/s", TWIST, [0.1, 0.2]),
        ("x=1 m, y=2 m", POINT, [1, 2]),
        ("[1, 2] m", POINT, [1, 2]),
        ("1 mm, 2 m", POINT, [0.001, 2]),
        ("[1 m -200 cm]", POINT, [1, -2]),
        ("[[100, 200], [300, 400]] cm", POINT, [[1, 2], [3, 4]]),
        ("v = 18 km/h, ω = 180 °/s", TWIST, [5, math.pi]),
        ("1, 2, 30°", POSE, [1, 2, math.pi / 6]),
        ("90° + 0.5 rad", [("θ", "rad")], math.pi / 2 + 0.5),
        ("0,5 cm", WIDTH, 0.005),
        ("1/2 cm", WIDTH, 0.005),
        ("۱٫۵ cm", WIDTH, 0.015),
        ("0.51/s", RATE, 0.51),
        ("0.5 1/s", RATE, 0.5),
        ("۰٫۵ ۱/s", RATE, 0.5),
        ("\u200fω = 0.5", RATE, 0.5),
        ("30 deg", [("", "°")], 30),
        ("0.5 rad", [("", "°")], 90 / math.pi),
        ("۲/۱۹۱", RATE, 2.191),
        ("1/3", RATE, 1 / 3),
        ("۱/۳", RATE, 1 / 3),
        ("۱/۳", RATE, 1.3),
        ("≈ 2.191", RATE, 2.191),
        ("ω: 2,191", RATE, 2.191),
        ("x = 0,5; y = 1,5", POINT, [0.5, 1.5]),
        ("-0,043 0,246", POINT, [-0.043, 0.246]),
        ("0.5 rad / s", RATE, 0.5),
        ("0.5 radians/s", RATE, 0.5),
        ("1,234.5 cm", WIDTH, 12.345),
    ],
)
def test_what_is_meant_is_among_the_readings(text, asks, value):
    assert_read(read_typed(text, asks), floats(value), text)


@pytest.mark.parametrize(
    ("text", "asks", "problem"),
    [
        ("0.5 m/s", RATE, "unit"),
        ("0.5 rad", RATE, "unit"),
        ("sin(-30°), 1", POINT, "function"),  # not in newtons, nor in degrees
        ("0.2 rad/s, 0.1 m/s", TWIST, "unit"),  # in the order of the question, or of the units?
        ("50 cm, 1", POINT, "units"),
        ("1 m + 2 cm", WIDTH, "units"),
        ("2-3 cm", WIDTH, "units"),
        ("30°, 1 m", POINT, "unit"),
        ("ω = 0.1, v = 0.2", TWIST, "equals"),
    ],
)
def test_what_cannot_be_meant_is_refused(text, asks, problem):
    assert read_typed(text, asks).problem == problem


def read_typed(text, asks):
    """What is read where numbers of these labels and units are asked."""
    named = [{"label": label, "unit": unit} for label, unit in asks]
    return checked(text, engine.call("courseware.parseTyped", text, named))


# --- an answer to an exercise ---------------------------------------------------------------------

WAYS_TO_TYPE = {
    "as printed": lambda text: text,
    "a decimal comma": lambda text: text.replace(", ", "; ").replace(".", ","),
    "a comma for all": lambda text: text.replace(".", ","),
    "blanks": lambda text: text.replace(", ", " "),
    "a decimal comma and blanks": lambda text: text.replace(", ", " ").replace(".", ","),
    "without brackets": lambda text: text if "[[" in text else re.sub(r"[\[\]]", "", text),
    "about": lambda text: f"≈ {text}",
    "a keyboard's minus": lambda text: text.replace("−", "-"),
    "Persian digits": lambda text: in_digits(text, SCRIPTS[1]).replace(".", "٫"),
    "in one more bracket": lambda text: text if "[" in text or " " in text else f"[{text}]",
}


@pytest.mark.parametrize("every", [16, pytest.param(1, marks=pytest.mark.slow)])
@each("exercise", "exercises", Exercise)
def test_a_right_answer_is_right_however_it_is_typed(exercise, every):
    some = variants.all_variants(exercise.name)[::every]
    candidates = [variant.candidates for variant in some]
    printed = [exercise.format_answer(variant.numbers) for variant in some]
    typed = [
        (k, way(one))
        for way in WAYS_TO_TYPE.values()
        for k, text in enumerate(printed)
        for one in (text.split(" or ")[0],)
    ]
    verdicts = judging.judge_all(exercise, candidates, typed)
    refused = {
        text: verdict.feedback
        for (_, text), verdict in zip(typed, verdicts, strict=True)
        if verdict.result != "right"
    }
    assert not refused


def rate(wrong):
    """Made up: 1.234 is right, and 1234 what somebody gets who makes a mistake."""
    exercise = EXERCISES["differential-drive-1"]
    named = [Candidate("right", ((1.234,),)), Candidate(next(iter(exercise.wrong)).name, wrong)]
    return lambda text: judging.judge(exercise, named, text)


def test_of_two_readings_the_one_that_is_known_counts():
    judge = rate(((2345.0,),))
    assert judge("1,234").read == "Read as 1.234 rad/s."
    assert judge("1,234").result == "right"
    mistake = judge("2,345")
    assert (mistake.result, mistake.read) == ("wrong", "Read as 2345 rad/s.")
    assert mistake.name
    unknown = judge("7,891")
    assert (unknown.name, unknown.read) == ("", "Read as 7.891 rad/s.")


def test_two_readings_that_are_both_known_are_asked_back():
    assert rate(((1234.0,),))("1,234").result == "right"
    exercise = EXERCISES["differential-drive-1"]
    first, second = list(exercise.wrong)[:2]
    named = [Candidate("right", ((9.0,),))]
    named += [Candidate(first.name, ((1.234,),)), Candidate(second.name, ((1234.0,),))]
    verdict = judging.judge(exercise, named, "1,234")
    assert verdict.result == "unread"
    assert "1.234 rad/s" in verdict.feedback
    assert "1234 rad/s" in verdict.feedback
