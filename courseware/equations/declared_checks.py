"""The comparison of each formula with a function, declared in a chapter's `checks.py`.

Where a function of the library takes or returns something else than the formula does, a few lines
beside the check adapt it. The page of checks prints the first line of their docstring.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from courseware.course import course
from courseware.equations.equation import Equation, free_symbols
from courseware.equations.quantities import refuse_namesakes, sort_symbols
from courseware.errors import CourseError

Array = NDArray[np.float64]
SAMPLES = 100  # points at which a test compares, beside special ones


@dataclass(frozen=True, eq=False)
class Check:
    """The comparison of one formula with code, in the tuple `CHECKS` of a chapter's `checks.py`.

    A test turns signs and swaps sines in every formula: a check that does not notice fails.

    Args:
        equation: the formula.
        function, arguments, component: `function(*arguments)[..., component]` must agree with the
            right side. Arguments are expressions, or tuples of them, stacked on the last axis; all
            symbols of the formula are in them. The function is the library's, or adapts it.
        tolerance: the largest difference allowed, absolute in the unit of the left side.
        reason: why the tolerance has its size.
        specials: points that are always compared; symbols that they leave out are drawn.
        ranges: for symbols whose own range is too wide, the range that they are drawn from.
        integers: symbols that are integers.
    """

    equation: Equation
    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    tolerance: float
    reason: str
    component: int | None = None
    specials: tuple[Mapping[sp.Symbol, float], ...] = ()
    ranges: Mapping[sp.Symbol, tuple[float, float]] = field(default_factory=dict)
    integers: tuple[sp.Symbol, ...] = ()

    def __post_init__(self) -> None:
        refuse_namesakes(self.symbols, f"the check of {self.name}")

    @property
    def name(self) -> str:
        return self.equation.name

    @property
    def symbols(self) -> list[sp.Symbol]:
        """The symbols of the formula and the arguments, sorted."""
        return sort_symbols({*self.equation.symbols, *free_symbols(self.arguments)})


def declared_checks() -> dict[str, Check]:
    """Return the check of every formula by the formula's name; refuse a formula without one."""
    homes, checks = course().chapters_of("formulas", Equation), course().find_all("checks", Check)
    for name, chapter in homes.items():
        if name not in checks:
            place = course().folder / chapter / "checks.py"
            raise CourseError(f"{name} has no check: add one of it to CHECKS in {place}")
    return {name: checks[name] for name in homes}
