"""Tables as CSV: written so that a spreadsheet shows them as they are, read whatever wrote them."""

import csv
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import TextIO

from courseware.errors import CourseError

Row = dict[str, str]
Write = Callable[[Sequence[object]], object]

NUMBER = r"[+-]?[\d.]+"
FORMULA = r"'*[=+\-@\t\r\n]"  # what a spreadsheet takes for the start of a formula, or was guarded
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
UNDECODED = re.compile("[\udc80-\udcff]")
NOT_CSV = (
    f"a quotation mark is not closed, or a cell has over {csv.field_size_limit():,} characters"
)
PROBLEMS = ("problem", "file", "line", "student", "exercise", "answer", "comment")


class Problems:
    """What was left out, replaced or not read: counted by kind, some shown, all of it written.

    write: takes every row of the table `PROBLEMS`. shown: how many different ones of a kind.
    """

    def __init__(self, write: Write = len, shown: int = 3) -> None:
        self.counts = Counter[str]()
        self._write, self._shown = write, shown
        self._first: dict[str, dict[str, str]] = {}

    def note(
        self, kind: str, path: Path, line: int = 0, comment: str = "", row: Mapping[str, str] = {}
    ) -> None:
        """Note a problem. line: 0 for a whole file. comment: alike ones are shown once."""
        self.counts[kind] += 1
        who = [row.get(column, "") for column in PROBLEMS[3:6]]
        self._write((kind, path, line or "", *who, comment))
        first = self._first.setdefault(kind, {})
        if comment not in first and len(first) < self._shown:
            place = f"{path}, line {line}" if line else f"{path}"
            first[comment] = ": ".join(filter(None, (place, comment)))

    def lines(self) -> list[str]:
        """To print: each kind with its count, and the first of them."""
        found = []
        for kind, count in self.counts.items():
            first = self._first[kind].values()
            more = f"  … and {count - len(first):,} more" if count > len(first) else ""
            found += [f"{kind}: {count:,}", *(f"  {words}" for words in first)]
            found += [more] if more else []
        return found


def guarded(text: str) -> str:
    """A cell that no spreadsheet runs as a formula: with a leading ', but for plain numbers."""
    formula = re.match(FORMULA, text) and not re.fullmatch(NUMBER, text)
    return f"'{text}" if formula else text


def unguarded(text: str) -> str:
    """A cell as it was before `guarded`."""
    return text[1:] if re.match("'" + FORMULA, text) else text


@contextmanager
def whole(path: str | Path, force: bool = False, encoding: str = "utf-8") -> Iterator[TextIO]:
    """A file to write in, which gets its name when it is whole; nothing is overwritten."""
    path = Path(path)
    free(path, force)
    part = path.with_name(f"{path.name}.part")
    try:
        with part.open("w", encoding=encoding, errors="replace", newline="") as file:
            yield file
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


@contextmanager
def writing(path: str | Path, columns: Sequence[str], force: bool = False) -> Iterator[Write]:
    """A table to write row by row, in UTF-8 with a mark, which spreadsheets need."""
    with whole(path, force, "utf-8-sig") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        yield lambda row: writer.writerow([guarded(str(cell)) for cell in row])


def write(
    path: str | Path, columns: Sequence[str], rows: Iterable[Sequence[object]], force: bool = False
) -> Path:
    """Write a whole table."""
    with writing(path, columns, force) as row_out:
        for row in rows:
            row_out(row)
    return Path(path)


def free(path: Path, force: bool) -> None:
    """Refuse a file that is already there, unless told to overwrite it."""
    if path.is_dir():
        raise CourseError(f"{path} is a folder: give the name of a file")
    if path.exists() and not force:
        raise CourseError(
            f"{path} is already there: choose another name, or overwrite it "
            "(--force; in Python, force=True)"
        )
    if not path.parent.is_dir():
        raise CourseError(f"there is no folder {path.parent} to write {path.name} in")


def rows(path: Path, problems: Problems, needed: Sequence[str] = ()) -> Iterator[tuple[int, Row]]:
    """The rows with their line numbers, one by one: comma, semicolon or tab, UTF-8 or UTF-16.

    needed: columns that the table must have.
    Bad lines are noted, not fatal. Where tables were joined, a heading may stand anywhere.
    """
    lines, first = _lines(path), list[str]()
    for text in lines:
        first.append(text)
        if text.strip():
            break
    reader = csv.reader(
        chain(first, lines), delimiter=max(",;\t", key="".join(first).count), strict=True
    )
    heading = list[str]()
    while True:
        number = reader.line_num + 1
        try:
            cells = next(reader)
        except StopIteration:
            break
        except csv.Error:
            words = f"{NOT_CSV}; read on after line {reader.line_num}"
            problems.note("lines that are no CSV", path, number, words)
            continue
        names = [cell.strip().lower() for cell in cells]
        if not any(names):
            continue
        if not heading or {"student", "exercise"} <= set(names):
            heading = names
            _require(path, needed, heading)
        elif any(map(UNDECODED.search, cells)):
            problems.note("lines not in UTF-8: save the file as CSV UTF-8", path, number)
        elif len(cells) != len(heading):
            words = f"{len(cells)} cells, the heading has {len(heading)}"
            problems.note("lines with more or fewer cells than the heading", path, number, words)
        else:
            values = (unguarded(cell).strip() for cell in cells)
            yield number, dict(zip(heading, values, strict=True))
    if not heading:
        _require(path, needed, heading)


def _require(path: Path, needed: Sequence[str], heading: Sequence[str]) -> None:
    missing = [name for name in needed if name not in heading]
    if missing:
        raise CourseError(
            f"{path} has no column {', '.join(missing)}; needed are {', '.join(needed)}, "
            f"its first line has {', '.join(filter(None, heading)) or 'nothing'}"
        )


def _lines(path: Path) -> Iterator[str]:
    """The lines as text; what is not UTF-8 is kept as surrogates."""
    try:
        with path.open("rb") as file:
            encoding = "utf-16" if file.read(2) in UTF_16 else "utf-8"
        errors = "replace" if encoding == "utf-16" else "surrogateescape"
        with path.open(encoding=encoding, errors=errors) as text:
            for line in text:
                remark = line.lower().startswith("sep=")  # a spreadsheet's own
                yield "\n" if remark else line.replace("\0", "").replace("\ufeff", "")
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
