"""The form in which notebooks are stored, and the comparison of stored with fresh outputs.

On the reference environment (Linux x86-64, Python 3.11, the lock's matplotlib) pictures are
compared byte for byte, elsewhere with a tolerance.
"""

import base64
import io
import platform
import sys
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

import nbformat
import numpy as np
import prose_numbers
from PIL import Image

LOCK = Path(__file__).parents[1] / "requirements.txt"
WIDGET = "application/vnd.jupyter.widget-view+json"
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python", "file_extension": ".py", "mimetype": "text/x-python"},
}
PLUMBING = {"remove-input", "hide-input", "hide-cell"}  # code that no student would type
COLOURS = 24  # of a picture: more cannot be told apart by eye
PICTURE_TOLERANCE = 0.01  # mean difference of a pixel, of 1: fonts are drawn a little differently


def normalize(notebook: nbformat.NotebookNode) -> str:
    """Return the text of a notebook without anything that differs from run to run."""
    notebook.metadata = nbformat.from_dict(METADATA)
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number:02d}"
        cell.metadata.pop("jupyter", None)
        if folded := folded_parts(cell):
            cell.metadata["jupyter"] = folded
        for output in cell.get("outputs", []):
            tidy_output(output)
    nbformat.validate(notebook)
    return str(nbformat.writes(notebook, indent=1)) + "\n"


def folded_parts(cell: nbformat.NotebookNode) -> dict[str, bool]:
    """Return which parts of a cell JupyterLab folds: those that a page folds or hides."""
    tags = set(cell.metadata.get("tags", []))
    if any(tag.startswith("after-") for tag in tags):  # until its prediction is answered
        return {"source_hidden": True, "outputs_hidden": True}
    if tags & PLUMBING:
        return {"source_hidden": True}
    return {}


def tidy_output(output: nbformat.NotebookNode) -> None:
    """Drop data that differ from run to run; reduce pictures, and store their size."""
    data = output.get("data", {})
    data.pop(WIDGET, None)
    if "image/png" in data:
        picture, (width, height) = reduce_colours(base64.b64decode(data["image/png"]))
        data["image/png"] = base64.b64encode(picture).decode()
        output.metadata["image/png"] = {"width": width // 2, "height": height // 2}


def reduce_colours(png: bytes) -> tuple[bytes, tuple[int, int]]:
    """Return a picture in few colours, with a quarter of its bytes, and its size.

    Each colour is chosen where the pixels are furthest from those chosen before: first the areas
    and lines, which keep their colours exactly, then steps between them at the edges.
    """
    picture = Image.open(io.BytesIO(png))
    if picture.mode == "P":
        return png, picture.size  # reduced already
    width, height = picture.size
    picture = picture.crop((0, 0, width // 2 * 2, height // 2 * 2))  # half of it is whole pixels
    pixels = np.asarray(picture.convert("RGB")).reshape(-1, 3) @ [1 << 16, 1 << 8, 1]
    packed, which, count = np.unique(pixels, return_inverse=True, return_counts=True)
    colours = np.stack([packed >> 16, packed >> 8 & 255, packed & 255], axis=-1)
    chosen = [int(count.argmax())]
    apart = ((colours - colours[chosen[0]]) ** 2).sum(axis=1)
    nearest = np.zeros(len(colours), dtype=np.uint8)
    while len(chosen) < min(COLOURS, len(colours)):
        chosen.append(int((apart * count).argmax()))
        new = ((colours - colours[chosen[-1]]) ** 2).sum(axis=1)
        nearest[new < apart] = len(chosen) - 1
        apart = np.minimum(apart, new)
    few = Image.fromarray(nearest[which.reshape(picture.size[::-1])], "P")
    few.putpalette(colours[chosen].astype(np.uint8).tobytes())
    file = io.BytesIO()
    few.save(file, "PNG", optimize=True)
    return file.getvalue(), picture.size


def describe_difference(cell: nbformat.NotebookNode, outputs: list[nbformat.NotebookNode]) -> str:
    """Say how a cell's stored outputs differ from fresh ones; "" if they do not."""
    for output in outputs:
        tidy_output(output)
    if len(cell.outputs) != len(outputs):
        return f"{len(outputs)} outputs, {len(cell.outputs)} are stored: run `make notebooks`"
    for stored, fresh in zip(cell.outputs, outputs, strict=True):
        stored, fresh = _parts(stored), _parts(fresh)
        unlike = [k for k in stored | fresh if stored.get(k) != fresh.get(k)]
        if has_other_layout():
            unlike = [k for k in unlike if k not in ("image/png", "metadata")]  # its size
        elif unlike == ["image/png"] and not is_reference():
            unlike = [k for k in unlike if not is_near(stored[k], fresh[k])]
        if unlike:
            return f"the stored output differs in {', '.join(unlike)}: run `make notebooks`"
    return ""


def _parts(output: nbformat.NotebookNode) -> dict[str, object]:
    """Return an output's parts by name, without the number of its cell."""
    parts = {**output, **output.get("data", {})}
    parts.pop("data", None)
    parts.pop("execution_count", None)
    return parts


def prose_after(
    notebook: nbformat.NotebookNode, cell: nbformat.NotebookNode
) -> Iterator[tuple[int, nbformat.NotebookNode]]:
    """Yield the cells of prose with computed numbers between a code cell and the next one."""
    place = next(k for k, each in enumerate(notebook.cells) if each is cell)
    for number, each in enumerate(notebook.cells[place + 1 :], start=place + 1):
        if each.cell_type == "code":
            return
        if prose_numbers.has_numbers(each):
            yield number, each


def is_near(a: str, b: str) -> bool:
    """Return whether two pictures (base64) differ no more than fonts do between machines."""
    first, second = (
        np.asarray(Image.open(io.BytesIO(base64.b64decode(x))).convert("RGB")) / 255 for x in (a, b)
    )
    if first.shape != second.shape:
        return False
    return bool(np.abs(first - second).mean() < PICTURE_TOLERANCE)


def has_other_layout() -> bool:
    """Return whether this Matplotlib lays out pictures otherwise: before 3.11 it does."""
    return tuple(map(int, version("matplotlib").split(".")[:2])) < (3, 11)


def is_reference() -> bool:
    """Return whether pictures are equal here byte for byte to the stored ones."""
    here = (platform.system(), platform.machine(), sys.version_info[:2])
    locked = f"\nmatplotlib=={version('matplotlib')} " in LOCK.read_text(encoding="utf-8")
    return here == ("Linux", "x86_64", (3, 11)) and locked
