// The whole figure as HTML: the same text on the page before and after the script takes over.

import { escapeHtml, renderSymbols } from "../units/text.js";
import { formatControl, formatReadout } from "./figure_text.js";
import { renderAttributes } from "./nodes.js";
import { renderTurns } from "./quarter_turns.js";
import { renderPicture } from "./scene.js";
import { compute, settings, startState } from "./state.js";
import { stroke, symbolData } from "./svg.js";

const renderName = ({ kind, label: words }) => {
  const swatch = kind ? `<svg class="rk-swatch" width="26" height="8" aria-hidden="true">`
    + `<path d="M0 4H26" style="${stroke(kind)}"/></svg>` : "";
  const name = renderSymbols(words).replace(/(^|[^\d] )(Δ?\p{L})$/u, "$1<i>$2</i>"); // a letter at the end, no unit
  return `<span class="rk-name">${swatch}${name}</span>`;
};

const renderChoice = (control, i) => {
  const options = control.options.map((option, k) =>
    `<option value="${k}"${k === control.start ? " selected" : ""}>${escapeHtml(option.label)}</option>`);
  return `<label class="rk-control">${renderName(control)}`
    + `<select data-i="${i}" autocomplete="off">${options.join("")}</select></label>`;
};

const renderButton = (kind, words, title, data = "") =>
  `<button type="button" class="rk-${kind}" aria-label="${words}: ${escapeHtml(title)}"${data}>${words}</button>`;

// For a finger, which cannot stop at each place of a slider; keys move the slider itself.
const renderStep = (control, i, sign, words) => `<button type="button" class="rk-step" tabindex="-1" `
  + `data-i="${i}" data-sign="${sign}1" aria-label="${words}: ${escapeHtml(control.label)}">${sign === "-" ? "−" : "+"}</button>`;

// The room of the widest of some texts: a name beside them must not wrap while a slider moves.
const keepRoom = (texts) => ` data-widest="${escapeHtml(texts.reduce((one, other) => (other.length > one.length ? other : one)))}"`;

const renderSlider = (control, i, title) => {
  const play = control.type === "clock" ? renderButton("play", "Play", title, ` data-i="${i}"`) : "";
  const shown = formatControl(control, control.start);
  const room = keepRoom([control.low, control.high].map((end) => formatControl(control, end)));
  return `<div class="rk-control"${renderAttributes(symbolData(control))}>${play}${renderStep(control, i, "-", "Less")}<label>${renderName(control)}`
    + `<span class="rk-value" data-o="${i}"${room} aria-hidden="true">${shown}</span>`
    + `<input type="range" data-i="${i}" autocomplete="off" min="${control.low}" max="${control.high}" `
    + `step="${control.step}" value="${control.start}" aria-valuetext="${shown}"></label>${renderStep(control, i, "+", "More")}</div>`;
};

// A number may get a sign, or a word in its place.
const renderReadout = (readout, value) => {
  const shown = formatReadout(readout, value), signed = `−${shown.replace("−", "")}`;
  return `<div${renderAttributes(symbolData(readout))}><dt>${renderName(readout)}</dt>`
    + `<dd${keepRoom([signed, ...Object.values(readout.words)])}>${escapeHtml(shown)}</dd></div>`;
};

const renderGoal = ({ words }) => `<p class="rk-goal">${renderSymbols(words)} <output></output></p>`;

export const renderFigure = (figure) => {
  const { values } = compute(figure, settings(figure, startState(figure)));
  const [left, right, low, high] = figure.view, shape = (right - left) / (high - low);
  const picture = `<div class="rk-picture" style="--shape:${shape.toFixed(3)}">${renderPicture(figure)}</div>`;
  if (!figure.controls.length) return picture;
  const turns = (_, i) => figure.viewAngles?.includes(i);
  const parts = figure.controls.map((control, i) =>
    ({ choice: renderChoice, turns: renderTurns }[control.type] ?? renderSlider)(control, i, figure.title));
  const aside = parts.filter(turns).join("");
  const view = aside && `<details class="rk-view"><summary>Turn the view with sliders</summary>`
    + `<div class="rk-controls">${aside}</div></details>`;
  return `${picture}<div class="rk-panel">${figure.goals.map(renderGoal).join("")}`
    + `<div class="rk-controls">${parts.filter((...of) => !turns(...of)).join("")}</div>`
    + `<dl class="rk-readouts">${figure.readouts.map((r, k) => renderReadout(r, values[k])).join("")}</dl>`
    + `<div class="rk-buttons">${figure.buttons.map(({ label }) => renderButton("move", escapeHtml(label), figure.title)).join("")}`
    + `${renderButton("reset", "Reset", figure.title)}`
    + `${figure.size === "step" ? "" : renderButton("link", "Link to this setting", figure.title)}</div>${view}</div>`
    + `<p class="rk-says" aria-live="polite"></p>`;
};
