"""A formula with the numbers of a figure: v = (0.10 + 0.05)/2 = 0.075 m/s.

Every number is a slot, which the script fills whenever the figure is drawn. A negative number gets
parentheses where its sign would meet another one. Angles are in degrees, as in the figure, or in
radians where they meet other quantities.
"""

from collections.abc import Mapping
from functools import cache
from html import escape
from typing import Any

import sympy as sp

from courseware.equations.equation import Equation, as_written, substitute
from courseware.equations.latex import align_lines, render_latex
from courseware.equations.quantities import NamedSymbol
from courseware.equations.text import format_symbol, split_fraction
from courseware.errors import CourseError
from courseware.figures.figure import Figure, find_figure
from courseware.script import engine
from courseware.symbols import lexicon

SIZES = (sp.Abs, sp.Max, sp.Min)  # functions whose value has the unit of their arguments
Numbers = Mapping[str, Mapping[str, Any]]
START_NUMBERS = """((figure, {numbersBySymbol, startState, settings, compute}) => numbersBySymbol(
  figure, startState(figure), compute(figure, settings(figure, startState(figure)))
))"""


@cache
def start_numbers(figure: Figure) -> Numbers:
    """Return the numbers of an untouched figure, `{value, text}`, by the keys of their symbols."""
    found: Numbers = engine.run(f"{START_NUMBERS}({figure.code}, courseware)")
    return found


def find_key(figure: Figure, name: str) -> str:
    """Return the key of a quantity of a figure, by its name."""
    keys = start_numbers(figure)
    if found := next((key for key in keys if key.split(".")[1] == name), ""):
        return found
    raise CourseError(
        f"a sentence follows {name} of the figure {figure.name}, which shows no such quantity; "
        f"there are {', '.join(keys)}"
    )


def start_text(figure: str, name: str) -> str:
    """Return a quantity of an untouched figure with its unit, as a sentence shows it."""
    found = find_figure(figure)
    return str(start_numbers(found)[find_key(found, name)]["text"])


def split_lines(equation: Equation, computed: bool) -> list[tuple[Any, Any]]:
    """Return left and right side of each line; a product of matrices is written out."""
    right = equation.shown_side(computed)
    right = equation.right if isinstance(right, sp.MatMul) else right
    sides = (equation.left, right)
    columns = [list(side) if isinstance(side, sp.MatrixBase) else [side] for side in sides]
    return list(zip(*columns, strict=True))


