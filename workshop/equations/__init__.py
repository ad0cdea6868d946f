"""Every formula of a course, once: printed in the chapters, checked here, drawn from."""

from workshop.equations.checking import Result, check
from workshop.equations.core import Equation, as_written, declared, find, quantities, quantity
from workshop.equations.printing import show

__all__ = [
    "Equation",
    "Result",
    "as_written",
    "check",
    "declared",
    "find",
    "quantities",
    "quantity",
    "show",
]
