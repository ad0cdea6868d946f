// Labels, which get out of each other's way.

import { escapeHtml } from "../units/text.js";
import { color, px, symbolData } from "./svg.js";

// A label beside a place in pixels; toward: where it stands if that is free, in steps around it,
// as far as its box must go to be clear of the place.
export const addLabel = (to, x, y, shape, toward = [1, -1]) => {
  const most = Math.max(...toward.map(Math.abs)) || 1;
  if (shape.label) to.labels.push({ x, y, shape, toward: toward.map((step) => step / most) });
};

const AROUND = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];
const FAR = [4, 12, 22, 34, 48, 66, 90, 120]; // pixels between a place and its label
export const overlaps = ([a, b, c, d]) => ([p, q, r, s]) => a < r && p < c && b < s && q < d;

// A text in pieces: letters of formulas with their mark and index ("θ̇_1", but no unit), all else.
const UNIT = /(\d[ \u00a0]?|\/|\bin )$/; // before a letter, which is a unit then
const splitLetters = (text) => {
  const words = text.normalize("NFD").split(/(\p{L}[\p{L}\p{M}]*(?:_\w+)?)/u);
  return words.map((word, i) => {
    const [, letter, mark, index = ""] = /^(\p{L})(\u0307?)(?:_(\w+))?$/u.exec(word) ?? [];
    return letter && !UNIT.test(words.slice(0, i).join("")) ? { letter, mark, index } : { word };
  }).filter(({ letter, word }) => letter || word);
};

// How wide a text will be, rather too much than too little; marks above letters take no room.
const wordWidth = (word) => [...word].reduce((sum, sign) =>
  sum + (/[ .,:()'|lijtfr]/.test(sign) ? 5 : /[mwMW∞]/.test(sign) ? 13 : /[^a-z]/.test(sign) ? 9.5 : 8.5), 0);
const textWidth = (pieces) => pieces.reduce((sum, { letter, index, word }) =>
  sum + (letter ? 13 + 7.5 * index.length : wordWidth(word)), 1);

const WORDS = "font:14px system-ui,sans-serif", UPRIGHT = "KaTeX_Main,'Latin Modern Roman',serif";
const MATH = "font:italic 17px KaTeX_Math,'Latin Modern Math','STIX Two Math',serif";

// Each piece at its height above the line of the text. A dot stands over its letter; an index has a
// thin edge of ground only, because it is painted after its letter, and over it.
const renderPieces = (pieces) => {
  let at = 0;
  const render = (text, high, style = "", dx = 0) => {
    const shift = (dx ? ` dx="${dx}"` : "") + (high === at ? "" : ` dy="${at - high}"`);
    at = high;
    return `<tspan${shift}${style && ` style="${style}"`}>${escapeHtml(text)}</tspan>`;
  };
  return pieces.map(({ letter, mark, index, word }) => word ? render(word.normalize("NFC"), 0)
    : render(letter, 0, MATH) + (mark && render("\u02d9", 0, `font:17px ${UPRIGHT}`, -8))
      + (index && render(index, -4, `font:12px ${UPRIGHT};stroke-width:2px`, mark ? 3 : 1))).join("");
};

// Where it stands is a transform: a text that is only moved is not laid out again.
const renderLabel = ({ x, y, shape }, pieces) => ["g", { transform: `translate(${px(x)} ${px(y + 5)})` }, [["text", {
  "text-anchor": "middle",
  style: `fill:${color(shape.kind)};stroke:var(--rk-ground,#fff);stroke-width:5px;`
    + `stroke-linejoin:round;paint-order:stroke;${WORDS}`, ...symbolData(shape),
}, renderPieces(pieces)]]];

const BEYOND = 20; // pixels: what lies farther outside has no label

// Each label takes the first place that is inside the picture and free of handles and of the labels
// before it. → their nodes, and the boxes that are taken.
export const placeLabels = ({ labels: all, taken: already }, grips, [width, height]) => {
  const labels = all.filter(({ x, y }) =>
    Math.abs(x - width / 2) < width / 2 + BEYOND && Math.abs(y - height / 2) < height / 2 + BEYOND);
  const taken = [...already, ...grips.map(([x, y]) => [x - 10, y - 10, x + 10, y + 10])];
  const nodes = labels.map((one) => {
    const pieces = splitLetters(one.shape.label);
    const w = textWidth(pieces) / 2, h = 11, ways = [one.toward, ...AROUND];
    const spots = FAR.flatMap((far) => ways.map(([dx, dy]) => [
      Math.min(width - w - 2, Math.max(w + 2, one.x + dx * (w + far))),
      Math.min(height - h - 2, Math.max(h + 2, one.y + dy * (h + far))),
    ]));
    const box = ([x, y]) => [x - w, y - h, x + w, y + h];
    const [x, y] = spots.find((spot) => !taken.some(overlaps(box(spot)))) ?? spots[0];
    taken.push(box([x, y]));
    return renderLabel({ ...one, x, y }, pieces);
  });
  return [nodes, taken];
};
