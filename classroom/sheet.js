// On a sheet with a student's own numbers: what is typed stays in the browser, and is saved as a file.

const sheet = document.body.dataset, key = `${sheet.course} ${sheet.version} ${sheet.student}`;
const entries = parsed(key);
for (const field of document.querySelectorAll("input")) {
  field.value = entries[field.name]?.answer ?? "";
  field.addEventListener("input", () => {
    entries[field.name] = { answer: field.value, time: now() };
    memory.set(key, JSON.stringify(entries));
  });
}
document.querySelector("button").addEventListener("click",
  () => saveAnswers(sheet, sheet.student, entries));
