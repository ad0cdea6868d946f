// The file of answers that a student hands in, and the reader of tables.

import { GUARD, UNGUARD } from "./constants.js";

export const now = () => new Date().toISOString();

// As a spreadsheet may read it: quoted, and no cell that it would take for a formula.
const escapeCell = (text) => {
  const safe = text.replace(RegExp(GUARD, "g"), "$1$2'");
  return /[",;\n\r]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
};

// entries: exercise → { answer, time, tries, help }; what was not checked is among them.
export const serializeAnswers = ({ course, version }, student, entries) => [
  ["kind", "course", "version", "time", "student", "exercise", "answer", "tries", "help"],
  ...Object.entries(entries).filter(([, { answer }]) => answer)
    .map(([exercise, { answer, time = "", tries = "", help = "" }]) =>
      ["answers", course, version, time, student, exercise, answer, tries, help]),
].map((row) => row.map((cell) => escapeCell(String(cell))).join(",")).join("\r\n") + "\r\n";

// The one reader of tables, of the page and of `grade`: [line, cells] of each line that is not empty. The
// first one tells by what cells are separated. Spreadsheets leave out empty cells at the end.
export const readTable = (text) => {
  const plain = text.replaceAll("\ufeff", "").replace(/\r\n?/g, "\n"), first = plain.match(/.*\S.*/)?.[0] ?? "";
  const count = (sign) => first.split(sign).length;
  const separator = [",", ";", "\t"].reduce((one, other) => count(other) > count(one) ? other : one);
  const cell = RegExp(`(?:"((?:[^"]|"")*)"|([^${separator}\n]*))([${separator}\n]|$)`, "y"), rows = [];
  for (let line = 1; cell.lastIndex < plain.length;) {
    const start = cell.lastIndex, cells = [];
    let found;
    do {
      found = cell.exec(plain);
      cells.push((found[1]?.replaceAll('""', '"') ?? found[2]).replace(RegExp(UNGUARD, "g"), "$1$2").trim());
    } while (found[3] === separator);
    if (cells.some(Boolean)) rows.push([line, cells]);
    line += plain.slice(start, cell.lastIndex).split("\n").length - 1;
  }
  return rows;
};

export const parseAnswers = (text) => {
  const [[, heading] = [], ...rows] = readTable(text);
  return rows.map(([, cells]) => Object.fromEntries(heading.map((name, i) => [name.toLowerCase(), cells[i] ?? ""])))
    .filter(({ student, exercise, answer }) => student && exercise && answer);
};

export const downloadAnswers = (course, student, entries) => {
  const text = "\ufeff" + serializeAnswers(course, student, entries);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.download = `answers-${student.replace(/[^\p{L}\p{N}]+/gu, "-").slice(0, 40)}.csv`;
  link.click();
  return link.download;
};
