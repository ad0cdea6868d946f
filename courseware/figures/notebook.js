// In a notebook: the state of the widget is the settings in SI units, by name.

const toValues = (figure, state) => Object.fromEntries(figure.controls.map((control, i) =>
  [control.key, control.type === "choice" ? control.options[state[i]].label
    : control.type === "turns" ? state[i][0] : state[i] * control.factor]));

const fromValues = (figure, values) => figure.controls.map((control) => {
  if (!(control.key in values)) return control.start;
  const value = values[control.key];
  if (control.type === "turns") return [pressesOf(value).join(""), 1];
  return control.type === "choice" ? optionOf(control, value) : clamp(control, value / control.factor);
});

const inNotebook = (figure, { model, el }) => {
  el.classList.add("rk-figure");
  el.innerHTML = html(figure);
  el.dataset.size = figure.size;
  el.role = "group";
  el.ariaLabel = figure.title;
  el.querySelector(".rk-link")?.remove();
  const live = new Live(el, figure, (state) => {
    model.set("state", toValues(figure, state));
    model.save_changes();
  }).start();
  const follow = () => live.set(fromValues(figure, model.get("state")), true);
  follow();
  model.on("change:state", follow);
  return () => model.off("change:state", follow);
};

Object.assign(part, { inNotebook });
