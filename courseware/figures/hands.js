// Hands on a live figure: controls, clock, handles, the ground of a picture in space.

const STEPPING = /^(Arrow|Page|Home|End)/;

const followControls = (live) => live.inputs.forEach((input) => {
  const inSteps = () => { input.step = live.figure.controls[input.dataset.i].step; };
  input.addEventListener("pointerdown", (event) => {
    inSteps();
    if (event.button > 0 || input.type !== "range") return;
    // no capture of the pointer: with it, WebKit would not move the thumb
    live.held = { by: input, state: live.state };
    addEventListener("pointerup", () => release(live, input), { once: true });
  });
  letGo(live, input);
  input.addEventListener("keydown", (event) => { if (STEPPING.test(event.key)) inSteps(); });
  input.addEventListener("input", () => {
    stops(live, Number(input.dataset.i));
    live.setOne(Number(input.dataset.i), Number(input.value));
  });
});

const followReset = (live) => live.element.querySelector(".rk-reset")
  ?.addEventListener("click", () => {
    pause(live);
    live.reached.clear();
    live.set(startState(live.figure));
    live.look?.();
  });

// ---- the clock

const reducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

// The words on a button, and whose it is for those who hear it alone.
const called = (button, words, { title }) => {
  button.textContent = words;
  button.ariaLabel = `${words}: ${title}`;
};

const pause = (live) => {
  cancelAnimationFrame(live.tick);
  live.tick = 0;
  live.all(".rk-play").forEach((button) => called(button, "Play", live.figure));
};

const REST = 0.8; // seconds at the end, before it starts again

const play = (live, i, from) => {
  const control = live.figure.controls[i], began = performance.now();
  const round = control.high - control.low + REST * control.rate;
  const tick = (now) => {
    const gone = from + control.rate * Math.max(0, now - began) / 1000;
    const time = clamp(control, control.loops ? control.low + (gone - control.low) % round : gone);
    live.setOne(i, time);
    if (time >= control.high && !control.loops) pause(live);
    else live.tick = requestAnimationFrame(tick);
  };
  live.tick = requestAnimationFrame(tick);
  live.all(".rk-play").forEach((button) => called(button, "Pause", live.figure));
};

// A hand on a control stops the clock; one that loops only if it is on the clock itself.
const stops = (live, i) => {
  const { controls } = live.figure;
  if (controls[i].loops || !controls.some(({ loops }) => loops)) pause(live);
  if (controls[i].loops) live.look = null;
};

// A clock that loops runs while its picture is in sight, until a hand stops it.
const followSight = (live) => {
  const i = live.figure.controls.findIndex(({ loops }) => loops);
  if (i < 0 || reducedMotion()) return;
  let seen = false;
  live.look = () => {
    if (seen && !live.tick) play(live, i, live.state[i]);
    if (!seen) pause(live);
  };
  new IntersectionObserver(([{ isIntersecting }]) => {
    seen = isIntersecting;
    live.look?.();
  }, { threshold: 0.5 }).observe(live.picture);
};

const followClock = (live) => live.all(".rk-play").forEach((button) => {
  button.addEventListener("click", () => {
    live.look = null; // from now on by hand
    if (live.tick) return pause(live);
    const i = Number(button.dataset.i), control = live.figure.controls[i];
    const ended = live.state[i] >= control.high, from = ended ? control.low : live.state[i];
    if (reducedMotion()) {
      const step = (control.high - control.low) / 10;
      return live.setOne(i, snap(control, from + (ended ? 0 : step)));
    }
    play(live, i, from);
  });
});

// ---- handles: a pointer in world coordinates becomes settings of the controls

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
const MAGNET = 6; // pixels: from so near a special value draws the hand to it

// To a screen reader a slider in two directions, whose number is that of the first thing it sets.
const handleHtml = (handle) =>
  `<circle r="17" tabindex="0" role="slider" aria-roledescription="draggable point" `
  + `aria-label="${escaped(handle.label)}: drag, or move with the arrow keys"/>`
  + `<ellipse rx="9" ry="9"/>`;

const tellHandle = (live, { sets }, grip) => {
  const { controls } = live.figure, [first] = sets, { low, high } = controls[first];
  const all = sets.map((i) => `${controls[i].label} ${shownControl(controls[i], live.state[i])}`);
  Object.assign(grip, { ariaValueMin: low, ariaValueMax: high, ariaValueNow: live.state[first],
    ariaValueText: all.join(", ") });
};

const takeHandles = (live) => {
  const { figure, picture } = live, grips = figure.handles.map(handleHtml).join("");
  picture.insertAdjacentHTML("beforeend", `<g class="rk-handles">${grips}</g>`);
  live.handles = live.all(".rk-handles circle");
  figure.handles.forEach((handle, k) => {
    followPointer(live, live.handles[k]);
    followArrows(live, handle, live.handles[k]);
  });
};

const pixel = ({ width, computed: { view } }) => (view[1] - view[0]) / width;

const ASIDE = [[0, 0], [0, -22], [22, 0], [0, 22], [-22, 0]];

// Where the handles are drawn, in pixels: inside the picture, and none under another. The one that
// was taken last keeps its place, others give way.
const spots = (live) => {
  const to = projection(live.computed.view, live.width), margin = 10, found = [];
  const high = heightOf(live.figure, live.width);
  const inside = (x, end) => Math.min(end - margin, Math.max(margin, x));
  const free = ([x, y]) => found.every(([a, b]) => Math.hypot(x - a, y - b) > 18);
  const order = [...live.handles.keys()].sort((a, b) => (b === live.last) - (a === live.last));
  for (const k of order) {
    const [at, up] = to(live.place(live.figure.handles[k]));
    const [x, y] = [inside(at, live.width), inside(up, high)];
    const tried = ASIDE.map(([dx, dy]) => [inside(x + dx, live.width), inside(y + dy, high)]);
    found[k] = Number.isFinite(at + up) ? tried.find(free) ?? tried[0] : [-99, -99];
  }
  return found;
};

