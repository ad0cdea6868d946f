"""Letters to put back into a picture, the question at the end of a chapter."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import sympy as sp

from courseware.figures import Choice, Goal, Label, when
from courseware.figures.computed_parts import Place

COUNTS = {2: "two", 3: "three"}


class Letters(NamedTuple):
    """The parts of a figure: a choice for each letter, the labels in the picture, the goal."""

    controls: tuple[Choice, ...]
    shapes: tuple[Label, ...]
    goal: Goal


def put_back(
    quantity: Callable[..., Any], options: tuple[str, ...], answers: Mapping[str, Place]
) -> Letters:
    """Return the parts of a question for letters.

    quantity: the chapter's. options: all letters to choose from. answers: the right ones, each with
    its place, which has a number until it is named.
    """
    numbers = {name: (number,) for number, name in enumerate(("?", *options))}
    names = [
        quantity(f"name_{k}", "", 0, len(options), f"the reader's name for {k}")
        for k in range(1, len(answers) + 1)
    ]
    controls, shapes, right = list[Choice](), list[Label](), list[Any]()
    for k, (name, (wanted, place)) in enumerate(zip(names, answers.items(), strict=True), 1):
        controls.append(Choice(f"name_{k}", f"{k} is", (name,), numbers))
        for letter, (number,) in numbers.items():
            kind = "target" if letter == wanted else "error" if number else "text"
            text = letter if letter == wanted else f"{letter}: no" if number else str(k)
            shapes += when(sp.Abs(name - number) < 0.5, Label(kind, place, text))
        right.append(sp.Abs(name - numbers[wanted][0]) < 0.5)
    goal = Goal(sp.And(*right), f"Put the {COUNTS[len(answers)]} letters back.")
    return Letters(tuple(controls), tuple(shapes), goal)
