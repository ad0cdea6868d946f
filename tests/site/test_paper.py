"""The book as PDF, as `make paper` has written it; `make test-slow` does both."""

import re
from collections import Counter
from html import unescape
from pathlib import Path
from types import SimpleNamespace
from unicodedata import normalize
from xml.etree import ElementTree

import pytest
from browser import SITE, listed, watched_page
from declared import EXERCISES
from offline_bundle import PAPER, offer_paper
from paper.pages import BUILD
from paper.pdf import WORK, join_documents
from poster import PICTURE
from pypdf import PdfReader, PdfWriter

from courseware.course import course

pytest_plugins = ["browser"]


PDF = BUILD / "robokin.pdf"
WITHOUT_ANSWERS = BUILD / "robokin-without-answers.pdf"
CONTROLS = ("Link to this setting", "That is my guess", "Where should I look?")
HEADING = re.compile(r"<h[12]>(.*?)<a class=\"headerlink\"", re.S)
DRAWN = '<span class="katex-html"'
WIDER = f"""() => [...document.querySelectorAll("svg > g > text")]
  .filter((text) => text.getBBox().width > {PICTURE}).map((text) => text.textContent)"""
NUMBERED = re.compile(rf'{DRAWN}((?:(?!{DRAWN}|<p>).)*?)<span class="eqno">(\(.*?\))', re.S)


def plain(html):
    """The text of HTML in one line."""
    return " ".join(unescape(re.sub(r"<[^>]+>", "", html)).split())


def letters(text):
    """A text without blanks and ligatures."""
    return re.sub(r"[\s\u200b]", "", normalize("NFKC", text))


def page_of(name):
    """What a page of the site says, without menus."""
    text = (SITE / f"{name}.html").read_text("utf-8")
    return text[text.index("<article") : text.index("</article>")]


def titles():
    """[(title of a page, [titles of its sections])] as the site has them."""
    found = [[plain(each) for each in HEADING.findall(page_of(name))] for name in listed()]
    return [(first, rest) for first, *rest in found]


@pytest.fixture(scope="module")
def pdf(site):
    """The PDF with answers, of which the contents are the first pages; no build runs now."""
    assert PDF.exists(), "run `make paper` first"
    return PdfReader(PDF)


@pytest.fixture(scope="module")
def texts(pdf):
    """The text of each page."""
    return [page.extract_text() for page in pdf.pages]


def outline(pdf):
    """[(title, page, [titles below])] of the PDF's outline."""
    entries = []
    for entry in pdf.outline:
        if isinstance(entry, list):
            entries[-1][2].extend(each.title for each in entry if not isinstance(each, list))
        else:
            entries.append((entry.title, pdf.get_destination_page_number(entry), []))
    return entries


def missing_drawings(html):
    """Drawings and gradients that pictures use, and that a page does not have."""
    used = set(re.findall(r'<use href="#([^"]+)"|url\(#([^)"]+)\)', html))
    return {one or other for one, other in used} - set(re.findall(r' id="([^"]+)"', html))


# --- the PDF --------------------------------------------------------------------------------


@pytest.mark.slow
def test_the_outline_is_the_contents_of_the_site(pdf):
    assert [(title, below) for title, _, below in outline(pdf)] == titles()


def test_a_title_stands_once_in_the_outline(tmp_path):
    """Chromium writes those twice that a page break has moved."""
    text = PdfWriter()
    text.add_blank_page(width=100, height=100)
    above = text.add_outline_item(title="1 Dicing1 Dicing", page_number=0)
    for title in ("RecapRecap", "Recap"):
        text.add_outline_item(title=title, page_number=0, parent=above)
    text.write(tmp_path / "text.pdf")
    front = PdfReader(tmp_path / "text.pdf")
    joined = join_documents(front, PdfReader(tmp_path / "text.pdf"), [], "A book")
    joined.write(tmp_path / "book.pdf")
    found = [(title, below) for title, _, below in outline(PdfReader(tmp_path / "book.pdf"))]
    assert found == [("1 Dicing", ["Recap", "Recap"])]


@pytest.mark.slow
def test_the_contents_name_the_pages_on_which_titles_stand(pdf, texts):
    entries = outline(pdf)
    front = entries[0][1]
    contents = letters("".join(texts[:front]))
    for title, page, _ in entries:
        assert letters(title) in letters(texts[page])
        assert f"{letters(title)}{pdf.page_labels[page]}" in contents
    assert pdf.page_labels[front] == "1"


