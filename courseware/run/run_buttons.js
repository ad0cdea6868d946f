// Run under each cell; what it does comes when it is first pressed.

import { VERSION } from "./constants.js";

export const addRunButtons = () => {
  const home = document.currentScript.src;
  const bars = [...document.querySelectorAll(".cell:not(.tag_interact) > .cell_input")].map((input) => {
    input.insertAdjacentHTML("beforeend",
      `<div class="rk-run"><button type="button">Run</button><p role="status"></p></div>`);
    return input.lastElementChild;
  });
  const press = async (k) => {
    try {
      await (await import(new URL(`../run/cells.js?v=${VERSION}`, home))).pressRun(bars, k);
    } catch {
      bars[k].lastChild.textContent = "This runs where the page comes from a server, not from disk.";
    }
  };
  bars.forEach((bar, k) => bar.firstChild.addEventListener("click", () => press(k)));
};
