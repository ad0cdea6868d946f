"""Write the notebooks: run every cell, store the outputs, byte for byte the same each time, and
put the computed numbers into the prose (`tools/prose.py`).

    python tools/notebooks.py            write all notebooks of book/
    python tools/notebooks.py bicycle    only those whose name contains bicycle

When nbval runs a notebook, `conftest.py` compares the same in that run. How: `tools/stored.py`.
"""

import sys
from pathlib import Path

import nbformat
import prose
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from stored import normal

BOOK = Path(__file__).parents[1] / "book"


def main() -> int:
    only = sys.argv[1] if len(sys.argv) > 1 else ""
    paths = sorted(p for p in BOOK.glob("*/*.ipynb") if only in p.name)
    failed = False
    for number, path in enumerate(paths, start=1):
        print(f"[{number}/{len(paths)}] {path.name}", end=" ", flush=True)
        try:
            after = written(path)
        except (prose.ProseError, CellExecutionError) as error:
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


def written(path: Path) -> str:
    """The notebook's text after running it from top to bottom."""
    notebook = nbformat.read(path, as_version=4)
    client = NotebookClient(
        notebook,
        timeout=120,
        kernel_name="python3",
        record_timing=False,
        store_widget_state=False,
        coalesce_streams=True,  # what is printed slowly comes in parts; how many is chance
        extra_arguments=["--log-level=ERROR"],
        resources={"metadata": {"path": str(path.parent)}},
    )
    with client.setup_kernel():
        for number, cell in enumerate(notebook.cells):
            client.execute_cell(cell, number)
            if prose.asks(cell):
                asked = client.kc.execute(
                    "", silent=True, user_expressions=prose.questions(cell, path.stem)
                )
                reply = client.wait_for_reply(asked)["content"]
                where = f"{path.name}, cell {number}"
                cell.source = prose.filled(cell, where, reply["user_expressions"])
    return normal(notebook)


if __name__ == "__main__":
    sys.exit(main())
