"""Tables as CSV, read whatever wrote them, and the problems that they have."""

import csv
import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Iterator, Mapping, Sequence
from itertools import zip_longest
from pathlib import Path
from typing import NamedTuple

from courseware.errors import CourseError
from courseware.practice.saving import unguard_cell

Row = dict[str, str]

UNDECODED = re.compile("[\udc80-\udcff]")
NOT_CSV = (
    f"a quotation mark is not closed, or a cell has over {csv.field_size_limit():,} characters"
)
SHOWN = 3  # problems of a kind in a file, when they are printed


class Problem(NamedTuple):
    """A line that was left out or replaced, or a whole file, which has no line."""

    problem: str
    file: Path
    line: int | str
    student: str
    exercise: str
    answer: str
    comment: str

    def __str__(self) -> str:
        place = f"{self.file}, line {self.line}" if self.line else f"{self.file}"
        return f"{place}: {self.comment}" if self.comment else place


class Problems(list[Problem]):
    """All problems, in the order in which they were found."""

    def note(
        self, kind: str, path: Path, line: int = 0, comment: str = "", row: Mapping[str, str] = {}
    ) -> None:
        """Note a problem of a line, or of a whole file (line 0)."""
        student, exercise, answer = (row.get(n, "") for n in ("student", "exercise", "answer"))
        self.append(Problem(kind, path, line or "", student, exercise, answer, comment))

    def lines(self) -> list[str]:
        """Return what to print: each kind with its count, and the first of it in each file."""
        kinds: dict[str, dict[Path, list[Problem]]] = {}
        for each in self:
            kinds.setdefault(each.problem, {}).setdefault(each.file, []).append(each)
        found = []
        for kind, files in kinds.items():
            found.append(f"{kind}: {sum(map(len, files.values())):,}")
            for path, all_here in files.items():
                found += [f"  {each}" for each in all_here[:SHOWN]]
                if len(all_here) > SHOWN:
                    found.append(f"  {path}: {len(all_here) - SHOWN:,} more")
        return found


def read_rows(
    path: Path, problems: Problems, needed: Sequence[str] = ()
) -> Iterator[tuple[int, Row]]:
    """Yield rows with their line numbers: comma, semicolon or tab, UTF-8 or UTF-16.

    Bad lines are noted. Where tables were joined, a heading may stand anywhere. A table without
    the `needed` columns is refused.
    """
    heading = list[str]()
    for number, cells in _read_cells(path, problems):
        names = [cell.strip().lower() for cell in cells]
        if not heading or {"student", "exercise"} <= set(names):
            heading = names
            _require(path, needed, heading)
        elif any(map(UNDECODED.search, cells)):
            problems.note("lines not in UTF-8: save the file as CSV UTF-8", path, number)
        elif len(cells) > len(heading):
            words = f"{len(cells)} cells, the heading has {len(heading)}"
            problems.note("lines with more cells than the heading", path, number, words)
        else:  # spreadsheets leave out empty cells at the end
            values = (unguard_cell(cell).strip(" \t\r\n") for cell in cells)  # as the judge does
            yield number, dict(zip_longest(heading, values, fillvalue=""))
    _require(path, needed, heading)  # of an empty table, too


def _read_cells(path: Path, problems: Problems) -> Iterator[tuple[int, list[str]]]:
    """Yield the cells of lines that are not empty, with their numbers; note what is no CSV."""
    first = next(filter(str.strip, read_lines(path)), "")
    separator = max(",;\t", key=first.count)
    reader = csv.reader(read_lines(path), delimiter=separator, strict=True)
    while True:
        number = reader.line_num + 1
        try:
            cells = next(reader)
        except StopIteration:
            return
        except csv.Error:
            words = f"{NOT_CSV}; read on after line {reader.line_num}"
            problems.note("lines that are no CSV", path, number, words)
            continue
        if any(map(str.strip, cells)):
            yield number, cells


def _require(path: Path, needed: Sequence[str], heading: Sequence[str]) -> None:
    missing = [name for name in needed if name not in heading]
    if missing:
        raise CourseError(
            f"{path} has no column {', '.join(missing)}; needed are {', '.join(needed)}, "
            f"its first line has {', '.join(filter(None, heading)) or 'nothing'}"
        )


def read_lines(path: Path) -> Iterator[str]:
    """Yield lines as text; bytes that are not UTF-8 are kept as surrogates."""
    try:
        with path.open("rb") as file:
            start = file.read(1000)
        is_utf_16 = start.startswith((BOM_UTF16_LE, BOM_UTF16_BE))
        if b"\0" in start and not is_utf_16:
            raise CourseError(
                f"{path} is no text: unpack an archive, save a spreadsheet as CSV UTF-8"
            )
        encoding, errors = ("utf-16", "replace") if is_utf_16 else ("utf-8", "surrogateescape")
        with path.open(encoding=encoding, errors=errors) as text:
            for line in text:
                yield line.replace("\ufeff", "")  # also where files were joined
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
