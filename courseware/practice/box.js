// The box of an exercise: as HTML, and under the hand.
//
// exercise: { name, title, level, text, solution, asked, variants, … }, made by page.py.
// variants: { shown, candidates }; shown: what stands for each placeholder.

const LEVELS = { 1: "one step", 2: "several steps", 3: "hard" };
const TRAINING = "Numbers for training: they are not yours and do not count.";
const LOADING = "Your numbers are being loaded …";
const NOT_LOADED = "Your numbers could not be loaded, so nothing can be checked.";
const TRY_FIRST = "Check an answer first, any guess will do: then the steps open one by one.";
const PICTURED = "In the numbers of the chapter; dashed or red is what the mistake makes of it.";
const RUNGS = ["Where should I look?", "Show the first step", "Show the next step", "Show the answer"];

const filled = (template, shown) => template.replace(/\{([\w.:]+)\}/g, (_, key) => shown[key]);

// Lists in a list as a matrix. In a cell letters and indices stand in one span: in mathematics each
// would have a line of its own.
const MATRIX = /\[(\[[^[\]]*\](?:, \[[^[\]]*\])*)\]/g;
const cells = (row) => row.split(/, (?![^(]*\))/)
  .map((cell) => `<mtd><mtext><span>${cell}</span></mtext></mtd>`).join("");
const matrices = (text) => text.replace(MATRIX, (_, rows) => `<math><mtable>${
  rows.slice(1, -1).split("], [").map((row) => `<mtr>${cells(row)}</mtr>`).join("")
}</mtable></math>`);

const unbroken = (text) => text.replace(new RegExp(UNBROKEN, "g"), "\u00a0");

const paragraphs = (text) => matrices(symbols(unbroken(text))).split("\n\n")
  .map((paragraph) => `<p>${paragraph}</p>`).join("");

const FORMULA = /^(\[[^=]*\]|\S+) = /;

// The chapter, and what its formulas give; each leads to the formula, where the chapter prints it.
const whereToLook = ({ chapter, formulas }, link) => {
  const found = formulas.map(([gives, place]) => place ? link(place, symbols(gives)) : symbols(gives));
  return `Look in the chapter “${symbols(chapter)}”`
    + `${found.length ? ` for the formulas of ${found.join("; ")}` : ""}.`;
};

// A solution in steps: each is a text and the formulas that follow it.
const stepsOf = (text) => text ? text.split("\n\n").reduce((steps, part) => {
    const last = steps.at(-1)?.split("\n\n").at(-1);
    if (last === undefined || (FORMULA.test(last) && !FORMULA.test(part))) return [...steps, part];
    return [...steps.slice(0, -1), `${steps.at(-1)}\n\n${part}`];
  }, []) : [];

// All of it, for paper.
const solutionHtml = (text, shown) => paragraphs(filled(text, shown));

// A matrix can be typed entry by entry, too.
const gridHtml = ({ shape: [rows, columns] = [] }) => columns ? `<details class="rk-grid">`
  + `<summary>Type it entry by entry</summary><table>${Array.from({ length: rows }, (_, i) =>
    `<tr>${Array.from({ length: columns }, (_, j) => `<td><input type="text" autocomplete="off" `
      + `spellcheck="false" aria-label="row ${i + 1}, column ${j + 1}"></td>`).join("")}</tr>`).join("")
  }</table></details>` : "";

// id: the start of the ids inside, for the box's own parts to find each other.
const exerciseHtml = (exercise, shown, solution, id = exercise.name) =>
  `<div class="rk-question" id="${id}-question">`
    + `<p class="rk-exercise-title"><strong>${escaped(exercise.title)}</strong>`
    + ` <span class="rk-level">${LEVELS[exercise.level]}</span>`
    + ` <span class="rk-passed" hidden>passed</span></p>`
    + `<div class="rk-text">${paragraphs(filled(exercise.text, shown))}</div></div>`
    + `<p class="rk-training" hidden>${TRAINING} <button type="button">Back to my numbers</button></p>`
    + `<form class="rk-form"><label for="${id}-answer">Answer, <span class="rk-asked">`
    + `${symbols(unbroken(exercise.asked))}</span></label>`
    + `<div class="rk-row"><input id="${id}-answer" type="text" autocomplete="off" autocapitalize="off" `
    + `spellcheck="false" aria-describedby="${id}-question ${id}-verdict">`
    + `<button type="submit">Check</button>`
    + `<button type="button" class="rk-another">Another one</button></div>${gridHtml(exercise)}</form>`
    + `<p class="rk-verdict" id="${id}-verdict" role="status"></p><p class="rk-read"></p>`
    + `<div class="rk-ladder" aria-live="polite"></div>`
    + `<button type="button" class="rk-help">${RUNGS[0]}</button>`;

// An exercise in an element that holds its HTML. desk: { course, student(), load(), kept(),
// keep(entry) }; load() promises the exercise with its variants. What is shown is what is judged:
// both take the variant from `number`, which `show` alone sets.
class Box {
  constructor(element, desk) {
    Object.assign(this, { element, desk });
    this.input = this.one("input");
    this.exercise = this.number = null; // until they are loaded and shown
    this.training = 0; // how many variants beyond one's own
    this.trained = {}; // what is kept of one's own numbers is not kept of these
  }

  one(selector) {
    return this.element.querySelector(selector);
  }

