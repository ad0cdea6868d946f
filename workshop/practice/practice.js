// Exercises: which numbers a student gets, is an answer right, and the box that asks. The first
// two parts do what robokin/practice/dealing.py and judging.py do; tests hold them together.
//
// exercise: { name, title, level, text, solution, asked, asks, shape, accept, outcomes, variants },
// made by robokin/practice/page.py. variants: { shown, candidates: [[name, rows], …] }.

// ---- dealing

// what Python, browsers and Unicode all take for white space, written out so that all agree
const SPACES = /[\t-\r\x1c- \x85\xa0\u1680\u2000-\u200a\u2028\u2029\u202f\u205f\u3000\ufeff]+/g;

const INVISIBLE = /[\xad\u200b-\u200f\u202a-\u202e\u2060-\u2064]/g;

const foldedName = (name) => [...name]
  .map((sign) => /[\ud800-\udfff]/.test(sign) && sign.length === 1 ? "\ufffd" : sign).join("")
  .normalize("NFC").replace(INVISIBLE, "").replace(/\u064a/g, "\u06cc").replace(/\u0643/g, "\u06a9")
  .replace(SPACES, " ").replace(/^ | $/g, "");

const utf8 = (text) => [...text].flatMap((sign) => {
  const code = sign.codePointAt(0);
  if (code < 0x80) return [code];
  const tail = (shift) => 0x80 | code >> shift & 0x3f;
  if (code < 0x800) return [0xc0 | code >> 6, tail(0)];
  if (code < 0x10000) return [0xe0 | code >> 12, tail(6), tail(0)];
  return [0xf0 | code >> 18, tail(12), tail(6), tail(0)];
});

const fnv1a = (text) => utf8(text)
  .reduce((value, byte) => Math.imul(value ^ byte, 0x01000193), 0x811c9dc5) >>> 0;

const dealtVariant = (course, exercise, name) => {
  const value = fnv1a([foldedName(course), exercise, foldedName(name)].join("\n"));
  return ((value ^ value >>> 16) >>> 0) % VARIANTS;
};

// ---- judging

const offBy = (ask, x, wanted, factor) => {
  if (!ask.circle) return Math.abs(x - wanted);
  const turn = 2 * Math.PI * Math.abs(factor), off = Math.abs(x - wanted) % turn;
  return Math.min(off, turn - off);
};

// Whether each row is one of the wanted ones, each of them once.
const meets = (asks, rows, wanted, allowed, factors) => {
  const left = wanted.slice();
  return rows.every((row) => {
    const place = left.findIndex((other) =>
      row.every((x, i) => offBy(asks[i], x, other[i], factors[i]) <= allowed[i]));
    if (place >= 0) left.splice(place, 1);
    return place >= 0;
  }) && !left.length;
};

// A variant's answers, and the right ones in other units.
const candidatesOf = (exercise, variant) => {
  const listed = exercise.variants[variant].candidates;
  const units = Object.keys(exercise.outcomes).filter((name) => name.startsWith("unit:"));
  return [...listed, ...units.flatMap((unit) => listed
    .filter(([name]) => name === "right")
    .map(([, rows]) => [unit, rows.map((row) =>
      row.map((x, i) => x * exercise.outcomes[unit].factors[i]))]))];
};

const judgeRows = (exercise, candidates, rows) => {
  const { asks, outcomes } = exercise, ones = asks.map(() => 1);
  for (const [name, wanted] of candidates) {
    const { result, says: words, factors } = outcomes[name];
    const allowed = asks.map((ask, i) => ask.tolerance * Math.abs(factors[i]));
    if (meets(asks, rows, wanted, allowed, factors)) {
      const more = exercise.accept === "any" && result === "right" ? ` ${SAYS.other}` : "";
      return { result, name, says: words + more };
    }
  }
  const right = candidates.filter(([name]) => name === "right");
  const near = asks.map((ask) => NEAR * ask.tolerance);
  if (right.some(([, wanted]) => meets(asks, rows, wanted, near, ones))) {
    return { result: "wrong", name: "near", says: SAYS.near };
  }
  const parts = exercise.accept === "one" && !exercise.shape.length ? asks.filter((ask, i) =>
    offBy(ask, rows[0][i], right[0][1][0][i], 1) <= ask.tolerance) : [];
  const more = parts.length
    ? " " + SAYS.parts.replace("{labels}", parts.map((ask) => ask.label).join(", ")) : "";
  return { result: "wrong", name: "", says: SAYS.wrong + more };
};

