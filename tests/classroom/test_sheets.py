"""Sheets with the numbers of a key."""

import re

from commands import ONE, run
from declared import EXERCISES, table

from courseware.practice import dealing
from courseware.script import engine


def test_a_sheet_shows_the_numbers_of_the_key(keyed):
    """As the page shows them, for every exercise."""
    assert run("key", "roster.csv", "--force") == 0
    assert run("sheet", "key.csv") == 0
    page = next((keyed / "sheets").glob("Ada*")).read_text()
    for row in table("key.csv"):
        if row["student"] == "Ada":
            variant = dealing.variants(row["exercise"])[int(row["variant"])]
            exercise = EXERCISES[row["exercise"]]
            text = exercise.fill(exercise.text, variant.numbers)
            assert engine.call("courseware.renderParagraphs", text) in page
    assert "<mtable>" in page  # no lists in lists


def test_a_damaged_key_makes_no_sheet_and_says_why(keyed, capsys):
    key = (keyed / "key.csv").read_text("utf-8")
    for damaged in (key.replace("{", "{,"), re.sub(r'""\w+"": ', '""none"": ', key)):
        assert damaged != key
        (keyed / "damaged.csv").write_text(damaged, "utf-8")
        assert run("sheet", "damaged.csv", "--force") == 2
        assert f"numbers of {ONE} that cannot be used" in capsys.readouterr().err
