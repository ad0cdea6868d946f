"""Write the notebooks: run every cell and store the outputs, byte for byte the same each time.

    python tools/notebooks.py            write all notebooks of book/
    python tools/notebooks.py --check    write nothing; say which notebook is stale
    python tools/notebooks.py bicycle    only those whose name contains bicycle

On the reference environment (Linux x86-64, Python 3.11, the lock) --check compares bytes;
elsewhere text outputs exactly and pictures with a tolerance.
"""

import argparse
import base64
import io
import platform
import struct
import sys
from pathlib import Path

import matplotlib.image
import nbformat
import numpy as np
from nbclient import NotebookClient

BOOK = Path(__file__).parents[1] / "book"
FRESH = BOOK.parent / "_build" / "notebooks"  # what a stale notebook should be, for comparison
WIDGET = "application/vnd.jupyter.widget-view+json"
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python", "file_extension": ".py", "mimetype": "text/x-python"},
}
PICTURE_TOLERANCE = 0.01  # mean difference of a pixel, of 1: fonts are drawn a little differently


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("only", nargs="?", default="", help="a part of the notebook's name")
    parser.add_argument("--check", action="store_true", help="write nothing, say what is stale")
    options = parser.parse_args()
    paths = sorted(p for p in BOOK.glob("*/*.ipynb") if options.only in p.name)
    stale = []
    for number, path in enumerate(paths, start=1):
        print(f"[{number}/{len(paths)}] {path.name}", end=" ", flush=True)
        before, after = path.read_text(encoding="utf-8"), written(path)
        if before == after:
            print("unchanged")
        elif options.check:
            same = not is_reference() and alike(before, after)
            print("the same but for drawing" if same else "STALE: run `make notebooks`")
            if not same:
                stale.append(path)
                FRESH.mkdir(parents=True, exist_ok=True)
                (FRESH / path.name).write_text(after, encoding="utf-8")
        else:
            path.write_text(after, encoding="utf-8")
            print("written")
    if not paths:
        print(f"no notebook in {BOOK} has {options.only!r} in its name")
    return 1 if stale or not paths else 0


def is_reference() -> bool:
    """Whether pictures come out here byte for byte as they were stored."""
    here = (platform.system(), platform.machine(), sys.version_info[:2])
    return here == ("Linux", "x86_64", (3, 11))


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
    client.execute()
    notebook.metadata = nbformat.from_dict(METADATA)
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number:02d}"
        for output in cell.get("outputs", []):
            tidy(output)
    nbformat.validate(notebook)
    return str(nbformat.writes(notebook, indent=1)) + "\n"


def tidy(output: nbformat.NotebookNode) -> None:
    """Drop what differs from run to run; give pictures their size, so that a page does not jump."""
    data = output.get("data", {})
    data.pop(WIDGET, None)
    if "image/png" in data:
        width, height = struct.unpack(">II", base64.b64decode(data["image/png"])[16:24])
        output.metadata["image/png"] = {"width": width // 2, "height": height // 2}


def alike(before: str, after: str) -> bool:
    """Whether two notebooks agree, pictures compared with a tolerance."""
    return _without_pictures(before) == _without_pictures(after) and all(
        _near(a, b) for a, b in zip(_pictures(before), _pictures(after), strict=True)
    )


def _outputs(text: str) -> list[nbformat.NotebookNode]:
    cells = nbformat.reads(text, as_version=4).cells
    return [output for cell in cells for output in cell.get("outputs", [])]


def _pictures(text: str) -> list[str]:
    return [o.data["image/png"] for o in _outputs(text) if "image/png" in o.get("data", {})]


def _without_pictures(text: str) -> str:
    for picture in _pictures(text):
        text = text.replace(picture.replace("\n", "\\n"), "")
    return text


def _near(a: str, b: str) -> bool:
    first, second = (matplotlib.image.imread(io.BytesIO(base64.b64decode(x))) for x in (a, b))
    if first.shape != second.shape:
        return False
    return bool(np.abs(first - second).mean() < PICTURE_TOLERANCE)


if __name__ == "__main__":
    sys.exit(main())
