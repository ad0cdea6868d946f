"""Tables as CSV, read whatever wrote them, and the problems that they have."""

import csv
import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import zip_longest
from pathlib import Path

from courseware.errors import CourseError
from courseware.practice.saving import Write, unguard_cell

Row = dict[str, str]

UNDECODED = re.compile("[\udc80-\udcff]")
NOT_CSV = (
    f"a quotation mark is not closed, or a cell has over {csv.field_size_limit():,} characters"
)
PROBLEMS = ("problem", "file", "line", "student", "exercise", "answer", "comment")


class Problems:
    """Lines and files that were left out or replaced, by kind and file.

    `write` takes every one as a row of the table `PROBLEMS`; all are counted, and `keep` different
    ones of a kind are kept of each file, to be printed.
    """

    def __init__(self, write: Write = len, keep: int = 3) -> None:
        self.counts = Counter[tuple[str, Path]]()
        self._write, self._keep = write, keep
        self._first: dict[str, dict[Path, dict[str, str]]] = {}

    def note(
        self, kind: str, path: Path, line: int = 0, comment: str = "", row: Mapping[str, str] = {}
    ) -> None:
        """Note a problem of a line, or of a whole file (line 0)."""
        self.counts[kind, path] += 1
        who = [row.get(column, "") for column in PROBLEMS[3:6]]
        self._write((kind, path, line or "", *who, comment))
        first = self._first.setdefault(kind, {}).setdefault(path, {})
        if comment not in first and len(first) < self._keep:
            place = f"{path}, line {line}" if line else f"{path}"
            words = ": ".join(filter(None, (place, comment)))
            first[comment] = words.replace("\n", "\\n")  # of a file's name, or of a cell

    def lines(self) -> list[str]:
        """Return what to print: each kind with its count, and the first of it in each file."""
        found = []
        for kind, files in self._first.items():
            found.append(f"{kind}: {sum(self.counts[kind, path] for path in files):,}")
            for path, first in files.items():
                found += [f"  {words}" for words in first.values()]
                if more := self.counts[kind, path] - len(first):
                    found.append(f"  {path}: {more:,} more")
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
            plain = (re.sub('^="(.*)"$', r"\1", cell) for cell in cells)
            values = (unguard_cell(cell).strip(" \t\r\n") for cell in plain)  # as the judge does
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
        if len(cells) == 1 and separator in first:  # the whole line was quoted
            cells = next(csv.reader(cells, delimiter=separator))
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
                remark = line.lower().startswith("sep=")  # a spreadsheet's own
                yield "\n" if remark else line.replace("\0", "").replace("\ufeff", "")
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
