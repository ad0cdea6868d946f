"""How an equation is shown: numbered mathematics in JupyterLab and on the page."""

from typing import Any

import sympy as sp

MIME = "application/vnd.workshop.equation+json"
LINES_APART, FRACTIONS_APART = r"\\[4pt]", r"\\[10pt]"  # fractions in two rows would touch


def latex(expression: Any) -> str:
    """LaTeX of an expression in the order in which it was written."""
    text: str = sp.latex(expression, order="none")
    if r"\frac" in text:
        text = text.replace(r"\\", FRACTIONS_APART)
    return text.replace(r"\operatorname{atan}_{2}", r"\operatorname{atan2}")


def both_sides(left: Any, right: Any) -> str:
    """Left side = right side; columns as one line for each component."""
    if isinstance(left, sp.MatrixBase) and isinstance(right, sp.MatrixBase):
        lines = [f"{latex(a)} &= {latex(c)}" for a, c in zip(left, right, strict=True)]
        apart = FRACTIONS_APART if any(r"\frac" in line for line in lines) else LINES_APART
        return r"\begin{aligned} " + f" {apart} ".join(lines) + r" \end{aligned}"
    return f"{latex(left)} = {latex(right)}"


def _plain(expression: Any) -> str:
    listed = list(expression) if isinstance(expression, sp.MatrixBase) else expression
    return str(sp.sstr(listed, order="none")).replace("- 1*", "- ")


def mimebundle(label: str, left: Any, right: Any) -> dict[str, Any]:
    """The output of a cell: labelled mathematics for the page, tagged LaTeX for a notebook."""
    formula, tag = both_sides(left, right), label.replace("_", r"\_")
    return {
        MIME: {"label": label, "latex": formula},
        "text/latex": rf"$$ {formula} \tag{{{tag}}} $$",
        "text/plain": f"{_plain(left)} = {_plain(right)}   ({label})",
    }
