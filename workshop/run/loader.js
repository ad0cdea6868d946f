// Run under each cell with code; what it does comes when it is first pressed.

const onPage = () => {
  const home = document.currentScript.src;
  const bars = [...document.querySelectorAll(".cell_input")].map((input) => {
    input.insertAdjacentHTML("beforeend",
      `<div class="rk-run"><button type="button">Run</button><p role="status"></p></div>`);
    return input.lastElementChild;
  });
  bars.forEach((bar, k) => bar.firstChild.addEventListener("click", () =>
    import(new URL(`../run/cells.js?v=${VERSION}`, home)).then(({ press }) => press(bars, k), () => {
      bar.lastChild.textContent = "This runs only where the page comes from a server, not from disk.";
    })));
};

Object.assign(part, { onPage });
