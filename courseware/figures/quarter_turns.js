// Quarter turns: a state is [presses, part of the last one that is made].

import { color } from "./svg.js";

export const parsePresses = (text) => (/^(-?[xyz])*$/i.test(text) && text.match(/-?./g)) || [];

const parseQuarterTurn = (press) => {
  const axis = "xyz".indexOf(press.slice(-1).toLowerCase()), sign = press[0] === "-" ? -1 : 1;
  const unit = [0, 1, 2].map((k) => (k === axis ? sign : 0));
  const [i, j] = [(axis + 1) % 3, (axis + 2) % 3], R = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  R[4 * axis] = 1;
  R[3 * i + j] = -sign;
  R[3 * j + i] = sign;
  return { unit, R, own: press.slice(-1) < "a" };
};

const multiply = (A, B) => A.map((_, k) => {
  const row = 3 * Math.floor(k / 3), column = k % 3;
  return A[row] * B[column] + A[row + 1] * B[column + 3] + A[row + 2] * B[column + 6] + 0;
});

// For the formulas: the rotation before the last turn, its axis, whether about its own axes, part, count.
export const computeTurns = ([text, made]) => {
  const all = parsePresses(text).map(parseQuarterTurn), last = all[all.length - 1];
  const before = all.slice(0, -1).reduce(
    (R, turn) => (turn.own ? multiply(R, turn.R) : multiply(turn.R, R)), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  return [...before, ...(last?.unit ?? [0, 0, 0]), Number(last?.own ?? true), made, all.length];
};

const renderPress = (press) => {
  const letter = press.slice(-1), words = press[0] === "-" ? "minus" : "plus";
  return `<button type="button" data-press="${press}" aria-label="${words} 90° about `
    + `${letter < "a" ? "its own" : "the room\u2019s"} ${letter.toLowerCase()} axis" `
    + `style="color:${color(`${letter.toLowerCase()}_axis`)}">`
    + `${press[0] === "-" ? "\u2212" : "+"}<i>${letter.toLowerCase()}</i></button>`;
};

export const renderTurns = (control, i) => `<div class="rk-turning" data-i="${i}">`
  + [["about its own axes", "XYZ"], ["about the room’s axes", "xyz"]].map(([words, letters]) =>
    `<div role="group" aria-label="quarter turns ${words}"><span class="rk-name">${words}</span>`
    + `${[...letters].flatMap((letter) => [letter, `-${letter}`]).map(renderPress).join("")}</div>`)
    .join("") + "</div>";

export const describeTurns = (text) => parsePresses(text).map((press) =>
  `${press[0] === "-" ? "\u2212" : "+"}${press.slice(-1).toLowerCase()}`
  + ` ${press.slice(-1) < "a" ? "own" : "room"}`).join(", ") || "none";
