// Puts the tokens of brackets into brackets, and commas where blanks separate.

import { CLOSERS, joinTokens, LISTS, MAX_DEPTH, newToken, PAIRS, refuse } from "./tokenizing.js";

export const nestBrackets = (flat) => {
  const levels = [[]], opened = [];
  for (const token of flat) {
    const level = levels.at(-1);
    if (!opened.length && token.gap.includes("\n") && level.length && level.at(-1).kind !== ";") {
      level.push(newToken(";", ";", " "));
    }
    if (PAIRS.has(token.kind)) {
      if (opened.length === MAX_DEPTH) refuse("unknown", token.shown);
      level.push(token);
      opened.push(token);
      levels.push([]);
    } else if (CLOSERS.includes(token.kind)) closeBracket(opened.pop(), token, levels.pop());
    else level.push(token);
  }
  if (opened.length) refuse("brackets", opened.at(-1).shown);
  return levels[0];
};

const closeBracket = (start, token, level) => {
  if (PAIRS.get(start?.kind) !== token.kind) refuse("brackets", token.shown);
  start.shown = joinTokens([start, ...level, token]);
  start.inside = separateBlanks(level, start.kind);
};

// Put commas where blanks separate, and semicolons for new lines: between plain numbers or lists in [ ] and { }.
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
    const { kind, gap } = level[i], sign = !LISTS.includes(kind) && gap.includes("\n") ? ";" : ",";
    level = [...level.slice(0, i), newToken(sign, sign, " "), ...level.slice(i)];
  }
  return level;
};
