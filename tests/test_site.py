"""Every page of the built site, in a real browser."""

import re
import shutil
import subprocess
from pathlib import Path
from zipfile import ZipFile

import pytest

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser
pytest.register_assert_rewrite("browser")

from browser import ROOT, Watch, build_command, pages, watched_page  # noqa: E402

AXE = Path(__file__).parent / "vendor" / "axe" / "axe.min.js"
SCREENSHOTS = ROOT / "_build" / "screenshots"
LIMIT = 300_000  # bytes, compressed, without pictures
VIEWS = [(width, scheme) for width in (1280, 390) for scheme in ("light", "dark")]
PICTURES = ("image", "media")

FOUND_BY_AXE = """
async () => {
  // axe reads no MathML: a heading cell with a formula counts as empty
  axe.configure({rules: [{id: "empty-table-header", selector: "th:not([role], :has(math))"}]});
  return (await axe.run(document, {resultTypes: ["violations"]})).violations.map(
      ({id, help, nodes}) => `${id}: ${help}: ${nodes.map((node) => node.target).join(", ")}`);
}
"""
OVERFLOW = "() => document.documentElement.scrollWidth - document.documentElement.clientWidth"
VISIBLE_SEARCHES = """
() => [...document.querySelectorAll("input[type=search], .search-button__button")]
  .filter((element) => element.checkVisibility()).length
"""


def settled(page, address, until="networkidle"):
    """Open a page and wait until it is quiet, or only loaded, and has its fonts."""
    page.goto(address, wait_until=until)
    page.evaluate("() => document.fonts.ready")


def assert_clean(problems):
    """No page has a problem; else all of them are told."""
    told = "\n".join(f"{where}: {what}" for where, found in problems.items() for what in found)
    assert not told, told


def test_pages_are_quiet_and_stay_at_home(site, server, chromium):
    """No console message, no failed or foreign request, on the first visit and on later ones."""
    problems = {}
    for name in pages(site):
        with watched_page(chromium, server) as (first, watch):
            later = first.context.new_page()
            watch_later = Watch(later, server)
            settled(first, server + name)
            settled(later, server + name)
            visits = (watch, watch_later)
            problems[name] = [what for visit in visits for what in visit.errors + visit.strangers]
    assert_clean(problems)


def test_pages_work_from_disk(site, chromium):
    """The same for a reader who opens the files; nothing outside the folder is asked for."""
    home, problems = site.as_uri() + "/", {}
    for name in pages(site):
        with watched_page(chromium, home) as (page, watch):
            settled(page, home + name)
            problems[name] = watch.errors + watch.strangers
    assert_clean(problems)


def test_search_finds_a_page(site, server, chromium):
    """Over http and from disk."""
    for home in (server, site.as_uri() + "/"):
        with watched_page(chromium, home) as (page, watch):
            settled(page, home + "search.html?q=robot")
            page.wait_for_selector("#search-results li a")
            assert_clean({home: watch.errors + watch.strangers})


def test_pages_are_light(site, server, chromium):
    """At most 300 kB compressed on a first visit, pictures not counted."""
    heavy = {}
    for name in pages(site):
        with watched_page(chromium, server) as (page, watch):
            settled(page, server + name)
            kinds = watch.weight(site)
        total = sum(size for kind, size in kinds.items() if kind not in PICTURES)
        parts = ", ".join(f"{kind} {size / 1000:.1f}" for kind, size in sorted(kinds.items()))
        print(f"{name}: {total / 1000:.1f} kB in {len(watch.kinds)} requests ({parts})")
        heavy[name] = [f"{total} bytes"] if total > LIMIT else []
    assert_clean(heavy)


