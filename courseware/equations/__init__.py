"""Every formula of a course, once: printed in the chapters, checked here, drawn from."""

from courseware.equations.checks import Check
from courseware.equations.core import (
    Equation,
    again,
    as_written,
    find_equation,
    look,
    quantity,
    show,
    sign,
)
from courseware.equations.verification import Array, Result, verify, verify_all

__all__ = [
    "Array",
    "Check",
    "Equation",
    "Result",
    "again",
    "as_written",
    "find_equation",
    "look",
    "quantity",
    "show",
    "sign",
    "verify",
    "verify_all",
]
