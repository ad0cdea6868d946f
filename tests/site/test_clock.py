"""The clock of a figure: play, pause, the end, and readers who want no motion."""

import pytest
from declared import FIGURES
from figure_numbers import ASKED, TYPICAL, started
from figure_page import assert_shows_state
from playwright.sync_api import expect

from courseware.figures import Clock

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


each_clock = pytest.mark.parametrize(
    ("figure", "clock"),
    [
        pytest.param(f, c, marks=[pytest.mark.slow] * (f.name not in TYPICAL), id=f.name)
        for f in FIGURES.values()
        for c in f.controls
        if isinstance(c, Clock) and not c.loops and f.name not in ASKED
    ],
)


def time_of(live, clock):
    """The clock's time, in SI."""
    return live.values()[clock.key]


def on_its_own_clock(page):
    """Seconds pass when the test says so."""
    page.clock.install(time=0)


@each_clock
def test_play_pause_and_the_end(figure, clock, alone):
    """On a clock of the test's own: seconds pass when it says so."""
    with alone(figure, before=on_its_own_clock, reduced_motion="no-preference") as live:
        live.page.clock.pause_at(60_000)
        live.press(clock, "Home")
        button = live.root.locator(".rk-play")
        button.click()
        assert button.text_content() == "Pause"
        live.page.clock.run_for(1000)  # no clock is at its end by then
        # two frames of 16 ms may be missing at the start and at the end
        assert time_of(live, clock) == pytest.approx(clock.low + clock.rate, abs=0.035)
        button.click()
        stopped = time_of(live, clock)
        live.page.clock.run_for(1000)
        assert time_of(live, clock) == stopped
        assert button.text_content() == "Play"
        assert_shows_state(live)
        button.click()
        live.page.clock.run_for(1000 * (clock.high - clock.low) / clock.rate)
        assert time_of(live, clock) == clock.high
        assert button.text_content() == "Play"
        assert_shows_state(live)
        button.click()  # from the end it starts again
        live.page.clock.run_for(1000)
        assert time_of(live, clock) == pytest.approx(clock.low + clock.rate, abs=0.035)


@each_clock
def test_scrubbing_takes_over_from_playing(figure, clock, alone):
    """In real time."""
    with alone(figure, reduced_motion="no-preference") as live:
        live.root.locator(".rk-play").click()
        live.page.wait_for_function(
            """([name, i, low, high]) => {
              const time = document.getElementById(name).courseware.state[i];
              return time > low && time < high;  // it may have stood at its end
            }""",
            arg=[figure.name, figure.controls.index(clock), clock.low, clock.high],
        )
        live.press(clock, "End", "ArrowLeft")
        assert live.root.locator(".rk-play").text_content() == "Play"
        assert time_of(live, clock) == pytest.approx(clock.high - clock.step)
        assert_shows_state(live)


@each_clock
def test_reduced_motion_steps(figure, clock, alone):
    """Nothing runs: each press of the button is a tenth of the time."""
    with alone(figure, reduced_motion="reduce") as live:
        live.press(clock, "Home")
        for turn in range(1, 12):
            live.root.locator(".rk-play").click()
            tenths = turn if turn <= 10 else 0  # and from the end back to the start
            wanted = clock.low + tenths * (clock.high - clock.low) / 10
            assert time_of(live, clock) == pytest.approx(wanted)
            assert live.root.locator(".rk-play").text_content() == "Play"


# --- What plays by itself -------------------------------------------------------------------

PARK = FIGURES["park"]
LOOP = next(c for c in PARK.controls if isinstance(c, Clock))
TIME = f"document.getElementById('park').courseware.state[{PARK.controls.index(LOOP)}]"


def test_motion_loops_in_sight_and_rests_out_of_it(alone):
    place = PARK.controls.index(LOOP)
    with alone(PARK, reduced_motion="no-preference") as live:
        live.picture.scroll_into_view_if_needed()
        live.page.wait_for_function(f"() => {TIME} > {LOOP.low + 0.2}")
        highest = 0.9 * LOOP.high
        live.root.evaluate("({courseware}, [i, t]) => courseware.setOne(i, t)", [place, highest])
        live.page.wait_for_function(f"() => {TIME} > {highest}")
        live.page.wait_for_function(f"() => {TIME} < {highest}")  # and again
        live.press(PARK.controls[0], "End")  # another hand does not stop it …
        before = live.state()[place]
        live.page.wait_for_function(f"() => {TIME} !== {before}")
        live.page.evaluate("() => scrollTo(0, document.body.scrollHeight)")
        button = live.root.locator(".rk-play")
        expect(button).to_have_text("Play")
        live.picture.scroll_into_view_if_needed()
        expect(button).to_have_text("Pause")  # in sight again
        button.click()  # … and the button does
        expect(button).to_have_text("Play")
        button.click()
        expect(button).to_have_text("Pause")


def test_it_rests_after_two_rounds(alone):
    ticks = "({courseware}) => courseware.tick"
    with alone(PARK, before=on_its_own_clock, reduced_motion="no-preference") as live:
        round = (LOOP.high - LOOP.low) / LOOP.rate
        live.page.wait_for_function(f"() => ({ticks})(document.getElementById('park'))")
        live.page.clock.run_for(1000 * (2 * round + 3))
        assert not live.root.evaluate(ticks)
        assert time_of(live, LOOP) == LOOP.high
        live.root.locator(".rk-play").click()  # again and again
        live.page.clock.run_for(1000 * (4 * round + 3))
        assert live.root.evaluate(ticks)


def test_nothing_plays_by_itself_for_those_who_want_no_motion(alone):
    with alone(PARK) as live:
        live.picture.scroll_into_view_if_needed()
        assert live.root.locator(".rk-play").text_content() == "Play"
        assert live.state() == started(PARK)
