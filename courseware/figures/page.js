// On a web page: the address carries a setting, the script takes over the waiting picture.

import { nameButton } from "./clock.js";
import { LiveFigure } from "./live_figure.js";
import { parsePresses } from "./quarter_turns.js";
import { renderFrames } from "./scene.js";
import { clamp } from "./state.js";

// A choice is the name of its option, and turns are their presses.
const toText = (control, shown) => control.type === "choice" ? control.options[shown].label
  : control.type === "turns" ? shown[0] : Number(shown.toFixed(6));

const fromText = (control, text) => {
  if (control.type === "turns") return [parsePresses(text ?? "").join(""), 1];
  if (control.type === "choice") {
    const place = control.options.findIndex(({ label }) => label === text);
    return place < 0 ? control.start : place;
  }
  const number = text ? Number(text) : NaN;
  return Number.isFinite(number) ? clamp(control, number) : control.start;
};

const addressOf = (figure, state) => `#${figure.name}?` + figure.controls.map((control, i) =>
  `${control.key}=${encodeURIComponent(toText(control, state[i]))}`).join("&");

const readAddress = (figure, address) => {
  const [name, query] = address.replace(/^#/, "").split("?");
  if (name !== figure.name || !query) return null;
  const given = new URLSearchParams(query);
  return figure.controls.map((control) => fromText(control, given.get(control.key)));
};

const followLink = (live) => {
  const button = live.element.querySelector(".rk-link");
  button?.addEventListener("click", () => {
    history.replaceState(null, "", addressOf(live.figure, live.state));
    nameButton(button, "The link is in the address bar", live.figure);
    navigator.clipboard?.writeText(location.href).then(
      () => nameButton(button, "Link copied", live.figure), () => {});
    setTimeout(() => nameButton(button, "Link to this setting", live.figure), 2500);
  });
};

const followAddress = (live) => {
  const follow = () => {
    const state = readAddress(live.figure, location.hash);
    if (!state) return;
    live.set(state);
    live.element.scrollIntoView();
  };
  live.element.querySelector(".rk-reset")?.addEventListener("click", () => {
    if (readAddress(live.figure, location.hash)) history.replaceState(null, "", `#${live.figure.name}`);
  });
  addEventListener("hashchange", follow);
  follow();
};

export const startFigure = (figure) => {
  const element = document.getElementById(figure.name), picture = element.querySelector(".rk-picture > svg"), before = picture.outerHTML;
  try {
    const live = new LiveFigure(element, figure).start();
    followLink(live);
    followAddress(live);
    live.settled();
    element.courseware = live;
  } catch (error) {
    picture.outerHTML = before; // the still picture stays, without its controls
    element.querySelectorAll(".rk-panel > :not(.rk-card), .rk-clock, .rk-reset").forEach((part) => part.remove());
    element.classList.remove("rk-live");
    console.error(`The figure ${figure.name} cannot be moved:`, error);
  }
};

const followPaper = (figures) => {
  addEventListener("beforeprint", () => figures.forEach((figure) => {
    const element = document.getElementById(figure.name);
    if (element.matches(".rk-veiled, :has(.rk-frames)")) return;
    element.querySelector(".rk-picture").insertAdjacentHTML("beforeend", renderFrames(figure));
  }));
  addEventListener("afterprint", () => document.querySelectorAll(".rk-frames").forEach((frames) => frames.remove()));
};

// A figure comes to life when it comes near, within a screen's height, or when the address names it.
export const startFigures = () => {
  const figures = window.coursewareFigures ?? [], still = new Map(figures.map((figure) => [figure.name, figure]));
  followPaper(figures);
  const near = new IntersectionObserver((seen) => seen.forEach(({ target, isIntersecting }) => {
    if (isIntersecting) wake(target.id);
  }), { rootMargin: "100% 0px" });
  const wake = (name) => {
    if (!still.has(name)) return;
    near.unobserve(document.getElementById(name));
    startFigure(still.get(name));
    still.delete(name);
  };
  const follow = () => wake(location.hash.slice(1).split("?")[0]);
  addEventListener("hashchange", follow);
  follow();
  still.forEach((_, name) => near.observe(document.getElementById(name)));
};
