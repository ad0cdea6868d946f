"""A mistake as a wrong formula: its line, its number and its expression come from one place."""

from functools import cache

import nbformat
import numpy as np
import pytest
from declared import EXERCISES, FIGURES, MISTAKES, course, each

from book.differential_drive import formulas
from book.differential_drive.exercises import M12, M13, M14
from book.differential_drive.formulas import b, v_L, v_R
from courseware import practice
from courseware.figures import Choice, Figure
from courseware.practice import Mistake
from courseware.practice.wrong_formula import mark_difference
from courseware.site import mistake_pictures


@each("mistake", "exercises", Mistake)
def test_the_two_lines_stand_in_the_fold_with_what_changed_marked(mistake):
    html = practice.mistake(mistake.name).answer
    right, wrong = mistake.formula.lines
    plain = [line.replace("«", "").replace("»", "") for line in (right, wrong)]
    assert plain[0] != plain[1]
    assert html.index("What is wrong?") < html.index("Right: ") < html.index("Here: ")
    assert html.count("<mark>") == right.count("«") + wrong.count("«") > 0


def test_what_changed_is_marked_in_letters():
    assert M12.formula.lines == ("ω = (v_R − v_L)/«b»", "ω = (v_R − v_L)/«(b/2)»")


def test_a_figure_gets_the_expression():
    """In which a ghost can be drawn: here with the speeds as symbols, and as numbers."""
    assert M12.substitute({b: 0.1}).free_symbols == {v_L, v_R}
    assert float(M12.substitute({b: 0.1, v_L: 0.05, v_R: 0.1})) == pytest.approx(1.0, rel=1e-15)


def test_the_same_is_put_in_for_the_numbers_of_other_formulas():
    assert M13.formula.replace(theta=np.pi, v=2) == {"theta": 180, "v": 2}
    assert M14.formula.wrap(lambda theta: [theta])(theta=1) == [-1]
    other = M12.formula.transfer(formulas.wheel_speeds).evaluate(v=0, omega=1, b=0.4)
    np.testing.assert_allclose(other.ravel(), [-0.1, 0.1], rtol=1e-15)


def test_the_bank_s_numbers_are_the_formula_s():
    drive = EXERCISES["differential-drive-1"]
    assert drive.wrong[M12](v_L=0.05, v_R=0.1, b=0.1) == pytest.approx(1.0, rel=1e-15)


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


@each("mistake", "exercises", Mistake)
def test_a_picture_shows_its_mistake_in_a_figure_of_its_chapter(mistake):
    """And no other mistake's; on a dark page in dark colours."""
    name, picture = mistake.name, mistake.picture
    home, figures = (
        course().chapters_of("exercises", Mistake)[name],
        course().chapters_of("figures", Figure),
    )
    assert picture, (
        f"{name} has no picture: declare a figure with a Choice named mistake in book/{home}/"
        f"figures.py, and picture=Picture(its name, an option of that, words) in exercises.py"
    )
    assert figures.get(picture.figure) == home, (
        f"{name} is shown by {picture.figure}: take a figure that book/{home}/figures.py declares"
    )
    choices = [c for c in FIGURES[picture.figure].controls if isinstance(c, Choice)]
    options = {option for c in choices if c.name == "mistake" for option in c.options}
    assert len(choices) == 1, f"{picture.figure} needs one Choice, named mistake: {choices}"
    assert picture.option in options, (
        f"{name}: {picture.figure} has no option {picture.option!r} of its Choice mistake, only "
        f"{sorted(options)}"
    )
    others = [m for m in MISTAKES.values() if m is not mistake and m.picture]
    alike = [m.name for m in others if still(m.picture) == still(picture)]
    assert not alike, f"{name} looks as {alike}: give their options other numbers"
    assert "#dark:target { --rk-ground: #14181f;" in still(picture)


@each("mistake", "exercises", Mistake)
def test_a_mistake_is_shown_in_its_chapter_under_its_title(mistake):
    """For the box itself has none."""
    home = course().chapters_of("exercises", Mistake)[mistake.name]
    sources = [cell.source for cell in nbformat.read(course().notebook(home), 4).cells]
    cell = f'practice.mistake("{mistake.name}")'
    assert cell in sources, f"add a cell `{cell}` to {home}.ipynb"
    assert mistake.picture, f"{mistake.name} has no picture, whose option is its title"
    title, above = f"### {mistake.picture.option}", sources[sources.index(cell) - 1]
    assert above == title, f"above `{cell}` in {home}.ipynb: {title}, not {above!r}"
