"""From a declaration to the object that the script draws: data, and functions made from SymPy."""

import json
import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import sympy as sp

from courseware.equations.equation import Where
from courseware.equations.quantities import (
    NamedSymbol,
    describe_symbols,
    find_kind,
    refuse_unknown_kind,
)
from courseware.equations.text import format_symbol
from courseware.errors import CourseError
from courseware.figures import declaration as d
from courseware.figures.javascript import compile_function
from courseware.figures.solids import Solid
from courseware.figures.turning import Bracket, QuarterTurns
from courseware.line_breaks import prevent_breaks
from courseware.units import figure_unit

_JS_NAMES = {"inf": "Infinity", "-inf": "-Infinity", "nan": "NaN"}
Control = d.Slider | d.Choice | QuarterTurns


def settings(controls: Sequence[Control]) -> list[sp.Symbol]:
    """Return the symbols that controls set, in order."""
    return [symbol for control in controls for symbol in control.symbols]


def xy(*places: d.Place) -> list[Any]:
    """The coordinates of places, one after the other."""
    return [x for place in places for x in place[:2]]


# type → its word in the script, what is computed, what is given as it is
SHAPES: dict[type, tuple[str, Callable[[Any], Iterable[Any]], tuple[str, ...]]] = {
    d.Point: ("point", lambda s: xy(s.at), ("edge",)),
    d.Line: ("line", lambda s: xy(*s.points), ()),
    d.Arrow: ("arrow", lambda s: xy(s.tail, s.head), ()),
    d.Wheel: ("wheel", lambda s: (*xy(s.at), s.angle, s.roll), ("length", "width")),
    d.Disc: ("disc", lambda s: (*xy(s.at), s.angle), ("radius", "spokes")),
    d.Area: ("area", lambda s: xy(*s.points), ()),
    d.Length: ("length", lambda s: xy(s.start, s.end), ("aside",)),
    d.Label: ("label", lambda s: xy(s.at), ()),
    d.Body: ("body", lambda s: (*xy(s.at), s.angle), ("radius",)),
    d.AngleArc: ("angle", lambda s: (*xy(s.at), s.start, s.end), ("radius",)),
    d.Curve: ("curve", lambda s: (s.low, s.high), ()),
    d.Trail: ("trail", lambda s: (), ("line", "dots")),
    Solid: ("solid", lambda s: s.numbers, ("data", "floor", "opacity", "behind")),
    Bracket: ("bracket", lambda s: (*xy(s.at), *s.matrix), ("columns", "digits")),
}


