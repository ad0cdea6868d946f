"""Whoever goes through a page by keyboard sees where they are."""

import pytest
from browser import draw_all, listed, settled, watched_page

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


# goes through all stops; what it reaches is to be seen, and nothing may lie over all of it
HIDDEN = """(back) => {
  document.querySelectorAll(".bd-article details").forEach((fold) => { fold.open = true; });
  const all = "a[href], button, input, select, textarea, summary, [tabindex='0']";
  const stops = [...document.querySelectorAll(all)].filter((each) => each.tabIndex >= 0);
  const places = [0.1, 0.5, 0.9];
  const shown = { opacityProperty: true, visibilityProperty: true };
  // the button of a choice is seen by its label, on which it lies
  const drawn = (each) => each.closest(".rk-options label") ?? each;
  const isSeen = (each) => drawn(each).checkVisibility(shown)
    && [...each.getClientRects()].some(({ left, top, width, height }) => width && height
      && places.some((x) => places.some((y) => {
        const hit = document.elementFromPoint(left + x * width, top + y * height);
        const own = hit?.closest("label") ?? hit;
        return own && (each.contains(hit) || own.contains(each));
      })));
  return (back ? stops.reverse() : stops).filter((each) => {
    each.focus();
    return document.activeElement === each && !isSeen(each);
  }).map((each) => `${each.tagName}.${each.getAttribute("class")}: ${each.textContent}`);
}"""
SHORT = ("practice", "euler/euler")
every_page = [pytest.param(n, marks=[pytest.mark.slow] * (n not in SHORT)) for n in listed()]


@pytest.mark.parametrize("name", every_page)
def test_what_has_the_focus_is_seen_and_not_covered(name, server, chromium):
    """All stops, forth and back, on a laptop and on a phone, beside the page's bars and menus."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, f"{server}{name}.html")
        draw_all(page)
        page.keyboard.press("Tab")
        for width, height in ((1280, 800), (390, 844)):
            page.set_viewport_size({"width": width, "height": height})
            for back in (False, True):
                assert page.evaluate(HIDDEN, back) == [], (width, back)


FOCUSED = "(button) => button === document.activeElement"


@pytest.mark.parametrize("name", ["index", "practice"])
def test_the_focus_stays_at_the_button_or_comes_back(name, server, chromium):
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, f"{server}{name}.html")
        for width in (390, 1000, 1280):
            page.set_viewport_size({"width": width, "height": 844})
            for button in ("theme-switch-button", "search-button__button", "primary-toggle"):
                place = page.locator(f".{button}:visible").first
                place.focus()
                page.keyboard.press("Enter")
                opened = page.locator("dialog[open]")
                if opened.count():
                    page.keyboard.press("Escape")
                    opened.wait_for(state="detached")
                assert place.evaluate(FOCUSED), (width, button)
                if button == "primary-toggle" and width > 390:
                    page.keyboard.press("Enter")  # the menu at the side is as before
