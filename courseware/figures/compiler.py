"""Compile a declaration to the object that the script draws: data, and functions from SymPy."""

import json
from collections.abc import Callable, Iterable, Sequence
from hashlib import blake2b
from itertools import chain, groupby
from typing import Any

import sympy as sp

from courseware.course import course
from courseware.equations.javascript import Code, compile_javascript
from courseware.equations.quantities import NamedSymbol
from courseware.errors import CourseError
from courseware.figures import shapes as s
from courseware.figures.computed_parts import Goal, Place, Readout, Recurrence
from courseware.figures.control_compiler import compile_control, find_look, serialize_unit
from courseware.figures.controls import POINTER, Button, Control, Handle
from courseware.figures.solids import Solid
from courseware.figures.sprites import Outline, Rim, Sprite, list_corners
from courseware.units.line_breaks import prevent_breaks

_JS_NAMES = {"inf": "Infinity", "-inf": "-Infinity", "nan": "NaN"}


def coordinates(*places: Place) -> list[Any]:
    """Return the coordinates of places, one after the other."""
    return [x for place in places for x in place[:2]]


STRAIGHT = set("MLz 0123456789.-")  # of a path

# type → its name in the script, the numbers that are computed, the fields that are passed on
SHAPES: dict[type, tuple[str, Callable[[Any], Iterable[Any]], tuple[str, ...]]] = {
    s.Point: ("point", lambda x: coordinates(x.at), ()),
    s.Line: ("line", lambda x: coordinates(*x.points), ()),
    s.Arrow: ("arrow", lambda x: coordinates(x.tail, x.head), ()),
    s.Area: ("area", lambda x: coordinates(*x.points), ()),
    s.Length: ("length", lambda x: coordinates(x.start, x.end), ("aside",)),
    s.Label: ("label", lambda x: coordinates(x.at), ()),
    s.AngleArc: ("angle", lambda x: (*coordinates(x.at), x.start, x.end), ("radius",)),
    s.Curve: ("curve", lambda x: (x.low, x.high), ("samples",)),
    s.Trail: ("trail", lambda x: (), ("dots",)),
    s.Track: ("track", lambda x: coordinates(x.at), ("name",)),
    s.Cloud: ("cloud", lambda x: (), ("rows",)),
    s.Bracket: (
        "bracket",
        lambda x: (*coordinates(x.at), *x.matrix),
        ("columns", "digits", "by_row"),
    ),
}


def serialize(value: Any) -> str:
    """Return a JavaScript literal; `Code` is copied as it is."""
    if isinstance(value, Code):
        return str(value)
    if isinstance(value, dict):
        pairs = (f"{json.dumps(k)}:{serialize(v)}" for k, v in value.items())
        return "{" + ",".join(pairs) + "}"
    if isinstance(value, list):
        return "[" + ",".join(map(serialize, value)) + "]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


