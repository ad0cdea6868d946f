"""The notebooks are tests: run, stored, compared; and their prose is held to the rules."""

import json
import re
import subprocess
import sys

import nbformat
import pytest
from support import ROOT

BOOK = ROOT / "book"
NOTEBOOKS = sorted(BOOK.glob("*/*.ipynb"))
DRIVE = BOOK / "differential_drive" / "differential_drive.ipynb"
PAGES = sorted(BOOK.glob("*.md"))
MARKS = {"definition", "derivation", "mistake"}
BY_HAND = {"mistake", "solution"}

# display mathematics, or inline mathematics with an equals sign: a formula
FORMULA = re.compile(r"\$\$|\\begin\{|```\{math\}|\$[^$\n]*(?<![<>!])=[^$\n]*\$")


def cells(path):
    return nbformat.read(path, as_version=4).cells


def nbval(path):
    """nbval over one notebook, alone and strict, as CI runs it."""
    command = [sys.executable, "-m", "pytest", "--nbval", "-q", "-p", "no:cacheprovider"]
    return subprocess.run([*command, str(path)], cwd=ROOT, capture_output=True, text=True)


def test_there_are_notebooks():
    assert NOTEBOOKS


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_every_cell_has_run_in_order_without_error(path):
    numbers = []
    for cell in cells(path):
        if cell.cell_type == "code":
            numbers.append(cell.execution_count)
            assert not [o for o in cell.outputs if o.output_type == "error"], cell.source
    assert numbers == list(range(1, len(numbers) + 1))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_stored_outputs_are_current(path):
    command = [sys.executable, "tools/notebooks.py", "--check", path.stem]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_pictures_have_a_text_alternative(path):
    for cell in cells(path):
        for output in cell.get("outputs", []):
            if "image/png" in output.get("data", {}):
                assert cell.metadata["mystnb"]["image"]["alt"], cell.source
                assert output.metadata["image/png"]["width"] > 0


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_are_short(path):
    for cell in cells(path):
        if cell.cell_type == "code":
            lines = cell.source.splitlines()
            assert len(lines) <= 15, cell.source
            longest = max(map(len, lines))
            assert longest <= 80, f"{longest} characters do not fit the page: {cell.source}"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_formulas_come_from_the_equations(path):
    for cell in cells(path):
        if cell.cell_type == "markdown" and not MARKS & set(cell.metadata.get("tags", [])):
            assert not FORMULA.search(cell.source), f"typed by hand: {cell.source}"


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_pages_hold_no_formula_typed_by_hand(path):
    assert not FORMULA.search(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("the rate $\\omega = v/R$ is", True),
        ("$$\nx\n$$", True),
        ("\\begin{align}", True),
        ("a symbol $v_L$, or $v/\\omega$, and b = 3", False),
        ("both $a$ and $b$ cost $5, so x = 1", False),
    ],
)
def test_what_counts_as_a_formula(text, found):
    assert bool(FORMULA.search(text)) == found


# nbval bites


@pytest.fixture
def copy(tmp_path):
    """A copy of a notebook to tamper with: (its text, a function that writes it)."""
    path = tmp_path / DRIVE.name

    def write(change):
        notebook = nbformat.read(DRIVE, as_version=4)
        notebook.cells = notebook.cells[:12]
        change(notebook)
        nbformat.write(notebook, path)
        return path

    return write


def test_nbval_passes_an_untouched_copy(copy):
    assert nbval(copy(lambda notebook: None)).returncode == 0


def test_nbval_sees_one_wrong_digit(copy):
    def tamper(notebook):
        text = json.dumps(notebook)
        assert '"0.075"' in text
        notebook.update(nbformat.from_dict(json.loads(text.replace('"0.075"', '"0.076"'))))

    run = nbval(copy(tamper))
    assert run.returncode == 1
    assert "0.076" in run.stdout


def test_nbval_sees_a_changed_formula(copy):
    def tamper(notebook):
        text = json.dumps(notebook)
        assert "v_{R} + v_{L}" in text
        notebook.update(
            nbformat.from_dict(json.loads(text.replace("v_{R} + v_{L}", "v_{R} - v_{L}")))
        )

    assert nbval(copy(tamper)).returncode == 1


def test_a_stripped_copy_fails(copy):
    """nbval has nothing to compare in it and passes: the first test of this file does not."""

    def strip(notebook):
        for cell in notebook.cells:
            if cell.cell_type == "code":
                cell.outputs, cell.execution_count = [], None

    with pytest.raises(AssertionError):
        test_every_cell_has_run_in_order_without_error(copy(strip))
