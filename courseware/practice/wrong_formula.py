"""A mistake as a formula: the right one with something in it replaced::

    WrongFormula(formulas.turning_rate, {b: b / 2})

From it come the two formulas with the change marked, the wrong number that the judge knows, and
an expression for a figure that shows the consequence.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from functools import cached_property
from math import prod
from typing import Any

import sympy as sp

from courseware.equations.equation import as_written, free_symbols, substitute
from courseware.equations.text import format_formula, split_sign
from courseware.practice.solution_steps import compile_function

TOKEN = re.compile(r"\w[\w\u0300-\u036f]*|\s+|.")  # of a formula in one line of text
SHORT = 2  # changes at most so many signs apart are marked as one


@dataclass(frozen=True, eq=False)
class WrongFormula:
    """A formula as somebody writes it who makes a mistake.

    Args:
        of: the right one, an Equation or a LocalEquation.
        replaced: symbol → the expression in its place in the right side.
        instead: another right side altogether.
    """

    of: Any
    replaced: Mapping[sp.Symbol, Any] = field(default_factory=dict)
    instead: Any = None

    @cached_property
    def right(self) -> Any:
        """The wrong right side."""
        if self.instead is not None:
            return self.instead
        return simplify_signs(substitute(self.of.right, self.replaced))

    @cached_property
    def evaluate(self) -> Callable[..., Any]:
        """The function from numbers, by the names of the symbols, to the wrong result."""
        return _compile_by_name(self.right)

    def substitute(self, values: Mapping[sp.Symbol, Any]) -> Any:
        """Return the wrong right side with expressions for its symbols."""
        return substitute(self.right, values)

    def replace(self, **numbers: Any) -> dict[str, Any]:
        """Return the numbers with the mistake applied to them, under the same names."""
        known = ((str(s), sp.sympify(value)) for s, value in self.replaced.items())
        return numbers | {n: _compile_by_name(x)(**numbers) for n, x in known if n in numbers}

    def wrap(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Return the function as somebody calls it who makes the mistake."""
        return lambda **numbers: function(**self.replace(**numbers))

    def transfer(self, other: Any) -> "WrongFormula":
        """Return the same mistake in another formula."""
        return WrongFormula(other, self.replaced)

    @property
    def lines(self) -> tuple[str, str]:
        """The right and the wrong formula in a line of text each, with the difference in « »."""
        left = format_formula(self.of.left)
        right, wrong = (f"{left} = {format_formula(side)}" for side in (self.of.right, self.right))
        return mark_difference(right, wrong)


def _compile_by_name(expression: Any) -> Callable[..., Any]:
    """Compile an expression to a function of numbers by the names of its symbols."""
    symbols = tuple(sorted(free_symbols(expression), key=str))
    function, names = compile_function(expression, symbols), [str(symbol) for symbol in symbols]
    return lambda **numbers: function(*(numbers[name] for name in names))


def simplify_signs(e: Any) -> Any:
    """Write cos(−x) as cos x, sin(−x) as −sin x and −(−x) as x, and all else as it is."""
    if isinstance(e, sp.MatrixBase):
        return e.applyfunc(simplify_signs)
    if not isinstance(e, sp.Basic) or not e.args:
        return e
    parts = [simplify_signs(part) for part in e.args]
    with as_written():
        if isinstance(e, sp.sin | sp.cos):
            sign, rest = split_sign(parts[0])
            return -e.func(rest) if sign < 0 and isinstance(e, sp.sin) else e.func(rest)
        if isinstance(e, sp.Mul):
            signs, rests = zip(*map(split_sign, parts), strict=True)
            rests = tuple(rest for rest in rests if rest != 1) or (sp.S.One,)
            product = sp.Mul(*rests) if len(rests) > 1 else rests[0]
            return -product if prod(signs) < 0 else product
        return e.func(*parts)


def mark_difference(right: str, wrong: str) -> tuple[str, str]:
    """Put the difference of two lines in « »; a letter between two changes belongs to them."""
    tokens: list[list[str]] = [TOKEN.findall(line) for line in (right, wrong)]
    texts, same = ["", ""], True
    places = SequenceMatcher(None, tokens[0], tokens[1], autojunk=False).get_opcodes()
    for n, (kind, a, b, c, d) in enumerate(places):
        equal = kind == "equal" and not (b - a <= SHORT and 0 < n < len(places) - 1)
        for k, piece in enumerate(("".join(tokens[0][a:b]), "".join(tokens[1][c:d]))):
            texts[k] += piece if equal == same else f"{'»' if equal else '«'}{piece}"
        same = equal
    ends = (text + "»" * (not same) for text in texts)
    first, second = (re.sub(r"«(\s*)", r"\1«", end).replace("«»", "") for end in ends)
    return first, second
