"""The key: numbers for everyone, on a page or drawn by a secret."""

import json

from commands import ONE, ONLY, results, run, saved
from declared import each, table

from courseware.practice import Exercise, variants


def test_a_secret_deals_numbers_that_are_on_no_page(keyed):
    """Also to those who are enrolled later, and the numbers of the others stay."""
    few = ("--only", ONE, "wheels-5")  # the second has few numbers
    assert run("key", "roster.csv", "--out", "exam.csv", "--secret", "secret.txt", *few) == 0
    exam = table("exam.csv")
    for row in exam:
        public = [variant.numbers for variant in variants.all_variants(row["exercise"])]
        assert json.loads(row["numbers"]) not in public
    (keyed / "roster.csv").write_text("student\nEve\nAda\nBob\n")
    again = ("--secret", "secret.txt", "--force", *few)
    assert run("key", "roster.csv", "--out", "exam.csv", *again) == 0
    assert [row for row in table("exam.csv") if row["student"] != "Eve"] == exam
    (keyed / "secret.txt").unlink()
    assert run("key", "roster.csv", "--out", "other.csv", "--secret", "secret.txt", *few) == 0
    assert table("other.csv") != table("exam.csv")


@each("exercise", "exercises", Exercise)
def test_a_secret_finds_numbers_for_every_exercise(exercise):
    """No mistake ends in an error, no exercise is left with a handful."""
    public = {tuple(variant.numbers.values()) for variant in variants.all_variants(exercise.name)}
    dealt = variants.all_variants(exercise.name, "1000000000000000")
    own = {tuple(variant.numbers.values()) for variant in dealt}
    assert len(own) >= variants.FEWEST
    assert not public & own


def test_a_secret_must_be_one(keyed, capsys):
    (keyed / "secret.txt").write_text("cat")
    assert run("key", "roster.csv", "--force", "--secret", "secret.txt") == 2
    assert "secret.txt must hold one word of 16 characters" in capsys.readouterr().err
    assert run("moodle", "--secret", "nowhere.txt") == 2
    assert "`key --secret` makes one" in capsys.readouterr().err
    assert not (keyed / "nowhere.txt").exists()


def test_answers_of_the_page_are_none_to_the_numbers_of_a_secret(keyed, capsys):
    """Who practises on the page and hands in that file too loses nothing."""
    assert run("key", "roster.csv", "--out", "exam.csv", "--secret", "secret.txt", *ONLY) == 0
    mine = next(row for row in table("exam.csv") if row["student"] == "Ada")
    right = mine["answer"].split(" ")[0].replace("−", "-")
    (keyed / "sheet.csv").write_text(saved("Ada", {ONE: right}, course=mine["course"]))
    later = {ONE: "2026-04-01T10:00:00Z"}
    (keyed / "page.csv").write_text(saved("Ada", {ONE: "7"}, later))
    assert run("grade", ".", "--key", "exam.csv") == 1
    assert "answers of another course: 1" in capsys.readouterr().err
    assert results()["Ada", ONE] == "right"


def test_a_secret_that_an_editor_saved_again_deals_the_same(keyed):
    few = ("--only", ONE, "--out", "exam.csv", "--secret", "secret.txt")
    assert run("key", "roster.csv", *few) == 0
    before, secret = table("exam.csv"), (keyed / "secret.txt").read_text().strip()
    for text, encoding in (
        (f"{secret}\r\n\r\n", "utf-8"),
        (f"{secret}\n", "utf-16"),
    ):
        (keyed / "secret.txt").write_bytes(text.encode(encoding))
        assert run("key", "roster.csv", *few, "--force") == 0
        assert table("exam.csv") == before


def test_another_secret_does_not_replace_a_key(keyed, capsys):
    few = ("--only", ONE, "--out", "exam.csv", "--secret", "secret.txt")
    assert run("key", "roster.csv", *few) == 0
    before = table("exam.csv")
    (keyed / "secret.txt").write_text("x" * 16)
    assert run("key", "roster.csv", *few, "--force") == 2
    assert "its numbers would change" in capsys.readouterr().err
    assert table("exam.csv") == before


def test_a_roster_of_a_learning_platform_is_read(folder):
    (folder / "roster.csv").write_text('Student,ID\n"Lovelace, Ada",1\n')
    assert run("key", "roster.csv", *ONLY) == 0
    (folder / "a.csv").write_text(saved("Ada Lovelace", {ONE: "7"}))
    assert run("grade", "a.csv", "--key", "key.csv") == 0
    assert results()["Lovelace, Ada", ONE] == "wrong"
