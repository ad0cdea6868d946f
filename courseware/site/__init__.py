"""The Sphinx extension of a course: formulas, live figures and exercises on pages.

A formula in a cell's output becomes a numbered equation, a figure a still picture that the script
takes over, an exercise a box for the answer. Directives: `{formula-checks}` (every formula and its
function), `{notation}`, `{practice} topic` (the exercises of a topic), `{errata}` (mistakes in the
source documents), `{chapters}` (cards), `{live} figure`, `{library}` (its functions), `{desk}` (the
line with the student's name).

Settings: `course_name` (the salt that picks each student's numbers; by default the course's own
name), `course_solutions`, `course_wheels` and `course_lock` (needed by a downloaded notebook),
`course_python` (the address of the Python that runs in a page), `course_katex` (renders the
formulas in its results), `course_editor` (in which a cell is changed).

A figure gets onto a page in three steps. A cell stores its name (`figures/figure.py`). `outputs.py`
finds the declaration and has it compiled and drawn (`figures/compiler.py`, `script/engine.py`).
The page loads the script that `assets.py` writes, which brings it to life (`figures/page.js`).
"""

from typing import Any

from myst_nb.core.render import load_mime_renders
from sphinx.application import Sphinx

from courseware.course import course
from courseware.errors import CourseError
from courseware.predictions import page as predictions
from courseware.run import page as run
from courseware.site.assets import add_assets, write_assets, write_downloads
from courseware.site.directives import Desk, Errata, Library, Practice, skip_fields
from courseware.site.home_page import Chapters, Live
from courseware.site.notation_page import Notation
from courseware.site.outputs import Outputs
from courseware.site.verification_page import FormulaChecks
from courseware.symbols.live_numbers import place_slots
from courseware.symbols.page import mark_formulas

SETTINGS: dict[str, Any] = {  # name → default
    "course_name": "",
    "course_solutions": True,
    "course_wheels": [],
    "course_python": "https://cdn.jsdelivr.net/pyodide/v314.0.6/full/",
    "course_editor": "",
    "course_katex": "katex/katex.min.js",
    "course_lock": "requirements.txt",
}


def _open_course(app: Sphinx, config: Any) -> None:
    """Open the course, read its declarations, and have MyST read what our directives write."""
    config.myst_enable_extensions = {*config.myst_enable_extensions, "colon_fence", "dollarmath"}
    try:
        for part in ("checks", "exercises", "predictions", "programs"):
            course().modules(part)
    except CourseError as error:
        raise SystemExit(str(error)) from None


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the extension with Sphinx."""
    for directive in (Chapters, Desk, Errata, Library, Live, Notation, Practice):
        app.add_directive(directive.__name__.lower(), directive)
    app.add_directive("formula-checks", FormulaChecks)
    for name, default in SETTINGS.items():
        app.add_config_value(name, default, "env")
    load_mime_renders().append(Outputs)  # for this build alone: nothing is registered in MyST-NB
    app.connect("config-inited", _open_course)
    app.setup_extension("sphinx.ext.autodoc")  # which `{library}` uses
    app.connect("autodoc-skip-member", skip_fields)
    app.connect("source-read", place_slots)
    app.connect("doctree-resolved", mark_formulas)
    app.connect("html-page-context", add_assets)
    predictions.setup(app)
    run.setup(app)
    app.connect("env-updated", write_assets)
    app.connect("build-finished", write_downloads)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
