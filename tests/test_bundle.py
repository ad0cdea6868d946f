"""What a page waits for: one sheet and few scripts; pictures and formulas that come later."""

import bundle
import pytest
from browser import draw_all, pages, watched_page
from bs4 import BeautifulSoup

pytest_plugins = ["browser"]


@pytest.mark.parametrize(
    ("css", "kept"),
    [
        (".used{a:b}.gone{c:d}", ".used{a:b}"),
        (".gone, .used > p{a:b}", ".used > p{a:b}"),
        (".used .gone{a:b}", ""),
        (".used:not(.gone):is(.gone, .more){a:b}", ".used:not(.gone):is(.gone, .more){a:b}"),
        ('p[title="a,.gone"], .gone{a:"}"}', 'p[title="a,.gone"]{a:"}"}'),
        ("@media print{.gone{a:b}}", ""),
        ("@media print{.gone{a:b}.used{c:d}}", "@media print{.used{c:d}}"),
        ("@font-face{src:url(x)}", "@font-face{src:url(x)}"),
        ("@font-face{font-family:Font Awesome}.fa-x{a:b}/* c */p{a:b}", "p{a:b}"),
        (".fa-x{--icon:url(x)}", ".fa-x{--icon:url(x)}"),
        ('@import "x.css";p{a:b}', "p{a:b}"),
    ],
)
def test_rules_that_no_page_needs_are_left_out(css, kept):
    assert bundle.used_rules(css, {"used", "more", "fa-x"}) == kept


@pytest.mark.browser
def test_every_page_asks_for_one_sheet_and_few_scripts_which_wait(site):
    for name in pages(site):
        soup = BeautifulSoup((site / name).read_text("utf-8"), "html.parser")
        (sheet,) = soup.select("link[rel=stylesheet]")
        assert "_static/all.css?v=" in sheet["href"], name
        scripts = soup.select("script[src]")  # all pages', the page's own, the workshop's
        assert 0 < len(scripts) <= 3, name
        assert all(script.has_attr("defer") for script in scripts), name


HEIGHTS = "(all) => all.map((each) => Math.round(each.getBoundingClientRect().height))"
NOW = """(all) => Promise.all(all.map((each) => {
  each.loading = "eager";
  return each.decode();
}))"""


@pytest.mark.browser
@pytest.mark.parametrize("width", [1280, 390])
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


@pytest.mark.browser
@pytest.mark.parametrize("width", [1280, 390])
def test_a_formula_far_below_waits_and_has_its_place(server, chromium, width):
    """It costs nothing until it comes near, and what follows does not jump when it does."""
    with watched_page(chromium, server, width) as (page, _):
        page.add_init_script("requestIdleCallback = () => {}")  # there is always something to do
        page.goto(f"{server}euler/euler.html")
        page.evaluate("() => document.fonts.ready")
        formulas = page.locator(".math-scroll:visible")
        assert formulas.evaluate_all(WAIT) > 10
        waiting = formulas.evaluate_all(HEIGHTS)
        draw_all(page)
        drawn = formulas.evaluate_all(HEIGHTS)
        # on a phone a long formula may be broken once more, which only its drawing tells
        assert sum(drawn) == pytest.approx(sum(waiting), rel=0.05)


@pytest.mark.browser
def test_all_formulas_are_drawn_and_have_their_fonts_before_one_prints(server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        page.goto(f"{server}euler/euler.html")
        page.wait_for_function(f"() => !({WAIT})({SHOWN})")
        page.evaluate("() => document.fonts.ready")
        assert any("KaTeX_Size4" in url for url in watch.kinds)  # a matrix far below
        assert not watch.errors
<<<<<<< HEAD:tests/test_light.py


def all_sheets(static):
    """Links to all sheets as they were."""
    names = [p for pattern in (*light.THEME, *light.OWN) for p in sorted(static.glob(pattern))]
    return "".join(
        rf'<link rel="stylesheet" href="\1_static/{file.relative_to(static).as_posix()}" />'
        for file in names
    )


# what can be seen of an element: where it is, and all its styles
SEEN = """() => [...document.querySelectorAll("body *:not(svg *)")].map((element) => {
  const { x, y, width, height } = element.getBoundingClientRect();
  const style = getComputedStyle(element), all = [x, y, width, height];
  for (const name of style) if (!name.startsWith("--")) all.push(style.getPropertyValue(name));
  const hash = [...all.join()].reduce((sum, sign) => (31 * sum + sign.charCodeAt()) | 0, 7);
  return `${element.tagName} ${element.className} ${hash}`;
})"""


@pytest.mark.browser
@pytest.mark.parametrize(
    ("name", "width", "scheme"),
    [
        pytest.param("euler/euler.html", 1280, "dark", marks=pytest.mark.slow),
        pytest.param("notation.html", 390, "light", marks=pytest.mark.slow),
        ("search.html", 390, "dark"),
        pytest.param("index.html", 1280, "light", marks=pytest.mark.slow),
    ],
)
def test_a_page_looks_as_with_all_of_the_theme(name, width, scheme, site, server, chromium):
    links = all_sheets(site / "_static")

    def with_all(route):
        route.fulfill(body=SHEET.sub(links, (site / name).read_text("utf-8")))

    seen = []
    for change in (False, True):
        options = {"width": width, "scheme": scheme, "reduced_motion": "reduce"}
        with watched_page(chromium, server, **options) as (page, watch):
            if change:
                page.route(server + name, with_all)
            settled(page, server + name)
            wait_until_drawn(page)
            seen.append(page.evaluate(SEEN))
            assert (len([u for u in watch.kinds if ".css" in u]) > 1) == change
            assert not watch.errors
    assert seen[0] == seen[1]
=======
>>>>>>> 2f3b3a0 (Leave the site to Sphinx where nothing measured needs us):tests/test_bundle.py
