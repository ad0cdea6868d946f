// An answer typed with more than was asked: a name before the number, a unit after it, decimals
// behind a slash. Here it becomes the bare number in the unit that is asked for, where it can only
// mean one thing.

const NAMED = /(\p{L}[\p{L}\p{M}\p{Nd}_']*)\s*[=≈≃≅≡]\s*/gu;
const NATIVE = "[\u0660-\u0669\u06f0-\u06f9]"; // digits beside which a slash is a decimal sign
const SLASHED = RegExp(`(?<![\\p{Nd}./])(${NATIVE}+)/(${NATIVE}+)(?![\\p{Nd}./])`, "gu");
const ZERO = /^[\u0660\u06f0]/;

// One name before one number is its name; several must be those that are asked for, in order.
const unnamed = (text, asks) => {
  const names = [...text.matchAll(NAMED)].map(([, name]) => name);
  const meant = names.length === asks.length && (asks.length === 1 ? NAMED.test(text) && text.trim().search(NAMED) === 0
    : asks.every(({ label }, i) => label === names[i]));
  NAMED.lastIndex = 0;
  return meant ? text.replace(NAMED, "") : text;
};

const SIZES = UNITS.map((row) => row.map((unit) => ({ ...unit, typed: RegExp(`^(?:${unit.pattern})$`, "iu") })));
// A unit behind a number or a bracket that is not the start of an unknown one, such as m/s³.
const WRITTEN = RegExp(`(?<=[\\p{Nd}.)\\]π½¼¾⅓⅔i\\s])\\s*(${
  UNITS.flat().map(({ pattern }) => pattern).filter(Boolean).join("|")
})(?!\\p{Nd}|[^\\S\\n]*[\\p{L}/∕⁄÷^²³*·⋅∙×])`, "giu");
const LAST = RegExp(`${WRITTEN.source}[\\s.)\\]}]*$`, "iu");
const CALCULATED = /[*·×/π+]|pi/i;
const SUM = /[^\s,;([{e]\s*(?:\+|[-−–]\s)|[\p{Nd})][-−–]/iu;

const sizeOf = ({ unit = "" }) => SIZES.find((row) => row.some(({ name }) => name === unit));
const unitOf = ({ unit = "" }) => SIZES.flat().find(({ name }) => name === unit);
const isDegree = (name) => DEGREES.includes(name.toLowerCase());
const inUnit = (x, from, to) => from === to ? x : x * from.times / from.by * to.by / to.times;

// All that may be typed, for a sentence; a sign that few keyboards have in two ways.
const unitsFor = (asks) => [...new Set(asks.map(sizeOf))].map((row) => [...new Set(row.flatMap(({ name }) =>
  [name, name.replace("°", "deg").replace("²", "^2").replace("·", "*")]))].filter(Boolean).join(", ")).join("; ");

// The units of a text, and the text without them. Degrees of an angle stay: 90° + 0.5 rad is a sum.
const takeUnits = (text, asks) => {
  if (!/[\p{L}°º˚%]/u.test(text)) return { units: [], rest: text }; // most, and four times as fast
  const units = [], written = [...text.matchAll(WRITTEN)].map(([, name]) => name);
  const known = asks.some(({ unit }) => unit === "rad") || CALCULATED.test(text);
  if (known && written.every(isDegree)) return { units, rest: text };
  const rest = text.replace(WRITTEN, (all, name) => {
    const ask = asks[units.length % asks.length], stays = ask.unit === "rad" && isDegree(name);
    units.push(stays ? unitOf(ask) : sizeOf(ask).find(({ typed }) => typed.test(name)) ?? refuse("unit", name));
    return stays ? all : "";
  });
  return { units, rest };
};

// What was read, in the units that are asked for: those typed stand behind each number, or once.
const converted = (value, units, text, asks) => {
  const wanted = asks.map(unitOf), alike = wanted.every((unit) => unit === wanted[0]);
  if (alike && units.every((unit) => unit === wanted[0])) return value; // in a sum, too
  const count = [value].flat(Infinity).length, once = alike && units.length === 1 && LAST.test(text);
  if (SUM.test(text) || (!once && units.length !== count)) refuse("units", text);
  let i = 0;
  const each = (part) => Array.isArray(part) ? part.map(each)
    : inUnit(part, units[once ? 0 : i], wanted[i++ % wanted.length]);
  return each(value);
};

// ۲/۱۹۱ is 2.191: nobody divides by 191, or by 05, or zero by something. ۱/۳ may be both, and so may
// ۷۰/۱۸۰, and ۷۰/۱۹۱ beside a factor.
const DIVISORS = /^(180|360|10+)$/;
const FACTOR_BEFORE = /[*·×π]\s*$/u, FACTOR_BEHIND = /^\s*[*·×π]/u;
const digits = (text) => [...text].map((digit) => digit.codePointAt(0) & 15).join("");
const unslashed = (text) => text.replace(SLASHED, (all, whole, part, at) => {
  const factor = FACTOR_BEFORE.test(text.slice(0, at)) || FACTOR_BEHIND.test(text.slice(at + all.length));
  const divides = part.length < 3 || DIVISORS.test(digits(part)) || factor;
  if (divides && !ZERO.test(whole) && !ZERO.test(part)) refuse("slash", all);
  return `${whole}.${part}`;
});

const bare = (text) => unslashed(text)
  .replace(/(\p{Nd}[.٫]\p{Nd}+)\.(?=\s*$)/u, "$1"); // a full stop

const readAsked = (text, asks) => {
  try {
    if (!asks.length || [...text].length > LONGEST) return readAnswer(text);
    const named = unnamed(text, asks), { units, rest } = takeUnits(named, asks), found = readAnswer(bare(rest));
    return found.problem || !units.length ? found : { ...found, value: converted(found.value, units, named, asks) };
  } catch (refused) {
    return problemOf(refused);
  }
};

Object.assign(part, { readAsked });
