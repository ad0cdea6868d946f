"""What an equation is: declared once, then printed, checked and drawn from.

A quantity is a SymPy symbol with its unit, range and meaning; it belongs to the module that
declares it. A sign is the same without a range: what formulas name on the way, or only the text
uses. An equation holds its two sides. Sides are written inside `with as_written():`, so
that SymPy keeps (v_R + v_L)/2 as it stands.
"""

import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from courseware.course import course
from courseware.equations.rendering import AGAIN, COMPUTED, both_sides, mimebundle, name_on_page
from courseware.errors import CourseError
from courseware.units import refuse_other_than_si

# Named steps on the way to a result, in order: each may use those before it.
Where = Sequence[tuple[sp.Symbol, Any]]


class NamedSymbol(sp.Symbol):  # type: ignore[misc]
    """A symbol with its unit (SI), the range it is tested in, what it means, how it prints, and
    its name in the code of the chapter's notebook.

    One without a range (`low` is NaN) is a sign: no formula is computed from it alone.

    Two symbols of one name are different if two modules declare them.
    """

    unit: str
    low: float
    high: float
    meaning: str
    latex: str
    code: str
    module: str
    line: int

    @property
    def is_sign(self) -> bool:
        """Whether it has no range."""
        return math.isnan(self.low)

    @property
    def called(self) -> str:
        """Its name: what stands before a colon in its meaning."""
        name, colon, _ = self.meaning.partition(": ")
        return name if colon else ""

    @property
    def chapter(self) -> str:
        """The chapter that declares it."""
        return self.module.split(".")[-2:][0]

    @property
    def key(self) -> str:
        """What every face of it on a page carries as `data-symbol`."""
        return f"{self.chapter}.{self.name}"

    @property
    def place(self) -> str:
        """Where it is declared."""
        return f"{self.module}, line {self.line}"

    def _hashable_content(self) -> tuple[Any, ...]:
        return (*super()._hashable_content(), self.module)

    def _latex(self, printer: Any) -> str:
        return self.latex


def as_written() -> Any:
    """A `with` block in which SymPy leaves expressions as they are typed.

    They print with their parentheses, and are computed in the order in which they are typed:
    a + (b − c) is another sum than a + b − c. What is added up from a list is `sympy.Add(*terms)`.
    """
    return sp.evaluate(False)


def quantity(
    name: str,
    unit: str,
    low: float,
    high: float,
    meaning: str,
    latex: str = "",
    code: str = "",
) -> NamedSymbol:
    """Declare a symbol, which belongs to the chapter that declares it.

    A chapter gives one letter to one symbol, and declares every letter that it prints: so it stands
    on the page of notation, and its letters, sliders, readouts and names in code light up together.
    `LOOKS = {v_L: "left"}` in `formulas.py` gives a quantity the look of a kind of thing.

    Args:
        name: as SymPy's; Greek letters are spelled.
        unit: SI, from the table in `courseware/units.py`.
        low, high: the range that points are drawn from, to hold its formulas to the library.
        meaning: in a few words; a name may stand first, before a colon: "heading: …".
        latex: how it prints, where SymPy's own way will not do.
        code: its name in the code of the chapter's notebook, where that is another one.
    """
    return _named(name, unit, (low, high), meaning, latex, code)


def sign(name: str, meaning: str, latex: str = "", unit: str = "", code: str = "") -> NamedSymbol:
    """Declare what is printed and never given a number by itself: a step, a matrix, a point."""
    return _named(name, unit, (math.nan, math.nan), meaning, latex, code)


def _named(
    name: str, unit: str, span: tuple[float, float], meaning: str, latex: str, code: str
) -> NamedSymbol:
    refuse_other_than_si(unit, f"the symbol {name}")
    symbol: NamedSymbol = NamedSymbol.__xnew__(
        NamedSymbol, name, real=True
    )  # not SymPy's own of that name
    symbol.unit, symbol.meaning, (symbol.low, symbol.high) = unit, meaning, map(float, span)
    symbol.latex, symbol.code = latex or sp.latex(sp.Symbol(name)), code or name
    caller = sys._getframe(2)
    symbol.module, symbol.line = caller.f_globals["__name__"], caller.f_lineno
    return symbol


def look(symbol: NamedSymbol, chapter: str = "") -> str:
    """The kind of a quantity's look, or "": as `LOOKS` says in the formulas of a chapter that uses
    it, else in those of its own.
    """
    for where in (chapter, symbol.chapter):
        known = where in course().chapters  # the machine has symbols of its own
        kinds = getattr(known and course().module(where, "formulas"), "LOOKS", {})
        if symbol in kinds:
            return refuse_unknown_kind(kinds[symbol])
    return ""


def refuse_unknown_kind(kind: str) -> str:
    """The kind, if the course has a look for it."""
    if kind not in course().looks:
        raise CourseError(f"there is no kind {kind!r}; there are {', '.join(course().looks)}")
    return kind


def place(symbol: sp.Symbol) -> str:
    """Where a symbol is declared, for an error."""
    return getattr(symbol, "place", "a plain SymPy symbol")


def in_order(symbols: Iterable[sp.Symbol]) -> list[sp.Symbol]:
    """By name; those of one name by the place where they are declared."""
    return sorted(symbols, key=lambda symbol: (str(symbol), place(symbol)))


