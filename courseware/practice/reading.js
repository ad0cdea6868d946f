// Reads a typed answer: a number, a list, or a calculation such as `sqrt(3)/2`. Runs nothing. The
// one reader: of the page, of notebooks and of `grade`. `tests/courseware/answers.json` says what it must read.
//
// - A product without a sign, `2pi`, ranks as `*`. By that rule `1/2pi` is pi/2, which few mean:
//   a division followed by such a product is refused, and so is `√2pi`. `√` takes one thing.
// - `30°` is 30 times pi/180. `,` `،` `;` `؛` and new lines separate; the last one may be left over.
// - Rows, `1, 2; 3, 4`, are lists in a list; rows of one number each, `1; 2; 3`, are one flat list.
// - In `[ ]` and `{ }` blanks separate as well, where nothing but numbers and lists stands inside.
//
// A comma that touches a digit on both sides, as in `0,5`, may be decimal; all others separate.
// It is decided for each pair of brackets by the first of these rules that fits:
//
// 1. A decimal point anywhere in the text, or a run as in `1,2,3`: it separates.
// 2. A `;`, or a comma with a space after it, beside it: it is decimal, `0,5, 1,5` and `0,5; 1,5`.
// 3. Brackets around it, or one more comma of any kind: it separates, `[0,5]`.
// 4. Otherwise, alone and outside brackets: it is decimal, `0,5`.
//
// Refused, because both are likely: `[1,2; 3,4]`, `1,5/2` without brackets, `1,000`, `0,5 1,5`.

const LONGEST = 1000, DEEPEST = 20;
const PAIRS = new Map([["(", ")"], ["[", "]"], ["{", "}"]]);
const CLOSERS = [...PAIRS.values()];
const LISTS = ["[", "{"];
const SIGNS = ["+", "-", "*", "/"];
const PI = ["pi", "π"];
const FRACTIONS = new Map([["½", 1 / 2], ["¼", 1 / 4], ["¾", 3 / 4], ["⅓", 1 / 3], ["⅔", 2 / 3]]);
const NOT_FINITE = new Map(
  [["nan", "nan"], ["inf", "infinity"], ["infinity", "infinity"], ["∞", "infinity"]]);
const WRAPPERS = ["array", "asarray", "matrix", "float", "int", "float64", "float32", "int64",
  "int32"];
const FUNCTIONS = ["sin", "cos", "tan", "cot", "asin", "acos", "atan", "arcsin", "arccos",
  "arctan", "sinh", "cosh", "tanh", "exp", "log", "ln", "abs", "hypot", "pow"];

const INVISIBLE =
  /[\u061c\u180e\u200b-\u200f\u202a-\u202e\u2060\u2066-\u2069\ufe00-\ufe0f\ufeff]/g;
const shift = (c, by) => String.fromCharCode(c.charCodeAt(0) + by);
const PLAIN = new Map([
  [" ", "\t\v\f\u00a0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a"
    + "\u202f\u205f\u3000"],
  ["\n", "\r\u0085\u2028\u2029"],
  ["-", "\u02d7\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u2796\ufe58\ufe63\uff0d"],
  ["+", "\u2795\ufb29\uff0b"],
  ["*", "×·∙⋅∗✕✖\u2062\uff0a"],
  ["/", "÷∕⁄➗\uff0f"],
  [".", "٫\uff0e"],
  ["'", "_’‘ʼ٬\uff07"],
  [",", "\uff0c"],
  ["،", "、"],
  [";", "؛\uff1b"],
  ["=", "≈≃≅≡\uff1d"],
  ["^", "\uff3e"],
  ...[..."()[]{}"].map((bracket) => [bracket, shift(bracket, 0xfee0)]),
  ...[..."0123456789"].map((d) => [d, shift(d, 0x630) + shift(d, 0x6c0) + shift(d, 0xfee0)]),
  ...[..."abcdefghijklmnopqrstuvwxyz"].map((letter) => [letter, shift(letter, -0x20)]),
].flatMap(([plain, odds]) => [...odds].map((odd) => [odd, plain])));