const pointer = ({ picture, computed: { view } }, event) => {
  const box = picture.getBoundingClientRect();
  return [view[0] + (event.clientX - box.left) / box.width * (view[1] - view[0]),
    view[3] - (event.clientY - box.top) / box.height * (view[3] - view[2])];
};

// How far a few pixels move what a handle sets.
const reaches = (live, handle, given, [x, y], next) => {
  const by = MAGNET * pixel(live);
  const [across, up] = [[x + by, y], [x, y + by]].map((point) => handle.to(f, given, point));
  return next.map((value, k) => Math.hypot(across[k] - value, up[k] - value));
};

const dragTo = (live, handle, point, byHand) => {
  const { figure } = live, placed = live.state.slice();
  const given = compute(figure, settings(figure, live.state)).c;
  const next = handle.to(f, given, point), reach = reaches(live, handle, given, point, next);
  handle.sets.forEach((i, k) => {
    const control = figure.controls[i];
    if (!Number.isFinite(next[k])) return;
    placed[i] = clamp(control, next[k] / control.factor);
    if (byHand) placed[i] = attracted(figure, placed, i, reach[k] / control.factor);
  });
  handle.sets.forEach((i) => stops(live, i));
  live.set(placed);
};

// Where targets overlap, the handle that is nearest to the pointer is meant.
const nearest = (live, event) => {
  const far = (grip) => {
    const { left, right, top, bottom } = grip.getBoundingClientRect();
    return Math.hypot((left + right) / 2 - event.clientX, (top + bottom) / 2 - event.clientY);
  };
  return live.handles.reduce((best, grip) => (far(grip) < far(best) ? grip : best));
};

const followPointer = (live, grip) => {
  grip.addEventListener("pointerdown", (event) => {
    if (event.button > 0) return;
    event.preventDefault();
    live.settled();
    const taken = nearest(live, event), k = live.handles.indexOf(taken), at = pointer(live, event);
    // a handle taken at its edge must not jump to the pointer
    const off = live.place(live.figure.handles[k])
      .map((x, i) => (Number.isFinite(x) ? x - at[i] : 0));
    live.held = { by: taken, k, off, state: live.state, view: live.computed.view };
    live.last = k;
    taken.setPointerCapture(event.pointerId);
    taken.classList.add("rk-taken"); // without the ring of the keyboard, which would hide its label
    taken.focus({ preventScroll: true });
  });
  // in SVG, `touch-action` alone lets the page scroll away with the finger
  grip.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  grip.addEventListener("pointermove", (event) => {
    if (live.held?.by !== grip) return;
    const { k, off } = live.held;
    dragTo(live, live.figure.handles[k], pointer(live, event).map((x, i) => x + off[i]), true);
  });
  grip.addEventListener("blur", () => grip.classList.remove("rk-taken"));
  letGo(live, grip);
};

const release = (live, element) => {
  if (live.held?.by !== element) return;
  live.held = null;
  live.set(asShown(live.figure, live.state));
};

// What the system cuts short, as by a call, has not been.
const letGo = (live, element, undone = ({ state }) => state) => {
  element.addEventListener("pointercancel", () => {
    if (live.held?.by !== element) return;
    live.set(undone(live.held));
    live.held = null;
  });
  element.addEventListener("lostpointercapture", () => release(live, element));
};

const followArrows = (live, handle, grip) => {
  grip.addEventListener("keydown", (event) => {
    grip.classList.remove("rk-taken");
    const move = ARROWS[event.key], { view } = live.figure;
    if (!move) return;
    event.preventDefault();
    const step = (view[1] - view[0]) / (event.shiftKey ? 20 : 100);
    dragTo(live, handle, live.place(handle).map((x, i) => x + step * move[i]), false);
  });
  grip.addEventListener("keyup", ({ key }) => {
    if (ARROWS[key]) live.set(asShown(live.figure, live.state));
  });
};

// ---- the ground: dragging it turns the view, by half a turn across the picture

// What else moves meanwhile goes on.
const turned = (live, held, event) => {
  const { figure, picture } = live, next = live.state.slice();
  const moved = [held.x - event.clientX, event.clientY - held.y];
  const pixelTurns = 180 / picture.getBoundingClientRect().width;
  figure.viewAngles.forEach((i, k) => {
    next[i] = allRound(figure.controls[i], held.state[i] + pixelTurns * moved[k]);
    next[i] = attracted(figure, next, i, MAGNET * pixelTurns);
  });
  return next;
};

const UNDECIDED = 10; // pixels: so far a finger may still mean to scroll the page

const followGround = (live) => {
  if (!live.figure.viewAngles) return;
  const { element, picture } = live;
  element.classList.add("rk-turns");
  picture.addEventListener("pointerdown", (event) => {
    if (live.handles.includes(event.target) || event.button > 0) return;
    picture.setPointerCapture(event.pointerId);
    event.preventDefault();
    const waits = event.pointerType === "touch";
    live.held = { by: picture, x: event.clientX, y: event.clientY, state: live.state, waits };
  });
  picture.addEventListener("pointermove", (event) => {
    const { held } = live;
    if (held?.by !== picture) return;
    const across = Math.abs(event.clientX - held.x), along = Math.abs(event.clientY - held.y);
    held.waits &&= across < UNDECIDED || across < along;
    if (!held.waits) live.set(turned(live, held, event));
  });
  letGo(live, picture, ({ state }) =>
    live.state.map((now, i) => (live.figure.viewAngles.includes(i) ? state[i] : now)));
};
