"""The Sphinx extension of a course: how formulas, live figures and exercises get onto a page.

A cell's formula becomes a numbered equation, a cell's figure its still picture that the script
takes over, a cell's exercise a box to answer in. Directives: `{formula-checks}` (every formula
against its function), `{notation}`, `{practice} topic` (all exercises of a topic),
`{errata}` (what is wrong in the source documents), `{chapters}` (cards), `{live} figure`,
`{promise}` (what was counted and checked), `{library}` (its functions), `{downloads}` (what
notebooks need).
Settings: `course_package` (what is imported to open the course), `course_name` (the salt that
picks each student's numbers; without one the course's own name), `course_solutions`,
`course_wheels` and `course_lock` (what a downloaded notebook needs).

A figure's way: a cell stores its name (`figures/figure.py`); `outputs.py` finds the declaration by
that name and has it compiled and drawn (`figures/compiling.py`, `script/engine.py`); the page loads
the script that `files.py` writes, which brings it to life (`figures/page.js`).
"""

from importlib import import_module
from typing import Any

from myst_nb.core.render import load_mime_renders
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from workshop.site.checks import FormulaChecks
from workshop.site.directives import Errata, Library, Notation, Practice
from workshop.site.files import Downloads, add_assets, write_assets, write_downloads
from workshop.site.first import Chapters, Live, Promise
from workshop.site.outputs import Outputs


def _open_course(app: Sphinx, config: Any) -> None:
    """Import the course's package, which opens it."""
    if not config.course_package:
        raise ExtensionError(
            "set course_package in _config.yml: the package to import, such as book"
        )
    import_module(config.course_package)


def setup(app: Sphinx) -> dict[str, Any]:
    """Called by Sphinx."""
    app.add_directive("formula-checks", FormulaChecks)
    app.add_directive("notation", Notation)
    app.add_directive("practice", Practice)
    app.add_directive("chapters", Chapters)
    app.add_directive("live", Live)
    app.add_directive("promise", Promise)
    app.add_directive("library", Library)
    app.add_directive("errata", Errata)
    app.add_config_value("course_package", "", "env", str)
    app.add_config_value("course_name", "", "env", str)
    app.add_config_value("course_solutions", True, "env", bool)
    app.add_config_value("course_wheels", [], "env", list)
    app.add_config_value("course_lock", "requirements.txt", "env", str)
    load_mime_renders().append(Outputs)  # for this build alone: nothing is registered in MyST-NB
    app.connect("config-inited", _open_course)
    app.connect("html-page-context", add_assets)
    app.add_directive("downloads", Downloads)
    app.connect("env-updated", write_assets)
    app.connect("build-finished", write_downloads)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
