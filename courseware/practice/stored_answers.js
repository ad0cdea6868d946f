// The answers of a student in this browser, and how many exercises of each chapter are passed.

import { STORE } from "../answers/constants.js";
import { TOPICS } from "./constants.js";
import { foldName } from "./variants.js";
import { readStored } from "../answers/storage.js";

export const answersKey = (course) => `${STORE} answers ${course}`;
export const STUDENT_KEY = `${STORE} student`;

// The answers under a name, however it is written.
export const readAnswers = (course, name) => readStored(answersKey(course))[foldName(name)] ?? {};

export const isPassed = (answers, exercise) => answers[exercise]?.result === "right";

export const countPassed = (answers) => Object.entries(TOPICS).map(([title, [topic, count]]) => {
  const passed = Object.keys(answers).filter((name) => isPassed(answers, name)
    && name.replace(/-\d+$/, "").replaceAll("-", "_") === topic).length;
  return { title, topic, count, passed };
});

export const sumUp = (progress, key) => progress.reduce((total, chapter) => total + chapter[key], 0);
