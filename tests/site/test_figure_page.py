"""A figure on its chapter's page: the still picture, the script that takes it over, colours."""

import re
from itertools import compress

import numpy as np
import pytest
from browser import SHIFTS, draw_all, settled, watched_page
from declared import FIGURES
from figure_numbers import (
    each_figure,
    kind_of,
    own_controls,
    point,
    typical_figure,
    typical_moved,
)
from figure_page import SHOW, OnPage, alone_together, assert_shows_state, page_of

from courseware.figures import Choice
from robokin.styles import KINDS

pytest_plugins = ["figure_page"]
pytestmark = pytest.mark.browser


@each_figure
def test_the_page_holds_the_still_picture(figure, site):
    """The very text that the engine draws, but for the outlines of things, which are there once."""
    text = (site / page_of(figure)).read_text("utf-8")
    alone = re.sub("<defs>.*</defs>", "", figure.render_svg())
    assert alone in text
    assert {text.count(f'id="{name}"') for name in figure.compiled["drawings"]} <= {1}
    assert len(re.findall(f'id="{figure.name}"', text)) == 1


@typical_figure
def test_without_javascript_the_picture_is_there_and_why_it_stands_still(figure, server, chromium):
    with watched_page(chromium, server, java_script_enabled=False) as (page, _):
        page.goto(server + page_of(figure))
        live = OnPage(page, figure)
        live.unfold()
        draw_all(page)  # until it is, a figure's height is guessed
        live.root.scroll_into_view_if_needed()
        picture, whole = live.picture.bounding_box(), live.root.bounding_box()
        assert picture["height"] > 200
        assert picture["width"] * picture["height"] < whole["width"] * whole["height"]  # beside it
        why = "(figure) => getComputedStyle(figure, '::after').content"
        assert "no scripts run here" in live.root.evaluate(why)
        assert live.root.locator("button, input, select, dd").filter(visible=True).count() == 0


BREAK = """(figure) => courseware.startFigure({ ...figure.courseware.figure,
  compute: () => { throw new Error("on purpose"); } })"""


def test_a_broken_figure_stays_still_and_alone(chromium):
    """As in an old browser: its picture stays, without controls; the others live."""
    figures = [FIGURES[name] for name in ("wheel-speeds", "park")]
    with alone_together(chromium, figures, 1280) as (page, watch):
        broken, other = (OnPage(page, figure) for figure in figures)
        broken.root.evaluate(BREAK)
        assert broken.picture.is_visible()
        assert broken.root.locator("button, input, select").count() == 0
        other.press(other.figure.controls[0], "End")
        assert_shows_state(other)
    (error,) = watch.errors
    assert "The figure wheel-speeds cannot be moved: Error: on purpose" in error


BELOW = "(element) => element.getBoundingClientRect().bottom"


@pytest.mark.parametrize("width", [1280, 390])
@typical_figure
def test_the_page_does_not_jump_when_the_script_takes_over(figure, server, chromium, width):
    """The script comes late: the page is complete and the reader looks at the still picture."""
    start = "courseware.startFigures()"

    def held(route):
        response = route.fetch()
        assert start in response.text()
        route.fulfill(response=response, body=response.text().replace(start, "0"))

    with watched_page(chromium, server, width) as (page, watch):
        page.route("**/courseware/*.js*", held)
        settled(page, server + page_of(figure))
        live = OnPage(page, figure)
        live.unfold()
        draw_all(page)
        live.picture.evaluate(SHOW)
        below = live.root.evaluate(BELOW)
        page.evaluate(SHIFTS)
        page.evaluate(start)
        live.come_alive()
        live.picture.evaluate(SHOW)  # two frames: shifts have been reported
        shift = sum(page.evaluate("shifts"))
        print(f"{figure.name} at {width} px: layout shift {shift}")
        assert shift == 0
        assert live.root.evaluate(BELOW) == pytest.approx(below, abs=1)  # px: as a page scrolls
        assert not watch.errors


