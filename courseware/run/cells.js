// The cells of a page once Run is pressed: they can be changed, run in order, and put back.
//
// A cell runs after those above it that have not run since the last change above them. Python runs
// in a worker, which alone can be stopped in an endless loop; then all is forgotten and starts anew.

const BLOCK = `<div class="output text_plain highlight-myst-ansi notranslate">`
  + `<div class="highlight"><pre></pre></div></div>`;

let cells, settings, worker, ready, running = null, stop;

// keep: what keeps a change of a cell in the browser.
class Cell {
  constructor(bar, k, keep) {
    Object.assign(this, { bar, k, keep, input: bar.parentElement, ran: null, fresh: null });
    const tags = [...this.input.parentElement.classList].map((name) => name.replace("tag_", ""));
    this.program = tags.find((tag) => tag.startsWith("program-"))?.slice(8);
    this.mayFail = this.program || tags.includes("raises-exception"); // no other cell needs it
    [this.button, this.status] = [bar.firstChild, bar.lastChild];
    this.word = this.button.textContent;
    this.code = this.input.querySelector("pre");
    this.original = this.text;
    this.outputs = this.input.closest(".cell").querySelectorAll(".cell_output, .below-input");
    this.button.insertAdjacentHTML("afterend", `<button type="button" hidden>Reset</button>`);
    this.reset = this.button.nextSibling;
    this.reset.addEventListener("click", () => this.restore());
    this.button.ariaLabel = `${this.word} cell ${k + 1}`;
    this.reset.ariaLabel = `Reset cell ${k + 1}`;
  }

  get text() { return this.editor?.text ?? this.code.textContent.replace(/\n$/, ""); }

  say(text) { this.status.textContent = text; }

  // The editor takes the place of the code once the reader is in it.
  makeEditable() {
    this.code.tabIndex = 0;
    let point;
    this.code.addEventListener("mousedown", ({ x, y }) => { point = { x, y }; });
    this.code.addEventListener("focus", async () => { (await this.edit()).focus(point); });
  }

  async edit() {
    const [{ createEditor }, parts] = await Promise.all(
      [`editor.js${new URL(import.meta.url).search}`, settings.editor].map((name) => import(new URL(name, import.meta.url))));
    this.editor ??= createEditor(parts, {
      parent: this.code.parentElement,
      text: this.text,
      label: `Code of cell ${this.k + 1}`,
      onChange: () => this.noteChange(),
      onRun: () => { if (!this.button.disabled && running === null) this.button.click(); },
    });
    this.code.hidden = true;
    this.input.querySelector(".copybtn")?.remove(); // it copies what was there
    return this.editor;
  }

  noteChange() {
    this.reset.hidden = false;
    const text = this.text === this.original ? undefined : this.text;
    this.keep(this.k, { first: this.code.textContent, text });
  }

  // Run, or Stop.
  press() { return running === this.k ? stop() : runThrough(this.k); }

  async bringBack({ text }) {
    (await this.edit()).text = text;
    this.button.focus();
  }

  begin() {
    this.fresh?.remove();
    this.outputs.forEach((output) => { output.hidden = true; });
    this.fresh = document.createElement("div");
    this.fresh.className = "cell_output docutils container rk-fresh";
    this.input.after(this.fresh);
    this.reset.hidden = false;
  }

  async showAnswer(numbers) {
    const out = this.fresh, { default: figure } = await import(`../programs/${this.program}.js`);
    out.insertAdjacentHTML("beforeend", globalThis.courseware.renderAnswer(figure, numbers));
  }

  show(kind, text) {
    const out = this.fresh;
    if (kind === "answer") return this.showAnswer(JSON.parse(text));
    if (kind === "text/html" || kind === "image/svg+xml") {
      out.insertAdjacentHTML("beforeend", `<div class="output">${text}</div>`);
    } else if (kind === "image/png") {
      const picture = Object.assign(new Image(), { src: `data:image/png;base64,${text}` });
      const before = [...this.outputs].map((output) => output.querySelector("img")).find(Boolean);
      picture.alt = before?.alt ?? "The picture that this cell has drawn";
      picture.onload = () => { picture.style.width = `${picture.naturalWidth / 2}px`; };
      out.append(picture);
    } else {
      if (out.lastChild?.dataset?.kind !== kind || !kind.startsWith("std")) {
        out.insertAdjacentHTML("beforeend", BLOCK);
        out.lastChild.dataset.kind = kind;
        out.lastChild.classList.toggle("rk-failed", kind === "error");
      }
      out.lastChild.querySelector("pre").append(text);
    }
  }

