"""The copies of the notebooks for Colab; run in a fresh environment that says that it
is Colab: `make test-install`."""

import ast
import json
import os
import subprocess
import sys
import venv

import colab_copies
import nbformat
import pytest
from browser import serving
from declared import judge_all
from IPython.core.inputtransformer2 import TransformerManager
from support import ROOT, python_of

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

NOTEBOOKS = sorted((ROOT / "book").glob("*/*.ipynb"))
CHAPTER = "bicycle"
WAIT = 900  # seconds at most to install, on a slow line
MANAGER = "https://example.org/manager.js"
COLAB = {  # as much of it as the first cell and the widgets look at
    "sitecustomize.py": "import google.colab.output\n",
    "google/colab/__init__.py": "",
    "google/colab/output.py": "class _widgets:\n    _installed_url = None\n\n\n"
    f"def enable_custom_widget_manager():\n    _widgets._installed_url = {MANAGER!r}\n",
}
WIDGET = "application/vnd.jupyter.widget-view+json"


def shows(output):
    """Whether it shows a widget: a figure or an exercise."""
    return WIDGET in output.get("data", {})


def first_cell(folder):
    return json.loads((folder / f"{CHAPTER}.ipynb").read_text("utf-8"))["cells"][0]


@pytest.fixture(scope="module")
def copies(site, tmp_path_factory):
    """The folder with the copies of all notebooks."""
    folder = tmp_path_factory.mktemp("hosted")
    colab_copies.copy_all("https://example.org/raw/hosted", folder)
    return folder


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_copy_is_the_notebook_with_one_cell_more(file, copies):
    copy = json.loads((copies / file.name).read_text("utf-8"))
    own = json.loads(file.read_text("utf-8"))
    assert copy["cells"][1:] == own["cells"]
    assert {**copy, "cells": []} == {**own, "cells": []}


def test_the_first_cell_asks_for_the_wheels_beside_it(copies):
    asked = "".join(first_cell(copies)["source"])
    for wheel in copies.glob("*.whl"):
        assert f"@ https://example.org/raw/hosted/{wheel.name}" in asked


def test_the_first_cell_does_nothing_elsewhere():
    code = TransformerManager().transform_cell(
        colab_copies.make_first_cell("https://example.org", ["a-1.whl"])
    )
    top = [type(line).__name__ for line in ast.parse(code).body]
    assert top == ["Import", "If"]
    exec(compile(code, "cell", "exec"), {})  # elsewhere is here: `get_ipython` is not known


@pytest.mark.install
def test_a_copy_runs_where_the_course_is_not_installed(site, tmp_path):
    folder, place, colab = (tmp_path / name for name in ("hosted", "place", "colab"))
    venv.create(place, with_pip=True)
    python = python_of(place)
    given = ["numpy==2.0.2", "matplotlib==3.10.0", "sympy==1.13.3", "ipykernel", "nbconvert"]
    uv = [sys.executable, "-m", "uv", "pip", "install", "-q", "--python", python]
    subprocess.run([*uv, *given], check=True, timeout=WAIT)  # about what Colab has
    for name, text in COLAB.items():
        (colab / name).parent.mkdir(parents=True, exist_ok=True)
        (colab / name).write_text(text)
    with serving(folder) as address:
        colab_copies.copy_all(address.rstrip("/"), folder)
        options = ("--execute", "--inplace", f"--ExecutePreprocessor.timeout={WAIT}")
        run = subprocess.run(
            [python, "-m", "nbconvert", "--to", "notebook", *options, f"{CHAPTER}.ipynb"],
            cwd=folder,
            env={**os.environ, "PYTHONPATH": str(colab)},
            capture_output=True,
            text=True,
        )
    assert run.returncode == 0, run.stderr[-3000:]
    cells = nbformat.read(folder / f"{CHAPTER}.ipynb", as_version=4).cells
    code = [cell for cell in cells if cell.cell_type == "code"]
    skipped = [cell for cell in code if "skip-execution" in cell.metadata.get("tags", ())]
    assert [cell for cell in code if not cell.execution_count] == skipped
    judged = subprocess.run([python, "-c", judge_all()], capture_output=True, text=True)
    assert set(json.loads(judged.stdout or "{}").values()) == {"right"}, judged.stderr
    told = [o.get("metadata", {}).get(WIDGET) for cell in code for o in cell.outputs if shows(o)]
    assert told == [{"colab": {"custom_widget_manager": {"url": MANAGER}}}] * len(told) != []
