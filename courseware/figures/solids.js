// Solids: corners turned by twelve numbers, faces that look away left out, the others shaded by a
// a light fixed in the room. Their pieces have depths and are sorted with all others.

import { dot } from "../equations/functions.js";
import { KINDS } from "./constants.js";
import { paint, px, writePoint } from "./svg.js";

const LIGHT = [0.36, -0.48, 0.8];
const SHADOW = -100; // behind all but the floor

const meanOf = (points, k) => points.reduce((sum, point) => sum + point[k], 0) / points.length;
const subtract = (a, b) => b.map((x, k) => x - a[k]);
const cross = (u, v) => [0, 1, 2].map((k) =>
  u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);

// Whether a face looks at the viewer; y points down.
const isSeen = (q) => {
  let area = 0;
  q.forEach(([x, y], i) => {
    const [x1, y1] = q[(i + 1) % q.length];
    area += x * y1 - x1 * y;
  });
  return area < -0.5;
};

const joinPoints = (points, style) => ["polyline", { points: points.join(" "), style }];

// The outlines of a shadow: the edges between faces that the light meets and those that it does not,
// joined to loops. One that lies in another is a hole, by the way that it runs.
const castShadow = (faces, flat, beside) => {
  const lit = faces.map((face) => isSeen(face.map((i) => flat[i]))), next = new Map();
  faces.forEach((face, k) => face.forEach((start, i) => {
    if (!lit[k] || lit[beside[k][i]]) return;
    next.set(start, [...(next.get(start) ?? []), face[(i + 1) % face.length]]);
  }));
  let loops = "";
  for (const start of next.keys()) {
    const loop = [];
    for (let at = start; next.get(at)?.length; at = next.get(at).pop()) loop.push(writePoint(flat[at]));
    if (loop.length) loops += `M${loop.join(" ")}z`;
  }
  return loops;
};

const HALO = [0, 5, 11]; // pixels: widths of the layers of a shadow
const layShadow = (loops) => {
  return ["g", { style: "fill:#000;stroke:#000;stroke-linejoin:round" }, HALO.map((wide) =>
    ["path", { d: loops, style: `opacity:var(--rk-soft,.08);stroke-width:${wide}` }])];
};

const unit = (a) => {
  const long = Math.sqrt(dot(a, a)) || 1;
  return a.map((x) => x / long);
};
const normalOf = ([a, b, c]) => unit(cross(subtract(a, b), subtract(b, c)));

// Lighter or darker than its kind, in steps of a fiftieth; what is wrong is pale, and hatched.
const shadeFace = (kind, normal) => {
  const part = 2 * Math.round(20 * dot(normal, LIGHT) - 2.5);
  return `color-mix(in srgb,${paint(kind === "error" ? "shell_mid" : kind)} ${100 - Math.abs(part)}%,${part < 0 ? "#000" : "#fff"})`;
};

// Discs in the plane of a face, from its middle along its first edge and to the left of that.
const paintDots = (discs, q, [a, b], normal, toEye, fill) => {
  const ahead = unit(subtract(a, b)), middle = toEye([0, 0, 0]);
  const axes = [ahead, cross(normal, ahead)].flatMap((axis) => subtract(middle, toEye(axis)).slice(0, 2));
  const transform = `matrix(${axes.map(Math.round)} ${px(meanOf(q, 0))} ${px(meanOf(q, 1))})`;
  return [["g", { transform }, discs.map(([x, y, r, tone]) =>
    ["circle", { cx: x, cy: y, r, style: `fill:${fill(tone)};stroke:none` }])]];
};

const SHARP = 0.7; // of the cosine of two faces that meet: a round body has no lines between its faces

// The face at the other side of each edge of each face.
const findNeighbours = (faces) => {
  const ends = (face, i) => [face[i], face[(i + 1) % face.length]], owner = new Map();
  faces.forEach((face, k) => face.forEach((_, i) => owner.set(ends(face, i).join(), k)));
  return faces.map((face) => face.map((_, i) => owner.get(ends(face, i).reverse().join())));
};

