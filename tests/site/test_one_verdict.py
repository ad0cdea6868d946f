"""One verdict on a text: of the page, the notebook, and `grade` on the file that the page saves."""

import pytest
from browser import watched_page
from declared import EXERCISES, OF_EACH_KIND, table, typed
from test_practice_page import come_to, printed, sign_in

from courseware import practice
from courseware.classroom.__main__ import main
from courseware.practice import variants

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

# checks answers: [exercise, text] each → what the field holds, the verdict, its words
CHECK = """(answers) => answers.map(([exercise, text]) => {
  const box = document.querySelector(`[data-exercise="${exercise}"]`);
  const field = box.querySelector(".rk-row input"), verdict = box.querySelector(".rk-verdict");
  field.focus();
  document.execCommand("insertText", false, text);
  field.blur();
  field.form.requestSubmit();
  return [field.value, verdict.className.replace("rk-verdict rk-", ""), verdict.textContent];
})"""
RUBBISH = ["", "no idea", "=SUM(A1:A3)", "\t=1", '="0.5"', "a,b;c", "[1, 2", "0.5\u2028", "‏۰٫۵"]


def answers_of(student, name):
    """What somebody may type: the right answer, with decimal commas too, mistakes, rubbish."""
    exercise = EXERCISES[name]
    variant = variants.find_variant("robokin", name, student)
    right = exercise.format_answer(variant.numbers).split(" or ")[0]
    named = [c for c in variant.candidates if c.name[0] == "M"]
    return [
        (right, "right"),
        (right.replace(", ", "; ").replace(".", ","), "right"),
        *((typed(c.rows, exercise), c.name) for c in named),
        *((text, "") for text in RUBBISH),
    ]


def tidy(words):
    """Words as a page shows them: a browser shows several blanks as one."""
    return " ".join(printed(words).split())


@pytest.mark.parametrize(
    ("exercises", "students"),
    [
        pytest.param(OF_EACH_KIND, 12, id="fast"),
        pytest.param(list(EXERCISES), 24, id="all", marks=pytest.mark.slow),
    ],
)
def test_page_notebook_and_grade_have_one_verdict(
    chromium, server, tmp_path, monkeypatch, exercises, students
):
    monkeypatch.chdir(tmp_path)
    people = [f"Student {k}" for k in range(students)]
    given = {(s, n): answers_of(s, n) for s in people for n in exercises}
    given = {key: texts[people.index(key[0]) % len(texts)] for key, texts in given.items()}
    found, held = {}, {}
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "practice.html")
        for student in people:
            sign_in(page, student)
            for name in exercises:
                come_to(page, name, student)
            texts = [[name, given[student, name][0]] for name in exercises]
            for name, (value, result, words) in zip(
                exercises, page.evaluate(CHECK, texts), strict=True
            ):
                found[student, name], held[student, name] = (result, tidy(words)), value
            with page.expect_download() as download:
                page.locator(".rk-export").dispatch_event("click")  # in a menu
            download.value.save_as(tmp_path / "answers" / f"{student}.csv")
        assert not watch.errors + watch.strangers
    (tmp_path / "roster.csv").write_text("\n".join(["student", *people]))
    assert main(["key", "roster.csv", "--only", *exercises]) == 0
    main(["grade", "answers", "--key", "key.csv"])
    graded = {(row["student"], row["exercise"]): row for row in table("grades.csv")}
    faults = []
    for (student, name), (text, meant) in given.items():
        verdict = practice.exercise(name, student=student).check(text)
        row = graded[student, name]
        by_grade = row["result"], row["mistake"], row["comment"]
        mistake = verdict.name.removeprefix("right")
        is_empty = not held[student, name].strip()
        is_one = found[student, name] == (verdict.result, tidy(verdict.feedback)) and by_grade == (
            ("missing", "", "") if is_empty else (verdict.result, mistake, verdict.feedback)
        )
        if not is_one or (meant and verdict.name != meant):
            faults.append((student, name, text, verdict, found[student, name], by_grade))
    assert not faults
