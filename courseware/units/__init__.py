"""Units and numbers as text: the table of units, and how a number, its unit and a symbol print."""

from typing import Any

from courseware.script.parts import provide
from courseware.units.line_breaks import UNBROKEN
from courseware.units.table import (
    ROWS,
    TABLE,
    UNITS,
    Unit,
    figure_unit,
    refuse_other_than_si,
    refuse_unknown,
)

FIELDS = ("name", "times", "by", "pattern")


def collect_constants() -> dict[str, Any]:
    """Return what the script knows of units: the table, and which of them follow a number."""
    return {
        "UNITS": [[{key: getattr(unit, key) for key in FIELDS} for unit in row] for row in TABLE],
        "DEGREES": UNITS["°"].words,
        "TIGHT_UNITS": "".join(name for name, unit in UNITS.items() if unit.joined),
        "UNBROKEN": UNBROKEN,
    }


provide("courseware/units/constants.js", collect_constants)