class Compiler:
    """Collect the expressions of one figure, so that all of them become one function."""

    def __init__(self, figure: Any, chapter: str) -> None:
        self.figure, self.chapter = figure, chapter
        trails = [shape.recurrence for shape in figure.shapes if isinstance(shape, s.Trail)]
        self.recurrences = list({id(loop): loop for loop in trails}.values())
        ends = (end for loop in self.recurrences for end in loop.ends)
        self.before_where = [*figure.control_symbols, *ends]
        self.named = [symbol for symbol, _ in figure.where]
        self.known = [*self.before_where, *self.named]
        self.expressions: list[Any] = []
        self.drawings: dict[str, list[Any]] = {}

    def compile_figure(self) -> dict[str, Any]:
        """Return the object that the script draws; the readouts' numbers come first."""
        figure = self.figure
        data = {
            "name": figure.name,
            "title": figure.title,
            "size": figure.size,
            "view": list(figure.view),
            "sentence": figure.sentence,
            "grid": figure.grid and not figure.view_angles,
            "readouts": list(map(self.compile_readout, figure.readouts)),
            "controls": [self.compile_control(c) for c in figure.controls],
            "shapes": list(map(self.compile_shape, figure.shapes)),
            "drawings": self.drawings,
            "ground": figure.ground,
            "handles": list(map(self.compile_handle, figure.handles)),
            "buttons": list(map(self.compile_button, figure.buttons)),
            "goals": list(map(self.compile_goal, figure.goals)),
            "follow": self.add(*coordinates(figure.follow)) or None,
            "contain": self.add(*coordinates(*figure.contain)) or None,
            "viewAngles": self.find_sliders(figure.view_angles) or None,
            "steps": self.list_quantities(),
            "recurrences": list(map(self.compile_recurrence, self.recurrences)),
            "where": compile_javascript({"c": self.before_where}, self.named, figure.where),
            "compute": self._compile(self.expressions),
        }
        return {key: value for key, value in data.items() if value is not None}

    def add(self, *expressions: Any) -> list[int]:
        """Add expressions to be computed; return their places in the list of values."""
        self.expressions += expressions
        return list(range(len(self.expressions) - len(expressions), len(self.expressions)))

    def compile_control(self, control: Control) -> dict[str, Any]:
        """Return a control's data; with a condition, where its number is."""
        data, shown = compile_control(control, self.chapter), getattr(control, "shown", True)
        return data if shown is True else data | {"shown": self.add_condition(shown)}

    def compile_shape(self, shape: Any) -> dict[str, Any]:
        """Return a shape's data: its numbers by place, its curve as a function."""
        if isinstance(shape, Sprite):
            return {"shape": "sprite", "kind": "", "label": "", **self.compile_sprite(shape)}
        if isinstance(shape, Solid):
            return {"shape": "solid", "kind": "", "label": "", **self.compile_solid(shape)}
        name, numbers, fields = SHAPES[type(shape)]
        data = find_look(shape.kind, self.chapter, getattr(shape, "label", ""))
        if not data["kind"]:
            raise CourseError(
                f"{shape.kind} has no look: add it to LOOKS in formulas.py of {self.chapter}, "
                "or give the shape the name of a kind"
            )
        depth = getattr(shape, "depth", None)
        if depth is not None and not isinstance(shape, s.Curve):
            data["depth"] = self.add(depth)[0]
        data |= {"shape": name, "at": self.add(*numbers(shape))}
        data |= {field: getattr(shape, field) for field in fields}
        return data | self.compile_trace(shape)

    def compile_solid(self, solid: Solid) -> dict[str, Any]:
        """Return a body's data: its pose and the view by place, its meshes as they are."""
        for mesh in solid.meshes:
            printed = (tone for dots in mesh.dots.values() for _, _, _, *tone in dots)
            _refuse_unknown_paint((mesh.kind, mesh.edge, *chain.from_iterable(printed)))
        fields = {name: getattr(solid, name) for name in ("data", "floor", "opacity", "behind")}
        return {"at": self.add(*solid.numbers), **fields}

    def compile_sprite(self, sprite: Sprite, look: str = "") -> dict[str, Any]:
        """Return a sprite's data: places, and its outlines by their ids."""
        parts: list[Any] = []
        group: Any
        for kind, group in groupby(sprite.parts, type):
            if kind is Outline:
                parts.append(self.find_drawing(*group))
            else:
                parts += [self.compile_moving(part, sprite.look or look) for part in group]
        data = {"at": self.add(*sprite.at, sprite.size), "parts": parts, "height": sprite.height}
        if sprite.height or sprite.look or look:
            data["silhouette"] = self.find_drawing(Outline(sprite.silhouette or ""))
        data |= {"window": list(sprite.window)} if sprite.window else {}
        return data | {"look": sprite.look, "corners": list_corners(sprite.silhouette or "")}

    def compile_moving(self, part: Rim | Sprite, look: str) -> dict[str, Any]:
        """Return the data of a part that moves in its sprite."""
        if isinstance(part, Sprite):
            return self.compile_sprite(part, look)
        moving = {"at": self.add(part.roll), "rim": [part.radius, part.count, part.thickness]}
        if len(part.outlines) == 1 and set(part.outlines[0].path) <= STRAIGHT:
            return moving | {"lines": _compile_outline(*part.outlines)}
        return moving | {"drawing": self.find_drawing(*part.outlines)}

    def find_drawing(self, *outlines: Outline) -> str:
        """Return the id of outlines; the same ones are drawn once."""
        drawing = list(map(_compile_outline, outlines))
        name = f"rk-{blake2b(repr(drawing).encode(), digest_size=4).hexdigest()}"
        self.drawings[name] = drawing
        return name

    def compile_trace(self, shape: Any) -> dict[str, Any]:
        """Return what makes the points of a curve, trail or cloud; else nothing."""
        if isinstance(shape, s.Curve):
            place = coordinates(shape.at) if shape.depth is None else [*shape.at, shape.depth]
            return {"point": self._compile(place, s=[shape.parameter])}
        if isinstance(shape, s.Cloud):
            return {"point": self._compile(coordinates(shape.at), s=shape.symbols)}
        if isinstance(shape, s.Trail):
            index = self.recurrences.index(shape.recurrence)
            point = self._compile(coordinates(shape.at), s=shape.recurrence.state)
            return {"recurrence": index, "point": point}
        return {}

    def find_sliders(self, symbols: Iterable[Any]) -> list[int]:
        """Return the places of the sliders of symbols."""
        keys = [getattr(c, "symbol", None) for c in self.figure.controls]
        return [keys.index(symbol) for symbol in symbols]

    def compile_handle(self, handle: Handle) -> dict[str, Any]:
        """Return a handle's data: its place, its sliders, the function from pointer to them."""
        return {
            "label": handle.label,
            "at": self.add(*coordinates(handle.at)),
            "sets": self.find_sliders(handle.sets),
            "to": self._compile(list(handle.sets.values()), p=POINTER),
        }

    def compile_button(self, button: Button) -> dict[str, Any]:
        """Return a button's data: its sliders, the function to their numbers."""
        sets = self.find_sliders(button.sets)
        to = self._compile(list(button.sets.values()))
        return {"label": button.label, "sets": sets, "to": to}

    def compile_goal(self, goal: Goal) -> dict[str, Any]:
        """Return a goal's data."""
        return {"words": prevent_breaks(goal.words), "at": self.add_condition(goal.condition)}

    def add_condition(self, condition: Any) -> int:
        """Add a condition; its number is 1 where it holds, else 0."""
        return self.add(sp.Piecewise((1, condition), (0, True)))[0]

    def compile_recurrence(self, loop: Recurrence) -> dict[str, Any]:
        """Return a loop's functions: for its start, its step and how often."""
        given = {"c": self.figure.control_symbols}
        return {
            "start": compile_javascript(given, loop.start),
            "step": compile_javascript({**given, "s": loop.state}, loop.step),
            "count": compile_javascript(given, [loop.count]),
            "most": loop.most,
        }

    def compile_readout(self, readout: Readout) -> dict[str, Any]:
        """Return a readout's data; its number comes at its own place in the list of values."""
        self.add(readout.value)
        return {
            "key": readout.name,
            **find_look(readout.symbol or "", self.chapter, readout.label),
            **serialize_unit(readout.unit),
            "digits": readout.digits,
            "words": {_JS_NAMES[value]: word for value, word in readout.words.items()},
        }

    def list_quantities(self) -> list[dict[str, Any]]:
        """Return the named steps that are quantities, with their places among all known numbers."""
        return [
            {"key": str(symbol), "symbol": symbol.key, "at": place, **serialize_unit(symbol.unit)}
            for place, symbol in enumerate(self.named, len(self.before_where))
            if isinstance(symbol, NamedSymbol)
        ]

    def _compile(self, expressions: Sequence[Any], **more: Sequence[sp.Symbol]) -> Code:
        return compile_javascript({"c": self.known, **more}, expressions)


def _refuse_unknown_paint(names: Iterable[str], gradients: Iterable[str] = ()) -> None:
    known = [*course().materials.tones, *gradients]
    for name in filter(None, names):
        if name not in {*known, *course().looks}:
            raise CourseError(f"there is no material {name!r}; there are {', '.join(known)}")


def _compile_outline(outline: Outline) -> list[Any]:
    _refuse_unknown_paint((outline.fill, outline.edge), course().materials.gradients)
    return [outline.path, outline.fill, outline.edge, outline.width, outline.opacity]
