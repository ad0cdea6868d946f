// The shapes of a picture as nodes.

import { functions } from "../equations/functions.js";
import { KINDS } from "./constants.js";
import { formatFixed } from "./figure_text.js";
import { addLabel } from "./labels.js";
import { casing, color, drawLine, fill, headCasing, path, px, stroke } from "./svg.js";

const SOLID = ";stroke-dasharray:none";
const circle = (x, y, r, style) => ["circle", { cx: px(x), cy: px(y), r: px(r), style }];

const MARKERS = {
  dot: (x, y, kind) => circle(x, y, 4.5, fill(kind)),
  ring: (x, y, kind) => circle(x, y, 6, stroke(kind, ";stroke-width:2.5")),
  square: (x, y, kind) => path(`M${px(x - 4)} ${px(y - 4)}h8v8h-8z`, fill(kind)),
  diamond: (x, y, kind) => path(`M${px(x)} ${px(y - 6)}l6 6l-6 6l-6 -6z`, fill(kind)),
  cross: (x, y, kind) => path(`M${px(x - 6)} ${px(y - 6)}l12 12m0 -12l-12 12`, stroke(kind, `;stroke-width:3${SOLID}`)),
};

// In space a line leaves a gap in what it passes in front of.
const strokeLine = (points, shape, extra) =>
  [...("depth" in shape ? [drawLine(points, casing(shape.kind))] : []), drawLine(points, stroke(shape.kind, extra))];

// A curve in space, near here and far there: pieces, each with the depth of its middle. The dashes
// run on from piece to piece.
const cutCurve = (points, depths, kind, size = 4) => {
  const pieces = [];
  for (let i = 0, run = 0; i < points.length - 1; i += size) {
    const piece = points.slice(i, i + size + 1);
    const offset = KINDS[kind].dash.length ? `;stroke-dashoffset:${px(run)}` : "";
    const depth = depths[i + (piece.length >> 1)];
    if (Number.isFinite(depth)) pieces.push({ nodes: strokeLine(piece, { kind, depth }, offset), depth });
    piece.slice(1).forEach(([x, y], k) => {
      run += Math.sqrt((x - piece[k][0]) ** 2 + (y - piece[k][1]) ** 2);
    });
  }
  return { pieces };
};

const toPoints = (p) => p.flatMap((x, i) => (i % 2 ? [] : [[x, p[i + 1]]]));

// A labelled point outside the picture: an arrowhead at the edge, on the way to it from the origin
// (from the middle, if that is outside, too), and how far from the origin it is.
export const arrowToOutside = (p, shape, to, [width, height]) => {
  const [x, y] = to(p), inside = (a, b) => a > 0 && a < width && b > 0 && b < height;
  if (inside(x, y)) return null;
  const [x0, y0] = inside(...to([0, 0])) ? to([0, 0]) : [width / 2, height / 2];
  const long = Math.sqrt((x - x0) ** 2 + (y - y0) ** 2), [ux, uy] = [(x - x0) / long, (y - y0) / long];
  const across = ((ux > 0 ? width : 0) - x0) / ux, down = ((uy > 0 ? height : 0) - y0) / uy;
  const way = Math.min(ux ? across : Infinity, uy ? down : Infinity) - 3;
  const [ex, ey] = [x0 + way * ux, y0 + way * uy], off = Math.sqrt(p[0] ** 2 + p[1] ** 2);
  const away = off < 1e4 ? `${formatFixed(off, off < 1 ? 2 : off < 10 ? 1 : 0)} m` : "far away";
  addLabel(to, ex - 13 * ux, ey - 13 * uy, { ...shape, label: `${shape.label} ${away}` }, [-ux, -uy]);
  const head = `M${px(ex)} ${px(ey)}L${px(ex - 13 * ux - 6 * uy)} ${px(ey - 13 * uy + 6 * ux)}`
    + `L${px(ex - 13 * ux + 6 * uy)} ${px(ey - 13 * uy - 6 * ux)}z`;
  return [["path", { d: head, style: fill(shape.kind), class: "rk-beyond" }]];
};