// A typed number or list as rows of the numbers asked for; null if it has another shape.
const rowsOf = (exercise, value, count) => {
  const shapeOf = (x) => Array.isArray(x) ? [x.length, ...(x.length ? shapeOf(x[0]) : [])] : [];
  const regular = (x, shape) => shape.length
    ? Array.isArray(x) && x.length === shape[0] && x.every((y) => regular(y, shape.slice(1)))
    : typeof x === "number";
  const size = exercise.asks.length, shape = shapeOf(value);
  const one = size === 1 ? [[]] : [];
  const allowed = exercise.accept === "all"
    ? [[count, size], ...(size === 1 ? [[count]] : [])]
    : [[size], exercise.shape.length ? exercise.shape : [size], [1, size], ...one];
  const fits = regular(value, shape)
    && allowed.some((wanted) => String(wanted) === String(shape) && wanted.length === shape.length);
  if (!fits) return null;
  const flat = [value].flat(Infinity), rows = [];
  for (let i = 0; i < flat.length; i += size) rows.push(flat.slice(i, i + size));
  return rows;
};

const shownValue = (value) => Array.isArray(value)
  ? `[${value.map(shownValue).join(", ")}]`
  : String(Number(value.toPrecision(6))).replace("-", "\u2212");

// The answer to what was typed: { result, name, says }; result "unread" counts for nothing.
const checkAnswer = (exercise, variant, text) => {
  const unread = (words) => ({ result: "unread", name: "", says: words });
  const { value, problem, about } = readAnswer(text);
  if (problem) return unread(PROBLEMS[problem].replace("{about}", () => about));
  const candidates = candidatesOf(exercise, variant);
  const rows = rowsOf(exercise, value, candidates[0][1].length);
  if (!rows) {
    const words = SAYS.shape.replace("{asked}", exercise.asked);
    return unread(words.replace("{read}", shownValue(value)));
  }
  return judgeRows(exercise, candidates, rows);
};

// ---- the box as HTML, from an exercise and what stands for its placeholders

const filled = (template, shown) => template.replace(/\{([\w.:]+)\}/g, (_, key) => shown[key]);

const LETTER_WITH_INDEX = /(\p{L}[\u0300-\u036f]*)_([0-9A-Za-z]+)/gu;

const indexed = (text) => escaped(text).replace(LETTER_WITH_INDEX, "<i>$1</i><sub>$2</sub>");

const paragraphs = (text) => indexed(text).split("\n\n")
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
    + `${indexed(exercise.asked)}</span></label>`
    + `<div class="rk-row"><input id="${id}-answer" type="text" autocomplete="off" autocapitalize="off" `
    + `spellcheck="false" aria-describedby="${id}-question ${id}-verdict">`
    + `<button type="submit">Check</button>`
    + `<button type="button" class="rk-another">Another one</button></div></form>`
    + `<p class="rk-verdict" id="${id}-verdict" role="status"></p>`
    + (solution ? `<details class="rk-solution"><summary>Solution</summary><div></div></details>` : "");

const deskHtml = () => `<div class="rk-row"><label for="rk-student">Your name or number</label>`
  + `<input id="rk-student" type="text" maxlength="200" autocomplete="off" spellcheck="false"></div>`
  + `<p class="rk-progress" role="status"></p>`
  + `<div class="rk-row"><button type="button" class="rk-export">Save my answers (CSV)</button>`
  + `<button type="button" class="rk-clear">Clear my answers</button></div>`
  + `<p class="rk-note">${NOTE}</p>`;

