"""What a page waits for: one sheet and few scripts; pictures and formulas that come later."""

import re

import asset_bundle
import pytest
from browser import TALL, UNFOLD, draw_all, listed, pages, settled, watched_page
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
    assert asset_bundle.filter_rules(css, {"used", "more", "fa-x"}) == kept


each_page = pytest.mark.parametrize("name", [*listed(), "what is not in the table of contents"])


def named(name, site):
    """The page of a document; all pages that are none's for another name."""
    own = [f"{document}.html" for document in listed()]
    return [f"{name}.html"] if name in listed() else sorted({*pages(site)} - {*own})


@pytest.mark.browser
@each_page
def test_every_page_asks_for_one_sheet_and_few_scripts_which_wait(name, site):
    for page in named(name, site):
        text = (site / page).read_text("utf-8")
        # the whole page would take as long as all else here
        tags = re.findall("<(?:link|script) [^>]*>", text)
        soup = BeautifulSoup("</script>".join(tags), "html.parser")
        (sheet,) = soup.select("link[rel=stylesheet]")
        assert "_static/all.css?v=" in sheet["href"], page
        scripts = soup.select("script[src]")  # all pages', the page's own, the courseware's
        assert 0 < len(scripts) <= 3, page
        assert all(script.has_attr("defer") for script in scripts), page


each_width = pytest.mark.parametrize("width", [pytest.param(1280, marks=pytest.mark.slow), 390])
HEIGHTS = "(all) => all.map((each) => Math.round(each.getBoundingClientRect().height))"
NOW = """(all) => Promise.all(all.map((each) => {
  each.loading = "eager";
  return each.decode();
}))"""


@pytest.mark.browser
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


@pytest.mark.browser
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


@pytest.mark.browser
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


@pytest.mark.browser
def test_the_fonts_come_though_formulas_are_printed_anew_meanwhile(server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        page.add_init_script(f"({ANEW})()")
        page.goto(f"{server}bicycle/bicycle.html")
        page.wait_for_function("() => document.fonts.check('1em KaTeX_Size4')")
        assert not watch.errors


@pytest.mark.browser
@pytest.mark.parametrize("name", [name for name in listed() if "/" in name])
def test_the_fonts_hold_the_letters_of_a_page_and_others_come_when_needed(name, server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        asked = []
        page.on("request", lambda request: asked.append(request.url))
        page.goto(f"{server}{name}.html")
        draw_all(page)
        whole = [
            url
            for url in asked
            if re.search(r"KaTeX_(AMS|Main|Math)-(Regular|Bold|Italic)\.woff2", url)
        ]
        assert not whole
        assert any("KaTeX_Main-Regular-used.woff2" in url for url in asked)
        with page.expect_request("**/KaTeX_Main-Regular.woff2"):  # a letter of no page
            page.evaluate("() => document.fonts.load('1em KaTeX_Main', 'Ξ')")
        assert not watch.errors


@pytest.mark.browser
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


SHEETS = (  # in the order of the bundle
    "basic.css",
    "styles/pydata-sphinx-theme.css",
    "pygments.css",
    "styles/sphinx-book-theme.css",
    "katex/katex.min.css",
    "copybutton.css",
    "mystnb.*.css",
    "courseware.css",
    "site.css",
)


class All:
    """All names of classes."""

    def issuperset(self, names):
        """Whether these are among them."""
        return True


def whole_sheet(static):
    """All rules of all sheets."""
    files = [file for name in SHEETS for file in sorted(static.glob(name))]
    css = asset_bundle.filter_rules("\n".join(file.read_text("utf-8") for file in files), All())
    return css.replace("url(fonts/", "url(katex/fonts/")


# what can be seen of an element: where it is, and all its styles; the theme says a moment later
# which link is active
SEEN = """() => [...document.querySelectorAll("body *:not(svg *)")].map((element) => {
  const { x, y, width, height } = element.getBoundingClientRect();
  const style = getComputedStyle(element), all = [x, y, width, height];
  for (const name of style) if (!name.startsWith("--")) all.push(style.getPropertyValue(name));
  const hash = [...all.join()].reduce((sum, sign) => (31 * sum + sign.charCodeAt()) | 0, 7);
  return `${element.tagName} ${element.classList.value.replace("active", "")} ${hash}`;
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
    css, seen = whole_sheet(site / "_static"), []
    assert len(css) > 2 * (site / "_static" / "all.css").stat().st_size
    for change in (False, True):
        options = {"width": width, "scheme": scheme, "reduced_motion": "reduce"}
        with watched_page(chromium, server, **options) as (page, watch):
            if change:
                page.route("**/all.css*", lambda r: r.fulfill(body=css, content_type="text/css"))
            settled(page, server + name)
            draw_all(page)
            seen.append(page.evaluate(SEEN))
            assert not watch.errors
    assert seen[0] == seen[1]
