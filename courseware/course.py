"""The course that is open: its chapters, found by their folders, and what they declare.

A course is a package with a folder for each chapter; `_toc.yml` gives the order. What belongs to a
chapter stands in modules of fixed names (`formulas`, `checks`, `figures`, `exercises`, …): whatever
a module holds under a name, also in a tuple or a dictionary, is declared. A package opens itself::

    open_course(__name__, name="kinematics", looks=KINDS, library="robokin")

and is found, once installed, by the entry point `courseware.course` of its `pyproject.toml`.
"""

import json
import sys
from collections.abc import Iterator, Mapping
from functools import cache, cached_property
from importlib import import_module
from importlib.metadata import entry_points
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from typing import Any, TypeVar, cast

import yaml

from courseware.errors import CourseError

__all__ = ["Course", "course", "open_course"]

T = TypeVar("T")


class Course:
    """A course. name: the salt of its exercises' numbers, too. looks: its kinds of things.

    A look has `light` and `dark` (its colour on a light and on a dark page), `dash` (lengths of
    line and gap), `width` and `marker` (dot, ring, cross, square or diamond). Among the looks are
    those of `grid` and `text`, which every picture has.
    library: the package whose functions the chapters use; a chapter may have `functions`, too.
    """

    def __init__(self, package: str, name: str, looks: Mapping[str, Any], library: str) -> None:
        self.package, self.name, self.library = package, name, library
        self.looks = looks
        self._declared: dict[tuple[str, type], dict[str, tuple[str, Any]]] = {}

    @cached_property
    def folder(self) -> Path:
        """Where the package stands."""
        return Path(import_module(self.package).__path__[0])

    @cached_property
    def chapters(self) -> list[str]:
        """The folders, as `_toc.yml` orders them; before them what chapters share, by name."""
        listed = self._listed()
        folders = sorted({path.parent.name for path in self.folder.glob("[a-z]*/*.py")})
        for chapter in folders:
            if not (self.folder / chapter / "__init__.py").exists():
                raise CourseError(
                    f"{self.folder / chapter} has no __init__.py: write one whose docstring is the "
                    "question that the chapter answers"
                )
        for chapter in folders:
            if self.notebook(chapter).exists() and chapter not in listed:
                raise CourseError(
                    f"{self.notebook(chapter)} is not in _toc.yml: add the line "
                    f"`- file: {chapter}/{chapter}`"
                )
        return [f for f in folders if f not in listed] + [f for f in listed if f in folders]

    @cached_property
    def taught(self) -> list[str]:
        """The chapters that have a notebook; what chapters share has none."""
        return [chapter for chapter in self.chapters if self.notebook(chapter).exists()]

    def _beside(self, name: str) -> dict[str, Any]:
        """A YAML file that stands beside the package or, installed, in it; {} if there is none."""
        places = (self.folder.parent / name, self.folder / name)
        texts = (place.read_text(encoding="utf-8") for place in places if place.exists())
        return yaml.safe_load(next(texts, "")) or {}

    def _listed(self) -> list[str]:
        """The chapters of `_toc.yml`."""
        contents = self._beside("_toc.yml")
        if not contents:
            raise CourseError(f"there is no _toc.yml beside {self.folder} or in it")
        folders = [file.split("/") for file in files(contents)]
        return [names[0] for names in folders if len(names) == 2 and names[0] == names[1]]

    @cached_property
    def settings(self) -> dict[str, Any]:
        """What `_config.yml` sets for Sphinx."""
        found: dict[str, Any] = self._beside("_config.yml").get("sphinx", {}).get("config", {})
        return found

    def notebook(self, chapter: str) -> Path:
        """A chapter's notebook; what chapters share has none."""
        return self.folder / chapter / f"{chapter}.ipynb"

    def title(self, chapter: str) -> str:
        """The first heading of a chapter's notebook."""
        return _heading(self.notebook(chapter))

    def question(self, chapter: str) -> str:
        """What a chapter answers: the docstring of its package."""
        return (import_module(f"{self.package}.{chapter}").__doc__ or "").strip()

    @cached_property
    def library_folder(self) -> Path:
        """Where the library stands."""
        return Path(import_module(self.library).__path__[0])

    @cached_property
    def library_modules(self) -> list[str]:
        """The library's public modules by name, then the functions of chapters."""
        public = [f"{self.library}.{m.name}" for m in iter_modules([str(self.library_folder)])]
        own = [module.__name__ for module in self.modules("functions").values()]
        return [name for name in public if not name.rpartition(".")[2].startswith("_")] + own

    def module(self, chapter: str, part: str) -> ModuleType | None:
        """A chapter's module, or None where it has none of that name."""
        name = f"{self.package}.{chapter}.{part}"
        return import_module(name) if find_spec(name) else None

    def modules(self, part: str) -> dict[str, ModuleType]:
        """The modules of one name, by chapter, in the course's order."""
        found = {chapter: self.module(chapter, part) for chapter in self.chapters}
        return {chapter: module for chapter, module in found.items() if module}

    def declared(self, part: str, kind: type[T]) -> dict[str, T]:
        """All things of a kind that the modules of one name hold, by their `name`."""
        return {name: thing for name, (_, thing) in self._found(part, kind).items()}

    def find(self, part: str, kind: type[T], name: object) -> T:
        """Return the thing of a kind and a name, and import no more chapters than it takes."""
        for chapter in sorted(self.chapters, key=self._is_new):
            module = self.module(chapter, part)
            thing: Any
            for thing in held(module, kind) if module else ():
                if thing.name == name:
                    return cast(T, thing)
        raise CourseError(
            f"there is no {kind.__name__.lower()} {name!r}; there are "
            f"{', '.join(self.declared(part, kind))}, declared in the chapters' {part}.py, "
            "under a name of their own or in a tuple"
        )

    def _is_new(self, chapter: str) -> bool:
        return f"{self.package}.{chapter}" not in sys.modules

    def homes(self, part: str, kind: type) -> dict[str, str]:
        """The chapter of each of these things, by name."""
        return {name: chapter for name, (chapter, _) in self._found(part, kind).items()}

    def _found(self, part: str, kind: type) -> dict[str, tuple[str, Any]]:
        if (part, kind) not in self._declared:
            found: dict[str, tuple[str, Any]] = {}
            for chapter, module in self.modules(part).items():
                thing: Any
                for thing in held(module, kind):
                    first, known = found.setdefault(thing.name, (chapter, thing))
                    if known is not thing:
                        raise CourseError(
                            f"{thing.name} is declared twice, in the {part} of {first} and of "
                            f"{chapter}: choose another name for one of the two"
                        )
            self._declared[part, kind] = found
        return self._declared[part, kind]


