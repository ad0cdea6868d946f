"""A figure as a notebook has it: its module, given a model as JupyterLab gives one."""

import pytest
from browser import watched_page
from declared import FIGURES

pytest_plugins = ["browser"]

MODEL = """async (module) => {
  const url = URL.createObjectURL(new Blob([module], { type: "text/javascript" }));
  window.model = {
    state: {}, saved: 0,
    get: () => model.state,
    set: (_, value) => { model.state = value; },
    save_changes: () => { model.saved += 1; },
  };
  const { default: widget } = await import(url);
  window.show = () => {
    const el = document.createElement("div");
    document.body.replaceChildren(el);
    widget.render({ model, el });
  };
  show();
}"""


@pytest.mark.browser
def test_a_widget_keeps_its_state_when_it_is_shown_anew(chromium):
    """As by a notebook that is scrolled there and back."""
    with watched_page(chromium, "about:blank") as (page, watch):
        page.evaluate(MODEL, FIGURES["wheel-speeds"].widget.get_state()["_esm"])
        speed = page.locator("dl > div", has_text="speed v").locator("dd")
        assert speed.text_content() == "0.075 m/s"
        page.locator("input[type=range]").first.press("End")
        assert page.evaluate("model.saved") > 0
        page.evaluate("show()")
        page.wait_for_function("(dd) => dd.textContent === '0.110 m/s'", arg=speed.element_handle())
        assert page.locator("input[type=range]").first.input_value() == "0.12"
        assert not watch.errors
