"""A link to a figure's setting: it brings that back, and junk in it does no harm."""

import numpy as np
import pytest
from figure_numbers import started, typical_linked
from figure_page import assert_shows_state, drag, nudge, slide

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


IN_VIEW = """(name) => {
  const {top, bottom} = document.querySelector(`#${name} svg`).getBoundingClientRect();
  return top >= 0 && bottom <= innerHeight;
}"""


@typical_linked
def test_a_link_brings_the_setting_back(figure, alone):
    with alone(figure) as live:
        for turn in range(3):
            (slide, drag, nudge)[turn](live, np.random.default_rng(turn))
        state = live.state()
        live.root.locator(".rk-link").click()
        address = live.page.evaluate("location.hash")
    assert state != started(figure)
    with alone(figure, address) as live:
        for found, wanted in zip(live.state(), state, strict=True):
            # the address keeps six decimals
            assert found == wanted or found == pytest.approx(wanted, abs=1e-6)
        assert_shows_state(live)
        live.page.wait_for_function(IN_VIEW, arg=figure.name)


@typical_linked
@pytest.mark.parametrize("junk", ["-1e99", "NaN", "<script>alert(1)</script>", "%"])
def test_junk_in_the_address_does_no_harm(figure, junk, alone):
    """Too small is the end of the range, no number is the start."""
    address = "&".join(f"{key}={junk}" for key in ("x", *(c.key for c in figure.controls)))
    with alone(figure, f"#{figure.name}?{address}") as live:
        assert_shows_state(live)
        if junk != "-1e99":
            assert live.state() == started(figure)
