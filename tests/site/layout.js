// What can go wrong with a page's layout: an expression for `page.evaluate`. Gives a list of
// findings by check; opens all folds, and brings all figures to life.
// `unfold` and `comeAlive` come from tests/browser.py.
// screens: whether each screen must have something to see or do; heights: the most of a figure in
// px, by its size or name; sizes: the size of each figure, by its name
async ({ phone, screens, heights, sizes }) => {
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const seen = (selector) => all(selector).filter((each) => each.checkVisibility());
  const start = (element) => element.textContent.trim().slice(0, 60);
  const box = (element) => element.getBoundingClientRect();

  // --- as the page comes ---

  const tooWide = () => {
    const { scrollWidth, clientWidth } = document.documentElement;
    return scrollWidth > clientWidth ? [`${scrollWidth - clientWidth} px`] : [];
  };

  const severalSearches = () => {
    const count = seen("input[type=search], .search-button__button")
      .filter((each) => !each.closest(".bd-search-container")).length; // a page's own
    return count > 1 ? [`${count} searches`] : [];
  };

  // The rule for pictures among the outputs must not squeeze the drawn parts of a formula.
  const squeezedRoots = () => seen(".katex .sqrt svg")
    .filter((sign) => box(sign).height <= 10 * parseFloat(sign.getAttribute("height")))
    .map((sign) => start(sign.closest(".katex")));

  const onlyText = () => {
    const kinds = ".rk-figure, .rk-prediction, [data-slot], .math, .rk-exercise, .rk-mistake, svg";
    const boxes = all(`.bd-article :is(${kinds})`).map(box).filter(({ height }) => height > 0)
      .map(({ top, bottom }) => [top + scrollY, bottom + scrollY]);
    const end = box(document.querySelector(".bd-article")).bottom + scrollY, empty = [];
    for (let top = 0; top < end - 300; top += 900) {
      const from = Math.min(top, end - 900); // the last screen is a whole one
      if (!boxes.some(([a, b]) => a < from + 900 && b > from)) empty.push(`from ${from} px`);
    }
    return empty;
  };

  // --- all folds open ---

  // Scrolling cannot bring back what lies left of its box at rest. One pixel for rounding.
  const lostToTheLeft = () => seen(".math-scroll").filter((math) => {
    math.scrollLeft = 0;
    const pieces = all(".katex-html > *", math);
    return Math.min(...pieces.map((piece) => box(piece).left)) < box(math).left - 1;
  }).map(start);

  const tornFormulas = () => all("span.math.kept")
    .filter((each) => each.offsetWidth && getComputedStyle(each).whiteSpace !== "nowrap").map(start);

  const tornPunctuation = () => seen(".kept")
    .filter((kept) => box(kept).height > 2.2 * parseFloat(getComputedStyle(kept).lineHeight)
      || box(kept).right > innerWidth).map(start);

  const cutCode = () => seen(".bd-article pre")
    .filter((pre) => pre.closest(".rk-mistake") || !pre.closest(".output"))
    .filter((pre) => pre.scrollWidth > pre.clientWidth + 1).map(start);

  // What scrolls sideways fades out at its end.
  const hiddenScrolling = () => seen(".bd-article *")
    .filter((e) => e.scrollWidth > e.clientWidth + 1)
    .filter((e) => !["visible", "hidden", "clip"].includes(getComputedStyle(e).overflowX))
    .filter((e) => !getComputedStyle(e).backgroundImage.includes("gradient")).map(start);

  // --- all figures alive ---

  const tornNumbers = (figure) => all("dd", figure).filter((told) => {
    const text = new Range();
    text.selectNodeContents(told);
    const lines = new Set([...text.getClientRects()].map(({ top }) => Math.round(top)));
    return /^\S+ \S+$/.test(told.textContent) && lines.size > 1;
  });

  const figureFaults = (figure) => {
    const { left, right, height } = box(figure), svg = figure.querySelector(".rk-picture svg");
    const scale = box(svg).width / svg.viewBox.baseVal.width, texts = all("text", svg);
    const letters = all("text, tspan", svg).map((t) => scale * parseFloat(getComputedStyle(t).fontSize));
    const faults = tornNumbers(figure).map((told) => `${told.textContent} is torn`);
    const card = figure.querySelector(".rk-card"), own = height - (card ? box(card).height : 0); // a question leaves
    const most = heights[figure.id] ?? heights[sizes[figure.id]];
    if (own > most) faults.push(`${own} px high, at most ${most}: flatten its view, or tell less`);
    if (left < 0 || right > innerWidth) faults.push("beside the page");
    if (!texts.length) faults.push("no text");
    if (Math.min(...letters) < 11 - 0.05) faults.push(`letters of ${Math.min(...letters)} px`); // rounded
    return faults.map((fault) => `${figure.id}: ${fault}`);
  };

  const found = { tooWide, severalSearches, squeezedRoots, ...(screens ? { onlyText } : {}) };
  for (const [name, check] of Object.entries(found)) found[name] = check();
  unfold(document.body);
  const opened = { lostToTheLeft, tornFormulas, ...(phone ? { tornPunctuation, cutCode, hiddenScrolling } : {}) };
  for (const [name, check] of Object.entries(opened)) found[name] = check();
  found.figures = [];
  for (const figure of all(".rk-figure")) {
    await comeAlive(figure);
    found.figures.push(...figureFaults(figure));
  }
  return Object.fromEntries(Object.entries(found).filter(([, findings]) => findings.length));
}
