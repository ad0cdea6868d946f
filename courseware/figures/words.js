// From numbers to words.

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

// Digits after the point; -2: two digits and a power of ten.
const fixed = (number, digits) => {
  if (digits < 0 && number) {
    const [digit, power] = number.toExponential(-digits - 1).split("e");
    const raised = power.replace("+", "").replace("-", "⁻").replace(/\d/g, (d) => RAISED[d]);
    return `${trueMinus(digit)}·10${raised}`;
  }
  return trueMinus(number.toFixed(Math.max(0, digits)).replace(/^-(?=[0.]*$)/, ""));
};

const shownNumber = (readout, value) => {
  if (String(value) in readout.words) return readout.words[String(value)];
  return withUnit(fixed(value * readout.factor, readout.digits), readout.unit);
};

const shownControl = (control, shown) => control.type === "choice" ? control.options[shown].label
  : control.type === "turns" ? toldTurns(shown[0])
  : shownNumber({ words: {}, factor: 1, digits: control.digits, unit: control.unit }, shown);

// All that a figure tells: named steps, controls, readouts, each as it is in SI and as it is shown.
const told = (figure, state, { c, values }) => {
  const short = (x) => trueMinus(String(Math.abs(x) < 1e-12 ? 0 : Number(x.toPrecision(3)))); // rounding
  return [
    ...figure.steps.map((step) => {
      const text = withUnit(short(c[step.at] * step.factor), step.unit);
      return { ...step, value: c[step.at], text };
    }),
    ...figure.controls.map((control, i) =>
      ({ ...control, value: state[i] * control.factor, text: shownControl(control, state[i]) })),
    ...figure.readouts.map((readout, k) =>
      ({ ...readout, value: values[k], text: shownNumber(readout, values[k]) })),
  ];
};

// Every number that has a symbol, by its key.
const numbers = (figure, state, computed) => Object.fromEntries(
  told(figure, state, computed).filter(({ symbol }) => symbol)
    .map(({ symbol, value, text }) => [symbol, { value, text }]));

// Words about the present state: `{name}` becomes what is told under it.
const filled = (text, all) =>
  text.replace(/\{(\w+)\}/g, (_, name) => all.findLast(({ key }) => key === name).text);

const says = (figure, state, computed) => filled(figure.sentence, told(figure, state, computed));

const alternative = (figure, state, computed) =>
  `${figure.title}. ${says(figure, state, computed)}`.trim();

Object.assign(part, { numbers, settings });
