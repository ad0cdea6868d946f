"""A finger on the live figures of a phone: what it scrolls, and what it moves.

With real touches: on a typical figure, and on every figure of every page in the long run.
"""

import time

import pytest
from browser import draw_all, listed, watched_page
from declared import FIGURES
from figure_page import SHOW, OnPage

from courseware.figures import Choice, QuarterTurns

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser

FAR = 120  # pixels that a finger goes
STILL = "() => new Promise((seen) => requestAnimationFrame(() => requestAnimationFrame(seen)))"


class Finger:
    """One finger on a page."""

    def __init__(self, page):
        self.page, self.session = page, page.context.new_cdp_session(page)

    def send(self, kind, at, *touches):
        """An event at a time in seconds."""
        points = [{"x": float(x), "y": float(y)} for x, y in touches]
        event = {"type": kind, "touchPoints": points, "timestamp": at}
        self.session.send("Input.dispatchTouchEvent", event)

    def drag(self, x, y, right=0, down=0):
        """From a place, in five moves; it rests before it is lifted, so that nothing glides."""
        now = time.time()
        self.send("touchStart", now, (x, y))
        for step in range(1, 6):
            self.send("touchMove", now + step / 50, (x + right * step / 5, y + down * step / 5))
        self.send("touchEnd", now + 1)

    def scrolled(self):
        return self.page.evaluate("scrollY")


def scrolls(finger, live, x, y):
    """A swipe up from there scrolls the page, and the figure stays as it is.

    A browser that is late with a frame may pass a whole swipe over: it is made up to three times.
    """
    before, top = live.state(), finger.scrolled()
    for _ in range(3):
        finger.drag(x, y, down=-FAR)
        live.page.evaluate(STILL)
        if abs(finger.scrolled() - top) > 50:
            break
    live.page.wait_for_function("(top) => Math.abs(scrollY - top) > 50", arg=top)
    assert live.state() == before


def moves(finger, live, x, y, *ways):
    """A drag from there moves the figure, and the page stays where it is.

    ways: (right, down) each; of a slider at its end only one leads on, and along the
    radius of a circle none.
    """
    before, top = live.state(), finger.scrolled()
    for right, down in ways:
        if live.state() == before:
            finger.drag(x, y, right, down)
            live.page.evaluate(STILL)
    assert live.state() != before
    assert finger.scrolled() == top


def scroll_to(place):
    """Its box on the screen, in the middle of it and at rest."""
    place.evaluate(SHOW)
    return place.bounding_box()


def thumb(slider, box):
    """Where the middle of a slider's thumb is, across."""
    share = slider.evaluate("({value, min, max}) => (value - min) / (max - min)")
    return box["x"] + 14 + share * (box["width"] - 28)


def touch_sliders(finger, live):
    """A slider moves by its thumb and sideways; else it lets the page scroll."""
    for control in live.figure.controls:
        slider = live.input(control).and_(live.page.locator(":not([inert] *)"))  # of a guess
        if isinstance(control, Choice | QuarterTurns) or not slider.is_visible():
            continue
        box = scroll_to(slider)
        at, middle = thumb(slider, box), box["x"] + box["width"] / 2
        toward = 1 if at < middle else -1
        scrolls(finger, live, middle + toward * box["width"] / 4, box["y"] + box["height"] / 2)
        box = scroll_to(slider)
        scrolls(finger, live, at, box["y"] + box["height"] / 2)
        box = scroll_to(slider)
        moves(finger, live, at, box["y"] + box["height"] / 2, (60 * toward, -30))


def touch_ground(finger, live):
    """From the ground of a picture a finger scrolls; across, it turns a view in space."""
    scrolls(finger, live, *free(live))
    if live.figure.view_angles:
        x, y = free(live)
        moves(finger, live, x, y, (FAR if x < 195 else -FAR, 10))


def free(live):
    """A place of the picture that no handle is near to."""
    scroll_to(live.picture)
    return live.picture.evaluate("""(svg) => {
      const box = svg.getBoundingClientRect();
      for (let x = box.left + 12; x < box.right; x += 12)
        for (let y = box.bottom - 12; y > box.top; y -= 12)
          if (y > 150 && !document.elementFromPoint(x, y)?.closest(".rk-handles")) return [x, y];
    }""")


def touch_handles(finger, live):
    """Each handle can be dragged, and the page does not go with it."""
    for place in range(live.handles.count()):
        grip = live.handles.nth(place)
        if not grip.is_visible():
            continue
        live.picture.evaluate(SHOW)
        box, picture = grip.bounding_box(), live.picture.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        if not picture["x"] <= x <= picture["x"] + picture["width"]:
            continue  # it has no place now
        right = 50 if x < picture["x"] + picture["width"] / 2 else -50
        down = 40 if y < picture["y"] + picture["height"] / 2 else -40
        moves(finger, live, x, y, (right, down), (-right, -down), (right, -down))


PHONE = {"width": 390, "has_touch": True, "is_mobile": True}


def test_two_fingers_make_a_picture_in_space_larger(alone):
    """And the view stays as it is."""
    with alone(next(figure for figure in FIGURES.values() if figure.view_angles), **PHONE) as live:
        (_, y), x, before = free(live), 195, live.state()
        finger, now = Finger(live.page), time.time()
        for step in range(8):
            near = 20 + 15 * step
            kind = "touchMove" if step else "touchStart"
            finger.send(kind, now + step / 50, (x - near, y), (x + near, y))
        finger.send("touchEnd", now + 1)
        live.page.wait_for_function("() => visualViewport.scale > 1.2")
        assert live.state() == before


def scroll_or_move(live):
    """All that a finger may touch of a figure."""
    finger, start = Finger(live.page), live.state()
    for touch in (touch_sliders, touch_handles, touch_ground):
        touch(finger, live)
        live.put(start)


def test_a_finger_scrolls_or_moves_but_never_both(alone):
    with alone(FIGURES["wheel-speeds"], **PHONE) as live:
        scroll_or_move(live)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["index", *filter(lambda name: "/" in name, listed())])
def test_so_it_is_on_every_page(name, server, chromium):
    with watched_page(chromium, server, reduced_motion="reduce", **PHONE) as (page, watch):
        page.goto(f"{server}{name}.html")
        draw_all(page)  # what is drawn above moves the page
        ids = page.locator(".rk-figure").evaluate_all("(all) => all.map(({id}) => id)")
        assert ids
        for each in ids:
            scroll_or_move(OnPage(page, FIGURES[each]).come_alive())
        assert not watch.errors + watch.strangers
