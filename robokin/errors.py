"""The errors that robokin raises, one family: `except RobokinError` catches all."""

import reprlib
from typing import Any

__all__ = ["RobokinError", "SingularError", "UnreachableError"]


class RobokinError(ValueError):
    """An argument that cannot be worked with: says what was got and what is allowed."""


class UnreachableError(RobokinError):
    """A target that the robot cannot reach: says which, and by how much."""


class SingularError(RobokinError):
    """A pose or a set of wheels at which the question has no single answer: says which."""


def at_index(index: tuple[int, ...]) -> str:
    """Return which element of a batch is meant, as a message says it."""
    return f" at index {', '.join(map(str, index))}" if index else ""


def describe(value: Any) -> str:
    """Return a value cut short for a message; some objects cannot even be printed."""
    try:
        return reprlib.repr(value)
    except Exception:
        return f"a {type(value).__name__}"
