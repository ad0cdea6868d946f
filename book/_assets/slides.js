// A chapter becomes slides: of each section its figures, predictions and formulas, with the words
// before them. Runs before the scripts of the page, which find all of it in its new place.

const LEFT_OUT = "#as-a-function, #your-own-figure, #write-it-yourself, #exercises, #find-the-mistake, #a-glance-further";
const BOXES = `section:not(${LEFT_OUT}), .rk-opens, .rk-opens > div:not(.rk-key), .cell.tag_remove-input, .cell_output`;
const STARTS = ".rk-figure, .rk-prediction, h1, h2, h3, hr";
const LONG = 240, EXERCISE = 600; // characters

const article = document.querySelector("article"), deck = document.createElement("div");
let heading = null, first = null, words = null, slide = null, rest = null;

// Leave the first sentences of a paragraph, or the last ones of one that leads to what follows.
const leads = (paragraph) => paragraph?.textContent.trim().endsWith(":");
const shorten = (paragraph, most = LONG) => {
  const cut = document.createRange(), ends = [];
  let length = 0;
  for (const node of paragraph.childNodes) {
    const text = node.nodeType === Node.TEXT_NODE ? node.data : "xyz"; // a formula
    for (const { index } of text.matchAll(/[.?!](?=\s|$)/g)) ends.push([node, index + 1, length + index]);
    length += text.length;
  }
  if (!ends.length || length <= most) return paragraph;
  cut.selectNodeContents(paragraph);
  if (leads(paragraph)) cut.setEnd(...(ends.find(([, , at]) => length - at < most) ?? ends.at(-1)).slice(0, 2));
  else cut.setStart(...(ends.findLast(([, , at]) => at < most) ?? ends[0]).slice(0, 2));
  cut.deleteContents();
  return paragraph;
};

const put = (part) => { if (part.matches(".rk-figure")) rest.before(part); else rest.append(part); };
const begin = (part) => {
  [slide, rest] = ["section", "div"].map((tag) => document.createElement(tag));
  slide.append(heading.cloneNode(true), ...(words ? [shorten(words, heading.parentElement.id === "the-exercise" ? EXERCISE : LONG)] : []), rest);
  deck.append(slide);
  words = null;
  put(part);
};

// The parts of a chapter in one row; a rule ends what follows an answer.
const collect = (part) => {
  if (part.matches(".rk-prediction")) return [part, ...[...part.querySelector(".rk-opens").children].flatMap(collect), document.createElement("hr")];
  return part.matches(BOXES) ? [...part.children].flatMap(collect) : [part];
};
[...article.children].flatMap(collect).forEach((part, k, parts) => {
  const holds = (selector) => slide.querySelector(`:scope > ${selector}, :scope > div > ${selector}`);
  if (part.matches("h1, h2, h3")) [heading, first, words] = [part, null, null];
  else if (part.matches(".rk-prediction")) (holds(`#${JSON.parse(part.dataset.prediction).figure || "none"}`) ? put : begin)(part);
  else if (part.matches("p") && part.textContent.trim()) {
    if (part.textContent.startsWith("After this chapter")) deck.firstChild.lastChild.append(shorten(part));
    else if (part.textContent.startsWith("A place to stop.")) begin(part);
    else if (!words || words !== first) { words = part; first ??= part; } // the first below a heading, else the last
  } else if (part.matches(".rk-figure, #recap > ul")) (holds("ul") ? put : begin)(part);
  else if (part.matches(".rk-numbers")) put(part);
  else if (part.matches("div.math")) { // a figure's slide has its formula; if it has several, they are on the next
    const more = parts.slice(k + 1, parts.findIndex((other, i) => i > k && other.matches(STARTS))).some((other) => other.matches("div.math"));
    if (holds("figure") ? more || holds("[data-size=laboratory]") || holds(".math") : holds(".rk-prediction") || rest.querySelectorAll(":scope > :is(.math, .rk-numbers)").length > 2) begin(part);
    else rest.append(...(words ? [shorten(words)] : []), part);
    words = null;
  } else if (part.matches("hr") || leads(words)) words = null; // it leads to what is on no slide
  if (part.matches("h1")) begin(document.createElement("p"));
});
article.classList.add("reveal");
article.append(Object.assign(deck, { className: "slides" }));

// A picture is as large as its slide leaves room for, also when an answer comes; words alone are as
// large. What is not above or below it is in a column, without a formula's numbers if it would be small.
const overflows = (slide) => slide.scrollHeight > slide.clientHeight || [...slide.querySelectorAll(".math-scroll")].some((box) => box.scrollWidth > box.clientWidth + 1);
const lay = (slide, layout, room) => { slide.dataset.layout = layout; slide.style.setProperty("--room", `${room}rem`); };
const fit = (slide) => {
  const picture = slide.querySelector(".rk-picture"), best = [0];
  if (slide.clientHeight) Object.entries({ column: 1, above: 0.95, bare: 0.75 }).forEach(([layout, weight]) => {
    let room = picture ? 40 : 30;
    lay(slide, layout, room);
    while (overflows(slide) && room > 10) lay(slide, layout, room -= 1);
    const size = weight * (picture?.offsetHeight ?? room);
    if (size > best[0] && !overflows(slide)) best.splice(0, 3, size, layout, room);
  });
  if (best[1]) lay(slide, ...best.slice(1));
};
const sizes = new ResizeObserver((seen) => new Set(seen.map(({ target }) => target.closest(".slides > section"))).forEach(fit));
deck.querySelectorAll("section > *, section > div > *, .rk-panel").forEach((part) => sizes.observe(part));

const holder = () => document.activeElement?.closest(":is(input, select, summary, button, a, [tabindex='0'])");
deck.addEventListener("click", ({ target }) => { if (target.closest(".rk-card button")) document.activeElement.blur(); });
addEventListener("keydown", ({ key }) => { if (/^(Escape|Page)/.test(key)) document.activeElement.blur(); }, true);
window.Reveal.initialize({ width: 1280, height: 720, margin: 0, center: false, display: "grid", transition: "none", hash: true,
  controlsLayout: "edges", slideNumber: "c/t", touch: false, overview: false, pause: false,
  keyboardCondition: ({ key }) => !holder() || (holder().matches("button, a, summary") && key.startsWith("Arrow")) });
