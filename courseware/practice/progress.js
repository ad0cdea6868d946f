// In the menu and on the first page: how many exercises of each chapter are passed in this browser.

import { memory } from "../answers/storage.js";
import { countPassed, readAnswers, STUDENT_KEY, sumUp } from "./stored_answers.js";

const writeBeside = (link, words, part) => {
  link.querySelector(".rk-so-far")?.remove();
  link.style.setProperty("--passed", part);
  if (words) link.insertAdjacentHTML("beforeend", `<small class="rk-so-far">${words}</small>`);
};

const showPassed = () => {
  const course = document.querySelector("meta[name=course]")?.content;
  const progress = countPassed(readAnswers(course, memory.get(STUDENT_KEY) ?? ""));
  const links = [...document.querySelectorAll("nav.bd-links a, a.site-card")];
  for (const { topic, count, passed } of progress) {
    const own = links.filter(({ pathname }) => pathname.endsWith(`/${topic}/${topic}.html`));
    own.forEach((link) => writeBeside(link, passed ? `${passed} of ${count} passed` : "", passed / count));
  }
  const all = sumUp(progress, "passed"), first = document.querySelector(".site-so-far");
  if (first) first.textContent = all ? `You have passed ${all} of ${sumUp(progress, "count")} exercises.` : "";
};

export const startProgress = () => {
  showPassed();
  addEventListener("courseware:kept", showPassed);
  for (const elsewhere of ["storage", "pageshow"]) addEventListener(elsewhere, showPassed);
};
