"""Code that runs in the page: *Run* under each cell, by Python in the browser (Pyodide).

Until it is pressed a page has only `run_buttons.js`, which adds the buttons. Then come `cells.js`
(cells to run and reset), `editor.js` (CodeMirror, once the reader is in a cell), `worker.js` (loads
Python, off the page's thread) and `cells.py` (runs a cell in it, and judges a program).
`courseware.run.page` puts these files into the site.

A page runs the cells that it shows. The worker is ours, 7 kB: thebe is kept at an old Pyodide, and
the kernel of JupyterLite needs parts of JupyterLab and 14 wheels before the first line runs.
"""

import hashlib
from importlib.resources import files

from courseware.script.parts import Part, provide, register

FETCHED = ("cells.js", "editor.js", "worker.js", "cells.py")


def read_files() -> dict[str, str]:
    """Return the files that are fetched when *Run* is pressed, by name."""
    return {name: files(__name__).joinpath(name).read_text(encoding="utf-8") for name in FETCHED}


def version() -> str:
    """Return a hash of these files, so that no browser keeps an old one."""
    return hashlib.sha256("".join(read_files().values()).encode()).hexdigest()[:8]


provide("courseware/run/constants.js", lambda: {"VERSION": version()})
register(
    Part(
        name="run",
        page="courseware/run/run_buttons.js:addRunButtons",
        styles=("courseware/run/run.css",),
    )
)