class Compiler:
    """Collects the expressions of one figure, so that all of them become one function."""

    def __init__(
        self, controls: Sequence[Control], shapes: Sequence[Any], where: Where, chapter: str
    ) -> None:
        self.controls, self.chapter = controls, chapter
        self.settings = settings(controls)
        trails = [s.recurrence for s in shapes if isinstance(s, d.Trail)]
        self.recurrences = list({id(r): r for r in trails}.values())
        self.ends = [s for r in self.recurrences for s in r.ends]
        self.where = where
        self.expressions: list[Any] = []

    @property
    def known(self) -> list[sp.Symbol]:
        """The symbols that every expression may use."""
        return [*self.settings, *self.ends, *(symbol for symbol, _ in self.where)]

    def numbers(self, *expressions: Any) -> list[int]:
        """Note expressions to be computed; their places in the list of values."""
        self.expressions += expressions
        return list(range(len(self.expressions) - len(expressions), len(self.expressions)))

    def face(self, kind: Any, label: str | None = None) -> dict[str, Any]:
        """Look and label of what has a kind; of a quantity its letter and its key, too."""
        if not isinstance(kind, NamedSymbol):
            return {"kind": kind and refuse_unknown_kind(kind), "label": label or ""}
        letter = format_symbol(kind) if label is None else label
        return {"kind": find_kind(kind, self.chapter), "label": letter, "symbol": kind.key}

    def control(self, control: Control) -> dict[str, Any]:
        """A control as the script reads it, in the unit that the reader sees."""
        if isinstance(control, d.Choice):
            _refuse_wrong_choice(control)
            options = [{"label": k, "values": list(v)} for k, v in control.options.items()]
            start = list(control.options).index(control.start)
            return {
                "type": "choice",
                "key": control.key,
                "label": control.label,
                "options": options,
                "start": start,
            }
        if isinstance(control, QuarterTurns):
            return {"type": "turns", "key": control.key, "start": [control.start, 1]}
        if not isinstance(control.symbol, NamedSymbol):
            raise CourseError(f"the control {control.symbol} is no declared quantity")
        _refuse_wrong_slider(control)
        face = self.face(control.symbol, control.label)
        known = control.symbol
        unit = figure_unit(known.unit)
        scale = unit.factor
        step = _tidy(control.step / scale)
        return {
            "type": "clock" if isinstance(control, d.Clock) else "slider",
            "key": control.key,
            **face,
            "kind": self.face(control.kind)["kind"] or face["kind"],
            "unit": unit.name,
            "factor": scale,
            "low": _tidy(control.low / scale),
            "high": _tidy(control.high / scale),
            "start": _tidy(control.start / scale),
            "step": step,
            "digits": max(0, -math.floor(math.log10(step) + 1e-9)),
            "rate": _tidy(control.rate / scale),
            "loops": isinstance(control, d.Clock) and control.loops,
            "whole": isinstance(control.step, int),
        }

    def shape(self, shape: Any) -> dict[str, Any]:
        """A shape as the script reads it: its numbers by place, its curve as a function."""
        if type(shape) not in SHAPES:
            raise CourseError(f"{shape!r} is not a shape")
        word, coordinates, sizes = SHAPES[type(shape)]
        found = self.face(shape.kind, getattr(shape, "label", ""))
        if not found["kind"]:
            raise CourseError(
                f"{shape.kind} has no look: add it to LOOKS in formulas.py of {self.chapter}, "
                "or give the shape the name of a kind"
            )
        depth = getattr(shape, "depth", None)
        if depth is not None and not isinstance(shape, d.Curve):
            found["depth"] = self.numbers(depth)[0]
        found |= {"shape": word, "at": self.numbers(*coordinates(shape))}
        found |= {size: getattr(shape, size) for size in sizes}
        for part in found.get("data", ()):
            part["kind"] = self.face(part["kind"])["kind"]
        if isinstance(shape, d.Curve):
            traced = xy(shape.at) if depth is None else [*shape.at, depth]
            point = compile_function({"c": self.known, "s": [shape.parameter]}, traced)
            found |= {"point": Code(point), "samples": shape.samples}
        if isinstance(shape, d.Trail):
            point = compile_function({"c": self.known, "s": shape.recurrence.state}, xy(shape.at))
            index = self.recurrences.index(shape.recurrence)
            found |= {"recurrence": index, "point": Code(point)}
        return found

    def sliders(self, symbols: Iterable[Any], who: str) -> list[int]:
        """The places of the sliders that somebody moves."""
        keys = [getattr(c, "symbol", None) for c in self.controls]
        for symbol in symbols:
            if symbol not in keys:
                raise CourseError(
                    f"{who} sets {describe_symbols([symbol], keys)}, which is no slider"
                )
        return [keys.index(symbol) for symbol in symbols]

    def handle(self, handle: d.Handle) -> dict[str, Any]:
        """A handle: where it is, which controls it sets, and the function from pointer to them."""
        code = compile_function({"c": self.known, "p": d.POINTER}, list(handle.sets.values()))
        return {
            "label": handle.label,
            "at": self.numbers(*xy(handle.at)),
            "sets": self.sliders(handle.sets, f"the handle {handle.label!r}"),
            "to": Code(code),
        }

    def goal(self, goal: d.Goal) -> dict[str, Any]:
        """A goal: its number is 1 when it is reached, else 0."""
        reached = sp.Piecewise((1, goal.condition), (0, True))
        return {"words": prevent_breaks(goal.words), "at": self.numbers(reached)[0]}

    def recurrence(self, loop: d.Recurrence) -> dict[str, Any]:
        """A loop: functions for its start, its step and how often."""
        given = {"c": self.settings}
        try:
            return {
                "start": Code(compile_function(given, loop.start)),
                "step": Code(compile_function({**given, "s": loop.state}, loop.step)),
                "count": Code(compile_function(given, [loop.count])),
                "most": loop.most,
            }
        except CourseError as error:
            raise CourseError(f"in a recurrence, which comes before `where`, {error}") from error

    def readout(self, readout: d.Readout) -> dict[str, Any]:
        """A readout: its number comes at its own place in the list of values."""
        self.numbers(readout.value)
        if unknown := set(readout.words) - set(_JS_NAMES):
            raise CourseError(
                f"the readout {readout.name} has a word for {', '.join(unknown)}; words can stand "
                f"for {', '.join(_JS_NAMES)}"
            )
        return {
            "key": readout.name,
            **self.face(readout.symbol or "", readout.label),
            "unit": figure_unit(readout.unit).name,
            "factor": 1 / figure_unit(readout.unit).factor,
            "digits": readout.digits,
            "words": {_JS_NAMES[value]: word for value, word in readout.words.items()},
        }

    def known_steps(self) -> list[dict[str, Any]]:
        """The named steps that are quantities, with their places among all known numbers."""
        start = len(self.known) - len(self.where)
        return [
            {
                "key": str(symbol),
                "symbol": symbol.key,
                "at": start + place,
                "unit": figure_unit(symbol.unit).name,
                "factor": 1 / figure_unit(symbol.unit).factor,
            }
            for place, (symbol, _) in enumerate(self.where)
            if isinstance(symbol, NamedSymbol)
        ]

    def steps(self) -> "Code":
        """The function that computes the named steps, from settings and last states."""
        given = {"c": [*self.settings, *self.ends]}
        return Code(compile_function(given, [symbol for symbol, _ in self.where], self.where))

    def code(self) -> "Code":
        """The one function that computes every noted expression."""
        return Code(compile_function({"c": self.known}, self.expressions))


