// Sprites: their outlines are in the picture once, each frame sets where they are.

import { GRADIENTS, GROUNDS } from "./constants.js";
import { renderNodes } from "./nodes.js";
import { color, paint, px } from "./svg.js";

const EDGE = 1.8, SOFT = [0.2, 1, 1.8]; // pixels; widths of the layers of a shadow

// One without any paint takes that of what it is used for, as a silhouette.
const drawOutline = ([d, fill, edge, width, opacity]) => {
  if (!fill && !edge) return ["path", { d }];
  const style = [`fill:${fill ? paint(fill) : "none"}`, ...(edge ? [`stroke:${paint(edge)}`] : []),
    ...(width ? [`stroke-width:${width}`] : []), ...(opacity < 1 ? [`opacity:${opacity}`] : [])];
  return ["path", { d, style: style.join(";") }];
};

const HATCH = '<pattern id="rk-hatch" width=".1" height=".1" patternContentUnits="objectBoundingBox" '
  + `patternTransform="rotate(45)"><path d="M0 0V.2" style="stroke:${color("error")};stroke-width:.035"/></pattern>`;

// Outlines, and the materials with form; they never change.
const renderDefs = (drawings, grounds = []) => {
  const used = new Set(Object.values(drawings).flat().flatMap(([, fill, edge]) => [fill, edge]));
  grounds.forEach((ground) => used.add(ground.fill));
  const gradients = Object.keys(GRADIENTS).filter((name) => used.has(name)).map((name) => GRADIENTS[name]);
  const groups = Object.entries(drawings).map(([id, outlines]) => ["g", { id }, outlines.map(drawOutline)]);
  return `<defs>${gradients.join("")}${HATCH}${renderNodes(groups)}</defs>`;
};

// For a picture by itself; a page has them once, for all pictures.
export const renderOwnDefs = ({ drawings, ground }) => drawings && (ground || Object.keys(drawings).length)
  ? renderDefs(drawings, ground ? [GROUNDS[ground]] : []) : "";
export const renderOutlines = (drawings) => '<svg class="rk-outlines" width="0" height="0" aria-hidden="true">'
  + `${renderDefs(drawings, Object.values(GROUNDS))}</svg>`;

const uses = {}; // the same node for the same drawing: what is the same is not looked at again
const use = (id) => (uses[id] ??= ["use", { href: `#${id}` }]);

const degrees = (angle) => px(-angle * 180 / Math.PI);
const small = (number) => Number(number.toPrecision(5));

// From the sides of the wheel to its top, which is nearest to the eye: how long each copy looks, and
// how far ahead it is.
const placeOnRim = ([radius, count, thickness], rolled) => {
  const apart = 2 * Math.PI / count, most = Math.ceil((thickness ? 2 : 1.5) / apart);
  const roll = (rolled / radius % apart + apart) % apart;
  return Array.from({ length: 2 * most }, (_, k) => {
    const angle = roll + apart * (k % 2 ? most - (k + 1) / 2 : k / 2 - most), cos = Math.cos(angle), sin = Math.sin(angle);
    return [thickness ? Math.hypot(cos, thickness * sin) : Math.max(0, cos), radius * sin];
  });
};

// Straight lines are one path for all copies: the browser paints that in half the time of many.
const drawRim = ({ at, rim, lines, drawing }, values) => {
  const places = placeOnRim(rim, values[at[0]]);
  if (!lines) {
    return ["g", {}, places.map(([long, ahead]) =>
      ["use", { href: `#${drawing}`, transform: `matrix(${small(long)} 0 0 1 ${small(ahead)} 0)` }])];
  }
  const [d, ...looks] = lines, all = places.map(([long, ahead]) =>
    d.replace(/([ML])([-.\d]+)/g, (_, sign, x) => sign + small(long * x + ahead)));
  return drawOutline([all.join(""), ...looks]);
};

// The nodes of a sprite and of those in it; pick: those of the sprite itself.
const walk = (sprite, values, pick) => pick(sprite).map((part) => {
  if (typeof part === "string") return use(part);
  if (part.rim) return drawRim(part, values);
  const [x, y, angle, size] = part.at.map((index) => values[index]);
  if (!Number.isFinite(x + y + angle + size)) return ["g", {}, []];
  const scale = size === 1 ? "" : ` scale(${small(size)})`;
  return ["g", { transform: `translate(${small(x)} ${small(y)}) rotate(${-degrees(angle)})${scale}` },
    walk(part, values, pick)];
});

// The outlines of a sprite and of those in it, as corners in pixels.
export const listOutlines = (sprite, values, to) => {
  const [x, y, angle, size] = sprite.at.map((index) => values[index]), cos = size * Math.cos(angle), sin = size * Math.sin(angle);
  if (!Number.isFinite(x + y + cos + sin)) return [];
  const inside = ([a, b]) => to([x + a * cos - b * sin, y + a * sin + b * cos]);
  return [sprite.corners.map(inside), ...sprites(sprite).flatMap((part) => listOutlines(part, values, inside))];
};

const partsOf = ({ parts }) => parts;
const sprites = ({ parts }) => parts.filter((part) => part.parts);
const silhouettes = (sprite) => [sprite.silhouette, ...sprites(sprite)];
const casting = (sprite) => [sprite.silhouette, ...sprites(sprite).filter(({ height }) => height)];

const drawShadow = (sprite, values, place, scale) => {
  const cast = walk(sprite, values, casting), { height } = sprite;
  const style = `fill:${paint("shadow")};stroke:${paint("shadow")};stroke-linejoin:round`;
  return ["g", { transform: place(0.7 * height * scale, height * scale), style }, SOFT.map((wide) =>
    ["g", { style: "opacity:var(--rk-soft,.08)", "stroke-width": small(0.8 * height * wide / (values[sprite.at[3]] || 1)) }, cast])];
};

const seeThrough = ([left, right, low, high], to, nodes) => {
  const [x, y] = to([left, high]).map(px), [width, height] = [right - left, high - low].map((side) => px(side * to.scale));
  return [["svg", { x, y, width, height, viewBox: `${x} ${y} ${width} ${height}` }, nodes]];
};

export const drawSprite = (at, sprite, to, computed) => {
  const nodes = drawWhole(at, sprite, to, computed);
  return sprite.window ? seeThrough(sprite.window, to, nodes) : nodes;
};

const drawWhole = ([x, y, angle, size], sprite, to, { values }) => {
  const [left, top] = to([x, y]), scale = to.scale * size;
  const place = (right, down) => `translate(${px(left + right)} ${px(top + down)}) rotate(${degrees(angle)}) `
    + `scale(${small(scale)} ${small(-scale)})`;
  const body = walk(sprite, values, partsOf);
  const around = { transform: place(0, 0), "stroke-width": small(EDGE / scale), "stroke-linejoin": "round", "stroke-linecap": "round" };
  const nodes = sprite.height && !sprite.look ? [drawShadow(sprite, values, place, to.scale)] : [];
  if (!sprite.look) return [...nodes, ["g", around, body]];
  const lines = walk(sprite, values, silhouettes);
  const style = sprite.look === "ghost" ? `fill:none;stroke:${color("ghost")}`
    : `fill:url(#rk-hatch);stroke:${color("error")}`;
  return [["g", around, [["g", { style: "opacity:.34" }, body], ["g", { style }, lines]]]];
};
