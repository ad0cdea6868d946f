"""The errors that robokin raises, one family: `except RobokinError` catches all."""

import reprlib

__all__ = ["RobokinError", "SingularError", "UnreachableError"]

describe = reprlib.repr  # a value cut short, for a message


class RobokinError(ValueError):
    """Error in an argument: the message says what was got and what is allowed."""


class UnreachableError(RobokinError):
    """Error for a target that the robot cannot reach: the message says which, and by how much."""


class SingularError(RobokinError):
    """Error for a pose or a set of wheels with no single answer: the message says which."""


def at_index(index: tuple[int, ...]) -> str:
    """Return which element of a batch is meant, as a message says it."""
    return f" at index {', '.join(map(str, index))}" if index else ""
