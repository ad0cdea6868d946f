// On a web page: one desk for all exercises, the student's name and answers in the browser.

const NAMELESS = "Type your name first: it picks your numbers.";
const NOTE = "For checking yourself. Your name picks your numbers; it and your answers stay in this "
  + "browser, nothing is sent. Give three decimals where nothing else is said. Answers can be 0.5, 1/3, pi/3, sqrt(3)/2, "
  + "30°, or a list: [1, 2].";

const deskHtml = (course) => `<div class="rk-row"><label for="rk-student">Your name or number</label>`
  + `<input id="rk-student" type="text" maxlength="200" autocomplete="off" spellcheck="false"></div>`
  + `<p class="rk-progress" role="status"></p>`
  + `<div class="rk-row"><button type="button" class="rk-export">Save my answers (CSV)</button>`
  + `<button type="button" class="rk-clear">Clear my answers</button></div>`
  + `<p class="rk-note">Course: <strong>${escaped(course)}</strong>. ${NOTE}</p>`;

const unpacked = (packed) => {
  const bytes = Uint8Array.from(atob(packed), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).json();
};

const memory = { // a browser may refuse to keep anything: then the page alone remembers
  data: {},
  get: (key) => { try { return localStorage.getItem(key) ?? memory.data[key]; } catch { return memory.data[key]; } },
  set: (key, value) => { // whether the browser keeps it
    memory.data[key] = value;
    try { localStorage.setItem(key, value); return true; } catch { return false; }
  },
};

// The numbers of a topic's exercises, a file beside the page that is loaded when they are needed.
const topics = {};
const loadTopic = (topic, version) => topics[topic] ??= new Promise((resolve, reject) => {
  const script = document.createElement("script");
  script.src = `${document.documentElement.dataset.content_root}_static/practice/${topic}.js?${version}`;
  script.onload = () => resolve(unpacked(window.workshopPractice[topic]));
  script.onerror = () => { delete topics[topic]; reject(new Error(`${script.src} is missing`)); };
  document.head.append(script);
});

// The desk of a page: who works here, and what this student has answered.
class Desk {
  constructor(element, sections) {
    Object.assign(this, { element, sections });
    this.course = element.dataset.course;
    this.name = element.querySelector("input");
    this.boxes = sections.map((section) => new Box(section, this.seenBy(section.dataset)));
  }

  // What the box of one exercise sees of the desk.
  seenBy({ exercise, topic, version }) {
    return {
      course: this.course,
      student: () => this.student(),
      load: async () => (await loadTopic(topic, version))[exercise],
      kept: () => this.mine()[exercise],
      keep: (entry) => this.keep({ ...this.mine(), [exercise]: { ...entry, time: now() } }),
    };
  }

  start() {
    const press = (button, work) =>
      this.element.querySelector(button).addEventListener("click", () => work.call(this));
    press(".rk-clear", this.clear);
    press(".rk-export", this.save);
    this.name.value = memory.get(`${STORE} student`) ?? "";
    this.name.addEventListener("change", () => this.renew());
    this.boxes.forEach((box) => box.start());
    this.tellProgress();
    if (this.name.value || Object.keys(this.mine()).length) this.boxes.forEach((box) => box.renew());
  }

  student() {
    return foldedName(this.name.value);
  }

  all() {
    return JSON.parse(memory.get(`${STORE} answers ${this.course}`) || "{}");
  }

  mine() {
    return this.all()[this.student()] ?? {};
  }

  // Answers of the present student; undefined: none any more.
  keep(answers) {
    const all = { ...this.all(), [this.student()]: answers };
    memory.set(`${STORE} answers ${this.course}`, JSON.stringify(all));
    this.tellProgress();
  }

  renew() {
    memory.set(`${STORE} student`, this.name.value);
    this.tellProgress();
    this.boxes.forEach((box) => box.renew());
  }

  tell(words) {
    this.element.querySelector(".rk-progress").textContent = words;
  }

  tellProgress() {
    const mine = this.mine();
    const passed = this.sections.filter(({ dataset }) => mine[dataset.exercise]?.result === "right");
    const nameless = passed.length && !this.student() ? `. ${NAMELESS}` : "";
    this.tell(`${passed.length} of ${this.sections.length} checks on this page passed${nameless}`);
  }

  clear() {
    if (!confirm(`Clear all answers of ${this.student() || "this page"} in this browser?`)) return;
    this.keep(undefined);
    this.renew();
  }

  save() {
    const student = this.student();
    if (!student) {
      this.tell(NAMELESS);
      return this.name.focus();
    }
    saveAnswers(this.element.dataset, student, this.mine());
  }
}

const onPage = () => {
  const desk = document.querySelector(".rk-desk");
  if (desk) new Desk(desk, [...document.querySelectorAll(".rk-exercise")]).start();
};

Object.assign(part, { answersCsv, deskHtml, memory, onPage });
