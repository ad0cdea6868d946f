import { writeText } from "../units/text.js";
import { followButtons, followClock, followSight, followTurns } from "./clock.js";
import { addHandles, describeHandle, followControls, followGround, followReset, followSteps, placeHandles } from "./dragging.js";
import { describeFigure, describeState, formatControl, formatReadout, numbersBySymbol } from "./figure_text.js";
import { setAttribute, updateNodes } from "./nodes.js";
import { heightOf, renderScene, widthOf } from "./scene.js";
import { compute, settings, startState } from "./state.js";
import { px } from "./svg.js";

// Between two steps of a slider the browser would show the nearer one.
const showPosition = (input, control, shown) => {
  if (input.type === "radio") return void (input.checked = Number(input.value) === shown);
  for (const step of [control.step, "any"]) {
    if (Math.abs(Number(input.value) - shown) < 1e-9) return;
    Object.assign(input, { step, value: shown });
  }
};

const TRACKS = {}; // by name

/** A figure that can be moved, in an element that holds its HTML. */
export class LiveFigure {
  constructor(element, figure, changed = () => {}) {
    Object.assign(this, { element, figure, changed });
    this.picture = element.querySelector(".rk-picture > svg");
    this.drawing = this.picture.querySelector("[role=img]");
    this.nodes = ""; // what is drawn
    this.inputs = this.all(":is(input, select)[data-i]");
    this.outputs = this.all("[data-o]");
    this.readouts = this.all("dd");
    this.goals = this.all(".rk-goal");
    for (const shape of figure.shapes) if (shape.shape === "track") shape.past = TRACKS[shape.name || figure.name] ??= [];
    this.state = startState(figure);
    this.width = widthOf(figure);
    this.drawn = this.told = this.tick = 0; // what is waited for: requests and a timer
    this.reached = new Set(); // goals, until a reset
    this.handles = [];
    this.held = this.last = null; // what a pointer moves now, and the handle that it moved last
  }

  all(selector) { return [...this.element.querySelectorAll(selector)]; }

  start() {
    addHandles(this);
    for (const follow of [followControls, followSteps, followTurns, followButtons, followClock, followGround, followReset,
      followSight]) follow(this);
    this.resize(this.picture.parentElement.clientWidth);
    new ResizeObserver(([{ contentRect: { width } }]) => {
      if (Math.round(width) !== this.width) this.resize(width);
    }).observe(this.picture.parentElement);
    this.element.classList.add("rk-live");
    return this;
  }

  set(state) {
    this.state = state;
    this.changed(state);
    this.drawn ||= requestAnimationFrame(() => this.draw());
  }

  setOne(i, shown) {
    this.set(this.state.map((old, k) => (k === i ? shown : old)));
  }

  // Draws now what waits to be drawn.
  settled() {
    if (!this.drawn) return;
    cancelAnimationFrame(this.drawn);
    this.draw();
  }

  numbers() {
    this.settled();
    return numbersBySymbol(this.figure, this.state, this.computed);
  }

  place(handle) { return handle.at.map((index) => this.computed.values[index]); }

  resize(width) {
    this.width = Math.max(240, Math.round(width || this.width));
    const height = heightOf(this.figure, this.width);
    const size = { width: this.width, height, viewBox: `0 0 ${this.width} ${height}` };
    Object.entries(size).forEach((attribute) => this.picture.setAttribute(...attribute));
    this.draw();
  }

  draw() {
    this.drawn = 0;
    this.computed = compute(this.figure, settings(this.figure, this.state));
    if (this.held?.view) this.computed.view = this.held.view; // a view that follows waits for a hand
    const nodes = renderScene(this.figure, this.computed, this.width, this.state);
    updateNodes(this.drawing, nodes, this.nodes);
    this.nodes = nodes;
    this.drawHandles();
    this.writeGoals();
    this.writeReadouts();
    this.writeControls();
    this.element.dispatchEvent(new CustomEvent("courseware:drawn", {
      bubbles: true, detail: { name: this.figure.name, numbers: this.numbers() },
    }));
    clearTimeout(this.told);
    this.told = setTimeout(() => this.tell(), 400);
  }

  drawHandles() {
    placeHandles(this).forEach(([x, y], k) => {
      describeHandle(this, this.figure.handles[k], this.handles[k]);
      for (const part of [this.handles[k], this.handles[k].nextSibling]) {
        setAttribute(part, "cx", px(x));
        setAttribute(part, "cy", px(y));
        setAttribute(part, "visibility", x < 0 ? "hidden" : "inherit"); // what is nowhere has no focus
      }
    });
  }

  writeReadouts() {
    this.readouts.forEach((element, k) =>
      writeText(element, formatReadout(this.figure.readouts[k], this.computed.values[k])));
  }

  writeControls() {
    const shown = (i) => formatControl(this.figure.controls[i], this.state[i]);
    this.inputs.forEach((input) => {
      showPosition(input, this.figure.controls[input.dataset.i], this.state[input.dataset.i]);
      if (input.type === "range") setAttribute(input, "aria-valuetext", shown(input.dataset.i));
      input.closest(".rk-control").hidden = this.computed.values[this.figure.controls[input.dataset.i].shown] === 0;
    });
    this.outputs.forEach((output) => writeText(output, shown(output.dataset.o)));
  }

  // Passing over a goal does not reach it; once reached it stays so until a reset.
  writeGoals() {
    const now = this.figure.goals.map(({ at }) => this.computed.values[at] === 1);
    if (!this.held && !this.passing) now.forEach((isReached, k) => { if (isReached) this.reached.add(k); });
    this.element.classList.toggle("rk-reached", now.some((isReached, k) => isReached && this.reached.has(k)));
    this.goals.forEach((goal, k) => {
      const done = this.reached.has(k);
      if (goal.classList.contains("rk-done") === done) return;
      goal.classList.toggle("rk-done", done);
      goal.querySelector("output").textContent = done ? "reached" : "";
    });
  }

  tell() {
    const { element, figure, state, computed } = this;
    this.drawing.setAttribute("aria-label", describeFigure(figure, state, computed));
    if (!this.inputs.length || !element.contains(document.activeElement)) return;
    element.querySelector(".rk-says").textContent = describeState(figure, state, computed);
  }
}
