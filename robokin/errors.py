"""The errors that robokin raises: one family, so that one `except RobokinError` catches all."""

__all__ = ["RobokinError", "SingularError", "UnreachableError"]


class RobokinError(ValueError):
    """An argument that cannot be worked with: says what was got and what is allowed."""


class UnreachableError(RobokinError):
    """A target that the robot cannot reach: says which, and by how much."""


class SingularError(RobokinError):
    """A pose or a set of wheels at which the question has no single answer: says which."""
