"""The open course: its chapters, found by their folders, and their declarations.

A course is a package with a folder for each chapter; `_toc.yml` gives the order. Modules of a
chapter have fixed names (`formulas`, `checks`, `figures`, `exercises`, …): each value that a module
holds under a name, alone or in a tuple, list or dictionary, is declared. A package opens itself::

    open_course(__name__, name="kinematics", looks=KINDS, library="robokin")

and is found, once installed, by the entry point `courseware.course` of its `pyproject.toml`.
"""

import json
import re
import sys
from collections.abc import Iterator, Mapping
from functools import cache, cached_property
from importlib import import_module
from importlib.metadata import entry_points
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules
from traceback import extract_tb
from types import ModuleType
from typing import Any, TypeVar, cast

import yaml

from courseware.errors import CourseError

T = TypeVar("T")


class Course:
    """A course.

    Args:
        package: its Python package.
        name: also the salt of its exercises' numbers.
        looks: by kind of thing; `grid` and `text`, which every picture has, are among them. A look
            has `light` and `dark` (its colour on a light and on a dark page), `dash` (lengths of
            line and gap), `width` and `marker` (dot, ring, cross, square or diamond).
        materials: the `Materials` of the things in its figures.
        library: the package whose functions the chapters use, if they use one.
    """

    def __init__(
        self, package: str, name: str, looks: Mapping[str, Any], materials: Any, library: str = ""
    ) -> None:
        self.package, self.name, self.looks, self.library = package, name, looks, library
        self.materials = materials
        self._declared: dict[tuple[str, type], dict[str, tuple[str, Any]]] = {}

    @cached_property
    def folder(self) -> Path:
        return Path(import_module(self.package).__path__[0])

    @cached_property
    def chapters(self) -> list[str]:
        """Their names: shared ones without a notebook, then the others as in `_toc.yml`."""
        listed = self._listed_chapters()
        folders = sorted({path.parent.name for path in self.folder.glob("[a-z]*/*.py")})
        for chapter in folders:
            if self.notebook(chapter).exists() and chapter not in listed:
                raise CourseError(
                    f"{self.notebook(chapter)} is not in _toc.yml: add the line "
                    f"`- file: {chapter}/{chapter}`"
                )
        return [f for f in folders if f not in listed] + [f for f in listed if f in folders]

    @cached_property
    def taught(self) -> list[str]:
        """The chapters that have a notebook."""
        return [chapter for chapter in self.chapters if self.notebook(chapter).exists()]

    def _read_yaml(self, name: str) -> dict[str, Any]:
        """Read a file beside the package or, if that is installed, in it; {} without one."""
        places = (self.folder.parent / name, self.folder / name)
        texts = (place.read_text(encoding="utf-8") for place in places if place.exists())
        return yaml.safe_load(next(texts, "")) or {}

    def _listed_chapters(self) -> list[str]:
        contents = self._read_yaml("_toc.yml")
        if not contents:
            raise CourseError(f"there is no _toc.yml beside {self.folder} or in it")
        folders = [file.split("/") for file in list_documents(contents)]
        return [names[0] for names in folders if len(names) == 2 and names[0] == names[1]]

    @cached_property
    def settings(self) -> dict[str, Any]:
        """The settings for Sphinx in `_config.yml`."""
        found: dict[str, Any] = self._read_yaml("_config.yml").get("sphinx", {}).get("config", {})
        return found

    @property
    def salt(self) -> str:
        """The name that takes part in picking numbers: the settings' `course_name`, or its own."""
        return str(self.settings.get("course_name") or self.name)

    def notebook(self, chapter: str) -> Path:
        """Return the path of a chapter's notebook, which need not exist."""
        return self.folder / chapter / f"{chapter}.ipynb"

    def title(self, chapter: str) -> str:
        """Return the first heading of a chapter's notebook."""
        return _read_heading(self.notebook(chapter))

    def _package_of(self, chapter: str) -> ModuleType:
        return import_module(f"{self.package}.{chapter}")

    def question(self, chapter: str) -> str:
        """Return the question that a chapter answers: the docstring of its package."""
        return (self._package_of(chapter).__doc__ or "").strip()

    def card(self, chapter: str) -> str:
        """Return the figure on a chapter's card, if it says another than its first: `CARD`."""
        return str(getattr(self._package_of(chapter), "CARD", ""))

    def minutes(self, chapter: str) -> str:
        """Return how long a chapter takes, as its notebook says it: "Time: about 60 minutes"."""
        found = re.search(r"Time: about (\d+) minutes", self.notebook(chapter).read_text("utf-8"))
        return found[1] if found else ""

    @cached_property
    def library_modules(self) -> list[str]:
        """The library's public modules by name, then the `functions` of chapters."""
        places = import_module(self.library).__path__ if self.library else []
        public = [m.name for m in iter_modules(places) if not m.name.startswith("_")]
        own = [module.__name__ for module in self.modules("functions").values()]
        return [f"{self.library}.{name}" for name in public] + own

    def module(self, chapter: str, part: str) -> ModuleType | None:
        """Return a chapter's module of a name, or None; an error names its file and line."""
        name = f"{self.package}.{chapter}.{part}"
        try:
            return import_module(name) if find_spec(name) else None
        except Exception as error:
            own = [f for f in extract_tb(error.__traceback__) if str(self.folder) in f.filename]
            place = f"{own[-1].filename}, line {own[-1].lineno}" if own else name
            raise CourseError(f"{place}: {error}") from error

    def modules(self, part: str) -> dict[str, ModuleType]:
        """Return the modules of a name by chapter, in the order of the course."""
        found = {chapter: self.module(chapter, part) for chapter in self.chapters}
        return {chapter: module for chapter, module in found.items() if module}

    def find_all(self, part: str, kind: type[T]) -> dict[str, T]:
        """Return all declarations of a type in modules of a name, by their `name`."""
        return {name: thing for name, (_, thing) in self._find_all(part, kind).items()}

    def find(self, part: str, kind: type[T], name: object) -> T:
        """Return the declaration of a type and a name, importing as few chapters as possible."""
        # by its figures, which come first: any search imports the packages of all chapters
        figures = {chapter: f"{self.package}.{chapter}.figures" for chapter in self.chapters}
        for chapter in sorted(figures, key=lambda c: figures[c] not in sys.modules):
            module = self.module(chapter, part)
            thing: Any
            for thing in get_members(module, kind) if module else ():
                if thing.name == name:
                    return cast(T, thing)
        raise CourseError(
            f"there is no {kind.__name__.lower()} {name!r}; there are "
            f"{', '.join(self.find_all(part, kind))}, declared in the chapters' {part}.py, "
            "under a name of their own or in a tuple"
        )

    def find_chapter(self, part: str, thing: Any) -> str:
        """Return the chapter that declares a thing of this name, of those that are imported."""
        for chapter in self.chapters:
            module = sys.modules.get(f"{self.package}.{chapter}.{part}")
            if module and thing.name in (x.name for x in get_members(module, type(thing))):
                return chapter
        return ""

    def find_place(self, chapter: str, part: str, name: str) -> str:
        """Return the file and line in which a chapter gives a declaration its name."""
        file = self.folder / chapter / f"{part}.py"
        before = file.read_text("utf-8").partition(f'"{name}"')[0] if file.exists() else ""
        return f"{file}, line {before.count(chr(10)) + 1}"

    def chapters_of(self, part: str, kind: type) -> dict[str, str]:
        """Return the chapters of these declarations, by name."""
        return {name: chapter for name, (chapter, _) in self._find_all(part, kind).items()}

    def _find_all(self, part: str, kind: type) -> dict[str, tuple[str, Any]]:
        if (part, kind) not in self._declared:
            found: dict[str, tuple[str, Any]] = {}
            for chapter, module in self.modules(part).items():
                thing: Any
                for thing in get_members(module, kind):
                    first, known = found.setdefault(thing.name, (chapter, thing))
                    if known is not thing:
                        raise CourseError(
                            f"{thing.name} is declared twice, in the {part} of {first} and of "
                            f"{chapter}: choose another name for one of the two"
                        )
            self._declared[part, kind] = found
        return self._declared[part, kind]


