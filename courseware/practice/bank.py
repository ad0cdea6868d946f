"""What an exercise and a mistake are: declared once, then dealt, shown, checked and graded from.

An exercise has a text with numbers left open, how these are drawn, the right answer, and the
mistakes that can be made in it, each as the formula that someone who makes it would use. Inside a
formula all numbers are SI; the reader sees the units that suit the text.

64 variants are drawn by a fixed seed. One in which two answers of `right` and `wrong` would be too
close to tell apart is not dealt. Answers are read and judged by the scripts of the page everywhere.
In `tests/courseware`, `test_practice.py` holds every answer of every variant to its verdict, in
Python and in the script of the page, `test_solutions.py` goes on with every number as a solution
prints it, and the table `answers.json` says what must be read.
"""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from inspect import signature
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from courseware.course import course
from courseware.errors import CourseError, describe
from courseware.practice.solutions import Solution
from courseware.practice.wording import number_text, with_unit
from courseware.practice.wrong import Wrong
from courseware.units import UNITS, refuse_other_than_si, refuse_unknown

Answers = NDArray[np.float64]

RELATIVE = 1e-3  # of a large answer: as much as numbers make that are rounded on the way


@dataclass(frozen=True)
class Picture:
    """What a figure of the chapter shows of a mistake, for those who made it twice.

    Args:
        figure: its name.
        option: what its choice "mistake" is set to; the heading above `practice.mistake`, too.
        shows: the picture in words.
    """

    figure: str
    option: str
    shows: str


@dataclass(frozen=True)
class Mistake:
    """A mistake that people make, written once: exercises name it, chapters show it.

    It is a formula with something replaced. The two formulas with what changed marked, its number
    (`M12.wrong.gives`, or `M12.wrong.through(f)` in another formula) and a figure's ghost
    (`M12.substitute({…})`) come from there. A chapter shows it by `practice.mistake("M12")`.

    Args:
        name: M1, M2, … through the whole course in the order in which they were found; a new one
            gets the next free number, and none changes: students' results hold them.
        says: completes "This is what you get …".
        why: why it is wrong, in one to three sentences.
        unnoticed: where it happens to be right.
        wrong: the wrong formula.
        line: the wrong line as a student types it, with the names of the numbers that
            `practice.example` gives; several make up the whole answer. It is typed, as SymPy's
            NumPy printer knows no such names and no arrays: a test runs it in the numbers of the
            first exercise with an `example`, and what its last new name holds must be the answer
            that this exercise has for the mistake in `wrong`.
        picture: what then happens. Every mistake of the course has one.
        document, place, nth: the source document that has it, where, and which of its errata this
            is, counted from its start; empty, as what follows, for one that is only likely.
        stands, should: what stands there and what should, with what changes in « ».
        explained: why, in the letters of the document, where those of `why` are others.
    """

    name: str
    says: str
    why: str
    unnoticed: str
    wrong: Wrong
    line: str
    picture: Picture | None = None
    document: str = ""
    place: str = ""
    nth: int = 0
    stands: str = ""
    should: str = ""
    explained: str = ""

    def substitute(self, values: Mapping[Any, Any]) -> Any:
        """What the mistake makes, as an expression: for a figure that shows what happens then."""
        return self.wrong.substitute(values)


@dataclass(frozen=True)
class Given:
    """A number of the text that is drawn: its options as shown, and their unit."""

    options: tuple[Any, ...]
    unit: str = ""

    def __post_init__(self) -> None:
        refuse_unknown(self.unit, f"the number drawn from {describe(self.options)}")

    def value(self, option: Any) -> Any:
        """The SI number that formulas get; what is no number stays as it is."""
        return UNITS[self.unit].to_si(option) if isinstance(option, int | float) else option

    def option(self, value: Any) -> Any:
        """The number as the reader sees it, from its SI number."""
        if not isinstance(value, int | float):
            return value
        return float(f"{UNITS[self.unit].from_si(value):.9g}")

    def shown(self, option: Any) -> str:
        """As the reader sees it: "30 cm", "−45°"."""
        text = number_text(option, "") if isinstance(option, int | float) else str(option)
        return with_unit(text, self.unit)


def steps(low: float, high: float, step: float, unit: str = "") -> Given:
    """The round numbers from low to high, both included."""
    count = round((high - low) / step)
    numbers = [float(f"{low + k * step:.9g}") for k in range(count + 1)]
    return Given(tuple(int(n) if n.is_integer() else n for n in numbers), unit)


