"""Spaces at which no line of a text may break: before units, and beside = in short formulas."""

import re

from courseware.units.table import UNITS

# for Python and the script; of a unit its start is enough, as m of m/s
STARTS = sorted({re.split("[/·² ]", name)[0] for name in UNITS} - {"", "1"})
UNIT = rf"(?:{'|'.join(STARTS)})(?![A-Za-z_])"
SHORT = r"\S{1,9}(?:\s|$)"
BEHIND = rf"(?:(?<=[0-9])|(?<=\bin)) (?={UNIT})"
UNBROKEN = rf"{BEHIND}|(?<=\S) (?== {SHORT})|(?<=\S =) (?={SHORT})"


def prevent_breaks(text: str) -> str:
    """Return a text with no-break spaces before units and beside = in short formulas."""
    return re.sub(UNBROKEN, "\u00a0", text)
