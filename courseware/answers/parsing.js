// Reads a typed answer: a number, a list, or a calculation such as `sqrt(3)/2`. Runs nothing. The
// one reader: of the page, of notebooks and of `grade`. `courseware/tests/answers.json` says what it
// must read.
//
// - A product without a sign, `2pi`, ranks as `*`. By that rule `1/2pi` is pi/2, which few mean:
//   a division followed by such a product is refused, and so is `√2pi`. `√` takes one thing.
// - `30°` is 30 times pi/180. `,` `،` `;` `؛` and new lines separate; the last one may be left over.
// - Rows, `1, 2; 3, 4`, are lists in a list; rows of one number each, `1; 2; 3`, are one flat list.
// - In `[ ]` and `{ }` blanks separate as well, and new lines rows, where nothing but numbers and lists
//   is inside.
//
// A comma, a point or a blank between digits can be a decimal sign, separate, or mark thousands, and
// a slash between digits of Arabic or Persian is a decimal sign, too. All that a text can say is read;
// the judge knows what fits. It may be typed with more than was asked: a name before the number, a
// unit after it. It becomes the bare number in the unit that is asked for.

import { evaluateGroup } from "./calculating.js";
import { nestBrackets } from "./nesting.js";
import { describeRefusal, FUNCTIONS, INVISIBLE, listMeanings, MAX_LENGTH, refuse, tokenize } from "./tokenizing.js";
import { DEGREES, UNITS } from "../units/constants.js";

