// The whole figure as HTML: the same text on the page before and after the script takes over.

const controlName = ({ kind, label: words }) => {
  const swatch = kind ? `<svg class="rk-swatch" width="26" height="8" aria-hidden="true">`
    + `<path d="M0 4H26" ${stroke(kind)}/></svg>` : "";
  const name = symbols(words).replace(/(^|[^\d] )(Δ?\p{L})$/u, "$1<i>$2</i>"); // a letter at the end, no unit
  return `<span class="rk-name">${swatch}${name}</span>`;
};

const choiceHtml = (control, i) => {
  const options = control.options.map((option, k) =>
    `<option value="${k}"${k === control.start ? " selected" : ""}>${escaped(option.label)}</option>`);
  return `<label class="rk-control">${controlName(control)}`
    + `<select data-i="${i}" autocomplete="off">${options.join("")}</select></label>`;
};

const buttonHtml = (kind, words, title, data = "") =>
  `<button type="button" class="rk-${kind}" aria-label="${words}: ${escaped(title)}"${data}>${words}</button>`;

const sliderHtml = (control, i, title) => {
  const play = control.type === "clock" ? buttonHtml("play", "Play", title, ` data-i="${i}"`) : "";
  const shown = shownControl(control, control.start);
  return `<div class="rk-control"${faceOf(control)}>${play}<label>${controlName(control)}`
    + `<span class="rk-value" data-o="${i}" aria-hidden="true">${shown}</span>`
    + `<input type="range" data-i="${i}" autocomplete="off" min="${control.low}" max="${control.high}" `
    + `step="${control.step}" value="${control.start}" aria-valuetext="${shown}"></label></div>`;
};

const controlHtml = (control, i, title) => ({ choice: choiceHtml, turns: turnsHtml }[control.type]
  ?? sliderHtml)(control, i, title);

const readoutHtml = (readout, value) =>
  `<div${faceOf(readout)}><dt>${controlName(readout)}</dt><dd>${escaped(shownNumber(readout, value))}</dd></div>`;

const goalHtml = ({ words }) => `<p class="rk-goal">${symbols(words)} <output></output></p>`;

const html = (figure) => {
  const { values } = compute(figure, settings(figure, startState(figure)));
  const picture = `<div class="rk-picture">${svg(figure)}</div>`;
  if (!figure.controls.length) return picture;
  const turns = (_, i) => figure.viewAngles?.includes(i), parts = figure.controls.map((control, i) => controlHtml(control, i, figure.title));
  const aside = parts.filter(turns).join("");
  const view = aside && `<details class="rk-view"><summary>Turn the view with sliders</summary>`
    + `<div class="rk-controls">${aside}</div></details>`;
  return `${picture}<div class="rk-panel">${figure.goals.map(goalHtml).join("")}`
    + `<div class="rk-controls">${parts.filter((...of) => !turns(...of)).join("")}</div>`
    + `<dl class="rk-readouts">${figure.readouts.map((r, k) => readoutHtml(r, values[k])).join("")}</dl>`
    + `<div class="rk-buttons">${buttonHtml("reset", "Reset", figure.title)}`
    + `${figure.size === "step" ? "" : buttonHtml("link", "Link to this setting", figure.title)}</div>${view}</div>`
    + `<p class="rk-says" aria-live="polite"></p>`;
};

Object.assign(part, { html });
