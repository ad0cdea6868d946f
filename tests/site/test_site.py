"""Every page of the built site, in a real browser."""

import json
import os
import re
import subprocess
import sys
from html import unescape
from pathlib import Path
from urllib.parse import unquote

import pytest
from browser import COME_ALIVE, ROOT, SHIFTS, UNFOLD, draw_all, listed, pages, settled, watched_page
from declared import FIGURES
from PIL import Image
from test_steps import IN_STEPS

import book
from courseware.course import Course
from courseware.practice import all_exercises

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

AXE = Path(__file__).parent / "vendor" / "axe" / "axe.min.js"
LIMIT = 400_000  # bytes, compressed
HIGHER = {"one-axis": 640, "street-corner": 570}  # pixels on a phone, with the bar of a goal
SOLID = {"elbow_arm/elbow_arm.html": 420_000}  # seven pictures of a solid arm
DESCRIPTION = 160  # characters that search engines show
GENERATED = ("404", "genindex", "py-modindex", "search")
PAGES = [f"{name}.html" for name in (*listed(), *GENERATED)]
each_page = pytest.mark.parametrize("name", PAGES)
# what pages load, and how they look in the dark, is of as many kinds; all in the long run
KINDS = ("index", "practice", "search", "bicycle/bicycle", "notation")
each_kind = pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] * (name.removesuffix(".html") not in KINDS))
        for name in PAGES
        if name != "404.html"
    ],
)

FOUND_BY_AXE = """
async (looks) => {
  // axe reads no MathML: a heading cell with a formula counts as empty
  axe.configure({rules: [{id: "empty-table-header", selector: "th:not([role], :has(math))"}]});
  const colours = "color-contrast";  // takes as long as all other rules together
  const rules = {
    "all": {},
    "colours": {runOnly: [colours]},
    "all but colours": {rules: {[colours]: {enabled: false}}},
  }[looks];
  return (await axe.run(document, {resultTypes: ["violations"], ...rules})).violations.map(
      ({id, help, nodes}) => `${id}: ${help}: ${nodes.map((node) => node.target).join(", ")}`);
}
"""
# two thirds of a page are the parts of its formulas: MathML, which axe does not read, and what is
# drawn, all alike and hidden from screen readers. Beyond twenty a letter stands for each without
# colours of its own. Most of the rest are drawings, which have a text alternative, and words of
# code: those beyond the first twenty of a colour become plain
IN_LETTERS = """
() => {
  const beyond = (selector) => [...document.querySelectorAll(selector)].slice(20);
  document.querySelectorAll(".rk-picture [role=img], .rk-outlines")
    .forEach((drawing) => drawing.replaceChildren());
  beyond(".katex").filter((formula) => !formula.querySelector(".katex-html [style*=color]"))
    .forEach((formula) => formula.replaceChildren("x"));
  const spans = [...document.querySelectorAll("pre span[class]")];
  for (const colour of new Set(spans.map((span) => span.className)))
    beyond(`pre span[class="${colour}"]`).forEach((word) => word.replaceWith(...word.childNodes));
}
"""
AT_ONCE = "*, ::before, ::after { transition: none !important; }"  # from light to dark
LAYOUT = f"""(given) => {{
  const unfold = {UNFOLD}, comeAlive = {COME_ALIVE};
  return (
{(Path(__file__).parent / "layout.js").read_text("utf-8")}
  )(given);
}}"""
OVERFLOW = "() => document.documentElement.scrollWidth - document.documentElement.clientWidth"
REACHED = """
() => [...document.querySelectorAll(".bd-article :is(.math-scroll, pre)")]
  .filter((box) => box.checkVisibility() && box.scrollWidth > box.clientWidth)
  .every((box) => box.tabIndex === 0)
"""


def test_these_are_all_pages(site):
    assert sorted(PAGES) == pages(site)


@each_page
def test_a_page(name, site, server, chromium):
    """A first visit on a laptop, whose window then becomes as narrow as a phone.

    Nothing in the console, nothing asked of strangers, light, no fault of layout, no axe violation.
    """
    with watched_page(chromium, server, reduced_motion="reduce") as (page, watch):
        settled(page, server + name)
        all_drawn(page)
        assert_light(name, watch.weight(site), len(watch.kinds))
        assert faults(page, name, phone=False) == {}
        narrow(page)
        assert faults(page, name, phone=True) == {}
        assert found_by_axe(page, "all but colours") == []
        assert not watch.errors + watch.strangers


@each_kind
def test_what_axe_finds_on_a_laptop_and_of_colours(name, server, chromium):
    with watched_page(chromium, server, reduced_motion="reduce") as (page, watch):
        settled(page, server + name)
        all_drawn(page)
        assert found_by_axe(page, "colours") == []
        in_dark(page)
        assert found_by_axe(page, "all") == []
        assert not watch.errors + watch.strangers


