"""Dealing: the same numbers in Python and on the page, to whoever has the same name."""

import json
import unicodedata

import numpy as np
from declared import EXERCISES

from courseware.practice import variants
from courseware.script import engine as script

NAMES = ["", " Ada ", "Ada  Lovelace", "سارا محمدی", "José", "Jose\u0301", "李雷", "😀 smile", "ß"]


def names(count):
    """Names of many scripts, with accents and odd spaces."""
    random = np.random.default_rng(1)
    letters = [*"abzÅéüñçßøłžαωжяابپچ李王あ한\u0301\u0308\u200d😀🤖’´İıIكةأيＡ－–,\u2066 \t-'7"]
    made = {"".join(random.choice(letters, random.integers(1, 12))) for _ in range(2 * count)}
    return [*NAMES, *sorted(made)][:count]


def dealt_in_python(course, exercise, people):
    return [variants.choose_variant(course, exercise, name) for name in people]


DEAL = """(people) => people.map((name) =>
  courseware.chooseVariant("2026 Herbst", "euler-1", name))"""


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
    shown = EXERCISES["euler-1"].format_given(variants.all_variants("euler-1")[43].numbers)
    assert list(shown.values()) == ["90°", "y", "−30°", "z", "z"]


def test_names_that_look_alike_are_the_same():
    assert variants.fold_name("  Ada \u00a0 Lovelace\n") == "ada lovelace"
    assert variants.fold_name("Jose\u0301") == variants.fold_name("José")
    assert variants.fold_name("  Ada\u200c \u00a0 ۰۴۷۱\n") == "ada 0471"
    assert variants.fold_name("ADA ۰۴۷۱") == variants.fold_name("ada 0471") == "ada 0471"
    assert variants.fold_name("علي") == variants.fold_name("علی")  # two letters, one name
    assert variants.fold_name("A\u200cda\u200d") == "ada"
    typed = "O’Brien-Smith|O´Brien‑Smith|Ｏ＇Ｂｒｉｅｎ－Ｓｍｉｔｈ|\u2066O`Brien–Smith\u2069"
    for alike in typed.split("|"):
        assert variants.fold_name(alike) == "o'brien-smith"
    assert variants.fold_name("ALİ IŞIK") == variants.fold_name("ali işik")
    assert (
        variants.fold_name("Lovelace, Ada") == variants.fold_name("Ada  Lovelace") == "ada lovelace"
    )
    assert variants.fold_name("أحمد فاطمة") == variants.fold_name("احمد فاطمه")


def test_variants_are_dealt_evenly():
    """Numbered students: all variants, none twice as often as it should but by chance."""
    dealt = dealt_in_python("course", "euler-1", [f"{k}" for k in range(10_000, 16_400)])
    counts = np.bincount(dealt, minlength=variants.VARIANTS)
    # 100 each on average, with a standard deviation of 10
    assert counts.min() > 50
    assert counts.max() < 200


def test_another_course_deals_other_variants():
    people = [f"{k}" for k in range(1000)]
    last, this = (dealt_in_python(year, "euler-1", people) for year in ("2025", "2026"))
    assert sum(a == b for a, b in zip(last, this, strict=True)) < 50  # 16 expected by chance