// Each shape gets its numbers (`at`, already in world units), the declaration, and `to`, which
// takes world coordinates to pixels. Angles on the screen run the other way (y points down).
export const SHAPES = {
  point: (p, shape, to) => {
    const [x, y] = to(p);
    addLabel(to, x, y, shape);
    return [MARKERS[KINDS[shape.kind].marker](x, y, shape.kind)];
  },
  line: (p, shape, to) => strokeLine(toPoints(p).map(to), shape),
  arrow: (p, shape, to) => {
    const [x0, y0] = to(p), [x1, y1] = to([p[2], p[3]]);
    const long = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
    if (long < 0.5) return [];
    const tip = Math.min(11, long), [ux, uy] = [(x1 - x0) / long, (y1 - y0) / long];
    const [bx, by] = [x1 - tip * ux, y1 - tip * uy], w = tip * 0.42;
    const stem = [[x0, y0], [bx, by]], left = [bx - w * uy, by + w * ux], right = [bx + w * uy, by - w * ux];
    const head = [[x1, y1], left, right, [x1, y1]];
    addLabel(to, x1, y1, shape, [ux, uy]);
    return [drawLine(stem, casing(shape.kind)), drawLine(head, headCasing),
      drawLine(stem, stroke(shape.kind)), drawLine(head, fill(shape.kind))];
  },
  area: (p, shape, to) => [drawLine(toPoints(p).map(to), fill(shape.kind, 0.16))],
  length: (p, shape, to) => {
    const [[x0, y0], [x1, y1]] = toPoints(p).map(to), long = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
    if (long < 1) return [];
    const [ux, uy] = [(x1 - x0) / long, (y1 - y0) / long], off = shape.aside * to.scale;
    const end = (x, y) => `M${px(x)} ${px(y)}L${px(x + off * uy)} ${px(y - off * ux)}`;
    const [ax, ay, bx, by] = [x0 + off * uy, y0 - off * ux, x1 + off * uy, y1 - off * ux];
    addLabel(to, (ax + bx) / 2, (ay + by) / 2, shape, off < 0 ? [-uy, ux] : [uy, -ux]);
    const ends = `${off ? end(x0, y0) + end(x1, y1) : ""}M${px(ax - 5 * uy)} ${px(ay + 5 * ux)}l${px(10 * uy)} `
      + `${px(-10 * ux)}M${px(bx - 5 * uy)} ${px(by + 5 * ux)}l${px(10 * uy)} ${px(-10 * ux)}`;
    return [...strokeLine([[ax, ay], [bx, by]], shape),
      path(ends, stroke(shape.kind, `${SOLID};stroke-width:1`))];
  },
  label: (p, shape, to) => {
    addLabel(to, ...to(p), shape, [0, 0]);
    return [];
  },
  curve: (p, shape, to, { c }) => {
    const points = [], depths = [];
    for (let i = 0; i <= shape.samples; i++) {
      const s = p[0] + (p[1] - p[0]) * i / shape.samples;
      const [x, y, depth] = shape.point(functions, c, [s]);
      points.push(to([x, y]));
      depths.push(depth);
    }
    if (depths[0] === undefined) return strokeLine(points, shape);
    return cutCurve(points, depths, shape.kind);
  },
  trail: (p, shape, to, { c, trails }) => {
    const points = trails[shape.recurrence].map((state) => to(shape.point(functions, c, state)));
    const corners = points.length > 60 || !shape.dots ? [] : points.map(([x, y]) => circle(x, y, 3, fill(shape.kind)));
    return [...strokeLine(points, shape), ...corners];
  },
  track: (at, shape, to, { view }) => {
    const past = shape.past ??= [], far = ([x, y], [a, b]) => Math.hypot(x - a, y - b) / (view[1] - view[0]);
    if (!past.length || !(far(at, past.at(-1)) <= 1e-4)) past.push(at); // also where it is nowhere
    const step = (place, i) => `${i && far(place, past[i - 1]) < 0.2 ? "L" : "M"}${to(place).map(px)}`;
    return [path(past.map(step).filter((piece) => !piece.includes("NaN")).join(""), stroke(shape.kind))];
  },
  cloud: (p, shape, to, { c }) => {
    const dots = shape.rows.map((row) => to(shape.point(functions, c, row))).filter(([x, y]) => Number.isFinite(x + y));
    return [path(dots.map(([x, y]) => `M${px(x)} ${px(y)}h0`).join(""), stroke(shape.kind, `;stroke-width:4.5;stroke-linecap:round${SOLID}`))];
  },
  angle: (p, shape, to) => {
    const [x, y, from, until] = p, points = [], steps = 24;
    for (let i = 0; i <= steps; i++) {
      const a = from + (until - from) * i / steps;
      points.push(to([x + shape.radius * Math.cos(a), y + shape.radius * Math.sin(a)]));
    }
    const [mx, my] = points[steps / 2], [cx, cy] = to(p);
    const far = Math.sqrt((mx - cx) ** 2 + (my - cy) ** 2) || 1;
    addLabel(to, mx, my, shape, [(mx - cx) / far, (my - cy) / far]);
    return [drawLine([...points, [cx, cy]], fill(shape.kind, 0.16)), ...strokeLine(points, shape, SOLID)];
  },
  // A matrix: columns, or rows, in their colours, between brackets.
  bracket: ([x, y, ...entries], { columns, by_row: byRow, digits, ...shape }, to) => {
    const other = entries.length / columns.length, [n, m] = byRow ? [other, columns.length] : [columns.length, other];
    const [x0, y0] = to([x, y]), wide = 20 + 9 * digits, half = n / 2 * wide + 6, high = 17, tall = (m / 2 + 0.1) * high;
    const number = (value, k, row = Math.floor(k / n)) => ["text", {
      x: px(x0 + (k % n - n / 2 + 0.9) * wide), y: px(y0 + (row - m / 2 + 0.8) * high),
      "text-anchor": "end", style: `fill:${color(columns[byRow ? row : k % n])};font:600 13px sans-serif`,
    }, formatFixed(value, digits)];
    to.taken.push([x0 - half, y0 - tall - 1.7, x0 + half, y0 + tall + 1.7]);
    const edge = (side) => `M${px(x0 + side * (half - 4))} ${px(y0 - tall)}h${4 * side}`
      + `v${px(2 * tall)}h${-4 * side}`;
    addLabel(to, x0, y0 + tall, shape, [0, 1]);
    return [path(edge(-1) + edge(1), stroke(shape.kind)), ...entries.map((value, k) => number(value, k))];
  },
};
