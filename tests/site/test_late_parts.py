"""Pictures, formulas and fonts that come later than the page: what waits has its place."""

import pytest
from browser import TALL, UNFOLD, draw_all, watched_page

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

each_width = pytest.mark.parametrize("width", [pytest.param(1280, marks=pytest.mark.slow), 390])
HEIGHTS = "(all) => all.map((each) => Math.round(each.getBoundingClientRect().height))"
NOW = """(all) => Promise.all(all.map((each) => {
  each.loading = "eager";
  return each.decode();
}))"""


@each_width
def test_a_picture_that_comes_late_has_its_place(server, chromium, width):
    """Else the page jumps under a reader who scrolls."""
    with watched_page(chromium, server, width) as (page, _):
        page.route("**/*.png", lambda route: None)  # none comes
        page.goto(f"{server}odometry/odometry.html", wait_until="domcontentloaded")
        page.wait_for_function("() => document.styleSheets.length")
        without = page.locator(".bd-article img").evaluate_all(HEIGHTS)
        page.unroute("**/*.png")
        page.reload()
        page.locator(".bd-article img").evaluate_all(NOW)
        assert without == page.locator(".bd-article img").evaluate_all(HEIGHTS)
        assert min(without) > 100


FAR = """() => [...document.querySelectorAll(".math-scroll")].filter((box) => box.checkVisibility()
  && !box.firstElementChild.checkVisibility({ contentVisibilityAuto: true })).length"""
LOADED = """[...document.fonts].filter((font) => font.status === "loaded")
  .map(({ family, style, weight }) => [family, style, weight].join(" ")).sort().join()"""


@pytest.mark.parametrize("name", ["elbow_arm", "frames", "bicycle"])
def test_formulas_far_below_wait_for_a_reader_s_first_move(name, server, chromium):
    """Then they have their heights, so that nothing jumps, and their fonts, should one print."""
    with watched_page(chromium, server, 390) as (page, _):
        page.goto(f"{server}{name}/{name}.html")
        draw_all(page)
        tall = page.evaluate(TALL)
        page.locator("main").evaluate(UNFOLD)  # as for a printer
        page.evaluate("() => document.fonts.ready")
        fonts = page.evaluate(LOADED)
    with watched_page(chromium, server, 390) as (page, watch):  # nothing is answered here
        page.goto(f"{server}{name}/{name}.html")
        assert page.evaluate(FAR) > 5
        page.keyboard.press("Shift")
        page.wait_for_function(
            f"([tall, fonts]) => {TALL} === tall && {LOADED} === fonts && !({FAR})()",
            arg=[tall, fonts],
        )
        assert not watch.errors
