"""What expressions in the prose of the chapters may use, beside the chapters' own variables.

A chapter may add to it in a `prose` module of its own.
"""

from typing import Any

from courseware.course import course
from courseware.figures import Choice, Figure, Slider

__all__ = ["digit_and_power", "names", "reads"]


def names(chapter: str) -> dict[str, Any]:
    """All of these names, and those of the chapter's `prose`."""
    own = course().module(chapter, "prose")
    return {**globals(), **(vars(own) if own else {})}


def reads(figure: str, readout: str, **settings: float | str) -> float:
    """What a readout of a live figure says, in SI: at `settings` (SI), the rest as at the start.

    A setting that the reader cannot reach is refused.
    """
    shown = course().find_all("figures", Figure)[figure]
    row: list[float] = []
    for control in shown.controls:
        value = settings.pop(control.key, control.start)
        if isinstance(control, Choice):
            row += control.options[str(value)]
            continue
        if not isinstance(control, Slider):
            raise TypeError(
                f"{figure}: what {control.key} shows is made of presses, not of a number"
            )
        row.append(float(value))
        if not control.low <= row[-1] <= control.high:
            reach = f"from {control.low:.4g} to {control.high:.4g}"
            raise ValueError(
                f"{figure}: the slider {control.key} goes {reach}, not to {row[-1]:.4g}"
            )
    if settings:
        raise KeyError(f"the figure {figure} has no control {', '.join(settings)}")
    place = [each.name for each in shown.readouts].index(readout)
    return float(shown.compute([row])[0, place])


def digit_and_power(x: float) -> tuple[int, int]:
    """A number rounded to one digit: 0.0021 → (2, −3)."""
    digit, power = f"{x:.0e}".split("e")
    return int(digit), int(power)
