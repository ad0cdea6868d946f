"""A prediction in a notebook: the question, and a fold with the answer."""

from courseware.equations.notebook import Output
from courseware.predictions.prediction import Buttons, Prediction, find_prediction

MIME = "application/vnd.courseware.prediction+json"


def ask(name: str) -> Output:
    """Ask the reader for a prediction, by its name."""
    return show_prediction(find_prediction(name))


def show_prediction(p: Prediction) -> Output:
    """Render a prediction as the value of a cell; a page finds it by its name."""
    options = p.answers.options if isinstance(p.answers, Buttons) else ()
    question = "\n".join([f"**Your guess first.** {p.question}\n", *(f"- {o}" for o in options)])
    fold = f"<details><summary>The answer</summary>\n\n{render_fold(p)}\n\n</details>"
    return Output(
        {
            MIME: {"name": p.name},
            "text/markdown": f"{question}\n\n{fold}",
            "text/plain": question,
        }
    )


def render_fold(p: Prediction) -> str:
    """Render the answer, its explanation and the assumptions of wrong guesses as Markdown."""
    guesses = "\n".join(f"- {guess}: {why}" for guess, why in p.answers.guesses())
    return f"**{p.answers.format_answer()}**\n\n{p.explanation}\n\n{guesses}".strip()
