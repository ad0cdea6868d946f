"""A figure as a notebook has it: its module, given a model as JupyterLab gives one."""

import pytest
from browser import watched_page
from declared import FIGURES
from playwright.sync_api import expect

from courseware.practice import exercise

pytest_plugins = ["browser"]

MODEL = """async ([module, state]) => {
  const url = URL.createObjectURL(new Blob([module], { type: "text/javascript" }));
  window.model = {
    state, saved: 0,
    get: () => model.state,
    set: (_, value) => { model.state = value; },
    save_changes: () => { model.saved += 1; },
    on() {}, off() {},
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
        page.evaluate(MODEL, [FIGURES["wheel-speeds"].widget.get_state()["_esm"], {}])
        speed = page.locator("dl > div", has_text="speed v").locator("dd")
        assert speed.text_content() == "0.075 m/s"
        slider = page.get_by_label("left wheel v").and_(page.locator("input"))
        slider.press("End")
        assert page.evaluate("model.saved") > 0
        page.evaluate("show()")
        page.wait_for_function("(dd) => dd.textContent === '0.110 m/s'", arg=speed.element_handle())
        assert slider.input_value() == "0.12"
        assert not watch.errors


@pytest.mark.browser
def test_an_answer_that_is_typed_stays_when_its_box_is_shown_anew(chromium):
    """Also when the page is loaded again: the kernel has the state."""
    with watched_page(chromium, "about:blank") as (page, watch):
        state = exercise("differential-drive-1", student="Ada").widget.get_state()
        page.evaluate(MODEL, [state["_esm"], state["state"]])
        field = page.locator(".rk-live .rk-row input")
        field.press_sequentially("0.1234")
        page.evaluate("show()")
        expect(field).to_have_value("0.1234")
        assert not watch.errors


WIDGETS = {
    "figure": (FIGURES["wheel-speeds"], "input[type=range]"),
    "exercise": (exercise("differential-drive-1", student="Ada"), ".rk-live .rk-help"),
}


@pytest.mark.browser
@pytest.mark.parametrize(("shown", "inside"), WIDGETS.values(), ids=WIDGETS)
def test_keys_stay_in_a_widget(chromium, shown, inside):
    """Else JupyterLab would move to the next cell, and cut or add one."""
    with watched_page(chromium, "about:blank") as (page, watch):
        state = shown.widget.get_state()
        page.evaluate(MODEL, [state["_esm"], state["state"]])
        page.locator(inside).first.wait_for()
        page.evaluate(
            "() => addEventListener('keydown', ({ key }) => (window.keys ??= []).push(key))"
        )
        for key in ("ArrowDown", "b", "x"):
            page.locator(inside).first.press(key)
        assert page.evaluate("window.keys ?? []") == []
        page.keyboard.press("Tab")
        page.evaluate("() => document.activeElement.blur()")
        page.keyboard.press("b")
        assert page.evaluate("window.keys") == ["b"]
        assert not watch.errors
