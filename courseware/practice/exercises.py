"""How an exercise is declared: once, to be dealt, shown, judged and graded.

An exercise has a text with placeholders for numbers, how these are drawn, the right answer, and the
mistakes that can be made in it, each as the formula that somebody who makes it would use. Inside a
formula all numbers are SI; the reader sees the units that suit the text.

64 variants are drawn by a fixed seed. One in which two answers of `right` and `wrong` would be too
close to tell apart is not dealt. Answers are read and judged by the scripts of the page everywhere.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from courseware.answers import Unknown
from courseware.course import topic_of
from courseware.errors import CourseError
from courseware.practice.mistakes import Mistake
from courseware.practice.solutions import Solution
from courseware.units import UNITS, refuse_unknown
from courseware.units.formatting import append_unit, format_number

Row = tuple[float, ...]

PLACEHOLDER = r"{([\w.:]+)}"


@dataclass(frozen=True)
class Given:
    """A number of the text that is drawn from options, which are in the unit that is shown."""

    options: tuple[Any, ...]
    unit: str = ""

    def __post_init__(self) -> None:
        refuse_unknown(self.unit, f"the number drawn from {self.options!r}")

    def to_si(self, option: Any) -> Any:
        """Return the SI number that formulas get; a name stays as it is."""
        return UNITS[self.unit].to_si(option) if isinstance(option, int | float) else option

    def format(self, value: Any) -> str:
        """Return a value in SI as the reader sees it: "30 cm", "−45°"."""
        if not isinstance(value, int | float):
            return append_unit(str(value), self.unit)
        option = float(f"{UNITS[self.unit].from_si(value):.9g}")
        return append_unit(format_number(option), self.unit)


def number_range(low: float, high: float, step: float, unit: str = "") -> Given:
    """Draw one of the round numbers from low to high, both included."""
    count = round((high - low) / step)
    numbers = [float(f"{low + k * step:.9g}") for k in range(count + 1)]
    return Given(tuple(int(n) if n.is_integer() else n for n in numbers), unit)


def one_of(*options: Any, unit: str = "") -> Given:
    """Draw one of some numbers or names."""
    return Given(options, unit)


@dataclass(frozen=True, eq=False)
class Exercise:
    """One exercise with numbers left open, in a chapter's `exercises.py`.

    It appears by itself on the page of all exercises and in the teacher's tables. A chapter shows
    it by `practice.exercise("bicycle-1")`, and the numbers of its example by `practice.example`, in
    cells tagged `remove-input`.

    Args:
        name: stem of the topic and a number.
        title: of its box.
        text: Markdown-free text with `{placeholders}`: numbers of `given`, what `derive` adds, and
            `{right}`; `{x:deg}` shows degrees, `{x:.2f}` a format; "v_L" becomes a symbol; an empty
            line starts a paragraph.
        given: name → how it is drawn.
        unknowns: the numbers of an answer, in order.
        right: function of the numbers → the answer, shape (n,) or `shape`.
        wrong: mistake → function → the answer of somebody who makes it; `{}` if there is none.
        solution: the way there, with such placeholders.
        likely_slips: as `wrong` for mistakes without a number, as words that end "This is what
            you get …"; where one gives the same as a mistake, both are named.
        together: two mistakes → function → the answer of somebody who makes both; named where it
            is apart from all other answers.
        shape: of a matrix.
        accept: which rows of `right` must be typed: "one", its only row; "any" one of them, where
            several answers are right; or "all" of them, in any order.
        derive: function of the numbers → others, for the text.
        when: function of the numbers → whether they may be dealt.
        example: numbers in SI that are the same for all, where the chapter shows the mistakes.
    """

    name: str
    title: str
    text: str
    given: Mapping[str, Given]
    unknowns: tuple[Unknown, ...]
    right: Callable[..., ArrayLike]
    wrong: Mapping[Mistake, Callable[..., ArrayLike]]
    solution: Solution
    likely_slips: Mapping[str, Callable[..., ArrayLike]] = field(default_factory=dict)
    together: Mapping[tuple[Mistake, Mistake], Callable[..., ArrayLike]] = field(
        default_factory=dict
    )
    shape: tuple[int, ...] = ()
    accept: Literal["one", "any", "all"] = "one"
    derive: Callable[..., Mapping[str, Any]] = field(default=lambda **_: {})
    when: Callable[..., bool] = field(default=lambda **_: True)
    example: Mapping[str, Any] = field(default_factory=dict)

    @property
    def topic(self) -> str:
        """The stem of module, chapter and test: "differential_drive"."""
        return topic_of(self.name)

    def evaluate(
        self, formula: Callable[..., ArrayLike], numbers: Mapping[str, Any]
    ) -> tuple[Row, ...]:
        """Return the answer of a formula as rows; one row unless several answers count."""
        found = np.asarray(formula(**numbers), dtype=float).reshape(-1, len(self.unknowns))
        return tuple(map(tuple, found.tolist()))

    def fill(self, template: str, numbers: Mapping[str, Any]) -> str:
        """Return a text of the exercise with these numbers in it."""
        texts = self.fill_placeholders(template, numbers)
        return re.sub(PLACEHOLDER, lambda match: texts[match[1]], template)

    def format_given(self, numbers: Mapping[str, Any]) -> dict[str, str]:
        """Return the drawn numbers as the reader sees them."""
        return {name: given.format(numbers[name]) for name, given in self.given.items()}

    def fill_placeholders(self, template: str, numbers: Mapping[str, Any]) -> dict[str, str]:
        """Return each placeholder of a text with the text that takes its place."""
        given, values = self.format_given(numbers), {**numbers, **self.derive(**numbers)}
        keys = {key: re.split("[.:]", key)[0] for key in re.findall(PLACEHOLDER, template)}
        has_steps = not self.solution.steps.keys().isdisjoint(keys.values())
        steps = self.solution.solve(values, given) if has_steps else {}
        texts = {}
        for key, stem in keys.items():
            name, _, spec = key.partition(":")
            if stem in steps:
                texts[key] = steps[stem].format(name.partition(".")[2], spec)
            elif key == "right":
                texts[key] = self.format_answer(numbers)
            elif key in given:
                texts[key] = given[key]
            elif name in values:
                texts[key] = format_number(values[name], spec)
            else:
                raise CourseError(f"{self.name} has {{{key}}}, but only {', '.join(values)}")
        return texts

    def format_answer(self, numbers: Mapping[str, Any]) -> str:
        """Return the right answer as typed."""
        return self.format_rows(self.evaluate(self.right, numbers))

    def format_rows(self, rows: ArrayLike) -> str:
        """Return answers as typed, with their unit where all have the same."""
        shaped = np.reshape(rows, (-1, *(self.shape or (len(self.unknowns),))))
        units = {unknown.unit for unknown in self.unknowns}
        unit = units.pop() if len(units) == 1 else ""
        texts = [format_number(row if len(row) > 1 else float(row[0])) for row in shaped]
        joint = " or " if self.accept == "any" else "; "
        return joint.join(append_unit(text, unit) for text in dict.fromkeys(texts))