const isSmooth = (k, next, seen, normals) => seen[next] && dot(normals[k], normals[next]) > SHARP;

// The lines of a face: its edges to faces that look away, or another way; one between two such faces
// is drawn once.
const findLines = (texts, k, { beside }, seen, normals) => {
  const lines = [];
  let ended;
  texts.forEach((start, i) => {
    const next = beside[k][i], end = texts[(i + 1) % texts.length];
    if (isSmooth(k, next, seen, normals) || (seen[next] && next < k)) return;
    if (start === ended) lines.at(-1).push(end);
    else lines.push([start, end]);
    ended = end;
  });
  return lines;
};

// Whether a face is painted over the place of a label: then it would name what is not seen.
export const isCovered = ({ x, y }, depth, pieces) => pieces.some(({ face, depth: near }) => face
  && near > depth && face.every(([a, b], i) => {
    const [c, d] = face[(i + 1) % face.length];
    return (c - a) * (y - b) < (d - b) * (x - a);
  }));

export const drawSolid = (p, { data, floor, opacity, behind }, to) => {
  const [ca, sa, ce, se] = [0, 1].flatMap((k) => [Math.cos(p[k]), Math.sin(p[k])]);
  const place = ([x, y, z]) => [0, 1, 2].map((i) =>
    p[2 + 3 * i] * x + p[3 + 3 * i] * y + p[4 + 3 * i] * z + p[11 + i]);
  const toEye = ([x, y, z]) => {
    const away = x * ca + y * sa;
    return [...to([y * ca - x * sa, z * ce - away * se]), away * ce + z * se];
  };
  const pieces = [], ghost = opacity < 1;
  let shadow = "";
  for (const mesh of data) {
    const { kind, edge, corners, faces, dots } = mesh;
    mesh.beside ??= findNeighbours(faces);
    const there = corners.map(place), points = there.map(toEye), texts = points.map(writePoint);
    const worlds = faces.map((face) => face.map((i) => there[i]));
    const outlines = faces.map((face) => face.map((i) => points[i])), seen = outlines.map(isSeen);
    const normals = worlds.map((world, k) => seen[k] && normalOf(world));
    const depths = outlines.map((outline) => meanOf(outline, 2) - behind), lines = [];
    if (floor !== null && se >= 0) shadow += castShadow(faces, there.map(([x, y]) => toEye([x, y, floor])), mesh.beside);
    faces.forEach((face, k) => {
      if (!seen[k]) return;
      const tone = ghost ? paint(kind) : shadeFace(kind, normals[k]), around = face.map((i) => texts[i]);
      const style = ghost ? `fill:${tone};fill-opacity:${opacity};stroke:${tone};stroke-dasharray:${KINDS[kind]?.dash.join(" ") || "none"}`
        : `color:${tone};stroke-width:.6`;
      const printed = !dots[k] ? [] : paintDots(dots[k], outlines[k], worlds[k], normals[k], toEye,
        (own) => ghost ? paint(kind) : own ? paint(own) : "var(--rk-ground,#fff)");
      if (kind === "error" && !ghost) printed.push(joinPoints(around, "fill:url(#rk-hatch);stroke:none"));
      pieces.push({ nodes: [joinPoints([...around, around[0]], style), ...printed], depth: depths[k], face: !ghost && !behind && outlines[k] });
      const edges = ghost ? [] : findLines(around, k, mesh, seen, normals);
      if (edges.length) { // above the faces beside it of the same round body
        lines.push({ nodes: edges.map((line) => joinPoints(line, `fill:none;stroke:${paint(edge || kind)}`)),
          depth: Math.max(depths[k], ...mesh.beside[k].filter((next) => seen[next]).map((next) => depths[next])) });
      }
    });
    pieces.push(...lines);
  }
  if (shadow) pieces.push({ nodes: [layShadow(shadow)], depth: SHADOW });
  return { pieces };
};
