"""Compile controls, looks and units to the data that the script draws from."""

import math
from typing import Any

from courseware.equations.quantities import NamedSymbol, find_kind, refuse_unknown_kind
from courseware.equations.text import format_symbol
from courseware.figures.controls import Choice, Clock, Control, QuarterTurns, Slider
from courseware.units import figure_unit


def find_look(kind: Any, chapter: str, label: str | None = None) -> dict[str, Any]:
    """Return the look and label of a kind; of a quantity its letter and its key, too."""
    if not isinstance(kind, NamedSymbol):
        return {"kind": kind and refuse_unknown_kind(kind), "label": label or ""}
    letter = format_symbol(kind) if label is None else label
    return {"kind": find_kind(kind, chapter), "label": letter, "symbol": kind.key}


def serialize_unit(unit: str) -> dict[str, Any]:
    shown = figure_unit(unit)
    return {"unit": shown.name, "factor": 1 / shown.factor}


def compile_control(control: Control, chapter: str) -> dict[str, Any]:
    """Return a control's data, in the unit that the reader sees."""
    if isinstance(control, QuarterTurns):
        return {"type": "turns", "key": control.key, "start": [control.start, 1]}
    if isinstance(control, Choice):
        return _compile_choice(control)
    return _compile_slider(control, chapter)


def _compile_choice(control: Choice) -> dict[str, Any]:
    """Return a choice's data: a list of options with their numbers."""
    return {
        "type": "choice",
        "key": control.key,
        "label": control.label,
        "options": [
            {"label": label, "values": [x for _, x in zip(control.symbols, values, strict=True)]}
            for label, values in control.options.items()
        ],
        "start": list(control.options).index(control.start),
    }


def _compile_slider(slider: Slider, chapter: str) -> dict[str, Any]:
    """Return a slider's data; its look is the quantity's unless it has one of its own."""
    unit = figure_unit(slider.symbol.unit)
    data = find_look(slider.symbol, chapter, slider.label) | {
        "type": "slider",
        "key": slider.key,
        "unit": unit.name,
        "factor": unit.factor,
        "whole": isinstance(slider.step, int),
    }
    if slider.kind:
        data["kind"] = refuse_unknown_kind(slider.kind)
    numbers = ["low", "high", "start", "step"]
    if isinstance(slider, Clock):
        data |= {"type": "clock", "loops": slider.loops}
        numbers.append("rate")
    data |= {name: _round_off(getattr(slider, name) / unit.factor) for name in numbers}
    return data | {"digits": max(0, -math.floor(math.log10(data["step"]) + 1e-9))}


def _round_off(number: float) -> float:
    """Return 90 for 90.00000000000001, so that the reader sees what was meant."""
    rounded = float(f"{number:.12g}")
    return int(rounded) if rounded.is_integer() else rounded
