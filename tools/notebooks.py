"""Run the notebooks and store their outputs, equal byte for byte in every run.

Numbers in the prose are computed, too (`tools/prose_numbers.py`).

    python tools/notebooks.py            write all notebooks of book/
    python tools/notebooks.py bicycle    only those whose name contains bicycle

When nbval runs a notebook, `conftest.py` compares the same (`tools/stored_outputs.py`).
"""

import sys
from pathlib import Path

import nbformat
import prose_numbers
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from stored_outputs import normalize

import book  # noqa: F401 (opens the course)
from courseware.programs import all_programs

BOOK = Path(__file__).parents[1] / "book"


def main() -> int:
    only = sys.argv[1] if len(sys.argv) > 1 else ""
    paths = sorted(p for p in BOOK.glob("*/*.ipynb") if only in p.name)
    failed = False
    for number, path in enumerate(paths, start=1):
        print(f"[{number}/{len(paths)}] {path.name}", end=" ", flush=True)
        try:
            after = run_notebook(path)
        except (prose_numbers.ProseError, CellExecutionError) as error:
            print(f"FAILED\n{error}")
            failed = True
            continue
        if path.read_text(encoding="utf-8") == after:
            print("unchanged")
        else:
            path.write_text(after, encoding="utf-8")
            print("written")
    if not paths:
        print(f"no notebook in {BOOK} has {only!r} in its name")
    return 1 if failed or not paths else 0


def write_starters(notebook: nbformat.NotebookNode) -> None:
    """Write the code that students begin with, which `programs.py` has, into its cells."""
    starters = {f"program-{p.name}": p.starter.rstrip() for p in all_programs().values()}
    for cell in notebook.cells:
        for tag in starters.keys() & set(cell.metadata.get("tags", ())):
            cell.source = starters[tag]


def run_notebook(path: Path) -> str:
    """Run a notebook from top to bottom and return its text."""
    notebook = nbformat.read(path, as_version=4)
    write_starters(notebook)
    client = NotebookClient(
        notebook,
        timeout=120,
        kernel_name="python3",
        record_timing=False,
        store_widget_state=False,
        coalesce_streams=True,  # slow printing comes in parts, whose number varies
        extra_arguments=["--log-level=ERROR"],
        resources={"metadata": {"path": str(path.parent)}},
    )
    with client.setup_kernel():
        for number, cell in enumerate(notebook.cells):
            client.execute_cell(cell, number)
            if prose_numbers.has_numbers(cell):
                asked = client.kc.execute(
                    "",
                    silent=True,
                    user_expressions=prose_numbers.kernel_expressions(cell, path.stem),
                )
                reply = client.wait_for_reply(asked)["content"]
                where = f"{path.name}, cell {number}"
                cell.source = prose_numbers.fill_numbers(cell, where, reply["user_expressions"])
    return normalize(notebook)


if __name__ == "__main__":
    sys.exit(main())
