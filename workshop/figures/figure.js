// Live figures: one pure function from a state to text (SVG and HTML), and the hands that move
// the state. It draws what the declaration says and knows no kinematics.
//
// figure: { name, title, view, controls, handles, readouts, says, recurrences, where, compute, scene,
// turns?, grid? }, made by robokin/live/compiling.py. state: what each control shows, in the units it shows.

// ---- from a state to numbers

const startState = (figure) => figure.controls.map((control) => control.start);

const vector = (figure, state) => figure.controls.flatMap((control, i) =>
  control.type === "choice" ? control.options[state[i]].values : [state[i] * control.factor]);

const run = (recurrence, c) => {
  const count = Math.min(Math.max(0, Math.round(recurrence.count(f, c)[0])), recurrence.most);
  const states = [recurrence.start(f, c)];
  for (let i = 0; i < count; i++) states.push(recurrence.step(f, c, states[i]));
  return states;
};

// A figure's numbers build on each other: settings, last states of its loops, named steps.
// All numbers of the figure at once: readouts first, then what the scene refers to by index.
const compute = (figure, settings) => {
  const trails = figure.recurrences.map((recurrence) => run(recurrence, settings));
  const given = settings.concat(...trails.map((states) => states[states.length - 1]));
  const c = given.concat(figure.where(f, given));
  return { c, trails, values: figure.compute(f, c) };
};

const clamp = (control, shown) => {
  const inside = Math.min(control.high, Math.max(control.low, shown));
  return control.whole ? Math.round(inside) : inside;
};

const snap = (control, shown) => {
  const steps = Math.round((shown - control.low) / control.step);
  return clamp(control, Number((control.low + steps * control.step).toFixed(9)));
};

// A slider that goes all the way round has no end: past it, it goes on from the other one.
const allRound = ({ low, high }, shown) =>
  high - low === 360 ? shown - 360 * Math.floor((shown - low) / 360) : shown;

// ---- from numbers to words

const fixed = (number, digits) =>
  number.toFixed(digits).replace(/^-(?=[0.]*$)/, "").replace("-", "\u2212");

const shownNumber = (readout, value) => {
  if (String(value) in readout.words) return readout.words[String(value)];
  const number = fixed(value * readout.factor, readout.digits);
  return readout.unit === "°" ? number + "°" : readout.unit ? `${number} ${readout.unit}` : number;
};

const shownControl = (control, shown) => control.type === "choice"
  ? control.options[shown].label
  : shownNumber({ words: {}, factor: 1, digits: control.digits, unit: control.unit }, shown);

const says = (figure, state, values) => figure.says.replace(/\{(\w+)\}/g, (_, key) => {
  const i = figure.controls.findIndex((control) => control.key === key);
  if (i >= 0) return shownControl(figure.controls[i], state[i]);
  const k = figure.readouts.findIndex((readout) => readout.key === key);
  return shownNumber(figure.readouts[k], values[k]);
});

const alternative = (figure, state, values) => `${figure.title}. ${says(figure, state, values)}`;

