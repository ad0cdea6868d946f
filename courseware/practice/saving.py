"""Tables of answers as CSV, written so that a spreadsheet shows them as they are."""

import csv
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

from courseware.errors import CourseError

ANSWER_COLUMNS = (
    *("kind", "course", "version", "time", "student", "exercise", "answer"),
    *("tries", "help"),  # how often it was checked, how many hints and steps were opened
)
OTHER_COLUMNS = ("numbers", "problem", "result")  # of a key, problems and grades
# Spreadsheets begin a cell, and so a formula, behind a semicolon, too, where that separates cells,
# also within quotation marks that they take for none
START, FORMULA = r'(^|[;\t\r\n])([ "]*)', "(?='*[=+@＝＋－＠\t\r\n-])"
GUARD = rf"{START}(?![+-]?[0-9.]+ *(?:[;\t\r\n]|$)){FORMULA}"  # a number may begin with a sign
UNGUARD = rf"{START}'{FORMULA}"

Write = Callable[[Sequence[object]], object]


def refuse_existing(path: Path, force: bool) -> None:
    """Refuse a file that is already there, unless it may be overwritten."""
    if path.is_dir():
        raise CourseError(f"{path} is a folder: give the name of a file")
    if path.exists() and not force:
        raise CourseError(f"{path} is already there; overwrite it by --force (Python: force=True)")
    if not path.parent.is_dir():
        raise CourseError(f"there is no folder {path.parent} to write {path.name} in")


@contextmanager
def open_file(path: str | Path, force: bool = False, encoding: str = "utf-8") -> Iterator[TextIO]:
    """Open a file to write, which gets its name once it is complete."""
    path = Path(path)
    refuse_existing(path, force)
    part = path.with_name(f"{path.name}.part")
    try:
        with part.open("w", encoding=encoding, errors="replace", newline="") as file:
            yield file
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


@contextmanager
def open_table(path: str | Path, columns: Sequence[str], force: bool = False) -> Iterator[Write]:
    """Open a table to write row by row, in UTF-8 with the mark that spreadsheets need."""
    with open_file(path, force, "utf-8-sig") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        yield lambda row: writer.writerow([re.sub(GUARD, r"\1\2'", str(cell)) for cell in row])


def write_table(
    path: str | Path, columns: Sequence[str], rows: Iterable[Sequence[object]], force: bool = False
) -> Path:
    """Write a complete table, and return its path."""
    with open_table(path, columns, force) as write:
        for row in rows:
            write(row)
    return Path(path)
