// From numbers to a picture: the shapes.

const paint = (kind) => KINDS[kind];
const color = (kind) => `var(--rk-${kind},${paint(kind).light})`;
const stroke = (kind, extra = "") => {
  const { dash, width } = paint(kind);
  const dashes = dash.length ? `;stroke-dasharray:${dash.join(" ")}` : "";
  return `style="fill:none;stroke:${color(kind)};stroke-width:${width}${dashes}${extra}"`;
};
const fill = (kind) => `style="fill:${color(kind)};stroke:none"`;
// What belongs to a quantity carries its key.
const faceOf = ({ symbol }) => (symbol ? ` data-symbol="${symbol}"` : "");
const n = (number) => Number(number.toFixed(2));

const MARKERS = {
  dot: (x, y, kind) => `<circle cx="${x}" cy="${y}" r="4.5" ${fill(kind)}/>`,
  ring: (x, y, kind) => `<circle cx="${x}" cy="${y}" r="6" ${stroke(kind, ";stroke-width:2.5")}/>`,
  square: (x, y, kind) => `<rect x="${n(x - 4)}" y="${n(y - 4)}" width="8" height="8" ${fill(kind)}/>`,
  diamond: (x, y, kind) =>
    `<path d="M${x} ${n(y - 6)}l6 6l-6 6l-6 -6z" ${fill(kind)}/>`,
  cross: (x, y, kind) => `<path d="M${n(x - 6)} ${n(y - 6)}l12 12m0 -12l-12 12" `
    + `${stroke(kind, ";stroke-width:3;stroke-dasharray:none")}/>`,
};

const label = (x, y, text, kind, shift = [8, -8], anchor = "") => `<text x="${n(x + shift[0])}" `
  + `y="${n(y + shift[1])}" ${anchor && `text-anchor="${anchor}" `}style="fill:${color(kind)};stroke:var(--rk-ground,#fff);`
  + `stroke-width:3px;paint-order:stroke;font:italic 15px serif">`
  + `${symbols(text, '$1<tspan dy="4" font-size="75%" font-style="normal">$2</tspan>')}</text>`;

const polyline = (points) => points
  .map(([x, y], i) => `${i && Number.isFinite(points[i - 1][0]) ? "L" : "M"}${n(x)} ${n(y)}`)
  .filter((piece) => !/NaN|Infinity/.test(piece)).join("");

// In space a line leaves a gap in what it passes in front of.
const gap = (line, kind) => `<path d="${line}" style="fill:none;stroke:var(--rk-ground,#fff);`
  + `stroke-width:${paint(kind).width + 4}"/>`;
const stroked = (line, shape, extra) => ("depth" in shape ? gap(line, shape.kind) : "")
  + `<path d="${line}" ${stroke(shape.kind, extra)}/>`;

// A curve in space, near here and far there: pieces, each with the depth of its middle. The dashes
// run on from piece to piece.
const inPieces = (points, depths, kind, size = 4) => {
  const pieces = [];
  for (let i = 0, run = 0; i < points.length - 1; i += size) {
    const piece = points.slice(i, i + size + 1);
    const offset = paint(kind).dash.length ? `;stroke-dashoffset:${n(run)}` : "";
    const depth = depths[i + (piece.length >> 1)];
    const text = stroked(polyline(piece), { kind, depth }, offset);
    if (Number.isFinite(depth)) pieces.push({ text, depth });
    piece.slice(1).forEach(([x, y], k) => {
      run += Math.sqrt((x - piece[k][0]) ** 2 + (y - piece[k][1]) ** 2);
    });
  }
  return pieces;
};

const atAngle = (x, y, angle) =>
  `transform="translate(${x} ${y}) rotate(${n(-angle * 180 / Math.PI)})"`;

// A labelled point outside the picture: an arrowhead at the edge, on the way to it from the origin
// (from the middle, if that is outside, too), and how far from the origin it is.
const beyond = (p, { label: name, kind }, to, [width, height]) => {
  const [x, y] = to(p), inside = (a, b) => a > 0 && a < width && b > 0 && b < height;
  if (inside(x, y)) return "";
  const [x0, y0] = inside(...to([0, 0])) ? to([0, 0]) : [width / 2, height / 2];
  const long = Math.sqrt((x - x0) ** 2 + (y - y0) ** 2), [ux, uy] = [(x - x0) / long, (y - y0) / long];
  const across = ((ux > 0 ? width : 0) - x0) / ux, down = ((uy > 0 ? height : 0) - y0) / uy;
  const way = Math.min(ux ? across : Infinity, uy ? down : Infinity) - 3;
  const [ex, ey] = [x0 + way * ux, y0 + way * uy], far = Math.sqrt(p[0] ** 2 + p[1] ** 2);
  const side = ex < 70 ? "start" : ex > width - 70 ? "end" : "middle";
  const told = far < 1e4 ? `${fixed(far, far < 1 ? 2 : far < 10 ? 1 : 0)} m` : "far away";
  const shift = [{ start: 32, end: -12, middle: 0 }[side], ey < 40 ? 28 : -12];
  return `<path class="rk-beyond" d="M${n(ex)} ${n(ey)}L${n(ex - 13 * ux - 6 * uy)} `
    + `${n(ey - 13 * uy + 6 * ux)}L${n(ex - 13 * ux + 6 * uy)} ${n(ey - 13 * uy - 6 * ux)}z" `
    + `${fill(kind)}/>${label(ex, ey, `${name} ${told}`, kind, shift, side)}`;
};

