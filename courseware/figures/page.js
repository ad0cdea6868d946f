// On a web page: the script takes over the waiting pictures.

import { LiveFigure } from "./live_figure.js";

export const startFigure = (figure) => {
  const element = document.getElementById(figure.name), picture = element.querySelector(".rk-picture > svg"), before = picture.outerHTML;
  try {
    const live = new LiveFigure(element, figure).start();
    live.settled();
    element.courseware = live;
  } catch (error) {
    picture.outerHTML = before; // the still picture stays, without its controls
    element.querySelectorAll(".rk-panel > :not(.rk-card), .rk-clock, .rk-reset").forEach((part) => part.remove());
    element.classList.remove("rk-live");
    console.error(`The figure ${figure.name} cannot be moved:`, error);
  }
};

// A figure comes to life when it comes near, within a screen's height, or when the address names it.
export const startFigures = () => {
  const figures = window.coursewareFigures ?? [], still = new Map(figures.map((figure) => [figure.name, figure]));
  const near = new IntersectionObserver((seen) => seen.forEach(({ target, isIntersecting }) => {
    if (isIntersecting) wake(target.id);
  }), { rootMargin: "100% 0px" });
  const wake = (name) => {
    if (!still.has(name)) return;
    near.unobserve(document.getElementById(name));
    startFigure(still.get(name));
    still.delete(name);
  };
  const follow = () => wake(location.hash.slice(1));
  addEventListener("hashchange", follow);
  follow();
  still.forEach((_, name) => near.observe(document.getElementById(name)));
};