def narrow(page):
    """Make the window as narrow as a phone's."""
    page.set_viewport_size({"width": 390, "height": 844})
    page.wait_for_function(REACHED)


def faults(page, name, phone):
    """What `layout.js` finds."""
    heights = {"step": 560, **HIGHER} if phone else {"step": 480, "laboratory": 800}
    options = {
        "phone": phone,
        "screens": not phone and name.partition("/")[0] in IN_STEPS,
        "heights": heights,
        "sizes": {figure: FIGURES[figure].size for figure in FIGURES},
    }
    return page.evaluate(LAYOUT, options)


def all_drawn(page):
    """Also what lies far from the window; what then scrolls sideways is reached with the keys."""
    draw_all(page)
    page.wait_for_function(REACHED)


def assert_light(name, kinds, requests):
    """At most 400 kB compressed on a first visit."""
    total = sum(kinds.values())
    parts = ", ".join(f"{kind} {size / 1000:.1f}" for kind, size in sorted(kinds.items()))
    print(f"{name}: {total / 1000:.1f} kB in {requests} requests ({parts})")
    assert total <= SOLID.get(name, LIMIT)


def in_dark(page):
    """As the system says, at once."""
    page.add_style_tag(content=AT_ONCE)
    page.emulate_media(color_scheme="dark")
    page.wait_for_function("() => document.documentElement.dataset.theme === 'dark'")


def found_by_axe(page, looks):
    """What axe finds where it looks at "all", at "colours" or at "all but colours"."""
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(IN_LETTERS)
        page.add_script_tag(path=AXE)
    return page.evaluate(FOUND_BY_AXE, looks)


@each_kind
def test_a_page_from_disk(name, site, chromium):
    """For a reader who opens the files; nothing outside the folder is asked for."""
    home = site.as_uri() + "/"
    with watched_page(chromium, home) as (page, watch):
        settled(page, home + name)
        draw_all(page)
        assert not watch.errors + watch.strangers


@pytest.mark.parametrize(
    ("width", "toggle", "menu"),
    [
        (390, ".primary-toggle", "nav.bd-docs-nav"),
        (390, ".secondary-toggle", "nav.page-toc"),
        (1280, ".secondary-toggle", "nav.page-toc"),
    ],
)
def test_a_menu_behind_a_button(site, server, chromium, width, toggle, menu):
    """Escape, a button and a choice close it; focus returns to the button that opened it."""
    with watched_page(chromium, server, width) as (page, watch):
        settled(page, server + "bicycle/bicycle.html")
        button, entries = page.locator(toggle).first, page.locator(menu)
        ways = (
            lambda: page.keyboard.press("Escape"),
            page.locator("dialog[open] .site-close").click,
            entries.locator("a[href^='#']").last.click,
        )
        for close in ways:
            button.click()
            entries.wait_for(state="visible")
            close()
            entries.wait_for(state="hidden")
            assert button.evaluate("(each) => each === document.activeElement")
        assert not watch.errors


OUTSIDE = """(box) => [...document.querySelectorAll(`${box} *`)].filter((leaf) => {
  const outer = document.querySelector(box).getBoundingClientRect();
  const { left, right, width } = leaf.getBoundingClientRect();
  return !leaf.childElementCount && leaf.textContent.trim() && leaf.checkVisibility() && width > 1
    && (left < outer.left - 1 || right > outer.right + 1)
    && !leaf.closest("svg, pre, .math, .katex, math, .pst-scrollable-table-container");
}).map((leaf) => leaf.textContent)"""


@pytest.mark.parametrize("name", ["index", "practice", "differential_drive/differential_drive"])
def test_text_of_twice_the_size_is_all_there(name, server, chromium):
    with watched_page(chromium, server) as (page, _):
        settled(page, f"{server}{name}.html")
        page.add_style_tag(content="html { font-size: 200% !important; }")
        for width in (1280, 390):
            page.set_viewport_size({"width": width, "height": 844})
            for box in (".bd-article", ".bd-sidebar-primary", ".bd-header-article"):
                assert page.evaluate(OUTSIDE, box) == [], box
            assert page.evaluate(OVERFLOW) == 0