@typical_moved
def test_the_text_alternative_follows(figure, alone):
    """The picture's label and the sentence that is read aloud, after a key press."""
    with alone(figure) as live:
        before = live.alternative()
        assert before.startswith(figure.title)
        assert live.root.locator(".rk-says").text_content() == ""  # silent until touched
        first = own_controls(figure)[0]
        last = [*first.options][-1] if isinstance(first, Choice) else None
        live.press(first, "Home" if last == first.start else "End")
        changed = "([picture, before]) => picture.getAttribute('aria-label') !== before"
        label = live.picture.locator("[role=img]").element_handle()
        live.page.wait_for_function(changed, arg=[label, before])
        said = live.root.locator(".rk-says").text_content()
        assert live.root.locator(".rk-says").get_attribute("aria-live") == "polite"
        assert live.alternative() == f"{figure.title}. {said}" != before
        assert "{" not in said
        for name, text in live.readouts().items():
            assert text in said or f"{{{name}}}" not in figure.sentence


@typical_moved
def test_everything_is_reached_by_tab_and_seen(figure, alone):
    """Each control in turn, with a ring of 3 px round it that stands out."""
    rings = []
    with alone(figure) as live:
        live.root.evaluate("(e) => { e.tabIndex = -1; e.focus(); e.removeAttribute('tabindex'); }")
        live.root.evaluate(
            "(e) => e.querySelectorAll('details').forEach((d) => { d.open = true; })"
        )
        reached = live.root.locator("button, input, select, summary, [tabindex]")
        # steps are for fingers; of a row of buttons the keys reach the chosen one
        reached = reached.and_(live.page.locator(":not(.rk-step, [type=radio]:not(:checked))"))
        parts = reached.filter(visible=True).count()
        controls = live.root.locator(".rk-controls :is(.rk-control, .rk-turning)")
        shown = controls.filter(visible=True).count()
        assert parts >= shown + live.handles.filter(visible=True).count()
        for _ in range(parts):
            live.page.keyboard.press("Tab")
            rings.append(live.page.evaluate(RING))
    assert len({ring.pop("which") for ring in rings}) == parts
    for ring in rings:
        assert ring == {"inside": figure.name, "style": "solid", "width": "3px", "named": True}


RING = """() => {
  const element = document.activeElement, style = getComputedStyle(element);
  const figure = element.closest(".rk-figure");
  return {
    which: [...figure.querySelectorAll("*")].indexOf(element),
    inside: figure.id,
    style: style.outlineStyle,
    width: style.outlineWidth,
    named: Boolean(element.ariaLabel || element.textContent || element.labels?.[0].textContent),
  };
}"""


PAINT = """(svg, which) => [...svg.querySelectorAll(which)].flatMap((element) => {
  const { stroke, fill } = getComputedStyle(element);
  return [stroke, fill];
})"""


def rgb(color):
    """As a browser tells a colour."""
    return f"rgb({', '.join(str(int(color[i : i + 2], 16)) for i in (1, 3, 5))})"


# at the start: an arrow of no length, and a word that lies on a thing, on which it is dark
UNSEEN = {"trolley": "velocity", "dark-room": "text"}


@typical_figure
def test_every_kind_has_its_colour(figure, alone):
    """On light and dark pages; a shape whose place is no number is not there."""
    numbers = figure.compute([point(figure, {})])[0]
    there = [np.isfinite(numbers[each["at"]]).all() for each in figure.compiled["shapes"]]
    with alone(figure) as live:
        for theme, other in (("light", "dark"), ("dark", "light")):
            live.page.evaluate(
                "(theme) => { document.documentElement.dataset.theme = theme; }", theme
            )
            painted = set(live.picture.evaluate(PAINT, "*"))
            # on a thing, which is light on dark pages too, words are dark on both
            but_words = set(live.picture.evaluate(PAINT, ":not(text, tspan)"))
            kinds = {kind_of(figure, s) for s in compress(figure.shapes, there)}
            for kind in kinds - {None, UNSEEN.get(figure.name)}:
                assert rgb(getattr(KINDS[kind], theme)) in painted, kind
                assert rgb(getattr(KINDS[kind], other)) not in but_words, kind
