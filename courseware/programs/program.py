"""How a program exercise is declared: once, to be shown, judged and handed to graders."""

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from courseware.answers import Unknown
from courseware.course import course, topic_of
from courseware.equations.quantities import NamedSymbol
from courseware.practice.mistakes import Mistake

Function = Callable[..., Any]


@dataclass(frozen=True, eq=False)
class Program:
    """A function that students write, in a chapter's `programs.py`.

    The functions below take the arguments of the student's function, in its order. An answer that
    is right in several ways is judged by what it does.

    Args:
        name: stem of the topic, "p" and a number: "bicycle-p1".
        title: of its box.
        text: what the function has to do, free of Markdown.
        starter: the code that the student begins with; in it one function is defined. One with a
            mistake in it is to be mended.
        symbols: what inputs are drawn for: each has a range and a unit.
        answer: the numbers of the answer, row by row.
        right: function → the right answer.
        solution: code as a student may write it.
        arguments: function of the symbols' numbers → the arguments, if they are not these numbers.
        ranges: symbol → its range here, where its own is too wide.
        when: function → whether an input may be drawn.
        specials: words → symbol → its number in a special case: "straight ahead": {phi: 0}.
        wrong: mistake → function → the answer of somebody who makes it.
        likely_slips: likewise for mistakes without a number, as words that end "This is what you
            get …".
        compared_value: where several answers are right, function of an answer and the arguments,
            as arrays of symbols → what is compared instead.
        shape: of a matrix.
        picture: function of the right answer, the student's, and the arguments, all as arrays of
            symbols → the shapes and sprites of the picture that shows both.
        extent: how far a thing in it reaches from its place, in its own metres.
        hints: the first says least.
    """

    name: str
    title: str
    text: str
    starter: str
    symbols: tuple[NamedSymbol, ...]
    answer: tuple[Unknown, ...]
    right: Function
    picture: Function
    extent: float
    solution: str
    hints: tuple[str, ...]
    arguments: Function = field(default=lambda *numbers: numbers)
    ranges: Mapping[NamedSymbol, tuple[float, float]] = field(default_factory=dict)
    when: Callable[..., bool] = field(default=lambda *_: True)
    specials: Mapping[str, Mapping[NamedSymbol, float]] = field(default_factory=dict)
    wrong: Mapping[Mistake, Function] = field(default_factory=dict)
    likely_slips: Mapping[str, Function] = field(default_factory=dict)
    compared_value: Function | None = None
    shape: tuple[int, ...] = ()

    @property
    def topic(self) -> str:
        """The stem of the chapter: "differential_drive"."""
        return topic_of(self.name)

    @cached_property
    def definition(self) -> ast.FunctionDef:
        """The student's function as the starter defines it."""
        (found,) = (n for n in ast.parse(self.starter).body if isinstance(n, ast.FunctionDef))
        return found

    @property
    def is_new(self) -> bool:
        """Whether the function is to be written, not to be mended."""
        return ast.unparse(self.definition.body[-1]) == "..."


def all_programs() -> dict[str, Program]:
    """Return every program by name, in the course's order."""
    return course().find_all("programs", Program)


def find_program(name: str) -> Program:
    return course().find("programs", Program, name)
