"""A mistake as a wrong formula: its line, its number and its expression come from one place."""

import re
from functools import cache

import nbformat
import numpy as np
import pytest
from declared import EXERCISES, MISTAKES, course, each

import robokin
from book.differential_drive import formulas
from book.differential_drive.exercises import degrees_taken, half_wheel_distance, world_to_robot
from courseware import practice
from courseware.figures import Choice
from courseware.practice import Mistake
from courseware.practice.bank import all_mistakes, find_mistake
from courseware.practice.notebook import exercise_of, format_wrong_answer, render_judgement
from courseware.practice.wrong_formula import mark_difference
from courseware.site import mistake_pictures

each_mistake = each("mistake", "exercises", Mistake)


@each_mistake
def test_the_two_lines_stand_in_the_fold_with_what_changed_marked(mistake):
    html = render_judgement(mistake)
    right, wrong = mistake.formula.lines
    plain = [line.replace("«", "").replace("»", "") for line in (right, wrong)]
    assert plain[0] != plain[1]
    assert html.index("It gives") < html.index("<details>") < html.index("Right is")
    assert html.index("What is wrong?") < html.index("Right: ") < html.index("Here: ")
    assert not re.search(r"\bnan\b", html)
    assert html.count("<mark>") == right.count("«") + wrong.count("«") > 0


def test_the_same_is_put_in_for_the_numbers_of_other_formulas():
    assert degrees_taken.formula.replace(theta=np.pi, v=2) == {"theta": 180, "v": 2}
    assert world_to_robot.formula.wrap(lambda theta: [theta])(theta=1) == [-1]
    other = half_wheel_distance.formula.transfer(formulas.wheel_speeds).evaluate(
        v=0, omega=1, b=0.4
    )
    np.testing.assert_allclose(other.ravel(), [-0.1, 0.1], rtol=1e-15)


@pytest.mark.parametrize(
    ("lines", "shown"),
    [
        (("a = b", "a = −b"), ("a = b", "a = «−»b")),
        (("a = b − c", "a = (b/2) − c"), ("a = «b» − c", "a = «(b/2)» − c")),
        (("R_1 R_2", "R_2 R_1"), ("«R_1 R_2»", "«R_2 R_1»")),
        (("θ̇_1 + a", "θ̇_2 + a"), ("«θ̇_1» + a", "«θ̇_2» + a")),
    ],
)
def test_what_changed_is_marked(lines, shown):
    assert mark_difference(*lines) == shown


still = cache(mistake_pictures.draw_picture)


@each_mistake
def test_a_picture_shows_its_mistake_in_a_figure_of_its_chapter(mistake):
    """And no other mistake's; on a dark page in dark colours."""
    figure = mistake_pictures.find_mistake_figure(mistake)
    choices = [c for c in figure.controls if isinstance(c, Choice)]
    assert len(choices) == 1, f"{figure.name} needs one Choice, named mistake: {choices}"
    alike = [m.name for m in MISTAKES.values() if m is not mistake and still(m) == still(mistake)]
    assert not alike, f"{mistake.name} looks as {alike}: give their options other numbers"
    assert "#dark:target { --rk-ground: #14181f;" in still(mistake)


@each_mistake
def test_a_mistake_is_shown_in_its_chapter_under_its_title(mistake):
    """For the box itself has none."""
    home = course().chapters_of("exercises", Mistake)[mistake.name]
    sources = [cell.source for cell in nbformat.read(course().notebook(home), 4).cells]
    cell = f'practice.mistake("{mistake.name}")'
    assert cell in sources, f"add a cell `{cell}` to {home}.ipynb"
    title, above = f"### {mistake.title}", sources[sources.index(cell) - 1]
    assert above == title, f"above `{cell}` in {home}.ipynb: {title}, not {above!r}"


