"""One symbol, one thing, on a page: touch a face of it, and all in the step light up."""

import re
from contextlib import contextmanager
from html import unescape
from unicodedata import normalize

import pytest
from browser import TALL, UNFOLD, draw_all, listed, watched_page
from declared import FIGURES

from courseware.script import engine
from courseware.symbols.formula_numbers import start_numbers

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

PAGE, STEP, KEY = "differential_drive", "#the-axle-is-stiff", "differential_drive.v_L"
SLOT = re.compile(r'<span ([^>]*data-of="[^>]*)>')
TAG = re.compile(r"(</?span[^>]*>)")
FACES = {  # where a symbol has a face
    "sentence": "p span.math .katex",
    "formula": "div.math .katex",
    "numbers": ".rk-numbers .katex",
    "figure": ".rk-picture svg",
    "slider": ".rk-control",
    "code": ".highlight pre",
}
# how many faces each selector finds, and whether all of them are lit
LIT = """(selectors) => {
  const found = selectors.map((selector) => [...document.querySelectorAll(selector)]);
  const lit = (face) => {
    const { backgroundColor, filter } = getComputedStyle(face);
    return backgroundColor !== "rgba(0, 0, 0, 0)" || filter !== "none";
  };
  return [found.map(({ length }) => length), found.map((faces) => faces.every(lit))];
}"""
FOLLOWED = """([step, key, before]) => {
  const face = `${step} .rk-control[data-symbol="${key}"] input`;
  const now = document.querySelector(face).getAttribute("aria-valuetext");
  return now !== before && [...document.querySelectorAll(`${step} .rk-numbers .katex [data-of]`)]
    .filter((slot) => slot.dataset.symbol === key)
    .every((slot) => now.startsWith(slot.textContent.replace(/[()]/g, "")));
}"""


@contextmanager
def visited(chromium, server, **options):
    """The page whose step has all faces of a symbol; its console must stay empty."""
    with watched_page(chromium, server, **options) as (page, watch):
        page.goto(f"{server}{PAGE}/{PAGE}.html")
        page.locator(STEP).evaluate(UNFOLD)  # what predictions open
        draw_all(page)  # then nothing moves any more
        page.locator(f"{STEP} .rk-figure").first.scroll_into_view_if_needed()
        page.wait_for_selector(f"{STEP} .rk-live")
        yield page
        assert not watch.errors + watch.strangers


@pytest.fixture(scope="module")
def opened(chromium, server):
    """The page, which all tests with a mouse share."""
    with visited(chromium, server) as page:
        yield page


@pytest.fixture
def page(opened):
    """The page with nothing lit."""
    opened.emulate_media(color_scheme="light")
    opened.mouse.move(0, 0)
    opened.evaluate("() => document.activeElement.blur()")
    assert opened.locator(".rk-named").is_hidden()
    return opened


def faces(where, key=KEY):
    """What selects the faces of a symbol in the step, of one sort."""
    face = f"{STEP} {FACES[where]}"
    return f'{face} [data-symbol="{key}"], {face}[data-symbol="{key}"]'


def lit(page, key=KEY, where=FACES):
    """Of which sorts all faces are lit; there are some of each."""
    counts, found = page.evaluate(LIT, [faces(sort, key) for sort in where])
    assert all(counts), dict(zip(where, counts, strict=True))
    return {sort for sort, is_lit in zip(where, found, strict=True) if is_lit}


def test_every_face_lights_all_of_them(page):
    note = page.locator(".rk-named")
    for where in FACES:
        page.mouse.move(0, 0)
        assert note.is_hidden()
        assert not lit(page)
        page.locator(faces(where)).first.hover(force=True)
        assert lit(page) == set(FACES), where
        assert not lit(page, "differential_drive.v_R", ["formula"])
        assert "left wheel: its speed over the floor: 0.0" in note.inner_text()
    page.keyboard.press("Escape")
    assert note.is_hidden()
    assert "formula" not in lit(page)


