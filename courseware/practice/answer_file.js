// The file of answers that a student hands in, and the reader of tables.

import { GUARD, OTHER_COLUMNS, UNGUARD } from "./constants.js";

const NO_FILE = " If no file comes, the frame that shows this page forbids it: open the page in a tab of its own.";
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

const UNDECODED = /[\udc80-\udcff\ufffd]/u; // what no UTF-8 was: by Python, by a browser

// Lines of a table that are not empty, with their numbers: [line, cells], or [line, null] if a
// quotation mark is not closed. The first one may say by what cells are separated.
const splitTable = (text) => {
  const plain = text.replaceAll("\ufeff", "").replace(/\r\n?/g, "\n"), first = plain.match(/.*\S.*/)?.[0] ?? "";
  const count = (sign) => first.split(sign).length, named = first.match(/^"?sep=([,;|\t])/i)?.[1];
  const separator = named ?? [",", ";", "\t"].reduce((one, other) => count(other) > count(one) ? other : one);
  const cell = RegExp(`(?:"((?:[^"]|"")*)"|((?!")[^${separator}\n]*))([${separator}\n]|$)`, "y"), lines = [];
  for (let at = named ? plain.indexOf(first) + first.length : 0, line = 1, seen = 0; at < plain.length;) {
    line += plain.slice(seen, seen = at).split("\n").length - 1;
    let found, cells = [];
    do {
      cell.lastIndex = at;
      found = cell.exec(plain);
      at = found ? cell.lastIndex : plain.indexOf("\n", at) + 1 || plain.length;
      cells = found && [...cells, found[1]?.replaceAll('""', '"') ?? found[2]];
    } while (found?.[3] === separator);
    if (!cells || cells.some((each) => each.trim())) lines.push([line, cells]);
  }
  return lines;
};

// The one reader of tables, of the page and of `grade`: [line, kind, cells] each. Where tables were
// joined, a heading may occur anywhere; spreadsheets leave out empty cells at the end.
export const readTable = (text) => {
  let heading = [];
  return splitTable(text).map(([line, cells]) => {
    if (!cells) return [line, "unclosed", []];
    const names = cells.map((cell) => cell.trim().toLowerCase());
    if (!heading.length || ["student", "exercise"].every((name) => names.includes(name))) {
      return [line, "heading", heading = names];
    }
    if (cells.some((cell) => UNDECODED.test(cell))) return [line, "encoding", cells];
    if (cells.length > heading.length) return [line, "long", cells];
    return [line, "row", heading.map((_, i) => (cells[i] ?? "")
      .replace(RegExp(UNGUARD, "g"), "$1$2").replace(/^[ \t\r\n]+|[ \t\r\n]+$/g, ""))];
  });
};

// The bytes of a file as text: UTF-8, or UTF-16 with its mark.
export const decodeTable = (bytes) =>
  new TextDecoder({ 0xff: "utf-16le", 0xfe: "utf-16be" }[bytes[0]]).decode(bytes);

export const parseAnswers = (text) => {
  let heading;
  const rows = readTable(text).flatMap(([, kind, cells]) => {
    if (kind === "heading") heading = cells;
    return kind === "row" ? [Object.fromEntries(heading.map((name, i) => [name, cells[i]]))] : [];
  });
  return rows.filter((row) => row.student && row.exercise && row.answer && !OTHER_COLUMNS.some((name) => name in row));
};

// Save the answers as a file, and return what was done, in words.
export const downloadAnswers = (course, student, entries) => {
  const count = Object.values(entries).filter(({ answer }) => answer).length;
  if (!count) return "There are no answers under this name yet: nothing was saved.";
  const text = "\ufeff" + serializeAnswers(course, student, entries);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.download = `answers-${student.replace(/[^\p{L}\p{N}]+/gu, "-").slice(0, 40)}.csv`;
  link.click();
  return `Saved ${count} answer${count > 1 ? "s" : ""} as ${link.download}.${self === top ? "" : NO_FILE}`;
};
