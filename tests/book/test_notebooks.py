"""The notebooks are tests: run, stored, compared, with the computed numbers of their prose."""

import base64
import io
import re
import shutil
import subprocess
import sys
import tomllib

import nbformat
import notebooks
import prose_numbers
import pytest
import stored_outputs
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from PIL import Image
from support import ROOT

BOOK = ROOT / "book"
NOTEBOOKS = sorted(BOOK.glob("*/*.ipynb"))
FRAMES = BOOK / "frames" / "frames.ipynb"
PAGES = sorted(BOOK.glob("*.md"))
MARKS = {"definition", "derivation", "mistake"}
LARGEST = 25_000  # bytes of a picture

# display mathematics, or inline mathematics with an equals sign: a formula
FORMULA = re.compile(r"\$\$|\\begin\{|```\{math\}|\$[^$\n]*(?<![<>!])=[^$\n]*\$")


def cells(path):
    return nbformat.read(path, as_version=4).cells


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_every_cell_has_run_in_order_without_error(path):
    numbers = []
    for cell in cells(path):
        if cell.cell_type == "code" and "skip-execution" in cell.metadata.get("tags", []):
            assert "nbval-skip" in cell.metadata.tags, f"nbval runs it: {cell.source}"
            assert not cell.outputs, cell.source
        elif cell.cell_type == "code":
            numbers.append(cell.execution_count)
            assert not [o for o in cell.outputs if o.output_type == "error"], cell.source
    assert numbers == list(range(1, len(numbers) + 1)), f"run: make notebooks T={path.stem}"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_stored_as_it_is_written(path):
    """What nbval's run does not compare: the form, the cells' names, sizes of pictures."""
    text = path.read_text(encoding="utf-8")
    assert text == stored_outputs.normalize(nbformat.reads(text, as_version=4)), (
        "run `make notebooks`"
    )


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_pictures_are_light_and_have_a_text_alternative(path):
    for cell in cells(path):
        for output in cell.get("outputs", []):
            if "image/png" in output.get("data", {}):
                image = cell.metadata.get("mystnb", {}).get("image", {})
                assert image.get("alt"), (
                    'say in the cell\'s metadata what is seen, as {"mystnb": {"image": {"alt": '
                    f'"…"}}}}: {cell.source}'
                )
                assert output.metadata["image/png"]["width"] > 0, "run `make notebooks`"
                png = base64.b64decode(output.data["image/png"])
                picture = Image.open(io.BytesIO(png))
                again = f"run `make notebooks T={path.stem}` for the picture of: {cell.source}"
                assert picture.mode == "P", again
                assert len(picture.getcolors()) <= stored_outputs.COLOURS, again
                assert len(png) < LARGEST, (
                    f"{len(png)} bytes, at most {LARGEST}: draw less, or smaller: {cell.source}"
                )


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_are_short(path):
    for cell in cells(path):
        if cell.cell_type == "code":
            lines = cell.source.splitlines()
            assert len(lines) <= 15, (
                f"{len(lines)} lines, at most 15: split the cell, or move what it needs to the "
                f"chapter's modules: {cell.source}"
            )
            longest = max(map(len, lines), default=0)
            assert longest <= 80, (
                f"a line of {longest} characters, at most 80 fit the page: break it: {cell.source}"
            )


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_formulas_come_from_the_equations(path):
    for cell in cells(path):
        if cell.cell_type == "markdown" and not MARKS & set(cell.metadata.get("tags", [])):
            assert not FORMULA.search(cell.source), (
                "a formula typed by hand: show one of formulas.py (`equations.show`), or tag the "
                f"cell with one of {sorted(MARKS)}: {cell.source}"
            )


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_pages_hold_no_formula_typed_by_hand(path):
    found = FORMULA.search(path.read_text(encoding="utf-8"))
    assert not found, f"{path.name} has a formula typed by hand: {found[0] if found else ''}"


# Numbers in the prose


def prose_cell(text, computed=()):
    return new_markdown_cell(text, metadata={"numbers": {"computed": list(computed)}})


def test_the_first_page_names_the_python_that_is_needed():
    settings = tomllib.loads((ROOT / "courseware" / "pyproject.toml").read_text("utf-8"))
    python = settings["project"]["requires-python"].removeprefix(">=")
    assert f"Python {python} or newer" in (BOOK / "index.md").read_text("utf-8")


def answered(*texts):
    return {
        str(k): {"status": "ok", "data": {"text/plain": repr(text)}} for k, text in enumerate(texts)
    }


def test_computed_numbers_are_put_in():
    cell = prose_cell(
        "Off by 1.0 and 2 cm; −3°; $10^{-5}$; {braces}.",
        ["by {a:.1f} and {b:.0f} cm", "; {c['x']:.0f}°", "$10^{{{k}}}$"],
    )
    assert prose_numbers.list_fields(cell) == [
        ("a", ".1f"),
        ("b", ".0f"),
        ("c['x']", ".0f"),
        ("k", ""),
    ]
    text = prose_numbers.fill_numbers(cell, "one", answered("12.5", "-3", "-40", "-7"))
    assert text == "Off by 12.5 and −3 cm; −40°; $10^{-7}$; {braces}."


