// Reads a typed answer: a number, a list, or a calculation such as `sqrt(3)/2`. Runs nothing. The
// one reader: of the page, of notebooks and of `grade`. `tests/courseware/answers.json` says what it
// must read.
//
// - A product without a sign, `2pi`, ranks as `*`. By that rule `1/2pi` is pi/2, which few mean:
//   a division followed by such a product is refused, and so is `√2pi`. `√` takes one thing.
// - `30°` is 30 times pi/180. `,` `،` `;` `؛` and new lines separate; the last one may be left over.
// - Rows, `1, 2; 3, 4`, are lists in a list; rows of one number each, `1; 2; 3`, are one flat list.
// - In `[ ]` and `{ }` blanks separate as well, where nothing but numbers and lists stands inside.
//
// It may be typed with more than was asked: a name before the number, a unit after it, decimals
// behind a slash. It becomes the bare number in the unit that is asked for, where it can only mean
// one thing.

import { evaluateGroup } from "./calculating.js";
import { nestBrackets } from "./nesting.js";
import { describeRefusal, INVISIBLE, MAX_LENGTH, refuse, tokenize } from "./tokenizing.js";
import { DEGREES, UNITS } from "./units.js";

const NAME = /(\p{L}[\p{L}\p{M}\p{Nd}_']*)\s*[=≈≃≅≡]\s*/gu;
const OTHER_DIGIT = "[\u0660-\u0669\u06f0-\u06f9]"; // digits beside which a slash is a decimal sign
const SLASHED_NUMBER = RegExp(`(?<![\\p{Nd}./])(${OTHER_DIGIT}+)/(${OTHER_DIGIT}+)(?![\\p{Nd}./])`, "gu");
const LEADING_ZERO = /^[\u0660\u06f0]/;

// One name before one number is its name; several must be those that are asked for, in order.
const removeNames = (text, asks) => {
  const names = [...text.matchAll(NAME)].map(([, name]) => name);
  const meant = names.length === asks.length && (asks.length === 1 ? NAME.test(text) && text.trim().search(NAME) === 0
    : asks.every(({ label }, i) => label === names[i]));
  NAME.lastIndex = 0;
  return meant ? text.replace(NAME, "") : text;
};

const UNIT_PATTERNS = UNITS.map((row) => row.map((unit) => ({ ...unit, typed: RegExp(`^(?:${unit.pattern})$`, "iu") })));
// A unit behind a number or a bracket that is not the start of an unknown one, such as m/s³.
const WRITTEN = RegExp(`(?<=[\\p{Nd}.)\\]π½¼¾⅓⅔i\\s])\\s*(${
  UNITS.flat().map(({ pattern }) => pattern).filter(Boolean).join("|")
})(?!\\p{Nd}|[^\\S\\n]*[\\p{L}/∕⁄÷^²³*·⋅∙×])`, "giu");
const UNIT_AT_END = RegExp(`${WRITTEN.source}[\\s.)\\]}]*$`, "iu");
const PRODUCT = /[*·×/π+]|pi/i;
const SUM = /[^\s,;([{e]\s*(?:\+|[-−–]\s)|[\p{Nd})][-−–]/iu;

const unitsOfSize = ({ unit = "" }) => UNIT_PATTERNS.find((row) => row.some(({ name }) => name === unit));
const unitOf = ({ unit = "" }) => UNIT_PATTERNS.flat().find(({ name }) => name === unit);
const isDegree = (name) => DEGREES.includes(name.toLowerCase());
const convert = (x, from, to) => from === to ? x : x * from.times / from.by * to.by / to.times;

// All that may be typed, for a sentence; a sign that few keyboards have in two ways.
export const listUnits = (asks) => [...new Set(asks.map(unitsOfSize))].map((row) => [...new Set(row.flatMap(({ name }) =>
  [name, name.replace("°", "deg").replace("²", "^2").replace("·", "*")]))].filter(Boolean).join(", ")).join("; ");

// The units of a text, and the text without them. Degrees of an angle stay: 90° + 0.5 rad is a sum.
const takeUnits = (text, asks) => {
  if (!/[\p{L}°º˚%]/u.test(text)) return { units: [], rest: text }; // most, and four times as fast
  const units = [], written = [...text.matchAll(WRITTEN)].map(([, name]) => name);
  const known = asks.some(({ unit }) => unit === "rad") || PRODUCT.test(text);
  if (known && written.every(isDegree)) return { units, rest: text };
  const rest = text.replace(WRITTEN, (all, name) => {
    const ask = asks[units.length % asks.length], stays = ask.unit === "rad" && isDegree(name);
    units.push(stays ? unitOf(ask) : unitsOfSize(ask).find(({ typed }) => typed.test(name)) ?? refuse("unit", name));
    return stays ? all : "";
  });
  return { units, rest };
};

// Convert to the units that are asked for; a unit stands behind each number, or once.
const convertAll = (value, units, text, asks) => {
  const wanted = asks.map(unitOf), alike = wanted.every((unit) => unit === wanted[0]);
  if (alike && units.every((unit) => unit === wanted[0])) return value; // in a sum, too
  const count = [value].flat(Infinity).length, once = alike && units.length === 1 && UNIT_AT_END.test(text);
  if (SUM.test(text) || (!once && units.length !== count)) refuse("units", text);
  let i = 0;
  const each = (part) => Array.isArray(part) ? part.map(each)
    : convert(part, units[once ? 0 : i], wanted[i++ % wanted.length]);
  return each(value);
};

// ۲/۱۹۱ is 2.191: nobody divides by 191, or by 05, or zero by something. ۱/۳ may be both, and so may
// ۷۰/۱۸۰, and ۷۰/۱۹۱ beside a factor.
const DIVISORS = /^(180|360|10+)$/;
const FACTOR_BEFORE = /[*·×π]\s*$/u;
const FACTOR_BEHIND = /^\s*[*·×π]/u;
const toAsciiDigits = (text) => [...text].map((digit) => digit.codePointAt(0) & 15).join("");
const replaceSlashes = (text) => text.replace(SLASHED_NUMBER, (all, whole, part, at) => {
  const factor = FACTOR_BEFORE.test(text.slice(0, at)) || FACTOR_BEHIND.test(text.slice(at + all.length));
  const divides = part.length < 3 || DIVISORS.test(toAsciiDigits(part)) || factor;
  if (divides && !LEADING_ZERO.test(whole) && !LEADING_ZERO.test(part)) refuse("slash", all);
  return `${whole}.${part}`;
});

const normalizeNumber = (text) => replaceSlashes(text)
  .replace(/(\p{Nd}[.٫]\p{Nd}+)\.(?=\s*$)/u, "$1"); // a full stop

// Return { value, problem, about }: a value, or the code of a problem and the text it is about.
export const parseAnswer = (text) => {
  try {
    if ([...text].length > MAX_LENGTH) refuse("long", text);
    const level = nestBrackets(tokenize(text.replace(INVISIBLE, "")));
    if (!level.length) refuse("empty", "");
    return { value: evaluateGroup(level, "", ""), problem: "", about: "" };
  } catch (refused) {
    return describeRefusal(refused);
  }
};

export const parseTyped = (text, asks) => {
  try {
    if (!asks.length || [...text].length > MAX_LENGTH) return parseAnswer(text);
    const named = removeNames(text, asks), { units, rest } = takeUnits(named, asks), found = parseAnswer(normalizeNumber(rest));
    return found.problem || !units.length ? found : { ...found, value: convertAll(found.value, units, named, asks) };
  } catch (refused) {
    return describeRefusal(refused);
  }
};

