// Puts the tokens of brackets into brackets, and settles what commas and blanks mean.
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

import {
  CLOSERS, LISTS, MAX_DEPTH, mayBeThousands, newToken, PAIRS, refuse, SIGNS, joinTokens,
} from "./tokenizing.js";

// Put what stands in brackets inside the opening bracket; settle commas and blanks.
export const nestBrackets = (flat) => {
  const point = flat.some((t) => t.kind === "number" && t.text.includes("."));
  const levels = [[]], opened = [];
  for (const token of flat) {
    const level = levels.at(-1);
    if (!opened.length && token.gap.includes("\n") && level.length && level.at(-1).kind !== ";") {
      level.push(newToken(";", ";", " "));
    }
    if (PAIRS.has(token.kind)) {
      if (opened.length === MAX_DEPTH) refuse("deep", token.shown);
      token.inside = level.slice(-1); // until it closes: what stands before it
      level.push(token);
      opened.push(token);
      levels.push([]);
    } else if (CLOSERS.includes(token.kind)) closeBracket(opened.pop(), token, levels.pop(), point);
    else level.push(token);
  }
  if (opened.length) refuse("brackets", opened.at(-1).shown);
  return joinDecimals(levels[0], "", point);
};

// Put a level inside the bracket that opened it.
const closeBracket = (start, token, level, point) => {
  if (PAIRS.get(start?.kind) !== token.kind) refuse("brackets", token.shown);
  const root = start.kind === "(" && start.inside.some((t) => t.kind === "√");
  start.shown = joinTokens([start, ...level, token]);
  start.inside = separateBlanks(joinDecimals(level, root ? "√" : start.kind, point), start.kind);
};

// Join numbers at decimal commas, by the four rules.
const joinDecimals = (level, opener, point) => {
  const places = findTightCommas(level);
  if (!places.length) return level;
  const decimal = areCommasDecimal(level, places, opener, point);
  for (const i of places) {
    if (mayBeThousands(level[i - 1], level[i + 1], !opener || decimal)) {
      const point = level[i - 1].text.includes(".") || level[i + 1].text.includes(".");
      refuse(point || places.includes(i + 2) ? "thousands" : "decimal", joinTokens(level.slice(i - 1, i + 2)));
    }
  }
  return decimal ? joinNumbers(level, places) : level;
};

// Where a comma touches a digit on both sides.
const findTightCommas = (level) => [...level.keys()].filter((i) =>
  level.slice(i - 1, i + 2).map((t) => t.kind).join(" ") === "number , number"
  && level[i].gap + level[i + 1].gap === "" && !level[i - 1].text.includes("e"));

const areCommasDecimal = (level, places, opener, point) => {
  const kinds = level.map((t) => t.kind), first = level.slice(places[0] - 1, places[0] + 2);
  if (point || places.some((i) => places.includes(i + 2))) return false;
  if (opener === "√") return true;
  const listed = (i) => kinds[i + 2] === "number" // 0,5 1,5
    || kinds[i - 2] === "number" && !mayBeThousands(level[i - 2], level[i - 1], true);
  if (places.some(listed)) refuse("comma", joinTokens(level));
  const spaced = kinds.includes("،")
    || kinds.some((kind, i) => kind === "," && i + 1 < level.length && level[i + 1].gap !== "");
  if (spaced || kinds.includes(";")) {
    if (opener && !spaced) refuse("comma", joinTokens(first));
    return true;
  }
  if (opener) return false;
  const worked = kinds.some((kind, i) =>
    i > 0 && SIGNS.includes(kind) && ![...SIGNS, ",", ";", "√"].includes(kinds[i - 1]));
  if (worked) refuse("comma", joinTokens(first));
  return kinds.filter((kind) => kind === ",").length === 1;
};

// The level with a decimal number for each comma and its two numbers.
const joinNumbers = (level, places) => {
  const found = [];
  level.forEach((token, i) => {
    if (places.includes(i - 1)) {
      const last = found.pop(), both = last.text + "." + token.text;
      found.push(newToken("number", both, last.shown + "," + token.shown, last.gap));
    } else if (!places.includes(i)) found.push(token);
  });
  return found;
};

// Put commas where blanks separate: between plain numbers or lists in [ ] and { }.
const separateBlanks = (level, opener) => {
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
    if (token.kind === "number" && mayBeThousands(level[i - 1], token)) {
      refuse("thousands", joinTokens(level.slice(i - 1, i + 1)));
    }
    if (!LISTS.includes(token.kind) && token.gap.includes("\n")) {
      refuse("adjacent", joinTokens(level.slice(i - 1, i + 1)));
    }
    level = [...level.slice(0, i), newToken(",", ",", " "), ...level.slice(i)];
  }
  return level;
};
