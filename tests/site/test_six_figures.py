"""A figure of each kind, looked at and moved: what no chapter's figure needs yet."""

import numpy as np
import pytest
from browser import ROOT
from declared import FIGURES
from figure_numbers import random_states
from figure_page import alone_together
from six_figures import BUILDS, DRIVES, SIX
from test_labels import FAULTS

from courseware.errors import CourseError
from courseware.script import parts

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

SHEETS = ROOT / "_build" / "screenshots"
MODES = {
    "light": {},
    "dark": {"color_scheme": "dark"},
    "print": {"media": "print"},
    "forced-colours": {"forced_colors": "active"},
}
SET = """(states) => Object.entries(states).forEach(([name, state]) => {
  const live = document.getElementById(name).courseware;
  live.set(state);
  live.settled();
})"""


@pytest.fixture(scope="module", params=[1280, 390])
def alive(request, chromium):
    """All six on a page of that width."""
    with alone_together(chromium, SIX, request.param) as opened:
        yield opened


@pytest.mark.parametrize("figure", SIX, ids=lambda figure: figure.name)
def test_no_text_lies_on_another_or_outside_in_any_kind(figure, alive):
    page, watch = alive
    assert (
        not page.evaluate(FAULTS, [figure.name, random_states(figure, 5, len(figure.name))])
        + watch.errors
    )


def test_a_simulation_goes_on_from_where_it_is_and_rests_out_of_sight(chromium):
    with alone_together(chromium, (DRIVES,), 1280, "no-preference") as (page, watch):
        page.add_style_tag(content="body { padding-bottom: 3000px; }")
        root = page.locator("#drives")
        where = "({courseware}) => courseware.state[0]"
        root.locator(".rk-play").click()
        page.wait_for_function(
            "() => document.getElementById('drives').courseware.state[0][0] > -0.19"
        )
        root.locator(".rk-move").click()  # it drives on while a button straightens its way
        page.wait_for_function(
            "([root]) => root.courseware.state[1] === root.courseware.state[2]",
            arg=[root.element_handle()],
        )
        assert root.locator(".rk-play").text_content() == "Pause"
        page.evaluate("() => scrollTo(0, 2500)")
        page.wait_for_function("() => !document.getElementById('drives').courseware.tick")
        x, y, _, left, right = root.evaluate(where)
        assert left != 0 != right
        assert np.hypot(x + 0.2, y) == pytest.approx(abs(left + right) / 2, rel=0.1)
        root.locator(".rk-reset").evaluate("(button) => button.click()")
        assert root.evaluate(where) == [-0.2, 0, 0.3, 0, 0]
        assert not watch.errors


def test_a_control_is_shown_only_under_its_condition(alive):
    page, _ = alive
    root = page.locator(f"#{BUILDS.name}")
    labels = (
        "(root) => [...root.querySelectorAll('label')].filter((l) => l.checkVisibility()).length"
    )
    for kind, count in (("castor", 2), ("Mecanum", 1), ("steered", 2)):
        root.locator("select").select_option(label=kind)
        page.wait_for_function(
            f"([root, count]) => ({labels})(root) === count", arg=[root.element_handle(), count]
        )


def test_an_unknown_layer_is_refused():
    from six_figures import ROAD

    with pytest.raises(CourseError, match="shows traks; its scene has tracks, robot, centre"):
        ROAD.figure("x", "X.", "traks robot")


def test_on_paper_what_moves_by_itself_is_three_pictures(chromium):
    figures = (FIGURES["park"], DRIVES)
    assert [figure.render_frames().count("<svg") for figure in figures] == [3, 0]
    with alone_together(chromium, (), 1280) as (page, _):
        drawn = "".join(figure.render_html() for figure in figures)
        codes = ", ".join(figure.code for figure in figures)
        page.set_content(f"{drawn}<script>window.coursewareFigures = [{codes}];</script>")
        page.add_script_tag(content=f"{parts.bundle_page(parts.list_parts())}")
        for event, count in (("beforeprint", 3), ("afterprint", 0)):
            page.evaluate("(event) => dispatchEvent(new Event(event))", event)
            assert page.locator(".rk-frames svg").count() == count


@pytest.mark.slow
@pytest.mark.parametrize("mode", MODES)
def test_contact_sheets(mode, alive):
    """Write pictures of the start and of five settings, to look at."""
    page, _ = alive
    page.emulate_media(reduced_motion="reduce", **MODES[mode])
    theme = "(dark) => { document.documentElement.dataset.theme = dark ? 'dark' : 'light'; }"
    page.evaluate(theme, mode == "dark")
    SHEETS.mkdir(parents=True, exist_ok=True)
    states = {figure.name: random_states(figure, 5, len(figure.name)) for figure in SIX}
    for k in range(6):
        if k:
            page.evaluate(SET, {name: each[k - 1] for name, each in states.items()})
        width = page.viewport_size["width"]
        page.screenshot(path=SHEETS / f"six-{width}-{mode}-{k}.png", full_page=True)
    page.emulate_media(media="screen", color_scheme="light", forced_colors="none")
    page.evaluate(theme, False)
