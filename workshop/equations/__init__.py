"""Every formula of a course, once: printed in the chapters, checked here, drawn from."""

from workshop.equations.checking import Array, Result, check
from workshop.equations.checks import Check
from workshop.equations.core import (
    Equation,
    again,
    as_written,
    find,
    look,
    quantity,
    show,
    sign,
)

__all__ = [
    "Array",
    "Check",
    "Equation",
    "Result",
    "again",
    "as_written",
    "check",
    "find",
    "look",
    "quantity",
    "show",
    "sign",
]
