// The whole picture of a figure as SVG.

import { escapeHtml, fillTemplate } from "../units/text.js";
import { describeFigure, textsByKey } from "./figure_text.js";
import { renderGround, renderScale, toneOf } from "./grounds.js";
import { placeLabels } from "./labels.js";
import { renderNodes } from "./nodes.js";
import { arrowToOutside, SHAPES } from "./shapes.js";
import { drawSolid, isCovered } from "./solids.js";
import { compute, settings, startState } from "./state.js";
import { px, symbolData } from "./svg.js";
import { drawSprite, listOutlines, renderOwnDefs } from "./sprites.js";

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

// a face of a solid, and its rim, have its colour
const SOLIDS = { "stroke-width": 1.5, "stroke-linecap": "round", fill: "currentColor", stroke: "currentColor" };
const DRAWN = { ...SHAPES, solid: drawSolid, sprite: drawSprite };

// The points of what is drawn as a line.
const listPoints = ([tag, { points }, inside]) => tag === "g" ? inside.flatMap(listPoints)
  : tag === "polyline" ? [points.split(" ").map(Number).reduce((all, x, k) => (k % 2 ? all.at(-1).push(x) : all.push([x]), all), [])] : [];

// Each shape is a node of its own, so that one that rests is not touched. Those with a depth change
// places among themselves, the nearest is painted last: all take the place of the first of them.
export const renderScene = (figure, computed, width, state) => {
  const { view, values } = computed, to = createProjection(view, width);
  const texts = textsByKey(figure, state, computed), deep = [];
  const height = to.scale * (view[3] - view[2]);
  let first; // of the shapes with a depth
  const nodes = figure.shapes.map((declared, i) => {
    const shape = { ...declared, label: fillTemplate(declared.label, texts) };
    const at = shape.at.map((index) => values[index]), isDeep = "depth" in shape;
    const depth = isDeep ? values[shape.depth] : 0, node = ["g", symbolData(shape), []];
    if (shape.shape !== "track" && ![...at, depth].every(Number.isFinite)) return node;
    const isNamed = shape.shape === "point" && shape.label && figure.grid !== false;
    const drawn = (isNamed && arrowToOutside(at, shape, to, [width, height]))
      || DRAWN[shape.shape](at, shape, to, computed);
    if (!drawn.pieces && !isDeep) node[2] = drawn;
    else {
      first ??= i;
      node[1] = SOLIDS; // one of them has the pieces of all
      deep.push(...(drawn.pieces ?? [{ nodes: [["g", symbolData(shape), drawn]], depth }]));
    }
    return node;
  });
  to.labels = to.labels.filter((one) => !isCovered(one, values[one.shape.depth], deep));
  const scale = renderScale(figure, view, to, height);
  const grips = figure.handles.map(({ at }) => to(at.map((index) => values[index])));
  const sprites = figure.shapes.filter(({ shape }) => shape === "sprite").flatMap((sprite) => listOutlines(sprite, values, to));
  const lines = [...nodes.flatMap(([, , drawn]) => drawn), ...deep.filter(({ face }) => !face).flatMap((piece) => piece.nodes)];
  if (figure.controls.length) to.taken.push([width - 44, 0, width, 58], [0, 0, figure.goals.length && width, 14]); // reset, goal
  const [labels, taken] = placeLabels(to, grips, [width, height],
    [...sprites, ...deep.flatMap(({ face }) => face ? [face] : [])], lines.flatMap(listPoints));
  if (deep.length) nodes[first][2] = deep.sort((a, b) => a.depth - b.depth).flatMap((piece) => piece.nodes);
  return [["g", {}, renderGround(figure, view, to, [width, height], taken)], ...nodes,
    ["g", {}, scale], ["g", {}, labels]];
};

export const renderPicture = (figure, state = startState(figure), width = widthOf(figure)) => {
  const computed = compute(figure, settings(figure, state)), height = heightOf(figure, width);
  const around = figure.ground ? ` style="--rk-ground:${toneOf(figure)}"` : "";
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" `
    + `width="${width}" height="${height}"${around}>${renderOwnDefs(figure)}`
    + `<rect width="100%" height="100%" style="fill:var(--rk-ground,#fff)"/>`
    + `<g role="img" aria-label="${escapeHtml(describeFigure(figure, state, computed))}">`
    + `${renderNodes(renderScene(figure, computed, width, state))}</g></svg>`;
};

// For a program's verdict: the figure has one choice, with one option, all numbers.
export const renderAnswer = (figure, numbers) => {
  figure.controls[0].options[0].values = numbers;
  return `<figure class="rk-answer">${renderPicture(figure)}<figcaption>${figure.title}</figcaption></figure>`;
};
