"""Equations in notebooks: cells that show them, and those that a stored notebook shows."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.printing.str import StrPrinter

from courseware.course import course
from courseware.equations.equation import Equation, all_equations, find_equation
from courseware.equations.latex import OrderedPrinter

MIME = "application/vnd.courseware.equation+json"
COMPUTED = "-computed"  # ends the label of a formula in the form that the code uses


@dataclass(frozen=True)
class Output:
    """The output of a notebook cell, by MIME type."""

    data: Mapping[str, Any]

    def _repr_mimebundle_(self, **_: Any) -> Mapping[str, Any]:
        return self.data


def show(name: str, computed: bool = False, figure: str = "") -> Output:
    """Show an equation, in a cell of its own that is tagged `remove-input`.

    The text refers to it with ``{eq}`differential_drive.speed```. A formula typed by hand is
    refused by a test, except in cells tagged `definition`, `derivation` or `mistake`.

    Args:
        name: of the equation.
        computed: in the form that the code uses, where a textbook's form is shown otherwise.
        figure: a live figure whose numbers are shown below the formula and follow the hand. Each
            symbol of the formula needs a slider, a readout or a named step in it, its left side a
            readout.
    """
    equation = find_equation(name)
    label = equation_label(name, computed)
    tag, right = label.replace("_", r"\_"), equation.shown_side(computed)
    content = {"name": name, "computed": computed} | ({"figure": figure} if figure else {})
    return Output(
        {
            MIME: content,
            "text/latex": rf"$$ {equation.latex(computed)} \tag{{{tag}}} $$",
            "text/plain": f"{_plain(equation.left)} = {_plain(right)}   ({label})",
        }
    )


class _Plain(OrderedPrinter, StrPrinter):  # type: ignore[misc]
    """SymPy's printer of a line that Python reads."""


def _plain(expression: Any) -> str:
    parts = list(expression) if isinstance(expression, sp.MatrixBase) else expression
    return str(_Plain().doprint(parts)).replace("- 1*", "- ")


def equation_label(name: str, computed: bool) -> str:
    """Return the label that `{eq}` refers to: a page may show a formula in both its forms."""
    return name + COMPUTED if computed else name


def equation_anchor(label: str) -> str:
    """Return the part of a page's address that leads to an equation."""
    return "equation-" + re.sub("[^a-z0-9]+", "-", label.lower())


def read_cells(chapter: str) -> list[dict[str, Any]]:
    """Return the cells of a chapter's stored notebook, none if it has no notebook."""
    if chapter not in course().taught:
        return []
    cells: list[dict[str, Any]] = json.loads(course().notebook(chapter).read_text("utf-8"))["cells"]
    return cells


def read_outputs(cell: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the outputs of a stored cell, each by MIME type."""
    return [output.get("data", {}) for output in cell.get("outputs", ())]


def shown_equations(chapter: str) -> list[tuple[Equation, bool]]:
    """Return the equations that a chapter's notebook shows, each with `computed`.

    Those whose names are no longer declared are left out: the notebook must run again to say so.
    """
    known = all_equations()
    outputs = (data for cell in read_cells(chapter) for data in read_outputs(cell))
    found = (data[MIME] for data in outputs if MIME in data)
    return [(known[data["name"]], data["computed"]) for data in found if data["name"] in known]
