"""How a formula is held to the library: a `Check` for each, in a chapter's `checks.py`.

A check names the function that must agree with the formula. Where a function of the library takes
or gives something else than the formula does, a few lines beside the check put its arguments and
answers in order; their docstring says how, and the page of checks prints it.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import sympy as sp

from courseware.course import course
from courseware.equations.core import (
    Equation,
    declared,
    describe_symbols,
    free_symbols,
    in_order,
    refuse_namesakes,
)
from courseware.errors import CourseError


@dataclass(frozen=True, eq=False)
class Check:
    """How one formula is held to the library, in the tuple `CHECKS` of a chapter's `checks.py`.

    A test turns signs and swaps sines in every formula: a check that does not notice fails.

    Args:
        equation: the formula.
        reason: why the tolerance is what it is.
        tolerance: the largest difference allowed, absolute in the unit of the left side.
        function, arguments, component: `function(*arguments)[..., component]` must agree with the
            right side. Arguments are expressions, or tuples of them, stacked on the last axis; all
            symbols of the formula are in them. The function is the library's, or a few lines beside
            the check that put its arguments and answers in order; the page of checks prints the
            first line of their docstring.
        compared_with: what computes, in words, where that is not the library.
        checked_by: for a formula that no function computes, the test that holds it, instead.
        specials: settings that are always checked too; what they leave out is drawn.
        ranges: where points are drawn from, for symbols whose own range is too wide.
        whole: symbols that are whole numbers only.
    """

    equation: Equation
    reason: str
    tolerance: float = 0.0
    function: Callable[..., Any] | None = None
    arguments: tuple[Any, ...] = ()
    component: int | None = None
    compared_with: str = ""
    checked_by: str = ""
    specials: tuple[Mapping[sp.Symbol, float], ...] = ()
    ranges: Mapping[sp.Symbol, tuple[float, float]] = field(default_factory=dict)
    whole: tuple[sp.Symbol, ...] = ()

    def __post_init__(self) -> None:
        if (self.function is None) == (not self.checked_by):
            raise CourseError(
                f"the check of {self.name} must name a function or a test, one of two"
            )
        if not self.reason or (self.function is not None) != (self.tolerance > 0):
            raise CourseError(
                f"the check of {self.name} needs a `reason`, and a `tolerance` above 0 if it names "
                "a function"
            )
        refuse_namesakes(self.symbols, f"the check of {self.name}")
        if self.function is not None:
            given = free_symbols(self.arguments)
            self._refuse("is in the formula", self.equation.symbols, given, "`arguments`")
        special = {symbol for setting in self.specials for symbol in setting}
        for what, some in {"specials": special, "ranges": self.ranges, "whole": self.whole}.items():
            self._refuse(f"is in `{what}`", some, self.symbols, "the formula and `arguments`")

    def _refuse(self, where: str, some: Any, allowed: Any, of: str) -> None:
        extra = in_order(s for s in some if s not in allowed)
        if extra:
            raise CourseError(
                f"the check of {self.name}: {describe_symbols(extra, allowed)} {where}, but not "
                f"in {of}, which have {describe_symbols(in_order(allowed), extra)}"
            )

    @property
    def name(self) -> str:
        """The formula's name."""
        return self.equation.name

    @property
    def symbols(self) -> list[sp.Symbol]:
        """The symbols of the formula and the arguments, in alphabetical order."""
        return in_order({*self.equation.symbols, *free_symbols(self.arguments)})

    @property
    def between(self) -> str:
        """How arguments and answers are put in order: a docstring's first line; '' if they fit."""
        called = self.function.func if isinstance(self.function, partial) else self.function
        if getattr(called, "__module__", None) in {None, "numpy", *course().library_modules}:
            return ""
        return (called.__doc__ or "").partition("\n")[0].strip()


def declared_checks() -> dict[str, Check]:
    """The check of every formula, by the formula's name; a formula without one is an error."""
    formulas, checks = declared(), course().declared("checks", Check)
    for name, check in checks.items():
        if formulas.get(name) is not check.equation:
            raise CourseError(
                f"there is a check of {name}, but no formula: declare it in a formulas.py of "
                f"{course().package}, or remove the check"
            )
    for name, equation in formulas.items():
        if name not in checks:
            raise CourseError(_missing(equation))
    return {name: checks[name] for name in formulas}


def _missing(equation: Equation) -> str:
    """What to write for a formula without a check, and where."""
    chapter = course().homes("formulas", Equation)[equation.name]
    names = vars(course().modules("formulas")[chapter]).items()
    variable = next((name for name, value in names if value is equation), "…")
    line = f"Check(formulas.{variable}, function=…, arguments=…, tolerance=…, reason=…)"
    place = course().folder / chapter / "checks.py"
    return f"{equation.name} has no check: add `{line}` to CHECKS in {place}"