  restore() {
    if (this.editor) this.editor.text = this.original;
    this.fresh?.remove();
    this.outputs.forEach((output) => { output.hidden = false; });
    this.ran = this.fresh = null;
    this.reset.hidden = true;
    this.say("");
    this.button.focus();
  }
}

const describeSource = () => {
  const { origin, host } = new URL(settings.python, import.meta.url);
  return origin === location.origin ? "this site" : host;
};

const startWorker = () => {
  worker = new Worker(new URL(`worker.js${new URL(import.meta.url).search}`, import.meta.url),
    { type: "module" });
  ready = waitForWorker();
  ready.catch(() => {}); // handled where it is awaited
  const whole = (address) => address && new URL(address, import.meta.url).href;
  worker.postMessage({ settings: {
    python: whole(settings.python), katex: whole(settings.katex), cells: whole(settings.cells),
    wheels: settings.wheels.map(whole),
  } });
};

const stopWorker = () => {
  worker?.terminate();
  worker = null;
  cells.forEach((cell) => { cell.ran = null; });
};

// The end of what the worker does now; meanwhile outputs and progress are shown.
const waitForWorker = () => new Promise((resolve, reject) => {
  const on = ({ data }) => {
    if (data.kind) return cells[data.cell].show(data.kind, data.text);
    if (data.loading) {
      const [what, size] = data.loading;
      cells[running]?.say(`Loading ${what}${size ? `, about ${size} MB,` : ""} from ${describeSource()} …`);
    } else if (data.failed) reject(new Error(data.failed));
    else resolve(data);
  };
  worker.onmessage = on;
  worker.onerror = () => reject(new Error("its worker does not start"));
  stop = () => reject(null);
});

const updateButtons = () => cells.forEach((cell, k) => {
  cell.button.textContent = running === k ? "Stop" : cell.word;
  cell.button.disabled = cell.reset.disabled = running !== null && running !== k;
});

const fetchText = async (name) => {
  const answer = await fetch(new URL(name, import.meta.url), { cache: "no-cache" });
  if (!answer.ok) throw new Error(`${name} answers ${answer.status}`);
  return answer.text();
};

const runCell = async (cell) => {
  cell.begin();
  cell.ran = cell.text;
  cells.slice(cell.k + 1).forEach((below) => { below.ran = null; });
  const end = waitForWorker(), { k, program } = cell;
  const stored = program && await fetchText(`../programs/${program}.json`);
  worker.postMessage({ cell: k, source: cell.ran, name: `cell ${k + 1}`, stored });
  const { ended } = await end;
  if (!ended) cell.ran = null;
  return ended;
};

const runThrough = async (k) => {
  const cell = cells[k];
  running = k;
  updateButtons();
  try {
    if (!worker) startWorker();
    await ready;
    for (const each of cells.slice(0, k + 1)) {
      if (each !== cell && (cell.program || each.ran === each.text || each.mayFail)) continue;
      cell.say(each === cell ? "Running …" : `Running cell ${each.k + 1}, above, first …`);
      const ended = await runCell(each);
      cell.say(ended || each === cell ? "" : `Cell ${each.k + 1}, above, stops with an error.`);
      if (!ended) break;
    }
    if (cell.program) cell.fresh.scrollIntoView({ block: "nearest" });
  } catch (error) {
    const begun = ready && await ready.then(() => true, () => false);
    stopWorker();
    cell.say(!error ? "Stopped. Python has forgotten all names; Run starts it anew."
      : `Python cannot be loaded from ${describeSource()}: ${error.message}. `
        + "The network here may block it. The stored results stand; Run tries again.");
    if (error && begun) cell.say(`Python has stopped: ${error.message}. Run starts it anew.`);
  } finally {
    running = null;
    updateButtons();
    cell.bar.dispatchEvent(new Event("courseware:ran"));
  }
};

// The cell k of the page, when the reader first presses Run, writes or wants a change back.
export const openCell = async (bars, k, keep) => {
  settings ??= JSON.parse(await fetchText(`settings.json${new URL(import.meta.url).search}`));
  if (!cells) {
    cells = bars.map((bar, place) => new Cell(bar, place, keep));
    cells.forEach((cell) => cell.makeEditable());
  }
  return cells[k];
};
