// The ground of a picture: tiles with a scale bar, or squared paper with numbers.

import { GROUNDS } from "./constants.js";
import { formatFixed } from "./figure_text.js";
import { overlaps } from "./labels.js";
import { color, FONT, paint, path, px, stroke } from "./svg.js";

export const toneOf = (figure) => paint(GROUNDS[figure.ground].tone);

// About a sixth of the picture, as a round length.
const roundLength = (view) => {
  const rough = (view[1] - view[0]) / 6, power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough * 0.99);
};

const multiples = (step, low, high) => {
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step);
};

export const renderGround = (figure, view, to, size, taken) => {
  if (figure.ground) return renderTiles(figure, view, to, size);
  return figure.grid === false ? [] : renderGrid(view, to, size, taken);
};

const linesOf = (view, to, [width, height]) => {
  const step = roundLength(view);
  const across = multiples(step, view[0], view[1]).map((x) => px(to([x, 0])[0]));
  const up = multiples(step, view[2], view[3]).map((y) => px(to([0, y])[1]));
  return across.map((x) => `M${x} 0V${px(height)}`).join("") + up.map((y) => `M0 ${y}H${px(width)}`).join("");
};

const renderTiles = (figure, view, to, size) => {
  const { fill, seam, light } = GROUNDS[figure.ground];
  const floor = ["rect", { width: "100%", height: "100%", style: `fill:${paint(fill)}` }];
  if (!seam) return [floor];
  const lines = linesOf(view, to, size), line = (tone, width) => `fill:none;stroke:${paint(tone)};stroke-width:${width}`;
  return [floor, path(lines, line(seam, 2)),
    ["g", { transform: "translate(1.4 1.4)" }, [path(lines, line(light, 0.9))]]];
};

// A bar as long as a tile, at the lower left.
export const renderScale = (figure, view, to, height) => {
  if (!figure.ground || !GROUNDS[figure.ground].seam) return [];
  const step = roundLength(view), long = px(step * to.scale), y = px(height - 12);
  to.taken.push([10, y - 24, 18 + long, height]);
  const words = step >= 1 ? `${step} m` : `${Math.round(100 * step)} cm`;
  const style = `${FONT};stroke:var(--rk-ground,#fff);stroke-width:4.5px;paint-order:stroke`;
  return [path(`M14 ${y - 4}v8m0 -4h${long}m0 -4v8`, `fill:none;stroke:${color("text")};stroke-width:1.4`),
    ["text", { x: px(14 + long / 2), y: y - 7, "text-anchor": "middle", style: `fill:${color("text")};${style}` }, words]];
};

// A number of the grid gives way to all labels.
const renderGridNumber = (taken, x, y, words, anchor = "start") => {
  const left = anchor === "end" ? x - 6.2 * words.length : x;
  if (taken.some(overlaps([left, y - 11, left + 6.2 * words.length, y + 3]))) return [];
  const style = `fill:${color("text")};fill-opacity:.7;font:11px sans-serif`;
  return [["text", { x: px(x), y: px(y), "text-anchor": anchor, style }, words]];
};

const renderGrid = (view, to, [width, height], taken) => {
  const step = roundLength(view), digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const number = (value, x, y) => renderGridNumber(taken, x, y, formatFixed(value, digits));
  return [path(linesOf(view, to, [width, height]), stroke("grid")),
    ...multiples(step, view[0], view[1]).flatMap((value) => {
      const [x] = to([value, 0]);
      return x > 40 && x < width - 72 ? number(value, x + 3, height - 5) : [];
    }),
    ...multiples(step, view[2], view[3]).flatMap((value) => {
      const [, y] = to([0, value]);
      return y > 20 && y < height - 30 ? number(value, 4, y - 3) : [];
    }),
    ...renderGridNumber(taken, width - 5, height - 5, "x, y in m", "end")];
};
