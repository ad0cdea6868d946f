"""A live figure in the browser, on a page with nothing else.

There it does what it does on its chapter's page, which takes ten times as long to open and twice as
long to draw.
"""

import math
import re
from contextlib import contextmanager

import numpy as np
import pytest
import sympy as sp
from browser import COME_ALIVE, UNFOLD, watched_page
from figure_numbers import (
    HOMES,
    LETTERS,
    MINUS,
    keeps_its_digits,
    point,
    pressed,
    readout_texts,
    readouts,
    rounded,
)
from verification import evaluate_exactly

from courseware.figures import Choice, QuarterTurns
from courseware.figures.compiler import coordinates
from courseware.figures.figure import render_outlines
from courseware.script import parts
from courseware.units import figure_unit

pytest_plugins = ["browser"]


def page_of(figure):
    """Return the name of a figure's page."""
    home = HOMES[figure.name]
    return "index.html" if home == "home" else f"{home}/{home}.html"


SHOW = """(svg) => new Promise((standing) => {
  let before = NaN, still = 0;
  const look = () => {
    const {top} = svg.getBoundingClientRect();
    still = top === before ? still + 1 : 0;
    if (still === 3) return standing();
    before = top;
    requestAnimationFrame(look);
  };
  svg.scrollIntoView({block: "center", behavior: "instant"});
  look();
})"""


MADE = "(name) => document.getElementById(name).courseware.state[0][1] === 1"
OPENED = "(input) => { const fold = input.closest('details'); if (fold) fold.open = true; }"


class OnPage:
    """One figure on a page in the browser."""

    def __init__(self, page, figure):
        self.page, self.figure = page, figure
        self.root = page.locator(f"#{figure.name}")
        self.handles = self.root.locator(".rk-handles circle")
        self.picture = self.root.locator(".rk-picture > svg")

    def come_alive(self):
        """Wait until the script has taken over: it does when the figure comes near."""
        self.unfold()
        self.root.evaluate(COME_ALIVE)
        return self

    def unfold(self):
        """Open the folds around it, and what a prediction shows."""
        self.root.evaluate(UNFOLD)

    def state(self):
        """Return the state of the controls, in the units that they show, once all is drawn."""
        return self.root.evaluate(
            "({courseware}) => { courseware.settled(); return courseware.state; }"
        )

    def point(self):
        """Return the state as a row of numbers in SI, computed here as on the page."""
        row = []
        for control, shown in zip(self.figure.controls, self.state(), strict=True):
            if isinstance(control, Choice):
                row += list(control.options.values())[shown]
            elif isinstance(control, QuarterTurns):
                row += pressed(*shown)
            else:
                row.append(shown * figure_unit(control.symbol.unit).factor)
        return row

    def readouts(self):
        """Return the text of each readout, by name."""
        self.state()
        texts = self.root.locator("dd").all_text_contents()
        return dict(zip((r.name for r in self.figure.readouts), texts, strict=True))

    def input(self, control):
        """Return the slider or the list of a control, or the chosen one of few options."""
        place = self.figure.controls.index(control)
        return self.root.locator(f"[data-i='{place}']:not(button, [type=radio]:not(:checked))")

    def acts(self, control):
        """Return whether a control is there, maybe in a fold: some are only while they act."""
        place = self.figure.controls.index(control)
        return not self.root.locator(f".rk-control[hidden] [data-i='{place}']").count()

    def choose(self, control, option):
        """Choose an option of a list or of a row of buttons."""
        if len(control.options) > 4:
            return self.input(control).select_option(option)
        return self.buttons(control).nth([*control.options].index(option)).check()

    def buttons(self, control):
        return self.root.locator(f"[data-i='{self.figure.controls.index(control)}'][type=radio]")

    def press(self, control, *keys):
        """Press keys on a slider that has the focus; of turns, buttons, each to its end.

        A row of buttons has no End: there its last button is chosen, at Home its first.
        """
        if isinstance(control, Choice) and self.buttons(control).count():
            for one in keys:
                self.choose(control, [*control.options][0 if one == "Home" else -1])
            return
        if isinstance(control, QuarterTurns):
            for one in keys:
                self.root.locator(f"[data-press='{one if one in LETTERS else 'Z'}']").click()
                self.page.wait_for_function(MADE, arg=self.figure.name)
            return
        self.input(control).evaluate(OPENED)
        self.input(control).focus()
        for one in keys:
            self.page.keyboard.press(one)

    def put(self, state):
        """Set a state, and draw it."""
        self.root.evaluate("({courseware}, state) => courseware.set(state)", state)
        return self.state()

    def centre(self, place):
        """Return where on the screen a handle is drawn, with the picture in view."""
        self.picture.evaluate(SHOW)
        self.state()
        box = self.handles.nth(place).bounding_box()
        return np.array([box["x"] + box["width"] / 2, box["y"] + box["height"] / 2])

    def spot(self, place, values):
        """Return where on the screen a handle is at a setting (by name, in SI)."""
        self.picture.evaluate(SHOW)
        box, (left, right, low, high) = self.picture.bounding_box(), self.figure.view
        at = sp.Matrix(coordinates(self.figure.handles[place].at))
        given = np.array([point(self.figure, values)], dtype=float)
        x, y = evaluate_exactly(at, self.figure.control_symbols, given, self.figure.where)[
            0
        ].astype(float)
        across, down = (x - left) / (right - left), (high - y) / (high - low)
        return box["x"] + across * box["width"], box["y"] + down * box["height"]

    def way(self, place, wished):
        """Return the way from where a handle is drawn, maybe beside its place, to a setting."""
        here, there = self.spot(place, self.values()), self.spot(place, wished)
        box = self.handles.nth(place).bounding_box()
        start = np.array([box["x"] + box["width"] / 2, box["y"] + box["height"] / 2])
        return start.tolist(), (start + there - here).tolist()

    def values(self):
        """Return the present setting by name, in SI."""
        row = iter(self.point())
        found = {}
        for control, shown in zip(self.figure.controls, self.state(), strict=True):
            numbers = [next(row) for _ in control.symbols]
            if isinstance(control, Choice):
                numbers = [list(control.options)[shown]]
            found[control.key] = shown[0] if isinstance(control, QuarterTurns) else numbers[0]
        return found

    def alternative(self):
        """Return the text alternative of the picture."""
        return self.picture.locator("[role=img]").get_attribute("aria-label")


