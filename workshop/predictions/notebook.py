"""A prediction in a notebook: the question, and a fold with what it opens."""

from typing import Any

from workshop.predictions.declaration import Buttons, Prediction, find

MIME = "application/vnd.workshop.prediction+json"


class Asked:
    """A prediction as the value of a cell; a page finds it by its name."""

    def __init__(self, prediction: Prediction) -> None:
        self.prediction = prediction

    @property
    def opened(self) -> str:
        """What stands in the fold, as Markdown."""
        p = self.prediction
        guesses = [f"- {guess}: {why}" for guess, why in p.assumes]
        return "\n\n".join([f"**{p.answers.answer()}**", p.opens, "\n".join(guesses)]).strip()

    def _repr_mimebundle_(self, **_: Any) -> dict[str, Any]:
        p = self.prediction
        options = p.answers.options if isinstance(p.answers, Buttons) else ()
        question = "\n".join(
            [f"**Your guess first.** {p.question}\n", *(f"- {o}" for o in options)]
        )
        fold = f"<details><summary>The answer</summary>\n\n{self.opened}\n\n</details>"
        return {
            MIME: {"name": p.name},
            "text/markdown": f"{question}\n\n{fold}",
            "text/plain": question,
        }


def ask(name: str) -> Asked:
    """Ask the reader for a prediction, by its name."""
    return Asked(find(name))
