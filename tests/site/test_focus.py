"""Whoever goes through a page by keyboard sees where they are."""

import pytest
from browser import settled, watched_page

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

# what takes the focus and shows no ring, or one that a box round it cuts
CUT = """() => {
  document.querySelectorAll(".bd-article details").forEach((fold) => { fold.open = true; });
  const all = "a[href], button, input, select, textarea, summary, [tabindex='0']";
  return [...document.querySelectorAll(all)].filter((each) => {
    each.focus({ preventScroll: true });
    if (!each.matches(":focus-visible") || !each.checkVisibility()) return false;
    const { outlineStyle, outlineOffset, outlineWidth, boxShadow } = getComputedStyle(each);
    if (outlineStyle === "none") return boxShadow === "none";
    const wide = parseFloat(outlineOffset) + parseFloat(outlineWidth);
    const { left, right, top, bottom } = each.getBoundingClientRect();
    for (let box = each.parentElement; box !== document.body; box = box.parentElement) {
      if (getComputedStyle(box).overflow === "visible") continue;
      const outer = box.getBoundingClientRect();
      const over = [outer.left - left, right - outer.right, outer.top - top, bottom - outer.bottom];
      // further outside, the box is scrolled; half a pixel is rounding
      if (over.some((far) => far + wide > 0.5 && far < 1)) return true;
    }
    return false;
  }).map((each) => `${each.tagName}.${each.className}: ${each.textContent.slice(0, 40)}`);
}"""


@pytest.mark.parametrize("name", ["index", "practice", "elbow_arm/elbow_arm"])
def test_the_ring_of_what_has_the_focus_is_whole(name, server, chromium):
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, f"{server}{name}.html")
        page.keyboard.press("Tab")  # from now on the browser shows rings
        assert page.evaluate(CUT) == []
        page.set_viewport_size({"width": 390, "height": 844})
        assert page.evaluate(CUT) == []
