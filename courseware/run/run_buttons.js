// Run under each cell; what it does comes when it is first pressed.

import { VERSION } from "./constants.js";

export const addRunButtons = () => {
  const home = document.currentScript.src;
  // Changed code stays in the browser, and is offered again while its cell is the same.
  const key = `courseware-cells ${location.pathname}`;
  const read = () => { try { return JSON.parse(localStorage.getItem(key)) ?? {}; } catch { return {}; } };
  const keep = (k, change) => {
    try { localStorage.setItem(key, JSON.stringify({ ...read(), [k]: change })); } catch { /* full */ }
  };
  const kept = read();
  const bars = [...document.querySelectorAll(".cell:not(.tag_interact) > .cell_input")].map((input) => {
    const word = input.closest("[class*=tag_program-]") ? "Check" : "Run";
    input.insertAdjacentHTML("beforeend",
      `<div class="rk-run"><button type="button">${word}</button><p role="status"></p></div>`);
    return input.lastElementChild;
  });
  const withCells = async (k, work) => {
    try {
      await work(await import(new URL(`../run/cells.js?v=${VERSION}`, home)));
    } catch {
      bars[k].lastChild.textContent = "This runs where the page comes from a server, not from disk.";
    }
  };
  bars.forEach((bar, k) => {
    bar.firstChild.addEventListener("click", () => withCells(k, ({ pressRun }) => pressRun(bars, k, keep)));
    const code = bar.parentElement.querySelector("pre");
    if (bar.firstChild.textContent === "Check") {
      let at;
      bar.lastChild.textContent = "Write into the code above.";
      Object.assign(code, { tabIndex: 0, onmousedown: (event) => { at = event; } });
      code.addEventListener("focus", () => withCells(k, ({ write }) => write(bars, k, keep, at)), { once: true });
    }
    if (!kept[k]?.text || kept[k].first !== code.textContent) return;
    bar.lastChild.insertAdjacentHTML("beforebegin", `<button type="button">Bring back my change</button>`);
    bar.children[1].addEventListener("click", ({ target }) => {
      target.remove();
      withCells(k, ({ bringBack }) => bringBack(bars, k, keep, kept[k]));
    });
  });
};
