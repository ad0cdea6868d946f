// In a notebook: the state of the widget is the settings in SI units, by name.

import { renderFigure } from "./controls.js";
import { LiveFigure } from "./live_figure.js";
import { parsePresses } from "./quarter_turns.js";
import { clamp, indexOfOption } from "./state.js";

const valuesOf = (figure, state) => Object.fromEntries(figure.controls.map((control, i) =>
  [control.key, control.type === "choice" ? control.options[state[i]].label
    : control.type === "turns" ? state[i][0] : state[i] * control.factor]));

const stateOf = (figure, values) => figure.controls.map((control) => {
  if (!(control.key in values)) return control.start;
  const value = values[control.key];
  if (control.type === "turns") return [parsePresses(value).join(""), 1];
  return control.type === "choice" ? indexOfOption(control, value) : clamp(control, value / control.factor);
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
