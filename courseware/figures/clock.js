// Animations: the clock, quarter turns, and buttons that move sliders.

import { functions } from "../equations/functions.js";
import { clamp, snap } from "./state.js";

export const prefersReducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

// Screen readers say which figure the button belongs to.
const nameButton = (button, words, { title }) => {
  button.textContent = words;
  button.ariaLabel = `${words}: ${title}`;
};

export const pauseClock = (live) => {
  if (!live.tick) return;
  cancelAnimationFrame(live.tick);
  live.tick = 0;
  live.all(".rk-play").forEach((button) => nameButton(button, "Play", live.figure));
};

const REST_SECONDS = 0.8; // at the end, before it starts again
const ROUNDS = 2; // of what starts by itself; a press plays it again

const playClock = (live, i, from) => {
  const control = live.figure.controls[i], began = performance.now();
  const round = control.high - control.low + REST_SECONDS * control.rate;
  const tick = (now) => {
    const gone = from + control.rate * Math.max(0, now - began) / 1000;
    const rests = live.resumeClock && gone >= control.low + ROUNDS * round;
    const time = clamp(control, control.loops && !rests ? control.low + (gone - control.low) % round : gone);
    live.setOne(i, time);
    if (rests) live.resumeClock = null;
    if (rests || (time >= control.high && !control.loops)) pauseClock(live);
    else live.tick = requestAnimationFrame(tick);
  };
  live.tick = requestAnimationFrame(tick);
  live.all(".rk-play").forEach((button) => nameButton(button, "Pause", live.figure));
};

// A hand on a control stops the clock; one that loops only if it is on the clock itself.
export const stopClock = (live, i) => {
  const { controls } = live.figure;
  if (controls[i].loops || !controls.some(({ loops }) => loops)) pauseClock(live);
  if (controls[i].loops) live.resumeClock = null;
};

// What moves rests out of sight. A clock that loops runs twice by itself, under no veil, unless a
// hand stops it.
export const followSight = (live) => {
  const i = live.figure.controls.findIndex(({ loops }) => loops);
  let seen = false;
  if (i >= 0 && !prefersReducedMotion()) {
    live.resumeClock = () => {
      const runs = seen && !live.element.matches(".rk-veiled");
      if (runs && !live.tick) playClock(live, i, live.state[i]);
      if (!runs) pauseClock(live);
    };
  }
  new IntersectionObserver(([{ isIntersecting }]) => {
    seen = isIntersecting;
    if (seen) live.element.classList.add("rk-seen");
    if (!seen && live.tick) pauseClock(live);
    live.resumeClock?.();
  }, { threshold: 0.5 }).observe(live.picture);
};

export const followClock = (live) => live.all(".rk-play").forEach((button) => {
  button.addEventListener("click", () => {
    live.resumeClock = null; // from now on by hand
    if (live.tick) return pauseClock(live);
    const i = Number(button.dataset.i), control = live.figure.controls[i];
    const ended = live.state[i] >= control.high, from = ended ? control.low : live.state[i];
    if (prefersReducedMotion()) {
      const step = (control.high - control.low) / 10;
      return live.setOne(i, snap(control, from + (ended ? 0 : step)));
    }
    playClock(live, i, from);
  });
});

// Draw parts from 0 to 1, in a time in ms; it ends if a control is set anew meanwhile. Goals on the
// way are not reached.
const animate = (live, time, draw, isOurs) => {
  const show = (part) => {
    live.passing = part < 1;
    draw(part);
  };
  cancelAnimationFrame(live.turning);
  if (prefersReducedMotion()) return show(1);
  const began = performance.now();
  const tick = (now) => {
    if (!isOurs()) return void (live.passing = false);
    const part = Math.min(1, Math.max(0, now - began) / time);
    show(part);
    if (part < 1) live.turning = requestAnimationFrame(tick);
  };
  show(0);
  live.turning = requestAnimationFrame(tick);
};

export const followTurns = (live) => live.all("[data-press]").forEach((button) => {
  button.addEventListener("click", () => {
    const i = Number(button.closest("[data-i]").dataset.i), text = live.state[i][0] + button.dataset.press;
    animate(live, 600, (part) => live.setOne(i, [text, part]), () => live.state[i][0] === text);
  });
});

export const followButtons = (live) => live.all(".rk-move").forEach((button, k) => {
  const { sets, to } = live.figure.buttons[k];
  button.addEventListener("click", () => {
    sets.forEach((i) => stopClock(live, i));
    live.settled();
    const from = live.state, ends = to(functions, live.computed.c);
    let shown = from;
    const draw = (part) => {
      const moved = 3 * part ** 2 - 2 * part ** 3;
      shown = live.state.slice();
      sets.forEach((i, n) => {
        const control = live.figure.controls[i], end = clamp(control, ends[n] / control.factor);
        shown[i] = clamp(control, from[i] + moved * (end - from[i]));
      });
      live.set(shown);
    };
    animate(live, 900, draw, () => sets.every((i) => live.state[i] === shown[i]));
  });
});
