// Reads a typed answer. The rules stand in reading.py: the same reader, in the same order.
// readAnswer(text) → { value, problem, about }
const readAnswer = (() => {
  const LONGEST = 1000, DEEPEST = 20;
  const PAIRS = new Map([["(", ")"], ["[", "]"], ["{", "}"]]);
  const CLOSERS = [...PAIRS.values()];
  const LISTS = ["[", "{"];
  const SIGNS = ["+", "-", "*", "/"];
  const PI = ["pi", "π"];
  const FRACTIONS = new Map([["½", 1 / 2], ["¼", 1 / 4], ["¾", 3 / 4], ["⅓", 1 / 3], ["⅔", 2 / 3]]);
  const NOT_FINITE = new Map(
    [["nan", "nan"], ["inf", "infinity"], ["infinity", "infinity"], ["∞", "infinity"]]);
  const DEGREES = ["°", "deg", "degree", "degrees"];
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
    ["°", "º˚"],
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

  const read = (text) => {
    try {
      if ([...text].length > LONGEST) refuse("long", text);
      const level = nest(tokens(text.replace(INVISIBLE, "")));
      if (!level.length) refuse("empty", "");
      return { value: group(level, "", ""), problem: "", about: "" };
    } catch (refused) {
      if (!(refused instanceof Refused)) throw refused;
      return { value: null, problem: refused.problem, about: refused.about };
    }
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
      } else if (CLOSERS.includes(token.kind)) {
        if (!opened.length || PAIRS.get(opened.at(-1).kind) !== token.kind) {
          refuse("brackets", token.shown);
        }
        const start = opened.pop();
        const root = start.kind === "(" && start.inside.some((t) => t.kind === "√");
        start.shown = piece([start, ...level, token]);
        start.inside = blanks(commas(level, root ? "√" : start.kind, point), start.kind);
        levels.pop();
      } else level.push(token);
    }
    if (opened.length) refuse("brackets", opened.at(-1).shown);
    return commas(levels[0], "", point);
  };

  // Join numbers at decimal commas, by the four rules.
  const commas = (level, opener, point) => {
    const kinds = level.map((t) => t.kind);
    const touching = [...kinds.keys()].filter((i) =>
      i > 0 && i < level.length - 1 && kinds.slice(i - 1, i + 2).join(" ") === "number , number"
      && level[i].gap + level[i + 1].gap === "" && !level[i - 1].text.includes("e"));
    if (!touching.length) return level;
    const first = piece(level.slice(touching[0] - 1, touching[0] + 2));
    const run = touching.some((i) => touching.includes(i + 2));
    const spaced = kinds.includes("،")
      || kinds.some((kind, i) => kind === "," && i + 1 < level.length && level[i + 1].gap !== "");
    const worked = kinds.some((kind, i) =>
      i > 0 && SIGNS.includes(kind) && ![...SIGNS, ",", ";", "√"].includes(kinds[i - 1]));
    let decimal;
    if (point || run) decimal = false;
    else if (opener === "√") decimal = true;
    else if (spaced || kinds.includes(";")) {
      decimal = true;
      if (opener && !spaced) refuse("comma", first);
    } else {
      decimal = !opener;
      if (decimal && worked) refuse("comma", first);
      decimal = decimal && kinds.filter((kind) => kind === ",").length === 1;
    }
    for (const i of touching) {
      if (doubtful(level[i - 1], level[i + 1], !opener || decimal)) {
        refuse("thousands", piece(level.slice(i - 1, i + 2)));
      }
    }
    if (!decimal) return level;
    const joined = [];
    level.forEach((token, i) => {
      if (touching.includes(i - 1)) {
        const last = joined.pop();
        const both = last.text + "." + token.text;
        joined.push(newToken("number", both, last.shown + "," + token.shown, last.gap));
      } else if (!touching.includes(i)) joined.push(token);
    });
    return joined;
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

  // The value of what stands in one pair of brackets, or outside all: a list, or one value.
  const group = (level, opener, shown) => {
    const rows = split(level, [";"]).map((row) =>
      split(row, [",", "،"]).map((item) => calculate(item, opener)));
    if (!rows.length) refuse("missing", shown);
    let items = rows.length === 1 ? rows[0] : rows;
    if (rows.every((row) => row.length === 1)) items = rows.map((row) => row[0]);
    return items.length === 1 && !LISTS.includes(opener) ? items[0] : items;
  };

  // Cut at the separators; one at the end may be left over.
  const split = (level, separators) => {
    const parts = [[]];
    for (const token of level) {
      if (!separators.includes(token.kind)) parts.at(-1).push(token);
      else if (parts.at(-1).length) parts.push([]);
      else refuse("missing", token.shown);
    }
    return parts.at(-1).length ? parts : parts.slice(0, -1);
  };

  // The value of one item: a list, or a sum of products of signed factors.
  const calculate = (item, opener) => {
    let i = 0;

    const number = (value) => {
      if (Array.isArray(value)) refuse("list", piece(item));
      if (!Number.isFinite(value)) refuse("overflow", piece(item));
      return value;
    };

    const total = () => {
      let value = product();
      while (i < item.length && ["+", "-"].includes(item[i].kind)) {
        const sign = item[i];
        if (LISTS.includes(opener) && sign.gap && i + 1 < item.length && !item[i + 1].gap) {
          refuse("adjacent", piece(item.slice(i - 1, i + 2))); // [1 -pi]
        }
        i += 1;
        const left = number(value), right = number(product());
        value = number(sign.kind === "+" ? left + right : left - right);
      }
      if (i < item.length) refuse(item[i].kind === "power" ? "power" : "unknown", item[i].shown);
      return Array.isArray(value) ? value : value + 0; // no -0
    };

    const product = () => {
      let value = factor();
      let divided = false;
      while (i < item.length) {
        const kind = item[i].kind;
        if (kind === "*" || kind === "/") {
          i += 1;
          const left = number(value), right = number(factor());
          if (kind === "/" && right === 0) refuse("zero", piece(item));
          value = number(kind === "/" ? left / right : left * right);
          divided = kind === "/";
        } else if (multiplies()) {
          const loose = i > 1 && item[i - 2].kind === "√" && item[i - 1].kind !== "(";
          if (divided || loose) refuse("parentheses", piece(item));
          const left = number(value), right = number(factor());
          value = number(left * right);
        } else break;
      }
      return value;
    };

    // Whether a factor follows without a sign; what cannot follow is refused.
    const multiplies = () => {
      const token = item[i];
      if (token.kind === "name" && !known(token.text)) refuse("unit", piece(item.slice(i)));
      if (token.kind === "number" && doubtful(item[i - 1], token, true)) {
        refuse("thousands", piece(item.slice(i - 1, i + 1)));
      }
      const value = ["number", ...FRACTIONS.keys(), ...LISTS].includes(token.kind);
      const follows = ["name", "√", "("].includes(token.kind);
      if (value || (follows && LISTS.includes(opener) && token.gap)) {
        refuse("adjacent", piece(item.slice(i - 1, i + 1)));
      }
      return follows;
    };

    const factor = () => {
      const signs = [];
      for (; i < item.length && ["+", "-", "√"].includes(item[i].kind); i++) {
        signs.push(item[i].kind);
      }
      if (i === item.length) refuse("missing", item.at(-1).shown);
      let value = atom();
      for (const sign of signs.reverse()) {
        const operand = number(value);
        if (sign === "√" && operand < 0) refuse("root", piece(item));
        value = sign === "√" ? Math.sqrt(operand) : sign === "-" ? -operand : operand;
      }
      if (i < item.length && DEGREES.includes(item[i].text)) {
        i += 1;
        value = number(value) * (Math.PI / 180);
      }
      return value;
    };

    const atom = () => {
      const token = item[i];
      i += 1;
      const called = i < item.length && item[i].kind === "(";
      if (token.kind === "number") return number(Number(token.text));
      if (FRACTIONS.has(token.kind)) return FRACTIONS.get(token.kind);
      if (PAIRS.has(token.kind)) return group(token.inside, token.kind, token.shown);
      if (PI.includes(token.text)) return Math.PI;
      if (WRAPPERS.includes(token.text) && called) {
        i += 1;
        return group(item[i - 1].inside, "(", item[i - 1].shown);
      }
      if (NOT_FINITE.has(token.text)) refuse(NOT_FINITE.get(token.text), token.shown);
      if (token.kind === "name" && (called || known(token.text))) refuse("function", token.shown);
      if (SIGNS.includes(token.kind)) refuse("missing", token.shown);
      refuse(token.kind === "power" ? "power" : "unknown", token.shown);
    };

    return total();
  };

  // Whether a name is no unit; sin30 and atan2 are functions as well.
  const known = (name) => [...PI, ...WRAPPERS, ...NOT_FINITE.keys()].includes(name)
    || FUNCTIONS.includes(name.replace(/[0-9]+$/, ""));

  return read;
})();
