"""The Sphinx extension of a course: how formulas, live figures and exercises get onto a page.

A cell's formula becomes a numbered equation, a cell's figure its still picture that the script
takes over, a cell's exercise a box to answer in. Directives: `{formula-checks}` (every formula
against its function), `{notation}`, `{practice} topic` (all exercises of a topic),
`{errata}` (what is wrong in the source documents), `{chapters}` (cards), `{live} figure`,
`{promise}` (what was counted and checked), `{library}` (its functions), `{desk}` (the line
above the exercises, with the student's name).
Settings: `course_name` (the salt that picks each student's numbers; without one the course's own
name), `course_solutions`, `course_wheels` and `course_lock` (what a downloaded notebook needs),
`course_python` (where the Python that runs in a page comes from), `course_katex` (what sets the
formulas that it gives).

A figure's way: a cell stores its name (`figures/figure.py`); `outputs.py` finds the declaration by
that name and has it compiled and drawn (`figures/compiling.py`, `script/engine.py`); the page loads
the script that `files.py` writes, which brings it to life (`figures/page.js`).
"""

from typing import Any

from myst_nb.core.render import load_mime_renders
from sphinx.application import Sphinx

from courseware.course import course
from courseware.site import predictions, run
from courseware.site.checks_page import FormulaChecks
from courseware.site.directives import (
    Desk,
    Errata,
    Library,
    Notation,
    Practice,
    keep_quotes,
    skip_fields,
)
from courseware.site.files import add_assets, write_assets, write_downloads
from courseware.site.home_page import Chapters, Live, Promise
from courseware.site.outputs import Outputs, refuse_names_of_headings
from courseware.site.sources import list_files
from courseware.symbols.page import mark_formulas

SETTINGS = {  # name → what it is without, what it must be, an example
    "course_name": ("", "a text, in quotes", '"kinematics-2026"'),
    "course_solutions": (True, "true or false, without quotes", "true"),
    "course_wheels": ([], "a list of folders", "[., courseware, book]"),
    "course_python": (
        "https://cdn.jsdelivr.net/pyodide/v314.0.6/full/",
        "an address with a slash at its end, in quotes",
        '"https://cdn.jsdelivr.net/pyodide/v314.0.6/full/"',
    ),
    "course_katex": ("", "the name of a file in the site's `_static`, in quotes", '"katex.min.js"'),
    "course_lock": ("requirements.txt", "the name of a file, in quotes", '"requirements.txt"'),
}


def _open_course(app: Sphinx, config: Any) -> None:
    """Check the settings and open the course."""
    for name, (default, words, example) in SETTINGS.items():
        value = getattr(config, name)
        texts = value if isinstance(value, list) else [""]
        if type(value) is not type(default) or not all(isinstance(text, str) for text in texts):
            _refuse(name, f"is {value!r}: it must be {words}, such as `{name}: {example}`")
    root = course().folder.parent
    for name in ("course_wheels", "course_lock"):
        value = getattr(config, name)
        for file in value if isinstance(value, list) else [value]:
            if not (root / file).exists():
                _refuse(name, f"names {file!r}, which is not in {root}")


def _refuse(setting: str, words: str) -> None:
    """End the build with a sentence: of an error Jupyter Book shows tracebacks."""
    raise SystemExit(f"{setting} in _config.yml {words}")


def setup(app: Sphinx) -> dict[str, Any]:
    """Called by Sphinx."""
    app.add_directive("formula-checks", FormulaChecks)
    app.add_directive("notation", Notation)
    app.add_directive("desk", Desk)
    app.add_directive("practice", Practice)
    app.add_directive("chapters", Chapters)
    app.add_directive("live", Live)
    app.add_directive("promise", Promise)
    app.add_directive("library", Library)
    app.add_directive("errata", Errata)
    for name, (default, *_) in SETTINGS.items():
        # with text allowed, Sphinx leaves "no" as it is: without, it would be true
        app.add_config_value(name, default, "env", (type(default), str))
    load_mime_renders().append(Outputs)  # for this build alone: nothing is registered in MyST-NB
    app.connect("config-inited", _open_course)
    app.connect("builder-inited", list_files)
    app.connect("autodoc-skip-member", skip_fields)
    app.connect("object-description-transform", keep_quotes)
    app.connect("doctree-read", refuse_names_of_headings)
    app.connect("doctree-resolved", mark_formulas)
    app.connect("html-page-context", add_assets)
    predictions.setup(app)
    run.setup(app)
    app.connect("env-updated", write_assets)
    app.connect("build-finished", write_downloads)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
