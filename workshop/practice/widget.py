"""An exercise in JupyterLab, Notebook and VS Code."""

import json

import anywidget
import traitlets

from workshop.practice.bank import Exercise
from workshop.practice.page import packed
from workshop.script.runtime import runtime, stylesheet


class ExerciseWidget(anywidget.AnyWidget):
    """The figures' runtime with one exercise; `answer` is what was checked last."""

    _esm = traitlets.Unicode().tag(sync=True)
    _css = traitlets.Unicode().tag(sync=True)
    student = traitlets.Unicode().tag(sync=True)
    answer = traitlets.Unicode().tag(sync=True)


def widget(exercise: Exercise, student: str, course: str) -> ExerciseWidget:
    """The box of an exercise, for a student of a course."""
    given = ", ".join(json.dumps(text) for text in (packed([exercise]), exercise.name, course))
    module = (
        f"{runtime()}\n"
        f"export default {{ render: (view) => robokin.exerciseInNotebook({given}, view) }};\n"
    )
    return ExerciseWidget(_esm=module, _css=stylesheet(), student=student)