def files(contents: Any) -> Iterator[str]:
    """The documents that a table of contents names, in order."""
    if isinstance(contents, list):
        for entry in contents:
            yield from files(entry)
    elif isinstance(contents, dict):
        yield from (contents[key] for key in ("root", "file") if key in contents)
        for key in ("parts", "chapters", "sections"):
            yield from files(contents.get(key))


def held(module: ModuleType, kind: type[T]) -> Iterator[T]:
    """What a module holds of a kind, in the order in which it is written."""
    for value in vars(module).values():
        inside = value.values() if isinstance(value, dict) else value
        several = isinstance(value, tuple | list | dict)
        yield from (x for x in (inside if several else (value,)) if isinstance(x, kind))


@cache
def _heading(notebook: Path) -> str:
    """The first heading of a notebook; its questions in Moodle all name it."""
    text = "".join(json.loads(notebook.read_text("utf-8"))["cells"][0]["source"])
    return text.splitlines()[0].removeprefix("# ")


_open: list[Course] = []


def open_course(package: str, name: str, looks: Mapping[str, Any], library: str) -> None:
    """Make a course the one that is shown, checked and dealt from."""
    _open[:] = [Course(package, name, looks, library)]


def course() -> Course:
    """Return the course that is open; if none is, open the one that is installed."""
    if not _open:
        installed = entry_points(group="courseware.course")
        if len(installed) != 1:
            raise CourseError(
                f"no course is open, and {len(installed)} are installed: import the package of "
                "the course first, for example `import book`"
            )
        for package in installed:
            package.load()
    return _open[0]
