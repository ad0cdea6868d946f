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


WAIT = """(all) => all.filter(({ firstElementChild }) => {
  return !firstElementChild.checkVisibility({ contentVisibilityAuto: true });
}).length"""
SHOWN = "[...document.querySelectorAll('.math-scroll')].filter((box) => box.checkVisibility())"


@each_width
def test_a_formula_far_below_waits_and_has_its_place(server, chromium, width):
    """It costs nothing until it comes near, and what follows does not jump when it does."""
    with watched_page(chromium, server, width) as (page, _):
        page.goto(f"{server}euler/euler.html")
        page.evaluate("() => document.fonts.ready")
        formulas = page.locator(".math-scroll:visible")
        assert formulas.evaluate_all(WAIT) > 10
        waiting = formulas.evaluate_all(HEIGHTS)
        draw_all(page)
        drawn = formulas.evaluate_all(HEIGHTS)
        # on a phone a long formula may be broken once more, which only its drawing tells
        assert sum(drawn) == pytest.approx(sum(waiting), rel=0.05)


LOADED = """[...document.fonts].filter((font) => font.status === "loaded")
  .map(({ family, style, weight }) => [family, style, weight].join(" ")).sort().join()"""


@pytest.mark.parametrize("name", ["euler", "frames", "wheels"])
def test_the_fonts_of_far_formulas_come_before_one_prints(name, server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        page.goto(f"{server}{name}/{name}.html")
        page.locator("main").evaluate(UNFOLD)  # as for a printer
        draw_all(page)
        page.evaluate("() => document.fonts.ready")
        fonts = page.evaluate(LOADED)
        page.reload()
        page.wait_for_function(f"(fonts) => {LOADED} === fonts", arg=fonts)
        assert page.evaluate(f"({WAIT})({SHOWN})")
        assert not watch.errors


# before each idle turn all formulas are printed anew, as those of figures are at any time
ANEW = """() => {
  const later = requestIdleCallback;
  globalThis.requestIdleCallback = (act) => later((deadline) => {
    document.querySelectorAll(".katex").forEach((each) => each.replaceWith(each.cloneNode(true)));
    act(deadline);
  });
}"""


def test_the_fonts_come_though_formulas_are_printed_anew_meanwhile(server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        page.add_init_script(f"({ANEW})()")
        page.goto(f"{server}bicycle/bicycle.html")
        page.wait_for_function("() => document.fonts.check('1em KaTeX_Size4')")
        assert not watch.errors


def test_when_one_scrolls_all_heights_become_known_and_all_rests_again(server, chromium):
    """Nothing jumps on the way up then, and nothing far away is painted with a figure."""
    with watched_page(chromium, server, 390) as (page, _):
        page.goto(f"{server}wheels/wheels.html")
        draw_all(page)
        tall = page.evaluate(TALL)
        page.reload()
        assert page.evaluate(TALL) != tall
        page.mouse.wheel(0, 100)
        page.wait_for_function(f"(tall) => {TALL} === tall && ({WAIT})({SHOWN})", arg=tall)
