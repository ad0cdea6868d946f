// What a student has answered in this browser, and how much of each chapter is passed.

const answersKept = (course) => `${STORE} answers ${course}`;
const studentKept = `${STORE} student`;

// The answers under a name, however it is written.
const answersUnder = (course, name) => {
  const all = parsed(answersKept(course)), student = foldedName(name);
  const [alike] = Object.keys(all).filter((other) => foldedName(other) === student);
  return all[student] ?? all[alike] ?? {};
};

const isPassed = (answers, exercise) => answers[exercise]?.result === "right";

// Chapter by chapter: its title, its name, how many exercises it has and how many are passed.
const progressOf = (answers) => Object.entries(TOPICS).map(([title, [topic, count]]) => {
  const many = Object.keys(answers).filter((name) => isPassed(answers, name)
    && name.replace(/-\d+$/, "").replaceAll("-", "_") === topic).length;
  return { title, topic, count, many };
});

const sumOf = (progress, key) => progress.reduce((total, chapter) => total + chapter[key], 0);
