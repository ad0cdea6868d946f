"""Sheets with the numbers of a key."""

from commands import run
from declared import EXERCISES, table

from courseware.practice import variants
from courseware.script import engine


def test_a_sheet_shows_the_numbers_of_the_key(keyed):
    """As the page shows them, for every exercise."""
    assert run("key", "roster.csv", "--force") == 0
    assert run("sheet", "key.csv") == 0
    page = next((keyed / "sheets").glob("Ada*")).read_text()
    for row in table("key.csv"):
        if row["student"] == "Ada":
            variant = variants.all_variants(row["exercise"])[int(row["variant"])]
            exercise = EXERCISES[row["exercise"]]
            text = exercise.fill(exercise.text, variant.numbers)
            assert engine.call("courseware.renderParagraphs", text) in page
    assert "<mtable>" in page  # no lists in lists
