// Pages of the site as they go on paper: what needs a hand or a script is text, or gone. Runs in a
// browser, which reads HTML and writes XHTML better than anybody else; the pages are only parsed.

const GONE = `.headerlink, .copybtn, .site-paper, .rk-desk, .rk-training, .rk-row,
  .rk-grid, .rk-verdict, .rk-read, .rk-ladder, .rk-help, .rk-guess, .rk-said, .rk-view, .rk-turning,
  .rk-buttons, .rk-passed, .rk-figure > .rk-says, button, input, output, script, style`;
// what is in them is kept, in elements that are no control
const PLAIN = { form: "div", label: "div", article: "section" };
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
  all(page, ".site-later noscript").forEach((waiting) => waiting.replaceWith(...waiting.childNodes));
  const styles = all(page, "link[rel=stylesheet]").map((link) => link.getAttribute("href"));
  return { address, styles, article: page.querySelector(".bd-article"), name: nameOf(address) };
};

// Where a file of the site stands that a page names.
const fileOf = (address, { address: from }) => new URL(address, HOME + from).pathname.slice(1);

// frames: pictures side by side of figures that move by themselves, by name.
const withFrames = (article, frames) => all(article, ".rk-figure").forEach((figure) => {
  if (frames[figure.id]) figure.querySelector(".rk-picture").innerHTML = frames[figure.id];
});

const withoutControls = (article) => {
  all(article, ".rk-control select").forEach((select) => {
    const shown = select.ownerDocument.createElement("span");
    shown.className = "rk-value";
    shown.textContent = select.selectedOptions[0].textContent;
    select.replaceWith(shown);
  });
  all(article, ".rk-noscript").forEach((said) => {
    said.textContent = NOBODY;
    said.className = "paper-note";
  });
  all(article, GONE).forEach((element) => element.remove());
  Object.entries(PLAIN).forEach(([name, other]) =>
    all(article, name).forEach((element) => renamed(element, other)));
  all(article, ":is(.rk-controls, .rk-readouts, .rk-panel):empty").forEach((box) => box.remove());
};

// The exercises of a chapter stand on one more page, and there they have their solutions.
const withSolutions = ({ name, article }, solutions) => {
  if (!Object.keys(solutions).length) return;
  if (name !== SOLVED) {
    return all(article, ".paper-note").forEach((note) => note.insertAdjacentHTML("beforeend",
      ` The solutions stand in the part <a href="/${SOLVED}.html">Practice</a>.`));
  }
  all(article, ".rk-exercise").forEach((box) => box.insertAdjacentHTML("beforeend",
    `<details><summary>Solution</summary><div class="rk-ladder">${solutions[box.id]}</div></details>`));
};

// folds: "open", "gone", or "kept" where a reader can open them. The fold of a cell says how to open
// it, and no more.
const withFolds = (article, folds) => all(article, "details").forEach((fold) => {
  const summary = fold.querySelector("summary"), how = summary.querySelector(".collapsed");
  if (folds === "gone") return fold.remove();
  if (folds === "kept") return how?.parentElement.replaceChildren(how.textContent);
  if (how) summary.remove(); else renamed(summary, "p", "paper-fold");
  renamed(fold, "div", how ? "" : "paper-opened");
});

// Formulas as MathML; numbers under a formula are said in a line of text beside it.
const asMathml = (article) => {
  all(article, ".rk-numbers div.math").forEach((element) => element.remove());
  all(article, ".katex").forEach((element) => {
    const math = element.querySelector("math"), tex = math.querySelector("annotation");
    math.setAttribute("alttext", tex.textContent);
    math.replaceChildren(math.firstChild.firstChild);
    all(math, ":is(mi, mn, mo, mtext):has(*)").forEach((token) => { token.textContent = token.textContent; });
    (element.closest(".katex-display") ?? element).replaceWith(math);
  });
};

const asHtml = (article) =>
  all(article, ".katex-mathml, .rk-numbers .rk-says").forEach((element) => element.remove());

// Where an address leads in the book: a page's name and a place in it; null if out of it.
const placeOf = (address, from, pages) => {
  const url = new URL(address, HOME + from.address);
  const page = pages.find(({ name }) => name === nameOf(url.pathname));
  if (!url.href.startsWith(HOME) || !page) return null;
  const id = decodeURIComponent(url.hash.slice(1)).split("?")[0];
  return { page: page.name, id: page.ids.has(id) ? id : "" };
};

const withLinks = (page, pages, link) => all(page.article, "a").forEach((element) => {
  const address = element.getAttribute("href");
  if (!address || /^(https?|mailto):/.test(address)) return;
  const place = placeOf(address, page, pages);
  if (!place) return element.replaceWith(...element.childNodes);
  const id = place.id ? `${place.page}.${place.id}` : place.page;
  element.setAttribute("href", link.replace("PAGE", place.page).replace("ID", id));
});

// Ids are told apart by their page: the book may be one document. Those in pictures name a drawing,
// which is the same on every page.
const withIds = ({ name, article }) => {
  all(article, "[id]:not(svg *)").forEach((element) => { element.id = `${name}.${element.id}`; });
  const others = ["for", "aria-labelledby", "aria-describedby", "headers"];
  all(article, others.map((other) => `[${other}]`).join(", ")).forEach((element) =>
    others.forEach((other) => element.removeAttribute(other)));
  article.id = name;
};

const withPictures = (page, folder) => all(page.article, "img").forEach((image) => {
  image.setAttribute("src", folder + fileOf(image.getAttribute("src"), page));
});

const BARE = /^(data-(?!size)|aria-live)/;

const withoutData = (article) => all(article, "*").forEach((element) =>
  element.getAttributeNames().filter((name) => BARE.test(name))
    .forEach((name) => element.removeAttribute(name)));

// What the menu of the site holds: [{ caption, addresses }].
const contents = (html) => {
  const menu = new DOMParser().parseFromString(html, "text/html").querySelector(".bd-docs-nav");
  return all(menu, ".caption").map((caption) => ({
    caption: caption.textContent,
    addresses: all(caption.nextElementSibling, "a").map((a) => a.getAttribute("href")),
  }));
};

const titleOf = (heading) => {
  const copy = heading.cloneNode(true);
  all(copy, ".katex-html, annotation").forEach((element) => element.remove());
  return copy.textContent.replace(/\s+/g, " ").trim();
};

// given: [{ address, html }]; solutions: of exercises, by name. link: how a place is addressed, from
// PAGE and ID; folder: where the site's files stand.
const paper = (given, solutions, frames, { link, folder, mathml, folds }) => {
  const pages = given.map(read);
  for (const page of pages) {
    withFrames(page.article, frames);
    withoutControls(page.article);
    withSolutions(page, solutions);
    page.ids = new Set(all(page.article, "[id]").map(({ id }) => id));
    page.titles = all(page.article, "h1, h2").map((heading) => ({
      title: titleOf(heading), level: Number(heading.tagName[1]),
      id: `${page.name}.${heading.closest("section").id}`,
    }));
  }
  return pages.map((page) => {
    (mathml ? asMathml : asHtml)(page.article);
    withFolds(page.article, folds);
    withLinks(page, pages, link);
    withIds(page);
    withPictures(page, folder);
    withoutData(page.article);
    const body = new XMLSerializer().serializeToString(page.article);
    const styles = page.styles.map((address) => folder + fileOf(address, page));
    return { name: page.name, titles: page.titles, styles, body };
  });
};
