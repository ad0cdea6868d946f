// In a notebook: `student` in the state of the widget comes from Python, the answer that counts
// goes back, with what it was judged to be.
//
// content: { packed, name, course }, packed by rendering.py.

import { chooseVariant, foldName } from "./variants.js";
import { ExerciseBox, unpack } from "./exercise.js";
import { renderExercise } from "./rendering.js";

export const showExercise = async ({ packed, name, course }, { model, el }) => {
  // boxes of one exercise, also of several notebooks in one window, must not share ids
  const id = `rk-box-${Math.random().toString(36).slice(2)}`;
  const student = () => foldName(model.get("state").student);
  const exercise = (await unpack(packed))[name];
  const first = exercise.variants[chooseVariant(course, name, student())];
  el.classList.add("rk-exercise");
  el.innerHTML = renderExercise(exercise, first.shown, exercise.solution, id);
  const box = new ExerciseBox(el, {
    course,
    student,
    load: async () => exercise,
    kept: () => model.get("state").kept[student()],
    keep: (entry) => {
      const { answer, result, tries = 0, help = 0 } = entry, kept = { ...model.get("state").kept, [student()]: entry };
      model.set("state", { ...model.get("state"), answer, result, tries, help, kept });
      model.save_changes();
    },
  }).start();
  // JupyterLab takes the Enter key, which would send the form
  el.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !event.target.matches("input")) return;
    event.preventDefault(); // elsewhere the form would be sent, too: two tries
    box.check();
  });
  let before = student();
  const follow = () => {
    if (student() !== before) box.renew();
    before = student();
  };
  model.on("change:state", follow);
  await box.renew();
  return () => model.off("change:state", follow);
};