def one_of(*options: Any, unit: str = "") -> Given:
    """Some numbers or names."""
    return Given(options, unit)


@dataclass(frozen=True)
class Ask:
    """One number that is asked for.

    How far off an answer may be follows from its unit, and is a thousandth of a large one; the
    words on decimals follow from that.

    Args:
        label: its letter or name.
        unit: SI; an answer that is typed with another unit of this size is converted.
        circle: whether it is an angle, compared up to whole turns.
        tolerance, reason: how far off an answer may be instead, in the unit, and why.
        relative: the same as a part of the answer.
    """

    label: str
    unit: str = ""
    circle: bool = False
    tolerance: float = -1.0
    reason: str = ""
    relative: float = 0.0

    def __post_init__(self) -> None:
        refuse_other_than_si(self.unit, f"the answer {self.label}")
        if (self.tolerance < 0) == bool(self.reason):
            raise CourseError(f"{self.label}: a tolerance and its reason come together")
        if self.tolerance < 0:
            unit = UNITS[self.unit]
            object.__setattr__(self, "tolerance", unit.tolerance)
            object.__setattr__(self, "reason", unit.reason)
            object.__setattr__(self, "relative", 0.0 if self.circle else RELATIVE)

    def allowed(self, value: float, factor: float = 1.0) -> float:
        """How far off an answer may be from a value in a unit of this size."""
        return max(self.tolerance * abs(factor), self.relative * abs(value))

    @property
    def decimals(self) -> int:
        """How many decimals are always enough: half of the last one is within the tolerance."""
        exact = self.tolerance < 1e-6  # a whole number
        return 0 if exact else math.ceil(-math.log10(2 * self.tolerance))


def angle(label: str) -> Ask:
    """An angle, right up to whole turns, as all that an exercise asks in rad."""
    return Ask(label, "rad", circle=True)


def whole(label: str) -> Ask:
    """A whole number."""
    return Ask(label, tolerance=1e-9, reason="a whole number, exactly")


def matrix(name: str, rows: int, columns: int) -> tuple[Ask, ...]:
    """The entries of a matrix, row by row."""
    return tuple(Ask(f"{name}[{i}, {j}]") for i in range(rows) for j in range(columns))


