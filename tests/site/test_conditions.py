"""Pages under conditions that a reader may have: storage, direction, copies, an earlier visit."""

import re

import pytest
from browser import COME_ALIVE, settled, watched_page

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

CHAPTER = "bicycle/bicycle.html"
REFUSED = """for (const name of ["localStorage", "sessionStorage"]) {
  Object.defineProperty(window, name, { configurable: true, get() {
    throw new DOMException("refused", "SecurityError");
  } });
}"""


def test_menus_search_and_colours_work_where_nothing_is_stored(server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        page.add_init_script(REFUSED)
        settled(page, server + CHAPTER)
        root = page.locator("html")
        looks = set()
        for _ in range(3):
            page.locator(".theme-switch-button").first.click()
            looks.add(root.get_attribute("data-mode"))
        assert looks == {"auto", "dark", "light"}
        page.locator(".primary-toggle").first.click()
        page.locator("dialog[open] nav.bd-docs-nav").wait_for()
        page.keyboard.press("Escape")
        page.locator(".search-button__button:visible").first.click()
        page.keyboard.type("bicycle")
        page.locator("#pst-search-dialog .site-results li").first.wait_for()
        assert not watch.errors + watch.strangers


DIRECTIONS = "(all) => all.map((each) => getComputedStyle(each).direction)"
LEFT_TO_RIGHT = (
    *(".bd-article .katex-html", ".bd-article pre", ".bd-article p code", ".rk-picture svg text"),
    *(".rk-readouts dd", ".rk-value", ".rk-slot", ".rk-exercise input", ".rk-card input"),
)


def test_mathematics_code_and_numbers_run_from_left_to_right(server, chromium):
    """On a page that an extension or a wrapper has turned for Persian or Arabic."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, f"{server}differential_drive/differential_drive.html")
        page.evaluate("() => { document.documentElement.dir = 'rtl'; }")
        for boxes in LEFT_TO_RIGHT:
            ways = page.locator(boxes).evaluate_all(DIRECTIONS)
            assert {*ways} == {"ltr"}, boxes


COPY = """(box) => {
  let copied = "";
  addEventListener("copy", (event) => { copied = event.clipboardData.getData("text/plain"); },
    { once: true });
  getSelection().selectAllChildren(box);
  document.execCommand("copy");
  return copied;
}"""


def test_a_copied_formula_is_its_tex(server, chromium):
    with watched_page(chromium, server) as (page, _):
        settled(page, server + CHAPTER)
        inline = page.locator(".bd-article p:has(.katex-mathml)").first
        tex = inline.locator("annotation").first.text_content()
        assert f"${tex}$" in inline.evaluate(COPY)
        display = page.locator("div.math:has(.katex-mathml)").first
        for tex in display.locator("annotation").all_text_contents():
            assert tex in display.evaluate(COPY)


# what scripts add, by kind
MADE = """() => {
  const count = {};
  const kinds = "button, .rk-bar, .rk-run, .rk-handles circle, .site-results, .rk-live, .rk-veiled";
  for (const each of document.querySelectorAll(kinds)) {
    const kind = `${each.tagName} ${each.getAttribute("class")} ${each.textContent}`;
    count[kind] = (count[kind] ?? 0) + 1;
  }
  return count;
}"""


# a screen above and below
NEAR_ONES_LIVE = """() => [...document.querySelectorAll(".rk-figure")].every((figure) => {
  const { top, bottom, width } = figure.getBoundingClientRect();
  const isFar = !width || bottom < -innerHeight || top > 2 * innerHeight;
  return isFar || figure.dataset.size === "still" || figure.courseware;
})"""


def answer_with(reply):
    return lambda route: route.fulfill(**reply)


@pytest.mark.parametrize("name", [CHAPTER, "practice.html"])
def test_a_page_that_the_browser_has_saved_comes_alive_once(name, server, chromium):
    """Its HTML is what the scripts had made of it."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, watch):
        made = []
        for _ in range(2):
            settled(page, server + name)
            figures = page.locator(".rk-figure:visible")
            for k in range(min(3, figures.count())):
                figures.nth(k).evaluate(COME_ALIVE)
                page.wait_for_function(NEAR_ONES_LIVE)
            page.evaluate("() => scrollTo(0, 0)")
            made.append(page.evaluate(MADE))
            reply = {"body": page.content(), "content_type": "text/html"}
            page.route("**/" + name, answer_with(reply))
        assert made[0] == made[1]
        assert name != CHAPTER or any("copybtn" in kind for kind in made[0])
        assert not watch.errors + watch.strangers


def test_every_file_that_a_page_fetches_names_its_version(server, chromium):
    """Else a browser may put an earlier release's file into a page of this one."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "practice.html")
        page.fill("#rk-student", "Ada")
        page.keyboard.press("Tab")
        page.locator(".rk-exercise[data-variant]").first.wait_for()
        page.keyboard.press("Control+k")
        page.keyboard.type("bicycle")
        page.locator("#pst-search-dialog .site-results li").first.wait_for()
        files = [url for url, kind in watch.kinds.items() if kind in ("script", "stylesheet")]
        assert len(files) > 4
        ours = [
            url
            for url in files
            if not re.search(r"/basic\.css|/mystnb\.\w+\.css|/styles/|/scripts/", url)
        ]
        assert [url for url in ours if "?" not in url] == []
