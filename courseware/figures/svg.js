// How lines, areas and texts of a kind look.

import { KINDS } from "./constants.js";

export const color = (kind) => `var(--rk-${kind},${KINDS[kind].light})`;
export const stroke = (kind, extra = "") => {
  const { dash, width } = KINDS[kind];
  const dashes = dash.length ? `;stroke-dasharray:${dash.join(" ")}` : "";
  return `style="fill:none;stroke:${color(kind)};stroke-width:${width}${dashes}${extra}"`;
};
export const fill = (kind) => `style="fill:${color(kind)};stroke:none"`;
// Mark what belongs to a quantity with its key.
export const symbolData = ({ symbol }) => (symbol ? ` data-symbol="${symbol}"` : "");
export const px = (number) => Number(number.toFixed(2));

export const polyline = (points) => points
  .map(([x, y], i) => `${i && Number.isFinite(points[i - 1][0]) ? "L" : "M"}${px(x)} ${px(y)}`)
  .filter((piece) => !/NaN|Infinity/.test(piece)).join("");