@dataclass(frozen=True, eq=False)
class Exercise:
    """One exercise with numbers left open, in a chapter's `exercises.py`.

    It appears by itself on the page of all exercises and in the teacher's tables. A chapter shows
    it by `practice.exercise("bicycle-1")`, and the numbers of its example by `practice.example`, in
    cells tagged `remove-input`.

    Args:
        name: stem of the topic and a number.
        level: 1 one step, 2 several, 3 hard.
        title: of its box.
        text: Markdown-free text with `{placeholders}`: numbers of `given`, what `derive` adds, and
            `{right}`; `{x:deg}` shows degrees, `{x:.2f}` a format; "v_L" becomes a symbol; an empty
            line starts a paragraph.
        given: name → how it is drawn.
        asks: the numbers asked for, in order.
        right: function of the numbers → the answer, shape (n,) or `shape`.
        wrong: mistake → function → the answer of somebody who makes it; `{}` if there is none.
        solution: the way there, with such placeholders.
        also: as `wrong` for what is no documented mistake, as words that end "This is what you get
            …"; where it gives what a mistake gives, both are said.
        shape: of a matrix that is asked for.
        accept: which rows of `right` must be typed: "one", its only row; "any" one of them, where
            several answers are right; or "all" of them, in any order.
        derive: function of the numbers → others, for the text.
        when: function of the numbers → whether they may be dealt.
        example: numbers in SI that are the same for all, where the chapter shows the mistakes.
    """

    name: str
    level: int
    title: str
    text: str
    given: Mapping[str, Given]
    asks: tuple[Ask, ...]
    right: Callable[..., ArrayLike]
    wrong: Mapping[Mistake, Callable[..., ArrayLike]]
    solution: Solution
    also: Mapping[str, Callable[..., ArrayLike]] = field(default_factory=dict)
    shape: tuple[int, ...] = ()
    accept: str = "one"
    derive: Callable[..., Mapping[str, Any]] = field(default=lambda **_: {})
    when: Callable[..., bool] = field(default=lambda **_: True)
    example: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        twice = set(self.solution.steps) & set(self.given)
        if twice:
            raise CourseError(
                f"{self.name} has numbers and steps of its solution of one name: {', '.join(twice)}"
            )
        for formula in (self.right, *self.wrong.values(), *self.also.values()):
            try:
                signature(formula).bind(**dict.fromkeys(self.given))
            except TypeError as error:
                raise CourseError(
                    f"{self.name} gives {', '.join(self.given)}, but one of its formulas takes "
                    f"{signature(formula)}: {error}"
                ) from error
        if self.accept not in ("one", "any", "all"):
            raise CourseError(f"{self.name}: accept must be one, any or all, got {self.accept!r}")
        if self.shape and math.prod(self.shape) != len(self.asks):
            raise CourseError(f"{self.name} asks {len(self.asks)} numbers in shape {self.shape}")

    @property
    def topic(self) -> str:
        """The stem of module, chapter and test: "differential_drive"."""
        return self.name.rsplit("-", 1)[0].replace("-", "_")

    @cached_property
    def solution_text(self) -> str:
        """The worked solution with placeholders for all that depends on the numbers."""
        return self.solution.template(PLACEHOLDER)

    def answers(self, formula: Callable[..., ArrayLike], numbers: Mapping[str, Any]) -> Answers:
        """What a formula gives for these numbers, as rows (k, n); one row unless several count."""
        found = np.asarray(formula(**numbers), dtype=float)
        return found.reshape(-1, len(self.asks))

    def filled(self, template: str, numbers: Mapping[str, Any], shown: Mapping[str, str]) -> str:
        """A text of the exercise with these numbers put in. shown: the drawn ones as text."""
        found = self.placeholders(template, numbers, shown)
        return re.sub(PLACEHOLDER, lambda match: found[match[1]], template)

    def placeholders(
        self, template: str, numbers: Mapping[str, Any], shown: Mapping[str, str]
    ) -> dict[str, str]:
        """Each placeholder of a text and what stands for it."""
        values = {**numbers, **self.derive(**numbers)}
        found = {}
        keys = dict.fromkeys(re.findall(PLACEHOLDER, template))
        said = {key.partition(":")[0].partition(".")[0] for key in keys} & set(self.solution.steps)
        steps = self.solution.worked(values, shown) if said else {}
        for key in keys:
            name, _, spec = key.partition(":")
            step, _, part = name.partition(".")
            if step in steps:
                found[key] = steps[step].shown(part, spec)
            elif key == "right":
                found[key] = self.answer_text(numbers)
            elif key in shown:
                found[key] = shown[key]
            elif name in values:
                found[key] = number_text(values[name], spec)
            else:
                raise CourseError(f"{self.name} has {{{key}}}, but only {', '.join(values)}")
        return found

    def answer_text(
        self, numbers: Mapping[str, Any], formula: Callable[..., ArrayLike] | None = None
    ) -> str:
        """The right answer, or a formula's, as typed."""
        return self.rows_text(self.answers(formula or self.right, numbers))

    def rows_text(self, rows: ArrayLike) -> str:
        """Answers as typed, with their unit where all have the same."""
        rows = np.asarray(rows)
        shaped = [row.reshape(self.shape) if self.shape else row for row in rows]
        units = {ask.unit for ask in self.asks}
        unit = units.pop() if len(units) == 1 else ""
        texts = [number_text(row if len(row) > 1 else float(row[0]), "") for row in shaped]
        joint = " or " if self.accept == "any" else "; "
        return joint.join(with_unit(text, unit) for text in dict.fromkeys(texts))


PLACEHOLDER = r"{([\w.:]+)}"


def exercises() -> dict[str, Exercise]:
    """Every exercise of the course, by name, in the course's order."""
    for name, chapter in course().homes("exercises", Exercise).items():
        stem = chapter.replace("_", "-")
        if name.rpartition("-")[0] != stem:
            raise CourseError(
                f"an exercise in the folder {chapter} is named {stem}-1, {stem}-2, …; got {name}"
            )
    return course().declared("exercises", Exercise)


def mistakes() -> dict[str, Mistake]:
    """Every mistake of the course, by name."""
    return course().declared("exercises", Mistake)


def topics() -> list[str]:
    """The chapters that have exercises, in the course's order."""
    return list(dict.fromkeys(exercise.topic for exercise in exercises().values()))


def default_salt() -> str:
    """The name that the site's settings give the course, or its own."""
    return str(course().settings.get("course_name") or course().name)
