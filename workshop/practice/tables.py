"""Tables as CSV: written so that a spreadsheet shows them as they are, read whatever wrote them."""

import csv
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from workshop.errors import CourseError

Row = dict[str, str]

NUMBER = r"[+-]?[\d.]+"
FORMULA = r"[=+\-@\t\r]"  # what a spreadsheet takes for the start of a formula
ENCODINGS = (  # byte order marks
    (b"\xef\xbb\xbf", "utf-8-sig"),
    (b"\xff\xfe", "utf-16"),
    (b"\xfe\xff", "utf-16"),
)


@dataclass
class Table:
    """The rows that could be read, each with its line number, and what is wrong with the others."""

    path: Path
    rows: list[tuple[int, Row]]
    problems: list[str] = field(default_factory=list)

    def refuse(self, line: int, words: str) -> None:
        """Note what is wrong with a line."""
        self.problems.append(f"{self.path}, line {line}: {words}")


def guarded(text: str) -> str:
    """A cell that no spreadsheet runs as a formula: with a leading ', but for plain numbers."""
    formula = re.match(FORMULA, text) and not re.fullmatch(NUMBER, text)
    return f"'{text}" if formula else text


def unguarded(text: str) -> str:
    """A cell as it was before `guarded`."""
    return text[1:] if re.match("'" + FORMULA, text) else text


def write(
    path: str | Path, columns: Sequence[str], rows: Iterable[Sequence[object]], force: bool = False
) -> Path:
    """Write a table (UTF-8 with a mark, which spreadsheets need); refuse to overwrite."""
    path = Path(path)
    free(path, force)
    with path.open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows([guarded(str(cell)) for cell in row] for row in rows)
    return path


def free(path: Path, force: bool) -> None:
    """Refuse a file that is already there, unless told to overwrite it."""
    if path.is_dir():
        raise CourseError(f"{path} is a folder: give the name of a file")
    if path.exists() and not force:
        raise CourseError(f"{path} is already there: choose another name, or add --force")
    if not path.parent.is_dir():
        raise CourseError(f"there is no folder {path.parent} to write {path.name} in")


def read(path: str | Path, needed: Sequence[str]) -> Table:
    """Read a table: comma, semicolon or tab, UTF-8 or UTF-16; bad lines are noted, not fatal."""
    path = Path(path)
    try:
        data = path.read_bytes()
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
    table = Table(path, [])
    lines = _decoded(table, data)
    if lines and lines[0].lower().startswith("sep="):
        lines[0] = "\n"  # a spreadsheet's own remark; the header tells as much
    first = next((line for line in lines if line.strip()), "")
    reader = csv.reader(lines, delimiter=max(",;\t", key=first.count), strict=True)
    header = [name.strip().lower() for name in next(_cells(table, reader), [])]
    missing = [name for name in needed if name not in header]
    if missing:
        raise CourseError(
            f"{path} has no column {', '.join(missing)}; needed are {', '.join(needed)}, "
            f"its first line has {', '.join(filter(None, header)) or 'nothing'}"
        )
    for cells in _cells(table, reader):
        if len(cells) != len(header):
            table.refuse(reader.line_num, f"{len(cells)} cells, the header has {len(header)}")
            continue
        row = {name: unguarded(cell).strip() for name, cell in zip(header, cells, strict=True)}
        table.rows.append((reader.line_num, row))
    return table


def _cells(table: Table, reader: Any) -> Iterator[list[str]]:
    """The lines that are not empty; what cannot be CSV, such as an open quotation, is noted."""
    while True:
        start = reader.line_num + 1
        try:
            cells = next(reader)
        except StopIteration:
            return
        except csv.Error as error:
            table.refuse(start, f"not read, to line {reader.line_num}: {error}")
            continue
        if any(cell.strip() for cell in cells):
            yield cells


def _decoded(table: Table, data: bytes) -> list[str]:
    """The lines as text. A line that is not UTF-8 is noted and left empty."""
    for mark, encoding in ENCODINGS:
        if data.startswith(mark):
            return data.decode(encoding, errors="replace").splitlines(keepends=True)
    lines = []
    for number, line in enumerate(data.splitlines(keepends=True), start=1):
        try:
            lines.append(line.decode("utf-8").replace("\0", ""))
        except UnicodeDecodeError:
            table.refuse(number, "not in UTF-8: save the file as CSV UTF-8")
            # a heading with an odd letter still names the other columns
            lines.append("\n" if any(map(str.strip, lines)) else line.decode("latin-1"))
    return lines