@pytest.mark.parametrize(("width", "scheme"), VIEWS)
def test_pages_are_accessible_and_fit(site, server, chromium, width, scheme):
    """axe finds nothing, nothing sticks out sideways, one search; a screenshot of each page."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    problems = {}
    with watched_page(chromium, server, width, scheme, bypass_csp=True) as (page, _):
        for name in pages(site):
            settled(page, server + name, "load")
            page.add_script_tag(path=AXE)
            found = page.evaluate(FOUND_BY_AXE)
            if over := page.evaluate(OVERFLOW):
                found.append(f"the page is {over} px too wide")
            if (searches := page.evaluate(VISIBLE_SEARCHES)) > 1 and name != "search.html":
                found.append(f"{searches} search boxes")
            if page.evaluate("() => document.documentElement.dataset.theme") != scheme:
                found.append(f"is not {scheme}")
            problems[name] = found
            picture = f"{name.removesuffix('.html').replace('/', '-')}-{width}-{scheme}.png"
            page.screenshot(path=SCREENSHOTS / picture, full_page=True)
    assert_clean(problems)


def test_menu_on_a_phone(site, server, chromium):
    """The menu button opens the chapters, Escape closes them, focus returns to the button."""
    with watched_page(chromium, server, 390) as (page, watch):
        settled(page, server + "index.html")
        chapters = page.locator("nav.bd-docs-nav")
        assert not chapters.is_visible()
        page.locator(".primary-toggle").click()
        chapters.wait_for(state="visible")
        page.screenshot(path=SCREENSHOTS / "menu-390-light.png")
        page.keyboard.press("Escape")
        chapters.wait_for(state="hidden")
        page.locator(".primary-toggle").click()
        chapters.locator("a").last.click()
        page.wait_for_load_state("networkidle")
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


def test_reduced_motion(site, server, chromium):
    """Nothing glides for a reader who asked for rest."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, server + "index.html")
        moving = page.evaluate(
            """() => [...document.querySelectorAll("*")].filter((element) => {
              const style = getComputedStyle(element);
              return style.scrollBehavior === "smooth"
                || style.transitionDuration.split(", ").some((time) => parseFloat(time) > 0);
            }).length"""
        )
        assert moving == 0


def test_pages_have_a_description(site):
    """Search engines and link previews get a sentence of at most 160 characters."""
    missing = {}
    for name in pages(site):
        text = (site / name).read_text("utf-8")
        found = re.findall(r'<meta name="description" content="([^"]*)"', text)
        missing[name] = [] if len(found) == 1 and 10 < len(found[0]) <= 200 else [str(found)]
    assert_clean(missing)


def test_root_signs_are_as_high_as_what_is_under_them(site, server, chromium):
    """The rule for pictures among the outputs must not squeeze the drawn parts of a formula."""
    look = "(all) => all.map((s) => [s.getBoundingClientRect().height, s.getAttribute('height')])"
    found = []
    for name in pages(site):
        if 'class="mord sqrt"' in (site / name).read_text("utf-8"):
            with watched_page(chromium, server) as (page, _):
                page.goto(server + name)
                found += page.locator(".katex .sqrt svg").evaluate_all(look)
    assert found
    for height, ems in found:
        assert height > 10 * float(ems.removesuffix("em"))  # px; letters are 18 px


def test_icons_are_drawn(site):
    """Each icon class that a page uses has a drawing in the style sheet (the icon font is gone)."""
    sheet = (site / "_static" / "site.css").read_text("utf-8")
    drawn = set(re.findall(r"\.(fa-[a-z-]+)", sheet)) | {"fa-solid", "fa-lg"}
    for name in pages(site):
        used = set()
        for classes in re.findall(r'class="([^"]*)"', (site / name).read_text("utf-8")):
            used |= {name for name in classes.split() if name.startswith("fa-")}
        assert used <= drawn, f"{name} uses {used - drawn}"


BAD_TEX = "# Bad\n\nFine: $a^2$.\n\nBad: $\\frac{1}{$ here.\n\n$$\n\\unknown\n$$\n"


def test_bad_tex_fails_the_build(tmp_path):
    """The message names document and line; a second build does not forget it."""
    ignore = shutil.ignore_patterns("*.ipynb", "*.md")
    shutil.copytree(ROOT / "book", tmp_path / "book", ignore=ignore)
    shutil.copy(ROOT / "_config.yml", tmp_path)
    (tmp_path / "_toc.yml").write_text("format: jb-book\nroot: bad\n", "utf-8")
    (tmp_path / "book" / "bad.md").write_text(BAD_TEX, "utf-8")
    command = [part.replace(str(ROOT / "_toc"), str(tmp_path / "_toc")) for part in build_command()]
    for _ in range(2):
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert run.returncode != 0
        assert "bad.md:5: WARNING: TeX: " in run.stderr
        assert "bad.md:7: WARNING: TeX: Undefined control sequence: \\unknown" in run.stderr


def test_downloaded_notebooks_find_what_they_need(site):
    """The wheel and the lock stand beside the notebooks, where the first page links to them."""
    links = re.findall(
        r'href="(_sources/[^"]+)" download', (site / "intro.html").read_text("utf-8")
    )
    assert {Path(link).suffix for link in links} == {".txt", ".whl"}
    assert all((site / link).is_file() for link in links)
    assert list((site / "_sources").glob("*/differential_drive.ipynb"))
    wheels = [site / link for link in links if link.endswith(".whl")]
    names = {name for wheel in wheels for name in ZipFile(wheel).namelist()}
    assert {"robokin/motion.py", "workshop/figures/figure.js", "book/bicycle/figures.py"} <= names
    lock = (site / "_sources" / "requirements.txt").read_text("utf-8")
    assert lock == (ROOT / "requirements.txt").read_text("utf-8")
