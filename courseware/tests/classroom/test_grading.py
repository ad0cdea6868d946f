"""Grades: of a few students, and of a class whose grades are known."""

import csv
import json
import random
from collections import Counter
from functools import cache

import pytest
from commands import ONE, ONLY, run, saved
from declared import COURSE, EXERCISES, table, typed

from courseware.classroom import answer_key, grading
from courseware.practice import candidates, variants
from courseware.practice.saving import write_table


def test_key_sheets_and_grades(folder, capsys):
    (folder / "roster.csv").write_text("student,group\nAda,1\nسارا,2\n=1+1,3\n", encoding="utf-8")
    assert run("key", "roster.csv", *ONLY) == 0
    assert run("sheet", "key.csv") == 0
    rows = table("key.csv")
    assert [row["student"] for row in rows[::2]] == ["Ada", "سارا", "=1+1"]
    sheets = sorted((folder / "sheets").iterdir())
    assert len(sheets) == 3
    for row in rows:
        variant = variants.all_variants(row["exercise"])[int(row["variant"])]
        assert json.loads(row["numbers"]) == variant.numbers
    assert not any(row["answer"].split(" ")[0] in s.read_text() for s in sheets for row in rows)

    answers = [  # right, half the wheel distance, in degrees, words, nothing
        ("Ada", ONE, rows[0]["answer"].split(" ")[0]),
        ("Ada", "differential-drive-2", "no idea"),
        ("سارا", ONE, str(wrong(rows[2], "M12"))),
        ("=1+1", ONE, str(wrong(rows[4], "unit:degrees"))),
    ]
    write_table("answers.csv", ("student", "exercise", "answer"), answers)
    assert run("grade", "answers.csv", "--key", "key.csv") == 0
    told = capsys.readouterr().out
    assert f"1 of 3, {ONE}: M12. " in told
    assert "students with unread answers: 1\n  Ada: differential-drive-2\n" in told
    graded = table("grades.csv")
    found = [row["result"] for row in graded]
    assert found == ["right", "unread", "wrong", "missing", "partly", "missing"]
    assert [row["mistake"] for row in graded] == ["", "", "M12", "", "unit:degrees", ""]
    totals = table("grades-students.csv")
    assert totals[2] == dict(zip(grading.TOTALS, ["=1+1", "0", "1", "0", "0", "1"], strict=True))
    assert table("grades-problems.csv") == []


def wrong(row, name):
    """What a candidate of the student's variant answers."""
    variant = variants.all_variants(row["exercise"])[int(row["variant"])]
    return next(c.rows[0][0] for c in variant.candidates if c.name == name)


