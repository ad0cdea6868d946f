"""Compile SymPy expressions to JavaScript, and run it."""

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray
from sympy.printing.jscode import JavascriptCodePrinter
from sympy.simplify.cse_main import tree_cse

from courseware.equations.equation import Where, as_written
from courseware.equations.functions import IN_SCRIPT
from courseware.equations.latex import OrderedPrinter
from courseware.equations.quantities import describe_symbols
from courseware.errors import CourseError
from courseware.script import engine


class Code(str):
    """JavaScript source, as opposed to a text."""


class _JavaScript(OrderedPrinter, JavascriptCodePrinter):  # type: ignore[misc]
    """SymPy's printer, with named symbols and the runtime's functions."""

    def __init__(self, names: Mapping[sp.Symbol, str]) -> None:
        super().__init__(precision=17)
        self.names = names

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        if expr not in self.names:
            raise CourseError(
                f"an expression uses {describe_symbols([expr], self.names)}, but may use only "
                f"{describe_symbols(self.names, [expr])}"
            )
        return self.names[expr]

    def _print_Function(self, expr: sp.Expr) -> str:
        name = expr.func.__name__
        if name in IN_SCRIPT:
            return f"f.{name}({', '.join(self._print(a) for a in expr.args)})"
        if name not in self.known_functions:
            raise CourseError(f"no JavaScript for {name}; see courseware/equations/functions.py")
        return str(super()._print_Function(expr))

    _print_sinc = _print_Function

    def _print_Pow(self, expr: sp.Pow) -> str:
        base, power = expr.as_base_exp() if expr.base.is_Number else (expr.base, expr.exp)
        if power == 1:
            return f"({self._print(base)})"
        if power == 2:  # a square as NumPy computes it; Math.pow may differ in the last digit
            text = self.parenthesize(base, 100)
            return f"({text} * {text})"
        return str(super()._print_Pow(expr))

    def _print_Float(self, expr: sp.Float) -> str:
        return repr(float(expr))  # all its digits, not the 15 that SymPy shows

    def _print_NaN(self, expr: sp.Expr) -> str:
        return "NaN"


def compile_javascript(
    arguments: Mapping[str, Sequence[sp.Symbol]], expressions: Sequence[Any], where: Where = ()
) -> Code:
    """Return the source of a JavaScript function `(f, c, …) => [values]`.

    arguments: name of an array argument → the symbols that its elements are. `f` holds the
    runtime's functions. where: named steps on the way, in order. Subexpressions that occur twice
    are computed once.
    """
    names = {
        symbol: f"{name}[{i}]"
        for name, symbols in arguments.items()
        for i, symbol in enumerate(symbols)
    }
    printer = _JavaScript(names)
    lines = []
    with as_written():
        shared, values = tree_cse([*map(sp.S, expressions)], sp.numbered_symbols(), order="none")
        for place, (symbol, expression) in enumerate([*where, *shared]):
            lines.append(f"const t{place} = {_one_line(printer, expression)};")
            names[symbol] = f"t{place}"
        results = ", ".join(_one_line(printer, value) for value in values)
    return Code(f"(f, {', '.join(arguments)}) => {{ {' '.join(lines)} return [{results}]; }}")


def _one_line(printer: _JavaScript, expression: Any) -> str:
    return " ".join(printer.doprint(expression).split())


def run_javascript(function: str, points: ArrayLike) -> NDArray[np.float64]:
    """Run a JavaScript function `(f, c) => […]` at points (n, k), in one call → (n, values)."""
    listed = json.dumps(np.asarray(points, dtype=float).tolist(), allow_nan=False)
    found = engine.run(f"{listed}.map((c) => ({function})(courseware.functions, c))")
    return np.array(found, dtype=float)
