"""A prediction is asked before it is told: nothing above or beside it gives the answer away."""

import re

import nbformat
import pytest
import stored_outputs
from declared import PREDICTIONS, course, each
from nbformat.v4 import new_code_cell, new_markdown_cell
from sympy import Float

from book.differential_drive import formulas
from book.differential_drive.figures import guess_x, guess_y
from book.differential_drive.formulas import b, v_L, v_R
from book.motion.formulas import theta
from courseware.figures import figure
from courseware.predictions import Ghost, Number, Prediction
from courseware.predictions.notebook import MIME, render_fold, show_prediction
from courseware.predictions.page import TAG
from courseware.script import engine

ASK = re.compile(r'predictions\.ask\("([\w-]+)"\)')
PLAIN = re.compile(r"[*_$`]|<[^>]+>|\\[a-z]+")  # what is no word of the text


def plain(text):
    """A text as it is read: small letters, one blank between words, a plain minus."""
    return " ".join(PLAIN.sub(" ", text).replace("\u2212", "-").lower().split())


def prediction_of(cell):
    """The name of the prediction that a cell asks, or None."""
    found = ASK.search(cell.source) if cell.cell_type == "code" else None
    return found and found[1]


def text_before(cell, known):
    """What a reader has seen of a cell when the next one is read; predictions are open then."""
    if prediction_of(cell) in known:
        prediction = known[prediction_of(cell)]
        return f"{prediction.question} {render_fold(prediction)}"
    texts = [cell.source]
    for output in cell.get("outputs", []):
        data = output.get("data", {})
        if figure.MIME in data:
            texts.append(figure.find_figure(data[figure.MIME]["name"]).render_contents())
        texts += [output.get("text", ""), data.get("text/plain", ""), data.get("text/html", "")]
    return " ".join("".join(text) for text in texts)


def tells(prediction):
    """Words that give the answer away."""
    answers = prediction.answers
    unit = isinstance(answers, Number) and answers.unit
    return [*prediction.spoilers, *([answers.format_answer()] if unit else [])]


def given_away(cells, known):
    """Where a notebook says what it asks."""
    for place, cell in enumerate(cells):
        if prediction_of(cell) in known:
            prediction = known[prediction_of(cell)]
            beside = unfolded(cells[place + 1 :], prediction.name)
            seen = [text_before(other, known) for other in cells[:place]]
            seen += [prediction.question, *(text_before(other, {}) for other in beside)]
            yield from (
                f"{prediction.name}: “{words}” is outside its fold"
                for words in tells(prediction)
                if re.search(rf"(?<![\w.]){re.escape(plain(words))}(?!\w)", plain(" ".join(seen)))
            )


def followed(cell):
    """The predictions that a cell is folded into."""
    tags = cell.metadata.get("tags", [])
    return {tag.removeprefix(TAG) for tag in tags if tag.startswith(TAG)}


def unfolded(cells, name):
    """The open cells below a question, up to the next heading or question."""
    for cell in cells:
        if prediction_of(cell) or (cell.cell_type == "markdown" and cell.source.startswith("#")):
            return
        if name not in followed(cell):
            yield cell


ASKING = list(course().modules("predictions"))


@pytest.mark.parametrize("chapter", course().taught)
def test_a_chapter_asks(chapter):
    assert chapter in ASKING, f"ask before you tell: write book/{chapter}/predictions.py"


def cells_of(chapter):
    return nbformat.read(course().notebook(chapter), as_version=4).cells


@pytest.mark.parametrize("chapter", ASKING)
def test_nothing_gives_an_answer_away(chapter):
    found = list(given_away(cells_of(chapter), PREDICTIONS))
    assert not found, f"fold it into its question (tag {TAG}NAME), or say it below: {found}"


