"""How an equation is shown: numbered mathematics in JupyterLab and on the page."""

from typing import Any

import sympy as sp

from workshop.equations.core import Equation, find

MIME = "application/vnd.workshop.equation+json"
LINES_APART, FRACTIONS_APART = r"\\[4pt]", r"\\[10pt]"  # fractions in two rows would touch


def latex(expression: Any) -> str:
    """LaTeX of an expression in the order in which it was written."""
    text: str = sp.latex(expression, order="none")
    if r"\frac" in text:
        text = text.replace(r"\\", FRACTIONS_APART)
    return text.replace(r"\operatorname{atan}_{2}", r"\operatorname{atan2}")


def printed(equation: Equation, computed: bool) -> Any:
    """The right side that is shown: the textbook's where there is one, unless `computed`."""
    return equation.right if computed or equation.textbook is None else equation.textbook


def equation_latex(equation: Equation, computed: bool = False) -> str:
    """Left side = right side; columns as one line for each component."""
    left, right = equation.left, printed(equation, computed)
    if isinstance(left, sp.MatrixBase) and isinstance(right, sp.MatrixBase):
        lines = [f"{latex(a)} &= {latex(c)}" for a, c in zip(left, right, strict=True)]
        apart = FRACTIONS_APART if any(r"\frac" in line for line in lines) else LINES_APART
        return r"\begin{aligned} " + f" {apart} ".join(lines) + r" \end{aligned}"
    return f"{latex(left)} = {latex(right)}"


def _plain(expression: Any) -> str:
    listed = list(expression) if isinstance(expression, sp.MatrixBase) else expression
    return str(sp.sstr(listed, order="none")).replace("- 1*", "- ")


def mimebundle(equation: Equation, computed: bool = False) -> dict[str, Any]:
    """The output of a cell: labelled mathematics for the page, tagged LaTeX for a notebook."""
    label = equation.name + ("-computed" if computed else "")
    formula, right = equation_latex(equation, computed), printed(equation, computed)
    tag = label.replace("_", r"\_")
    return {
        MIME: {"label": label, "latex": formula},
        "text/latex": rf"$$ {formula} \tag{{{tag}}} $$",
        "text/plain": f"{_plain(equation.left)} = {_plain(right)}   ({label})",
    }


class Shown:
    """An equation as the value of a notebook cell."""

    def __init__(self, equation: Equation, computed: bool) -> None:
        self.equation = equation
        self.computed = computed

    def _repr_mimebundle_(self, **_: Any) -> dict[str, Any]:
        return mimebundle(self.equation, self.computed)


def show(name: str, computed: bool = False) -> Shown:
    """Show an equation by its name; `computed=True` shows the form that the code uses."""
    return Shown(find(name), computed)
