"""What is written in the figures: no text on another, and none outside its picture.

At 20 settings of every figure of the course, as wide as on a page and as on a phone; at 200 in the
long run.
"""

import json

import numpy as np
import pytest
from browser import watched_page
from declared import FIGURES
from test_hands import shown

from workshop.script import runtime

pytest_plugins = ["browser"]

FAULTS = """([name, states]) => {
  const live = document.getElementById(name).workshop, found = new Set();
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


@pytest.mark.browser
@pytest.mark.parametrize("count", [20, pytest.param(200, marks=pytest.mark.slow)])
@pytest.mark.parametrize("width", [1280, 390])
def test_no_text_lies_on_another_or_outside(chromium, width, count):
    random = np.random.default_rng(11)
    body = "".join(figure.on_page() for figure in FIGURES.values())
    style = f"{runtime.stylesheet()} body {{ max-width: 46rem; margin: 1rem; }}"
    with watched_page(chromium, "about:blank", width) as (page, watch):
        page.emulate_media(reduced_motion="reduce")
        page.set_content(f"<style>{style}</style>{body}")
        alive = [f"workshop.figures.bringToPage({figure.code});" for figure in FIGURES.values()]
        page.add_script_tag(content="\n".join([*map(runtime.script, runtime.parts()), *alive]))
        found = {}
        for name, figure in FIGURES.items():
            states = [shown(figure, random) for _ in range(count)]
            found[name] = page.evaluate(FAULTS, [name, json.loads(json.dumps(states))])
        assert not watch.errors
    for name, faults in found.items():
        print(name, len(faults), faults[:2])
    assert not any(found.values())
