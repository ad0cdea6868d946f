"""Slides of chapters: keys lead through them, what is on them fits, figures are moved by hand."""

import pytest
from browser import pull, settled, watched_page

from courseware.course import course

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

FIRST = "frames"
each_chapter = pytest.mark.parametrize(
    "name",
    [pytest.param(c, marks=[pytest.mark.slow] * (c != FIRST)) for c in course().taught],
)
# what of a slide lies beyond it, before and after its questions are answered
BEYOND = """async () => {
  const slide = Reveal.getCurrentSlide(), beyond = [];
  const drawn = async () => {
    for (let k = 0; k < 3; k += 1) await new Promise(requestAnimationFrame);
    const boxes = [slide, ...slide.querySelectorAll(".math-scroll")];
    const over = boxes.filter((box) => box.scrollWidth > box.clientWidth + 1);
    beyond.push(...over.map((box) => `${box.className} is too wide`));
    if (slide.scrollHeight > slide.clientHeight) beyond.push("the slide is too high");
  };
  await drawn();
  slide.querySelectorAll(".rk-guess button[value], .rk-skip").forEach((button) => button.click());
  await drawn();
  const name = `${Reveal.getIndices().h} ${slide.firstChild.textContent}`;
  return beyond.map((fault) => `${name}: ${fault}`);
}"""


@each_chapter
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_keys_lead_to_the_end_and_all_fits(name, scheme, site, server, chromium):
    with watched_page(chromium, server, scheme=scheme) as (page, watch):
        settled(page, f"{server}slides/{name}.html")
        slides, beyond = page.evaluate("Reveal.getTotalSlides()"), []
        for _ in range(slides):
            beyond += page.evaluate(BEYOND)
            page.keyboard.press("ArrowRight")
        assert page.evaluate("Reveal.isLastSlide()")
        assert slides > (6 if name == "basics" else 8)  # that one has four short steps
        assert (beyond, watch.errors, watch.strangers) == ([], [], [])
    assert "_static/reveal" not in (site / name / f"{name}.html").read_text("utf-8")


def test_a_figure_is_dragged_and_escape_gives_the_keys_back(server, chromium):
    with watched_page(chromium, server, reduced_motion="reduce") as (page, watch):
        page.set_viewport_size({"width": 1920, "height": 1080})
        settled(page, f"{server}slides/{FIRST}.html#/1")
        handle = page.locator(".slides .present .rk-handles circle").first
        handle.wait_for()

        def middle():
            box = handle.bounding_box()
            return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

        x, y = middle()
        pull(page, (x, y), (x - 60, y + 30), steps=5)
        assert middle() == pytest.approx((x - 60, y + 30), abs=3), "pixels; a slider has steps"
        handle.focus()
        page.keyboard.press("ArrowRight")
        assert page.evaluate("Reveal.getIndices().h") == 1
        page.keyboard.press("Escape")
        page.keyboard.press("ArrowRight")
        assert page.evaluate("Reveal.getIndices().h") == 2
        assert not watch.errors


def test_a_presenters_keys_always_turn_the_slide(server, chromium):
    """Also after a click on an answer, and after the key with which reveal.js blanks the screen."""
    with watched_page(chromium, server) as (page, watch):
        settled(page, f"{server}slides/differential_drive.html#/2")
        page.locator(".slides .present .rk-guess button[value]").first.click()
        page.keyboard.press("b")
        page.keyboard.press("PageDown")
        assert page.evaluate("Reveal.getIndices().h") == 3
        assert not watch.errors
