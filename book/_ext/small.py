"""The site's scripts made small, when the book is built: shorter names, no blanks.

Terser runs in V8, which comes as the wheel `mini-racer`. A script that it cannot read fails the
build.
"""

import json
from pathlib import Path

from py_mini_racer import MiniRacer

TERSER = Path(__file__).parents[1] / "_vendor" / "terser" / "terser.min.js"
# the theme's others are small already
OWN = ("site.js", "search.js", "minisearch.js", "doctools.js", "copybutton.js", "workshop/*.js",
       "run/*.js", "pages/*.js")  # fmt: skip
BEFORE = "globalThis.sourceMap = {}; globalThis.performance = Date; globalThis.process = {env: {}};"


def minify(scripts):
    """The same scripts, smaller."""
    engine = MiniRacer()
    try:
        engine.eval(f"{BEFORE} 0")
        engine.eval(f"{TERSER.read_text('utf-8')}; 0")
        small = "(script) => Terser.minify_sync(script).code"
        return [engine.eval(f"({small})({json.dumps(script)})") for script in scripts]
    finally:
        engine.close()


def make_small(app, error):
    """Writes the site's scripts anew."""
    if error or app.builder.format != "html":
        return
    static = Path(app.outdir, "_static")
    files = [file for names in OWN for file in static.glob(names)]
    scripts = minify(file.read_text("utf-8") for file in files)
    for file, script in zip(files, scripts, strict=True):
        file.write_text(script, "utf-8")


def setup(app):
    """Called by Sphinx; after the machine has written its script."""
    app.connect("build-finished", make_small, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
