"""What is stored does not depend on the last bits of a float: no output, no exercise.

Each notebook runs twice with results that are moved in their last bits (`last_bits.py`), the second
time all the other way, and must print what is stored.
"""

import os
import subprocess
import sys
from functools import partial

import nbformat
import notebooks
import pytest
from nbformat.v4 import new_code_cell, new_notebook
from support import ROOT

import book  # noqa: F401 - opens the course
from courseware.practice import variants

pytestmark = pytest.mark.slow
NOTEBOOKS = sorted((ROOT / "book").glob("*/*.ipynb"))
DIRECTIONS = (1, -1)
NO_TEXT = {"data", "execution_count", "image/png", "metadata", "traceback"}


@pytest.fixture
def perturbed(tmp_path, monkeypatch):
    """A function that runs a notebook with its last bits moved, past cells that fail."""
    startup = tmp_path / "profile_default" / "startup" / "move.py"
    startup.parent.mkdir(parents=True)
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    monkeypatch.setenv("PYTHONPATH", str(ROOT / "tests"), prepend=os.pathsep)
    client = partial(notebooks.NotebookClient, allow_errors=True)
    monkeypatch.setattr(notebooks, "NotebookClient", client)

    def run(path, direction):
        startup.write_text(f"import last_bits\nlast_bits.move({direction})\ndel last_bits\n")
        return nbformat.reads(notebooks.run_notebook(path), as_version=4)

    return run


def texts(cell):
    """The lines of a cell's prose, or of its outputs."""
    if cell.cell_type == "markdown":
        return cell.source.splitlines()
    parts = [{**output, **output.get("data", {})} for output in cell.get("outputs", [])]
    values = [str(part[name]) for part in parts for name in sorted(part.keys() - NO_TEXT)]
    return [line for value in values for line in value.splitlines()]


def differences(name, stored, fresh):
    """Where two notebooks differ: cell, line, and the words in it that do."""
    for number, cells in enumerate(zip(stored.cells, fresh.cells, strict=True)):
        old, new = map(texts, cells)
        for line, (before, after) in enumerate(zip(old, new, strict=False), start=1):
            words = [(a, b) for a, b in zip(before.split(), after.split(), strict=False) if a != b]
            if before != after:
                yield f"{name}, cell {number}, line {line}: {words}\n{before}\n{after}"
        if len(old) != len(new):
            yield f"{name}, cell {number}: {len(new)} lines, {len(old)} are stored\n{new[-1]}"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_outputs_do_not_depend_on_last_bits(path, perturbed):
    stored = nbformat.read(path, as_version=4)
    found = [d for way in DIRECTIONS for d in differences(path.stem, stored, perturbed(path, way))]
    assert not found, "\n".join(found)


ROUNDED = "import numpy as np\nprint(np.sin(0.5).round(6), np.hypot(3, 4))"
ALL_DIGITS = "print(np.sin(0.5))"
AT_THE_BORDER = "print(f'{np.hypot(0.0015, 0.002):.3f}')"  # 0.0025


def test_a_number_that_depends_on_them_is_named(tmp_path, perturbed):
    cells = [new_code_cell(source) for source in (ROUNDED, ALL_DIGITS, AT_THE_BORDER)]
    path = tmp_path / "basics.ipynb"
    nbformat.write(new_notebook(cells=cells), path)
    with pytest.MonkeyPatch.context() as plain:
        plain.setenv("IPYTHONDIR", str(tmp_path / "empty"))
        stored = nbformat.reads(notebooks.run_notebook(path), as_version=4)
    found = [d for way in DIRECTIONS for d in differences("one", stored, perturbed(path, way))]
    assert {d.partition(", line")[0] for d in found} == {"one, cell 1", "one, cell 2"}


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_the_bank_has_one_version(direction):
    code = f"import last_bits; last_bits.move({direction}); import book; "
    code += "from courseware.practice import variants; print(variants.version())"
    path = os.pathsep.join(filter(None, [str(ROOT / "tests"), os.environ.get("PYTHONPATH")]))
    run = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    assert run.stdout.strip() == variants.version()
