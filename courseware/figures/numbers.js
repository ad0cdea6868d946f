// A figure is one pure function from a state to text (SVG and HTML), and the hands that move the
// state. It draws what the declaration says and knows no robot. Here: from a state to numbers.
//
// figure: { name, title, view, controls, handles, readouts, sentence, steps, recurrences, where, compute,
// scene, goals, size, viewAngles?, grid?, follow? }, made by compiling.py. state: what each control shows, in its shown unit.

const startState = (figure) => figure.controls.map((control) => control.start);

// What the formulas get: all symbols that controls set, in SI.
const settings = (figure, state) => figure.controls.flatMap((control, i) =>
  control.type === "choice" ? control.options[state[i]].values
    : control.type === "turns" ? turnNumbers(state[i]) : [state[i] * control.factor]);

const statesOf = (recurrence, c) => {
  const count = Math.min(Math.max(0, Math.round(recurrence.count(f, c)[0])), recurrence.most);
  const states = [recurrence.start(f, c)];
  for (let i = 0; i < count; i++) states.push(recurrence.step(f, c, states[i]));
  return states;
};

// A figure's numbers build on each other: settings, last states of its loops, named steps.
// All numbers of the figure at once: readouts first, then what the scene refers to by index.
const compute = (figure, given) => {
  const trails = figure.recurrences.map((recurrence) => statesOf(recurrence, given));
  const ended = given.concat(...trails.map((states) => states[states.length - 1]));
  const c = ended.concat(figure.where(f, ended));
  const values = figure.compute(f, c);
  return { c, trails, values, view: viewOf(figure, values) };
};

// The window on the world: it moves along with a point, once that comes near an edge.
const viewOf = ({ view, follow }, values) => {
  if (!follow) return view;
  return view.map((edge, k) => {
    const axis = k >> 1, [low, high] = view.slice(2 * axis, 2 * axis + 2), free = 0.2 * (high - low);
    const at = values[follow[axis]];
    return edge + at - Math.min(high - free, Math.max(low + free, at));
  });
};

const clamp = (control, shown) => {
  const inside = Math.min(control.high, Math.max(control.low, shown));
  return control.whole ? Math.round(inside) : inside;
};

const snap = (control, shown) => {
  const steps = Math.round((shown - control.low) / control.step);
  return clamp(control, Number((control.low + steps * control.step).toFixed(9)));
};

// What a hand looks for: zero, the ends, the start, right angles, and the value of another control
// that differs in nothing but its colour, as of the other wheel.
const magnets = (figure, state, i) => {
  const { kind, unit, low, high, start } = figure.controls[i];
  const quarter = unit === "°" ? 90 * Math.round(state[i] / 90) : 0;
  const others = state.filter((_, k) => {
    const other = figure.controls[k];
    return k !== i && kind && other.kind && unit !== "°"
      && other.unit === unit && other.low === low && other.high === high;
  });
  return [0, quarter, low, high, start, ...others].filter((x) => low <= x && x <= high);
};

const REACH = 0.015; // of a control's range: a magnet never draws from farther away

// The state after a hand has moved control i, who draws it to the nearest magnet in reach.
const attracted = (figure, state, i, reach) => {
  const control = figure.controls[i], near = Math.min(reach, REACH * (control.high - control.low));
  const far = (x) => Math.abs(x - state[i]);
  const [best] = magnets(figure, state, i).sort((a, b) => far(a) - far(b));
  return clamp(control, far(best) <= near ? best : state[i]);
};

// What a hand leaves is what is shown of it, so that a formula with the figure's numbers is true; a
// special value stays.
const asShown = (figure, state) => figure.controls.map((control, i) =>
  control.type !== "slider" || magnets(figure, state, i).includes(state[i]) ? state[i]
    : clamp(control, Number(state[i].toFixed(control.digits))));

// A slider that goes all the way round has no end: past it, it goes on from the other one.
const allRound = ({ low, high }, shown) =>
  high - low === 360 ? shown - 360 * Math.floor((shown - low) / 360) : shown;

Object.assign(part, { f, startState, compute });
