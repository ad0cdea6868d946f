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

const FEW = 4; // options that are a row of buttons; more are a list

const renderChoice = (control, i, title) => {
  const render = (start, end, chosen) => control.options.map(({ label }, k) =>
    `<${start} value="${k}"${k === control.start ? ` ${chosen}` : ""}>${escapeHtml(label)}</${end}>`).join("");
  if (control.options.length > FEW) {
    return `<label class="rk-control">${renderName(control)}`
      + `<select data-i="${i}" autocomplete="off">${render("option", "option", "selected")}</select></label>`;
  }
  const radio = `label><input type="radio" name="${escapeHtml(title)} ${i}" data-i="${i}" autocomplete="off"`;
  return `<div class="rk-control rk-options" role="radiogroup" aria-label="${escapeHtml(control.label)}">`
    + `${renderName(control)}${render(radio, "label", "checked")}</div>`;
};

const renderButton = (kind, words, title, data = "") =>
  `<button type="button" class="rk-${kind}" aria-label="${words}: ${escapeHtml(title)}"${data}>${words}</button>`;

// For a finger, which cannot stop at each place of a slider; keys move the slider itself.
const renderStep = (control, i, sign, words) => `<button type="button" class="rk-step" tabindex="-1" `
  + `data-i="${i}" data-sign="${sign}1" aria-label="${words}: ${escapeHtml(control.label)}">${sign === "-" ? "−" : "+"}</button>`;

// The room of the widest of some texts: a name beside them must not wrap while a slider moves.
const keepRoom = (texts) => ` data-widest="${escapeHtml(texts.reduce((one, other) => (other.length > one.length ? other : one)))}"`;

const renderSlider = (control, i, title) => {
  const isClock = control.type === "clock", play = isClock ? renderButton("play", "Play", title, ` data-i="${i}"`) : "";
  const shown = formatControl(control, control.start);
  const room = keepRoom([control.low, control.high].map((end) => formatControl(control, end)));
  return `<div class="rk-control${isClock ? " rk-clock" : ""}"${renderAttributes(symbolData(control))}>${play}${renderStep(control, i, "-", "Less")}<label>${renderName(control)}`
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

// Of several the next one is seen, with its number.
const renderGoals = ({ goals }) => goals.length ? `<div class="rk-goals">${goals.map(({ words }, k) =>
  `<p class="rk-goal">${goals.length > 1 ? `<b>${k + 1}/${goals.length}</b> ` : ""}${renderSymbols(words)} <output></output></p>`)
  .join("")}</div>` : "";

// On the picture's edge are the goal of a step, the clock and the way back; beside it, all else.
export const renderFigure = (figure) => {
  const { controls, title, size, viewAngles, readouts, buttons } = figure, isStep = size === "step";
  const [left, right, low, high] = figure.view, shape = (right - left) / (high - low);
  const { values } = compute(figure, settings(figure, startState(figure)));
  const renderControl = (control, i) => ({ choice: renderChoice, turns: renderTurns }[control.type] ?? renderSlider)(control, i, title)
    .replace(" ", values[control.shown] === 0 ? " hidden " : " ");
  const render = (isMeant) => controls.map((control, i) => isMeant(control, i) ? renderControl(control, i) : "").join("");
  const isClock = ({ type }) => type === "clock", turnsView = (_, i) => viewAngles?.includes(i);
  const picture = `<div class="rk-picture" style="--shape:${shape.toFixed(3)}">${isStep ? renderGoals(figure) : ""}`
    + `${renderPicture(figure)}${render(isClock)}${controls.length ? renderButton("reset", "Reset", title) : ""}</div>`;
  if (!controls.length) return picture;
  const part = (tag, name, inside) => inside && `<${tag} class="rk-${name}">${inside}</${tag}>`;
  const pressed = buttons.map(({ label }) => renderButton("move", escapeHtml(label), title)).join("");
  const view = viewAngles ? `<summary>Turn the view with sliders</summary><div class="rk-controls">${render(turnsView)}</div>` : "";
  return picture + part("div", "panel", (isStep ? "" : renderGoals(figure))
    + part("div", "controls", render((...of) => !isClock(...of) && !turnsView(...of)))
    + part("dl", "readouts", readouts.map((r, k) => renderReadout(r, values[k])).join(""))
    + part("div", "buttons", pressed) + part("details", "view", view)) + `<p class="rk-says" aria-live="polite"></p>`;
};
