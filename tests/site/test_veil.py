"""A figure under a veil: still, until its question is answered or shown."""

from contextlib import contextmanager

import pytest
from browser import watched_page
from playwright.sync_api import expect

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

FIGURE, QUESTION = "#rates", "#wheel-rate"
NEAR = "() => document.querySelector('#rates').courseware"
STATE = "() => document.querySelector('#rates').courseware.state"
# where the question stands below the top of its figure, and how high the figure is
LAYOUT = """() => {
  const { top, height } = document.querySelector("#rates").getBoundingClientRect();
  return [document.querySelector("#wheel-rate").getBoundingClientRect().top - top, height];
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


def is_under_veil(page):
    """Whether nothing of the figure can be moved or read, but its picture seen."""
    figure = page.locator(FIGURE)
    movable = figure.locator("input, .rk-reset, .rk-step, .rk-handles circle")
    taken = movable.evaluate_all(f"(all) => all.map({TAKES_FOCUS})")
    veiled, read = figure.locator(".rk-veil").count(), figure.locator("dd").first.is_visible()
    assert {not veiled} == {read, *taken}
    return bool(veiled)


def play(page, milliseconds):
    """Let time pass, and return the figure's clock."""
    page.clock.run_for(milliseconds)
    return page.evaluate(STATE)[2]


def test_it_stands_still_until_it_is_shown_and_nothing_jumps(page):
    assert is_under_veil(page)
    assert play(page, 1000) == 0
    before = page.evaluate(LAYOUT)
    page.locator(".rk-veil button").press("Enter")
    assert not is_under_veil(page)
    assert page.evaluate(LAYOUT) == before
    assert page.locator(f"{QUESTION} > .rk-opens").is_visible()
    assert page.locator(f"{QUESTION} > .rk-said").inner_text() == "Shown: 3.33 rad/s."
    page.locator(FIGURE).scroll_into_view_if_needed()
    assert play(page, 1000) > 0


def test_an_answer_lifts_it_and_it_is_kept_and_forgotten(page):
    page.fill(f"{QUESTION} input", "1")
    page.press(f"{QUESTION} input", "Enter")
    assert not is_under_veil(page)
    page.evaluate("() => document.querySelector('#rates').courseware.setOne(0, 0.09)")
    page.get_by_role("button", name="Forget my guesses").click()
    assert is_under_veil(page)
    assert page.evaluate(STATE)[0] == 0.075  # as at the start
    page.locator(".rk-veil button").click()
    page.reload()
    page.locator(f"{QUESTION} > .rk-opens").wait_for()
    assert page.locator(".rk-veil").count() == 0


def test_a_link_to_a_setting_lifts_it(chromium, server):
    with visited(chromium, server, f"{FIGURE}?v=0.08") as page:
        assert not is_under_veil(page)
        assert page.evaluate(STATE)[0] == pytest.approx(0.08)


def test_a_screen_reader_hears_the_title_and_the_way_out_only(page):
    """And the way leads to the question. On paper there is no veil."""
    reader = page.context.new_cdp_session(page)
    place = {"expression": f"document.querySelector('{FIGURE}')"}
    figure = reader.send("Runtime.evaluate", place)["result"]["objectId"]
    found = reader.send("Accessibility.queryAXTree", {"objectId": figure})["nodes"]
    heard = " ".join(node.get("name", {}).get("value", "") for node in found if not node["ignored"])
    assert "two wheels from the side" in heard
    assert "show me" in heard
    assert "rad/s" not in heard
    page.locator(".rk-veil").get_by_role("link", name="Answer").click()
    page.wait_for_function(f"() => document.querySelector('{QUESTION}:target')")
    assert is_under_veil(page)
    page.emulate_media(media="print")
    assert page.locator(".rk-veil").is_hidden()
    assert page.locator(f"{FIGURE} dd").first.is_visible()


@pytest.mark.parametrize(("motion", "shown"), [("no-preference", "Pause"), ("reduce", "Play")])
def test_what_waited_plays_once_it_is_answered(motion, shown, chromium, server):
    with watched_page(chromium, server, reduced_motion=motion) as (page, _):
        page.goto(f"{server}euler/euler.html")
        figure = page.locator("#order")
        figure.scroll_into_view_if_needed()
        page.wait_for_function("() => document.querySelector('#order').courseware")
        page.locator("#two-orders").get_by_role("button", name="alike").click()
        expect(figure.locator(".rk-play")).to_have_text(shown)
