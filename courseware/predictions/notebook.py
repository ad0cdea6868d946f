"""A prediction in a notebook: the question, and a fold with what it opens."""

from courseware.equations.notebook import Output
from courseware.predictions.declaration import Buttons, Prediction, find

MIME = "application/vnd.courseware.prediction+json"


def ask(name: str) -> Output:
    """Ask the reader for a prediction, by its name."""
    return asked(find(name))


def asked(p: Prediction) -> Output:
    """A prediction as the value of a cell; a page finds it by its name."""
    options = p.answers.options if isinstance(p.answers, Buttons) else ()
    question = "\n".join([f"**Your guess first.** {p.question}\n", *(f"- {o}" for o in options)])
    fold = f"<details><summary>The answer</summary>\n\n{opened(p)}\n\n</details>"
    return Output(
        {
            MIME: {"name": p.name},
            "text/markdown": f"{question}\n\n{fold}",
            "text/plain": question,
        }
    )


def opened(p: Prediction) -> str:
    """What stands in the fold, as Markdown."""
    guesses = [f"- {guess}: {why}" for guess, why in p.assumes]
    return "\n\n".join([f"**{p.answers.answer()}**", p.opens, "\n".join(guesses)]).strip()