def topic_of(name: str) -> str:
    """Return the chapter of an exercise or a program: "differential_drive" of its "-1" or "-p1"."""
    return name.rsplit("-", 1)[0].replace("-", "_")


def list_documents(contents: Any) -> Iterator[str]:
    """Yield the documents of a table of contents, in order."""
    if isinstance(contents, list):
        for entry in contents:
            yield from list_documents(entry)
    elif isinstance(contents, dict):
        yield from (contents[key] for key in ("root", "file") if key in contents)
        for key in ("parts", "chapters", "sections"):
            yield from list_documents(contents.get(key))


def get_members(module: ModuleType, kind: type[T]) -> Iterator[T]:
    """Yield the values of a type in a module, in the order of its text."""
    for value in vars(module).values():
        inside = value.values() if isinstance(value, dict) else value
        several = isinstance(value, tuple | list | dict)
        yield from (x for x in (inside if several else (value,)) if isinstance(x, kind))


@cache  # each of its questions in Moodle names it
def _read_heading(notebook: Path) -> str:
    text = "".join(json.loads(notebook.read_text("utf-8"))["cells"][0]["source"])
    return text.splitlines()[0].removeprefix("# ")


_open: list[Course] = []


def open_course(*arguments: Any, **named: Any) -> None:
    """Make a course, from what `Course` takes, the one that `course()` returns."""
    _open[:] = [Course(*arguments, **named)]


def course() -> Course:
    """Return the open course, or else open the one that is installed."""
    if not _open:
        installed = entry_points(group="courseware.course")
        if len(installed) != 1:
            raise CourseError(
                f"no course is open, and {len(installed)} are installed: import the package of "
                "the course first, for example `import book`"
            )
        next(iter(installed)).load()
    return _open[0]
