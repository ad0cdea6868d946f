// The box of an exercise, which takes answers and gives help.

import { escapeHtml, fillTemplate, renderSymbols } from "../units/text.js";
import { now } from "./answer_file.js";
import { VARIANTS } from "./constants.js";
import { chooseVariant } from "./variants.js";
import { judgeAnswer } from "../answers/judging.js";
import { parseTyped } from "../answers/parsing.js";
import { HELP_STEPS, renderParagraphs, renderHint, splitSolution } from "./rendering.js";

const NOT_LOADED = "Your numbers could not be loaded, so nothing can be checked.";
const TRY_FIRST = "Check an answer first, any guess will do: then the steps open one by one.";
const PICTURED = "In the numbers of the chapter; dashed or red is what the mistake makes of it.";

/**
 * An exercise in an element that holds its HTML. What is shown is what is judged: both take the
 * variant from `number`, which `show` alone sets.
 *
 * @typedef {{ name, title, steps, text, solution, prompt, topic, variants: Variant[] }} Exercise
 * @typedef {{ shown: Object<string, string>, candidates: Candidate[] }} Variant shown: texts for
 *   placeholders
 * @typedef {{ course, student(): string, load(): Promise<Exercise>, kept(), keep(entry) }} ExerciseDesk
 */
export class ExerciseBox {
  constructor(element, desk) {
    Object.assign(this, { element, desk });
    this.input = this.one("input");
    this.exercise = this.number = null; // until they are loaded and shown
    this.stale = false; // whether its numbers are another name's, until it comes near
    this.training = 0; // how many variants beyond one's own
    this.trained = {}; // what is kept of one's own numbers is not kept of these
  }

  one(selector) { return this.element.querySelector(selector); }

  start() {
    this.one("form").addEventListener("submit", (event) => { event.preventDefault(); this.check(); });
    this.one(".rk-grid")?.addEventListener("input", () => {
      const rows = [...this.element.querySelectorAll("tr")].map((row) =>
        `[${[...row.querySelectorAll("input")].map((cell) => cell.value.replace(/,/g, ".")).join(", ")}]`);
      this.input.value = `[${rows.join(", ")}]`;
    });
    this.one("form").addEventListener("input", () => { // what was said stays to be read, without its sign
      this.keepTyped();
      this.one(".rk-verdict").className = "rk-verdict";
      this.one(".rk-read").textContent = "";
    });
    const train = (training) => this.withExercise(() => {
      Object.assign(this, { training, trained: {} });
      this.show();
      this.restore();
      this.input.focus();
    });
    this.one(".rk-another").addEventListener("click", () => train(this.training + 1));
    this.one(".rk-training button").addEventListener("click", () => train(0));
    this.one(".rk-help").addEventListener("click", () => this.withExercise(() => this.help()));
    this.element.classList.add("rk-live");
    return this;
  }

  // later: once it comes near, unless there is an answer to judge.
  renew(later = false) {
    Object.assign(this, { training: 0, number: null });
    this.setStale(later && !this.entry().unjudged);
    this.restore(); // at once: what is typed while the numbers are loaded must stay
    return this.stale ? null : this.showMine();
  }

  showMine() {
    return this.withExercise(() => {
      this.show();
      if (this.entry().unjudged) this.check(); // from a file
      else this.climb();
    });
  }

  setStale(stale) {
    this.stale = stale;
    this.element.classList.toggle("rk-stale", stale);
    if (stale) delete this.element.dataset.variant;
  }

  // Does something with the exercise; until it is there, the box says so in place of the question.
  async withExercise(work) {
    const text = this.one(".rk-text");
    try {
      if (!this.exercise) text.textContent = "Your numbers are being loaded …";
      this.exercise ??= await this.desk.load();
    } catch (error) {
      this.setStale(false); // from now on by the button
      text.innerHTML = `<p>${NOT_LOADED} <button type="button">Try again</button></p>`;
      text.querySelector("button").addEventListener("click", () => this.renew());
      return console.error(error);
    }
    if (this.number === null) this.show();
    return work();
  }

  get variant() { return this.exercise.variants[this.number]; }

  get steps() { return splitSolution(fillTemplate(this.exercise.solution, this.variant.shown)); }

  // The stored entry of the present numbers: { answer, time, result, feedback, tries, help, … }.
  entry() { return (this.training ? this.trained : this.desk.kept()) ?? {}; }

  keep(entry) {
    if (this.training) this.trained = entry; else this.desk.keep(entry);
    this.seen = JSON.stringify(entry);
  }

  // What was stored in another tab meanwhile.
  follow() {
    if (!this.training && JSON.stringify(this.entry()) !== this.seen) this.restore();
  }

  // Store unchecked typing, too, so that it is saved to the file; it takes no pass away.
  keepTyped() {
    const answer = this.input.value, { unjudged, ...kept } = this.entry();
    if (this.training || !answer || kept.result === "right" || kept.answer === answer) return;
    this.keep({ ...kept, answer, result: "", feedback: "", time: now() });
  }