// ---- the box under the hand

// Put an exercise to life in an element that holds its HTML. desk: { course, student(), load(),
// kept(), keep(entry) }; load() promises the exercise with its variants.
const bringExercise = (element, desk) => {
  const one = (selector) => element.querySelector(selector);
  const [input, verdict, solution] = [one("input"), one(".rk-verdict"), one(".rk-solution")];
  let exercise = null, training = 0, before;

  const variant = () =>
    (dealtVariant(desk.course, exercise.name, desk.student()) + training) % VARIANTS;
  const tell = (result, words) => {
    verdict.className = `rk-verdict rk-${result}`;
    verdict.innerHTML = indexed(words);
  };
  const unfold = () => {
    if (!solution || !solution.open || !exercise) return;
    const { shown } = exercise.variants[variant()];
    solution.querySelector("div").innerHTML = paragraphs(filled(exercise.solution, shown));
  };
  const show = () => {
    const { shown } = exercise.variants[variant()];
    one(".rk-text").innerHTML = paragraphs(filled(exercise.text, shown));
    element.dataset.variant = variant();
    one(".rk-training").hidden = !training;
    if (solution && before !== undefined && before !== variant()) solution.open = false;
    before = variant();
    unfold();
  };
  const restore = () => {
    const kept = training ? null : desk.kept();
    input.value = kept ? kept.answer : "";
    one(".rk-passed").hidden = kept?.result !== "right";
    tell(kept ? kept.result : "", kept ? kept.says : "");
  };
  const loaded = async () => {
    exercise ??= await desk.load();
    return exercise;
  };
  const withExercise = (work) => loaded().then(work, (error) => {
    tell("unread", "The exercise could not be loaded. Please load the page again.");
    console.error(error);
  });
  const check = () => withExercise(() => {
    const found = checkAnswer(exercise, variant(), input.value);
    tell(found.result, found.says);
    const passed = desk.kept()?.result === "right";  // a further try takes nothing away
    if (training || found.result === "unread" || (passed && found.result !== "right")) return;
    desk.keep({ answer: input.value, ...found, variant: variant() });
    one(".rk-passed").hidden = found.result !== "right";
  });

  one("form").addEventListener("submit", (event) => {
    event.preventDefault();
    check();
  });
  one(".rk-another").addEventListener("click", () => withExercise(() => {
    training += 1;
    show();
    restore();
    input.focus();
  }));
  one(".rk-training button").addEventListener("click", () => {
    training = 0;
    show();
    restore();
    input.focus();
  });
  solution?.addEventListener("toggle", () => withExercise(unfold));
  element.classList.add("rk-live");
  const renew = () => {
    training = 0;
    restore();  // at once: what is typed while the numbers are loaded must stay
    return withExercise(show);
  };
  return { renew, check };
};

// ---- on a web page: one desk for all exercises, the student's name and answers in the browser

const unpacked = (packed) => {
  const bytes = Uint8Array.from(atob(packed), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).json();
};

const memory = {  // a browser may refuse to keep anything: then the page alone remembers
  data: {},
  get: (key) => { try { return localStorage.getItem(key) ?? memory.data[key]; } catch { return memory.data[key]; } },
  set: (key, value) => {
    memory.data[key] = value;
    try { localStorage.setItem(key, value); } catch { /* told by the note: kept in this page only */ }
  },
};

