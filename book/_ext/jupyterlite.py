"""JupyterLite beside the book: every chapter as a notebook that runs in the browser.

`lite/` in the site has JupyterLite, the notebooks and the course's packages; Python itself
(Pyodide) comes from `course_python`. The lock file for Pyodide lists the course's packages too: so
`import robokin` works, and no other registry is asked.

A browser keeps what a student has changed, in a place of its own for each course and version: else
an edited copy would hide every later notebook of that name.

Four places name one version of Pyodide, and tests compare them: `course_python`
(`courseware/site/__init__.py`), `book/_vendor/pyodide`, `jupyterlite-pyodide-kernel` and
`tests/pyodide.py`.
"""

import hashlib
import json
import shutil
import subprocess
import sys
import zipfile
from importlib.metadata import distribution, version
from pathlib import Path

import nbformat
from sphinx.util import logging

from courseware.course import course
from courseware.run.page import wheel_name

logger = logging.getLogger(__name__)

LOCK = Path(__file__).parents[1] / "_vendor" / "pyodide" / "pyodide-lock.json"
KERNEL = "@jupyterlite/pyodide-kernel-extension:kernel"
KERNELSPEC = {"name": "python", "display_name": "Python (Pyodide)", "language": "python"}
# packages for widgets that Pyodide lacks, taken from this environment, with their dependencies
WIDGETS = {
    "comm": ("traitlets",),
    "ipywidgets": ("comm", "ipython", "traitlets"),
    "psygnal": (),
    "anywidget": ("ipywidgets", "psygnal", "typing-extensions"),
}
COURSE = {  # our packages by the names of imports, with their dependencies
    "robokin": ("numpy",),
    "courseware": ("anywidget", "fonttools", "ipywidgets", "numpy", "pyyaml", "sympy"),
    "book": ("matplotlib", "robokin", "robokin-courseware"),
}


def notebook_address(page):
    """Return the address of a chapter's notebook, relative to its page."""
    stem = course().notebook(page.partition("/")[0]).stem
    return "../" * page.count("/") + f"lite/notebooks/index.html?path={stem}.ipynb"


def write_notebooks(folder):
    """Write all notebooks with the name of the kernel; another name would open a dialog."""
    folder.mkdir(parents=True)
    for chapter in course().taught:
        file = course().notebook(chapter)
        notebook = nbformat.read(file, as_version=4)  # joins lines
        notebook["metadata"]["kernelspec"] = KERNELSPEC
        (folder / file.name).write_text(json.dumps(notebook, ensure_ascii=False), "utf-8")


def build_wheel(name, folder):
    """Build a wheel of an installed package, without compiled parts, which are optional here."""
    found = distribution(name)
    file = folder / f"{name}-{found.version}-py3-none-any.whl"
    inside = [f for f in found.files if f.suffix != ".so" and ".." not in f.parts]
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as wheel:
        for each in sorted(f for f in inside if "__pycache__" not in f.parts):
            if each.name not in ("RECORD", "direct_url.json", "INSTALLER", "REQUESTED"):
                entry = zipfile.ZipInfo(each.as_posix())  # without the time: equal in each build
                wheel.writestr(entry, each.locate().read_bytes(), zipfile.ZIP_DEFLATED)
    return file


def write_packages(app, folder):
    """Write the wheels of course and widgets, and the lock file of all packages."""
    folder.mkdir(parents=True)
    lock = json.loads(LOCK.read_text("utf-8"))
    place = app.config.course_python
    for entry in lock["packages"].values():
        entry["file_name"] = place + entry["file_name"]
    for name, needs in WIDGETS.items():
        lock["packages"][name] = describe_wheel(build_wheel(name, folder), name, needs)
    for project, (name, needs) in zip(app.config.course_wheels, COURSE.items(), strict=True):
        wheel = wheel_name(project)
        shutil.copy(Path(app.outdir, "_sources", wheel), folder)
        entry = describe_wheel(folder / wheel, name, needs)
        lock["packages"][entry["name"]] = entry
    (folder / LOCK.name).write_text(json.dumps(lock), "utf-8")


def describe_wheel(wheel, imported, needs):
    """Return a wheel's entry in the lock file."""
    name, number, *_ = wheel.name.split("-")
    return {
        "name": name.replace("_", "-"),
        "version": number,
        "file_name": wheel.name,
        "sha256": hashlib.sha256(wheel.read_bytes()).hexdigest(),
        "package_type": "package",
        "install_dir": "site",
        "imports": [imported],
        "depends": list(needs),
        "unvendored_tests": False,
    }


def make_settings(app):
    """Return the settings that JupyterLite reads when it starts."""
    python = app.config.course_python
    kernel = {
        "pyodideUrl": f"{python}pyodide.mjs",
        "disablePyPIFallback": True,  # nothing is loaded from elsewhere
        "loadPyodideOptions": {"lockFileURL": "./packages/pyodide-lock.json"},
    }
    return {
        "jupyter-lite-schema-version": 0,
        "jupyter-config-data": {
            "appName": app.config.html_title,
            "contentsStorageName": f"{course().salt} {version('robokin')}",
            "litePluginSettings": {KERNEL: kernel},
        },
    }


def build(app, error):
    """Build JupyterLite into the site."""
    if error or app.builder.name != "html":
        return
    folder, target = Path(app.outdir).parent / "lite", Path(app.outdir) / "lite"
    shutil.rmtree(folder, ignore_errors=True)
    write_notebooks(folder / "notebooks")
    write_packages(app, folder / "packages")
    (folder / "jupyter-lite.json").write_text(json.dumps(make_settings(app)), "utf-8")
    run_jupyterlite(folder, target)
    shutil.copytree(folder / "packages", target / "packages")


def run_jupyterlite(folder, target):
    """Run its command, and log the output only if it fails."""
    logger.info("building JupyterLite …")
    command = [sys.executable, "-m", "jupyterlite_core.app", "build", "--lite-dir", str(folder)]
    command += ["--contents", str(folder / "notebooks"), "--output-dir", str(target)]
    command += ["--apps", "notebooks", "--apps", "tree", "--no-sourcemaps"]
    command += ["--no-unused-shared-packages", "--force"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if run.returncode:
        logger.warning("JupyterLite is not built:\n%s", run.stdout + run.stderr)


def setup(app):
    """Register with Sphinx, after the wheels are written."""
    app.connect("build-finished", build, priority=910)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
