"""What an equation is: declared once, then printed, checked and drawn from.

A quantity is a SymPy symbol with its unit, range and meaning; it belongs to the module that
declares it. An equation holds its two sides. Sides are written inside `with as_written():`, so
that SymPy keeps (v_R + v_L)/2 as it stands.
"""

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from workshop.course import course, held
from workshop.errors import CourseError

# Named steps on the way to a result, in order: each may use those before it.
Where = Sequence[tuple[sp.Symbol, Any]]


class NamedSymbol(sp.Symbol):  # type: ignore[misc]
    """A symbol with its unit (SI), the range it is tested in, what it means, how it prints.

    Two symbols of one name are different if two modules declare them.
    """

    unit: str
    low: float
    high: float
    meaning: str
    latex: str
    module: str
    line: int

    @property
    def place(self) -> str:
        """Where it is declared."""
        return f"{self.module}, line {self.line}"

    def _hashable_content(self) -> tuple[Any, ...]:
        return (*super()._hashable_content(), self.module)

    def _latex(self, printer: Any) -> str:
        return self.latex


def as_written() -> Any:
    """A `with` block in which SymPy leaves expressions as they are typed."""
    return sp.evaluate(False)


def quantity(
    name: str, unit: str, low: float, high: float, meaning: str, latex: str = ""
) -> sp.Symbol:
    """Declare a symbol: its name in code, unit, the range it is tested in, what it means."""
    symbol = NamedSymbol.__xnew__(NamedSymbol, name, real=True)  # not SymPy's own of that name
    symbol.unit, symbol.low, symbol.high, symbol.meaning = unit, low, high, meaning
    symbol.latex = latex or sp.latex(sp.Symbol(name))
    caller = sys._getframe(1)
    symbol.module, symbol.line = caller.f_globals["__name__"], caller.f_lineno
    return symbol


def quantities(parts: Sequence[str] = ("formulas", "figures")) -> list[NamedSymbol]:
    """All quantities that the course declares, each once, in the course's order."""
    modules = [module for part in parts for module in course().modules(part).values()]
    return list(dict.fromkeys(s for module in modules for s in held(module, NamedSymbol)))


def refuse_namesakes(symbols: Iterable[sp.Symbol], who: str) -> None:
    """Two different symbols of one name in one thing are a mistake: say where both stand."""
    known: dict[str, sp.Symbol] = {}
    for symbol in symbols:
        other = known.setdefault(str(symbol), symbol)
        if other != symbol:
            places = " and ".join(
                getattr(s, "place", "a plain SymPy symbol") for s in (other, symbol)
            )
            raise CourseError(
                f"{who} uses two different symbols {symbol}: {places}; use one of them"
            )


@dataclass(frozen=True, eq=False)
class Equation:
    """One formula of the course.

    name: `module.what`, where module is the one that computes it.
    left, right: the two sides, scalar or column; the right one in the form that keeps its digits.
    textbook: the right side as books print it, where that reads better; proved equal, only shown.
    function, arguments, component: `function(*arguments)[..., component]` must agree with `right`;
    arguments are expressions (or tuples of them, stacked on the last axis).
    checked_by: for an identity that no function computes, the test that holds it.
    tolerance, reason: the largest difference allowed, absolute in the unit of `left`, and why.
    where: named steps that the right side is written in, each a symbol and what it stands for.
    specials: settings that are always checked too; what they leave out is drawn from the range.
    """

    name: str
    left: Any
    right: Any
    source: str
    tolerance: float
    reason: str
    function: Callable[..., Any] | None = None
    arguments: tuple[Any, ...] = ()
    component: int | None = None
    checked_by: str = ""
    textbook: Any = None
    specials: tuple[Mapping[sp.Symbol, float], ...] = ()
    where: Where = ()
    ranges: Mapping[sp.Symbol, tuple[float, float]] = field(default_factory=dict)
    is_angle: bool = False

    def __post_init__(self) -> None:
        if (self.function is None) == (not self.checked_by):
            raise CourseError(f"{self.name} must name a function or a test, one of the two")
        unknown = [s for s in self.symbols if not isinstance(s, NamedSymbol)]
        if unknown:
            names = ", ".join(map(str, unknown))
            raise CourseError(f"{self.name} uses {names}, which no `quantity(…)` declares")
        refuse_namesakes(self.symbols, self.name)
        if self.function is not None:
            self._refuse("right", set(self.symbols) - free_symbols(self.arguments), "arguments")
        for special in self.specials:
            self._refuse("specials", set(special) - set(self.symbols), "right nor arguments")

    def _refuse(self, part: str, extra: set[sp.Symbol], of: str) -> None:
        if extra:
            names = ", ".join(sorted(map(str, extra)))
            raise CourseError(f"{self.name} has {names} in `{part}`, but not in its {of}")

    @property
    def symbols(self) -> list[sp.Symbol]:
        """The symbols of the right side and the arguments, in alphabetical order."""
        steps = [expression for _, expression in self.where]
        parts = (self.right, *self.arguments, *steps)
        free = {s for part in parts for s in free_symbols(part)}
        return sorted(free - {symbol for symbol, _ in self.where}, key=str)

    def at(self, values: Mapping[sp.Symbol, Any]) -> Any:
        """The right side with expressions put in for its symbols, otherwise as written."""
        return put_in(self.right, values)

    def _repr_mimebundle_(self, **_: Any) -> dict[str, Any]:
        from workshop.equations.printing import mimebundle

        return mimebundle(self)


def free_symbols(part: Any) -> set[sp.Symbol]:
    """The symbols in an expression, a matrix, a number or a nested tuple of them."""
    if isinstance(part, tuple):
        return set().union(*(free_symbols(p) for p in part))
    return set(sp.sympify(part).free_symbols)


def put_in(expression: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    """Replace symbols in an expression or matrix and leave its form alone."""
    replacements = {symbol: sp.sympify(value) for symbol, value in values.items()}
    with as_written():
        return expression.xreplace(replacements)


def declared() -> dict[str, Equation]:
    """Every formula of the course, by name."""
    return course().declared("formulas", Equation)


def find(name: str) -> Equation:
    """The equation of that name."""
    if name not in declared():
        known = ", ".join(sorted(declared()))
        raise CourseError(f"there is no equation {name!r}; there are {known}")
    return declared()[name]
