// Is an answer right, and if not, which mistake does it look like? The one judge: of the page, of
// notebooks and of `grade`.

/**
 * @typedef {[string, number[][]]} Candidate name and rows of a possible answer, but not of right
 *   answers in other units
 * @typedef {{ prompt, unknowns, shape, accept, outcomes }} Judged exercise, as judging.py gives it
 */

import { fillTemplate, formatNumber } from "../units/text.js";
import { listUnits, parseTyped } from "./parsing.js";
import { PROBLEMS } from "./problems.js";

export const NEAR = 10; // tolerances: so close is probably rounding on the way
export const FEEDBACK = {
  near: "Not yet, but very close. Keep all digits on the way{digits}.",
  wrong: "Not yet, and none of the mistakes known here gives this.",
  parts: "Already right: {labels}.",
  shape: "Asked is {prompt}. Write it like {like}. This was read as {read}.",
  readings: "This can be read in two ways. Write decimals with a point, and nothing between thousands.",
  other: "There are other right answers too.",
  digits: "Give {decimals} decimals: with fewer the check cannot tell what went wrong.",
  units: "And it is in other units ({unit}).",
  whole: "Asked is a whole number.",
};
const COUNTS = ["no", "one", "two", "three", "four", "five"];

const offBy = (unknown, x, wanted, factor) => {
  if (!unknown.circle) return Math.abs(x - wanted);
  const turn = 2 * Math.PI * Math.abs(factor), off = Math.abs(x - wanted) % turn;
  return Math.min(off, turn - off);
};

// How far off an answer may be from what is wanted, in a unit of this size.
const toleranceOf = ({ tolerance, relative }, wanted, factor) =>
  Math.max(tolerance * Math.abs(factor), relative * Math.abs(wanted));

// Whether each row is one of the wanted ones, each of them once. allowed: in tolerances.
const matchesRows = ({ unknowns }, rows, wanted, factors, allowed = 1) => {
  const left = wanted.slice();
  const fits = (x, i, other) => offBy(unknowns[i], x, other[i], factors[i])
    <= allowed * toleranceOf(unknowns[i], other[i], factors[i]);
  return rows.every((row) => {
    const place = left.findIndex((other) => row.every((x, i) => fits(x, i, other)));
    if (place >= 0) left.splice(place, 1);
    return place >= 0;
  }) && !left.length;
};

const convertRows = (rows, factors) => rows.map((row) => row.map((x, i) => x * factors[i]));

const findRightParts = ({ accept, shape, unknowns }, right, row) =>
  accept !== "one" || shape.length ? [] : unknowns.filter((unknown, i) =>
    offBy(unknown, row[i], right[i], 1) <= toleranceOf(unknown, right[i], 1)).map((unknown) => unknown.label);

const NAMED = "Not yet. This is what you get ";
// Several mistakes may give one number: then all of them are said.
const joinFeedback = (all) => all.join(" ").replaceAll(`. ${NAMED}`, ", or ");

const isRoundedRight = ({ decimals }, rows, wanted) =>
  [2, 3].some((digits) => digits < decimals && rows.length === wanted.length && rows.every((row, k) =>
    row.every((x, i) => Math.abs(x - Number(wanted[k][i].toFixed(digits))) < 1e-9)));

// Whether it is a right one in other units, rounded to two digits or three: 31° for 30.53°, also
// without the sign.
const isRoundedInUnits = (factors, rows, wanted) => [factors, factors.map(() => 1)].some((typed) =>
  [0, 1].some((digits) => rows.length === wanted.length && rows.every((row, k) => row.every((x, i) => {
    const right = wanted[k][i] * factors[i], off = x * typed[i] - Number(right.toFixed(digits));
    return Math.abs(right) >= 10 ** (1 - digits) && Math.abs(off) < 1e-9;
  }))));

const isRounded = (rows, digits) => rows.flat().every((x) => Math.abs(x - Number(x.toFixed(digits))) < 1e-9);

const hasFewDecimals = ({ decimals }, text) => decimals && !RegExp(`[^\\p{Nd}\\s-]\\p{Nd}{${decimals}}`, "u").test(text);

const isTooCoarse = (exercise, rows, text, right) => hasFewDecimals(exercise, text)
  && isRounded(rows, exercise.decimals - 1) && !isRounded(right, exercise.decimals - 1);

// The mistake that an answer is in other units, and these; nothing if there is none.
const findInUnits = (exercise, candidates, units, rows) => units.flatMap((unit) => {
  const { factors } = exercise.outcomes[unit];
  return candidates.filter(([name, wanted]) =>
    name !== "right" && matchesRows(exercise, rows, convertRows(wanted, factors), factors))
    .map(([name]) => [name, unit.slice(5)]);
})[0] ?? [];

