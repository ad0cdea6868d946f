// Pages of the site as they go on paper: what needs a hand or a script is gone. Runs in a browser,
// where the pages are only parsed.

const GONE = `.headerlink, .copybtn, .site-paper, .rk-desk, .rk-training, .rk-row,
  .rk-grid, .rk-verdict, .rk-read, .rk-ladder, .rk-help, .rk-guess, .rk-said, .rk-view, .rk-turning,
  .rk-buttons, .rk-passed, .rk-figure > .rk-says, .rk-numbers .rk-says, .katex-mathml,
  button, input, output, script, style`;
const NOBODY = "On the site each student gets numbers of their own, and answers are checked. Here "
  + "the numbers are those of somebody without a name.";
const SOLVED = "practice"; // the page whose exercises have their solutions
const HOME = "https://book/";

const all = (element, selector) => [...element.querySelectorAll(selector)];

const renamed = (element, name, also = "") => {
  const other = element.ownerDocument.createElement(name);
  other.className = `${element.className} ${also}`.trim();
  other.append(...element.childNodes);
  element.replaceWith(other);
};

// The last part of a page's address names it in the book: euler/euler.html is euler.
const nameOf = (address) => address.replace(/\.html$/, "").split("/").at(-1);

const read = ({ address, html }) => {
  const page = new DOMParser().parseFromString(html, "text/html");
  const styles = all(page, "link[rel=stylesheet]").map((link) => link.getAttribute("href"));
  return { address, styles, article: page.querySelector(".bd-article"), name: nameOf(address) };
};

// Where a file is that a page names, from the folder in which the book is printed.
const fileOf = (address, { address: from }) => `../html${new URL(address, HOME + from).pathname}`;

const withoutControls = (article) => {
  all(article, ".rk-noscript").forEach((said) => {
    said.textContent = NOBODY;
    said.className = "paper-note";
  });
  all(article, GONE).forEach((element) => element.remove());
  all(article, ":is(.rk-controls, .rk-readouts, .rk-panel):empty").forEach((box) => box.remove());
};

// The exercises of a chapter are on one more page, and there they have their solutions.
const withSolutions = ({ name, article }, solutions) => {
  if (!Object.keys(solutions).length) return;
  if (name !== SOLVED) {
    return all(article, ".paper-note").forEach((note) => note.insertAdjacentHTML("beforeend",
      ` The solutions are in the part <a href="/${SOLVED}.html">Practice</a>.`));
  }
  all(article, ".rk-exercise").forEach((box) => box.insertAdjacentHTML("beforeend",
    `<details><summary>Solution</summary><div class="rk-ladder">${solutions[box.id]}</div></details>`));
};

// What is folded lies open, or is left out. The fold of a cell says how to open it, and no more.
const withFolds = (article, open) => all(article, "details").forEach((fold) => {
  const summary = fold.querySelector("summary"), isCell = summary.querySelector(".collapsed");
  if (!open) return fold.remove();
  if (isCell) summary.remove(); else renamed(summary, "p", "paper-fold");
  renamed(fold, "div", isCell ? "" : "paper-opened");
});

// The place in the book to which an address leads, as an id; null if out of the book.
const placeOf = (address, from, pages) => {
  const url = new URL(address, HOME + from.address);
  const page = pages.find(({ name }) => name === nameOf(url.pathname));
  if (!url.href.startsWith(HOME) || !page) return null;
  const id = decodeURIComponent(url.hash.slice(1)).split("?")[0];
  return page.ids.has(id) ? `${page.name}.${id}` : page.name;
};

const withLinks = (page, pages) => all(page.article, "a").forEach((element) => {
  const address = element.getAttribute("href");
  if (!address || /^(https?|mailto):/.test(address)) return;
  const place = placeOf(address, page, pages);
  if (place) element.setAttribute("href", `#${place}`);
  else element.replaceWith(...element.childNodes);
});

// Ids are told apart by their page, in one document. Those in pictures name a drawing, which is the
// same on every page.
const withIds = ({ name, article }) => {
  all(article, "[id]:not(svg *)").forEach((element) => { element.id = `${name}.${element.id}`; });
  article.id = name;
};

const withPictures = (page) => all(page.article, "img").forEach((image) => {
  image.setAttribute("src", fileOf(image.getAttribute("src"), page));
});

// What the menu of the site holds: [{ caption, addresses }].
const contents = (html) => {
  const menu = new DOMParser().parseFromString(html, "text/html").querySelector(".bd-docs-nav");
  return all(menu, ".caption").map((caption) => ({
    caption: caption.textContent,
    addresses: all(caption.nextElementSibling, "a").map((a) => a.getAttribute("href")),
  }));
};

// given: [{ address, html }]; solutions: of exercises, by name; open: whether folds are.
const paper = (given, solutions, open) => {
  const pages = given.map(read);
  for (const page of pages) {
    withoutControls(page.article);
    withSolutions(page, solutions);
    withFolds(page.article, open);
    page.ids = new Set(all(page.article, "[id]").map(({ id }) => id));
  }
  return pages.map((page) => {
    const title = page.article.querySelector("h1").textContent.trim();
    withLinks(page, pages);
    withIds(page);
    withPictures(page);
    const styles = page.styles.map((address) => fileOf(address, page));
    return { name: page.name, title, styles, body: page.article.outerHTML };
  });
};
