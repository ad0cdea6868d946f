"""Nothing that is moved changes the height of its figure: the page below would jump."""

import pytest
from browser import COME_ALIVE, UNFOLD, settled, watched_page

import book  # noqa: F401 (opens the course)
from courseware.course import course

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

CHAPTERS = [f"{chapter}/{chapter}" for chapter in course().taught]
GROWING = {"trolley", "wheel-laboratory"}  # a control comes with what it acts on
# each control through its range, in forty steps; the figure's heights
HEIGHTS = """(figure) => {
  const found = new Set(), { courseware } = figure;
  for (const input of figure.querySelectorAll(":is(input, select)[data-i]")) {
    const { value: start, min, max, options } = input;
    const set = (value) => {
      input.value = value;
      for (const name of ["input", "change"]) {
        input.dispatchEvent(new Event(name, { bubbles: true }));
      }
      courseware.settled();
      found.add(figure.offsetHeight);
    };
    if (input.type === "radio") {
      input.checked = true;
      set(start);
      continue;
    }
    set(start);
    if (options) [...options].forEach(({ value }) => set(value));
    else for (let k = 0; k <= 40; k += 1) set(Number(min) + (max - min) * k / 40);
    set(start);
  }
  return [...found];
}"""


@pytest.mark.parametrize(
    ("name", "width"),
    [
        ("index", 390),
        ("planar_arm/planar_arm", 390),
        *(
            pytest.param(name, width, marks=pytest.mark.slow)
            for name in ("index", *CHAPTERS)
            for width in (390, 1280)
        ),
    ],
)
def test_no_figure_changes_its_height(name, width, server, chromium):
    with watched_page(chromium, server, width, reduced_motion="reduce") as (page, _):
        settled(page, f"{server}{name}.html")
        page.locator(".bd-article").evaluate(UNFOLD)
        jumps = {}
        for figure in page.locator(".rk-figure").all():
            figure.evaluate(UNFOLD)
            figure.evaluate(COME_ALIVE)
            heights = figure.evaluate(HEIGHTS)
            name = figure.get_attribute("id")
            if heights and max(heights) - min(heights) > 1 and name not in GROWING:
                jumps[name] = heights
        assert jumps == {}
