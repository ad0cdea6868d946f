"""Which files a page is made of, so that it is read again when one of them changes."""

from functools import cache
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

from courseware.course import course

MACHINE = Path(__file__).parents[1]
LIST = "files.txt"


def depend(env: BuildEnvironment, *parts: str) -> None:
    """Read the present page again when the machine, the library or such a module changes.

    And when there is another file or chapter than before: Sphinx looks at known files only.
    """
    for path in [*sources(*parts), Path(env.doctreedir, LIST)]:
        env.note_dependency(str(path))


@cache  # every figure and formula of a page asks
def sources(*parts: str) -> list[Path]:
    """The files that what is shown depends on: modules of these names, and all below them."""
    modules = [path for part in parts for path in course().folder.glob(f"*/{part}.py")]
    machine = [path for suffix in ("py", "js", "css") for path in MACHINE.rglob(f"*.{suffix}")]
    return sorted([*modules, *machine, *course().library_folder.rglob("*.py")])


def list_files(app: Sphinx) -> None:
    """List the chapters in their order and all sources; the file changes if the list does."""
    listed = "\n".join([*course().taught, *map(str, sources("*"))])
    file = Path(app.doctreedir, LIST)
    if not file.exists() or file.read_text("utf-8") != listed:
        file.write_text(listed, "utf-8")