  start() {
    this.one("form").addEventListener("submit", (event) => {
      event.preventDefault();
      this.check();
    });
    this.input.addEventListener("change", () => this.keepTyped());
    this.one(".rk-grid")?.addEventListener("input", () => {
      const rows = [...this.element.querySelectorAll("tr")].map((row) =>
        `[${[...row.querySelectorAll("input")].map((cell) => cell.value.replace(/,/g, ".")).join(", ")}]`);
      this.input.value = `[${rows.join(", ")}]`;
    });
    this.one(".rk-grid")?.addEventListener("change", () => this.keepTyped());
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

  // For another student.
  renew() {
    Object.assign(this, { training: 0, number: null });
    this.restore(); // at once: what is typed while the numbers are loaded must stay
    return this.withExercise(() => {
      this.show();
      if (this.entry().unjudged) this.check(); // from a file
      else this.climb();
    });
  }

  // Does something with the exercise; until it is there, the box says so in place of the question.
  async withExercise(work) {
    const text = this.one(".rk-text");
    try {
      if (!this.exercise) text.textContent = LOADING;
      this.exercise ??= await this.desk.load();
    } catch (error) {
      text.innerHTML = `<p>${NOT_LOADED} <button type="button">Try again</button></p>`;
      text.querySelector("button").addEventListener("click", () => this.renew());
      return console.error(error);
    }
    if (this.number === null) this.show();
    return work();
  }

  get variant() {
    return this.exercise.variants[this.number];
  }

  get steps() {
    return stepsOf(filled(this.exercise.solution, this.variant.shown));
  }

  // What is kept of the present numbers: { answer, time, result, says, tries, help, … }.
  entry() {
    return (this.training ? this.trained : this.desk.kept()) ?? {};
  }

  keep(entry) {
    if (this.training) this.trained = entry; else this.desk.keep(entry);
  }

  // What is typed and not checked yet is kept, and saved, too; it takes no pass away.
  keepTyped() {
    const answer = this.input.value, { unjudged, ...kept } = this.entry();
    if (this.training || !answer || kept.result === "right" || kept.answer === answer) return;
    this.keep({ ...kept, answer, result: "", says: "", time: now() });
  }

  check() {
    return this.withExercise(() => {
      const { input, number, variant } = this, { unjudged, ...kept } = this.entry();
      const found = checkAnswer(this.exercise, variant.candidates, input.value);
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

  tell({ result = "", says = "", read = "" }) {
    this.one(".rk-verdict").className = `rk-verdict rk-${result}`;
    this.one(".rk-verdict").innerHTML = symbols(says);
    this.one(".rk-read").innerHTML = symbols(read);
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
    if (entry.result !== "right") this.keep({ answer: "", says: "", ...entry, help: this.opened, of: this.steps.length });
    this.climb();
  }

  // The rungs that are open: why, after two tries, a named mistake is one; then where to look, then
  // the steps of the solution.
  climb(entry = this.entry(), note = "") {
    const { look, outcomes, topic } = this.exercise, opened = this.opened ?? entry.help ?? 0;
    const { steps } = this, last = steps.length;
    const { why, picture } = entry.tries > 1 && entry.result === "wrong" ? outcomes[entry.name] ?? {} : {};
    const root = document.documentElement.dataset.content_root; // a notebook has none
    const link = (place, words) => `<a href="${root}${topic}/${topic}.html#${place}">${words}</a>`;
    const see = root === undefined ? "" : ` ${link(entry.name, "See it in the chapter.")}`;
    const still = (theme) => `<img class="rk-on-${theme} dark-light" loading="lazy" alt="${escaped(picture)}" `
      + `src="${root}_static/practice/${entry.name}.svg#${theme}">`;
    this.one(".rk-ladder").innerHTML = (why ? `<p>${symbols(why)}${see}</p>` : "")
      + (picture && root !== undefined ? `<figure>${still("light")}${still("dark")}<figcaption>${PICTURED}</figcaption></figure>` : "")
      + (opened ? `<p>${whereToLook(look, root === undefined ? (_, words) => words : link)}</p>` : "")
      + steps.slice(0, Math.max(0, opened - 1)).map(paragraphs).join("") + (note && `<p>${note}</p>`);
    const button = this.one(".rk-help");
    button.hidden = opened > last;
    button.textContent = opened < 2 ? RUNGS[opened] : RUNGS[opened < last ? 2 : 3];
  }

  show() {
    const { course, student } = this.desk, { exercise, training } = this;
    this.number = (dealtVariant(course, exercise.name, student()) + training) % VARIANTS;
    this.one(".rk-text").innerHTML = paragraphs(filled(exercise.text, this.variant.shown));
    this.element.dataset.variant = this.number;
    this.one(".rk-training").hidden = !training;
  }

  restore() {
    const kept = this.entry();
    this.opened = null; // besides what was opened before the pass
    this.input.value = kept.answer ?? "";
    const entries = [readAsked(this.input.value, this.exercise?.asks ?? []).value].flat(Infinity);
    this.element.querySelectorAll("td input").forEach((cell, k) => { cell.value = entries[k] ?? ""; });
    this.pass();
    this.tell(kept);
    if (this.exercise && this.number !== null) this.climb();
  }
}

Object.assign(part, { exerciseHtml, paragraphs, solutionHtml });
