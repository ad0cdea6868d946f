// The file of answers that a student hands in: `grade` reads it.

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

export const parseAnswers = (text) => {
  const rows = [[]];
  const cells = text.replace(/^\ufeff/, "").matchAll(/(?:"((?:[^"]|"")*)"|([^,\r\n]*))(,|\r?\n|$)/g);
  for (const [, quoted, plain, end] of cells) {
    rows.at(-1).push((quoted?.replaceAll('""', '"') ?? plain).replace(RegExp(UNGUARD, "g"), "$1$2"));
    if (end !== ",") rows.push([]);
  }
  const [heading, ...lines] = rows;
  return lines.filter((line) => line.length === heading.length)
    .map((line) => Object.fromEntries(heading.map((name, i) => [name, line[i]])))
    .filter(({ kind, answer }) => kind === "answers" && answer);
};

export const downloadAnswers = (course, student, entries) => {
  const text = "\ufeff" + serializeAnswers(course, student, entries);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.download = `answers-${student.replace(/[^\p{L}\p{N}]+/gu, "-").slice(0, 40)}.csv`;
  link.click();
  return link.download;
};
