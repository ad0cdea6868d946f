"""How an equation is shown: numbered mathematics in JupyterLab and on the page."""

import re
from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter
from sympy.printing.printer import Printer
from sympy.printing.str import StrPrinter

MIME = "application/vnd.courseware.equation+json"
AGAIN = "application/vnd.courseware.equations+json"  # those of a chapter once more
LINES_APART, FRACTIONS_APART = r"\\[4pt]", r"\\[10pt]"  # fractions in two rows would touch


class AsWritten(Printer):  # type: ignore[misc]
    """The base of our printers: all parts stand in the order in which they were written."""

    def __init__(self, **settings: Any) -> None:
        super().__init__({"order": "none", **settings})

    def _as_ordered_terms(self, expr: Any, order: str | None = None) -> list[Any]:
        """The terms of a sum: three of a + b + c, which Python takes for (a + b) + c."""
        first, *rest = expr.args
        return [*self._as_ordered_terms(first), *rest] if first.is_Add else list(expr.args)


class _Latex(AsWritten, LatexPrinter):  # type: ignore[misc]
    """SymPy's printer, but that atan2 of two sums takes two rows, to fit a phone."""

    def _print_atan2(self, e: Any) -> str:
        inside = ",".join(map(self._print, e.args))
        if all(part.is_Add for part in e.args):
            rows = r", \\ &".join(map(self._print, e.args))
            inside = rf"\begin{{aligned}} &{rows} \end{{aligned}}"
        return rf"\operatorname{{atan2}}{{\left({inside} \right)}}"


def latex(expression: Any, **settings: Any) -> str:
    """LaTeX of an expression in the order in which it was written."""
    text: str = _Latex(**settings).doprint(expression)
    if r"\frac" in text:
        text = text.replace(r"\\", FRACTIONS_APART)
    text = text.replace(r"} \frac", r"} \, \frac")  # two fractions side by side are two
    return text.replace("^{T}", r"^{\top}")  # one sign for the transposed in the whole course


def both_sides(left: Any, right: Any) -> str:
    """Left side = right side; columns as one line for each component."""
    if isinstance(left, sp.MatrixBase) and isinstance(right, sp.MatrixBase):
        return aligned([(latex(a), latex(c)) for a, c in zip(left, right, strict=True)])
    return f"{latex(left)} = {latex(right)}"


def aligned(lines: Sequence[tuple[str, str]]) -> str:
    """Lines with their signs = below each other."""
    apart = FRACTIONS_APART if any(r"\frac" in right for _, right in lines) else LINES_APART
    both = f" {apart} ".join(f"{left} &= {right}" for left, right in lines)
    return rf"\begin{{aligned}} {both} \end{{aligned}}"


COMPUTED = "-computed"


def name_on_page(name: str, computed: bool) -> str:
    """What `{eq}` refers to: a formula may stand on a page in both its forms."""
    return name + COMPUTED if computed else name


def place_on_page(label: str) -> str:
    """Where a page has a formula, as links to it say; label: what `{eq}` refers to."""
    return "equation-" + re.sub("[^a-z0-9]+", "-", label.lower())


class _Plain(AsWritten, StrPrinter):  # type: ignore[misc]
    """SymPy's printer of a line that Python reads."""


def _plain(expression: Any) -> str:
    listed = list(expression) if isinstance(expression, sp.MatrixBase) else expression
    return str(_Plain().doprint(listed)).replace("- 1*", "- ")


def mimebundle(
    name: str, computed: bool, left: Any, right: Any, figure: str = ""
) -> dict[str, Any]:
    """The output of a cell: the formula's name for the page, tagged LaTeX for a notebook."""
    label = name_on_page(name, computed)
    formula, tag = both_sides(left, right), label.replace("_", r"\_")
    return {
        MIME: {"name": name, "computed": computed, **({"figure": figure} if figure else {})},
        "text/latex": rf"$$ {formula} \tag{{{tag}}} $$",
        "text/plain": f"{_plain(left)} = {_plain(right)}   ({label})",
    }