const escaped = (text) => String(text).replace(/[&<>"]/g, (sign) =>
  ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);

// In a label "v_L" is a symbol: an italic letter with its index.
const symbols = (label, write) => escaped(label).replace(/(?<!\S)(\S)_(\w+)/g, write);
const svgLabel = (label) =>
  symbols(label, '$1<tspan dy="4" font-size="75%" font-style="normal">$2</tspan>');
const htmlLabel = (label) => symbols(label, "<i>$1</i><sub>$2</sub>");

// ---- from numbers to a picture

const paint = (kind) => KINDS[kind];
const color = (kind) => `var(--rk-${kind},${paint(kind).light})`;
const stroke = (kind, extra = "") => {
  const { dash, width } = paint(kind);
  const dashes = dash.length ? `;stroke-dasharray:${dash.join(" ")}` : "";
  return `style="fill:none;stroke:${color(kind)};stroke-width:${width}${dashes}${extra}"`;
};
const fill = (kind) => `style="fill:${color(kind)};stroke:none"`;
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

const label = (x, y, text, kind, shift = [8, -8]) => `<text x="${n(x + shift[0])}" `
  + `y="${n(y + shift[1])}" style="fill:${color(kind)};stroke:var(--rk-ground,#fff);`
  + `stroke-width:3px;paint-order:stroke;font:italic 15px serif">${svgLabel(text)}</text>`;

const polyline = (points) => points
  .map(([x, y], i) => `${i && Number.isFinite(points[i - 1][0]) ? "L" : "M"}${n(x)} ${n(y)}`)
  .filter((piece) => !/NaN|Infinity/.test(piece)).join("");

// In space a line leaves a gap in what it passes in front of.
const gap = (line, kind) => `<path d="${line}" style="fill:none;stroke:var(--rk-ground,#fff);`
  + `stroke-width:${paint(kind).width + 4}"/>`;

// A curve in space, near here and far there: pieces, each with the depth of its middle. The dashes
// run on from piece to piece.
const inPieces = (points, depths, kind, size = 4) => {
  const pieces = [];
  for (let i = 0, run = 0; i < points.length - 1; i += size) {
    const piece = points.slice(i, i + size + 1);
    const line = polyline(piece), offset = paint(kind).dash.length ? `;stroke-dashoffset:${n(run)}` : "";
    const text = `${gap(line, kind)}<path d="${line}" ${stroke(kind, offset)}/>`;
    const depth = depths[i + (piece.length >> 1)];
    if (Number.isFinite(depth)) pieces.push({ text, depth });
    piece.slice(1).forEach(([x, y], k) => {
      run += Math.sqrt((x - piece[k][0]) ** 2 + (y - piece[k][1]) ** 2);
    });
  }
  return pieces;
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
    const line = polyline(points);
    return ("depth" in shape ? gap(line, shape.kind) : "") + `<path d="${line}" ${stroke(shape.kind)}/>`;
  },
  arrow: (p, shape, to) => {
    const [x0, y0] = to(p), [x1, y1] = to([p[2], p[3]]);
    const long = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
    if (long < 0.5) return "";
    const head = Math.min(11, long), [ux, uy] = [(x1 - x0) / long, (y1 - y0) / long];
    const [bx, by] = [x1 - head * ux, y1 - head * uy], w = head * 0.42;
    const shaft = `M${n(x0)} ${n(y0)}L${n(bx)} ${n(by)}`;
    return ("depth" in shape ? gap(shaft, shape.kind) : "") + `<path d="${shaft}" ${stroke(shape.kind)}/>`
      + `<path d="M${n(x1)} ${n(y1)}L${n(bx - w * uy)} ${n(by + w * ux)}`
      + `L${n(bx + w * uy)} ${n(by - w * ux)}z" ${fill(shape.kind)}/>`
      + (shape.label ? label(x1, y1, shape.label, shape.kind, [30 * ux - 7, 30 * uy + 5]) : "");
  },
  wheel: (p, shape, to) => {
    const [x, y] = to(p).map(n), [w, h] = [shape.length * to.scale, shape.width * to.scale];
    return `<rect x="${n(-w / 2)}" y="${n(-h / 2)}" width="${n(w)}" height="${n(h)}" rx="2" `
      + `transform="translate(${x} ${y}) rotate(${n(-p[2] * 180 / Math.PI)})" `
      + `style="fill:${color(shape.kind)};fill-opacity:.35;stroke:${color(shape.kind)};`
      + `stroke-width:2"/>`;
  },
  body: (p, shape, to) => {
    const [x, y] = to(p).map(n), r = n(shape.radius * to.scale);
    return `<g transform="translate(${x} ${y}) rotate(${n(-p[2] * 180 / Math.PI)})">`
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
    if (depths[0] === undefined) return `<path d="${polyline(points)}" ${stroke(shape.kind)}/>`;
    return inPieces(points, depths, shape.kind);
  },
  trail: (p, shape, to, { c, trails }) => {
    const points = trails[shape.recurrence].map((state) => to(shape.point(f, c, state)));
    const corners = points.length > 60 ? "" : points
      .map(([x, y]) => `<circle cx="${n(x)}" cy="${n(y)}" r="3" ${fill(shape.kind)}/>`).join("");
    return `<path d="${polyline(points)}" ${stroke(shape.kind)}/>${corners}`;
  },
  angle: (p, shape, to) => {
    const [x, y, from, until] = p, points = [], steps = 24;
    for (let i = 0; i <= steps; i++) {
      const a = from + (until - from) * i / steps;
      points.push(to([x + shape.radius * Math.cos(a), y + shape.radius * Math.sin(a)]));
    }
    const [mx, my] = points[steps / 2];
    return `<path d="${polyline(points)}" ${stroke(shape.kind, ";stroke-dasharray:none")}/>`
      + (shape.label ? label(mx, my, shape.label, shape.kind) : "");
  },
};

