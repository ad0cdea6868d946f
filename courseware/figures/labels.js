// Labels, which get out of each other's way.

import { renderSymbols } from "../script/text.js";
import { color, px, symbolData } from "./svg.js";

// A label beside a place in pixels; toward: where it stands if that is free, in steps around it,
// as far as its box must go to be clear of the place.
export const addLabel = (to, x, y, shape, toward = [1, -1]) => {
  const most = Math.max(...toward.map(Math.abs)) || 1;
  if (shape.label) to.labels.push({ x, y, shape, toward: toward.map((step) => step / most) });
  return "";
};

const AROUND = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];
const FAR = [4, 12, 22, 34, 48, 66, 90, 120]; // pixels between a place and its label
export const overlaps = ([a, b, c, d]) => ([p, q, r, s]) => a < r && p < c && b < s && q < d;

// How wide a text will be, rather too much than too little; marks above letters take no room.
const textWidth = (text) => [...text.normalize("NFC").replace(/[\u0300-\u036f]/g, "")]
  .reduce((sum, sign) => sum + (/[ .,:()'|lij⁰¹²³⁴-⁹⁻]/.test(sign) ? 5.5 : /[mwMW]|[^\0-~]/.test(sign) ? 13 : 10), 0);

// An index has a thin edge of ground only, because it is painted after its letter, and over it.
const renderLabel = ({ x, y, shape }) => `<text x="${px(x)}" y="${px(y + 5)}" text-anchor="middle"`
  + `${symbolData(shape)} style="fill:${color(shape.kind)};stroke:var(--rk-ground,#fff);`
  + `stroke-width:5px;stroke-linejoin:round;paint-order:stroke;font:italic 15px serif">`
  + renderSymbols(shape.label, '$1<tspan dx="1" dy="4" font-size="75%" font-style="normal" stroke-width="2">$2</tspan>')
  + "</text>";

// Each label takes the first place that is inside the picture and free of handles and of the labels
// before it. → their text, and the boxes that are taken.
export const placeLabels = ({ labels, taken: already }, grips, [width, height]) => {
  const taken = [...already, ...grips.map(([x, y]) => [x - 10, y - 10, x + 10, y + 10])];
  const texts = labels.map((one) => {
    const w = textWidth(one.shape.label) / 2, h = 11, ways = [one.toward, ...AROUND];
    const spots = FAR.flatMap((far) => ways.map(([dx, dy]) => [
      Math.min(width - w - 2, Math.max(w + 2, one.x + dx * (w + far))),
      Math.min(height - h - 2, Math.max(h + 2, one.y + dy * (h + far))),
    ]));
    const box = ([x, y]) => [x - w, y - h, x + w, y + h];
    const [x, y] = spots.find((spot) => !taken.some(overlaps(box(spot)))) ?? spots[0];
    taken.push(box([x, y]));
    return renderLabel({ ...one, x, y });
  });
  return [texts.join(""), taken];
};
