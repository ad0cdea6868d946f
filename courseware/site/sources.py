"""The source files of a page, which is read again when one of them changes."""

from functools import cache
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

from courseware.course import course

FRAMEWORK = Path(__file__).parents[1]
LIST = "files.txt"


def note_sources(env: BuildEnvironment, *parts: str) -> None:
    """Have the present page read again when the framework, the library or these modules change.

    Or when a file or chapter is added: Sphinx looks at known files only.
    """
    for path in [*find_sources(*parts), Path(env.doctreedir, LIST)]:
        env.note_dependency(str(path))


@cache  # for every figure and formula of a page
def find_sources(*parts: str) -> list[Path]:
    """Return the files of the framework, of the library, and of modules of these names."""
    modules = [path for part in parts for path in course().folder.glob(f"*/{part}.py")]
    framework = [path for suffix in ("py", "js", "css") for path in FRAMEWORK.rglob(f"*.{suffix}")]
    return sorted([*modules, *framework, *course().library_folder.rglob("*.py")])


def list_files(app: Sphinx) -> None:
    """List the chapters in order and all sources, in a file that changes when the list does."""
    lines = "\n".join([*course().taught, *map(str, find_sources("*"))])
    file = Path(app.doctreedir, LIST)
    if not file.exists() or file.read_text("utf-8") != lines:
        file.write_text(lines, "utf-8")
