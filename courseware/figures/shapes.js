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

// ---- labels, which get out of each other's way

// A label beside a place in pixels; toward: where it stands if that is free, in steps around it,
// as far as its box must go to be clear of the place.
const label = (to, x, y, shape, toward = [1, -1]) => {
  const most = Math.max(...toward.map(Math.abs)) || 1;
  if (shape.label) to.labels.push({ x, y, shape, toward: toward.map((step) => step / most) });
  return "";
};

const AROUND = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];
const FAR = [4, 12, 22, 34, 48, 66, 90, 120]; // pixels between a place and its label
const meets = ([a, b, c, d]) => ([p, q, r, s]) => a < r && p < c && b < s && q < d;

// How wide a text will be, rather too much than too little; marks above letters take no room.
const wide = (text) => [...text.normalize("NFC").replace(/[\u0300-\u036f]/g, "")]
  .reduce((sum, sign) => sum + (/[ .,:()'|lij⁰¹²³⁴-⁹⁻]/.test(sign) ? 5.5 : /[mwMW]|[^\0-~]/.test(sign) ? 13 : 10), 0);

// An index has a thin edge of ground only, because it is painted after its letter, and over it.
const written = ({ x, y, shape }) => `<text x="${n(x)}" y="${n(y + 5)}" text-anchor="middle"`
  + `${faceOf(shape)} style="fill:${color(shape.kind)};stroke:var(--rk-ground,#fff);`
  + `stroke-width:5px;stroke-linejoin:round;paint-order:stroke;font:italic 15px serif">`
  + `${symbols(shape.label, '$1<tspan dx="1" dy="4" font-size="75%" font-style="normal" stroke-width="2">$2</tspan>')}</text>`;

// Each label takes the first place that is inside the picture and free of handles and of the labels
// before it. → their text, and the boxes that are taken.
const placed = ({ labels, taken: already }, grips, [width, height]) => {
  const taken = [...already, ...grips.map(([x, y]) => [x - 10, y - 10, x + 10, y + 10])];
  const texts = labels.map((one) => {
    const w = wide(one.shape.label) / 2, h = 11, ways = [one.toward, ...AROUND];
    const spots = FAR.flatMap((far) => ways.map(([dx, dy]) => [
      Math.min(width - w - 2, Math.max(w + 2, one.x + dx * (w + far))),
      Math.min(height - h - 2, Math.max(h + 2, one.y + dy * (h + far))),
    ]));
    const box = ([x, y]) => [x - w, y - h, x + w, y + h];
    const [x, y] = spots.find((spot) => !taken.some(meets(box(spot)))) ?? spots[0];
    taken.push(box([x, y]));
    return written({ ...one, x, y });
  });
  return [texts.join(""), taken];
};

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

const pairs = (p) => p.flatMap((x, i) => (i % 2 ? [] : [[x, p[i + 1]]]));

const atAngle = (x, y, angle) =>
  `transform="translate(${x} ${y}) rotate(${n(-angle * 180 / Math.PI)})"`;

// A labelled point outside the picture: an arrowhead at the edge, on the way to it from the origin
// (from the middle, if that is outside, too), and how far from the origin it is.
const beyond = (p, shape, to, [width, height]) => {
  const [x, y] = to(p), inside = (a, b) => a > 0 && a < width && b > 0 && b < height;
  if (inside(x, y)) return "";
  const [x0, y0] = inside(...to([0, 0])) ? to([0, 0]) : [width / 2, height / 2];
  const long = Math.sqrt((x - x0) ** 2 + (y - y0) ** 2), [ux, uy] = [(x - x0) / long, (y - y0) / long];
  const across = ((ux > 0 ? width : 0) - x0) / ux, down = ((uy > 0 ? height : 0) - y0) / uy;
  const way = Math.min(ux ? across : Infinity, uy ? down : Infinity) - 3;
  const [ex, ey] = [x0 + way * ux, y0 + way * uy], off = Math.sqrt(p[0] ** 2 + p[1] ** 2);
  const away = off < 1e4 ? `${fixed(off, off < 1 ? 2 : off < 10 ? 1 : 0)} m` : "far away";
  const far = { ...shape, label: `${shape.label} ${away}` };
  return `<path class="rk-beyond" d="M${n(ex)} ${n(ey)}L${n(ex - 13 * ux - 6 * uy)} `
    + `${n(ey - 13 * uy + 6 * ux)}L${n(ex - 13 * ux + 6 * uy)} ${n(ey - 13 * uy - 6 * ux)}z" `
    + `${fill(shape.kind)}/>${label(to, ex - 13 * ux, ey - 13 * uy, far, [-ux, -uy])}`;
};

// Each shape gets its numbers (`at`, already in world units), the declaration, and `to`, which
// takes world coordinates to pixels. Angles on the screen run the other way (y points down).
const SHAPES = {
  point: (p, shape, to) => {
    const [x, y] = to(p).map(n);
    return MARKERS[paint(shape.kind).marker](x, y, shape.kind)
      + label(to, x, y, shape);
  },
  line: (p, shape, to) => stroked(polyline(pairs(p).map(to)), shape),
  arrow: (p, shape, to) => {
    const [x0, y0] = to(p), [x1, y1] = to([p[2], p[3]]);
    const long = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
    if (long < 0.5) return "";
    const head = Math.min(11, long), [ux, uy] = [(x1 - x0) / long, (y1 - y0) / long];
    const [bx, by] = [x1 - head * ux, y1 - head * uy], w = head * 0.42;
    return stroked(`M${n(x0)} ${n(y0)}L${n(bx)} ${n(by)}`, shape)
      + `<path d="M${n(x1)} ${n(y1)}L${n(bx - w * uy)} ${n(by + w * ux)}`
      + `L${n(bx + w * uy)} ${n(by - w * ux)}z" ${fill(shape.kind)}/>`
      + label(to, x1, y1, shape, [ux, uy]);
  },
  wheel: (p, shape, to) => {
    const [x, y] = to(p).map(n), [w, h] = [shape.length * to.scale, shape.width * to.scale];
    const gap = w / 4, shift = to.scale * p[3], treads = [0, 1, 2, 3]
      .map((k) => `M${n(((k * gap + shift) % w + w) % w - w / 2)} ${n(-h / 2)}v${n(h)}`);
    return `<g ${atAngle(x, y, p[2])} style="fill:${color(shape.kind)};fill-opacity:.35;`
      + `stroke:${color(shape.kind)};stroke-width:2"><rect x="${n(-w / 2)}" y="${n(-h / 2)}" `
      + `width="${n(w)}" height="${n(h)}" rx="2"/>`
      + `<path d="${w > 16 ? treads.join("") : ""}" style="stroke-width:1"/></g>`;
  },
  disc: (p, shape, to) => {
    const [x, y] = to(p).map(n), r = shape.radius * to.scale;
    const spokes = Array.from({ length: shape.spokes }, (_, k) => {
      const turn = 2 * Math.PI * k / shape.spokes;
      return `M0 0L${n(r * Math.cos(turn))} ${n(-r * Math.sin(turn))}`;
    });
    return `<g ${atAngle(x, y, p[2])} style="fill:${color(shape.kind)};fill-opacity:.15;`
      + `stroke:${color(shape.kind)};stroke-width:2"><circle r="${n(r)}" style="stroke-width:4"/>`
      + `<path d="${spokes.join("")}"/><circle r="4" style="fill-opacity:1"/></g>`;
  },
  area: (p, shape, to) => `<path d="${polyline(pairs(p).map(to))}z" style="fill:${color(shape.kind)};`
    + `fill-opacity:.16"/>`,
  length: (p, shape, to) => {
    const [[x0, y0], [x1, y1]] = pairs(p).map(to), long = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
    if (long < 1) return "";
    const [ux, uy] = [(x1 - x0) / long, (y1 - y0) / long], off = shape.aside * to.scale;
    const end = (x, y) => `M${n(x)} ${n(y)}L${n(x + off * uy)} ${n(y - off * ux)}`;
    const [ax, ay, bx, by] = [x0 + off * uy, y0 - off * ux, x1 + off * uy, y1 - off * ux];
    return stroked(`M${n(ax)} ${n(ay)}L${n(bx)} ${n(by)}`, shape)
      + `<path d="${off ? end(x0, y0) + end(x1, y1) : ""}M${n(ax - 5 * uy)} ${n(ay + 5 * ux)}l${n(10 * uy)} `
      + `${n(-10 * ux)}M${n(bx - 5 * uy)} ${n(by + 5 * ux)}l${n(10 * uy)} ${n(-10 * ux)}" `
      + `${stroke(shape.kind, ";stroke-dasharray:none;stroke-width:1")}/>`
      + label(to, (ax + bx) / 2, (ay + by) / 2, shape, off < 0 ? [-uy, ux] : [uy, -ux]);
  },
  label: (p, shape, to) => label(to, ...to(p), shape, [0, 0]),
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
    const [mx, my] = points[steps / 2], [cx, cy] = to(p), arc = polyline(points);
    const far = Math.sqrt((mx - cx) ** 2 + (my - cy) ** 2) || 1;
    return `<path d="${arc}L${n(cx)} ${n(cy)}z" style="fill:${color(shape.kind)};fill-opacity:.16"/>`
      + stroked(arc, shape, ";stroke-dasharray:none")
      + label(to, mx, my, shape, [(mx - cx) / far, (my - cy) / far]);
  },
};
