"""Tables as CSV, read whatever wrote them, and the problems that they have."""

from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from courseware.errors import CourseError
from courseware.script import engine

Row = dict[str, str]

SAVE_OR_ASK = "save your own as CSV UTF-8, ask students for the original"
BAD_LINES = {
    "unclosed": "lines in which a quotation mark is not closed, or does not end its cell",
    "encoding": f"lines not in UTF-8: {SAVE_OR_ASK}",
    "long": "lines with more cells than the heading",
}
SHOWN = 3  # problems of a kind in a file, when they are printed
UNKNOWN_STUDENT = "answers of students who are not in the key"
UNKNOWN_EXERCISE = "answers to exercises that do not exist"
NOT_ASKED = "answers to exercises that were not asked"  # their count says enough


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
        """Return what to print: each kind with its count, and the first comments on each file."""
        kinds: dict[str, dict[Path, list[Problem]]] = {UNKNOWN_STUDENT: {}, UNKNOWN_EXERCISE: {}}
        for each in self:
            kinds.setdefault(each.problem, {}).setdefault(each.file, []).append(each)
        found = []
        for kind, files in kinds.items():
            if files:
                found.append(f"{kind}: {sum(map(len, files.values())):,}")
            for path, here in files.items() if kind != NOT_ASKED else ():
                shown = [*Counter(each.comment for each in here).items()][:SHOWN]
                for comment, count in shown:
                    first = next(each for each in here if each.comment == comment)
                    found.append(f"  {first} ({count:,} lines)" if count > 1 else f"  {first}")
                if more := len(here) - sum(count for _, count in shown):
                    found.append(f"  {path}: {more:,} more")
        return found


def read_rows(
    path: Path, problems: Problems, needed: Sequence[str] = ()
) -> Iterator[tuple[int, Row]]:
    """Yield rows with their line numbers, as the page's reader finds them (`answer_file.js`).

    Bad lines are noted. A table without the `needed` columns is refused.
    """
    heading = list[str]()
    for line, kind, cells in engine.call("courseware.readTable", read_text(path)):
        if kind == "row":
            yield line, dict(zip(heading, cells, strict=True))
        elif kind == "heading":
            heading = cells
            _require(path, needed, heading)
        else:
            words = f"{len(cells)} cells, the heading has {len(heading)}" * (kind == "long")
            problems.note(BAD_LINES[kind], path, line, words)
    _require(path, needed, heading)  # of an empty table, too


def _require(path: Path, needed: Sequence[str], heading: Sequence[str]) -> None:
    missing = [name for name in needed if name not in heading]
    if missing:
        raise CourseError(
            f"{path} has no column {', '.join(missing)}; needed are {', '.join(needed)}, "
            f"its first line has {', '.join(filter(None, heading)) or 'nothing'}"
        )


def read_text(path: Path) -> str:
    """Return a file as text; bytes that are not UTF-8 are kept as surrogates."""
    try:
        found = path.read_bytes()
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
    if found.startswith((BOM_UTF16_LE, BOM_UTF16_BE)):
        return found.decode("utf-16", "replace")
    if b"\0" in found[:1000]:
        raise CourseError(f"{path} is no text: unpack an archive; of a spreadsheet, {SAVE_OR_ASK}")
    return found.decode("utf-8", "surrogateescape")
