// Solids: corners turned by twelve numbers, faces that look away left out, the others shaded by a
// light that stands in the room. Their pieces have depths and are sorted with all others.

import { KINDS } from "./constants.js";
import { color, paint, path, px } from "./svg.js";

const LIGHT = [0.36, -0.48, 0.8];
const SHADOW = -100; // behind all but the floor

const meanOf = (points, k) => points.reduce((sum, point) => sum + point[k], 0) / points.length;
const subtract = (a, b) => b.map((x, k) => x - a[k]);
const cross = (u, v) => [0, 1, 2].map((k) =>
  u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);

// The outline of a face that looks at the viewer, else nothing; y points down.
const outlineFace = (q) => {
  const area = q.reduce((sum, [x, y], i) => {
    const [x1, y1] = q[(i + 1) % q.length];
    return sum + x * y1 - x1 * y;
  }, 0);
  return area < -0.5 ? `M${q.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join(" ")}z` : "";
};

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));
const normalOf = ([a, b, c]) => unit(cross(subtract(a, b), subtract(b, c)));

// Lighter or darker than its kind, in steps of a fiftieth.
const shadeFace = (kind, normal) => {
  const part = 2 * Math.round(20 * dot(normal, LIGHT) - 2.5);
  return `color-mix(in srgb,${paint(kind)} ${100 - Math.abs(part)}%,${part < 0 ? "#000" : "#fff"})`;
};

// Discs in the plane of a face, from its middle along its first edge and to the left of that.
const paintDots = (discs, q, [a, b], normal, seen, fill) => {
  const ahead = unit(subtract(a, b)), middle = seen([0, 0, 0]);
  const axes = [ahead, cross(normal, ahead)].flatMap((axis) => subtract(middle, seen(axis)).slice(0, 2));
  const at = (x, y, k) => px(meanOf(q, k) + x * axes[k] + y * axes[2 + k]);
  return discs.map(([x, y, r, tone]) => ["circle", {
    r, style: `fill:${fill(tone)}`, transform: `matrix(${axes.map(px)} ${at(x, y, 0)} ${at(x, y, 1)})`,
  }]);
};

const SHARP = 0.8; // of the cosine of two faces that meet: a round body has no lines between its faces

// The face at the other side of each edge of each face.
const findNeighbours = (faces) => {
  const ends = (face, i) => [face[i], face[(i + 1) % face.length]], owner = new Map();
  faces.forEach((face, k) => face.forEach((_, i) => owner.set(ends(face, i).join(), k)));
  return faces.map((face) => face.map((_, i) => owner.get(ends(face, i).reverse().join())));
};

const isSmooth = (k, next, lines, normals) => lines[next] && dot(normals[k], normals[next]) > SHARP;

// Its edges to faces that look away, or another way; one between two such faces is drawn once.
const outlineEdges = (q, k, { beside }, lines, normals) => {
  let line = "", ended = "";
  q.forEach((from, i) => {
    const next = beside[k][i], [start, end] = [from, q[(i + 1) % q.length]].map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`);
    if (isSmooth(k, next, lines, normals) || (lines[next] && next < k)) return;
    line += `${start === ended ? "" : `M${start}`}L${end}`;
    ended = end;
  });
  return line;
};

// Whether a face is painted over the place of a label: then it would name what is not seen.
export const isCovered = ({ x, y }, depth, pieces) => pieces.some(({ face, depth: near }) => face
  && near > depth && face.every(([a, b], i) => {
    const [c, d] = face[(i + 1) % face.length];
    return (c - a) * (y - b) < (d - b) * (x - a);
  }));

export const drawSolid = (p, { data, floor, opacity, behind }, to) => {
  const [ca, sa, ce, se] = [0, 1].flatMap((k) => [Math.cos(p[k]), Math.sin(p[k])]);
  const place = (corner) => [0, 1, 2].map((i) =>
    corner.reduce((sum, x, k) => sum + p[2 + 3 * i + k] * x, p[11 + i]));
  const seen = ([x, y, z]) => {
    const away = x * ca + y * sa;
    return [...to([y * ca - x * sa, z * ce - away * se]), away * ce + z * se];
  };
  const pieces = [], ghost = opacity < 1;
  let shadow = "";
  for (const mesh of data) {
    const { kind, edge, corners, faces, dots } = mesh;
    mesh.beside ??= findNeighbours(faces);
    const there = corners.map(place), points = there.map(seen);
    const flat = floor === null || se < 0 ? [] : there.map(([x, y]) => seen([x, y, floor]));
    const worlds = faces.map((face) => face.map((i) => there[i])), normals = worlds.map(normalOf);
    const seenFaces = faces.map((face) => face.map((i) => points[i])), lines = seenFaces.map(outlineFace);
    const depths = seenFaces.map((q) => meanOf(q, 2) - behind), drawn = [];
    faces.forEach((face, k) => {
      if (flat.length) shadow += outlineFace(face.map((i) => flat[i]));
      const q = seenFaces[k], line = lines[k];
      if (!line) return;
      const tone = shadeFace(kind, normals[k]);
      const edges = ghost ? "" : outlineEdges(q, k, mesh, lines, normals);
      if (edges) { // above the faces beside it of the same round body
        drawn.push({ nodes: [path(edges, `fill:none;stroke:${paint(edge || kind)}`)],
          depth: Math.max(depths[k], ...mesh.beside[k].filter((next) => lines[next]).map((next) => depths[next])) });
      }
      const dashes = `;stroke-dasharray:${KINDS[kind]?.dash.join(" ") || "none"}`;
      const nodes = [path(line, ghost ? `fill:${paint(kind)};fill-opacity:${opacity};stroke:${paint(kind)}${dashes}`
        : `fill:${tone};stroke:${tone};stroke-width:.6`),
      ...paintDots(dots[k] ?? [], q, worlds[k], normals[k], seen,
        (own) => ghost ? paint(kind) : own ? paint(own) : "var(--rk-ground,#fff)")];
      pieces.push({ nodes, depth: depths[k], face: !ghost && q });
    });
    pieces.push(...drawn);
  }
  const dark = `fill:color-mix(in srgb,${color("grid")} 80%,#000)`;
  if (shadow) pieces.push({ nodes: [path(shadow, dark)], depth: SHADOW });
  return { pieces };
};
