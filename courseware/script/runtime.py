"""The scripts and the one style sheet of a course, put together from the parts that register.

In the browser each part is an object in `courseware`, as `courseware.figures`. Its files share a
scope, in which stand its constants, what `text.js` defines, and `part`, to which they add what is
called from outside. Two functions have fixed names: `onPage()` brings to life what a page holds,
and `inNotebook(content, view)` shows the content of a widget.
"""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from courseware.errors import CourseError
from courseware.units import UNITS


@dataclass(frozen=True)
class Part:
    """What a package adds to the script: `register(Part(…))` in its `__init__.py`.

    Args:
        name: of its object in JavaScript.
        package: where the files are.
        scripts, styles: files of the package, in order.
        called_by: what stands in the text of a page that needs it.
        needs: parts that come before it.
        constants: what Python tells the script, by name; asked once a course is open.
        rules: what it tells the style sheet, likewise.
    """

    name: str
    package: str
    scripts: tuple[str, ...]
    styles: tuple[str, ...]
    called_by: str
    needs: tuple[str, ...] = ()
    constants: Callable[[], Mapping[str, Any]] = dict
    rules: Callable[[], str] = str


COMPACT = (",", ":")  # of JSON, without blanks
JOINED = "".join(name for name, unit in UNITS.items() if unit.joined)  # signs, for `text.js`
_parts: dict[str, Part] = {}


def register(part: Part) -> None:
    """Make a part known, under its name."""
    _parts[part.name] = part


def parts() -> list[str]:
    """The names of the parts that are known, sorted."""
    return sorted(_parts)


@cache
def code(name: str) -> str:
    """A part as a JavaScript expression."""
    part = _part(name)
    constants = [
        f"const {key} = {json.dumps(value, ensure_ascii=False, separators=COMPACT)};"
        for key, value in {"JOINED": JOINED, **part.constants()}.items()
    ]
    sources = [
        ("courseware.script", "text.js"),
        *((part.package, script) for script in part.scripts),
    ]
    scripts = [_text(*source) for source in sources]
    return "\n".join(['((part) => {\n"use strict";', *constants, *scripts, "return part;\n})({})"])


def rules(*names: str) -> str:
    """The style sheet of parts: the colours that all share, and their own rules."""
    texts = [_text("courseware.script", "theme.css")]
    for part in map(_part, names):
        texts += [*(_text(part.package, sheet) for sheet in part.styles), part.rules()]
    return "".join(texts)


def called_by(text: str) -> list[str]:
    """The parts that a page with this text needs, in order."""
    wanted = [part for part in _parts.values() if part.called_by in text]
    names = {name for part in wanted for name in (*part.needs, part.name)}
    return [name for name in parts() if name in names]


def script(name: str) -> str:
    """A part's script for a page: the part, and its start."""
    part = f"courseware.{name}"
    return f"globalThis.courseware ??= {{}};\n{part} = {code(name)};\n{part}.onPage();\n"


def stylesheet() -> str:
    """The style sheet of a page."""
    return rules(*parts())


def _part(name: str) -> Part:
    if name not in _parts:
        raise CourseError(f"no part {name!r} is registered; there are {', '.join(parts())}")
    return _parts[name]


def _text(package: str, name: str) -> str:
    return files(package).joinpath(name).read_text(encoding="utf-8")
