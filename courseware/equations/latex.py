"""Expressions and equations as LaTeX, in the order in which they are written."""

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter
from sympy.printing.printer import Printer

LINES_APART, FRACTIONS_APART = r"\\[4pt]", r"\\[10pt]"  # fractions in two rows would touch


class OrderedPrinter(Printer):  # type: ignore[misc]
    """The base of our printers: all parts keep the order in which they were written."""

    def __init__(self, **settings: Any) -> None:
        super().__init__({"order": "none", **settings})

    def _as_ordered_terms(self, expr: Any, order: str | None = None) -> list[Any]:
        """Return the terms of a sum: three of a + b + c, which is (a + b) + c for Python."""
        first, *rest = expr.args
        return [*self._as_ordered_terms(first), *rest] if first.is_Add else list(expr.args)


class _Latex(OrderedPrinter, LatexPrinter):  # type: ignore[misc]
    """SymPy's printer, except that atan2 of two sums takes two rows, to fit a phone."""

    def _print_atan2(self, e: Any) -> str:
        inside = ",".join(map(self._print, e.args))
        if all(part.is_Add for part in e.args):
            rows = r", \\ &".join(map(self._print, e.args))
            inside = rf"\begin{{aligned}} &{rows} \end{{aligned}}"
        return rf"\operatorname{{atan2}}{{\left({inside} \right)}}"


def render_latex(expression: Any, **settings: Any) -> str:
    text: str = _Latex(**settings).doprint(expression)
    if r"\frac" in text:
        text = text.replace(r"\\", FRACTIONS_APART)
    text = text.replace(r"} \frac", r"} \, \frac")  # two fractions side by side are two
    return text.replace("^{T}", r"^{\top}")


def render_equation(left: Any, right: Any) -> str:
    """Return the LaTeX of left side = right side, of columns with a line for each component."""
    if isinstance(left, sp.MatrixBase) and isinstance(right, sp.MatrixBase):
        pairs = zip(left, right, strict=True)
        return align_lines([(render_latex(a), render_latex(b)) for a, b in pairs])
    return f"{render_latex(left)} = {render_latex(right)}"


def align_lines(lines: Sequence[tuple[str, str]]) -> str:
    """Return lines with their signs = below each other."""
    apart = FRACTIONS_APART if any(r"\frac" in right for _, right in lines) else LINES_APART
    both = f" {apart} ".join(f"{left} &= {right}" for left, right in lines)
    return rf"\begin{{aligned}} {both} \end{{aligned}}"