class Slots:
    """Writes the lines of a formula with slots for the numbers of a figure."""

    def __init__(self, equation: Equation, figure: Figure, chapter: str) -> None:
        self.equation, self.figure, self.chapter = equation, figure, chapter
        self.numbers = start_numbers(figure)

    def render_tex(self, computed: bool) -> str:
        lines = [self._line(left, right) for left, right in split_lines(self.equation, computed)]
        return align_lines(lines) if len(lines) > 1 else " = ".join(lines[0])

    def render_sentence(self) -> str:
        """Return the results as HTML, for screen readers, which do not read the formula."""
        lefts = [left for left, _ in split_lines(self.equation, False)]
        return ", ".join(
            f'{format_symbol(left)} = <span data-symbol="{left.key}" data-of="{self.figure.name}" '
            f'data-result="1">{escape(self.numbers[left.key]["text"])}</span>'
            for left in lefts
        )

    def _line(self, left: Any, right: Any) -> tuple[str, str]:
        if not isinstance(left, NamedSymbol):
            raise CourseError(
                f"the numbers of {self.equation.name} cannot follow a figure: its left side "
                f"{left} is no symbol"
            )
        self._refuse_unknown(left, "a readout")
        if isinstance(right, NamedSymbol):  # its number is the result already
            return lexicon.mark_symbols(self.chapter, left.latex), self._slot(left, result=True)
        right = substitute(right, self._steps())
        degrees = is_in_degrees(right) and not mixes_units(right)
        result = self._slot(left, result=True)
        if left.unit == "rad" and not degrees:
            result = rf"{self._slot(left, radians=True)}\,\mathrm{{rad}} = {result}"
        self.turns_in_degrees = not mixes_units(right)
        with as_written():
            written = render_latex(self._filled(right, degrees), mul_symbol="dot")
        return lexicon.mark_symbols(self.chapter, left.latex), f"{written} = {result}"

    def _steps(self) -> dict[sp.Symbol, Any]:
        """Return the named steps that the figure has no numbers for, written out."""
        steps: dict[sp.Symbol, Any] = {}
        for symbol, step in self.equation.where:
            if getattr(symbol, "key", "") not in self.numbers:
                steps[symbol] = substitute(step, steps)
        return steps

    def _refuse_unknown(self, symbol: NamedSymbol, what: str) -> None:
        if symbol.key not in self.numbers:
            raise CourseError(
                f"the numbers of {self.equation.name} follow the figure {self.figure.name}, which "
                f"shows none for {symbol} ({symbol.module}): give it {what} with this symbol; "
                f"there are {', '.join(self.numbers)}"
            )

    def _slot(self, symbol: NamedSymbol, **flags: bool) -> str:
        flags = {flag: is_set for flag, is_set in flags.items() if is_set}
        text = engine.call("courseware.formatSlot", self.numbers[symbol.key], flags)
        marks = "".join(f",{flag}=1" for flag in flags)
        face = f"{lexicon.symbol_data(symbol, self.chapter)},of={self.figure.name}{marks}"
        upright = text.replace("%", r"\%").replace(" ", "~")
        return rf"{{\htmlData{{{face}}}{{\mathrm{{{upright}}}}}}}"

    def _filled(self, e: Any, degrees: bool, guarded: bool = False) -> Any:
        """Replace symbols by slots; guarded: a minus needs parentheses."""
        if isinstance(e, NamedSymbol):
            self._refuse_unknown(e, "a slider, a readout or a named step (`where`)")
            radians = e.unit == "rad" and not degrees
            return sp.Symbol(self._slot(e, guarded=guarded, radians=radians))
        if e == sp.pi and degrees:
            return sp.Symbol(r"180^\circ")
        if isinstance(e, sp.Piecewise):
            return self._filled(e.args[0][0], degrees, guarded)  # the ordinary case comes first
        if isinstance(e, sp.Function) and not isinstance(e, SIZES):
            inside = self.turns_in_degrees
            return e.func(*(self._filled(a, inside and is_in_degrees(a)) for a in e.args))
        parts = (self._filled(a, degrees, g) for a, g in mark_guarded(e, guarded))
        return e.func(*parts) if e.args else e


def mark_guarded(e: Any, guarded: bool) -> list[tuple[Any, bool]]:
    """Return the parts of an expression, and whether a minus would meet another sign there."""
    if isinstance(e, sp.Add):
        return [(part, place > 0) for place, part in enumerate(e.args)]
    if isinstance(e, sp.Pow):
        return [(e.base, guarded if e.exp == -1 else e.exp != sp.Rational(1, 2)), (e.exp, False)]
    if isinstance(e, sp.Mul):
        above, below = split_fraction(e)
        alone = [side[0] for side in (above, below) if below and len(side) == 1]
        under = [a.base if isinstance(a, sp.Pow) and a.exp == -1 else a for a in e.args]
        return [(a, part not in alone) for a, part in zip(e.args, under, strict=True)]
    return [(part, False) for part in e.args]


def mixes_units(e: Any) -> bool:
    """Return whether a function has angles beside other quantities: the line is in radians."""
    inside = {part for call in sp.sympify(e).atoms(sp.Function) for part in call.args}
    units = [{getattr(s, "unit", "") == "rad" for s in _plain(p).free_symbols} for p in inside]
    return {True, False} in units


def is_in_degrees(e: Any) -> bool:
    """Return whether an expression has only angles outside functions of them."""
    plain = _plain(e)
    units = [getattr(symbol, "unit", "") for symbol in plain.free_symbols]
    return set(units) <= {"rad"} and bool(units or plain.has(sp.pi))


def _plain(e: Any) -> Any:
    """Return an expression with an angle or a number for each function in it."""
    return sp.sympify(e).replace(
        lambda x: isinstance(x, sp.Function) and not isinstance(x, (*SIZES, sp.Piecewise)),
        lambda x: sp.pi if x.func.__name__.startswith("a") else sp.S.One,
    )
