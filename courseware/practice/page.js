// On a web page: one desk for all exercises, the student's name and answers in the browser.

import { escapeHtml } from "../units/text.js";
import { decodeTable, downloadAnswers, parseAnswers } from "./answer_file.js";
import { startProgress } from "./progress.js";
import { foldName } from "./variants.js";
import { ExerciseBox, unpack } from "./exercise.js";
import { memory, readStored } from "../answers/storage.js";
import { answersKey, countPassed, isPassed, readAnswers, STUDENT_KEY, sumUp } from "./stored_answers.js";

const NAMELESS = "Type your name first: it picks your numbers.";
const ORPHANS = " answered before you typed a name: to see them again, with their numbers, empty the name.";
const NOTE = "For checking yourself. Your name picks your numbers; it and your answers stay in this "
  + "browser, nothing is sent. Give three decimals where nothing else is said. Answers can be 0.5, "
  + "1/3, pi/3, sqrt(3)/2, 30° where rad is asked, a list: [1, 2], or a matrix: [[1, 2], [3, 4]]. "
  + "Whole turns more or less do not matter in an angle. Safari forgets what it keeps after seven days "
  + "without a visit: save your answers.";
const CLEAR = "Clear my answers";
const NOTHING_KEPT = "This browser keeps nothing more: save your answers as a file before you leave.";

export const renderDesk = (course) => `<div class="rk-row"><label for="rk-student">Name</label>`
  + `<input id="rk-student" type="text" placeholder="it picks your numbers" maxlength="200" autocomplete="off" spellcheck="false">`
  + `<details class="rk-menu"><summary>Answers</summary><div class="rk-row">`
  + `<button type="button" class="rk-export">Save my answers (CSV)</button>`
  + `<label class="rk-import">Load answers that I saved <input type="file" accept=".csv,.tsv,.txt"></label>`
  + `<button type="button" class="rk-clear">${CLEAR}</button></div>`
  + `<p class="rk-note">Course: <strong>${escapeHtml(course)}</strong>. ${NOTE}</p></details></div>`
  + `<p class="rk-progress" role="status">&nbsp;</p>`;

// A line that stays in sight while an exercise is.
const BAR = `<button type="button" class="rk-who"></button> <span></span> <a>Next open exercise</a>`;

// The numbers of a topic's exercises, a file beside the page that is loaded when they are needed.
const loadedTopics = {};
const loadTopic = (topic, version) => loadedTopics[topic] ??= new Promise((resolve, reject) => {
  const script = document.createElement("script");
  script.src = `${document.documentElement.dataset.content_root}_static/practice/${topic}.js?${version}`;
  script.onload = () => unpack(window.coursewarePractice[topic]).then(resolve, reject);
  script.onerror = () => { delete loadedTopics[topic]; reject(new Error(`${script.src} is missing`)); };
  document.head.append(script);
});

// The desk of a page: who works here, and what this student has answered. `name` is who it is
// until another name is given as a whole, so that numbers and answers are always one student's.
class Desk {
  constructor(element, sections) {
    Object.assign(this, { element, sections });
    this.course = element.dataset.course;
    this.field = element.querySelector("input");
    this.boxes = sections.map((section) => new ExerciseBox(section, this.seenBy(section.dataset)));
    this.bar = document.createElement("div");
    this.bar.className = "rk-bar";
    this.bar.innerHTML = BAR;
  }

  // The part of the desk that the box of one exercise needs.
  seenBy({ exercise, topic, version }) {
    return {
      course: this.course,
      student: () => this.student(),
      load: async () => (await loadTopic(topic, version))[exercise],
      kept: () => this.mine()[exercise],
      keep: (entry) => this.keep({ ...this.mine(), [exercise]: entry }),
    };
  }

  start() {
    const press = (where, button, work) =>
      where.querySelector(button).addEventListener("click", () => work.call(this));
    press(this.element, ".rk-clear", this.clear);
    this.element.querySelector(".rk-clear").addEventListener("blur", ({ target }) => { target.textContent = CLEAR; });
    press(this.element, ".rk-export", this.save);
    press(this.bar, ".rk-who", () => { this.element.scrollIntoView(); this.field.focus(); });
    this.element.querySelector("[type=file]").addEventListener("change", (event) => this.load(event.target));
    this.field.value = this.name = memory.get(STUDENT_KEY) ?? "";
    this.field.addEventListener("change", () => this.renew());
    (this.element.closest("article") ?? document.body).append(this.bar);
    const seen = this.watch("0px"), { element } = this;
    this.near = this.watch("50% 0px"); // whose numbers are loaded, chapter by chapter
    for (const box of this.boxes) {
      box.start();
      [seen, this.near].forEach(({ observer }) => observer.observe(box.element));
    }
    seen.observer.observe(element);
    // unseen, in its place: the end of the page must not jump
    seen.follow = () => { this.bar.inert = seen.has(element) || !seen.size; };
    this.near.follow = () => this.boxes.forEach((box) => { if (box.stale && this.near.has(box.element)) box.showMine(); });
    addEventListener("storage", () => this.follow());
    addEventListener("pageshow", ({ persisted }) => { if (persisted) this.follow(); }); // by Back
    addEventListener("beforeprint", () => this.boxes.forEach((box) => { if (box.stale) box.showMine(); }));
    this.tellProgress();
    if (this.name || Object.keys(this.mine()).length) this.renewBoxes();
  }

