"""One colour, line and marker for each kind of thing, in every figure of every chapter.

Used by the course's live figures and by the still ones (`robokin.draw`). Kinds that are compared
(left and right, the axes, the headings of a step) differ by line or marker, too. The colours are
told apart by readers who see no red or no green, and have a contrast of at least 3:1 on white and
on black pages.
"""

from dataclasses import dataclass

__all__ = ["KINDS", "Style"]


@dataclass(frozen=True)
class Style:
    """Colour on a light and on a dark page, dashes, width, marker.

    Parameters
    ----------
    light, dark : str
        Colours, as `#0072b2`.
    dash : tuple of int, optional
        Lengths of line and gap.
    width : float, default 2.0
        Width of the line.
    marker : {"dot", "ring", "cross", "square", "diamond"}, default "dot"
        Marker of a point.
    """

    light: str
    dark: str
    dash: tuple[int, ...] = ()
    width: float = 2.0
    marker: str = "dot"  # dot, ring, cross, square, diamond


KINDS: dict[str, Style] = {
    "left": Style("#0067a3", "#4aaef2", width=3, marker="square"),
    "right": Style("#ad4000", "#ffa25f", dash=(8, 3), width=3, marker="diamond"),
    "body": Style("#3d4654", "#c9d1dc"),
    "velocity": Style("#0b6a47", "#4fcba0", width=3),
    "turning": Style("#43157f", "#d6bfff", dash=(7, 3), width=2.5, marker="diamond"),
    "heading": Style("#00657a", "#5cd3e6", dash=(2, 2), width=2),
    "length": Style("#4a5260", "#c2cad6", width=1.5),
    "error": Style("#8f0f2a", "#ff7a86", dash=(2, 3), width=8, marker="cross"),
    "target": Style("#3c4600", "#eef08a", marker="ring"),
    "icr": Style("#b0257f", "#ee7cc4", dash=(2, 3), marker="cross"),
    "path": Style("#20242c", "#eef1f5", width=2.5),
    "approximation": Style("#805b00", "#f2c14e", dash=(5, 4), width=2),
    "old_heading": Style("#aa400a", "#ff9e5e", dash=(8, 3), width=2, marker="diamond"),
    "new_heading": Style("#9a2f74", "#f08cc8", dash=(2, 3), width=2.5, marker="square"),
    "middle_heading": Style("#0067a0", "#56b4e9", dash=(10, 3, 2, 3), width=2),
    "uncertainty": Style("#0067a0", "#56b4e9", width=2, marker="ring"),
    "ghost": Style("#5b6573", "#9aa4b0", dash=(4, 4), width=1.5, marker="ring"),
    "x_axis": Style("#bc271b", "#ff8a7a", width=2.5),
    "y_axis": Style("#287028", "#7fd77f", dash=(9, 2), width=2.5),
    "z_axis": Style("#3a3fc4", "#9aa5ff", dash=(3, 2), width=2.5),
    "grid": Style("#dfe3e8", "#3a414c", width=1),
    "text": Style("#20242c", "#eef1f5", width=1),
}
