// The numbers of a figure as text.

import { fillTemplate, formatNumber, trueMinus, withUnit } from "../units/text.js";
import { describeTurns } from "./quarter_turns.js";

// Digits after the point; -2: two digits and a power of ten.
export const formatFixed = (number, digits) => {
  if (digits < 0 && number) {
    const [digit, power] = number.toExponential(-digits - 1).split("e");
    const raised = power.replace("+", "").replace("-", "⁻").replace(/\d/g, (d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]);
    return `${trueMinus(digit)}·10${raised}`;
  }
  return trueMinus(number.toFixed(Math.max(0, digits)).replace(/^-(?=[0.]*$)/, ""));
};

export const formatReadout = (readout, value) => {
  if (String(value) in readout.words) return readout.words[String(value)];
  return withUnit(formatFixed(value * readout.factor, readout.digits), readout.unit);
};

export const formatControl = (control, shown) => control.type === "choice" ? control.options[shown].label
  : control.type === "turns" ? describeTurns(shown[0])
  : formatReadout({ words: {}, factor: 1, digits: control.digits, unit: control.unit }, shown);

// Named steps, controls and readouts, each as it is in SI and as it is shown; once for a frame.
const listQuantities = (figure, state, computed) => computed.quantities ??= [
  ...figure.steps.map((step) => {
    const value = computed.c[step.at], shown = value * step.factor;
    const text = formatNumber(Math.abs(shown) < 1e-12 ? 0 : shown, 3); // rounding
    return { ...step, value, text: withUnit(text, step.unit) };
  }),
  ...figure.controls.map((control, i) =>
    ({ ...control, value: state[i] * control.factor, text: formatControl(control, state[i]) })),
  ...figure.readouts.map((readout, k) =>
    ({ ...readout, value: computed.values[k], text: formatReadout(readout, computed.values[k]) })),
];

export const numbersBySymbol = (figure, state, computed) => Object.fromEntries(
  listQuantities(figure, state, computed).filter(({ symbol }) => symbol)
    .map(({ symbol, value, text }) => [symbol, { value, text }]));

// The texts of all quantities, for the placeholders of sentences and labels.
export const textsByKey = (figure, state, computed) => Object.fromEntries(
  listQuantities(figure, state, computed).map(({ key, text }) => [key, text]));

export const describeState = (figure, state, computed) =>
  fillTemplate(figure.sentence, textsByKey(figure, state, computed));

export const describeFigure = (figure, state, computed) =>
  `${figure.title}. ${describeState(figure, state, computed)}`.trim();
