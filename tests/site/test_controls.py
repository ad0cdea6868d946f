"""Controls and handles under a reader's hand, by mouse and by keys."""

import json

import numpy as np
import pytest
from browser import pull
from declared import FIGURES
from figure_numbers import (
    TYPICAL,
    WORDS,
    own_controls,
    typical,
    typical_handled,
    typical_held,
    typical_moved,
)
from figure_page import OPENED, assert_shows_state, drag, nudge, slide

from courseware.figures import Slider

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


@typical_handled
def test_settings_by_mouse_and_keys(figure, alone):
    random = np.random.default_rng(20)
    seen = set()
    with alone(figure) as live:
        for turn in range(9):
            (slide, drag, nudge)[turn % 3](live, random)
            assert_shows_state(live)
            seen.add(json.dumps(live.state()))
    assert len(seen) >= 4  # some keys, as Home at the lower end, change nothing


@typical_held
def test_a_handle_taken_at_its_edge_does_not_jump(figure, alone):
    with alone(figure) as live:
        start, values = live.state(), live.values()
        spots = [live.spot(place, values) for place in range(len(figure.handles))]
        x, y = [spot for spot in spots if np.isfinite(spot).all()][-1]  # some are nowhere yet
        pull(live.page, (x + 6, y + 6), (x + 6, y + 6), steps=1)
        assert live.state() == pytest.approx(start, abs=1e-9)


@pytest.mark.parametrize(
    ("name", "values", "readout", "word"),
    [pytest.param(*row, marks=[pytest.mark.slow] * (row[0] not in TYPICAL)) for row in WORDS],
)
def test_keys_reach_a_word_instead_of_a_number(alone, name, values, readout, word):
    """From the nearer end of the slider step by step."""
    figure = FIGURES[name]
    with alone(figure) as live:
        for control in figure.controls:
            if control.key in values:
                up = round((values[control.key] - control.low) / control.step)
                down = round((control.high - values[control.key]) / control.step)
                ways = ["Home", *["ArrowRight"] * up], ["End", *["ArrowLeft"] * down]
                live.press(control, *min(ways, key=len))
        assert live.readouts()[readout] == word
        assert_shows_state(live)


@typical(lambda figure: any(isinstance(c, Slider) for c in own_controls(figure)))
def test_a_tap_moves_a_slider_by_its_step(figure, alone):
    """No slider needs to be dragged."""
    sliders = [c for c in figure.controls if isinstance(c, Slider)]
    with alone(figure) as live:
        tapped = 0
        for slider in sliders:
            live.input(slider).evaluate(OPENED)
            place = figure.controls.index(slider)
            less, more = live.root.locator(f".rk-step[data-i='{place}']").all()
            if not more.is_visible():  # it is there only while it acts
                continue
            tapped += 1
            live.press(slider, "Home")
            more.click()
            more.click()
            less.click()
            assert live.values()[slider.key] == pytest.approx(slider.low + slider.step)
            assert_shows_state(live)
    assert tapped


@typical_moved
def test_reset_restores_the_start(figure, alone):
    with alone(figure) as live:
        start = live.state()
        for control in figure.controls:
            if live.acts(control):
                live.press(control, "End")
                if live.state() == start:  # it begins there
                    live.press(control, "Home")
        assert live.state() != start
        live.root.locator(".rk-reset").click()
        assert live.state() == start
        assert_shows_state(live)
