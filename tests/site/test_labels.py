"""What a figure draws: no text on another or outside its picture, nothing of former settings.

Of every figure of the course at 10 settings as wide as on a page and at 10 others as on a phone;
at 200 in the long run.
"""

import pytest
from declared import FIGURES, each
from figure_numbers import random_states
from figure_page import alone_together

from courseware.figures import Figure

pytest_plugins = ["browser"]

FAULTS = """([name, states]) => {
  const live = document.getElementById(name).courseware, found = new Set();
  for (const state of states) {
    live.set(state);
    live.settled();
    const outer = live.picture.getBoundingClientRect();
    const texts = [...live.drawing.querySelectorAll("text")]
      .map((text) => ({ words: text.textContent, box: text.getBoundingClientRect() }));
    texts.forEach(({ words, box: a }, i) => {
      if (a.left < outer.left || a.right > outer.right || a.top < outer.top
        || a.bottom > outer.bottom) found.add(`${words} leaves at ${state}`);
      for (const { words: other, box: b } of texts.slice(i + 1)) {
        if (a.left < b.right && b.left < a.right && a.top + 2 < b.bottom && b.top + 2 < a.bottom) {
          found.add(`${words} and ${other} at ${state}`);
        }
      }
    });
  }
  return [...found];
}"""


@pytest.fixture(scope="module", params=[1280, 390])
def alive(request, chromium):
    """All figures on a page of that width."""
    with alone_together(chromium, FIGURES.values(), request.param) as opened:
        yield opened


# settings whose picture is not the one that is drawn anew: only what has changed is touched
ANEW = """([name, states]) => {
  const live = document.getElementById(name).courseware, template = live.drawing.cloneNode(false);
  return states.filter((state) => {
    live.set(state);
    live.settled();
    template.innerHTML = courseware.renderNodes(live.nodes);
    return template.innerHTML !== live.drawing.innerHTML;
  });
}"""


# where two texts meet by some pixels at so many of ten settings, on a page without our fonts
CROWDED = {"hero": 2, "two-readings": 2, "spokes": 1, "arm-joints": 1, "areas": 1, "balance": 1}
CROWDED |= {"arm-line": 1, "wheel-laboratory": 3}  # what is anywhere, and a number of the scale


@pytest.mark.browser
@pytest.mark.parametrize("count", [10, pytest.param(200, marks=pytest.mark.slow)])
@each("figure", "figures", Figure)
def test_what_is_drawn(figure, count, alive):
    page, watch = alive
    states = random_states(figure, count, [page.viewport_size["width"], len(figure.name)])
    crowded = page.evaluate(FAULTS, [figure.name, states])
    assert len(crowded) <= CROWDED.get(figure.name, 0) * count / 10, crowded
    assert page.evaluate(ANEW, [figure.name, states[:10]]) == []
    assert not watch.errors
