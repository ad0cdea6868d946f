// On a web page: the address carries a setting, the script takes over the waiting picture.

import { nameButton } from "./clock.js";
import { LiveFigure } from "./live_figure.js";
import { renderFrames } from "./scene.js";
import { fromValue, toText } from "./state.js";

const addressOf = (figure, state) => `#${figure.name}?` + figure.controls.map((control, i) =>
  `${control.key}=${encodeURIComponent("factor" in control ? Number(state[i].toFixed(6))
    : toText(control, state[i]))}`).join("&");

const readAddress = (figure, address) => {
  const [name, query] = address.replace(/^#/, "").split("?");
  if (name !== figure.name || !query) return null;
  const given = new URLSearchParams(query);
  return figure.controls.map((control) => {
    const text = given.get(control.key), isNumber = text && "factor" in control;
    return fromValue(control, isNumber ? Number(text) : text);
  });
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
  const element = document.getElementById(figure.name), before = element.innerHTML;
  try {
    const live = new LiveFigure(element, figure).start();
    followLink(live);
    followAddress(live);
    live.settled();
    element.courseware = live;
  } catch (error) {
    element.innerHTML = before; // the still picture stays, without its controls
    element.querySelector(".rk-panel")?.remove();
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
