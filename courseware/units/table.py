"""Units: their names, spellings and sizes, and the tolerance of an answer.

`TABLE` has a row for each physical quantity, the SI unit first. Symbols, readouts, answers and
steps of solutions are in SI units. Numbers that only a reader sees (`given`, a guess) may be in any
unit of the table. A student may type any unit of the row, which is converted.

A new unit is one more entry: `Unit("m/s²")` in a row of its own, or `Unit("knots", 1852, 3600)` in
the row of m/s, and for a new word its size in `courseware/tests/test_units.py`.
"""

import re
from dataclasses import dataclass
from math import pi
from typing import Any

from courseware.errors import CourseError

BETWEEN = {  # patterns of the text between the words of a name, for Python and the script
    "/": r"\s*(?:[/∕⁄÷]|per\s)\s*",
    "·": r"[\s·⋅∙*]*",
    " ": r"[\s·⋅∙*]+",
    "²": r"(?:²|\^2|\*\*2|2)",
    "1": "(?:(?<!\\S)[1١۱１])?",
}
ANGLE = 9e-4  # three decimals in radians or one in degrees are enough: half of 0.1° is 8.7e-4


@dataclass(frozen=True)
class Unit:
    """A unit.

    Args:
        name: as declared and printed.
        times, by: its size: a number in this unit is `number * times / by` in the SI unit.
        spellings: what else may be typed for it, with blanks between; "metres" also in "metres/s".
        slip: the name of the unit in the feedback to an answer that is right in this unit, but was
            typed without it.
        shown: the unit that figures show instead of it.
        tolerance: how far off an answer may be, of an SI unit; three decimals are enough.
        joined: whether it follows its number without a space.
    """

    name: str
    times: float = 1
    by: float = 1
    spellings: str = ""
    slip: str = ""
    shown: str = ""
    tolerance: float = 6e-4
    joined: bool = False

    @property
    def words(self) -> list[str]:
        return [self.name, *self.spellings.split()]

    @property
    def factor(self) -> float:
        return self.times / self.by

    def to_si(self, number: float) -> float:
        return number * self.times / self.by

    def from_si(self, number: float) -> float:
        return number * self.by / self.times

    @property
    def pattern(self) -> str:
        """The regular expression of everything that may be typed for it."""
        others = UNITS.keys() - self.words

        def piece(part: str) -> str:
            return BETWEEN.get(part) or (f"(?:{UNITS[part].pattern})" if part in others else part)

        parts = (filter(None, re.split(f"([{''.join(BETWEEN)}])", word)) for word in self.words)
        return "|".join("".join(map(piece, each)) for each in parts)


TABLE = (
    (Unit(""), Unit("%", by=100, joined=True)),
    (
        Unit("m", spellings="metre metres meter meters"),
        Unit("cm", by=100, spellings="centimetre centimetres centimeter centimeters", slip="cm"),
        Unit("mm", by=1000, spellings="millimetre millimetres millimeter millimeters", slip="mm"),
        Unit("km", 1000, spellings="kilometre kilometres kilometer kilometers"),
    ),
    (
        Unit("m/s"),
        Unit("cm/s", by=100, slip="cm"),
        Unit("mm/s", by=1000, slip="mm"),
        Unit("km/h", 1000, 3600),
    ),
    (Unit("m²"), Unit("cm²", by=100**2, slip="cm"), Unit("mm²", by=1000**2, slip="mm")),
    (Unit("m³"),),
    (Unit("1/m"), Unit("1/cm", 100, slip="cm"), Unit("1/mm", 1000, slip="mm")),
    (
        Unit("rad", spellings="radian radians", shown="°", tolerance=ANGLE),
        Unit("°", pi, 180, "deg degree degrees º ˚", slip="degrees", joined=True),
        Unit("turns", 2 * pi, spellings="turn rev revolution revolutions", slip="turns"),
    ),
    (
        Unit("rad/s", spellings="1/s", tolerance=ANGLE),
        Unit("°/s", pi, 180, slip="degrees"),
        Unit("turns/s", 2 * pi, slip="turns"),
    ),
    (Unit("rad/m", tolerance=ANGLE), Unit("°/m", pi, 180, slip="degrees")),
    (Unit("rad²"),),
    (Unit("m rad"),),
    (Unit("1/s"),),
    (
        Unit("s", spellings="sec second seconds"),
        Unit("ms", by=1000, spellings="millisecond milliseconds"),
        Unit("min", 60, spellings="minute minutes"),
        Unit("h", 3600, spellings="hour hours"),
    ),
    (Unit("N", spellings="newton newtons"),),
    (Unit("N·m"),),
    (Unit("ticks", spellings="tick"),),
    (Unit("bits", spellings="bit"),),
)
UNITS = {unit.name: unit for row in TABLE for unit in row}
ROWS = {unit.name: row for row in TABLE for unit in row}


def figure_unit(unit: str) -> Unit:
    """Return the unit in which figures show a quantity."""
    return UNITS[UNITS[unit].shown or unit]


def refuse_unknown(unit: Any, who: str) -> None:
    """Refuse a unit that is not in the table."""
    if not isinstance(unit, str) or unit not in UNITS:
        raise CourseError(
            f"{who} has the unit {unit!r}; known are {', '.join(filter(None, UNITS))}, and "
            '"" for none: write one of these, or add yours in courseware/units/table.py'
        )


def refuse_other_than_si(unit: Any, who: str) -> None:
    """Refuse a unit that formulas do not compute in."""
    refuse_unknown(unit, who)
    if unit != (si := ROWS[unit][0].name):
        raise CourseError(
            f"{who} has the unit {unit!r}, but its numbers come from formulas, which compute in "
            f"SI units: write {si!r}"
        )