HOME = "http://alone.test/"


STYLE = "body { max-width: 46rem; margin: 1rem; }"


@pytest.fixture
def alone(chromium):
    """Open a figure on a page without anything else, which can be scrolled."""

    @contextmanager
    def opened(figure, address="", before=None, reduced_motion="reduce", **options):
        scripts = parts.bundle_pages()
        html = (
            "<!doctype html><meta charset='utf-8'>"
            "<meta name='viewport' content='width=device-width'>"
            f"<style>{parts.join_styles()} {STYLE}</style>"
            f"{render_outlines([figure])}{figure.render_html()}<p style='height: 3000px'>"
            f"<script>{scripts}courseware.startFigure({figure.code});</script>"
        )
        options["reduced_motion"] = reduced_motion
        with watched_page(chromium, HOME, **options) as (page, watch):
            if before:
                before(page)
            page.route(
                f"{HOME}**", lambda route: route.fulfill(body=html, content_type="text/html")
            )
            page.goto(HOME + address)
            yield OnPage(page, figure).come_alive()
            assert not watch.errors + watch.strangers

    return opened


@contextmanager
def alone_together(chromium, figures, width, reduced_motion="reduce"):
    """Open a page with several figures and nothing else, all alive → page, what went wrong."""
    body = render_outlines(figures) + "".join(figure.render_html() for figure in figures)
    with watched_page(chromium, "about:blank", width) as (page, watch):
        page.emulate_media(reduced_motion=reduced_motion)
        page.set_content(f"<style>{parts.join_styles()} {STYLE}</style>{body}")
        scripts = [f"courseware.startFigure({figure.code});" for figure in figures]
        page.add_script_tag(content="\n".join([parts.bundle_pages(), *scripts]))
        yield page, watch


