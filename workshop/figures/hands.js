// Hands on a live figure: controls, clock, handles, the ground of a picture in space.

const followControls = (live) => live.inputs.forEach((input) => {
  input.addEventListener("input", () => {
    pause(live);
    live.setOne(Number(input.dataset.i), Number(input.value));
  });
});

const followReset = (live) => live.element.querySelector(".rk-reset")
  .addEventListener("click", () => {
    pause(live);
    live.set(startState(live.figure));
  });

// ---- the clock

const reducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

const pause = (live) => {
  cancelAnimationFrame(live.tick);
  live.tick = 0;
  live.all(".rk-play").forEach((button) => { button.textContent = "Play"; });
};

const play = (live, i, from) => {
  const control = live.figure.controls[i], began = performance.now();
  const tick = (now) => {
    const time = clamp(control, from + control.rate * Math.max(0, now - began) / 1000);
    live.setOne(i, time);
    if (time >= control.high) pause(live); else live.tick = requestAnimationFrame(tick);
  };
  live.tick = requestAnimationFrame(tick);
};

const followClock = (live) => live.all(".rk-play").forEach((button) => {
  button.addEventListener("click", () => {
    if (live.tick) return pause(live);
    const i = Number(button.dataset.i), control = live.figure.controls[i];
    const ended = live.state[i] >= control.high, from = ended ? control.low : live.state[i];
    if (reducedMotion()) {
      const step = (control.high - control.low) / 10;
      return live.setOne(i, snap(control, from + (ended ? 0 : step)));
    }
    button.textContent = "Pause";
    play(live, i, from);
  });
});

// ---- handles: a pointer in world coordinates becomes settings of the controls

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

const handleHtml = (handle) =>
  `<circle r="17" tabindex="0" role="button" aria-roledescription="draggable point" `
  + `aria-label="${escaped(handle.label)}: drag, or move with the arrow keys"/>`;

const takeHandles = (live) => {
  const { figure, picture } = live, circles = figure.handles.map(handleHtml).join("");
  picture.insertAdjacentHTML("beforeend", `<g class="rk-handles">${circles}</g>`);
  live.handles = live.all(".rk-handles circle");
  figure.handles.forEach((handle, k) => {
    followPointer(live, handle, live.handles[k]);
    followArrows(live, handle, live.handles[k]);
  });
};

const pointer = ({ picture, figure: { view } }, event) => {
  const box = picture.getBoundingClientRect();
  return [view[0] + (event.clientX - box.left) / box.width * (view[1] - view[0]),
    view[3] - (event.clientY - box.top) / box.height * (view[3] - view[2])];
};

const dragTo = (live, handle, point, rounded) => {
  const next = handle.to(f, settings(live.figure, live.state), point), placed = live.state.slice();
  handle.sets.forEach((i, k) => {
    const control = live.figure.controls[i];
    if (!Number.isFinite(next[k])) return;
    placed[i] = (rounded ? snap : clamp)(control, next[k] / control.factor);
  });
  pause(live);
  live.set(placed);
};

const followPointer = (live, handle, grip) => {
  let off = [0, 0]; // a handle taken at its edge must not jump to the pointer
  grip.addEventListener("pointerdown", (event) => {
    const at = pointer(live, event);
    off = live.place(handle).map((x, i) => (Number.isFinite(x) ? x - at[i] : 0));
    grip.setPointerCapture(event.pointerId);
    grip.focus({ preventScroll: true });
    event.preventDefault();
  });
  // in SVG, `touch-action` alone lets the page scroll away with the finger
  grip.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  grip.addEventListener("pointermove", (event) => {
    if (!grip.hasPointerCapture(event.pointerId)) return;
    dragTo(live, handle, pointer(live, event).map((x, i) => x + off[i]), true);
  });
};

const followArrows = (live, handle, grip) => grip.addEventListener("keydown", (event) => {
  const move = ARROWS[event.key], { view } = live.figure;
  if (!move) return;
  event.preventDefault();
  const step = (view[1] - view[0]) / (event.shiftKey ? 20 : 100);
  dragTo(live, handle, live.place(handle).map((x, i) => x + step * move[i]), false);
});

// ---- the ground: dragging it turns the view, by half a turn across the picture

const turned = (live, held, event) => {
  const { figure, picture } = live, next = live.state.slice();
  const moved = [held.x - event.clientX, event.clientY - held.y];
  figure.turns.forEach((i, k) => {
    const shown = held.state[i] + 180 * moved[k] / picture.getBoundingClientRect().width;
    next[i] = snap(figure.controls[i], allRound(figure.controls[i], shown));
  });
  return next;
};

const followGround = (live) => {
  if (!live.figure.turns) return;
  const { element, picture } = live;
  let held = null;
  element.classList.add("rk-turns");
  picture.addEventListener("pointerdown", (event) => {
    if (live.handles.includes(event.target) || event.button > 0) return;
    picture.setPointerCapture(event.pointerId);
    event.preventDefault();
    held = { x: event.clientX, y: event.clientY, state: live.state };
  });
  picture.addEventListener("pointermove", (event) => {
    if (held && picture.hasPointerCapture(event.pointerId)) live.set(turned(live, held, event));
  });
  picture.addEventListener("lostpointercapture", () => { held = null; });
};