  check() {
    return this.withExercise(() => {
      const { input, number, variant } = this, { unjudged, ...kept } = this.entry();
      const found = judgeAnswer(this.exercise, variant.candidates, input.value);
      if (unjudged?.answer && found.result !== "right") { // an older one, of no use
        this.keep(unjudged);
        return this.restore();
      }
      this.tell(found);
      if (found.result === "unread") return;
      const passed = kept.result === "right"; // a further try takes nothing away
      const tries = (kept.tries ?? 0) + 1, right = found.result === "right";
      const time = unjudged ? kept.time : now(); // from a file: when it was given
      if (!passed) this.keep({ ...kept, answer: input.value, ...found, variant: number, tries, time });
      if (right) this.pass();
      this.climb(passed ? { ...kept, ...found, tries } : this.entry());
    });
  }

  tell({ result = "", feedback = "", read = "" }) {
    this.one(".rk-verdict").className = `rk-verdict rk-${result}`;
    this.one(".rk-verdict").innerHTML = renderSymbols(feedback);
    this.one(".rk-read").innerHTML = renderSymbols(read);
  }

  pass() {
    const { result, help = 0, of } = this.entry();
    this.one(".rk-passed").hidden = this.training > 0 || result !== "right";
    this.one(".rk-passed").textContent = help > 1 ? `passed with help: ${help - 1} of ${of} steps` : "passed";
  }

  // The next rung of the ladder; what is opened before the pass is kept with it.
  help() {
    const entry = this.entry(), opened = this.opened ?? entry.help ?? 0;
    if (opened && !entry.tries) return this.climb(entry, TRY_FIRST);
    this.opened = opened + 1;
    const helped = { answer: "", feedback: "", ...entry, help: this.opened, of: this.steps.length };
    if (entry.result !== "right") this.keep(helped);
    this.climb();
  }

  // The rungs that are open: why, after two tries, a named mistake is one; then where to look, then
  // the steps of the solution.
  climb(entry = this.entry(), note = "") {
    const { hint, outcomes, topic } = this.exercise, opened = this.opened ?? entry.help ?? 0;
    const { steps } = this, last = steps.length;
    const { why, picture } = entry.tries > 1 && entry.result === "wrong" ? outcomes[entry.name] ?? {} : {};
    const root = document.documentElement.dataset.content_root; // a notebook has none
    const link = (place, words) => `<a href="${root}${topic}/${topic}.html#${place}">${words}</a>`;
    const words = (_, name) => name, here = location.pathname.endsWith(`/${topic}.html`);
    const see = root === undefined ? "" : ` ${link(entry.name, "See it in the chapter.")}`;
    const still = (theme) => `<img class="rk-on-${theme} dark-light" loading="lazy" alt="${escapeHtml(picture)}" `
      + `src="${root}_static/practice/${entry.name}.svg?${this.element.dataset.version}#${theme}">`;
    this.one(".rk-ladder").innerHTML = (why ? `<p>${renderSymbols(why)}${see}</p>` : "")
      + (picture && root !== undefined
        ? `<figure>${still("light")}${still("dark")}<figcaption>${PICTURED}</figcaption></figure>` : "")
      + (opened ? `<p>${renderHint(hint, root === undefined ? words : link, here, steps[0])}</p>` : "")
      + steps.slice(0, Math.max(0, opened - 1)).map(renderParagraphs).join("") + (note && `<p>${note}</p>`);
    const button = this.one(".rk-help");
    button.hidden = opened > last;
    button.textContent = opened < 2 ? HELP_STEPS[opened] : HELP_STEPS[opened < last ? 2 : 3];
  }

  show() {
    const { course, student } = this.desk, { exercise, training } = this;
    this.number = (chooseVariant(course, exercise.name, student()) + training) % VARIANTS;
    this.setStale(false);
    this.one(".rk-text").innerHTML = renderParagraphs(fillTemplate(exercise.text, this.variant.shown));
    this.element.dataset.variant = this.number;
    this.one(".rk-training").hidden = !training;
  }

  restore() {
    const kept = this.entry();
    this.seen = JSON.stringify(kept);
    this.opened = null; // besides what was opened before the pass
    this.input.value = kept.answer ?? "";
    const cells = [...this.element.querySelectorAll("td input")];
    const readings = parseTyped(this.input.value, this.exercise?.unknowns ?? []).map(({ value }) => [value].flat(Infinity));
    const entries = readings.find(({ length }) => length === cells.length) ?? readings[0];
    cells.forEach((cell, k) => { cell.value = entries[k] ?? ""; });
    this.pass();
    this.tell(kept);
    if (this.exercise && this.number !== null) this.climb();
  }
}

// The data of exercises are packed by rendering.py.
export const unpack = async (packed) => {
  const bytes = Uint8Array.from(atob(packed), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).json();
};
