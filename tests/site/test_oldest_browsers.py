"""The oldest browsers that README.md names can run the site; older ones say so, and show it."""

import json
import re
from html import unescape

import pytest
from browser import watched_page
from py_mini_racer import JSEvalException, MiniRacer
from support import ROOT

from courseware.classroom import sheets

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser  # they need the built site

CHAPTER = "differential_drive/differential_drive.html"
TOO_OLD = "Here figures cannot be moved and answers not be checked"
LANGUAGE = 2022  # ECMAScript, which all of Chrome 111, Firefox 121 and Safari 16.4 know
# what is newer than one of these browsers and would break something, not only look plainer
NEWER_CALLS = "|".join(
    (
        r"\bcheckVisibility\(|\b(Object|Map)\.groupBy\(|\.withResolvers\(|\bfromAsync\(",
        r"\bURL\.(parse|canParse)\(|\b(Promise\.try|RegExp\.escape|Iterator\.from)\(",
        r"\b(showPopover|togglePopover|startViewTransition|moveBefore|setHTMLUnsafe)\(",
        r"\.(union|intersection|difference|isSubsetOf|isSupersetOf|isDisjointFrom)\(",
        r"\.(values|keys|entries)\(\)\s*\.(map|filter|some|every|find|reduce|forEach|take)\(",
    )
)
NEWER_STYLES = "|".join(
    (
        r"\(scripting:|light-dark\(|@(property|starting-style|scope|view-transition)\b",
        r"\b(rgb|hsl|hwb|lch|oklch|lab|oklab|color)\(from |@container style\(",
        r"\b(round|mod|rem|abs|sign|pow|hypot|linear)\(|:(user-valid|user-invalid|state)\b",
        r"\b(anchor-name|position-anchor|field-sizing|interpolate-size):|[{;]\s*&|&\s*[.:{>]",
    )
)


def scripts(site):
    """All that we write for the browser, by name: files, and scripts in a page."""
    static = site / "_static"
    ours = [
        "courseware/all.js",
        "site.js",
        "search.js",
        *(f"run/{n}.js" for n in ("cells", "editor", "worker")),
    ]
    found = {name: (static / name).read_text("utf-8") for name in ours}
    found["pages"] = (static / "pages" / "differential_drive-differential_drive.js").read_text(
        "utf-8"
    )
    sheets = ROOT / "courseware" / "classroom" / "sheet.js"
    return {**found, "sheet.js": sheets.read_text("utf-8"), **inline(site)}


def inline(site):
    """The scripts in a chapter and in the page that is shown where there is none."""
    return {
        f"{name}, script {k}": unescape(text)
        for name in (CHAPTER, "404.html")
        for k, text in enumerate(
            re.findall(r"<script>(.*?)</script>", (site / name).read_text("utf-8"), re.DOTALL)
        )
    }


def test_the_oldest_browsers_can_read_all_scripts(site):
    found, engine = scripts(site), MiniRacer()
    engine.eval((ROOT / "tests" / "site" / "vendor" / "acorn" / "acorn.js").read_text("utf-8"))

    def parse(text, version):
        options = f"{{ecmaVersion: {version}, sourceType: 'module'}}"
        engine.eval(f"acorn.parse({json.dumps(text)}, {options}); 0")

    for name, text in found.items():
        try:
            parse(text, LANGUAGE)
        except JSEvalException as error:
            raise AssertionError(f"{name} is newer than ES{LANGUAGE}: {error}") from error
        assert not (newer := re.search(NEWER_CALLS, text)), f"{name}: {newer[0]}"
    first = next(text for name, text in found.items() if CHAPTER in name)
    parse(first, 5)  # what tells older browsers must be read by them


def test_the_oldest_browsers_know_what_styles_depend_on(site):
    texts = {n: (site / "_static" / n).read_text("utf-8") for n in ("courseware.css", "site.css")}
    texts["sheets"] = sheets.PAGE
    for name, text in texts.items():
        plain = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
        assert not (newer := re.search(NEWER_STYLES, plain)), f"{name}: {newer[0]}"


OLD = {
    "one that cannot read the scripts": "",
    "Firefox 115": "CSS.known = CSS.supports;"
    "CSS.supports = (...of) => !/:has/.test(of) && CSS.known(...of)",
    "Chrome 79": "delete window.CSS",
}


@pytest.mark.parametrize("older", OLD.values(), ids=OLD)
def test_an_older_browser_says_so_and_shows_what_needs_no_script(chromium, server, older):
    with watched_page(chromium, server) as (page, _):
        page.add_init_script(older)
        if not older:
            broken = {"body": "/(?<=a)(?<=/;", "content_type": "text/javascript"}
            page.route("**/courseware/all.js*", lambda route: route.fulfill(**broken))
        page.goto(server + CHAPTER)
        assert page.get_by_text(TOO_OLD).is_visible()
        for dead in (".rk-figure .rk-panel", ".rk-guess", ".rk-form", ".rk-desk"):
            assert page.locator(dead).count()
            assert page.locator(dead).filter(visible=True).count() == 0, dead
        answer = page.locator(".rk-prediction .rk-opens").first
        answer.locator("summary").click()
        assert answer.locator("p").first.is_visible()
        assert page.get_by_text("answers cannot be checked here").first.is_visible()


def test_a_browser_that_is_new_enough_says_nothing(chromium, server):
    with watched_page(chromium, server) as (page, watch):
        for name in (CHAPTER, "search.html", "404.html", "practice.html"):
            page.goto(server + name)
            assert page.get_by_text(TOO_OLD).count() == 0, name
        assert not watch.errors
