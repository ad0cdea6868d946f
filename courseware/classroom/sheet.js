// On a sheet with a student's own numbers: what is typed stays in the browser, and is saved as a file.

import { downloadAnswers, now } from "../practice/answer_file.js";
import { memory, readStored } from "../answers/storage.js";

const sheet = document.body.dataset, fields = [...document.querySelectorAll("input")];
const key = `${sheet.course} ${sheet.version} ${sheet.student}`;
const show = () => fields.forEach((field) => { field.value = readStored(key)[field.name]?.answer ?? ""; });
for (const field of fields) {
  field.addEventListener("input", () => {
    const entry = { answer: field.value, time: now() };
    memory.set(key, JSON.stringify({ ...readStored(key), [field.name]: entry })); // beside another tab's
  });
}
document.querySelector("button").addEventListener("click", () => {
  document.querySelector("output").textContent = downloadAnswers(sheet, sheet.student, readStored(key));
});
for (const elsewhere of ["storage", "pageshow"]) addEventListener(elsewhere, show);
show();
document.body.className = "live";
