"""The error of the machine: a course that is declared wrongly, or a call that cannot be meant."""

import reprlib
from typing import Any

__all__ = ["CourseError", "describe"]


class CourseError(ValueError):
    """Says what was got, what is allowed, and what to do."""


def describe(value: Any) -> str:
    """What was got, cut short for a message; some objects cannot even be printed."""
    try:
        return reprlib.repr(value)
    except Exception:
        return f"a {type(value).__name__}"