@pytest.mark.parametrize("chapter", ASKING)
def test_each_is_asked_once_in_its_own_chapter(chapter):
    homes = course().chapters_of("predictions", Prediction)
    asked = sorted(name for cell in cells_of(chapter) if (name := prediction_of(cell)))
    declared = sorted(name for name, home in homes.items() if home == chapter)
    assert asked == declared, f"{chapter}.ipynb asks {asked}; predictions.py declares {declared}"


@each("prediction", "predictions", Prediction)
def test_it_says_what_would_give_it_away(prediction):
    """A number with a unit is looked for by itself."""
    assert tells(prediction), (
        f"{prediction.name}: name in `spoilers` the words that would give its answer away"
    )


@each("prediction", "predictions", Prediction)
def test_a_usual_wrong_guess_is_not_right(prediction):
    data = prediction.answers.serialize()
    same = "(d) => d.wrong.map((w) => courseware.isSameGuess(d, w, d.right))"
    right = engine.call(f"({same})", data)
    assert not any(right), (
        f"{prediction.name}: of the guesses in `assumptions` these are right: {right}"
    )


@each("prediction", "predictions", Prediction)
def test_a_figure_that_waits_stands_before(prediction):
    """The one of a ghost, and the one under a veil."""
    if prediction.figure:
        chapter = course().chapters_of("predictions", Prediction)[prediction.name]
        cells = cells_of(chapter)
        place = next(i for i, cell in enumerate(cells) if prediction_of(cell) == prediction.name)
        outputs = [o.data for o in cells[place - 1].outputs if figure.MIME in o.get("data", {})]
        shown = [o[figure.MIME]["name"] for o in outputs]
        assert shown == [prediction.figure], (
            f"show {prediction.figure} in the cell before predictions.ask("
            f'"{prediction.name}"), which shows {shown}'
        )


# --- what is shown and told ------------------------------------------------------------------

SPEEDS = {v_L: Float("0.05"), v_R: Float("0.1"), b: Float("0.1")}
RATE = Prediction(
    "rate",
    "How fast does it turn?",
    Number("rad/s", right=formulas.turning_rate.substitute(SPEEDS)),
    explanation="By the difference.",
)


def ask(name):
    return new_code_cell(f'predictions.ask("{name}")')


def text(source, *tags):
    return new_markdown_cell(source, metadata={"tags": list(tags)})


def test_in_a_notebook_the_answer_is_folded():
    data = show_prediction(RATE)._repr_mimebundle_()
    question, _, fold = data["text/markdown"].partition("<details>")
    assert "0.5 rad/s" in fold
    assert "0.5" not in question + data["text/plain"]
    assert data[MIME] == {"name": "rate"}


WAYS = [
    (("guess", guess_x, guess_y), [-0.12, 0.034], "12 cm too far to the left, 3.4 cm too far up"),
    (("guess", guess_x, guess_y), [0.001, -0.5], "50 cm too far down"),
    (("world", theta), [15], "turned 15° too far to the left"),
    (("world", theta), [-170.4], "turned 170° too far to the right"),
    (("tips", v_L), [0.02], "left wheel v_L 0.02 m/s too large"),
]


@pytest.mark.parametrize(("where", "offs", "told"), WAYS)
def test_a_ghost_is_told_how_it_is_off(where, offs, told):
    name, *places = where
    right = formulas.speed.substitute(SPEEDS)
    ghost = Ghost(name, tuple(places), {}, (right,) * len(places), 0.01)
    assert engine.call("courseware.describeMiss", ghost.serialize(), offs, True) == told
    direction = engine.call("courseware.describeMiss", ghost.serialize(), offs)
    assert direction == re.sub(r"[\d.]+(°| c?m(/s)?) ", "", told)


def test_in_jupyterlab_what_it_opens_is_folded():
    notebook = nbformat.v4.new_notebook(cells=[ask("rate"), text("0.5 rad/s", "after-rate")])
    stored_outputs.normalize(notebook)
    question, result = notebook.cells
    assert "jupyter" not in question.metadata
    assert result.metadata["jupyter"]["source_hidden"]
