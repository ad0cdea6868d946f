// Solids: corners turned by twelve numbers, faces that look away left out, the others shaded by a
// light that stands in the room. Their pieces have depths and are sorted with all others.

import { KINDS } from "./constants.js";
import { color, px } from "./svg.js";

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

// Lighter or darker than its kind, in steps of a twentieth.
const shadeFace = (kind, [a, b, c]) => {
  const up = cross(subtract(a, b), subtract(b, c));
  const lit = up.reduce((sum, x, k) => sum + x * LIGHT[k], 0) / (Math.hypot(...up) || 1);
  const part = 5 * Math.round(8 * lit - 1);
  return `color-mix(in srgb,${color(kind)} ${100 - Math.abs(part)}%,${part < 0 ? "#000" : "#fff"})`;
};

// Discs in the plane of a face: its first edge and the one after it, per metre, are their axes.
const paintDots = (discs, q, [a, b, c], paint) => {
  const axes = [[0, 1, a, b], [1, 2, b, c]].flatMap(([i, j, s, t]) => {
    const long = Math.hypot(...subtract(s, t));
    return subtract(q[i], q[j]).slice(0, 2).map((x) => x / long);
  });
  const at = (x, y, k) => px(meanOf(q, k) + x * axes[k] + y * axes[2 + k]);
  return discs.map(([x, y, r]) => `<circle r="${r}" style="fill:${paint}" `
    + `transform="matrix(${axes.map(px)} ${at(x, y, 0)} ${at(x, y, 1)})"/>`).join("");
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
  for (const { kind, corners, faces, dots, smooth } of data) {
    const there = corners.map(place), points = there.map(seen);
    const flat = floor === null || se < 0 ? [] : there.map(([x, y]) => seen([x, y, floor]));
    faces.forEach((face, k) => {
      if (flat.length) shadow += outlineFace(face.map((i) => flat[i]));
      const q = face.map((i) => points[i]), line = outlineFace(q), world = face.map((i) => there[i]);
      if (!line) return;
      const tone = ghost ? `${color(kind)};fill-opacity:${opacity}` : shadeFace(kind, world);
      const dashes = ghost ? `;stroke-dasharray:${KINDS[kind].dash.join(" ") || "none"}` : "";
      const text = `<path d="${line}" style="fill:${tone};stroke:${smooth ? tone : color(kind)}${dashes}"/>`
        + paintDots(dots[k] ?? [], q, world, ghost ? color(kind) : "var(--rk-ground,#fff)");
      pieces.push({ text, depth: meanOf(q, 2) - behind, face: !ghost && q });
    });
  }
  const dark = `fill:color-mix(in srgb,${color("grid")} 80%,#000)`;
  if (shadow) pieces.push({ text: `<path d="${shadow}" style="${dark}"/>`, depth: SHADOW });
  return pieces;
};
