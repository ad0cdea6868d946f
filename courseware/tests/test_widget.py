"""A figure as a notebook has it: its module, given a model as JupyterLab gives one."""

import json
from contextlib import contextmanager

import numpy as np
import pytest
from browser import watched_page
from declared import FIGURES

pytest_plugins = ["browser"]

MODEL = """async ([module, state]) => {
  const listeners = [], url = URL.createObjectURL(new Blob([module], { type: "text/javascript" }));
  window.model = {
    state, saved: 0,
    get: () => model.state,
    set: (_, value) => { model.state = value; },
    save_changes: () => { model.saved += 1; },
    on: (event, listener) => listeners.push(listener),
    off: () => {},
    fromPython: (values) => {
      model.state = { ...model.state, ...values };
      listeners.forEach((listener) => listener());
    },
  };
  const el = document.body.appendChild(document.createElement("div"));
  const { default: widget } = await import(url);
  widget.render({ model, el });
}"""


@pytest.fixture
def shown(chromium):
    """Show a figure's widget on an empty page, as JupyterLab does."""

    @contextmanager
    def opened(name):
        widget = FIGURES[name].widget
        state = json.loads(json.dumps(widget.state))
        with watched_page(chromium, "about:blank") as (page, watch):
            page.evaluate(MODEL, [widget.get_state()["_esm"], state])
            yield page
            assert not watch.errors

    return opened


@pytest.mark.browser
def test_a_widget_and_python_follow_each_other(shown):
    with shown("wheel-speeds") as page:
        speed = page.locator("dl > div", has_text="speed v").locator("dd")
        assert speed.text_content() == "0.075 m/s"
        page.locator("input[type=range]").first.press("End")
        assert page.evaluate("model.saved") > 0
        assert page.evaluate("model.state.v_L") == pytest.approx(0.12)
        page.evaluate("model.fromPython({ v_L: -0.1, v_R: 0.0998 })")  # a zero has no sign
        page.wait_for_function("(dd) => dd.textContent === '0.000 m/s'", arg=speed.element_handle())


@pytest.mark.browser
def test_an_angle_is_in_degrees_to_the_hand_and_in_radians_to_python(shown):
    with shown("world") as page:
        slider = page.locator("input[type=range]").first
        page.evaluate("model.fromPython({ theta: Math.PI / 2 })")
        page.wait_for_function("(input) => input.value === '90'", arg=slider.element_handle())
        slider.press("ArrowRight")
        assert page.evaluate("model.state.theta") == pytest.approx(np.radians(91))
