"""What a hand does to the live figures, and what a phone shows of one."""

import numpy as np
import pytest
from declared import FIGURES
from figure_numbers import own_controls, random_state, typical, typical_figure
from figure_page import CANCEL, states_on_the_way

from courseware.figures import Clock

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


def test_dragging_is_continuous(alone):
    with alone(FIGURES["wheel-speeds"]) as live:
        start = live.centre(1)
        # on the way it meets at most one magnet
        found = states_on_the_way(live, start, start + np.array([0, 120]), 40)
    assert len(set(map(tuple, found))) >= 35


def test_near_a_special_value_it_is_exactly_that(alone):
    """A wheel's speed: as the other wheel's, zero, its end; two pixels away is near enough."""
    with alone(FIGURES["wheel-speeds"]) as live:
        for start, special in ((0.05, 0.1), (0.05, 0.0), (-0.1, -0.12)):
            there, here = (live.put([v, 0.1, 1.5]) and live.centre(0) for v in (special, start))
            toward = 2 * (there - here) / np.abs(there - here).max()
            states_on_the_way(live, here, there - toward, 3)
            assert live.state()[0] == special


def test_what_a_hand_leaves_is_what_is_shown(alone):
    """So that the formula with the figure's numbers is true."""
    with alone(FIGURES["wheel-speeds"]) as live:
        start = live.centre(1)
        *_, (_, on_the_way, _) = states_on_the_way(live, start, start + np.array([0, 37]), 3)
        _, right, _ = live.state()
    assert on_the_way != right == pytest.approx(on_the_way, abs=5e-4)
    assert right == round(right, 3)


def test_what_keys_leave_is_what_is_shown(alone):
    """And not half a step of the last digit beside it, as 0.07500000000000001."""
    with alone(FIGURES["wheel-speeds"]) as live:
        handle = live.handles.nth(1)
        handle.focus()
        before = live.state()[1]
        for _ in range(3):
            live.page.keyboard.press("ArrowUp")
            right = live.state()[1]
            assert before < right == round(right, 3)
            before = right


def test_the_thumb_follows_and_keys_go_in_steps(alone):
    figure = FIGURES["wheel-speeds"]
    with alone(figure) as live:
        start = live.centre(1)
        states_on_the_way(live, start, start + np.array([0, 15]), 1)
        slider, found = live.input(figure.controls[1]), live.state()
        assert float(slider.input_value()) == pytest.approx(found[1], abs=1e-9)
        assert abs(found[1] / 0.005 - round(found[1] / 0.005)) > 0.01  # between two steps
        live.press(figure.controls[1], "ArrowRight")
        after = live.state()[1]
        assert after == pytest.approx(round(after / 0.005) * 0.005, abs=1e-12)
        assert 0 < after - found[1] <= 0.0075


# --- Handles --------------------------------------------------------------------------------

MEASURED = """({courseware}, states) => states.map((state) => {
  courseware.set(state);
  courseware.settled();
  return [...courseware.picture.querySelectorAll(".rk-handles ellipse")].map((ring) => {
    const box = ring.getBoundingClientRect();
    const target = ring.previousSibling.getBoundingClientRect();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2, target: target.width };
  });
})"""


@typical_figure
def test_handles_are_apart(figure, alone):
    """Over settings at random, inside the picture, and large enough for a finger."""
    random = np.random.default_rng(5)
    with alone(figure, width=390) as live:
        picture = live.picture.bounding_box()
        states = [random_state(figure, random) for _ in range(30)]
        for rings in live.root.evaluate(MEASURED, states):
            for k, ring in enumerate(rings):
                assert ring["target"] >= 24  # WCAG 2.5.8
                assert ring["x"] < -50 or picture["x"] < ring["x"] < picture["x"] + picture["width"]
                for other in rings[:k]:
                    far = np.hypot(ring["x"] - other["x"], ring["y"] - other["y"])
                    assert far > 17 or ring["x"] < -50


def test_handles_that_meet_can_both_be_taken(alone):
    """The platform of the frames put upon the object's ring: each comes away from the other."""
    figure = FIGURES["room-plan"]
    with alone(figure) as live:
        state = live.state()
        state[:2], state[6:8] = [1.2, 0.9], [1.2, 1.04]  # the ring is 14 cm below the object
        live.put(state)
        for place, places in ((1, [0, 1]), (5, [6, 7])):
            before, here = live.state(), live.centre(place)
            states_on_the_way(live, here, here + np.array([31, -23]), 2)
            now = live.state()
            assert [k for k in range(9) if now[k] != before[k]] == places
            live.put(state)


def test_a_cancelled_drag_has_not_been(alone):
    with alone(FIGURES["wheel-speeds"]) as live:
        before = live.state()
        live.page.mouse.move(*live.centre(1))
        live.page.mouse.down()
        live.page.mouse.move(*(live.centre(1) + np.array([0, 30])), steps=3)
        assert live.state() != before
        live.handles.nth(1).evaluate(CANCEL)
        assert live.state() == before
        live.page.mouse.move(*(live.centre(1) + np.array([0, 60])))
        assert live.state() == before
        live.page.mouse.up()


# --- What is outside the picture ------------------------------------------------------------


def test_the_icr_outside_is_told_at_the_edge(alone):
    """Nearly straight: the ICR is 3.2 m away; on a phone, too, its words are in the picture."""
    with alone(FIGURES["wheel-speeds"], width=390) as live:
        marker = live.picture.locator(".rk-beyond")
        assert marker.count() == 0
        live.put([0.0945, 0.0975, 1.5])
        assert marker.count() == 1
        words = live.picture.locator("text", has_text="ICR")
        # the wheels are 10 cm apart: R = b/2 (v_R + v_L)/(v_R - v_L)
        assert words.text_content() == "ICR 3.2 m"
        outer, inner = live.picture.bounding_box(), words.bounding_box()
        assert outer["x"] < inner["x"]
        assert inner["x"] + inner["width"] < outer["x"] + outer["width"]
        assert outer["y"] < inner["y"]
        live.put([0.1, 0.1, 1.5])  # straight: there is none
        assert marker.count() == 0


# --- On a phone -----------------------------------------------------------------------------


@typical(
    lambda figure: any(not isinstance(c, Clock) for c in own_controls(figure)),
    ["wheel-laboratory"],
)  # with more sliders than a phone has room for
def test_on_a_phone_the_picture_stays_with_its_sliders(figure, alone):
    with alone(figure, width=390) as live:
        last = live.root.locator(".rk-controls :is(input, select, button):not(details *)")
        last = last.filter(visible=True).last
        last.evaluate("(e) => e.scrollIntoView({block: 'end', behavior: 'instant'})")
        picture, slider = live.root.locator(".rk-picture").bounding_box(), last.bounding_box()
        assert picture["y"] >= 0
        assert picture["height"] <= 0.46 * 844
        assert picture["y"] + picture["height"] <= slider["y"] + 1
        assert slider["y"] + slider["height"] <= 844
