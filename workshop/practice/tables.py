"""Tables as CSV: written so that a spreadsheet shows them as they are, read whatever wrote them."""

import csv
import io
import re
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

from workshop.errors import CourseError

Row = dict[str, str]
Line = tuple[int, str]
Write = Callable[[Sequence[object]], object]

NUMBER = r"[+-]?[\d.]+"
FORMULA = r"'*[=+\-@\t\r]"  # what a spreadsheet takes for the start of a formula, or was guarded
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
LONG = 1 << 20  # bytes of a line: what is longer is read in pieces, none of which is a row
NOT_CSV = (
    f"a quotation mark is not closed, or a cell has over {csv.field_size_limit():,} characters"
)
LINES = 5  # of a cell in quotation marks: an open one must not swallow other students' rows
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


def read(path: str | Path, needed: Sequence[str], problems: Problems) -> list[tuple[int, Row]]:
    """A whole table that has at least these columns."""
    return list(rows(Path(path), problems, needed))


def rows(path: Path, problems: Problems, needed: Sequence[str] = ()) -> Iterator[tuple[int, Row]]:
    """The rows with their line numbers, one by one: comma, semicolon or tab, UTF-8 or UTF-16.

    Bad lines are noted, not fatal. Where tables were joined, a heading may stand anywhere.
    """
    lines, heading, delimiter = _Lines(path, problems), list[str](), ","
    for number, text in lines:
        if not text.strip() or text.lower().startswith("sep="):  # a spreadsheet's own remark
            continue
        # a heading is whole in its line; of an answer in several the others would be lost
        if not heading or ("student" in text.lower() and text.count('"') % 2 == 0):
            mark = max(",;\t", key=text.count)
            names = [name.strip().lower() for name in lines.cells(number, text, mark) or ()]
            if not heading or {"student", "exercise"} <= set(names):
                heading, delimiter = names, mark
                _require(path, needed, heading)
                continue
        cells = lines.cells(number, text, delimiter, len(heading))
        if cells is None:
            problems.note("lines that are no CSV", path, number, NOT_CSV)
        elif len(cells) != len(heading):
            words = f"{len(cells)} cells, the heading has {len(heading)}"
            problems.note("lines with more or fewer cells than the heading", path, number, words)
        elif any(map(str.strip, cells)):
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


class _Lines:
    """The lines of a file with their numbers; a row may take several of them."""

    def __init__(self, path: Path, problems: Problems) -> None:
        self._lines = _decoded(path, problems)
        self._waiting = deque[Line]()

    def __iter__(self) -> Iterator[Line]:
        return self

    def __next__(self) -> Line:
        return self._waiting.popleft() if self._waiting else next(self._lines)

    def cells(
        self, number: int, text: str, delimiter: str, width: int | None = None
    ) -> list[str] | None:
        """The cells of the row that starts in this line; None if it is no CSV.

        What was read ahead for a quotation mark that is never closed is given back.
        """
        taken = [(number, text)]
        while len(taken) < LINES and sum(line.count('"') for _, line in taken) % 2:
            try:
                taken.append(next(self))
            except StopIteration:
                break
        reader = csv.reader((line for _, line in taken), delimiter=delimiter, strict=True)
        try:
            cells, used = next(reader, []), reader.line_num
        except csv.Error:
            cells, used = None, 1
        if used > 1 and width not in (None, len(cells or ())):
            cells, used = None, 1
        self._waiting.extendleft(reversed(taken[used:]))
        return cells


def _decoded(path: Path, problems: Problems) -> Iterator[Line]:
    """The lines as text. One that is not UTF-8 is noted and left out."""
    try:
        with path.open("rb") as file:
            if file.read(2) in UTF_16:
                file.seek(0)
                text = io.TextIOWrapper(file, "utf-16", errors="replace", newline="")
                yield from enumerate(text, start=1)
                return
            file.seek(0)
            pieces = iter(lambda: file.readline(LONG), b"")
            lines = (line for piece in pieces for line in piece.splitlines(keepends=True))
            blank = True
            for number, line in enumerate(lines, start=1):
                try:
                    text_of_line = line.decode("utf-8")
                except UnicodeDecodeError:
                    problems.note("lines not in UTF-8: save the file as CSV UTF-8", path, number)
                    if not blank:
                        continue
                    # a heading with an odd letter still names the other columns
                    text_of_line = line.decode("latin-1")
                text_of_line = text_of_line.replace("\0", "").replace("\ufeff", "")
                blank = blank and not text_of_line.strip()
                yield number, text_of_line
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
