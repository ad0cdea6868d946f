// Run under each cell; what it does comes when it is first pressed.

import { memory, readStored } from "../answers/storage.js";
import { VERSION } from "./constants.js";

export const addRunButtons = () => {
  const home = document.currentScript.src;
  // Changed code stays in the browser, and is offered again while its cell is the same.
  const key = `courseware-cells ${location.pathname}`;
  const keep = (k, change) => memory.set(key, JSON.stringify({ ...readStored(key), [k]: change }));
  const kept = readStored(key);
  const bars = [...document.querySelectorAll(".cell:not(.tag_interact) > .cell_input")].map((input) => {
    const word = input.closest("[class*=tag_program-]") ? "Check" : "Run";
    input.insertAdjacentHTML("beforeend",
      `<div class="rk-run"><button type="button">${word}</button><p role="status"></p></div>`);
    return input.lastElementChild;
  });
  const withCell = async (k, work) => {
    try {
      const { openCell } = await import(new URL(`../run/cells.js?v=${VERSION}`, home));
      await work(await openCell(bars, k, keep));
    } catch {
      bars[k].lastChild.textContent = "This runs where the page comes from a server, not from disk.";
    }
  };
  bars.forEach((bar, k) => {
    bar.firstChild.addEventListener("click", () => withCell(k, (cell) => cell.press()));
    const code = bar.parentElement.querySelector("pre");
    if (bar.firstChild.textContent === "Check") {
      let at;
      bar.lastChild.textContent = "Write into the code above.";
      Object.assign(code, { tabIndex: 0, onmousedown: (event) => { at = event; } });
      code.addEventListener("focus", () => withCell(k, async (cell) => (await cell.edit()).focus(at)), { once: true });
    }
    if (!kept[k]?.text || kept[k].first !== code.textContent) return;
    bar.lastChild.insertAdjacentHTML("beforebegin", `<button type="button">Bring back my change</button>`);
    bar.children[1].addEventListener("click", ({ target }) => {
      target.remove();
      withCell(k, (cell) => cell.bringBack(kept[k]));
    });
  });
};
