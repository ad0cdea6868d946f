// The whole picture of a figure as SVG.

import { escapeHtml, fillTemplate } from "../script/text.js";
import { describeFigure, formatFixed, textsByKey } from "./figure_text.js";
import { overlaps, placeLabels } from "./labels.js";
import { arrowToOutside, SHAPES } from "./shapes.js";
import { drawSolid, isCovered } from "./solids.js";
import { compute, settings, startState } from "./state.js";
import { color, px, stroke, symbolData } from "./svg.js";

// Pixels, before a page tells how wide it is.
export const widthOf = ({ size }) => (size === "step" ? 460 : 640);

// From world coordinates to pixels; it gathers the labels, which are placed
// when all is drawn, and the boxes of other texts.
export const createProjection = (view, width) => {
  const scale = width / (view[1] - view[0]);
  const to = ([x, y]) => [(x - view[0]) * scale, (view[3] - y) * scale];
  return Object.assign(to, { scale, labels: [], taken: [] });
};

export const heightOf = ({ view }, width) => px(width * (view[3] - view[2]) / (view[1] - view[0]));

// A number of the grid gives way to all labels.
const renderGridNumber = (taken, x, y, words, anchor = "start") => {
  const left = anchor === "end" ? x - 6.2 * words.length : x;
  return taken.some(overlaps([left, y - 11, left + 6.2 * words.length, y + 3])) ? ""
    : `<text x="${px(x)}" y="${px(y)}" text-anchor="${anchor}" `
    + `style="fill:${color("text")};fill-opacity:.7;font:11px sans-serif">${words}</text>`;
};

const renderGrid = (view, to, width, height, taken) => {
  const rough = (view[1] - view[0]) / 6, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough * 0.99);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  let lines = "", numbers = "";
  for (let k = Math.ceil(view[0] / step); k * step <= view[1]; k++) {
    const [x] = to([k * step, 0]).map(px);
    lines += `M${x} 0V${px(height)}`;
    if (x > 40 && x < width - 72) numbers += renderGridNumber(taken, x + 3, height - 5, formatFixed(k * step, digits));
  }
  for (let k = Math.ceil(view[2] / step); k * step <= view[3]; k++) {
    const [, y] = to([0, k * step]).map(px);
    lines += `M0 ${y}H${px(width)}`;
    if (y > 20 && y < height - 30) numbers += renderGridNumber(taken, 4, y - 3, formatFixed(k * step, digits));
  }
  return `<path d="${lines}" ${stroke("grid")}/>${numbers}`
    + renderGridNumber(taken, width - 5, height - 5, "x, y in m", "end");
};

const DRAWN = { ...SHAPES, solid: drawSolid };

export const renderScene = (figure, computed, width, state) => {
  const { view } = computed, to = createProjection(view, width);
  const texts = textsByKey(figure, state, computed);
  const height = to.scale * (view[3] - view[2]);
  const pieces = figure.scene.flatMap((declared) => {
    const shape = { ...declared, label: fillTemplate(declared.label, texts) };
    const at = shape.at.map((index) => computed.values[index]);
    const depth = "depth" in shape ? computed.values[shape.depth] : 0;
    if (![...at, depth].every(Number.isFinite)) return [];
    const seen = shape.edge && shape.label && figure.grid !== false;
    const drawn = (seen && arrowToOutside(at, shape, to, [width, height]))
      || DRAWN[shape.shape](at, shape, to, computed);
    if (typeof drawn !== "string") return drawn; // in space, and of no quantity
    const text = shape.symbol ? `<g${symbolData(shape)}>${drawn}</g>` : drawn;
    return "depth" in shape ? { text, depth } : { text };
  });
  // those with a depth change places among themselves: the nearest is painted last
  const deep = pieces.filter((piece) => "depth" in piece).sort((a, b) => a.depth - b.depth);
  to.labels = to.labels.filter((one) => !isCovered(one, computed.values[one.shape.depth], deep));
  const grips = figure.handles.map(({ at }) => to(at.map((index) => computed.values[index])));
  const [labels, taken] = placeLabels(to, grips, [width, height]);
  const ground = figure.grid === false ? "" : renderGrid(view, to, width, height, taken);
  return ground + pieces.map((piece) => ("depth" in piece ? deep.shift() : piece).text).join("")
    + labels;
};

export const renderPicture = (figure, state = startState(figure), width = widthOf(figure)) => {
  const computed = compute(figure, settings(figure, state)), height = heightOf(figure, width);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" `
    + `width="${width}" height="${height}">`
    + `<rect width="100%" height="100%" style="fill:var(--rk-ground,#fff)"/>`
    + `<g role="img" aria-label="${escapeHtml(describeFigure(figure, state, computed))}">`
    + `${renderScene(figure, computed, width, state)}</g></svg>`;
};
