"""A figure that waits: still, its question beside it, until that is answered or shown."""

from contextlib import contextmanager

import pytest
from browser import watched_page
from playwright.sync_api import expect

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

FIGURE, QUESTION = "#rates", "#wheel-rate"
NEAR = "() => document.querySelector('#rates').courseware"
STATE = "() => document.querySelector('#rates').courseware.state"
CARD = ":is(#rates, #wheel-rate) .rk-card"  # beside the picture, and then below the figure
# where the picture is on the page, and how wide
LAYOUT = """() => {
  const { top, width } = document.querySelector("#rates svg").getBoundingClientRect();
  return [top + scrollY, width];
}"""
# whether a hand could get at it
TAKES_FOCUS = "(element) => { element.focus(); return document.activeElement === element; }"


@contextmanager
def visited(chromium, server, address="", **options):
    """The chapter, with its clocks stopped and the figure alive."""
    with watched_page(chromium, server, **options) as (page, watch):
        page.clock.install(time=0)
        page.goto(f"{server}differential_drive/differential_drive.html{address}")
        page.clock.pause_at(60_000)
        page.locator(FIGURE).scroll_into_view_if_needed()
        page.wait_for_function(NEAR)
        yield page
        assert not watch.errors + watch.strangers


@pytest.fixture
def page(chromium, server):
    with visited(chromium, server) as page:
        yield page


def waits(page):
    """Whether nothing of the figure can be moved or read, but its picture seen."""
    figure = page.locator(FIGURE)
    movable = figure.locator("input[data-i], .rk-reset, .rk-step, .rk-handles circle")
    taken = movable.evaluate_all(f"(all) => all.map({TAKES_FOCUS})")
    waiting, read = figure.locator(".rk-card").count(), figure.locator("dd").first.is_visible()
    assert {not waiting} == {read, *taken}
    return bool(waiting)


def play(page, milliseconds):
    """Let time pass, and return the figure's clock."""
    page.clock.run_for(milliseconds)
    return page.evaluate(STATE)[2]


def test_it_stands_still_until_it_is_shown_and_nothing_jumps(page):
    assert waits(page)
    assert play(page, 1000) == 0
    before = page.evaluate(LAYOUT)
    page.locator(f"{CARD} .rk-skip").press("Enter")
    assert not waits(page)
    assert page.evaluate(LAYOUT) == before
    assert page.locator(f"{QUESTION} > .rk-opens").is_visible()
    assert page.locator(f"{CARD} .rk-said").inner_text() == "Shown: 3.33 rad/s."
    page.locator(FIGURE).scroll_into_view_if_needed()
    assert play(page, 1000) > 0


def test_an_answer_ends_it_and_it_is_kept_and_forgotten(page):
    page.fill(f"{CARD} input", "1")
    page.press(f"{CARD} input", "Enter")
    assert not waits(page)
    page.evaluate("() => document.querySelector('#rates').courseware.setOne(0, 0.09)")
    page.get_by_role("button", name="Forget my guesses").click()
    assert waits(page)
    assert page.evaluate(STATE)[0] == 0.075  # as at the start
    page.locator(f"{CARD} .rk-skip").click()
    page.reload()
    page.locator(f"{QUESTION} > .rk-opens").wait_for()
    assert page.locator(f"{FIGURE} .rk-card").count() == 0


def test_a_link_to_the_figure_ends_it(chromium, server):
    with visited(chromium, server, FIGURE) as page:
        assert not waits(page)


def test_a_screen_reader_hears_the_title_and_the_question_only(page):
    """On paper there is all of it."""
    reader = page.context.new_cdp_session(page)
    place = {"expression": f"document.querySelector('{FIGURE}')"}
    figure = reader.send("Runtime.evaluate", place)["result"]["objectId"]
    found = reader.send("Accessibility.queryAXTree", {"objectId": figure})["nodes"]
    heard = " ".join(node.get("name", {}).get("value", "") for node in found if not node["ignored"])
    assert "two wheels from the side" in heard
    assert "Show me" in heard
    assert "1.667" not in heard  # the left rate
    assert waits(page)
    page.emulate_media(media="print")
    assert page.locator(f"{FIGURE} dd").first.is_visible()


@pytest.mark.parametrize(("motion", "shown"), [("no-preference", "Pause"), ("reduce", "Play")])
def test_what_waited_plays_once_it_is_answered(motion, shown, chromium, server):
    with watched_page(chromium, server, reduced_motion=motion) as (page, _):
        page.goto(f"{server}euler/euler.html")
        figure = page.locator("#order")
        figure.scroll_into_view_if_needed()
        page.wait_for_function("() => document.querySelector('#order').courseware")
        figure.get_by_role("button", name="alike").click()
        expect(figure.locator(".rk-play")).to_have_text(shown)
