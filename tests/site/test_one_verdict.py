"""One verdict on a text: of the page, the notebook, and `grade` on the file that the page saves."""

import pytest
from browser import watched_page
from declared import EXERCISES, OF_EACH_KIND, table
from test_practice_page import printed, sign_in
from typed_answers import draw

from classroom.__main__ import main
from courseware import practice
from courseware.practice import dealing

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

# pastes and checks answers: [exercise, text] each → what the field holds, the verdict, its words
CHECK = """(answers) => answers.map(([exercise, text]) => {
  const box = document.querySelector(`[data-exercise="${exercise}"]`);
  const field = box.querySelector(".rk-row input"), verdict = box.querySelector(".rk-verdict");
  const clipboardData = new DataTransfer();
  const how = { clipboardData, bubbles: true, cancelable: true };
  clipboardData.setData("text", text);
  field.focus();
  const typed = field.dispatchEvent(new ClipboardEvent("paste", how));
  if (typed) document.execCommand("insertText", false, text);
  field.blur();
  field.form.requestSubmit();
  return [field.value, verdict.className.replace("rk-verdict rk-", ""), verdict.textContent];
})"""


def answers_of(student, exercises, seed):
    """An answer of a student to each exercise."""
    for name in exercises:
        variant = dealing.variants(name)[dealing.deal("robokin", name, student)]
        [typed] = draw(f"{seed} {student}", EXERCISES[name], variant, 1)
        yield name, typed


def tidy(words):
    """Words as a page shows them: a browser shows several blanks as one."""
    return " ".join(printed(words).split())


def is_expected(typed, verdict):
    """Whether a right answer is right, a mistake is named, and a near miss is neither."""
    if typed.kind == "right":
        return verdict.result == "right"
    if typed.kind == "near":
        return verdict.result == "wrong"
    return typed.kind == "rubbish" or verdict.name == typed.kind


@pytest.mark.parametrize(
    ("exercises", "students"),
    [
        pytest.param(OF_EACH_KIND, 10, id="fast"),
        pytest.param(list(EXERCISES), 40, id="all", marks=pytest.mark.slow),
    ],
)
def test_page_notebook_and_grade_have_one_verdict(
    chromium, server, tmp_path, monkeypatch, exercises, students
):
    monkeypatch.chdir(tmp_path)
    people = [f"Student {k}" for k in range(students)]
    typed = {(s, name): one for s in people for name, one in answers_of(s, exercises, 1)}
    found, held = {}, {}
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "practice.html")
        for student in people:
            sign_in(page, student)
            for name in exercises:
                number = dealing.deal("robokin", name, student)
                page.locator(f"#{name}").scroll_into_view_if_needed()
                page.locator(f"#{name}[data-variant='{number}']").wait_for()
            texts = [[name, typed[student, name].text] for name in exercises]
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
    for (student, name), one in typed.items():
        verdict = practice.exercise(name, student=student).check(one.text)
        row = graded[student, name]
        by_grade = row["result"], row["mistake"], row["comment"]
        is_empty = not held[student, name].strip()
        is_one = found[student, name] == (verdict.result, tidy(verdict.feedback)) and by_grade == (
            ("missing", "", "") if is_empty else (verdict.result, verdict.name, verdict.feedback)
        )
        if not is_one or not is_expected(one, verdict):
            faults.append((student, name, one, verdict, found[student, name], by_grade))
    assert not faults