def test_live_numbers_are_those_of_an_untouched_figure(tmp_path):
    live = {"tips": ["drives at {v} and {v_L};", "R is {R}."], "world": ["heading {theta}"]}
    text = "It drives at 1 m/s and 2 m/s; R is −1 m. The heading 9°."
    cell = new_markdown_cell(text, metadata={"numbers": {"live": live}})
    (made,) = nbformat.reads(written(tmp_path, cell), as_version=4).cells
    assert made.source == "It drives at 0.075 m/s and 0.050 m/s; R is 0.150 m. The heading 40°."


def test_a_live_number_that_no_figure_shows_is_named(tmp_path):
    cell = new_markdown_cell("At 1 m.", metadata={"numbers": {"live": {"tips": ["At {speed}"]}}})
    with pytest.raises(
        prose_numbers.ProseError, match=r"speed of the figure tips.* there are .*v_L"
    ):
        written(tmp_path, cell)


@pytest.mark.parametrize(("phrase", "count"), [("So {v:.1f} km", 0), ("{v:.1f} cm", 2)])
def test_a_phrase_that_does_not_stand_in_the_text_once_is_refused(phrase, count):
    cell = prose_cell("So 7.5 cm or 8.5 cm", [phrase])
    with pytest.raises(prose_numbers.ProseError, match=f"one: .* stands in the text {count} times"):
        prose_numbers.fill_numbers(cell, "one", answered("7.5"))


def written(tmp_path, *cells):
    path = tmp_path / "basics.ipynb"  # a chapter that there is
    nbformat.write(new_notebook(cells=list(cells)), path)
    return notebooks.run_notebook(path)


def test_the_writer_computes_at_the_cells_place_and_leaves_no_trace(tmp_path):
    cells = [
        new_code_cell("v = 1.0"),
        prose_cell("At 9.00 m.", ["At {v / 3:.2f} m"]),
        new_code_cell("v = 2.0"),
        prose_cell("At 9 m, 0 %.", ["At {v:.0f} m, {digit_and_power(0.021)[0]} %"]),
        new_code_cell("'digit_and_power' in globals(), len(In)"),
    ]
    made = nbformat.reads(written(tmp_path, *cells), as_version=4).cells
    assert [cell.source for cell in made[1:4:2]] == ["At 0.33 m.", "At 2 m, 2 %."]
    assert made[4].outputs[0].data["text/plain"] == "(False, 4)"  # the first of In is empty


def test_an_expression_that_fails_is_named(tmp_path):
    told = r"basics\.ipynb, cell 1: 1 / v cannot be computed: ZeroDivisionError"
    with pytest.raises(prose_numbers.ProseError, match=told):
        written(tmp_path, new_code_cell("v = 0"), prose_cell("At 9 m.", ["At {1 / v:.0f} m"]))


# nbval bites


def test_nbval_sees_a_changed_picture_and_stale_prose(tmp_path):
    """In one run: most of its time is the kernel's start."""
    notebook = nbformat.read(FRAMES, as_version=4)
    notebook.cells = [
        *painted_over(notebook),
        prose_cell("So 3.1 cm/s.", ["So {np.pi:.1f} cm/s"]),
        prose_cell("So 3.2 cm/s.", ["So {np.pi:.1f} cm/s"]),
        prose_cell("So 3.1 cm/s.", ["So {v_none:.1f} cm/s"]),
        prose_cell("So 3.1 km/s.", ["So {np.pi:.1f} cm/s"]),
    ]
    path = tmp_path / FRAMES.name
    nbformat.write(notebook, path)
    shutil.copy(ROOT / "conftest.py", tmp_path)
    command = [sys.executable, "-m", "pytest", "--nbval", "-q", "-p", "no:cacheprovider"]
    command += ["-c", str(ROOT / "pyproject.toml"), str(path)]  # strict, as CI runs it
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 1
    assert "the stored output differs in image/png" in run.stdout
    stale = set(re.findall(r"cell \d+: numbers in the text are stale", run.stdout))
    assert len(stale) == 1  # a CI's pytest says it again in its summary
    assert "fresh:  So 3.1 cm/s." in run.stdout
    assert "v_none cannot be computed: NameError" in run.stdout
    assert "the computed phrase 'So {np.pi:.1f} cm/s' stands in the text 0" in run.stdout


def painted_over(notebook):
    """The cells of a notebook as far as its first drawn picture, and that one black."""
    cells = [c for c in notebook.cells if c.cell_type == "code"]
    drawn = next(k for k, cell in enumerate(cells) if "image/png" in str(cell.outputs))
    data = next(o.data for o in cells[drawn].outputs if "image/png" in o.data)
    picture = Image.open(io.BytesIO(base64.b64decode(data["image/png"])))
    picture.paste(0, (0, 0, *picture.size))
    file = io.BytesIO()
    picture.save(file, "PNG")
    data["image/png"] = base64.b64encode(file.getvalue()).decode()
    return cells[: drawn + 1]
