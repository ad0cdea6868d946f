// Labels, which get out of the way of each other and of what is drawn.

import { escapeHtml } from "../units/text.js";
import { KINDS } from "./constants.js";
import { color, drawLine, FONT, px, symbolData } from "./svg.js";

// A label beside a place in pixels; toward: where it is placed if that is free, in steps around it,
// as far as its box must go to be clear of the place.
export const addLabel = (to, x, y, shape, toward = [1, -1]) => {
  const most = Math.max(...toward.map(Math.abs)) || 1;
  if (shape.label) to.labels.push({ x, y, shape, toward: toward.map((step) => step / most) });
};

const AROUND = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];
const FAR = [4, 12, 22, 34, 48, 66, 90, 120], BESIDE = 22; // pixels between a place and its label; up to BESIDE without a leader
export const overlaps = ([a, b, c, d]) => (box) => a < box[2] && box[0] < c && b < box[3] && box[1] < d;

// A text in pieces: letters of formulas with their mark and index ("θ̇_1", but no unit), all else.
const UNIT = /(\d[ \u00a0]?|\/|\bin )$/; // before a letter, which is a unit then
const splitLetters = (text) => {
  const words = text.normalize("NFD").split(/(\p{L}[\p{L}\p{M}]*(?:'\p{L}+|_\w+)?)/u);
  return words.map((word, i) => {
    const [, letter, mark, index = ""] = /^(\p{L})(\u0307?)(?:_(\w+))?$/u.exec(word) ?? [];
    return letter && !UNIT.test(words.slice(0, i).join("")) ? { letter, mark, index } : { word };
  }).filter(({ letter, word }) => letter || word);
};

// How wide a text will be, rather too much than too little; marks above letters take no room.
const wordWidth = (word) => [...word].reduce((sum, sign) =>
  sum + (/[ .,:()'|lijtfr]/.test(sign) ? 5.3 : /[mwMW∞]/.test(sign) ? 14 : /[^a-z]/.test(sign) ? 10 : 9), 0);
const textWidth = (pieces) => pieces.reduce((sum, { letter, index, word }) =>
  sum + (letter ? 13 + 7.5 * index.length : wordWidth(word)), 1);

const UPRIGHT = "KaTeX_Main,'Latin Modern Roman',serif";
const MATH = "font:italic 17px KaTeX_Math,'Latin Modern Math','STIX Two Math',serif";

const LOW = /[acegm-suvwxyzαγεηικμνπρστυφω]/; // letters under a dot that is not raised

// Each piece at its height above the line of the text. A dot is above its letter; an index, or what
// touches a letter, has a thin edge of ground only, because it is painted after it, and over it.
const renderPieces = (pieces) => {
  let at = 0;
  const render = (text, high, style = "", dx = 0) => {
    const shift = (dx ? ` dx="${dx}"` : "") + (high === at ? "" : ` dy="${at - high}"`);
    at = high;
    return `<tspan${shift}${style && ` style="${style}"`}>${escapeHtml(text)}</tspan>`;
  };
  return pieces.map(({ letter, mark, index, word }, i) => word ? render(word.normalize("NFC"), 0, i && /^\S{1,3}$/.test(word) ? "stroke-width:2px" : "")
    : render(letter, 0, MATH) + (mark && render("\u02d9", LOW.test(letter) ? 0 : 4, `font:17px ${UPRIGHT}`, -8))
      + (index && render(index, -4, `font:12px ${UPRIGHT};stroke-width:2px`, mark ? 3 : 1))).join("");
};

// Where it is is a transform: a text that is only moved is not laid out again. On a thing, which is
// light on dark pages too, it is dark on a light halo; far from its place, a line leads there.
const renderLabel = ({ x, y, shape, isOn, leader }, pieces) => ["g", {}, [
  ...(leader ? [drawLine(leader, `fill:none;stroke:${color(shape.kind)};stroke-width:1`)] : []),
  ["g", { transform: `translate(${px(x)} ${px(y + 5)})` }, [["text", {
    "text-anchor": "middle",
    style: `fill:${isOn ? KINDS[shape.kind].light : color(shape.kind)};stroke:${isOn ? "var(--m-shell,#fff)" : "var(--rk-ground,#fff)"}`
      + `;stroke-width:${isOn ? 3 : 5}px;stroke-linejoin:round;paint-order:stroke;${FONT}`, ...symbolData(shape),
  }, renderPieces(pieces)]]]]];

const BEYOND = 20; // pixels: what lies farther outside has no label

const boxOf = (points) => {
  const all = [0, 1].map((axis) => points.map((point) => point[axis]));
  return [...all.map((some) => Math.min(...some)), ...all.map((some) => Math.max(...some))];
};
const crosses = ([a, b], [c, d], [left, top, right, low]) => {
  if ((a < left && c < left) || (a > right && c > right) || (b < top && d < top) || (b > low && d > low)) return false;
  const side = (x, y) => (c - a) * (y - b) > (d - b) * (x - a), first = side(left, top);
  return side(right, top) !== first || side(left, low) !== first || side(right, low) !== first;
};
const contains = (corners, x, y) => corners.reduce((odd, [a, b], i) => {
  const [c, d] = corners.at(i - 1);
  return (b > y) !== (d > y) && x < (c - a) * (y - b) / (d - b) + a ? !odd : odd;
}, false);

// What a label costs in a box: a line below it, an outline across it, a thing all round it.
const LINE = 30, OUTLINE = 60, ON = 35, FREE = 1000, WAY = 0.4; // WAY: of a pixel from its place
const costOf = (box, x, y, obstacles, taken) => {
  const meets = overlaps(box);
  return obstacles.reduce((sum, { points, isBody, around }) => {
    if (!meets(around)) return sum;
    if (points.some((point, i) => i > 0 && crosses(points[i - 1], point, box))) return sum + (isBody ? OUTLINE : LINE);
    return sum + (isBody && contains(points, x, y) ? ON : 0);
  }, FREE * taken.filter(meets).length);
};

// Plain text, such as the numbers of an axis, stays where it was put: what has a symbol gives way.
const stays = ({ shape: { shape, kind } }) => shape === "label" && kind === "text";

// bodies: outlines of things, and faces; lines: all else. Each label takes the place inside the picture
// that costs least. → their nodes, and the boxes that are taken.
export const placeLabels = ({ labels: all, taken: already }, grips, [width, height], bodies, lines) => {
  const labels = all.filter(({ x, y }) =>
    Math.abs(x - width / 2) < width / 2 + BEYOND && Math.abs(y - height / 2) < height / 2 + BEYOND);
  labels.sort((one, other) => stays(other) - stays(one));
  const taken = [...already, ...grips.map(([x, y]) => [x - 10, y - 10, x + 10, y + 10])];
  const closed = bodies.filter((points) => points.length).map((points) => [...points, points[0]]);
  const obstacles = [closed, lines].flatMap((part) => part.map((points) => ({ points, isBody: part === closed, around: boxOf(points) })));
  const nodes = labels.map((label) => {
    const { x: x0, y: y0, toward, shape } = label, ways = stays(label) ? [toward] : [toward, ...AROUND];
    const pieces = splitLetters(shape.label), w = textWidth(pieces) / 2, h = pieces.some(({ mark }) => mark) ? 15 : 11;
    let best = { cost: Infinity };
    for (const far of FAR) {
      if (WAY * far < best.cost) ways.forEach(([dx, dy], k) => {
        const cost = WAY * far + (k && 3), x = Math.min(width - w - 2, Math.max(w + 2, x0 + dx * (w + far)));
        const y = Math.min(height - h - 2, Math.max(h + 2, y0 + dy * (h + far))), box = [x - w, y - h, x + w, y + h];
        const all = cost < best.cost ? cost + costOf(box, x, y, obstacles, taken) : Infinity;
        if (all < best.cost) best = { cost: all, x, y, box, far };
      });
    }
    const { x, y, box, far } = best, isOn = closed.some((corners) => contains(corners, x, y));
    taken.push(box);
    const [dx, dy] = [x0 - x, y0 - y], edge = Math.min(1, w / Math.abs(dx), h / Math.abs(dy));
    const leader = far > BESIDE && toward.some(Boolean) && [[x0, y0], [x + edge * dx, y + edge * dy]];
    return renderLabel({ x, y, shape, isOn, leader }, pieces);
  });
  return [nodes, taken];
};
