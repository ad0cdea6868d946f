// A prediction takes a guess, keeps it in this browser, and only then opens its result.
//
// data: { kind: "buttons" | "number" | "ghost", right, wrong, … }, made by prediction.py. A guess
// is the number of an option, or a list of numbers in the units that the reader sees; "shown"
// where somebody wants to see without guessing. A figure may wait for the answer.

import { prefersReducedMotion } from "../figures/clock.js";
import { STORE } from "../answers/constants.js";
import { describeProblem } from "../answers/judging.js";
import { parseTyped } from "../answers/parsing.js";
import { memory, readStored } from "../answers/storage.js";
import { escapeHtml, formatNumber, renderSymbols, withUnit } from "../units/text.js";

const SHOWN = "shown";
const TRIES = 3; // to place a ghost, before there is more help
const GUESSES_KEY = `${STORE} guesses`;
const GUESSES_NOT_KEPT = "This browser keeps nothing for this page: your guesses are forgotten when you leave it.";
const GUESSES_KEPT = "Your guesses stay in this browser; nothing is sent.";

const renderOptions = (options) => options.length
  ? `<ul class="rk-plain">${options.map((option) => `<li>${renderSymbols(option)}</li>`).join("")}</ul>` : "";

export const renderForm = ({ kind, options, units }) => `<form class="rk-guess">${
  kind === "buttons" ? options.map((option, k) =>
    `<button type="button" value="${k}" aria-pressed="false">${renderSymbols(option)}</button>`).join("")
  : kind === "ghost" ? `<span>Put your guess where you think it belongs, then:</span> `
    + `<button type="submit">Here</button>`
  : `<label>Your guess <input type="text" autocomplete="off" autocapitalize="off" spellcheck="false">`
    + `${units[0] ? ` ${escapeHtml(units[0])}` : ""}</label> <button type="submit">That is my guess</button>`
}<button type="button" class="rk-skip">Show me</button></form>${renderOptions(options ?? [])}`
  + `<p class="rk-said" role="status" tabindex="-1"></p>`;

const describeGuess = ({ kind, options, labels, units }, guess) => kind === "buttons" ? options[guess]
  : guess.map((x, i) => `${labels[i]} ${withUnit(formatNumber(x, 3), units[i])}`.trim()).join(", ");

// By how much numbers are off; the direction of a ghost goes round.
const offsets = ({ kind, units }, guess, other) => guess.map((x, i) => {
  const off = x - other[i];
  return kind === "ghost" && units[i] === "°" ? off - 360 * Math.round(off / 360) : off;
});

// Whether a guess is what somebody else says.
export const isSameGuess = (data, guess, other) => data.kind === "buttons" ? guess === other
  : offsets(data, guess, other).every((off) => Math.abs(off) <= data.near);

// How a ghost is off: "too far to the left", or with its size "12 cm too far to the left, turned 15° too far to the right".
export const describeMiss = ({ near, ways, units }, offs, sized) => offs.flatMap((off, i) => {
  if (Math.abs(off) <= near) return [];
  const [before, more, less] = ways[i], inCm = units[i] === "m" && near < 1;
  const size = withUnit(formatNumber(Math.abs(off) * (inCm ? 100 : 1), 2), inCm ? "cm" : units[i]);
  return [`${before}${sized ? `${size} ` : ""}${off > 0 ? more : less}`];
}).join(", ");

const storeGuesses = (guesses) => memory.set(GUESSES_KEY, JSON.stringify(guesses));

// One line for the whole page, at the guess that was made last.
const createForgetLine = (boxes) => {
  const line = document.createElement("p");
  line.className = "rk-forget";
  line.innerHTML = `<span></span> <button type="button">Forget my guesses</button>`;
  line.lastChild.addEventListener("click", () => {
    storeGuesses({});
    const [last] = boxes.filter((box) => box.card.contains(line));
    boxes.forEach((box) => box.reset());
    line.remove();
    last?.one("button, input").focus();
  });
  return (box, kept) => {
    line.firstChild.textContent = kept ? GUESSES_KEPT : GUESSES_NOT_KEPT;
    box.card.append(line);
  };
};