// Each shape gets its numbers (`at`, already in world units), the declaration, and `to`, which
// takes world coordinates to pixels. Angles on the screen run the other way (y points down).
const SHAPES = {
  point: (p, shape, to) => {
    const [x, y] = to(p).map(n);
    return MARKERS[paint(shape.kind).marker](x, y, shape.kind)
      + (shape.label ? label(x, y, shape.label, shape.kind) : "");
  },
  line: (p, shape, to) => {
    const points = [];
    for (let i = 0; i < p.length; i += 2) points.push(to([p[i], p[i + 1]]));
    return stroked(polyline(points), shape);
  },
  arrow: (p, shape, to) => {
    const [x0, y0] = to(p), [x1, y1] = to([p[2], p[3]]);
    const long = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
    if (long < 0.5) return "";
    const head = Math.min(11, long), [ux, uy] = [(x1 - x0) / long, (y1 - y0) / long];
    const [bx, by] = [x1 - head * ux, y1 - head * uy], w = head * 0.42;
    return stroked(`M${n(x0)} ${n(y0)}L${n(bx)} ${n(by)}`, shape)
      + `<path d="M${n(x1)} ${n(y1)}L${n(bx - w * uy)} ${n(by + w * ux)}`
      + `L${n(bx + w * uy)} ${n(by - w * ux)}z" ${fill(shape.kind)}/>`
      + (shape.label ? label(x1, y1, shape.label, shape.kind, [30 * ux - 7, 30 * uy + 5]) : "");
  },
  wheel: (p, shape, to) => {
    const [x, y] = to(p).map(n), [w, h] = [shape.length * to.scale, shape.width * to.scale];
    return `<rect x="${n(-w / 2)}" y="${n(-h / 2)}" width="${n(w)}" height="${n(h)}" rx="2" `
      + `${atAngle(x, y, p[2])} style="fill:${color(shape.kind)};fill-opacity:.35;`
      + `stroke:${color(shape.kind)};stroke-width:2"/>`;
  },
  body: (p, shape, to) => {
    const [x, y] = to(p).map(n), r = n(shape.radius * to.scale);
    return `<g ${atAngle(x, y, p[2])}>`
      + `<circle r="${r}" style="fill:${color(shape.kind)};fill-opacity:.1;`
      + `stroke:${color(shape.kind)};stroke-width:${paint(shape.kind).width}`
      + `;stroke-dasharray:${paint(shape.kind).dash.join(" ") || "none"}"/>`
      + `<path d="M${n(r * 0.55)} ${n(-r * 0.3)}L${n(r * 0.9)} 0L${n(r * 0.55)} ${n(r * 0.3)}" `
      + `${stroke(shape.kind, ";stroke-dasharray:none")}/></g>`;
  },
  curve: (p, shape, to, { c }) => {
    const points = [], depths = [];
    for (let i = 0; i <= shape.samples; i++) {
      const s = p[0] + (p[1] - p[0]) * i / shape.samples;
      const [x, y, depth] = shape.point(f, c, [s]);
      points.push(to([x, y]));
      depths.push(depth);
    }
    if (depths[0] === undefined) return stroked(polyline(points), shape);
    return inPieces(points, depths, shape.kind);
  },
  trail: (p, shape, to, { c, trails }) => {
    const points = trails[shape.recurrence].map((state) => to(shape.point(f, c, state)));
    const corners = points.length > 60 || !shape.dots ? "" : points
      .map(([x, y]) => `<circle cx="${n(x)}" cy="${n(y)}" r="3" ${fill(shape.kind)}/>`).join("");
    return (shape.line ? stroked(polyline(points), shape) : "") + corners;
  },
  angle: (p, shape, to) => {
    const [x, y, from, until] = p, points = [], steps = 24;
    for (let i = 0; i <= steps; i++) {
      const a = from + (until - from) * i / steps;
      points.push(to([x + shape.radius * Math.cos(a), y + shape.radius * Math.sin(a)]));
    }
    const [mx, my] = points[steps / 2];
    return stroked(polyline(points), shape, ";stroke-dasharray:none")
      + (shape.label ? label(mx, my, shape.label, shape.kind) : "");
  },
};
