// Moving a figure by hand: its controls, its handles, the ground of a picture in space.

import { functions } from "../equations/functions.js";
import { escapeHtml } from "../units/text.js";
import { pauseClock, stopClock } from "./clock.js";
import { formatControl } from "./figure_text.js";
import { createProjection, heightOf } from "./scene.js";
import { attract, clamp, compute, roundState, settings, snap, startState, wrapAround } from "./state.js";
import { color } from "./svg.js";

export const followControls = (live) => live.inputs.forEach((input) => {
  const inSteps = () => { input.step = live.figure.controls[input.dataset.i].step; };
  input.addEventListener("pointerdown", (event) => {
    inSteps();
    if (event.button > 0 || input.type !== "range") return;
    // no capture of the pointer: with it, WebKit would not move the thumb
    live.held = { by: input, state: live.state };
    addEventListener("pointerup", () => release(live, input), { once: true });
  });
  followRelease(live, input);
  input.addEventListener("keydown", (event) => { if (/^(Arrow|Page|Home|End)/.test(event.key)) inSteps(); });
  input.addEventListener("input", () => {
    stopClock(live, Number(input.dataset.i));
    live.setOne(Number(input.dataset.i), Number(input.value));
  });
});

export const followSteps = (live) => live.all(".rk-step").forEach((button) => {
  const i = Number(button.dataset.i), control = live.figure.controls[i];
  button.addEventListener("click", () => {
    stopClock(live, i);
    live.setOne(i, snap(control, wrapAround(control, live.state[i] + button.dataset.sign * control.step)));
  });
});

export const followReset = (live) => live.element.querySelector(".rk-reset")
  ?.addEventListener("click", () => {
    pauseClock(live);
    live.reached.clear();
    live.figure.shapes.forEach(({ past }) => past?.splice(0));
    live.set(startState(live.figure));
    live.resumeClock?.();
  });

// ---- handles: a pointer in world coordinates becomes settings of the controls

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
const MAGNET = 6; // pixels: from so near a special value draws the hand to it

// For screen readers a slider in two directions, with the number of the first control it sets.
const renderHandle = (handle, { kind }) =>
  `<circle r="17" tabindex="0" role="slider" aria-roledescription="draggable point" `
  + `aria-label="${escapeHtml(handle.label)}: drag, or move with the arrow keys"/>`
  + `<ellipse rx="9" ry="9"${kind ? ` style="--ring:${color(kind)}"` : ""}/>`;

export const describeHandle = (live, { sets }, grip) => {
  const { controls } = live.figure, [first] = sets, { low, high } = controls[first];
  const all = sets.map((i) => `${controls[i].label} ${formatControl(controls[i], live.state[i])}`);
  Object.assign(grip, { ariaValueMin: low, ariaValueMax: high, ariaValueNow: live.state[first],
    ariaValueText: all.join(", ") });
};

export const addHandles = (live) => {
  const { figure, picture } = live, grips = figure.handles.map((handle) => renderHandle(handle, figure.controls[handle.sets[0]])).join("");
  picture.insertAdjacentHTML("beforeend", `<g class="rk-handles">${grips}</g>`);
  live.handles = live.all(".rk-handles circle");
  figure.handles.forEach((handle, k) => {
    followPointer(live, live.handles[k]);
    followArrows(live, handle, live.handles[k]);
  });
};

const ASIDE = [[0, 0], [0, -22], [22, 0], [0, 22], [-22, 0]];

// Where the handles are drawn, in pixels: inside the picture, none under another nor under the button
// in the corner. The one that was taken last keeps its place, others give way.
export const placeHandles = (live) => {
  const to = createProjection(live.computed.view, live.width), margin = 10, found = [];
  const high = heightOf(live.figure, live.width);
  const inside = (x, end) => Math.min(end - margin, Math.max(margin, x));
  const free = ([x, y]) => found.every(([a, b]) => Math.hypot(x - a, y - b) > 18);
  const seen = (x, y) => { // the shorter way out of the corner: a phone's button is 40 pixels wide
    const [left, down] = [x - live.width + 48, 48 - y];
    return Math.min(left, down) < 0 ? [x, y] : left < down ? [x - left, y] : [x, y + down];
  };
  const order = [...live.handles.keys()].sort((a, b) => (b === live.last) - (a === live.last));
  for (const k of order) {
    const [at, up] = to(live.place(live.figure.handles[k]));
    const [x, y] = [inside(at, live.width), inside(up, high)];
    const tried = ASIDE.map(([dx, dy]) => seen(inside(x + dx, live.width), inside(y + dy, high)));
    found[k] = Number.isFinite(at + up) ? tried.find(free) ?? tried[0] : [-99, -99];
  }
  return found;
};

const locatePointer = ({ picture, computed: { view } }, event) => {
  const box = picture.getBoundingClientRect();
  return [view[0] + (event.clientX - box.left) / box.width * (view[1] - view[0]),
    view[3] - (event.clientY - box.top) / box.height * (view[3] - view[2])];
};