const grid = (view, to, width, height) => {
  const span = view[1] - view[0], rough = span / 6;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough * 0.99);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const text = (x, y, words, anchor) => `<text x="${n(x)}" y="${n(y)}" text-anchor="${anchor}" `
    + `style="fill:${color("text")};fill-opacity:.7;font:11px sans-serif">${words}</text>`;
  let lines = "", numbers = "";
  for (let k = Math.ceil(view[0] / step); k * step <= view[1]; k++) {
    const [x] = to([k * step, 0]).map(n);
    lines += `M${x} 0V${n(height)}`;
    if (x > 40 && x < width - 72) numbers += text(x + 3, height - 5, fixed(k * step, digits), "start");
  }
  for (let k = Math.ceil(view[2] / step); k * step <= view[3]; k++) {
    const [, y] = to([0, k * step]).map(n);
    lines += `M0 ${y}H${n(width)}`;
    if (y > 20 && y < height - 30) numbers += text(4, y - 3, fixed(k * step, digits), "start");
  }
  return `<path d="${lines}" ${stroke("grid")}/>${numbers}${text(width - 5, height - 5, "x, y in m", "end")}`;
};

const projection = (view, width) => {
  const scale = width / (view[1] - view[0]);
  const to = ([x, y]) => [(x - view[0]) * scale, (view[3] - y) * scale];
  to.scale = scale;
  return to;
};

const scene = (figure, computed, width) => {
  const to = projection(figure.view, width);
  const height = to.scale * (figure.view[3] - figure.view[2]);
  const pieces = figure.scene.flatMap((shape) => {
    const at = shape.at.map((index) => computed.values[index]);
    const depth = "depth" in shape ? computed.values[shape.depth] : 0;
    if (![...at, depth].every(Number.isFinite)) return [];
    const drawn = SHAPES[shape.shape](at, shape, to, computed);
    if (typeof drawn !== "string") return drawn;
    return "depth" in shape ? { text: drawn, depth } : { text: drawn };
  });
  // those with a depth change places among themselves: the nearest is painted last
  const deep = pieces.filter((piece) => "depth" in piece).sort((a, b) => a.depth - b.depth);
  const ground = figure.grid === false ? "" : grid(figure.view, to, width, height);
  return ground + pieces.map((piece) => ("depth" in piece ? deep.shift() : piece).text).join("");
};

const WIDTH = 640;

const svg = (figure, state, width = WIDTH) => {
  const computed = compute(figure, vector(figure, state));
  const height = n(width * (figure.view[3] - figure.view[2]) / (figure.view[1] - figure.view[0]));
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" `
    + `width="${width}" height="${height}">`
    + `<rect width="100%" height="100%" style="fill:var(--rk-ground,#fff)"/>`
    + `<g role="img" aria-label="${escaped(alternative(figure, state, computed.values))}">`
    + `${scene(figure, computed, width)}</g></svg>`;
};

// ---- the whole figure as HTML: the same text on the page before and after the script takes over

