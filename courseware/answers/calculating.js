// Turns nested tokens into numbers and lists.

import {
  FRACTIONS, FUNCTIONS, LISTS, PAIRS, PI, refuse, SIGNS, joinTokens, WRAPPERS,
} from "./tokenizing.js";
import { DEGREES } from "../units/constants.js";

// The value of the content of one pair of brackets, or outside all: a list, or one value.
export const evaluateGroup = (level, opener, shown) => {
  const rows = split(level, [";"]).map((row) =>
    split(row, [",", "،"]).map((item) => new Expression(item, opener).total()));
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

// Whether a name is no unit; sin30 and atan2 are functions as well.
const isKnownName = (name) => [...PI, ...WRAPPERS].includes(name)
  || FUNCTIONS.includes(name.replace(/[0-9]+$/, ""));

// One item, read from left to right: a list, or a sum of products of signed factors.
class Expression {
  constructor(tokens, opener) {
    Object.assign(this, { tokens, opener, i: 0 });
  }

  ended() { return this.i >= this.tokens.length; }

  // A part of it, as it was typed.
  typed(start = 0, end = this.tokens.length) { return joinTokens(this.tokens.slice(start, end)); }

  number(value) {
    if (Array.isArray(value)) refuse("list", this.typed());
    if (!Number.isFinite(value)) refuse("overflow", this.typed());
    return value;
  }

  total() {
    let value = this.product();
    while (!this.ended() && ["+", "-"].includes(this.tokens[this.i].kind)) {
      const sign = this.tokens[this.i], next = this.tokens[this.i + 1];
      if (LISTS.includes(this.opener) && sign.gap && next && !next.gap) {
        refuse("adjacent", this.typed(this.i - 1, this.i + 2)); // [1 -pi]
      }
      this.i += 1;
      const left = this.number(value), right = this.number(this.product());
      value = this.number(sign.kind === "+" ? left + right : left - right);
    }
    if (!this.ended()) {
      const { kind, shown } = this.tokens[this.i];
      refuse(kind === "power" ? "power" : "unknown", shown);
    }
    return Array.isArray(value) ? value : value + 0; // no -0
  }

  product() {
    let value = this.factor(), divided = false;
    while (!this.ended()) {
      const { kind } = this.tokens[this.i];
      if (kind === "*" || kind === "/") {
        this.i += 1;
        const left = this.number(value), right = this.number(this.factor());
        if (kind === "/" && right === 0) refuse("zero", this.typed());
        // 45/2° is no 45/(2°)
        if (kind === "/" && DEGREES.includes(this.tokens[this.i - 1].text)) refuse("parentheses", this.typed());
        value = this.number(kind === "/" ? left / right : left * right);
        divided = kind === "/";
      } else if (this.multiplies()) {
        const [before, last] = this.tokens.slice(Math.max(0, this.i - 2), this.i);
        if (divided || (last && before.kind === "√" && last.kind !== "(")) {
          refuse("parentheses", this.typed());
        }
        const left = this.number(value), right = this.number(this.factor());
        value = this.number(left * right);
      } else break;
    }
    return value;
  }

  // Whether a factor follows without a sign; what cannot follow is refused.
  multiplies() {
    const { i, tokens, opener } = this, token = tokens[i];
    if (token.kind === "name" && !isKnownName(token.text)) refuse("unit", this.typed(i));
    const value = ["number", ...FRACTIONS.keys(), ...LISTS].includes(token.kind);
    const follows = ["name", "√", "("].includes(token.kind);
    if (value || (follows && LISTS.includes(opener) && token.gap)) {
      refuse("adjacent", this.typed(i - 1, i + 1));
    }
    return follows;
  }

  factor() {
    const signs = [];
    for (; !this.ended() && ["+", "-", "√"].includes(this.tokens[this.i].kind); this.i++) {
      signs.push(this.tokens[this.i].kind);
    }
    if (this.ended()) refuse("missing", this.tokens.at(-1).shown);
    let value = this.atom();
    for (const sign of signs.reverse()) {
      const operand = this.number(value);
      if (sign === "√" && operand < 0) refuse("root", this.typed());
      value = sign === "√" ? Math.sqrt(operand) : sign === "-" ? -operand : operand;
    }
    if (!this.ended() && DEGREES.includes(this.tokens[this.i].text)) {
      this.i += 1;
      value = this.number(value) * (Math.PI / 180);
    }
    return value;
  }

  atom() {
    const token = this.tokens[this.i++], next = this.tokens[this.i], { kind, text, shown } = token;
    const called = next?.kind === "(";
    if (kind === "number") return this.number(Number(text));
    if (FRACTIONS.has(kind)) return FRACTIONS.get(kind);
    if (PAIRS.has(kind)) return evaluateGroup(token.inside, kind, shown);
    if (PI.includes(text)) return Math.PI;
    if (WRAPPERS.includes(text) && called) {
      this.i += 1;
      return evaluateGroup(next.inside, "(", next.shown);
    }
    if (kind === "name" && (called || isKnownName(text))) refuse("function", shown);
    if (SIGNS.includes(kind)) refuse("missing", shown);
    return refuse(kind === "power" ? "power" : "unknown", shown);
  }
}