// As a spreadsheet may read it: quoted, and no cell that it would take for a formula.
const csvCell = (text) => {
  const safe = /^[=+\-@\t\r]/.test(text) && !/^[+-]?[\d.]+$/.test(text) ? `'${text}` : text;
  return /[",;\n\r]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
};

const answersCsv = (course, student, entries) => [["course", "student", "exercise", "answer"],
  ...Object.entries(entries).map(([name, entry]) => [course, student, name, entry.answer]),
].map((row) => row.map(csvCell).join(",")).join("\r\n") + "\r\n";

const exercisesOnPage = (root) => {
  const deskElement = document.querySelector(".rk-desk"), boxes = [];
  const { course } = deskElement.dataset, key = `robokin answers ${course}`;
  const sections = [...document.querySelectorAll(".rk-exercise")];
  const topics = {};
  const load = (topic, version) => topics[topic] ??= new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = `${root}_static/practice/${topic}.js?${version}`;
    script.onload = () => resolve(unpacked(window.robokinPractice[topic]));
    script.onerror = () => { delete topics[topic]; reject(new Error(`${script.src} is missing`)); };
    document.head.append(script);
  });

  const nameInput = deskElement.querySelector("input");
  const student = () => foldedName(nameInput.value);
  const all = () => JSON.parse(memory.get(key) || "{}");
  const mine = () => all()[student()] ?? {};
  const progress = () => {
    const passed = sections.filter(({ dataset }) => mine()[dataset.exercise]?.result === "right");
    const nameless = passed.length && !student() ? `. ${NAMELESS}` : "";
    deskElement.querySelector(".rk-progress").textContent =
      `${passed.length} of ${sections.length} checks on this page passed${nameless}`;
  };
  const keep = (name, entry) => {
    memory.set(key, JSON.stringify({ ...all(), [student()]: { ...mine(), [name]: entry } }));
    progress();
  };

  sections.forEach((element) => {
    const { exercise, topic, version } = element.dataset;
    boxes.push(bringExercise(element, {
      course,
      student,
      load: async () => (await load(topic, version))[exercise],
      kept: () => mine()[exercise],
      keep: (entry) => keep(exercise, entry),
    }));
  });
  const renew = () => {
    memory.set("robokin student", nameInput.value);
    progress();
    boxes.forEach((box) => box.renew());
  };
  nameInput.addEventListener("change", renew);
  deskElement.querySelector(".rk-clear").addEventListener("click", () => {
    if (!confirm(`Clear all answers of ${student() || "this page"} in this browser?`)) return;
    const left = all();
    delete left[student()];
    memory.set(key, JSON.stringify(left));
    renew();
  });
  deskElement.querySelector(".rk-export").addEventListener("click", () => {
    if (!student()) {
      deskElement.querySelector(".rk-progress").textContent = NAMELESS;
      return nameInput.focus();
    }
    const text = "\ufeff" + answersCsv(course, student(), mine());
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
    link.download = `answers-${student().replace(/[^\p{L}\p{N}]+/gu, "-").slice(0, 40)}.csv`;
    link.click();
  });
  nameInput.value = memory.get("robokin student") ?? "";
  progress();
  if (nameInput.value || Object.keys(mine()).length) boxes.forEach((box) => box.renew());
};

// ---- in a notebook: an anywidget; `student` comes from Python, `answer` goes back

const exerciseInNotebook = (packed, name, course, { model, el }) => {
  // each box has a script of its own, so no counter would tell two boxes of one exercise apart
  const kept = {}, id = `rk-box-${Math.random().toString(36).slice(2)}`;
  el.classList.add("rk-exercise");
  // JupyterLab takes the Enter key, which would send the form
  el.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && event.target.matches("input")) live.check();
  });
  let live;
  const start = unpacked(packed).then((exercises) => {
    const exercise = exercises[name];
    const student = () => foldedName(model.get("student"));
    const first = exercise.variants[dealtVariant(course, name, student())];
    el.innerHTML = exerciseHtml(exercise, first.shown, exercise.solution, id);
    live = bringExercise(el, {
      course,
      student,
      load: async () => exercise,
      kept: () => kept[student()],
      keep: (entry) => {
        kept[student()] = entry;
        model.set("answer", entry.answer);
        model.save_changes();
      },
    });
    return live.renew();
  });
  const follow = () => start.then(() => live.renew());
  model.on("change:student", follow);
  return () => model.off("change:student", follow);
};
