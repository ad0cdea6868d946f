// From numbers to words.

const fixed = (number, digits) => trueMinus(number.toFixed(digits).replace(/^-(?=[0.]*$)/, ""));

const shownNumber = (readout, value) => {
  if (String(value) in readout.words) return readout.words[String(value)];
  const number = fixed(value * readout.factor, readout.digits);
  return readout.unit === "°" ? number + "°" : readout.unit ? `${number} ${readout.unit}` : number;
};

const shownControl = (control, shown) => control.type === "choice" ? control.options[shown].label
  : control.type === "turns" ? toldTurns(shown[0])
  : shownNumber({ words: {}, factor: 1, digits: control.digits, unit: control.unit }, shown);

// The sentence about the present state.
const says = (figure, state, values) => figure.says.replace(/\{(\w+)\}/g, (_, key) => {
  const i = figure.controls.findIndex((control) => control.key === key);
  if (i >= 0) return shownControl(figure.controls[i], state[i]);
  const k = figure.readouts.findIndex((readout) => readout.key === key);
  return shownNumber(figure.readouts[k], values[k]);
});

const alternative = (figure, state, values) => `${figure.title}. ${says(figure, state, values)}`;