class PredictionBox {
  constructor(element) {
    Object.assign(this, { element, name: element.id, data: JSON.parse(element.dataset.prediction) });
    this.figure = document.getElementById(this.data.figure);
    this.card = element.querySelector(".rk-card") ?? this.figure.querySelector(".rk-card"); // of a page that was saved
    this.fold = element.querySelector(".rk-opens");
    this.one("form").addEventListener("submit", (event) => {
      event.preventDefault();
      this.guess();
    });
    const field = this.one("input"), typed = `${this.name} typed`;
    if (field) field.value = readStored(GUESSES_KEY)[typed] ?? "";
    field?.addEventListener("input", () => storeGuesses({ ...readStored(GUESSES_KEY), [typed]: field.value }));
    this.buttons = [...this.card.querySelectorAll(".rk-guess button[value]")];
    this.buttons.forEach((button, k) => button.addEventListener("click", () => this.take(k)));
    this.one(".rk-skip").addEventListener("click", () => this.showMe());
  }

  one(selector) { return this.card.querySelector(selector); }

  // Work with the figure once it can be moved.
  withFigure(work) {
    const { figure } = this;
    if (figure?.courseware) work(figure.courseware);
    else figure?.addEventListener("courseware:drawn", () => setTimeout(() => work(figure.courseware)), { once: true });
  }

  showMe() {
    this.take(this.tried ?? SHOWN);
    this.one(".rk-said").focus(); // the button is gone
  }

  guess() {
    if (this.answered) return;
    const { kind, places, units } = this.data;
    if (kind === "ghost") return this.withFigure(({ state, figure }) => places.every((i) => state[i] === figure.controls[i].start)
      ? this.say("Move your guess first.") : this.place(places.map((i) => state[i])));
    const unknowns = [{ unit: units[0] }], readings = parseTyped(this.one("input").value, unknowns), [first] = readings;
    const found = readings.find(({ value }) => typeof value === "number");
    if (found) return this.take([found.value]);
    this.say(first.problem ? describeProblem(first, unknowns) : "Type one number.");
  }

  // A ghost may be placed until it is right: first a direction helps, then sizes, and each try is compared with the last one.
  place(guess) {
    const { data } = this, offs = offsets(data, guess, data.right), far = Math.hypot(...offs);
    if (this.answered || offs.every((off) => Math.abs(off) <= data.near)) return this.take(guess);
    const trend = this.tries < TRIES || far === this.far ? "" : far < this.far ? "Warmer: " : "Colder: ";
    Object.assign(this, { tried: guess, far, tries: this.tries + 1 });
    const helps = this.tries >= TRIES, miss = `${trend}${describeMiss(data, offs, helps)}.`;
    this.say(miss[0].toUpperCase() + miss.slice(1));
    this.sayAssumption(guess);
  }

  take(guess) {
    if (this.answered) return;
    const kept = storeGuesses({ ...readStored(GUESSES_KEY), [this.name]: guess });
    this.open(guess);
    this.play();
    this.showForgetLine(this, kept);
    const said = this.one(".rk-said");
    if (!this.card.contains(document.activeElement)) said.focus({ preventScroll: true }); // it has gone elsewhere
    said.scrollIntoView({ block: "nearest" });
  }

  // What waited for the answer moves now.
  play() {
    const button = this.data.kind !== "ghost" && this.figure?.querySelector(".rk-play");
    if (button?.textContent === "Play" && !prefersReducedMotion()) button.click();
  }

  say(words) { this.one(".rk-said").innerHTML = renderSymbols(words); }

  open(guess) {
    const { data } = this, is = describeGuess(data, data.right);
    this.show(true, guess);
    if (guess === SHOWN) return this.say(`Shown: ${is}.`);
    const right = isSameGuess(data, guess, data.right), your = describeGuess(data, guess);
    this.say(right ? `✓ You said: ${your}.${your === is ? "" : ` The answer: ${is}.`}`
      : `You said: ${your}. The answer: ${is}.`);
    if (!right) this.sayAssumption(guess);
  }

