"""On a phone all of a formula can be reached."""

import pytest

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser
pytest.register_assert_rewrite("browser")

from browser import listed, watched_page  # noqa: E402

# formulas whose left end lies left of their box at rest: scrolling cannot bring it back.
# One pixel for rounding.
LOST = """
() => {
  document.querySelectorAll(".bd-article details").forEach((each) => { each.open = true; });
  return [...document.querySelectorAll(".math-scroll")].filter((box) => {
    box.scrollLeft = 0;
    const pieces = [...box.querySelectorAll(".katex-html > *")];
    const left = Math.min(...pieces.map((piece) => piece.getBoundingClientRect().left));
    return left < box.getBoundingClientRect().left - 1;
  }).map((box) => box.textContent.slice(0, 60));
}
"""


def test_the_left_end_of_every_formula_can_be_reached(chromium, server):
    seen = 0
    with watched_page(chromium, server, 390) as (page, _):
        for name in listed():
            page.goto(f"{server}{name}.html")
            seen += page.locator(".math-scroll").count()
            lost = page.evaluate(LOST)
            assert not lost, f"{name}: {lost}"
    assert seen > 50  # the chapters show more formulas than that
