"""A link to a figure's setting: it brings that back, and junk in it does no harm."""

import numpy as np
import pytest
from figure_numbers import HOMES, has_address, started, typical, typical_linked
from figure_page import assert_shows_state, drag, neighbours, nudge, slide

from courseware.figures import Choice, QuarterTurns
from courseware.units import figure_unit

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


IN_VIEW = """(name) => {
  const {top, bottom} = document.querySelector(`#${name} svg`).getBoundingClientRect();
  return top >= 0 && bottom <= innerHeight;
}"""


@typical(lambda figure: has_address(figure) and HOMES[figure.name] != "home")  # which shows no link
def test_a_link_brings_the_setting_back(figure, visit):
    with visit(figure) as live:
        for turn in range(4):
            (slide, drag, nudge)[turn % 3](live, np.random.default_rng(turn))
        state = live.state()
        live.root.locator(".rk-link").click()
        address = live.page.evaluate("location.hash")
    with visit(figure, address) as live:
        for found, wanted in zip(live.state(), state, strict=True):
            # the address keeps six decimals
            assert found == wanted or found == pytest.approx(wanted, abs=1e-6)
        assert state != started(figure)
        assert_shows_state(live)
        live.page.wait_for_function(IN_VIEW, arg=figure.name)
        for other in neighbours(live):
            assert other.state() == started(other.figure)


JUNK = ["1e99", "-1e99", "NaN", "Infinity", "", "<script>alert(1)</script>", "%", "2.5", "null"]


@typical_linked
def test_junk_in_the_address_does_no_harm(figure, visit):
    """Too large or small is the end of the range, no number is the start."""
    with visit(figure, "#?") as live:
        live.page.on("dialog", lambda dialog: pytest.fail(dialog.message))
        for junk in JUNK:
            pairs = "&".join(
                f"{name}={junk}" for name in ["x", "__proto__", *(c.key for c in figure.controls)]
            )
            live.page.evaluate("(hash) => { location.hash = hash; }", f"#{figure.name}?{pairs}")
            live.page.wait_for_function("(name) => location.hash.includes(name)", arg=figure.name)
            assert_shows_state(live)
            for control, found in zip(figure.controls, live.values().values(), strict=True):
                assert found in allowed(control, junk), (junk, control.key)


def allowed(control, junk):
    """What a control may make of junk."""
    if isinstance(control, Choice | QuarterTurns):
        return [control.start]
    scale = figure_unit(control.symbol.unit).factor
    number = {"1e99": control.high, "-1e99": control.low, "2.5": 2.5 * scale}.get(
        junk, control.start
    )
    if isinstance(control.step, int):
        number = np.floor(number + 0.5)
    return [pytest.approx(np.clip(number, control.low, control.high), rel=1e-9)]
