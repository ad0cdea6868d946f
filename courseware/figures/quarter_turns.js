// Quarter turns: a state is [presses, part of the last one that is made].

import { color } from "./svg.js";

const parsePresses = (text) => text.match(/-?./g) ?? [];

const parsePress = (press) => {
  const letter = press.at(-1), minus = press[0] === "-";
  return { axis: letter.toLowerCase(), own: letter < "a", minus, sign: minus ? "\u2212" : "+" };
};

const computeTurn = (press) => {
  const { axis, own, minus } = parsePress(press), k = "xyz".indexOf(axis), way = minus ? -1 : 1;
  const [i, j] = [(k + 1) % 3, (k + 2) % 3], unit = [0, 0, 0], R = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  unit[k] = way;
  R[4 * k] = 1;
  R[3 * i + j] = -way;
  R[3 * j + i] = way;
  return { unit, R, own };
};

const multiply = (A, B) => A.map((_, k) => {
  const row = 3 * Math.floor(k / 3), column = k % 3;
  return A[row] * B[column] + A[row + 1] * B[column + 3] + A[row + 2] * B[column + 6] + 0;
});

// For the formulas: the rotation before the last turn, its axis, whether about its own axes, part, count.
export const computeTurns = ([text, made]) => {
  const all = parsePresses(text).map(computeTurn), last = all[all.length - 1];
  const before = all.slice(0, -1).reduce(
    (R, turn) => (turn.own ? multiply(R, turn.R) : multiply(turn.R, R)), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  return [...before, ...(last?.unit ?? [0, 0, 0]), Number(last?.own ?? true), made, all.length];
};

const renderPress = (press) => {
  const { axis, own, minus, sign } = parsePress(press);
  return `<button type="button" data-press="${press}" aria-label="${minus ? "minus" : "plus"} 90° about `
    + `${own ? "its own" : "the room\u2019s"} ${axis} axis" style="color:${color(`${axis}_axis`)}">`
    + `${sign}<i>${axis}</i></button>`;
};

export const renderTurns = (control, i) => `<div class="rk-turning" data-i="${i}">`
  + [["about its own axes", "XYZ"], ["about the room’s axes", "xyz"]].map(([words, letters]) =>
    `<div role="group" aria-label="quarter turns ${words}"><span class="rk-name">${words}</span>`
    + `${[...letters].flatMap((letter) => [letter, `-${letter}`]).map(renderPress).join("")}</div>`)
    .join("") + "</div>";

export const describeTurns = (text) => parsePresses(text).map(parsePress)
  .map(({ axis, own, sign }) => `${sign}${axis} ${own ? "own" : "room"}`).join(", ") || "none";