const controlHtml = (control, i) => {
  const swatch = control.kind
    ? `<svg class="rk-swatch" width="26" height="8" aria-hidden="true">`
      + `<path d="M0 4H26" ${stroke(control.kind)}/></svg>` : "";
  const name = `<span class="rk-name">${swatch}${htmlLabel(control.label)}</span>`;
  if (control.type === "choice") {
    const options = control.options.map((option, k) =>
      `<option value="${k}"${k === control.start ? " selected" : ""}>${escaped(option.label)}</option>`);
    return `<label class="rk-control">${name}<select data-i="${i}">${options.join("")}</select></label>`;
  }
  const play = control.type === "clock"
    ? `<button type="button" class="rk-play" data-i="${i}">Play</button>` : "";
  return `<div class="rk-control">${play}<label>${name}<span class="rk-value" data-o="${i}" aria-hidden="true">`
    + `${shownControl(control, control.start)}</span><input type="range" data-i="${i}" `
    + `min="${control.low}" max="${control.high}" step="${control.step}" `
    + `value="${control.start}" aria-valuetext="${shownControl(control, control.start)}"></label></div>`;
};

const readoutHtml = (readout, value) =>
  `<div><dt>${htmlLabel(readout.label)}</dt><dd>${escaped(shownNumber(readout, value))}</dd></div>`;

const html = (figure, state = startState(figure)) => {
  const { values } = compute(figure, vector(figure, state));
  return `<div class="rk-picture">${svg(figure, state)}</div>`
    + `<div class="rk-panel"><div class="rk-controls">${figure.controls.map(controlHtml).join("")}</div>`
    + `<dl class="rk-readouts">${figure.readouts.map((r, k) => readoutHtml(r, values[k])).join("")}</dl>`
    + `<div class="rk-buttons"><button type="button" class="rk-reset">Reset</button>`
    + `<button type="button" class="rk-link">Link to this setting</button></div></div>`
    + `<p class="rk-says" aria-live="polite"></p>`;
};

// ---- hands on the figure

const reducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

