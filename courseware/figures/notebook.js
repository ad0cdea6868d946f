// In a notebook: the state of the widget is the settings in SI units, by name.

import { renderFigure } from "./controls.js";
import { LiveFigure } from "./live_figure.js";
import { fromValue, toText } from "./state.js";

const valuesOf = (figure, state) => Object.fromEntries(figure.controls.map((control, i) =>
  [control.key, "factor" in control ? state[i] * control.factor : toText(control, state[i])]));

const stateOf = (figure, values) => figure.controls.map((control) => {
  const value = values[control.key];
  return fromValue(control, "factor" in control ? value / control.factor : value);
});

export const showFigure = (figure, { model, el }) => {
  el.classList.add("rk-figure");
  el.innerHTML = renderFigure(figure);
  el.dataset.size = figure.size;
  el.role = "group";
  el.ariaLabel = figure.title;
  el.querySelector(".rk-link")?.remove();
  const live = new LiveFigure(el, figure, (state) => {
    model.set("state", valuesOf(figure, state));
    model.save_changes();
  }).start();
  const follow = () => live.set(stateOf(figure, model.get("state")), true);
  follow();
  model.on("change:state", follow);
  return () => model.off("change:state", follow);
};
