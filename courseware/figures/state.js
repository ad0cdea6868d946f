// From the state of a figure to its numbers, and where a hand may put it.

/**
 * @typedef {{ name, title, view, controls, handles, readouts, sentence, steps, recurrences, where,
 *   compute, scene, goals, size, viewAngles?, grid?, follow?, contain? }} Figure made by compiler.py
 * @typedef {{ type, key, label, unit, factor, low, high, start, step, digits, kept? }} Control in its shown unit
 * @typedef {(number | [string, number])[]} State what each control shows; of turns, see quarter_turns.js
 * @typedef {{ c: number[], trails: number[][][], values: number[], view: number[] }} Computed
 *   c: settings, last states of recurrences, named steps, which build on each other; values: those
 *   of the readouts, then those that the scene refers to by place
 */

import { functions } from "../equations/functions.js";
import { computeTurns } from "./quarter_turns.js";

export const startState = (figure) => figure.controls.map(({ kept, start }) => kept ?? start);

// For the formulas: all symbols that controls set, in SI.
export const settings = (figure, state) => figure.controls.flatMap((control, i) =>
  control.type === "choice" ? control.options[state[i]].values
    : control.type === "turns" ? computeTurns(state[i]) : [state[i] * control.factor]);

const runRecurrence = (recurrence, c) => {
  const count = Math.min(Math.max(0, Math.round(recurrence.count(functions, c)[0])), recurrence.most);
  const states = [recurrence.start(functions, c)];
  for (let i = 0; i < count; i++) states.push(recurrence.step(functions, c, states[i]));
  return states;
};

/** @type {function(Figure, number[]): Computed} */
export const compute = (figure, given) => {
  const trails = figure.recurrences.map((recurrence) => runRecurrence(recurrence, given));
  const ended = given.concat(...trails.map((states) => states[states.length - 1]));
  const c = ended.concat(figure.where(functions, ended));
  const values = figure.compute(functions, c);
  return { c, trails, values, view: findView(figure, values) };
};

// The window on the world: it fits places into it, or moves along with a point that comes near an edge.
const findView = ({ view, follow, contain }, values) => {
  if (contain) return fitView(view, contain.map((index) => values[index]));
  if (!follow) return view;
  return view.map((edge, k) => {
    const axis = k >> 1, [low, high] = view.slice(2 * axis, 2 * axis + 2), free = 0.2 * (high - low);
    const at = values[follow[axis]];
    return edge + at - Math.min(high - free, Math.max(low + free, at));
  });
};

// The form of the window stays.
const fitView = (view, at) => {
  const ends = [0, 1].map((axis) => at.filter((_, k) => k % 2 === axis)).map((all) => [Math.min(...all), Math.max(...all)]);
  const sizes = [view[1] - view[0], view[3] - view[2]];
  const times = 1.2 * Math.max(...ends.map(([low, high], axis) => (high - low) / sizes[axis]));
  return ends.flatMap(([low, high], axis) => [-1, 1].map((side) => (low + high + side * times * sizes[axis]) / 2));
};

export const clamp = (control, shown) => {
  const inside = Math.min(control.high, Math.max(control.low, shown));
  return control.whole ? Math.round(inside) : inside;
};

export const snap = (control, shown) => {
  const steps = Math.round((shown - control.low) / control.step);
  return clamp(control, Number((control.low + steps * control.step).toFixed(9)));
};

// Values that attract a hand: zero, the ends, the start, right angles, and the value of another
// control that differs only in its colour, as of the other wheel.
const listMagnets = (figure, state, i) => {
  const { kind, unit, low, high, start } = figure.controls[i];
  const right = unit === "°" ? 90 * Math.round(state[i] / 90) : 0;
  const others = state.filter((_, k) => {
    const other = figure.controls[k];
    return k !== i && kind && other.kind && unit !== "°"
      && other.unit === unit && other.low === low && other.high === high;
  });
  return [0, right, low, high, start, ...others].filter((x) => low <= x && x <= high);
};

const REACH = 0.015; // of a control's range: a magnet never draws from farther away

// Draw control i to the nearest magnet in reach.
export const attract = (figure, state, i, reach) => {
  const control = figure.controls[i], near = Math.min(reach, REACH * (control.high - control.low));
  const far = (x) => Math.abs(x - state[i]);
  const [best] = listMagnets(figure, state, i).sort((a, b) => far(a) - far(b));
  return clamp(control, far(best) <= near ? best : state[i]);
};

// Leave what is shown, so that a formula with the figure's numbers is true; a magnet's value stays.
export const roundState = (figure, state) => figure.controls.map((control, i) =>
  control.type !== "slider" || listMagnets(figure, state, i).includes(state[i]) ? state[i]
    : clamp(control, Number(state[i].toFixed(control.digits))));

// A slider that goes all the way round has no end: past it, it goes on from the other one.
export const wrapAround = ({ low, high }, shown) =>
  high - low === 360 ? shown - 360 * Math.floor((shown - low) / 360) : shown;
