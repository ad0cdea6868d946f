// The box of an exercise: as HTML, and under the hand.
//
// exercise: { name, title, level, text, solution, asked, variants, … }, made by page.py.
// variants: { shown, candidates }; shown: what stands for each placeholder.

const LEVELS = { 1: "one step", 2: "several steps", 3: "hard" };
const TRAINING = "Numbers for training: they are not yours and do not count.";
const NOT_LOADED = "The exercise could not be loaded. Please load the page again.";

const filled = (template, shown) => template.replace(/\{([\w.:]+)\}/g, (_, key) => shown[key]);

const paragraphs = (text) => symbols(text).split("\n\n")
  .map((paragraph) => `<p>${paragraph}</p>`).join("");

// id: the start of the ids inside, for the box's own parts to find each other.
const exerciseHtml = (exercise, shown, solution, id = exercise.name) =>
  `<div class="rk-question" id="${id}-question">`
    + `<p class="rk-exercise-title"><strong>${escaped(exercise.title)}</strong>`
    + ` <span class="rk-level">${LEVELS[exercise.level]}</span>`
    + ` <span class="rk-passed" hidden>passed</span></p>`
    + `<div class="rk-text">${paragraphs(filled(exercise.text, shown))}</div></div>`
    + `<p class="rk-training" hidden>${TRAINING} <button type="button">Back to my numbers</button></p>`
    + `<form class="rk-form"><label for="${id}-answer">Answer, <span class="rk-asked">`
    + `${symbols(exercise.asked)}</span></label>`
    + `<div class="rk-row"><input id="${id}-answer" type="text" autocomplete="off" autocapitalize="off" `
    + `spellcheck="false" aria-describedby="${id}-question ${id}-verdict">`
    + `<button type="submit">Check</button>`
    + `<button type="button" class="rk-another">Another one</button></div></form>`
    + `<p class="rk-verdict" id="${id}-verdict" role="status"></p>`
    + (solution ? `<details class="rk-solution"><summary>Solution</summary><div></div></details>` : "");

// An exercise in an element that holds its HTML. desk: { course, student(), load(), kept(),
// keep(entry) }; load() promises the exercise with its variants.
class Box {
  constructor(element, desk) {
    Object.assign(this, { element, desk });
    this.input = this.one("input");
    this.solution = this.one(".rk-solution");
    this.exercise = null; // until it is loaded
    this.training = 0; // how many variants beyond one's own
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
    const train = (training) => this.withExercise(() => {
      this.training = training;
      this.show();
      this.restore();
      this.input.focus();
    });
    this.one(".rk-another").addEventListener("click", () => train(this.training + 1));
    this.one(".rk-training button").addEventListener("click", () => train(0));
    this.solution?.addEventListener("toggle", () => this.withExercise(() => this.unfold()));
    this.element.classList.add("rk-live");
    return this;
  }

  // For another student.
  renew() {
    this.training = 0;
    this.restore(); // at once: what is typed while the numbers are loaded must stay
    return this.withExercise(() => this.show());
  }

  async withExercise(work) {
    try {
      this.exercise ??= await this.desk.load();
    } catch (error) {
      this.tell("unread", NOT_LOADED);
      return console.error(error);
    }
    return work();
  }

  get number() {
    const { course, student } = this.desk;
    return (dealtVariant(course, this.exercise.name, student()) + this.training) % VARIANTS;
  }

  get variant() {
    return this.exercise.variants[this.number];
  }

  // What is typed and not checked yet is kept, and saved, too; it takes no pass away.
  keepTyped() {
    const answer = this.input.value, kept = this.desk.kept();
    if (this.training || !answer || kept?.result === "right" || kept?.answer === answer) return;
    this.desk.keep({ answer, result: "", says: "" });
  }

  check() {
    return this.withExercise(() => {
      const { input, number, variant } = this;
      const found = checkAnswer(this.exercise, variant.candidates, input.value);
      this.tell(found.result, found.says);
      const passed = this.desk.kept()?.result === "right"; // a further try takes nothing away
      if (this.training || found.result === "unread" || (passed && found.result !== "right")) return;
      this.desk.keep({ answer: input.value, ...found, variant: number });
      this.one(".rk-passed").hidden = found.result !== "right";
    });
  }

  tell(result, words) {
    this.one(".rk-verdict").className = `rk-verdict rk-${result}`;
    this.one(".rk-verdict").innerHTML = symbols(words);
  }

  show() {
    const { dataset } = this.element, before = dataset.variant;
    this.one(".rk-text").innerHTML = paragraphs(filled(this.exercise.text, this.variant.shown));
    dataset.variant = this.number;
    this.one(".rk-training").hidden = !this.training;
    if (this.solution && before !== undefined && before !== dataset.variant) this.solution.open = false;
    this.unfold();
  }

  unfold() {
    if (!this.solution?.open) return;
    const text = filled(this.exercise.solution, this.variant.shown);
    this.solution.querySelector("div").innerHTML = paragraphs(text);
  }

  restore() {
    const kept = this.training ? null : this.desk.kept();
    this.input.value = kept ? kept.answer : "";
    this.one(".rk-passed").hidden = kept?.result !== "right";
    this.tell(kept ? kept.result : "", kept ? kept.says : "");
  }
}

Object.assign(part, { exerciseHtml });
