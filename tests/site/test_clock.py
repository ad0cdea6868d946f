"""The clock of a figure: play, pause, the end, and readers who want no motion."""

import pytest
from declared import FIGURES
from figure_numbers import ASKED, TYPICAL
from figure_page import SHOW, assert_shows_state

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
    """Where the clock stands, in SI."""
    return live.values()[clock.key]


def on_its_own_clock(page):
    """Seconds pass when the test says so."""
    page.clock.install(time=0)


@each_clock
def test_play_pause_and_the_end(figure, clock, visit):
    """On a clock of the test's own: seconds pass when it says so."""
    with visit(figure, before=on_its_own_clock, reduced_motion="no-preference") as live:
        live.page.clock.pause_at(60_000)
        live.press(clock, "Home")
        button = live.root.locator(".rk-play")
        button.click()
        assert button.text_content() == "Pause"
        live.page.clock.run_for(2000)
        # two frames of 16 ms may be missing at the start and at the end
        assert time_of(live, clock) == pytest.approx(clock.low + 2 * clock.rate, abs=0.035)
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
def test_scrubbing_takes_over_from_playing(figure, clock, visit):
    """In real time."""
    with visit(figure, reduced_motion="no-preference") as live:
        live.root.locator(".rk-play").click()
        live.page.wait_for_function(
            "([name, i, low]) => document.getElementById(name).courseware.state[i] > low",
            arg=[figure.name, figure.controls.index(clock), clock.low],
        )
        live.press(clock, "End", "ArrowLeft")
        assert live.root.locator(".rk-play").text_content() == "Play"
        assert time_of(live, clock) == pytest.approx(clock.high - clock.step)
        assert_shows_state(live)


@each_clock
def test_reduced_motion_steps(figure, clock, visit):
    """Nothing runs: each press of the button is a tenth of the time."""
    with visit(figure, reduced_motion="reduce") as live:
        live.press(clock, "Home")
        for turn in range(1, 12):
            live.root.locator(".rk-play").click()
            tenths = turn if turn <= 10 else 0  # and from the end back to the start
            wanted = clock.low + tenths * (clock.high - clock.low) / 10
            assert time_of(live, clock) == pytest.approx(wanted)
            assert live.root.locator(".rk-play").text_content() == "Play"


LOOPS = [f for f in FIGURES.values() if any(isinstance(c, Clock) and c.loops for c in f.controls)]
WAKE = "() => document.querySelectorAll('.rk-figure').forEach((e) => e.scrollIntoView())"
COUNT = """() => {
  window.drawn = {};
  const count = ({ target: { id } }) => { drawn[id] = (drawn[id] ?? 0) + 1; };
  addEventListener("courseware:drawn", count);
}"""
OUT_OF_SIGHT = """() => Object.keys(drawn).filter((id) => {
  const { top, bottom } = document.getElementById(id).getBoundingClientRect();
  return bottom < 0 || top > innerHeight;
})"""
RUNS = "(name) => document.getElementById(name).courseware.tick"


@pytest.mark.parametrize("figure", LOOPS, ids=lambda figure: figure.name)
def test_only_what_is_in_sight_runs(figure, visit):
    """All figures of the page are alive; those that draw a frame are counted."""
    with visit(figure, reduced_motion="no-preference") as live:
        page = live.page
        page.evaluate(WAKE)
        live.picture.evaluate(SHOW)
        page.wait_for_function(RUNS, arg=figure.name)
        page.evaluate(COUNT)
        page.wait_for_function("(name) => drawn[name] > 5", arg=figure.name)
        assert page.evaluate(OUT_OF_SIGHT) == []
        page.evaluate("() => scrollTo(0, document.body.scrollHeight)")
        page.wait_for_function(f"(name) => !({RUNS})(name)", arg=figure.name)


@pytest.mark.parametrize("figure", LOOPS, ids=lambda figure: figure.name)
def test_what_starts_by_itself_rests_after_two_rounds(figure, visit):
    with visit(figure, before=on_its_own_clock, reduced_motion="no-preference") as live:
        live.picture.evaluate(SHOW)
        live.page.wait_for_function(RUNS, arg=figure.name)
        clock = next(c for c in figure.controls if isinstance(c, Clock))
        live.page.clock.run_for(1000 * (2 * (clock.high - clock.low) / clock.rate + 3))
        assert not live.page.evaluate(RUNS, figure.name)
        assert time_of(live, clock) == clock.high
        live.root.locator(".rk-play").click()  # again and again
        live.page.clock.run_for(1000 * (4 * (clock.high - clock.low) / clock.rate + 3))
        assert live.page.evaluate(RUNS, figure.name)