const NAME = /(\p{L}[\p{L}\p{M}\p{Nd}_']*)\s*[=≈≃≅≡:]\s*/gu;
const SLASH = /(?<=(?<![\p{Nd}./])[\u0660-\u0669\u06f0-\u06f9]+)\/(?=[\u0660-\u0669\u06f0-\u06f9]+(?![\p{Nd}./]))/gu;

// One name before one number is its name; several must be those that are asked for, in order.
const removeNames = (text, unknowns) => {
  const names = [...text.matchAll(NAME)].map(([, name]) => name);
  const meant = names.length === unknowns.length && (unknowns.length === 1
    ? text.trim().search(NAME) === 0 : unknowns.every(({ label }, i) => label === names[i]));
  return meant ? text.replace(NAME, "") : text;
};

const UNIT_PATTERNS = UNITS.map((row) => row.map((unit) => ({ ...unit, typed: RegExp(`^(?:${unit.pattern})$`, "iu") })));
// A unit behind a number or a bracket that is not the start of an unknown one, such as m/s³.
const WRITTEN = RegExp(`(?<=[\\p{Nd}.)\\]π½¼¾⅓⅔\\s]|pi)\\s*(${
  UNITS.flat().map(({ pattern }) => pattern).filter(Boolean).join("|")
})(?!\\p{Nd}|[^\\S\\n\\u2028]*[\\p{L}/∕⁄÷^²³*·⋅∙×])`, "giu");
const UNIT_AT_END = RegExp(`${WRITTEN.source}[\\s.)\\]}]*$`, "iu");
const PRODUCT = /[*·×/π+]|pi/i;
const SUM = /[^\s,;([{e]\s*(?:\+|[-−–]\s)|[\p{Nd})][-−–]/iu;

const unitsOfSize = ({ unit = "" }) => UNIT_PATTERNS.find((row) => row.some(({ name }) => name === unit));
const unitOf = ({ unit = "" }) => UNIT_PATTERNS.flat().find(({ name }) => name === unit);
const isDegree = (name) => DEGREES.includes(name.toLowerCase());
const convert = (x, from, to) => from === to ? x : x * from.times / from.by * to.by / to.times;

// All that may be typed, for a sentence; a sign that few keyboards have in two ways.
export const listUnits = (unknowns) => [...new Set(unknowns.map(unitsOfSize))].map((row) => {
  const names = row.flatMap(({ name }) => [name, name.replace("°", "deg").replace("²", "^2").replace("·", "*")]);
  return [...new Set(names)].filter(Boolean).join(", ");
}).join("; ");

// The units of a text, and the text without them. Degrees of an angle stay: 90° + 0.5 rad is a sum.
// Most texts have none, and are read four times as fast; a function is refused where it is computed.
const takeUnits = (text, unknowns) => {
  const calls = text.toLowerCase().match(/\p{L}+/gu)?.some((word) => FUNCTIONS.includes(word));
  if (calls || !/[\p{L}°º˚%]/u.test(text)) return { units: [], rest: text };
  const units = [], written = [...text.matchAll(WRITTEN)].map(([, name]) => name);
  const known = unknowns.some(({ unit }) => unit === "rad") || PRODUCT.test(text);
  if (known && written.every(isDegree)) return { units, rest: text };
  const rest = text.replace(WRITTEN, (all, name) => {
    const unknown = unknowns[units.length % unknowns.length], stays = unknown.unit === "rad" && isDegree(name);
    units.push(stays ? unitOf(unknown) : unitsOfSize(unknown).find(({ typed }) => typed.test(name)) ?? refuse("unit", name));
    return stays ? all : "";
  });
  return { units, rest };
};

// Convert to the units that are asked for; a unit follows each number, or the last one.
const convertAll = (value, units, text, unknowns) => {
  const wanted = unknowns.map(unitOf), alike = wanted.every((unit) => unit === wanted[0]);
  if (alike && units.every((unit) => unit === wanted[0])) return value; // in a sum, too
  const count = [value].flat(Infinity).length, once = alike && units.length === 1 && UNIT_AT_END.test(text);
  if (SUM.test(text) || (!once && units.length !== count)) refuse("units", text);
  let i = 0;
  const each = (part) => Array.isArray(part) ? part.map(each)
    : convert(part, units[once ? 0 : i], wanted[i++ % wanted.length]);
  return each(value);
};

// Remove a sign before the number and a full stop behind it.
const trim = (text) => text.replace(/^\s*[=≈≃≅≡]/, "").replace(/(\p{Nd}[.٫]\p{Nd}+)\.(?=\s*$)/u, "$1");

// Return { value, problem, about }: a value, or the code of a problem and the text it is about.
const attempt = (read) => {
  try {
    return { value: read(), problem: "", about: "" };
  } catch (refused) {
    return describeRefusal(refused);
  }
};

// Keep the readings without a problem, or else the first.
const dropProblems = (readings) => {
  const good = readings.filter(({ problem }) => !problem);
  return good.length ? good : readings.slice(0, 1);
};

// Blanks round a text do not count: a table of answers does not keep them.
const isLong = (text) => [...text.trim()].length > MAX_LENGTH;

// Return all that a text can say, or one problem. Outside brackets blanks may separate as inside.
export const parseAnswer = (text) => {
  if (isLong(text)) return [attempt(() => refuse("long", text))];
  const shown = text.replace(INVISIBLE, "").trim(), brackets = ["", ...(/\S\s+\S/.test(shown) ? ["[]"] : [])];
  return dropProblems(listMeanings(shown).flatMap((meaning) => brackets.map(([open = "", close = ""]) => attempt(() => {
    const level = nestBrackets(tokenize(open + meaning + close, open + shown + close));
    if (!level.length) refuse("empty", "");
    return evaluateGroup(level, "", "");
  }))));
};

export const parseTyped = (text, unknowns) => {
  if (!unknowns.length || isLong(text)) return parseAnswer(text);
  const named = trim(removeNames(text.replace(INVISIBLE, "").trim(), unknowns));
  const { value: taken, ...refused } = attempt(() => takeUnits(named, unknowns));
  if (refused.problem) return [{ value: null, ...refused }];
  const { units, rest } = taken, texts = new Set([rest.replace(SLASH, "."), rest]);
  return dropProblems([...texts].flatMap(parseAnswer).map((found) => found.problem || !units.length ? found
    : attempt(() => convertAll(found.value, units, named, unknowns))));
};
