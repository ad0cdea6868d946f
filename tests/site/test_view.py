"""The ground of a picture in space under the hand, which turns the view."""

import numpy as np
import pytest
from browser import pull
from figure_page import CANCEL
from small_figures import a, space_figure
from test_touch import Finger, scrolls

from courseware.figures import POINTER, Handle, Readout, Slider

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


TURNED = space_figure(
    controls=(Slider(a, 0.0, 1.0, start=0.5, step=0.01),),
    handles=(Handle("tip", (1, 1), {a: POINTER[0]}),),
    readouts=(Readout("set", "where the handle is", a, "m"),),
    seen_from=(0.5, 0.25),
)


def degrees(live):
    """Azimuth and elevation as shown."""
    return live.state()[1:]


def test_dragging_the_ground_turns_the_view(alone):
    """Half a turn across the picture: what is near goes with the hand, and the rest stays."""
    with alone(TURNED) as live:
        box = live.picture.bounding_box()
        before = live.state()
        x, y = box["x"] + 100, box["y"] + 100
        pull(live.page, (x, y), (x + box["width"] / 6, y + 40))
        across, down = 30, 180 * 40 / box["width"]
        # a magnet reaches 6 px: straight from the front is near
        assert degrees(live) == pytest.approx([before[1] - across, before[2] + down], abs=2)
        assert live.state()[0] == before[0]
        rest = live.state()
        live.page.mouse.move(box["x"] + 10, box["y"] + 10)  # let go: nothing follows any more
        assert live.state() == rest


def test_the_view_goes_all_round_and_stops_above(alone):
    with alone(TURNED) as live:
        box = live.picture.bounding_box()
        start = [box["x"] + 0.9 * box["width"], box["y"] + 20]
        for _ in range(3):  # to the left by 0.8 of half a turn each time: 432°, and up
            end = box["x"] + 0.1 * box["width"], start[1] + box["height"] / 2
            pull(live.page, start, end, steps=1)
        azimuth, elevation = degrees(live)
        # each of three drags rounds to a degree
        assert azimuth == pytest.approx(np.degrees(0.5) + 432 - 360, abs=2)
        assert elevation == 90
        live.press(live.figure.controls[1], "ArrowRight", "ArrowRight")
        assert degrees(live)[0] == pytest.approx(azimuth + 2, abs=0.5)  # keys go in steps


def test_a_handle_does_not_turn_the_view(alone):
    with alone(TURNED) as live:
        before = degrees(live)
        x, y = live.spot(0, {})
        pull(live.page, (x, y), (x - 80, y + 40))
        assert degrees(live) == before
        assert live.state()[0] != 0.5


def test_a_finger_across_turns_and_up_scrolls(alone):
    with alone(TURNED, width=390, has_touch=True, is_mobile=True) as live:
        live.page.evaluate("() => scrollTo(0, 0)")
        before, box = degrees(live), live.picture.bounding_box()
        x, y, finger = box["x"] + box["width"] / 2, box["y"] + 40, Finger(live.page)
        finger.drag(x, y, right=-90, down=4)
        after = degrees(live)
        assert after[0] == pytest.approx(before[0] + 180 * 90 / box["width"], abs=1)
        assert finger.scrolled() == 0
        scrolls(finger, live, x, y + 160)


def test_a_cancelled_turn_has_not_been(alone):
    with alone(TURNED) as live:
        box, before = live.picture.bounding_box(), live.state()
        live.page.mouse.move(box["x"] + 60, box["y"] + 60)
        live.page.mouse.down()
        live.page.mouse.move(box["x"] + 120, box["y"] + 90, steps=3)
        assert live.state() != before
        live.picture.evaluate(CANCEL)
        assert live.state() == before
        live.page.mouse.up()
