"""A page's code runs in the page: *Run* under each cell, by Python in the browser (Pyodide).

Until it is pressed a page has `run_buttons.js` alone, which puts the buttons there. Then come
`cells.js` (cells that can be changed, run and put back), `worker.js` (loads Python, off the page's
thread) and `cells.py` (runs a cell in it). `courseware.site.run` puts these files into the site.

A page runs the cells that it shows: a test refuses a name that only a cell with `remove-input`
makes. Another runs them all and compares with what is stored.

The worker is ours because what there is brings a page more than it asks for: thebe is kept at an
old Pyodide and brings parts of JupyterLab; the kernel of JupyterLite speaks Jupyter's protocol and
so needs these parts too, and IPython, 14 wheels before the first line runs. Ours is 7 kB, shows
outputs in the page's own style, and imports what a cell names only then.
"""

import hashlib
from importlib.resources import files

from courseware.script.parts import Part, register

FETCHED = ("cells.js", "worker.js", "cells.py")


def fetched() -> dict[str, str]:
    """The files that are fetched when *Run* is pressed, by name."""
    return {name: files(__name__).joinpath(name).read_text(encoding="utf-8") for name in FETCHED}


def version() -> str:
    """Changes with these files, so that no browser keeps an old one."""
    return hashlib.sha256("".join(fetched().values()).encode()).hexdigest()[:8]


register(
    Part(
        name="run",
        page="courseware/run/run_buttons.js:addRunButtons",
        called_by="cell_input",
        styles=("courseware/run/run.css",),
        constants={"courseware/run/constants.js": lambda: {"VERSION": version()}},
    )
)
