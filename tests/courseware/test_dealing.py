"""Dealing: the same numbers in Python and on the page, to whoever has the same name."""

import json
import math
import unicodedata

import numpy as np
from declared import EXERCISES, each

from courseware.practice import Exercise, dealing
from courseware.script import engine as script

each_exercise = each("exercise", "exercises", Exercise)


NAMES = [
    "",
    "Ada",
    " Ada ",
    "Ada  Lovelace",
    "سارا محمدی",
    "José",
    "Jose\u0301",
    "李雷",
    "😀 smile",
    "ß",
]


def names(count):
    """Names of many scripts, with accents and odd spaces."""
    random = np.random.default_rng(1)
    letters = [
        *"abzÅéüñçßøłžαωжяابپچ李王あ한\u0301\u0308\u200d😀🤖",
        *"’´İıIكةأيＡ－–,\u2066",
        " ",
        "\u00a0",
        "\t",
        "-",
        "'",
        "7",
    ]
    made = {"".join(random.choice(letters, random.integers(1, 12))) for _ in range(2 * count)}
    return [*NAMES, *sorted(made)][:count]


def dealt_in_python(course, exercise, people):
    return [dealing.deal(course, exercise, name) for name in people]


DEAL = """(people) => people.map((name) =>
  courseware.dealVariant("2026 Herbst", "euler-1", name))"""


def test_the_engine_deals_the_same():
    """Without other forms (NFKC), which the engine of the build may not know."""
    people = [name for name in names(2000) if unicodedata.is_normalized("NFKC", name)]
    assert len(people) > 500
    found = script.run(f"({DEAL})({json.dumps(people)})")
    assert found == dealt_in_python("2026 Herbst", "euler-1", people)


def test_a_release_deals_as_the_last_one_did():
    """Or who is half-way through the course gets other numbers."""
    dealt = dealt_in_python("robokin", "euler-1", ["", "Ada", "سارا محمدی", "李雷"])
    assert dealt == [11, 43, 44, 15]
    shown = EXERCISES["euler-1"].format_given(dealing.variants("euler-1")[43].numbers)
    assert list(shown.values()) == ["90°", "y", "−30°", "z", "z"]


def test_names_that_look_alike_are_the_same():
    assert dealing.fold_name("  Ada \u00a0 Lovelace\n") == "ada lovelace"
    assert dealing.fold_name("Jose\u0301") == dealing.fold_name("José")
    assert dealing.fold_name("  Ada\u200c \u00a0 ۰۴۷۱\n") == "ada 0471"
    assert dealing.fold_name("ADA ۰۴۷۱") == dealing.fold_name("ada 0471") == "ada 0471"
    assert dealing.fold_name("علي") == dealing.fold_name("علی")  # two letters, one name
    assert dealing.fold_name("A\u200cda\u200d") == "ada"
    typed = "O’Brien-Smith|O´Brien‑Smith|Ｏ＇Ｂｒｉｅｎ－Ｓｍｉｔｈ|\u2066O`Brien–Smith\u2069"
    for alike in typed.split("|"):
        assert dealing.fold_name(alike) == "o'brien-smith"
    assert dealing.fold_name("ALİ IŞIK") == dealing.fold_name("ali işik")
    assert (
        dealing.fold_name("Lovelace, Ada") == dealing.fold_name("Ada  Lovelace") == "ada lovelace"
    )
    assert dealing.fold_name("أحمد فاطمة") == dealing.fold_name("احمد فاطمه")


def test_the_hash_is_fnv1a():
    """The published test values of 32-bit FNV-1a."""
    assert dealing.fnv1a("") == 0x811C9DC5
    assert dealing.fnv1a("a") == 0xE40C292C
    assert dealing.fnv1a("foobar") == 0xBF9CF968


@each_exercise
def test_variants_are_dealt_evenly(exercise):
    """Numbered students: all variants, none twice as often as it should but by chance."""
    dealt = dealt_in_python("course", exercise.name, [f"{k}" for k in range(10_000, 16_400)])
    counts = np.bincount(dealt, minlength=dealing.VARIANTS)
    # 100 each on average, with a standard deviation of 10
    assert counts.min() > 50
    assert counts.max() < 200


def test_another_course_deals_other_variants():
    people = [f"{k}" for k in range(1000)]
    last, this = (dealt_in_python(year, "euler-1", people) for year in ("2025", "2026"))
    assert sum(a == b for a, b in zip(last, this, strict=True)) < 50  # 16 expected by chance


def test_numbers_are_those_of_real_things():
    """A bicycle leans at most so far, a table is no bar, a truck has the wheels of one."""
    for variant in dealing.variants("bicycle-1"):
        n = variant.numbers
        sideways = n["v_front"] ** 2 * math.cos(n["phi"]) * math.sin(n["phi"]) / n["L"]
        assert sideways < 5
    for variant in dealing.variants("frames-6"):
        assert 0.5 < variant.numbers["height"] - variant.numbers["z_e"] < 1.1
    for variant in dealing.variants("bicycle-5"):
        assert variant.numbers["diameter"] >= 0.7
