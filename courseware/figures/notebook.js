// In a notebook: the state stays with the widget, which may be shown anew.

import { renderFigure } from "./controls.js";
import { LiveFigure } from "./live_figure.js";

export const showFigure = (figure, { model, el }) => {
  el.classList.add("rk-figure");
  el.innerHTML = renderFigure(figure);
  el.dataset.size = figure.size;
  el.role = "group";
  el.ariaLabel = figure.title;
  const live = new LiveFigure(el, figure, (shown) => {
    model.set("state", { shown });
    model.save_changes();
  }).start();
  const { shown } = model.get("state");
  if (shown) live.set(shown);
};
