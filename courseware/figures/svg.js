// How lines, areas and texts of a kind look, as attributes of nodes.

import { GRADIENTS, KINDS, TONES } from "./constants.js";

export const color = (kind) => `var(--rk-${kind},${KINDS[kind].light})`;
// A material's colour; of one with form, its definition.
export const paint = (name) => name in GRADIENTS ? `url(#rk-${name})`
  : name in TONES ? `var(--m-${name},${TONES[name]})` : color(name);
export const stroke = (kind, extra = "") => {
  const { dash, width } = KINDS[kind];
  const dashes = dash.length ? `;stroke-dasharray:${dash.join(" ")}` : "";
  return `fill:none;stroke:${color(kind)};stroke-width:${width}${dashes}${extra}`;
};
export const fill = (kind, opacity = 1) => `fill:${color(kind)};stroke:none`
  + (opacity < 1 ? `;fill-opacity:${opacity}` : "");
// A line in the ground's colour round what must be seen on all that it crosses.
const GROUND = "var(--rk-ground,#fff)", CASING = 3.4;
export const casing = (kind) => `fill:none;stroke:${GROUND};stroke-width:${KINDS[kind].width + CASING}`;
export const headCasing = `fill:${GROUND};stroke:${GROUND};stroke-width:${CASING};stroke-linejoin:round`;
// The page's own letters.
export const FONT = "font:15px var(--pst-font-family-base,system-ui,sans-serif)";
export const path = (d, style) => ["path", { d, style }];
// Mark what belongs to a quantity with its key.
export const symbolData = ({ symbol }) => (symbol ? { "data-symbol": symbol } : {});
export const px = (number) => Math.round(100 * number) / 100;
export const writePoint = ([x, y]) => `${Math.round(10 * x) / 10} ${Math.round(10 * y) / 10}`;

export const polyline = (points) => points
  .map(([x, y], i) => `${points[i - 1]?.every(Number.isFinite) ? "L" : "M"}${px(x)} ${px(y)}`)
  .filter((piece) => !/NaN|Infinity/.test(piece)).join("");
// Not a path, if it has no gap: what a browser knows of a path's form is its style, which is worked out anew.
export const drawLine = (points, style) => points.every(([x, y]) => Number.isFinite(x + y))
  ? ["polyline", { points: points.map(writePoint).join(" "), style }]
  : path(polyline(points), style);
