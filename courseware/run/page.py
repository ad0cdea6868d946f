"""Files that *Run* fetches when it is pressed: settings, programs, wheels, its own scripts."""

import json
from pathlib import Path
from typing import Any

from hatchling.builders.wheel import WheelBuilder
from sphinx.application import Sphinx

from courseware import run
from courseware.course import course
from courseware.programs.notebook import serialize
from courseware.programs.picture import answer_figure
from courseware.programs.program import all_programs
from courseware.script.page import write_static


def write_files(app: Sphinx, env: Any) -> None:
    """Write the files that *Run* fetches, and the addresses of the others."""
    if app.builder.format != "html":
        return
    for name, text in run.read_files().items():
        write_static(app, f"run/{name}", text)
    wheels = [wheel_name(name) for name in app.config.course_wheels]
    settings = {
        "python": app.config.course_python,
        "katex": f"../{app.config.course_katex}",
        "editor": f"../{app.config.course_editor}",
        "cells": f"cells.py?v={run.version()}",
        "wheels": [f"../../_sources/{name}" for name in wheels],
    }
    write_static(app, "run/settings.json", json.dumps(settings))
    for name, program in all_programs().items():
        write_static(app, f"programs/{name}.json", serialize(program))
        code = answer_figure(program).code
        write_static(app, f"programs/{name}.js", f"export default {code};\n")


def project_path(name: str) -> Path:
    return course().folder.parent / name


def wheel_name(project: str) -> str:
    metadata = WheelBuilder(str(project_path(project))).metadata
    name = metadata.core.name.replace("-", "_")
    return f"{name}-{metadata.version}-py3-none-any.whl"


def setup(app: Sphinx) -> None:
    app.connect("env-updated", write_files)
