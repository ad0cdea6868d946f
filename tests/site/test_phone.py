"""On a phone links lead to their places, code is copied as typed, pictures keep their shape."""

import json

import pytest
from browser import ROOT, TALL, draw_all, watched_page

import book  # noqa: F401 (opens the course)
from courseware.course import course

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

# chapters whose cells draw; two of them each time
PICTURED = [
    pytest.param(name, marks=[pytest.mark.slow] * (name not in ("odometry", "elbow_arm")))
    for name in course().taught
    if "image/png" in course().notebook(name).read_text("utf-8")
]
# of each: width by height, as it is shown and as it was drawn; whether it fits
SQUEEZED = """
() => Promise.all([...document.querySelectorAll(".cell_output img")].map(async (img) => {
  img.loading = "eager";
  await img.decode();
  const { width, height } = img.getBoundingClientRect();
  return [width / height, img.naturalWidth / img.naturalHeight, width <= innerWidth];
}))
"""


@pytest.fixture(scope="module")
def page(chromium):
    """A page of a phone."""
    with watched_page(chromium, "", 390) as (page, _):
        yield page


def test_what_wraps_is_copied_as_it_was_typed(page, server):
    """The longest code of a chapter; the text is taken from the event, before the clipboard."""
    cells = json.loads((ROOT / "book" / "wheels" / "wheels.ipynb").read_text("utf-8"))["cells"]
    typed = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    page.goto(f"{server}wheels/wheels.html")
    page.evaluate(
        "() => addEventListener('copy', (event) => { window.copied = event.target.value; })"
    )
    cell = page.locator(".cell_input:visible", has_text="backgroundcolor").first
    cell.scroll_into_view_if_needed()
    cell.locator("button.copybtn").dispatch_event("click")
    copied = page.wait_for_function("() => window.copied").json_value()
    assert copied in typed
    assert max(map(len, copied.splitlines())) > 60  # a line that wraps


FROM_TOP = "(place) => document.getElementById(place).getBoundingClientRect().top"


def test_a_link_leads_to_its_place_at_once_and_stays_there(chromium, server):
    """What is around it is drawn meanwhile, which is not quite as high as was reckoned."""
    place = "equation-wheels-mobility"
    with watched_page(chromium, server, 390) as (page, _):
        page.goto(f"{server}wheels/wheels.html")
        draw_all(page)
        tall = page.evaluate(TALL)
        page.goto(f"{server}glossary.html")
        page.goto(f"{server}wheels/wheels.html#{place}")
        head = page.locator(".bd-header-article").bounding_box()["height"]
        assert head <= page.evaluate(FROM_TOP, place) < head + 20
        page.wait_for_function(f"(tall) => {TALL} === tall", arg=tall)
        assert head <= page.evaluate(FROM_TOP, place) < head + 20


@pytest.mark.parametrize("name", PICTURED)
def test_the_pictures_of_cells_keep_their_shape(name, page, server):
    page.goto(f"{server}{name}/{name}.html")
    found = page.evaluate(SQUEEZED)
    assert found
    for shape, drawn, fits in found:
        assert shape == pytest.approx(drawn, rel=0.01)
        assert fits
