"""Equations: declared once, then printed, tested and drawn from.

The two sides are written inside `with as_written():`, so that SymPy keeps (v_R + v_L)/2 as typed.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import sympy as sp

from courseware.course import course
from courseware.equations.latex import render_equation
from courseware.equations.quantities import refuse_namesakes, sort_symbols
from courseware.errors import CourseError

Where = Sequence[tuple[sp.Symbol, Any]]  # named steps in order: each may use those before it


def as_written() -> Any:
    """Return a `with` block in which SymPy leaves expressions as they are typed.

    They print with their parentheses, and are computed in the order in which they are typed:
    a + (b − c) is another sum than a + b − c. For a list of terms write `sympy.Add(*terms)`.
    """
    return sp.evaluate(False)


@dataclass(frozen=True, eq=False)
class Equation:
    """One formula of the course, in a chapter's `formulas.py`; a `Check` compares it with code.

    It is written inside `with as_written():`. A singular case gets its own branch, by SymPy's
    `Piecewise`.

    Args:
        name: `chapter.what`, with the chapter that declares it.
        left, right: the two sides, scalar or column; the right one in the form that keeps digits.
        textbook: the right side as books print it, where that reads better; a test proves the two
            equal, and this one is shown.
        where: named steps that the right side is written in, each a symbol and its expression.
        is_angle: its values are angles, and one turn more is the same angle.
    """

    name: str
    left: Any
    right: Any
    textbook: Any = None
    where: Where = ()
    is_angle: bool = False

    def __post_init__(self) -> None:
        unknown = [str(s) for s in self.symbols if not getattr(s, "has_range", False)]
        if unknown:
            raise CourseError(
                f"{self.name} uses {', '.join(unknown)}, which no `quantity(…)` declares"
            )
        refuse_namesakes(self.symbols, self.name)

    @property
    def symbols(self) -> list[sp.Symbol]:
        """The symbols of the right side and its named steps, sorted."""
        steps = dict(self.where)
        return sort_symbols(free_symbols((self.right, *steps.values())) - steps.keys())

    def substitute(self, values: Mapping[sp.Symbol, Any]) -> Any:
        """Return the right side with expressions in place of symbols, otherwise as written."""
        return substitute(self.right, values)

    def shown_side(self, computed: bool = False) -> Any:
        """Return the right side that is shown: the textbook's, if any, unless `computed`."""
        return self.right if computed or self.textbook is None else self.textbook

    def latex(self, computed: bool = False) -> str:
        return render_equation(self.left, self.shown_side(computed))


def free_symbols(part: Any) -> set[sp.Symbol]:
    """Return the symbols in an expression, a matrix, a number or a nested tuple of them."""
    if isinstance(part, tuple):
        return set().union(*(free_symbols(p) for p in part))
    return set(sp.sympify(part).free_symbols)


def substitute(expression: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    """Replace symbols in an expression or matrix and leave its form alone.

    Whole numbers are multiplied: of −1·0 SymPy says by turns that it is even and that it is not.
    """
    replacements = {symbol: sp.sympify(value) for symbol, value in values.items()}
    with as_written():
        found = expression.xreplace(replacements)
        products = [m for m in found.atoms(sp.Mul) if all(k.is_Integer for k in m.args)]
        return found.xreplace({m: sp.Integer(prod(map(int, m.args))) for m in products})


def all_equations() -> dict[str, Equation]:
    return course().find_all("formulas", Equation)


def find_equation(name: str) -> Equation:
    return course().find("formulas", Equation, name)
