"""How numbers, units and symbols are written in texts of exercises."""

import math
import re
from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from courseware.line_breaks import prevent_breaks
from courseware.units import UNITS


def number_text(value: Any, spec: str) -> str:
    """A number, vector or matrix as text: four decimals, no trailing zeros, a true minus."""
    if isinstance(value, str):
        return value
    if isinstance(value, Sequence | np.ndarray):
        return "[" + ", ".join(number_text(v, spec) for v in value) + "]"
    if spec == "deg":
        return number_text(value * 180 / math.pi, ".1f").removesuffix(".0") + "°"
    text = format(value, spec) if spec else f"{value:.4f}".rstrip("0").rstrip(".")
    return re.sub(r"^-(?=[0.]*$)", "", text).replace("-", "\u2212")


def with_unit(text: str, unit: str) -> str:
    """ "30 cm", but "45°"."""
    return text + unit if UNITS[unit].joined else f"{text} {unit}".rstrip()


def symbols(text: str) -> str:
    """A text as HTML, with "v_L", "θ̇_1", "x_{i+1}" and "θ_1^away" as letters with an index."""
    letter, index = r"([^\W\d_][\u0300-\u036f]*)", "(?:([0-9A-Za-z]+)|{([^}]+)})"
    text = re.sub(f"{letter}_{index}", r"<i>\1</i><sub>\2\3</sub>", escape(text))
    return re.sub(r"</sub>\^([0-9A-Za-z]+|[+−-])", r"</sub><sup>\1</sup>", text)


def highlighted(text: str) -> str:
    """A text as HTML, with what stands in « » marked."""
    return symbols(text).replace("«", "<mark>").replace("»", "</mark>")


def paragraphs(text: str) -> str:
    """A text of several paragraphs as HTML."""
    return "".join(f"<p>{symbols(prevent_breaks(part))}</p>" for part in text.split("\n\n"))
