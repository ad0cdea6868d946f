// An answer typed with more than was asked: a name before the number, its unit after it, decimals
// behind a slash. Here it becomes the bare number, where it can only mean one thing.

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

// Units that stand after the numbers, in the order in which they are asked for; and those of a list
// that all have the same one.
const unitless = (text, asks) => {
  const units = [...new Set(asks.map(({ unit }) => unit).filter(Boolean))];
  if (!units.length) return text;
  const known = units.map((unit) => unit.replace(/[.*+?^${}()|[\]\\/]/g, "\\$&"))
    .sort((a, b) => b.length - a.length).join("|");
  const after = RegExp(`(?<=[\\p{Nd}.)\\]πi\\s])\\s*(${known})(?![\\p{L}\\p{Nd}/*^²³])`, "gu");
  const found = [...text.matchAll(after)].map(([, unit]) => unit);
  const inOrder = found.every((unit, i) => unit === asks[i]?.unit) && found.length === asks.length;
  return units.length === 1 || inOrder ? text.replace(after, "") : text;
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

const bare = (text, asks) => unslashed(unitless(unnamed(text, asks), asks))
  .replace(/(\p{Nd}[.٫]\p{Nd}+)\.(?=\s*$)/u, "$1"); // a full stop

const readAsked = (text, asks) => {
  try {
    return readAnswer([...text].length > LONGEST ? text : bare(text, asks));
  } catch (refused) {
    return problemOf(refused);
  }
};

Object.assign(part, { readAsked });