def describe_symbols(symbols: Iterable[sp.Symbol], beside: Iterable[Any]) -> str:
    """The names of symbols for an error; of those with a namesake `beside`, the place, too."""
    names = set(map(str, beside))
    return ", ".join(f"{s} ({place(s)})" if str(s) in names else str(s) for s in symbols)


def refuse_namesakes(symbols: Iterable[sp.Symbol], who: str) -> None:
    """Two different symbols of one name in one thing are a mistake: say where both stand."""
    known: dict[str, sp.Symbol] = {}
    for symbol in symbols:
        other = known.setdefault(str(symbol), symbol)
        if other != symbol:
            raise CourseError(
                f"{who} uses two different symbols {symbol}: {place(other)} and {place(symbol)}; "
                "use one of them"
            )


@dataclass(frozen=True, eq=False)
class Equation:
    """One formula of the course, in a chapter's `formulas.py`; a `Check` holds it to the library.

    It is written inside `with as_written():`, so that SymPy keeps the form that is typed. A
    singular case gets its own branch, by SymPy's `Piecewise`.

    Args:
        name: `chapter.what`, with the chapter that declares it.
        left, right: the two sides, scalar or column; the right one in the form that keeps digits.
        source: where it comes from.
        textbook: the right side as books print it, where that reads better; a test proves the two
            equal, and this one is shown.
        where: named steps that the right side is written in, each a symbol and what it stands for.
        is_angle: its values are angles, and one turn more is the same angle.
    """

    name: str
    left: Any
    right: Any
    source: str
    textbook: Any = None
    where: Where = ()
    is_angle: bool = False

    def __post_init__(self) -> None:
        unknown = [s for s in self.symbols if getattr(s, "is_sign", True)]
        if unknown:
            names = ", ".join(map(str, unknown))
            raise CourseError(f"{self.name} uses {names}, which no `quantity(…)` declares")
        refuse_namesakes(self.symbols, self.name)

    @property
    def symbols(self) -> list[sp.Symbol]:
        """The symbols of the right side and its named steps, in alphabetical order."""
        parts = (self.right, *(expression for _, expression in self.where))
        free = {s for part in parts for s in free_symbols(part)}
        return in_order(free - {symbol for symbol, _ in self.where})

    def substitute(self, values: Mapping[sp.Symbol, Any]) -> Any:
        """The right side with expressions put in for its symbols, otherwise as written."""
        return substitute(self.right, values)

    def printed(self, computed: bool = False) -> Any:
        """The right side that is shown: the textbook's where there is one, unless `computed`."""
        return self.right if computed or self.textbook is None else self.textbook

    def latex(self, computed: bool = False) -> str:
        """Left side = right side."""
        return both_sides(self.left, self.printed(computed))


@dataclass(frozen=True)
class Output:
    """What a notebook cell shows, by MIME type."""

    data: Mapping[str, Any]

    def _repr_mimebundle_(self, **_: Any) -> Mapping[str, Any]:
        return self.data


def free_symbols(part: Any) -> set[sp.Symbol]:
    """The symbols in an expression, a matrix, a number or a nested tuple of them."""
    if isinstance(part, tuple):
        return set().union(*(free_symbols(p) for p in part))
    return set(sp.sympify(part).free_symbols)


def substitute(expression: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    """Replace symbols in an expression or matrix and leave its form alone."""
    replacements = {symbol: sp.sympify(value) for symbol, value in values.items()}
    with as_written():
        return expression.xreplace(replacements)


def declared() -> dict[str, Equation]:
    """Every formula of the course, by name."""
    return course().declared("formulas", Equation)


def find_equation(name: str) -> Equation:
    """The equation of that name."""
    return course().find("formulas", Equation, name)


_shown: dict[str, None] = {}  # what this notebook has shown, in order: `again` shows it all


def show(name: str, computed: bool = False, figure: str = "") -> Output:
    """Show an equation, in a cell of its own that is tagged `remove-input`.

    The text refers to it with ``{eq}`differential_drive.speed```. A formula typed by hand is
    refused by a test, except in cells tagged `definition`, `derivation` or `mistake`.

    Args:
        name: of the equation.
        computed: in the form that the code uses, where a textbook's form is shown otherwise.
        figure: a live figure whose numbers then stand below the formula and follow the hand. Each
            symbol of the formula needs a slider, a readout or a named step in it, its left side a
            readout.
    """
    equation = find_equation(name)
    right = equation.printed(computed)
    _shown.setdefault(name_on_page(name, computed))
    return Output(mimebundle(name, computed, equation.left, right, figure))


def again(*below: str) -> Output:
    """Show once more, in a box, all equations that the notebook has shown.

    below: names of those that it shows further below; "…-computed" as the code uses it.
    """
    labels = (*_shown, *below)
    formulas = [labelled(label).latex(label.endswith(COMPUTED)) for label in labels]
    return Output(
        {
            AGAIN: {"labels": labels},
            "text/latex": "\n\n".join(f"$$ {formula} $$" for formula in formulas),
            "text/plain": "Again: " + ", ".join(labels),
        }
    )


def labelled(label: str) -> Equation:
    """The equation of a label on a page."""
    return find_equation(label.removesuffix(COMPUTED))