const LETTERS = "a-zµ\\u00c0-\\u02af\\u0370-\\u058f\\u05d0-\\u05ea"
  + "\\u0620-\\u064a\\u066e-\\u06d3\\u0900-\\u1fff";
const TOKEN = new RegExp(
  "(?<gap>[ \\n]+)"
  + "|(?<number>\\.*[0-9][0-9.]*(?:'[0-9][0-9.]*)*(?:e[+-]?[0-9]+)?)"
  + `|(?:(?:np|numpy|math)\\.)?(?<name>sqrt|[π∞]|[${LETTERS}][${LETTERS}0-9]*)`
  + "|(?<power>\\*\\*|[\\^²³¹\\u2070-\\u207f])"
  + "|(?<sign>.)", "gsu");
const MARKED = /^(?:.*'.*|[1-9][0-9]{0,2}(?:\.[0-9]{3}){2,})$/; // 1'000 and 1.000.000
const THOUSANDS = // 1,000 and 1,000.5 and 1.000,5
  /^(?:[1-9][0-9]{0,2},[0-9]{3}(?:\.[0-9]*)?|[1-9][0-9]{0,2}\.[0-9]{3},[0-9]+)$/;

const newToken = (kind, text, shown, gap = "") => ({ kind, text, shown, gap, inside: [] });

class Refused {
  constructor(problem, about) { Object.assign(this, { problem, about }); }
}
const refuse = (problem, about) => {
  throw new Refused(problem, [...about].slice(0, 20).join(""));
};

// What was read: { value, problem, about }, with a value or the code of a problem and the piece of
// text that it is about.
const readAnswer = (text) => {
  try {
    if ([...text].length > LONGEST) refuse("long", text);
    const level = nest(tokens(text.replace(INVISIBLE, "")));
    if (!level.length) refuse("empty", "");
    return { value: group(level, "", ""), problem: "", about: "" };
  } catch (refused) {
    return problemOf(refused);
  }
};

const problemOf = (refused) => {
  if (!(refused instanceof Refused)) throw refused;
  return { value: null, problem: refused.problem, about: refused.about };
};

// Numbers, names and signs of a text, in order.
const tokens = (shown) => {
  const found = [];
  let gap = "";
  const plain = [...shown].map((c) => PLAIN.get(c) ?? c).join("");
  for (const match of plain.matchAll(TOKEN)) {
    let kind = Object.keys(match.groups).find((name) => match.groups[name] !== undefined);
    const text = match.groups[kind];
    const typed = shown.slice(match.index, match.index + match[0].length);
    if (kind === "gap") {
      gap = text;
      continue;
    }
    if (kind === "number" && MARKED.test(text)) refuse("thousands", typed);
    if (kind === "number" && text.split(".").length > 2) refuse("unknown", typed);
    if (kind === "sign" || text === "sqrt") kind = text === "sqrt" ? "√" : text;
    found.push(newToken(kind, text, typed, gap));
    gap = "";
    if (kind === "=") refuse("equals", piece(found));
  }
  return found;
};

// The tokens as they were typed.
const piece = (some) =>
  some.map((t, i) => (i ? t.gap.replaceAll("\n", " ") : "") + t.shown).join("");

// Put what stands in brackets inside the opening bracket; settle commas and blanks.
const nest = (flat) => {
  const point = flat.some((t) => t.kind === "number" && t.text.includes("."));
  const levels = [[]], opened = [];
  for (const token of flat) {
    const level = levels.at(-1);
    if (!opened.length && token.gap.includes("\n") && level.length && level.at(-1).kind !== ";") {
      level.push(newToken(";", ";", " "));
    }
    if (PAIRS.has(token.kind)) {
      if (opened.length === DEEPEST) refuse("deep", token.shown);
      token.inside = level.slice(-1); // until it closes: what stands before it
      level.push(token);
      opened.push(token);
      levels.push([]);
    } else if (CLOSERS.includes(token.kind)) close(opened.pop(), token, levels.pop(), point);
    else level.push(token);
  }
  if (opened.length) refuse("brackets", opened.at(-1).shown);
  return commas(levels[0], "", point);
};

// Put a level inside the bracket that opened it.
const close = (start, token, level, point) => {
  if (PAIRS.get(start?.kind) !== token.kind) refuse("brackets", token.shown);
  const root = start.kind === "(" && start.inside.some((t) => t.kind === "√");
  start.shown = piece([start, ...level, token]);
  start.inside = blanks(commas(level, root ? "√" : start.kind, point), start.kind);
};

// Join numbers at decimal commas, by the four rules.
const commas = (level, opener, point) => {
  const places = touching(level);
  if (!places.length) return level;
  const decimal = areDecimal(level, places, opener, point);
  for (const i of places) {
    if (doubtful(level[i - 1], level[i + 1], !opener || decimal)) {
      const point = level[i - 1].text.includes(".") || level[i + 1].text.includes(".");
      refuse(point || places.includes(i + 2) ? "thousands" : "decimal", piece(level.slice(i - 1, i + 2)));
    }
  }
  return decimal ? joined(level, places) : level;
};

// Where a comma touches a digit on both sides.
const touching = (level) => [...level.keys()].filter((i) =>
  level.slice(i - 1, i + 2).map((t) => t.kind).join(" ") === "number , number"
  && level[i].gap + level[i + 1].gap === "" && !level[i - 1].text.includes("e"));

const areDecimal = (level, places, opener, point) => {
  const kinds = level.map((t) => t.kind), first = level.slice(places[0] - 1, places[0] + 2);
  if (point || places.some((i) => places.includes(i + 2))) return false;
  if (opener === "√") return true;
  const listed = (i) => kinds[i + 2] === "number" // 0,5 1,5
    || kinds[i - 2] === "number" && !doubtful(level[i - 2], level[i - 1], true);
  if (places.some(listed)) refuse("comma", piece(level));
  const spaced = kinds.includes("،")
    || kinds.some((kind, i) => kind === "," && i + 1 < level.length && level[i + 1].gap !== "");
  if (spaced || kinds.includes(";")) {
    if (opener && !spaced) refuse("comma", piece(first));
    return true;
  }
  if (opener) return false;
  const worked = kinds.some((kind, i) =>
    i > 0 && SIGNS.includes(kind) && ![...SIGNS, ",", ";", "√"].includes(kinds[i - 1]));
  if (worked) refuse("comma", piece(first));
  return kinds.filter((kind) => kind === ",").length === 1;
};

// The level with a decimal number for each comma and its two numbers.
const joined = (level, places) => {
  const found = [];
  level.forEach((token, i) => {
    if (places.includes(i - 1)) {
      const last = found.pop(), both = last.text + "." + token.text;
      found.push(newToken("number", both, last.shown + "," + token.shown, last.gap));
    } else if (!places.includes(i)) found.push(token);
  });
  return found;
};

// Whether two numbers may be one with a mark between thousands; 000 is no number alone.
const doubtful = (left, right, anyhow = false) =>
  THOUSANDS.test(left.text + "," + right.text) && (anyhow || right.text[0] === "0");

// Put commas where blanks separate: between plain numbers or lists in [ ] and { }.
const blanks = (level, opener) => {
  const starts = [];
  for (const [i, token] of level.entries()) {
    const before = i ? level[i - 1].kind : ";";
    let plain;
    if (before === "+" || before === "-") plain = token.kind === "number" && !token.gap;
    else {
      plain = ["number", "+", "-", ";", ...LISTS].includes(token.kind);
      if (before !== ";" && token.kind !== ";") {
        plain = plain && token.gap !== "";
        starts.push(i);
      }
    }
    if (!plain || !LISTS.includes(opener)) return level;
  }
  for (const i of starts.reverse()) {
    const token = level[i];
    if (token.kind === "number" && doubtful(level[i - 1], token)) {
      refuse("thousands", piece(level.slice(i - 1, i + 1)));
    }
    if (!LISTS.includes(token.kind) && token.gap.includes("\n")) {
      refuse("adjacent", piece(level.slice(i - 1, i + 1)));
    }
    level = [...level.slice(0, i), newToken(",", ",", " "), ...level.slice(i)];
  }
  return level;
};
