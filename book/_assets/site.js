// A page that a browser has saved holds what its scripts had made: they make it anew.
document.querySelectorAll(".rk-handles, .rk-run, .rk-bar, .rk-named, .copybtn, .site-results, .site-close")
  .forEach((made) => made.remove());

// What scrolls sideways, or has symbols to name, can be reached with the keyboard.
{
  const LABELS = { "math-scroll": "Equation", "pst-scrollable-table-container": "Table" };
  const BOXES = Object.keys(LABELS).map((name) => `.bd-article .${name}`).join(", ");

  // All are measured before one is changed: else the page is laid out anew for each.
  const markScrollable = (boxes) => boxes.map((box) => [box, box.scrollWidth > box.clientWidth]).forEach(([box, wide]) => {
    const labels = [];
    if (wide) labels.push("scrolls sideways");
    if (box.querySelector(".katex [data-symbol]")) labels.push("the arrow keys name its symbols");
    if (labels.length) {
      box.tabIndex = 0;
      box.setAttribute("role", "group");
      box.setAttribute("aria-label", [LABELS[box.className], ...labels].join(", "));
    } else {
      ["tabindex", "role", "aria-label"].forEach((name) => box.removeAttribute(name));
    }
  });

  // A box is measured when it is drawn: what lies far from the window is laid out when it comes near.
  const boxes = [...document.querySelectorAll(BOXES)];
  const observer = new ResizeObserver((entries) => markScrollable(entries.map(({ target }) => target)));
  const observeBoxes = () => boxes.forEach((box) => {
    observer.unobserve(box);
    observer.observe(box);
  });
  observeBoxes();
  document.fonts.addEventListener("loadingdone", observeBoxes);
  document.addEventListener("contentvisibilityautostatechange", ({ target, skipped }) => {
    if (!skipped && target.matches(BOXES)) markScrollable([target]);
  }, true);

  // What waits for an answer is not drawn, but printed: its fonts are asked for by name.
  const loadFonts = (box) => box.querySelectorAll(".katex-html span").forEach((each) => {
    const { fontStyle, fontWeight, fontFamily } = getComputedStyle(each);
    document.fonts.load(`${fontStyle} ${fontWeight} 1em ${fontFamily}`, each.textContent);
  });

  // From a reader's first move on, formulas far away are drawn one by one: so their heights are known,
  // and their fonts come, for which a printer does not wait.
  const waiting = [...boxes], later = globalThis.requestIdleCallback ?? setTimeout; // which Safari lacks
  const drawFar = () => {
    const box = waiting.shift();
    if (!box) return;
    box.style.contentVisibility = "visible";
    if (!box.getClientRects().length) loadFonts(box);
    markScrollable([box]);
    later(drawFar);
  };
  for (const move of ["scroll", "pointermove", "keydown"]) addEventListener(move, () => later(drawFar), { once: true });
}

// The theme takes the focus off its buttons, so that their tooltips go: not from a reader with keys.
for (const button of document.querySelectorAll(".theme-switch-button, .search-button, .sidebar-toggle")) {
  button.blur = () => { if (!button.matches(":focus-visible")) HTMLElement.prototype.blur.call(button); };
}
document.getElementById("pst-search-dialog")?.addEventListener("close", () => {
  if (document.activeElement !== document.body) return; // back where the keys had opened it
  [...document.querySelectorAll(".search-button__button")].find((each) => each.getClientRects().length)?.focus();
});

// The menus of a phone: a button closes them, so does a choice in them, and focus goes back.
for (const which of ["primary", "secondary"]) {
  const dialog = document.getElementById(`pst-${which}-sidebar-modal`);
  if (!dialog) continue;
  const close = document.createElement("button");
  Object.assign(close, { type: "button", className: "btn site-close", title: "Close",
    ariaLabel: "Close the menu", innerHTML: '<i class="fa-solid fa-xmark"></i>' });
  close.addEventListener("click", () => dialog.close());
  // the theme moves the menu in when it opens, and out again
  new MutationObserver(() => { if (dialog.open && !close.isConnected) dialog.prepend(close); })
    .observe(dialog, { attributeFilter: ["open"] });
  dialog.addEventListener("click", ({ target }) => {
    if (target.closest("a[href*='#']")) dialog.close();
  });
  dialog.addEventListener("close", () => {
    close.remove();
    document.querySelector(`.${which}-toggle`)?.focus();
  });
}

// On paper: light, and what is folded lies open, unless the reader wants it shut.
{
  const root = document.documentElement;
  let before = null;
  const openFolds = () => {
    if (before) return;
    const shut = root.dataset.folds === "shut" ? [] : document.querySelectorAll("details:not([open])");
    before = { theme: root.dataset.theme, opened: [...shut] };
    before.opened.forEach((fold) => { fold.open = true; });
    root.dataset.theme = "light";
  };
  const closeFolds = () => {
    before?.opened.forEach((fold) => { fold.open = false; });
    root.dataset.theme = before?.theme ?? root.dataset.theme;
    before = null;
    delete root.dataset.folds;
  };
  addEventListener("beforeprint", openFolds);
  addEventListener("afterprint", closeFolds);
  document.querySelectorAll("[data-print]").forEach((button) => {
    button.addEventListener("click", () => {
      root.dataset.folds = button.dataset.print;
      print();
    });
  });
}

// From disk: JupyterLite needs a server and is not there.
if (location.protocol === "file:") {
  const menu = document.querySelector(".dropdown-run-buttons");
  menu?.querySelectorAll("a[href^='../lite/']").forEach((link) => link.parentElement.remove());
  if (menu && !menu.querySelector("a")) menu.remove();
}
