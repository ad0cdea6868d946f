"""Join ES modules to one script: V8, a widget and a page from disk can fetch no second file.

All modules share one scope: a name is declared once in all of them, at the start of a line.
"""

import re
from collections.abc import Callable, Iterable
from posixpath import dirname, join, normpath

from courseware.errors import CourseError

IMPORT = re.compile(r'^import \{([^}]*)\} from "([^"]+)";\n', re.MULTILINE)
DECLARATION = re.compile(r"^(export )?(?:const|let|class|(?:async )?function) (\w+)", re.MULTILINE)
OTHER = re.compile(r"^(?:import|export)\b(?! (?:const|let|class|async|function) ).*", re.MULTILINE)
# what the browser does not need: comments, empty lines, the space before others
SPARE = re.compile(r"^ *(?://.*|/\*\*(?:.|\n)*?\*/)?\n|^ +", re.MULTILINE)


def join_modules(entries: Iterable[str], read: Callable[[str], str]) -> str:
    """Return a JavaScript expression: an object of all that the modules export.

    Args:
        entries: paths of modules; what they import is joined before them.
        read: the text of the module at a path, or a FileNotFoundError.
    """
    joined = _Joined(read)
    for entry in entries:
        joined.add(entry, ())
    exports = ", ".join(name for names in joined.exports.values() for name in names)
    return f'(() => {{\n"use strict";\n{"".join(joined.bodies)}return {{ {exports} }};\n}})()'


class _Joined:
    """Modules in an order in which each stands after those that it imports."""

    def __init__(self, read: Callable[[str], str]) -> None:
        self.read = read
        self.exports: dict[str, list[str]] = {}  # path → names
        self.declared: dict[str, str] = {}  # name → path
        self.bodies: list[str] = []

    def add(self, path: str, importers: tuple[str, ...]) -> None:
        """Join a module, unless it is there. importers: those that led to it, in order."""
        if path in importers:
            raise CourseError(f"modules import each other: {' → '.join((*importers, path))}")
        if path in self.exports:
            return
        try:
            text = self.read(path)
        except FileNotFoundError as error:
            raise CourseError(f"{' → '.join((*importers, path))}: the last is missing") from error
        for names, source in IMPORT.findall(text):
            target = normpath(join(dirname(path), source))
            self.add(target, (*importers, path))
            self._refuse_missing(names.replace(",", " ").split(), target, path)
        body = IMPORT.sub("", text)
        self._declare(path, body)
        self.bodies.append(SPARE.sub("", re.sub("^export ", "", body, flags=re.MULTILINE)))

    def _refuse_missing(self, names: list[str], target: str, path: str) -> None:
        if missing := ", ".join(name for name in names if name not in self.exports[target]):
            exported = ", ".join(self.exports[target])
            raise CourseError(f"{path} imports {missing} from {target}, which has only {exported}")

    def _declare(self, path: str, body: str) -> None:
        if other := OTHER.search(body):
            raise CourseError(f"{path} has `{other[0]}`, which is not read; see {__name__}")
        names = DECLARATION.findall(body)
        self.exports[path] = [name for exported, name in names if exported]
        for _, name in names:
            if (first := self.declared.setdefault(name, path)) != path:
                raise CourseError(f"{name} is declared in {first} and in {path}: rename one")
