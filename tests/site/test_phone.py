"""On a phone all of a formula can be reached, and all of a line of code be read."""

import json
import re

import pytest
from browser import ROOT, TALL, draw_all, watched_page

import book  # noqa: F401 (opens the course)
from courseware.course import course

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

# where lines of code wrap: the signs before and after, and how far from the code's left edge the
# line goes on, in signs
WRAPPED = """
() => [...document.querySelectorAll(".cell_input pre")].flatMap((pre) => {
  const texts = document.createTreeWalker(pre, NodeFilter.SHOW_TEXT), places = [];
  for (let text; (text = texts.nextNode());) [...text.data].forEach((sign, k) => {
    const range = new Range();
    range.setStart(text, k);
    range.setEnd(text, k + 1);
    const { left, bottom, width } = range.getBoundingClientRect();
    if (width || sign === "\\n") places.push({ sign, left, bottom, width });
  });
  return places.slice(1).flatMap((place, k) => {
    const before = places[k], torn = before.sign + place.sign;
    if (torn.includes("\\n") || place.bottom < before.bottom + 9) return [];
    return [{ torn, far: (place.left - places[0].left) / places[0].width }];
  });
})
"""


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


@pytest.mark.parametrize(
    "name",
    ["wheels", *(pytest.param(n, marks=pytest.mark.slow) for n in ("elbow_arm", "planar_arm"))],
)
def test_a_line_of_code_that_wraps_hangs_and_tears_no_name(name, page, server):
    page.goto(f"{server}{name}/{name}.html")
    # Chromium may take half an em for a sign's width at first
    page.wait_for_function(f"() => ({WRAPPED})().every(({{ far }}) => Math.round(far) === 6)")
    wrapped = page.evaluate(WRAPPED)
    assert len(wrapped) > 20  # there are more
    assert not [each for each in wrapped if re.fullmatch(r"\w\w", each["torn"])]
    assert {round(each["far"]) for each in wrapped} == {6}


def test_what_wraps_is_copied_as_it_was_typed(page, server):
    """The longest code of a chapter; the text is taken from the event, before the clipboard."""
    cells = json.loads((ROOT / "book" / "wheels" / "wheels.ipynb").read_text("utf-8"))["cells"]
    typed = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    if page.url != f"{server}wheels/wheels.html":
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


@pytest.mark.parametrize("place", ["wheels-5", "equation-wheels-mobility"])
def test_a_link_leads_to_its_place_at_once_and_stays_there(place, chromium, server):
    """What is around it is drawn meanwhile, which is not quite as high as was reckoned."""
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