// The verdict on an answer that has the right shape. text: as it was typed.
const judgeRows = (exercise, candidates, rows, text) => {
  const { unknowns, accept, outcomes, decimals } = exercise;
  const right = candidates.filter(([name]) => name === "right").map(([, wanted]) => wanted);
  const units = Object.keys(outcomes).filter((name) => name.startsWith("unit:"));
  const inUnits = units.flatMap((unit) => right.map((wanted) => [unit, convertRows(wanted, outcomes[unit].factors)]));
  const met = [...candidates, ...inUnits].filter(([name, wanted]) =>
    matchesRows(exercise, rows, wanted, outcomes[name].factors)).map(([name]) => name);
  const verdict = (result, name, ...words) => ({ result, name, feedback: words.filter(Boolean).join(" ") });
  const { result, feedback } = outcomes[met[0]] ?? {};
  if (result === "right") return verdict(result, met[0], feedback, accept === "any" && FEEDBACK.other);
  if (result === "partly") return verdict(result, met[0], feedback);
  if (met.length) return verdict("wrong", met[0], joinFeedback(met.map((name) => outcomes[name].feedback)));
  const [elsewhere, unit] = findInUnits(exercise, candidates, units, rows);
  if (elsewhere) return verdict("wrong", elsewhere, outcomes[elsewhere].feedback, fillTemplate(FEEDBACK.units, { unit }));
  const few = hasFewDecimals(exercise, text), digits = few ? `, and give ${COUNTS[decimals]} decimals` : "";
  const isNear = (wanted) => isRoundedRight(exercise, rows, wanted)
    || (few && units.some((each) => isRoundedInUnits(outcomes[each].factors, rows, wanted)))
    || matchesRows(exercise, rows, wanted, unknowns.map(() => 1), NEAR);
  if (right.some(isNear)) return verdict("wrong", "near", fillTemplate(FEEDBACK.near, { digits }));
  const parts = findRightParts(exercise, right[0][0], rows[0]);
  return verdict("wrong", "", FEEDBACK.wrong,
    parts.length && fillTemplate(FEEDBACK.parts, { labels: parts.join(", ") }),
    !decimals && !isRounded(rows, 0) && FEEDBACK.whole,
    isTooCoarse(exercise, rows, text, right[0]) && fillTemplate(FEEDBACK.digits, { decimals: COUNTS[decimals] }));
};

// Lengths, from outside to inside, of lists in lists that are all alike; null if they are not.
const findShape = (value) => {
  if (!Array.isArray(value)) return [];
  const [first, ...others] = value.map(findShape);
  const alike = first && others.every((other) => other && String(other) === String(first));
  if (value.length && !alike) return null;
  return [value.length, ...(first ?? [])];
};

// A typed number or list as rows of the numbers asked for; null if it has another shape.
const toRows = ({ unknowns: { length: size }, accept, shape }, value, count) => {
  const single = [[size], shape.length ? shape : [size], [1, size], ...(size === 1 ? [[]] : [])];
  const several = [[count, size], [count * size]];
  const found = JSON.stringify(findShape(value));
  if (!(accept === "all" ? several : single).some((one) => JSON.stringify(one) === found)) return null;
  const flat = [value].flat(Infinity), rows = [];
  for (let i = 0; i < flat.length; i += size) rows.push(flat.slice(i, i + size));
  return rows;
};

const formatValue = (value) => Array.isArray(value)
  ? `[${value.map(formatValue).join(", ")}]`
  : formatNumber(value, 6);

// An answer of the shape that is asked for; of several answers two.
export const formatExample = ({ unknowns: { length: size }, accept, shape }) => {
  const [many = accept === "all" ? 2 : 1, wide = size] = shape;
  const rows = Array.from({ length: many }, (_, k) => Array.from({ length: wide }, (_, i) => k * wide + i + 1));
  const value = many > 1 && wide > 1 ? rows : rows.flat();
  return formatValue(value.length > 1 ? value : 0.5).replaceAll(" ", "\u00a0"); // in one line
};

export const describeProblem = ({ problem, about }, unknowns) =>
  fillTemplate(PROBLEMS[problem], { about, units: listUnits(unknowns) });

// The verdict on what was typed: { result, name, feedback, read }; result "unread" counts for nothing. Of
// several readings that fit, the right one counts, or else the one that is a known mistake.
export const judgeAnswer = (exercise, candidates, text) => {
  const unread = (feedback) => ({ result: "unread", name: "", feedback }), { unknowns, prompt } = exercise;
  const readings = parseTyped(text, unknowns), [first] = readings, verdicts = new Map();
  if (first.problem) return unread(describeProblem(first, unknowns));
  const unit = unknowns.length === 1 && unknowns[0].unit ? ` ${unknowns[0].unit}` : "";
  for (const { value } of readings) {
    const rows = toRows(exercise, value, candidates[0][1].length), key = String(rows);
    if (!rows || verdicts.has(key)) continue;
    verdicts.set(key, { ...judgeRows(exercise, candidates, rows, text), read: `Read as ${formatValue(value)}${unit}.` });
  }
  const fitting = [...verdicts.values()], right = fitting.find(({ result }) => result === "right");
  const [known, other] = right ? [right] : fitting.filter(({ name }) => name);
  if (!fitting.length) {
    return unread(fillTemplate(FEEDBACK.shape, { prompt, like: formatExample(exercise), read: formatValue(first.value) }));
  }
  return other ? unread(`${FEEDBACK.readings} ${known.read} ${other.read}`) : known ?? fitting[0];
};

// The verdicts on many answers, [variant, text] each. variants: the candidates of each.
export const judgeAnswers = (exercise, variants, answers) =>
  answers.map(([variant, text]) => judgeAnswer(exercise, variants[variant], text));