// Put a figure to life in an element that holds its HTML. `changed(state)` is told of each new
// state; the returned function sets one.
const bringToLife = (element, figure, changed = () => {}) => {
  let state = startState(figure), computed, width = WIDTH, playing = 0, waiting = 0, telling = 0;
  const all = (selector) => [...element.querySelectorAll(selector)];
  const picture = element.querySelector(".rk-picture svg"), drawing = picture.querySelector("g");
  const [inputs, outputs, values] = [all("[data-i]:not(button)"), all("[data-o]"), all("dd")];
  picture.insertAdjacentHTML("beforeend", `<g class="rk-handles">${figure.handles.map((handle) =>
    `<circle r="17" tabindex="0" role="button" aria-roledescription="draggable point" `
    + `aria-label="${escaped(handle.label)}: drag, or move with the arrow keys"/>`).join("")}</g>`);
  const handles = all(".rk-handles circle");

  const draw = () => {
    waiting = 0;
    computed = compute(figure, vector(figure, state));
    drawing.innerHTML = scene(figure, computed, width);
    const to = projection(figure.view, width);
    figure.handles.forEach((handle, k) => {
      const [x, y] = to(handle.at.map((index) => computed.values[index]));
      handles[k].setAttribute("cx", Number.isFinite(x) ? n(x) : -99);
      handles[k].setAttribute("cy", Number.isFinite(y) ? n(y) : -99);
    });
    figure.readouts.forEach((readout, k) => {
      values[k].textContent = shownNumber(readout, computed.values[k]);
    });
    inputs.forEach((input) => {
      const i = Number(input.dataset.i), control = figure.controls[i];
      input.value = state[i];
      if (control.type !== "choice") input.setAttribute("aria-valuetext", shownControl(control, state[i]));
    });
    outputs.forEach((output) => {
      const i = Number(output.dataset.o);
      output.textContent = shownControl(figure.controls[i], state[i]);
    });
    clearTimeout(telling);
    telling = setTimeout(() => {
      const words = says(figure, state, computed.values);
      drawing.setAttribute("aria-label", alternative(figure, state, computed.values));
      if (element.contains(document.activeElement)) element.querySelector(".rk-says").textContent = words;
    }, 400);
  };

  const set = (next, quiet = false) => {
    state = next;
    if (!quiet) changed(state);
    if (!waiting) waiting = requestAnimationFrame(draw);
  };
  const setOne = (i, shown) => set(state.map((old, k) => (k === i ? shown : old)));

  inputs.forEach((input) => input.addEventListener("input", () => {
    pause();
    setOne(Number(input.dataset.i), Number(input.value));
  }));

  // the clock
  const pause = () => {
    cancelAnimationFrame(playing);
    playing = 0;
    all(".rk-play").forEach((button) => { button.textContent = "Play"; });
  };
  all(".rk-play").forEach((button) => button.addEventListener("click", () => {
    const i = Number(button.dataset.i), control = figure.controls[i];
    if (playing) return pause();
    const from = state[i] >= control.high ? control.low : state[i];
    if (reducedMotion()) {
      const step = (control.high - control.low) / 10;
      return setOne(i, snap(control, from + (state[i] >= control.high ? 0 : step)));
    }
    button.textContent = "Pause";
    const began = performance.now();
    const tick = (now) => {
      const time = clamp(control, from + control.rate * Math.max(0, now - began) / 1000);
      setOne(i, time);
      if (time >= control.high) pause(); else playing = requestAnimationFrame(tick);
    };
    playing = requestAnimationFrame(tick);
  }));

  // draggable points: a pointer in world coordinates becomes settings of the controls
  const dragTo = (handle, point, rounded) => {
    const next = handle.to(f, vector(figure, state), point);
    const placed = state.slice();
    handle.sets.forEach((i, k) => {
      const control = figure.controls[i];
      if (!Number.isFinite(next[k])) return;
      const shown = next[k] / control.factor;
      placed[i] = rounded ? snap(control, shown) : clamp(control, shown);
    });
    pause();
    set(placed);
  };
  const pointer = (event) => {
    const box = picture.getBoundingClientRect(), { view } = figure;
    return [view[0] + (event.clientX - box.left) / box.width * (view[1] - view[0]),
      view[3] - (event.clientY - box.top) / box.height * (view[3] - view[2])];
  };
  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
  figure.handles.forEach((handle, k) => {
    const grip = handles[k], place = () => handle.at.map((index) => computed.values[index]);
    let off = [0, 0];  // a handle taken at its edge must not jump to the pointer
    grip.addEventListener("pointerdown", (event) => {
      const at = pointer(event);
      off = place().map((x, i) => Number.isFinite(x) ? x - at[i] : 0);
      grip.setPointerCapture(event.pointerId);
      grip.focus({ preventScroll: true });
      event.preventDefault();
    });
    // in SVG, `touch-action` alone lets the page scroll away with the finger
    grip.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    grip.addEventListener("pointermove", (event) => {
      if (!grip.hasPointerCapture(event.pointerId)) return;
      dragTo(handle, pointer(event).map((x, i) => x + off[i]), true);
    });
    grip.addEventListener("keydown", (event) => {
      const move = ARROWS[event.key];
      if (!move) return;
      event.preventDefault();
      const step = (figure.view[1] - figure.view[0]) / (event.shiftKey ? 20 : 100);
      const at = place();
      dragTo(handle, [at[0] + step * move[0], at[1] + step * move[1]], false);
    });
  });

  // dragging the ground turns the view: by half a turn across the picture
  if (figure.turns) {
    element.classList.add("rk-turns");
    let held = null;
    picture.addEventListener("pointerdown", (event) => {
      if (handles.includes(event.target) || event.button > 0) return;
      picture.setPointerCapture(event.pointerId);
      event.preventDefault();
      held = { x: event.clientX, y: event.clientY, state };
    });
    picture.addEventListener("pointermove", (event) => {
      if (!held || !picture.hasPointerCapture(event.pointerId)) return;
      const moved = [held.x - event.clientX, event.clientY - held.y];
      const next = state.slice();
      figure.turns.forEach((i, k) => {
        const shown = held.state[i] + 180 * moved[k] / picture.getBoundingClientRect().width;
        next[i] = snap(figure.controls[i], allRound(figure.controls[i], shown));
      });
      set(next);
    });
    picture.addEventListener("lostpointercapture", () => { held = null; });
  }

  element.querySelector(".rk-reset").addEventListener("click", () => {
    pause();
    set(startState(figure));
  });

  const resize = () => {
    width = Math.max(240, Math.round(element.querySelector(".rk-picture").clientWidth || WIDTH));
    const height = n(width * (figure.view[3] - figure.view[2]) / (figure.view[1] - figure.view[0]));
    picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    picture.setAttribute("width", width);
    picture.setAttribute("height", height);
    draw();
  };
  resize();
  new ResizeObserver(resize).observe(element.querySelector(".rk-picture"));
  element.classList.add("rk-live");
  return { set, state: () => state, settled: () => { if (waiting) { cancelAnimationFrame(waiting); draw(); } } };
};

