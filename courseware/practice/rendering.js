// Exercises and solutions as HTML.

import { escapeHtml, fillTemplate, renderSymbols } from "../units/text.js";
import { UNBROKEN } from "../units/constants.js";

const TRAINING = "Numbers for training: they are not yours and do not count.";
export const HELP_STEPS = ["Where should I look?", "Show the first step", "Show the next step", "Show the answer"];

// Lists in a list as a matrix. In a cell letters and indices share one span: in mathematics each
// would have a line of its own.
const MATRIX = /\[(\[[^[\]]*\](?:, \[[^[\]]*\])*)\]/g;
const renderCells = (row) => row.split(/, (?![^(]*\))/)
  .map((cell) => `<mtd><mtext><span>${cell}</span></mtext></mtd>`).join("");
const renderMatrices = (text) => text.replace(MATRIX, (_, rows) => `<math><mtable>${
  rows.slice(1, -1).split("], [").map((row) => `<mtr>${renderCells(row)}</mtr>`).join("")
}</mtable></math>`);

const joinUnbroken = (text) => text.replace(new RegExp(UNBROKEN, "g"), "\u00a0");

export const renderParagraphs = (text) => renderMatrices(renderSymbols(joinUnbroken(text))).split("\n\n")
  .map((paragraph) => `<p>${paragraph}</p>`).join("");

const FORMULA_LINE = /^(\[[^=]*\]|\S+) = /;

// The chapter, and what its formulas give; each leads to the formula, where the chapter prints it.
// here: the exercise is in its own chapter. Without formulas, the idea of the solution's first step.
export const renderHint = ({ chapter, formulas }, link, here, step = "") => {
  const [idea] = step.split("\n\n")[0].split(". ");
  if (!formulas.length && idea) return `${renderSymbols(idea.replace(/\.$/, ""))} …`;
  const found = formulas.map(([gives, place]) => place ? link(place, renderSymbols(gives)) : renderSymbols(gives));
  return `Look ${here ? "above" : `in the chapter “${renderSymbols(chapter)}”`}`
    + `${found.length ? ` for the formulas of ${found.join("; ")}` : ""}.`;
};

// A solution in steps: each is a text and the formulas that follow it.
export const splitSolution = (text) => text ? text.split("\n\n").reduce((steps, part) => {
    const last = steps.at(-1)?.split("\n\n").at(-1);
    if (last === undefined || (FORMULA_LINE.test(last) && !FORMULA_LINE.test(part))) return [...steps, part];
    return [...steps.slice(0, -1), `${steps.at(-1)}\n\n${part}`];
  }, []) : [];

const renderEntries = ({ shape: [rows, columns] = [] }) => columns ? `<details class="rk-grid">`
  + `<summary>Type it entry by entry</summary><table>${Array.from({ length: rows }, (_, i) =>
    `<tr>${Array.from({ length: columns }, (_, j) => `<td><input type="text" autocomplete="off" `
      + `spellcheck="false" aria-label="row ${i + 1}, column ${j + 1}"></td>`).join("")}</tr>`).join("")
  }</table></details>` : "";

// id: the start of the ids inside, for the box's own parts to find each other.
export const renderExercise = (exercise, shown, solution, id = exercise.name) =>
  `<div class="rk-question" id="${id}-question">`
    + `<p class="rk-exercise-title"><strong>${escapeHtml(exercise.title)}</strong>`
    + ` <span class="rk-steps">${exercise.steps} step${exercise.steps > 1 ? "s" : ""} · ${exercise.name}</span>`
    + ` <span class="rk-passed" hidden>passed</span></p>`
    + `<div class="rk-text">${renderParagraphs(fillTemplate(exercise.text, shown))}</div></div>`
    + `<p class="rk-training" hidden>${TRAINING} <button type="button">Back to my numbers</button></p>`
    + `<form class="rk-form"><label for="${id}-answer">Answer, <span class="rk-asked">`
    + `${renderSymbols(joinUnbroken(exercise.prompt))}</span></label>`
    + `<div class="rk-row"><input id="${id}-answer" type="text" autocomplete="off" autocapitalize="off" `
    + `spellcheck="false" aria-describedby="${id}-question ${id}-verdict">`
    + `<button type="submit">Check</button>`
    + `<button type="button" class="rk-another">Another one</button>`
    + `<button type="button" class="rk-help">${HELP_STEPS[0]}</button></div>${renderEntries(exercise)}</form>`
    + `<p class="rk-verdict" id="${id}-verdict" role="status"></p><p class="rk-read"></p>`
    + `<div class="rk-ladder" aria-live="polite"></div>`;