def test_back_brings_a_figure_s_controls_and_picture_as_they_belong(server, chromium):
    """Without the browser's memory of whole pages, which tests run without."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        page.goto(f"{server}wheels/wheels.html")
        figure = page.locator("#wheel-laboratory")
        figure.scroll_into_view_if_needed()
        figure.locator("select").first.wait_for()
        figure.locator("select").first.select_option(index=1)
        figure.locator("input[type=range]").first.press("End")
        page.goto(f"{server}index.html")
        page.go_back()
        figure.scroll_into_view_if_needed()
        figure.locator("select").first.wait_for()
        shown = figure.evaluate(
            "({courseware: {inputs}}) => inputs.filter(({type}) => type !== 'radio')"
            ".map((input, k) => [Number(input.value), k])"
        )
        state = figure.evaluate(
            "({courseware: {inputs, state}}) => inputs.filter(({type}) => type !== 'radio')"
            ".map(({dataset}, k) => [state[dataset.i], k])"
        )
        assert shown == state


def test_progress_stands_in_the_menu_and_on_the_first_page(server, chromium):
    answers = {"anna": {f"bicycle-{k}": {"result": "right"} for k in (1, 3)}}
    answers["anna"]["euler-1"] = {"result": "wrong"}
    kept = {"robokin student": " Anna", "robokin answers robokin": json.dumps(answers)}
    with watched_page(chromium, server) as (page, watch):
        settled(page, server + "index.html")
        assert page.locator(".rk-so-far:not(:empty), .site-so-far:not(:empty)").count() == 0
        page.evaluate("(kept) => Object.assign(localStorage, kept)", kept)
        page.reload()
        told = f"2 of {sum(e.topic == 'bicycle' for e in all_exercises().values())} passed"
        card = page.locator("a.site-card", has_text="Bicycle model")
        assert card.locator(".rk-so-far").inner_text() == told
        assert page.locator("nav.bd-links").first.get_by_text(told).count() == 1
        assert page.get_by_text("You have passed 2 of ").is_visible()
        assert page.locator(".rk-so-far:not(:empty)").count() == 2
        assert not watch.errors


def test_on_paper(site, server, chromium):
    """What is folded lies open, unless it shall not; from dark to light; and all
    comes back.
    """
    state = """(event) => {
      dispatchEvent(new Event(event));
      const count = (all) => document.querySelectorAll(all).length;
      const { theme } = document.documentElement.dataset;
      return [theme, count("details[open]")];
    }"""
    with watched_page(chromium, server, scheme="dark") as (page, watch):
        settled(page, server + "bicycle/bicycle.html")
        folds = page.locator("details").count()
        assert page.evaluate(state, "beforeprint") == ["light", folds]
        assert page.evaluate(state, "afterprint") == ["dark", 0]
        page.evaluate("() => { window.print = () => {}; }")
        page.locator("[data-print=shut]").press("Enter")  # by key: what comes near may still move
        assert page.evaluate(state, "beforeprint") == ["light", 0]
        page.emulate_media(media="print")
        assert not page.locator(".bd-sidebar-primary, .bd-header-article").first.is_visible()
        assert page.locator(".rk-readouts dd").first.is_visible()
        assert not page.locator(".rk-panel :is(input, button)").first.is_visible()
        code = page.locator(".cell_input pre").first
        assert code.evaluate("(each) => getComputedStyle(each).whiteSpace") == "pre-wrap"
        assert not watch.errors


def test_dark_mode_is_remembered(site, server, chromium):
    """The button changes the colours, and the next page keeps them."""
    with watched_page(chromium, server) as (page, watch):
        settled(page, server + "index.html")
        for _ in range(3):
            if page.evaluate("() => document.documentElement.dataset.mode") != "dark":
                page.locator(".theme-switch-button").first.click()
        settled(page, server + "search.html")
        assert page.evaluate("() => document.documentElement.dataset.theme") == "dark"
        assert not watch.errors


def test_a_long_page_opens_with_few_elements(server, chromium):
    with watched_page(chromium, server) as (page, _):
        settled(page, f"{server}practice.html")
        assert page.evaluate("() => document.querySelectorAll('*').length") <= 6000


def test_the_foot_of_a_page_says_who_which_version_and_under_which_licence(site):
    text = (site / "bicycle" / "bicycle.html").read_text("utf-8")
    foot = text[text.index("bd-footer-content") :]
    assert all(words in foot for words in ("The robokin authors", "CC BY 4.0"))
    assert f"version {book.__version__}" in foot


PAINTED = "() => performance.getEntriesByName('first-contentful-paint').length"


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("name", ["index", "practice", "own_course", "teaching", "euler/euler"])
def test_a_page_does_not_jump_when_its_scripts_come(name, width, site, server, chromium):
    """What is painted first stays where it is; the theme's scripts without `defer` come before."""
    with watched_page(chromium, server, width) as (page, watch):
        held, html = [], (site / f"{name}.html").read_text("utf-8")
        late = "|".join(re.findall(r'<script defer[^>]* src="[^"]*?([^"/?]+)', html))
        page.add_init_script(SHIFTS)
        # no builtin: Playwright marks it
        page.route(re.compile(rf"/({late})(\?|$)"), lambda route: held.append(route))
        page.goto(f"{server}{name}.html", wait_until="commit")
        page.wait_for_function(PAINTED)
        for route in held:
            route.continue_()
        page.unroute_all()
        page.wait_for_load_state()
        page.evaluate("() => new Promise((done) => requestIdleCallback(done))")
        assert sum(page.evaluate("shifts")) < 0.01  # the theme's own scripts; 0.1 is called good
        assert not watch.errors