def assert_shows_state(live):
    """Compare readouts and controls with `robokin` at the state that is read back."""
    wanted = readouts(live.figure, [live.point()])[0]
    texts = live.readouts()
    for readout, value in zip(live.figure.readouts, wanted, strict=True):
        if keeps_its_digits(live.figure, readout.value):
            assert texts[readout.name] in readout_texts(readout, value), (
                live.state(),
                readout.name,
            )
    for control, shown in zip(live.figure.controls, live.state(), strict=True):
        if not isinstance(control, Choice | QuarterTurns):
            assert_slider_shows(live, control, shown)


def assert_slider_shows(live, control, shown):
    """Compare the number beside a slider, with its unit, also for a screen reader."""
    text = live.input(control).get_attribute("aria-valuetext")
    assert live.input(control).locator("xpath=../*[@data-o]").text_content() == text
    number, unit = re.fullmatch(r"(\S*?\d)(°| .*|)", text.replace(MINUS, "-")).groups()
    known = control.symbol.unit
    assert unit.strip() == ("°" if known == "rad" else known)
    digits = len(number.partition(".")[2])
    assert number.replace("-", MINUS) == rounded(shown, digits)
    assert float(number) == pytest.approx(shown, abs=control.step / figure_unit(known).factor)


SEEN = """(root) => {
  const seen = [], { courseware } = root, stop = new AbortController();
  root.ownerDocument.addEventListener("pointermove", () => {
    courseware.settled();
    seen.push(courseware.state);
  }, stop);
  root.seen = () => { stop.abort(); return seen; };
}"""


def states_on_the_way(live, start, end, moves):
    """Return the state after each of several moves of the mouse with the button down."""
    live.page.mouse.move(*start)
    live.page.mouse.down()
    live.root.evaluate(SEEN)
    live.page.mouse.move(*end, steps=moves)
    found = live.root.evaluate("(root) => root.seen()")
    live.page.mouse.up()
    return found


CANCEL = """(element) => element.dispatchEvent(
  new PointerEvent("pointercancel", {bubbles: true, pointerId: 1}))"""


def slide(live, random):
    """Press keys on a slider, or choose another entry of a list."""
    shown = [control for control in live.figure.controls if live.acts(control)]
    control = random.choice(np.array(shown, dtype=object))
    if isinstance(control, Choice):
        return live.choose(control, str(random.choice([*control.options])))
    right, left = ["ArrowRight"] * 3, ["ArrowLeft"] * 2
    keys = [["Home"], ["End"], ["Home", *right], ["End", *left], right, left, ["Home", "PageUp"]]
    return live.press(control, *keys[random.integers(len(keys))])


def wish(live, place, random):
    """Return a random setting for a handle to be dragged to, on the sliders' steps."""
    wished = live.values()
    for control in live.figure.controls:
        if getattr(control, "symbol", None) in live.figure.handles[place].sets:
            steps = round((control.high - control.low) / control.step)
            wished[control.key] = control.low + int(random.integers(steps + 1)) * control.step
    return wished


NEAR = 9  # pixels: magnets draw to both sides by 6


def drag(live, random):
    """Drag a handle by the mouse to where it belongs at another setting, and let go.

    There its place is under the pointer; what sets it may differ, as two settings look alike.
    """
    if not live.figure.handles:
        return slide(live, random)
    place = int(random.integers(len(live.figure.handles)))
    wished = wish(live, place, random)
    start, end = live.way(place, wished)
    if not np.isfinite([start, end]).all():  # before or after, the handle is nowhere
        return slide(live, random)
    live.page.mouse.move(*start)
    live.page.mouse.down()
    live.page.mouse.move(*end, steps=4)
    held = live.values()
    assert math.dist(live.spot(place, held), live.spot(place, wished)) <= NEAR, (held, wished)
    live.page.mouse.up()
    left = live.values()
    for control in live.figure.controls:
        if not isinstance(control, Choice | QuarterTurns):
            # a hundredth more for the rounding of numbers in between
            assert abs(left[control.key] - held[control.key]) <= 1.01 * control.step
    return None


def nudge(live, random):
    """Move a handle by arrow keys."""
    if not live.figure.handles:
        return slide(live, random)
    live.handles.nth(int(random.integers(len(live.figure.handles)))).focus()
    arrow = random.choice(["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "Shift+ArrowUp"])
    for _ in range(3):
        live.page.keyboard.press(arrow)
        live.state()
    return None
