// Animations: the clock, and quarter turns.

import { clamp, snap } from "./state.js";

const prefersReducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

// Screen readers say which figure the button belongs to.
export const nameButton = (button, words, { title }) => {
  button.textContent = words;
  button.ariaLabel = `${words}: ${title}`;
};

export const pauseClock = (live) => {
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

// A clock that loops runs twice while its picture is in sight and under no veil, unless a hand stops it.
export const followSight = (live) => {
  const i = live.figure.controls.findIndex(({ loops }) => loops);
  if (i < 0 || prefersReducedMotion()) return;
  let seen = false;
  live.resumeClock = () => {
    const runs = seen && !live.element.matches(".rk-veiled");
    if (runs && !live.tick) playClock(live, i, live.state[i]);
    if (!runs) pauseClock(live);
  };
  new IntersectionObserver(([{ isIntersecting }]) => {
    seen = isIntersecting;
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

const TURN_TIME = 600; // ms

export const followTurns = (live) => live.all("[data-press]").forEach((button) => {
  button.addEventListener("click", () => {
    const i = Number(button.closest("[data-i]").dataset.i), began = performance.now();
    const text = live.state[i][0] + button.dataset.press;
    cancelAnimationFrame(live.turning);
    if (prefersReducedMotion()) return live.setOne(i, [text, 1]);
    const tick = (now) => {
      if (live.state[i][0] !== text) return; // set anew meanwhile
      const part = Math.min(1, Math.max(0, now - began) / TURN_TIME);
      live.setOne(i, [text, part]);
      if (part < 1) live.turning = requestAnimationFrame(tick);
    };
    live.setOne(i, [text, 0]);
    live.turning = requestAnimationFrame(tick);
  });
});
