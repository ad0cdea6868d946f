"""Pages under conditions that a reader may have: storage, direction, copies, an earlier visit."""

import pytest
from browser import COME_ALIVE, draw_all, settled, watched_page

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

CHAPTER = "bicycle/bicycle.html"
REFUSED = """for (const name of ["localStorage", "sessionStorage"]) {
  Object.defineProperty(window, name, { configurable: true, get() {
    throw new DOMException("refused", "SecurityError");
  } });
}"""
FULL = """for (const store of [localStorage, sessionStorage]) {
  store.clear();
  for (let size = 2 ** 22, k = 0; size >= 1; k += 1) {
    try { store.setItem(k, "x".repeat(size)); } catch { size /= 2; }
  }
}"""


@pytest.mark.parametrize("storage", [REFUSED, FULL])
def test_menus_search_and_colours_work_where_nothing_is_stored(storage, server, chromium):
    with watched_page(chromium, server, 390) as (page, watch):
        page.add_init_script(storage)
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


def test_a_reader_whose_answers_are_not_stored_is_told(server, chromium):
    with watched_page(chromium, server) as (page, watch):
        page.add_init_script(FULL)
        page.goto(server + "practice.html")
        page.fill("#rk-student", "Ada")
        page.keyboard.press("Tab")
        page.locator(".rk-progress", has_text="keeps nothing more").wait_for()
        assert not watch.errors


# where each letter stands, from the first one of its box
LETTERS = """(boxes) => [...document.querySelectorAll(boxes)].filter((box) => box.checkVisibility())
  .slice(0, 300).map((box) => {
    const texts = document.createTreeWalker(box, NodeFilter.SHOW_TEXT), found = [];
    for (let text; (text = texts.nextNode());) [...text.data].slice(0, 60).forEach((letter, k) => {
      const range = new Range();
      range.setStart(text, k);
      range.setEnd(text, k + 1);
      const { left, top, width } = range.getBoundingClientRect();
      if (width && letter.trim()) found.push([letter, left, top]);
    });
    return found.map(([letter, left, top]) =>
      `${letter} ${Math.round(left - found[0][1])} ${Math.round(top - found[0][2])}`).join(", ");
  })"""
LEFT_TO_RIGHT = (
    ".bd-article :is(.katex-html, math, pre, p code, .rk-readouts dd, .rk-value, .rk-slot, "
    ".rk-picture svg text, .rk-text p)"
)


@pytest.mark.parametrize("name", ["euler/euler", "practice", "notation"])
def test_mathematics_code_and_numbers_run_from_left_to_right(name, server, chromium):
    """On a page that an extension or a wrapper has turned for Persian or Arabic."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, f"{server}{name}.html")
        draw_all(page)
        page.add_style_tag(content="p code { white-space: nowrap; }")  # lines end elsewhere then
        before = page.evaluate(LETTERS, LEFT_TO_RIGHT)
        assert len(before) > 50
        page.evaluate("() => { document.documentElement.dir = 'rtl'; }")
        assert page.evaluate(LETTERS, LEFT_TO_RIGHT) == before
        for box in page.locator(":is(.rk-exercise, .rk-prediction) input").all()[:3]:
            assert box.evaluate("(each) => getComputedStyle(each).direction") == "ltr"


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
  const kinds = "button, .rk-bar, .rk-run, .rk-handles circle, .site-results, .rk-live, .rk-veil";
  for (const each of document.querySelectorAll(kinds)) {
    const kind = `${each.tagName} ${each.getAttribute("class")} ${each.textContent}`;
    count[kind] = (count[kind] ?? 0) + 1;
  }
  return count;
}"""


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
        assert [url for url in files if "?" not in url] == []
