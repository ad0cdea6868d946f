"""A printed chapter, read page by page as text."""

import re
from io import BytesIO

import pytest
from browser import watched_page
from declared import FIGURES
from pypdf import PdfReader

from courseware.symbols.formula_numbers import start_numbers

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

A4 = (595, 842)  # points
PAGE = "bicycle/bicycle"


@pytest.fixture(scope="module")
def printed(server, chromium):
    """What is folded in a chapter, and the pages that its print gives, from a dark screen."""
    with watched_page(chromium, server, scheme="dark", reduced_motion="reduce") as (page, _):
        page.goto(f"{server}{PAGE}.html")
        longest = page.evaluate(LONGEST)
        reader = PdfReader(BytesIO(page.pdf(format="A4", prefer_css_page_size=True)))
        yield longest, reader.pages, [sheet.extract_text() for sheet in reader.pages]


LONGEST = """() => [...document.querySelectorAll(".cell_input pre")]
  .flatMap((code) => code.textContent.split("\\n")).sort((a, b) => b.length - a.length)[0]"""


def flat(text):
    """Without blanks, which a line's break may add."""
    return re.sub(r"\s", "", text)


def test_pages_are_numbered_and_none_is_empty(printed):
    _, pages, texts = printed
    assert len(pages) > 5
    for number, (page, text) in enumerate(zip(pages, texts, strict=True), start=1):
        size = (float(page.mediabox.width), float(page.mediabox.height))
        assert size == pytest.approx(A4, abs=1)
        assert text.rstrip().endswith(str(number)) or text.lstrip().startswith(str(number))
        assert len(flat(text)) > 100 or "/XObject" in page["/Resources"], number


def test_code_is_whole(printed):
    longest, _, texts = printed
    assert len(longest) > 70
    assert flat(longest) in flat("".join(texts))


def test_figures_have_their_readouts_and_no_menus_are_there(printed):
    _, _, texts = printed
    whole = flat("".join(texts))
    for readout in FIGURES["swept-lane"].readouts:
        name = flat(re.sub(r"_\w+|[^\w ].*", "", readout.label))
        assert name in whole, readout.label
    at_start = [each["text"] for each in start_numbers(FIGURES["swept-lane"]).values()]
    assert any(flat(number) in whole for number in at_start)
    for words in ("Onthispage", "Searchthebook", "Linktothissetting", "Printthispage", "Nextopen"):
        assert words not in whole
