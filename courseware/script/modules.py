"""Join ES modules to one script: V8, a widget and a page from disk can fetch no second file.

All modules share one scope, so a name is declared once in all of them, at the start of a line.
"""

import re
from collections.abc import Callable, Iterable
from posixpath import dirname, join, normpath

IMPORT = re.compile(r'^import \{[^}]*\} from "([^"]+)";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:const|let|class|(?:async )?function) (\w+))", re.MULTILINE)
# what the browser does not need: comments, empty lines, the space before others
SPARE = re.compile(r"^ *(?://.*|/\*\*(?:.|\n)*?\*/)?\n|^ +", re.MULTILINE)


def join_modules(entries: Iterable[str], read: Callable[[str], str]) -> str:
    """Return a JavaScript expression: an object of all that the modules export.

    Args:
        entries: paths of modules; what they import is joined before them.
        read: the text of the module at a path.
    """
    joined: set[str] = set()
    exports: list[str] = []
    bodies: list[str] = []

    def add(path: str) -> None:
        if path in joined:
            return
        joined.add(path)
        text = read(path)
        for source in IMPORT.findall(text):
            add(normpath(join(dirname(path), source)))
        body = IMPORT.sub("", text)
        exports.extend(EXPORT.findall(body))
        bodies.append(SPARE.sub("", EXPORT.sub("", body)))

    for entry in entries:
        add(entry)
    return f'(() => {{\n"use strict";\n{"".join(bodies)}return {{ {", ".join(exports)} }};\n}})()'
