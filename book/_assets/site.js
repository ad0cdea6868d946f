// What scrolls sideways, or has symbols to name, can be reached with the keyboard.
{
  const LABELS = { "math-scroll": "Equation", "pst-scrollable-table-container": "Table" };
  const BOXES = Object.keys(LABELS).map((name) => `.bd-article .${name}`).join(", ");

  const mark = (box) => {
    const told = [];
    if (box.scrollWidth > box.clientWidth) told.push("scrolls sideways");
    if (box.querySelector(".katex [data-symbol]")) told.push("the arrow keys name its symbols");
    if (told.length) {
      box.tabIndex = 0;
      box.setAttribute("role", "group");
      box.setAttribute("aria-label", [LABELS[box.className], ...told].join(", "));
    } else {
      ["tabindex", "role", "aria-label"].forEach((name) => box.removeAttribute(name));
    }
  };

  const observer = new ResizeObserver((entries) => entries.forEach(({ target }) => mark(target)));
  document.querySelectorAll(BOXES).forEach((box) => observer.observe(box));
  document.fonts?.ready.then(() => document.querySelectorAll(BOXES).forEach(mark));

  // Search results show no text from pages on disk: browsers do not let a script read them.
  if (location.protocol === "file:" && typeof DOCUMENTATION_OPTIONS !== "undefined") {
    DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
  }
}