def last_made(code, numbers):
    """The last new name that our own code gives a value, run with the chapters' imports."""
    modules = {name: getattr(robokin, name) for name in robokin.__all__}
    space = {"np": np, **modules, **numbers}
    before = {*space, "__builtins__"}
    exec(code, space)
    return [space[name] for name in space if name not in before][-1]


@each_mistake
def test_a_mistake_is_used_and_its_line_makes_it(mistake):
    """The line, run with the document's numbers, gives what the exercise calls that mistake."""
    shown_in = [e for e in EXERCISES.values() if mistake in e.wrong and e.example]
    assert shown_in, "no exercise with an example has it"
    exercise = shown_in[0]
    numbers = {**exercise.example, **exercise.derive(**exercise.example)}
    found = last_made(mistake.line, numbers)
    wrong = exercise.evaluate(exercise.wrong[mistake], exercise.example)
    np.testing.assert_allclose(np.ravel(found), np.ravel(wrong), rtol=1e-12, atol=1e-12)
    right = exercise.evaluate(exercise.right, exercise.example)
    assert not np.allclose(right, wrong, atol=1e-6)


@each_mistake
def test_a_mistake_runs_as_printed(mistake):
    """The numbers and the line, copied from the page, give what the page says they give."""
    exercise = exercise_of(mistake).name
    page_text = practice.example(exercise).data["text/markdown"]
    given = re.search("```python\n(.*)\n```", page_text, re.DOTALL)[1]
    longest = max(map(len, given.splitlines()))
    assert longest <= 80, (
        f"the example of {exercise} prints {longest} characters in a line, at most 80: "
        "give it shorter numbers"
    )
    numbers = {}
    exec(given, {"np": np}, numbers)
    found = last_made(mistake.line, numbers)
    says = re.findall(r"-?[0-9.]+", format_wrong_answer(mistake).replace("\u2212", "-"))
    # both are rounded to four decimals; a product with the largest number here, 2, doubles that
    wanted = np.array(says, dtype=float)
    told = f"the line of {mistake.name} must give what its formula gives: {mistake.line}"
    np.testing.assert_allclose(np.ravel(found), wanted, atol=1.5e-4, rtol=0, err_msg=told)


@each_mistake
def test_a_mistake_says_all_it_must(mistake):
    assert mistake.unnoticed, f"say where {mistake.name} happens to be right, as `unnoticed`"
    assert mistake.why, f"say why {mistake.name} is wrong, as `why`"
    assert not mistake.feedback.endswith("."), f"`feedback` of {mistake.name}: no stop at its end"
    told = mistake.document, mistake.place, mistake.nth, mistake.quote, mistake.correction
    assert all(told) or not any((*told, mistake.explanation)), (
        f"{mistake.name} is in a document, and needs all of `document`, `place`, `nth`, "
        f"`quote` and `correction`, or in none: {told}"
    )
    # an erratum marks what changes, and marks nothing that is there already
    assert bool(mistake.document) == ("«" in mistake.correction), (
        f"mark in `correction` of {mistake.name} what changes, in « »"
    )
    longest = max(map(len, mistake.line.splitlines()))
    assert longest <= 80, (
        f"`line` of {mistake.name} has {longest} characters in a line, at most 80: break it"
    )


@pytest.mark.parametrize("chapter", practice.all_topics())
def test_errata_have_an_order(chapter):
    homes = course().chapters_of("exercises", Mistake)
    for document in {m.document for m in all_mistakes().values() if homes[m.name] == chapter} - {
        ""
    }:
        order = {m.name: m.nth for m in all_mistakes().values() if m.document == document}
        assert sorted(order.values()) == [*range(1, len(order) + 1)], (
            f"number the errata of {document} from 1 on, as `nth`: {order}"
        )


def test_a_matrix_is_given_row_by_row():
    html = render_judgement(find_mistake("M19"))
    assert html.count("<br>") == 6  # three rows, wrong and right
    assert "<br>" not in render_judgement(half_wheel_distance)
