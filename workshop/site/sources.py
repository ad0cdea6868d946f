"""Which files a page is made of, so that it is read again when one of them changes."""

from pathlib import Path

from sphinx.environment import BuildEnvironment

from workshop.course import course

MACHINE = Path(__file__).parents[1]


def depend(env: BuildEnvironment, *parts: str) -> None:
    """Read the present page again when the machine, the library or such a module changes."""
    for path in sources(*parts):
        env.note_dependency(str(path))


def sources(*parts: str) -> list[Path]:
    """The files that what is shown depends on: modules of these names, and all below them."""
    modules = [path for part in parts for path in course().folder.glob(f"*/{part}.py")]
    machine = [path for suffix in ("py", "js", "css") for path in MACHINE.rglob(f"*.{suffix}")]
    return sorted([*modules, *machine, *course().library_folder.rglob("*.py")])
