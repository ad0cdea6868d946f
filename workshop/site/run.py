"""What *Run* fetches when it is pressed: Python's address, the course's wheels, its own files.

`course_python` in `_config.yml` is the public address of Pyodide, or empty: then there is no *Run*.
The environment's PYODIDE names a folder with it instead, which is copied into the site.
"""

import json
import os
import shutil
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

from workshop import run
from workshop.errors import CourseError
from workshop.site.files import wheel_name, write_static

NEEDED = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
LOCK = "pyodide-lock.json"
PACKAGES = ("numpy", "sympy", "matplotlib")  # with what they need
FOLDER = "python"  # in `_static`, if the site has Python itself


def own_python(app: Sphinx) -> Path | None:
    """The folder with Pyodide that the build is given, if it is."""
    name = os.environ.get("PYODIDE")
    return Path(name).resolve() if name else None


def allowed(app: Sphinx, body: str) -> str:
    """What the policy of a page must allow besides the site's own files, for *Run*."""
    if "cell_input" not in body:
        return ""
    place = "" if own_python(app) else f" {app.config.course_python}"
    connect = f"; connect-src 'self'{place}" if place else ""
    return f"; script-src 'self' 'wasm-unsafe-eval'{place}{connect}"


def read_setting(app: Sphinx, config: Any) -> None:
    """The folder is a setting like others: where it changes, the pages do."""
    folder = own_python(app)
    if folder and (missing := [name for name in (*NEEDED, LOCK) if not (folder / name).exists()]):
        raise SystemExit(
            f"PYODIDE={folder} has no {', '.join(missing)}: it must be the folder `pyodide` of a "
            "release of Pyodide, unpacked"
        )
    config.course_folder = str(folder or "")


def write_files(app: Sphinx, env: Any) -> None:
    """The files that *Run* fetches, and where it finds the rest."""
    if app.builder.format != "html":
        return
    for name, text in run.fetched().items():
        write_static(app, f"run/{name}", text)
    folder, katex = own_python(app), app.config.course_katex
    wheels = [wheel_name(name) for name in app.config.course_wheels]
    settings = {
        "python": f"../{FOLDER}/" if folder else app.config.course_python,
        "katex": f"../{katex}" if katex else "",
        "cells": f"cells.py?v={run.version()}",
        "wheels": [f"../../_sources/{name}" for name in wheels],
    }
    write_static(app, "run/settings.json", json.dumps(settings))
    if folder:
        copy_python(folder, Path(app.outdir) / "_static" / FOLDER)


def copy_python(folder: Path, target: Path) -> None:
    """Python itself, and of its packages those that the course can need."""
    target.mkdir(parents=True, exist_ok=True)
    packages = json.loads((folder / LOCK).read_text("utf-8"))["packages"]
    wanted, names = list(PACKAGES), set[str]()
    while wanted:
        name = wanted.pop()
        if name not in names:
            names.add(name)
            wanted += packages[name]["depends"]
    for file in (*NEEDED, LOCK, *(packages[name]["file_name"] for name in sorted(names))):
        if not (folder / file).exists():
            raise CourseError(
                f"{folder} has no {file}: take the full release of Pyodide, not its core"
            )
        shutil.copy(folder / file, target)


def setup(app: Sphinx) -> None:
    """Called by the site's extension."""
    app.add_config_value("course_folder", "", "html", str)
    app.connect("config-inited", read_setting)
    app.connect("env-updated", write_files)
