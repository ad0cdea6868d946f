"""Files that *Run* fetches when it is pressed: settings, programs, wheels, its own scripts.

`course_python` is the public address of Pyodide. If the environment's PYODIDE names a folder with
an unpacked release, that is copied into the site, and no other site is asked.
"""

import json
import os
import shutil
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from packaging.utils import canonicalize_name
from sphinx.application import Sphinx

from courseware import run
from courseware.errors import CourseError
from courseware.programs.declaration import all_programs
from courseware.programs.notebook import serialize
from courseware.programs.picture import answer_figure
from courseware.site.assets import wheel_name, write_static

NEEDED = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
LOCK = "pyodide-lock.json"
# imported by chapters and by JupyterLite's kernel
PACKAGES = (
    *("numpy", "pyyaml", "sympy", "matplotlib"),
    *("ipython", "jedi", "micropip", "typing-extensions"),
)
FOLDER = "python"  # in `_static`, if the site has Python itself


def own_python() -> Path | None:
    """Return the folder with Pyodide that the environment names, if it does."""
    name = os.environ.get("PYODIDE")
    return Path(name).resolve() if name else None


def check_folder(app: Sphinx, config: Any) -> None:
    """Refuse a folder that is no release of Pyodide."""
    folder = own_python()
    if folder and (missing := [name for name in (*NEEDED, LOCK) if not (folder / name).exists()]):
        raise SystemExit(
            f"PYODIDE={folder} has no {', '.join(missing)}: it must be the folder `pyodide` of a "
            "release of Pyodide, unpacked"
        )


def write_files(app: Sphinx, env: Any) -> None:
    """Write the files that *Run* fetches, and the addresses of the others."""
    if app.builder.format != "html":
        return
    for name, text in run.read_files().items():
        write_static(app, f"run/{name}", text)
    folder, katex = own_python(), app.config.course_katex
    wheels = [wheel_name(name) for name in app.config.course_wheels]
    settings = {
        "python": f"../{FOLDER}/" if folder else app.config.course_python,
        "katex": f"../{katex}" if katex else "",
        "editor": f"../{app.config.course_editor}",
        "cells": f"cells.py?v={run.version()}",
        "wheels": [f"../../_sources/{name}" for name in wheels],
    }
    write_static(app, "run/settings.json", json.dumps(settings))
    for name, program in all_programs().items():
        write_static(app, f"programs/{name}.json", serialize(program))
        code = answer_figure(program).code
        write_static(app, f"programs/{name}.js", f"export default {code};\n")
    if folder:
        copy_python(folder, Path(app.outdir) / "_static" / FOLDER)


def copy_python(folder: Path, target: Path) -> None:
    """Copy Python and those of its packages that the course can need."""
    target.mkdir(parents=True, exist_ok=True)
    packages = json.loads((folder / LOCK).read_text("utf-8"))["packages"]
    wheels = [packages[name]["file_name"] for name in with_dependencies(packages, PACKAGES)]
    for file in (*NEEDED, LOCK, *wheels):
        if not (folder / file).exists():
            raise CourseError(f"PYODIDE={folder} has no {file}: it must be a whole release")
        shutil.copy(folder / file, target)


def with_dependencies(packages: Mapping[str, Any], names: Iterable[str]) -> list[str]:
    """Return the names of packages and of all their dependencies."""
    found, wanted = set[str](), list(names)
    while wanted:
        name = canonicalize_name(wanted.pop())
        if name not in found:
            found.add(name)
            wanted += packages[name]["depends"]
    return sorted(found)


def setup(app: Sphinx) -> None:
    app.connect("config-inited", check_folder)
    app.connect("env-updated", write_files)
