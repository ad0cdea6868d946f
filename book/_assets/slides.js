// A chapter becomes slides: of each section its figures, predictions and formulas, with the words
// before them. Runs before the scripts of the page, which find all of it in its new place.

const LEFT_OUT = "#as-a-function, #your-own-figure, #write-it-yourself, #exercises, #find-the-mistake, #a-glance-further";
const BOXES = "section, .rk-opens, .rk-opens > div:not(.rk-key), .cell.tag_remove-input, .cell_output";
const KEYS = "The arrow keys go on and back, F fills the screen. While a figure or an answer has the keys, Esc gives them back.";
const LONG = 240, EXERCISE = 600; // characters

const article = document.querySelector("article"), deck = document.createElement("div");
let heading = null, first = null, words = null, slide = null;

// Leave the first sentences of a paragraph.
const shorten = (paragraph, most = LONG) => {
  let before = 0, end = null;
  for (const node of paragraph.childNodes) {
    if (node.nodeType !== Node.TEXT_NODE) before += 3;
    else for (const { index } of node.data.matchAll(/[.?!](?=\s|$)/g)) if (!end || before + index < most) end = [node, index + 1];
    before += node.data?.length ?? 0;
  }
  const rest = document.createRange();
  rest.selectNodeContents(paragraph);
  if (end && before > most) { rest.setStart(...end); rest.deleteContents(); }
  return paragraph;
};

const begin = (...parts) => {
  slide = document.createElement("section");
  slide.append(heading.cloneNode(true), ...parts);
  if (words) slide.firstChild.after(shorten(words, heading.parentElement.id === "the-exercise" ? EXERCISE : LONG));
  deck.append(slide);
  words = null;
};

const holds = (selector) => slide.querySelector(selector);
const add = (part) => {
  if (part.matches(LEFT_OUT)) return;
  if (part.matches(".rk-prediction")) {
    const { figure } = JSON.parse(part.dataset.prediction), fold = part.querySelector(".rk-opens");
    if (figure && holds(`#${figure}`)) slide.append(part); else begin(part);
    [...fold.children].forEach(add); // what follows the answer is on the next slides
    words = null;
  } else if (part.matches(BOXES)) [...part.children].forEach(add);
  else if (part.matches("h1, h2, h3")) {
    [heading, first, words] = [part, null, null];
    if (part.matches("h1")) begin(Object.assign(document.createElement("p"), { className: "keys", textContent: KEYS }));
  } else if (part.matches("p") && part.textContent.trim()) {
    if (part.textContent.startsWith("After this chapter")) deck.firstChild.lastChild.before(shorten(part));
    else if (!words || words !== first) { words = part; first ??= part; } // the first below a heading, else the last
  } else if (part.matches(".rk-figure, #recap > ul")) begin(part);
  else if (part.matches(".rk-numbers")) slide.append(part);
  else if (part.matches("div.math")) {
    if (holds("[data-size=laboratory], .rk-prediction, .rk-numbers, ul") || slide.querySelectorAll("div.math").length > (holds("figure") ? 0 : 2)) begin(part);
    else slide.append(part);
  }
};
[...article.children].forEach(add);
article.querySelectorAll(":scope > section").forEach((rest) => { rest.hidden = true; });
deck.querySelectorAll("section:not(:has(figure))").forEach((each) => each.classList.add("words"));
article.classList.add("reveal");
deck.className = "slides";
article.append(deck);

// Pictures are as high as the slide leaves room for, also when an answer comes; words alone as large.
const fit = (slide) => {
  for (let room = 30; room > 10; room -= 0.5) {
    slide.style.setProperty("--room", `${room}rem`);
    if (slide.scrollHeight <= slide.clientHeight) return;
  }
};
const sizes = new ResizeObserver((seen) => new Set(seen.map(({ target }) => target.parentElement)).forEach(fit));
deck.querySelectorAll("section > *").forEach((part) => sizes.observe(part));

const holder = () => document.activeElement?.closest(":is(input, select, summary, button, a, [tabindex='0'])");
addEventListener("keydown", ({ key }) => { if (key === "Escape") document.activeElement.blur(); }, true);
window.Reveal.initialize({ width: 1280, height: 720, margin: 0, center: false, display: "flex", transition: "none", hash: true,
  controlsLayout: "edges", slideNumber: "c/t", touch: false, overview: false,
  keyboardCondition: ({ key }) => !holder() || (holder().matches("button, a, summary") && key.startsWith("Arrow")) });
