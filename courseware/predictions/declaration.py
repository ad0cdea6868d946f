"""What a prediction is: a question, the ways to answer it, and what the answer opens.

Right answers that are numbers are computed: an expression without symbols (a formula's `at`, also
a mistake's), or a function of no arguments. They are SI; the reader sees and types `unit`.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy as sp

from courseware.course import course
from courseware.errors import CourseError, describe
from courseware.figures.declaration import Slider
from courseware.figures.figure import find_figure
from courseware.practice.wording import number_text, with_unit
from courseware.units import UNITS, in_figures, refuse_unknown

Value = Any  # an expression, a matrix or tuple of them, or a function of no arguments


@dataclass(frozen=True)
class Buttons:
    """Two to four options.

    Args:
        options: the words on the buttons.
        right: one of them, or a function that finds it.
        assumes: option → what somebody assumes who chooses it, in a sentence.
    """

    options: tuple[str, ...]
    right: str | Callable[[], str]
    assumes: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        unknown = {self.answer(), *self.assumes} - set(self.options)
        if unknown or not 2 <= len(set(self.options)) <= 4:
            raise CourseError(
                f"a prediction has two to four different options, and its other words name them; "
                f"got {', '.join(self.options)} and {', '.join(unknown) or 'none besides'}"
            )

    def answer(self) -> str:
        """The right option."""
        return self.right if isinstance(self.right, str) else self.right()

    def data(self) -> dict[str, Any]:
        """What the script must know."""
        wrong = {self.options.index(option): why for option, why in self.assumes.items()}
        return {
            "kind": "buttons",
            "options": self.options,
            "right": self.options.index(self.answer()),
            "wrong": list(wrong),
        }


@dataclass(frozen=True)
class Number:
    """A number to type, read as answers of exercises are.

    Args:
        label, unit: of the box.
        right: the right one.
        assumes: what somebody assumes, in a sentence → the number that this gives.
        near: how far off still counts as right, as a part of the right one.
    """

    label: str
    unit: str
    right: Value
    assumes: Mapping[str, Value] = field(default_factory=dict)
    near: float = 0.05

    def __post_init__(self) -> None:
        refuse_unknown(self.unit, f"the guess of {self.label}")
        _refuse_typed(self.label, self.right, *self.assumes.values())

    def shown(self, value: Value) -> float:
        """A number in the unit that the reader sees."""
        return UNITS[self.unit].from_si(row(value)[0])

    def answer(self) -> str:
        """The right number with its unit."""
        return with_unit(number_text(self.shown(self.right), ".3g"), self.unit)

    def data(self) -> dict[str, Any]:
        """What the script must know."""
        right = self.shown(self.right)
        return {
            "kind": "number",
            "labels": [""],
            "units": [self.unit],
            "right": [right],
            "wrong": [[self.shown(value)] for value in self.assumes.values()],
            "near": self.near * (abs(right) or 1),
        }


@dataclass(frozen=True)
class Ghost:
    """A ghost to place in a live figure, which stands in the cell before.

    Args:
        figure: its name.
        places: those sliders of the figure that place the ghost; while the question is open, they
            and their handles are all that can be moved.
        then: what the figure shows after the answer.
        right: where the ghost belongs, a number for each slider.
        near: how far off still counts as right, in what the sliders show.
        assumes: as for a number.
    """

    figure: str
    places: tuple[sp.Symbol, ...]
    then: Mapping[sp.Symbol, Value]
    right: Value
    near: float
    assumes: Mapping[str, Value] = field(default_factory=dict)

    def __post_init__(self) -> None:
        _refuse_typed(self.figure, self.right, *self.assumes.values())

    def sliders(self) -> list[Slider]:
        """The sliders that place the ghost."""
        known = {getattr(control, "symbol", None): control for control in self.controls()}
        missing = [str(s) for s in (*self.places, *self.then) if s not in known]
        if missing:
            raise CourseError(
                f"a prediction moves {', '.join(missing)}, but the figure {self.figure} has the "
                f"sliders {', '.join(str(s) for s in known if s is not None)}"
            )
        return [known[symbol] for symbol in self.places]

    def controls(self) -> tuple[Any, ...]:
        """All controls of the figure."""
        return find_figure(self.figure).controls

    def units(self) -> list[str]:
        """The unit of each slider, as the reader sees it."""
        return [in_figures(slider.symbol.unit).name for slider in self.sliders()]

    def shown(self, value: Value) -> list[float]:
        """Numbers in the units that the reader sees."""
        pairs = zip(row(value), self.sliders(), strict=True)
        return [x / in_figures(slider.symbol.unit).factor for x, slider in pairs]

    def answer(self) -> str:
        """Where the ghost belongs, in words."""
        parts = zip(self.sliders(), self.shown(self.right), self.units(), strict=True)
        return ", ".join(
            f"{slider.label or slider.symbol} {with_unit(number_text(x, '.3g'), unit)}"
            for slider, x, unit in parts
        )

    def data(self) -> dict[str, Any]:
        """What the script must know; sliders as numbers of the figure's controls."""
        order = [getattr(control, "symbol", None) for control in self.controls()]
        return {
            "kind": "ghost",
            "figure": self.figure,
            "places": [order.index(slider.symbol) for slider in self.sliders()],
            "labels": [slider.label or str(slider.symbol) for slider in self.sliders()],
            "units": self.units(),
            "then": {
                order.index(symbol): float(row(value)[0]) / in_figures(symbol.unit).factor
                for symbol, value in self.then.items()
            },
            "right": self.shown(self.right),
            "wrong": [self.shown(value) for value in self.assumes.values()],
            "near": self.near,
        }


