"""A prediction: a question, the ways to answer it, and the explanation that an answer opens.

Right answers that are numbers are computed: an expression without symbols (of a
formula's or a mistake's `substitute`), or a function of no arguments. They are SI; the reader sees
and types `unit`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy as sp

from courseware.course import course
from courseware.figures.figure import find_figure
from courseware.units import UNITS, Unit, figure_unit, refuse_unknown
from courseware.units.formatting import append_unit, format_number

Value = Any  # an expression, a matrix or tuple of them, or a function of no arguments
LEFT, RIGHT = "too far to the left", "too far to the right"
PLACED = (("", RIGHT, LEFT), ("", "too far up", "too far down"))  # along the axes of a picture
TURNED = ("turned ", LEFT, RIGHT)


@dataclass(frozen=True)
class Buttons:
    """Two to four options.

    Args:
        options: the words on the buttons.
        right: one of them, or a function that finds it, as with `nearest_option`.
        assumptions: option → the assumption of somebody who chooses it, in a sentence.
    """

    options: tuple[str, ...]
    right: str | Callable[[], str]
    assumptions: Mapping[str, str] = field(default_factory=dict)

    def format_answer(self) -> str:
        return self.right if isinstance(self.right, str) else self.right()

    def guesses(self) -> list[tuple[str, str]]:
        return list(self.assumptions.items())

    def serialize(self) -> dict[str, Any]:
        """Return what the script must know."""
        return {
            "kind": "buttons",
            "options": self.options,
            "right": self.options.index(self.format_answer()),
            "wrong": [self.options.index(option) for option in self.assumptions],
        }


def nearest_option(options: Mapping[str, Any], value: Any) -> str:
    """Return the option whose number, or row of numbers, is nearest to a computed one."""
    return min(options, key=lambda o: float(np.linalg.norm(np.subtract(options[o], value))))


class _Numbers:
    """Numbers that are computed, shown in the units that the reader sees."""

    right: Value
    assumptions: Mapping[str, Value]

    def units(self) -> list[Unit]:
        raise NotImplementedError

    def convert(self, value: Value) -> list[float]:
        return [unit.from_si(x) for x, unit in zip(evaluate(value), self.units(), strict=True)]

    def format(self, value: Value) -> list[str]:
        pairs = zip(self.convert(value), self.units(), strict=True)
        return [append_unit(format_number(x, ".3g"), unit.name) for x, unit in pairs]

    def guesses(self) -> list[tuple[str, str]]:
        return [(", ".join(self.format(value)), why) for why, value in self.assumptions.items()]

    def serialize(self) -> dict[str, Any]:
        return {
            "units": [unit.name for unit in self.units()],
            "right": self.convert(self.right),
            "wrong": [self.convert(value) for value in self.assumptions.values()],
        }


@dataclass(frozen=True)
class Number(_Numbers):
    """A number to type, read as answers of exercises are.

    Args:
        unit: of the box.
        right: the right one.
        assumptions: an assumption, in a sentence → the number that follows from it.
        relative: how far off still counts as right, as a part of the right one.
    """

    unit: str
    right: Value
    assumptions: Mapping[str, Value] = field(default_factory=dict)
    relative: float = 0.05

    def __post_init__(self) -> None:
        refuse_unknown(self.unit, "a guess")

    def units(self) -> list[Unit]:
        return [UNITS[self.unit]]

    def format_answer(self) -> str:
        return self.format(self.right)[0]

    def serialize(self) -> dict[str, Any]:
        near = self.relative * (abs(self.convert(self.right)[0]) or 1)
        return super().serialize() | {"kind": "number", "labels": [""], "near": near}


@dataclass(frozen=True)
class Ghost(_Numbers):
    """A ghost to place in a live figure, which is in the cell before.

    A wrong place is answered with the direction that it is off, "too far to the left", and another
    try; the third one with the distance, too. After that each is also called warmer or colder, and
    a button shows the answer. Nothing is judged before the ghost has been moved.

    Args:
        figure: its name.
        places: those sliders of the figure that place the ghost; while the question is open, they
            and their handles are all that can be moved. A handle at two sliders makes the first one
            left and right, the second one up and down; the only angle is turned; another slider
            goes by its label.
        then: the sliders' values after the answer.
        free: sliders to move before and after the answer, which they must not tell.
        right: where the ghost belongs, a number for each slider.
        tolerance: how far off each may be and still count as right, in the units of the sliders.
        assumptions: as for a number.
    """

    figure: str
    places: tuple[sp.Symbol, ...]
    then: Mapping[sp.Symbol, Value]
    right: Value
    tolerance: float
    assumptions: Mapping[str, Value] = field(default_factory=dict)
    free: tuple[sp.Symbol, ...] = ()

    def controls(self) -> dict[sp.Symbol, tuple[int, Any]]:
        """Return the controls of the figure by symbol, each with its number."""
        controls = enumerate(find_figure(self.figure).controls)
        return {c.symbol: (k, c) for k, c in controls if hasattr(c, "symbol")}

    def units(self) -> list[Unit]:
        return [figure_unit(symbol.unit) for symbol in self.places]

    def labels(self) -> list[str]:
        controls = self.controls()
        return [controls[symbol][1].label or str(symbol) for symbol in self.places]

    def ways(self) -> list[tuple[str, str, str]]:
        """Return for each slider the words before an amount, and after too much and too little."""
        turned = [symbol for symbol in self.places if symbol.unit == "rad"]
        found = {("rad", symbol): TURNED for symbol in turned if len(turned) == 1}
        for handle in find_figure(self.figure).handles:
            found |= {("m", at): way for at, way in zip(handle.at, PLACED, strict=False)}
        return [
            found.get((symbol.unit, symbol), (f"{label} ", "too large", "too small"))
            for symbol, label in zip(self.places, self.labels(), strict=True)
        ]

    def format_answer(self) -> str:
        pairs = zip(self.labels(), self.format(self.right), strict=True)
        return ", ".join(f"{label} {text}" for label, text in pairs)

    def serialize(self) -> dict[str, Any]:
        """Return what the script must know; sliders as numbers of the figure's controls."""
        controls = self.controls()
        return super().serialize() | {
            "kind": "ghost",
            "places": [controls[symbol][0] for symbol in self.places],
            "free": [controls[symbol][0] for symbol in self.free],
            "labels": self.labels(),
            "ways": self.ways(),
            "then": {
                controls[symbol][0]: figure_unit(symbol.unit).from_si(evaluate(value)[0])
                for symbol, value in self.then.items()
            },
            "near": self.tolerance,
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
        explanation: the result in a sentence or two, Markdown with formulas.
        spoilers: words that give the answer away, besides the answer itself; a test holds that they
            be nowhere above it in the chapter, and below it only in the fold.
        covers: the name of a figure in the cell before, which waits for the answer: on the page its
            picture rests, and what moves it is replaced by "Answer, or show me". Without
            JavaScript, in print and in a notebook the figure is open, as at its start.
    """

    name: str
    question: str
    answers: Buttons | Number | Ghost
    explanation: str
    spoilers: tuple[str, ...] = ()
    covers: str = ""

    @property
    def figure(self) -> str:
        """The name of the figure that waits for the answer, or ""."""
        return getattr(self.answers, "figure", self.covers)

    def serialize(self) -> dict[str, Any]:
        """Return what the script must know."""
        return self.answers.serialize() | {"figure": self.figure}


def evaluate(value: Value) -> list[float]:
    if isinstance(value, tuple):
        return [number for part in value for number in evaluate(part)]
    found = value() if callable(value) else value
    if isinstance(found, sp.Basic | sp.MatrixBase):
        found = np.array(sp.Matrix([found]).evalf().tolist(), dtype=float)
    numbers = (float(x) for x in np.ravel(found))
    # cos(π/2) and the like leave no zero but 1e-16, or 1e-136 of many digits
    return [0.0 if abs(x) < 1e-12 else x for x in numbers]


def find_prediction(name: str) -> Prediction:
    return course().find("predictions", Prediction, name)
