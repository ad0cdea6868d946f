"""The first page: one goal on its first screen, and a card for each chapter."""

import re

import pytest
from browser import settled, watched_page

from courseware.course import course

pytest_plugins = ["browser"]

OUTSIDE = """() => [...document.querySelectorAll(`h1, .site-start a, #hero .rk-goal,
    #hero .rk-handles circle, #hero :is(input, button)`)].filter((each) => {
  const { top, bottom, left, right } = each.getBoundingClientRect();
  return top < 0 || left < 0 || bottom > innerHeight || right > innerWidth;
}).map((each) => each.outerHTML)"""


@pytest.mark.browser
@pytest.mark.parametrize(("width", "height"), [(1280, 800), (390, 844)])
def test_the_first_screen_holds_the_goal_and_its_keys(server, chromium, width, height):
    with watched_page(chromium, server, reduced_motion="reduce") as (page, watch):
        page.set_viewport_size({"width": width, "height": height})
        settled(page, server + "index.html")
        page.wait_for_selector("#hero.rk-live")
        assert page.evaluate(OUTSIDE) == []
        left, right = page.locator("#hero .rk-panel input").all()
        for key, slider, count in (("ArrowRight", left, 8), ("ArrowRight", right, 2)):
            assert page.locator("#hero .rk-done").count() == 0
            for _ in range(count):
                slider.press(key)  # to 0.12 and 0.06 m/s
        page.wait_for_selector("#hero .rk-done")
        assert not watch.errors


@pytest.mark.browser
def test_the_menu_opens_on_a_laptop(server, chromium):
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        settled(page, server + "index.html")
        menu = page.locator("#pst-primary-sidebar")
        assert not menu.is_visible()
        page.locator(".primary-toggle").click()
        assert menu.get_by_role("link", name="Bicycle model").is_visible()


def test_the_pictures_of_the_cards_are_whole_and_of_one_shape(site):
    """Wide enough for all that they show, and without a number that could not be computed."""
    text = (site / "index.html").read_text("utf-8")
    cards = re.findall(r'<a class="site-card".*?</a>', text, re.DOTALL)
    shapes = [re.search(r'viewBox="0 0 (\S+) (\S+)"', card).groups() for card in cards]
    assert len(set(shapes)) == 1
    assert not re.search("NaN|undefined|Infinity", "".join(cards))


@pytest.mark.parametrize("chapter", course().taught)
def test_a_chapter_has_a_card_with_its_time(site, chapter):
    text = (site / "index.html").read_text("utf-8")
    cards = dict(re.findall(r'site-card" href="(\w+)/.*?(\d*) min', text, re.DOTALL))
    assert cards[chapter] == course().minutes(chapter) != "", (
        f"say in the first cell of {chapter}.ipynb how long it takes: Time: about 60 minutes"
    )
