"""The pages of the built site, without parts that need a reader's hand or a script."""

from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
BUILD = ROOT / "_build"
SITE = BUILD / "html"


@dataclass(frozen=True)
class Page:
    """A page of the book. name: the last part of its address; part: of the contents, or "".

    styles: the style sheets that it links; body: HTML.
    """

    name: str
    part: str
    title: str
    styles: list
    body: str


def read_pages(browser, solutions, folds_open):
    """Return all pages in order. solutions: as HTML, by the exercise's name."""
    tab = browser.new_page()
    tab.add_script_tag(path=HERE / "pages.js")
    first = (SITE / "index.html").read_text("utf-8")
    parts = {"index.html": ""}
    for part in tab.evaluate("(html) => contents(html)", first):
        parts |= dict.fromkeys(part["addresses"], part["caption"])
    given = [{"address": each, "html": (SITE / each).read_text("utf-8")} for each in parts]
    made = tab.evaluate("(all) => paper(...all)", [given, solutions, folds_open])
    tab.close()
    return [Page(part=part, **page) for part, page in zip(parts.values(), made, strict=True)]
