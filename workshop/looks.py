"""How kinds of things look: one colour, line and marker each, in every figure of a course."""

from typing import Protocol


class Look(Protocol):
    """Colour on a light and on a dark page, dashes (lengths of line and gap), width, marker.

    Markers: dot, ring, cross, square, diamond.
    """

    @property
    def light(self) -> str: ...
    @property
    def dark(self) -> str: ...
    @property
    def dash(self) -> tuple[int, ...]: ...
    @property
    def width(self) -> float: ...
    @property
    def marker(self) -> str: ...