  // What a usual wrong guess assumes.
  sayAssumption(guess) {
    const wrong = this.data.wrong.findIndex((other) => isSameGuess(this.data, guess, other));
    if (wrong < 0) return;
    const why = this.fold.querySelectorAll(".rk-assumes")[wrong].cloneNode(true);
    why.innerHTML = why.innerHTML.replace(/“[^”]*”\? /, "");
    this.one(".rk-said").append(why);
  }

  reset() {
    this.say("");
    if (this.one("input")) this.one("input").value = "";
    this.show(false, null);
    if (this.data.kind !== "ghost") this.figure?.querySelector(".rk-reset")?.click();
  }

  show(answered, guess) {
    const { data, buttons, fold } = this;
    Object.assign(this, { answered, taken: guess, tries: 0, tried: null });
    this.element.classList.toggle("rk-answered", answered);
    fold.open = answered;
    buttons.forEach((button, k) => {
      button.setAttribute("aria-pressed", k === guess);
      button.setAttribute("aria-disabled", answered);
      button.classList.toggle("rk-right", answered && k === data.right);
    });
    if (!this.figure) return;
    if (answered) this.element.prepend(this.card);
    else (this.figure.querySelector(".rk-panel") ?? this.figure).prepend(this.card);
    if (data.kind !== "ghost") return this.veil();
    this.lockControls();
    this.withFigure((live) => this.lockFigure(live));
  }

  // A figure that waits is at its start.
  veil() {
    const { figure, answered } = this;
    figure.classList.toggle("rk-veiled", !answered);
    figure.querySelector(".rk-picture").inert = !answered;
    if (answered) figure.courseware?.resumeClock?.();
  }

  // While the question is open, the ghost is all that can be moved; then, all but the ghost.
  isMovable(i) {
    const { places, free } = this.data;
    return free.includes(Number(i)) || places.includes(Number(i)) !== this.answered;
  }

  lockControls() {
    const { figure, answered } = this;
    figure.querySelectorAll(".rk-readouts, .rk-buttons, .rk-reset, .rk-goals").forEach((part) => { part.inert = !answered; });
    figure.querySelectorAll("[data-i]").forEach((hand) => {
      hand.closest(".rk-control").inert = !this.isMovable(hand.dataset.i);
    });
  }

  // As the question is by then: it may have been answered while the figure came alive.
  lockFigure(live) {
    const { answered, taken } = this, { controls, handles } = live.figure, { places, then, right } = this.data;
    handles.forEach(({ sets }, k) => {
      for (const grip of [live.handles[k], live.handles[k].nextSibling]) {
        grip.style.display = sets.every((i) => this.isMovable(i)) ? "" : "none";
      }
    });
    // a reset leaves what the answer alone has set; what is close enough moves to the exact place
    controls.forEach((control, i) => { control.kept = answered && control.shown !== undefined ? then[i] : undefined; });
    const guess = answered && (taken === SHOWN || isSameGuess(this.data, taken, right)) ? right : taken;
    live.set(controls.map(({ start }, i) => !answered ? start
      : places.includes(i) ? guess[places.indexOf(i)] : then[i] ?? live.state[i]));
  }
}

// A link to what is folded away, or waits for an answer, opens it.
const revealTarget = (boxes) => {
  const aim = document.getElementById(location.hash.slice(1)), fold = aim?.closest(".rk-opens");
  const waiting = boxes.find(({ figure }) => figure && figure === aim && figure.matches(".rk-veiled"));
  waiting?.showMe();
  if (fold) {
    fold.open = true;
    fold.parentElement.classList.add("rk-answered");
  }
  if (fold || waiting) aim.scrollIntoView();
};

export const startPredictions = () => {
  const boxes = [...document.querySelectorAll(".rk-prediction")].map((element) => new PredictionBox(element));
  const showForgetLine = createForgetLine(boxes), known = readStored(GUESSES_KEY);
  boxes.forEach((box) => {
    box.showForgetLine = showForgetLine;
    if (!(box.name in known)) return box.show(false, null);
    box.open(known[box.name]);
    showForgetLine(box, true);
  });
  addEventListener("hashchange", () => revealTarget(boxes));
  revealTarget(boxes);
};
