"""Functions for computed numbers in the prose, beside the chapters' own variables.

A chapter may add its own in a module `prose`.
"""

from typing import Any

from courseware.course import course
from courseware.figures import Choice, Slider
from courseware.figures.figure import find_figure
from courseware.symbols.formula_numbers import start_text

__all__ = ["digit_and_power", "get_names", "read_figure", "start_text"]


def get_names(chapter: str) -> dict[str, Any]:
    """Return all names of this module and of the chapter's `prose`."""
    own = course().module(chapter, "prose")
    return {**globals(), **(vars(own) if own else {})}


def read_figure(figure: str, readout: str, **settings: float | str) -> float:
    """Return a readout of a live figure at `settings`, the others as at the start, all in SI.

    A setting that the reader cannot reach is refused.
    """
    declared = find_figure(figure)
    row: list[float] = []
    for control in declared.controls:
        value = settings.pop(control.key, control.start)
        if isinstance(control, Choice):
            row += control.options[str(value)]
            continue
        if not isinstance(control, Slider):
            raise TypeError(
                f"{figure}: what {control.key} shows is made of presses, not of a number"
            )
        row.append(float(str(value)))
        if not control.low <= row[-1] <= control.high:
            reach = f"from {control.low:.4g} to {control.high:.4g}"
            raise ValueError(
                f"{figure}: the slider {control.key} goes {reach}, not to {row[-1]:.4g}"
            )
    if settings:
        raise KeyError(f"the figure {figure} has no control {', '.join(settings)}")
    place = [each.name for each in declared.readouts].index(readout)
    return float(declared.compute([row])[0, place])


def digit_and_power(x: float) -> tuple[int, int]:
    """Round a number to one digit: 0.0021 → (2, −3)."""
    digit, power = f"{x:.0e}".split("e")
    return int(digit), int(power)
