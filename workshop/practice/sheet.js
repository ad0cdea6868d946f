// On a sheet with a student's own numbers: what is typed stays in the browser, and is saved as a file.

const sheet = document.body.dataset, kept = `${sheet.course} ${sheet.version} ${sheet.student}`;
let entries = {};
try { entries = JSON.parse(localStorage.getItem(kept)) ?? {}; } catch { /* nothing kept */ }
for (const field of document.querySelectorAll("input")) {
  field.value = entries[field.name]?.answer ?? "";
  field.addEventListener("change", () => {
    entries[field.name] = { answer: field.value, time: now() };
    try { localStorage.setItem(kept, JSON.stringify(entries)); } catch { /* in this page only */ }
  });
}
document.querySelector("button").addEventListener("click",
  () => saveAnswers(sheet, sheet.student, entries));
