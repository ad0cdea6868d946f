"""A page's code runs in the page: *Run* under each cell, by Python in the browser (Pyodide).

Until it is pressed a page has `loader.js` alone, which puts the buttons there. Then come `cells.js`
(cells that can be changed, run and put back), `worker.js` (loads Python, off the page's thread) and
`cells.py` (runs a cell in it). `workshop.site.run` puts these files into the site.
"""

import hashlib
from importlib.resources import files

from workshop.script.runtime import Part, register

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
        package=__name__,
        scripts=("loader.js",),
        styles=("run.css",),
        called_by="cell_input",
        constants=lambda: {"VERSION": version()},
    )
)
