"""A mistake as a formula: the right one with something in it replaced::

    Wrong(formulas.turning_rate, {b: b / 2})

From it come the two formulas with what changed marked, the wrong number that the bank knows, and
an expression for a figure that shows what the robot then does.
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
from courseware.equations.text import formula_text, signed
from courseware.practice.solutions import compiled

TOKEN = re.compile(r"\w[\w\u0300-\u036f]*|\s+|.")  # of a formula in one line of text
SHORT = 2  # so many signs between two changes are no rest for the eye


@dataclass(frozen=True, eq=False)
class Wrong:
    """A formula as somebody writes it who makes a mistake.

    Args:
        of: the right one, an Equation or a Line.
        puts: what stands in its right side for which symbol.
        instead: another right side altogether.
    """

    of: Any
    puts: Mapping[sp.Symbol, Any] = field(default_factory=dict)
    instead: Any = None

    @cached_property
    def right(self) -> Any:
        """The wrong right side."""
        if self.instead is not None:
            return self.instead
        return plain_signs(substitute(self.of.right, self.puts))

    @cached_property
    def gives(self) -> Callable[..., Any]:
        """The wrong number, vector or matrix, from numbers by the names of the symbols."""
        return by_name(self.right)

    @cached_property
    def _parts(self) -> dict[str, Callable[..., Any]]:
        return {str(symbol): by_name(sp.sympify(value)) for symbol, value in self.puts.items()}

    def substitute(self, values: Mapping[sp.Symbol, Any]) -> Any:
        """The wrong right side with expressions put in for its symbols."""
        return substitute(self.right, values)

    def put(self, **numbers: Any) -> dict[str, Any]:
        """Numbers as somebody takes them who makes the mistake, under the same names."""
        put = {name: value(**numbers) for name, value in self._parts.items() if name in numbers}
        return numbers | put

    def through(self, formula: Callable[..., Any]) -> Callable[..., Any]:
        """What another formula gives where the same is put in for its numbers."""
        return lambda **numbers: formula(**self.put(**numbers))

    def made_in(self, other: Any) -> "Wrong":
        """The same mistake in another formula."""
        return Wrong(other, self.puts)

    @property
    def lines(self) -> tuple[str, str]:
        """The right and the wrong formula in one line of text, with what differs in « »."""
        left = formula_text(self.of.left)
        right, wrong = (f"{left} = {formula_text(side)}" for side in (self.of.right, self.right))
        return marked(right, wrong)


def by_name(expression: Any) -> Callable[..., Any]:
    """An expression as a function of numbers by the names of its symbols."""
    symbols = tuple(sorted(free_symbols(expression), key=str))
    function, names = compiled(expression, symbols), [str(symbol) for symbol in symbols]
    return lambda **numbers: function(*(numbers[name] for name in names))


def plain_signs(e: Any) -> Any:
    """An expression with cos(−x) as cos x, sin(−x) as −sin x and −(−x) as x, else as written."""
    if isinstance(e, sp.MatrixBase):
        return e.applyfunc(plain_signs)
    if not isinstance(e, sp.Basic) or not e.args:
        return e
    parts = [plain_signs(part) for part in e.args]
    with as_written():
        if isinstance(e, sp.sin | sp.cos):
            sign, rest = signed(parts[0])
            return -e.func(rest) if sign < 0 and isinstance(e, sp.sin) else e.func(rest)
        if isinstance(e, sp.Mul):
            signs, rests = zip(*map(signed, parts), strict=True)
            rests = tuple(rest for rest in rests if rest != 1) or (sp.S.One,)
            product = sp.Mul(*rests) if len(rests) > 1 else rests[0]
            return -product if prod(signs) < 0 else product
        return e.func(*parts)


def marked(right: str, wrong: str) -> tuple[str, str]:
    """Two lines with what differs in « »; a letter that stays between two changes is in them."""
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
