"""The scripts and the one style sheet of a course, put together from the parts that register."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from courseware.script.modules import join_modules

Constants = Callable[[], Mapping[str, Any]]


@dataclass(frozen=True)
class Part:
    """A package's contribution to the script: `register(Part(…))` in its `__init__.py`.

    Args:
        name: of the part.
        page: the module whose function starts it on a page, a colon, and the function's name.
        widget: likewise the function that shows it in a notebook.
        styles: paths of its style sheets.
        rules: what Python adds to them; asked once a course is open.
    """

    name: str
    page: str
    widget: str = ""
    styles: tuple[str, ...] = ()
    rules: Callable[[], str] = str


_parts: dict[str, Part] = {}
_constants: dict[str, Constants] = {}


def register(part: Part) -> None:
    """Make a part known, under its name."""
    _parts[part.name] = part


def provide(path: str, constants: Constants) -> None:
    """Tell the script what Python knows, once a course is open: a module that is no file.

    constants: returns its exports by name.
    """
    _constants[path] = constants


def list_parts() -> list[str]:
    return sorted(_parts)


def bundle_pages() -> str:
    """Return the script of all pages: what the parts export, and their start."""
    entries, starts = zip(*(_parts[name].page.split(":") for name in list_parts()), strict=True)
    calls = "".join(f"courseware.{start}();\n" for start in starts)
    runs = 'document.documentElement.dataset.scripts ??= "";'  # for the rules of the style
    return f"globalThis.courseware = {bundle(*entries)};\n{runs}\n{calls}"


def bundle_widget(name: str) -> str:
    """Return what shows a part in a notebook, as a JavaScript expression."""
    entry, function = _parts[name].widget.split(":")
    return f"({bundle(entry)}).{function}"


def bundle_all() -> str:
    """Return an expression for all parts: an object of all that they export."""
    entries = (entry for part in _parts.values() for entry in (part.page, part.widget))
    return bundle(*(entry.split(":")[0] for entry in entries if entry))


@cache
def bundle(*entries: str) -> str:
    """Join modules, and what they import, to an expression."""
    return join_modules(entries, _read)


def join_styles(*names: str) -> str:
    """Return the style sheet of parts, or of all: the colours that all share, and their rules."""
    texts = [_read("courseware/script/theme.css")]
    for name in names or list_parts():
        texts += [*map(_read, _parts[name].styles), _parts[name].rules()]
    return "".join(texts)


def _read(path: str) -> str:
    if path in _constants:
        compact = json.JSONEncoder(ensure_ascii=False, separators=(",", ":"))
        constants = _constants[path]().items()
        return "".join(f"export const {name} = {compact.encode(x)};\n" for name, x in constants)
    package, _, name = path.partition("/")
    return files(package).joinpath(name).read_text(encoding="utf-8")