@dataclass(frozen=True, eq=False)
class Prediction:
    """A question that takes an answer, in the tuple `PREDICTIONS` of a chapter's `predictions.py`.

    A cell `predictions.ask("faster-right")`, tagged `remove-input`, shows it. The cells right after
    it, code or Markdown, that are tagged `after-faster-right` are folded and open with it.

    Args:
        name: its address on the page, letters and dashes.
        question: Markdown with formulas.
        answers: Buttons, a Number or a Ghost.
        opens: the result in a sentence or two, Markdown with formulas.
        hides: words that give the answer away, besides the answer itself; a test holds that they
            stand nowhere above it in the chapter, and below it only in what it opens.
    """

    name: str
    question: str
    answers: Buttons | Number | Ghost
    opens: str
    hides: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not re.fullmatch("[a-z][a-z0-9-]*", self.name):
            raise CourseError(f"a prediction's name has small letters and dashes, got {self.name}")

    @property
    def assumes(self) -> list[tuple[str, str]]:
        """What usual wrong guesses are, and what each of them assumes."""
        answers, data = self.answers, self.answers.data()
        if isinstance(answers, Buttons):
            return list(answers.assumes.items())
        guesses = (
            ", ".join(
                with_unit(number_text(x, ".3g"), unit)
                for x, unit in zip(guess, data["units"], strict=True)
            )
            for guess in data["wrong"]
        )
        return list(zip(guesses, answers.assumes, strict=True))


def row(value: Value) -> list[float]:
    """A value's numbers."""
    if isinstance(value, tuple):
        return [number for part in value for number in row(part)]
    found = value() if callable(value) else value
    if isinstance(found, sp.Basic | sp.MatrixBase):
        found = np.array(sp.Matrix([found]).evalf().tolist(), dtype=float)
    numbers = (float(x) for x in np.ravel(found))
    # cos(π/2) and the like leave no zero but 1e-16, or 1e-136 of many digits
    return [0.0 if abs(x) < 1e-12 else x for x in numbers]


def _refuse_typed(who: str, *values: Value) -> None:
    """An answer that is typed can be wrong without a test that notices."""
    for value in (part for v in values for part in (v if isinstance(v, tuple) else (v,))):
        code = getattr(value, "__code__", None)
        computed = callable(value) or isinstance(value, sp.Basic | sp.MatrixBase)
        if not computed or (code and not code.co_names and not code.co_freevars):
            raise CourseError(
                f"the answers to a prediction are computed: give an expression or a function "
                f"of the library for {who!r}, got {describe(value)}"
            )


def predictions() -> dict[str, Prediction]:
    """Every prediction of the course, by name."""
    return course().declared("predictions", Prediction)


def find(name: str) -> Prediction:
    """The prediction of that name."""
    return course().find("predictions", Prediction, name)
