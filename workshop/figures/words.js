// From numbers to words.

const fixed = (number, digits) => trueMinus(number.toFixed(digits).replace(/^-(?=[0.]*$)/, ""));

const shownNumber = (readout, value) => {
  if (String(value) in readout.words) return readout.words[String(value)];
  const number = fixed(value * readout.factor, readout.digits);
  return readout.unit === "°" ? number + "°" : readout.unit ? `${number} ${readout.unit}` : number;
};

const shownControl = (control, shown) => control.type === "choice"
  ? control.options[shown].label
  : shownNumber({ words: {}, factor: 1, digits: control.digits, unit: control.unit }, shown);

// Every number that has a symbol, by its key: what it is in SI, and as it is shown.
const numbers = (figure, state, { c, values }) => {
  const found = {};
  const add = ({ symbol }, value, text) => { if (symbol) found[symbol] = { value, text }; };
  figure.steps.forEach((step) => {
    const short = trueMinus(String(Number((c[step.at] * step.factor).toPrecision(3))));
    add(step, c[step.at], step.unit === "°" ? `${short}°` : `${short} ${step.unit}`.trim());
  });
  figure.controls.forEach((control, i) => {
    if (control.type !== "choice") add(control, state[i] * control.factor, shownControl(control, state[i]));
  });
  figure.readouts.forEach((readout, k) => add(readout, values[k], shownNumber(readout, values[k])));
  return found;
};

// The sentence about the present state.
const says = (figure, state, values) => figure.says.replace(/\{(\w+)\}/g, (_, key) => {
  const i = figure.controls.findIndex((control) => control.key === key);
  if (i >= 0) return shownControl(figure.controls[i], state[i]);
  const k = figure.readouts.findIndex((readout) => readout.key === key);
  return shownNumber(figure.readouts[k], values[k]);
});

const alternative = (figure, state, values) => `${figure.title}. ${says(figure, state, values)}`;

Object.assign(part, { numbers, settings });