def test_a_tap_lights_and_a_tap_elsewhere_clears(chromium, server):
    with visited(chromium, server, width=390, has_touch=True) as page:
        note, before = page.locator(".rk-named"), page.evaluate(TALL)
        page.locator(faces("formula")).first.tap()
        assert lit(page) == set(FACES)
        assert page.evaluate(TALL) == before  # nothing moves
        box = note.bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 390
        page.locator(f"{STEP} h2").tap()
        assert note.is_hidden()


def test_the_arrow_keys_name_the_symbols_of_a_formula(page):
    """Which a screen reader hears: the note is a status."""
    formula = page.locator(f"{STEP} .math-scroll").first
    assert "arrow keys" in formula.get_attribute("aria-label")
    formula.focus()
    told = []
    for _ in range(4):
        page.keyboard.press("ArrowRight")
        told.append(page.locator(".rk-named[role=status]").inner_text())
    assert len(set(told[:3])) == 3  # v, v_R, v_L, and round again
    assert told[3] == told[0]
    page.keyboard.press("ArrowLeft")
    assert page.locator(".rk-named").inner_text() == told[2]
    page.keyboard.press("Tab")
    assert page.locator(".rk-named").is_hidden()


def text_from(html, start):
    """The text of the element whose start tag ends there."""
    text, depth = "", 1
    for piece in TAG.split(html[start : start + 1000]):
        depth += piece.startswith("<span") - piece.startswith("</span")
        if not depth:
            break
        text += "" if TAG.match(piece) else piece
    return unescape(text).replace("\u00a0", " ")


@pytest.mark.parametrize("name", listed())
def test_a_formula_has_the_numbers_of_its_figure_before_any_script_runs(name, site):
    """What is built, and printed, is what the script writes when the figure comes alive."""
    html = (site / f"{name}.html").read_text("utf-8")
    slots = list(SLOT.finditer(html))
    for slot in slots:
        flags = dict(re.findall(r'data-(\w+)="([^"]+)"', slot[1]))
        number = start_numbers(FIGURES[flags["of"]])[flags["symbol"]]
        told = engine.call("courseware.formatSlot", number, flags)
        assert normalize("NFKC", text_from(html, slot.end())) == normalize("NFKC", told)
    assert len(slots) > 20 or name != f"{PAGE}/{PAGE}"


def test_the_numbers_of_a_formula_follow_the_hand(page):
    slider = page.locator(f'{STEP} .rk-control[data-symbol="{KEY}"] input')
    for _ in range(3):
        before = slider.get_attribute("aria-valuetext")
        slider.press("ArrowLeft")
        page.wait_for_function(FOLLOWED, arg=[STEP, KEY, before])
        speed = page.locator(f'{STEP} .rk-readouts [data-symbol="motion.v"] dd').inner_text()
        results = f'{STEP} .rk-numbers .katex [data-symbol="motion.v"][data-result]'
        assert page.locator(results).first.text_content() == speed


def test_a_number_in_a_sentence_follows_the_hand_in_its_own_room(page):
    slot = page.locator(f"{STEP} p .rk-slot")
    slider = page.locator(f'{STEP} .rk-control[data-symbol="{KEY}"] input')
    speed = page.locator(f'{STEP} .rk-readouts [data-symbol="motion.v"] dd')
    page.locator(f'{STEP} .rk-control[data-symbol="differential_drive.v_R"] input').press("Home")
    rooms = set()
    for key in ("Home", "End"):
        before = slider.get_attribute("aria-valuetext")
        slider.press(key)
        page.wait_for_function(FOLLOWED, arg=[STEP, KEY, before])
        assert slot.text_content().rstrip(".,") == speed.text_content()
        rooms.add(slot.bounding_box()["width"])
    assert len(rooms) == 1  # without the minus that it had, too
