"""Blanks at which no line of a text ends."""

import re

from courseware.units import UNITS

# For Python and for the script: before a unit that a number or "in" precedes, and beside the = of a
# short formula. What a unit starts with, as m of m/s, will do.
STARTS = sorted({re.split("[/·² ]", name)[0] for name in UNITS} - {"", "1"})
UNIT = rf"(?:{'|'.join(STARTS)})(?![A-Za-z_])"
SHORT = r"\S{1,9}(?:\s|$)"
BEHIND = rf"(?:(?<=[0-9])|(?<=\bin)) (?={UNIT})"
UNBROKEN = rf"{BEHIND}|(?<=\S) (?== {SHORT})|(?<=\S =) (?={SHORT})"


def prevent_breaks(text: str) -> str:
    """A text in which no line ends before a unit, or beside the = of a short formula."""
    return re.sub(UNBROKEN, "\u00a0", text)
