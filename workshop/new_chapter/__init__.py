"""The skeleton of a new chapter: `python -m book new NAME`.

The files here are a small chapter that works, to be replaced piece by piece: one formula, function,
figure and exercise. In them NAME is the chapter's name, SLUG the same with hyphens, and `book` the
course's package.
"""

import json
from importlib.resources import files
from typing import Any

from workshop.course import course
from workshop.errors import CourseError

MODULES = ("formulas", "functions", "checks", "figures", "expected", "exercises", "test_NAME")
QUESTION = '"""The question that this chapter answers, for the first page?"""\n'


def write(name: str) -> str:
    """Write a chapter's folder, and return what to do next."""
    if not (name.isidentifier() and name.islower()):
        raise CourseError(f"{name!r} cannot name a module: use a-z, 0-9 and _, as in gear_train")
    folder = course().folder / name
    if folder.exists():
        raise CourseError(f"{folder} exists: choose another name, or remove it")
    folder.mkdir()
    (folder / "__init__.py").write_text(QUESTION, encoding="utf-8")
    for module in MODULES:
        file = folder / f"{module.replace('NAME', name)}.py"
        file.write_text(template(f"{module}.py.txt", name), encoding="utf-8")
    parts = template("cells.txt", name).split("\n%%")
    cells = [cell(number, part) for number, part in enumerate(parts)]
    notebook = {"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}
    course().notebook(name).write_text(json.dumps(notebook, indent=1) + "\n", encoding="utf-8")
    return (
        f"written: {folder}\n"
        f"Now add the line `- file: {name}/{name}` to _toc.yml, then: make notebooks T={name}, "
        f"make serve, make test T={name}"
    )


def template(file: str, name: str) -> str:
    """Return a file of this folder with a chapter's names in it."""
    text = files(__name__).joinpath(file).read_text(encoding="utf-8")
    text = text.replace("NAME", name).replace("SLUG", name.replace("_", "-"))
    return text.replace("book.", f"{course().package}.")


def cell(number: int, part: str) -> dict[str, Any]:
    """Return a notebook's cell; its first line has its tags, `text`, or `alt:` of its picture."""
    first, _, source = part.partition("\n")
    first = first.strip()
    metadata: dict[str, Any] = {}
    if number == 0:
        first, source = "text", part
    elif first.startswith("alt:"):
        metadata = {"mystnb": {"image": {"alt": first.removeprefix("alt:").strip()}}}
    elif first:
        metadata = {"tags": first.split()}
    made = {"id": f"cell-{number:02d}", "source": source.strip("\n")}
    if first == "text":
        return made | {"cell_type": "markdown", "metadata": {}}
    return made | {
        "cell_type": "code",
        "execution_count": None,
        "metadata": metadata,
        "outputs": [],
    }