@pytest.mark.parametrize("name", listed())
def test_a_page_has_a_description(name, site):
    """Search engines and previews of links show it."""
    text = (site / f"{name}.html").read_text("utf-8")
    metas = [dict(re.findall(r'(\w+)="([^"]*)"', tag)) for tag in re.findall("<meta [^>]*>", text)]
    for key in ({"name": "description"}, {"property": "og:description"}):
        (found,) = (unescape(meta["content"]) for meta in metas if key.items() <= meta.items())
        assert 10 < len(found) <= DESCRIPTION


@pytest.mark.parametrize("name", ["index.html", "bicycle/bicycle.html"])
def test_the_icon_of_a_home_screen_is_there(name, site):
    (found,) = re.findall(r'<link rel="apple-touch-icon" href="([^"?]+)', (site / name).read_text())
    with Image.open((site / name).parent / found) as icon:
        assert icon.size == (180, 180)


def test_icons_are_drawn(site):
    """Each icon class that a page uses has a drawing in the style sheet (the icon font is gone)."""
    sheet = (site / "_static" / "site.css").read_text("utf-8")
    drawn = set(re.findall(r"\.(fa-[a-z-]+)", sheet)) | {"fa-solid", "fa-lg"}
    for name in pages(site):
        used = set()
        for classes in re.findall(r'class="([^"]*)"', (site / name).read_text("utf-8")):
            used |= {name for name in classes.split() if name.startswith("fa-")}
        assert used <= drawn, f"{name} uses {used - drawn}"


def test_links_lead_to_a_page_and_a_place_on_it(site):
    """Those that are made as HTML, too, which Sphinx does not follow."""
    texts = {site / name: (site / name).read_text("utf-8") for name in pages(site)}
    places = {page: set(re.findall(r'\bid="([^"]+)"', text)) for page, text in texts.items()}
    dead = []
    for page, text in texts.items():
        for link in set(re.findall(r'(?:href|src)="([^":]+)"', unescape(text))):
            path, _, place = unquote(link).partition("#")
            place = place.partition("?")[0]  # a setting of a figure
            file = Path(os.path.normpath(page.parent / path.partition("?")[0])) if path else page
            if not file.exists() or (place and place not in places.get(file, {place})):
                dead.append(f"{page.relative_to(site)}: {link}")
    assert not dead


BAD_TEX = "# Bad\n\nFine: $a^2$.\n\nBad: $\\frac{1}{$ here.\n\n$$\n\\unknown\n$$\n"
WITH_KATEX = f"""
import sys
sys.path.insert(0, {str(ROOT / "book" / "_ext")!r})
extensions = ["myst_parser", "katex"]
html_math_renderer = "katex"
myst_enable_extensions = ["dollarmath"]
myst_update_mathjax = False
"""


def test_bad_tex_fails_the_build(tmp_path):
    """The message names document and line; a second build does not forget it."""
    (tmp_path / "conf.py").write_text(WITH_KATEX, "utf-8")
    (tmp_path / "index.md").write_text(BAD_TEX, "utf-8")
    options = ["-E", "-W", "--keep-going"]  # as `make book`
    command = [sys.executable, "-m", "sphinx", *options, tmp_path, tmp_path / "html"]
    for _ in range(2):
        run = subprocess.run(command, capture_output=True, text=True)
        assert run.returncode != 0
        assert "index.md:5: WARNING: TeX: " in run.stderr
        assert "index.md:7: WARNING: TeX: Undefined control sequence: \\unknown" in run.stderr


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("course_name: kinematics-2026  # a new one", "kinematics-2026"),
        ('course_name: "2026 # 1"  # a new one', "2026 # 1"),
        ("course_name: 'kin 2026'", "kin 2026"),
        ("course_name:", None),
    ],
)
def test_the_teacher_s_commands_know_the_course_of_the_site(tmp_path, line, name):
    text, setting = (ROOT / "_config.yml").read_text("utf-8"), line.partition(":")[0].strip()
    changed, count = re.subn(rf"(?m)^( +){setting}:.*$", rf"\1{line}", text)
    assert count == 1
    (tmp_path / "_config.yml").write_text(changed, "utf-8")
    (tmp_path / "book").mkdir()
    known = Course("book", "own", {}, None)
    known.folder = tmp_path / "book"
    assert known.settings["course_name"] == name
