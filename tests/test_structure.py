"""Who may import whom: the library nothing of the rest, the machine no robot, chapters backwards.

Read from the sources, without running them; imports for the type checker alone do not count.
"""

import ast
from graphlib import CycleError, TopologicalSorter
from typing import NamedTuple

import pytest
from declared import course
from support import ROOT

PACKAGES = ("robokin", "workshop", "book")


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
    name_of(path): path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py"))
}


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


def told(imports):
    """Imports as a reader finds them."""
    return [f"{each.by}, line {each.line}, imports {each.of}" for each in imports]


def chapter_of(module):
    """The chapter that a module belongs to, or None."""
    parts = module.split(".")
    return parts[1] if parts[0] == "book" and parts[1:] and parts[1] in course().chapters else None


@pytest.mark.parametrize(
    ("package", "others"),
    [("robokin", ("workshop", "book")), ("workshop", ("robokin", "book"))],
)
def test_a_package_does_not_import(package, others):
    assert not told(i for i in IMPORTS if within(i.by, package) and within(i.of, *others))


def test_a_chapter_imports_only_what_is_shared_and_earlier_chapters():
    order = {chapter: place for place, chapter in enumerate(course().chapters)}
    assert not told(
        each
        for each in IMPORTS
        if chapter_of(each.by)
        and chapter_of(each.of)
        and order[chapter_of(each.of)] > order[chapter_of(each.by)]
    )


def test_formulas_are_declared_without_the_library():
    """How the library agrees with them stands in `checks`, and nothing but tests needs that."""
    formulas = [i for i in IMPORTS if within(i.by, "book") and i.by.endswith(".formulas")]
    assert not told(i for i in formulas if within(i.of, "robokin"))
    checks = [i for i in IMPORTS if within(i.of, "book") and i.of.endswith(".checks")]
    assert not told(i for i in checks if not i.by.endswith(".checks"))


def test_no_two_modules_need_each_other():
    graph = {name: [] for name in MODULES}
    for each in IMPORTS:
        if each.of in MODULES and each.of != each.by:
            graph[each.by].append(each.of)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" imports ".join(reversed(error.args[1])))


def test_the_reader_of_imports_sees_them():
    """A wrong import would be found, wherever it stands."""
    source = """
import numpy as np
from robokin import motion, errors as e
from workshop.equations.core import quantity
if TYPE_CHECKING:
    from book.motion import formulas
def f():
    import matplotlib.pyplot
    from book import motion
    class A:
        from book.motion.formulas import x
"""
    assert [each.of for each in imports_of("m", source)] == [
        "numpy",
        "robokin.motion",
        "robokin.errors",
        "workshop.equations.core",
        "matplotlib.pyplot",
        "book.motion",
        "book.motion.formulas",
    ]