@pytest.mark.slow
def test_no_page_is_blank(pdf, texts):
    """Besides its head and its number, a page has something to read."""
    heads = {letters(title) for title, _, _ in outline(pdf)} | set(pdf.page_labels)
    blank = [k + 1 for k, text in enumerate(texts) if {*map(letters, text.split("\n"))} <= heads]
    assert blank == []


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in listed() if "/" in name])
def test_every_formula_of_a_chapter_stands_before_its_number(name, texts):
    """All its letters; their order is that in which they are drawn."""
    text = letters("".join(texts))
    formulas = NUMBERED.findall(page_of(name))
    assert formulas
    for html, number in formulas:
        wanted = Counter(letters(plain(f"<{html}")))
        reach = 2 * wanted.total() + 20
        places = [found.start() for found in re.finditer(re.escape(number), text)]
        before = [Counter(text[max(0, at - reach) : at]) for at in places]
        assert any(wanted <= window for window in before), (number, wanted)


@pytest.mark.slow
def test_figures_have_their_numbers_and_no_controls(texts):
    text = " ".join(" ".join(texts).split())
    park = page_of("index")
    shown = [plain(each) for each in re.findall(r"<dt>.*?</dd>", park, re.S)]
    assert shown
    assert all(letters(each) in letters(text) for each in shown)
    solutions = text.count("Solution ")
    assert solutions >= len(EXERCISES), f"{solutions} solutions, at least {len(EXERCISES)}"
    assert not [words for words in CONTROLS if words in text]


@pytest.mark.slow
def test_nothing_is_missing_in_a_picture():
    printed = (WORK / "text.html").read_text("utf-8")
    assert "<use " in printed
    assert missing_drawings(printed) == set()


@pytest.mark.slow
def test_links_lead_into_the_pdf_or_to_the_web(pdf):
    names, inner = pdf.named_destinations, 0
    for page in pdf.pages:
        for link in page.get("/Annots", []):
            link = link.get_object()
            target = link.get("/Dest") or link["/A"]["/URI"]
            if "/Dest" in link:
                inner += 1
                assert not isinstance(target, str) or target in names or f"/{target}" in names
            else:
                assert re.match("https?://(?!book/)", target)
    assert inner > 200, f"{inner} links lead into the PDF, at least 201: links were lost"


@pytest.mark.slow
def test_the_other_pdf_leaves_the_answers_out(pdf, texts):
    without = PdfReader(WITHOUT_ANSWERS)
    assert [(title, below) for title, _, below in outline(without)] == titles()
    pages = len(without.pages), len(pdf.pages)
    assert pages[0] < pages[1], f"{pages[0]} pages without answers, {pages[1]} with them"
    assert not [page for page in without.pages if "Solution " in page.extract_text()]


# --- the poster -----------------------------------------------------------------------------


def test_the_poster_has_a_picture_of_each_chapter_and_needs_no_other_file(site):
    poster = (site / "poster.svg").read_text("utf-8")
    titles = [f"{number} {course().title(c)}" for number, c in enumerate(course().taught)]
    shown = re.findall(r'font-weight="700">(\d .*?)</text>', poster)
    assert shown == titles[1:]  # the first one is what one knows before
    assert len(ElementTree.fromstring(poster).findall("{*}g/{*}svg")) == len(shown)
    assert not re.search(r"(href|src)=\"(?!#)|url\((?!#)|@import|<script", poster)
    assert missing_drawings(poster) == set()


@pytest.mark.browser
def test_no_words_of_the_poster_are_wider_than_its_pictures(server, chromium):
    with watched_page(chromium, server) as (page, watch):
        page.goto(f"{server}poster.svg")
        assert (page.evaluate(WIDER), watch.errors, watch.strangers) == ([], [], [])


@pytest.mark.slow
@pytest.mark.parametrize(("name", "millimetres"), [(PAPER[2], 210), (PAPER[3], 420)])
def test_a_poster_is_one_sheet_of_its_size(name, millimetres):
    (sheet,) = PdfReader(BUILD / name).pages
    assert abs(float(sheet.mediabox.width) / 72 * 25.4 - millimetres) < 1, "Chromium's own rounding"
    assert len(sheet.images) == 0, "all is drawn as lines"


# --- on the site ----------------------------------------------------------------------------


@pytest.mark.slow
def test_the_first_page_links_what_was_made(site):
    """The site was built anew after `make paper`."""
    for file in (PDF, WITHOUT_ANSWERS):
        assert f'<a href="{file.name}" download>' in page_of("index")
        assert (site / file.name).read_bytes() == file.read_bytes()


@pytest.mark.parametrize("made", [PAPER[:1], PAPER])
def test_the_first_page_links_all_or_nothing(tmp_path, made):
    for name in made:
        (tmp_path / name).touch()
    app, config = SimpleNamespace(outdir=tmp_path / "html", tags=set()), SimpleNamespace()
    config.html_extra_path = []
    offer_paper(app, config)
    taken = {Path(name).name for name in config.html_extra_path}
    assert taken == set(made if made == PAPER else ())
    assert ("paper" in app.tags) == bool(taken)
