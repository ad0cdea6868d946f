"""Write the notebooks: run every cell, store the outputs, byte for byte the same each time, and
put the computed numbers into the prose (`tools/prose.py`).

    python tools/notebooks.py            write all notebooks of book/
    python tools/notebooks.py --check    write nothing; say which notebook is stale, and where
    python tools/notebooks.py bicycle    only those whose name contains bicycle

When nbval runs a notebook, `conftest.py` compares the same in that run. How: `tools/stored.py`.
"""

import argparse
import difflib
import re
import sys
from itertools import islice
from pathlib import Path

import nbformat
import prose
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from stored import alike, is_reference, normal

BOOK = Path(__file__).parents[1] / "book"
FRESH = BOOK.parent / "_build" / "notebooks"  # what a stale notebook should be, for comparison
SHOWN = 40  # lines of difference


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("only", nargs="?", default="", help="a part of the notebook's name")
    parser.add_argument("--check", action="store_true", help="write nothing, say what is stale")
    options = parser.parse_args()
    paths = sorted(p for p in BOOK.glob("*/*.ipynb") if options.only in p.name)
    failed = []
    for number, path in enumerate(paths, start=1):
        print(f"[{number}/{len(paths)}] {path.name}", end=" ", flush=True)
        before = path.read_text(encoding="utf-8")
        try:
            after = written(path)
        except (prose.ProseError, CellExecutionError) as error:
            print(f"FAILED\n{error}")
            failed.append(path)
            continue
        if before == after:
            print("unchanged")
        elif not options.check:
            path.write_text(after, encoding="utf-8")
            print("written")
        elif not is_reference() and alike(before, after):
            print("the same but for drawing")
        else:
            print("STALE: run `make notebooks`")
            print(*difference(before, after), sep="\n")
            failed.append(path)
            FRESH.mkdir(parents=True, exist_ok=True)
            (FRESH / path.name).write_text(after, encoding="utf-8")
    if not paths:
        print(f"no notebook in {BOOK} has {options.only!r} in its name")
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


def difference(before: str, after: str) -> list[str]:
    """The first lines in which two notebooks differ, pictures told by their size only."""
    texts = [
        re.sub(r'("image/png": ")([^"]{99,})', lambda m: f"{m[1]}{hash(m[2]):x}", text).splitlines()
        for text in (before, after)
    ]
    lines = difflib.unified_diff(*texts, "stored", "fresh", n=1, lineterm="")
    return [line[:160] for line in islice(lines, SHOWN)]


if __name__ == "__main__":
    sys.exit(main())