  // The exercises that are in the window or so near to it.
  watch(rootMargin) {
    const found = new Set();
    found.observer = new IntersectionObserver((seen) => {
      seen.forEach(({ target, isIntersecting }) => found[isIntersecting ? "add" : "delete"](target));
      found.follow();
    }, { rootMargin });
    return found;
  }

  renewBoxes() {
    this.boxes.forEach((box) => box.renew(!this.near.has(box.element)));
  }

  student() { return foldName(this.name); }

  mine() { return readAnswers(this.course, this.name); }

  // Answers of the present student; undefined: none any more.
  keep(answers) {
    const key = answersKey(this.course), all = { ...readStored(key), [this.student()]: answers };
    memory.set(key, JSON.stringify(all));
    this.asked ??= navigator.storage?.persist?.().catch(() => {}); // a browser may tidy up what is not asked for
    this.tellProgress();
  }

  // What another tab or page has stored: the name that counts is the one that is seen.
  follow() {
    const name = memory.get(STUDENT_KEY) ?? "";
    if (name !== this.name) {
      this.field.value = name;
      return this.renew();
    }
    this.boxes.forEach((box) => box.follow());
    this.tellProgress();
  }

  renew() {
    this.name = this.field.value;
    memory.set(STUDENT_KEY, this.name);
    this.tellProgress();
    this.renewBoxes();
  }

  tell(words) {
    const said = this.element.querySelector(".rk-progress");
    if (said.textContent !== words) said.textContent = words; // it is read aloud
  }

  tellProgress() {
    const mine = this.mine(), passed = (name) => isPassed(mine, name);
    const here = this.sections.map(({ dataset }) => dataset.exercise), done = here.filter(passed);
    const nameless = done.length && !this.student() ? `. ${NAMELESS}` : "";
    const orphans = this.student() ? Object.values(readAnswers(this.course, "")).filter(({ answer }) => answer).length : 0;
    const storage = memory.kept ? "" : ` ${NOTHING_KEPT}`;
    this.tell(`${done.length} of ${here.length} checks on this page passed${nameless}${storage}`
      + (orphans ? `. ${orphans}${ORPHANS}` : ""));
    const all = countPassed(mine), open = here.find((name) => !passed(name));
    const course = `${sumUp(all, "passed")} of ${sumUp(all, "count")} in the course`;
    this.bar.querySelector(".rk-who").textContent = this.name.trim() || "Type your name";
    this.bar.querySelector("span").textContent = `${done.length}/${here.length} here, ${course}${storage}`;
    const next = this.bar.querySelector("a");
    next.hidden = !open;
    if (open) next.href = `#${open}`;
    dispatchEvent(new Event("courseware:kept"));
  }

  // Without a dialog, which a frame may forbid: the button asks, and leaving it is a no.
  clear() {
    const button = this.element.querySelector(".rk-clear");
    if (button.textContent === CLEAR) {
      button.textContent = `Press again to clear all answers of ${this.name.trim() || "this page"}`;
      return;
    }
    button.textContent = CLEAR;
    this.keep(undefined);
    this.renew();
  }

  save() {
    if (!this.student()) {
      this.tell(NAMELESS);
      return this.field.focus();
    }
    this.tell(downloadAnswers(this.element.dataset, this.name.trim(), this.mine()));
  }

  // Answers of a file that was saved here or elsewhere: each box checks its own again. A newer one
  // counts, as it does when graded, and an older one if it is right; the same one changes nothing.
  async load(input) {
    const all = parseAnswers(decodeTable(new Uint8Array(await input.files[0].arrayBuffer())));
    const rows = all.filter(({ course = "" }) => ["", foldName(this.course)].includes(foldName(course)));
    input.value = "";
    if (!rows.length) return this.tell("There are no answers for this course in that file.");
    this.name = this.field.value = rows[0].student;
    const answers = { ...this.mine() };
    for (const { student, exercise, answer, time = "" } of rows) {
      const here = answers[exercise];
      if (foldName(student) !== this.student() || here?.result === "right" || here?.answer === answer) continue;
      const newer = !here?.answer || time > (here.time ?? "");
      answers[exercise] = { ...here, answer, time, result: "", feedback: "", unjudged: newer || here };
    }
    this.keep(answers);
    this.renew();
  }
}

export const startDesk = () => {
  startProgress();
  const desk = document.querySelector(".rk-desk");
  if (desk) new Desk(desk, [...document.querySelectorAll(".rk-exercise")]).start();
};
