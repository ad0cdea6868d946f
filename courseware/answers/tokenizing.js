// Cuts a typed answer into numbers, names and signs.

export const MAX_LENGTH = 1000;
export const MAX_DEPTH = 20;
export const PAIRS = new Map([["(", ")"], ["[", "]"], ["{", "}"]]);
export const CLOSERS = [...PAIRS.values()];
export const LISTS = ["[", "{"];
export const SIGNS = ["+", "-", "*", "/"];
export const PI = ["pi", "π"];
export const FRACTIONS = new Map([["½", 1 / 2], ["¼", 1 / 4], ["¾", 3 / 4], ["⅓", 1 / 3], ["⅔", 2 / 3]]);
export const WRAPPERS = ["array", "asarray", "matrix", "float", "int", "float64", "float32", "int64", "int32"];
export const FUNCTIONS = ["sin", "cos", "tan", "cot", "asin", "acos", "atan", "arcsin", "arccos",
  "arctan", "sinh", "cosh", "tanh", "exp", "log", "ln", "abs", "hypot", "pow"];

export const INVISIBLE =
  /[\ufe00-\ufe0f\u061c\u180e\u200b-\u200f\u202a-\u202e\u2060\u2066-\u2069\ufeff]/g;
const shiftLetter = (c, by) => String.fromCharCode(c.charCodeAt(0) + by);
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
  ...[..."()[]{}"].map((bracket) => [bracket, shiftLetter(bracket, 0xfee0)]),
  ...[..."0123456789"].map((d) => [d, shiftLetter(d, 0x630) + shiftLetter(d, 0x6c0) + shiftLetter(d, 0xfee0)]),
  ...[..."abcdefghijklmnopqrstuvwxyz"].map((letter) => [letter, shiftLetter(letter, -0x20)]),
].flatMap(([plain, odds]) => [...odds].map((odd) => [odd, plain])));

const LETTERS = "a-zµ\\u00c0-\\u02af\\u0370-\\u058f\\u05d0-\\u05ea"
  + "\\u0620-\\u064a\\u066e-\\u06d3\\u0900-\\u1fff";
const TOKEN = new RegExp(
  "(?<gap>[ \\n]+)"
  + "|(?<number>\\.*[0-9][0-9.]*(?:'[0-9][0-9.]*)*(?:e[+-]?[0-9]+)?)"
  + `|(?:(?:np|numpy|math)\\.)?(?<name>sqrt|π|[${LETTERS}][${LETTERS}0-9]*)`
  + "|(?<power>\\*\\*|[\\^²³¹\\u2070-\\u207f])"
  + "|(?<sign>.)", "gsu");
const MARKED = /^[1-9][0-9]{0,2}(?:'[0-9]{3})+(?:\.[0-9]*)?(?:e.*)?$/; // 1'000.5
const THOUSANDS = [ // 1,000.5 and 1 000,5; 1.000,5 and 1.000.000
  /(?<![0-9.,'])[1-9][0-9]{0,2}([, ])[0-9]{3}(?:\1[0-9]{3})*(?![0-9'])/g,
  /(?<![0-9.,'])[1-9][0-9]{0,2}(?:(?:\.[0-9]{3})+(?=,[0-9]+(?![0-9.]))|(?:\.[0-9]{3}){2,}(?![0-9.]))/g,
];

export const newToken = (kind, text, shown, gap = "") => ({ kind, text, shown, gap, inside: [] });

class Refusal {
  constructor(problem, about) { Object.assign(this, { problem, about }); }
}
export const refuse = (problem, about) => {
  throw new Refusal(problem, [...about].slice(0, 20).join(""));
};

export const describeRefusal = (refused) => {
  if (!(refused instanceof Refusal)) throw refused;
  return { value: null, problem: refused.problem, about: refused.about };
};

// Whatever a reader may mean by the commas, points and blanks between digits: texts of one length in
// which a point is a decimal sign, ' marks thousands, and commas separate.
export const listMeanings = (text) => {
  const plain = [...text].map((c) => PLAIN.get(c) ?? c).join("");
  const marked = THOUSANDS.reduce((before, pattern) =>
    before.replace(pattern, (number) => number.replace(/[, .]/g, "'")), plain);
  const both = [plain, marked].flatMap((each) => [each, each.replace(/(?<=[0-9]),(?=[0-9])/g, ".")]);
  return [...new Set(both)];
};

// Numbers, names and signs of a text, in order. shown: the text as it was typed.
export const tokenize = (text, shown) => {
  const found = [];
  let gap = "";
  for (const match of text.matchAll(TOKEN)) {
    let kind = Object.keys(match.groups).find((name) => match.groups[name] !== undefined);
    const token = match.groups[kind];
    const typed = shown.slice(match.index, match.index + match[0].length);
    if (kind === "gap") {
      gap = token;
      continue;
    }
    const marked = token.includes("'") && !MARKED.test(token);
    if (kind === "number" && (marked || token.split(".").length > 2)) refuse("unknown", typed);
    if (kind === "sign" || token === "sqrt") kind = token === "sqrt" ? "√" : token;
    found.push(newToken(kind, token.replaceAll("'", ""), typed, gap));
    gap = "";
    if (kind === "=") refuse("equals", joinTokens(found));
  }
  return found;
};

export const joinTokens = (some) =>
  some.map((t, i) => (i ? t.gap.replaceAll("\n", " ") : "") + t.shown).join("");