// How far a few pixels move what a handle sets.
const findReaches = (live, handle, given, [x, y], next) => {
  const { view } = live.computed, by = MAGNET * (view[1] - view[0]) / live.width;
  const [across, up] = [[x + by, y], [x, y + by]].map((point) => handle.to(functions, given, point));
  return next.map((value, k) => Math.hypot(across[k] - value, up[k] - value));
};

const dragTo = (live, handle, point, byHand) => {
  const { figure } = live, placed = live.state.slice();
  const given = compute(figure, settings(figure, live.state)).c;
  const next = handle.to(functions, given, point), reach = findReaches(live, handle, given, point, next);
  handle.sets.forEach((i, k) => {
    const control = figure.controls[i];
    if (!Number.isFinite(next[k])) return;
    placed[i] = clamp(control, next[k] / control.factor);
    if (byHand) placed[i] = attract(figure, placed, i, reach[k] / control.factor);
  });
  handle.sets.forEach((i) => stopClock(live, i));
  live.set(placed);
};

// Where targets overlap, the handle that is nearest to the pointer is meant.
const findNearestHandle = (live, event) => {
  const far = (grip) => {
    const { left, right, top, bottom } = grip.getBoundingClientRect();
    return Math.hypot((left + right) / 2 - event.clientX, (top + bottom) / 2 - event.clientY);
  };
  return live.handles.reduce((best, grip) => (far(grip) < far(best) ? grip : best));
};

const followPointer = (live, grip) => {
  grip.addEventListener("pointerdown", (event) => {
    if (event.button > 0) return;
    event.preventDefault();
    live.settled();
    const taken = findNearestHandle(live, event), k = live.handles.indexOf(taken), at = locatePointer(live, event);
    // a handle taken at its edge must not jump to the pointer
    const off = live.place(live.figure.handles[k])
      .map((x, i) => (Number.isFinite(x) ? x - at[i] : 0));
    live.held = { by: taken, k, off, state: live.state, view: live.computed.view };
    live.last = k;
    taken.setPointerCapture(event.pointerId);
    taken.classList.add("rk-taken"); // without the ring of the keyboard, which would hide its label
    taken.focus({ preventScroll: true });
  });
  // in SVG, `touch-action` alone lets the page scroll away with the finger
  grip.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  grip.addEventListener("pointermove", (event) => {
    if (live.held?.by !== grip) return;
    const { k, off } = live.held;
    dragTo(live, live.figure.handles[k], locatePointer(live, event).map((x, i) => x + off[i]), true);
  });
  grip.addEventListener("blur", () => grip.classList.remove("rk-taken"));
  followRelease(live, grip);
};

const release = (live, element) => {
  if (live.held?.by !== element) return;
  live.held = null;
  live.set(roundState(live.figure, live.state));
};

// Undo a drag that the system cuts short, as by a call.
const followRelease = (live, element, undone = ({ state }) => state) => {
  element.addEventListener("pointercancel", () => {
    if (live.held?.by !== element) return;
    live.set(undone(live.held));
    live.held = null;
  });
  element.addEventListener("lostpointercapture", () => release(live, element));
};

const followArrows = (live, handle, grip) => {
  grip.addEventListener("keydown", (event) => {
    grip.classList.remove("rk-taken");
    const move = ARROWS[event.key], { view } = live.figure;
    if (!move) return;
    event.preventDefault();
    const step = (view[1] - view[0]) / (event.shiftKey ? 20 : 100);
    dragTo(live, handle, live.place(handle).map((x, i) => x + step * move[i]), false);
  });
  grip.addEventListener("keyup", ({ key }) => {
    if (ARROWS[key]) live.set(roundState(live.figure, live.state));
  });
};

// ---- the ground: dragging it turns the view, by half a turn across the picture

// Other controls go on moving meanwhile.
const turnView = (live, held, event) => {
  const { figure, picture } = live, next = live.state.slice();
  const moved = [held.x - event.clientX, event.clientY - held.y];
  const pixelTurns = 180 / picture.getBoundingClientRect().width;
  figure.viewAngles.forEach((i, k) => {
    next[i] = wrapAround(figure.controls[i], held.state[i] + pixelTurns * moved[k]);
    next[i] = attract(figure, next, i, MAGNET * pixelTurns);
  });
  return next;
};

const UNDECIDED = 10; // pixels: so far a finger may still mean to scroll the page

export const followGround = (live) => {
  if (!live.figure.viewAngles) return;
  const { element, picture } = live;
  element.classList.add("rk-turns");
  picture.addEventListener("pointerdown", (event) => {
    if (live.handles.includes(event.target) || event.button > 0) return;
    picture.setPointerCapture(event.pointerId);
    event.preventDefault();
    const waits = event.pointerType === "touch";
    live.held = { by: picture, x: event.clientX, y: event.clientY, state: live.state, waits };
  });
  picture.addEventListener("pointermove", (event) => {
    const { held } = live;
    if (held?.by !== picture) return;
    const across = Math.abs(event.clientX - held.x), along = Math.abs(event.clientY - held.y);
    held.waits &&= across < UNDECIDED || across < along;
    if (!held.waits) live.set(turnView(live, held, event));
  });
  followRelease(live, picture, ({ state }) =>
    live.state.map((now, i) => (live.figure.viewAngles.includes(i) ? state[i] : now)));
};
