"""How kinds of things look: one colour, line and marker each, in every figure of a course."""

from dataclasses import dataclass
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


@dataclass(frozen=True)
class Plain:
    """The look of what stands behind a picture."""

    light: str
    dark: str
    dash: tuple[int, ...] = ()
    width: float = 1.0
    marker: str = "dot"


GROUND: dict[str, Look] = {
    "grid": Plain("#dfe3e8", "#3a414c"),
    "text": Plain("#20242c", "#eef1f5"),
}
