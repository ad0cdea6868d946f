"""Symbols with a meaning, a unit and a range: the quantities of a chapter.

A chapter gives one letter to one symbol, and declares every letter that it prints. So each is
on the page of notation, and its letters, sliders, readouts and names in code light up together.
`LOOKS = {v_L: "left"}` in `formulas.py` gives a quantity the look of a kind of thing.
"""

import math
from collections.abc import Callable, Iterable
from functools import partial
from itertools import count
from typing import Any

import sympy as sp

from courseware.course import course
from courseware.errors import CourseError
from courseware.units import refuse_other_than_si

_places = count()


class NamedSymbol(sp.Symbol):  # type: ignore[misc]
    """A symbol that a module declares; one of the same name in another module is different."""

    unit: str
    low: float
    high: float
    meaning: str
    latex: str
    code: str
    module: str
    place: int  # among all that are declared

    @property
    def has_range(self) -> bool:
        """Return whether it is a quantity, from which formulas are computed."""
        return not math.isnan(self.low)

    @property
    def short_name(self) -> str:
        """The part of its meaning before a colon, or ""."""
        name, colon, _ = self.meaning.partition(": ")
        return name if colon else ""

    @property
    def chapter(self) -> str:
        return self.module.split(".")[-2:][0]

    @property
    def key(self) -> str:
        """The value of `data-symbol` wherever it is on a page."""
        return f"{self.chapter}.{self.name}"

    def _hashable_content(self) -> tuple[Any, ...]:
        return (*super()._hashable_content(), self.module)

    def _latex(self, printer: Any) -> str:
        return self.latex


Declare = Callable[..., NamedSymbol]


def declarations(module: str) -> tuple[Declare, Declare]:
    """Return `quantity` and `symbol` for a module that gives its name.

    ::

        quantity, symbol = declarations(__name__)
        v = quantity("v", "m/s", -2, 2, "speed")
    """
    return partial(declare_quantity, module), partial(declare_symbol, module)


def declare_quantity(
    module: str,
    name: str,
    unit: str,
    low: float,
    high: float,
    meaning: str,
    latex: str = "",
    code: str = "",
) -> NamedSymbol:
    """Declare a quantity of a chapter: `quantity(name, unit, …)` in its modules.

    Args:
        module: that declares it.
        name: as SymPy's; Greek letters are spelled.
        unit: SI, from the table in `courseware/units/table.py`.
        low, high: the range of the points at which formulas are compared with the library.
        meaning: in a few words; a name may come first, before a colon: "heading: …".
        latex: how it prints, where that is not SymPy's own way.
        code: its name in the code of the chapter's notebook, where that differs.
    """
    refuse_other_than_si(unit, f"the symbol {name}")
    # past SymPy's cache, which knows symbols by name alone
    new: NamedSymbol = NamedSymbol.__xnew__(NamedSymbol, name, real=True)
    new.module, new.place, new.unit, new.meaning = module, next(_places), unit, meaning
    new.low, new.high = float(low), float(high)
    new.latex, new.code = latex or sp.latex(sp.Symbol(name)), code or name
    return new


def declare_symbol(
    module: str, name: str, meaning: str, latex: str = "", unit: str = "", code: str = ""
) -> NamedSymbol:
    """Declare a symbol without a range: a named step, a matrix, a point, a letter in the text."""
    return declare_quantity(module, name, unit, math.nan, math.nan, meaning, latex, code)


def find_kind(symbol: NamedSymbol, chapter: str = "") -> str:
    """Return the kind whose look a symbol has in a chapter, or "".

    `LOOKS` of that chapter comes first, then `LOOKS` of the chapter that declares the symbol.
    """
    for user in (chapter, symbol.chapter):
        is_chapter = user in course().chapters  # figures have symbols of their own
        looks = getattr(is_chapter and course().module(user, "formulas"), "LOOKS", {})
        if symbol in looks:
            return refuse_unknown_kind(looks[symbol])
    return ""


def refuse_unknown_kind(kind: str) -> str:
    """Return the kind if the course has a look for it."""
    if kind not in course().looks:
        raise CourseError(f"there is no kind {kind!r}; there are {', '.join(course().looks)}")
    return kind


def sort_symbols(symbols: Iterable[sp.Symbol]) -> list[sp.Symbol]:
    """Sort by name, and by the place of declaration where names are the same."""
    return sorted(symbols, key=lambda symbol: (str(symbol), _location(symbol)))


def describe_symbols(symbols: Iterable[sp.Symbol], beside: Iterable[Any]) -> str:
    """List names for an error, each with its location if its name is among `beside`, too."""
    names = set(map(str, beside))
    return ", ".join(f"{s} ({_location(s)})" if str(s) in names else str(s) for s in symbols)


def refuse_namesakes(symbols: Iterable[sp.Symbol], who: str) -> None:
    known: dict[str, sp.Symbol] = {}
    for symbol in symbols:
        other = known.setdefault(str(symbol), symbol)
        if other != symbol:
            raise CourseError(
                f"{who} uses two different symbols {symbol}: {_location(other)} and "
                f"{_location(symbol)}; use one of them"
            )


def _location(symbol: sp.Symbol) -> str:
    return getattr(symbol, "module", "a plain SymPy symbol")
