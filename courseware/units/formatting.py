"""Numbers, units and symbols as texts of exercises and predictions write them."""

import math
import re
from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from courseware.units.line_breaks import prevent_breaks
from courseware.units.table import UNITS


def format_number(value: Any, spec: str = "") -> str:
    """Return a number, vector or matrix: four decimals, no trailing zeros, a true minus."""
    if isinstance(value, str):
        return value
    if isinstance(value, Sequence | np.ndarray):
        return "[" + ", ".join(format_number(v, spec) for v in value) + "]"
    if spec == "deg":
        return format_number(value * 180 / math.pi, ".1f").removesuffix(".0") + "°"
    text = format(value, spec) if spec else f"{value:.4f}".rstrip("0").rstrip(".")
    return re.sub(r"^-(?=[0.]*$)", "", text).replace("-", "\u2212")


def append_unit(text: str, unit: str) -> str:
    """Return "30 cm", but "45°"."""
    return text + unit if UNITS[unit].joined else f"{text} {unit}".rstrip()


def render_symbols(text: str) -> str:
    """Render "v_L", "θ̇_1", "x_{i+1}" and "θ_1^away" as letters with an index, in HTML."""
    letter, index = r"([^\W\d_][\u0300-\u036f]*)", r"(?:([^\W_]+)|{([^}]+)})"
    text = re.sub(f"{letter}_{index}", r"<i>\1</i><sub>\2\3</sub>", escape(text))
    return re.sub(r"</sub>\^([0-9A-Za-z]+|[+−-])", r"</sub><sup>\1</sup>", text)


def render_marked(text: str) -> str:
    """Render a text as HTML, with the part in « » marked."""
    return render_symbols(text).replace("«", "<mark>").replace("»", "</mark>")


def render_paragraphs(text: str) -> str:
    """Render a text of several paragraphs as HTML."""
    return "".join(f"<p>{render_symbols(prevent_breaks(part))}</p>" for part in text.split("\n\n"))
