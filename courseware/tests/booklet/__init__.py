"""A course on another subject, in one chapter: the framework's second user.

`python -m courseware.new_chapter` copies its chapter. So the looks and materials that the chapter
uses are named as in `book`.
"""

from typing import NamedTuple

from courseware.course import open_course
from courseware.figures import Ground, Materials


class Look(NamedTuple):
    light: str
    dark: str
    dash: tuple[int, ...] = ()
    width: float = 2.0
    marker: str = "dot"


LOOKS = {
    "target": Look("#3c4600", "#eef08a", marker="ring"),
    "error": Look("#8f0f2a", "#ff7a86", dash=(2, 3), width=8, marker="cross"),
    "path": Look("#20242c", "#eef1f5", width=2.5),
    "length": Look("#4a5260", "#c2cad6", width=1.5),
    "ghost": Look("#5b6573", "#9aa4b0", dash=(4, 4), width=1.5, marker="ring"),
    "grid": Look("#dfe3e8", "#3a414c", width=1),
    "text": Look("#20242c", "#eef1f5", width=1),
}
MATERIALS = Materials(
    tones={
        "paper": ("#ffffff", "#323a45"),
        "edge": ("#4b5664", "#9fa9b5"),
        "lamp": ("#ffe08a", "#ffe9a8"),
        "glass_lit": ("#86a9c7", "#5d86aa"),
        "shadow": ("#1b2430", "#000000"),
    },
    grounds={"paper": Ground("paper", "paper")},
)

open_course(__name__, name="example", looks=LOOKS, materials=MATERIALS)