def test_a_key_of_an_older_bank_is_regraded_on_its_own_numbers(folder, capsys):
    """A corrected exercise: the students keep their numbers, the answers are the new ones."""
    numbers = json.dumps({"b": 0.123, "v_L": 0.1, "v_R": 0.2})
    row = ("c", "0ldbank", "Ada", ONE, 7, numbers, "wrong in the old bank")
    other = ("c", "0ldbank", "Bob", ONE, 7, '{"gone": 1}', "")
    write_table("key.csv", answer_key.COLUMNS, [row, other])
    write_table("answers.csv", ("student", "exercise", "answer"), [("Ada", ONE, 0.1 / 0.123)])
    assert run("grade", "answers.csv", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert "The key is of version 0ldbank of the exercises" in told.out
    assert f"key.csv, line 3: {ONE} cannot be computed from" in told.err
    assert [row["result"] for row in table("grades.csv")] == ["right"]


NAMES = ("s{:04}", "Åsa Öberg {}", "سارا محمدی {}", "=1+{}", 'O"Neil, {}', "  José   {} ")


@cache
def known_by_one_name(exercise, number):
    """What can be answered in a variant, without what gives the number of something before."""
    found = []
    for candidate in variants.all_variants(exercise.name)[number].candidates:
        if all(candidates.is_apart(exercise, candidate, other) for other in found):
            found.append(candidate)
    return found


def built_class(count):
    """A class: name → exercise → answer; and (name, exercise) → the grade that was built in.

    Where mistakes give the same, several names will do; which one, other tests hold.
    """
    draw, answers, wanted = random.Random(500), {}, {}
    for k in range(count):
        name = NAMES[k % len(NAMES)].format(k)
        mine = answers[name] = {}
        for exercise in EXERCISES.values():
            number = variants.choose_variant(COURSE, exercise.name, name)
            possible = known_by_one_name(exercise, number)
            chosen = draw.choice((possible[0], draw.choice(possible), None, "no idea"))
            grades = {("missing", "")}
            if chosen == "no idea":
                mine[exercise.name], grades = chosen, {("unread", "")}
            elif chosen:
                mine[exercise.name] = typed(chosen.rows, exercise)
                alike = (c for c in possible if not candidates.is_apart(exercise, c, chosen))
                meant = candidates.outcomes(exercise)
                grades = {(meant[c.name].result, c.name.removeprefix("right")) for c in alike}
            wanted[variants.fold_name(name), exercise.name] = grades
    return answers, wanted


@pytest.mark.parametrize("size", [40, pytest.param(500, marks=pytest.mark.slow)])
def test_a_class(size, folder, capsys):
    """Mistakes, names typed late, two downloads, joined files, other files: all grades as built."""
    answers, wanted = built_class(size)
    names = list(answers)
    for part in (names[:-20], names):  # twenty are enrolled later
        write_table("roster.csv", ("student",), [(name,) for name in part], force=True)
        assert run("key", "roster.csv", "--force") == 0
    (folder / "joined").mkdir()
    joined = b""
    early, late = ({name: f"2026-03-0{day}T09:00:00Z" for name in EXERCISES} for day in (1, 2))
    for k, name in enumerate(names):
        text = saved(name, answers[name], late)
        if k % 7 == 0:  # an older file, with a name that sorts before or after
            older = dict.fromkeys(answers[name], "0.123")
            (folder / f"{k} {'ab'[k % 2]}.csv").write_text(saved(name, older, early))
        if k % 11 == 0:  # at first without a name, and once in another course
            (folder / f"{k}-nameless.csv").write_text(saved("", answers[name], late))
            (folder / f"{k}-old.csv").write_text(saved(name, answers[name], late, "last year"))
        if k % 5 == 0:
            joined += text.encode()
        elif k % 13 == 0:  # by a spreadsheet
            rows = csv.reader(text.lstrip("\ufeff").splitlines())
            lines = (
                "\t".join(f'"{cell.replace(chr(34), chr(34) * 2)}"' for cell in r) for r in rows
            )
            (folder / f"{k}.csv").write_text("\n".join(lines), encoding="utf-16")
        else:
            (folder / f"{k} ab.csv").write_text(text)
    (folder / "joined" / "all.csv").write_bytes(joined)
    capsys.readouterr()
    assert run("grade", ".", "--key", "key.csv") == 1
    told = capsys.readouterr()
    assert f"students: {size};" in told.out
    graded = {
        (variants.fold_name(row["student"]), row["exercise"]): (row["result"], row["mistake"])
        for row in table("grades.csv")
    }
    assert graded.keys() == wanted.keys()
    assert [person for person in wanted if graded[person] not in wanted[person]] == []
    counts = Counter(row["problem"] for row in table("grades-problems.csv"))
    replaced = sum(len(answers[name]) for name in names[::7])
    elevenths = sum(len(answers[name]) for name in names[::11])
    assert counts["answers replaced by a newer one"] == replaced
    assert counts["answers without a name"] == counts["answers of another course"] == elevenths


def test_tries_and_help_reach_the_teacher(keyed):
    (keyed / "a.csv").write_text(f"student,exercise,answer,tries,help\nAda,{ONE},7,3,2\n")
    assert run("grade", "a.csv", "--key", "key.csv") == 0
    first, *others = table("grades.csv")
    assert (first["tries"], first["help"]) == ("3", "2")
    assert {row["tries"] for row in others} == {""}
