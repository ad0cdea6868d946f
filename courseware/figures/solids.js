// Solids: corners turned by twelve numbers, faces that look away left out, the others shaded by a
// light that stands in the room. Their pieces have depths and are sorted with all others.

const LIGHT = [0.36, -0.48, 0.8], SHADOW = -100; // a shadow lies behind all but the floor

const mean = (points, k) => points.reduce((sum, point) => sum + point[k], 0) / points.length;
const from = (a, b) => b.map((x, k) => x - a[k]);
const crossed = (u, v) => [0, 1, 2].map((k) =>
  u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);

// The outline of a face that looks at the viewer, else nothing; y points down.
const outline = (q) => {
  const area = q.reduce((sum, [x, y], i) => {
    const [x1, y1] = q[(i + 1) % q.length];
    return sum + x * y1 - x1 * y;
  }, 0);
  return area < -0.5 ? `M${q.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join(" ")}z` : "";
};

// Lighter or darker than its kind, in steps of a twentieth.
const shaded = (kind, [a, b, c]) => {
  const up = crossed(from(a, b), from(b, c));
  const lit = up.reduce((sum, x, k) => sum + x * LIGHT[k], 0) / (Math.hypot(...up) || 1);
  const part = 5 * Math.round(8 * lit - 1);
  return `color-mix(in srgb,${color(kind)} ${100 - Math.abs(part)}%,${part < 0 ? "#000" : "#fff"})`;
};

// Discs in the plane of a face: its first edge and the one after it, per metre, are their axes.
const printed = (discs, q, [a, b, c], paint) => {
  const axes = [[0, 1, a, b], [1, 2, b, c]].flatMap(([i, j, s, t]) => {
    const long = Math.hypot(...from(s, t));
    return from(q[i], q[j]).slice(0, 2).map((x) => x / long);
  });
  const at = (x, y, k) => n(mean(q, k) + x * axes[k] + y * axes[2 + k]);
  return discs.map(([x, y, r]) => `<circle r="${r}" style="fill:${paint}" `
    + `transform="matrix(${axes.map(n)} ${at(x, y, 0)} ${at(x, y, 1)})"/>`).join("");
};

// Whether a face is painted over the place of a label: then it would name what is not seen.
const covered = ({ x, y }, depth, pieces) => pieces.some(({ face, depth: near }) => face
  && near > depth && face.every(([a, b], i) => {
    const [c, d] = face[(i + 1) % face.length];
    return (c - a) * (y - b) < (d - b) * (x - a);
  }));

SHAPES.solid = (p, { data, floor, opacity, behind }, to) => {
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
      if (flat.length) shadow += outline(face.map((i) => flat[i]));
      const q = face.map((i) => points[i]), line = outline(q), world = face.map((i) => there[i]);
      if (!line) return;
      const tone = ghost ? `${color(kind)};fill-opacity:${opacity}` : shaded(kind, world);
      const dashes = ghost ? `;stroke-dasharray:${paint(kind).dash.join(" ") || "none"}` : "";
      const text = `<path d="${line}" style="fill:${tone};stroke:${smooth ? tone : color(kind)}${dashes}"/>`
        + printed(dots[k] ?? [], q, world, ghost ? color(kind) : "var(--rk-ground,#fff)");
      pieces.push({ text, depth: mean(q, 2) - behind, face: !ghost && q });
    });
  }
  const dark = `fill:color-mix(in srgb,${color("grid")} 80%,#000)`;
  if (shadow) pieces.push({ text: `<path d="${shadow}" style="${dark}"/>`, depth: SHADOW });
  return pieces;
};
