"""Formulas as one line of text, with letters or with numbers, in the order of the declaration.

Letters with an index stay as "v_L"; HTML with a raised or lowered index is made of it later.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar

import sympy as sp
from sympy.printing.pretty.pretty_symbology import greek_unicode

from courseware.equations.latex import OrderedPrinter
from courseware.errors import CourseError

SUM, SIGNED, PRODUCT, POWER, ATOM = range(5)  # how tightly a text binds
Bound = tuple[str, int]  # a text and how tightly it binds

GREEK = {**greek_unicode, "varphi": "φ", "vartheta": "ϑ", "varepsilon": "ε", "ell": "ℓ"}
WORDS = GREEK | {"det": "det", "top": "ᵀ"}
ACCENTS = {"dot": "\u0307", "ddot": "\u0308", "hat": "\u0302", "bar": "\u0304"}
NAMES = {
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "Max": "max",
    "Min": "min",
    "Mod": "mod",
}
TURNS = ("sin", "cos", "tan", "cot")  # functions of an angle
RAISED = {2: "²", 3: "³"}


def format_symbol(symbol: sp.Symbol) -> str:
    """Return a symbol's letter: "θ̇_1" for `\\dot\\theta_1`."""
    latex: str = sp.latex(symbol)
    text = re.sub(r"\\operatorname\s*\{(\w+)\}(?=[\w\\])", r"\1 ", latex)
    text = re.sub(r"\\(?:mathrm|operatorname|text|boldsymbol)\s*\{((?:\\?\w)+)\}", r"\1", text)
    text = re.sub(r"\\([A-Za-z]+)", lambda m: WORDS.get(m[1], m[0]), text)
    text = re.sub(r"\\(d?dot|hat|bar)\W*(\w)", lambda m: m[2] + ACCENTS[m[1]], text)
    text = re.sub(r"_\{([^{}]*)\}", lambda m: "_" + re.sub("[ ,]", "", m[1]), text)
    text = text.replace("{", "").replace("}", "").replace("Δ ", "Δ").replace("'", "′")
    if "\\" in text:
        raise CourseError(f"the symbol {symbol} prints as {latex}, which has no plain letter")
    return text


def parenthesize(bound: Bound, least: int) -> str:
    """Return the text, in parentheses if it binds less tightly than `least`."""
    text, binding = bound
    return text if binding >= least else f"({text})"


class Text(OrderedPrinter):
    """Prints each part of an expression as a text and how tightly it binds.

    Args:
        letters: returns the text for a symbol.
        in_degrees: texts for symbols inside a function of an angle, used if it has them all.
    """

    _default_settings: ClassVar = {"order": None}

    def __init__(
        self, letters: Callable[[sp.Symbol], str], in_degrees: Mapping[sp.Symbol, str] | None = None
    ) -> None:
        super().__init__()
        self.letters, self.in_degrees = letters, in_degrees or {}

    def text(self, expression: Any) -> str:
        return self.bound(expression)[0]

    def bound(self, e: Any) -> Bound:
        """Return the text of an expression and how tightly it binds."""
        found: Bound = self._print(sp.sympify(e))
        return found

    def _print_Symbol(self, e: Any) -> Bound:
        text = self.letters(e)
        return text, SIGNED if text.startswith("−") else ATOM

    _print_MatrixSymbol = _print_Symbol

    def _print_NumberSymbol(self, e: Any) -> Bound:
        return "π" if e == sp.pi else str(e), ATOM

    def _print_Number(self, e: Any) -> Bound:
        text = f"{float(e):.6g}" if isinstance(e, sp.Float) else str(e)
        return text.replace("-", "−"), SIGNED if text.startswith("-") else ATOM

    def _print_Rational(self, e: Any) -> Bound:
        if e.is_Integer:
            return self._print_Number(e)
        return f"{'−' if e < 0 else ''}{abs(e.p)}/{e.q}", PRODUCT if e > 0 else SIGNED

    def _print_MatrixBase(self, e: Any) -> Bound:
        if e.cols == 1:
            return "[" + ", ".join(map(self.text, e)) + "]", ATOM
        rows = (", ".join(map(self.text, e.row(i))) for i in range(e.rows))
        return "[" + ", ".join(f"[{row}]" for row in rows) + "]", ATOM

    def _print_MatMul(self, e: Any) -> Bound:
        sign, rest = split_sign(e)
        factors = rest.args if isinstance(rest, sp.MatMul) else (rest,)
        text = " ".join(parenthesize(self.bound(factor), PRODUCT) for factor in factors)
        return (f"−{text}", SIGNED) if sign < 0 else (text, PRODUCT)

    def _print_Transpose(self, e: Any) -> Bound:
        return parenthesize(self.bound(e.arg), ATOM) + "ᵀ", POWER

    def _print_Inverse(self, e: Any) -> Bound:
        return parenthesize(self.bound(e.arg), ATOM) + "⁻¹", POWER

    def _print_Add(self, e: Any) -> Bound:
        text = ""
        for place, part in enumerate(e.args):
            sign, rest = split_sign(part)
            shown = parenthesize(self.bound(rest), PRODUCT if place or sign < 0 else SUM)
            if place:
                text += f" {'−' if sign < 0 else '+'} {shown}"
            else:
                text = f"−{shown}" if sign < 0 else shown
        return text, SUM

    def _print_Piecewise(self, e: Any) -> Bound:
        return self.bound(e.args[0][0])  # the ordinary case comes first

    def _print_Abs(self, e: Any) -> Bound:
        return f"|{self.text(e.args[0])}|", ATOM

    def _print_Mul(self, e: Any) -> Bound:
        sign, rest = split_sign(e)
        above, below = split_fraction(rest)
        alone = PRODUCT if sign < 0 else SIGNED if below else SUM
        text = self._factors(above, closed=bool(below), alone=alone)
        if below:
            under = self._factors(below, closed=False)
            several = len(below) > 1 or self.bound(below[0])[1] < POWER
            text = f"{text}/({under})" if several else f"{text}/{under}"
        text = f"−{text}" if sign < 0 else text
        return text, SIGNED if text.startswith("−") else PRODUCT

    def _factors(self, factors: Sequence[Any], closed: bool, alone: int = SUM) -> str:
        """Join factors; closed: a function at the end has its argument in parentheses.

        alone: how tightly a single factor must bind to stand without parentheses.
        """
        if not factors:
            return "1"
        least = alone if len(factors) == 1 else PRODUCT
        text = ""
        for place, factor in enumerate(factors):
            shown = parenthesize(self.bound(factor), least)
            is_call = factor.is_Function and not isinstance(factor, sp.Abs | sp.Piecewise)
            if is_call and (closed or place < len(factors) - 1):
                shown, _ = self._print_Basic(factor, closed=True)
            text += choose_separator(text, shown) + shown
        return text

    def _print_Pow(self, e: Any) -> Bound:
        base, exponent = e.base, e.exp
        if exponent == sp.Rational(1, 2):
            return "√" + parenthesize(self.bound(base), ATOM), POWER
        if exponent.is_Number and exponent < 0:
            return self._print_Mul(sp.Mul(sp.S.One, e, evaluate=False))
        raised = RAISED.get(exponent) or f"^{parenthesize(self.bound(exponent), ATOM)}"
        return parenthesize(self.bound(base), ATOM) + raised, POWER

    def _print_Basic(self, e: Any, closed: bool = False) -> Bound:
        """Print a function of something."""
        name = NAMES.get(e.func.__name__, e.func.__name__)
        inside = self
        if name in TURNS and e.free_symbols and e.free_symbols <= set(self.in_degrees):
            inside = Text(self.in_degrees.__getitem__)
        arguments = [inside.bound(argument) for argument in e.args]
        if len(arguments) == 1 and arguments[0][1] == ATOM and not closed and name != "ceiling":
            return f"{name} {arguments[0][0]}", POWER
        return f"{name}({', '.join(text for text, _ in arguments)})", POWER


