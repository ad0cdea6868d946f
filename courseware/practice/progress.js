// In the menu and on the first page: how many exercises of each chapter are passed in this browser.

const tellAt = (place, words) => {
  let told = place.querySelector(".rk-so-far");
  if (!told) {
    told = place.appendChild(document.createElement("small"));
    told.className = "rk-so-far";
  }
  told.textContent = words;
};

const tell = () => {
  const course = document.querySelector("meta[name=course]")?.content;
  const progress = progressOf(answersUnder(course, memory.get(studentKept) ?? ""));
  const links = [...document.querySelectorAll("nav.bd-links a, a.site-card")];
  for (const { topic, count, many } of progress) {
    const own = links.filter(({ pathname }) => pathname.endsWith(`/${topic}/${topic}.html`));
    own.forEach((link) => tellAt(link, many ? `${many} of ${count} passed` : ""));
  }
  const all = sumOf(progress, "many"), first = document.querySelector(".site-so-far");
  if (first) first.textContent = all ? `You have passed ${all} of ${sumOf(progress, "count")} exercises.` : "";
};

const onPage = () => {
  tell();
  addEventListener("courseware:kept", tell);
  addEventListener("storage", tell); // from another window
};

Object.assign(part, { onPage });
