"""Tables as CSV, as spreadsheets write them, and the problems that they have."""

from collections.abc import Iterator, Sequence
from itertools import zip_longest
from pathlib import Path
from typing import NamedTuple

from courseware.errors import CourseError
from courseware.script import engine

Row = dict[str, str]
SHOWN = 3  # problems of a kind in a file, when they are printed


class Problem(NamedTuple):
    """A line that was left out or replaced, or a whole file, which has no line."""

    problem: str
    file: Path
    line: int | str
    comment: str

    def __str__(self) -> str:
        place = f"{self.file}, line {self.line}" if self.line else f"{self.file}"
        return f"{place}: {self.comment}" if self.comment else place


class Problems(list[Problem]):
    """All problems, in the order in which they were found."""

    def note(self, kind: str, path: Path, line: int = 0, comment: str = "") -> None:
        """Note a problem of a line, or of a whole file (line 0)."""
        self.append(Problem(kind, path, line or "", comment))

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
    """Yield rows with their line numbers, as the page's reader finds them (`answer_file.js`).

    Bad lines are noted. A table without the `needed` columns is refused.
    """
    (_, heading), *rows = engine.call("courseware.readTable", read_text(path)) or [(1, [])]
    heading = [name.lower() for name in heading]
    if missing := [name for name in needed if name not in heading]:
        raise CourseError(
            f"{path} has no column {', '.join(missing)}; needed are {', '.join(needed)}, "
            f"its first line has {', '.join(filter(None, heading)) or 'nothing'}"
        )
    for line, cells in rows:
        if len(cells) > len(heading):
            words = f"{len(cells)} cells, the heading has {len(heading)}"
            problems.note("lines with more cells than the heading", path, line, words)
        else:
            yield line, dict(zip_longest(heading, cells, fillvalue=""))


def read_text(path: Path) -> str:
    """Return the text of a file in UTF-8."""
    try:
        return path.read_text("utf-8-sig")
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise CourseError(
            f"{path} is no text in UTF-8: unpack an archive, save a spreadsheet as CSV UTF-8"
        ) from error
