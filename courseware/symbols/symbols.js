// Hover, tap or focus of a symbol lights all its faces within the step, and a note names it.

import { escapeHtml, renderSymbols, trueMinus, writeText } from "../units/text.js";

// A step is a section without the sections in it.
const SYMBOL = "[data-symbol]";
const FORMULA = ".math-scroll";
const WITHIN = "> :not(section)";
let note;
let rule;
let lit = null; // lit: { face, key, step, by }

// The number of the figure that the face is in or follows, or else of the first in the step that has it.
const findNumber = ({ face, step, key }) => [face.closest(".rk-figure"), document.getElementById(face.dataset.of),
  ...step.querySelectorAll(`:scope ${WITHIN} .rk-figure`)].map((figure) => figure?.courseware?.numbers()[key]?.text).find(Boolean);

// A number of a formula: as the figure shows it, without its unit unless it is the result.
export const formatSlot = ({ value, text }, { result, radians, guarded }) => {
  const plain = text.replace(/^([−\d]\S*) .*/, "$1");
  const shown = result ? text : radians ? trueMinus(value.toFixed(3)) : plain;
  return guarded && shown[0] === "−" ? `(${shown})` : shown;
};

const slots = {}; // of each figure
const fillSlots = ({ name, numbers }) => {
  slots[name] ??= document.querySelectorAll(`[data-of="${name}"]`);
  slots[name].forEach((slot) => {
    const text = formatSlot(numbers[slot.dataset.symbol], slot.dataset), room = slot.closest(".rk-slot");
    writeText(slot, text);
    if (!room || text.length <= (room.longest ?? 0)) return;
    room.longest = text.length;
    room.style.minWidth = `${room.getBoundingClientRect().width}px`;
  });
};

// On a phone the formula is below the screen while a hand moves its figure: it comes in sight until the
// page is scrolled, at that end where the hand is not, nor the picture if there is room.
const unpin = () => document.querySelector(".rk-pinned")?.classList.remove("rk-pinned");
const pinNumbers = (figure, { name }) => {
  const hand = figure.courseware?.held?.by ?? (figure.contains(document.activeElement) && document.activeElement);
  if (!hand || !matchMedia("(max-width: 600px)").matches) return;
  const numbers = [...document.querySelectorAll(`.rk-numbers:has([data-of="${name}"])`)].find((each) => each.getClientRects().length);
  if (!numbers || numbers.matches(".rk-pinned") || numbers.getBoundingClientRect().bottom < innerHeight) return;
  unpin();
  numbers.classList.add("rk-pinned");
  const boxes = [hand, figure.querySelector(".rk-picture")].map((each) => each.getBoundingClientRect());
  const [low, under] = boxes.map(({ bottom }) => bottom > innerHeight - numbers.offsetHeight);
  const isLow = low || under && boxes.every(({ top }) => top > numbers.offsetHeight);
  numbers.style.inset = isLow ? "var(--rk-top, 0) 0 auto" : "";
  addEventListener("scroll", unpin, { once: true });
};

const markNames = () => {
  const known = new Map(Object.entries(coursewareSymbols).map(([symbol, [, , , look, code]]) =>
    [code, look ? { symbol, look } : { symbol }]));
  for (const name of document.querySelectorAll(".highlight .n")) {
    Object.assign(name.dataset, known.get(name.textContent));
  }
};

const writeNote = () => {
  const [letter, meaning, unit, kind] = coursewareSymbols[lit.key], number = findNumber(lit);
  note.innerHTML = `<b data-look="${kind}">${renderSymbols(letter)}</b> ${renderSymbols(meaning)}`
    + (number ? `: <span>${escapeHtml(number)}</span>` : unit ? ` (${escapeHtml(unit)})` : "");
};

const placeNote = () => {
  const { left } = lit.face.getBoundingClientRect(), gap = 8;
  const { top, bottom } = (lit.face.closest(FORMULA) ?? lit.face).getBoundingClientRect();
  const most = document.documentElement.clientWidth - note.offsetWidth - gap;
  const above = lit.face.closest(".rk-numbers") ? 0 : top - note.offsetHeight - gap;
  note.style.left = `${Math.max(gap, Math.min(left, most)) + scrollX}px`;
  note.style.top = `${(above > 60 ? above : bottom + gap) + scrollY}px`; // 60: the head of the page
};

const clearHighlight = () => {
  lit?.step.classList.remove("rk-here");
  lit = null;
  note.hidden = true;
  rule.textContent = "";
};

const highlight = (face, by) => {
  const key = face.dataset.symbol, step = face.closest("section");
  if (!(key in coursewareSymbols) || !step) return;
  clearHighlight();
  lit = { face, key, step, by };
  step.classList.add("rk-here");
  const here = `.rk-here ${WITHIN}`, all = `[data-symbol="${key}"]`;
  rule.textContent = `${here} ${all} { background: var(--rk-lit); border-radius: 3px; }`
    + `@media (forced-colors: active) { ${here} ${all} { outline: 2px solid Highlight; } }`
    + `${here} svg ${all} { filter: var(--rk-glow); }`;
  note.hidden = false;
  note.ariaLive = "polite";
  writeNote();
  placeNote();
};

export const startSymbols = () => {
  if (!globalThis.coursewareSymbols) return;
  markNames();
  document.body.insertAdjacentHTML("beforeend", `<div class="rk-named" role="status" hidden></div>`);
  note = document.body.lastElementChild;
  rule = document.head.appendChild(document.createElement("style"));
  const faceOf = (event) => event.target.closest?.(SYMBOL);
  addEventListener("pointerover", (event) => {
    if (event.pointerType !== "mouse" || event.buttons) return;
    const face = faceOf(event);
    if (face) highlight(face, "hover"); else if (lit?.by === "hover") clearHighlight();
  });
  addEventListener("click", (event) => {
    if (event.target.closest?.("input, select, button")) return;
    const face = faceOf(event);
    const again = lit?.by === "tap" && lit.face === face;
    if (face && !again) highlight(face, "tap"); else if (lit) clearHighlight();
  });
  addEventListener("focusin", (event) => {
    const face = faceOf(event);
    if (face && event.target.matches(":focus-visible")) highlight(face, "focus");
    else if (lit?.by === "focus") clearHighlight();
  });
  addEventListener("focusout", () => { if (lit?.by === "focus") clearHighlight(); });
  addEventListener("keydown", (event) => {
    if (event.key === "Escape" && lit) clearHighlight();
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!way || !event.target.matches?.(FORMULA)) return;
    const faces = [...event.target.querySelectorAll(SYMBOL)], at = faces.indexOf(lit?.face);
    if (!faces.length) return;
    event.preventDefault();
    const next = faces[at < 0 ? 0 : (at + way + faces.length) % faces.length];
    next.scrollIntoView({ block: "nearest", inline: "nearest" });
    highlight(next, "focus");
  });
  for (const { id, courseware: live } of document.querySelectorAll(".rk-figure")) {
    if (live) fillSlots({ name: id, numbers: live.numbers() });
  }
  addEventListener("courseware:drawn", ({ target, detail }) => {
    fillSlots(detail);
    pinNumbers(target, detail);
    if (!lit?.step.contains(target)) return;
    note.ariaLive = "off"; // what moves is not told again and again
    writeNote();
  });
};
