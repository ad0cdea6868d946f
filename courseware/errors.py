"""The error of the framework: a wrong declaration or a wrong call."""

import reprlib
from typing import Any


class CourseError(ValueError):
    """Its message says what was got, what is allowed, and what to do."""


def describe(value: Any) -> str:
    """Return a short text of a value for a message, even of one that cannot be printed."""
    try:
        return reprlib.repr(value)
    except Exception:
        return f"a {type(value).__name__}"