// ---- on a web page: the address carries a setting, the script takes over the waiting picture

const toAddress = (figure, state) => `#${figure.name}?` + figure.controls.map((control, i) =>
  `${control.key}=${encodeURIComponent(control.type === "choice"
    ? control.options[state[i]].label : Number(state[i].toFixed(6)))}`).join("&");

const fromAddress = (figure, address) => {
  const [name, query] = address.replace(/^#/, "").split("?");
  if (name !== figure.name || !query) return null;
  const given = new URLSearchParams(query);
  return figure.controls.map((control) => {
    const text = given.get(control.key);
    if (control.type === "choice") {
      const i = control.options.findIndex((option) => option.label === text);
      return i < 0 ? control.start : i;
    }
    const shown = text === null || text === "" ? NaN : Number(text);
    return Number.isFinite(shown) ? clamp(control, shown) : control.start;
  });
};

const onPage = (figure) => {
  const element = document.getElementById(figure.name), before = element.innerHTML;
  try {
    const live = bringToLife(element, figure);
    const button = element.querySelector(".rk-link");
    button.addEventListener("click", () => {
      history.replaceState(null, "", toAddress(figure, live.state()));
      button.textContent = "The link is in the address bar";
      navigator.clipboard?.writeText(location.href).then(
        () => { button.textContent = "Link copied"; }, () => {});
      setTimeout(() => { button.textContent = "Link to this setting"; }, 2500);
    });
    const follow = () => {
      const state = fromAddress(figure, location.hash);
      if (!state) return;
      live.set(state);
      element.scrollIntoView();
    };
    addEventListener("hashchange", follow);
    follow();
    live.settled();
    element.robokin = live;
  } catch (error) {
    element.innerHTML = before; // the still picture stays, without its controls
    element.querySelector(".rk-panel").remove();
    element.classList.remove("rk-live");
    console.error(`The figure ${figure.name} cannot be moved:`, error);
  }
};

// ---- in a notebook: an anywidget, whose `values` are the settings in SI units

const toValues = (figure, state) => Object.fromEntries(figure.controls.map((control, i) =>
  [control.key, control.type === "choice" ? control.options[state[i]].label : state[i] * control.factor]));

const fromValues = (figure, values) => figure.controls.map((control) => {
  if (!(control.key in values)) return control.start;
  const value = values[control.key];
  return control.type === "choice"
    ? control.options.findIndex((option) => option.label === value)
    : clamp(control, value / control.factor);
});

const inNotebook = (figure, { model, el }) => {
  el.classList.add("rk-figure");
  el.innerHTML = html(figure);
  el.querySelector(".rk-link").remove();
  const live = bringToLife(el, figure, (state) => {
    model.set("values", toValues(figure, state));
    model.save_changes();
  });
  const follow = () => live.set(fromValues(figure, model.get("values")), true);
  follow();
  model.on("change:values", follow);
  return () => model.off("change:values", follow);
};