def split_sign(e: Any) -> tuple[int, Any]:
    """Return the sign that an expression starts with, and the rest."""
    if not e.is_Matrix and e.is_Number and e < 0:
        return -1, -e
    if isinstance(e, sp.Mul | sp.MatMul):
        sign, first = split_sign(e.args[0])
        if sign < 0:
            rest = e.args[1:] if first == 1 else (first, *e.args[1:])
            return -1, rest[0] if len(rest) == 1 else e.func(*rest, evaluate=False)
        for place, part in enumerate(e.args):
            if isinstance(part, sp.Mul) and split_sign(part)[0] < 0:  # a product in the product
                rest = (*e.args[:place], split_sign(part)[1], *e.args[place + 1 :])
                return -1, e.func(*rest, evaluate=False)
    return 1, e


def split_fraction(e: Any) -> tuple[list[Any], list[Any]]:
    """Return the factors above and below the line, in order."""
    above, below = list[Any](), list[Any]()
    for part in e.args if isinstance(e, sp.Mul) else [e]:
        if isinstance(part, sp.Mul):
            more, under = split_fraction(part)
            above += more
            below += under
        elif isinstance(part, sp.Pow) and part.exp.is_Number and part.exp < 0:
            power = sp.Pow(part.base, -part.exp, evaluate=False)
            below.append(part.base if part.exp == -1 else power)
        elif isinstance(part, sp.Rational) and not part.is_Integer:
            above += [sp.Integer(part.p)] if part.p != 1 else []
            below.append(sp.Integer(part.q))
        elif part != 1:
            above.append(part)
    return above, below


def choose_separator(left: str, right: str) -> str:
    """Return what separates two factors: nothing in 2π, a point where a space would mislead."""
    if not left or (right.startswith("π") and left[-1].isdigit()):
        return ""
    number = re.search(r"(?<![_\w])[\d.]+$", left)
    if right[0].isdigit() or (right[0] == "(" and (number or left[-1] == ")")):
        return " · "
    return " "


def format_formula(expression: Any) -> str:
    return Text(format_symbol).text(expression)


def format_with_numbers(
    expression: Any, numbers: Mapping[sp.Symbol, str], in_degrees: Mapping[sp.Symbol, str]
) -> str:
    """Return an expression with numbers, given as texts, in place of its symbols."""
    return Text(numbers.__getitem__, in_degrees).text(expression)
