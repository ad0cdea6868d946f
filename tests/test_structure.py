"""The allowed imports: none of ours in the library, no robot in the framework, no later chapter.

Read from the sources, without running them; imports for the type checker alone do not count.
"""

import ast
import sys
from graphlib import CycleError, TopologicalSorter
from importlib.metadata import packages_distributions, requires
from typing import NamedTuple

import pytest
from declared import course
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from support import ROOT

PACKAGES = ("robokin", "courseware", "book")
PROVIDED = packages_distributions()  # by the names of imports


class Import(NamedTuple):
    """That a module imports another."""

    by: str
    of: str
    line: int


def name_of(path):
    """The module in a file."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {
    name_of(path): path
    for package in PACKAGES
    for path in sorted((ROOT / package).rglob("*.py"))
    if "tests" not in path.relative_to(ROOT).parts
}
# of courseware: each part uses those before it, and can be used without those after it
LAYERS = (
    *("errors", "script", "course", "units", "source_listing", "equations", "figures", "answers"),
    *("practice", "explaining", "judge", "programs", "predictions", "symbols", "run", "site"),
    *("classroom", "new_chapter"),
)


def imports_of(name, source):
    """All imports of a module; `from package import module` is one of the module."""
    found = []

    def look(node):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
                continue
            if isinstance(child, ast.Import | ast.ImportFrom):
                targets = dict.fromkeys(target(child, alias.name) for alias in child.names)
                found.extend(Import(name, of, child.lineno) for of in targets)
            look(child)

    look(ast.parse(source))
    return found


def target(node, name):
    """The module that an import needs."""
    if isinstance(node, ast.Import):
        return name
    assert not node.level, "imports are absolute"
    inner = f"{node.module}.{name}"
    return inner if inner in MODULES else node.module


IMPORTS = [
    each
    for name, path in MODULES.items()
    for each in imports_of(name, path.read_text(encoding="utf-8"))
]


def within(module, *packages):
    """Whether a module is one of some packages or inside."""
    return any(module == p or module.startswith(f"{p}.") for p in packages)


def is_for_the_site(module):
    """Whether a module is needed only where the site is built, or by teachers."""
    parts = ("courseware.site", "courseware.symbols", "courseware.classroom", "book._ext")
    return within(module, *parts) or module.endswith(".page")


def describe_imports(imports):
    """Imports as a reader finds them."""
    return [f"{each.by}, line {each.line}, imports {each.of}" for each in imports]


def chapter_of(module):
    """The chapter that a module belongs to, or None."""
    parts = module.split(".")
    return parts[1] if parts[0] == "book" and parts[1:] and parts[1] in course().chapters else None


@pytest.mark.parametrize(
    ("package", "others"),
    [
        ("robokin", ("courseware", "book")),
        ("courseware", ("robokin", "book")),
        ("book", ("courseware.classroom",)),
    ],
)
def test_a_package_does_not_import(package, others):
    wrong = describe_imports(i for i in IMPORTS if within(i.by, package) and within(i.of, *others))
    assert not wrong, f"{package} stands alone: {wrong}"


def test_the_library_s_tests_need_no_course():
    """They also run where there is none: in the Python of a browser."""
    files = {name_of(path): path for path in (ROOT / "tests" / "robokin").glob("*.py")}
    found = (i for name, path in files.items() for i in imports_of(name, path.read_text("utf-8")))
    wrong = describe_imports(i for i in found if within(i.of, "book", "courseware"))
    assert not wrong, wrong


def part_of(module):
    """The part of the framework that a module belongs to, or None."""
    package, _, rest = module.partition(".")
    return rest.partition(".")[0] if package == "courseware" and rest else None


def test_each_part_of_the_framework_uses_only_those_above_it_in_the_list():
    parts = {part_of(name) for name in MODULES} - {None}
    assert parts == set(LAYERS), "name its place in LAYERS"
    between = [i for i in IMPORTS if part_of(i.by) and part_of(i.of)]
    wrong = [i for i in between if LAYERS.index(part_of(i.by)) < LAYERS.index(part_of(i.of))]
    assert not wrong, describe_imports(wrong)


def test_the_judge_needs_numpy_alone():
    """It is handed to graders as two files."""
    judge = {"courseware.judge", "courseware.explaining"}
    others = {
        i.of for i in IMPORTS if i.by in judge and not i.of.startswith("courseware.explaining")
    }
    tops = {of.partition(".")[0] for of in others}
    assert tops - set(sys.stdlib_module_names) == {"numpy"}


@pytest.mark.parametrize("package", PACKAGES)
def test_a_wheel_asks_for_what_its_modules_import(package):
    """Else it is missing where only the wheels are installed; Pyodide has a module of its own."""
    needed, more = set(), {"robokin" if package == "robokin" else f"robokin-{package}"}
    while more:
        needed |= more
        asked = (Requirement(text) for name in more for text in requires(name) or ())
        asked = (r for r in asked if not r.marker or r.marker.evaluate({"extra": "draw"}))
        more = {canonicalize_name(r.name) for r in asked} - needed
    known = {*sys.stdlib_module_names, *PACKAGES, "pyodide"}
    known |= {top for top, by in PROVIDED.items() if needed & set(map(canonicalize_name, by))}
    own = [i for i in IMPORTS if within(i.by, package) and not is_for_the_site(i.by)]
    missing = describe_imports(i for i in own if i.of.partition(".")[0] not in known)
    assert not missing, f"name it in pyproject.toml: {missing}"


each_chapter = pytest.mark.parametrize("chapter", course().chapters)


@pytest.mark.parametrize("chapter", [c for c in course().chapters if c != "home"])
def test_a_chapter_imports_only_what_is_shared_and_earlier_chapters(chapter):
    """The first page shows what any chapter has."""
    later = course().chapters[course().chapters.index(chapter) + 1 :]
    mine = [each for each in IMPORTS if chapter_of(each.by) == chapter]
    wrong = describe_imports(each for each in mine if chapter_of(each.of) in later)
    assert not wrong, f"{wrong}, which comes later in _toc.yml: declare it here, or in book/motion"


@each_chapter
def test_formulas_are_declared_without_the_library(chapter):
    """`checks` says how the library agrees with them, and nothing but tests needs that."""
    mine = [each for each in IMPORTS if chapter_of(each.by) == chapter]
    formulas = [i for i in mine if i.by.endswith(".formulas")]
    wrong = describe_imports(i for i in formulas if within(i.of, "robokin"))
    assert not wrong, f"{wrong}: what compares with the library is in checks.py"
    checks = [i for i in mine if within(i.of, "book") and i.of.endswith(".checks")]
    wrong = describe_imports(i for i in checks if not i.by.endswith(".checks"))
    assert not wrong, f"{wrong}: only tests need it"


@pytest.mark.parametrize("part", ["robokin", "courseware", "book", *course().chapters])
def test_no_two_modules_need_each_other(part):
    """Among those that a part needs, its own and others."""
    graph = {}
    for each in IMPORTS:
        if each.of in MODULES and each.of != each.by:
            graph.setdefault(each.by, set()).add(each.of)
    needed = {m for m in MODULES if within(m, part, f"book.{part}")}
    while more := {of for by in needed for of in graph.get(by, ())} - needed:
        needed |= more
    try:
        TopologicalSorter({name: graph.get(name, ()) for name in needed}).prepare()
    except CycleError as error:
        round_ = " imports ".join(reversed(error.args[1]))
        pytest.fail(f"{round_}: move what both need to one of them, or to a third")