class Code(str):
    """JavaScript source, as opposed to a text."""


def serialize(value: Any) -> str:
    """A JavaScript literal; `Code` stands in it as it is."""
    if isinstance(value, Code):
        return str(value)
    if isinstance(value, dict):
        pairs = (f"{json.dumps(k)}: {serialize(v)}" for k, v in value.items())
        return "{" + ", ".join(pairs) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(serialize, value)) + "]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _tidy(number: float) -> float:
    """90.0 for 90.00000000000001: what a reader sees is round where it was meant to be."""
    rounded = float(f"{number:.12g}")
    return int(rounded) if rounded.is_integer() else rounded


def _refuse_wrong_choice(choice: d.Choice) -> None:
    for option, values in choice.options.items():
        if len(values) != len(choice.symbols):
            raise CourseError(
                f"the option {option!r} of {choice.name} must give a number to each of "
                f"{', '.join(map(str, choice.symbols))}, got {len(values)}"
            )
    if choice.start not in choice.options:
        known = ", ".join(choice.options)
        raise CourseError(f"{choice.name} must start at one of {known}, got {choice.start!r}")


def _refuse_wrong_slider(s: d.Slider) -> None:
    if not (s.low < s.high and s.low <= s.start <= s.high and 0 < s.step <= s.high - s.low):
        raise CourseError(
            f"the slider {s.symbol} goes from {s.low} to {s.high} in steps of {s.step} and starts "
            f"at {s.start}: its low end must be below its high one, its start between them, its "
            "step positive and no longer than its way"
        )
